//! Lay of a measured surface: how far its ridges run across the direction of its rows.
//!
//! The rows are traces in the direction of rolling. The lay γ that the film in the inlet of a line contact depends on follows
//! from the texture aspect ratio of the prepared rows and from the direction of their ridges; its interval follows from
//! parts of the rows, each left out in turn. It is the lay of the roughness that the film meets: the filters along the rows
//! remove waves that are long in this direction, so that it lies below the ratio of the unfiltered surface, by 7 % for ridges
//! four times as long as wide of 6 µm correlation length, by a quarter for waves of 20 µm.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s | least distance at which the autocorrelation is 0.2 over the largest one, Str | - |
//! | θ | angle between the ridges and the normal of the rows in the surface | rad |
//! | γ | lay: 0 ridges normal to the rows, 1 isotropic, above 1 ridges along the rows | - |
//! | n | number of parts of the rows | - |

use asperity_core::quantity::Length;
use asperity_core::{Profile, cite};
use serde::Serialize;

use crate::areal::{Decays, HeightGrid, LagSums};
use crate::error::RoughnessError;
use crate::preparation::{Preparation, RoughnessFilter, prepare_with};

/// Most and least number of parts of the rows.
const PARTS: [usize; 2] = [8, 4];
/// Least length of a part in correlation lengths across the ridges.
const PART_LENGTHS: f64 = 8.0;
/// Least correlation length in distances of points or rows.
const POINTS: f64 = 1.5;
/// Most points that are correlated; of a larger surface the middle of the rows is used.
const MOST_POINTS: usize = 1 << 20;
/// 97.5 % quantiles of Student's t for 3 to 7 degrees of freedom.
const T_975: [f64; 5] = [3.182_446, 2.776_445, 2.570_582, 2.446_912, 2.364_624];

/// Lay of a surface, for traces along its rows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RowLay {
    /// γ; the upper end of `range` if the ridges are longer than half of the surface.
    pub gamma: f64,
    /// 95 % interval; everything that is possible if the ridges are longer than half of the surface.
    pub range: [f64; 2],
    /// Whether the ridges are longer than half of the surface, so that γ is only bounded.
    pub is_bound: bool,
}

/// The lay, or why the surface does not show it.
pub type LayFinding = Result<RowLay, LayUnknown>;

/// Reason why a surface does not show its lay.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, thiserror::Error)]
#[non_exhaustive]
pub enum LayUnknown {
    /// The heights of neighbouring rows or points are not correlated.
    #[error(
        "the {lines} are {spacing:.2} apart, and heights are correlated over {length:.2} in that direction"
    )]
    TooFarApart {
        /// Rows or points.
        lines: &'static str,
        /// Distance between them.
        spacing: Length,
        /// Distance at which the autocorrelation is 0.2, or its bound.
        length: Length,
    },
    /// The rows are too short for several independent parts.
    #[error("the prepared rows are {length:.3} long, and {needed:.3} are needed")]
    TooShort {
        /// Length of the prepared rows.
        length: Length,
        /// Least length.
        needed: Length,
    },
    /// Too few rows have heights.
    #[error("{rows} rows with heights are too few")]
    TooFewRows {
        /// Number of rows with heights.
        rows: usize,
    },
    /// The surface is flat.
    #[error("the prepared rows are flat")]
    Flat,
}

