//! Computation of the change of traces.

use asperity::message::Warning;
use asperity_core::numerics::{deviation, mean};
use asperity_core::quantity::{Length, Ratio};
use asperity_core::{Code, DomainError, Estimate, EstimateKeys, Fault, estimate_keys};
use asperity_report::{Input as _, StudySettings, Watch, Work, settings};
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::{Ends, mean_line};
use asperity_roughness::preparation::LAMBDA_C;
use asperity_roughness::relocation::{Bounds, Change, Relocation, relocate};
use serde::Serialize;

use super::in_case::{ChangeInCase, Matched, WornFlank, in_case};
use super::pairs::{TracePair, TracePairs};

/// Material ratios of the table \[%\].
const RATIOS: [f64; 9] = [1.0, 5.0, 10.0, 25.0, 50.0, 75.0, 90.0, 95.0, 99.0];
/// Steps of the progress that a case adds.
const RUNS: usize = 2;
/// Micrometres and nanometres in a metre.
const MICRO: f64 = 1e6;
const NANO: f64 = 1e9;

settings! {
    /// Settings of a change of traces.
    pub struct ChangeSettings {
        /// Largest shift of the second trace, to either side
        max_shift: Length = "0.5 mm",
        /// Largest stretch of the second trace, to either side
        max_stretch: Ratio = "0.3 %",
        /// Form by which the second trace may differ: level (height and tilt), or poly2 (a bow as well)
        [value_name = "FORM"] form: Form = "level",
        /// Engagements of a tooth of the pinion in the test, for Archard's wear coefficient
        [value_name = "N"] engagements: Option<f64>,
        /// Flank that changed, pinion or wheel, where the case does not have the traces before the test
        flank: Option<WornFlank>,
        /// Leave out pairs that are not of one place or match at several places alike, and name them
        leave_out: bool,
    }
}

estimate_keys! {
    ShiftKeys: "shift_um" "shift_quantiles_um";
    StretchKeys: "stretch_percent" "stretch_quantiles_percent";
    HeightKeys: "height_um" "height_quantiles_um";
    TiltKeys: "tilt_um_per_mm" "tilt_quantiles_um_per_mm";
    BowKeys: "bow_um" "bow_quantiles_um";
    RemovedKeys: "removed_nm" "removed_quantiles_nm";
    LostKeys: "lost_nm" "lost_quantiles_nm";
    GainedKeys: "gained_nm" "gained_quantiles_nm";
}

/// Mean heights over a trace.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Heights {
    /// Height removed.
    #[serde(flatten, with = "RemovedKeys")]
    pub removed_nm: Estimate,
    /// Height lost where the trace is lower after the test.
    #[serde(flatten, with = "LostKeys")]
    pub lost_nm: Estimate,
    /// Height gained where it is higher.
    #[serde(flatten, with = "GainedKeys")]
    pub gained_nm: Estimate,
}

/// Match of a pair and what it lost.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PairRow {
    /// Name of the trace before.
    pub before: String,
    /// Name of the trace after.
    pub after: String,
    /// Shift of the middle of the second trace along the first.
    #[serde(flatten, with = "ShiftKeys")]
    pub shift_um: Estimate,
    /// Stretch of the second trace.
    #[serde(flatten, with = "StretchKeys")]
    pub stretch_percent: Estimate,
    /// Height added to the second trace.
    #[serde(flatten, with = "HeightKeys")]
    pub height_um: Estimate,
    /// Slope added to the second trace.
    #[serde(flatten, with = "TiltKeys")]
    pub tilt_um_per_mm: Estimate,
    /// Height added to the ends of the second trace, as a parabola; `None` without one.
    #[serde(flatten, with = "BowKeys")]
    pub bow_um: Option<Estimate>,
    /// Correlation of the valleys.
    pub correlation: f64,
    /// Best correlation of the valleys at another place.
    pub elsewhere: f64,
    /// Share of the points in the valleys that were matched.
    pub matched_percent: f64,
    /// Standard deviation of the difference of both traces in the valleys.
    pub noise_nm: f64,
    /// Length that both traces have in common.
    pub overlap_mm: f64,
    /// Area of the section that was removed.
    pub removed_um2: f64,
    /// Mean heights.
    #[serde(flatten)]
    pub heights: Heights,
}

