//! The pictures of the chapters in `docs/model`, drawn from runs of the shipped case.
//!
//! `ASPERITY_WRITE=1 cargo test -p asperity-tests --test book pictures` draws them anew.

use asperity::Run;
use asperity::case::{CaseInput, LoadedCase};
use asperity::ehl::{LineContact, Oil, SteadySettings, Window, steady};
use asperity::oil::{DensityLaw, PressureViscosityLaw, ShearLaw};
use asperity::pipeline::Kept;
use asperity::result::PositionRow;
use asperity_profile_io::read::{ReadOptions, read};
use asperity_report::chart::{Axis, Chart, Dress, Interval, Line, Series, Tornado};
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_tests::losses;
use asperity_tests::markdown::root;
use asperity_tests::picture::hold_picture;

fn e_drive(keys: &[(&str, &str)]) -> LoadedCase {
    let set = |input: &mut CaseInput| {
        for (key, value) in keys {
            input.set(key, value).unwrap();
        }
    };
    asperity::case::load_with(&root().join("fixtures/cases/e-drive.toml"), &set).unwrap()
}

fn along(row: &PositionRow) -> f64 {
    row.path_fraction
}

/// A curve over the path of contact.
pub fn over_path(
    name: &str,
    line: Line,
    path: &[PositionRow],
    value: fn(&PositionRow) -> f64,
) -> Series {
    Series::through(name, line, path.iter().map(|row| [along(row), value(row)]))
}

fn path_axis() -> Axis {
    Axis::new("place on the path of contact, from A to E", "-")
}

/// Enough positions for a smooth curve; windows of the traces do not matter for the load.
const FINE: [(&str, &str); 2] = [("model.positions", "48"), ("model.offsets", "1")];

fn mesh() -> String {
    let relieved = [
        (
            "gears.pinion.tip_relief",
            "{ amount = \"10 um\", length = \"2.9 mm\" }",
        ),
        (
            "gears.wheel.tip_relief",
            "{ amount = \"10 um\", length = \"2.9 mm\" }",
        ),
    ];
    let load = |row: &PositionRow| row.line_load_n_per_mm;
    let of = |keys: &[(&str, &str)]| losses(&e_drive(&[&FINE[..], keys].concat())).unwrap().path;
    Chart::new(
        "mesh",
        "Line load of the e-drive",
        "mesh.md",
        path_axis(),
        Axis::new("line load", "N/mm").from_zero(),
    )
    .with(over_path("no relief", Line::Solid, &of(&[]), load))
    .with(over_path(
        "10 um of tip relief on both gears",
        Line::Dashed,
        &of(&relieved),
        load,
    ))
    .svg(Dress::Alone)
}

fn roughness() -> String {
    let file = root().join("fixtures/profiles/ground_pinion.csv");
    let profile = read(&file, &ReadOptions::default()).unwrap().profile;
    let recipe = |lambda_c: Option<&str>| Preparation {
        lambda_c: lambda_c.map(|cutoff| cutoff.parse().unwrap()),
        ..Preparation::default()
    };
    let primary = prepare(&profile, &recipe(None)).unwrap();
    let filtered = prepare(&profile, &recipe(Some("0.25 mm"))).unwrap();
    let step = profile.spacing().si();
    // A part of 0.8 mm in the middle.
    let (start, count) = (profile.len() / 2, (0.8e-3 / step) as usize);
    let heights = |index: usize| {
        let whole = primary.profile.heights()[start + index - primary.first_index];
        let rough = filtered.profile.heights()[start + index - filtered.first_index];
        [1e6 * whole, 1e6 * rough, 1e6 * (whole - rough)]
    };
    let curve = |name, line, which: usize| {
        let points = (0..count)
            .step_by(4)
            .map(|i| [1e3 * step * i as f64, heights(i)[which]]);
        Series::through(name, line, points)
    };
    Chart::new(
        "roughness",
        "A part of a ground flank",
        "roughness.md",
        Axis::new("along the flank", "mm"),
        Axis::new("height", "um"),
    )
    .with(curve(
        "levelled, without waves shorter than 2.5 um",
        Line::Solid,
        0,
    ))
    .with(curve("mean line at 0.25 mm", Line::Ink, 2))
    .with(curve("roughness", Line::Dashed, 1))
    .svg(Dress::Alone)
}

