//! Patches: windows with an extent along the lead.

use std::f64::consts::PI;

use asperity_contact::dense_reference::solve_dense;
use asperity_contact::hertz_point::HertzPoint;
use asperity_contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, Control, Lead, PeriodicKernel, Solver,
    SolverSettings, solve,
};
use asperity_core::quantity::{Force, Length, LineLoad, Pressure};

use crate::common::{CYLINDER, relative_difference, rough_gap, rough_patch, rough_wave, tight};

fn lead(rows: usize, spacing: Length) -> Option<Lead> {
    Some(Lead { rows, spacing })
}

#[test]
fn a_patch_constant_along_the_lead_is_its_line() {
    let rows = 5;
    let (free, periodic) = (rough_gap(500), rough_wave(256));
    let limit = Some(Pressure::from_si(4e9));
    for (boundary, (gap, spacing), pressure_limit) in [
        (Boundary::FreeEnds, &free, None),
        (Boundary::FreeEnds, &free, limit),
        (Boundary::Periodic(PeriodicKernel::Strip), &periodic, None),
        (
            Boundary::Periodic(PeriodicKernel::Spectral),
            &periodic,
            None,
        ),
    ] {
        let load = match boundary {
            Boundary::FreeEnds => CYLINDER.load,
            Boundary::Periodic(_) => LineLoad::from_si(1e4),
            _ => unreachable!("no boundary of this test"),
        };
        let line = ContactProblem {
            boundary,
            pressure_limit,
            ..ContactProblem::new(gap, *spacing, CYLINDER.modulus, load)
        };
        let rough = gap.repeat(rows);
        let patch = ContactProblem {
            gap: &rough,
            lead: lead(rows, *spacing * 3.0),
            ..line
        };
        let [line, patch] = [line, patch].map(|problem| solve(&problem, &tight()).unwrap());
        for (of_patch, of_line) in [
            (&patch.pressure, &line.pressure),
            (&patch.gap, &line.gap),
            (&patch.displacement, &line.displacement),
        ] {
            let difference = relative_difference(of_patch, &of_line.repeat(rows));
            assert!(difference < 1e-8, "{boundary}: {difference:e}");
        }
        let numbers = |of: &ContactSolution| {
            [
                of.load.si(),
                of.approach.si(),
                of.elastic_energy.si(),
                of.dissipated.si(),
                of.contact_fraction,
                of.certificate.reference_gap.si(),
            ]
        };
        for (of_patch, of_line) in numbers(&patch).into_iter().zip(numbers(&line)) {
            assert!(
                (of_patch - of_line).abs() <= 1e-8 * of_line.abs(),
                "{of_patch} {of_line}"
            );
        }
    }
}

#[test]
fn a_barrel_on_a_plane_has_the_contact_of_hertz() {
    // Cells of a tenth of the half axes, in a window of ten.
    let (radii, modulus, load) = ([5e-3, 9e-3], Pressure::from_si(115e9), Force::from_si(30.0));
    let hertz = HertzPoint::new(load, radii.map(Length::from_si), modulus).unwrap();
    let n = 96;
    let [dx, dy] = hertz.half_axes.map(|axis| axis * 0.1);
    let place = |i: usize, step: Length| (i as f64 - 0.5 * (n - 1) as f64) * step.si();
    let gap: Vec<f64> = (0..n * n)
        .map(|k| {
            let [x, y] = [place(k % n, dx), place(k / n, dy)];
            x * x / (2.0 * radii[0]) + y * y / (2.0 * radii[1])
        })
        .collect();
    let mean = LineLoad::from_si(load.si() / (dy.si() * n as f64));
    let problem = ContactProblem {
        lead: lead(n, dy),
        ..ContactProblem::new(&gap, dx, modulus, mean)
    };
    let found = solve(&problem, &SolverSettings::default()).unwrap();
    let cells = found.contact_fraction * (n * n) as f64;
    // Half of the 63 cells on the edge of a circle of ten cells scatter: √(63/4)/314 is one standard deviation of 1.3 %.
    assert!((cells / (100.0 * PI) - 1.0).abs() < 0.03);
    for (k, p) in found.pressure.iter().enumerate() {
        let [x, y] = [
            place(k % n, dx) / hertz.half_axes[0].si(),
            place(k / n, dy) / hertz.half_axes[1].si(),
        ];
        let expected = (1.0 - x * x - y * y).max(0.0).sqrt();
        let error = p / hertz.max_pressure.si() - expected;
        assert!(
            error.abs() < 0.02 || (x.hypot(y) - 1.0).abs() < 0.1,
            "{x} {y}: {error}"
        );
    }
}

