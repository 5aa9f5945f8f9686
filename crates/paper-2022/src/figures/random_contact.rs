//! Fig. 6: two random surfaces in dry contact: deformation, contact stress and subsurface stress.
//!
//! The paper does not give its surfaces; these are self-affine with the roughness of ground flanks.

use std::path::Path;

use asperity::PositionError;
use asperity_contact::subsurface::{graded_depths, subsurface_stress};
use asperity_contact::two_flanks::TwoFlanks;
use asperity_contact::{ContactSolution, SolverSettings};
use asperity_core::numerics::range;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{Fault, Profile};
use asperity_report::chart::{Axis, Chart, Contour, Drawing, Line, Series};
use asperity_report::tables::write;
use asperity_report::thin;
use asperity_report::units::MICRO;
use asperity_roughness::generate::SelfAffine;
use serde::Serialize;

use super::figure::PaperFigure;

/// Relative radius, line load and modulus of the reference case at its pitch point.
const RADIUS: Length = Length::from_si(11.627e-3);
const LOAD: LineLoad = LineLoad::from_si(113.41e3);
const MODULUS: Pressure = Pressure::from_si(115.384_615e9);
const POISSON: f64 = 0.3;
/// Hertz half width of that contact.
const HALF_WIDTH: Length = Length::from_si(120.62e-6);
const POINTS: usize = 1441;
const SPACING: Length = Length::from_si(0.5e-6);
const SEEDS: [u64; 2] = [6, 66];

/// Surface with Rq 0.3 µm, typical of ground flanks.
fn surface(seed: u64) -> Result<Profile, PositionError> {
    let recipe = SelfAffine {
        points: POINTS,
        spacing: SPACING,
        rq: Length::from_si(0.3e-6),
        hurst: 0.8,
        roll_off: Length::from_si(60e-6),
        short_cut: Length::from_si(5e-6),
        seed,
    };
    Ok(recipe.generate()?)
}

const TABLE: &str = "fig06_surface.csv";

pub(super) fn figures(folder: &Path) -> Result<Vec<PaperFigure>, Fault> {
    let surfaces = [surface(SEEDS[0])?, surface(SEEDS[1])?];
    let flanks = TwoFlanks {
        first: &surfaces[0],
        second: &surfaces[1],
        radius: RADIUS,
        load: LOAD,
        modulus: MODULUS,
        pressure_limit: None,
    };
    let gap = flanks.gap().map_err(PositionError::from)?;
    let solution = flanks
        .press(&SolverSettings::default())
        .map_err(PositionError::from)?;
    let rows = rows(&surfaces, &gap, &solution);
    write(&folder.join(TABLE), rows.iter())?;
    let x: Vec<f64> = rows.iter().map(|row| row.x_um).collect();
    let mut figures = charts(&rows);
    let stress = below(&x, &solution, folder)?;
    figures.push(PaperFigure {
        name: "fig06d_subsurface",
        drawing: Drawing::Contour(stress),
    });
    Ok(figures)
}

fn charts(rows: &[ContactRow]) -> Vec<PaperFigure> {
    let curve = |name: &str, line: Line, of: fn(&ContactRow) -> f64| {
        Series::through(name, line, rows.iter().map(|row| [row.x_um, of(row)]))
    };
    let chart = |id: &str, title: &str, y: Axis| Chart::new(id, title, TABLE, across(), y);
    let shape = chart(
        "fig06a",
        "Fig. 6a: two random surfaces before contact",
        Axis::new("height", "µm"),
    )
    .with(curve("first", Line::Solid, |row| row.height_first_um))
    .with(curve("second", Line::Solid, |row| row.height_second_um));
    let deformed = chart(
        "fig06b",
        "Fig. 6b: gap before and in contact",
        Axis::new("gap", "µm").from_zero(),
    )
    .with(curve("undeformed", Line::Dashed, |row| {
        row.gap_undeformed_um
    }))
    .with(curve("in contact", Line::Solid, |row| row.gap_um))
    .with(curve("elastic displacement of both", Line::Solid, |row| {
        row.displacement_um
    }));
    let pressure = chart(
        "fig06c",
        "Fig. 6c: contact stress",
        Axis::new("pressure", "MPa").from_zero(),
    )
    .with(curve("random surfaces", Line::Solid, |row| {
        row.pressure_mpa
    }))
    .with(curve("Hertz, smooth", Line::Dashed, |row| {
        row.pressure_hertz_mpa
    }));
    vec![
        PaperFigure::curves("fig06a_surfaces", shape),
        PaperFigure::curves("fig06b_deformation", deformed),
        PaperFigure::curves("fig06c_contact_stress", pressure),
    ]
}

