//! The known name that is most similar to another.

/// Jaro-Winkler similarity below which a suggestion confuses more than it helps.
const LIKE: f64 = 0.75;

/// The name of `known` most similar to `seen`, ignoring case; `None` if no name is similar.
///
/// ```
/// let known = ["18CrNiMo7-6", "42CrMo4"].map(str::to_owned);
/// assert_eq!(asperity_core::nearest_name("18crnimo", &known).as_deref(), Some("18CrNiMo7-6"));
/// assert_eq!(asperity_core::nearest_name("brass", &known), None);
/// ```
#[must_use]
pub fn nearest_name(seen: &str, known: &[String]) -> Option<String> {
    let lower: Vec<String> = known.iter().map(|name| name.to_lowercase()).collect();
    let similar = most_similar(&seen.to_lowercase(), lower.iter().map(String::as_str))?;
    let index = lower.iter().position(|name| *name == similar)?;
    known.get(index).cloned()
}

/// The name of `known` most similar to `seen`; `None` if no name is similar.
#[must_use]
pub fn most_similar<'a>(seen: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    known
        .map(|name| (strsim::jaro_winkler(seen, name), name))
        .filter(|(likeness, _)| *likeness >= LIKE)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, name)| name)
}

/// The end of a message about an unknown name, with the most similar known name.
#[must_use]
pub fn did_you_mean(nearest: Option<&str>) -> String {
    nearest
        .map(|key| format!(". Did you mean \"{key}\"?"))
        .unwrap_or_default()
}
