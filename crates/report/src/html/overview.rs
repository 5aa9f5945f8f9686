//! Summary: key numbers, warnings, losses, friction laws, lubrication regime.

use asperity::result::loss_band::Digits;
use asperity::result::{FlankHeights, PublishedOutcome, RunInFlanks, RunResult, Scope, Summary};
use maud::{Markup, html};

use super::page::figure;
use crate::chart::{Axis, Bar, BarChart, Drawing};
use crate::printed::{PrintedLoss, included, mesh_with_interval};

pub(super) fn section(result: &RunResult) -> Markup {
    let mut first = headline(result);
    if let Some(gearbox) = &result.gearbox {
        first.extend(super::gearbox::tiles(gearbox, result.uncertainty.as_ref()));
    }
    let rows = [
        ("tiles first", first),
        ("tiles", parts(result)),
        ("tiles last", evidence(result)),
    ];
    let band_chart = result.uncertainty.as_ref().map(super::band::loss_chart);
    let others = [losses(result), laws(result), super::path::strip(result)];
    let charts: Vec<Drawing> = band_chart.into_iter().chain(others).collect();
    html! {
        @for (class, tiles) in &rows {
            dl class=(class) {
                @for (name, value, key) in tiles {
                    div { dt { (name) } dd data-key=(key) { (value) } }
                }
            }
        }
        @if let Some(gearbox) = &result.gearbox { (super::gearbox::section(gearbox, result.uncertainty.is_some())) }
        @if let Some(uncertainty) = &result.uncertainty { (super::band::section(uncertainty)) }
        @if let Some(pairs) = &result.pairs { @if let Some(sampling) = &pairs.sampling {
            (super::pairs::section(pairs, sampling))
        } }
        @if let Some(run_in) = &result.run_in { (as_measured_and_run_in(result, run_in)) }
        @if let Some(report) = &result.micropitting { (super::micropitting::section(report)) }
        @if !result.warnings.is_empty() {
            h3 { "Warnings" }
            ul.warnings {
                @for warning in &result.warnings { li { code { (warning.code) } " " (warning.text) } }
            }
        }
        div.charts { @for chart in &charts { (figure(chart)) } }
    }
}

/// Losses and roughness of the flanks, as measured and run in.
fn as_measured_and_run_in(result: &RunResult, run_in: &RunInFlanks) -> Markup {
    let passes: usize = run_in.cycles.iter().map(|cycle| cycle.passes).sum();
    let states = [
        (&result.summary, &run_in.measured),
        (&run_in.summary, &run_in.run_in),
    ];
    let cells = |of: &dyn Fn(&Summary, &FlankHeights) -> String| {
        states.map(|(summary, heights)| of(summary, heights))
    };
    let both = |values: [f64; 2]| format!("{:.3} and {:.3} µm", values[0], values[1]);
    let watts = |power: f64| format!("{} W", significant(power));
    let rows = [
        (
            "efficiency (mesh only)",
            cells(&|s, _| format!("{:.4} %", 100.0 * s.efficiency)),
        ),
        ("loss", cells(&|s, _| watts(s.loss_w))),
        ("sliding in film", cells(&|s, _| watts(s.film_w))),
        (
            "lubricated asperities",
            cells(&|s, _| watts(s.lubricated_asperity_w)),
        ),
        ("boundary layer", cells(&|s, _| watts(s.boundary_w))),
        (
            "share of the load on asperities",
            cells(&|s, _| percent(s.asperity_share)),
        ),
        (
            "share of the load on the boundary layer",
            cells(&|s, _| percent(s.boundary_share)),
        ),
        (
            "Rq of pinion and wheel",
            cells(&|_, heights| both(heights.rq_um)),
        ),
        (
            "Rpk of pinion and wheel",
            cells(&|_, heights| both(heights.rpk_um)),
        ),
    ];
    html! {
        h3 { "As measured and run in" }
        p {
            "The flanks ran in over " (passes) " contacts under the full load without a film; the rest of this page is for \
            the flanks as measured."
        }
        div.scroll { table {
            thead { tr { th { "number" } th { "as measured" } th { "run in" } } }
            tbody { @for (name, [measured, after]) in &rows {
                tr { th scope="row" { (name) } td { (measured) } td { (after) } }
            } }
        } }
    }
}

