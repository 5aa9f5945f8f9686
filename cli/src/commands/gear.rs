//! `asperity gear`: geometry, contact ratios, stiffness, transmission error, loss factors of every law.

use asperity::case::LoadedCase;
use asperity::quantity::Length;
use asperity::result::gear_report::{GearReport, gear_report};
use asperity_report::{Report, Table, columns};

use super::{load_train, mesh_of, of_meshes};
use crate::args::{CaseArgs, Common};
use crate::failure::Failure;
use crate::output::print_report;

/// `asperity gear`
pub fn gear(args: &CaseArgs, common: &Common) -> Result<(), Failure> {
    let report = |loaded: &LoadedCase| {
        gear_report(&loaded.case).map_err(|error| Failure::about(&args.case, &error))
    };
    let train = load_train(&args.case, &args.set, args.formulation)?;
    let reports = train.cases().map(report);
    let reports = reports.collect::<Result<Vec<_>, Failure>>()?;
    print_report(
        common,
        || of_meshes(&train, &reports),
        || match &reports[..] {
            [only] => of_pair(Report::new(&only.title, ""), only),
            all => of_train(&train.title, all),
        },
        None,
    )
}

/// The answers first, then the geometry and the factors of all laws.
fn of_pair<'a>(report: Report<'a>, gears: &GearReport) -> Report<'a> {
    report
        .verdict([loss_factor(gears), contact_ratios(gears)])
        .verdict(transmission_error(gears))
        .table(laws(gears))
        .text(edge_contact(gears))
        .text(geometry(gears))
}

/// The loss factors of the meshes of a train, then the rest of each under its title.
fn of_train<'a>(title: &str, meshes: &[GearReport]) -> Report<'a> {
    let answer =
        |gears: &GearReport| format!("{}: {}", mesh_of(title, &gears.title), loss_factor(gears));
    let report = Report::new(title, "").verdict(meshes.iter().map(answer));
    meshes.iter().fold(report, |report, gears| {
        report
            .heading(&gears.title)
            .table(laws(gears))
            .text([contact_ratios(gears)])
            .text(transmission_error(gears))
            .text(edge_contact(gears))
            .text(geometry(gears))
    })
}

fn millimetres(length: Length) -> f64 {
    length.si().abs() * 1e3
}

fn loss_factor(report: &GearReport) -> String {
    let band = report.band.as_ref().map_or(String::new(), |band| {
        format!(", between {:.4} and {:.4}", band.whole.low, band.whole.high)
    });
    format!(
        "loss factor H_V {:.4} ({}){band}",
        report.loss_factor_local, report.law
    )
}

fn contact_ratios(report: &GearReport) -> String {
    let path = report.gears.path();
    format!(
        "contact ratios  eps_alpha {:.4}   eps_beta {:.4}   eps_gamma {:.4}",
        path.eps_alpha, path.eps_beta, path.eps_gamma
    )
}

fn transmission_error(report: &GearReport) -> Vec<String> {
    let Some(error) = &report.transmission_error else {
        return Vec::new();
    };
    let iso = report.iso_mesh_stiffness_n_per_mm_um;
    let iso = iso.map_or(String::new(), |iso| format!("   by ISO 6336-1 {iso:.2}"));
    vec![
        format!(
            "transmission error  mean {:.2} um   peak to peak {:.2} um",
            error.mean.si() * 1e6,
            error.peak_to_peak.si() * 1e6
        ),
        format!(
            "mesh stiffness c_gamma  {:.2} N/(mm um){iso}",
            error.mesh_stiffness * 1e-9
        ),
    ]
}

fn edge_contact(report: &GearReport) -> Option<String> {
    let note = report.edge_contact.as_ref()?;
    Some(format!(
        "Without tip relief the teeth approach by {:.1} µm; with contact of the tip edges H_V is {:.4}.",
        note.approach.si() * 1e6,
        note.with
    ))
}

fn geometry(report: &GearReport) -> [String; 4] {
    let gears = &report.gears;
    let path = gears.path();
    let [z1, z2] = gears.teeth;
    let sign = if gears.internal { "-" } else { "" };
    [
        format!(
            "teeth {z1}/{sign}{z2}   m_n {:.4} mm   helix {:.3} deg   face {:.3} mm   a {:.4} mm",
            millimetres(gears.normal_module),
            gears.helix.si().to_degrees(),
            millimetres(gears.face_width),
            millimetres(gears.centre_distance),
        ),
        format!(
            "working pressure angle {:.4} deg   tip diameters {:.4}, {:.4} mm",
            gears.working_pressure_angle.si().to_degrees(),
            2.0 * millimetres(gears.tip_radius[0]),
            2.0 * millimetres(gears.tip_radius[1]),
        ),
        format!(
            "path from T1 [mm]  A {:.4}   C {:.4}   E {:.4}",
            millimetres(path.a),
            millimetres(path.c),
            millimetres(path.e)
        ),
        format!(
            "torque {} N m   normal force {:.1} N   K_Hbeta {:.3}",
            (report.torque_nm * 1e3).round() / 1e3,
            report.normal_force_n,
            report.face_load_factor
        ),
    ]
}

fn laws(report: &GearReport) -> Table {
    let ohlendorf = ("Ohlendorf", Some(report.loss_factor_ohlendorf), None);
    let laws = report.loss_factors.iter();
    let laws = laws.map(|row| (row.law.as_str(), row.loss_factor, row.refused.as_deref()));
    let rows = std::iter::once(ohlendorf).chain(laws);
    columns! { (law, factor, refused) in rows;
        head law "law" "" = law;
        number factor "loss factor" "" "{:.4}" = factor;
        text refused "" "" = refused.unwrap_or("");
    }
}
