//! Neutralising text from names and titles before a spreadsheet or a terminal shows it.

use std::borrow::Cow;

/// `text` as a cell of a spreadsheet: an apostrophe precedes text that would be a formula.
///
/// ```
/// use asperity_storage::cell;
/// assert_eq!(cell("=1+1"), "'=1+1");
/// assert_eq!(cell("ground"), "ground");
/// ```
pub fn cell(text: &str) -> Cow<'_, str> {
    match text.starts_with(['=', '+', '-', '@', '\t', '\r']) {
        true => Cow::Owned(format!("'{text}")),
        false => Cow::Borrowed(text),
    }
}

/// `text` for a terminal: control characters except line feeds and tabs, and those that change the direction of
/// writing, are escaped.
///
/// ```
/// assert_eq!(asperity_storage::printable("a\u{1b}[31mb\n"), "a\\u{1b}[31mb\n");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    escaped(text, |c| is_control(c) && c != '\n' && c != '\t')
}

/// A title or a name for a terminal: as [`printable`], with line feeds and tabs escaped too, so that it stays on one
/// line.
///
/// ```
/// assert_eq!(asperity_storage::one_line("a\nE501 b"), "a\\u{a}E501 b");
/// ```
pub fn one_line(text: &str) -> Cow<'_, str> {
    escaped(text, is_control)
}

/// Whether a character is a control character or changes the direction of writing.
fn is_control(c: char) -> bool {
    let changes_direction = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || changes_direction
}

/// `text` with the characters for which `is_bad` holds escaped.
fn escaped(text: &str, is_bad: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_bad) {
        return Cow::Borrowed(text);
    }
    let written = text.chars().map(|c| match is_bad(c) {
        true => c.escape_unicode().to_string(),
        false => c.to_string(),
    });
    Cow::Owned(written.collect())
}
