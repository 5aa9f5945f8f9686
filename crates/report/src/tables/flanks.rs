//! Tables of a flank: trace as measured, levelled and filtered, material ratio curve, spectrum.

use std::path::Path;

use asperity::result::FlankRecord;
use asperity_core::{Fault, Profile};
use asperity_roughness::RoughnessError;
use asperity_roughness::form;
use asperity_roughness::material_ratio::abbott_curve;
use asperity_roughness::preparation::{Prepared, prepare};
use asperity_roughness::spectral::power_spectrum;
use serde::{Deserialize, Serialize};

use super::csv_table::{read, write};
use crate::thin::{BINS, thin};
use crate::units::MICRO;

/// Names of the two flanks in files.
pub const BODIES: [&str; 2] = ["pinion", "wheel"];

/// Row of `flank_*.csv`: a point of the trace.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TraceRow {
    /// Position along the trace \[µm\].
    pub x_um: f64,
    /// Height as measured \[µm\].
    pub measured_um: f64,
    /// Height with the form removed \[µm\].
    pub form_removed_um: f64,
    /// Height of the roughness \[µm\]; absent at the ends that the filter drops.
    pub roughness_um: Option<f64>,
}

/// Row of `abbott_*.csv`: a point of the material ratio curve.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct MaterialRatioRow {
    /// Material ratio \[%\].
    pub material_ratio_percent: f64,
    /// Height \[µm\].
    pub height_um: f64,
}

/// Row of `psd_*.csv`: a point of the one-sided power spectral density.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SpectrumRow {
    /// Spatial frequency \[1/mm\].
    pub frequency_per_mm: f64,
    /// Wavelength \[µm\].
    pub wavelength_um: f64,
    /// Density \[µm³\].
    pub density_um3: f64,
}

/// Tables of a measured flank.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FlankTables {
    /// The trace.
    pub trace: Vec<TraceRow>,
    /// The material ratio curve.
    pub material_ratio: Vec<MaterialRatioRow>,
    /// The spectrum.
    pub spectrum: Vec<SpectrumRow>,
}

/// Files of the flank of `body`: trace, material ratio curve, spectrum.
pub fn files_of(body: &str) -> [String; 3] {
    ["flank", "abbott", "psd"].map(|kind| format!("{kind}_{body}.csv"))
}

impl FlankTables {
    /// Makes the tables of the flank `record` whose trace is `profile`; `None` for a flank without a
    /// trace.
    ///
    /// # Errors
    /// When the trace cannot be prepared.
    pub fn new(
        record: &FlankRecord,
        profile: Option<&Profile>,
    ) -> Result<Option<Self>, RoughnessError> {
        let whole = |of: Evaluated| {
            Ok(Self {
                spectrum: of.spectrum()?,
                material_ratio: of.material_ratio()?,
                trace: of.trace(),
            })
        };
        Evaluated::of(record, profile)?.map(whole).transpose()
    }

    /// [`new`](Self::new) thinned for display, with the extremes of every drawn curve, and the spectrum averaged in bands. One whole
    /// table is in memory at a time: a trace of a million points makes a hundred megabytes of them.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn shown(
        record: &FlankRecord,
        profile: Option<&Profile>,
    ) -> Result<Option<Self>, RoughnessError> {
        let thinned = |of: Evaluated| {
            let spectrum = in_bands(&of.spectrum()?);
            let material_ratio = thin(
                &of.material_ratio()?,
                BINS,
                |row| row.material_ratio_percent,
                |row| [row.height_um],
            );
            let trace = thin(
                &of.trace(),
                BINS,
                |row| row.x_um,
                |row| {
                    let rough = row.roughness_um.unwrap_or(f64::NAN);
                    [row.measured_um, row.form_removed_um, rough]
                },
            );
            Ok(Self {
                trace,
                material_ratio,
                spectrum,
            })
        };
        Evaluated::of(record, profile)?.map(thinned).transpose()
    }

    /// The spectrum as means of the density in bands of a twelfth of a decade, at the geometric mean of their frequencies.
    /// With equal steps of frequency the area below the spectrum, the mean square of the heights, stays.
    #[must_use]
    pub fn spectrum_in_bands(&self) -> Vec<SpectrumRow> {
        in_bands(&self.spectrum)
    }

    /// Reads the tables of flank `body` (0 pinion, 1 wheel) in a result folder.
    ///
    /// # Errors
    /// When one of the tables is missing or damaged.
    pub fn read(folder: &Path, body: usize) -> Result<Self, Fault> {
        let files = files_of(BODIES[body]).map(|name| folder.join(name));
        Ok(Self {
            trace: read(&files[0])?,
            material_ratio: read(&files[1])?,
            spectrum: read(&files[2])?,
        })
    }

    /// Writes the tables of flank `body` into `folder`.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn write(&self, folder: &Path, body: usize) -> Result<(), Fault> {
        let [trace, material_ratio, spectrum] =
            files_of(BODIES[body]).map(|name| folder.join(name));
        write(&trace, &self.trace)?;
        write(&material_ratio, &self.material_ratio)?;
        write(&spectrum, &self.spectrum)
    }
}

