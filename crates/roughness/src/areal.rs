//! Height, slope and texture parameters of a measured surface.
//!
//! Source: ISO 25178-2:2021, quoted from surfalize 0.19.2; the standard was not available.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | heights over the least-squares plane | m |
//! | ρ(t) | autocorrelation, unbiased over the overlap, ρ(0) = 1 | - |
//! | Sal, Str | least distance with ρ = 0.2, and its ratio to the largest one | m, - |
//! | Std | direction in which the angular power spectrum is largest | ° |
//!
//! Points without a height are left out of all sums.

use asperity_core::DomainError;
use asperity_core::numerics::{complex_inverse, extremes};
use asperity_core::quantity::Length;
use realfft::num_complex::Complex;
use serde::{Deserialize, Serialize};

use crate::error::RoughnessError;

/// Parameters of a surface over its least-squares plane.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct ArealParameters {
    /// Arithmetic mean height.
    pub sa: Length,
    /// Root mean square height.
    pub sq: Length,
    /// Highest point.
    pub sp: Length,
    /// Depth of the lowest point.
    pub sv: Length,
    /// Sum of both.
    pub sz: Length,
    /// Skewness; `None` for a plane.
    pub ssk: Option<f64>,
    /// Kurtosis; `None` for a plane.
    pub sku: Option<f64>,
    /// Root mean square gradient.
    pub sdq: f64,
    /// Developed area over the projected one, less one.
    pub sdr: f64,
    /// Texture; `None` for a plane or a surface of too many points.
    pub texture: Option<Texture>,
}

/// Autocorrelation and direction of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Texture {
    /// Autocorrelation length Sal; `None` if it is not reached within the surface.
    pub sal: Option<Length>,
    /// Aspect ratio Str, 0 for a lay of straight ridges to 1; `None` if the surface is too small along the lay.
    pub str: Option<f64>,
    /// Largest value that Str can have: it equals Str if that is known.
    pub str_at_most: Option<f64>,
    /// Direction Std across the lay \[°\], from x towards rows of higher number, 0 to 180.
    pub std_degrees: f64,
}

/// Most points of a surface whose texture is computed: its transforms take four times as many complex numbers.
const MOST_POINTS: usize = 1 << 23;

/// A grid of heights with missing points.
pub(crate) struct HeightGrid {
    z: Vec<f64>,
    columns: usize,
    rows: usize,
    dx: f64,
    dy: f64,
}

/// The parameters of heights \[m\], row by row with NaN where there is none, over their least-squares plane.
///
/// # Errors
/// When there are fewer than two rows or columns or three heights, or a spacing is not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_roughness::areal::parameters;
/// let [columns, rows] = [200, 100];
/// // Waves of 20 um and 1 um amplitude along x, without change along y.
/// let wave = |k: usize| 1e-6 * ((k % columns) as f64 / 20.0 * std::f64::consts::TAU).sin();
/// let z: Vec<f64> = (0..columns * rows).map(wave).collect();
/// let found = parameters(&z, columns, [Length::from_si(1e-6); 2])?;
/// assert!((found.sq.si() / 0.7071e-6 - 1.0).abs() < 1e-2);
/// let texture = found.texture.unwrap();
/// assert_eq!((texture.str, texture.std_degrees), (None, 0.0));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn parameters(
    z: &[f64],
    columns: usize,
    spacings: [Length; 2],
) -> Result<ArealParameters, RoughnessError> {
    let grid = HeightGrid::level(z, columns, spacings)?;
    let heights: Vec<f64> = grid.z.iter().copied().filter(|z| z.is_finite()).collect();
    let n = heights.len() as f64;
    let moment = |power: i32| heights.iter().map(|z| z.powi(power)).sum::<f64>() / n;
    let sq = moment(2).sqrt();
    let shape = |power: i32| Some(moment(power) / sq.powi(power)).filter(|v| v.is_finite());
    let (low, high) = extremes(&heights);
    Ok(ArealParameters {
        sa: Length::from_si(heights.iter().map(|z| z.abs()).sum::<f64>() / n),
        sq: Length::from_si(sq),
        sp: Length::from_si(high),
        sv: Length::from_si(-low),
        sz: Length::from_si(high - low),
        ssk: shape(3),
        sku: shape(4),
        sdq: grid.gradient(),
        sdr: grid.developed(),
        texture: (sq > 0.0 && z.len() <= MOST_POINTS).then(|| grid.texture()),
    })
}

