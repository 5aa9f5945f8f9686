//! Result of a gear train as a whole: its tables, its page, its summary and its headline.

use asperity_core::{Estimate, Fault, capitalised};
use std::path::Path;

use asperity::case::train::mesh_folder;
use asperity::message::Warning;
use asperity::train::Whole;
use maud::{Markup, html};

use crate::chart::{Axis, Bar, BarChart, Drawing};
use crate::folder::{FileText, PAGE, PLANETARY_MARK, TRAIN_MARK, json_text};
use crate::html::band::evidence;
use crate::html::gearbox::section;
use crate::html::overview::{doubt, trust, warnings as listed};
use crate::html::{figure, page, source_line};
use crate::printed::stated;
use crate::summary::besides_the_mesh;
use crate::tables as csv;
use crate::tiles::{Tile, TileKind};
use crate::{Cell, Report, Table, columns};

/// The files of a train without the folders of its meshes; its page shows `warnings`.
pub(crate) fn texts(result: &Whole, warnings: &[Warning]) -> Result<Vec<FileText>, Fault> {
    let mark = match result.set {
        Some(_) => PLANETARY_MARK,
        None => TRAIN_MARK,
    };
    let meshes = csv::text(Path::new("meshes.csv"), &result.meshes)?;
    let shafts = csv::text(Path::new("shafts.csv"), &result.shafts)?;
    Ok(vec![
        (mark, json_text(Path::new(mark), result)?.into_bytes()),
        ("meshes.csv", meshes),
        ("shafts.csv", shafts),
        (PAGE, summary_page(result, warnings).into_bytes()),
    ])
}

/// The line with efficiency and loss.
pub(crate) fn headline(result: &Whole) -> String {
    let [loss, efficiency] = result.with_bands();
    format!("Efficiency (meshes only)  {efficiency}   loss {loss}")
}

/// Losses, meshes and shafts of a gear train for the terminal, with `warnings`.
pub(crate) fn report<'a>(result: &Whole, warnings: impl IntoIterator<Item = String>) -> Report<'a> {
    let gearbox = result
        .gearbox_with_bands()
        .map(|[loss, efficiency]| format!("efficiency (gearbox)      {efficiency}   loss {loss}"));
    let sets = result.planetary_sets().map(|(name, set)| {
        let name = if name.is_empty() {
            String::new()
        } else {
            format!("{name}: ")
        };
        format!(
            "{name}{} planets   carrier {} 1/min   power through the meshes {:.2} kW",
            set.planets,
            rpm(set.carrier_rad_per_s),
            1e-3 * set.rolling_power_w,
        )
    });
    let wide = ["sliding", "rolling", "p₀ at K_γ"];
    Report::new(&result.title, "")
        .verdict([headline(result)])
        .verdict(gearbox)
        .text([format!("power in {:.2} kW", 1e-3 * result.power_in_w)])
        .text(result.gearbox.as_ref().map(besides_the_mesh))
        .text(sets)
        .text(result.heat.as_ref().map(|heat| heat.line()))
        .table(meshes(result).brief(&wide))
        .table(shafts(result))
        .warning(warnings)
}

fn rpm(speed: f64) -> String {
    format!("{:.1}", speed * 30.0 / std::f64::consts::PI)
}

/// Place of the loss of all meshes in the headline.
const LOSS: usize = 1;

