//! `asperity gear`: geometry, contact ratios, stiffness, transmission error, loss factors of every law.

use std::fmt::Write as _;

use asperity::case::LoadedCase;
use asperity::result::gear_report::{GearReport, gear_report};
use asperity_report::columns;

use super::{load_train, of_meshes};
use crate::args::{CaseArgs, Common};
use crate::failure::Failure;
use crate::output::print;

/// `asperity gear`
pub fn gear(args: &CaseArgs, common: &Common) -> Result<(), Failure> {
    let report = |loaded: &LoadedCase| {
        gear_report(&loaded.case).map_err(|error| Failure::about(&args.case, &error))
    };
    let train = load_train(&args.case, &args.set, args.formulation)?;
    let reports = train.cases().map(report);
    let reports = reports.collect::<Result<Vec<_>, Failure>>()?;
    print(
        common,
        || of_meshes(&train, &reports),
        || reports.iter().map(text).collect::<Vec<_>>().join("\n"),
    )
}

fn text(report: &GearReport) -> String {
    let mut text = format!("{}\n", asperity_storage::one_line(&report.title));
    // Writing into a string cannot fail.
    let _ = write_geometry(&mut text, report);
    let _ = write_mesh(&mut text, report);
    let _ = write_factors(&mut text, report);
    text
}

fn write_geometry(text: &mut String, report: &GearReport) -> std::fmt::Result {
    let gears = &report.gears;
    let path = gears.path();
    let [z1, z2] = gears.teeth;
    let sign = if gears.internal { "-" } else { "" };
    let mm = |length: asperity::quantity::Length| length.si().abs() * 1e3;
    writeln!(
        text,
        "teeth {z1}/{sign}{z2}   m_n {:.4} mm   helix {:.3} deg   face {:.3} mm   a {:.4} mm",
        mm(gears.normal_module),
        gears.helix.si().to_degrees(),
        mm(gears.face_width),
        mm(gears.centre_distance),
    )?;
    writeln!(
        text,
        "working pressure angle {:.4} deg   tip diameters {:.4}, {:.4} mm",
        gears.working_pressure_angle.si().to_degrees(),
        2.0 * mm(gears.tip_radius[0]),
        2.0 * mm(gears.tip_radius[1]),
    )?;
    writeln!(
        text,
        "contact ratios  eps_alpha {:.4}   eps_beta {:.4}   eps_gamma {:.4}",
        path.eps_alpha, path.eps_beta, path.eps_gamma
    )?;
    writeln!(
        text,
        "path from T1 [mm]  A {:.4}   C {:.4}   E {:.4}",
        mm(path.a),
        mm(path.c),
        mm(path.e)
    )
}

fn write_mesh(text: &mut String, report: &GearReport) -> std::fmt::Result {
    writeln!(
        text,
        "torque {} N m   normal force {:.1} N   K_Hbeta {:.3}",
        (report.torque_nm * 1e3).round() / 1e3,
        report.normal_force_n,
        report.face_load_factor
    )?;
    if let Some(error) = &report.transmission_error {
        writeln!(
            text,
            "transmission error  mean {:.2} um   peak to peak {:.2} um",
            error.mean.si() * 1e6,
            error.peak_to_peak.si() * 1e6
        )?;
        write!(
            text,
            "mesh stiffness c_gamma  {:.2} N/(mm um)",
            error.mesh_stiffness * 1e-9
        )?;
        if let Some(iso) = report.iso_mesh_stiffness_n_per_mm_um {
            write!(text, "   by ISO 6336-1 {iso:.2}")?;
        }
        writeln!(text)?;
    }
    Ok(())
}

fn write_factors(text: &mut String, report: &GearReport) -> std::fmt::Result {
    writeln!(
        text,
        "loss factor H_V  {:.4} ({})",
        report.loss_factor, report.law
    )?;
    if let Some(band) = &report.band {
        writeln!(text, "  band {:.4} to {:.4}", band.low, band.high)?;
    }
    if let Some(note) = &report.edge_contact {
        writeln!(
            text,
            "  tips are not relieved and the teeth approach by {:.1} um: {:.4} with tip edge contact",
            note.approach.si() * 1e6,
            note.with
        )?;
    }
    let ohlendorf = ("Ohlendorf", Some(report.ohlendorf), None);
    let laws = report.loss_factors.iter();
    let laws = laws.map(|row| (row.law.as_str(), row.loss_factor, row.refused.as_deref()));
    let rows = std::iter::once(ohlendorf).chain(laws);
    let table = columns! { (law, factor, refused) in rows;
        head law "law" "" = law;
        number factor "loss factor" "" "{:.4}" = factor;
        text refused "" "" = refused.unwrap_or("");
    };
    text.push_str(&table.text("  "));
    Ok(())
}
