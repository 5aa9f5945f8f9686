//! The uncertainty of a loss as plain data, and the digits that it leaves.

use asperity_case::message::Subject;
use asperity_core::{Code, Estimate};
use asperity_uncertainty::Quantiles;
use serde::{Deserialize, Serialize};

/// The uncertainty of the loss with its components, and the loss by other models.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct Uncertainty {
    /// The loss as drawn.
    pub loss: LossDistribution,
    /// Median of the mesh efficiency.
    pub efficiency_median: f64,
    /// Its 5 % and 95 % quantiles.
    pub efficiency_quantiles: [f64; 2],
    /// Constants that were drawn.
    pub constants: Vec<DrawnConstant>,
    /// Constants that were not drawn because the case states them.
    pub held: Vec<String>,
    /// Draws.
    pub draws: usize,
    /// Draws whose loss exceeded the power into the mesh, and was set to it.
    pub beyond_power: usize,
    /// Evaluations of the losses that the draws interpolate.
    pub evaluations: usize,
    /// Root mean square error of the interpolation of ln loss, at evaluations that it was not fitted to.
    pub interpolation_error: f64,
    /// Roughness that the contact leaves over the film, weighted with the sliding loss: beyond 3 nothing judges the model, and its
    /// error is wider (gap law `power`: beyond 2 it loses more than reference solutions).
    pub roughness_over_film: Option<f64>,
    /// Contribution of the sampling of the flanks.
    pub sampling: SamplingPart,
    /// Friction of the boundary layer at the 5 % and 95 % quantiles of the boundary share of asperity contacts formed inside the contact
    /// \[W\]: how well the reference solutions distinguish it from the friction of lubricated asperities. `None` if that share is not
    /// sampled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub boundary_w: Option<[f64; 2]>,
    /// The loss over the boundary share of asperity contacts formed inside the contact, which is sampled.
    pub structures: Vec<AlternativeRow>,
    /// The loss by models that reference solutions or measurements contradict; none is sampled.
    pub other_models: Vec<AlternativeRow>,
    /// Trust in the result.
    pub trust: Trust,
    /// Quantiles of the loss that traces instead of surrogate flanks would leave \[W\]; `None` for measured flanks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub with_traces_w: Option<[f64; 2]>,
    /// 5 % and 95 % quantiles of the sliding loss per metre of contact line at each position \[W/m\].
    pub path_sliding_w_per_m: Vec<[f64; 2]>,
    /// Measurements that would narrow the interval, the one that leaves the narrowest first; empty if they were not sought.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub evidence: Vec<EvidenceRow>,
}

/// A measurement with the interval of the loss that it is expected to leave, about its present median: the result of a
/// measurement is not known before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct EvidenceRow {
    /// Name.
    pub key: String,
    /// The measurement in words.
    pub measurement: String,
    /// Hours that it takes.
    pub hours: f64,
    /// Expected 5 % quantile of the loss \[W\].
    pub low_w: f64,
    /// Expected 95 % quantile \[W\].
    pub high_w: f64,
    /// Expected standard deviation of ln loss.
    pub sd_ln: f64,
    /// Expected width of the interval of ln loss over its present one.
    pub width: f64,
}

impl EvidenceRow {
    /// The row of a measurement that takes `hours` and leaves `left` of the present interval `now`.
    #[must_use]
    pub fn new(key: &str, words: String, hours: f64, now: Quantiles, left: Quantiles) -> Self {
        let moved = now.drawn.value / left.drawn.value;
        let [low_w, high_w] = left.drawn.ends().map(|end| moved * end);
        Self {
            key: key.to_owned(),
            measurement: words,
            hours,
            low_w,
            high_w,
            sd_ln: left.sd_ln,
            width: left.drawn.log_width() / now.drawn.log_width(),
        }
    }

    /// Its interval \[W\].
    #[must_use]
    pub fn interval(&self) -> [f64; 2] {
        [self.low_w, self.high_w]
    }