/// Name, formatted value and key in `result.json` of a number.
type Tile = (&'static str, String, &'static str);

/// Key numbers: efficiency and loss.
fn headline(result: &RunResult) -> Vec<Tile> {
    let s = &result.summary;
    let mixed = (
        "mixed lubrication, of the path",
        format!("{:.1} %", 100.0 * s.mixed_share),
        "summary.mixed_share",
    );
    let Some(uncertainty) = &result.uncertainty else {
        return vec![
            (
                "efficiency (mesh only)",
                format!("{:.4} %", 100.0 * s.efficiency),
                "summary.efficiency",
            ),
            ("loss", printed(result).loss, "summary.loss_w"),
            mixed,
        ];
    };
    let [loss, efficiency] = mesh_with_interval(s.power_in_w, uncertainty);
    vec![
        (
            "efficiency (mesh only), in brackets 5 to 95 %",
            efficiency,
            "uncertainty.efficiency_median",
        ),
        (
            "loss, in brackets 5 to 95 %",
            loss,
            "uncertainty.loss.median_w",
        ),
        mixed,
    ]
}

/// The loss and its parts as text.
fn printed(result: &RunResult) -> PrintedLoss {
    PrintedLoss::of(
        &result.summary,
        &result.running_in,
        result.uncertainty.as_ref(),
    )
}

/// Parts of the loss, input power and output torque.
fn parts(result: &RunResult) -> Vec<Tile> {
    let s = &result.summary;
    let printed = printed(result);
    vec![
        ("sliding", printed.sliding, "summary.sliding_w"),
        ("rolling", printed.rolling, "summary.rolling_w"),
        (
            "equivalent friction μ_eq",
            format!("{:.4}", s.mu_equivalent),
            "summary.mu_equivalent",
        ),
        (
            "H_V of the load over the teeth",
            format!("{:.4}", s.loss_factor_local),
            "summary.loss_factor_local",
        ),
        (
            "power in",
            format!("{:.3} kW", 1e-3 * s.power_in_w),
            "summary.power_in_w",
        ),
        (
            "torque out",
            format!("{:.2} N m", s.torque_out_nm),
            "summary.torque_out_nm",
        ),
    ]
}

/// Scope and convergence of the numbers.
fn evidence(result: &RunResult) -> Vec<Tile> {
    let s = &result.summary;
    let energy = result.running_in.energy_per_engagement_j;
    let scope = match s.scope {
        Scope::Mesh => "mesh only",
        Scope::Gearbox => "mesh and gearbox",
    };
    let mut tiles = vec![
        ("scope", scope.to_owned(), "summary.scope"),
        (
            "H_V by Ohlendorf",
            format!("{:.4}", s.loss_factor),
            "summary.loss_factor",
        ),
        (
            "plastic work, first engagement",
            format!("{energy:.2e} J"),
            "running_in.energy_per_engagement_j",
        ),
        (
            "mesh positions",
            s.positions.to_string(),
            "summary.positions",
        ),
        (
            "offsets of the traces",
            s.offsets.to_string(),
            "summary.offsets",
        ),
        (
            "worst load error",
            format!("{:.1e}", s.worst_load_error),
            "summary.worst_load_error",
        ),
    ];
    if let Some(bulk) = &result.bulk {
        let value = format!("{:.0} °C, oil {:.0} °C", bulk.bulk_c, bulk.oil_c);
        tiles.insert(0, ("bulk temperature by the loss", value, "bulk.bulk_c"));
    }
    tiles
}

