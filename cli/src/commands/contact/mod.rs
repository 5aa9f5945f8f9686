//! `asperity contact`: only the rough contact of a case.

mod solved;
mod stress;

use std::path::Path;

use asperity::contacts::dry_contact::{DryContact, dry_contact};
use asperity_contact::problem::MAX_TOLERANCE;
use asperity_core::Code;
use asperity_core::quantity::Length;

use super::{load_case, on_the_path};
use crate::args::{Common, ContactArgs};
use crate::failure::Failure;
use crate::output::{besides_file, print_report};
use solved::SolvedContact;
use stress::{Stress, stress};

/// `asperity contact`
pub fn contact(args: &ContactArgs, common: &Common) -> Result<(), Failure> {
    check_tolerance(args.tolerance)?;
    let common = &match &args.output {
        Some(output) => besides_file(output, common)?,
        None => common.clone(),
    };
    let contact = of_case(&args.case, args)?;
    let stress = match &args.stress {
        Some(path) => Some(stress(&contact, args, path)?),
        None => None,
    };
    if let Some(output) = &args.output {
        contact.write_points(output)?;
    }
    let stress = stress.as_ref();
    print_report(
        common,
        || contact.json(stress.map(|stress| stress.json())),
        || contact.report(stress.map(Stress::lines).unwrap_or_default()),
        None,
    )
}

fn check_tolerance(tolerance: f64) -> Result<(), Failure> {
    if tolerance > MAX_TOLERANCE {
        return Err(Failure::new(
            Code::E211,
            format!("--tolerance {tolerance:e}: must be at most {MAX_TOLERANCE:e}"),
        )
        .advising("Pass --tolerance 1e-4 or less; 1e-8 is the default."));
    }
    if tolerance.is_nan() || tolerance <= 0.0 {
        return Err(Failure::new(
            Code::E209,
            format!("--tolerance {tolerance:e}: must be above 0 and at most {MAX_TOLERANCE:e}"),
        ));
    }
    Ok(())
}

fn of_case(path: &Path, args: &ContactArgs) -> Result<SolvedContact, Failure> {
    let loaded = load_case(path, &args.set, None)?;
    let loaded = loaded.overridden(|over| over.tolerance = Some(args.tolerance));
    let loaded = loaded.map_err(|error| Failure::about(path, &error))?;
    let position = on_the_path(&loaded, args.position)?.unwrap_or(loaded.case.paper.position);
    let DryContact {
        path_fraction,
        hertz,
        x,
        undeformed,
        solution,
        ..
    } = dry_contact(&loaded, position).map_err(|error| Failure::about(path, &error))?;
    Ok(SolvedContact {
        spacing: Length::from_si(x[1] - x[0]),
        title: format!("{} at {path_fraction:.4} of the path, dry", path.display()),
        x,
        undeformed,
        solution,
        hertz_pressure: hertz.max_pressure,
    })
}
