//! Tables of numbers and texts, described once for the page and for the terminal.
//!
//! A table is a list of columns; [`columns!`](crate::columns) makes one from rows with one line for each column: its heading, unit,
//! digits and value. [`Table::text`] prints it with aligned columns, and on a page it is written into the markup by `(table)`.

use std::borrow::Cow;

use asperity_storage::one_line;
use maud::{Markup, Render, html};

use crate::wrap::{COLUMNS, wrapped_within};

/// A cell of a table.
#[derive(Debug, Clone, Default)]
pub struct Cell {
    /// Its text in the terminal.
    text: String,
    /// Its markup on a page; `None` for the text.
    markup: Option<Markup>,
}

impl Cell {
    /// A number by `format`, or "-" if there is none.
    pub fn number(value: impl Number, format: impl Fn(f64) -> String) -> Self {
        value.number().map_or("-".to_owned(), format).into()
    }

    /// The text of `value`, or "-" if there is none.
    pub fn optional(value: Option<impl ToString>) -> Self {
        value.map_or_else(|| "-".into(), Self::from)
    }

    /// `text`, on a page with `markup`.
    pub fn marked(text: impl Into<String>, markup: Markup) -> Self {
        Self {
            text: text.into(),
            markup: Some(markup),
        }
    }

    /// `text` as code.
    pub fn code(text: impl Into<String>) -> Self {
        let text = text.into();
        let markup = html! { code { (text) } };
        Self::marked(text, markup)
    }

    /// Its text in the terminal, on one line.
    fn line(&self) -> Cow<'_, str> {
        one_line(&self.text)
    }

    fn width(&self) -> usize {
        length(&self.line())
    }
}

impl<T: ToString> From<T> for Cell {
    fn from(text: T) -> Self {
        Self {
            text: text.to_string(),
            markup: None,
        }
    }
}

impl Render for Cell {
    fn render(&self) -> Markup {
        match &self.markup {
            Some(markup) => markup.clone(),
            None => html! { (self.text) },
        }
    }
}

/// A number that may be missing.
pub trait Number {
    /// The number; `None` if it is missing.
    fn number(self) -> Option<f64>;
}

impl Number for f64 {
    fn number(self) -> Option<f64> {
        Some(self)
    }
}

impl Number for usize {
    fn number(self) -> Option<f64> {
        Some(self as f64)
    }
}

impl<T: Number> Number for Option<T> {
    fn number(self) -> Option<f64> {
        self.and_then(T::number)
    }
}

impl<T: Number + Copy> Number for &T {
    fn number(self) -> Option<f64> {
        (*self).number()
    }
}

/// Lines of a heading in the terminal that need no wider column.
const USUAL: usize = 2;

/// Least width in which a text of the last column is wrapped.
const LEAST_ROOM: usize = 15;

/// Lines of the tallest of the `headings`.
fn tallest(headings: &[Vec<String>]) -> usize {
    headings.iter().map(Vec::len).max().unwrap_or(0)
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// How the cells of a column are set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Names of the rows, at the left.
    Head,
    /// Text, at the left.
    Text,
    /// Numbers, at the right.
    Number,
}

/// A column of a table.
#[derive(Debug, Clone)]
pub struct Column {
    kind: Kind,
    /// Heading with the unit in square brackets.
    heading: String,
    cells: Vec<Cell>,
}

impl Column {
    /// A column of `cells`; without a `unit` the heading has none.
    pub fn new<C: Into<Cell>>(
        kind: Kind,
        heading: &str,
        unit: &str,
        cells: impl IntoIterator<Item = C>,
    ) -> Self {
        let heading = match (heading, unit) {
            (heading, "") => heading.to_owned(),
            ("", unit) => format!("[{unit}]"),
            (heading, unit) => format!("{heading} [{unit}]"),
        };
        Self {
            kind,
            heading,
            cells: cells.into_iter().map(Into::into).collect(),
        }
    }

