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
    let is_bad = |c: char| {
        let turns = matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        (c.is_control() && c != '\n' && c != '\t') || turns
    };
    if !text.contains(is_bad) {
        return Cow::Borrowed(text);
    }
    let written = text.chars().map(|c| match is_bad(c) {
        true => c.escape_unicode().to_string(),
        false => c.to_string(),
    });
    Cow::Owned(written.collect())
}
