//! Report of a study of running-in: how long, what it is worth, at which torque, and the flanks over engagements.

use asperity::result::loss_band::Digits;
use asperity_core::{Estimate, decimals};
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Cell, Report, StudyResult, Table, columns};

use super::course::{Course, CourseRow};
use super::study::{RunningInFound, TestPair};
use crate::change::digits::{digits, shown};

/// Table of the rows of all torques.
const TABLE: &str = "running_in.csv";
/// Last places that are printed: of a roughness \[µm\], a share, and a loss over another.
const LEAST_UM: f64 = 0.001;
const LEAST_SHARE: f64 = 0.001;
/// Unit of a printed wear coefficient, in mm³/(N m).
const NANO: f64 = 1e-9;

impl StudyResult for RunningInFound {
    const KIND: &'static str = "study of running-in";
    const NAME: &'static str = "running_in";

    fn report(&self) -> Report<'_> {
        let first = &self.courses[0];
        let mut report = Report::new(&self.title, "running-in")
            .section("What running-in saves")
            .verdict([worth(self, first), how_long(first)])
            .verdict(no_flow(first))
            .verdict(best(&self.courses))
            .text(self.test.as_ref().map(of_test))
            .text(self.courses.iter().flat_map(|course| remarks(course, self.engagements)))
            .at(&self.conditions)
            .table(courses(self))
            .section("Over the engagements")
            .figures(|| charts(self))
            .table(rows(self))
            .warning(&self.warnings)
            .section("Flanks run in")
            .text([format!(
                "The folder has the flanks after {} engagements at {} as a run takes them, with their filters. To run them:",
                count(self.engagements),
                newton_metres(first.torque_nm)
            )])
            .on_page()
            .code(KEYS)
            .on_page();
        for flank in &self.flanks {
            report = report.rows(flank.file.clone(), || flank.points());
        }
        report
    }
}

/// Keys by which a case takes the flanks.
const KEYS: &str = "[surface]\nform = \"none\"\ncutoff = \"0 mm\"\nnoise_cutoff = \"0 um\"\npinion = { file = \"pinion.csv\" }\n\
    wheel = { file = \"wheel.csv\" }\n";

fn newton_metres(torque: f64) -> String {
    format!("{} N m", decimals(torque, 1))
}

/// A number of engagements in words.
fn count(engagements: f64) -> String {
    if engagements < 1e4 {
        decimals(engagements, 0)
    } else {
        format!("{engagements:.1e}").replace(".0e", "e")
    }
}

/// Loss run in and fresh.
fn worth(found: &RunningInFound, course: &Course) -> String {
    let percent = course.factor.map(|factor| 100.0 * factor);
    let run_in = course.rows[course.rows.len() - 1].loss_w.value;
    let power = |w: f64| Digits::of_power(w).rounded(w);
    format!(
        "After {} engagements at {} the mesh loses {} of what it loses with fresh flanks: {} W instead of {} W.",
        count(found.engagements),
        newton_metres(course.torque_nm),
        digits(percent, 0.1).interval_with(" %", percent),
        power(run_in),
        power(found.loss_w)
    )
}

/// Engagements that running-in takes.
fn how_long(course: &Course) -> String {
    match (course.done_engagements, course.done_hours) {
        (Some(engagements), Some(hours)) => {
            let seconds = 3600.0 * hours;
            let time = match seconds {
                short if short < 0.5 => "less than 1 s".to_owned(),
                short if short < 120.0 => format!("{} s", decimals(short, 0)),
                long if long < 7200.0 => format!("{} min", decimals(long / 60.0, 0)),
                _ => format!("{} h", decimals(hours, 1)),
            };
            format!(
                "90 % of the change of Rq are done after {} engagements of a tooth of the pinion ({time}).",
                count(engagements)
            )
        }
        _ => "Rq does not change.".to_owned(),
    }
}

/// That flanks change by wear only, where nothing flows.
fn no_flow(course: &Course) -> Option<&'static str> {
    /// Height removed that is none \[nm\].
    const NONE: f64 = 0.01;
    let flowed = course
        .rows
        .iter()
        .rev()
        .find(|row| row.engagements <= course.plastic_engagements)?;
    let removed = flowed
        .pinion_removed_nm
        .value
        .max(flowed.wheel_removed_nm.value);
    (removed < NONE).then_some("Nothing flows: only wear changes these flanks.")
}

