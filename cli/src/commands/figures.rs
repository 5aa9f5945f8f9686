//! `asperity figures`: the figures of the 2022 paper.

use asperity::case::{self, LoadedCase};
use asperity_core::Fault;
use asperity_paper_2022::{figures, register};

use super::{keys, load_case};
use crate::args::{Common, FiguresArgs, SetArgs};
use crate::failure::Failure;
use crate::output::print;

/// `asperity figures`
pub fn figures(args: &FiguresArgs, common: &Common) -> Result<(), Failure> {
    let case = match &args.case {
        Some(case) => load_case(case, &args.set, Some(register()))?,
        None => table_2(&args.set)?,
    };
    let files = figures::write(&case, &args.output)?;
    let list = || files.iter().map(|file| format!("{}\n", file.display()));
    print(common, || &files, || list().collect())
}

/// Table 2 of the paper on the synthetic flank of the program.
fn table_2(set: &SetArgs) -> Result<LoadedCase, Failure> {
    let (case, flank) = asperity_fixtures::demo::table_2()
        .map_err(|error| Fault::internal(error).about("the case cannot be made"))?;
    let flank = &flank.content;
    let mut loaded = case::from_text(case.name, &case.content, &|_| Ok(flank.clone().into()))
        .map_err(|error| Failure::from_error(&error))?;
    for (key, value) in keys(set) {
        let changed = loaded.with_key(&key, &value);
        loaded = changed.map_err(|error| Failure::from_error(&error))?;
    }
    loaded
        .with(|input| input.formulation = Some(register()))
        .map_err(|error| Failure::from_error(&error))
}
