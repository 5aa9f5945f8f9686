//! Laws written in Python: each is called once at a mesh position, with arrays over the offsets of the traces.

use std::fmt;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use asperity::core::{Checked, DomainError};
use asperity::ehl_regime::{FilmConditions, FilmThickness, FilmThicknessLaw, RegimeError};
use asperity::error::PositionError;
use asperity::gear::{GearError, LoadConditions, LoadDistribution, LoadMap, LoadSharing};
use asperity::laws::Laws;
use asperity::lubrication::{LoadShare, ShareConditions, SharedLoad};
use asperity::quantity::{Length, LineLoad, Pressure};
use asperity::tribo_friction::{FilmContact, FilmFriction, FilmTraction, FrictionError};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::choices::LawOf;
use crate::work;

/// A law in Python. `call` takes the conditions as a dictionary and returns arrays by name, checked.
pub struct PythonLaw {
    name: String,
    /// Exponent of speed in the central film, of a film thickness.
    exponent: f64,
    call: Py<PyAny>,
    /// Two laws are never the same: what a law computes is not known here.
    number: u64,
}

impl fmt::Debug for PythonLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "law {} of Python, number {}", self.name, self.number)
    }
}

/// Columns over the offsets, by name.
type Columns<'a> = Vec<(&'a str, Vec<f64>)>;

impl PythonLaw {
    /// A law that a case takes.
    pub fn new(name: String, exponent: f64, call: Py<PyAny>) -> Self {
        static NUMBERS: AtomicU64 = AtomicU64::new(0);
        Self {
            name,
            exponent,
            call,
            number: NUMBERS.fetch_add(1, Ordering::Relaxed),
        }
    }

    /// Puts this law instead of that of a case.
    pub fn put_into(self: &Arc<Self>, laws: &mut Laws, law: LawOf) {
        let own = Arc::clone(self);
        match law {
            LawOf::FilmFriction => laws.friction = Some(own),
            LawOf::FilmThickness => laws.film = Some(own),
            LawOf::LoadShare => laws.load_share = Some(own),
            LawOf::LoadDistribution => laws.load_distribution = Some(own),
        }
    }

    /// The arrays called `names` that the law returns for these conditions, each of `count` values. The exception of a
    /// law ends the work, whose caller raises it.
    fn answer<const N: usize>(
        &self,
        conditions: Columns<'_>,
        names: [&str; N],
        count: usize,
    ) -> Result<[Vec<f64>; N], DomainError> {
        let ended = || DomainError {
            name: "a law in Python",
            value: f64::NAN,
            unit: "-",
            rule: "ended with an exception",
        };
        if work::has_raised() {
            return Err(ended());
        }
        let called = Python::attach(|py| -> PyResult<[Vec<f64>; N]> {
            let given = PyDict::new(py);
            for (name, values) in conditions {
                given.set_item(name, values.into_pyarray(py))?;
            }
            let found = self.call.bind(py).call1((given, count))?;
            let mut arrays = names.map(|_| Vec::new());
            for (array, name) in arrays.iter_mut().zip(names) {
                let values: PyReadonlyArray1<'_, f64> = found.get_item(name)?.extract()?;
                *array = values.as_array().to_vec();
            }
            Ok(arrays)
        });
        called.map_err(|error| {
            work::raise(error);
            ended()
        })
    }
}

/// Columns of one value for each item.
macro_rules! columns {
    ($items:expr, $($name:literal: $of:expr),+ $(,)?) => {
        vec![$(($name, $items.iter().map($of).collect::<Vec<f64>>())),+]
    };
}

fn of_contacts<'a>(contacts: &[&FilmContact<'_>]) -> Columns<'a> {
    columns!(contacts,
        "load": |at| at.position.load.si(),
        "radius": |at| at.position.radius.si(),
        "entrainment": |at| at.position.entrainment.si(),
        "sliding": |at| at.position.sliding.si(),
        "max_pressure": |at| at.position.max_pressure.si(),
        "viscosity": |at| at.position.viscosity.si(),
        "contact_viscosity": |at| at.position.contact_viscosity.si(),
        "kinematic_viscosity": |at| at.position.kinematic_viscosity.si(),
        "pressure_viscosity": |at| at.position.pressure_viscosity.si(),
        "central_film": |at| at.position.central_film.si(),
        "minimum_film": |at| at.position.minimum_film.si(),
        "combined_roughness": |at| at.position.combined_roughness.si(),
        "mean_ra": |at| at.position.mean_ra.si(),
        "sum_rz": |at| at.position.sum_rz.si(),
        "boundary_coefficient": |at| at.position.boundary_coefficient,
        "modulus": |at| at.modulus.si(),
        "half_width": |at| at.half_width.si(),
        "bulk_temperature": |at| at.bulk_temperature.si(),
    )
}

