//! The problems that contact programs are compared on.
//!
//! Phases come from splitmix64: the k-th number of seed s is the top 53 bits of the output for the state s · 1 099 511 628 211 + k, over
//! 2⁵³, and φₖ is 2π times it. Points are in the middle of their cells for free ends, and at j/n for periods.
//!
//! | case | gap | load | ends |
//! |---|---|---|---|
//! | a | cylinder, R 3 mm, window of 600 µm, E\* = 210 GPa/1.82 | 300 N/mm | free |
//! | d | a less two profiles of seeds 11 and 22, each Σ k^−1.3 cos(2πkx/L + φₖ), k 6..300, Rq 0.4 µm/√2 | 300 N/mm | free |
//! | e | d with a pressure limit of 4 GPa | 300 N/mm | free |
//! | c | −Σ k^−1.3 cos(2πkx + φₖ), k 16..512, seed 20 240 601, root mean square slope 1; E\* = 1, L = 1 | mean 0.015 | periodic |
//! | cf | c with waves to n/8 at the same scale | mean 0.015, 0.039, 0.075 at n = 4096, 65 536, 1 048 576 | periodic |

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use std::f64::consts::{PI, TAU};

use asperity_contact::{Boundary, ContactProblem, Control, Lead, PeriodicKernel};
use asperity_core::numerics::real_transforms;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use realfft::num_complex::Complex;

use super::{CYLINDER, hertz_problem, random, rough_gap};

/// Seed of the phases of the periodic surfaces.
const SEED: u64 = 20_240_601;

/// E* of the patches.
const PATCH_MODULUS: Pressure = Pressure::from_si(115e9);

/// A problem that owns its gap.
pub struct Peer {
    pub gap: Vec<f64>,
    spacing: Length,
    modulus: Pressure,
    boundary: Boundary,
    load: LineLoad,
    limit: Option<Pressure>,
    lead: Option<Lead>,
}

/// Cells along both sides of a periodic patch, 1 um each.
const SIDE: usize = 256;

impl Peer {
    /// Case `name` of `points` cells: a Hertz, c and cf periodic self-affine, d rough, e plastic. The other names are of periodic patches of
    /// 256 by 256 cells, whatever `points` says.
    pub fn new(name: &str, points: usize) -> Option<Self> {
        let line = |(gap, spacing): (Vec<f64>, Length), limit| Self {
            gap,
            spacing,
            modulus: CYLINDER.modulus,
            boundary: Boundary::FreeEnds,
            load: CYLINDER.load,
            limit,
            lead: None,
        };
        let wave = |most: usize, mean: f64| Self {
            gap: rough_period(points, most),
            spacing: Length::from_si(1.0 / points as f64),
            modulus: Pressure::from_si(1.0),
            boundary: Boundary::Periodic(PeriodicKernel::Strip),
            load: LineLoad::from_si(mean),
            limit: None,
            lead: None,
        };
        // Mean pressures for about 5 % in contact.
        Some(match (name, points) {
            ("a", _) => line(CYLINDER.gap(points), None),
            ("d", _) => line(rough_gap(points), None),
            ("e", _) => line(rough_gap(points), Some(Pressure::from_si(4e9))),
            ("c", _) => wave(512, 0.015),
            ("cf", 65_536) => wave(points / 8, 0.039),
            ("cf", 1_048_576) => wave(points / 8, 0.075),
            ("cf", _) => wave(points / 8, 0.015 * (points as f64 / 4096.0).powf(0.3)),
            _ => return Self::patch(name),
        })
    }

