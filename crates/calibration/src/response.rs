//! Response surface: a quadratic function of few variables that replaces the model and is exact along the axes.
//!
//! The function f on a box with centre c and half widths w, u_j = (y_j − c_j)/w_j:
//!
//! ```text
//! f = f₀ + Σ g_j u_j + ½ Σ h_jj u_j² + Σ_{i<j} h_ij u_i u_j
//! ```
//!
//! from 1 + 2 n + n (n − 1)/2 evaluations: the centre, both ends of every axis, one corner of every pair of axes.

use asperity_core::numerics::dot;

/// Box in which a surface replaces the model.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Centre.
    pub centre: Vec<f64>,
    /// Half width along every axis.
    pub half_width: Vec<f64>,
}

/// Quadratic surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Response {
    value: f64,
    slope: Vec<f64>,
    /// Full matrix of second derivatives.
    curvature: Vec<Vec<f64>>,
}

impl Region {
    /// Points at which a function is evaluated for its surface.
    #[must_use]
    pub fn settings(&self) -> Vec<Vec<f64>> {
        let n = self.centre.len();
        let moved = |moves: &[(usize, f64)]| {
            let mut at = self.centre.clone();
            for (axis, by) in moves {
                at[*axis] += by * self.half_width[*axis];
            }
            at
        };
        let mut settings = vec![moved(&[])];
        for axis in 0..n {
            settings.extend([moved(&[(axis, 1.0)]), moved(&[(axis, -1.0)])]);
        }
        for i in 0..n {
            settings.extend((i + 1..n).map(|j| moved(&[(i, 1.0), (j, 1.0)])));
        }
        settings
    }

    /// Points at which a function is evaluated for its [`tangent`](Response::tangent): the centre and the upper end of
    /// every axis.
    #[must_use]
    pub(crate) fn forward_settings(&self) -> Vec<Vec<f64>> {
        let n = self.centre.len();
        let all = self.settings();
        let upper = (0..n).map(|axis| all[1 + 2 * axis].clone());
        std::iter::once(self.centre.clone()).chain(upper).collect()
    }

    /// Normalised coordinates of `at`: −1 to 1 along every axis of the box.
    #[must_use]
    pub fn normalised(&self, at: &[f64]) -> Vec<f64> {
        let axes = at.iter().zip(&self.centre).zip(&self.half_width);
        axes.map(|((value, centre), width)| (value - centre) / width)
            .collect()
    }
}

impl Response {
    /// The surface through `values` at the [`settings`](Region::settings) of a box with `axes` axes.
    ///
    /// ```
    /// use asperity_calibration::response::{Region, Response};
    /// let region = Region { centre: vec![1.0, 2.0], half_width: vec![0.5, 0.1] };
    /// let f = |y: &[f64]| 3.0 + y[0] * y[0] - 2.0 * y[0] * y[1] + 0.25 * y[1];
    /// let values: Vec<f64> = region.settings().iter().map(|y| f(y)).collect();
    /// let surface = Response::through(2, &values);
    /// let at = [1.3, 1.95];
    /// let (value, slope) = surface.at(&region.normalised(&at));
    /// assert!((value - f(&at)).abs() < 1e-12);
    /// // The slope is per half-width.
    /// assert!((slope[0] - 0.5 * (2.0 * at[0] - 2.0 * at[1])).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn through(axes: usize, values: &[f64]) -> Self {
        let value = values[0];
        let ends: Vec<[f64; 2]> = (0..axes)
            .map(|j| [values[1 + 2 * j], values[2 + 2 * j]])
            .collect();
        let mut curvature = vec![vec![0.0; axes]; axes];
        for (j, [up, down]) in ends.iter().enumerate() {
            curvature[j][j] = up + down - 2.0 * value;
        }
        let mut corner = 1 + 2 * axes;
        for i in 0..axes {
            for j in i + 1..axes {
                let mixed = values[corner] - ends[i][0] - ends[j][0] + value;
                (curvature[i][j], curvature[j][i]) = (mixed, mixed);
                corner += 1;
            }
        }
        let slope = ends.iter().map(|[up, down]| 0.5 * (up - down)).collect();
        Self {
            value,
            slope,
            curvature,
        }
    }

    /// The plane through `values` at the `forward_settings` of a box.
    #[must_use]
    pub fn tangent(axes: usize, values: &[f64]) -> Self {
        Self {
            value: values[0],
            slope: (0..axes).map(|axis| values[1 + axis] - values[0]).collect(),
            curvature: vec![vec![0.0; axes]; axes],
        }
    }

    /// Value and slope at normalised coordinates.
    #[must_use]
    pub fn at(&self, u: &[f64]) -> (f64, Vec<f64>) {
        let (mut value, mut slope) = (self.value, self.slope.clone());
        for ((g, row), along) in slope.iter_mut().zip(&self.curvature).zip(u) {
            let bent = dot(row, u);
            value += (*g + 0.5 * bent) * along;
            *g += bent;
        }
        (value, slope)
    }
}