/// Parts of the loss as bars.
fn losses(result: &RunResult) -> Drawing {
    let s = &result.summary;
    let printed = printed(result);
    let [pinion, wheel] = printed.deformation;
    let hysteresis = s.hysteresis_w;
    let running_in = included(&result.running_in);
    let parts = [
        ("film", s.film_w, printed.film, true),
        (
            "lubricated asperities",
            s.lubricated_asperity_w,
            printed.lubricated,
            true,
        ),
        ("boundary", s.boundary_w, printed.boundary, true),
        (
            "rolling",
            s.rolling_w - hysteresis,
            printed.rolling_friction,
            true,
        ),
        ("deformation, pinion", s.deformation_w[0], pinion, false),
        ("deformation, wheel", s.deformation_w[1], wheel, false),
        ("hysteresis", hysteresis, printed.hysteresis, false),
        ("running-in", running_in, printed.running_in, false),
    ];
    let shares = shares_of_loss(&parts.each_ref().map(|(_, watts, ..)| *watts), result);
    let bars = parts.into_iter().zip(shares);
    let bars = bars
        .filter(|((_, watts, _, always), _)| *always || *watts != 0.0)
        .map(|((name, watts, text, _), share)| Bar {
            name: name.to_owned(),
            value: Some(watts),
            spread: None,
            text: format!("{text}, {share}"),
        })
        .collect();
    let of_power = match &result.uncertainty {
        Some(uncertainty) => {
            let share = 100.0 * uncertainty.loss.median_w / s.power_in_w;
            format!(
                "{} %",
                uncertainty.digits().of_percent(s.power_in_w).rounded(share)
            )
        }
        None => percent(s.loss_w / s.power_in_w),
    };
    Drawing::Bars(BarChart {
        id: "losses".to_owned(),
        title: format!(
            "Losses of the mesh: {}, {of_power} of the power in",
            printed.loss
        ),
        source: "losses.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars,
    })
}

/// Shares of the parts in the loss, with the digits that its band justifies; they add up to 100 %.
fn shares_of_loss(parts: &[f64], result: &RunResult) -> Vec<String> {
    let loss = result.summary.loss_w;
    if loss <= 0.0 {
        return parts.iter().map(|_| percent(0.0)).collect();
    }
    let digits = match &result.uncertainty {
        Some(uncertainty) => uncertainty.digits().of_percent(loss),
        None => Digits::of_decimals(2),
    };
    let shares: Vec<f64> = parts.iter().map(|watts| 100.0 * watts / loss).collect();
    let steps = digits.parts(digits.steps(100.0), &shares);
    let text = |(share, steps): (&f64, f64)| match steps == 0.0 && *share > 0.0 {
        true => format!("< {} %", digits.last_place()),
        false => format!("{} %", digits.text(steps)),
    };
    shares.iter().zip(steps).map(text).collect()
}

fn laws(result: &RunResult) -> Drawing {
    let bars = result.published_laws.iter().map(|entry| {
        let range = match entry.inside_its_range {
            true => "",
            false => ", outside its range",
        };
        let (value, text) = match &entry.outcome {
            PublishedOutcome::Applied { loss_w, .. } => {
                (Some(*loss_w), format!("{} W{range}", significant(*loss_w)))
            }
            _ => (None, "cannot be used here".to_owned()),
        };
        let asperities = match entry.includes_asperities {
            true => "with asperities",
            false => "film alone",
        };
        Bar {
            name: format!("{} ({asperities})", entry.law),
            value,
            spread: None,
            text,
        }
    });
    Drawing::Bars(BarChart {
        id: "friction-laws".to_owned(),
        title: "Published laws, applied whole".to_owned(),
        source: "friction_laws.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars: bars.collect(),
    })
}

/// Three digits or more, with an exponent only for small numbers.
fn significant(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if size >= 100.0 => format!("{value:.0}"),
        size if size >= 0.01 => format!("{value:.2}"),
        _ => format!("{value:.1e}"),
    }
}

fn percent(share: f64) -> String {
    let value = 100.0 * share;
    if value == 0.0 || value >= 0.01 {
        format!("{value:.2} %")
    } else {
        format!("{value:.0e} %")
    }
}
