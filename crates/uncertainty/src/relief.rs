//! Loss factors over tip reliefs, for gears whose relief the case does not state.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | C_a | tip relief of both gears where it is not stated | m |
//! | c | C_a over the approach δ of the teeth, 0 to 1 | - |
//! | l | roll length of the relief relative to double contact, 1/2 to 1 | - |
//! | H_V | loss factor of the load over the teeth | - |

use asperity_core::cite;
use serde::{Deserialize, Serialize};

use asperity_case::case::{AssumedRelief, Case};
use asperity_case::error::PositionError;

/// Places c of the table.
const AMOUNTS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Places l of the table.
const LENGTHS: [f64; 2] = [0.5, 1.0];

/// Loss factors over amount and length of the tip relief.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ReliefFactors {
    /// By length, then by amount.
    factors: [[f64; 5]; 2],
    /// With the relief of the run.
    of_run: f64,
}

impl ReliefFactors {
    /// The loss factors of a case over the reliefs that it may have; `None` if it states its relief.
    pub fn from_case(case: &Case) -> Result<Option<Self>, PositionError> {
        let Some(assumed) = &case.assumed_relief else {
            return Ok(None);
        };
        let inputs = case.load_inputs();
        let factor = |c: f64, l: f64| {
            let map = assumed.under(&inputs, c, l).load_map()?;
            Ok::<_, PositionError>(map.loss_factor())
        };
        let mut factors = [[0.0; 5]; 2];
        for (row, l) in factors.iter_mut().zip(LENGTHS) {
            for (place, c) in row.iter_mut().zip(AMOUNTS) {
                *place = factor(c, l)?;
            }
        }
        let of_run = factor(AssumedRelief::AMOUNT, AssumedRelief::LENGTH)?;
        Ok(Some(Self { factors, of_run }))
    }

    /// F: the loss factor at c = `amount` and the place `length`, 0 to 1, in the range of l, relative to the run.
    ///
    /// ```text
    /// F = H_V(c δ, l L)/H_V(δ/2, 3/4 L)                                        [Relief-factor]
    /// ```
    ///
    /// Bilinear between ten solutions of the load over the teeth. Without relief the edges of the tips of an external pair
    /// may carry load.
    pub fn ratio(&self, amount: f64, length: f64) -> f64 {
        cite!("Relief-factor");
        let steps = AMOUNTS.len() - 1;
        let place = amount * steps as f64;
        let k = (place as usize).min(steps - 1);
        let at = |row: &[f64; 5]| row[k] + (place - k as f64) * (row[k + 1] - row[k]);
        let [short, long] = [at(&self.factors[0]), at(&self.factors[1])];
        (short + length * (long - short)) / self.of_run
    }
}
