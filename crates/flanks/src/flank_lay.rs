//! Lay γ of each flank with its distribution: measured on its surface, or assumed.

use asperity_core::numerics::{Z_975, standard_normal_below};
use asperity_ehl_regime::Lay;
use asperity_roughness::lay::RowLay;
use serde::{Deserialize, Serialize};

use crate::error::PositionError;

/// Upper end of the lay of ground and superfinished flanks, whose ridges run nearly across the face.
const MOST_LAY: f64 = 1.0 / 6.0;

/// Distribution of the lay of a flank.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FlankLay {
    /// Everything between two ends.
    Uniform {
        /// Lower end.
        low: f64,
        /// Upper end.
        high: f64,
    },
    /// Lognormal, at most 1.
    Lognormal {
        /// Median.
        median: f64,
        /// 97.5 % quantile over the median.
        factor: f64,
    },
}

impl FlankLay {
    /// The lay of ground flanks.
    pub const ASSUMED: Self = Self::Uniform {
        low: 0.0,
        high: MOST_LAY,
    };

    /// The measured lay; `None` if it says less than the assumed one.
    pub fn from_rows(measured: &RowLay) -> Option<Self> {
        let [low, high] = measured.range.map(|end| two_digits(end.min(1.0)));
        match measured.is_bound {
            true if high >= MOST_LAY && low < MOST_LAY => None,
            true => Some(Self::Uniform { low, high }),
            false => Some(Self::Lognormal {
                median: two_digits(measured.gamma.min(1.0)),
                factor: measured.range[1] / measured.gamma,
            }),
        }
    }

    /// γ at `z` of the standard normal distribution.
    pub fn at(self, z: f64) -> f64 {
        match self {
            Self::Uniform { low, high } => low + (high - low) * standard_normal_below(z),
            Self::Lognormal { median, factor } => (median * factor.powf(z / Z_975)).min(1.0),
        }
    }
}

/// Mean of the lays of both flanks at `z`.
pub fn mean_at(lays: [FlankLay; 2], z: f64) -> f64 {
    0.5 * (lays[0].at(z) + lays[1].at(z))
}

/// Lays of both flanks at one place of their distributions, with this mean.
///
/// # Errors
/// When a lay is not within 0 to 1.
pub fn with_mean(lays: [FlankLay; 2], mean: f64) -> Result<[Lay; 2], PositionError> {
    if lays[0] == lays[1] {
        return Ok([Lay::new(mean)?; 2]);
    }
    // Bisection: the mean rises with z.
    const REACH: f64 = 8.0;
    const STEPS: usize = 60;
    let [mut low, mut high] = [-REACH, REACH];
    for _ in 0..STEPS {
        let middle = 0.5 * (low + high);
        if mean_at(lays, middle) < mean {
            low = middle
        } else {
            high = middle
        }
    }
    let z = 0.5 * (low + high);
    Ok([Lay::new(lays[0].at(z))?, Lay::new(lays[1].at(z))?])
}

/// Rounded to the digits that an interval of some per cent allows.
pub fn two_digits(value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    let step = 10_f64.powi(value.log10().floor() as i32 - 1);
    // Division by a whole number is exact to the last digit, as the text is.
    let inverse = (1.0 / step).round();
    (value * inverse).round() / inverse
}
