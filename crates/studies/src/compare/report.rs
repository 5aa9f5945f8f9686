//! Report of a comparison.

use asperity::quantity::Length;
use asperity::result::loss_band::{Digits, Uncertainty};
use asperity::uncertainty::Verdict;
use asperity_core::Estimate;
use asperity_core::unique;
use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{along, points};
use asperity_report::tables::{BODIES, FlankTables, SpectrumRow};
use asperity_report::units::MICRO;
use asperity_report::{Cell, Column, Kind, Report, StudyResult, Table, columns, parts_of};

use super::comparison::{Comparison, FinishResult, PairOfFinish};
use super::tables;
use super::windows::PARAMETERS;
use super::words::{
    known, loss, measured, meshes, narrowed_by, note, oils, run_in, scope, surest, table, warnings,
};

impl StudyResult for Comparison {
    const KIND: &'static str = "comparison";
    const NAME: &'static str = "compare";

    fn report(&self) -> Report<'_> {
        let names: Vec<&str> = self.finishes.iter().map(|finish| &*finish.name).collect();
        let of_pair = self.finishes.iter().all(|finish| finish.pair.is_some());
        // Every variant is in the table as well, which a first screen would otherwise have no room for.
        let (surest, others) = surest(self);
        let operation = self.operation.iter().map(|point| format!(" · {point}"));
        let of = format!(
            "comparison of {}{}",
            names.join(", "),
            operation.collect::<String>()
        );
        let report = Report::new(&self.title, of)
            .section("Verdict")
            .verdict(surest)
            .figures(|| [bars(self)])
            .text(others)
            .text(narrowed_by(self))
            .on_page()
            .table(table(self))
            .text(known(self))
            .text(oils(self))
            .in_terminal()
            .text(narrowed_by(self))
            .in_terminal()
            .text([note(self)])
            .text(run_in(self))
            .text([scope(self)]);
        let report = if of_pair {
            of_pairs(report, self)
        } else {
            report
                .section("Meshes")
                .table(meshes(self))
                .text([OF_MESHES])
                .on_page()
        };
        let report = compared(report, self);
        report
            .section("Warnings")
            .warning(warnings(self))
            .section("Provenance")
            .table(provenance(self))
            .on_page()
    }
}

/// A value of a key, or that there is none.
fn or_none(value: &str) -> &str {
    match value {
        "" => "not stated",
        value => value,
    }
}

/// Keys that differ between the variants, measurements that would decide, and common draws.
fn compared<'a>(report: Report<'a>, comparison: &'a Comparison) -> Report<'a> {
    let Some((first, others)) = comparison.finishes.split_first() else {
        return report;
    };
    let mut report = report;
    let changes = others
        .iter()
        .flat_map(|of| of.changes.iter().map(move |row| (of, row)));
    let changes: Vec<_> = changes.collect();
    if !changes.is_empty() {
        let table = columns! { (of, row) in &changes;
            head variant "variant" "" = &of.name;
            code key "key" "" = &row.key;
            text first "first" "" = or_none(&row.first);
            text value "variant has" "" = or_none(&row.value);
        };
        report = report.section("What differs").table(table).on_page();
    }
    let deciding = others
        .iter()
        .flat_map(|of| of.deciding.iter().map(move |row| (of, row)));
    let deciding: Vec<_> = deciding.collect();
    let is_open = |of: &FinishResult| {
        let difference = of.difference.as_ref();
        difference.is_some_and(|found| found.verdict == Verdict::Undecided)
    };
    let decides = |[low, high]: [f64; 2]| low > 0.0 || high < 0.0;
    let mut rows = deciding.iter();
    let is_decided = rows.any(|(of, row)| is_open(of) && decides(row.quantiles_w));
    let none = (others.iter().any(is_open) && !is_decided).then_some(NONE_DECIDES);
    let table = columns! { (of, row) in deciding;
        head variant "variant" "" = &of.name;
        text measurement "measurement or computation" "" = measured(row, [&first.name, &of.name]);
        percent width "remaining width" "%" "{:.0}" = row.width;
        range quantiles_w "difference" "W" = Cell::range(Some(row.quantiles_w), Digits::of_interval(row.quantiles_w));
    };
    if !table.is_empty() {
        report = report
            .section(if is_decided {
                "What would decide"
            } else {
                "What would narrow the difference"
            })
            .text([DECIDING].into_iter().chain(none))
            .on_page();
        report = report.table(table).on_page();
    }
    let common = others
        .iter()
        .filter_map(|of| Some((of, of.difference.as_ref()?)));
    let common = common.flat_map(|(of, found)| found.common.iter().map(move |row| (of, row)));
    let table = columns! { (of, row) in common;
        head variant "variant" "" = &of.name;
        text name "component" "" = &row.name;
        text belongs_to "belongs to" "" = &row.belongs_to;
        number correlation "correlation" "" "{:.2}" = row.correlation;
    };
    if table.is_empty() {
        report
    } else {
        report
            .section("Draws in common")
            .text([COMMON])
            .on_page()
            .table(table)
            .on_page()
    }
}