fn in_bands(rows: &[SpectrumRow]) -> Vec<SpectrumRow> {
    const PER_DECADE: f64 = 12.0;
    let band = |row: &SpectrumRow| (PER_DECADE * row.frequency_per_mm.log10()).floor();
    let mean = |of: &dyn Fn(&SpectrumRow) -> f64, rows: &[SpectrumRow]| {
        rows.iter().map(of).sum::<f64>() / rows.len() as f64
    };
    let bands = rows.chunk_by(|a, b| band(a) == band(b));
    let row = |rows: &[SpectrumRow]| {
        let frequency_per_mm = mean(&|row| row.frequency_per_mm.ln(), rows).exp();
        SpectrumRow {
            frequency_per_mm,
            wavelength_um: 1e3 / frequency_per_mm,
            density_um3: mean(&|row| row.density_um3, rows),
        }
    };
    bands.map(row).collect()
}

/// A trace with its form removed and filtered.
struct Evaluated {
    raw: Profile,
    form_removed: Profile,
    prepared: Prepared,
}

impl Evaluated {
    fn of(record: &FlankRecord, profile: Option<&Profile>) -> Result<Option<Self>, RoughnessError> {
        let (Some(profile), Some(preparation)) = (profile, &record.preparation) else {
            return Ok(None);
        };
        let raw = match record.mirrored {
            true => profile.mirrored(),
            false => profile.clone(),
        };
        Ok(Some(Self {
            form_removed: form::remove(&raw, preparation.recipe.form)?,
            prepared: prepare(&raw, &preparation.recipe)?,
            raw,
        }))
    }

    fn trace(&self) -> Vec<TraceRow> {
        let (measured, level) = (self.raw.heights(), self.form_removed.heights());
        let rough = self.prepared.profile.heights();
        let rows = (0..measured.len()).map(|i| TraceRow {
            x_um: i as f64 * self.raw.spacing().si() * MICRO,
            measured_um: measured[i] * MICRO,
            form_removed_um: level[i] * MICRO,
            roughness_um: i
                .checked_sub(self.prepared.first_index)
                .and_then(|k| rough.get(k))
                .map(|z| z * MICRO),
        });
        rows.collect()
    }

    fn material_ratio(&self) -> Result<Vec<MaterialRatioRow>, RoughnessError> {
        let curve = abbott_curve(self.prepared.profile.heights())?;
        let count = curve.len() as f64;
        let rows = curve
            .iter()
            .enumerate()
            .map(|(k, height)| MaterialRatioRow {
                material_ratio_percent: 100.0 * (k as f64 + 0.5) / count,
                height_um: height * MICRO,
            });
        Ok(rows.collect())
    }

    fn spectrum(&self) -> Result<Vec<SpectrumRow>, RoughnessError> {
        /// Cubic micrometres per cubic metre.
        const CUBIC_MICRO: f64 = MICRO * MICRO * MICRO;
        let spectrum = power_spectrum(&self.prepared.profile)?;
        // The mean, at frequency zero, is omitted.
        let points = spectrum.density.iter().enumerate().skip(1);
        let rows = points.map(|(k, density)| {
            let frequency = k as f64 * spectrum.frequency_step;
            SpectrumRow {
                frequency_per_mm: frequency * 1e-3,
                wavelength_um: MICRO / frequency,
                density_um3: density * CUBIC_MICRO,
            }
        });
        Ok(rows.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_leave_the_area_below_the_spectrum_and_single_lines_as_they_are() {
        let rows: Vec<SpectrumRow> = (1..=5000)
            .map(|k| {
                let frequency_per_mm = 0.4 * f64::from(k);
                SpectrumRow {
                    frequency_per_mm,
                    wavelength_um: 1e3 / frequency_per_mm,
                    density_um3: (1.5 + f64::from(k).sin()) / frequency_per_mm,
                }
            })
            .collect();
        let bands = in_bands(&rows);
        assert!((35..50).contains(&bands.len()), "{}", bands.len());
        // Bands at low frequencies hold one line.
        assert!((bands[0].density_um3 - rows[0].density_um3).abs() < 1e-15);
        assert!((bands[0].frequency_per_mm - 0.4).abs() < 1e-12);
        let band = |row: &SpectrumRow| (12.0 * row.frequency_per_mm.log10()).floor();
        let area: f64 = rows.iter().map(|row| row.density_um3).sum();
        let of_bands: f64 = rows
            .chunk_by(|a, b| band(a) == band(b))
            .zip(&bands)
            .map(|(rows, mean)| rows.len() as f64 * mean.density_um3)
            .sum();
        assert!((of_bands / area - 1.0).abs() < 1e-12);
    }
}
