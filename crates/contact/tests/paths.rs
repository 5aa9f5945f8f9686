//! Paths of contacts, many at once, and running-in.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use crate::common::{CYLINDER, hertz_problem, relative_difference, rough_gap, self_affine, tight};
use asperity_contact::running_in::{Cycle, RunningIn};
use asperity_contact::two_flanks::TwoFlanks;
use asperity_contact::{
    Boundary, ContactError, ContactProblem, Control, Path, SolverSettings, solve,
};
use asperity_core::Profile;
use asperity_core::quantity::Pressure;

/// The flanks of the composite gap of [`rough_gap`].
fn rough_flanks(points: usize) -> [Profile; 2] {
    let spacing = CYLINDER.window / points as f64;
    let x: Vec<f64> = (0..points)
        .map(|i| (i as f64 + 0.5) / points as f64)
        .collect();
    let power: f64 = (6..=300).map(|k| 0.5 * f64::from(k).powf(-2.6)).sum();
    let amplitude = 0.4e-6 / (2.0 * power).sqrt();
    [11, 22].map(|seed| {
        let heights = self_affine(&x, 6..=300, seed);
        Profile::new(spacing, heights.iter().map(|z| amplitude * z).collect()).unwrap()
    })
}

fn pair<'a>(flanks: &'a [Profile; 2]) -> TwoFlanks<'a> {
    TwoFlanks {
        first: &flanks[0],
        second: &flanks[1],
        radius: CYLINDER.radius,
        load: CYLINDER.load,
        modulus: CYLINDER.modulus,
        pressure_limit: Some(Pressure::from_si(4e9)),
    }
}

#[test]
fn a_path_of_loads_gives_the_contacts_of_each_load_with_fewer_iterations() {
    let (gap, spacing) = rough_gap(4_000);
    let problem = |share: f64| ContactProblem {
        control: Control::Load(CYLINDER.load * share),
        ..hertz_problem(&gap, spacing)
    };
    let mut path = Path::new(4_000, Boundary::FreeEnds, tight()).unwrap();
    let (mut along, mut alone) = (0, 0);
    for step in 0..8 {
        let problem = problem(0.7 + 0.05 * f64::from(step));
        let warm = path.step(&problem).unwrap();
        let cold = solve(
            &problem,
            &SolverSettings {
                cascade: false,
                ..tight()
            },
        )
        .unwrap();
        // Single pressures are right to about a thousand times the tolerance of 1e-12.
        assert!(relative_difference(&warm.pressure, &cold.pressure) < 1e-8);
        if step > 1 {
            along += warm.iterations;
            alone += cold.iterations;
        }
    }
    assert!(along < alone, "{along} {alone}");
}

#[test]
fn a_shifted_start_is_the_solution_of_the_shifted_roughness() {
    let (gap, spacing) = rough_gap(2_000);
    let mut path = Path::new(2_000, Boundary::FreeEnds, tight()).unwrap();
    let first = path.step(&hertz_problem(&gap, spacing)).unwrap();
    let mut moved = gap.clone();
    moved.rotate_right(40);
    path.shift(40);
    let second = path.step(&hertz_problem(&moved, spacing)).unwrap();
    assert!(second.iterations <= 1, "{}", second.iterations);
    assert_eq!(first.contact_fraction, second.contact_fraction);
}

#[test]
fn a_path_refuses_another_size_and_a_problem_outside_its_domain() {
    let (gap, spacing) = CYLINDER.gap(200);
    let good = hertz_problem(&gap, spacing);
    let bad = ContactProblem {
        modulus: Pressure::from_si(-1.0),
        ..good
    };
    let other_size = ContactProblem {
        gap: &gap[..100],
        ..good
    };
    let mut path = Path::new(200, Boundary::FreeEnds, SolverSettings::default()).unwrap();
    assert!(path.step(&good).is_ok());
    assert!(matches!(path.step(&bad), Err(ContactError::Domain(_))));
    let said = path.step(&other_size).unwrap_err().to_string();
    assert!(
        said.starts_with("the solver was made for 200 points"),
        "{said}"
    );
}

