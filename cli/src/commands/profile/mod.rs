//! `asperity profile`: evaluation, conversion, filtering, generation and comparison of profiles.

mod case_lines;
mod change;
mod details;
mod evaluated;
mod file_facts;
mod info;
mod json;
mod levels;
mod like_surface;
mod like_trace;
mod plan;
mod plot;
mod surface_facts;
mod text;
mod transform;

use super::study;
use crate::args::{Common, ProfileCommand};
use crate::failure::Failure;

/// Runs one of the subcommands.
pub fn run(command: &ProfileCommand, common: &Common) -> Result<(), Failure> {
    match command {
        ProfileCommand::Info(args) => info::info(args, common),
        ProfileCommand::Compare(args) => info::compare(args, common),
        ProfileCommand::Plot(args) => plot::plot(args, common),
        ProfileCommand::Convert(args) => transform::convert(args, common),
        ProfileCommand::Filter(args) => transform::filter(args, common),
        ProfileCommand::Generate(args) => transform::generate(args, common),
        ProfileCommand::Study(command) => study::study(command, common),
    }
}
