//! Computation of a study of running-in.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::case::{ContactName, LoadedCase, OperatingCase, RunningInPlan};
use asperity::core::cancel::checkpoint;
use asperity::gear::{FlankPoint, Gear};
use asperity::message::Warning;
use asperity::pipeline::{History, HistorySettings, Kept, history};
use asperity::profile_io::read::{ReadOptions, read};
use asperity::running_in::{limits, run_in};
use asperity::{PositionError, Run};
use asperity_core::quantity::{Pressure, Quantity, Torque};
use asperity_core::{Code, DomainError, Estimate, EstimateKeys, Fault, estimate_keys};
use asperity_report::{Settings as _, StudySettings, Watch, Work, settings};
use serde::Serialize;

use super::clock::{Clock, Fall, Tested, USUAL};
use super::course::{Course, Histories, done};
use super::flanks::{RunInTrace, after, traces};
use crate::change::{ChangeSettings, TracePair, TracePairs, WornFlank};

/// Most engagements over those of a test that a history goes to.
const BEYOND: f64 = 10.0;
/// Wear at which a history between traces ends, over the wear by the usual coefficient.
const MOST_WORN: f64 = 1e3;
/// Wear at which a history without a test ends, over the wear by the usual coefficient.
const UPPER: f64 = 10.0;
/// Engagements over which flanks flow at the ends of the range of the limit: it changes how much flows, and hardly how long.
pub(super) const OF_LIMITS: f64 = 128.0;
/// Part of the noise floor of a parameter, a 95 % bound to either side, from the middle to the 5 and 95 % quantiles.
const OF_FLOOR: f64 = 0.839;
/// States of a history, for its progress.
const STATES: usize = 30;
/// Runs whose time the history at a torque takes.
const RUNS: usize = 40;
/// Round-off of a sum of packages of wear.
const ROUND_OFF: f64 = 1e-9;
/// Cubic millimetres per newton metre in 1/Pa.
const MM3_PER_N_M: f64 = 1e9;

settings! {
    /// Settings of a study of running-in.
    pub struct RunningInSettings {
        /// Torques at the pinion at which the flanks run in, side by side [default: the torque of operation.running_in, else of the case]
        [value_name = "TORQUE", value_delimiter = ','] torque: Vec<Torque>,
        /// Engagements of a tooth of the pinion to which the history goes
        [value_name = "N"] engagements: f64 = 1000000.0,
        /// Traces of a flank before a test on these gears with this oil, at the first torque
        [value_name = "FILE", requires = "after"] before: Vec<PathBuf>,
        /// The traces of the same places after the test
        [value_name = "FILE", requires = "before"] after: Vec<PathBuf>,
        /// Engagements of a tooth of the pinion in the test
        [value_name = "N", requires = "before"] test_engagements: Option<f64>,
        /// Flank of the traces, pinion or wheel
        [value_name = "FLANK"] flank: WornFlank = "pinion",
    }
}

estimate_keys! {
    KKeys: "k_mm3_per_n_m" "k_quantiles_mm3_per_n_m";
    RqRatioKeys: "rq_ratio" "rq_ratio_quantiles";
}

/// Traces before and after a test in a history.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct TestPair {
    /// Flank of the traces.
    pub flank: WornFlank,
    /// Engagements of a tooth of the pinion in the test.
    pub engagements: f64,
    /// Rq after the test over Rq before it.
    #[serde(flatten, with = "RqRatioKeys")]
    pub rq_ratio: Estimate,
    /// The same by plastic flow without wear.
    pub plastic_rq_ratio: f64,
    /// Wear coefficient with the pressure of the asperities; `None` where plastic flow explains the change.
    #[serde(flatten, serialize_with = "KKeys::serialize")]
    pub k_mm3_per_n_m: Option<Estimate>,
}