    /// A periodic patch with the spectral kernel, by its name.
    fn patch(name: &str) -> Option<Self> {
        let spacing = Length::from_si(1e-6);
        let side = spacing.si() * SIDE as f64;
        // Of 2 N.
        let of_ball = 2.0 / (side * side);
        let closing = 2f64.sqrt() * PI * PATCH_MODULUS.si() * 0.5e-6 / side;
        let ball = |x: f64, y: f64| (x * x + y * y) / 2e-3;
        let wave = |length: f64, x: f64| (TAU * x / length).cos();
        let of = |gap: &dyn Fn(f64, f64) -> f64, mean: f64| {
            let place = |i: usize| (i as f64 - (SIDE / 2) as f64) * spacing.si();
            let cells = (0..SIDE * SIDE).map(|k| gap(place(k % SIDE), place(k / SIDE)));
            (cells.collect(), mean)
        };
        let double_wave = |x: f64, y: f64| 0.5e-6 * (1.0 - wave(side, x) * wave(side, y));
        let (gap, mean) = match name {
            "constant" => of(&|x, _| x * x / 20e-3 - 0.2e-6 * wave(64e-6, x), 0.05e9),
            "ball" => of(&ball, of_ball),
            "double-wave" => of(&double_wave, 0.4 * closing),
            "ball-on-waves" => of(
                &|x, y| ball(x, y) - 0.05e-6 * wave(16e-6, x) * wave(16e-6, y),
                of_ball,
            ),
            "self-affine" => (self_affine_patch(), 0.1e9),
            _ => return None,
        };
        Some(Self {
            gap,
            spacing,
            modulus: PATCH_MODULUS,
            boundary: Boundary::Periodic(PeriodicKernel::Spectral),
            load: LineLoad::from_si(mean * side),
            limit: None,
            lead: Some(Lead {
                rows: SIDE,
                spacing,
            }),
        })
    }

    pub fn problem(&self) -> ContactProblem<'_> {
        ContactProblem {
            lead: self.lead,
            modulus: self.modulus,
            boundary: self.boundary,
            control: Control::Load(self.load),
            pressure_limit: self.limit,
            ..hertz_problem(&self.gap, self.spacing)
        }
    }
}

/// The gap over a self-affine patch: waves 2 to 64 of its side with a Hurst exponent of 0.8, Rq 0.3 um.
fn self_affine_patch() -> Vec<f64> {
    let mut heights = vec![0.0; SIDE * SIDE];
    let mut power = 0.0;
    let mut number = 0;
    for (m, n) in (0..=64).flat_map(|m| (-64..=64).map(move |n| (m, n))) {
        let waves = f64::from(m * m + n * n).sqrt();
        number += 1;
        // Of a wave and its opposite, one.
        if (m, n) <= (0, 0) || !(2.0..=64.0).contains(&waves) {
            continue;
        }
        let size = waves.powf(-1.8);
        power += 0.5 * size * size;
        let turns = |waves: i32, phase: f64| -> Vec<(f64, f64)> {
            let turn = TAU * f64::from(waves) / SIDE as f64;
            let each = (0..SIDE).map(|i| (turn * i as f64 + phase).sin_cos());
            each.collect()
        };
        let along = turns(m, TAU * random(SEED, number));
        let across = turns(n, 0.0);
        for (row, (sine, cosine)) in heights.chunks_exact_mut(SIDE).zip(across) {
            for (z, (s, c)) in row.iter_mut().zip(&along) {
                *z += size * (c * cosine - s * sine);
            }
        }
    }
    let scale = 0.3e-6 / power.sqrt();
    heights.iter().map(|z| -scale * z).collect()
}

/// The gap over a self-affine surface of waves 16 to `most`, whose waves to 512 have together a
/// root mean square slope of one.
fn rough_period(points: usize, most: usize) -> Vec<f64> {
    let slope: f64 = (16..=512)
        .map(|k| 0.5 * (TAU * f64::from(k).powf(-0.3)).powi(2))
        .sum();
    let (_, inverse) = real_transforms(points);
    let mut spectrum = inverse.make_input_vec();
    for (k, wave) in spectrum.iter_mut().enumerate().skip(16).take(most - 15) {
        let size = -0.5 * (k as f64).powf(-1.3) / slope.sqrt();
        *wave = Complex::from_polar(size, TAU * random(SEED, k as u64));
    }
    let mut gap = inverse.make_output_vec();
    inverse.process(&mut spectrum, &mut gap).unwrap();
    gap
}