/// Text if no measurement decides an undecided difference.
const NONE_DECIDES: &str = "None of them alone decides a difference that is inconclusive.";
/// Text above the measurements.
const DECIDING: &str = "Each line is the interval of the difference, from 5 to 95 %, that the measurement leaves at best: as if it were \
    exact. Without the name of a variant, one measurement serves both.";

/// Text above the common draws.
const COMMON: &str = "A component has the same samples in both where the thing that it belongs to is the same: its correlation is 1. Where \
    each has a thing of its own it is 0, and it falls from 1 with the distance of the two.";

/// Content of a comparison of a gear train.
const OF_MESHES: &str = "Losses of one mesh of each kind. A comparison of a single mesh shows its flanks, its spectra and the \
    correlation of their roughness with the loss.";

/// Note on flanks without traces.
const NO_TRACE: &str = "The flanks are given only by roughness values: no trace was measured.";

/// Sections of a comparison of pairs.
fn of_pairs<'a>(report: Report<'a>, comparison: &'a Comparison) -> Report<'a> {
    let report = report
        .figures(|| [parts(comparison)])
        .text(film_instead_of_asperities(comparison))
        .on_page()
        .figures(|| [along_the_path(comparison)])
        .rows("parts.csv", || tables::parts(comparison))
        .rows("offsets.csv", || tables::offsets(comparison))
        .rows("path.csv", || tables::path(comparison));
    let report = if comparison.has_equal_flanks() {
        report
    } else {
        of_flanks(report, comparison)
    };
    let report = if comparison.correlations.is_empty() {
        report
    } else {
        correlations(report, comparison)
    };
    let drawn = drawn(comparison);
    let Some((_, first)) = drawn.first() else {
        return report;
    };
    report
        .section("Uncertainty")
        .text([COMPONENTS])
        .on_page()
        .figures(|| [components(comparison)])
        .rows("components.csv", || tables::components(comparison))
        .heading("Other models, and the evidence against them")
        .on_page()
        .text([OTHER_MODELS])
        .on_page()
        .table(models(&drawn, first))
        .on_page()
}

/// Section on the flanks of pairs.
fn of_flanks<'a>(report: Report<'a>, comparison: &'a Comparison) -> Report<'a> {
    report
        .section("Flanks")
        .table(parameters(comparison))
        .on_page()
        .figures(|| flanks(comparison))
        .text(flanks(comparison).is_empty().then_some(NO_TRACE))
        .on_page()
        .rows("traces.csv", || tables::traces(comparison))
        .rows("spectra.csv", || tables::spectra(comparison))
}

/// Text above the components of the uncertainty.
const COMPONENTS: &str = "Each component is sampled alone, with every other at its median.";

/// Text above the other models.
const OTHER_MODELS: &str = "Each other model has its constants at their medians, and the evidence is against its result there. Its loss is scaled as the run to the median of the draws. The \
    interval of the verdict is of the default model with drawn constants. Its ends need constants far from their medians: there the \
    default, too, may save as much as an excluded model.";