impl HeightGrid {
    /// The grid of heights `z`.
    pub(crate) fn new(
        mut z: Vec<f64>,
        columns: usize,
        [dx, dy]: [Length; 2],
    ) -> Result<Self, RoughnessError> {
        const LEAST: usize = 2;
        let rows = z.len().checked_div(columns).unwrap_or(0);
        RoughnessError::at_least(columns.min(rows), LEAST, "rows and columns of a surface")?;
        z.truncate(rows * columns);
        Ok(Self {
            z,
            columns,
            rows,
            dx: DomainError::positive("spacing along a row", dx)?,
            dy: DomainError::positive("spacing of the rows", dy)?,
        })
    }

    /// Heights over the least-squares plane.
    pub(crate) fn level(
        z: &[f64],
        columns: usize,
        spacings: [Length; 2],
    ) -> Result<Self, RoughnessError> {
        let mut grid = Self::new(z.to_vec(), columns, spacings)?;
        let (columns, rows) = (grid.columns, grid.rows);
        let plane = grid.plane()?;
        for (k, z) in grid.z.iter_mut().enumerate() {
            let [x, y] = place(k, columns, rows);
            *z -= plane[0] + plane[1] * x + plane[2] * y;
        }
        Ok(grid)
    }

    /// Heights row by row.
    pub(crate) fn heights(&self) -> &[f64] {
        &self.z
    }

    /// Least-squares plane c₀ + c₁ x + c₂ y over places from −1 to 1.
    fn plane(&self) -> Result<[f64; 3], RoughnessError> {
        const LEAST: usize = 3;
        let mut normal = [[0.0; 4]; 3];
        let mut points = 0;
        for (k, z) in self.z.iter().enumerate().filter(|(_, z)| z.is_finite()) {
            let [x, y] = place(k, self.columns, self.rows);
            let basis = [1.0, x, y];
            points += 1;
            for (row, a) in normal.iter_mut().zip(basis) {
                for (cell, b) in row.iter_mut().zip([1.0, x, y, *z]) {
                    *cell += a * b;
                }
            }
        }
        let few = RoughnessError::TooFewPoints {
            points,
            needed: LEAST,
            purpose: "a plane, not all on one line",
        };
        // Gauss-Jordan elimination; the places are within one of zero, so the largest pivot comes first.
        for k in 0..3 {
            if normal[k][k].abs() < 1e-9 * points as f64 || points < LEAST {
                return Err(few);
            }
            let pivot = normal[k].map(|value| value / normal[k][k]);
            normal[k] = pivot;
            for other in (0..3).filter(|other| *other != k) {
                let factor = normal[other][k];
                for (cell, value) in normal[other].iter_mut().zip(pivot) {
                    *cell -= factor * value;
                }
            }
        }
        Ok(normal.map(|row| row[3]))
    }

    /// Sdq = √(⟨(∂z/∂x)²⟩ + ⟨(∂z/∂y)²⟩) by differences of neighbours.
    fn gradient(&self) -> f64 {
        let mean_square = |differences: &mut dyn Iterator<Item = f64>| {
            let known = differences.filter(|d| d.is_finite());
            crate::spectral::mean_square(known)
        };
        let along = mean_square(
            &mut self
                .z
                .chunks(self.columns)
                .flat_map(|row| row.windows(2).map(|pair| (pair[1] - pair[0]) / self.dx)),
        );
        let mut below = self.z.iter().zip(self.z.iter().skip(self.columns));
        let across = mean_square(&mut below.by_ref().map(|(a, b)| (b - a) / self.dy));
        (along + across).sqrt()
    }

    /// Sdr: mean area of the two ways to divide each cell into triangles, over that of the cell, less one.
    fn developed(&self) -> f64 {
        let (mut sum, mut cells) = (0.0, 0_usize);
        for (upper, lower) in self
            .z
            .chunks(self.columns)
            .zip(self.z.chunks(self.columns).skip(1))
        {
            for (a, b) in upper.windows(2).zip(lower.windows(2)) {
                let along = [a, b].map(|pair| ((pair[1] - pair[0]) / self.dx).powi(2));
                let across = [0, 1].map(|k| ((b[k] - a[k]) / self.dy).powi(2));
                let corner = |k: usize, l: usize| (1.0 + along[k] + across[l]).sqrt() - 1.0;
                let area = 0.25 * (corner(0, 0) + corner(0, 1) + corner(1, 0) + corner(1, 1));
                if area.is_finite() {
                    sum += area;
                    cells += 1;
                }
            }
        }
        sum / cells.max(1) as f64
    }

