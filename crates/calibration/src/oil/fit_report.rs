//! Report of a fit to traction curves.

use asperity::result::loss_band::Digits;
use asperity_core::Estimate;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Cell, Report, StudyResult, Table, columns};

use super::oil_fit::{FittedConstant, OilFit, TractionPointRow};
use super::selection::Dropped;
use crate::report::{correlations, files, notes, rehearsal};
use crate::summary::in_unit;

/// The oil file.
const FILE: &str = "oil.toml";
/// Table of the points.
const POINTS: &str = "points.csv";
/// Curves of a chart.
const CURVES: usize = 6;

impl StudyResult for OilFit {
    const KIND: &'static str = "fit of traction curves";
    const NAME: &'static str = "oil_fit";

    fn report(&self) -> Report<'_> {
        let names: Vec<&str> = self.constants.iter().map(|one| one.name.as_str()).collect();
        let other = &self.other_law;
        let simulated = rehearsal(&self.sources);
        let [dots, next] = match simulated {
            Some(_) => ["simulated, not measured", NEXT_OF_REHEARSAL],
            None => ["measured", NEXT],
        };
        let mut report = Report::new(&self.title, "fit of traction curves")
            .section("Constants")
            .verdict(&simulated)
            .verdict(self.verdicts())
            .text([next])
            .on_page()
            .figures(|| curves(self))
            .text([format!("Dots: {dots}. Lines: fitted, with gain and zero.")])
            .on_page()
            .table(
                constants(&self.constants)
                    .with(further(self))
                    .brief(&FOLDED)
                    .in_file("constants.csv"),
            );
        if !self.is_law_decided {
            report = report
                .heading(format!(
                    "By the other law of pressure ({})",
                    other.pressure_law.name()
                ))
                .table(constants(&other.constants).brief(&FOLDED));
        }
        let sentences = self.sentences().into_iter().chain(self.helpful());
        let report = notes(report, sentences.collect(), &self.warnings)
            .method([METHOD])
            .on_page()
            .heading("Correlations")
            .on_page()
            .table(correlations("constant", &names, &self.correlations))
            .on_page()
            .section("Residuals")
            .figures(|| residuals(self))
            .section("Dropped points")
            .table(dropped(self))
            .on_page();
        report
            .section("Nuisance terms")
            .text([NUISANCE])
            .on_page()
            .table(nuisance(self))
            .on_page()
            .section("Oil file")
            .text([format!("{FILE}, which a case names by lubricant.oil_file:")])
            .code(self.written())
            .section("Provenance")
            .table(files(&self.sources))
            .on_page()
            .text_file(FILE, self.written())
            .rows(POINTS, || &self.points)
    }
}

/// Columns that the page has and the terminal has no room for.
const FOLDED: [&str; 4] = [
    "family",
    "by the other law",
    "remaining error, as expected before",
    "remaining error",
];
/// Next step.
const NEXT: &str = "To use these constants, name the oil file in a case by lubricant.oil_file and run the case again. asperity evidence \
    then lists the measurements that narrow the interval of its loss further.";
/// Next step after a rehearsal.
const NEXT_OF_REHEARSAL: &str = "These constants are not for use: measure the points of the plan, then fit the measured curves.";
/// Meaning of the nuisance terms.
const NUISANCE: &str = "Errors of the machine that the fit assumes, the largest first, over the standard deviations of their priors.";
/// Meaning of the numbers.
const METHOD: &str = "5 to 95 %: the constant lies between these quantiles with a probability of 90 %. The oil file states the \
    2.5 % and 97.5 % quantiles. Remaining error: standard deviation after the points over the standard deviation of the \
    family. The family: oils of the same base. Not identified: the error of the family remains.";

