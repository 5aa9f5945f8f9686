//! Tables of numbers and texts, described once for the page, the terminal and the file.
//!
//! A table is a list of columns; [`columns!`](crate::columns) makes one from rows with one line for each column: its name, heading,
//! unit, digits and value. [`Table::text`] prints it with aligned columns, on a page it is written into the markup by `(table)`, and
//! with [`Table::in_file`] its values are a file.

use asperity_core::{Estimate, Fault};
use std::borrow::Cow;
use std::path::Path;

use asperity::result::loss_band::Digits;
use asperity_storage::one_line;
use maud::{Markup, Render, html};
use serde::Serialize;

use crate::tables;
use crate::wrap::{COLUMNS, wrapped_within};

/// A value in the file of a table, with all its digits.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// A text.
    Text(String),
    /// A number.
    Number(f64),
    /// A count.
    Count(usize),
    /// No value: an empty cell.
    Missing,
}

/// A cell of a table.
#[derive(Debug, Clone)]
pub struct Cell {
    /// Its text in the terminal.
    text: String,
    /// Its markup on a page; `None` for the text.
    markup: Option<Markup>,
    /// Its values in the file: one, or three of an interval.
    values: Vec<Value>,
}

impl Default for Cell {
    fn default() -> Self {
        "".into()
    }
}

impl Cell {
    /// A number by `format`, or "-" if there is none.
    pub fn number(value: impl Number, format: impl Fn(f64) -> String) -> Self {
        let value = value.number();
        Self::shown(
            value.map_or("-".to_owned(), format),
            value.map_or(Value::Missing, Value::Number),
        )
    }

    /// The number `value` with its interval and the digits that this leaves.
    pub fn interval(estimate: Estimate) -> Self {
        let text = Digits::of_interval(estimate.ends()).interval(estimate);
        Self::estimate(text, Some(estimate))
    }

    /// A number with its interval if there is one, shown as `text`.
    pub fn estimate(text: impl Into<String>, estimate: Option<Estimate>) -> Self {
        Self::with_ends(
            text,
            estimate.map(|of| of.value),
            estimate.map(Estimate::ends),
        )
    }

    /// A number, possibly with the ends of its interval, shown as `text`.
    pub fn with_ends(text: impl Into<String>, value: Option<f64>, ends: Option<[f64; 2]>) -> Self {
        let number = |value: Option<f64>| value.map_or(Value::Missing, Value::Number);
        let [low, high] = ends.map_or([None; 2], |ends| ends.map(Some));
        Self {
            values: [value, low, high].map(number).into(),
            ..Self::from(text.into())
        }
    }

    /// An interval in brackets, or "-" if there is none.
    pub fn range(ends: Option<[f64; 2]>, digits: Digits) -> Self {
        let text = ends.map(|ends| format!("({})", digits.range(ends)));
        let [low, high] = ends.map_or([Value::Missing, Value::Missing], |ends| {
            ends.map(Value::Number)
        });
        Self {
            values: vec![low, high],
            ..Self::from(text.unwrap_or("-".to_owned()))
        }
    }

    /// The text of `value`, or "-" if there is none.
    pub fn optional<T: Into<Cell>>(value: Option<T>) -> Self {
        let missing = || Self::shown("-", Value::Missing);
        value.map_or_else(missing, T::into)
    }

    /// `text`, in the file `value`.
    pub fn shown(text: impl Into<String>, value: Value) -> Self {
        Self {
            text: text.into(),
            markup: None,
            values: vec![value],
        }
    }

    /// `text`, on a page with `markup`.
    pub fn marked(text: impl Into<String>, markup: Markup) -> Self {
        Self {
            markup: Some(markup),
            ..Self::from(text.into())
        }
    }

    /// `text` as code.
    pub fn code(text: impl Into<String>) -> Self {
        let text = text.into();
        let markup = html! { code { (text) } };
        Self::marked(text, markup)
    }

    /// Its text.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Its text in the terminal, on one line.
    fn line(&self) -> Cow<'_, str> {
        one_line(&self.text)
    }

    fn width(&self) -> usize {
        length(&self.line())
    }
}

impl<T: Into<Value> + ToString> From<T> for Cell {
    fn from(value: T) -> Self {
        let text = value.to_string();
        Self::shown(text, value.into())
    }
}

