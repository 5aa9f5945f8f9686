//! The array of heights among the arrays of a file.

use crate::read::error::{ReadFault, shortened};
use crate::read::format::Format;
use crate::read::header::is_depth;

/// Names of the array of heights among several arrays, in addition to those of depths.
const NAMES: [&str; 4] = ["z", "heights", "height", "profile"];

/// The only array, or of several the one with the name of heights, in whichever group it is.
pub(super) fn chosen<T>(
    format: Format,
    mut all: Vec<(String, T)>,
) -> Result<(String, T), ReadFault> {
    let is_named = |(name, _): &(String, T)| {
        let name = name.rsplit('/').next().unwrap_or_default().to_lowercase();
        NAMES.contains(&name.as_str()) || is_depth(&name)
    };
    let at = match all.len() {
        0 => {
            return Err(ReadFault::no_heights(format, "no array of real numbers"));
        }
        1 => 0,
        _ => all.iter().position(is_named).ok_or_else(|| {
            let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
            ReadFault::several_arrays(&shortened(&names.join(", ")))
        })?,
    };
    Ok(all.swap_remove(at))
}