impl OilFit {
    /// The constants that the points determine, with their intervals, those that they do not, and the law of pressure.
    fn verdicts(&self) -> Vec<String> {
        let (fitted, open): (Vec<_>, Vec<_>) =
            self.constants.iter().partition(|one| one.is_identified);
        let fitted = fitted.into_iter().map(|one| {
            let unit = match one.unit.as_str() {
                "" => String::new(),
                unit => format!(" {unit}"),
            };
            let digits = Digits::of_interval(one.fitted.ends());
            let value = digits.interval_with(&unit, one.fitted);
            format!("{} {value}", one.name)
        });
        let fitted: Vec<String> = fitted.collect();
        let open: Vec<&str> = open.into_iter().map(|one| one.name.as_str()).collect();
        let mut verdicts = vec![if fitted.is_empty() {
            "The points identify no constant.".to_owned()
        } else {
            format!(
                "Identified by the points, in brackets 5 to 95 %: {}.",
                fitted.join(", ")
            )
        }];
        let unsigned = self.constants.iter().filter(|one| {
            let [low, high] = one.fitted.ends();
            one.is_identified && low < 0.0 && high > 0.0
        });
        verdicts.extend(unsigned.map(|one| {
            format!(
                "The sign of the {} is open: its interval contains 0.",
                one.name
            )
        }));
        if !open.is_empty() {
            verdicts.push(format!("Not identified: {}.", open.join(", ")));
        }
        let law = self.pressure_law.name();
        verdicts.push(if self.is_law_decided {
            format!(
                "The viscosity in the film rises with the pressure by the law of {}{}.",
                law[..1].to_uppercase(),
                &law[1..]
            )
        } else {
            format!("The points do not decide the law of pressure; {law} fits best.")
        });
        verdicts
    }

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
        let decided = if self.is_law_decided {
            "The points decide"
        } else {
            "The points do not decide"
        };
        let mut lines = vec![
            format!(
                "{readings} readings at {points} set points{films}, {kept} fitted{}.",
                counted.collect::<String>()
            ),
            format!(
                "{decided} the law of pressure: the sum of squares is {best:.1} with {}, and {other:.1} with the other law.",
                self.pressure_law.name()
            ),
            format!(
                "Squares of the residuals per point {:.3}; the error of the law adds {:.0} %.",
                self.squares_per_point,
                100.0 * self.law_error
            ),
        ];
        lines.extend(self.largest_deviation());
        lines
    }

    /// Further readings that would determine a constant.
    fn helpful(&self) -> impl Iterator<Item = String> {
        self.constants.iter().filter_map(|constant| {
            let further = constant.would_help.as_ref()?;
            let name = &constant.name;
            Some(format!(
                "{name}: ten readings would help most at {further}."
            ))
        })
    }

    /// The text of the oil file.
    fn written(&self) -> String {
        self.oil_file()
            .map(|file| file.to_string())
            .unwrap_or_default()
    }
}

/// Fitted constants and the constants of the family.
fn constants(constants: &[FittedConstant]) -> Table {
    columns! { one in constants;
        head constant "constant" "" = Cell::shown(in_unit(&one.name, &one.unit), one.name.as_str().into());
        file unit = &one.unit;
        number value "value" "" = by_interval(one.fitted);
        range range "5 to 95 %" "" = range(one.fitted.ends());
        number prior "family" "" = by_interval(one.prior);
        range prior_range "5 to 95 % of the family" "" = range(one.prior.ends());
        text verdict "by the points" "" = if one.is_identified { "identified" } else { "not identified" };
    }
}

/// The value with the digits that its interval leaves.
fn by_interval(of: Estimate) -> Cell {
    let digits = Digits::of_interval(of.ends());
    Cell::shown(digits.rounded(of.value), of.value.into())
}

fn range(ends: [f64; 2]) -> Cell {
    Cell::range(Some(ends), Digits::of_interval(ends))
}

/// Further columns of the constants.
fn further(fit: &OilFit) -> Table {
    let both = fit.constants.iter().zip(&fit.other_law.constants);
    columns! { (one, other) in both;
        number by_other_law "by the other law" "" = by_interval(other.fitted);
        percent expected "remaining error, as expected before" "%" "{:.0}" = one.expected;
        percent posterior "remaining error" "%" "{:.0}" = one.posterior;
    }
}

fn kept(fit: &OilFit) -> Vec<&TractionPointRow> {
    fit.points
        .iter()
        .filter(|row| row.fitted.is_some())
        .collect()
}

/// One chart for each set temperature.
fn curves(fit: &OilFit) -> Vec<Drawing> {
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
        Drawing::Curves(chart)
    });
    charts.collect()
}

fn residuals(fit: &OilFit) -> [Drawing; 3] {
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
        Drawing::Curves(chart)
    };
    let axis = Axis::new;
    [
        over(
            "over-temperature",
            "Residuals over temperature",
            axis("temperature", "°C"),
            |row| row.temperature_c,
        ),
        over(
            "over-pressure",
            "Residuals over pressure",
            axis("largest Hertz pressure", "GPa"),
            |row| row.pressure_gpa,
        ),
        over(
            "over-slide",
            "Residuals over slide-to-roll ratio",
            axis("slide-to-roll ratio", "%").log(),
            |row| row.slide_roll_percent,
        ),
    ]
}

fn dropped(fit: &OilFit) -> Table {
    let points = fit.points.iter();
    let rows = points.filter(|row| row.dropped.is_some());
    columns! { row in rows;
        head reading "reading" "" = format!("{}:{}", row.file, row.line);
        number load_n "load" "N" "{:.0}";
        number mean_speed_m_s "speed" "m/s" = row.mean_speed_m_s;
        number slide_roll_percent "slide-to-roll ratio" "%" "{:.1}";
        number temperature_c "temperature" "°C" "{:.0}";
        number traction "friction" "" "{:.4}";
        number film_ratio "film over roughness" "" "{:.1}";
        text dropped "rule" "" = Cell::optional(row.dropped.map(|rule| rule.to_string()));
    }
}

fn nuisance(fit: &OilFit) -> Table {
    columns! { term in &fit.nuisance;
        text text "term" "";
        number deviations "standard deviations" "" "{:+.2}";
    }
}
