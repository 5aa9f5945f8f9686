//! Result of a gear train: its folder with a table of its meshes and a result folder for each, its summary and its headline.

use asperity_core::Fault;
use std::path::Path;

use asperity::case::gear_train::mesh_folder;
use asperity::gear_train::{MeshRow, TrainOutcome, TrainResult};
use asperity::message::Warning;
use asperity_storage::{check_folder, replace_folder, write_among};
use maud::{Markup, html};

use crate::folder::{
    Fields, FileText, PAGE, PLANETARY_MARK, TRAIN_MARK, check_fields, fill, json_text, load_points,
    make_subfolder, texts, write_bytes,
};
use crate::html::band::evidence;
use crate::html::gearbox::section;
use crate::html::overview::warnings;
use crate::html::page;
use crate::printed::stated;
use crate::ridges;
use crate::summary::{besides_the_mesh, note, short_note, weightiest};
use crate::tables;
use crate::tiles::{Tile, TileKind};
use crate::wrap::{COLUMNS, wrapped};

/// Kind of the folder in messages.
const KIND: &str = "gear train result";

/// Checks that the result of a gear train may be written as folder `target`, as [`crate::check_place`].
///
/// # Errors
/// When `target` holds something else.
pub fn check_train_place(target: &Path) -> Result<(), Fault> {
    Ok(check_folder(target, KIND)?)
}

/// Writes `outcome` as folder `target`: `train.json` (`planetary.json` of a case `[planetary]`), `meshes.csv`,
/// `shafts.csv`, `report.html` and a result folder for each kind of mesh.
///
/// # Errors
/// When a file cannot be written, or `target` holds something else.
pub fn write_train(outcome: &TrainOutcome, target: &Path, fields: &Fields) -> Result<(), Fault> {
    for mesh in &outcome.meshes {
        check_fields(mesh, fields)?;
    }
    replace_folder(target, KIND, |folder| {
        for (name, text) in texts_of_whole(outcome)? {
            write_bytes(&folder.join(name), &text)?;
        }
        for (mesh, row) in outcome.meshes.iter().zip(&outcome.result.meshes) {
            let place = folder.join(mesh_folder(&row.mesh));
            make_subfolder(&place)?;
            fill(mesh, &place, fields)?;
        }
        Ok(())
    })
}

/// The files of [`write_train`] without fields, in memory, with the folders of the meshes in their names.
///
/// # Errors
/// When a number is not finite.
pub fn texts_of_train(outcome: &TrainOutcome) -> Result<Vec<(String, Vec<u8>)>, Fault> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let whole = texts_of_whole(outcome)?.into_iter();
    files.extend(whole.map(|(name, text)| (name.to_owned(), text)));
    for (mesh, row) in outcome.meshes.iter().zip(&outcome.result.meshes) {
        let folder = mesh_folder(&row.mesh);
        let of_mesh = texts(mesh)?.into_iter();
        files.extend(of_mesh.map(|(name, text)| (format!("{folder}/{name}"), text)));
    }
    Ok(files)
}

/// The files of the train without the folders of its meshes.
fn texts_of_whole(outcome: &TrainOutcome) -> Result<Vec<FileText>, Fault> {
    let result = &outcome.result;
    let mark = match result.set {
        Some(_) => PLANETARY_MARK,
        None => TRAIN_MARK,
    };
    let meshes = tables::text(Path::new("meshes.csv"), &result.meshes)?;
    let shafts = tables::text(Path::new("shafts.csv"), &result.shafts)?;
    Ok(vec![
        (mark, json_text(Path::new(mark), result)?.into_bytes()),
        ("meshes.csv", meshes),
        ("shafts.csv", shafts),
        (PAGE, summary_page(outcome).into_bytes()),
    ])
}

/// Adds all points of the load map of each mesh to its folder in `target`, as `map.csv`.
///
/// # Errors
/// When a file cannot be written.
pub fn write_load_points_of_train(outcome: &TrainOutcome, target: &Path) -> Result<(), Fault> {
    let meshes = outcome.meshes.iter().zip(&outcome.result.meshes);
    let files = meshes.map(|(mesh, row)| {
        let (name, text) = load_points(mesh)?;
        Ok((format!("{}/{name}", mesh_folder(&row.mesh)), text))
    });
    let files = files.collect::<Result<Vec<_>, Fault>>()?;
    Ok(write_among(target, &files)?)
}

