//! Files that systems add to folders and archives.

/// Whether the last part of a path, or a folder in it, was added by a system: `__MACOSX`, `._name` and `.DS_Store` by macOS,
/// `Thumbs.db` and `desktop.ini` by Windows.
///
/// ```
/// use asperity_core::is_of_system;
/// assert!(is_of_system("__MACOSX/box/._box.rexs") && is_of_system("box\\Thumbs.db"));
/// assert!(!is_of_system("box/box.rexs"));
/// ```
#[must_use]
pub fn is_of_system(path: &str) -> bool {
    let is_added = |name: &str| {
        ["__macosx", ".ds_store", "thumbs.db", "desktop.ini"].contains(&name)
            || name.starts_with("._")
    };
    path.to_lowercase().split(['/', '\\']).any(is_added)
}
