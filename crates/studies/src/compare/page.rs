//! Page of a comparison.

use asperity::result::loss_band::Uncertainty;
use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::comparison::Comparison;
use super::summary::{cells, efficiency, note, scope};
use super::windows::PARAMETERS;

pub(super) fn render(comparison: &Comparison) -> String {
    let sections = [
        ("Losses", losses(comparison)),
        ("Roughness and loss", roughness(comparison)),
        ("Provenance", provenance(comparison)),
    ];
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

fn losses(comparison: &Comparison) -> Markup {
    html! {
        div.scroll { table {
            thead { tr {
                th { "finish" } th.number { "efficiency" } th.number { "loss [W]" }
                th.number { "minus the first [W]" } th.number { "change [%]" } th.number { "mixed" }
            } }
            tbody { @for finish in &comparison.finishes {
                @let [loss, difference, change] = cells(finish);
                tr {
                    th scope="row" { (finish.name) }
                    td.number { (efficiency(finish)) " %" }
                    td.number { (loss) }
                    td.number { (difference) }
                    td.number { (change) }
                    td.number { (format!("{:.0} %", 100.0 * finish.mixed_share)) }
                }
            } }
        } }
        @for verdict in comparison.verdicts() { p { strong { (verdict) "." } } }
        p { (note(comparison)) ". Common contributions, such as the friction of the oil, cancel in the differences." }
        p { (scope(comparison)) "." }
        (contributions(comparison))
        div.charts { (figure(&bars(comparison))) @if let Some(chart) = differences(comparison) { (figure(&chart)) } }
    }
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
        entry.map_or("-".to_owned(), |part| {
            let [low, high] = part.quantiles_w.map(|loss| digits.rounded(loss));
            format!("{low}..{high} W")
        })
    };
    let other = |of: &Uncertainty, name: &str| {
        let row = of.models().find(|row| row.name == name);
        let loss = row.and_then(|row| row.loss_w);
        loss.map_or("-".to_owned(), |loss| {
            format!("{} W", of.digits().rounded(loss))
        })
    };
    html! {
        h3 { "Components of the uncertainty, each drawn alone, 5 to 95 %" }
        div.scroll { table {
            thead { tr { th { "component" } @for (finish, _) in &drawn { th.number { (finish.name) } } } }
            tbody { @for row in &first.loss.parts {
                tr { th scope="row" { (row.name) } @for (_, of) in &drawn { td.number { (part(of, &row.name)) } } }
            } }
        } }
        h3 { "Other models, and what refutes them" }
        div.scroll { table {
            thead { tr { th { "model" } @for (finish, _) in &drawn { th.number { (finish.name) } } th { "refuted by" } } }
            tbody { @for row in first.models() {
                tr {
                    th scope="row" { (row.name) }
                    @for (_, of) in &drawn { td.number { (other(of, &row.name)) } }
                    td { (row.standing()) }
                }
            } }
        } }
    }
}

fn bars(comparison: &Comparison) -> Drawing {
    let bars = comparison.finishes.iter().map(|finish| Bar {
        name: finish.name.clone(),
        value: Some(
            finish
                .uncertainty
                .as_ref()
                .map_or(finish.loss_w, |drawn| drawn.loss.median_w),
        ),
        spread: finish
            .uncertainty
            .as_ref()
            .map(|drawn| drawn.loss.quantiles_w),
        text: format!("{} W", cells(finish)[0]),
    });
    Drawing::Bars(BarChart {
        id: "losses".to_owned(),
        title: "Loss of each finish".to_owned(),
        source: "compare.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: bars.collect(),
    })
}

fn differences(comparison: &Comparison) -> Option<Drawing> {
    let (first, others) = comparison.finishes.split_first()?;
    if others.is_empty() {
        return None;
    }
    let mut chart = Chart::new(
        "differences",
        &format!("Loss minus that of {}, offset by offset", first.name),
        "offsets.csv",
        Axis::new("offset", ""),
        Axis::new("difference", "W").from_zero(),
    );
    // The first finish is a line at zero, which reserves its colour.
    let number: Vec<f64> = first.offsets.iter().map(|row| row.offset as f64).collect();
    let zero = vec![0.0; number.len()];
    chart = chart.with(Series::new(&first.name, Line::Dashed, &number, &zero));
    for finish in others {
        let number: Vec<f64> = finish.offsets.iter().map(|row| row.offset as f64).collect();
        let pairs = finish.offsets.iter().zip(&first.offsets);
        let difference: Vec<f64> = pairs.map(|(row, base)| row.loss_w - base.loss_w).collect();
        chart = chart.with(Series::new(
            &finish.name,
            Line::Scatter,
            &number,
            &difference,
        ));
    }
    Some(Drawing::Curves(chart))
}

fn roughness(comparison: &Comparison) -> Markup {
    let best: Vec<Drawing> = comparison
        .correlations
        .iter()
        .take(2)
        .filter_map(|entry| scatter(comparison, entry.parameter))
        .collect();
    html! {
        p { "Rank correlation of Spearman of the roughness under the contact with the loss, over " (comparison.windows)
            " windows. It shows which parameter orders the finishes like their losses, not a cause; two finishes are a weak basis." }
        div.scroll { table {
            thead { tr { th { "parameter" } th.number { "with the loss" } th.number { "within finishes" } } }
            tbody { @for entry in &comparison.correlations {
                tr { th scope="row" { (entry.parameter) }
                    td.number { (format!("{:+.3}", entry.with_loss)) } td.number { (format!("{:+.3}", entry.within_finishes)) } }
            } }
        } }
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
        let x: Vec<f64> = finish.roughness.iter().map(of).collect();
        let y: Vec<f64> = finish.offsets.iter().map(|row| row.loss_w).collect();
        chart = chart.with(Series::new(&finish.name, Line::Scatter, &x, &y));
    }
    Some(Drawing::Curves(chart))
}

fn provenance(comparison: &Comparison) -> Markup {
    html! {
        div.scroll { table {
            thead { tr { th { "finish" } th { "file" } th { "SHA-256" } } }
            tbody { @for finish in &comparison.finishes { @for [file, sum] in &finish.files {
                tr { td { (finish.name) } td { code { (file) } } td { code { (sum) } } }
            } } }
        } }
        @for finish in &comparison.finishes { @if !finish.warnings.is_empty() {
            h3 { "Warnings: " (finish.name) }
            ul.warnings { @for warning in &finish.warnings { li { (warning) } } }
        } }
    }
}
