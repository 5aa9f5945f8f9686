//! Page of a comparison.

use asperity::quantity::Length;
use asperity::result::loss_band::Uncertainty;
use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{along, figure, page, points};
use asperity_report::tables::BODIES;
use asperity_report::units::MICRO;
use asperity_report::{Cell, Column, Kind, columns};
use maud::{Markup, html};

use super::comparison::Comparison;
use super::summary::{cells, meshes as meshes_table, note, run_in, scope, table};
use super::windows::PARAMETERS;

pub(super) fn render(comparison: &Comparison) -> String {
    let mut sections = vec![("Verdict", verdict(comparison))];
    match comparison.pairs().next() {
        Some(_) => sections.extend([
            ("Flanks", flanks(comparison)),
            ("Roughness and loss", roughness(comparison)),
            ("Uncertainty", contributions(comparison)),
        ]),
        None => sections.push(("Meshes", meshes(comparison))),
    }
    sections.push(("Provenance", provenance(comparison)));
    let names: Vec<&str> = comparison
        .finishes
        .iter()
        .map(|finish| finish.name.as_str())
        .collect();
    let subtitle = format!(
        "{} · comparison of {}",
        comparison.program,
        names.join(", ")
    );
    page(&comparison.title, &subtitle, &sections)
}

/// Losses of the meshes of a gear train.
fn meshes(comparison: &Comparison) -> Markup {
    html! {
        (meshes_table(comparison))
        p.sub { "Losses of one mesh of each kind. A comparison of a single mesh shows its flanks, its spectra and the correlation of their "
            "roughness with the loss." }
    }
}