/// Running-in of the flanks of a case.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct RunningInFound {
    /// Title of the case.
    pub title: String,
    /// Operating point.
    #[serde(skip)]
    pub conditions: String,
    /// Engagements of a tooth of the pinion to which the history goes.
    pub engagements: f64,
    /// Engagements of a tooth of the wheel for one of the pinion.
    pub of_wheel: f64,
    /// Loss of the flanks as measured \[W\], and its interval by the model.
    pub loss_w: f64,
    /// 5 and 95 % quantiles of this loss; `None` if the model has no uncertainty.
    pub loss_quantiles_w: Option<[f64; 2]>,
    /// Traces before and after a test; `None` without.
    pub test: Option<TestPair>,
    /// Running-in at each torque.
    pub courses: Vec<Course>,
    /// Warnings of the case, and of the readers.
    pub warnings: Vec<Warning>,
    /// Traces of the flanks at the end of the first course.
    #[serde(skip)]
    pub(super) flanks: Vec<RunInTrace>,
}

impl StudySettings for RunningInSettings {
    type Input = LoadedCase;
    type Found = RunningInFound;
    const COMMAND: &'static str = "running-in";
    const FUNCTION: &'static str = "running_in";
    const ABOUT: &'static str =
        "How flanks run in: roughness, film and loss over engagements, and at which torque";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] = &[
        &[("case", "demo/case.toml")],
        &[("case", "demo/case.toml"), ("torque", "100 N m,300 N m")],
        &[
            ("case", "demo/case.toml"),
            ("before", "before.csv"),
            ("after", "after.csv"),
            ("test_engagements", "1e6"),
        ],
    ];
    const METHOD: &'static str = "First the flanks flow: windows of both are pressed together under the whole load, without a film, at places \
        that fill traces and path evenly, and what flows at the shakedown limit stays off. Traces are periodic. This ends where a doubling of \
        the engagements changes Rq by less than 0.5 %. Then they wear by Archard's law from the pressure of the asperities, whose share of the load \
        follows from the film. A tooth of the wheel engages less often, by the numbers of teeth. Intervals are from 5 to 95 %: by the pressure \
        at which asperities flow and by the wear. Without traces of a test the wear coefficient is 3e-10 mm³/(N m) within a factor of ten \
        each way, a level from handbooks. Between traces before and after a test Rq falls with the logarithm of the engagements, which lost least on made pairs of three \
        kinds of running-in; the interval contains wear in proportion to the engagements too. Growth of a surface film is not modelled: it \
        can raise the boundary friction by up to 1.4 times, and friction that rises again late is missed.";
    const STEPS: &'static str = "states";

    fn work(&self, case: &LoadedCase) -> Result<Option<Work>, Fault> {
        let runs = RUNS * self.torque.len().max(1);
        Ok(Some(Work::new(vec![case.clone()], runs)))
    }

    fn run(&self, case: LoadedCase, watch: &Watch<'_>) -> Result<RunningInFound, Fault> {
        let test = self.measured()?;
        let case = by_rows(case)?;
        let cases = self.cases(&case)?;
        let steps = AtomicUsize::new(0);
        let total = STATES * cases.len();
        let step = || {
            let done = 1 + steps.fetch_add(1, Ordering::Relaxed);
            (watch.progress)(done.min(total), total);
        };
        let fresh = Run::new(&case).pictures(Kept::NoPictures).interval(true);
        let fresh = fresh.execute()?.into_only()?;
        step();
        let summary = &fresh.result.summary;
        let mut found = RunningInFound {
            title: case.case.title.clone(),
            conditions: case.case.conditions(),
            engagements: self.engagements,
            of_wheel: f64::from(case.case.gears.teeth[0]) / f64::from(case.case.gears.teeth[1]),
            loss_w: summary.loss_w,
            loss_quantiles_w: fresh
                .result
                .uncertainty
                .as_ref()
                .map(|of| of.loss.quantiles_w),
            test: None,
            courses: Vec::new(),
            warnings: fresh.result.warnings.clone(),
            flanks: Vec::new(),
        };
        if let Some((_, warnings)) = &test {
            found.warnings.extend(warnings.iter().cloned());
        }
        let mut clock = Clock::usual();
        for (k, case) in cases.iter().enumerate() {
            let case = Run::new(case).operating_case()?;
            let case = case.overridden(|over| over.offsets = Some(summary.offsets))?;
            let of_test = test.as_ref().map(|(ratio, _)| *ratio).filter(|_| k == 0);
            let (course, of_course, flanks) =
                self.course(&case, &clock, of_test, summary.loss_w, &step)?;
            if k == 0 {
                (found.flanks, found.test) =
                    (flanks, of_course.as_ref().map(|tested| self.pair(tested)));
                // At other torques the test says the coefficient only.
                if let Some(k) = of_course.and_then(|tested| tested.coefficient()) {
                    clock = Clock::Coefficient(k);
                }
            }
            found.courses.push(course);
        }
        (watch.progress)(total, total);
        Ok(found)
    }
}

