//! Ends of the range of problems: nothing touches, everything touches, everything flows.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use crate::common::{
    CYLINDER, hertz_problem, periodic_problem, relative_difference, rough_gap, tight,
};
use asperity_contact::dense_reference::solve_dense;
use asperity_contact::hertz_line::HertzLine;
use asperity_contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, ContactWarning, Control,
    PeriodicKernel, Solver, SolverSettings, solve,
};
use asperity_core::quantity::{Length, LineLoad, Pressure};

fn approach(metres: f64) -> Control {
    Control::Approach {
        approach: Length::from_si(metres),
        datum: CYLINDER.window * 2.0,
    }
}

fn solved(problem: &ContactProblem) -> Result<ContactSolution, ContactError> {
    solve(problem, &SolverSettings::default())
}

#[test]
fn bodies_held_apart_carry_nothing() {
    let (gap, spacing) = rough_gap(1_000);
    let lowest = gap.iter().copied().fold(f64::INFINITY, f64::min);
    let problem = ContactProblem {
        control: approach(lowest - 1e-9),
        ..hertz_problem(&gap, spacing)
    };
    let solution = solved(&problem).unwrap();
    assert_eq!((solution.load.si(), solution.contact_fraction), (0.0, 0.0));
    assert_eq!(solution.iterations, 0);
    let least = solution.gap.iter().copied().fold(f64::INFINITY, f64::min);
    assert!((least - 1e-9).abs() < 1e-18);
    // Also when the start comes from a contact that has since been opened.
    let start = vec![1e8; gap.len()];
    let opened = solved(&ContactProblem {
        start: Some(&start),
        ..problem
    })
    .unwrap();
    assert_eq!(opened.load.si(), 0.0);
}

#[test]
fn lowering_in_small_steps_gives_a_load_that_is_zero_and_then_rises() {
    let (gap, spacing) = rough_gap(1_000);
    let lowest = gap.iter().copied().fold(f64::INFINITY, f64::min);
    let mut solver = Solver::new(gap.len(), Boundary::FreeEnds).unwrap();
    let mut start: Option<Vec<f64>> = None;
    let mut loads = vec![];
    for step in 0..100 {
        let problem = ContactProblem {
            control: approach(lowest + 80e-9 * (f64::from(step) - 9.5)),
            start: start.as_deref(),
            ..hertz_problem(&gap, spacing)
        };
        let solution = solver.solve(&problem, &SolverSettings::default()).unwrap();
        assert!(
            solution.iterations < 150,
            "step {step}: {}",
            solution.iterations
        );
        loads.push(solution.load.si());
        start = Some(solution.pressure);
    }
    assert!(loads[..10].iter().all(|&load| load == 0.0));
    assert!(loads[9..].windows(2).all(|pair| pair[1] > pair[0]));
    assert!(loads[99] > CYLINDER.load.si());
}

#[test]
fn full_contact_is_the_linear_solution() {
    // p = p̄ + p*·cos(2πx/λ) once p̄ > p*: exact for the spectral kernel, Johnson 1985 eq. 13.6.
    let (points, amplitude) = (64, 1e-6);
    let spacing = Length::from_si(1e-3 / points as f64);
    let cosine = |i: usize| (std::f64::consts::TAU * i as f64 / points as f64).cos();
    let gap: Vec<f64> = (0..points).map(|i| amplitude * (1.0 - cosine(i))).collect();
    let closing = std::f64::consts::PI * CYLINDER.modulus.si() * amplitude / 1e-3;
    let problem = ContactProblem {
        control: Control::Load(LineLoad::from_si(1.5 * closing * 1e-3)),
        ..periodic_problem(&gap, spacing, PeriodicKernel::Spectral)
    };
    let solution = solve(&problem, &tight()).unwrap();
    let expected: Vec<f64> = (0..points).map(|i| closing * (1.5 + cosine(i))).collect();
    assert_eq!(solution.contact_fraction, 1.0);
    assert!(relative_difference(&solution.pressure, &expected) < 1e-10);
    assert!((solution.approach.si() / amplitude - 1.0).abs() < 1e-10);
}

