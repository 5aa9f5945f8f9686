//! Contacts without a case: a gap file, or two profiles.

use std::path::Path;

use asperity_contact::running_in::{Cycle, RunningIn};
use asperity_contact::two_flanks::TwoFlanks;
use asperity_contact::{
    Boundary, ContactError, ContactProblem, Control, PeriodicKernel, SolverSettings, solve,
};
use asperity_core::message::Warning;
use asperity_core::profile::common_spacing;
use asperity_core::{Code, Fault};

use super::column_file::{self, Columns};
use super::solved::SolvedContact;
use crate::args::{ContactArgs, KernelArg};
use crate::failure::Failure;

/// Solves the contact over a gap file.
pub fn of_gap(path: &Path, args: &ContactArgs) -> Result<SolvedContact, Failure> {
    let file = column_file::read(path, column_file::GAP)?;
    let prescribed = match &args.prescribed {
        Some(pressure) => Some(prescribed(pressure, &file)?),
        None => None,
    };
    let (prescribed, of_pressure) = prescribed.unzip();
    let window = file.spacing * file.values.len() as f64;
    let problem = ContactProblem {
        gap: &file.values,
        spacing: file.spacing,
        lead: None,
        modulus: args.e_star.ok_or_else(|| missing("--gap", "--e-star"))?,
        boundary: boundary(args),
        control: match (args.load, args.approach) {
            (Some(load), _) => Control::Load(load),
            (None, Some(approach)) => Control::Approach {
                approach,
                datum: args.datum.unwrap_or(window * 2.0),
            },
            (None, None) => return Err(missing("--gap", "--load or --approach")),
        },
        prescribed_pressure: prescribed.as_deref(),
        pressure_limit: args.pressure_limit,
        start: None,
    };
    let solution = solve(&problem, &settings(args)).map_err(|error| refused(path, error))?;
    Ok(SolvedContact {
        title: path.display().to_string(),
        spacing: file.spacing,
        x: file.x,
        undeformed: file.values,
        solution,
        hertz_pressure: None,
        cycles: vec![],
        unread: file
            .unread
            .into_iter()
            .chain(of_pressure.flatten())
            .collect(),
    })
}

/// Solves the contact of two profiles, on request after running-in.
pub fn of_flanks(
    paths: &[std::path::PathBuf],
    args: &ContactArgs,
) -> Result<SolvedContact, Failure> {
    let [first_path, second_path] = paths else {
        return Err(missing("--flanks", "two files"));
    };
    let [(first, of_first), (second, of_second)] = [
        column_file::profile(first_path)?,
        column_file::profile(second_path)?,
    ];
    let flanks = TwoFlanks {
        first: &first,
        second: &second,
        radius: args.radius.ok_or_else(|| missing("--flanks", "--radius"))?,
        load: args.load.ok_or_else(|| missing("--flanks", "--load"))?,
        modulus: args.e_star.ok_or_else(|| missing("--flanks", "--e-star"))?,
        pressure_limit: args.pressure_limit,
    };
    let about = |error: ContactError| refused(second_path, error);
    let (cycles, worn) = match args.running_in {
        Some(passes) => {
            let plan = RunningIn {
                shares: [args.first_share, 1.0 - args.first_share],
                ..RunningIn::evenly(first.len(), passes).map_err(|error| about(error.into()))?
            };
            let ran_in = plan.run(&flanks, &settings(args)).map_err(about)?;
            (ran_in.cycles, Some(ran_in.flanks))
        }
        None => (Vec::<Cycle>::new(), None),
    };
    let last = match &worn {
        Some([first, second]) => TwoFlanks {
            first,
            second,
            ..flanks
        },
        None => flanks,
    };
    let spacing = last.spacing().map_err(about)?;
    let undeformed = last.gap().map_err(about)?;
    let solution = last.press(&settings(args)).map_err(about)?;
    let middle = 0.5 * (undeformed.len() - 1) as f64;
    let x = (0..undeformed.len()).map(|i| (i as f64 - middle) * spacing.si());
    Ok(SolvedContact {
        title: format!("{} on {}", first_path.display(), second_path.display()),
        spacing,
        x: x.collect(),
        undeformed,
        solution,
        hertz_pressure: None,
        cycles,
        unread: of_first.into_iter().chain(of_second).collect(),
    })
}

/// The prescribed pressure in the file at `path`, and the warning of columns that were not read.
fn prescribed(path: &Path, gap: &Columns) -> Result<(Vec<f64>, Option<Warning>), Failure> {
    let file = column_file::read(path, column_file::PRESSURE)?;
    if common_spacing(file.spacing, gap.spacing).is_none() {
        return Err(Failure::new(
            Code::E209,
            format!(
                "{}: points {:.6} apart, those of the gap {:.6}; give the pressure at the points of the gap",
                path.display(),
                file.spacing,
                gap.spacing
            ),
        ));
    }
    Ok((file.values, file.unread))
}

fn boundary(args: &ContactArgs) -> Boundary {
    match (args.kernel, args.periodic) {
        (Some(KernelArg::Spectral), _) => Boundary::Periodic(PeriodicKernel::Spectral),
        (Some(KernelArg::Periodised), _) | (None, true) => {
            Boundary::Periodic(PeriodicKernel::Strip)
        }
        (Some(KernelArg::Strip) | None, _) => Boundary::FreeEnds,
    }
}

fn settings(args: &ContactArgs) -> SolverSettings {
    SolverSettings {
        tolerance: args.tolerance,
        ..SolverSettings::default()
    }
}

fn missing(option: &str, needed: &str) -> Failure {
    Failure::new(Code::E205, format!("{option} needs {needed}"))
}

/// The error of a contact in the file at `path`.
fn refused(path: &Path, error: ContactError) -> Fault {
    Fault::from(error).about(path.display())
}
