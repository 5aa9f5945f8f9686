//! Items without repetitions.

/// The distinct items in the order of their first occurrence.
///
/// ```
/// assert_eq!(asperity_core::unique(["b", "a", "b"]), ["b", "a"]);
/// ```
pub fn unique<T: PartialEq>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut met = Vec::new();
    for item in items {
        if !met.contains(&item) {
            met.push(item);
        }
    }
    met
}
