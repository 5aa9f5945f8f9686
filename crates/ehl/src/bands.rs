//! Matrices with four diagonals, at the offsets −2, −1, 0 and +1.

/// Four diagonals by rows: `diagonal[k][i]` multiplies the value at i + k − 2.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Bands {
    pub(crate) diagonal: [Vec<f64>; 4],
}

impl Bands {
    pub(crate) fn zero(nodes: usize) -> Self {
        Self {
            diagonal: std::array::from_fn(|_| vec![0.0; nodes]),
        }
    }

    pub(crate) fn clear(&mut self) {
        for diagonal in &mut self.diagonal {
            diagonal.fill(0.0);
        }
    }

    /// Replaces row `i` by `value` on the main diagonal.
    pub(crate) fn set_row(&mut self, i: usize, value: f64) {
        for diagonal in &mut self.diagonal {
            diagonal[i] = 0.0;
        }
        self.diagonal[2][i] = value;
    }

    /// Columns and values of row `i`.
    pub(crate) fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let nodes = self.diagonal[2].len();
        (0..4).filter_map(move |k| {
            let column = (i + k).checked_sub(2)?;
            (column < nodes).then(|| (column, self.diagonal[k][i]))
        })
    }

    /// `output` += this matrix · `input`.
    pub(crate) fn multiply_add(&self, input: &[f64], output: &mut [f64]) {
        let n = input.len();
        for i in [0, 1, n - 1] {
            output[i] += self.row(i).map(|(j, value)| value * input[j]).sum::<f64>();
        }
        let [a, b, c, d] = self.diagonal.each_ref().map(|diagonal| &diagonal[2..n - 1]);
        let inner = output[2..n - 1].iter_mut();
        for (i, out) in inner.enumerate() {
            *out +=
                a[i] * input[i] + b[i] * input[i + 1] + c[i] * input[i + 2] + d[i] * input[i + 3];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_product_is_the_sum_over_rows() {
        let n = 7;
        let mut bands = Bands::zero(n);
        for (k, diagonal) in bands.diagonal.iter_mut().enumerate() {
            for (i, value) in diagonal.iter_mut().enumerate() {
                *value = (k * 10 + i) as f64;
            }
        }
        let input: Vec<f64> = (0..n).map(|i| 1.0 + (i * i) as f64).collect();
        let mut output = vec![0.5; n];
        bands.multiply_add(&input, &mut output);
        for (i, value) in output.iter().enumerate() {
            let row: f64 = bands.row(i).map(|(j, v)| v * input[j]).sum();
            assert_eq!(*value, 0.5 + row);
        }
    }
}