/// The result of a gear train for the terminal, with all warnings of its meshes.
#[must_use]
pub fn summary_of_train(outcome: &TrainOutcome) -> String {
    let notes = warnings_of(outcome);
    let notes = notes.iter().map(|warning| note(warning, COLUMNS));
    tables_of_train(&outcome.result) + &notes.collect::<String>()
}

/// The result of a gear train for the terminal, with its own warnings, the ridges and at most one warning of each mesh, as [`crate::brief`].
#[must_use]
pub fn brief_of_train(outcome: &TrainOutcome) -> String {
    let mut text = tables_of_train(&outcome.result);
    let of_train = outcome.result.warnings.iter();
    text.extend(of_train.map(|warning| short_note(warning, COLUMNS)));
    for (mesh, row) in outcome.meshes.iter().zip(&outcome.result.meshes) {
        if let Some(ridges) = ridges::line(&mesh.result) {
            let line = format!("{}: {ridges}", row.mesh);
            text.push_str(&format!("{}\n", wrapped(&line, "  ")));
        }
        let warning = weightiest(&mesh.result);
        text.extend(warning.map(|warning| short_note(&of_mesh(&warning, row), COLUMNS)));
    }
    text
}

/// A warning with the mesh that it is about.
fn of_mesh(warning: &Warning, mesh: &MeshRow) -> Warning {
    warning.with(&format!(" [{}]", mesh.mesh))
}

/// All warnings, with the names of the meshes.
fn warnings_of(outcome: &TrainOutcome) -> Vec<Warning> {
    let meshes = outcome.meshes.iter().zip(&outcome.result.meshes);
    let warnings = meshes.flat_map(|(mesh, row)| {
        let warnings = mesh.result.warnings.iter();
        warnings.map(move |warning| of_mesh(warning, row))
    });
    let of_train = outcome.result.warnings.iter().cloned();
    of_train.chain(warnings).collect()
}

/// Losses, meshes and shafts of a gear train for the terminal.
#[must_use]
pub fn tables_of_train(result: &TrainResult) -> String {
    let [loss, efficiency] = result.with_bands();
    let mut text = format!(
        "{}\nefficiency (meshes only)  {efficiency}   loss {loss}\n  power in {:.2} kW\n",
        asperity_storage::one_line(&result.title),
        1e-3 * result.powers_w()[0],
    );
    if let (Some([loss, efficiency]), Some(gearbox)) =
        (result.gearbox_with_bands(), &result.gearbox)
    {
        text.push_str(&format!(
            "efficiency (gearbox)      {efficiency}   loss {loss}\n"
        ));
        text.push_str(&format!("{}\n", wrapped(&besides_the_mesh(gearbox), "  ")));
    }
    for (name, set) in result.planetary_sets() {
        let name = if name.is_empty() {
            String::new()
        } else {
            format!("{name}: ")
        };
        text.push_str(&format!(
            "{name}{} planets   carrier {} 1/min   power through the meshes {:.2} kW\n",
            set.planets,
            rpm(set.carrier_rad_per_s),
            1e-3 * set.rolling_power_w,
        ));
    }
    let width = |names: &mut dyn Iterator<Item = &String>| {
        names
            .map(|name| name.chars().count())
            .max()
            .unwrap_or(0)
            .max(16)
    };
    if let Some(heat) = &result.heat {
        text.push_str(&format!("{}\n", heat.line()));
    }
    let wide = width(&mut result.meshes.iter().map(|row| &row.mesh));
    text.push_str(&format!(
        "{:<wide$} {:>2} {:>10} {:>8} {:>18} {:>8} {:>8} {:>12} {:>7} {:>8} {:>7}\n",
        "mesh",
        "n",
        "T N m",
        "1/min",
        "loss W",
        "sliding",
        "rolling",
        "efficiency",
        "H_V",
        "mu_eq",
        "p0 MPa",
    ));
    for row in &result.meshes {
        let [loss, efficiency, mu] = row.with_digits();
        let parts: String = row
            .parts_with_digits()
            .iter()
            .map(|part| format!(" {part:>8}"))
            .collect();
        text.push_str(&format!(
            "{:<wide$} {:>2} {:>10.3} {:>8} {loss:>18}{parts} {efficiency:>10} % {:>7.4} {mu:>8} {:>7.0}\n",
            row.mesh, row.count, row.torque_nm, rpm(row.speed_rad_per_s), row.loss_factor, row.hertz_pressure_mpa,
        ));
    }
    let wide = width(&mut result.shafts.iter().map(|row| &row.shaft));
    text.push_str(&format!(
        "{:<wide$} {:>13} {:>8} {:>13} {:>9}\n",
        "shaft", "T N m", "1/min", "T into N m", "kW",
    ));
    for row in &result.shafts {
        let [carried, torque, power] = result.shaft_with_digits(row);
        text.push_str(&format!(
            "{:<wide$} {carried:>13} {:>8} {torque:>13} {power:>9}\n",
            row.shaft,
            rpm(row.speed_rad_per_s),
        ));
    }
    text
}

