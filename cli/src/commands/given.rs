//! Subjects of studies, read from the arguments of a command.

use std::path::PathBuf;

use asperity::case::{LoadedCase, Train};
use asperity::pipeline::KeptFields;
use asperity_report::Work;
use clap::Args;

use super::work::check_work;
use super::{load_case, load_train, result_name};
use crate::args::{Given, SetArgs, Subject, WorkArgs};
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
        check_work(limits, &work.meshes, &KeptFields::Highest, work.runs)
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
