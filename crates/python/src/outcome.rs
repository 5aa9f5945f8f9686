//! Outcome of a run.

use std::path::PathBuf;
use std::sync::Arc;

use asperity::Remedy;
use asperity::message::Code;
use asperity::result::{Losses, MeshOutcome as OfMesh, PositionFields};
use asperity::train::Outcome as OfTrain;
use asperity_report::{Fields, write_folder};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::arrays::columns;
use crate::failure::{self, Failure};
use crate::work::alone;

/// Outcome by kind of run.
pub enum Found {
    /// Losses alone, with program and title.
    Losses(&'static str, String, Box<Losses>),
    /// A mesh of a run.
    Mesh(Box<OfMesh>),
    /// A run.
    Run(Box<OfTrain>),
}

/// Losses with what they are of.
#[derive(serde::Serialize)]
struct Titled<'a> {
    program: &'a str,
    title: &'a str,
    #[serde(flatten)]
    losses: &'a Losses,
}

/// The outcome of a run.
#[pyclass(frozen, module = "asperity._asperity")]
pub struct Outcome(pub Arc<Found>);

impl Outcome {
    /// The outcome of the only mesh.
    fn only(&self) -> Option<&OfMesh> {
        match self.0.as_ref() {
            Found::Losses(..) => None,
            Found::Mesh(mesh) => Some(mesh),
            Found::Run(run) => run.only(),
        }
    }

    fn fields_of(&self) -> Result<&[PositionFields], Failure> {
        let none = || {
            Failure::new(
                Code::E402,
                "this result holds no fields; run with detail = \"fields\"",
            )
        };
        Ok(&self.only().ok_or_else(none)?.fields)
    }
}

#[pymethods]
impl Outcome {
    /// The result as the command prints it with --json, and the rows of the offsets.
    fn json(&self, py: Python<'_>) -> PyResult<(String, String)> {
        alone(py, || match self.0.as_ref() {
            Found::Losses(program, title, losses) => {
                let titled = Titled {
                    program,
                    title,
                    losses,
                };
                Ok((failure::json(&titled)?, failure::json(&losses.offsets)?))
            }
            Found::Mesh(mesh) => Ok((failure::json(&mesh.result)?, failure::json(&mesh.offsets)?)),
            Found::Run(run) => {
                let offsets = run.only().map_or(&[][..], |only| &only.offsets);
                Ok((failure::json(run)?, failure::json(&offsets)?))
            }
        })
    }

    /// Numbers of the positions whose fields are held.
    fn positions(&self) -> PyResult<Vec<usize>> {
        Ok(self
            .fields_of()?
            .iter()
            .map(|fields| fields.position)
            .collect())
    }

    /// Fields along the contact at a position, from 1 at A.
    fn fields<'py>(&self, py: Python<'py>, position: usize) -> PyResult<Bound<'py, PyDict>> {
        let fields = self.fields_of()?;
        let found = fields.iter().find(|fields| fields.position == position);
        let found = found.ok_or_else(|| {
            let kept = fields.iter().map(|one| one.position.to_string());
            let kept = kept.collect::<Vec<_>>().join(", ");
            let text = format!("there are no fields of position {position}, only of {kept}");
            Failure::new(Code::E402, text).advising(Remedy::act("name one of these positions"))
        })?;
        let mut arrays = vec![
            ("x", &found.x),
            ("height_pinion", &found.height_pinion),
            ("height_wheel", &found.height_wheel),
            ("displacement_pinion", &found.displacement_pinion),
            ("displacement_wheel", &found.displacement_wheel),
            ("plastic_pinion", &found.plastic_pinion),
            ("plastic_wheel", &found.plastic_wheel),
            ("gap", &found.gap),
            ("pressure_solid", &found.pressure_solid),
            ("pressure_fluid", &found.pressure_fluid),
            ("shear", &found.shear),
        ];
        if let Some(below) = &found.subsurface {
            arrays.extend([
                ("depths", &below.depths),
                ("sigma_xx", &below.sigma_xx),
                ("sigma_zz", &below.sigma_zz),
                ("tau_xz", &below.tau_xz),
                ("von_mises", &below.von_mises),
                ("plastic_stress", &below.plastic_stress),
            ]);
        }
        let arrays = arrays.into_iter();
        columns(py, arrays.map(|(name, values)| (name, values.clone())))
    }

    /// Outcomes of all meshes of a gear train.
    fn meshes(&self) -> PyResult<Vec<Self>> {
        let Found::Run(run) = self.0.as_ref() else {
            return Ok(Vec::new());
        };
        if run.only().is_some() {
            return Ok(Vec::new());
        }
        let meshes = run.meshes.iter().cloned();
        let of_mesh = |mesh: OfMesh| Self(Arc::new(Found::Mesh(mesh.into())));
        Ok(meshes.map(of_mesh).collect())
    }

    /// Writes the result folder, with all fields or those that its page shows.
    fn write(&self, py: Python<'_>, folder: PathBuf, fields: bool) -> PyResult<()> {
        let fields = if fields { Fields::All } else { Fields::Page };
        alone(py, || match self.0.as_ref() {
            Found::Mesh(mesh) => Ok(write_folder(&**mesh, &folder, &fields)?),
            Found::Run(run) => Ok(write_folder(&**run, &folder, &fields)?),
            Found::Losses(..) => {
                let message = "losses alone have no result folder; run with detail = \"fields\"";
                Err(Failure::new(Code::E402, message))
            }
        })
    }
}
