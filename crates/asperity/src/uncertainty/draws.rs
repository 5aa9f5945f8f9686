//! The loss of a case at every draw of its parameters.

use std::borrow::Cow;

use crate::case::LoadedCase;
use crate::contacts::Contacts;
use crate::error::Error;
use crate::pipeline::{losses, losses_with};
use crate::result::Losses;

use super::calibrated::calibrated_places;
use super::hypercube::latin_hypercube;
use crate::parameters::{AXES, OnAxis};

/// Draws of the parameters of a case, and the losses at each.
#[derive(Debug, Clone)]
pub(crate) struct Draws {
    /// Places in the ranges, by draw and axis.
    pub places: Vec<Vec<f64>>,
    /// Losses of each draw.
    pub losses: Vec<Losses>,
}

/// Losses of the flanks of `loaded` as measured, with its stored contacts if there are any.
pub(crate) fn evaluated(loaded: &LoadedCase, tables: Option<&Contacts>) -> Result<Losses, Error> {
    let mut loaded = Cow::Borrowed(loaded);
    if loaded.case.model.run_in {
        // No band looks at the flanks run in.
        loaded.to_mut().case.model.run_in = false;
    }
    match tables {
        Some(tables) => losses_with(tables, &loaded),
        None => losses(&loaded),
    }
}

impl Draws {
    /// Evaluates `count` draws of `parameters`, none without parameters; `done` is called after each with their number.
    pub(crate) fn of(
        loaded: &LoadedCase,
        tables: Option<&Contacts>,
        parameters: &[OnAxis],
        count: usize,
        done: &dyn Fn(usize),
    ) -> Result<Self, Error> {
        let count = if parameters.is_empty() { 0 } else { count };
        let places: Vec<Vec<f64>> = latin_hypercube(count, AXES.len())
            .into_iter()
            .map(|place| calibrated_places(loaded, place, parameters))
            .collect();
        let mut drawn = loaded.clone();
        let mut found = Vec::with_capacity(count);
        for place in &places {
            for (axis, ranged) in parameters {
                let value = ranged.at(place[*axis]);
                ranged
                    .kind
                    .set(&mut drawn, value)
                    .map_err(|error| Error::Whole(Box::new(error)))?;
            }
            found.push(evaluated(&drawn, tables)?);
            done(found.len());
        }
        Ok(Self {
            places,
            losses: found,
        })
    }

    /// Change of the loss over each parameter's range, by the plane through all draws (least squares); one per
    /// parameter.
    pub(crate) fn effects(&self, parameters: &[OnAxis]) -> Vec<f64> {
        let n = parameters.len();
        if self.losses.len() <= n {
            return vec![0.0; n];
        }
        let mean_loss = mean(self.losses.iter().map(|drawn| drawn.summary.loss_w));
        let axes = || parameters.iter().map(|(axis, _)| *axis);
        let middles: Vec<f64> = axes()
            .map(|axis| mean(self.places.iter().map(|place| place[axis])))
            .collect();
        let centred: Vec<Vec<f64>> = self
            .places
            .iter()
            .map(|place| axes().zip(&middles).map(|(k, m)| place[k] - m).collect())
            .collect();
        let mut matrix = vec![vec![0.0; n + 1]; n];
        for (row, drawn) in centred.iter().zip(&self.losses) {
            for i in 0..n {
                for j in 0..n {
                    matrix[i][j] += row[i] * row[j];
                }
                matrix[i][n] += row[i] * (drawn.summary.loss_w - mean_loss);
            }
        }
        solved(matrix)
    }
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

/// Solution of a positive definite system with its right side in the last column, by elimination.
fn solved(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let pivot = rows[k].clone();
        for row in rows.iter_mut().skip(k + 1) {
            let factor = row[k] / pivot[k];
            for (value, above) in row.iter_mut().zip(&pivot).skip(k) {
                *value -= factor * above;
            }
        }
    }
    let mut found = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * found[j]).sum();
        found[k] = (rows[k][n] - known) / rows[k][k];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_is_solved() {
        let found = solved(vec![vec![4.0, 1.0, 9.0], vec![1.0, 3.0, 5.0]]);
        assert!((found[0] - 2.0).abs() < 1e-14 && (found[1] - 1.0).abs() < 1e-14);
    }
}
