//! Reports of a calibration and of a design. Folder of a calibration: `calibration.json`, `calibration.toml` (the block), `points.csv`,
//! `calibration.html`. Folder of a design: `design.json`, `design.csv` to fill in, `design.html`, and on request `simulated.csv`.

use std::fmt::Write as _;

use asperity::message::Warning;
use asperity::result::loss_band::Digits;
use asperity_core::numerics::{self, distinct};
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Column, Kind, Report, StudyResult, Table, columns, duration};

use crate::birge::Scatter;
use crate::design::Design;
use crate::oil::is_simulated_source;
use crate::result::{Calibration, FittedParameter, FittedPoint, Verdict};
use crate::rig_table::{SIMULATED, SIMULATED_COLUMN};
use crate::summary::{
    BOOTSTRAPPED, HELD_OUT, before_and_after, design_bands, design_points, fitted, held_out,
    scatter, shown, unit_of,
};

/// Table of the points.
const POINTS: &str = "points.csv";

impl StudyResult for Calibration {
    const KIND: &'static str = KIND;
    const NAME: &'static str = "calibration";

    fn report(&self) -> Report<'_> {
        let kind = if self.is_simulated {
            "calibration on SIMULATED losses"
        } else {
            "calibration"
        };
        let parameters = self.parameters.iter();
        let names: Vec<&str> = parameters.map(|one| one.name.as_str()).collect();
        let report = Report::new(&self.title, format!("{kind}, {}", self.table))
            .section("Parameters")
            .verdict(self.is_simulated.then_some(REHEARSAL))
            .verdict(verdicts(self))
            .verdict(effect(self))
            .figures(|| [measured(self)])
            .table(fitted(self))
            .text([format!("Fit: {}.", scatter(self))])
            .method([BANDS])
            .heading("Correlations of the logarithms")
            .on_page()
            .table(correlations("parameter", &names, &self.correlations))
            .on_page();
        let report = if self.held_out.is_empty() {
            report
        } else {
            report.heading(HELD_OUT).table(held_out(self))
        };
        let report = report
            .warning(&self.warnings)
            .section("Residuals")
            .figures(|| residuals(self))
            .section("Profiles")
            .figures(|| profiles(self))
            .section("Identifiability")
            .text([by_derivatives(self)])
            .on_page()
            .table(before_and_after(self))
            .on_page();
        let report = if self.identifiability.helpful.is_empty() {
            report
        } else {
            report
                .heading("Further measurements that would help most")
                .on_page()
                .table(helpful(self))
                .on_page()
        };
        report
            .section("Nuisance terms")
            .table(nuisance(self))
            .on_page()
            .section("For the case")
            .heading(QUANTILES)
            .code(&self.block)
            .section("Provenance")
            .text(provenance(self))
            .on_page()
            .text_file("calibration.toml", self.block.clone())
            .rows(POINTS, || &self.points)
    }
}

impl StudyResult for Design {
    const KIND: &'static str = KIND;
    const NAME: &'static str = "design";

    fn report(&self) -> Report<'_> {
        let limits = &self.limits;
        let report = Report::new(
            &self.title,
            "design of a calibration",
        )
        .section("Points")
        .verdict([format!(
            "Measure these {} points with each of {} assemblies, in {} without heating (D-optimal, of {} candidates).",
            self.size() / limits.assemblies.max(1),
            limits.assemblies,
            duration(limits.minutes_per_point * self.size() as f64),
            self.candidates
        )])
        .verdict([deviations(self)])
        .text([WHEN])
        .figures(|| places(self))
        .table(design_points(self))
        .text([LOSSES])
        .on_page()
        .text(self.with_settings())
        .on_page()
        .section("Expected intervals")
        .heading(format!(
            "Expected with {:.1} % per point",
            100.0 * limits.sigma
        ))
        .table(design_bands(self))
        .text(self.kept_ranges())
        .on_page()
        .warning(&self.warnings)
        .text(
            self.simulated_w
                .as_ref()
                .map(|_| "simulated.csv contains SIMULATED losses at these points."),
        )
        .text_file("design.csv", rig_table(self, None));
        match &self.simulated_w {
            Some(losses) => report.text_file("simulated.csv", rig_table(self, Some(losses))),
            None => report,
        }
    }
}

/// Kind of both folders in messages.
const KIND: &str = "calibration";
/// Next step where no point helps.
const NO_NEXT: &str =
    "No further point within the limits of this rig narrows a parameter by a tenth.";
/// Use of a design, next to the command that compares measurements of one loss.
const WHEN: &str = "These points determine constants for other operating points and gears, by asperity calibrate. For the loss of one \
    case only, asperity evidence lists quicker measurements.";
/// Meaning of the losses of a design.
const LOSSES: &str = "Losses by the model with the constants of the case, to choose the range of the torque meter. They have no interval; \
    asperity map computes it.";
