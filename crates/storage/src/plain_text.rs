//! Neutralising text from names and titles before a spreadsheet or a terminal shows it.

use std::borrow::Cow;

/// `text` as a cell of a spreadsheet: an apostrophe precedes text that would be a formula. A number stays as it is.
///
/// ```
/// use asperity_storage::cell;
/// assert_eq!(cell("=1+1"), "'=1+1");
/// assert_eq!(cell("-5 nm"), "'-5 nm");
/// assert_eq!(cell("-5"), "-5");
/// assert_eq!(cell("ground"), "ground");
/// ```
pub fn cell(text: &str) -> Cow<'_, str> {
    if has_mark(text) {
        Cow::Owned(format!("{MARK}{text}"))
    } else {
        Cow::Borrowed(text)
    }
}

/// The text of which [`cell`] made `cell`.
///
/// ```
/// use asperity_storage::{cell, text_of_cell};
/// for text in ["=1+1", "'=1+1", "'", "'ground'", "-5", "ground"] {
///     assert_eq!(text_of_cell(&cell(text)), text);
/// }
/// ```
pub fn text_of_cell(cell: &str) -> &str {
    let text = cell.strip_prefix(MARK);
    text.filter(|text| has_mark(text)).unwrap_or(cell)
}

/// A line of text above a table, which a spreadsheet splits into cells as it does the rows of the table.
///
/// ```
/// assert_eq!(asperity_storage::line_of_cells("# title = a,=1+1; b"), "# title = a,'=1+1; b");
/// ```
pub fn line_of_cells(line: &str) -> String {
    let cells = line.split_inclusive([',', ';', '\t']);
    cells.map(cell).collect()
}

/// Character before the text of a cell that would be a formula.
const MARK: char = '\'';

/// Whether [`cell`] marks `text`: text that would be a formula without its leading marks, so that a mark can be removed.
fn has_mark(text: &str) -> bool {
    let is_number = |text: &str| text.parse().is_ok_and(f64::is_finite);
    let unmarked = text.trim_start_matches(MARK);
    unmarked.starts_with(['=', '+', '-', '@', '\t', '\r']) && !is_number(unmarked)
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
    let written = text.chars().map(|c| {
        if is_bad(c) {
            c.escape_unicode().to_string()
        } else {
            c.to_string()
        }
    });
    Cow::Owned(written.collect())
}