/// Rank correlations of the roughness with the loss.
fn correlations<'a>(report: Report<'a>, comparison: &'a Comparison) -> Report<'a> {
    let best = || comparison.correlations.iter();
    let text = format!(
        "Rank correlation of Spearman of the roughness under the contact with the computed loss, over {} windows. It shows which \
        parameter orders the finishes like their losses, not a cause.",
        comparison.windows
    );
    let first = best().take(4);
    let first = first.map(|entry| format!("{} {:+.2}", entry.parameter, entry.with_loss));
    let table = columns! { entry in &comparison.correlations;
        head parameter "parameter" "";
        number with_loss "with the loss" "" "{:+.3}";
        number within_finishes "within finishes" "" "{:+.3}";
    };
    report
        .section("Roughness and loss")
        .text([text])
        .text([first.collect::<Vec<_>>().join("   ")])
        .in_terminal()
        .table(table.of_file("parameters.csv"))
        .on_page()
        .figures(move || {
            best()
                .take(2)
                .filter_map(|entry| scatter(comparison, entry.parameter))
        })
        .rows("parameters.csv", || &comparison.correlations)
}

/// Local losses of all finishes from A to E.
fn along_the_path(comparison: &Comparison) -> Drawing {
    const KILO: f64 = 1e-3;
    let mut chart = Chart::new(
        "local-losses",
        "Loss per length of contact line from A to E, shaded 5 to 95 %",
        "path.csv",
        along(),
        Axis::new("loss", "kW/m").from_zero(),
    );
    if let Some((_, first)) = comparison.pairs().next() {
        chart = chart.marked(&points(&first.result));
    }
    for (finish, pair) in comparison.pairs() {
        let rows = &pair.result.path;
        let s: Vec<f64> = rows.iter().map(|row| row.s_mm).collect();
        let loss: Vec<f64> = rows.iter().map(|row| KILO * row.loss_w_per_m()).collect();
        chart = chart.curve(&finish.name, Line::Solid, &s, &loss);
    }
    for (index, (finish, pair)) in comparison.pairs().enumerate() {
        let Some(ends) = pair.result.path_loss_quantiles() else {
            continue;
        };
        let s: Vec<f64> = pair.result.path.iter().map(|row| row.s_mm).collect();
        let [low, high] = [0, 1].map(|end| {
            ends.iter()
                .map(|both| KILO * both[end])
                .collect::<Vec<f64>>()
        });
        let name = format!("{}, 5 to 95 %", finish.name);
        chart = chart.with(Series::band_of(index, &name, &s, &low, &high));
    }
    Drawing::Curves(chart)
}

/// Traces and spectra of the flanks side by side.
fn flanks(comparison: &Comparison) -> Vec<Drawing> {
    let charts = [traces, spectra].into_iter();
    let charts = charts.flat_map(|chart| [0, 1].map(|body| chart(comparison, body)));
    charts.flatten().collect()
}

/// Roughness parameters of the flanks with a trace.
fn parameters(comparison: &Comparison) -> Table {
    let flanks = comparison.pairs().flat_map(|(finish, pair)| {
        [0, 1].map(|body| (finish, BODIES[body], &pair.result.flanks[body]))
    });
    let rows = flanks.filter_map(|(finish, body, flank)| {
        let parameters = flank.parameters.as_ref()?;
        Some((finish, body, &parameters.heights, &parameters.material))
    });
    let um = |length: Length| length.si() * MICRO;
    columns! { (finish, body, heights, material) in rows;
        head name "finish" "" = &finish.name;
        text body "flank" "" = body;
        number ra "Ra" "µm" "{:.3}" = um(heights.ra);
        number rq "Rq" "µm" "{:.3}" = um(heights.rq);
        number rz "Rz" "µm" "{:.3}" = um(heights.rz);
        number rpk "Rpk" "µm" "{:.3}" = um(material.rpk);
        number rk "Rk" "µm" "{:.3}" = um(material.rk);
        number rvk "Rvk" "µm" "{:.3}" = um(material.rvk);
    }
}

/// Roughness of the flank `body` of all finishes over the same axes; `None` without a trace.
fn traces(comparison: &Comparison, body: usize) -> Option<Drawing> {
    let name = BODIES[body];
    let mut chart = Chart::new(
        &format!("traces-{name}"),
        &format!("Roughness of the {name}, filtered"),
        "traces.csv",
        Axis::new("position", "mm"),
        Axis::new("height", "µm"),
    );
    for (finish, pair) in comparison.pairs() {
        let Some(tables) = &pair.tables[body] else {
            continue;
        };
        let points = tables
            .trace
            .iter()
            .filter_map(|row| Some([1e-3 * row.x_um, row.roughness_um?]));
        chart = chart.with(Series::through(&finish.name, Line::Solid, points));
    }
    (!chart.series.is_empty()).then_some(Drawing::Curves(chart))
}

