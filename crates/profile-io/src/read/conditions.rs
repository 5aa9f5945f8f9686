//! Files of measuring conditions.

use std::path::{Path, PathBuf};

/// Name of the file of measuring conditions (Surfcom `.tx3`) of the profile `path`, if its format has one.
///
/// ```
/// use asperity_profile_io::read::conditions_of;
/// assert_eq!(conditions_of("flank.tx1".as_ref()), Some("flank.tx3".into()));
/// assert_eq!(conditions_of("flank.csv".as_ref()), None);
/// ```
pub fn conditions_of(path: &Path) -> Option<PathBuf> {
    let ending = match path.extension()?.to_str()? {
        "tx1" | "tx2" => "tx3",
        "TX1" | "TX2" => "TX3",
        _ => return None,
    };
    Some(path.with_extension(ending))
}