fn verdict(comparison: &Comparison) -> Markup {
    let of_pair = comparison.pairs().next().is_some();
    html! {
        @for verdict in comparison.verdicts() { p { strong { (verdict) "." } } }
        (table(comparison))
        p.sub { "Losses are " (note(comparison)) ". Common contributions, such as the friction of the oil, cancel in the "
            "differences; " (scope(comparison)) "." }
        @for line in run_in(comparison) { p.sub { (line) } }
        div.charts { (figure(&bars(comparison))) @if of_pair { (figure(&along_the_path(comparison))) } }
    }
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

/// Traces, spectra and parameters of the flanks side by side.
fn flanks(comparison: &Comparison) -> Markup {
    let drawings: Vec<Drawing> = [traces, spectra]
        .into_iter()
        .flat_map(|chart| [0, 1].map(|body| chart(comparison, body)))
        .flatten()
        .collect();
    if drawings.is_empty() {
        return html! { p { "The flanks are given only by roughness values: no trace was measured." } };
    }
    let flanks = comparison.pairs().flat_map(|(finish, pair)| {
        [0, 1].map(|body| (finish, BODIES[body], &pair.result.flanks[body]))
    });
    let rows = flanks.filter_map(|(finish, body, flank)| {
        let parameters = flank.parameters.as_ref()?;
        Some((finish, body, &parameters.heights, &parameters.material))
    });
    let um = |length: Length| length.si() * MICRO;
    let table = columns! { (finish, body, heights, material) in rows;
        head name "finish" "" = &finish.name;
        text body "flank" "" = body;
        number ra "Ra" "µm" "{:.3}" = um(heights.ra);
        number rq "Rq" "µm" "{:.3}" = um(heights.rq);
        number rz "Rz" "µm" "{:.3}" = um(heights.rz);
        number rpk "Rpk" "µm" "{:.3}" = um(material.rpk);
        number rk "Rk" "µm" "{:.3}" = um(material.rk);
        number rvk "Rvk" "µm" "{:.3}" = um(material.rvk);
    };
    html! {
        (table)
        div.charts { @for drawing in &drawings { (figure(drawing)) } }
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

/// Spectra of the flank `body` of all finishes; `None` without a trace.
fn spectra(comparison: &Comparison, body: usize) -> Option<Drawing> {
    let name = BODIES[body];
    let mut chart = Chart::new(
        &format!("spectra-{name}"),
        &format!("Power spectral density of the {name}, means of bands"),
        "spectra.csv",
        Axis::new("wavelength", "µm").log(),
        Axis::new("density", "µm³").log(),
    );
    for (finish, pair) in comparison.pairs() {
        let Some(tables) = &pair.tables[body] else {
            continue;
        };
        let bands = tables.spectrum_in_bands();
        let points = bands
            .iter()
            .map(|row| [1e3 / row.frequency_per_mm, row.density_um3]);
        chart = chart.with(Series::through(&finish.name, Line::Solid, points));
    }
    (!chart.series.is_empty()).then_some(Drawing::Curves(chart))
}

/// Components of the uncertainties, and losses by other models.
fn contributions(comparison: &Comparison) -> Markup {
    let drawn: Vec<_> = comparison
        .finishes
        .iter()
        .filter_map(|finish| Some((finish, finish.uncertainty.as_ref()?)))
        .collect();
    let Some((_, first)) = drawn.first() else {
        return html! {};
    };
    let part = |of: &Uncertainty, name: &str| {
        let digits = of.digits();
        let entry = of.loss.parts.iter().find(|part| part.name == name);
        Cell::optional(entry.map(|part| {
            let [low, high] = part.quantiles_w.map(|loss| digits.rounded(loss));
            match low == high {
                true => low,
                false => format!("{low}..{high}"),
            }
        }))
    };
    let other = |of: &Uncertainty, name: &str| {
        let row = of.models().find(|row| row.name == name);
        let loss = row.and_then(|row| row.loss_w);
        Cell::optional(loss.map(|loss| of.digits().rounded(loss)))
    };
    let components = columns! { row in &first.loss.parts; head name "component" ""; };
    let components = components.with(drawn.iter().map(|(finish, of)| {
        let cells = first.loss.parts.iter().map(|row| part(of, &row.name));
        Column::new(Kind::Number, &finish.name, "W", cells)
    }));
    let models = columns! { row in first.models(); head name "model" ""; };
    let models = models.with(drawn.iter().map(|(finish, of)| {
        let cells = first.models().map(|row| other(of, &row.name));
        Column::new(Kind::Number, &finish.name, "W", cells)
    }));
    let models = models
        .with(columns! { row in first.models(); text standing "against it" "" = row.standing(); });
    html! {
        h3 { "Components of the uncertainty, each drawn alone, 5 to 95 %" }
        (components)
        h3 { "Other models, and the evidence against them" }
        (models)
    }
}

fn bars(comparison: &Comparison) -> Drawing {
    let bars = comparison.finishes.iter().map(|finish| Bar {
        name: finish.name.clone(),
        value: Some(finish.drawn_w().map_or(finish.loss_w, |(median, _)| median)),
        spread: finish.drawn_w().map(|(_, quantiles)| quantiles),
        text: format!("{} W", cells(comparison, finish)[0]),
    });
    Drawing::Bars(BarChart {
        id: "losses".to_owned(),
        title: "Loss of each finish".to_owned(),
        source: "compare.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: bars.collect(),
    })
}

fn roughness(comparison: &Comparison) -> Markup {
    let best: Vec<Drawing> = comparison
        .correlations
        .iter()
        .take(2)
        .filter_map(|entry| scatter(comparison, entry.parameter))
        .collect();
    if comparison.correlations.is_empty() {
        return html! {};
    }
    let table = columns! { entry in &comparison.correlations;
        head parameter "parameter" "";
        number with_loss "with the loss" "" "{:+.3}";
        number within_finishes "within finishes" "" "{:+.3}";
    };
    html! {
        p { "Rank correlation of Spearman of the roughness under the contact with the loss, over " (comparison.windows)
            " windows. It shows which parameter orders the finishes like their losses, not a cause." }
        (table)
        div.charts { @for chart in &best { (figure(chart)) } }
    }
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

fn provenance(comparison: &Comparison) -> Markup {
    let finishes = comparison.finishes.iter();
    let files = finishes.flat_map(|finish| finish.files.iter().map(move |file| (finish, file)));
    let table = columns! { (finish, [file, sum]) in files;
        text finish "finish" "" = &finish.name;
        code file "file" "" = file;
        code sum "SHA-256" "" = sum;
    };
    html! {
        (table)
        @for finish in &comparison.finishes { @if !finish.warnings.is_empty() {
            h3 { "Warnings: " (finish.name) }
            ul.warnings { @for warning in &finish.warnings { li { (warning) } } }
        } }
    }
}
