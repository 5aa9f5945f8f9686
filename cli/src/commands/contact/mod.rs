//! `asperity contact`: the rough contact alone, of a case or of a bare gap file.

mod gap_file;

use std::path::Path;

use asperity::dry_contact::{DryContact, dry_contact};
use asperity_contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, Control, PeriodicKernel,
    SolverSettings, solve,
};
use serde_json::{Value, json};

use super::{load_case, on_the_path};
use crate::args::{Common, ContactArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// Largest tolerance, as for `model.tolerance` of a case.
const LOOSEST: f64 = 1e-2;

/// `asperity contact`
pub fn contact(args: &ContactArgs, common: &Common) -> Result<(), Failure> {
    // Any answer would pass for converged at a tolerance near 1.
    if !(args.tolerance > 0.0 && args.tolerance <= LOOSEST) {
        return Err(Failure::new(
            "E209",
            format!(
                "--tolerance {:e}: must be above 0 and at most {LOOSEST}",
                args.tolerance
            ),
        ));
    }
    let found = match (&args.gap, &args.case) {
        (Some(gap), _) => of_gap(gap, args)?,
        (None, Some(case)) => of_case(case, args)?,
        (None, None) => {
            return Err(Failure::new(
                "E205",
                "name a case file, or a gap file with --gap",
            ));
        }
    };
    if let Some(output) = &args.output {
        write_points(&found, output)?;
    }
    if common.json {
        return print_json(&as_json(&found));
    }
    print_text(common, &as_text(&found))
}

/// A solved contact and what it is compared with.
struct Found {
    title: String,
    x: Vec<f64>,
    undeformed: Vec<f64>,
    solution: ContactSolution,
    hertz_pressure: Option<f64>,
}

fn of_gap(path: &Path, args: &ContactArgs) -> Result<Found, Failure> {
    let file = gap_file::read(path)?;
    let missing = |option: &str| Failure::new("E205", format!("--gap needs {option}"));
    let problem = ContactProblem {
        gap: &file.gap,
        spacing: file.spacing,
        modulus: args.e_star.ok_or_else(|| missing("--e-star"))?,
        boundary: if args.periodic {
            Boundary::Periodic(PeriodicKernel::Strip)
        } else {
            Boundary::FreeEnds
        },
        control: Control::Load(args.load.ok_or_else(|| missing("--load"))?),
        prescribed_pressure: None,
        pressure_limit: args.pressure_limit,
        start: None,
    };
    let settings = SolverSettings {
        tolerance: args.tolerance,
        ..SolverSettings::default()
    };
    let solution = solve(&problem, &settings)
        .map_err(|error| Failure::new(code(&error), format!("{}: {error}", path.display())))?;
    Ok(Found {
        title: path.display().to_string(),
        x: file.x,
        undeformed: file.gap,
        solution,
        hertz_pressure: None,
    })
}

fn of_case(path: &Path, args: &ContactArgs) -> Result<Found, Failure> {
    let mut loaded = load_case(path, None)?;
    loaded.case.model.tolerance = args.tolerance;
    let place = on_the_path(&loaded, args.position)?.unwrap_or(loaded.case.model.position);
    let DryContact {
        path_fraction,
        hertz,
        x,
        undeformed,
        solution,
        ..
    } = dry_contact(&loaded, place).map_err(|error| Failure::about(path, &error))?;
    Ok(Found {
        title: format!("{} at {path_fraction:.4} of the path, dry", path.display()),
        x,
        undeformed,
        solution,
        hertz_pressure: Some(hertz.max_pressure.si()),
    })
}

fn code(error: &ContactError) -> &'static str {
    match error {
        ContactError::NotConverged { .. } => "E301",
        ContactError::LimitBelowMeanPressure { .. } => "E302",
        _ => "E209",
    }
}

fn as_json(found: &Found) -> Value {
    let s = &found.solution;
    json!({
        "title": found.title,
        "points": s.pressure.len(),
        "load_n_per_m": s.load.si(),
        "approach_m": s.approach.si(),
        "approach_datum_m": s.datum.si(),
        "contact_fraction": s.contact_fraction,
        "p_max_pa": s.max_pressure.si(),
        "hertz_p_max_pa": found.hertz_pressure,
        "plastic_energy_j_per_m": s.dissipated.si(),
        "iterations": s.iterations,
        "residual": {
            "duality_gap": s.certificate.duality_gap,
            "penetration": s.certificate.penetration,
            "load_error": s.certificate.load_error,
            "reference_gap_m": s.certificate.reference_gap.si(),
        },
    })
}

fn as_text(found: &Found) -> String {
    let s = &found.solution;
    let hertz = found
        .hertz_pressure
        .map(|p| format!(" (Hertz {:.1} MPa)", p * 1e-6))
        .unwrap_or_default();
    format!(
        "{}\n  load {:.6}   approach {:.7} (datum {:.6})\n  contact fraction {:.6}   p_max {:.7}{hertz}\n  \
         plastic work {:.4e} J/m\n  {} iterations; duality gap {:.1e}, penetration {:.1e}, load error {:.1e}\n",
        found.title,
        s.load,
        s.approach,
        s.datum,
        s.contact_fraction,
        s.max_pressure,
        s.dissipated.si(),
        s.iterations,
        s.certificate.duality_gap,
        s.certificate.penetration,
        s.certificate.load_error,
    )
}

/// x, undeformed gap, pressure, gap, displacement per point; every number reads back exactly.
fn write_points(found: &Found, path: &Path) -> Result<(), Failure> {
    let refused = |error: &dyn std::fmt::Display| {
        Failure::new(
            "E401",
            format!("{}: cannot be written: {error}", path.display()),
        )
    };
    let s = &found.solution;
    let mut text =
        String::from("x_m,h_m,pressure_pa,gap_m,displacement_m,plastic_displacement_m\n");
    for i in 0..found.x.len() {
        text.push_str(&format!(
            "{:e},{:e},{:e},{:e},{:e},{:e}\n",
            found.x[i],
            found.undeformed[i],
            s.pressure[i],
            s.gap[i],
            s.displacement[i],
            s.plastic_displacement[i],
        ));
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    std::fs::create_dir_all(folder).map_err(|error| refused(&error))?;
    asperity_report::save(path, text.as_bytes()).map_err(|error| refused(&error))
}
