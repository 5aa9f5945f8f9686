//! Grids of the film: nodes, faces between them, weights of integrals, interpolation to the faces.

use asperity_core::numerics::NodeInterval;

/// Nodes 0..=n with a face after each but the last.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FilmGrid {
    /// Places of the nodes, rising.
    pub(crate) x: Vec<f64>,
    /// Distance across each face.
    pub(crate) spacing: Vec<f64>,
    /// Trapezoidal weights of the nodes.
    pub(crate) weights: Vec<f64>,
    /// Weights of the nodes before, at and after a node for the quadratic at the face after it.
    pub(crate) to_face: Vec<[f64; 3]>,
}

impl FilmGrid {
    /// `cells` equal cells from `inlet` to `outlet`.
    pub(crate) fn uniform(inlet: f64, outlet: f64, cells: usize) -> Self {
        let h = (outlet - inlet) / cells as f64;
        Self::new((0..=cells).map(|i| inlet + h * i as f64).collect())
    }

    /// Grid of the nodes `x`, of which there are at least three.
    pub(crate) fn new(x: Vec<f64>) -> Self {
        let spacing: Vec<f64> = x.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mut weights = vec![0.0; x.len()];
        for (face, h) in spacing.iter().enumerate() {
            weights[face] += 0.5 * h;
            weights[face + 1] += 0.5 * h;
        }
        // The first face has no node before its own: the mean of its two nodes.
        let mut to_face = vec![[0.0, 0.5, 0.5]];
        to_face.extend(x.windows(3).map(quadratic_at_middle));
        // Oil leaves through the last face as it comes: the end node has no balance of its own.
        if let Some(last) = to_face.last_mut() {
            *last = [0.0, 1.0, 0.0];
        }
        Self {
            x,
            spacing,
            weights,
            to_face,
        }
    }

    /// Number of nodes.
    pub(crate) fn nodes(&self) -> usize {
        self.x.len()
    }

    /// Σ weight·value.
    pub(crate) fn integral(&self, values: &[f64]) -> f64 {
        self.weights.iter().zip(values).map(|(w, v)| w * v).sum()
    }

    /// Piecewise linear value at `x` of `values` on the nodes, constant beyond the ends.
    pub(crate) fn interpolate(&self, values: &[f64], x: f64) -> f64 {
        let interval = NodeInterval::from_nodes(&self.x, |node| *node, x);
        interval.held().mean(|node| values[node])
    }
}

/// Lagrange weights of three nodes at the middle of the last two.
fn quadratic_at_middle(nodes: &[f64]) -> [f64; 3] {
    let (a, b, c) = (nodes[0], nodes[1], nodes[2]);
    let x = 0.5 * (b + c);
    [
        (x - b) * (x - c) / ((a - b) * (a - c)),
        (x - a) * (x - c) / ((b - a) * (b - c)),
        (x - a) * (x - b) / ((c - a) * (c - b)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn faces_of_an_even_grid_have_the_weights_of_the_quadratic() {
        let grid = FilmGrid::uniform(-2.0, 1.0, 6);
        for (weight, expected) in grid.to_face[3].iter().zip([-0.125, 0.75, 0.375]) {
            assert!((weight - expected).abs() < 1e-14);
        }
        assert!((grid.integral(&[1.0; 7]) - 3.0).abs() < 1e-14);
        assert_eq!(grid.interpolate(&grid.x, 0.3), 0.3);
    }
}
