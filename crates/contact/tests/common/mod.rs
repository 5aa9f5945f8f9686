//! Problems that several tests share.
#![allow(dead_code, reason = "not every test uses every problem")]

pub mod peers;

use asperity_contact::{Boundary, ContactProblem, Control, SolverSettings};
use asperity_core::quantity::{Length, LineLoad, Pressure};

/// A cylinder on a flat in a window.
pub struct Cylinder {
    pub radius: Length,
    pub modulus: Pressure,
    pub load: LineLoad,
    pub window: Length,
}

/// Steel cylinders of 6 mm radius under 300 N/mm: b = 99.656 µm, p₀ = 1.9165 GPa.
pub const CYLINDER: Cylinder = Cylinder {
    radius: Length::from_si(3e-3),
    modulus: Pressure::from_si(210e9 / 1.82),
    load: LineLoad::from_si(3e5),
    window: Length::from_si(600e-6),
};

impl Cylinder {
    /// Positions of the cells and their distance [m], centred.
    pub fn positions(&self, points: usize) -> Vec<f64> {
        let dx = self.window.si() / points as f64;
        (0..points)
            .map(|i| (i as f64 + 0.5) * dx - 0.5 * self.window.si())
            .collect()
    }

    /// The gap x²/2R and the spacing.
    pub fn gap(&self, points: usize) -> (Vec<f64>, Length) {
        let radius = self.radius.si();
        let gap = self
            .positions(points)
            .iter()
            .map(|x| x * x / (2.0 * radius))
            .collect();
        (gap, self.window / points as f64)
    }
}

/// [`CYLINDER`] with another gap.
pub fn hertz_problem(gap: &[f64], spacing: Length) -> ContactProblem<'_> {
    ContactProblem {
        gap,
        spacing,
        modulus: CYLINDER.modulus,
        boundary: Boundary::FreeEnds,
        control: Control::Load(CYLINDER.load),
        lead: None,
        prescribed_pressure: None,
        pressure_limit: None,
        start: None,
    }
}

/// The `count`-th output of the splitmix64 generator (Steele, Lea and Flood 2014) seeded with
/// `seed`·(FNV prime), as a number in 0..1.
pub fn random(seed: u64, count: u64) -> f64 {
    let mut z = seed
        .wrapping_mul(0x100_0000_01B3)
        .wrapping_add(count)
        .wrapping_add(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    ((z ^ (z >> 31)) >> 11) as f64 * 2f64.powi(-53)
}

/// Σ k^−1.3·cos(2πkx + φₖ) over `waves` at `x` in periods: a self-affine profile of Hurst exponent 0.8.
pub fn self_affine(x: &[f64], waves: std::ops::RangeInclusive<u64>, seed: u64) -> Vec<f64> {
    let mut height = vec![0.0; x.len()];
    for k in waves {
        let phase = std::f64::consts::TAU * random(seed, k);
        let amplitude = (k as f64).powf(-1.3);
        for (z, x) in height.iter_mut().zip(x) {
            *z += amplitude * (std::f64::consts::TAU * k as f64 * x + phase).cos();
        }
    }
    height
}

/// The gap of two rough cylinders, composite Rq 0.4 µm with waves of 2 to 100 µm, and the spacing.
pub fn rough_gap(points: usize) -> (Vec<f64>, Length) {
    let (mut gap, spacing) = CYLINDER.gap(points);
    let x: Vec<f64> = CYLINDER
        .positions(points)
        .iter()
        .map(|x| x / CYLINDER.window.si() + 0.5)
        .collect();
    let power: f64 = (6..=300).map(|k| 0.5 * f64::from(k).powf(-2.6)).sum();
    let amplitude = 0.4e-6 / (2.0 * power).sqrt();
    for seed in [11, 22] {
        for (h, z) in gap.iter_mut().zip(self_affine(&x, 6..=300, seed)) {
            *h -= amplitude * z;
        }
    }
    (gap, spacing)
}

/// The gap of a patch of the cylinder with 100 waves of 4 to 100 µm in all directions, composite Rq 0.4 µm, periodic over
/// square cells along the lead; and the spacing.
pub fn rough_patch([columns, rows]: [usize; 2]) -> (Vec<f64>, Length) {
    let (smooth, spacing) = CYLINDER.gap(columns);
    let turns = |count: usize, waves: f64, phase: f64| -> Vec<(f64, f64)> {
        let turn = std::f64::consts::TAU * waves / count as f64;
        (0..count)
            .map(|i| (turn * i as f64 + phase).sin_cos())
            .collect()
    };
    let mut heights = vec![0.0; columns * rows];
    let mut power = 0.0;
    for wave in 0..100 {
        let [place, direction, phase] =
            [0, 1, 2].map(|k| std::f64::consts::TAU * random(31, 3 * wave + k));
        // Waves in a window, evenly spread over octaves: a Hurst exponent of 0.8.
        let count = 6.0 * 25f64.powf(place / std::f64::consts::TAU);
        let amplitude = count.powf(-0.8);
        let (across, along) = direction.sin_cos();
        let across = (count * across * rows as f64 / columns as f64).round();
        let (along, across) = (
            turns(columns, count * along, phase),
            turns(rows, across, 0.0),
        );
        for (row, (sine, cosine)) in heights.chunks_exact_mut(columns).zip(across) {
            for (z, (s, c)) in row.iter_mut().zip(&along) {
                *z += amplitude * (c * cosine - s * sine);
            }
        }
        power += 0.5 * amplitude * amplitude;
    }
    let scale = 0.4e-6 / power.sqrt();
    let cells = heights
        .chunks_exact(columns)
        .flat_map(|row| row.iter().zip(&smooth));
    (cells.map(|(z, h)| h - scale * z).collect(), spacing)
}

/// A rough periodic gap of 1 mm, waves 1 to 40 of about 1 µm, and the spacing.
pub fn rough_wave(points: usize) -> (Vec<f64>, Length) {
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let gap = self_affine(&x, 1..=40, 7)
        .iter()
        .map(|z| -1e-6 * z)
        .collect();
    (gap, Length::from_si(1e-3 / points as f64))
}

/// A periodic problem of steel under 10 N/mm per period.
pub fn periodic_problem(
    gap: &[f64],
    spacing: Length,
    kernel: asperity_contact::PeriodicKernel,
) -> ContactProblem<'_> {
    ContactProblem {
        boundary: Boundary::Periodic(kernel),
        control: Control::Load(LineLoad::from_si(1e4)),
        ..hertz_problem(gap, spacing)
    }
}

/// Settings whose certificate leaves single pressures right to about 1e-9.
pub fn tight() -> SolverSettings {
    SolverSettings {
        tolerance: 1e-12,
        ..SolverSettings::default()
    }
}

/// The largest value.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

/// Largest difference over the largest magnitude of `expected`.
pub fn relative_difference(values: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(values.len(), expected.len());
    let size = expected.iter().fold(0.0, |m, x| f64::max(m, x.abs()));
    let pairs = values.iter().zip(expected);
    pairs.fold(0.0, |m, (x, y)| f64::max(m, (x - y).abs())) / size
}
