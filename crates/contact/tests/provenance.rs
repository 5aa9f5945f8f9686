//! Tags of the equations that a solution rests on.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

use std::collections::BTreeSet;

use crate::common::{hertz_problem, periodic_problem, rough_gap};
use asperity_contact::{Boundary, ContactProblem, PeriodicKernel, Solver, SolverSettings};
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Pressure;

fn tags(solver: &mut Solver, problem: &ContactProblem) -> BTreeSet<&'static str> {
    let used = Provenance::new();
    used.collect(|| solver.solve(problem, &SolverSettings::default()).unwrap());
    used.tags()
}

#[test]
fn a_solution_names_the_equations_that_it_rests_on_and_no_other() {
    // Enough points touch that the sets are iterated; those of its coarsest grid are exact.
    let (gap, spacing) = rough_gap(2_000);
    let elastic = hertz_problem(&gap, spacing);
    let mut solver = Solver::new(gap.len(), elastic.boundary).unwrap();
    let first = tags(&mut solver, &elastic);
    let expected = [
        "Active-1",
        "Datum-1",
        "Deflation-1",
        "Duality-1",
        "Gap-deformed",
        "P1",
        "P2",
        "P3",
        "P4",
        "Patch-1",
    ];
    assert_eq!(first, BTreeSet::from(expected));
    // Kept operators rest on the kernel as new ones do.
    assert_eq!(tags(&mut solver, &elastic), first);
    let flowing = ContactProblem {
        pressure_limit: Some(Pressure::from_si(4e9)),
        ..elastic
    };
    let more: Vec<_> = tags(&mut solver, &flowing)
        .difference(&first)
        .copied()
        .collect();
    assert_eq!(more, ["Plastic-1", "Plastic-2"]);
}

#[test]
fn a_periodic_solution_names_its_own_kernel() {
    let (gap, spacing) = crate::common::rough_wave(512);
    for (kernel, tag, other) in [
        (PeriodicKernel::Strip, "Periodic-1", "Periodic-2"),
        (PeriodicKernel::Spectral, "Periodic-2", "Periodic-1"),
    ] {
        let problem = periodic_problem(&gap, spacing, kernel);
        let mut solver = Solver::new(gap.len(), Boundary::Periodic(kernel)).unwrap();
        for _ in 0..2 {
            let found = tags(&mut solver, &problem);
            assert!(found.contains(tag), "{found:?}");
            assert!(!found.contains(other) && !found.contains("P2") && !found.contains("Datum-1"));
        }
    }
}