fn across() -> Axis {
    Axis::new("distance from the middle of the contact", "µm")
}

/// Rounds to four decimals of micrometres or megapascals, the accuracy of the solver's tolerance.
fn digits(value: f64) -> f64 {
    (value * 1e4).round() / 1e4
}

#[derive(Serialize)]
struct ContactRow {
    x_um: f64,
    height_first_um: f64,
    height_second_um: f64,
    gap_undeformed_um: f64,
    gap_um: f64,
    displacement_um: f64,
    pressure_mpa: f64,
    pressure_hertz_mpa: f64,
}

fn rows(surfaces: &[Profile; 2], gap: &[f64], solution: &ContactSolution) -> Vec<ContactRow> {
    let hertz = 2.0 * LOAD.si() / (std::f64::consts::PI * HALF_WIDTH.si());
    // The displacement is relative to a datum; only its shape matters, so the least value is subtracted.
    let least = solution
        .displacement
        .iter()
        .copied()
        .fold(f64::INFINITY, f64::min);
    (0..POINTS)
        .map(|i| {
            let x = (i as f64 - 0.5 * (POINTS - 1) as f64) * SPACING.si();
            let um = |length: f64| digits(length * MICRO);
            let mpa = |pressure: f64| digits(pressure * 1e-6);
            let ellipse = (1.0 - (x / HALF_WIDTH.si()).powi(2)).max(0.0).sqrt();
            ContactRow {
                x_um: um(x),
                height_first_um: um(surfaces[0].heights()[i]),
                height_second_um: um(surfaces[1].heights()[i]),
                gap_undeformed_um: um(gap[i]),
                gap_um: um(solution.gap[i]),
                displacement_um: um(solution.displacement[i] - least),
                pressure_mpa: mpa(solution.pressure[i]),
                pressure_hertz_mpa: mpa(hertz * ellipse),
            }
        })
        .collect()
}

fn below(x: &[f64], solution: &ContactSolution, folder: &Path) -> Result<Contour, Fault> {
    const TABLE: &str = "fig06_subsurface.csv";
    const DEPTHS: usize = 32;
    const BINS: usize = 120;
    /// Range of the chart in half widths: the effect of asperities is limited to the surface.
    const REACH: [f64; 2] = [1.2, 0.5];
    let depths = graded_depths(SPACING, HALF_WIDTH, DEPTHS).map_err(PositionError::from)?;
    let field = subsurface_stress(&solution.pressure, None, SPACING, &depths)
        .map_err(PositionError::from)?;
    let stress = field.von_mises(POISSON).map_err(PositionError::from)?;
    #[derive(Serialize)]
    struct StressRow {
        x_um: f64,
        depth_um: f64,
        von_mises_mpa: f64,
    }
    let rows: Vec<usize> = (0..DEPTHS)
        .filter(|j| depths[*j] <= REACH[1] * HALF_WIDTH.si())
        .collect();
    let near: Vec<usize> = (0..x.len())
        .filter(|i| x[*i].abs() <= REACH[0] * HALF_WIDTH.si() * MICRO)
        .collect();
    let extremes = |i: &usize| range(rows.iter().map(|j| stress[j * x.len() + i]));
    let columns = thin(&near, BINS, |i| x[*i], extremes);
    let cells: Vec<StressRow> = rows
        .iter()
        .flat_map(|j| columns.iter().map(move |i| (*i, *j)))
        .map(|(i, j)| StressRow {
            x_um: x[i],
            depth_um: digits(depths[j] * MICRO),
            von_mises_mpa: digits(stress[j * x.len() + i] * 1e-6),
        })
        .collect();
    write(&folder.join(TABLE), cells.iter())?;
    Ok(Contour {
        id: "fig06d".to_owned(),
        title: "Fig. 6d: stress below the surface".to_owned(),
        source: TABLE.to_owned(),
        x: across(),
        y: Axis::new("depth", "µm").downward(),
        value: "von Mises stress [MPa]".to_owned(),
        columns: columns.iter().map(|i| x[*i]).collect(),
        rows: rows.iter().map(|j| depths[*j] * MICRO).collect(),
        values: cells.iter().map(|cell| cell.von_mises_mpa).collect(),
        height: 230.0,
        ..Contour::default()
    })
}