/// The torque that leaves the least loss; `None` of one.
fn best(courses: &[Course]) -> Option<String> {
    let by_factor = |a: &&Course, b: &&Course| a.factor.value.total_cmp(&b.factor.value);
    let best = courses.iter().min_by(by_factor)?;
    (courses.len() > 1).then(|| {
        format!(
            "Of these torques {} leaves the least loss.",
            newton_metres(best.torque_nm)
        )
    })
}

/// Findings of the test.
fn of_test(test: &TestPair) -> String {
    let percent = test.rq_ratio.map(|ratio| 100.0 * (ratio - 1.0));
    let measured = digits(percent, 0.1).interval_with(" %", percent);
    let wear = match test.k_mm3_per_n_m {
        Some(k) => {
            let k = k.map(|k| k / NANO);
            format!(
                "The rest is wear by {} times 1e-9 mm³/(N m) of the pressure of the asperities",
                Digits::of_interval(k.ends()).interval(k)
            )
        }
        None => "Plastic flow explains all of it, so that no wear coefficient follows".to_owned(),
    };
    format!(
        "In the test Rq of the {} changed by {measured} in {} engagements; plastic flow alone changes it by {:+.1} %. {wear}. Between the traces \
        Rq falls with the logarithm of the engagements.",
        test.flank.name(),
        count(test.engagements),
        100.0 * (test.plastic_rq_ratio - 1.0)
    )
}

/// Limits of the history at a torque.
fn remarks(course: &Course, engagements: f64) -> Vec<String> {
    let torque = newton_metres(course.torque_nm);
    let settled = (!course.is_settled && course.plastic_engagements < engagements).then(|| {
        format!(
            "At {torque} a doubling to {} engagements still changes Rq by more than 0.5 %: what flows after them is left out.",
            count(course.plastic_engagements)
        )
    });
    let ends = course.ends_at.map(|n| {
        format!(
            "At {torque} the wear of the model ends early: from {} engagements on the history, or the upper end of its interval, stays.",
            count(n)
        )
    });
    settled.into_iter().chain(ends).collect()
}

fn courses(found: &RunningInFound) -> Table {
    let last = |course: &Course| course.rows[course.rows.len() - 1];
    columns! { course in &found.courses;
        head torque "run in at" "" = newton_metres(course.torque_nm);
        interval factor "loss run in over fresh" "" = shown(course.factor, LEAST_SHARE);
        text done "90 % done after" "engagements" = course.done_engagements.map_or("-".to_owned(), count);
        interval pinion_rq "Rq pinion" "µm" = shown(last(course).pinion_rq_um, LEAST_UM);
        interval wheel_rq "Rq wheel" "µm" = shown(last(course).wheel_rq_um, LEAST_UM);
        text removed "removed from pinion and wheel" "mg" =
            format!("{} and {}", decimals(course.removed_mg[0], 2), decimals(course.removed_mg[1], 2));
    }
}

fn rows(found: &RunningInFound) -> Table {
    let all = found
        .courses
        .iter()
        .flat_map(|course| course.rows.iter().map(move |row| (course.torque_nm, row)));
    let power = |of: Estimate| Cell::interval(of);
    let table = columns! { (torque, row) in all;
        number torque_nm "run in at" "N m" "{:.1}" = torque;
        number engagements "engagements" "" = Cell::number(row.engagements, count);
        number hours "time" "h" = Cell::number(row.hours, |hours| format!("{hours:.3}"));
        interval pinion_rq_um "Rq pinion" "µm" = shown(row.pinion_rq_um, LEAST_UM);
        interval wheel_rq_um "Rq wheel" "µm" = shown(row.wheel_rq_um, LEAST_UM);
        interval pinion_rpk_um "Rpk pinion" "µm" = shown(row.pinion_rpk_um, LEAST_UM);
        interval wheel_rpk_um "Rpk wheel" "µm" = shown(row.wheel_rpk_um, LEAST_UM);
        interval pinion_removed_nm "removed from pinion" "nm" = shown(row.pinion_removed_nm, 0.1);
        interval wheel_removed_nm "removed from wheel" "nm" = shown(row.wheel_removed_nm, 0.1);
        interval asperity_share_mean "asperity share" "" = shown(row.asperity_share, LEAST_SHARE);
        interval film_ratio_mean "film over Rq" "" = shown(row.film_ratio, LEAST_SHARE);
        interval loss_w "loss" "W" = power(row.loss_w);
    };
    table.in_file(TABLE)
}