/// A parameter before and after, as mean of all pairs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ParameterRow {
    /// Parameter.
    pub parameter: &'static str,
    /// Before the test.
    pub before_um: f64,
    /// After it.
    pub after_um: f64,
    /// Difference.
    pub change_um: f64,
    /// Change that noise makes in one of twenty comparisons of unchanged traces.
    pub floor_um: f64,
}

/// A level of the material ratio curve before and after, as mean of all pairs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CurveRow {
    /// Material ratio.
    pub material_ratio_percent: f64,
    /// Level before the test above the mean line.
    pub before_um: f64,
    /// Level after it above the same line.
    pub after_um: f64,
    /// Difference.
    pub change_um: f64,
    /// Change that noise and the uncertain height make in one of twenty comparisons of unchanged traces.
    pub floor_um: f64,
}

/// A point of both traces, with heights above the mean line of the first.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(super) struct ChangedPointRow {
    pub x_mm: f64,
    pub before_um: f64,
    pub after_um: f64,
    pub lost_nm: f64,
}

/// Change of traces of the same places by a test.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TraceChange {
    /// Title.
    pub title: String,
    /// Mean over the pairs, for these places.
    pub mean: Heights,
    /// The mean if the form changed by a bow as well, where the traces are undecided without; `None` elsewhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_with_bow: Option<Heights>,
    /// Standard deviation of the height removed from pair to pair; `None` of a single pair.
    pub scatter_nm: Option<f64>,
    /// Pairs.
    pub pairs: Vec<PairRow>,
    /// Parameters.
    pub parameters: Vec<ParameterRow>,
    /// Material ratio curve.
    pub material_ratio: Vec<CurveRow>,
    /// Worth of the change in the case.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub in_case: Option<ChangeInCase>,
    /// Warnings of the readers, and pairs that are left out.
    pub warnings: Vec<Warning>,
    /// Points of each pair.
    #[serde(skip)]
    pub(super) points: Vec<Vec<ChangedPointRow>>,
}

impl StudySettings for ChangeSettings {
    type Input = TracePairs;
    type Found = TraceChange;
    const COMMAND: &'static str = "profile change";
    const FUNCTION: &'static str = "profile_change";
    const FOLDER: &'static str = "change";
    const ABOUT: &'static str = "Height that a test removed from traces of the same places, and the change of their parameters";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[("before", "before.csv"), ("after", "after.csv")],
        &[
            ("before", "before.csv"),
            ("after", "after.csv"),
            ("case", "demo/case.toml"),
            ("engagements", "1e6"),
            ("flank", "pinion"),
        ],
    ];
    const METHOD: &'static str = "The second trace is placed on the first by the valleys, which wear spares: shift, stretch, height and tilt, and a bow \
        with form = poly2. All places are compared at which half of the shorter trace overlaps, also those beyond the bound of the shift. \
        Heights are relative to the valleys, so that a loss of valleys and peaks alike does not show. Intervals are from 5 to 95 %. They \
        contain the noise of the match and the choice of the valleys. Where parts of the trace rose, other valleys may have risen as well: the \
        height gained is then also a standard deviation of the height removed. Parameters follow ISO 4287 with sections of 0.25 mm over the \
        common length. A noise floor is the change that noise makes in one of twenty comparisons. With a case, its flanks are the traces over \
        the common length, before and after the test. Each pair is a tooth. Both runs share all samples except two. The errors of the \
        model are correlated by the concordance of the changed heights. The sampling error follows from the differences of the \
        windows. A trace without a stated place lies at any place of the flank, and the interval of the wear coefficient contains this. \
        operation.running_in presses the flanks before the test into each other and removes nothing by wear.";
    const STEPS: &'static str = "pairs";

    fn work(&self, _: &TracePairs) -> Result<Option<Work>, Fault> {
        Ok(None)
    }

    fn run(&self, given: TracePairs, watch: &Watch<'_>) -> Result<TraceChange, Fault> {
        let bounds = Bounds {
            shift: self.max_shift,
            stretch: self.max_stretch.value(),
            form: self.form,
        };
        bounds.check()?;
        self.check_case(given.case.is_some())?;
        let title = given.title();
        let runs = if given.case.is_some() { RUNS } else { 0 };
        let count = given.pairs.len();
        let (mut matched, mut warnings) = (Vec::<Matched>::new(), Vec::new());
        for (k, mut pair) in given.pairs.into_iter().enumerate() {
            warnings.append(&mut pair.warnings);
            let [before, after] = &pair.traces;
            match relocate(before, after, bounds) {
                Ok(found) => matched.push((pair, found)),
                Err(fault) if self.leave_out && fault.code() == Code::E143 => {
                    let text = format!("{} is left out: {}", both(&pair), fault.message());
                    warnings.push(Warning::new(Code::W455, text));
                }
                Err(fault) => return Err(fault.about(both(&pair))),
            }
            (watch.progress)(k + 1, count + runs);
        }
        if matched.is_empty() {
            let message = "no pair of traces is of one place that is certain";
            return Err(Fault::new(Code::E143, message));
        }
        let (mut pairs, mut points) = (Vec::new(), Vec::new());
        let (mut parameters, mut levels) = (Vec::new(), Vec::new());
        for (pair, found) in &matched {
            let of_trace = |error| Fault::from(error).about(both(pair));
            parameters.push(found.parameters().map_err(of_trace)?.to_vec());
            levels.push(found.material_ratio(&RATIOS).map_err(of_trace)?);
            points.push(along(found).map_err(of_trace)?);
            pairs.push(row(&pair.names, found));
        }
        let in_case = given.case.map(|case| {
            let step = |k: usize| (watch.progress)(count + k, count + runs);
            in_case(&case, self.flank, self.engagements, &matched, &step)
        });
        let in_case = in_case.transpose()?;
        let removed = pairs.iter().map(|pair| pair.heights.removed_nm.value);
        let removed: Vec<f64> = removed.collect();
        let mean = Heights::mean(pairs.iter().map(|pair| pair.heights));
        let parameters: Vec<_> = means(&parameters).map(ParameterRow::from_change).collect();
        let is_undecided = bounds.form == Form::Level && is_undecided(&mean, &parameters);
        let with_bow = is_undecided.then(|| with_bow(&matched, bounds));
        Ok(TraceChange {
            title,
            mean,
            mean_with_bow: with_bow.transpose()?.flatten(),
            scatter_nm: deviation(&removed),
            parameters,
            material_ratio: means(&levels).map(CurveRow::from_change).collect(),
            pairs,
            in_case,
            warnings,
            points,
        })
    }
}

