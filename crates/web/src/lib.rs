//! The case run in a browser: files in memory and the text of a case in, the files of the result out.
//!
//! A page gives the same numbers as `asperity run`, since both call the same functions; [`bindings`] is what its
//! worker sees of them. Nothing here asks for a network, a file or a clock.

pub mod bindings;
mod failure;
mod files;
mod gearbox_file;
mod job;
mod library;
mod look;
mod pair;
mod versus;

pub use failure::Failure;
pub use files::Files;
pub use gearbox_file::{GearboxStage, gearbox_stage};
pub use job::{Finished, keys, run};
pub use library::library;
pub use look::{Look, Stated, look};
pub use pair::{Pair, pair};
pub use versus::{Versus, versus};

/// Registers the formulations that a case of the page can choose, before the first is read.
pub fn register() {
    asperity_paper_2022::register();
}
