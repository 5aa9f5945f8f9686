//! The page of a comparison.

use asperity_report::chart::{Axis, Bar, BarChart, Chart, Drawing, Line, Series};
use asperity_report::html::{figure, page};
use maud::{Markup, html};

use super::comparison::{CONFIDENCE, Comparison};
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
    let offsets = comparison
        .finishes
        .first()
        .map_or(0, |finish| finish.offsets.len());
    html! {
        div.scroll { table {
            thead { tr {
                th { "finish" } th.number { "efficiency" } th.number { "loss" } th.number { "minus the first" } th.number { "mixed" }
            } }
            tbody { @for finish in &comparison.finishes {
                tr {
                    th scope="row" { (finish.name) }
                    td.number { (format!("{:.4} %", 100.0 * finish.efficiency)) }
                    td.number { (format!("{:.1}{} W", finish.loss_w.mean, finish.loss_w.spread())) }
                    td.number { @match &finish.difference_w {
                        None => "reference",
                        Some(interval) => (format!("{:+.1}{} W", interval.mean, interval.spread())),
                    } }
                    td.number { (format!("{:.0} %", 100.0 * finish.mixed_share)) }
                }
            } }
        } }
        p { "± is a " (format!("{:.0}", 100.0 * CONFIDENCE)) " % interval of Student's t over " (offsets)
            " offsets; differences are taken offset by offset (paired). Windows that overlap on a short trace make it a lower bound." }
        div.charts { (figure(&bars(comparison))) @if let Some(chart) = differences(comparison) { (figure(&chart)) } }
    }
}

fn bars(comparison: &Comparison) -> Drawing {
    let bars = comparison.finishes.iter().map(|finish| Bar {
        name: finish.name.clone(),
        value: Some(finish.loss_w.mean),
        spread: finish.loss_w.half_width,
        text: format!("{:.0} W", finish.loss_w.mean),
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
    Some(Drawing::Curves(chart.level(0.0, &first.name)))
}

fn roughness(comparison: &Comparison) -> Markup {
    let best: Vec<Drawing> = comparison
        .correlations
        .iter()
        .take(2)
        .filter_map(|found| scatter(comparison, found.parameter))
        .collect();
    html! {
        p { "Rank correlation of Spearman of the roughness under the contact with the loss, over " (comparison.windows)
            " windows. It tells which parameter orders finishes as their losses do, not what causes them; two finishes are a weak basis." }
        div.scroll { table {
            thead { tr { th { "parameter" } th.number { "with the loss" } th.number { "within finishes" } } }
            tbody { @for found in &comparison.correlations {
                tr { th scope="row" { (found.parameter) }
                    td.number { (format!("{:+.3}", found.with_loss)) } td.number { (format!("{:+.3}", found.within_finishes)) } }
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
