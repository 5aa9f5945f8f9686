//! The gearbox around the mesh: its efficiency, and the parts that its user states.

use asperity::result::gearbox::GearboxReport;
use asperity::result::loss_band::{LossBand, rounded};
use maud::{Markup, html};

use crate::printed::{stated, stated_parts};

/// Name of a number, its value as text, its key in `result.json`.
type Tile = (&'static str, String, &'static str);

/// Efficiency and loss of mesh and parts together.
pub(super) fn tiles(found: &GearboxReport, band: Option<&LossBand>) -> Vec<Tile> {
    let (efficiency, loss) = match band {
        None => (
            format!("{:.4} %", 100.0 * found.efficiency),
            format!("{:.1} W", found.loss_w),
        ),
        Some(band) => {
            let [low, high] = found.efficiency_quantiles(band);
            let [least, most] = found.quantiles_w(band);
            let share = |share: f64| rounded(100.0 * share, 50.0 * (high - low));
            let loss = |power: f64| rounded(power, band.half_width_w());
            (
                format!(
                    "{} % ({}..{})",
                    share(found.efficiency),
                    share(low),
                    share(high)
                ),
                format!("{} W ({}..{})", loss(found.loss_w), loss(least), loss(most)),
            )
        }
    };
    vec![
        ("efficiency (gearbox)", efficiency, "gearbox.efficiency"),
        ("loss of the gearbox", loss, "gearbox.loss_w"),
    ]
}

/// The parts beside the mesh.
pub(super) fn section(found: &GearboxReport, has_band: bool) -> Markup {
    let losses: Vec<f64> = found.parts.iter().map(|part| part.loss_w).collect();
    let losses = stated_parts(&losses);
    html! {
        h3 { "Beside the mesh, stated by the user" }
        p {
            "These losses are not computed from the flanks: their constants, loads and tables come from the case, and they have no band. \
            Oil at " (format!("{:.0} °C", found.temperature_c)) ". The mesh is computed with the whole torque of the case; all losses count \
            against the power in."
            @if has_band { " Brackets of the gearbox are those of the mesh." }
        }
        div.scroll { table {
            thead { tr { th { "part" } th { "kind" } th { "law" } th.number { "torque [N m]" } th.number { "loss" } } }
            tbody {
                @for (part, loss) in found.parts.iter().zip(&losses) {
                    tr {
                        th scope="row" { (part.name) } td { (part.kind) } td { (part.law) }
                        td.number { (format!("{:.3}", part.torque_nm)) } td.number { (loss) }
                    }
                }
                tr { th scope="row" { "together" } td {} td {} td {} td.number { (stated(found.parts_w)) } }
            }
        } }
    }
}
