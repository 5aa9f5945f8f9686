//! `asperity list`: the oils, steels and gears of the library.

mod gears;
mod oils;
mod presets;
mod steels;

use crate::args::{Common, ListArgs, ListKind};
use crate::failure::Failure;

/// `asperity list`
pub fn list(args: &ListArgs, common: &Common) -> Result<(), Failure> {
    let name = args.name.as_deref();
    match args.kind {
        ListKind::Oils => oils::oils(name, common),
        ListKind::Steels => steels::steels(name, common),
        ListKind::Gears => gears::gears(name, common),
    }
}