/// Whether noise explains the height removed, and neither the loss of the peaks nor a gain elsewhere.
pub(super) fn is_undecided(mean: &Heights, parameters: &[ParameterRow]) -> bool {
    let has_fallen = |row: &ParameterRow| row.is_clear() && row.change_um < 0.0;
    mean.removed_nm.contains(0.0) && mean.gained_nm.low <= 0.0 && parameters.iter().any(has_fallen)
}

/// The mean over the pairs if the form changed by a bow as well; `None` if a pair does not match with it.
fn with_bow(matched: &[Matched], bounds: Bounds) -> Result<Option<Heights>, Fault> {
    let form = Form::Poly2;
    let mut heights = Vec::new();
    for (pair, _) in matched {
        let [before, after] = &pair.traces;
        match relocate(before, after, Bounds { form, ..bounds }) {
            Ok(found) => heights.push(row(&pair.names, &found).heights),
            Err(fault) if fault.code() == Code::E143 => return Ok(None),
            Err(fault) => return Err(fault),
        }
    }
    Ok(Some(Heights::mean(heights.into_iter())))
}

impl Heights {
    fn mean(each: impl Iterator<Item = Self> + Clone) -> Self {
        let of =
            |value: fn(Self) -> Estimate| mean_of(&each.clone().map(value).collect::<Vec<_>>());
        Self {
            removed_nm: of(|heights| heights.removed_nm),
            lost_nm: of(|heights| heights.lost_nm),
            gained_nm: of(|heights| heights.gained_nm),
        }
    }
}

/// Names of both traces of a pair.
fn both(pair: &TracePair) -> String {
    pair.names.join(", ")
}

