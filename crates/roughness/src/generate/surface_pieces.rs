//! Surfaces made of pieces of measured ones, which keep ridges, dimples and marks as they were measured.
//!
//! Source: Efros and Freeman 2001 (image quilting), with seams blended over 5 µm.
//!
//! A plane and the waves longer than [`LONG_WAVES`] are removed from every surface. Equal pieces of what is left are laid row by row, each
//! overlapping its neighbours on the left and above. Of 256 drawn places that piece is taken which fits them best. The seam runs
//! through the overlap where both differ least. The long waves are a surface with the spectrum and heights that were removed.
//! The surfaces given therefore decide all shorter waves and rare valleys.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z_o, z_n | heights of the surface made so far and of the next piece, in their overlap | m |
//! | s(y) | column of the seam in line y; across for the overlap above | - |
//!
//! A surface of n points costs 256 n sums over a tenth of the points of an overlap at most, whatever the number of surfaces given.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile, cite};
use serde::Serialize;

use super::fitted_surface::{FittedSurface, levelled};
use super::pieces::LONG_WAVES;
use super::random::Random;
use crate::error::RoughnessError;
use crate::gaussian_filter::{Ends, mean_line};

/// Side of a piece along a direction in which the surface is at least two shortest pieces long \[m\]; elsewhere a piece is as long as the surface.
const SIDE: f64 = 225e-6;
const SHORTEST: f64 = 150e-6;
/// Length over which two pieces are fitted \[m\].
const OVERLAP: f64 = 20e-6;
/// Length over which two pieces are blended within the overlap \[m\].
const SEAM: f64 = 5e-6;
/// Points compared along an overlap's width.
const COMPARED: usize = 8;
/// Places of which the best is taken.
const CANDIDATES: usize = 256;

/// Measured surfaces to take pieces of.
#[derive(Debug, Clone)]
pub struct SurfacePieces {
    /// Points along a row, and rows.
    size: [usize; 2],
    /// Heights without long waves \[m\] of each surface, row by row.
    surfaces: Vec<Vec<f64>>,
    /// The long waves; none where the surfaces are shorter than these.
    long: Option<FittedSurface>,
    /// Points of a piece in both directions.
    side: [usize; 2],
    /// Points of an overlap, and of its blend, in both directions.
    overlap: [usize; 2],
    seam: [usize; 2],
}

/// A piece of a generated surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct SurfacePiece {
    /// Index of the measured surface.
    pub surface: usize,
    /// Its first point along a row, and its first row.
    pub first: [usize; 2],
    /// Its points along a row, and its rows; fewer at the ends of the surface.
    pub size: [usize; 2],
}

/// A surface with the pieces that it was made of.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct PiecedSurface {
    /// Heights \[m\], row by row.
    pub heights: Vec<f64>,
    /// Its pieces, row by row.
    pub pieces: Vec<SurfacePiece>,
}

/// Heights laid so far.
struct Laid {
    z: Vec<f64>,
    columns: usize,
}