/// The case with the rows of its scans that a run with `operation.running_in` takes instead of the patches that their lay asks for,
/// which do not run in.
fn by_rows(case: LoadedCase) -> Result<LoadedCase, Fault> {
    let is_by_lay = case.case.input.surface.contact.is_none() && case.surfaces.sheets().is_some();
    if is_by_lay {
        Ok(case.with(|input| input.surface.contact = Some(ContactName::Lines))?)
    } else {
        Ok(case)
    }
}

/// A course, the test in it, and the flanks at its end.
type Found = (Course, Option<Tested>, Vec<RunInTrace>);

impl RunningInSettings {
    /// Rq after the test over Rq before it, mean over the pairs, with the warnings of the readers; `None` without a test.
    fn measured(&self) -> Result<Option<(Estimate, Vec<Warning>)>, Fault> {
        self.check()?;
        if self.before.is_empty() {
            return Ok(None);
        }
        let of = |file: &Path| -> Result<_, Fault> {
            let reading = read(file, &ReadOptions::default())?;
            let name = reading.name.clone();
            let warnings = reading
                .warnings
                .iter()
                .map(|warning| Warning::new(warning.code(), format!("{name}: {warning}")))
                .collect::<Vec<_>>();
            Ok((name, reading.profile.clone(), warnings))
        };
        let pairs = self.before.iter().zip(&self.after).map(|(before, after)| {
            let ((before, first, of_first), (after, second, of_second)) = (of(before)?, of(after)?);
            let mut pair = TracePair::new([&before, &after], [first, second]);
            pair.warnings = [of_first, of_second].concat();
            Ok(pair)
        });
        let pairs = TracePairs::new(pairs.collect::<Result<_, Fault>>()?);
        let change = ChangeSettings::usual()?.run(pairs, &Watch::SILENT)?;
        let rq = change.parameters.iter().find(|row| row.parameter == "Rq");
        let rq = rq.ok_or_else(|| Fault::new(Code::E205, "the traces of the test have no Rq"))?;
        let [ratio, half] = [rq.after_um, OF_FLOOR * rq.floor_um].map(|um| um / rq.before_um);
        let ratio = Estimate::new(ratio, [ratio - half, ratio + half]);
        Ok(Some((ratio, change.warnings)))
    }

