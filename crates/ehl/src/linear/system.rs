//! The linearised balances and the interface of their solvers.

use crate::bands::Bands;

/// Linearised balances: film·(K·p + h₀) + pressure·p + void·θ on the nodes, Σ w·p below.
///
/// The unknown of a node is its pressure, of a cavitated one its void fraction; the last unknown is
/// the rigid approach h₀.
pub(crate) struct Linearised<'a> {
    /// Slopes over the film.
    pub(crate) film: &'a Bands,
    /// Slopes over the unknown of each node.
    pub(crate) local: &'a Bands,
    /// Nodes whose unknown is the void fraction or the depth of flow, so that their pressure stays.
    pub(crate) masked: &'a [bool],
    /// Weights of the load.
    pub(crate) weights: &'a [f64],
    /// Whether storage of oil dominates the balances.
    pub(crate) transient: bool,
}

/// Effort of an iterative solution.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct LinearEffort {
    pub(crate) iterations: usize,
    /// Whether the iterations ended at their cap.
    pub(crate) capped: bool,
}

/// Elastic half-planes on a grid, and solutions of the linearised balances with them.
pub(crate) trait ElasticSystem {
    /// Writes the displacement by `pressure`.
    fn displacement(&mut self, pressure: &[f64], output: &mut [f64]);

    /// Solves the linearised balances for `right`, to a residual of `tolerance` times `right`.
    fn solve(
        &mut self,
        system: &Linearised,
        right: &[f64],
        solution: &mut [f64],
        tolerance: f64,
    ) -> LinearEffort;
}
