//! Tables of a flank: trace as measured, levelled and filtered, material ratio curve, spectrum.

use std::ops::Range;
use std::path::Path;

use asperity::result::FlankRecord;
use asperity_core::numerics::extreme_places;
use asperity_core::{Fault, Profile};
use asperity_roughness::RoughnessError;
use asperity_roughness::form::{self, Form};
use asperity_roughness::material_ratio::{abbott_curve, material_ratio_percent};
use asperity_roughness::preparation::{Preparation, Prepared, prepare};
use asperity_roughness::resampling::respaced;
use asperity_roughness::spectral::power_spectrum;
use serde::{Deserialize, Serialize};

use super::csv_table::{read, write};
use crate::thin::{BINS, thin_rising};
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
        let whole = |of: EvaluatedFlank<'_>| {
            let curve = of.material_ratio()?;
            let ratios = (0..curve.len()).map(|k| ratio_row(&curve, k));
            Ok(Self {
                spectrum: of.spectrum()?,
                material_ratio: ratios.collect(),
                trace: (0..of.points()).map(|i| of.trace_row(i)).collect(),
            })
        };
        EvaluatedFlank::new(record, profile)?.map(whole).transpose()
    }

    /// [`new`](Self::new) thinned for display, with the extremes of every drawn curve, and the spectrum averaged in bands. No whole
    /// table is in memory: a trace of a million points makes a hundred megabytes of them.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn shown(
        record: &FlankRecord,
        profile: Option<&Profile>,
    ) -> Result<Option<Self>, RoughnessError> {
        let thinned = |of: EvaluatedFlank<'_>| {
            let spectrum = in_bands(&of.spectrum()?);
            let curve = of.material_ratio()?;
            let ratios = thin_rising(
                curve.len(),
                BINS,
                |k| material_ratio_percent(k, curve.len()),
                |range| places_in(&curve, 0, range),
            );
            let points = thin_rising(
                of.points(),
                BINS,
                |i| of.x_um(i),
                |range| of.extreme_points(range),
            );
            let material_ratio = ratios.into_iter().map(|k| ratio_row(&curve, k)).collect();
            let trace = points.into_iter().map(|i| of.trace_row(i)).collect();
            Ok(Self {
                trace,
                material_ratio,
                spectrum,
            })
        };
        EvaluatedFlank::new(record, profile)?
            .map(thinned)
            .transpose()
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

/// Row `k` of the material ratio curve with these heights.
fn ratio_row(heights: &[f64], k: usize) -> MaterialRatioRow {
    MaterialRatioRow {
        material_ratio_percent: material_ratio_percent(k, heights.len()),
        height_um: heights[k] * MICRO,
    }
}

/// Points of a range at which one of `heights`, which begin at point `first`, is lowest, highest or first undefined.
fn places_in(heights: &[f64], first: usize, range: Range<usize>) -> Vec<usize> {
    let known = first..first + heights.len();
    let (from, to) = (range.start.max(known.start), range.end.min(known.end));
    if from >= to {
        return vec![range.start];
    }
    let found = extreme_places(&heights[from - first..to - first]);
    let undefined = match (range.start < from, range.end > to) {
        (true, _) => Some(range.start),
        (false, true) => Some(to),
        (false, false) => None,
    };
    found
        .into_iter()
        .map(|k| from + k)
        .chain(undefined)
        .collect()
}

/// A trace with its form removed and filtered.
struct EvaluatedFlank<'a> {
    measured: &'a Profile,
    is_mirrored: bool,
    form_removed: Profile,
    prepared: Prepared,
}

impl<'a> EvaluatedFlank<'a> {
    fn new(
        record: &FlankRecord,
        profile: Option<&'a Profile>,
    ) -> Result<Option<Self>, RoughnessError> {
        let (Some(measured), Some(preparation)) = (profile, &record.preparation) else {
            return Ok(None);
        };
        let recipe = preparation.recipe;
        let form_removed = if record.mirrored {
            form::remove(&measured.mirrored(), recipe.form)?
        } else {
            form::remove(measured, recipe.form)?
        };
        let rest = Preparation {
            form: Form::None,
            ..recipe
        };
        Ok(Some(Self {
            prepared: prepare(&form_removed, &rest)?,
            form_removed,
            measured,
            is_mirrored: record.mirrored,
        }))
    }

    fn points(&self) -> usize {
        self.measured.len()
    }

    /// Points of a range at which one of the three heights is lowest, highest or first undefined.
    fn extreme_points(&self, range: Range<usize>) -> Vec<usize> {
        let measured = if self.is_mirrored {
            let (from, to) = (self.points() - range.end, self.points() - range.start);
            let mirrored = self.measured.heights()[from..to].iter().rev();
            places_in(
                &mirrored.copied().collect::<Vec<_>>(),
                range.start,
                range.clone(),
            )
        } else {
            places_in(self.measured.heights(), 0, range.clone())
        };
        let form_removed = places_in(self.form_removed.heights(), 0, range.clone());
        let Prepared {
            profile,
            first_index,
            ..
        } = &self.prepared;
        let rough = places_in(profile.heights(), *first_index, range);
        [measured, form_removed, rough].concat()
    }

    fn x_um(&self, i: usize) -> f64 {
        i as f64 * self.measured.spacing().si() * MICRO
    }

    fn trace_row(&self, i: usize) -> TraceRow {
        let rough = self.prepared.profile.heights();
        let place = if self.is_mirrored {
            self.points() - 1 - i
        } else {
            i
        };
        TraceRow {
            x_um: self.x_um(i),
            measured_um: self.measured.heights()[place] * MICRO,
            form_removed_um: self.form_removed.heights()[i] * MICRO,
            roughness_um: i
                .checked_sub(self.prepared.first_index)
                .and_then(|k| rough.get(k))
                .map(|z| z * MICRO),
        }
    }

    /// Heights of the material ratio curve.
    fn material_ratio(&self) -> Result<Vec<f64>, RoughnessError> {
        Ok(abbott_curve(self.prepared.profile.heights())?)
    }

    /// The spectrum, of waves that the points of a run have: λs leaves nothing of the shorter ones, which a finer trace would have
    /// by the hundred thousand.
    fn spectrum(&self) -> Result<Vec<SpectrumRow>, RoughnessError> {
        /// Cubic micrometres per cubic metre.
        const CUBIC_MICRO: f64 = MICRO * MICRO * MICRO;
        let Prepared {
            profile, record, ..
        } = &self.prepared;
        let spectrum = match record.recipe.coarsest_spacing() {
            Some(coarsest) if coarsest > profile.spacing() => {
                power_spectrum(&respaced(profile, coarsest)?)?
            }
            _ => power_spectrum(profile)?,
        };
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
