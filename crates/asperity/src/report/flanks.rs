//! Tables of the flanks: the trace as measured, levelled and filtered, its material ratio curve, its
//! spectrum.

use std::path::Path;

use asperity_core::Profile;
use asperity_roughness::RoughnessError;
use asperity_roughness::form;
use asperity_roughness::material_ratio::abbott_curve;
use asperity_roughness::preparation::prepare;
use asperity_roughness::spectral::power_spectrum;
use serde::Serialize;

use super::tables::write;
use super::{MICRO, ReportError};
use crate::surfaces::FlankReport;

/// Names of the two flanks in files.
pub(super) const BODIES: [&str; 2] = ["pinion", "wheel"];

/// A flank at the three stages of its preparation [m]; NaN where the filter dropped the end.
struct Stages {
    spacing: f64,
    raw: Vec<f64>,
    form_removed: Vec<f64>,
    roughness: Profile,
    first_index: usize,
}

fn stages(flank: &FlankReport) -> Result<Option<Stages>, RoughnessError> {
    let (Some(reading), Some(record)) = (&flank.reading, &flank.preparation) else {
        return Ok(None);
    };
    let raw = match flank.mirrored {
        true => reading.profile.mirrored(),
        false => reading.profile.clone(),
    };
    let form_removed = form::remove(&raw, record.recipe.form)?.heights().to_vec();
    let prepared = prepare(&raw, &record.recipe)?;
    Ok(Some(Stages {
        spacing: raw.spacing().si(),
        raw: raw.heights().to_vec(),
        form_removed,
        roughness: prepared.profile,
        first_index: prepared.first_index,
    }))
}

/// `flank_*.csv`, `abbott_*.csv` and `psd_*.csv` of every flank that was measured.
pub(super) fn write_flanks(flanks: &[FlankReport; 2], folder: &Path) -> Result<(), ReportError> {
    for (body, flank) in BODIES.into_iter().zip(flanks) {
        let Some(stages) = stages(flank)? else {
            continue;
        };
        profile(&stages, &folder.join(format!("flank_{body}.csv")))?;
        abbott(&stages, &folder.join(format!("abbott_{body}.csv")))?;
        spectrum(&stages, &folder.join(format!("psd_{body}.csv")))?;
    }
    Ok(())
}

fn profile(stages: &Stages, file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        x_um: f64,
        measured_um: f64,
        form_removed_um: f64,
        roughness_um: Option<f64>,
    }
    let rough = stages.roughness.heights();
    write(
        file,
        (0..stages.raw.len()).map(|i| Row {
            x_um: i as f64 * stages.spacing * MICRO,
            measured_um: stages.raw[i] * MICRO,
            form_removed_um: stages.form_removed[i] * MICRO,
            roughness_um: i
                .checked_sub(stages.first_index)
                .and_then(|k| rough.get(k))
                .map(|z| z * MICRO),
        }),
    )
}

fn abbott(stages: &Stages, file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        material_ratio_percent: f64,
        height_um: f64,
    }
    let curve = abbott_curve(stages.roughness.heights()).map_err(RoughnessError::from)?;
    let count = curve.len() as f64;
    write(
        file,
        curve.iter().enumerate().map(|(k, height)| Row {
            material_ratio_percent: 100.0 * (k as f64 + 0.5) / count,
            height_um: height * MICRO,
        }),
    )
}

fn spectrum(stages: &Stages, file: &Path) -> Result<(), ReportError> {
    #[derive(Serialize)]
    struct Row {
        frequency_per_mm: f64,
        wavelength_um: f64,
        density_um3: f64,
    }
    /// Cubic metres to cubic micrometres.
    const CUBIC_MICRO: f64 = MICRO * MICRO * MICRO;
    let found = power_spectrum(&stages.roughness)?;
    // The mean, at no frequency, is left out.
    let rows = found
        .density
        .iter()
        .enumerate()
        .skip(1)
        .map(|(k, density)| {
            let frequency = k as f64 * found.frequency_step;
            Row {
                frequency_per_mm: frequency * 1e-3,
                wavelength_um: MICRO / frequency,
                density_um3: density * CUBIC_MICRO,
            }
        });
    write(file, rows)
}
