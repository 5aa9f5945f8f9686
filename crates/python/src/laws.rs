//! Laws of Hertz contact, film and friction over arrays: flat arrays of one length in, in SI units; broadcasting is
//! Python's.

use asperity::Remedy;
use asperity::contact::hertz_line::HertzLine;
use asperity::core::OutOfRange;
use asperity::ehl_regime::{FilmConditions, FilmLaw, thermal_reduction::ThermalLaw};
use asperity::message::Code;
use asperity::quantity::*;
use asperity::tribo_friction::conditions::{FrictionConditions, MeshConditions};
use asperity::tribo_friction::friction_law::{FrictionLaw, FrictionSettings};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::HashMap;

use crate::arrays::{Input, columns, copied, owned, same_length};
use crate::choices::named;
use crate::failure::{Failure, asked};
use crate::work::alone;

/// Quantities outside of the range that a law was fitted to, each once.
type Outside = Vec<String>;

/// Arrays by name, all of one length.
struct Columns(HashMap<String, Vec<f64>>, usize);

impl Columns {
    fn of(given: HashMap<String, Input<'_>>) -> Result<Self, Failure> {
        let columns: HashMap<_, _> = given
            .into_iter()
            .map(|(name, array)| (name, copied(&array)))
            .collect();
        let count = columns.values().next().map_or(0, Vec::len);
        if columns.values().any(|column| column.len() != count) {
            return Err(Failure::new(Code::E209, "all arrays must be of one length"));
        }
        Ok(Self(columns, count))
    }

    /// The value of a column, NaN of one that is not given: the laws that read it refuse it.
    fn at(&self, name: &str, index: usize) -> f64 {
        self.0.get(name).map_or(f64::NAN, |column| column[index])
    }
}

/// Notes each input that left its range, and whether any of this row did.
fn note(outside: &[OutOfRange], all: &mut Outside) -> bool {
    for found in outside {
        let text = format!("{}: {}", found.correlation, found.name);
        if !all.contains(&text) {
            all.push(text);
        }
    }
    !outside.is_empty()
}

/// Half width in m, largest and mean pressure in Pa of Hertz line contacts.
#[pyfunction]
pub fn hertz<'py>(
    py: Python<'py>,
    load: Input<'py>,
    radius: Input<'py>,
    modulus: Input<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let [load, radius, modulus] = [&load, &radius, &modulus].map(copied);
    let count = same_length(&[
        ("load", load.len()),
        ("radius", radius.len()),
        ("modulus", modulus.len()),
    ])?;
    let found = alone(py, || {
        let mut found = [(); 3].map(|()| Vec::with_capacity(count));
        for i in 0..count {
            let contact = HertzLine::new(
                LineLoad::from_si(load[i]),
                Length::from_si(radius[i]),
                Pressure::from_si(modulus[i]),
            )?;
            found[0].push(contact.half_width.si());
            found[1].push(contact.max_pressure.si());
            found[2].push(contact.mean_pressure().si());
        }
        Ok(found)
    })?;
    let names = ["half_width", "max_pressure", "mean_pressure"];
    columns(py, names.into_iter().zip(found))
}

type Films<'py> = (Bound<'py, PyDict>, Outside);

/// Central and minimum film in m by a law, and what left its range.
#[pyfunction]
pub fn film_thickness<'py>(
    py: Python<'py>,
    law: &str,
    given: HashMap<String, Input<'py>>,
) -> PyResult<Films<'py>> {
    let law: FilmLaw = named("law", law)?;
    let given = Columns::of(given)?;
    let (central, minimum, marks, outside) = alone(py, || {
        let (mut central, mut minimum, mut marks) = (Vec::new(), Vec::new(), Vec::new());
        let mut outside = Outside::new();
        for i in 0..given.1 {
            let at = |name| given.at(name, i);
            let length = given.0.contains_key("contact_length");
            let film = law.film(&FilmConditions {
                entrainment: Speed::from_si(at("entrainment")),
                radius: Length::from_si(at("radius")),
                load: LineLoad::from_si(at("load")),
                modulus: Pressure::from_si(at("modulus")),
                viscosity: DynamicViscosity::from_si(at("viscosity")),
                pressure_viscosity: PressureViscosity::from_si(at("pressure_viscosity")),
                contact_length: length.then(|| Length::from_si(at("contact_length"))),
            })?;
            central.push(film.value.central.si());
            minimum.push(film.value.minimum.si());
            marks.push(note(&film.outside, &mut outside));
        }
        Ok((central, minimum, marks, outside))
    })?;
    let arrays = columns(py, [("central", central), ("minimum", minimum)])?;
    arrays.set_item("outside", marks.into_pyarray(py))?;
    Ok((arrays, outside))
}

type Factors<'py> = (
    Bound<'py, PyArray1<f64>>,
    Bound<'py, PyArray1<bool>>,
    Outside,
);

fn checked<'py>(py: Python<'py>, found: (Vec<f64>, Vec<bool>, Outside)) -> Factors<'py> {
    let (values, marks, outside) = found;
    (owned(py, values), marks.into_pyarray(py), outside)
}