    fn check(&self) -> Result<(), Fault> {
        let rule = "must be from 1 to 1e10";
        let is_possible = |n: f64| (1.0..=1e10).contains(&n);
        let require = |name: &'static str, n: f64| {
            DomainError::require(is_possible(n), name, n, "-", rule).map_err(Fault::from)
        };
        require("engagements", self.engagements)?;
        if let Some(of_test) = self.test_engagements {
            require("test_engagements", of_test)?;
        }
        let refused = |message: String, help: &'static str| {
            Err(Fault::new(Code::E205, message).helping(help))
        };
        match (self.before.len(), self.after.len(), self.test_engagements) {
            (0, 0, None) => Ok(()),
            (0, 0, Some(_)) => refused(
                "test_engagements: the test has no traces".to_owned(),
                "Name the traces before and after it, or leave the setting out.",
            ),
            (before, after, _) if before != after => refused(
                format!(
                    "before: traces before and after the test do not pair: {before} and {after}"
                ),
                "Name for each trace before the test the trace of the same place after it.",
            ),
            (.., None) => refused(
                "test_engagements: the traces of the test need its engagements".to_owned(),
                "State the engagements of a tooth of the pinion in the test.",
            ),
            (.., Some(of_test)) if self.engagements > BEYOND * of_test => refused(
                format!(
                    "engagements: {} is beyond ten times the {} engagements of the test",
                    self.engagements, of_test
                ),
                "Ask for fewer engagements, or trace the flanks after more.",
            ),
            _ => Ok(()),
        }
    }

    /// The case with each torque of the running-in.
    fn cases(&self, case: &LoadedCase) -> Result<Vec<LoadedCase>, Fault> {
        if self.torque.is_empty() {
            return Ok(vec![match case.case.running_in {
                Some(_) => case.clone(),
                None => case.with_key("operation.running_in", "true")?,
            }]);
        }
        let at = |torque: &Torque| {
            let stated = format!("{} {}", torque.si(), Torque::SI_UNIT);
            let keyed = case.with_key(
                "operation.running_in",
                &format!("{{ torque = \"{stated}\" }}"),
            );
            keyed.map_err(|error| Fault::from(error).about("torque"))
        };
        self.torque.iter().map(at).collect()
    }

    /// The course at the torque of a case, with the Rq ratio of a test at this torque.
    fn course(
        &self,
        case: &OperatingCase,
        clock: &Clock,
        ratio: Option<Estimate>,
        fresh_w: f64,
        step: &(dyn Fn() + Sync),
    ) -> Result<Found, Fault> {
        let stated = case.case.running_in.as_ref();
        let torque = stated.map_or(case.case.torque, |plan| plan.torque);
        let plan = RunningInPlan {
            torque,
            engagements: Some(self.engagements),
        };
        let flank = self.flank as usize;
        let at = |limit: Pressure, worn: f64, engagements: f64| -> Result<History, Fault> {
            let settings = HistorySettings {
                plan: RunningInPlan {
                    torque,
                    engagements: Some(engagements),
                },
                limit,
                worn,
                least: ratio.map(|ratio| (flank, 2.0 * ratio.low - 1.0)),
            };
            let history = history(case, &settings, &|_| step())?;
            checkpoint().map_err(asperity::Error::from)?;
            Ok(history)
        };
        let [low, limit, high] = limits(&case.case).map_err(Fault::from)?;
        let most = match (clock, ratio) {
            (_, Some(_)) => MOST_WORN * USUAL,
            (Clock::Coefficient(k), None) => k.high,
            (Clock::Test(_), None) => UPPER * USUAL,
        };
        let middle = at(limit, most * self.engagements, self.engagements)?;
        let plastic = middle.steps.last().map_or(0.0, |step| step.engagements);
        let limited = plastic.min(OF_LIMITS);
        let ends = [at(low, 0.0, limited)?, at(high, 0.0, limited)?];
        let loss_w = middle.states[0].loss_w;
        let per_hour = case.case.speed.si() * 3600.0 / std::f64::consts::TAU;
        let histories = Histories {
            middle: &middle,
            ends: [&ends[0], &ends[1]],
            to_median: fresh_w / loss_w,
            per_hour,
        };
        let tested = ratio
            .zip(self.test_engagements)
            .map(|(measured, engagements)| {
                let rq = |heights: [f64; 2]| heights[flank];
                let first = rq(middle.states[0].heights.rq_um);
                let points = histories
                    .worn()
                    .map(|state| (state.worn, rq(state.heights.rq_um) / first));
                let points: Vec<(f64, f64)> = points.collect();
                Tested {
                    plastic: points.first().map_or(1.0, |(_, q)| *q),
                    fall: Fall::new(points),
                    flank,
                    engagements,
                    measured,
                }
            });
        let clock = match &tested {
            Some(tested) => Clock::Test(tested.clone()),
            None => clock.clone(),
        };
        let rows: Vec<_> = self.counts().map(|n| histories.row(n, &clock)).collect();
        let end = rows[rows.len() - 1];
        let done_engagements = done(&rows);
        let flanks = self.flanks_at_end(case, &histories, &plan, &clock)?;
        let last = histories.worn().last();
        let [most, share] = last.map_or([0.0; 2], |state| [state.worn, state.asperity_share]);
        // Flanks that a film parts do not wear on.
        let is_beyond = |n: &f64| match &tested {
            Some(tested) => !tested.fall.reaches(tested.ratio(*n).value),
            None => share > 0.0 && clock.worn(*n).high > (1.0 + ROUND_OFF) * most,
        };
        let ends_at = self.counts().find(is_beyond);
        let course = Course {
            torque_nm: torque.si(),
            plastic_engagements: histories.plastic(),
            is_settled: middle.is_settled,
            done_hours: done_engagements.map(|n| n / per_hour),
            done_engagements,
            factor: end.loss_w.map(|w| w / fresh_w),
            removed_mg: masses(case, [end.pinion_removed_nm, end.wheel_removed_nm])?,
            ends_at,
            rows,
        };
        Ok((course, tested, flanks))
    }

    /// Engagements of the rows: none, then three in ten times as many, and the last.
    fn counts(&self) -> impl Iterator<Item = f64> {
        let last = self.engagements;
        let tens = (0..=10).flat_map(|ten| [1.0, 2.0, 5.0].map(|n| n * 10_f64.powi(ten)));
        let between = tens.filter(move |n| *n < last);
        std::iter::once(0.0).chain(between).chain([last])
    }

    /// The traces of the flanks at the end of the history.
    fn flanks_at_end(
        &self,
        case: &LoadedCase,
        histories: &Histories<'_>,
        plan: &RunningInPlan,
        clock: &Clock,
    ) -> Result<Vec<RunInTrace>, Fault> {
        if self.engagements > histories.plastic() {
            let worn = clock.worn(self.engagements).value;
            let flanks = after(histories.worn(), worn)?;
            return flanks.map_or(Ok(Vec::new()), |flanks| traces(&flanks));
        }
        let ran_in = run_in(&case.case, &case.surfaces, plan, &|_| {})?;
        traces(&ran_in.surfaces)
    }

    /// The test in the result.
    fn pair(&self, tested: &Tested) -> TestPair {
        let in_unit = |k: Estimate| k.map(|k| MM3_PER_N_M * k);
        TestPair {
            flank: self.flank,
            engagements: tested.engagements,
            rq_ratio: tested.measured,
            plastic_rq_ratio: tested.plastic,
            k_mm3_per_n_m: tested.coefficient().map(in_unit),
        }
    }
}

/// Masses removed from all teeth of pinion and wheel \[mg\].
fn masses(case: &LoadedCase, removed_nm: [Estimate; 2]) -> Result<[f64; 2], Fault> {
    let gears = &case.case.gears;
    let path = gears.path();
    let of = |body: usize| -> Result<f64, Fault> {
        let gear = [Gear::Pinion, Gear::Wheel][body];
        let arc = |s| {
            gears
                .arc_of(gear, FlankPoint::Position(s))
                .map_err(PositionError::from)
        };
        let length = (arc(path.e)?.si() - arc(path.a)?.si()).abs();
        let area = length * gears.face_width.si() * f64::from(gears.teeth[body]);
        let density = case.case.materials[body].density.si();
        Ok(1e6 * density * area * 1e-9 * removed_nm[body].value)
    };
    Ok([of(0)?, of(1)?])
}