#[test]
fn a_flat_period_carries_its_load_evenly() {
    let gap = [0.0; 10];
    let spacing = Length::from_si(1e-6);
    for kernel in [PeriodicKernel::Strip, PeriodicKernel::Spectral] {
        let solution = solved(&periodic_problem(&gap, spacing, kernel)).unwrap();
        let even = vec![1e4 / 10e-6; 10];
        assert!(relative_difference(&solution.pressure, &even) < 1e-12);
    }
}

#[test]
fn a_single_point_in_contact_carries_all() {
    let gap = [1.0, 0.0, 1.0];
    for boundary in [
        Boundary::FreeEnds,
        Boundary::Periodic(PeriodicKernel::Strip),
        Boundary::Periodic(PeriodicKernel::Spectral),
    ] {
        let problem = ContactProblem {
            boundary,
            ..hertz_problem(&gap, Length::from_si(1e-6))
        };
        let solution = solved(&problem).unwrap();
        assert_eq!(solution.pressure[0], 0.0);
        assert!((solution.pressure[1] / 3e11 - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_limit_hardly_above_the_mean_pressure_flows_nearly_everywhere() {
    let (gap, spacing) = rough_gap(300);
    let mean = CYLINDER.load.si() / CYLINDER.window.si();
    let problem = ContactProblem {
        pressure_limit: Some(Pressure::from_si(1.001 * mean)),
        ..hertz_problem(&gap, spacing)
    };
    let solution = solved(&problem).unwrap();
    assert!(solution.contact_fraction > 0.999);
    assert!((solution.load / CYLINDER.load - 1.0).abs() < 1e-12);
}

#[test]
fn a_contact_all_at_the_limit_needs_no_point_between_the_bounds() {
    // Four cells at the limit carry the load to the last bit.
    let gap: Vec<f64> = (0..64)
        .map(|i| 1e-5 * (f64::from(i) - 31.5).powi(2))
        .collect();
    let spacing = Length::from_si(1e-6);
    let problem = ContactProblem {
        control: Control::Load(LineLoad::from_si(4e3)),
        pressure_limit: Some(Pressure::from_si(1e9)),
        ..hertz_problem(&gap, spacing)
    };
    let solution = solved(&problem).unwrap();
    assert!((solution.contact_fraction - 4.0 / 64.0).abs() < 1e-15);
    assert!(solution.pressure[30..34].iter().all(|&p| p == 1e9));
}

#[test]
fn the_scale_of_the_units_does_not_matter() {
    for scale in [1e-60, 1e60] {
        let gap: Vec<f64> = CYLINDER.gap(256).0.iter().map(|h| h * scale).collect();
        let spacing = CYLINDER.window / 256.0 * scale;
        let problem = ContactProblem {
            control: Control::Load(CYLINDER.load * scale),
            ..hertz_problem(&gap, spacing)
        };
        let solution = solved(&problem).unwrap();
        assert!((solution.max_pressure.si() / 1.916_456_7e9 - 1.0).abs() < 1e-4);
    }
}

#[test]
fn a_solver_serves_other_spacings_moduli_and_loads() {
    let (gap, spacing) = rough_gap(700);
    let mut solver = Solver::new(700, Boundary::FreeEnds).unwrap();
    for factor in [1.0, 0.5, 3.0] {
        let problem = ContactProblem {
            modulus: CYLINDER.modulus * factor,
            control: Control::Load(CYLINDER.load / factor),
            ..hertz_problem(&gap, spacing * factor)
        };
        let kept = solver.solve(&problem, &SolverSettings::default()).unwrap();
        assert_eq!(kept, solved(&problem).unwrap());
    }
}

#[test]
fn a_solution_is_its_own_start() {
    let (gap, spacing) = rough_gap(2_000);
    let problem = hertz_problem(&gap, spacing);
    let first = solved(&problem).unwrap();
    let start = Some(first.pressure.as_slice());
    let again = solved(&ContactProblem { start, ..problem }).unwrap();
    // The window may be another, whose round-off can cost a step at the edge of the tolerance.
    assert!(again.iterations <= 2, "{}", again.iterations);
}

#[test]
fn a_single_point_that_carries_all_lets_go() {
    // Here clipping the direction and restoring the load leads back to where it came from.
    let points = 64;
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let gap: Vec<f64> = crate::common::self_affine(&x, 1..=20, 525_262)
        .iter()
        .map(|z| 1e-6 * z)
        .collect();
    let mut start = vec![0.0; points];
    start[20] = 1.0;
    let spacing = Length::from_si(1e-3 / points as f64);
    let problem = ContactProblem {
        start: Some(&start),
        ..periodic_problem(&gap, spacing, PeriodicKernel::Strip)
    };
    let even = ContactProblem {
        start: None,
        ..problem
    };
    let expected = solve_dense(&even).unwrap().pressure;
    for problem in [problem, even] {
        let solution = solve(&problem, &tight()).unwrap();
        assert!(relative_difference(&solution.pressure, &expected) < 1e-8);
    }
}

#[test]
fn bodies_forced_together_beyond_their_limit_flow_everywhere() {
    let gap = [0.0; 10];
    let problem = ContactProblem {
        control: approach(1e-3),
        pressure_limit: Some(Pressure::from_si(1e9)),
        ..hertz_problem(&gap, Length::from_si(1e-6))
    };
    let solution = solved(&problem).unwrap();
    assert_eq!(solution.pressure, [1e9; 10]);
    // What elasticity does not give way to, flow must.
    let left: f64 = solution.displacement[0] + solution.plastic_displacement[0];
    assert!((left / 1e-3 - 1.0).abs() < 1e-12);
    assert!(solution.gap.iter().all(|&g| g == 0.0));
}

#[test]
fn the_load_does_not_drift_from_step_to_step() {
    // Steps that reach far beyond the load here leave 5e-12 of it to be restored at the end.
    let points = 112;
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let gap: Vec<f64> = crate::common::self_affine(&x, 1..=20, 522_829)
        .iter()
        .map(|z| 1e-6 * z)
        .collect();
    let spacing = Length::from_si(1e-3 / points as f64);
    let problem = periodic_problem(&gap, spacing, PeriodicKernel::Spectral);
    let solution = solve(&problem, &tight()).unwrap();
    assert!(solution.certificate.load_error < 1e-14);
}

#[test]
fn a_solver_can_move_between_threads() {
    fn shared<T: Send + Sync>() {}
    shared::<Solver>();
    shared::<ContactSolution>();
    shared::<ContactError>();
}

#[test]
fn a_contact_far_outside_the_start_is_found() {
    // The start touches on the left where the gap is wide, so the first window is a wrong one.
    let (gap, spacing) = rough_gap(2_000);
    let mut start = vec![0.0; gap.len()];
    start[100..110].fill(1e9);
    for limit in [None, Some(Pressure::from_si(4e9))] {
        let problem = ContactProblem {
            pressure_limit: limit,
            ..hertz_problem(&gap, spacing)
        };
        let expected = solve(&problem, &tight()).unwrap();
        let misled = ContactProblem {
            start: Some(&start),
            ..problem
        };
        let solution = solve(&misled, &tight()).unwrap();
        assert!(relative_difference(&solution.pressure, &expected.pressure) < 1e-8);
    }
}

/// Largest difference of the pressures of two solutions over the largest pressure.
fn pressures_apart(problem: &ContactProblem, other: &ContactProblem) -> f64 {
    let [one, other] =
        [problem, other].map(|problem| solve(problem, &SolverSettings::default()).unwrap());
    relative_difference(&other.pressure, &one.pressure)
}

#[test]
fn a_far_point_that_lies_deep_leaves_the_contact_as_it_is() {
    for points in [1_000, 10_000] {
        let (gap, spacing) = rough_gap(points);
        for depth in [1.0, 100.0] {
            let mut deep = gap.clone();
            deep[0] += depth;
            let (problem, with_point) =
                (hertz_problem(&gap, spacing), hertz_problem(&deep, spacing));
            let apart = pressures_apart(&problem, &with_point);
            // Both are right to about 1e-5 of the largest pressure.
            assert!(apart < 3e-5, "{points} {depth}: {apart:e}");
            let solution = solve(&with_point, &SolverSettings::default()).unwrap();
            let found = solution.warnings();
            assert!(
                matches!(found[..], [ContactWarning::GapBeyondDeformation { .. }]),
                "{found:?}"
            );
            assert!(solution.certificate.reference_gap.si() < 20e-6);
        }
        assert!(
            solve(&hertz_problem(&gap, spacing), &SolverSettings::default())
                .unwrap()
                .warnings()
                .is_empty()
        );
    }
}

#[test]
fn a_light_contact_with_a_deep_end_is_as_right_as_a_heavy_one() {
    for load in [30.0, 300.0, 3e5] {
        let hertz =
            HertzLine::new(LineLoad::from_si(load), CYLINDER.radius, CYLINDER.modulus).unwrap();
        let points = 2_000;
        let spacing = hertz.half_width * 4.0 / points as f64;
        let middle = 0.5 * (points - 1) as f64;
        let mut gap: Vec<f64> = (0..points)
            .map(|i| ((i as f64 - middle) * spacing.si()).powi(2) / (2.0 * CYLINDER.radius.si()))
            .collect();
        gap[points - 1] += 15e-6;
        let problem = ContactProblem {
            control: Control::Load(LineLoad::from_si(load)),
            ..hertz_problem(&gap, spacing)
        };
        let solution = solve(&problem, &SolverSettings::default()).unwrap();
        let largest = solution.max_pressure / hertz.max_pressure;
        // The discretisation error of 1000 points in contact.
        assert!((largest - 1.0).abs() < 1e-5, "{load}: {largest}");
        let exact: Vec<f64> = (0..points)
            .map(|i| hertz.pressure(spacing * (i as f64 - middle)).unwrap().si())
            .collect();
        let sum: f64 = exact.iter().sum();
        let off = |(p, e): (&f64, &f64)| (p - e).abs();
        let apart: f64 = solution.pressure.iter().zip(&exact).map(off).sum();
        assert!(apart / sum < 2e-4, "{load}: {:e}", apart / sum);
    }
}

#[test]
fn a_contact_that_runs_into_a_free_end_says_so() {
    // A cylinder of 10 mm radius under 3000 N/mm is wider than its window of 1 mm.
    let points = 1_000;
    let gap: Vec<f64> = (0..points)
        .map(|i| (1e-6 * (f64::from(i) - 499.5)).powi(2) / 20e-3)
        .collect();
    let load = LineLoad::from_si(3e6);
    let free = ContactProblem::new(&gap, Length::from_si(1e-6), CYLINDER.modulus, load);
    let solution = solve(&free, &SolverSettings::default()).unwrap();
    assert_eq!(
        solution.warnings(),
        [ContactWarning::PressureAtEnd {
            end_pressure: solution.end_pressure,
            max_pressure: solution.max_pressure,
        }]
    );
    assert!(solution.end_pressure.si() > 0.0);
    let light = ContactProblem {
        control: Control::Load(LineLoad::from_si(3e4)),
        ..free
    };
    let solution = solve(&light, &SolverSettings::default()).unwrap();
    assert_eq!(
        (solution.end_pressure.si(), solution.warnings()),
        (0.0, vec![])
    );
    // A period may begin anywhere.
    let mut turned = gap.clone();
    turned.rotate_left(500);
    let periodic = ContactProblem {
        gap: &turned,
        boundary: Boundary::Periodic(PeriodicKernel::Strip),
        ..free
    };
    let solution = solve(&periodic, &SolverSettings::default()).unwrap();
    assert!(solution.pressure[0] > 0.0 && solution.warnings().is_empty());
}

#[test]
fn a_high_limit_of_the_pressure_changes_no_certificate() {
    let (gap, spacing) = rough_gap(2_000);
    let elastic = hertz_problem(&gap, spacing);
    for limit in [100.0, 1e4, 1e8] {
        let limited = ContactProblem {
            // Over the mean pressure of the window.
            pressure_limit: Some(Pressure::from_si(limit * 3e5 / 600e-6)),
            ..elastic
        };
        let solution = solve(&limited, &tight()).unwrap();
        assert!(solution.certificate.within(1e-12) && solution.dissipated.si() == 0.0);
        let free = solve(&elastic, &tight()).unwrap();
        let apart = relative_difference(&solution.pressure, &free.pressure);
        assert!(apart < 1e-9, "{limit}: {apart:e}");
    }
}
