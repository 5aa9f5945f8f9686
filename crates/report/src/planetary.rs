//! Result folder of a planetary set: a table of its meshes, and a result folder for each.

use std::path::Path;

use asperity::planetary::{PlanetaryOutcome, PlanetaryResult};
use asperity_storage::{check_folder, replace_folder};
use maud::html;

use crate::error::ReportError;
use crate::folder::{
    Fields, PAGE, PLANETARY_MARK, check_fields, fill, make_subfolder, write_json, write_text,
};
use crate::html::page;
use crate::tables;

/// Folder names of the meshes of sun and planet, and of planet and ring.
const MESHES: [&str; 2] = ["sun_planet", "planet_ring"];

/// Kind of the folder in messages.
const KIND: &str = "planetary result";

/// Checks that a planetary result may be written as folder `target`, as [`crate::check_place`].
///
/// # Errors
/// When `target` holds something else.
pub fn check_planetary_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `outcome` as folder `target`: `planetary.json`, `meshes.csv`, `report.html` and a result folder for each
/// kind of mesh.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write_planetary(
    outcome: &PlanetaryOutcome,
    target: &Path,
    fields: &Fields,
) -> Result<(), ReportError> {
    for mesh in &outcome.meshes {
        check_fields(mesh, fields)?;
    }
    replace_folder(target, KIND, |folder| {
        let result = &outcome.result;
        write_json(&folder.join(PLANETARY_MARK), result)?;
        tables::write(&folder.join("meshes.csv"), &result.meshes)?;
        for (mesh, name) in outcome.meshes.iter().zip(MESHES) {
            let place = folder.join(name);
            make_subfolder(&place)?;
            fill(mesh, &place, fields)?;
        }
        write_text(&folder.join(PAGE), &summary_page(result))
    })
}

fn summary_page(result: &PlanetaryResult) -> String {
    let rpm = |speed: f64| format!("{:.1} 1/min", speed * 30.0 / std::f64::consts::PI);
    let [loss, efficiency] = result.with_bands();
    let summary = html! {
        dl.tiles {
            div { dt { "efficiency (meshes only)" } dd { (efficiency) " %" } }
            div { dt { "loss of all meshes" } dd { (loss) " W" } }
            div { dt { "power in" } dd { (format!("{:.3} kW", 1e-3 * result.power_in_w)) } }
            div { dt { "power through the meshes" } dd { (format!("{:.3} kW", 1e-3 * result.rolling_power_w)) } }
            div { dt { "planets" } dd { (result.planets) } }
            div { dt { "sun" } dd { (rpm(result.sun_rad_per_s)) } }
            div { dt { "ring" } dd { (rpm(result.ring_rad_per_s)) } }
            div { dt { "carrier" } dd { (rpm(result.carrier_rad_per_s)) } }
        }
        @if !result.can_be_equally_spaced {
            p { "Equally spaced planets cannot be assembled with these tooth numbers." }
        }
    };
    let meshes = html! {
        div.scroll { table {
            thead { tr {
                th { "mesh" } th { "torque [N m]" } th { "loss of one [W]" } th { "efficiency [%]" }
                th { "H_V" } th { "μ_eq" } th { "p₀ [MPa]" } th { "p₀ at K_γ [MPa]" }
            } }
            tbody { @for (row, folder) in result.meshes.iter().zip(MESHES) { @let [loss, efficiency, mu] = row.with_digits(); tr {
                td { a href={ (folder) "/report.html" } { (row.mesh) } }
                td { (format!("{:.3}", row.torque_nm)) }
                td { (loss) }
                td { (efficiency) }
                td { (format!("{:.4}", row.loss_factor)) }
                td { (mu) }
                td { (format!("{:.0}", row.hertz_pressure_mpa)) }
                td { (format!("{:.0}", row.hertz_pressure_most_loaded_mpa)) }
            } } }
        } }
        @if result.loss_distribution.is_some() {
            p { "In brackets 5 and 95 % over the same draws of oil and boundary layer for both kinds of meshes, with the sampling of
                the flanks. Each mesh has its own page with teeth, flanks and losses along the path." }
        }
        p { "data: " a href="meshes.csv" { "meshes.csv" } }
    };
    page(
        &result.title,
        &result.program,
        &[("Summary", summary), ("Meshes", meshes)],
    )
}
