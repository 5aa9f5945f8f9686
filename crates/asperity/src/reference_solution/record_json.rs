//! Numbers of a record as JSON, for the command and for Python.

use asperity_core::quantity::Length;
use asperity_ehl::transient::{HeatedFriction, MeanFriction};
use asperity_ehl::{Record, RecordMean};
use serde_json::{Map, Value, json};

/// Means of a record with their standard errors, which a record of one block does not have.
#[must_use]
pub fn record_json(record: &Record) -> Map<String, Value> {
    let scales = &record.scales;
    let below = record.load_below.iter().map(|below| {
        json!({
            "film_nm": nanometres(below.film),
            "share": below.share.mean,
            "standard_error": finite(below.share.standard_error),
        })
    });
    let numbers = json!({
        "half_width_um": scales.half_width.si() * 1e6,
        "hertz_pressure_pa": scales.max_pressure.si(),
        "moes_load": scales.moes_load,
        "moes_lubricant": scales.moes_lubricant,
        "slide_to_roll": scales.slide_to_roll,
        "travel_half_widths": record.travel,
        "solid_share": record.solid_share.mean,
        "solid_share_standard_error": finite(record.solid_share.standard_error),
        "load_below": below.collect::<Vec<_>>(),
        "central_film_um": record.smooth_film.si() * 1e6,
        "mean_film_um": record.mean_film.mean * 1e6,
        "mean_film_standard_error_um": finite(record.mean_film.standard_error * 1e6),
        "film_spread_um": record.film_spread.si() * 1e6,
        "mean_max_pressure_pa": record.mean_max_pressure.mean,
        "max_pressure_pa": record.max_pressure.si(),
        "plastic_share": record.plastic_share.mean,
        "friction": record.friction.as_ref().map(friction),
        "with_heat": record.heated.as_ref().map(with_heat),
    });
    match numbers {
        Value::Object(numbers) => numbers,
        _ => Map::new(),
    }
}

/// A film thickness in nm, without the digits that its conversion adds.
#[must_use]
pub fn nanometres(film: Length) -> f64 {
    (film.si() * 1e15).round() * 1e-6
}

/// An estimate as JSON.
#[must_use]
pub fn estimate_json(estimate: &RecordMean) -> Value {
    json!({ "mean": estimate.mean, "standard_error": finite(estimate.standard_error) })
}

fn with_heat(heated: &HeatedFriction) -> Value {
    json!({
        "friction": friction(&heated.friction),
        "film_rise_k": estimate_json(&heated.film_rise),
        "surface_rise_k": estimate_json(&heated.surface_rise),
    })
}

fn friction(friction: &MeanFriction) -> Value {
    json!({
        "shifted": estimate_json(&friction.shifted),
        "graded": estimate_json(&friction.graded),
        "stepped": estimate_json(&friction.stepped),
        "film_alone": estimate_json(&friction.film),
    })
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