    fn texture(&self) -> Texture {
        let decays = self
            .sums()
            .lags()
            .decays([self.dx, self.dy].map(Length::from_si));
        let is_known = decays.shortest.is_finite();
        let ratio = is_known.then(|| decays.shortest / decays.longest);
        Texture {
            sal: is_known.then(|| Length::from_si(decays.shortest)),
            str: ratio.filter(|_| !decays.is_open),
            str_at_most: ratio,
            std_degrees: self.direction(),
        }
    }

    /// Sums of products of heights over all lags.
    pub(crate) fn sums(&self) -> LagSums {
        let [width, height] = [2 * self.columns, 2 * self.rows];
        let squares = |value: &dyn Fn(f64) -> f64| {
            let mut padded = vec![Complex::new(0.0, 0.0); width * height];
            for (row, line) in self.z.chunks(self.columns).zip(padded.chunks_mut(width)) {
                for (z, cell) in row.iter().zip(line) {
                    cell.re = value(*z);
                }
            }
            transform(&mut padded, width, height);
            for cell in &mut padded {
                *cell = Complex::new(cell.norm_sqr(), 0.0);
            }
            transform(&mut padded, width, height);
            padded.into_iter().map(|cell| cell.re).collect()
        };
        let is_whole = self.z.iter().all(|z| z.is_finite());
        LagSums {
            products: squares(&|z| if z.is_finite() { z } else { 0.0 }),
            overlaps: if is_whole {
                whole_overlaps([self.columns, self.rows])
            } else {
                squares(&|z| f64::from(u8::from(z.is_finite())))
            },
            width,
            height,
        }
    }

    /// Std \[°\]: the direction in which the angular power spectrum is largest.
    ///
    /// The spectrum is summed in sectors about each half degree; from the largest sum on, the direction is the mean of the
    /// spatial frequencies about it, weighted by their power, until it stays. A sector is at least a few lines of the spectrum
    /// wide, over which the window spreads a wave.
    fn direction(&self) -> f64 {
        const STEPS_PER_DEGREE: f64 = 2.0;
        const BINS: usize = 360;
        /// Standard deviation of the weights of a sector \[rad\]: 5°.
        const SECTOR: f64 = std::f64::consts::PI / 36.0;
        /// Least standard deviation in distances of the lines; the window spreads a wave over two to either side.
        const LINES: f64 = 2.5;
        const MOST_ITERATIONS: usize = 100;
        /// Angle \[rad\] to which the direction is determined.
        const ACCURACY: f64 = 1e-6;
        let power = self.power();
        let mut bins = [0.0_f64; BINS];
        for &[fx, fy, power] in &power {
            let degrees = fy.atan2(fx).to_degrees().rem_euclid(180.0);
            bins[((degrees * STEPS_PER_DEGREE) as usize).min(BINS - 1)] += power;
        }
        let weight = |bins: usize| {
            let angle = (bins.min(BINS - bins) as f64 / STEPS_PER_DEGREE).to_radians();
            (-0.5 * (angle / SECTOR).powi(2)).exp()
        };
        let sector = |k: usize| {
            let parts = bins.iter().enumerate();
            parts
                .map(|(at, sum)| weight(at.abs_diff(k)) * sum)
                .sum::<f64>()
        };
        let sums: Vec<f64> = (0..BINS).map(sector).collect();
        let largest = sums.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1));
        let middle = |bin: usize| ((bin as f64 + 0.5) / STEPS_PER_DEGREE).to_radians();
        let mut angle = largest.map_or(0.0, |(bin, _)| middle(bin));
        for _ in 0..MOST_ITERATIONS {
            let (sin, cos) = angle.sin_cos();
            let along = sin / (self.columns as f64 * self.dx);
            let least = LINES * along.hypot(cos / (self.rows as f64 * self.dy));
            let (mut ahead, mut aside) = (0.0, 0.0);
            for &[fx, fy, power] in &power {
                let (u, v) = (fx * cos + fy * sin, fy * cos - fx * sin);
                let variance = SECTOR.powi(2) * (u * u + v * v) + least * least;
                let weighted = power * (-0.5 * v * v / variance).exp();
                ahead += weighted * u.abs();
                aside += weighted * v * u.signum();
            }
            let step = aside.atan2(ahead);
            angle += step;
            if step.abs() < ACCURACY {
                break;
            }
        }
        let degrees = angle.to_degrees().rem_euclid(180.0);
        // To the digits of the iteration, so that 0 is not 179.99999.
        (degrees * 1e3).round().rem_euclid(180e3) / 1e3
    }

    /// Spatial frequencies \[1/m\] of half of the spectrum with their power, after a Hann window. A wave is spread over two lines to
    /// either side, and its mean stays.
    fn power(&self) -> Vec<[f64; 3]> {
        let hann = |k: usize, n: usize| {
            (std::f64::consts::PI * (k as f64 + 0.5) / n as f64)
                .sin()
                .powi(2)
        };
        let window =
            |k: usize| hann(k % self.columns, self.columns) * hann(k / self.columns, self.rows);
        let known = || self.z.iter().enumerate().filter(|(_, z)| z.is_finite());
        let (sum, weights) = known().fold((0.0, 0.0), |(sum, weights), (k, z)| {
            (sum + window(k) * z, weights + window(k))
        });
        let mean = sum / weights;
        let mut lines = vec![Complex::new(0.0, 0.0); self.z.len()];
        for (k, z) in known() {
            lines[k].re = window(k) * (z - mean);
        }
        transform(&mut lines, self.columns, self.rows);
        let frequency = |k: usize, n: usize, d: f64| {
            if 2 * k > n {
                (k as f64 - n as f64) / (n as f64 * d)
            } else {
                k as f64 / (n as f64 * d)
            }
        };
        let all = lines.iter().enumerate().map(|(k, line)| {
            let fx = frequency(k % self.columns, self.columns, self.dx);
            let fy = frequency(k / self.columns, self.rows, self.dy);
            [fx, fy, line.norm_sqr()]
        });
        all.filter(|[fx, fy, _]| *fy > 0.0 || (*fy == 0.0 && *fx > 0.0))
            .collect()
    }
}

