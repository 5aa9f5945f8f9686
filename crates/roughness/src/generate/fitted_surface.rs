//! Surfaces like measured ones: their spectrum over both directions, and their heights.
//!
//! The spectral density is averaged over bands of its lines in both directions and over the surfaces; ridges that run at an
//! angle stay so. White noise on an area twice as long and wide as a surface gets this spectrum and, by ranks, the heights of
//! the surfaces; a part of the size of a surface is cut out of it, so that the parameters differ from seed to seed as
//! between surfaces.
//!
//! As for traces ([`Fitted`](super::Fitted)), the order of the phases is lost. The window broadens the lines of the spectrum, so
//! that ridges longer than a quarter of the surface become shorter.

use std::f64::consts::TAU;

use asperity_core::quantity::Length;
use asperity_core::{DomainError, cite};
use realfft::num_complex::Complex;

use super::fitted::{distribution, heights};
use super::random::Random;
use crate::areal::{HeightGrid, transform};
use crate::error::RoughnessError;
use crate::material_ratio::ascending;

/// Size of the area of which a part is cut out, in sizes of the surface.
const PARENT: usize = 2;
/// Most points of a surface that is fitted.
const MOST_POINTS: usize = 1 << 21;
/// Number of spectral lines with a band each, and ratio of the ends of the others, which are wider than a line.
const SINGLE_LINES: f64 = 20.5;
const BAND: f64 = 1.05;
/// Number of heights at each end of the distribution that are kept one by one, and between them.
const TAIL: usize = 4096;
const INNER: usize = 1 << 16;
/// Number of times that spectrum and heights are imposed in turn.
const ROUNDS: usize = 12;

/// Fit to surfaces of one kind.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedSurface {
    columns: usize,
    rows: usize,
    spacings: [Length; 2],
    /// Density of each band along the rows, of each one across and of both signs of its frequency.
    density: Vec<f64>,
    /// Shares of lower heights, and heights \[um\].
    heights: Vec<[f64; 2]>,
}

/// An area of cells, transformed or not.
pub(super) struct Area {
    pub cells: Vec<Complex<f64>>,
    /// Cells of a row, and rows.
    pub size: [usize; 2],
}

impl Area {
    /// The transform of white noise.
    pub(super) fn of_noise([width, height]: [usize; 2], seed: u64) -> Self {
        let mut random = Random::new(seed);
        let mut cells: Vec<Complex<f64>> = (0..width * height)
            .map(|_| Complex::new(normal(&mut random), 0.0))
            .collect();
        transform(&mut cells, width, height);
        Self {
            cells,
            size: [width, height],
        }
    }

    /// Imposes the amplitudes of its transform, which it is, and by ranks the ascending heights `targets`, in turn.
    pub(super) fn impose(&mut self, amplitudes: &[f64], targets: &[f64], rounds: usize) {
        let ([width, height], cells) = (self.size, &mut self.cells);
        for round in 0..rounds {
            if round > 0 {
                transform(cells, width, height);
            }
            for (cell, amplitude) in cells.iter_mut().zip(amplitudes) {
                let norm = cell.norm();
                let phase = if norm > 0.0 {
                    *cell / norm
                } else {
                    Complex::new(1.0, 0.0)
                };
                // Conjugate, since the same transform leads back.
                *cell = (phase * amplitude).conj();
            }
            transform(cells, width, height);
            let order = ascending(cells.iter().map(|cell| cell.re));
            for (index, target) in order.into_iter().zip(targets) {
                cells[index] = Complex::new(*target, 0.0);
            }
        }
    }
}

/// Number of bands over the lines of `n` points.
fn bands(n: usize) -> usize {
    band(0.5 * n as f64) + 1
}

/// Band of a spatial frequency in lines of the surface.
fn band(lines: f64) -> usize {
    if lines < SINGLE_LINES {
        return lines.round() as usize;
    }
    SINGLE_LINES as usize + 1 + ((lines / SINGLE_LINES).ln() / BAND.ln()) as usize
}

/// Frequency of a line of a transform over `n` points, in lines, negative in the upper half.
fn signed(line: usize, n: usize) -> f64 {
    if 2 * line > n {
        line as f64 - n as f64
    } else {
        line as f64
    }
}

impl FittedSurface {
    /// The fit to `surfaces`, heights \[m\] row by row, all of the same size and spacings.
    ///
    /// A plane is removed from each.
    ///
    /// # Errors
    /// When a surface has too few or too many points, heights are missing, or the sizes differ.
    ///
    /// ```
    /// use asperity_core::quantity::Length;
    /// use asperity_roughness::areal::parameters;
    /// use asperity_roughness::generate::FittedSurface;
    /// let (columns, spacings) = (200, [Length::from_si(1e-6); 2]);
    /// let z: Vec<f64> = (0..columns * 100)
    ///     .map(|k| 1e-7 * ((k % columns) as f64 * 0.9).sin() * ((k / columns) as f64 * 0.1).cos())
    ///     .collect();
    /// let made = FittedSurface::to(std::slice::from_ref(&z), columns, spacings)?.generate(3);
    /// let sq = |z: &[f64]| parameters(z, columns, spacings).map(|found| found.sq.si());
    /// assert!((sq(&made)? / sq(&z)? - 1.0).abs() < 0.3);
    /// # Ok::<(), asperity_roughness::RoughnessError>(())
    /// ```
    pub fn to(
        surfaces: &[Vec<f64>],
        columns: usize,
        spacings: [Length; 2],
    ) -> Result<Self, RoughnessError> {
        let mut densities = Vec::new();
        let mut all = Vec::new();
        for z in levelled(surfaces, columns, spacings)? {
            densities.resize(2 * bands(columns) * bands(z.len() / columns), [0.0; 2]);
            add_density(&z, columns, &mut densities);
            all.extend(z);
        }
        let mean = |[sum, count]: [f64; 2]| if count > 0.0 { sum / count } else { 0.0 };
        Ok(Self {
            columns,
            rows: surfaces.first().map_or(0, Vec::len) / columns.max(1),
            spacings,
            density: densities.into_iter().map(mean).collect(),
            heights: distribution(all, TAIL, INNER),
        })
    }