/// Note on simulated losses.
const REHEARSAL: &str = "SIMULATED losses: a rehearsal of a rig, not a measurement.";
/// Content of the bands.
const BANDS: &str = "The intervals include scatter and nuisance terms, but not the structure of the model: alternative models are \
    listed with a run.";

impl Design {
    /// What becomes of the parameters that the points do not identify.
    fn kept_ranges(&self) -> Option<&'static str> {
        let mut parameters = self.parameters.iter().map(|one| &one.identified);
        let is_any = parameters.any(|one| one.verdict == Verdict::NotIdentified);
        is_any.then_some(
            "The expected intervals are by the points alone. A parameter that they do not identify keeps the range that it had before.",
        )
    }

    /// The settings of the losses, in words; `None` of an older design.
    fn with_settings(&self) -> Option<String> {
        (!self.settings.is_empty()).then(|| {
            format!(
                "Settings of these losses: {}. A map with other settings, or with medians over the samples, has other losses.",
                self.settings
            )
        })
    }
}

/// Standard deviations of the parameters that the points leave, in words.
fn deviations(design: &Design) -> String {
    let of = |is_identified: bool| {
        let parameters = design.parameters.iter().map(|one| &one.identified);
        let parameters =
            parameters.filter(move |one| (one.verdict != Verdict::NotIdentified) == is_identified);
        let left = parameters.filter_map(|one| {
            let percent = 100.0 * one.deviation?;
            Some(format!("{} {percent:.0} %", one.name))
        });
        left.collect::<Vec<_>>().join(", ")
    };
    let others = of(false);
    let others = (!others.is_empty()).then(|| format!("not identified: {others}"));
    let parts = [Some(of(true)).filter(|found| !found.is_empty()), others];
    format!(
        "Standard deviations by these points alone, without the range known before: {}.",
        parts.into_iter().flatten().collect::<Vec<_>>().join("; ")
    )
}

/// The parameters that the points determine, with their bands, those that they do not, and the point that would help most, in
/// words.
fn verdicts(calibration: &Calibration) -> Vec<String> {
    let of = |verdict: Verdict, text: &dyn Fn(&FittedParameter) -> String| {
        let parameters = calibration.parameters.iter();
        let wanted = parameters.filter(|one| one.verdict == verdict).map(text);
        wanted.collect::<Vec<String>>().join(", ")
    };
    let with_band = |one: &FittedParameter| format!("{} {}", one.name, shown(&one.key, one.fitted));
    let determined = of(Verdict::Identified, &with_band);
    let held = of(Verdict::Partly, &|one| {
        format!(
            "{}, before {}",
            with_band(one),
            shown(&one.key, one.default)
        )
    });
    let others = of(Verdict::NotIdentified, &|one| one.name.clone());
    let mut verdicts = vec![if determined.is_empty() {
        "The points identify no parameter.".to_owned()
    } else {
        format!("Identified by the points, in brackets 5 to 95 %: {determined}.")
    }];
    if !held.is_empty() {
        verdicts.push(format!("Identified in part: {held}."));
    }
    if !others.is_empty() {
        verdicts.push(format!(
            "Not identified, not written to the case: {others}."
        ));
    }
    let next = calibration.identifiability.next();
    let next = next.map(|point| {
        format!(
            "Measure next: {:.0} N m, {:.0} 1/min, {:.0} °C, for {}.",
            point.torque_nm, point.speed_rpm, point.temperature_c, point.gains_most
        )
    });
    verdicts.push(next.unwrap_or_else(|| NO_NEXT.to_owned()));
    verdicts
}

/// Change of the loss at the points by the constants of the block, in words; `None` of a block without constants.
fn effect(calibration: &Calibration) -> Option<String> {
    let is_written = |one: &FittedParameter| one.verdict != Verdict::NotIdentified;
    let points = calibration.points.iter();
    let changes = points.map(|point| 100.0 * (point.calibrated_w / point.default_w - 1.0));
    let changes: Vec<f64> = changes.collect();
    let [low, high] = numerics::range(changes.iter().copied());
    let [mean, low, high] =
        [numerics::mean(changes), low, high].map(|change| Digits::of_decimals(0).signed(change));
    calibration.parameters.iter().any(is_written).then(|| {
        format!(
            "The constants for the case change the loss of the mesh at these points by {mean} % in the mean ({low} to {high} %)."
        )
    })
}

/// Note on simulated sources of curves; `None` without them.
pub(crate) fn rehearsal(sources: &[[String; 2]]) -> Option<String> {
    let is_simulated = sources.iter().any(is_simulated_source);
    is_simulated.then(|| format!("{SIMULATED} curves: a rehearsal, not a measurement."))
}

