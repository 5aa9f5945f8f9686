//! Text from names and titles that must do nothing where it is shown.

use std::borrow::Cow;

/// `text` as a cell of a table that a spreadsheet opens: one that starts as a formula gets an apostrophe.
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

/// `text` as a terminal shows it: control characters but line feeds and tabs are written out, and so are
/// those that turn the direction of writing.
///
/// ```
/// assert_eq!(asperity_storage::printable("a\u{1b}[31mb\n"), "a\\u{1b}[31mb\n");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    without(text, |c| acts(c) && c != '\n' && c != '\t')
}

/// A title or a name as a terminal shows it: the same with line feeds and tabs written out, so that it cannot begin a line
/// of its own.
///
/// ```
/// assert_eq!(asperity_storage::one_line("a\nE501 b"), "a\\u{a}E501 b");
/// ```
pub fn one_line(text: &str) -> Cow<'_, str> {
    without(text, acts)
}

/// Whether a character does something instead of being shown.
fn acts(c: char) -> bool {
    let turns = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    c.is_control() || turns
}

/// `text` with such characters written out.
fn without(text: &str, is_bad: impl Fn(char) -> bool) -> Cow<'_, str> {
    if !text.contains(&is_bad) {
        return Cow::Borrowed(text);
    }
    let written = text.chars().map(|c| match is_bad(c) {
        true => c.escape_unicode().to_string(),
        false => c.to_string(),
    });
    Cow::Owned(written.collect())
}
