//! Summary: the numbers that matter, the warnings, the losses, the friction laws, the regime.

use asperity::loss_band::{LossBand, rounded};
use asperity::result::{FlankHeights, PublishedOutcome, RunInFlanks, RunResult, Scope, Summary};
use maud::{Markup, html};

use super::page::figure;
use crate::chart::{Axis, Bar, BarChart, Drawing};

pub(super) fn section(result: &RunResult) -> Markup {
    let mut first = headline(result);
    if let Some(found) = &result.gearbox {
        first.extend(super::gearbox::tiles(found, result.band.as_ref()));
    }
    let rows = [
        ("tiles first", first),
        ("tiles", parts(result)),
        ("tiles last", evidence(result)),
    ];
    let beside = result.band.as_ref().map(super::band::beside);
    let others = [losses(result), laws(result), super::path::strip(result)];
    let charts: Vec<Drawing> = beside.into_iter().chain(others).collect();
    html! {
        @for (class, tiles) in &rows {
            dl class=(class) {
                @for (name, value, key) in tiles {
                    div { dt { (name) } dd data-key=(key) { (value) } }
                }
            }
        }
        @if let Some(found) = &result.gearbox { (super::gearbox::section(found, result.band.is_some())) }
        @if let Some(band) = &result.band { (super::band::section(band)) }
        @if let Some(pairs) = &result.pairs { @if let Some(sampling) = &pairs.sampling {
            (super::pairs::section(pairs, sampling))
        } }
        @if let Some(run_in) = &result.run_in { (as_measured_and_run_in(result, run_in)) }
        @if let Some(found) = &result.micropitting { (super::micropitting::section(found)) }
        @if !result.warnings.is_empty() {
            h3 { "Warnings" }
            ul.warnings {
                @for warning in &result.warnings { li { code { (warning.code) } " " (warning.text) } }
            }
        }
        div.charts { @for chart in &charts { (figure(chart)) } }
    }
}

/// Losses and roughness of the flanks as measured beside those of the run-in flanks.
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
            "The flanks ran in over " (passes) " contacts of the whole load without a film; all else on this page is of \
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

/// Name of a number, its value as text, its key in `result.json`.
type Tile = (&'static str, String, &'static str);

/// Headline of a design review: efficiency and loss.
fn headline(result: &RunResult) -> Vec<Tile> {
    let s = &result.summary;
    let mixed = (
        "mixed lubrication, of the path",
        format!("{:.1} %", 100.0 * s.mixed_share),
        "summary.mixed_share",
    );
    let Some(band) = &result.band else {
        return vec![
            (
                "efficiency (mesh only)",
                format!("{:.4} %", 100.0 * s.efficiency),
                "summary.efficiency",
            ),
            ("loss", format!("{:.1} W", s.loss_w), "summary.loss_w"),
            mixed,
        ];
    };
    let [least, most] = band.quantiles_w;
    let loss = |power: f64| rounded(power, band.half_width_w());
    let [low, high] = band.efficiency_quantiles;
    let share = |share: f64| rounded(100.0 * share, 50.0 * (high - low));
    vec![
        (
            "efficiency (mesh only), in brackets 5 to 95 %",
            format!(
                "{} % ({}..{})",
                share(s.efficiency),
                share(low),
                share(high)
            ),
            "summary.efficiency",
        ),
        (
            "loss, in brackets 5 to 95 %",
            format!("{} W ({}..{})", loss(s.loss_w), loss(least), loss(most)),
            "summary.loss_w",
        ),
        mixed,
    ]
}

/// A part of the loss, with the digits that the band of the whole leaves; a small one keeps some.
fn part(result: &RunResult, power: f64) -> String {
    let by_band = |band: &LossBand| rounded(power, band.half_width_w());
    match result.band.as_ref().map(by_band) {
        Some(text) if power == 0.0 || text != "0" => format!("{text} W"),
        None if power == 0.0 || power.abs() >= 0.05 => format!("{power:.1} W"),
        _ => format!("{} W", significant(power)),
    }
}

/// Parts of the loss, and what goes in and out.
fn parts(result: &RunResult) -> Vec<Tile> {
    let s = &result.summary;
    vec![
        ("sliding", part(result, s.sliding_w), "summary.sliding_w"),
        ("rolling", part(result, s.rolling_w), "summary.rolling_w"),
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

/// Evidence behind the numbers.
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
        let found = format!("{:.0} °C, oil {:.0} °C", bulk.bulk_c, bulk.oil_c);
        tiles.insert(0, ("bulk temperature by the loss", found, "bulk.bulk_c"));
    }
    tiles
}

/// Parts of the loss as bars.
fn losses(result: &RunResult) -> Drawing {
    let s = &result.summary;
    let running_in = match result.running_in.included {
        true => result.running_in.first_pass_w,
        false => 0.0,
    };
    let parts = [
        ("film", s.film_w, true),
        ("lubricated asperities", s.lubricated_asperity_w, true),
        ("boundary", s.boundary_w, true),
        ("rolling", s.rolling_w - s.hysteresis_w, true),
        ("deformation, pinion", s.deformation_w[0], false),
        ("deformation, wheel", s.deformation_w[1], false),
        ("hysteresis", s.hysteresis_w, false),
        ("running-in", running_in, false),
    ];
    let share = |watts: f64| {
        if s.loss_w > 0.0 {
            watts / s.loss_w
        } else {
            0.0
        }
    };
    let bars = parts
        .iter()
        .filter(|(_, watts, always)| *always || *watts != 0.0)
        .map(|(name, watts, _)| Bar {
            name: (*name).to_owned(),
            value: Some(*watts),
            spread: None,
            text: format!("{}, {}", part(result, *watts), percent(share(*watts))),
        })
        .collect();
    Drawing::Bars(BarChart {
        id: "losses".to_owned(),
        title: format!(
            "Losses of the mesh: {}, {} of the power in",
            part(result, s.loss_w),
            percent(s.loss_w / s.power_in_w)
        ),
        source: "losses.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars,
    })
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

/// Three digits or more, never an exponent where one can do without.
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