/// Lay γ of heights \[m\], row by row with NaN where there is none, for traces along the rows, prepared by `recipe`.
///
/// ```text
/// γ = (1 + s)/(cos²θ + s sin²θ) − 1,  ln γ± = ln γ ± t √((n − 1)/n Σ (ln γᵢ − ⟨ln γᵢ⟩)²)         [Lay-1]
/// ```
///
/// 1/(1 + γ) is the mean of k_x²/k² over an elliptical spectrum with axes in the ratio s, turned by θ. γᵢ is γ without part i,
/// t the 97.5 % quantile of Student's t for n − 1 degrees of freedom. A missing point is bridged for the filters and
/// has no weight in the autocorrelation.
///
/// # Errors
/// When the recipe cannot be applied to the rows, or a spacing is not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::lay::lay_of_rows;
/// use asperity_roughness::preparation::{Preparation, RoughnessFilter};
/// // Straight ridges normal to the rows, so that the lay is bounded only.
/// let [columns, rows] = [1200, 200];
/// let z: Vec<f64> = (0..columns * rows).map(|k| 1e-7 * (0.2 * ((k % columns) as f64).powf(1.05)).sin()).collect();
/// let spacings = [Length::from_si(1e-6); 2];
/// let lay = lay_of_rows(&z, columns, spacings, &Preparation::default(), RoughnessFilter::Gaussian)?.unwrap();
/// assert!(lay.is_bound && lay.gamma < 0.05);
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn lay_of_rows(
    z: &[f64],
    columns: usize,
    spacings: [Length; 2],
    recipe: &Preparation,
    filter: RoughnessFilter,
) -> Result<LayFinding, RoughnessError> {
    cite!("Lay-1");
    const LEAST_ROWS: usize = 4;
    let most = (MOST_POINTS / (z.len() / columns.max(1)).max(1)).max(1);
    let mut prepared = Vec::with_capacity(z.len());
    let (mut width, mut measured) = (0, 0);
    for row in z.chunks_exact(columns.max(1)) {
        let Some(bridged) = bridged(row) else {
            prepared.push(None);
            continue;
        };
        let profile = Profile::new(spacings[0], bridged)?;
        let roughness = prepare_with(&profile, recipe, filter)?;
        let heights = roughness.profile.heights();
        let known = &row[roughness.first_index..roughness.first_index + heights.len()];
        let heights = heights.iter().zip(known);
        let heights: Vec<f64> = heights
            .map(|(z, known)| if known.is_finite() { *z } else { f64::NAN })
            .collect();
        let middle = heights.len().saturating_sub(most) / 2;
        width = heights.len().min(most);
        measured += 1;
        prepared.push(Some(heights[middle..middle + width].to_vec()));
    }
    if measured < LEAST_ROWS {
        return Ok(Err(LayUnknown::TooFewRows { rows: measured }));
    }
    // The filter leaves a constant of a curved form, which would be correlated at every distance.
    let known = prepared
        .iter()
        .flatten()
        .flatten()
        .filter(|z| z.is_finite());
    let mean = known.clone().sum::<f64>() / known.count().max(1) as f64;
    prepared
        .iter_mut()
        .flatten()
        .flatten()
        .for_each(|z| *z -= mean);
    let surface = LayRows {
        rows: prepared,
        width,
        spacings,
    };
    surface.lay()
}

/// The heights of a row with linear bridges over missing ones; `None` if fewer than half of them are known.
///
/// ```
/// use asperity_roughness::lay::bridged;
/// assert_eq!(bridged(&[f64::NAN, 1.0, f64::NAN, 3.0]), Some(vec![1.0, 1.0, 2.0, 3.0]));
/// assert_eq!(bridged(&[f64::NAN, f64::NAN, 1.0]), None);
/// ```
#[must_use]
pub fn bridged(row: &[f64]) -> Option<Vec<f64>> {
    let known: Vec<[f64; 2]> = row
        .iter()
        .enumerate()
        .filter(|(_, z)| z.is_finite())
        .map(|(x, z)| [x as f64, *z])
        .collect();
    if known.is_empty() || 2 * known.len() < row.len() {
        return None;
    }
    let at = |x| asperity_core::numerics::interpolate(&known, x as f64);
    Some((0..row.len()).map(at).collect())
}

/// Prepared rows of equal length.
struct LayRows {
    rows: Vec<Option<Vec<f64>>>,
    width: usize,
    spacings: [Length; 2],
}