    /// Words of the heading, parted at spaces and after hyphens; a unit is one word.
    fn words(&self) -> Vec<String> {
        let (name, unit) = match self.heading.rfind('[') {
            Some(at) => self.heading.split_at(at),
            None => (self.heading.as_str(), ""),
        };
        let words = name.split_inclusive([' ', '-']).chain([unit]);
        let words = words.filter(|word| !word.is_empty());
        words.map(str::to_owned).collect()
    }

    /// Width of the cells and of the longest word of the heading.
    fn least_width(&self) -> usize {
        let of_cells = self.cells.iter().map(Cell::width);
        let of_words = self.words().into_iter().map(|word| length(word.trim_end()));
        of_cells.chain(of_words).max().unwrap_or(0)
    }

    /// Lines of the heading in the terminal, of at most `width` characters.
    fn heading_lines(&self, width: usize) -> Vec<String> {
        let mut lines: Vec<String> = Vec::new();
        for word in self.words() {
            match lines.last_mut() {
                Some(line) if length(line) + length(word.trim_end()) <= width => *line += &word,
                _ => lines.push(word),
            }
        }
        lines
            .into_iter()
            .map(|line| line.trim_end().to_owned())
            .collect()
    }
}

/// A table: columns of equally many cells. Without rows neither face shows it.
#[derive(Debug, Clone, Default)]
pub struct Table {
    columns: Vec<Column>,
    class: &'static str,
}

impl Table {
    /// A table of `columns`.
    #[must_use]
    pub fn new(columns: impl IntoIterator<Item = Column>) -> Self {
        Self {
            columns: columns.into_iter().collect(),
            class: "",
        }
    }

    /// The table with further rows, each with a cell for every column.
    #[must_use]
    pub fn with_rows<const N: usize>(mut self, rows: impl IntoIterator<Item = [Cell; N]>) -> Self {
        for row in rows {
            for (column, cell) in self.columns.iter_mut().zip(row) {
                column.cells.push(cell);
            }
        }
        self
    }

    /// The table with further columns at the right.
    #[must_use]
    pub fn with(mut self, columns: impl IntoIterator<Item = Column>) -> Self {
        self.columns.extend(columns);
        self
    }

    /// The table without the columns `headings`, for a face that has no room for them.
    #[must_use]
    pub fn without(mut self, headings: &[&str]) -> Self {
        let names = |column: &Column| {
            let name = column.heading.split(" [").next();
            name.is_some_and(|name| headings.contains(&name))
        };
        self.columns.retain(|column| !names(column));
        self
    }

    /// The table with a class of the page's style.
    #[must_use]
    pub fn classed(mut self, class: &'static str) -> Self {
        self.class = class;
        self
    }

