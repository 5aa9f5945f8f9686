//! Means over a record with standard errors from the means of its blocks.

use asperity_core::cite;
use serde::{Deserialize, Serialize};

/// Mean of a record with its standard error.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct RecordMean {
    /// Mean over the record.
    pub mean: f64,
    /// Standard error of the mean; not a number with fewer than two blocks.
    pub standard_error: f64,
}

/// Time-weighted sums of several quantities, block by block.
#[derive(Debug, Clone, Default)]
pub(crate) struct BatchMeans {
    block: f64,
    sums: Vec<f64>,
    duration: f64,
    blocks: Vec<Vec<f64>>,
    /// Sums over the whole record, an unfinished block included.
    totals: Vec<f64>,
    elapsed: f64,
}

impl BatchMeans {
    /// Sums of `count` quantities in blocks of the length `block`.
    pub(crate) fn new(count: usize, block: f64) -> Self {
        Self {
            block,
            sums: vec![0.0; count],
            totals: vec![0.0; count],
            ..Self::default()
        }
    }

    /// Adds values that hold for `duration`.
    pub(crate) fn add(&mut self, values: &[f64], duration: f64) {
        for (sum, value) in self.sums.iter_mut().zip(values) {
            *sum += duration * value;
        }
        for (total, value) in self.totals.iter_mut().zip(values) {
            *total += duration * value;
        }
        self.elapsed += duration;
        self.duration += duration;
        // The tolerance keeps a block of many equal steps from taking one too many.
        if self.duration >= self.block * (1.0 - 1e-9) {
            let means = self.sums.iter().map(|sum| sum / self.duration).collect();
            self.blocks.push(means);
            self.sums.fill(0.0);
            self.duration = 0.0;
        }
    }

    pub(crate) fn blocks(&self) -> usize {
        self.blocks.len()
    }

    /// Mean of one quantity over the record, with the standard error from its whole blocks.
    ///
    /// s = √( Σ (x̄ₖ − x̄)²/(n·(n − 1)) ) over n block means               `[Batch-means]`
    pub(crate) fn estimate(&self, quantity: usize) -> RecordMean {
        cite!("Batch-means");
        let n = self.blocks.len() as f64;
        let mean = self.blocks.iter().map(|b| b[quantity]).sum::<f64>() / n;
        let squares: f64 = self
            .blocks
            .iter()
            .map(|b| (b[quantity] - mean).powi(2))
            .sum();
        RecordMean {
            mean: self.totals[quantity] / self.elapsed,
            standard_error: (squares / (n * (n - 1.0))).sqrt(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_standard_error_is_that_of_independent_blocks() {
        let mut record = BatchMeans::new(1, 1.0);
        for k in 0..400 {
            // Four steps a block, block means 0, 1, 2, 3 in turn.
            record.add(&[f64::from(k / 4 % 4)], 0.25);
        }
        let estimate = record.estimate(0);
        assert_eq!(record.blocks(), 100);
        assert!((estimate.mean - 1.5).abs() < 1e-12);
        let expected = (1.25_f64 / 99.0).sqrt();
        assert!((estimate.standard_error - expected).abs() < 1e-12);
    }
}
