//! How fast the errors against closed forms fall with the cell.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use crate::common::{CYLINDER, hertz_problem, periodic_problem, tight};
use asperity_contact::hertz_line::{self, HertzLine};
use asperity_contact::westergaard::Wave;
use asperity_contact::{
    ContactProblem, ContactSolution, Control, PeriodicKernel, SolverSettings, flat_punch, solve,
};
use asperity_core::quantity::{Length, LineLoad};

/// Slope of ln(error) over ln(1/n) by least squares.
fn order(points: &[usize], error: impl Fn(usize) -> f64) -> f64 {
    let logs: Vec<(f64, f64)> = points
        .iter()
        .map(|&n| (-(n as f64).ln(), error(n).ln()))
        .collect();
    let count = logs.len() as f64;
    let (x, y) = logs
        .iter()
        .fold((0.0, 0.0), |(x, y), p| (x + p.0 / count, y + p.1 / count));
    let slope = |f: fn(f64, f64) -> f64| -> f64 { logs.iter().map(|p| f(p.0 - x, p.1 - y)).sum() };
    slope(|x, y| x * y) / slope(|x, _| x * x)
}

/// Sizes over a factor of 64, prime to each other so that the edges of a contact fall anywhere in
/// their cells.
const POINTS: [usize; 10] = [
    251, 401, 631, 1_009, 1_601, 2_521, 4_001, 6_337, 10_007, 16_001,
];

fn cylinder(points: usize) -> ContactSolution {
    let (gap, spacing) = CYLINDER.gap(points);
    solve(&hertz_problem(&gap, spacing), &tight()).unwrap()
}

#[test]
fn the_pressure_of_a_cylinder_has_the_order_of_its_edges() {
    let hertz = HertzLine::new(CYLINDER.load, CYLINDER.radius, CYLINDER.modulus).unwrap();
    let found = order(&POINTS, |points| {
        let dx = CYLINDER.window.si() / points as f64;
        let pairs = CYLINDER
            .positions(points)
            .into_iter()
            .zip(cylinder(points).pressure);
        let error =
            |(x, p): (f64, f64)| (p - hertz.pressure(Length::from_si(x)).unwrap().si()).abs();
        pairs.map(error).sum::<f64>() * dx / CYLINDER.load.si()
    });
    // The square root at the edge: h^1.5. Its place in the cell scatters single errors.
    assert!((found - 1.5).abs() < 0.2, "mean error: {found}");
    let found = order(&POINTS, |points| {
        (cylinder(points).max_pressure / hertz.max_pressure - 1.0).abs()
    });
    assert!(found > 1.8, "largest pressure: {found}");
    let found = order(&POINTS, |points| {
        let solution = cylinder(points);
        let (load, modulus) = (CYLINDER.load, CYLINDER.modulus);
        let exact = hertz_line::approach(load, CYLINDER.radius, modulus, solution.datum).unwrap();
        (solution.approach / exact - 1.0).abs()
    });
    assert!((found - 2.0).abs() < 0.3, "approach: {found}");
}

#[test]
fn the_pressure_of_a_wave_has_the_order_of_its_edges() {
    let wave = Wave {
        amplitude: Length::from_si(1e-6),
        wavelength: Length::from_si(1e-3),
        modulus: CYLINDER.modulus,
    };
    let mean = wave.closing_pressure().unwrap() * 0.3;
    for kernel in [PeriodicKernel::Strip, PeriodicKernel::Spectral] {
        let solved = |points: usize| {
            let position = |i: usize| (i as f64 + 0.5) / points as f64 * 1e-3;
            let gap: Vec<f64> = (0..points)
                .map(|i| 1e-6 * (1.0 - (std::f64::consts::TAU * 1e3 * position(i)).cos()))
                .collect();
            let problem = ContactProblem {
                control: Control::Load(LineLoad::from_si(mean.si() * 1e-3)),
                ..periodic_problem(&gap, wave.wavelength / points as f64, kernel)
            };
            let solution = solve(&problem, &tight()).unwrap();
            let exact = |i| {
                wave.pressure(mean, Length::from_si(position(i)))
                    .unwrap()
                    .si()
            };
            let error: f64 = (0..points)
                .map(|i| (solution.pressure[i] - exact(i)).abs())
                .sum();
            let gap = solution.gap.iter().sum::<f64>() / points as f64;
            let gap_error = (gap / wave.mean_gap(mean).unwrap().si() - 1.0).abs();
            (error / (points as f64 * mean.si()), gap_error)
        };
        let (pressure, gap) = (
            order(&POINTS, |n| solved(n).0),
            order(&POINTS, |n| solved(n).1),
        );
        assert!(
            (pressure - 1.5).abs() < 0.25,
            "{kernel:?}, mean error: {pressure}"
        );
        assert!((gap - 2.0).abs() < 0.3, "{kernel:?}, mean gap: {gap}");
    }
}

#[test]
fn the_approach_of_a_flat_strip_is_of_the_first_order() {
    let half = CYLINDER.window / 2.0;
    let found = order(&POINTS, |points| {
        let (gap, spacing) = (vec![0.0; points], CYLINDER.window / points as f64);
        let settings = SolverSettings::default();
        let solution = solve(&hertz_problem(&gap, spacing), &settings).unwrap();
        let exact = flat_punch::approach(CYLINDER.load, half, CYLINDER.modulus, solution.datum);
        (solution.approach / exact.unwrap() - 1.0).abs()
    });
    // The pressure is infinite at the edge of the strip, which costs part of a cell.
    assert!((found - 1.0).abs() < 0.1, "{found}");
}