/// Factor by which heat in the inlet thins a film.
#[pyfunction]
pub fn thermal_reduction<'py>(
    py: Python<'py>,
    law: &str,
    given: HashMap<String, Input<'py>>,
) -> PyResult<Factors<'py>> {
    let law: ThermalLaw = named("law", law)?;
    let given = Columns::of(given)?;
    let found = alone(py, || {
        let (mut values, mut marks, mut outside) = (Vec::new(), Vec::new(), Outside::new());
        for i in 0..given.1 {
            let at = |name| given.at(name, i);
            let factor = law.reduction(
                Pressure::from_si(at("max_pressure")),
                Pressure::from_si(at("modulus")),
                at("loading"),
                at("slide_to_roll"),
            )?;
            values.push(factor.value);
            marks.push(note(&factor.outside, &mut outside));
        }
        Ok((values, marks, outside))
    })?;
    Ok(checked(py, found))
}

/// Friction coefficient by a published law; `settings` in JSON are those of the case file.
#[pyfunction]
pub fn friction_coefficient<'py>(
    py: Python<'py>,
    law: &str,
    given: HashMap<String, Input<'py>>,
    settings: &str,
) -> PyResult<Factors<'py>> {
    let law: FrictionLaw = named("law", law)?;
    let settings: FrictionSettings = asked(settings)?;
    let given = Columns::of(given)?;
    let found = alone(py, || {
        let (mut values, mut marks, mut outside) = (Vec::new(), Vec::new(), Outside::new());
        let missing = missing(law, &settings, &given);
        if !missing.is_empty() {
            let message = format!("{}: the law requires {}", law.name(), missing.join(", "));
            return Err(
                Failure::new(Code::E205, message).advising(Remedy::act("give each by its keyword"))
            );
        }
        for i in 0..given.1 {
            let at = |name: &str| given.at(name, i);
            let friction = law.coefficient(&settings, &conditions(&at))?;
            values.push(friction.value);
            marks.push(note(&friction.outside, &mut outside));
        }
        Ok((values, marks, outside))
    })?;
    Ok(checked(py, found))
}

/// The inputs of a friction law, each with a usual value in SI units.
const INPUTS: [(&str, f64); 21] = [
    ("load", 1e5),
    ("radius", 0.01),
    ("entrainment", 10.0),
    ("sliding", 1.0),
    ("max_pressure", 1e9),
    ("viscosity", 0.01),
    ("contact_viscosity", 0.01),
    ("kinematic_viscosity", 1e-5),
    ("pressure_viscosity", 2e-8),
    ("central_film", 2e-7),
    ("minimum_film", 1e-7),
    ("combined_roughness", 4e-7),
    ("mean_ra", 4e-7),
    ("sum_rz", 4e-6),
    ("boundary_coefficient", 0.1),
    ("base_line_load", 1e5),
    ("sum_speed", 10.0),
    ("reduced_radius", 0.01),
    ("lubricant_factor", 1.0),
    ("load_intensity", 1e6),
    ("pitch_line_speed", 10.0),
];

/// The inputs that are not given and without which the law has no coefficient.
fn missing(law: FrictionLaw, settings: &FrictionSettings, given: &Columns) -> Vec<&'static str> {
    if given.1 == 0 {
        return Vec::new();
    }
    let is_given = |name: &str| given.0.contains_key(name);
    // Usual values instead of the other inputs that are not given.
    let usual = |name: &str| {
        let mut inputs = INPUTS.iter();
        inputs
            .find(|input| input.0 == name)
            .map_or(f64::NAN, |input| input.1)
    };
    let has_value_without = |left_out: &str| {
        let at = |name: &str| {
            if is_given(name) {
                given.at(name, 0)
            } else if name == left_out {
                f64::NAN
            } else {
                usual(name)
            }
        };
        let found = law.coefficient(settings, &conditions(&at));
        found.is_ok_and(|found| found.value.is_finite())
    };
    if !has_value_without("") {
        return Vec::new();
    }
    let names = INPUTS.iter().map(|input| input.0);
    names
        .filter(|name| !is_given(name) && !has_value_without(name))
        .collect()
}

fn conditions(at: &dyn Fn(&str) -> f64) -> FrictionConditions {
    let length = |name| Length::from_si(at(name));
    let speed = |name| Speed::from_si(at(name));
    FrictionConditions {
        load: LineLoad::from_si(at("load")),
        radius: length("radius"),
        entrainment: speed("entrainment"),
        sliding: speed("sliding"),
        max_pressure: Pressure::from_si(at("max_pressure")),
        viscosity: DynamicViscosity::from_si(at("viscosity")),
        contact_viscosity: DynamicViscosity::from_si(at("contact_viscosity")),
        kinematic_viscosity: KinematicViscosity::from_si(at("kinematic_viscosity")),
        pressure_viscosity: PressureViscosity::from_si(at("pressure_viscosity")),
        central_film: length("central_film"),
        minimum_film: length("minimum_film"),
        combined_roughness: length("combined_roughness"),
        mean_ra: length("mean_ra"),
        sum_rz: length("sum_rz"),
        boundary_coefficient: at("boundary_coefficient"),
        mesh: MeshConditions {
            base_line_load: LineLoad::from_si(at("base_line_load")),
            sum_speed: speed("sum_speed"),
            reduced_radius: length("reduced_radius"),
            lubricant_factor: at("lubricant_factor"),
            load_intensity: Pressure::from_si(at("load_intensity")),
            pitch_line_speed: speed("pitch_line_speed"),
        },
    }
}