/// Heading of the constants for a case.
pub(crate) const QUANTILES: &str =
    "A case file takes the 2.5 % and 97.5 % quantiles as low and high";

/// The end of a report of curves: sentences and warnings.
pub(crate) fn notes<'a>(
    report: Report<'a>,
    sentences: Vec<String>,
    warnings: &[Warning],
) -> Report<'a> {
    report.text(sentences).warning(warnings)
}

/// Files with their SHA-256.
pub(crate) fn files(sources: &[[String; 2]]) -> Table {
    columns! { [file, sum] in sources;
        code file "file" "" = file;
        code sum "SHA-256" "" = sum;
    }
}

/// Correlations of named quantities with each other.
pub(crate) fn correlations(first: &str, names: &[&str], rows: &[Vec<f64>]) -> Table {
    let names_of_rows = Column::new(Kind::Head, first, "", names);
    let columns = names.iter().enumerate().map(|(k, name)| {
        let cells = rows.iter().map(|row| format!("{:+.2}", row[k]));
        Column::new(Kind::Number, name, "", cells)
    });
    Table::new([names_of_rows]).with(columns)
}

/// Points grouped by temperature.
fn by_temperature<'a>(calibration: &'a Calibration) -> Vec<(f64, Vec<&'a FittedPoint>)> {
    let of = |at: f64| {
        let nearest = |point: &&FittedPoint| {
            let all = calibration.identifiability.temperatures_c.iter().copied();
            let far = |other: f64| (other - point.temperature_c).abs();
            all.fold(f64::INFINITY, |best, other| {
                if far(other) < far(best) { other } else { best }
            }) == at
        };
        calibration
            .points
            .iter()
            .filter(nearest)
            .collect::<Vec<&'a FittedPoint>>()
    };
    calibration
        .identifiability
        .temperatures_c
        .iter()
        .map(|at| (*at, of(*at)))
        .collect()
}

fn series(calibration: &Calibration, of: impl Fn(&FittedPoint) -> [f64; 2]) -> Vec<Series> {
    by_temperature(calibration)
        .into_iter()
        .map(|(at, points)| {
            let points = points.into_iter().map(&of);
            Series::through(&format!("{at:.0} °C"), Line::Scatter, points)
        })
        .collect()
}

fn charted(mut chart: Chart, series: Vec<Series>) -> Drawing {
    chart.series = series;
    Drawing::Curves(chart)
}

fn measured(calibration: &Calibration) -> Drawing {
    let losses = calibration
        .points
        .iter()
        .flat_map(|point| [point.measured_w, point.fitted_w]);
    let [low, high] = losses.fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], loss| {
        [low.min(loss), high.max(loss)]
    });
    let mut all = series(calibration, |point| [point.fitted_w, point.measured_w]);
    all.push(Series::new(
        "equal",
        Line::Dashed,
        &[low, high],
        &[low, high],
    ));
    let chart = Chart::new(
        "measured",
        "Measured against fitted loss",
        POINTS,
        Axis::new("fitted loss", "W").log(),
        Axis::new("measured loss", "W").log(),
    );
    charted(chart, all)
}

fn residuals(calibration: &Calibration) -> [Drawing; 3] {
    let over = |id: &str, title: &str, x: Axis, of: fn(&FittedPoint) -> f64| {
        let y = Axis::new("ln(measured/fitted)", "sigma");
        let chart = Chart::new(id, title, POINTS, x, y).level(0.0, "");
        charted(
            chart,
            series(calibration, |point| [of(point), point.residual_sigma]),
        )
    };
    let axis = Axis::new;
    [
        over(
            "over-speed",
            "Residuals over speed",
            axis("speed", "1/min").log(),
            |point| point.speed_rpm,
        ),
        over(
            "over-torque",
            "Residuals over torque",
            axis("torque", "N m"),
            |point| point.torque_nm,
        ),
        over(
            "over-temperature",
            "Residuals over temperature",
            axis("temperature", "°C"),
            |point| point.temperature_c,
        ),
    ]
}

fn profiles(calibration: &Calibration) -> Vec<Drawing> {
    let scatter = Scatter {
        chi_squared: calibration.chi_squared,
        freedom: calibration.freedom,
    };
    let drawn = |one: &FittedParameter| {
        let (unit, factor) = unit_of(&one.key);
        let x: Vec<f64> = one.profile.iter().map(|[at, _]| factor * at).collect();
        let y: Vec<f64> = one.profile.iter().map(|[_, rise]| *rise).collect();
        let chart = Chart::new(
            &format!("profile-{}", one.key),
            &format!("Profile of {}", one.name),
            "calibration.json",
            Axis::new(&one.name, unit),
            Axis::new("rise of the sum of squares", "").from_zero(),
        );
        let chart = chart.level(scatter.quantile(0.9).powi(2), "5 and 95 %");
        charted(chart, vec![Series::new(&one.name, Line::Dots, &x, &y)])
    };
    calibration.parameters.iter().map(drawn).collect()
}

