//! Result folder of a gear train: a table of its meshes, and a result folder for each.

use std::path::Path;

use asperity::gear_train::{TrainOutcome, TrainResult};
use asperity_storage::{check_folder, replace_folder};
use maud::{Markup, html};

use crate::error::ReportError;
use crate::folder::{
    Fields, PAGE, PLANETARY_MARK, TRAIN_MARK, check_fields, fill, make_subfolder, write_json,
    write_text,
};
use crate::html::gearbox::section;
use crate::html::page;
use crate::tables;

/// Kind of the folder in messages.
const KIND: &str = "gear train result";

/// Checks that the result of a gear train may be written as folder `target`, as [`crate::check_place`].
///
/// # Errors
/// When `target` holds something else.
pub fn check_train_place(target: &Path) -> Result<(), ReportError> {
    Ok(check_folder(target, KIND)?)
}

/// Folder of a mesh: its name as one word, `sun_planet` of "sun and planet".
fn folder_of(mesh: &str) -> String {
    mesh.replace(" and ", "_").replace(", ", "_")
}

/// Writes `outcome` as folder `target`: `train.json` (`planetary.json` of a case `[planetary]`), `meshes.csv`,
/// `shafts.csv`, `report.html` and a result folder for each kind of mesh.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write_train(
    outcome: &TrainOutcome,
    target: &Path,
    fields: &Fields,
) -> Result<(), ReportError> {
    for mesh in &outcome.meshes {
        check_fields(mesh, fields)?;
    }
    replace_folder(target, KIND, |folder| {
        let result = &outcome.result;
        let mark = match result.set {
            Some(_) => PLANETARY_MARK,
            None => TRAIN_MARK,
        };
        write_json(&folder.join(mark), result)?;
        tables::write(&folder.join("meshes.csv"), &result.meshes)?;
        tables::write(&folder.join("shafts.csv"), &result.shafts)?;
        for (mesh, row) in outcome.meshes.iter().zip(&result.meshes) {
            let place = folder.join(folder_of(&row.mesh));
            make_subfolder(&place)?;
            fill(mesh, &place, fields)?;
        }
        write_text(&folder.join(PAGE), &summary_page(result))
    })
}

fn rpm(speed: f64) -> String {
    format!("{:.1}", speed * 30.0 / std::f64::consts::PI)
}

fn summary_page(result: &TrainResult) -> String {
    let [loss, efficiency] = result.with_bands();
    let summary = html! {
        dl.tiles {
            div { dt { "efficiency (meshes only)" } dd { (efficiency) " %" } }
            div { dt { "loss of all meshes" } dd { (loss) " W" } }
            @if let Some([loss, efficiency]) = result.gearbox_with_bands() {
                div { dt { "efficiency (gearbox)" } dd { (efficiency) " %" } }
                div { dt { "loss of the gearbox" } dd { (loss) " W" } }
            }
            div { dt { "power in" } dd { (format!("{:.3} kW", 1e-3 * result.power_in_w)) } }
            @for (name, set) in result.planetary_sets() {
                @let of = if name.is_empty() { String::new() } else { format!(" of {name}") };
                div { dt { "planets" (of) } dd { (set.planets) } }
                div { dt { "power through the meshes" (of) } dd { (format!("{:.3} kW", 1e-3 * set.rolling_power_w)) } }
            }
        }
        @if let Some(heat) = &result.heat { p { (heat.line()) "." } }
        @if let Some(gearbox) = &result.gearbox { (section(gearbox, result.loss_distribution.is_some())) }
        @for (name, _) in result.planetary_sets().filter(|(_, set)| !set.can_be_equally_spaced) {
            p { @if !name.is_empty() { (name) ": " } "equally spaced planets cannot be assembled with these tooth numbers." }
        }
    };
    page(
        &result.title,
        &result.program,
        &[
            ("Summary", summary),
            ("Meshes", meshes(result)),
            ("Losses by kind", kinds(result)),
            ("Shafts", shafts(result)),
        ],
    )
}

fn meshes(result: &TrainResult) -> Markup {
    html! {
        div.scroll { table {
            thead { tr {
                th { "mesh" } th.number { "number" } th.number { "torque [N m]" } th.number { "speed [1/min]" } th.number { "loss of one [W]" }
                th.number { "sliding [W]" } th.number { "rolling [W]" } th.number { "efficiency [%]" }
                th.number { "H_V" } th.number { "μ_eq" } th.number { "p₀ [MPa]" } th.number { "p₀ at K_γ [MPa]" }
            } }
            tbody { @for row in &result.meshes {
                @let [loss, efficiency, mu] = row.with_digits();
                @let [sliding, rolling] = row.parts_with_digits();
                tr {
                    td { a href={ (folder_of(&row.mesh)) "/report.html" } { (row.mesh) } }
                    td.number { (row.count) }
                    td.number { (format!("{:.3}", row.torque_nm)) }
                    td.number { (rpm(row.speed_rad_per_s)) }
                    td.number { (loss) }
                    td.number { (sliding) }
                    td.number { (rolling) }
                    td.number { (efficiency) }
                    td.number { (format!("{:.4}", row.loss_factor)) }
                    td.number { (mu) }
                    td.number { (format!("{:.0}", row.hertz_pressure_mpa)) }
                    td.number { (format!("{:.0}", row.hertz_pressure_most_loaded_mpa)) }
                }
            } }
        } }
        p { "Torque and speed of the pinion, in a planetary set relative to the carrier." }
        @if result.loss_distribution.is_some() {
            p { "In brackets 5 and 95 % over the same draws of oil and boundary layer for all meshes, with the sampling of
                the flanks. Each mesh has its own page with teeth, flanks and losses along the path." }
        }
        p { "data: " a href="meshes.csv" { "meshes.csv" } }
    }
}

fn kinds(result: &TrainResult) -> Markup {
    html! {
        div.scroll { table {
            thead { tr { th { "loss of all meshes" } th.number { "[W]" } th.number { "share [%]" } } }
            tbody { @for (name, loss) in result.kinds.rows() { tr {
                td { (name) }
                td.number { (result.part_with_digits(loss)) }
                td.number { (format!("{:.1}", 100.0 * loss / result.loss_w)) }
            } } }
        } }
    }
}

fn shafts(result: &TrainResult) -> Markup {
    let [power_in, power_out] = result.powers_with_digits();
    html! {
        div.scroll { table {
            thead { tr { th { "shaft" } th.number { "speed [1/min]" } th.number { "torque carried [N m]" } th.number { "torque into the train [N m]" }
                th.number { "power [kW]" } } }
            tbody { @for row in &result.shafts {
                @let [carried, torque, power] = result.shaft_with_digits(row);
                tr {
                    td { (row.shaft) }
                    td.number { (rpm(row.speed_rad_per_s)) }
                    td.number { (carried) }
                    td.number { (torque) }
                    td.number { (power) }
                }
            } }
        } }
        p { "Torque and power into the train, with all losses; negative where the power leaves. The power in is " (power_in)
            " kW and the power out " (power_out) " kW." }
        p { "data: " a href="shafts.csv" { "shafts.csv" } }
    }
}
