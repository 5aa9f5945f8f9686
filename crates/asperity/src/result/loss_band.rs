//! The band of a loss as plain data: what is uncertain, by how much, and what other laws would give.

use serde::{Deserialize, Serialize};

/// The loss with its band.
///
/// The nominal loss is that of the defaults. Draws of the parameters are not centred on the defaults, so the band is
/// told by quantiles and not as ±.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LossBand {
    /// All losses with every parameter at its default \[W\].
    pub nominal_w: f64,
    /// 5 % and 95 % quantiles of the loss, parameters and sampling of the flanks together \[W\].
    pub quantiles_w: [f64; 2],
    /// The same of the mesh efficiency, the lower first.
    pub efficiency_quantiles: [f64; 2],
    /// 5 % and 95 % quantiles from the parameters only \[W\].
    pub parameter_quantiles_w: [f64; 2],
    /// Parameters that were drawn.
    pub parameters: Vec<BandParameter>,
    /// Parameters that were not drawn because the case states them.
    pub held: Vec<String>,
    /// Draws of the parameters; 0 where none is uncertain.
    pub draws: usize,
    /// The loss of each draw \[W\], the same draws for every case.
    pub draws_w: Vec<f64>,
    /// Contribution of the sampling of the flanks.
    pub sampling: SamplingPart,
    /// The loss by other laws, each by its name; none is in the band.
    pub alternatives: Vec<AlternativeRow>,
    /// Trust in the result.
    pub trust: Trust,
    /// 5 % and 95 % quantiles of the sliding loss per metre of contact line by the parameters, at each position
    /// \[W/m\].
    pub path_sliding_w_per_m: Vec<[f64; 2]>,
    /// The same with the sampling of the flanks \[W/m\]; empty in older results.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub path_with_sampling_w_per_m: Vec<[f64; 2]>,
}

/// A parameter of the band.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct BandParameter {
    /// Its name.
    pub name: String,
    /// The default.
    pub value: f64,
    /// Lower end of its range.
    pub low: f64,
    /// Upper end of its range.
    pub high: f64,
    /// Unit of these; "-" for a number.
    pub unit: String,
    /// Whether the logarithm is drawn evenly.
    pub is_logarithmic: bool,
    /// Whether the case calibrates it: the range is then the 95 % band of that, and draws are normal about the value.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_calibrated: bool,
    /// Change of the loss from the lower to the upper end, by the plane through all draws \[W\].
    pub effect_w: f64,
}

/// Contribution of a trace being a sample of its flank.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum SamplingPart {
    /// Windows of traces whose place on the flank is not known.
    Windows(WindowSampling),
    /// All pairs of several traces of one flank or of both.
    Pairs(PairSampling),
    /// One pair of traces at known places, which has no sampling error: the change of the loss \[W\] where each is
    /// misplaced by two half-widths of the contact against the other, to either side.
    OnePair([f64; 2]),
    /// There is no interval; why.
    None(String),
}

/// Sampling error of a mean over windows that overlap.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct WindowSampling {
    /// Windows that were computed.
    pub offsets: usize,
    /// Windows that count as independent, n_e.
    pub effective_windows: f64,
    /// Standard error of the mean loss \[W\].
    pub standard_error_w: f64,
    /// Half the width of the 95 % interval of the mean loss \[W\].
    pub half_width_w: f64,
}

/// Sampling error of the mean loss over all pairs of sampled teeth.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct PairSampling {
    /// Teeth sampled of pinion and wheel, n₁ and n₂.
    pub traces: [usize; 2],
    /// Mean loss over the pairs \[W\].
    pub mean_w: f64,
    /// Standard deviations between the traces of the pinion, s₁, and of the wheel, s₂ \[W\]; 0 of a single trace.
    pub between_w: [f64; 2],
    /// Standard deviation that remains from pair to pair, s₁₂ \[W\]; 0 where a flank has a single trace.
    pub interaction_w: f64,
    /// Standard error of the mean loss \[W\]; a lower bound where a flank has a single trace.
    pub standard_error_w: f64,
    /// Its degrees of freedom d.
    pub freedom: f64,
    /// Half the width of the 95 % interval of the mean loss \[W\].
    pub half_width_w: f64,
    /// Change of the loss \[W\] where placed traces are misplaced by two half-widths of the contact against each
    /// other, to either side; none of traces that are not placed, or where it was not asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub misplaced_w: Option<[f64; 2]>,
}

impl PairSampling {
    /// Pairs of teeth.
    #[must_use]
    pub const fn pairs(&self) -> usize {
        self.traces[0] * self.traces[1]
    }

    /// The gear of which a single tooth is sampled, so that the error is a lower bound.
    #[must_use]
    pub const fn not_sampled(&self) -> Option<&'static str> {
        match self.traces {
            [1, _] => Some("pinion"),
            [_, 1] => Some("wheel"),
            _ => None,
        }
    }
}

/// The loss by another law or formulation.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct AlternativeRow {
    /// The law or value used instead.
    pub name: String,
    /// All losses \[W\]; `None` if the model has no solution here.
    pub loss_w: Option<f64>,
}