    /// Number of points of a row, and the spacings along and across the rows.
    #[must_use]
    pub fn grid(&self) -> (usize, [Length; 2]) {
        (self.columns, self.spacings)
    }

    /// Heights \[m\] of a surface of the size of those fitted, row by row.
    ///
    /// ```text
    /// Z ← A Z/|Z|,  A = |W| √S(f_x, f_y);  z ← H⁻¹(rank z)                                 [Fitted-area]
    /// ```
    ///
    /// W is the transform of white noise, S the fitted density, H the distribution of the heights; both steps in turn.
    #[must_use]
    pub fn generate(&self, seed: u64) -> Vec<f64> {
        cite!("Fitted-area");
        let [width, height] = [PARENT * self.columns, PARENT * self.rows];
        let mut area = Area::of_noise([width, height], seed);
        let amplitudes: Vec<f64> = area
            .cells
            .iter()
            .enumerate()
            .map(|(k, cell)| cell.norm() * self.density_at(k, width, height).sqrt())
            .collect();
        let targets = heights("heights", &self.heights, width * height).unwrap_or_default();
        area.impose(&amplitudes, &targets, ROUNDS);
        let cells = area.cells;
        let row = |y: usize| {
            cells[y * width..y * width + self.columns]
                .iter()
                .map(|cell| cell.re)
        };
        (0..self.rows).flat_map(row).collect()
    }

    /// Density at a cell of the transform of the whole area.
    fn density_at(&self, k: usize, width: usize, height: usize) -> f64 {
        let x = signed(k % width, width) / PARENT as f64;
        let y = signed(k / width, height) / PARENT as f64;
        // Longer waves went with the plane.
        if x.abs() < 1.0 && y.abs() < 1.0 {
            return 0.0;
        }
        self.density[place(x, y, self.columns)]
    }
}

/// The heights of `surfaces` over their least-squares planes.
pub(super) fn levelled(
    surfaces: &[Vec<f64>],
    columns: usize,
    spacings: [Length; 2],
) -> Result<Vec<Vec<f64>>, RoughnessError> {
    let rule = "must be at least one";
    DomainError::require(!surfaces.is_empty(), "number of surfaces", 0.0, "-", rule)?;
    let points = surfaces[0].len();
    let level = |z: &Vec<f64>| {
        let is_sound = z.len() == points && points <= MOST_POINTS;
        let rule = "must be at most 2097152, and the same of all surfaces";
        DomainError::require(is_sound, "number of points", z.len() as f64, "-", rule)?;
        let missing = z.iter().filter(|z| !z.is_finite()).count();
        let rule = "must be zero";
        DomainError::require(missing == 0, "missing heights", missing as f64, "-", rule)?;
        Ok(HeightGrid::level(z, columns, spacings)?.heights().to_vec())
    };
    surfaces.iter().map(level).collect()
}

/// Index of the band of frequencies in lines; a wave and its opposite are the same.
fn place(x: f64, y: f64, columns: usize) -> usize {
    let is_falling = (x < 0.0) != (y < 0.0) && x != 0.0 && y != 0.0;
    2 * (band(y.abs()) * bands(columns) + band(x.abs())) + usize::from(is_falling)
}

/// Adds the periodogram of the heights, weighted with a window of cosines in both directions.
fn add_density(z: &[f64], columns: usize, sums: &mut [[f64; 2]]) {
    let rows = z.len() / columns;
    let window = |k: usize, n: usize| 1.0 - (TAU * (k as f64 + 0.5) / n as f64).cos();
    let mut cells: Vec<Complex<f64>> = z
        .iter()
        .enumerate()
        .map(|(k, z)| {
            let weight = window(k % columns, columns) * window(k / columns, rows);
            Complex::new(weight * z, 0.0)
        })
        .collect();
    transform(&mut cells, columns, rows);
    for (k, cell) in cells.iter().enumerate().skip(1) {
        let [x, y] = [signed(k % columns, columns), signed(k / columns, rows)];
        let [sum, count] = &mut sums[place(x, y, columns)];
        *sum += cell.norm_sqr();
        *count += 1.0;
    }
}

/// A standard normal number, by Box and Muller.
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.uniform()).ln()).sqrt();
    radius * (TAU * random.uniform()).cos()
}