/// The gap Δ·(1 − cos(2πx/λ)·cos(2πy/λ)) on `n`² cells of a period, and the spacing.
fn double_wave(n: usize) -> (Vec<f64>, Length) {
    let wave = |i: usize| (2.0 * PI * i as f64 / n as f64).cos();
    let gap = (0..n * n)
        .map(|k| 1e-6 * (1.0 - wave(k % n) * wave(k / n)))
        .collect();
    (gap, Length::from_si(1e-3 / n as f64))
}

/// The contact of the double wave at a mean pressure over p* = √2·π·E*·Δ/λ.
fn pressed_wave(
    n: usize,
    share: f64,
    kernel: PeriodicKernel,
) -> Result<ContactSolution, ContactError> {
    let (gap, spacing) = double_wave(n);
    let closing = 2f64.sqrt() * PI * 100e9 * 1e-3;
    let problem = ContactProblem {
        boundary: Boundary::Periodic(kernel),
        lead: lead(n, spacing),
        ..ContactProblem::new(
            &gap,
            spacing,
            Pressure::from_si(100e9),
            LineLoad::from_si(share * closing * 1e-3),
        )
    };
    solve(&problem, &SolverSettings::default())
}

#[test]
fn a_double_wave_closes_at_its_full_contact_pressure() {
    let closing = 2f64.sqrt() * PI * 100e9 * 1e-3;
    let full = pressed_wave(32, 1.0 + 1e-6, PeriodicKernel::Spectral).unwrap();
    assert_eq!(full.contact_fraction, 1.0);
    let (gap, _) = double_wave(32);
    for (p, h) in full.pressure.iter().zip(&gap) {
        assert!((p / closing - (2.0 - h / 1e-6)).abs() < 1e-5, "{p} {h}");
    }
    let open = pressed_wave(32, 1.0 - 1e-2, PeriodicKernel::Spectral).unwrap();
    assert!(open.contact_fraction < 1.0);
    // First touch: a share π·(3·p̄/(8π·p*))^⅔ in contact, on caps of spheres with one and a half of its mean pressure; last
    // holes: a share 3·(1 − p̄/p*)/(2π) of the plane, here 70 cells each.
    for kernel in [PeriodicKernel::Strip, PeriodicKernel::Spectral] {
        let touching = PI * (0.012 / (8.0 * PI)).powf(2.0 / 3.0);
        let peak = pressed_wave(128, 0.004, kernel).unwrap().max_pressure.si() / closing;
        assert!((peak * touching / 0.006 - 1.0).abs() < 5e-3, "{peak}");
        let open = 1.0 - pressed_wave(128, 0.98, kernel).unwrap().contact_fraction;
        // The law is the first order of 1 - p̄/p*; 42 of 156 open cells lie on the edges of both holes, of which half count: 13 %.
        assert!((open * 2.0 * PI / 0.06 - 1.0).abs() < 0.15, "{open}");
    }
}