impl SurfacePieces {
    /// Prepares `surfaces`, heights \[m\] row by row, all of the same size and spacings.
    ///
    /// # Errors
    /// When a surface has too few or too many points, heights are missing, the sizes differ, or a spacing exceeds half an overlap.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::generate::SurfacePieces;
    /// // Dimples every 60 um on a plane.
    /// let columns = 400;
    /// let dimple = |k: usize| {
    ///     let r = ((k % columns % 60) as f64 - 30.0).hypot((k / columns % 60) as f64 - 30.0);
    ///     -1e-6 * (1.0 - r / 20.0).max(0.0)
    /// };
    /// let z: Vec<f64> = (0..columns * 300).map(dimple).collect();
    /// let pieces = SurfacePieces::to(&[z.clone()], columns, [Length::from_si(1e-6); 2])?;
    /// let made = pieces.generate(3);
    /// let depth = |z: &[f64]| z.iter().copied().fold(f64::MIN, f64::max) - z.iter().copied().fold(f64::MAX, f64::min);
    /// assert!((depth(&made.heights) / depth(&z) - 1.0).abs() < 0.05);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn to(
        surfaces: &[Vec<f64>],
        columns: usize,
        spacings: [Length; 2],
    ) -> Result<Self, RoughnessError> {
        for spacing in spacings {
            let rule = "must not exceed half of the overlap of 20 um";
            let is_fine = spacing.si() <= 0.5 * OVERLAP;
            DomainError::require(is_fine, "spacing", spacing.si(), "m", rule)?;
        }
        let mut short = levelled(surfaces, columns, spacings)?;
        let size = [columns, short.first().map_or(0, Vec::len) / columns.max(1)];
        let mut long = Vec::new();
        for z in &mut short {
            if let Some(waves) = long_waves(z, size, spacings)? {
                z.iter_mut().zip(&waves).for_each(|(z, wave)| *z -= wave);
                long.push(waves);
            }
        }
        let count = |d: usize, length: f64| ((length / spacings[d].si()).round() as usize).max(1);
        let is_divided = |d: usize| size[d] >= 2 * count(d, SHORTEST);
        let side = [0, 1].map(|d| {
            if is_divided(d) {
                count(d, SIDE).min(size[d])
            } else {
                size[d]
            }
        });
        let overlap = [0, 1].map(|d| count(d, OVERLAP).min(side[d] / 2));
        Ok(Self {
            size,
            long: (!long.is_empty())
                .then(|| FittedSurface::to(&long, columns, spacings))
                .transpose()?,
            surfaces: short,
            side,
            overlap,
            seam: [0, 1].map(|d| count(d, SEAM).min(overlap[d])),
        })
    }

    /// Whether waves longer than [`LONG_WAVES`] are generated.
    #[must_use]
    pub fn has_long_waves(&self) -> bool {
        self.long.is_some()
    }

    /// A surface of the size of those given.
    #[must_use]
    pub fn generate(&self, seed: u64) -> PiecedSurface {
        let mut random = Random::new(seed);
        let [columns, rows] = self.size;
        let mut laid = Laid {
            z: vec![f64::NAN; columns * rows],
            columns,
        };
        let steps = [0, 1].map(|d| {
            if self.side[d] < self.size[d] {
                self.side[d] - self.overlap[d]
            } else {
                self.size[d]
            }
        });
        let mut pieces: Vec<SurfacePiece> = Vec::new();
        for y in (0..rows).step_by(steps[1]) {
            for x in (0..columns).step_by(steps[0]) {
                let place = [x, y];
                // A rest within the overlap is laid already.
                if (0..2).any(|d| place[d] > 0 && place[d] + self.overlap[d] >= self.size[d]) {
                    continue;
                }
                let piece = self.best(&laid, place, &pieces, &mut random);
                self.lay(&mut laid, place, piece);
                pieces.push(SurfacePiece {
                    size: self.extent(place),
                    ..piece
                });
            }
        }
        let mut heights = laid.z;
        if let Some(long) = &self.long {
            let waves = long.generate(random.seed());
            heights
                .iter_mut()
                .zip(waves)
                .for_each(|(z, wave)| *z += wave);
        }
        PiecedSurface { heights, pieces }
    }

    /// Height of a piece at its point `[x, y]`.
    fn height(&self, piece: SurfacePiece, [x, y]: [usize; 2]) -> f64 {
        self.surfaces[piece.surface][(piece.first[1] + y) * self.size[0] + piece.first[0] + x]
    }

    /// Points of a piece at `place` that lie on the surface.
    fn extent(&self, place: [usize; 2]) -> [usize; 2] {
        [0, 1].map(|d| self.side[d].min(self.size[d] - place[d]))
    }

    /// The piece that fits its neighbours best, of those that repeat the least of earlier pieces.
    fn best(
        &self,
        laid: &Laid,
        place: [usize; 2],
        pieces: &[SurfacePiece],
        random: &mut Random,
    ) -> SurfacePiece {
        let drawn = |random: &mut Random| SurfacePiece {
            surface: random.below(self.surfaces.len()),
            first: [0, 1].map(|d| random.below(self.size[d] - self.side[d] + 1)),
            size: self.side,
        };
        let mut best = drawn(random);
        let mut least = (usize::MAX, f64::MAX);
        for _ in 0..CANDIDATES {
            let piece = drawn(random);
            let repeated = self.repeated(piece, pieces);
            if repeated > least.0 {
                continue;
            }
            let miss = self.miss(laid, place, piece);
            if (repeated, miss) < least {
                (least, best) = ((repeated, miss), piece);
            }
        }
        best
    }

    /// Quarters of a piece that the earlier piece with the most of it has; a piece that overlaps by less than a quarter counts as new.
    fn repeated(&self, piece: SurfacePiece, pieces: &[SurfacePiece]) -> usize {
        let common = |earlier: &SurfacePiece| {
            let along =
                |d: usize| self.side[d].saturating_sub(earlier.first[d].abs_diff(piece.first[d]));
            4 * along(0) * along(1) / (self.side[0] * self.side[1])
        };
        let earlier = pieces
            .iter()
            .filter(|earlier| earlier.surface == piece.surface);
        earlier.map(common).max().unwrap_or(0)
    }

    /// Mean square of the differences from what is laid, over points spread evenly in the overlaps \[m²\].
    fn miss(&self, laid: &Laid, place: [usize; 2], piece: SurfacePiece) -> f64 {
        let extent = self.extent(place);
        let strides = self.overlap.map(|points| points.div_ceil(COMPARED));
        let (mut sum, mut count) = (0.0, 0);
        for y in (0..extent[1]).step_by(strides[1]) {
            let is_above = place[1] > 0 && y < self.overlap[1];
            let width = match (is_above, place[0] > 0) {
                (true, _) => extent[0],
                (false, true) => self.overlap[0].min(extent[0]),
                (false, false) => 0,
            };
            for x in (0..width).step_by(strides[0]) {
                sum += (laid.at(place, [x, y]) - self.height(piece, [x, y])).powi(2);
                count += 1;
            }
        }
        sum / f64::from(count.max(1))
    }

    /// Lays a piece; it begins at the seams with its neighbours.
    fn lay(&self, laid: &mut Laid, place: [usize; 2], piece: SurfacePiece) {
        let extent = self.extent(place);
        // The blend lies within the overlap.
        let half = self.seam.map(|points| points.div_ceil(2));
        let seams = [0, 1].map(|d| {
            let square = |along: usize, across: usize| {
                let across = across + half[d];
                let at = [[across, along], [along, across]][d];
                (laid.at(place, at) - self.height(piece, at)).powi(2)
            };
            let across = self.overlap[d].saturating_sub(2 * half[d]).max(1);
            (place[d] > 0).then(|| least_seam(extent[1 - d], across, square))
        });
        for y in 0..extent[1] {
            for x in 0..extent[0] {
                let share = |d: usize| {
                    let [along, across] = [[y, x], [x, y]][d];
                    match &seams[d] {
                        Some(seam) if across < self.overlap[d] => {
                            let from = across as f64 - (seam[along] + half[d]) as f64;
                            (0.5 + from / self.seam[d] as f64).clamp(0.0, 1.0)
                        }
                        _ => 1.0,
                    }
                };
                let share = share(0) * share(1);
                let next = self.height(piece, [x, y]);
                let z = &mut laid.z[(place[1] + y) * laid.columns + place[0] + x];
                *z = if share < 1.0 {
                    *z + share * (next - *z)
                } else {
                    next
                };
            }
        }
    }
}