/// Place of a point, from −1 to 1 in both directions.
fn place(k: usize, columns: usize, rows: usize) -> [f64; 2] {
    let at = |k: usize, n: usize| 2.0 * k as f64 / (n - 1) as f64 - 1.0;
    [at(k % columns, columns), at(k / columns, rows)]
}

/// Sums of products of heights, and of the number of products, by lags with negative ones behind the positive ones.
#[derive(Clone)]
pub(crate) struct LagSums {
    products: Vec<f64>,
    overlaps: Vec<f64>,
    width: usize,
    height: usize,
}

impl LagSums {
    /// Adds `factor` times the sums of another surface of equal size.
    pub(crate) fn add(&mut self, other: &Self, factor: f64) {
        for (own, others) in [
            (&mut self.products, &other.products),
            (&mut self.overlaps, &other.overlaps),
        ] {
            for (sum, value) in own.iter_mut().zip(others) {
                *sum += factor * value;
            }
        }
    }

    /// Whether any height differs from zero.
    pub(crate) fn has_heights(&self) -> bool {
        self.products[0] > 0.0
    }

    /// Unbiased autocorrelation.
    pub(crate) fn lags(&self) -> Lags {
        let scale = 1.0 / (self.width * self.height) as f64;
        let origin = self.products[0] / self.overlaps[0];
        let rho = self.products.iter().zip(&self.overlaps).map(|(p, o)| {
            // Fewer than half a point is rounding.
            if o * scale >= 0.5 {
                p / o / origin
            } else {
                0.0
            }
        });
        Lags {
            rho: rho.collect(),
            width: self.width,
            height: self.height,
            reach: [self.width / 2 - 1, self.height / 2 - 1],
        }
    }
}

/// Distances at which the autocorrelation has fallen to 0.2.
pub(crate) struct Decays {
    /// Least one \[m\]; infinite if none is within the surface.
    pub shortest: f64,
    /// Largest one \[m\], or the largest distance within the surface.
    pub longest: f64,
    /// Whether the autocorrelation stays above 0.2 up to the end of the surface in some direction.
    pub is_open: bool,
    /// Direction of the ridges \[rad\] from the rows: the longest one, or the middle of those that are open.
    pub along: f64,
}

/// Autocorrelation by lags, with negative ones behind the positive ones.
pub(crate) struct Lags {
    rho: Vec<f64>,
    width: usize,
    height: usize,
    /// Largest lag in points along a row and across.
    reach: [usize; 2],
}

