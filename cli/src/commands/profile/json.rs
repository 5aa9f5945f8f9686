//! One profile as JSON: the keys that scripts rely on, lengths in micrometres.

use asperity_core::quantity::Length;
use asperity_report::profile_json::{heights, material, spectral, um};
use asperity_roughness::ambiguity::Ambiguity;
use asperity_roughness::autocorrelation::autocorrelation;
use asperity_roughness::height_parameters::HeightParameters;
use asperity_roughness::material_ratio::abbott_curve;
use asperity_roughness::spectral::PowerSpectrum;
use serde_json::{Map, Value, json};

use super::details::Details;
use super::evaluated::EvaluatedFile;
use crate::args::name_of;

/// Convention of the spectrum.
const CONVENTION: &str = "of the R profile about its mean; Hann window; one-sided over spatial frequency f = 1/wavelength; \
     its integral over f is the mean square height of the windowed profile";

/// Report of a profile, on request with its curves by point.
pub fn report(evaluated: &EvaluatedFile, details: &Details, curves: bool) -> Value {
    let reading = &evaluated.reading;
    let notes = evaluated.warnings().into_iter();
    let notes: Vec<Value> = notes
        .map(|w| json!({ "code": w.code(), "text": w.to_string() }))
        .collect();
    let mut report = json!({
        "file": reading.name,
        "format": reading.format,
        "n": reading.points,
        "dx_um": um(reading.spacing),
        "length_um": um(reading.length),
        "filter_state": reading.filter_state,
        "reading": reading,
        "preparation": evaluated.plan.recorded(&evaluated.parts.roughness.record),
        "section_um": um(evaluated.section),
        "iso4287": heights(&evaluated.iso4287.heights),
        "iso21920": heights(&evaluated.iso21920.heights),
        "primary": whole("p", &evaluated.primary),
        "waviness": evaluated.waviness.as_ref().map(|p| whole("w", p)),
        "material_ratio": material(&evaluated.iso4287.material),
        "material_ratio_secant": details.secant.as_ref().map(material),
        "spectral": spectral(&evaluated.iso4287.spectral),
        "psd": details.spectrum.as_ref().map(|_| json!({
            "convention": CONVENTION,
            "median_wavelength_um": details.median_wavelength().map(um),
        })),
        "autocorrelation": details.correlation.map(|lengths| json!({
            "to_one_fifth_um": lengths.to_one_fifth.map(um),
            "to_one_over_e_um": lengths.to_one_over_e.map(um),
        })),
        "summits": summits(details),
        "hurst": hurst(details),
        "ambiguity": details.ambiguity.iter().map(open).collect::<Vec<_>>(),
        "warnings": notes,
    });
    if let Some(levels) = details.levels.json() {
        report["material_levels"] = levels;
    }
    if curves {
        report["curves"] = all_curves(evaluated, details);
    }
    report
}

/// P and W parameters over the full length, under separate names.
fn whole(letter: &str, p: &HeightParameters) -> Value {
    let mut parameters = Map::new();
    for (name, value) in [
        ("a_um", Some(um(p.ra))),
        ("q_um", Some(um(p.rq))),
        ("p_um", Some(um(p.rp))),
        ("v_um", Some(um(p.rv))),
        ("t_um", Some(um(p.rt))),
        ("sk", p.rsk),
        ("ku", p.rku),
        ("sm_um", p.rsm.map(um)),
        ("c_um", p.rc.map(um)),
        ("dq", Some(p.rdq)),
    ] {
        parameters.insert(format!("{letter}{name}"), json!(value));
    }
    Value::Object(parameters)
}

fn summits(details: &Details) -> Option<Value> {
    /// Per metre to per millimetre.
    const PER_MM: f64 = 1e-3;
    details.summits.map(|summits| {
        json!({
            "count": summits.count,
            "density_per_mm": summits.density * PER_MM,
            "density_of_gaussian_per_mm": summits.spectral_density * PER_MM,
            "mean_height_um": um(summits.mean_height),
            "height_deviation_um": um(summits.height_deviation),
            "mean_curvature_per_um": summits.mean_curvature * 1e-6,
            "mean_radius_um": summits.mean_radius.map(um),
            "window_um": um(details.window),
        })
    })
}

/// The Hurst fit with its range, or its error.
fn hurst(details: &Details) -> Value {
    let range = details.wavelengths;
    let mut value = match &details.hurst {
        Ok(fit) => json!(fit),
        Err(reason) => json!({ "hurst": null, "reason": reason.to_string() }),
    };
    value["longest_um"] = json!(um(range.longest));
    value["shortest_um"] = json!(um(range.shortest));
    value
}

/// Range of a parameter, with lengths in micrometres, and the contribution of each choice.
fn open(range: &Ambiguity) -> Value {
    let (unit, factor) = match range.unit {
        "m" => ("um", 1e6),
        other => (other, 1.0),
    };
    let both = |low: f64, high: f64| (low * factor, high * factor);
    let (low, high) = both(range.low, range.high);
    let spreads = range.spreads.iter().map(|spread| {
        let (low, high) = both(spread.low, spread.high);
        json!({ "choice": name_of(&spread.choice), "low": low, "high": high })
    });
    json!({
        "parameter": range.parameter, "unit": unit, "low": low, "high": high,
        "spreads": spreads.collect::<Vec<_>>(),
    })
}

fn all_curves(evaluated: &EvaluatedFile, details: &Details) -> Value {
    let rough = &evaluated.parts.roughness.profile;
    let in_um = |values: Vec<f64>| values.into_iter().map(|z| 1e6 * z).collect::<Vec<_>>();
    json!({
        "psd": details.spectrum.as_ref().map(spectrum),
        "autocorrelation": autocorrelation(rough.heights()).ok().map(|rho| json!({
            "shift_step_um": um(rough.spacing()), "rho": rho,
        })),
        "material_ratio": abbott_curve(rough.heights()).ok().map(|curve| json!({
            "convention": "height k of n, counted from 0, has the material ratio 100 (k + 1/2)/n percent",
            "height_um": in_um(curve),
        })),
    })
}

/// All waves of a spectrum, longest first.
fn spectrum(spectrum: &PowerSpectrum) -> Value {
    let (mut frequencies, mut wavelengths, mut densities) = (Vec::new(), Vec::new(), Vec::new());
    for (k, density) in spectrum.density.iter().enumerate().skip(1) {
        let frequency = k as f64 * spectrum.frequency_step;
        frequencies.push(1e-6 * frequency);
        wavelengths.push(um(Length::from_si(1.0 / frequency)));
        // m³ to um³.
        densities.push(1e18 * density);
    }
    json!({
        "convention": CONVENTION,
        "frequency_per_um": frequencies, "wavelength_um": wavelengths, "density_um3": densities,
    })
}
