//! Pages of a calibration and of a design.

use asperity::message::Warning;
use asperity_core::numerics::distinct;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use asperity_report::{Column, Kind, Table, columns, wrapped};
use maud::{Markup, Render, html};

use crate::birge::Scatter;
use crate::design::Design;
use crate::oil::is_simulated_source;
use crate::result::{Calibration, FittedParameter, FittedPoint, Verdict};
use crate::rig_table::SIMULATED;
use crate::summary::{
    HELD_OUT, design_bands, design_points, fitted, held_out, identified, range, scatter, shown,
    unit_of,
};

/// Table of the points.
const POINTS: &str = "points.csv";

pub(crate) fn render(calibration: &Calibration) -> String {
    let sections = [
        ("Parameters", parameters(calibration)),
        ("Measured and fitted", measured(calibration)),
        ("Residuals", residuals(calibration)),
        ("Profiles", profiles(calibration)),
        ("Identifiability", identifiability(calibration)),
        ("Nuisance terms", nuisance(calibration).render()),
        (
            "For the case",
            html! { pre { code { (calibration.block) } } },
        ),
        ("Provenance", provenance(calibration)),
    ];
    let kind = if calibration.is_simulated {
        "calibration on SIMULATED losses"
    } else {
        "calibration"
    };
    let subtitle = format!("{} · {kind}, {}", calibration.program, calibration.table);
    page(&calibration.title, &subtitle, &sections)
}

fn parameters(calibration: &Calibration) -> Markup {
    let parameters = calibration.parameters.iter();
    let names: Vec<&str> = parameters.map(|one| one.name.as_str()).collect();
    html! {
        p { strong { (verdict(calibration)) } }
        @if calibration.is_simulated {
            p { strong { "The losses of this table are simulated: " } "a rehearsal of a rig, not a measurement." }
        }
        (fitted(calibration))
        p { "Fit: " (scatter(calibration)) ". The bands include scatter and nuisance terms, but not the structure of the model: alternative models are listed with a run." }
        h3 { "Correlations of the logarithms" }
        (correlations("parameter", &names, &calibration.correlations))
        @if !calibration.held_out.is_empty() { h3 { (HELD_OUT) } }
        (held_out(calibration))
        (warnings(&calibration.warnings))
    }
}

/// The parameters that the points determine, with their bands, and those that they do not, in words.
fn verdict(calibration: &Calibration) -> String {
    let of = |is_wanted: &dyn Fn(Verdict) -> bool, text: &dyn Fn(&FittedParameter) -> String| {
        let parameters = calibration.parameters.iter();
        let wanted = parameters.filter(|one| is_wanted(one.verdict)).map(text);
        wanted.collect::<Vec<String>>().join(", ")
    };
    let with_band = |one: &FittedParameter| {
        let value = shown(&one.key, one.value);
        format!("{} {value} {}", one.name, range(&one.key, one.band))
    };
    let determined = of(&|verdict| verdict != Verdict::NotIdentified, &with_band);
    let others = of(&|verdict| verdict == Verdict::NotIdentified, &|one| {
        one.name.clone()
    });
    let determined = match determined.is_empty() {
        true => "The points determine no parameter".to_owned(),
        false => format!("Determined by the points: {determined}"),
    };
    match others.is_empty() {
        true => format!("{determined}."),
        false => format!("{determined}. Not determined, left at the default: {others}."),
    }
}

/// Last lines of the summary of a fit to curves: sentences, note on simulated sources, warnings.
pub(crate) fn notes(sentences: &[String], sources: &[[String; 2]], warnings: &[Warning]) -> String {
    let mut text = String::new();
    for line in sentences {
        text += &wrapped(line, "  ");
        text.push('\n');
    }
    if sources.iter().any(is_simulated_source) {
        text += &format!("{SIMULATED} curves: a rehearsal, not a measurement\n");
    }
    for warning in warnings {
        text += &wrapped(&warning.to_string(), "     ");
        text.push('\n');
    }
    text
}

pub(crate) fn warnings(warnings: &[Warning]) -> Markup {
    html! { @if !warnings.is_empty() {
        ul { @for warning in warnings { li { (warning.to_string()) } } }
    } }
}