impl ChangeSettings {
    /// Refuses engagements that cannot be, and settings that need a case.
    fn check_case(&self, has_case: bool) -> Result<(), Fault> {
        let needs = [
            ("engagements", self.engagements.is_some()),
            ("flank", self.flank.is_some()),
        ];
        if let Some((name, _)) = needs
            .into_iter()
            .find(|(_, is_stated)| *is_stated && !has_case)
        {
            let message = format!(
                "{name}: load, sliding and loss follow from the gears of a case, and none is given"
            );
            let help = "Name the case of the gears, or leave the setting out.";
            return Err(Fault::new(Code::E205, message).helping(help));
        }
        if let Some(engagements) = self.engagements {
            let rule = "must be above 0";
            let is_possible = engagements > 0.0 && engagements.is_finite();
            DomainError::require(is_possible, "engagements", engagements, "-", rule)?;
        }
        Ok(())
    }
}

fn row(names: &[String; 2], found: &Relocation) -> PairRow {
    let in_unit = |estimate: Estimate<Length>, unit: f64| estimate.map(|length| length.si() * unit);
    let overlap = found.before.length().si();
    let [before, after] = names.clone();
    PairRow {
        before,
        after,
        shift_um: in_unit(found.shift, MICRO),
        stretch_percent: found.stretch.map(|stretch| 100.0 * stretch),
        height_um: in_unit(found.height, MICRO),
        tilt_um_per_mm: found.tilt.map(|slope| 1e3 * slope),
        bow_um: found.bow.map(|bow| in_unit(bow, MICRO)),
        correlation: found.correlation,
        elsewhere: found.elsewhere,
        matched_percent: 100.0 * found.matched,
        noise_nm: found.noise.si() * NANO,
        overlap_mm: 1e3 * overlap,
        removed_um2: found.removed.value.si() * overlap * MICRO * MICRO,
        heights: Heights {
            removed_nm: in_unit(found.removed, NANO),
            lost_nm: in_unit(found.lost, NANO),
            gained_nm: in_unit(found.gained, NANO),
        },
    }
}

/// Both traces over the mean line of the first.
fn along(found: &Relocation) -> Result<Vec<ChangedPointRow>, asperity_roughness::RoughnessError> {
    let line = mean_line(&found.before, LAMBDA_C, Ends::Reg1)?;
    let [start, dx] = [found.start, found.before.spacing()].map(Length::si);
    let heights = found.before.heights().iter().zip(found.after.heights());
    let point = |(i, ((before, after), line)): (usize, ((&f64, &f64), f64))| ChangedPointRow {
        x_mm: 1e3 * (start + dx * i as f64),
        before_um: MICRO * (before - line),
        after_um: MICRO * (after - line),
        lost_nm: NANO * (before - after),
    };
    Ok(heights.zip(line).enumerate().map(point).collect())
}

/// Mean of the pairs. The valleys of all are chosen by one rule, so their errors are taken as common, and more pairs do not narrow it.
fn mean_of(pairs: &[Estimate]) -> Estimate {
    let of = |end: fn(&Estimate) -> f64| mean(pairs.iter().map(end));
    Estimate::new(of(|one| one.value), [of(|one| one.low), of(|one| one.high)])
}

/// A change as mean over the pairs \[µm\].
struct MeanChange<T> {
    of: T,
    before: f64,
    after: f64,
    floor: f64,
}

fn means<T: Copy>(pairs: &[Vec<Change<T>>]) -> impl Iterator<Item = MeanChange<T>> {
    let count = pairs.len() as f64;
    let first = pairs.first().map_or(&[][..], Vec::as_slice);
    first.iter().enumerate().map(move |(k, one)| {
        let each = || pairs.iter().map(|changes| &changes[k]);
        MeanChange {
            of: one.of,
            before: MICRO * mean(each().map(|change| change.before.si())),
            after: MICRO * mean(each().map(|change| change.after.si())),
            floor: MICRO * (mean(each().map(|change| change.floor.si().powi(2))) / count).sqrt(),
        }
    })
}

impl ParameterRow {
    /// Whether noise does not explain the change.
    pub(super) fn is_clear(&self) -> bool {
        self.change_um.abs() > self.floor_um
    }

    fn from_change(change: MeanChange<&'static str>) -> Self {
        Self {
            parameter: change.of,
            before_um: change.before,
            after_um: change.after,
            change_um: change.after - change.before,
            floor_um: change.floor,
        }
    }
}

impl CurveRow {
    fn from_change(change: MeanChange<f64>) -> Self {
        Self {
            material_ratio_percent: change.of,
            before_um: change.before,
            after_um: change.after,
            change_um: change.after - change.before,
            floor_um: change.floor,
        }
    }
}