/// Names and values of the headline.
fn named_values(result: &Whole) -> Vec<[String; 2]> {
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
    rows.push(row("power in", kw(result.power_in_w)));
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
pub(crate) fn tiles(result: &Whole) -> Vec<Tile> {
    let mut tiles: Vec<Tile> = named_values(result).into_iter().map(Tile::new).collect();
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
    let kinds = kinds.map(|kind| [kind.name.to_owned(), format!("{} W", kind.loss)]);
    tiles.push(Tile::rows(
        "meshes and parts",
        meshes.chain(parts).collect(),
    ));
    tiles.push(Tile::rows("losses of the meshes by kind", kinds.collect()));
    tiles
}

fn summary_page(result: &Whole, warnings: &[Warning]) -> String {
    // Efficiency and loss of the meshes and, if it is computed, of the gearbox.
    let first = if result.gearbox_with_bands().is_some() {
        4
    } else {
        2
    };
    let values = named_values(result);
    let (first, others) = values.split_at(first.min(values.len()));
    let summary = html! {
        (doubt(warnings))
        @for (class, values) in [("tiles first", first), ("tiles", others)] {
            dl class=(class) { @for [name, value] in values { div { dt { (name) } dd { (value) } } } }
        }
        @if result.loss_distribution.is_some() { p.sub { "In brackets: 5 to 95 %." } }
        (trust(warnings, None))
        div.verdict {
            div { (figure(&losses_of_meshes(result))) }
            div { (figure(&losses_by_kind(result))) }
        }
        @if !result.evidence.is_empty() { (evidence(&result.evidence, &|loss| result.digits().rounded(loss))) }
        @if let Some(heat) = &result.heat { p { (capitalised(&heat.line())) "." } }
        @if let Some(gearbox) = &result.gearbox { (section(gearbox, result.loss_distribution.is_some())) }
        (listed(warnings))
    };
    page(
        &result.title,
        &result.program,
        &[
            ("Summary", summary),
            ("Meshes", meshes_section(result)),
            (
                "Losses by kind",
                html! {
                    (kinds(result))
                    p.note { "Losses of all meshes and planets. Each is rounded by itself, so their sums may differ." }
                },
            ),
            ("Shafts", shafts_section(result)),
        ],
    )
}

/// Loss of one mesh of each kind, with its interval if it is drawn.
fn losses_of_meshes(result: &Whole) -> Drawing {
    let bars = result.meshes.iter().map(|row| {
        let drawn = row.drawn_w();
        let times = if row.count == 1 {
            String::new()
        } else {
            format!(", one of {}", row.count)
        };
        Bar {
            name: row.mesh.clone(),
            value: Some(row.loss_w),
            spread: drawn.map(Estimate::ends),
            text: format!("{} W{times}", row.with_digits()[0]),
        }
    });
    let title = match result.loss_distribution {
        Some(_) => "Loss of each mesh, in brackets 5 to 95 %",
        None => "Loss of each mesh",
    };
    bar_chart(["meshes", title, "meshes.csv"], bars.collect())
}

/// Losses of all meshes by kind.
fn losses_by_kind(result: &Whole) -> Drawing {
    let bars = result.kinds_with_digits().into_iter().map(|kind| Bar {
        name: kind.name.to_owned(),
        value: Some(kind.watts),
        spread: None,
        text: format!("{} W, {} % of all", kind.loss, kind.share),
    });
    let mark = if result.set.is_some() {
        PLANETARY_MARK
    } else {
        TRAIN_MARK
    };
    let title = "Losses of all meshes by kind";
    bar_chart(["kinds", title, mark], bars.collect())
}

fn bar_chart([id, title, source]: [&str; 3], bars: Vec<Bar>) -> Drawing {
    Drawing::Bars(BarChart {
        id: id.to_owned(),
        title: title.to_owned(),
        source: source.to_owned(),
        axis: Axis::new("loss", "W"),
        bars,
    })
}

/// The meshes, each with its loss, speeds and pressure.
fn meshes(result: &Whole) -> Table {
    columns! { row in &result.meshes;
        head mesh "mesh" "" = linked(&row.mesh);
        number count "number" "";
        number torque_nm "torque" "N m" "{:.3}";
        number speed "speed" "1/min" = rpm(row.speed_rad_per_s);
        number loss "loss of one" "W" = &row.with_digits()[0];
        number sliding "sliding" "W" = &row.parts_with_digits()[0];
        number rolling "rolling" "W" = &row.parts_with_digits()[1];
        number efficiency "efficiency" "%" = &row.with_digits()[1];
        number loss_factor_local "H_V" "" "{:.4}";
        number mu "μ_eq" "" = &row.with_digits()[2];
        number hertz_pressure_mpa "p₀" "MPa" "{:.0}";
        number hertz_pressure_most_loaded_mpa "p₀ at K_γ" "MPa" "{:.0}";
    }
}

/// Name of a mesh, on the page with a link to its own page.
fn linked(mesh: &str) -> Cell {
    let page = format!("{}/{PAGE}", mesh_folder(mesh));
    Cell::marked(mesh, html! { a href=(page) { (mesh) } })
}

fn meshes_section(result: &Whole) -> Markup {
    html! {
        (meshes(result))
        p { "Torque and speed of the pinion, in a planetary set relative to the carrier. Here the torque is without losses; \
            the table of the shafts has it with losses." }
        @if result.loss_distribution.is_some() {
            p { "In brackets are 5 and 95 % of the samples. They share oil and boundary layer over all meshes, and include the \
                sampling of the flanks. Each mesh has its own page with teeth, flanks and losses along the path." }
        }
        (source_line("meshes.csv"))
    }
}

fn kinds(result: &Whole) -> Table {
    columns! { row in result.kinds_with_digits();
        head kind "kind" "" = row.name;
        number loss "loss of all meshes" "W" = &row.loss;
        number share "of all" "%" = &row.share;
    }
}

/// The shafts with the torque that they carry, and torque and power into the train.
fn shafts(result: &Whole) -> Table {
    columns! { row in &result.shafts;
        head shaft "shaft" "";
        number speed "speed" "1/min" = rpm(row.speed_rad_per_s);
        number carried "torque carried" "N m" = &result.shaft_with_digits(row)[0];
        number torque "torque in" "N m" = &result.shaft_with_digits(row)[1];
        number power "power" "kW" = &result.shaft_with_digits(row)[2];
    }
}

fn shafts_section(result: &Whole) -> Markup {
    let [power_in, power_out] = result.powers_with_digits();
    html! {
        (shafts(result))
        p { "Torque and power into the train, with all losses; negative where the power leaves. The power in is " (power_in)
            " kW and the power out " (power_out) " kW." }
        (source_line("shafts.csv"))
    }
}