/// Bands of the spectrum of the flank `body` in which the filters of the case leave heights: the wavelengths between half of
/// λs and twice λc, where a Gaussian filter passes at least 6 and 16 % of a height.
fn passed<'a>(
    pair: &'a PairOfFinish,
    body: usize,
    tables: &FlankTables,
) -> impl Iterator<Item = SpectrumRow> + use<'a> {
    let recipe = pair.result.flanks[body].preparation.as_ref();
    let cutoffs = recipe.map_or([None; 2], |one| [one.recipe.lambda_s, one.recipe.lambda_c]);
    let [shortest, longest] = cutoffs.map(|cutoff| cutoff.map(|cutoff| 1e3 * cutoff.si()));
    let range = 0.5 * shortest.unwrap_or(0.0)..=2.0 * longest.unwrap_or(f64::INFINITY);
    let bands = tables.spectrum_in_bands().into_iter();
    bands.filter(move |row| range.contains(&(1.0 / row.frequency_per_mm)))
}

/// Spectra of the flank `body` of all finishes; `None` without a trace.
fn spectra(comparison: &Comparison, body: usize) -> Option<Drawing> {
    let name = BODIES[body];
    let mut chart = Chart::new(
        &format!("spectra-{name}"),
        &format!("Power spectral density of the {name}, where the filters leave heights"),
        "spectra.csv",
        Axis::new("wavelength", "µm").log(),
        Axis::new("density", "µm³").log(),
    );
    for (finish, pair) in comparison.pairs() {
        let Some(tables) = &pair.tables[body] else {
            continue;
        };
        let points =
            passed(pair, body, tables).map(|row| [1e3 / row.frequency_per_mm, row.density_um3]);
        chart = chart.with(Series::through(&finish.name, Line::Solid, points));
    }
    (!chart.series.is_empty()).then_some(Drawing::Curves(chart))
}

/// The finishes whose uncertainty was drawn.
fn drawn(comparison: &Comparison) -> Vec<(&FinishResult, &Uncertainty)> {
    let finishes = comparison.finishes.iter();
    let drawn = finishes.filter_map(|finish| Some((finish, finish.uncertainty.as_ref()?)));
    drawn.collect()
}

/// Components of the uncertainties, paired: half the width of the 90 % interval of each.
fn components(comparison: &Comparison) -> Drawing {
    let drawn = drawn(comparison);
    let all = drawn.iter().flat_map(|(_, of)| &of.loss.parts);
    let names = unique(all.map(|part| &*part.name)).into_iter();
    let bars = names.flat_map(|name| {
        drawn.iter().filter_map(move |(finish, of)| {
            let mut parts = of.loss.parts.iter();
            let half_w = parts.find(|part| part.name == name)?.half_range_w();
            Some(Bar {
                name: name.to_owned(),
                value: Some(half_w),
                spread: None,
                text: format!("{} W, {}", at_least_one(of.digits(), half_w), finish.name),
            })
        })
    });
    Drawing::Bars(BarChart {
        id: "components".to_owned(),
        title: "Components of the uncertainty, half the width of the 90 % interval".to_owned(),
        source: "components.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: bars.collect(),
    })
}

/// A power with these digits; below half of the last place "< 10", because a bar shows it.
fn at_least_one(digits: Digits, power_w: f64) -> String {
    digits.texts_of_parts(power_w, &[power_w]).concat()
}

/// Losses by other models.
fn models(drawn: &[(&FinishResult, &Uncertainty)], first: &Uncertainty) -> Table {
    let other = |of: &Uncertainty, name: &str| {
        let row = of.models().find(|row| row.name == name);
        let loss = row.and_then(|row| row.loss_w);
        Cell::optional(loss.map(|loss| of.digits().rounded(loss)))
    };
    let models = columns! { row in first.models(); head name "model" ""; };
    let models = models.with(drawn.iter().map(|(finish, of)| {
        let cells = first.models().map(|row| other(of, &row.name));
        Column::new(Kind::Number, &finish.name, "W", cells)
    }));
    // Rounded by themselves, as in the verdict: the losses as printed can differ by one step more or less.
    let differences = drawn.iter().filter_map(|(finish, _)| {
        let difference = finish.difference.as_ref()?;
        let digits = Digits::of_interval(difference.watts.ends());
        let of = |name: &str| {
            let row = difference.models.iter().find(|row| row.name == name);
            Cell::optional(row.and_then(|row| row.loss_w).map(|by| digits.rounded(by)))
        };
        let heading = format!("{} minus the first", finish.name);
        let cells: Vec<Cell> = first.models().map(|row| of(&row.name)).collect();
        Some(Column::new(Kind::Number, &heading, "W", cells))
    });
    let models = models.with(differences);
    models.with(columns! { row in first.models(); text standing "against it" "" = row.standing(); })
}