impl<T: Clone + Into<Self>> From<&T> for Value {
    fn from(value: &T) -> Self {
        value.clone().into()
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Count(count)
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<u32> for Value {
    fn from(count: u32) -> Self {
        Self::Count(count as usize)
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

/// Least width in which a text is wrapped.
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
    /// Numbers with their intervals, at the right.
    Interval,
    /// Intervals, at the right.
    Range,
}

impl Kind {
    fn is_number(self) -> bool {
        !matches!(self, Self::Head | Self::Text)
    }
}

/// The faces that have a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Faces {
    /// Terminal and page, and the file if the column has a name there.
    All,
    /// The page, and the file: the terminal has no room for it.
    NotTerminal,
    /// The file.
    File,
}

/// A column of a table.
#[derive(Debug, Clone)]
pub struct Column {
    kind: Kind,
    /// Name in the file, with its unit; empty if it is not in the file. An interval has three: `loss_w`, `loss_p05_w`, `loss_p95_w`.
    name: &'static str,
    /// Heading with the unit in square brackets.
    heading: String,
    faces: Faces,
    cells: Vec<Cell>,
}

/// Names of a number and of the ends of its interval in a file: `loss_w` has `loss_p05_w` and `loss_p95_w`.
fn names_of_interval(name: &str) -> [String; 3] {
    let end = |which: &str| match name.rsplit_once('_') {
        Some((stem, unit)) => format!("{stem}{which}_{unit}"),
        None => format!("{name}{which}"),
    };
    [name.to_owned(), end("_p05"), end("_p95")]
}

impl Column {
    /// A column of `cells` that is not in the file; without a `unit` the heading has none.
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
            name: "",
            heading,
            faces: Faces::All,
            cells: cells.into_iter().map(Into::into).collect(),
        }
    }

    /// The column with its name in the file.
    #[must_use]
    pub fn named(mut self, name: &'static str) -> Self {
        self.name = name;
        self
    }

    /// The column in the file only.
    #[must_use]
    pub fn unshown(mut self) -> Self {
        self.faces = Faces::File;
        self
    }

