//! Evidence that comes with a solution.

use serde::Serialize;

use crate::grid::FilmGrid;
use crate::newton::{NodeState, Solution};

/// A solution with what shows that it is one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Solved<T> {
    /// The solution.
    pub value: T,
    /// Measured values and effort.
    pub evidence: Evidence,
}

/// Residuals of a solution and its iterations; of a record, the largest residuals of its steps.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize)]
pub struct Evidence {
    /// |∫P dX − π/2|·2/π.
    pub load_error: f64,
    /// Largest violation of a node's conditions: the balance of full and cavitated nodes over the
    /// mean flux, the film of contact nodes minus the boundary film over a²/R.
    pub complementarity: f64,
    /// Oil that full and cavitated nodes gain or lose: |sum of their balances| over the mean flux.
    pub mass_balance: f64,
    /// Mean of `mass_balance` over the time steps.
    pub mean_mass_balance: f64,
    /// Oil that contact nodes supply, over the mean flux.
    pub boundary_supply: f64,
    /// Mean of `boundary_supply` over the time steps.
    pub mean_boundary_supply: f64,
    /// Newton iterations, of all grids or steps together.
    pub newton_iterations: usize,
    /// GMRES iterations of all Newton iterations together.
    pub gmres_iterations: usize,
    /// Linear systems of converged steps that ended at the cap of their iterations.
    pub gmres_capped: usize,
    /// Time steps taken.
    pub steps: usize,
    /// Time steps that were repeated at half their length.
    pub steps_cut: usize,
    /// Time steps with one or two nodes that are too thin when full and swallow oil in contact, held in
    /// contact. The iteration is converged; the oil they swallow is part of `complementarity`.
    pub loose_steps: usize,
}

impl Evidence {
    /// Residuals of one solution.
    pub(crate) fn new(grid: &FilmGrid, solution: &Solution, contact_film: f64) -> Self {
        let sum: f64 = solution.flux.iter().map(|f| f.abs()).sum();
        let flux = (sum / solution.flux.len() as f64).max(f64::MIN_POSITIVE);
        let mut evidence = Self {
            load_error: (grid.integral(&solution.unknowns.pressure) / std::f64::consts::FRAC_PI_2
                - 1.0)
                .abs(),
            newton_iterations: solution.effort.iterations,
            gmres_iterations: solution.effort.linear_iterations,
            gmres_capped: solution.effort.capped,
            loose_steps: usize::from(solution.effort.loose),
            ..Self::default()
        };
        let mut sum = 0.0;
        for (i, balance) in solution.balance.iter().enumerate() {
            let violation = if solution.unknowns.state[i] == NodeState::Contact {
                evidence.boundary_supply += balance / flux;
                (solution.film[i] - contact_film).abs().max(-balance / flux)
            } else {
                sum += balance / flux;
                balance.abs() / flux
            };
            evidence.complementarity = evidence.complementarity.max(violation);
        }
        evidence.mass_balance = sum.abs();
        evidence.mean_mass_balance = evidence.mass_balance;
        evidence.mean_boundary_supply = evidence.boundary_supply;
        evidence
    }

    /// Work, worst residuals and means over the time steps of this and `other`, which has at least one step.
    pub(crate) fn join(&mut self, other: &Self) {
        let part = other.steps as f64 / (self.steps + other.steps) as f64;
        let mean = |mine: f64, others: f64| mine + part * (others - mine);
        self.mean_mass_balance = mean(self.mean_mass_balance, other.mean_mass_balance);
        self.mean_boundary_supply = mean(self.mean_boundary_supply, other.mean_boundary_supply);
        self.load_error = self.load_error.max(other.load_error);
        self.complementarity = self.complementarity.max(other.complementarity);
        self.mass_balance = self.mass_balance.max(other.mass_balance);
        self.boundary_supply = self.boundary_supply.max(other.boundary_supply);
        self.newton_iterations += other.newton_iterations;
        self.gmres_iterations += other.gmres_iterations;
        self.gmres_capped += other.gmres_capped;
        self.steps += other.steps;
        self.steps_cut += other.steps_cut;
        self.loose_steps += other.loose_steps;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_over_the_steps_are_weighted_with_their_number() {
        let evidence = |steps, balance: f64| Evidence {
            steps,
            mass_balance: 2.0 * balance,
            mean_mass_balance: balance,
            mean_boundary_supply: 10.0 * balance,
            ..Evidence::default()
        };
        // The smooth start is no step.
        let mut record = evidence(0, 0.7);
        record.join(&evidence(1, 0.1));
        assert!((record.mean_mass_balance - 0.1).abs() < 1e-15);
        record.join(&evidence(3, 0.5));
        assert!((record.mean_mass_balance - 0.4).abs() < 1e-15);
        assert!((record.mean_boundary_supply - 4.0).abs() < 1e-14);
        assert_eq!((record.steps, record.mass_balance), (4, 1.4));
    }
}