fn bars(comparison: &Comparison) -> Drawing {
    let bars = comparison.finishes.iter().map(|finish| Bar {
        // One group, whose bars have the colours of the finishes in all charts.
        name: "loss".to_owned(),
        value: Some(finish.loss_w),
        spread: finish.drawn_w().map(Estimate::ends),
        text: format!("{} W, {}", loss(finish), finish.name),
    });
    Drawing::Bars(BarChart {
        id: "losses".to_owned(),
        title: format!("Loss of each {}", comparison.noun()),
        source: "compare.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: bars.collect(),
    })
}

/// Parts of the losses, paired.
fn parts(comparison: &Comparison) -> Drawing {
    let of: Vec<_> = comparison
        .pairs()
        .map(|(finish, pair)| (&finish.name, parts_of(&pair.result).collect::<Vec<_>>()))
        .collect();
    let names = unique(
        of.iter()
            .flat_map(|(_, parts)| parts.iter().map(|part| part.0)),
    );
    let bars = names.into_iter().flat_map(|name| {
        of.iter().filter_map(move |(finish, parts)| {
            let (_, watts, text) = parts.iter().find(|part| part.0 == name)?;
            Some(Bar {
                name: name.to_owned(),
                value: Some(*watts),
                spread: None,
                text: format!("{text}, {finish}"),
            })
        })
    });
    Drawing::Bars(BarChart {
        id: "parts".to_owned(),
        title: "Parts of the loss".to_owned(),
        source: "parts.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: bars.collect(),
    })
}

/// The finishes that lose more in the film than the first and less in all, in words.
fn film_instead_of_asperities(comparison: &Comparison) -> Option<String> {
    /// Least rise of the loss of the film, in parts of the whole loss.
    const LEAST: f64 = 0.02;
    let film = |pair: &PairOfFinish| pair.result.summary.film_w;
    let mut pairs = comparison.pairs();
    let (first, of_first) = pairs.next()?;
    let risen = pairs.filter(|(finish, pair)| {
        let is_lower = finish.loss_w < first.loss_w;
        is_lower && film(pair) - film(of_first) > LEAST * first.loss_w
    });
    let names: Vec<&str> = risen.map(|(finish, _)| &*finish.name).collect();
    (comparison.are_finishes && !names.is_empty()).then(|| {
        format!(
            "With {} the film loses more: it carries load that asperities carry with {}.",
            names.join(" and "),
            first.name
        )
    })
}

fn scatter(comparison: &Comparison, parameter: &str) -> Option<Drawing> {
    let (name, of) = PARAMETERS.iter().find(|(name, _)| *name == parameter)?;
    let unit = if *name == "Rdq" { "" } else { "µm" };
    let mut chart = Chart::new(
        &format!("loss-{}", name.to_lowercase()),
        &format!("Loss against {name} under the contact"),
        "offsets.csv",
        Axis::new(&format!("{name} of both flanks"), unit),
        Axis::new("loss", "W").from_zero(),
    );
    for finish in &comparison.finishes {
        let x: Vec<f64> = finish.roughness().iter().map(of).collect();
        let y: Vec<f64> = finish.offsets.iter().map(|row| row.loss_w).collect();
        chart = chart.curve(&finish.name, Line::Scatter, &x, &y);
    }
    Some(Drawing::Curves(chart))
}

/// The files of the traces.
fn provenance(comparison: &Comparison) -> Table {
    let finishes = comparison.finishes.iter();
    let files = finishes.flat_map(|finish| finish.files.iter().map(move |file| (finish, file)));
    columns! { (finish, [file, sum]) in files;
        text finish "finish" "" = &finish.name;
        code file "file" "" = file;
        code sum "SHA-256" "" = sum;
    }
}
