//! The gearbox: its efficiency, and the losses that the user states.

use asperity::result::gearbox::GearboxReport;
use asperity::result::loss_band::Uncertainty;
use maud::{Markup, html};

use crate::columns;
use crate::printed::{gearbox_with_interval, stated, stated_parts, watts};

/// Name, formatted value and key in `result.json` of a number.
type GearboxTile = (&'static str, String, &'static str);

/// Efficiency and loss of the mesh and the other parts.
pub(super) fn tiles(gearbox: &GearboxReport, of_mesh: Option<&Uncertainty>) -> Vec<GearboxTile> {
    let [loss, efficiency] = match of_mesh {
        None => [
            watts(gearbox.loss_w),
            format!("{:.4} %", 100.0 * gearbox.efficiency),
        ],
        Some(of_mesh) => gearbox_with_interval(gearbox, of_mesh),
    };
    vec![
        ("efficiency (gearbox)", efficiency, "gearbox.efficiency"),
        ("loss of the gearbox", loss, "gearbox.loss_w"),
    ]
}

/// The parts in addition to the mesh.
pub(crate) fn section(gearbox: &GearboxReport, has_band: bool) -> Markup {
    let losses: Vec<f64> = gearbox.parts.iter().map(|part| part.loss_w).collect();
    let losses = stated_parts(&losses);
    html! {
        h3 { "Besides the mesh, from the input" }
        p {
            "These losses are not computed from the flanks: their constants and tables are input, without an uncertainty. \
            Oil at " (format!("{:.0} °C", gearbox.temperature_c)) ". The mesh is computed with the full torque of the case; all losses are \
            subtracted from the power in."
            @if has_band { " The other parts add no uncertainty." }
        }
        (columns! { row in gearbox.parts.iter().zip(&losses);
            head name "part" "" = &row.0.name;
            text kind "kind" "" = &row.0.kind;
            text law "law" "" = &row.0.law;
            number torque_nm "torque" "N m" "{:.3}" = row.0.torque_nm;
            number loss "loss" "" = row.1;
        })
        p { "Together " (stated(gearbox.parts_w)) "." }
    }
}