impl LayRows {
    fn lay(&self) -> Result<LayFinding, RoughnessError> {
        let mut parts = PARTS[0];
        loop {
            let sums = self.sums(parts)?;
            let mut whole = sums[0].clone();
            sums[1..].iter().for_each(|part| whole.add(part, 1.0));
            let decays = whole.lags().half().decays(self.spacings);
            if !whole.has_heights() {
                return Ok(Err(LayUnknown::Flat));
            }
            if let Some(unresolved) = self.unresolved(&whole) {
                return Ok(Err(unresolved));
            }
            let length = self.spacings[0].si() * self.width as f64;
            // Correlated over more than half of a part, if no decay is within it.
            let decay = decays.shortest.min(length / parts as f64);
            let needed = PART_LENGTHS * decay;
            if length >= needed * parts as f64 {
                return Ok(Ok(found(&decays, &whole, &sums, self.spacings)));
            }
            if parts <= PARTS[1] {
                return Ok(Err(LayUnknown::TooShort {
                    length: Length::from_si(length),
                    needed: Length::from_si(needed * PARTS[1] as f64),
                }));
            }
            parts -= 1;
        }
    }

    /// Sums over the lags of equal parts of the rows.
    fn sums(&self, parts: usize) -> Result<Vec<LagSums>, RoughnessError> {
        let width = self.width / parts;
        // Without large prime factors, for the transforms.
        let width = width - width % (1 << (width / 16).max(1).ilog2());
        let part = |k: usize| {
            let heights = |row: &Option<Vec<f64>>| match row {
                Some(row) => row[k * width..(k + 1) * width].to_vec(),
                None => vec![f64::NAN; width],
            };
            let z: Vec<f64> = self.rows.iter().flat_map(heights).collect();
            Ok(HeightGrid::new(z, width, self.spacings)?.sums())
        };
        (0..parts).map(part).collect()
    }

    /// The reason why neighbours are not close enough, along or across the rows.
    fn unresolved(&self, sums: &LagSums) -> Option<LayUnknown> {
        let lags = sums.lags().half();
        let along = [("points", [1.0, 0.0]), ("rows", [0.0, 1.0])];
        let mut lines = along.into_iter().zip(self.spacings);
        lines.find_map(|((lines, direction), spacing)| {
            let (length, is_reached) = lags.decay(direction, self.spacings);
            let is_coarse = is_reached && length < POINTS * spacing.si();
            is_coarse.then(|| LayUnknown::TooFarApart {
                lines,
                spacing,
                length: Length::from_si(length),
            })
        })
    }
}

fn found(decays: &Decays, whole: &LagSums, sums: &[LagSums], spacings: [Length; 2]) -> RowLay {
    let ratio = decays.shortest / decays.longest;
    let gamma = of_texture(ratio, decays.along);
    if decays.is_open {
        return RowLay {
            gamma,
            range: [of_texture(0.0, decays.along), gamma],
            is_bound: true,
        };
    }
    let without = |part: &LagSums| {
        let mut rest = whole.clone();
        rest.add(part, -1.0);
        let decays = rest.lags().half().decays(spacings);
        of_texture(decays.shortest / decays.longest, decays.along).ln()
    };
    let logarithms: Vec<f64> = sums.iter().map(without).collect();
    let n = logarithms.len() as f64;
    let mean = logarithms.iter().sum::<f64>() / n;
    let squares: f64 = logarithms.iter().map(|ln| (ln - mean).powi(2)).sum();
    let factor = (T_975[sums.len() - PARTS[1]] * ((n - 1.0) / n * squares).sqrt()).exp();
    RowLay {
        gamma,
        range: [gamma / factor, gamma * factor],
        is_bound: false,
    }
}

/// γ of an aspect ratio and the direction of the ridges \[rad\] from the rows.
fn of_texture(ratio: f64, along: f64) -> f64 {
    let (across_rows, in_rows) = (along.sin().powi(2), along.cos().powi(2));
    (1.0 + ratio) / (across_rows + ratio * in_rows) - 1.0
}
