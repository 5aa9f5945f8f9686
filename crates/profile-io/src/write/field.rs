//! Text of a user within a field of a file.

/// Text that stays within one field: no control characters, line ends or quotes.
pub(super) fn field(text: &str) -> String {
    let kept = |c: &char| !c.is_control() && !matches!(c, '"' | '<' | '>' | '&');
    text.chars().filter(kept).collect()
}
