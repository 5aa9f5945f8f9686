//! Page of a comparison.

use asperity::result::loss_band::{LossBand, SamplingPart};
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
        p { "Nominal values, " (note(comparison)) ". Common contributions, such as the friction of the oil, cancel in the \
            differences; the sampling errors of different flanks add." }
        p { (scope(comparison)) "." }
        (contributions(comparison))
        div.charts { (figure(&bars(comparison))) @if let Some(chart) = differences(comparison) { (figure(&chart)) } }
    }
}

/// Contributions to the bands, and losses of the alternative models.
fn contributions(comparison: &Comparison) -> Markup {
    let banded: Vec<_> = comparison
        .finishes
        .iter()
        .filter_map(|finish| Some((finish, finish.band.as_ref()?)))
        .collect();
    let Some((_, first)) = banded.first() else {
        return html! {};
    };
    let effect = |band: &LossBand, name: &str| {
        let entry = band.parameters.iter().find(|p| p.name == name);
        entry.map_or("-".to_owned(), |p| format!("{:+.0} W", p.effect_w))
    };
    let other = |band: &LossBand, name: &str| {
        let entry = band.alternatives.iter().find(|row| row.name == name);
        let loss = entry.and_then(|row| row.loss_w);
        loss.map_or("-".to_owned(), |loss| format!("{loss:.0} W"))
    };
    html! {
        h3 { "Contributions to the bands" }
        div.scroll { table {
            thead { tr { th { "from the low to the high end of" } @for (finish, _) in &banded { th.number { (finish.name) } } } }
            tbody {
                @for parameter in &first.parameters {
                    tr { th scope="row" { (parameter.name) } @for (_, band) in &banded { td.number { (effect(band, &parameter.name)) } } }
                }
                tr { th scope="row" { "sampling of the flanks, ± 95 %" } @for (_, band) in &banded { td.number {
                    @match &band.sampling {
                        SamplingPart::Windows(entry) => (format!("{:.1} W", entry.half_width_w)),
                        SamplingPart::Pairs(entry) => (format!("{:.1} W, {} pairs", entry.half_width_w, entry.pairs())),
                        SamplingPart::OnePair([down, up]) => (format!("one pair, {down:+.1} and {up:+.1} W if shifted")),
                        SamplingPart::None(why) => (why),
                        _ => "-",
                    }
                } } }
            }
        } }
        h3 { "Alternative models, not in the bands" }
        div.scroll { table {
            thead { tr { th { "model" } @for (finish, _) in &banded { th.number { (finish.name) } } } }
            tbody { @for row in &first.alternatives {
                tr { th scope="row" { (row.name) } @for (_, band) in &banded { td.number { (other(band, &row.name)) } } }
            } }
        } }
    }
}

fn bars(comparison: &Comparison) -> Drawing {
    let bars = comparison.finishes.iter().map(|finish| Bar {
        name: finish.name.clone(),
        value: Some(finish.loss_w),
        spread: Some(finish.quantiles_w),
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