impl FilmFriction for PythonLaw {
    fn name(&self) -> &str {
        &self.name
    }

    fn traction(&self, contact: &FilmContact<'_>) -> Result<Checked<FilmTraction>, FrictionError> {
        let found = self.tractions(std::slice::from_ref(contact))?.pop();
        Ok(found.unwrap_or_else(|| Checked::inside(FilmTraction::from_coefficient(f64::NAN))))
    }

    fn tractions(
        &self,
        contacts: &[FilmContact<'_>],
    ) -> Result<Vec<Checked<FilmTraction>>, FrictionError> {
        let all: Vec<&FilmContact<'_>> = contacts.iter().collect();
        let [found] = self.answer(of_contacts(&all), ["coefficient"], contacts.len())?;
        let traction = |mu| Checked::inside(FilmTraction::from_coefficient(mu));
        Ok(found.into_iter().map(traction).collect())
    }
}

impl FilmThicknessLaw for PythonLaw {
    fn name(&self) -> &str {
        &self.name
    }

    fn film(&self, at: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
        let conditions = columns!([at],
            "entrainment": |at| at.entrainment.si(),
            "radius": |at| at.radius.si(),
            "load": |at| at.load.si(),
            "modulus": |at| at.modulus.si(),
            "viscosity": |at| at.viscosity.si(),
            "pressure_viscosity": |at| at.pressure_viscosity.si(),
        );
        let found = self.answer(conditions, ["central", "minimum"], 1)?;
        let [central, minimum] = found.map(|of| Length::from_si(of[0]));
        Ok(Checked::inside(FilmThickness { central, minimum }))
    }

    fn speed_exponent(&self) -> f64 {
        self.exponent
    }
}

impl LoadShare for PythonLaw {
    fn name(&self) -> &str {
        &self.name
    }

    fn share(&self, conditions: &ShareConditions<'_>) -> Result<SharedLoad, PositionError> {
        let found = self.shares(std::slice::from_ref(conditions))?.pop();
        Ok(found.unwrap_or(SharedLoad::of_film(f64::NAN)))
    }

    fn shares(&self, conditions: &[ShareConditions<'_>]) -> Result<Vec<SharedLoad>, PositionError> {
        let contacts: Vec<&FilmContact<'_>> = conditions.iter().map(|at| at.contact).collect();
        let mut all = of_contacts(&contacts);
        all.extend(columns!(conditions,
            "lambda_star": |at| at.lambda_star.unwrap_or(f64::NAN),
            "film_ratio": |at| at.film_ratio,
            "reduced_peak": |at| at.roughness.reduced_peak.unwrap_or(f64::NAN),
            "flow_pressure": |at| at.flow_pressure.map(Pressure::si).into_iter().fold(f64::INFINITY, f64::min),
        ));
        let names = ["film_share", "boundary_part", "lubricated_coefficient"];
        let [film, boundary, coefficient] = self.answer(all, names, conditions.len())?;
        let asperities = boundary.into_iter().zip(coefficient);
        let shared = film.into_iter().zip(asperities);
        Ok(shared
            .map(|(film, (part, mu))| {
                SharedLoad::of_film(film).with_lubricated_asperities(part, mu)
            })
            .collect())
    }
}

impl LoadDistribution for PythonLaw {
    fn name(&self) -> &str {
        &self.name
    }

    fn load_map(&self, mesh: &LoadConditions<'_>) -> Result<LoadMap, GearError> {
        let path = mesh.pair.path();
        LoadMap::of_line_loads(mesh, |places| {
            let uniform = |s: &Length| {
                let load = mesh.pair.line_load(*s, mesh.torque, &LoadSharing::Uniform);
                load.map(|load| load.si().abs())
            };
            let uniform = places.iter().map(uniform).collect::<Result<Vec<_>, _>>()?;
            let mut conditions = columns!(places,
                "s": |s| s.si(),
                "path_fraction": |s| (*s - path.a) / (path.e - path.a),
                "torque": |_| mesh.torque.si(),
            );
            conditions.push(("uniform", uniform));
            let [found] = self.answer(conditions, ["line_load"], places.len())?;
            Ok(found.into_iter().map(LineLoad::from_si).collect())
        })
    }
}
