//! Page, tables and summary of a fit to traction curves.

use std::fmt::Write as _;
use std::path::Path;

use asperity::result::loss_band::Digits;
use asperity_core::Fault;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use asperity_report::{StudyResult, tables};
use maud::{Markup, html};

use super::oil_fit::{FittedConstant, OilFit, TractionPointRow};
use super::selection::Dropped;
use crate::page::{files, notes, warnings};

/// The oil file.
const FILE: &str = "oil.toml";
/// Table of the points.
const POINTS: &str = "points.csv";
/// Curves of a chart.
const CURVES: usize = 6;

impl StudyResult for OilFit {
    const KIND: &'static str = "fit of traction curves";
    const NAME: &'static str = "oil_fit";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        let mut text = String::new();
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{:<38} {:>10}   {:<20} {:<20}",
            "constant", "value", "5 to 95 %", "family, 5 to 95 %"
        );
        text.extend(self.constants.iter().map(row));
        if !self.is_law_decided {
            let other = &self.other_law;
            let law = other.pressure_law.name();
            let _ = writeln!(text, "by the other law of pressure ({law})");
            text.extend(other.constants.iter().map(row));
        }
        let mut lines = self.sentences();
        for constant in &self.constants {
            if let Some(further) = &constant.would_help {
                lines.push(format!(
                    "{}: ten readings would help most at {further}",
                    constant.name
                ));
            }
        }
        text += &notes(&lines, &self.sources, &self.warnings);
        let _ = writeln!(
            text,
            "{FILE}, which a case names by lubricant.oil_file:\n{}",
            self.written()
        );
        text
    }

    fn page(&self, (): ()) -> String {
        let sections = [
            ("Constants", constants(self)),
            ("Measured and fitted", curves(self)),
            ("Residuals", residuals(self)),
            ("Dropped points", dropped(self)),
            ("Nuisance terms", nuisance(self)),
            (
                "Oil file",
                html! { p { "A case names it by " code { "lubricant.oil_file" } "." } pre { code { (self.written()) } } },
            ),
            ("Provenance", files(&self.sources)),
        ];
        page(
            &self.title,
            &format!("{} · fit of traction curves", self.program),
            &sections,
        )
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        asperity_report::write_text(&folder.join(FILE), &self.written())?;
        tables::write(&folder.join(POINTS), self.points.iter())
    }
}

impl OilFit {
    /// Fitted constants and points, in words.
    fn sentences(&self) -> Vec<String> {
        let [readings, points, kept] = self.counts;
        let counted = Dropped::ALL.into_iter().filter_map(|rule| {
            let count = self
                .points
                .iter()
                .filter(|row| row.dropped == Some(rule))
                .count();
            (count > 0).then(|| format!(", {count} dropped: {rule}"))
        });
        let films = self.points.iter().filter(|row| row.has_measured_film);
        let films = match films.count() {
            0 => String::new(),
            count => format!(", {count} with a measured film"),
        };
        let [best, other] = self.total_squared;
        let decided = match self.is_law_decided {
            true => "decided",
            false => "not decided",
        };
        let mut lines = vec![
            format!(
                "{readings} readings at {points} set points{films}, {kept} fitted{}",
                counted.collect::<String>()
            ),
            format!(
                "law of pressure {}: {decided}, sum of squares with the errors of the machine {best:.1} against {other:.1} of the other law",
                self.pressure_law.name()
            ),
            format!(
                "squares of the residuals per point {:.3}; the error of the law adds {:.0} %",
                self.squares_per_point,
                100.0 * self.law_error
            ),
        ];
        lines.extend(self.largest_deviation());
        lines
    }

    /// The text of the oil file.
    fn written(&self) -> String {
        self.oil_file()
            .map(|file| file.to_string())
            .unwrap_or_default()
    }
}

/// Line of a constant.
fn row(constant: &FittedConstant) -> String {
    let verdict = match constant.is_identified {
        true => "",
        false => "not identified",
    };
    let text = format!(
        "{:<38} {:>10}   {:<20} {:<20}  {verdict}",
        named(constant),
        by_interval(constant.value, constant.range),
        range(constant.range),
        range(constant.prior_range)
    );
    text.trim_end().to_owned() + "\n"
}

fn named(constant: &FittedConstant) -> String {
    match constant.unit.is_empty() {
        true => constant.name.clone(),
        false => format!("{} [{}]", constant.name, constant.unit),
    }
}

/// The value with the digits that its interval leaves.
fn by_interval(value: f64, interval: [f64; 2]) -> String {
    Digits::of_interval(interval).rounded(value)
}

pub(super) fn range(ends: [f64; 2]) -> String {
    let [low, high] = ends.map(|end| by_interval(end, ends));
    format!("({low}..{high})")
}