/// Files with their SHA-256.
pub(crate) fn files(sources: &[[String; 2]]) -> Markup {
    html! { @for [file, sum] in sources { p { (file) ", SHA-256 " code { (sum) } } } }
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

fn charted(mut chart: Chart, series: Vec<Series>) -> Markup {
    chart.series = series;
    figure(&Drawing::Curves(chart))
}

fn measured(calibration: &Calibration) -> Markup {
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
    html! { div.charts { (charted(chart, all)) } }
}

fn residuals(calibration: &Calibration) -> Markup {
    let over = |id: &str, title: &str, x: Axis, of: fn(&FittedPoint) -> f64| {
        let y = Axis::new("ln(measured/fitted)", "sigma");
        let chart = Chart::new(id, title, POINTS, x, y).level(0.0, "");
        charted(
            chart,
            series(calibration, |point| [of(point), point.residual_sigma]),
        )
    };
    html! { div.charts {
        (over("over-speed", "Residuals over speed", Axis::new("speed", "1/min").log(), |point| point.speed_rpm))
        (over("over-torque", "Residuals over torque", Axis::new("torque", "N m"), |point| point.torque_nm))
        (over("over-temperature", "Residuals over temperature", Axis::new("temperature", "°C"), |point| point.temperature_c))
    } }
}

fn profiles(calibration: &Calibration) -> Markup {
    let scatter = Scatter {
        chi_squared: calibration.chi_squared,
        freedom: calibration.freedom,
    };
    let drawn = |one: &FittedParameter| {
        let (unit, factor, _) = unit_of(&one.key);
        let x: Vec<f64> = one.profile.iter().map(|[at, _]| factor * at).collect();
        let y: Vec<f64> = one.profile.iter().map(|[_, rise]| *rise).collect();
        let chart = Chart::new(
            &format!("profile-{}", one.key),
            &format!("Profile of {}", one.name),
            "calibration.json",
            Axis::new(&one.name, unit),
            Axis::new("rise of the sum of squares", "").from_zero(),
        );
        let chart = chart.level(scatter.quantile().powi(2), "95 %");
        charted(chart, vec![Series::new(&one.name, Line::Dots, &x, &y)])
    };
    html! { div.charts { @for one in &calibration.parameters { (drawn(one)) } } }
}

fn identifiability(calibration: &Calibration) -> Markup {
    let design = &calibration.identifiability;
    html! {
        p { (design.points) " operating points"
            @if let Some([low, high]) = design.lambda_star { (format!(", Lambda* from {low:.2} to {high:.2}")) }
            ". Before the fit, from the derivatives of the model; each parameter without its own prior." }
        (identified(&design.parameters))
        @if !design.helpful.is_empty() {
            h3 { "Further measurements that would help most" }
            (columns! { one in &design.helpful;
                number torque_nm "torque" "N m" "{:.0}";
                number speed_rpm "speed" "1/min" "{:.0}";
                number temperature_c "temperature" "°C" "{:.0}";
                text gains_most "helps most" "";
                number now "standard deviation now" "%" "{:.1}" = 100.0 * one.deviation[0];
                number then "with the point" "%" "{:.1}" = 100.0 * one.deviation[1];
            })
        }
    }
}

fn nuisance(calibration: &Calibration) -> Table {
    columns! { row in &calibration.nuisance;
        head name "term" "";
        number value "value" "" "{:.3}";
        number deviation "standard deviation" "" "{:.3}";
        number prior "of the prior" "" "{:.3}";
        text unit "unit" "";
    }
}

fn provenance(calibration: &Calibration) -> Markup {
    let evidence = &calibration.evidence;
    html! {
        p { "Table " code { (calibration.table) } ", SHA-256 " code { (calibration.sha256) } "." }
        p { (evidence.evaluations) " evaluations of the model with stored contacts, " (evidence.rounds) " response surfaces; the last one differs from the model by "
            (format!("{:.3} %", 100.0 * evidence.largest_surface_error)) " at most, "
            (format!("{:.2} sigma", evidence.largest_surface_error_sigma)) ". "
            (evidence.bootstrap_samples) " samples of the bootstrap." }
        @for stage in &calibration.stages {
            p { "Stage: " (stage.name) " (" (stage.points) " points)." }
        }
    }
}

pub(crate) fn render_design(design: &Design) -> String {
    let points = &design.points;
    let temperatures = distinct(points.iter().map(|point| point.temperature_c));
    // The same point may be measured at several temperatures.
    let at_temperature = |at: &f64| {
        let chosen = points.iter().filter(|point| point.temperature_c == *at);
        let coordinates = chosen.map(|point| [point.speed_rpm, point.torque_nm]);
        let chart = Chart::new(
            &format!("design-{at:.0}"),
            &format!("Points to measure at {at:.0} °C"),
            "design.csv",
            Axis::new("speed", "1/min").log(),
            Axis::new("torque", "N m").from_zero(),
        );
        charted(
            chart,
            vec![Series::through("point", Line::Scatter, coordinates)],
        )
    };
    let sections = [
        (
            "Points",
            html! { (warnings(&design.warnings)) div.charts { @for at in &temperatures { (at_temperature(at)) } } (design_points(design)) },
        ),
        ("Expected bands", design_bands(design).render()),
    ];
    let subtitle = format!("{} · design of a calibration", design.program);
    page(&design.title, &subtitle, &sections)
}