/// Quantity of a chart: identifier, title, unit, and the curves with their names.
type Shown = (
    &'static str,
    &'static str,
    &'static str,
    &'static [(&'static str, fn(&CourseRow) -> Estimate)],
);

/// The charts of the first torque.
const SHOWN: [Shown; 4] = [
    (
        "rq",
        "Rq",
        "µm",
        &[
            ("pinion", |row| row.pinion_rq_um),
            ("wheel", |row| row.wheel_rq_um),
        ],
    ),
    (
        "rpk",
        "Rpk",
        "µm",
        &[
            ("pinion", |row| row.pinion_rpk_um),
            ("wheel", |row| row.wheel_rpk_um),
        ],
    ),
    (
        "share",
        "Share of the load on asperities",
        "",
        &[("share", |row| row.asperity_share)],
    ),
    (
        "ratio",
        "Film over Rq",
        "",
        &[("ratio", |row| row.film_ratio)],
    ),
];

fn charts(found: &RunningInFound) -> Vec<Drawing> {
    let axis = || Axis::new("engagements of a tooth of the pinion", "").log();
    let mut charts = Vec::new();
    let loss = Chart::new(
        "loss",
        "Loss of the mesh",
        TABLE,
        axis(),
        Axis::new("loss", "W"),
    );
    let names: Vec<String> = found
        .courses
        .iter()
        .map(|course| newton_metres(course.torque_nm))
        .collect();
    let of_loss = |row: &CourseRow| row.loss_w;
    let losses = found.courses.iter().zip(&names);
    let losses: Vec<CourseCurve<'_>> = losses
        .map(|(course, name)| {
            (
                name.as_str(),
                course,
                &of_loss as &dyn Fn(&CourseRow) -> Estimate,
            )
        })
        .collect();
    charts.push(Drawing::Curves(curves(loss, &losses)));
    let course = &found.courses[0];
    for (id, title, unit, shown) in SHOWN {
        let chart = Chart::new(id, title, TABLE, axis(), Axis::new(title, unit));
        let all: Vec<CourseCurve<'_>> = shown
            .iter()
            .map(|(name, of)| (*name, course, of as &dyn Fn(&CourseRow) -> Estimate))
            .collect();
        let chart = curves(chart, &all);
        let chart = match (&found.test, id) {
            (Some(test), "rq") => {
                let first = shown[test.flank as usize].1(&course.rows[0]).value;
                let points = [
                    [1.0, first],
                    [test.engagements, first * test.rq_ratio.value],
                ];
                chart.with(Series::through("traces of the test", Line::Scatter, points))
            }
            _ => chart,
        };
        charts.push(Drawing::Curves(chart));
    }
    charts
}

/// A curve: its name, its course and its quantity.
type CourseCurve<'a> = (&'a str, &'a Course, &'a dyn Fn(&CourseRow) -> Estimate);

/// Curves from the first engagement on, then their bands.
fn curves(chart: Chart, curves: &[CourseCurve<'_>]) -> Chart {
    let rows = |course: &Course| {
        let rows = course.rows.iter().filter(|row| row.engagements >= 1.0);
        rows.copied().collect::<Vec<CourseRow>>()
    };
    let over = |course: &Course, of: &dyn Fn(&CourseRow) -> f64| -> Vec<f64> {
        rows(course).iter().map(of).collect()
    };
    let x = |course: &Course| over(course, &|row| row.engagements);
    let with_lines = curves.iter().fold(chart, |chart, (name, course, of)| {
        chart.curve(
            name,
            Line::Solid,
            &x(course),
            &over(course, &|row| of(row).value),
        )
    });
    curves
        .iter()
        .enumerate()
        .fold(with_lines, |chart, (k, (name, course, of))| {
            let [low, high] = [
                over(course, &|row| of(row).low),
                over(course, &|row| of(row).high),
            ];
            chart.with(Series::band_of(
                k,
                &format!("{name}, 5 to 95 %"),
                &x(course),
                &low,
                &high,
            ))
        })
}
