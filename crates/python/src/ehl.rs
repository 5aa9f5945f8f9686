//! The mixed lubricated contact of a case at one place, in time.

use std::sync::atomic::{AtomicU64, Ordering};

use asperity::Run;
use asperity::ehl::RecordSettings;
use asperity::ehl::several_records::{mean_of, record_several};
use asperity::lubrication::{HIGHEST_PRESSURE, shares};
use asperity::message::Code;
use asperity::quantity::Pressure;
use asperity::reference_solution::{
    Inlet, ReferenceContact, ReferenceSettings, record_json, record_warnings,
};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use serde_json::{Value, json};

use crate::arrays::columns;
use crate::case::{Case, on_the_path};
use crate::failure::{self, Failure};
use crate::work::in_parallel;

/// Grid, length and number of the records, as JSON from Python.
#[derive(serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct Asked {
    position: Option<f64>,
    cells: usize,
    half_widths: f64,
    start: f64,
    records: usize,
    eyring_stress: Option<f64>,
    compare: bool,
}

/// Solves the contact of a case at a place of its path; numbers as JSON, mean pressure and film as arrays.
#[pyfunction]
pub fn ehl<'py>(
    py: Python<'py>,
    case: &Case,
    asked: &str,
    threads: Option<isize>,
    progress: Option<Bound<'py, PyAny>>,
) -> PyResult<(String, Bound<'py, PyDict>)> {
    let asked: Asked = failure::asked(asked)?;
    let loaded = case.only()?;
    let (numbers, record) = in_parallel(py, threads, progress.as_ref(), |told| {
        let place = on_the_path(asked.position)?.unwrap_or(loaded.case.paper.position);
        let settings = ReferenceSettings {
            record: RecordSettings {
                cells: asked.cells,
                start: asked.start,
                length: asked.half_widths,
                ..RecordSettings::default()
            },
            eyring_stress: asked.eyring_stress.map(Pressure::from_si),
            with_heat: true,
            beginning: 0,
            shortest_wave: None,
            inlet: Inlet::ByLoad,
        };
        let loaded = &Run::new(loaded).operating_case()?;
        let contact = ReferenceContact::new(loaded, place, &settings)?;
        // Thousandths of a half-width, of all records together.
        let travelled: Vec<AtomicU64> = (0..asked.records.max(1))
            .map(|_| AtomicU64::new(0))
            .collect();
        let records = record_several(
            &contact.rough,
            travelled.len(),
            &contact.record,
            &|number, now| {
                travelled[number].store((1e3 * now.time) as u64, Ordering::Relaxed);
                let all: u64 = travelled.iter().map(|t| t.load(Ordering::Relaxed)).sum();
                told.tell(
                    all as usize / 1000,
                    now.end.ceil() as usize * travelled.len(),
                );
                true
            },
        )?;
        let solved =
            mean_of(&records).ok_or_else(|| Failure::new(Code::E501, "no reference solution"))?;
        let highest = solved.value.max_pressure;
        if highest > HIGHEST_PRESSURE {
            let message = format!(
                "the pressure reaches {highest:.3}, above {HIGHEST_PRESSURE}, which no steel bears"
            );
            return Err(Failure::new(Code::E308, message));
        }
        let mut numbers = Value::Object(record_json(&solved.value));
        let roughness = contact.attenuated_roughness;
        let warnings =
            record_warnings(&solved.value, roughness, contact.record.ceiling).into_iter();
        let warnings = warnings.map(|(code, text)| json!({ "code": code, "text": text }));
        numbers["warnings"] = warnings.collect();
        numbers["path_fraction"] = json!(place);
        numbers["attenuated_roughness_um"] = json!(contact.attenuated_roughness.si() * 1e6);
        numbers["steps"] = json!(solved.evidence.steps);
        numbers["load_error"] = json!(solved.evidence.load_error);
        if asked.compare {
            numbers["comparison"] = json!(shares(loaded, &contact, &solved.value)?);
        }
        Ok((numbers, solved.value))
    })?;
    let (a, p_0) = (
        record.scales.half_width.si(),
        record.scales.max_pressure.si(),
    );
    let scaled = |values: &[f64], factor: f64| values.iter().map(|value| value * factor).collect();
    let film = record.mean_film_on_nodes.iter();
    let film = film
        .map(|film| record.scales.film_length(*film).si())
        .collect();
    let arrays = [
        ("x", scaled(&record.x, a)),
        ("mean_pressure", scaled(&record.mean_pressure, p_0)),
        ("mean_film", film),
    ];
    Ok((failure::json(&numbers)?, columns(py, arrays)?))
}