#[test]
fn the_work_of_the_load_is_the_elastic_energy() {
    let mean = |found: &ContactSolution| found.gap.iter().sum::<f64>() / found.gap.len() as f64;
    let mut work = 0.0;
    let states =
        [0.1, 0.11, 0.12].map(|share| pressed_wave(64, share, PeriodicKernel::Strip).unwrap());
    for pair in states.windows(2) {
        work += 0.5 * (pair[0].load.si() + pair[1].load.si()) * (mean(&pair[0]) - mean(&pair[1]));
    }
    let energy = states[2].elastic_energy.si() - states[0].elastic_energy.si();
    assert!((work / energy - 1.0).abs() < 1e-3);
}

#[test]
fn transforms_and_the_dense_matrix_give_the_same_patch() {
    let (gap, spacing) = rough_patch([96, 24]);
    for (boundary, limit) in [
        (Boundary::FreeEnds, None),
        (Boundary::FreeEnds, Some(Pressure::from_si(2.5e9))),
        (Boundary::Periodic(PeriodicKernel::Strip), None),
    ] {
        let problem = ContactProblem {
            boundary,
            pressure_limit: limit,
            lead: lead(24, spacing * 0.7),
            ..ContactProblem::new(&gap, spacing, CYLINDER.modulus, CYLINDER.load * 0.5)
        };
        let found = solve(&problem, &tight()).unwrap();
        let started = ContactProblem {
            start: Some(&found.pressure),
            ..problem
        };
        let dense = solve_dense(&started).unwrap();
        let difference = relative_difference(&found.pressure, &dense.pressure);
        assert!(difference < 1e-7, "{boundary}: {difference:e}");
        assert!((found.approach / dense.approach - 1.0).abs() < 1e-9);
        let most = limit.map_or(f64::INFINITY, Pressure::si);
        assert!(found.pressure.iter().all(|p| (0.0..=most).contains(p)));
        assert_eq!(limit.is_some(), found.dissipated.si() > 0.0);
        // From another load without the window: the same contact.
        let other = found.pressure.iter().map(|p| 0.8 * p).collect::<Vec<_>>();
        let again = ContactProblem {
            start: Some(&other),
            ..problem
        };
        let settings = SolverSettings {
            window: false,
            ..tight()
        };
        let again = solve(&again, &settings).unwrap();
        assert!(relative_difference(&again.pressure, &found.pressure) < 1e-7);
        // The load of the approach is the load that has it.
        let approach = Control::Approach {
            approach: found.approach,
            datum: spacing * 192.0,
        };
        let held = solve(
            &ContactProblem {
                control: approach,
                ..problem
            },
            &tight(),
        )
        .unwrap();
        assert!(
            (held.load / CYLINDER.load - 0.5).abs() < 1e-9,
            "{boundary}: {}",
            held.load
        );
    }
}

#[test]
fn a_patch_with_broken_rows_is_refused() {
    let gap = [1e-6; 12];
    let problem = |rows: usize, spacing: f64| ContactProblem {
        lead: lead(rows, Length::from_si(spacing)),
        ..ContactProblem::new(&gap, Length::from_si(1e-6), CYLINDER.modulus, CYLINDER.load)
    };
    for (rows, spacing, says) in [
        (5, 1e-6, "must divide"),
        (0, 1e-6, "must divide"),
        (3, 0.0, "spacing along the lead"),
        (12, 1e-6, "too few"),
    ] {
        let error = solve(&problem(rows, spacing), &SolverSettings::default()).unwrap_err();
        assert!(error.to_string().contains(says), "{error}");
    }
    let mut line = Solver::new(12, Boundary::FreeEnds).unwrap();
    let error = line
        .solve(&problem(3, 1e-6), &SolverSettings::default())
        .unwrap_err();
    assert!(error.to_string().contains("12 points in 3 rows"), "{error}");
    let spacing = Length::from_si(1e-6);
    let found = line.displacement(
        spacing,
        lead(3, spacing),
        CYLINDER.modulus,
        &gap,
        &mut [0.0; 12],
    );
    assert!(found.is_err());
}