/// The standard deviations before the fit, in words.
fn by_derivatives(calibration: &Calibration) -> String {
    let design = &calibration.identifiability;
    let range = design.lambda_star.map_or(String::new(), |[low, high]| {
        format!(", Lambda* from {low:.2} to {high:.2}")
    });
    format!(
        "{} operating points{range}. Standard deviations of the logarithms. Those expected are from the derivatives of the \
        model at the values of the case, before the fit, each without its own prior. Those after the fit are from the intervals, \
        which include the priors. The priors are wider than the ranges without calibration, so that they decide only what the points \
        leave open.",
        design.points
    )
}

fn helpful(calibration: &Calibration) -> Table {
    columns! { one in &calibration.identifiability.helpful;
        number torque_nm "torque" "N m" "{:.0}";
        number speed_rpm "speed" "1/min" "{:.0}";
        number temperature_c "temperature" "°C" "{:.0}";
        text gains_most "helps most" "";
        percent now "expected by the points" "%" "{:.1}" = one.deviation[0];
        percent then "expected with this one" "%" "{:.1}" = one.deviation[1];
    }
}

fn nuisance(calibration: &Calibration) -> Table {
    columns! { row in &calibration.nuisance;
        head name "term" "";
        number value "value" "" "{:.3}";
        number deviation "standard deviation" "" "{:.3}";
        number prior "standard deviation of the prior" "" "{:.3}";
        text unit "unit" "";
    }
}

fn provenance(calibration: &Calibration) -> Vec<String> {
    let evidence = &calibration.evidence;
    let mut lines = vec![
        format!(
            "Table {}, SHA-256 {}.",
            calibration.table, calibration.sha256
        ),
        format!(
            "{} evaluations of the model with stored contacts, {} response surfaces. The last one differs from the model by at most \
            {:.3} %, {:.2} sigma.",
            evidence.evaluations,
            evidence.rounds,
            100.0 * evidence.largest_surface_error,
            evidence.largest_surface_error_sigma
        ),
    ];
    if calibration.assemblies.len() >= BOOTSTRAPPED {
        lines.push(format!(
            "{} samples of the bootstrap.",
            evidence.bootstrap_samples
        ));
    }
    let stages = calibration.stages.iter();
    lines.extend(stages.map(|stage| format!("Stage: {} ({} points).", stage.name, stage.points)));
    lines
}

/// The points of a design over speed and torque: the same point may be measured at several temperatures.
fn places(design: &Design) -> Vec<Drawing> {
    let points = &design.points;
    let temperatures = distinct(points.iter().map(|point| point.temperature_c));
    // The same axes at all temperatures, with room for the marks.
    let [low, high] = numerics::range(points.iter().map(|point| point.speed_rpm));
    let torques = points.iter().map(|point| 1.1 * point.torque_nm);
    let [least, most] = numerics::range(torques.chain([0.0]));
    let at_temperature = |at: &f64| {
        let chosen = points.iter().filter(|point| point.temperature_c == *at);
        let coordinates = chosen.map(|point| [point.speed_rpm, point.torque_nm]);
        let chart = Chart::new(
            &format!("design-{at:.0}"),
            &format!("Points to measure at {at:.0} °C"),
            "design.csv",
            Axis::new("speed", "1/min")
                .log()
                .within(low / 1.5, 1.5 * high),
            Axis::new("torque", "N m").within(least, most),
        );
        let series = Series::through("point", Line::Scatter, coordinates);
        charted(chart, vec![series])
    };
    temperatures.iter().map(at_temperature).collect()
}

/// Rig table for `design`, with empty or simulated losses.
fn rig_table(design: &Design, simulated: Option<&[f64]>) -> String {
    let mut text = String::new();
    if simulated.is_some() {
        text.push_str(&format!(
            "# {SIMULATED} by {}: not measured\n",
            design.program
        ));
    }
    let [heading, mark] = match simulated {
        Some(_) => [format!(",{SIMULATED_COLUMN}"), ",true".to_owned()],
        None => Default::default(),
    };
    let _ = writeln!(
        text,
        "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,assembly,order,includes,flank_state{heading}"
    );
    for (k, (number, assembly)) in design.rows().enumerate() {
        let point = &design.points[number];
        let loss = simulated.and_then(|losses| losses.get(k));
        let measured = loss.map_or(",".to_owned(), |loss| {
            format!("{loss:.3},{:.3}", design.limits.sigma * loss)
        });
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{},{},{},{measured},{},{},mesh,{mark}",
            point.torque_nm,
            point.speed_rpm,
            point.temperature_c,
            assembly + 1,
            k + 1
        );
    }
    text
}