    /// Whether it has no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows() == 0
    }

    fn rows(&self) -> usize {
        let columns = self.columns.iter();
        columns.map(|column| column.cells.len()).max().unwrap_or(0)
    }

    fn headings(&self, widths: &[usize]) -> Vec<Vec<String>> {
        let columns = self.columns.iter().zip(widths);
        columns
            .map(|(column, width)| column.heading_lines(*width))
            .collect()
    }

    /// Widths of the columns in the terminal: as of their cells, wider where that makes the headings lower and there is room.
    fn widths(&self, indent: &str) -> Vec<usize> {
        let mut widths: Vec<usize> = self.columns.iter().map(Column::least_width).collect();
        if let (Some(Kind::Text), Some((last, others))) =
            (self.last_kind(), widths.split_last_mut())
        {
            let left = others.iter().map(|width| width + 2).sum::<usize>() + length(indent);
            let room = COLUMNS.saturating_sub(left);
            if room >= LEAST_ROOM {
                *last = (*last).min(room);
            }
        }
        loop {
            let headings = self.headings(&widths);
            let tall = tallest(&headings);
            if tall <= USUAL {
                return widths;
            }
            let columns = self.columns.iter().zip(&widths).zip(headings);
            let lower = columns.map(|((column, width), lines)| match lines.len() == tall {
                true => (*width..)
                    .find(|width| column.heading_lines(*width).len() < tall)
                    .unwrap_or(*width),
                false => *width,
            });
            let lower: Vec<usize> = lower.collect();
            let total = length(indent) + lower.iter().map(|width| width + 2).sum::<usize>() - 2;
            if total > COLUMNS {
                return widths;
            }
            widths = lower;
        }
    }

    fn last_kind(&self) -> Option<Kind> {
        self.columns.last().map(|column| column.kind)
    }

    /// Lines of a row in the terminal: a long text in the last column has several.
    fn lines(&self, row: usize, widths: &[usize]) -> Vec<Vec<String>> {
        let cells = self.columns.iter().map(|column| column.cells.get(row));
        let cells = cells.map(|cell| cell.map_or(String::new(), |cell| cell.line().into_owned()));
        let mut cells: Vec<String> = cells.collect();
        let is_long = |(text, width): (&String, &usize)| length(text) > *width;
        if !cells.last().zip(widths.last()).is_some_and(is_long) {
            return vec![cells];
        }
        let last = cells.pop().unwrap_or_default();
        let text = wrapped_within(&last, "", widths[cells.len()]);
        let lines = text.lines().map(|line| {
            let blank = vec![String::new(); cells.len()];
            let mut all = std::mem::replace(&mut cells, blank);
            all.push(line.to_owned());
            all
        });
        lines.collect()
    }

    /// The table for the terminal: aligned columns, two spaces between them, each line after `indent`. A long text in the last
    /// column is wrapped if there is room for it.
    ///
    /// ```
    /// use asperity_report::columns;
    /// struct Point { name: &'static str, load_n: f64, film_ratio: Option<f64> }
    /// let points = [
    ///     Point { name: "first", load_n: 30.0, film_ratio: Some(3.14) },
    ///     Point { name: "second", load_n: 75.0, film_ratio: None },
    /// ];
    /// let table = columns! { point in &points;
    ///     head name "point" "";
    ///     number load_n "load" "N" "{:.0}";
    ///     number film_ratio "film over roughness" "" "{:.1}";
    /// };
    /// let lines = [
    ///     "        load  film over",
    ///     "point    [N]  roughness",
    ///     "first     30        3.1",
    ///     "second    75          -",
    /// ];
    /// assert_eq!(table.text("").lines().collect::<Vec<_>>(), lines);
    /// ```
    #[must_use]
    pub fn text(&self, indent: &str) -> String {
        if self.is_empty() {
            return String::new();
        }
        let widths = self.widths(indent);
        let headings = self.headings(&widths);
        let tall = tallest(&headings);
        let blank = String::new();
        let of_headings = (0..tall).map(|line| {
            // Headings stand at the bottom.
            let cell = |lines: &Vec<String>| {
                let above = tall - lines.len();
                line.checked_sub(above)
                    .map_or(blank.clone(), |k| lines[k].clone())
            };
            headings.iter().map(cell).collect::<Vec<String>>()
        });
        let of_rows = (0..self.rows()).flat_map(|row| self.lines(row, &widths));
        let mut text = String::new();
        for cells in of_headings.chain(of_rows) {
            let mut line = indent.to_owned();
            for ((cell, column), width) in cells.iter().zip(&self.columns).zip(&widths) {
                let padding = " ".repeat(width - cell.chars().count().min(*width));
                line += &match column.kind {
                    Kind::Number => format!("{padding}{cell}  "),
                    Kind::Head | Kind::Text => format!("{cell}{padding}  "),
                };
            }
            text += line.trim_end();
            text.push('\n');
        }
        text
    }
}

impl IntoIterator for Table {
    type Item = Column;
    type IntoIter = std::vec::IntoIter<Column>;

