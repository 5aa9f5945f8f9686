//! Contacts of many patches take as few iterations as those of few.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use crate::common::peers::Peer;
use asperity_contact::{ContactProblem, Control, Solver, SolverSettings, solve};

#[test]
fn iterations_grow_neither_with_the_grid_nor_with_the_patches() {
    // Roughness down to eight cells: 390 patches at the largest size. Without a coarse space of
    // patches the counts were 30, 54 and 109.
    for points in [4_096, 16_384, 65_536] {
        let peer = Peer::new("cf", points).unwrap();
        let solution = solve(&peer.problem(), &SolverSettings::default()).unwrap();
        assert!(
            (6..=16).contains(&solution.iterations),
            "{points} points: {} iterations",
            solution.iterations
        );
    }
}

#[test]
fn a_start_from_a_lighter_load_settles_though_its_first_sets_are_worse() {
    let peer = Peer::new("cf", 65_536).unwrap();
    let problem = peer.problem();
    let Control::Load(load) = problem.control else {
        panic!("the case has a load");
    };
    let lighter = ContactProblem {
        control: Control::Load(load * 0.95),
        ..problem
    };
    let start = solve(&lighter, &SolverSettings::default())
        .unwrap()
        .pressure;
    let neighbour = ContactProblem {
        start: Some(&start),
        ..problem
    };
    let solution = solve(&neighbour, &SolverSettings::default()).unwrap();
    assert!(solution.iterations <= 25, "{}", solution.iterations);
}

#[test]
fn a_contact_of_many_patches_does_not_depend_on_the_start() {
    let peer = Peer::new("cf", 4_096).unwrap();
    let settings = SolverSettings {
        tolerance: 1e-13,
        ..SolverSettings::default()
    };
    let whole = solve(&peer.problem(), &settings).unwrap();
    // From an even pressure the sets begin far from those of the coarser grids.
    let cold = SolverSettings {
        cascade: false,
        ..settings
    };
    let even = solve(&peer.problem(), &cold).unwrap();
    let largest = whole.max_pressure.si();
    for (one, other) in whole.pressure.iter().zip(&even.pressure) {
        assert!((one - other).abs() < 1e-9 * largest);
    }
}

#[test]
fn what_a_solver_solved_before_does_not_show() {
    let peer = Peer::new("cf", 4_096).unwrap();
    let (whole, settings) = (peer.problem(), SolverSettings::default());
    let Control::Load(load) = whole.control else {
        panic!("the case has a load");
    };
    let at = |share: f64| ContactProblem {
        control: Control::Load(load * share),
        ..whole
    };
    let solver = || Solver::new(4_096, whole.boundary).unwrap();
    // From its start a contact has no coarser grids, and begins with the patches of the contact before.
    for shares in [[0.02, 0.05], [0.05, 0.2], [0.2, 0.5]] {
        let start = solver().solve(&at(shares[0]), &settings).unwrap().pressure;
        let problem = ContactProblem {
            start: Some(&start),
            ..at(shares[1])
        };
        let fresh = solver().solve(&problem, &settings).unwrap();
        for other in [0.02, 0.1, 1.0] {
            let mut solver = solver();
            solver.solve(&at(other), &settings).unwrap();
            let again = solver.solve(&problem, &settings).unwrap();
            assert_eq!(again.pressure, fresh.pressure, "{shares:?} after {other}");
        }
    }
}
