//! `asperity figures`: the figures of the 2022 paper.

use asperity_studies::figures::{self, FigureError};

use super::load_case;
use crate::args::{Common, FiguresArgs, FormulationArg};
use crate::failure::Failure;
use crate::output::{print_json, print_text};

/// `asperity figures`
pub fn figures(args: &FiguresArgs, common: &Common) -> Result<(), Failure> {
    let case = load_case(&args.case, Some(FormulationArg::Paper))?;
    let files = figures::write(&case, &args.output).map_err(|error| refused(&error))?;
    if common.json {
        return print_json(&files);
    }
    let list: String = files
        .iter()
        .map(|file| format!("{}\n", file.display()))
        .collect();
    print_text(common, &list)
}

fn refused(error: &FigureError) -> Failure {
    match error {
        FigureError::Run(error) => Failure::of(error),
        _ => Failure::new("E401", error.to_string()),
    }
}
