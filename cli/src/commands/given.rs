//! Subjects of studies, read from the arguments of a command.

use std::path::{Path, PathBuf};

use asperity::case::{LoadedCase, Train};
use asperity::pipeline::Kept;
use asperity::profile_io::read::read_table;
use asperity_calibration::RigFiles;
use asperity_core::Code;
use asperity_report::Work;
use asperity_studies::compare::{Finish, Finishes};
use asperity_studies::cycle::{CycleOnMap, LARGEST_TABLE};
use asperity_studies::map::{self, CaseOrFinishes};
use clap::Args;

use super::finish::finishes;
use super::work::check_work;
use super::{keys, load_case, load_train, result_name, stem};
use crate::args::{FinishArg, Given, NoLimits, SetArgs, Subject, WorkArgs};
use crate::failure::Failure;

/// A case.
#[derive(Debug, Args)]
pub struct GivenCase {
    /// Case file; - reads standard input
    case: PathBuf,
}

impl GivenCase {
    fn subject<I>(&self, input: I) -> Subject<I> {
        Subject {
            input,
            name: result_name(&self.case),
            file: Some(self.case.clone()),
        }
    }
}

const OF_CASE: &str = "<name of the case>";

impl Given for Train {
    type Args = GivenCase;
    type Limits = WorkArgs;
    const NAMED_BY: &'static str = OF_CASE;

    fn read(args: &GivenCase, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        Ok(args.subject(load_train(&args.case, set, None)?))
    }

    fn check(limits: &WorkArgs, work: &Work) -> Result<(), Failure> {
        check_work(limits, &work.meshes, &Kept::Highest, work.runs)
    }
}

impl Given for LoadedCase {
    type Args = GivenCase;
    type Limits = WorkArgs;
    const NAMED_BY: &'static str = OF_CASE;

    fn read(args: &GivenCase, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        Ok(args.subject(load_case(&args.case, set, None)?))
    }

    fn check(limits: &WorkArgs, work: &Work) -> Result<(), Failure> {
        Train::check(limits, work)
    }
}

/// Variants of a case.
#[derive(Debug, Args)]
pub struct VariantArgs {
    /// The case with other values of its keys, or of the keys in a file; another case as NAME=CASE.toml; the case itself as
    /// "as is", with which a single variant is compared. Variants follow the finishes
    #[arg(
        id = "variants",
        long = "variant",
        value_name = "NAME: KEY=VALUE,... or NAME=CASE.toml",
        value_hint = clap::ValueHint::AnyPath,
        allow_hyphen_values = true
    )]
    texts: Vec<String>,
}

/// A case and its variants.
#[derive(Debug, Args)]
pub struct GivenFinishes {
    /// Case file, whose traces are replaced by the traces of each finish; - reads standard input
    case: PathBuf,
    /// A finish and its traces, in a gear train of all meshes or of one; give at least two. A single file serves both
    /// flanks, mirrored for the wheel
    #[arg(
        long = "finish",
        required_unless_present = "variants",
        value_name = "NAME[@MESH]=PINION.csv[,WHEEL.csv]"
    )]
    finishes: Vec<FinishArg>,
    #[command(flatten)]
    variants: VariantArgs,
}

impl Given for Finishes {
    type Args = GivenFinishes;
    type Limits = WorkArgs;
    const NAMED_BY: &'static str = OF_CASE;

    fn read(args: &GivenFinishes, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        if args.variants.texts.is_empty() {
            Self::check_count(args.finishes.len())?;
        }
        Ok(Subject {
            input: Self(finishes(
                &args.case,
                set,
                &args.finishes,
                &args.variants.texts,
            )?),
            name: result_name(&args.case),
            file: Some(args.case.clone()),
        })
    }

    fn check(limits: &WorkArgs, work: &Work) -> Result<(), Failure> {
        Train::check(limits, work)
    }
}

/// A case, and finishes instead of its own traces.
#[derive(Debug, Args)]
pub struct GivenCaseOrFinishes {
    /// Case file; - reads standard input
    case: PathBuf,
    /// A finish and its traces, in a gear train of all meshes or of one; give several to see their difference
    /// [default: the flanks of the case]
    #[arg(long = "finish", value_name = "NAME[@MESH]=PINION.csv[,WHEEL.csv]")]
    finishes: Vec<FinishArg>,
    #[command(flatten)]
    variants: VariantArgs,
}

impl Given for CaseOrFinishes {
    type Args = GivenCaseOrFinishes;
    type Limits = WorkArgs;
    const NAMED_BY: &'static str = OF_CASE;

    fn read(args: &GivenCaseOrFinishes, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        let file = &args.case;
        let given = if args.finishes.is_empty() && args.variants.texts.is_empty() {
            vec![Finish {
                name: stem(file).to_string_lossy().into_owned(),
                case: load_train(file, set, None)?,
            }]
        } else {
            finishes(file, set, &args.finishes, &args.variants.texts)?
        };
        Ok(Subject {
            input: Self(Finishes(given)),
            name: result_name(file),
            file: Some(file.clone()),
        })
    }

    fn check(limits: &WorkArgs, work: &Work) -> Result<(), Failure> {
        Train::check(limits, work)
    }
}

/// A map and a cycle.
#[derive(Debug, Args)]
pub struct GivenCycle {
    /// Folder of a map
    map: PathBuf,
    /// Cycle: CSV with time_s and torque_nm, speed_rpm at the pinion, or speed_km_h (and grade_percent) with
    /// [vehicle] in the case of the map
    trace: PathBuf,
}

impl Given for CycleOnMap {
    type Args = GivenCycle;
    type Limits = NoLimits;
    const NAMED_BY: &'static str = "<name of the map>-<name of the cycle>";

    fn read(args: &GivenCycle, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        if set.mesh.is_some() {
            let message = "--mesh takes a mesh of a case; a map has the sum of all";
            return Err(Failure::new(Code::E205, message));
        }
        let advice = "Name the folder that asperity map wrote, e.g. results/case-map.";
        let mut map = map::read(&args.map).map_err(|error| error.helping(advice))?;
        for (key, value) in keys(set) {
            let set = map.input.set(&key, &value);
            set.map_err(|error| Failure::from_error(&error))?;
        }
        let [of_map, name] = [&args.map, &args.trace].map(|path| {
            let stem = path.file_stem().unwrap_or_default();
            stem.to_string_lossy().into_owned()
        });
        Ok(Subject {
            name: format!("{of_map}-{name}").into(),
            file: Some(args.trace.clone()),
            input: Self {
                map: map.into(),
                text: read_table(&args.trace, LARGEST_TABLE)?,
                name,
            },
        })
    }
}

/// The table of a rig, and a case.
#[derive(Debug, Args)]
pub struct GivenRig {
    /// Rig table
    #[arg(value_name = "RIG.csv")]
    rig: PathBuf,
    /// Case of the rows without a case
    #[arg(value_name = "CASE.toml")]
    case: Option<PathBuf>,
}

impl Given for RigFiles {
    type Args = GivenRig;
    type Limits = NoLimits;
    const NAMED_BY: &'static str = "<name of the table>";

    fn read(args: &GivenRig, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        let load = |path: &Path| load_case(path, set, None);
        Ok(Subject {
            input: Self::read(&args.rig, args.case.as_deref(), load)?,
            name: result_name(&args.rig),
            file: None,
        })
    }
}