impl Lags {
    /// The lags up to half of the surface, whose mean is over half of its points at least in each direction.
    pub(crate) fn half(self) -> Self {
        Self {
            reach: self.reach.map(|reach| reach / 2),
            ..self
        }
    }

    /// Distances over all directions.
    pub(crate) fn decays(&self, spacings: [Length; 2]) -> Decays {
        let mut decays = Decays {
            shortest: f64::INFINITY,
            longest: 0.0,
            is_open: false,
            along: 0.0,
        };
        // Sum of the open directions, as vectors of twice their angle.
        let mut open = [0.0; 2];
        const DIRECTIONS: usize = 720;
        for k in 0..DIRECTIONS {
            let angle = std::f64::consts::PI * k as f64 / DIRECTIONS as f64;
            let (length, is_reached) = self.decay([angle.cos(), angle.sin()], spacings);
            if is_reached {
                decays.shortest = decays.shortest.min(length);
            } else {
                decays.is_open = true;
                open[0] += (2.0 * angle).cos();
                open[1] += (2.0 * angle).sin();
            }
            if length > decays.longest {
                (decays.longest, decays.along) = (length, angle);
            }
        }
        if decays.is_open {
            decays.along = 0.5 * open[1].atan2(open[0]);
        }
        decays
    }

    /// Distance at which the autocorrelation has fallen to 0.2 in a direction, or the end of the surface and `false`.
    pub(crate) fn decay(&self, [cos, sin]: [f64; 2], spacings: [Length; 2]) -> (f64, bool) {
        const LEVEL: f64 = 0.2;
        let [dx, dy] = spacings.map(Length::si);
        // Steps of a quarter of a point along the closer axis.
        let step = 0.25 * dx.min(dy);
        let mut before = 1.0;
        let mut distance = 0.0;
        loop {
            let next = distance + step;
            let at = self.at([next * cos / dx, next * sin / dy]);
            match at {
                None => return (distance, false),
                Some(value) if value <= LEVEL => {
                    return (distance + step * (before - LEVEL) / (before - value), true);
                }
                Some(value) => before = value,
            }
            distance = next;
        }
    }

    /// Bilinear value at a lag in points; `None` beyond the surface.
    fn at(&self, [x, y]: [f64; 2]) -> Option<f64> {
        if x.abs() > self.reach[0] as f64 || y.abs() > self.reach[1] as f64 {
            return None;
        }
        let (left, upper) = (x.floor(), y.floor());
        let (u, v) = (x - left, y - upper);
        let at = |x: f64, y: f64| {
            let wrapped = |lag: f64, n: usize| lag.rem_euclid(n as f64) as usize;
            self.rho[wrapped(y, self.height) * self.width + wrapped(x, self.width)]
        };
        Some(
            (1.0 - v) * ((1.0 - u) * at(left, upper) + u * at(left + 1.0, upper))
                + v * ((1.0 - u) * at(left, upper + 1.0) + u * at(left + 1.0, upper + 1.0)),
        )
    }
}

/// Points over which a grid without missing points overlaps itself at each lag, times the number of lags: sums of two
/// transforms without a factor.
fn whole_overlaps([columns, rows]: [usize; 2]) -> Vec<f64> {
    let [along, across] = [columns, rows].map(|n| (0..2 * n).map(move |lag| n.abs_diff(lag)));
    let lags = (4 * columns * rows) as f64;
    let row = |above: usize| along.clone().map(move |left| (left * above) as f64 * lags);
    across.flat_map(row).collect()
}

/// Transforms rows and columns in place, without a factor.
pub(crate) fn transform(cells: &mut [Complex<f64>], width: usize, height: usize) {
    let along = complex_inverse(width);
    let zero = Complex::new(0.0, 0.0);
    for row in cells.chunks_mut(width) {
        // A row of padding stays as it is.
        if row.iter().any(|cell| *cell != zero) {
            along.process(row);
        }
    }
    let across = complex_inverse(height);
    let mut column = vec![Complex::new(0.0, 0.0); height];
    for x in 0..width {
        for (y, cell) in column.iter_mut().enumerate() {
            *cell = cells[y * width + x];
        }
        across.process(&mut column);
        for (y, cell) in column.iter().enumerate() {
            cells[y * width + x] = *cell;
        }
    }
}