fn film() -> String {
    let path = losses(&e_drive(&[("model.offsets", "64")])).unwrap().path;
    Chart::new(
        "film",
        "Film of the e-drive at 90 °C",
        "film.md",
        path_axis(),
        Axis::new("thickness", "um").from_zero(),
    )
    .with(over_path(
        "smooth central film",
        Line::Solid,
        &path,
        |row| row.film_central_um,
    ))
    .with(over_path(
        "smooth minimum film",
        Line::Dashed,
        &path,
        |row| row.film_minimum_um,
    ))
    .with(over_path(
        "mean gap of the rough flanks",
        Line::Dots,
        &path,
        |row| row.mean_gap_um.unwrap_or(f64::NAN),
    ))
    .svg(Dress::Alone)
}

fn losses_along() -> String {
    let path = losses(&e_drive(&[("model.offsets", "16")])).unwrap().path;
    let axis = Axis::new("loss per metre of contact line", "W/m").from_zero();
    Chart::new(
        "losses",
        "Losses of the e-drive, ground flanks",
        "losses.md",
        path_axis(),
        axis,
    )
    .with(over_path("film", Line::Solid, &path, |row| {
        row.film_w_per_m
    }))
    .with(over_path(
        "lubricated asperities",
        Line::Dots,
        &path,
        |row| row.lubricated_asperity_w_per_m,
    ))
    .with(over_path("boundary layer", Line::Dashed, &path, |row| {
        row.boundary_w_per_m
    }))
    .with(over_path("rolling", Line::Ink, &path, |row| {
        row.rolling_w_per_m
    }))
    .svg(Dress::Alone)
}

fn uncertainty() -> String {
    let case = e_drive(&[]);
    let result = Run::new(&case)
        .pictures(Kept::NoPictures)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result;
    let loss = result.uncertainty.unwrap().loss;
    let tens = |watts: f64| 10.0 * (watts / 10.0).round();
    let interval = |name: &str, [low, high]: [f64; 2]| Interval {
        name: name.to_owned(),
        ends: [low, high],
        middle: None,
        text: format!("{:.0} to {:.0}", tens(low), tens(high)),
    };
    let mut intervals = vec![interval("all together", loss.drawn().ends())];
    let parts = loss.parts.iter().take(7);
    intervals.extend(parts.map(|part| interval(&part.name, part.quantiles_w)));
    let tornado = Tornado {
        id: "uncertainty".to_owned(),
        title: "Loss of the e-drive, 5 to 95 %, and its components".to_owned(),
        source: "uncertainty.md".to_owned(),
        axis: Axis::new("loss", "W"),
        middle: Some(loss.drawn().value),
        intervals,
    };
    tornado.svg(Dress::Alone)
}

fn ehl() -> String {
    let oil = Oil {
        viscosity: "10 mPa s".parse().unwrap(),
        pressure_viscosity: "18 1/GPa".parse().unwrap(),
        viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
        density_law: DensityLaw::DowsonHigginson,
        shear_law: ShearLaw::Newtonian,
    };
    let [radius, modulus] = ["10 mm", "115.4 GPa"];
    let contact = LineContact::at_pressure(
        radius.parse().unwrap(),
        modulus.parse().unwrap(),
        "1.2 GPa".parse().unwrap(),
        "5 m/s".parse().unwrap(),
        0.0,
    );
    let settings = SteadySettings {
        cells: 512,
        window: Some(Window::ROUGH),
    };
    let film = steady::solve(&contact.unwrap(), &oil, &settings)
        .unwrap()
        .value;
    let curve = |name, line, values: &[f64], scale: f64| {
        let within = film
            .x
            .iter()
            .zip(values)
            .filter(|(x, _)| (-1.8..1.3).contains(*x));
        Series::through(name, line, within.map(|(x, value)| [*x, scale * value]))
    };
    let central = film.film[film.x.iter().position(|x| *x >= 0.0).unwrap()];
    let axis =
        Axis::new("film over central film, pressure over Hertz pressure", "-").within(0.0, 3.0);
    Chart::new(
        "ehl",
        "Smooth contact of 1.2 GPa at 5 m/s",
        "ehl.md",
        Axis::new("place over Hertz half-width", "-"),
        axis,
    )
    .with(curve("film", Line::Solid, &film.film, 1.0 / central))
    .with(curve("pressure", Line::Dashed, &film.pressure, 1.0))
    .svg(Dress::Alone)
}

#[test]
fn pictures_of_mesh_and_roughness_are_new() {
    hold_picture("model/mesh.svg", &mesh());
    hold_picture("model/roughness.svg", &roughness());
}

#[test]
fn pictures_of_film_and_losses_are_new() {
    hold_picture("model/film.svg", &film());
    hold_picture("model/losses.svg", &losses_along());
}

#[test]
fn pictures_of_uncertainty_and_reference_are_new() {
    hold_picture("model/uncertainty.svg", &uncertainty());
    hold_picture("model/ehl.svg", &ehl());
}