impl Laid {
    /// Height at a point of a piece at `place`.
    fn at(&self, place: [usize; 2], [x, y]: [usize; 2]) -> f64 {
        self.z[(place[1] + y) * self.columns + place[0] + x]
    }
}

/// Place across of the seam for each point along an overlap, one step apart at most.
///
/// ```text
/// Σ_y (z_o − z_n)²(s(y), y) → min,  |s(y+1) − s(y)| ≤ 1                                      [Pieces-3]
/// ```
fn least_seam(along: usize, across: usize, square: impl Fn(usize, usize) -> f64) -> Vec<usize> {
    cite!("Pieces-3");
    // Least sum up to each point, and where the way to it came from.
    let mut sums: Vec<f64> = (0..across).map(|x| square(0, x)).collect();
    let mut from: Vec<Vec<usize>> = Vec::with_capacity(along);
    for y in 1..along {
        let before = |x: usize| {
            let near = x.saturating_sub(1)..(x + 2).min(across);
            near.min_by(|&a, &b| sums[a].total_cmp(&sums[b]))
                .unwrap_or(x)
        };
        let came: Vec<usize> = (0..across).map(before).collect();
        sums = (0..across).map(|x| sums[came[x]] + square(y, x)).collect();
        from.push(came);
    }
    let last = (0..across).min_by(|&a, &b| sums[a].total_cmp(&sums[b]));
    let mut seam = vec![last.unwrap_or(0)];
    for came in from.iter().rev() {
        seam.push(came[seam[seam.len() - 1]]);
    }
    seam.reverse();
    seam
}

/// Waves of a levelled surface longer than [`LONG_WAVES`]; none of a shorter surface. In a direction in which the surface is shorter, the
/// mean stands for them.
fn long_waves(
    z: &[f64],
    size: [usize; 2],
    spacings: [Length; 2],
) -> Result<Option<Vec<f64>>, RoughnessError> {
    let is_long = [0, 1].map(|d| spacings[d] * size[d] as f64 > LONG_WAVES);
    if is_long == [false; 2] {
        return Ok(None);
    }
    let smooth = |z: Vec<f64>, d: usize| -> Result<Vec<f64>, RoughnessError> {
        if !is_long[d] {
            let mean = z.iter().sum::<f64>() / z.len() as f64;
            return Ok(vec![mean; z.len()]);
        }
        mean_line(&Profile::new(spacings[d], z)?, LONG_WAVES, Ends::Reg1)
    };
    let [columns, rows] = size;
    let mut waves = Vec::with_capacity(z.len());
    for row in z.chunks(columns) {
        waves.extend(smooth(row.to_vec(), 0)?);
    }
    for x in 0..columns {
        let column = (0..rows).map(|y| waves[y * columns + x]).collect();
        for (y, height) in smooth(column, 1)?.into_iter().enumerate() {
            waves[y * columns + x] = height;
        }
    }
    Ok(Some(waves))
}