#[test]
fn flanks_run_in_as_an_independent_program_has_it() {
    let flanks = rough_flanks(2_000);
    let settings = SolverSettings {
        tolerance: 1e-10,
        ..SolverSettings::default()
    };
    let ran_in = RunningIn::evenly(2_000, 8)
        .unwrap()
        .run(&pair(&flanks), &settings)
        .unwrap();
    // Energy, largest flow, contact and Rq of three cycles from an active set in another language.
    let expected = [
        (
            0,
            0.164_423_23,
            5.060_795_6e-7,
            0.151_187_5,
            0.263_708_43e-6,
            0.243_265_88e-6,
        ),
        (
            1,
            0.017_994_902,
            1.058_337_9e-7,
            0.167_562_5,
            0.263_169_61e-6,
            0.239_492_28e-6,
        ),
        (
            5,
            0.000_136_837_81,
            1.123_439_4e-9,
            0.173_812_5,
            0.263_197_87e-6,
            0.238_411_65e-6,
        ),
    ];
    for (cycle, energy, flow, fraction, first, second) in expected {
        let found = &ran_in.cycles[cycle];
        let close = |value: f64, expected: f64, tolerance: f64| {
            assert!(
                (value / expected - 1.0).abs() < tolerance,
                "{cycle}: {value:e} {expected:e}"
            );
        };
        // Eight digits are known; later cycles are small differences of earlier ones.
        let tolerance = 1e-6 * 0.164 / energy;
        close(found.dissipated.si(), energy, tolerance);
        close(found.largest_flow.si(), flow, tolerance);
        close(found.contact_fraction, fraction, 1e-9);
        close(found.rq[0].si(), first, 1e-7);
        close(found.rq[1].si(), second, 1e-7);
    }
}

#[test]
fn whoever_watches_running_in_sees_every_cycle_and_its_flanks() {
    let flanks = rough_flanks(1_000);
    let mut seen = vec![];
    let watch = |cycle: &Cycle, flanks: &[Profile; 2]| seen.push((cycle.clone(), flanks.clone()));
    let ran_in = RunningIn::evenly(1_000, 4)
        .unwrap()
        .run_watched(&pair(&flanks), &SolverSettings::default(), watch)
        .unwrap();
    let cycles: Vec<_> = seen.iter().map(|(cycle, _)| cycle.clone()).collect();
    assert_eq!(cycles, ran_in.cycles);
    let worn: Vec<_> = seen.into_iter().map(|(_, flanks)| flanks).collect();
    assert_eq!(worn[worn.len() - 1], ran_in.flanks);
    let all: Vec<_> = std::iter::once(&flanks).chain(&worn).collect();
    for cycle in all.windows(2) {
        for (before, after) in cycle[0].iter().zip(cycle[1]) {
            let pairs = before.heights().iter().zip(after.heights());
            assert!(pairs.clone().all(|(before, after)| after <= before));
        }
    }
}

#[test]
fn the_energy_of_running_in_decays_until_shakedown() {
    let flanks = rough_flanks(1_000);
    let settings = SolverSettings {
        tolerance: 1e-11,
        ..SolverSettings::default()
    };
    let ran_in = RunningIn::evenly(1_000, 4)
        .unwrap()
        .run(&pair(&flanks), &settings)
        .unwrap();
    let energies: Vec<f64> = ran_in
        .cycles
        .iter()
        .map(|cycle| cycle.dissipated.si())
        .collect();
    assert!(
        energies.windows(2).all(|pair| pair[1] < pair[0]),
        "{energies:?}"
    );
    let (first, last) = (energies[0], energies[energies.len() - 1]);
    assert!(last <= 1e-6 * first && energies.len() > 5);
    let (start, end) = (&ran_in.cycles[0], &ran_in.cycles[energies.len() - 1]);
    assert!(end.contact_fraction >= start.contact_fraction);
}

#[test]
fn running_in_is_refused_where_nothing_can_flow() {
    let flanks = rough_flanks(300);
    let good = RunningIn::evenly(300, 2).unwrap();
    for passes in [0, 301, usize::MAX] {
        assert!(RunningIn::evenly(300, passes).is_err());
    }
    let settings = SolverSettings::default();
    let elastic = TwoFlanks {
        pressure_limit: None,
        ..pair(&flanks)
    };
    let refused = good.run(&elastic, &settings).unwrap_err();
    assert!(refused.to_string().contains("give a pressure limit"));
    let changed = |change: fn(&mut RunningIn)| {
        let mut running_in = good.clone();
        change(&mut running_in);
        running_in
            .run(&pair(&flanks), &settings)
            .unwrap_err()
            .to_string()
    };
    assert!(changed(|r| r.shifts.clear()).contains("number of shifts"));
    assert!(changed(|r| r.shares = [0.7, 0.7]).contains("share"));
    assert!(changed(|r| r.shakedown = 0.0).contains("shakedown"));
    assert!(changed(|r| r.max_cycles = 2).contains("after 2 cycles"));
}
