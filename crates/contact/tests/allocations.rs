//! The iteration needs no memory.
#![allow(clippy::unwrap_used, reason = "a test that cannot set up has failed")]

mod common;

use allocation_counter::measure;
use asperity_contact::{ContactProblem, Solver, SolverSettings};
use common::peers::Peer;

#[test]
fn more_iterations_make_no_more_allocations() {
    for name in ["c", "cf", "d", "e"] {
        let peer = Peer::new(name, 4_096).unwrap();
        let problem = peer.problem();
        let settings = |tolerance| SolverSettings {
            tolerance,
            cascade: false,
            window: false,
            ..SolverSettings::default()
        };
        let mut solver = Solver::new(4_096, problem.boundary).unwrap();
        // The first solution plans and makes the buffers.
        solver.solve(&problem, &settings(1e-4)).unwrap();
        let mut count = |problem: &ContactProblem, tolerance| {
            let mut iterations = 0;
            let allocations = measure(|| {
                iterations = solver
                    .solve(problem, &settings(tolerance))
                    .unwrap()
                    .iterations;
            });
            (iterations, allocations.count_total)
        };
        let (few, allocated) = count(&problem, 1e-4);
        let (many, again) = count(&problem, 1e-12);
        assert!(many > few + 20, "{name}: {few} {many}");
        assert_eq!(allocated, again, "{name}");
    }
}