    /// The width over the present one as text.
    #[must_use]
    pub fn width_percent(&self) -> String {
        format!("{:.0} %", 100.0 * self.width)
    }
}

/// The loss as drawn, with the contribution of each component.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LossDistribution {
    /// Median \[W\].
    pub median_w: f64,
    /// 5 % and 95 % quantiles \[W\].
    pub quantiles_w: [f64; 2],
    /// Standard deviation of the logarithm.
    pub sd_ln: f64,
    /// Components, each with all others at their medians, the largest first.
    pub parts: Vec<UncertaintyPart>,
}

impl LossDistribution {
    /// Median with 5 % and 95 % quantiles \[W\].
    #[must_use]
    pub fn drawn(&self) -> Estimate {
        Estimate::new(self.median_w, self.quantiles_w)
    }
}

/// A component of the uncertainty, drawn with all others at their medians.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct UncertaintyPart {
    /// Its name.
    pub name: String,
    /// The component, where warnings are about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<Subject>,
    /// Standard deviation of ln loss.
    pub sd_ln: f64,
    /// 5 % and 95 % quantiles of the loss, scaled as the run to the median of all draws \[W\].
    pub quantiles_w: [f64; 2],
    /// Measurement or statement that narrows it.
    pub remedy: String,
}

impl UncertaintyPart {
    /// Half the range from the 5 % to the 95 % quantile \[W\].
    #[must_use]
    pub fn half_range_w(&self) -> f64 {
        0.5 * (self.quantiles_w[1] - self.quantiles_w[0])
    }
}

/// A constant that is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct DrawnConstant {
    /// Its name.
    pub name: String,
    /// The median, which the run uses.
    pub value: f64,
    /// 5 % quantile.
    pub low: f64,
    /// 95 % quantile.
    pub high: f64,
    /// Unit of these; "-" for a number.
    pub unit: String,
    /// Whether the case calibrates it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_calibrated: bool,
}

impl DrawnConstant {
    /// The median with its quantiles.
    #[must_use]
    pub fn drawn(&self) -> Estimate {
        Estimate::new(self.value, [self.low, self.high])
    }
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
    /// Standard error of ln loss for the flanks.
    pub standard_error: f64,
    /// Its degrees of freedom.
    pub freedom: f64,
    /// Standard error of the mean over the offsets as a value of these traces, over the mean.
    pub numerical_error: f64,
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
    /// other, to either side; `None` if the traces are not placed or it was not computed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub misplaced_w: Option<[f64; 2]>,
}

impl PairSampling {
    /// The same of losses that are `factor` times as large.
    pub(crate) fn times(self, factor: f64) -> Self {
        Self {
            mean_w: factor * self.mean_w,
            between_w: self.between_w.map(|spread| factor * spread),
            interaction_w: factor * self.interaction_w,
            standard_error_w: factor * self.standard_error_w,
            half_width_w: factor * self.half_width_w,
            misplaced_w: self
                .misplaced_w
                .map(|changes| changes.map(|change| factor * change)),
            ..self
        }
    }

    /// Pairs of teeth.
    #[must_use]
    pub const fn pairs(&self) -> usize {
        self.traces[0] * self.traces[1]
    }

    /// Text behind the standard error where a single tooth of a gear is sampled: it is a lower bound.
    #[must_use]
    pub fn bound(&self) -> String {
        match self.traces {
            [1, _] | [_, 1] => format!(", a lower bound ({})", Code::W450),
            _ => String::new(),
        }
    }
}

/// The loss by another model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct AlternativeRow {
    /// The law or value used instead.
    pub name: String,
    /// All losses \[W\], scaled as the run to the median of the draws; `None` if the model has no solution here.
    pub loss_w: Option<f64>,
    /// The records or measurements against it, and by how much; empty of a model that is drawn.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub refuted_by: String,
}

