//! User-defined text in a field of a file.

/// `text` without the characters that could end a field: control characters, line ends and quotes.
pub(super) fn field(text: &str) -> String {
    let is_safe = |c: &char| !c.is_control() && !matches!(c, '"' | '<' | '>' | '&');
    text.chars().filter(is_safe).collect()
}
