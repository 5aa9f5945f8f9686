//! Contacts of few touching points, solved by exact sets instead of iterations.
//!
//! A rough contact of a thousand points touches at a few dozen of them. To factor their matrix three to five times costs a third of
//! eight to eleven iterations with their transforms, and leaves no error but round-off.

use super::workspace::{Task, Workspace};
use crate::boundary::Boundary;
use crate::exact_sets::{ExactSets, Matrix, SetProblem, State};
use crate::grid::LARGE_GRID;
use crate::strip_kernel::strip_column;

/// Most touching points (own choice): a factor of n points costs n³/6 products.
const MOST_POINTS: usize = 96;
/// Sets after which the iterations take over. From a coarser solution or another load three to five suffice.
const MOST_SETS: usize = 20;
/// Points that touch first where the start is uniform pressure: the lowest (own choice).
const LOWEST: usize = 16;

/// Matrix and sets, whose memory serves contact after contact.
#[derive(Default)]
pub(crate) struct FewPoints {
    /// Of the largest grid so far.
    matrix: Matrix,
    sets: ExactSets,
}

impl FewPoints {
    /// Sets of the start `pressure`; false if too many points touch.
    fn begin(&mut self, pressure: &[f64], task: &Task) -> bool {
        let states = &mut self.sets.states;
        states.clear();
        states.extend(
            pressure
                .iter()
                .map(|p| State::from_pressure(*p, task.limit)),
        );
        let touching = states.iter().filter(|state| **state != State::Apart);
        let touching = touching.count();
        if touching == states.len() && touching > LOWEST {
            let mut places: Vec<usize> = (0..touching).collect();
            places.select_nth_unstable_by(LOWEST, |i, j| task.gap[*i].total_cmp(&task.gap[*j]));
            states.fill(State::Apart);
            for place in &places[..LOWEST] {
                states[*place] = State::Touching;
            }
            return true;
        }
        touching <= MOST_POINTS
    }

    /// Solves the contact of a line with free ends under a load, and leaves its pressure and opening in the workspace. Returns the
    /// number of sets; `None`, with the pressure as it was, for another contact, or one of too many points.
    pub(crate) fn solve(
        &mut self,
        boundary: Boundary,
        work: &mut Workspace,
        task: &Task,
    ) -> Option<usize> {
        let (Boundary::FreeEnds, Some(sum)) = (boundary, task.sum) else {
            return None;
        };
        let columns = task.columns;
        // The memory of a large grid is bounded.
        if columns > LARGE_GRID || !self.begin(&work.pressure, task) {
            return None;
        }
        if self.matrix.columns() < columns {
            self.matrix = Matrix::from_kernel(&strip_column(columns), columns);
        }
        let settled = self.sets.settle(&SetProblem {
            matrix: &self.matrix,
            gap: task.gap,
            columns,
            // The displacement is positive at every point then.
            constant: -self.matrix.lag(columns - 1),
            sum: Some(sum * task.compliance),
            limit: task.limit * task.compliance,
            range: task.reference_bounds.most,
            most: [MOST_POINTS, MOST_SETS],
        });
        let sets = settled.ok()?.steps;
        work.pressure.clear();
        let pressures = self.sets.pressures(task.limit, task.compliance);
        work.pressure.extend(pressures);
        work.opening.clear();
        let displaced = self.sets.displaced.iter().zip(task.gap);
        work.opening.extend(displaced.map(|(u, h)| u + h));
        work.list_loaded();
        Some(sets)
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::quantity::{Length, LineLoad, Pressure};

    use super::super::discrete_problem::DiscreteProblem;
    use super::super::operators::Levels;
    use super::*;
    use crate::grid::LineGrid;
    use crate::problem::{ContactProblem, SolverSettings};

    /// A cylinder of 5 mm radius with four waves of 0.1 um.
    fn rough_gap(points: usize) -> Vec<f64> {
        let gap = |i: usize| {
            let x = 1e-6 * (i as f64 - 0.5 * (points as f64 - 1.0));
            let waves = [(7.3e-6, 0.1), (19e-6, 1.2), (43e-6, 0.3), (111e-6, 2.0)];
            let rough =
                waves.map(|(length, phase)| (std::f64::consts::TAU * x / length + phase).sin());
            x * x / 1e-2 + 0.1e-6 * rough.iter().sum::<f64>()
        };
        (0..points).map(gap).collect()
    }

    #[test]
    fn exact_sets_and_iterations_find_the_same_pressure() {
        let gap = rough_gap(600);
        for limit in [None, Some(Pressure::from_si(1.5e9))] {
            let (spacing, modulus) = (Length::from_si(1e-6), Pressure::from_si(115e9));
            let problem = ContactProblem {
                pressure_limit: limit,
                ..ContactProblem::new(&gap, spacing, modulus, LineLoad::from_si(60e3))
            };
            let settings = SolverSettings {
                tolerance: 1e-13,
                ..SolverSettings::default()
            };
            let discrete = DiscreteProblem::new(&problem, |_, _| &mut []).unwrap();
            let task = discrete.task(&gap, gap.len(), &settings, 10_000);
            let start = vec![discrete.even_pressure(); gap.len()];
            let [mut few, mut iterated] = [(); 2].map(|()| Workspace {
                pressure: start.clone(),
                ..Workspace::default()
            });
            let sets = FewPoints::default()
                .solve(problem.boundary, &mut few, &task)
                .unwrap();
            assert!((2..MOST_SETS).contains(&sets));
            let mut levels = Levels::<LineGrid>::default();
            let work = (&mut iterated, &task);
            levels
                .iterate(discrete.cells, problem.boundary, work)
                .unwrap();
            let most = few.pressure.iter().fold(0.0, |m: f64, p| m.max(*p));
            assert_eq!(limit.is_some(), limit == Some(Pressure::from_si(most)));
            for (p, q) in few.pressure.iter().zip(&iterated.pressure) {
                assert!((p - q).abs() < 1e-6 * most, "{p} {q}");
            }
            let range = task.reference_bounds.most;
            for (v, w) in few.opening.iter().zip(&iterated.opening) {
                assert!((v - w).abs() < 1e-9 * range, "{v} {w}");
            }
        }
    }

    #[test]
    fn contacts_of_many_points_and_of_periods_are_left_to_the_iterations() {
        let gap = vec![0.0; 400];
        let load = LineLoad::from_si(60e3);
        let problem =
            ContactProblem::new(&gap, Length::from_si(1e-6), Pressure::from_si(115e9), load);
        let discrete = DiscreteProblem::new(&problem, |_, _| &mut []).unwrap();
        let task = discrete.whole_task(&SolverSettings::default());
        let mut work = Workspace {
            pressure: vec![discrete.even_pressure(); gap.len()],
            ..Workspace::default()
        };
        let start = work.pressure.clone();
        for boundary in [
            Boundary::FreeEnds,
            Boundary::Periodic(crate::PeriodicKernel::Strip),
        ] {
            let found = FewPoints::default().solve(boundary, &mut work, &task);
            assert_eq!(found, None);
        }
        assert_eq!(work.pressure, start);
    }
}