impl AlternativeRow {
    /// The evidence against the model, or that it is drawn.
    #[must_use]
    pub fn standing(&self) -> &str {
        if self.refuted_by.is_empty() {
            "sampled: part of the interval"
        } else {
            &self.refuted_by
        }
    }
}

/// Trust in the result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Trust {
    /// Both flanks were measured and their contact was solved, with or without its film.
    SolvedContact,
    /// A formula shares the load between film and asperities.
    ShareFormula,
    /// A flank has no trace, and the contact was solved on surrogates with its roughness values.
    Surrogates,
    /// A flank is known only by roughness values, from which a formula shares the load: the lowest trust.
    RoughnessValues,
}

impl Uncertainty {
    /// Median of the mesh efficiency with its 5 % and 95 % quantiles.
    #[must_use]
    pub fn efficiency(&self) -> Estimate {
        Estimate::new(self.efficiency_median, self.efficiency_quantiles)
    }

    /// The uncertainty of a loss that is `factor` times as large.
    pub(crate) fn times(mut self, factor: f64) -> Self {
        let [low, high] = &mut self.efficiency_quantiles;
        for efficiency in [&mut self.efficiency_median, low, high] {
            *efficiency = 1.0 - factor * (1.0 - *efficiency);
        }
        self.sampling = match self.sampling {
            SamplingPart::Pairs(pairs) => SamplingPart::Pairs(pairs.times(factor)),
            SamplingPart::OnePair(changes) => SamplingPart::OnePair(changes.map(|w| factor * w)),
            other => other,
        };
        let models = self.structures.iter_mut().chain(&mut self.other_models);
        let losses = models.filter_map(|row| row.loss_w.as_mut());
        let ends = self.boundary_w.iter_mut().chain(&mut self.with_traces_w);
        let ends = ends
            .chain(&mut self.path_sliding_w_per_m)
            .chain([&mut self.loss.quantiles_w]);
        let ends = ends.chain(self.loss.parts.iter_mut().map(|part| &mut part.quantiles_w));
        let of_evidence = self.evidence.iter_mut();
        let of_evidence = of_evidence.flat_map(|row| [&mut row.low_w, &mut row.high_w]);
        let powers = losses.chain(ends.flatten()).chain(of_evidence);
        for power in powers.chain([&mut self.loss.median_w]) {
            *power *= factor;
        }
        self
    }

    /// The loss by every model, those that are drawn first.
    pub fn models(&self) -> impl Iterator<Item = &AlternativeRow> {
        self.structures.iter().chain(&self.other_models)
    }

    /// The trust in the result in words, and the interval that traces would leave.
    #[must_use]
    pub fn trust_text(&self) -> String {
        let text = self.trust.text();
        let digits = self.digits();
        match self.with_traces_w {
            Some(_) if !self.traces_narrow() => {
                format!("{text}; traces would hardly narrow the interval")
            }
            Some(ends) => {
                format!(
                    "{text}; traces would narrow the interval to {} W",
                    digits.range(ends)
                )
            }
            None => text.to_owned(),
        }
    }

    /// Whether traces instead of roughness values would leave an interval that is printed with other ends.
    #[must_use]
    pub fn traces_narrow(&self) -> bool {
        let digits = self.digits();
        let printed = |ends: [f64; 2]| ends.map(|loss| digits.rounded(loss));
        let now = printed(self.loss.drawn().ends());
        self.with_traces_w.is_some_and(|ends| printed(ends) != now)
    }

    /// The last place of printed losses and their parts.
    #[must_use]
    pub fn digits(&self) -> Digits {
        Digits::of_interval(self.loss.drawn().ends())
    }
}

impl Trust {
    /// The level in words.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::SolvedContact => "both flanks have traces, their contact is solved",
            Self::ShareFormula => "lower: a formula shares the load between film and asperities",
            Self::Surrogates => {
                "lower: a flank is known by roughness values alone, its contact solved on surrogates"
            }
            Self::RoughnessValues => {
                "low: a flank is known by roughness values alone, no contact was solved"
            }
        }
    }
}