/// Trust in the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Trust {
    /// Both flanks were measured and their contact was solved.
    SolvedContact,
    /// A formula shares the load between film and asperities.
    ShareFormula,
    /// A flank has no trace, and the contact was solved on surrogates with its roughness values.
    Surrogates,
    /// A flank is known only by roughness values, from which a formula shares the load: the lowest trust.
    RoughnessValues,
}

impl LossBand {
    /// Half the width of the interval \[W\], which limits the printed digits of the loss.
    #[must_use]
    pub fn half_width_w(&self) -> f64 {
        0.5 * (self.quantiles_w[1] - self.quantiles_w[0])
    }
}

impl Trust {
    /// The level in words.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::SolvedContact => "both traces measured, their contact solved",
            Self::ShareFormula => "lower: a formula shares the load between film and asperities",
            Self::Surrogates => {
                "from roughness values, contact solved on surrogate flanks: no trace was measured"
            }
            Self::RoughnessValues => {
                "low: a flank is known by roughness values alone, no contact was solved"
            }
        }
    }
}

/// `value` with the digits that an uncertainty of `half_width` leaves: two of the uncertainty.
///
/// ```
/// use asperity::result::loss_band::rounded;
/// assert_eq!(rounded(612.34, 95.0), "612");
/// assert_eq!(rounded(612.34, 950.0), "610");
/// assert_eq!(rounded(99.55231, 0.0701), "99.552");
/// assert_eq!(rounded(612.34, 0.0), "612.3400");
/// ```
#[must_use]
pub fn rounded(value: f64, half_width: f64) -> String {
    let digits = Digits::of_uncertainty(half_width);
    digits.text(digits.steps(value))
}

/// The last decimal place of printed numbers. Numbers are whole steps of it, so that they can be added up as printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Digits {
    decimals: i32,
}

impl Digits {
    /// Decimals where nothing limits them.
    const MOST: i32 = 4;

    /// Digits with this number of decimals; -1 rounds to tens.
    #[must_use]
    pub const fn of_decimals(decimals: i32) -> Self {
        Self { decimals }
    }

    /// Two digits of an uncertainty, and four decimals at most.
    #[must_use]
    pub fn of_uncertainty(half_width: f64) -> Self {
        let decimals = match half_width.is_finite() && half_width > 0.0 {
            true => (1 - half_width.log10().floor() as i32).min(Self::MOST),
            false => Self::MOST,
        };
        Self { decimals }
    }

    /// Whole steps nearest to `value`.
    #[must_use]
    pub fn steps(self, value: f64) -> f64 {
        (value / self.step()).round()
    }

    /// Steps of the parts of a total of `total` steps, which add up to it: each part is rounded down, and the steps that
    /// are then missing go to the parts with the largest remainders. Parts of another total are rounded one by one.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// let tens = Digits::of_decimals(-1);
    /// // 565.6 + 8.1 = 573.7 is printed as 570 = 560 + 10.
    /// assert_eq!(tens.parts(tens.steps(573.7), &[565.6, 8.1]), [56.0, 1.0]);
    /// ```
    #[must_use]
    pub fn parts(self, total: f64, parts: &[f64]) -> Vec<f64> {
        let whole: Vec<f64> = parts
            .iter()
            .map(|part| (part / self.step()).floor())
            .collect();
        let missing = total - whole.iter().sum::<f64>();
        if !(0.0..=parts.len() as f64).contains(&missing) {
            return parts.iter().map(|part| self.steps(*part)).collect();
        }
        let remainder = |k: usize| parts[k] / self.step() - whole[k];
        let mut order: Vec<usize> = (0..parts.len()).collect();
        order.sort_by(|a, b| remainder(*b).total_cmp(&remainder(*a)));
        let mut steps = whole.clone();
        for &k in order.iter().take(missing as usize) {
            steps[k] += 1.0;
        }
        steps
    }

    /// A number of steps as text.
    #[must_use]
    pub fn text(self, steps: f64) -> String {
        format!("{:.*}", self.decimals.max(0) as usize, steps * self.step())
    }

    /// The last place, as text.
    #[must_use]
    pub fn last_place(self) -> String {
        self.text(1.0)
    }

    fn step(self) -> f64 {
        10f64.powi(-self.decimals)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_add_up_to_their_total_as_printed() {
        for decimals in [-2, 0, 3] {
            let digits = Digits::of_decimals(decimals);
            for k in 0..500 {
                let value = |j: u32| 1000.0 * (0.618_034 * f64::from(7 * k + j)).fract();
                let parts = [value(1), value(2), 0.01 * value(3), 0.0];
                let total = digits.steps(parts.iter().sum());
                let steps = digits.parts(total, &parts);
                assert_eq!(steps.iter().sum::<f64>(), total, "{parts:?}");
                let size = 10f64.powi(-decimals);
                let is_near = |(steps, part): (&f64, &f64)| (steps - part / size).abs() < 1.0;
                assert!(steps.iter().zip(&parts).all(is_near), "{steps:?} {parts:?}");
            }
        }
    }

    #[test]
    fn parts_of_another_total_are_rounded_one_by_one() {
        let ones = Digits::of_decimals(0);
        assert_eq!(ones.parts(100.0, &[1.4, 2.6]), [1.0, 3.0]);
    }
}