fn constants(fit: &OilFit) -> Markup {
    let percent = |share: f64| format!("{:.0} %", 100.0 * share);
    html! {
        @for line in fit.sentences() { p { (line) "." } }
        div.scroll { table {
            thead { tr { th { "constant" } th.number { "value" } th.number { "5 to 95 %" } th.number { "family" } th.number { "5 to 95 % of the family" }
                th.number { "by the other law" } th.number { "error left, expected" } th.number { "error left" } th { "by the points" } } }
            tbody { @for (one, other) in fit.constants.iter().zip(&fit.other_law.constants) { tr {
                th scope="row" { (named(one)) }
                td.number { (by_interval(one.value, one.range)) } td.number { (range(one.range)) }
                td.number { (by_interval(one.prior, one.prior_range)) } td.number { (range(one.prior_range)) }
                td.number { (by_interval(other.value, other.range)) }
                td.number { (percent(one.expected)) } td.number { (percent(one.posterior)) }
                td { @if one.is_identified { "identified" } @else { "not identified: the error of the family remains" }
                    @if let Some(further) = &one.would_help { "; ten readings would help most at " (further) } }
            } } }
        } }
        p { "5 to 95 %: the constant lies between these quantiles with a probability of 90 %. The oil file states the 2.5 % and 97.5 % quantiles. Error left: standard deviation after the points over the one of the family." }
        (warnings(&fit.warnings))
        h3 { "Correlations" }
        div.scroll { table {
            thead { tr { th { "constant" } @for one in &fit.constants { th.number { (one.name) } } } }
            tbody { @for (one, row) in fit.constants.iter().zip(&fit.correlations) { tr {
                th scope="row" { (one.name) } @for value in row { td.number { (format!("{value:+.2}")) } }
            } } }
        } }
    }
}

fn kept(fit: &OilFit) -> Vec<&TractionPointRow> {
    fit.points
        .iter()
        .filter(|row| row.fitted.is_some())
        .collect()
}

/// One chart for each set temperature.
fn curves(fit: &OilFit) -> Markup {
    let rows = kept(fit);
    let charts = fit.temperatures_c.iter().map(|set| {
        let of = rows.iter().copied().filter(|row| {
            let far = |at: f64| (at - row.temperature_c).abs();
            fit.temperatures_c
                .iter()
                .all(|other| far(*set) <= far(*other))
        });
        let of: Vec<&TractionPointRow> = of.collect();
        let mut numbers: Vec<usize> = of.iter().map(|row| row.curve).collect();
        numbers.dedup();
        let mut chart = Chart::new(
            &format!("curves-{set:.0}"),
            &format!("Friction at {set:.0} °C"),
            POINTS,
            Axis::new("slide-to-roll ratio", "%").log(),
            Axis::new("friction coefficient", "").from_zero(),
        );
        let curve = |number: usize| of.iter().copied().filter(move |row| row.curve == number);
        let shown = &numbers[..numbers.len().min(CURVES)];
        for number in shown {
            let name = curve(*number).next().map_or(String::new(), |row| {
                format!("{:.0} N, {} m/s", row.load_n, row.mean_speed_m_s)
            });
            let points = curve(*number).map(|row| [row.slide_roll_percent, row.traction]);
            chart
                .series
                .push(Series::through(&name, Line::Scatter, points));
        }
        // One series of all fits, parted by points that are not finite.
        let lines = shown.iter().flat_map(|number| {
            let points =
                curve(*number).filter_map(|row| Some([row.slide_roll_percent, row.fitted?]));
            points.chain([[f64::NAN; 2]])
        });
        chart.series.push(Series::through("fit", Line::Ink, lines));
        chart
    });
    html! {
        div.charts { @for chart in charts { (figure(&Drawing::Curves(chart))) } }
        p { "Dots: measured. Lines: fitted, with gain and zero." }
    }
}

fn residuals(fit: &OilFit) -> Markup {
    let rows = kept(fit);
    let over = |id: &str, title: &str, x: Axis, of: fn(&TractionPointRow) -> f64| {
        let chart = Chart::new(
            id,
            title,
            POINTS,
            x,
            Axis::new("measured - fitted", "sigma"),
        );
        let points = rows
            .iter()
            .filter_map(|row| Some([of(row), row.residual_sigma?]));
        let chart = chart
            .level(0.0, "")
            .with(Series::through("points", Line::Scatter, points));
        figure(&Drawing::Curves(chart))
    };
    html! { div.charts {
        (over("over-temperature", "Residuals over temperature", Axis::new("temperature", "°C"), |row| row.temperature_c))
        (over("over-pressure", "Residuals over pressure", Axis::new("largest Hertz pressure", "GPa"), |row| row.pressure_gpa))
        (over("over-slide", "Residuals over slide-to-roll ratio", Axis::new("slide-to-roll ratio", "%").log(), |row| row.slide_roll_percent))
    } }
}

fn dropped(fit: &OilFit) -> Markup {
    let rows: Vec<&TractionPointRow> = fit
        .points
        .iter()
        .filter(|row| row.dropped.is_some())
        .collect();
    html! { @if !rows.is_empty() { div.scroll { table {
        thead { tr { th { "reading" } th.number { "load" } th.number { "speed" } th.number { "slide-to-roll" } th.number { "temperature" } th.number { "friction" } th.number { "film over roughness" } th { "rule" } } }
        tbody { @for row in rows { tr {
            th scope="row" { (row.file) ":" (row.line) }
            td.number { (format!("{:.0} N", row.load_n)) } td.number { (row.mean_speed_m_s) " m/s" }
            td.number { (format!("{:.1} %", row.slide_roll_percent)) } td.number { (format!("{:.0} °C", row.temperature_c)) }
            td.number { (format!("{:.4}", row.traction)) } td.number { (format!("{:.1}", row.film_ratio)) }
            td { @if let Some(rule) = row.dropped { (rule.to_string()) } }
        } } }
    } } } }
}

fn nuisance(fit: &OilFit) -> Markup {
    html! {
        p { "For the fit to hold:" }
        div.scroll { table {
            thead { tr { th { "term" } th.number { "standard deviations" } } }
            tbody { @for term in &fit.nuisance { tr { td { (term.text) } td.number { (format!("{:+.2}", term.deviations)) } } } }
        } }
    }
}
