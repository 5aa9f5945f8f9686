//! The problems that contact programs are compared on; `docs/records/performance-contact.md` defines them in words.

#![allow(
    clippy::unwrap_used,
    reason = "helpers of tests may unwrap as tests do"
)]

use std::f64::consts::TAU;

use asperity_contact::{Boundary, ContactProblem, Control, PeriodicKernel};
use asperity_core::numerics::real_transforms;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use realfft::num_complex::Complex;

use super::{CYLINDER, hertz_problem, random, rough_gap};

/// Seed of the phases of the periodic surfaces.
const SEED: u64 = 20_240_601;

/// A problem that owns its gap.
pub struct Peer {
    pub gap: Vec<f64>,
    spacing: Length,
    modulus: Pressure,
    boundary: Boundary,
    load: LineLoad,
    limit: Option<Pressure>,
}

impl Peer {
    /// Case `name` of `points` cells: a Hertz, c and cf periodic self-affine, d rough, e plastic.
    pub fn new(name: &str, points: usize) -> Option<Self> {
        let line = |(gap, spacing): (Vec<f64>, Length), limit| Self {
            gap,
            spacing,
            modulus: CYLINDER.modulus,
            boundary: Boundary::FreeEnds,
            load: CYLINDER.load,
            limit,
        };
        let wave = |most: usize, mean: f64| Self {
            gap: rough_period(points, most),
            spacing: Length::from_si(1.0 / points as f64),
            modulus: Pressure::from_si(1.0),
            boundary: Boundary::Periodic(PeriodicKernel::Strip),
            load: LineLoad::from_si(mean),
            limit: None,
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
            _ => return None,
        })
    }

    pub fn problem(&self) -> ContactProblem<'_> {
        ContactProblem {
            modulus: self.modulus,
            boundary: self.boundary,
            control: Control::Load(self.load),
            pressure_limit: self.limit,
            ..hertz_problem(&self.gap, self.spacing)
        }
    }
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
