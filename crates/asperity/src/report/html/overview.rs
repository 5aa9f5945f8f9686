//! The numbers that matter, the losses, the friction laws and what calls for attention.

use maud::{Markup, html};
use serde_json::Value;

use super::data::ResultFolder;
use super::figure;
use crate::report::ReportError;
use crate::report::chart::{Axis, Bar, BarChart, Drawing};

pub(super) fn section(result: &ResultFolder) -> Result<Markup, ReportError> {
    let tiles = tiles(result);
    let notes = notes(result);
    let charts = [
        losses(result),
        Some(laws(result)),
        super::path::strip(result)?,
    ];
    Ok(html! {
        dl.tiles {
            @for (name, value, key) in &tiles {
                div { dt { (name) } dd data-key=(key) { (value) } }
            }
        }
        @if !notes.is_empty() {
            h3 { "Calls for attention" }
            ul.warnings {
                @for (code, text) in &notes { li { code { (code) } " " (text) } }
            }
        }
        div.charts { @for chart in charts.iter().flatten() { (figure(chart)) } }
    })
}

/// Name, key in `result.json` and how the number is printed.
type Tile = (&'static str, &'static str, fn(f64) -> String);

/// What a design review asks first.
const TILES: &[Tile] = &[
    ("efficiency (mesh only)", "summary.efficiency", |v| {
        format!("{:.4} %", 100.0 * v)
    }),
    (
        "standard deviation over the offsets",
        "summary.efficiency_deviation",
        |v| format!("±{:.4} %", 100.0 * v),
    ),
    ("loss", "summary.loss_w", |v| format!("{v:.1} W")),
    ("sliding", "summary.sliding_w", |v| format!("{v:.1} W")),
    ("rolling", "summary.rolling_w", |v| format!("{v:.2} W")),
    ("power in", "summary.power_in_w", |v| {
        format!("{:.3} kW", 1e-3 * v)
    }),
    ("torque out", "summary.torque_out_nm", |v| {
        format!("{v:.2} N m")
    }),
    ("equivalent friction μ_eq", "summary.mu_equivalent", |v| {
        format!("{v:.4}")
    }),
    ("loss factor H_V", "summary.loss_factor", |v| {
        format!("{v:.4}")
    }),
    (
        "H_V of the load sharing",
        "summary.loss_factor_local",
        |v| format!("{v:.4}"),
    ),
    (
        "mixed lubrication, of the path",
        "summary.mixed_share",
        |v| format!("{:.1} %", 100.0 * v),
    ),
    ("mesh positions", "summary.positions", |v| format!("{v:.0}")),
    ("offsets of the traces", "summary.offsets", |v| {
        format!("{v:.0}")
    }),
    ("worst load error", "summary.worst_load_error", |v| {
        format!("{v:.1e}")
    }),
    (
        "plastic work, first engagement",
        "running_in.energy_per_engagement_j",
        |v| format!("{v:.2e} J"),
    ),
];

/// Name, value and key of every tile whose number the result has.
fn tiles(result: &ResultFolder) -> Vec<(&'static str, String, &'static str)> {
    let value = |key: &str| result.number(&format!("/{}", key.replace('.', "/")));
    let known = TILES
        .iter()
        .filter_map(|(name, key, print)| Some((*name, print(value(key)?), *key)));
    known.collect()
}

fn notes(result: &ResultFolder) -> Vec<(&str, &str)> {
    result
        .rows("/warnings")
        .iter()
        .filter_map(|entry| Some((entry["code"].as_str()?, entry["text"].as_str()?)))
        .collect()
}

pub(crate) fn losses(result: &ResultFolder) -> Option<Drawing> {
    let (loss, power) = (
        result.number("/summary/loss_w")?,
        result.number("/summary/power_in_w")?,
    );
    let of = |pointer: &str| result.number(pointer).unwrap_or(0.0);
    let included = result.json.pointer("/running_in/included") == Some(&Value::Bool(true));
    let parts = [
        ("sliding", of("/summary/sliding_w"), true),
        ("rolling", of("/summary/rolling_w"), true),
        ("deformation, pinion", of("/summary/deformation_w/0"), false),
        ("deformation, wheel", of("/summary/deformation_w/1"), false),
        ("hysteresis", of("/summary/hysteresis_w"), false),
        (
            "running-in",
            if included {
                of("/running_in/first_pass_w")
            } else {
                0.0
            },
            false,
        ),
    ];
    let bars = parts
        .iter()
        .filter(|(_, watts, always)| *always || *watts != 0.0)
        .map(|(name, watts, _)| Bar {
            name: (*name).to_owned(),
            value: Some(*watts),
            spread: None,
            text: format!("{} W, {}", significant(*watts), percent(watts / loss)),
        })
        .collect();
    Some(Drawing::Bars(BarChart {
        id: "losses".to_owned(),
        title: format!(
            "Losses: {} W, {} of the power in",
            significant(loss),
            percent(loss / power)
        ),
        source: "losses.csv".to_owned(),
        axis: Axis::new("loss", "W"),
        bars,
    }))
}

fn laws(result: &ResultFolder) -> Drawing {
    let spread = result.number("/summary/efficiency_deviation");
    let bars = result
        .rows("/friction_laws")
        .iter()
        .enumerate()
        .map(|(k, entry)| {
            let loss = entry["efficiency"]
                .as_f64()
                .map(|efficiency| 100.0 * (1.0 - efficiency));
            Bar {
                name: entry["law"].as_str().unwrap_or_default().to_owned(),
                value: loss,
                // The case's own law is the first; the spread was found with it.
                spread: spread.filter(|_| k == 0).map(|share| 100.0 * share),
                text: loss.map_or("cannot be used here".to_owned(), |loss| {
                    format!("{loss:.3} %")
                }),
            }
        });
    Drawing::Bars(BarChart {
        id: "friction-laws".to_owned(),
        title: "Friction laws side by side".to_owned(),
        source: "friction_laws.csv".to_owned(),
        axis: Axis::new("loss of the power in", "%"),
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