    fn into_iter(self) -> Self::IntoIter {
        self.columns.into_iter()
    }
}

impl Render for Table {
    fn render(&self) -> Markup {
        let class = |column: &Column| (column.kind == Kind::Number).then_some("number");
        html! { @if !self.is_empty() { div.scroll { table class=[(!self.class.is_empty()).then_some(self.class)] {
            thead { tr { @for column in &self.columns { th class=[class(column)] { (column.heading) } } } }
            tbody { @for row in 0..self.rows() { tr { @for column in &self.columns {
                @let cell = column.cells.get(row).cloned().unwrap_or_default();
                @match column.kind {
                    Kind::Head => th scope="row" { (cell) },
                    _ => td class=[class(column)] { (cell) },
                }
            } } } }
        } } } }
    }
}

/// A [`Table`](crate::Table) of rows, with one line for each column.
///
/// A line is `kind field "heading" "unit"`, for a number with its digits, and `= value` where the value is not the field of
/// this name: `number temperature_c "temperature" "°C" "{:.0}";`, `text slides "slide-to-roll ratios" "" = slides(row);`. The kind is
/// `head`, `text`, `code` or `number`; a number without digits is a text that has its digits already. The row is a name, or a
/// pattern in parentheses whose parts the values name: `columns! { (name, [low, high]) in rows; ... }`.
#[macro_export]
macro_rules! columns {
    ($row:tt in $rows:expr; $($kind:ident $name:ident $heading:literal $unit:literal $($digits:literal)? $(= $value:expr)?;)+) => {{
        let columns = [$($crate::Column::new($crate::columns!(@kind $kind), $heading, $unit, [""; 0])),+];
        let rows = IntoIterator::into_iter($rows);
        $crate::Table::new(columns).with_rows(
            rows.map(|$row| [$($crate::columns!(@cell $kind, $row, $name, [$($digits)?] [$($value)?])),+]),
        )
    }};
    (@kind head) => { $crate::Kind::Head };
    (@kind text) => { $crate::Kind::Text };
    (@kind code) => { $crate::Kind::Text };
    (@kind number) => { $crate::Kind::Number };
    (@cell code, $row:tt, $name:ident, [] $value:tt) => {
        $crate::Cell::code($crate::columns!(@value $row, $name, $value))
    };
    (@cell $kind:ident, $row:tt, $name:ident, [] $value:tt) => {
        $crate::Cell::from($crate::columns!(@value $row, $name, $value))
    };
    (@cell $kind:ident, $row:tt, $name:ident, [$digits:literal] $value:tt) => {
        $crate::Cell::number($crate::columns!(@value $row, $name, $value), |value| format!($digits, value))
    };
    (@value $row:tt, $name:ident, []) => { &$row.$name };
    (@value $row:tt, $name:ident, [$value:expr]) => { $value };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_low_where_there_is_room_and_a_cell_stays_on_its_line() {
        let table = |name: &'static str| {
            let rows = [(name, 22.0)];
            columns! { (name, share) in rows; head name "name" "" = name; number share "standard deviation of single traces" "%" "{:.0}" = share; }
        };
        let room = table("first").text("");
        let lines: Vec<&str> = room.lines().collect();
        assert_eq!(
            lines,
            [
                "         standard deviation",
                "name   of single traces [%]",
                "first                    22"
            ]
        );
        let name: &'static str =
            "a name of seventy characters, which leaves no room for wide headings..";
        let none = table(name).text("");
        assert_eq!(none.lines().count(), 6, "{none}");
        assert!(none.lines().all(|line| line.chars().count() <= 81));
        assert!(table("a\nb").text("").contains("a\\u{a}b "));
    }

    #[test]
    fn a_table_without_rows_is_not_shown() {
        let none: [&str; 0] = [];
        let table = columns! { name in none; head name "name" "" = name; };
        assert_eq!(table.text(""), "");
        assert_eq!(table.render().into_string(), "");
    }
}