/// `value` with the digits that an interval of this half width leaves.
///
/// ```
/// use asperity::result::loss_band::rounded;
/// assert_eq!(rounded(612.34, 95.0), "610");
/// assert_eq!(rounded(612.34, 950.0), "600");
/// assert_eq!(rounded(99.55231, 0.0701), "99.55");
/// assert_eq!(rounded(612.34, 0.0), "612.3400");
/// ```
#[must_use]
pub fn rounded(value: f64, half_width: f64) -> String {
    let digits = Digits::of_uncertainty(half_width);
    digits.text(digits.steps(value))
}

/// A loss that is stated without its interval, with the digits that the interval of a run leaves: its half width is a tenth of
/// the loss or more.
///
/// ```
/// assert_eq!(asperity::result::loss_band::without_interval(708.13), "710");
/// ```
#[must_use]
pub fn without_interval(loss_w: f64) -> String {
    const LEAST_HALF_WIDTH: f64 = 0.1;
    rounded(loss_w, LEAST_HALF_WIDTH * loss_w)
}

/// A loss \[W\] with its quantiles, and the efficiency \[%\] with them of `power_in_w`, each with the digits that the
/// interval leaves and its unit after the first number.
///
/// ```
/// use asperity::result::loss_band::with_interval;
/// use asperity_core::Estimate;
/// let found = with_interval(Estimate::new(662.1, [517.0, 868.0]), 136_659.0, [" W", " %"]);
/// assert_eq!(found, ["660 W (520..870)", "99.516 % (99.365..99.622)"]);
/// ```
#[must_use]
pub fn with_interval(loss_w: Estimate, power_in_w: f64, [watt, percent]: [&str; 2]) -> [String; 2] {
    let digits = Digits::of_interval(loss_w.ends());
    let efficiency = loss_w.map(|loss| 100.0 * (1.0 - loss / power_in_w));
    [
        digits.interval_with(watt, loss_w),
        digits
            .of_percent(power_in_w)
            .interval_with(percent, efficiency),
    ]
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

    /// The last place that a tenth of the interval from `low` to `high` reaches, and four decimals at most.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// assert_eq!(Digits::of_interval([520.0, 840.0]).last_place(), "10");
    /// assert_eq!(Digits::of_interval([49.2, 50.1]).last_place(), "0.01");
    /// ```
    #[must_use]
    pub fn of_interval([low, high]: [f64; 2]) -> Self {
        Self::of_uncertainty(0.5 * (high - low))
    }

    /// The digits that the interval of a drawn number leaves; `without` one.
    #[must_use]
    pub fn of_drawn(drawn: Option<Estimate>, without: Self) -> Self {
        drawn.map_or(without, |drawn| Self::of_interval(drawn.ends()))
    }

    /// Digits of a difference: as [`of_interval`](Self::of_interval), with up to two places more if the interval excludes 0
    /// and an end would be printed as 0.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// let digits = |ends| Digits::of_difference(ends).last_place().to_owned();
    /// assert_eq!([[3.0, 110.0], [20.0, 130.0], [-3.0, 110.0]].map(digits), ["1", "10", "10"]);
    /// ```
    #[must_use]
    pub fn of_difference(ends: [f64; 2]) -> Self {
        let mut digits = Self::of_interval(ends);
        let most = (digits.decimals + 2).min(Self::MOST);
        let prints_zero = |digits: Self| ends.iter().any(|end| digits.steps(*end) == 0.0);
        while ends[0] * ends[1] > 0.0 && digits.decimals < most && prints_zero(digits) {
            digits.decimals += 1;
        }
        digits
    }

    /// The same of an interval of this half width.
    #[must_use]
    pub fn of_uncertainty(half_width: f64) -> Self {
        let decimals = if half_width.is_finite() && half_width > 0.0 {
            (-(0.2 * half_width).log10().floor() as i32).min(Self::MOST)
        } else {
            Self::MOST
        };
        Self { decimals }
    }

    /// Three or four digits of a power without an interval; two below 0.1 W.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// let text = |power| Digits::of_power(power).rounded(power);
    /// assert_eq!([12_347.0, 1370.28, 571.3, 8.123, 0.0456].map(text), ["12350", "1370", "571", "8.12", "0.046"]);
    /// ```
    #[must_use]
    pub fn of_power(power: f64) -> Self {
        Self::of_decimals(match power {
            power if power >= 10_000.0 => -1,
            power if power >= 100.0 => 0,
            power if power >= 0.1 => 2,
            power if power > 0.0 => 1 - power.log10().floor() as i32,
            _ => 0,
        })
    }

    /// The digits with one place more.
    #[must_use]
    pub const fn finer(self) -> Self {
        Self::of_decimals(self.decimals + 1)
    }

    /// Digits of a percentage of `power` for losses with these digits.
    #[must_use]
    pub fn of_percent(self, power: f64) -> Self {
        let step = 100.0 * self.step() / power;
        Self {
            decimals: (-step.log10().floor() as i32).clamp(0, 6),
        }
    }

    /// `value` rounded to the last place, as text.
    #[must_use]
    pub fn rounded(self, value: f64) -> String {
        self.text(self.steps(value))
    }

    /// `value` with the ends of its interval, all rounded to the last place.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// use asperity_core::Estimate;
    /// let loss = Estimate::new(662.1, [517.0, 868.0]);
    /// assert_eq!(Digits::of_interval(loss.ends()).interval(loss), "660 (520..870)");
    /// ```
    #[must_use]
    pub fn interval(self, estimate: Estimate) -> String {
        self.interval_with("", estimate)
    }

    /// `value` with its `unit`, and the ends of its interval.
    #[must_use]
    pub fn interval_with(self, unit: &str, estimate: Estimate) -> String {
        let ends = self.range(estimate.ends());
        format!("{}{unit} ({ends})", self.rounded(estimate.value))
    }

    /// The ends of an interval, rounded to the last place.
    #[must_use]
    pub fn range(self, ends: [f64; 2]) -> String {
        let [low, high] = ends.map(|end| self.rounded(end));
        format!("{low}..{high}")
    }

    /// `value` rounded to the last place, with its sign.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// let signed = |value| Digits::of_decimals(0).signed(value);
    /// assert_eq!([12.3, -0.4, -3.0].map(signed), ["+12", "0", "-3"]);
    /// ```
    #[must_use]
    pub fn signed(self, value: f64) -> String {
        self.signed_text(self.steps(value))
    }

    /// Whole `steps` as text, with their sign.
    #[must_use]
    pub fn signed_text(self, steps: f64) -> String {
        match steps {
            0.0 => "0".to_owned(),
            steps if steps > 0.0 => format!("+{}", self.text(steps)),
            _ => self.text(steps),
        }
    }

    /// `value` with the ends of its interval, all rounded to the last place, with their signs.
    #[must_use]
    pub fn signed_interval(self, estimate: Estimate) -> String {
        let [low, high] = estimate.ends().map(|end| self.signed(end));
        format!("{} ({low}..{high})", self.signed(estimate.value))
    }

    /// Whole steps nearest to `value`.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// assert_eq!(Digits::of_decimals(0).rounded(-0.4), "0");
    /// ```
    #[must_use]
    pub fn steps(self, value: f64) -> f64 {
        // The sum turns −0 into 0.
        (value / self.step()).round() + 0.0
    }

    /// Steps of the parts of a total of `total` steps, which add up to it: each part is rounded down, and the steps that
    /// are then missing go to the parts with the largest remainders, of at least half a step or negative. Parts of another
    /// total are rounded one by one.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// let tens = Digits::of_decimals(-1);
    /// // 565.6 + 8.1 = 573.7 is printed as 570 = 560 + 10.
    /// assert_eq!(tens.parts(tens.steps(573.7), &[565.6, 8.1]), [56.0, 1.0]);
    /// let ones = Digits::of_decimals(0);
    /// assert_eq!(ones.parts(-46.0, &[31.6, -25.4, -52.4, 0.0]), [32.0, -25.0, -53.0, 0.0]);
    /// ```
    #[must_use]
    pub fn parts(self, total: f64, parts: &[f64]) -> Vec<f64> {
        let whole: Vec<f64> = parts
            .iter()
            .map(|part| (part / self.step()).floor())
            .collect();
        let missing = total - whole.iter().sum::<f64>();
        let is_shown = |k: &usize| parts[*k] < 0.0 || parts[*k] >= 0.5 * self.step();
        let mut order: Vec<usize> = (0..parts.len()).filter(is_shown).collect();
        if !(0.0..=order.len() as f64).contains(&missing) {
            return parts.iter().map(|part| self.steps(*part)).collect();
        }
        let remainder = |k: usize| parts[k] / self.step() - whole[k];
        order.sort_by(|a, b| remainder(*b).total_cmp(&remainder(*a)));
        let mut steps = whole.clone();
        for &k in order.iter().take(missing as usize) {
            steps[k] += 1.0;
        }
        steps
    }

    /// Parts of `total` as text, which add up to it as printed; a part without a step is printed as less than one.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// assert_eq!(Digits::of_decimals(-2).texts_of_parts(679.0, &[638.4, 40.6]), ["700", "< 100"]);
    /// assert_eq!(Digits::of_decimals(0).texts_of_parts(-4.0, &[0.0, -4.0]), ["0", "-4"]);
    /// ```
    #[must_use]
    pub fn texts_of_parts(self, total: f64, parts: &[f64]) -> Vec<String> {
        let steps = self.parts(self.steps(total), parts);
        let text = |(steps, part): (f64, &f64)| {
            if steps == 0.0 && *part > 0.0 {
                format!("< {}", self.last_place())
            } else {
                self.text(steps)
            }
        };
        steps.into_iter().zip(parts).map(text).collect()
    }

    /// Shares \[%\] of `parts` that are printed as these `steps`: of the printed parts in their printed sum, so that a reader who
    /// divides the printed numbers obtains them. They add up to 100, with
    /// one decimal at most; a part below a step has less than the share of a step.
    ///
    /// ```
    /// use asperity::result::loss_band::Digits;
    /// // 180, 50, 440 and 40 W of 710 W.
    /// let shares = Digits::of_decimals(-1).shares(&[18.0, 5.0, 44.0, 4.0], &[178.0, 54.0, 438.0, 38.0]);
    /// assert_eq!(shares, ["25", "7", "62", "6"]);
    /// assert_eq!(Digits::of_decimals(-1).shares(&[45.0, 0.0], &[447.0, 3.0]), ["100", "< 3"]);
    /// ```
    #[must_use]
    pub fn shares(self, steps: &[f64], parts: &[f64]) -> Vec<String> {
        let total: f64 = steps.iter().sum();
        if total <= 0.0 {
            return parts.iter().map(|_| "0".to_owned()).collect();
        }
        let decimals = self.of_percent(total * self.step()).decimals.min(1);
        let digits = Self { decimals };
        let shares: Vec<f64> = steps.iter().map(|steps| 100.0 * steps / total).collect();
        let rounded = digits.parts(digits.steps(100.0), &shares);
        let one = digits.text((100.0 / total / digits.step()).ceil());
        let texts = rounded.into_iter().zip(steps.iter().zip(parts));
        let text = |(share, (steps, part)): (f64, (&f64, &f64))| {
            if *steps == 0.0 && *part > 0.0 {
                format!("< {one}")
            } else {
                digits.text(share)
            }
        };
        texts.map(text).collect()
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

    pub(crate) fn step(self) -> f64 {
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
            for k in 0..3_400 {
                let value = |j: u32| 1000.0 * (0.618_034 * f64::from(7 * k + j)).fract();
                let parts = [1.0 + value(1), value(2), 0.01 * value(3), 0.0];
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