fn rpm(speed: f64) -> String {
    format!("{:.1}", speed * 30.0 / std::f64::consts::PI)
}

/// Place of the loss of all meshes in the headline.
const LOSS: usize = 1;

/// Names and values of the headline.
fn headline(result: &TrainResult) -> Vec<[String; 2]> {
    let [loss, efficiency] = result.with_bands();
    let row = |name: &str, value: String| [name.to_owned(), value];
    let mut rows = vec![
        row("efficiency (meshes only)", efficiency),
        row("loss of all meshes", loss),
    ];
    if let Some([loss, efficiency]) = result.gearbox_with_bands() {
        rows.push(row("efficiency (gearbox)", efficiency));
        rows.push(row("loss of the gearbox", loss));
    }
    let kw = |power_w: f64| format!("{:.3} kW", 1e-3 * power_w);
    rows.push(row("power in", kw(result.powers_w()[0])));
    for (name, set) in result.planetary_sets() {
        let of = if name.is_empty() {
            String::new()
        } else {
            format!(" of {name}")
        };
        rows.push([format!("planets{of}"), set.planets.to_string()]);
        rows.push([
            format!("power through the meshes{of}"),
            kw(set.rolling_power_w),
        ]);
    }
    rows
}

/// The headline of a gear train: loss and efficiency, then the losses of meshes, other parts, and their kinds.
#[must_use]
pub fn tiles_of_train(result: &TrainResult) -> Vec<Tile> {
    let mut tiles: Vec<Tile> = headline(result).into_iter().map(Tile::of).collect();
    tiles[LOSS].kind = TileKind::Loss;
    if result.loss_distribution.is_some() {
        tiles[0].note = "median, in brackets 5 to 95 %".to_owned();
    }
    let meshes = result.meshes.iter().map(|row| {
        let times = if row.count == 1 {
            String::new()
        } else {
            format!("{} × ", row.count)
        };
        [
            row.mesh.clone(),
            format!("{times}{} W", row.with_digits()[0]),
        ]
    });
    let parts = result.gearbox.iter().flat_map(|gearbox| &gearbox.parts);
    let parts = parts.map(|part| [part.name.clone(), stated(part.loss_w)]);
    let kinds = result.kinds_with_digits().into_iter();
    let kinds = kinds.map(|(name, loss, _)| [name.to_owned(), format!("{loss} W")]);
    tiles.push(Tile::rows(
        "meshes and parts",
        meshes.chain(parts).collect(),
    ));
    tiles.push(Tile::rows("losses of the meshes by kind", kinds.collect()));
    tiles
}

fn summary_page(outcome: &TrainOutcome) -> String {
    let result = &outcome.result;
    let summary = html! {
        dl.tiles { @for [name, value] in headline(result) { div { dt { (name) } dd { (value) } } } }
        (evidence(&result.evidence, &|loss| result.digits().rounded(loss)))
        @if let Some(heat) = &result.heat { p { (heat.line()) "." } }
        @if let Some(gearbox) = &result.gearbox { (section(gearbox, result.loss_distribution.is_some())) }
        (warnings(&warnings_of(outcome)))
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
                tr {
                    td { a href={ (mesh_folder(&row.mesh)) "/report.html" } { (row.mesh) } }
                    td.number { (row.count) }
                    td.number { (format!("{:.3}", row.torque_nm)) }
                    td.number { (rpm(row.speed_rad_per_s)) }
                    td.number { (loss) }
                    @for part in row.parts_with_digits() { td.number { (part) } }
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
            tbody { @for (name, loss, share) in result.kinds_with_digits() { tr {
                td { (name) }
                td.number { (loss) }
                td.number { (format!("{:.1}", 100.0 * share)) }
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