    /// Names of its values in the file.
    fn names(&self) -> Vec<String> {
        match self.kind {
            _ if self.name.is_empty() => Vec::new(),
            Kind::Interval => names_of_interval(self.name).into(),
            Kind::Range => ["low", "high"]
                .map(|end| format!("{}_{end}", self.name))
                .into(),
            _ => vec![self.name.to_owned()],
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

    /// Least width in which its texts can be wrapped; the width of its numbers.
    fn wrapped_width(&self) -> usize {
        let least = self.least_width();
        if self.kind.is_number() {
            return least;
        }
        let words = self.cells.iter().flat_map(|cell| {
            let words = cell.line().split(' ').map(length).max();
            words.into_iter().collect::<Vec<usize>>()
        });
        let of_heading = self.words().into_iter().map(|word| length(word.trim_end()));
        let longest = words.chain(of_heading).max().unwrap_or(0);
        longest.max(LEAST_ROOM).min(least)
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
    /// Name of the file with its values; empty if there is none.
    file: &'static str,
    /// Whether the table is this file; otherwise the rows of the result are.
    is_file: bool,
    /// Whether it is the answer of its report.
    is_answer: bool,
}

impl Table {
    /// A table of `columns`.
    #[must_use]
    pub fn new(columns: impl IntoIterator<Item = Column>) -> Self {
        Self {
            columns: columns.into_iter().collect(),
            class: "",
            file: "",
            is_file: false,
            is_answer: false,
        }
    }

    /// The table, whose columns with a name are the file `name` of the folder.
    #[must_use]
    pub fn in_file(mut self, name: &'static str) -> Self {
        (self.file, self.is_file) = (name, true);
        self
    }

    /// The table, whose columns have the names of the columns of the file `name`, which has the rows of the result.
    #[must_use]
    pub fn of_file(mut self, name: &'static str) -> Self {
        (self.file, self.is_file) = (name, false);
        self
    }

    /// Whether it is a file of the folder.
    pub(crate) fn is_file(&self) -> bool {
        self.is_file
    }

    /// Writes the values of the columns that have a name, with all digits, as its file in `folder`.
    ///
    /// # Errors
    /// When the file cannot be written, or a number is not finite.
    pub fn write(&self, folder: &Path) -> Result<(), Fault> {
        tables::write(&folder.join(self.file), self.file_lines())
    }

    /// Name and text of its file.
    ///
    /// # Errors
    /// When a number is not finite.
    pub(crate) fn file_text(&self) -> Result<(&'static str, Vec<u8>), Fault> {
        Ok((
            self.file,
            tables::text(Path::new(self.file), self.file_lines())?,
        ))
    }

    /// The lines of its file.
    fn file_lines(&self) -> Vec<Vec<Value>> {
        let columns = || self.columns.iter().filter(|column| !column.name.is_empty());
        let names = columns().flat_map(Column::names).map(Value::Text);
        // Every row has a value of every name, also where a cell is missing or has no interval.
        let values = |column: &Column, row: usize| {
            let cell = column.cells.get(row).map_or(&[][..], |cell| &cell.values);
            let mut values = cell.to_vec();
            values.resize(column.names().len(), Value::Missing);
            values
        };
        let rows =
            (0..self.rows()).map(|row| columns().flat_map(|column| values(column, row)).collect());
        [names.collect()].into_iter().chain(rows).collect()
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

    /// The table as the answer of its report, of which a first screen shows every row.
    #[must_use]
    pub fn answer(mut self) -> Self {
        self.is_answer = true;
        self
    }

    pub(crate) fn is_answer(&self) -> bool {
        self.is_answer
    }

    /// The table without the columns `headings` in the terminal, which has no room for them.
    #[must_use]
    pub fn brief(self, headings: &[&str]) -> Self {
        self.left_to(Faces::NotTerminal, headings)
    }

    /// The table with the columns `headings` in its file only.
    #[must_use]
    pub fn unshown_of(self, headings: &[&str]) -> Self {
        self.left_to(Faces::File, headings)
    }

    fn left_to(mut self, faces: Faces, headings: &[&str]) -> Self {
        for column in &mut self.columns {
            let name = column.heading.split(" [").next();
            if name.is_some_and(|name| headings.contains(&name)) {
                column.faces = faces;
            }
        }
        self
    }

    /// The table with `to` as the heading instead of `heading`.
    #[must_use]
    pub fn renamed(mut self, heading: &str, to: &str) -> Self {
        let mut columns = self.columns.iter_mut();
        if let Some(column) = columns.find(|column| column.heading == heading) {
            column.heading = to.into();
        }
        self
    }

    /// Its columns on a page.
    fn shown(&self) -> impl Iterator<Item = &Column> {
        let columns = self.columns.iter();
        columns.filter(|column| column.faces != Faces::File)
    }

    /// Its columns in the terminal.
    fn in_terminal(&self) -> Vec<&Column> {
        let columns = self.columns.iter();
        let columns = columns.filter(|column| column.faces == Faces::All);
        columns.collect()
    }

    /// The table with a class of the page's style.
    #[must_use]
    pub(crate) fn classed(mut self, class: &'static str) -> Self {
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

    fn headings(columns: &[&Column], widths: &[usize]) -> Vec<Vec<String>> {
        let columns = columns.iter().zip(widths);
        columns
            .map(|(column, width)| column.heading_lines(*width))
            .collect()
    }

    /// Widths of the columns in the terminal: as of their cells, wider where that makes the headings lower and there is room.
    fn widths(shown: &[&Column], indent: &str) -> Vec<usize> {
        let mut widths: Vec<usize> = shown.iter().map(|column| column.least_width()).collect();
        let last_kind = shown.last().map(|column| column.kind);
        if let (Some(Kind::Text), Some((last, others))) = (last_kind, widths.split_last_mut()) {
            let left = others.iter().map(|width| width + 2).sum::<usize>() + length(indent);
            let room = COLUMNS.saturating_sub(left);
            if room >= LEAST_ROOM {
                *last = (*last).min(room);
            }
        }
        loop {
            let headings = Self::headings(shown, &widths);
            let tall = tallest(&headings);
            if tall <= USUAL {
                return widths;
            }
            let columns = shown.iter().zip(&widths).zip(headings);
            let lower = columns.map(|((column, width), lines)| {
                if lines.len() == tall {
                    (*width..)
                        .find(|width| column.heading_lines(*width).len() < tall)
                        .unwrap_or(*width)
                } else {
                    *width
                }
            });
            let lower: Vec<usize> = lower.collect();
            let total = length(indent) + lower.iter().map(|width| width + 2).sum::<usize>() - 2;
            if total > COLUMNS {
                return widths;
            }
            widths = lower;
        }
    }

    /// Number of lines of its headings in the terminal.
    pub(crate) fn heading_height(&self) -> usize {
        let (columns, widths) = self.fitted("");
        tallest(&Self::headings(&columns, &widths))
    }

    /// The columns that fit into a terminal, with their widths: texts are wrapped as far as their words allow, then columns at
    /// the right are left to the page and the file.
    fn fitted(&self, indent: &str) -> (Vec<&Column>, Vec<usize>) {
        let mut columns = self.in_terminal();
        loop {
            let mut widths = Self::widths(&columns, indent);
            let total = length(indent) + widths.iter().map(|width| width + 2).sum::<usize>();
            let mut excess = total.saturating_sub(COLUMNS + 2);
            for (width, column) in widths.iter_mut().zip(&columns) {
                let spare = width.saturating_sub(column.wrapped_width());
                let saved = spare.min(excess);
                *width -= saved;
                excess -= saved;
            }
            if excess == 0 || columns.len() <= 2 {
                return (columns, widths);
            }
            columns.pop();
        }
    }

    /// Lines of a row in the terminal: a text longer than its column has several.
    fn lines(columns: &[&Column], row: usize, widths: &[usize]) -> Vec<Vec<String>> {
        let cells = columns.iter().map(|column| column.cells.get(row));
        let cells = cells.map(|cell| cell.map_or(String::new(), |cell| cell.line().into_owned()));
        let wrapped = cells.zip(widths).map(|(text, width)| {
            let text = wrapped_within(&text, "", *width);
            text.lines().map(str::to_owned).collect::<Vec<String>>()
        });
        let wrapped: Vec<Vec<String>> = wrapped.collect();
        let count = wrapped.iter().map(Vec::len).max().unwrap_or(0).max(1);
        let line = |k: usize| {
            let cells = wrapped.iter();
            let cell = |lines: &Vec<String>| lines.get(k).cloned().unwrap_or_default();
            cells.map(cell).collect()
        };
        (0..count).map(line).collect()
    }

    /// The table for the terminal: aligned columns, two spaces between them, each line after `indent`. Texts are wrapped where
    /// the columns are wider than a terminal, and columns for which there is no room are left out.
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
        let (columns, widths) = self.fitted(indent);
        let headings = Self::headings(&columns, &widths);
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
        let of_rows = (0..self.rows()).flat_map(|row| Self::lines(&columns, row, &widths));
        let mut text = String::new();
        for cells in of_headings.chain(of_rows) {
            let mut line = indent.to_owned();
            for ((cell, column), width) in cells.iter().zip(&columns).zip(&widths) {
                let padding = " ".repeat(width - cell.chars().count().min(*width));
                line += &match column.kind {
                    kind if kind.is_number() => format!("{padding}{cell}  "),
                    _ => format!("{cell}{padding}  "),
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
        let class = |column: &Column| column.kind.is_number().then_some("number");
        /// Characters of a text beyond which its cell is wider on a narrow screen.
        const LONG: usize = 60;
        let is_long = |cell: &Cell| cell.text().chars().count() > LONG;
        let of_cell = |column, cell: &Cell| class(column).or(is_long(cell).then_some("long"));
        let file = (!self.file.is_empty()).then_some(self.file);
        let named =
            |column: &Column| (file.is_some() && !column.name.is_empty()).then_some(column.name);
        html! { @if !self.is_empty() { div.scroll { table class=[(!self.class.is_empty()).then_some(self.class)] data-file=[file] {
            thead { tr { @for column in self.shown() {
                // A heading without a text is not a heading.
                @if column.heading.is_empty() { td class=[class(column)] data-column=[named(column)] {} }
                @else { th class=[class(column)] data-column=[named(column)] { (column.heading) } }
            } } }
            tbody { @for row in 0..self.rows() { tr { @for column in self.shown() {
                @let cell = column.cells.get(row).cloned().unwrap_or_default();
                @match column.kind {
                    Kind::Head => th scope="row" { (cell) },
                    _ => td class=[of_cell(column, &cell)] { (cell) },
                }
            } } } }
        } } } }
    }
}

/// A [`Table`](crate::Table) of rows, with one line for each column.
///
/// A line is `kind name "heading" "unit"`, for a number with its digits, and `= value` where the value is not the field of
/// this name: `number temperature_c "temperature" "°C" "{:.0}";`, `text slides "slide-to-roll ratios" "" = slides(row);`. The name
/// is the name of the column in the file of the table, if it has one. The row is a name, or a pattern in parentheses whose parts
/// the values name: `columns! { (name, [low, high]) in rows; ... }`.
///
/// | kind | is |
/// |---|---|
/// | `head` | the name of the row |
/// | `text`, `code` | a text |
/// | `number` | a number; without digits a value that has its digits already |
/// | `percent` | a share, shown in percent |
/// | `interval` | a [`Cell`](crate::Cell) of a number with its interval, which is three columns of the file |
/// | `range` | a [`Cell`](crate::Cell) of an interval, which is two columns of the file |
/// | `shown` | a text that is not in the file; with a unit it is set as a number |
/// | `file` | a value that is in the file only: `file code = value;` |
#[macro_export]
macro_rules! columns {
    ($row:tt in $rows:expr; $($kind:ident $name:ident $($heading:literal $unit:literal $($digits:literal)?)? $(= $value:expr)?;)+) => {{
        let columns = [$($crate::columns!(@column $kind, $name, $($heading, $unit)?)),+];
        let rows = IntoIterator::into_iter($rows);
        $crate::Table::new(columns).with_rows(
            rows.map(|$row| [$($crate::columns!(@cell $kind, $row, $name, [$($($digits)?)?] [$($value)?])),+]),
        )
    }};
    (@column shown, $name:ident, $heading:literal, $unit:literal) => {
        $crate::Column::new(if $unit.is_empty() { $crate::Kind::Text } else { $crate::Kind::Number }, $heading, $unit, [""; 0])
    };
    (@column file, $name:ident,) => {
        $crate::Column::new($crate::Kind::Text, "", "", [""; 0]).named(stringify!($name)).unshown()
    };
    (@column $kind:ident, $name:ident, $heading:literal, $unit:literal) => {
        $crate::Column::new($crate::columns!(@kind $kind), $heading, $unit, [""; 0]).named(stringify!($name))
    };
    (@kind head) => { $crate::Kind::Head };
    (@kind text) => { $crate::Kind::Text };
    (@kind code) => { $crate::Kind::Text };
    (@kind number) => { $crate::Kind::Number };
    (@kind percent) => { $crate::Kind::Number };
    (@kind interval) => { $crate::Kind::Interval };
    (@kind range) => { $crate::Kind::Range };
    (@cell code, $row:tt, $name:ident, [] $value:tt) => {
        $crate::Cell::code($crate::columns!(@value $row, $name, $value))
    };
    (@cell file, $row:tt, $name:ident, [] $value:tt) => {
        $crate::Cell::from($crate::columns!(@value $row, $name, $value))
    };
    (@cell percent, $row:tt, $name:ident, [$digits:literal] $value:tt) => {
        $crate::Cell::number($crate::columns!(@value $row, $name, $value), |value| format!($digits, 100.0 * value))
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
        assert_eq!(none.lines().count(), 7, "{none}");
        assert!(none.lines().all(|line| line.chars().count() <= COLUMNS));
        assert!(table("a\nb").text("").contains("a\\u{a}b "));
    }

    #[test]
    fn a_table_wider_than_a_terminal_has_wrapped_names_and_fewer_columns() {
        let name =
            "losses of these gears with other flanks on a rig, at seven points of torque and speed";
        let column = |k: usize| {
            Column::new(
                Kind::Number,
                &format!("quantity {k}"),
                "W",
                ["1234567890 (1..2)"],
            )
        };
        let table = Table::new([Column::new(Kind::Head, "measurement", "", [name])])
            .with((0..6).map(column));
        let text = table.text("");
        assert!(
            text.lines().all(|line| line.chars().count() <= COLUMNS),
            "{text}"
        );
        assert!(
            text.contains("quantity 2") && !text.contains("quantity 5"),
            "{text}"
        );
        assert!(
            text.contains("losses of these") && text.contains("speed"),
            "{text}"
        );
    }

    #[test]
    fn a_table_without_rows_is_not_shown() {
        let none: [&str; 0] = [];
        let table = columns! { name in none; head name "name" "" = name; };
        assert_eq!(table.text(""), "");
        assert_eq!(table.render().into_string(), "");
    }
}
