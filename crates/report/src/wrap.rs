//! Line breaks of text for a terminal.

/// Largest width of text.
pub const COLUMNS: usize = 80;

/// Breaks `text` into lines of at most [`COLUMNS`]; the lines after the first begin with `indent`. A longer word is not
/// broken. Spaces at the start and between words are preserved.
///
/// ```
/// let text = format!("W112 {}", "word ".repeat(20));
/// let lines = asperity_report::wrapped(text.trim(), "  ");
/// assert!(lines.lines().all(|line| line.len() <= 80) && lines.lines().nth(1).unwrap().starts_with("  w"));
/// ```
pub fn wrapped(text: &str, indent: &str) -> String {
    wrapped_within(text, indent, COLUMNS)
}

/// Breaks `text` as [`wrapped`] into lines of at most `columns`.
pub fn wrapped_within(text: &str, indent: &str, columns: usize) -> String {
    let (mut lines, mut width) = (String::new(), 0);
    let mut is_first = true;
    for word in text.split_inclusive(' ') {
        let length = word.trim_end().chars().count();
        if width + length > columns && !is_first && length > 0 {
            lines.truncate(lines.trim_end().len());
            lines.push('\n');
            lines.push_str(indent);
            width = indent.chars().count();
        }
        // The line is not broken at spaces before the first word.
        is_first &= length == 0;
        lines.push_str(word);
        width += word.chars().count();
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_fits_stays_as_it_is() {
        assert_eq!(wrapped("  a  b", "    "), "  a  b");
        assert_eq!(wrapped("", "  "), "");
    }

    #[test]
    fn a_word_too_long_for_a_line_stands_alone() {
        let long = "x".repeat(100);
        assert_eq!(
            wrapped(&format!("W1 {long} y"), "  "),
            format!("W1\n  {long}\n  y")
        );
        assert_eq!(wrapped(&format!("  {long}"), "  "), format!("  {long}"));
    }

    #[test]
    fn eighty_characters_fit_whatever_their_bytes() {
        let text = format!("{} {}", "µ".repeat(39), "Λ".repeat(40));
        assert_eq!(wrapped(&text, ""), text);
        assert_eq!(wrapped(&format!("{text}µ"), "").lines().count(), 2);
    }
}
