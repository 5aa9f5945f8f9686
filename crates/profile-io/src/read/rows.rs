//! Reading of the rows of a table into columns of numbers.
//!
//! Plain rows are read from the bytes of whole blocks of lines. The first line of a block and other rows are read cell
//! by cell, with the same results.

use super::dialect::{DialectCell, Sniffed, is_word};
use super::error::{ReadFault, shortened};
use super::file_dialect::of_file;
use super::layout::Dialect;
use super::plain_row::Plain;
use super::table::{self, Chosen};
use super::text::{Line, TextSource};

/// Columns of x and height in the units of the file.
pub(super) struct Rows {
    /// x, if the table has such a column.
    pub x: Option<Vec<f64>>,
    /// Heights; NaN for missing ones.
    pub z: Vec<f64>,
    /// Number of rows without x and height, which are left out.
    pub empty: usize,
}

/// All rows from the line `first`, or the error of the first unreadable cell, explained with the lines `head`.
pub(super) fn read(
    text: &mut TextSource<'_>,
    first: usize,
    head: &[Line<'_>],
    sniffed: &Sniffed,
    chosen: Chosen,
) -> Result<Rows, ReadFault> {
    let plain = Plain::new(sniffed.dialect, chosen, text.line_end());
    let mut rows = Rows {
        x: chosen.x.map(|_| Vec::new()),
        z: Vec::new(),
        empty: 0,
    };
    let mut words = Words::default();
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number < first || line.is_blank() {
            continue;
        }
        let (x, z) = match row(head, &line, sniffed.dialect, chosen, &mut words) {
            Ok(row) => row,
            Err(fault) => {
                let (number, text) = (line.number, line.text.to_owned());
                return Err(of_file(fault, number, &text, &mut lines, sniffed)?);
            }
        };
        if chosen.x.is_some() && x.is_nan() {
            rows.empty += 1
        } else {
            rows.push(x, z)
        }
        let (mut passed, at_hand) = (0, lines.at_hand());
        let mut rest = at_hand;
        while let Some((x, z, after)) = plain.row(rest) {
            rows.push(x, z);
            passed += 1;
            rest = after;
        }
        lines.pass(passed, at_hand.len() - rest.len());
    }
    let Some(single) = words.single() else {
        return Ok(rows);
    };
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number == single {
            let fault = table::unreadable(head, &line, line.text.trim(), sniffed.dialect);
            let text = line.text.to_owned();
            return Err(of_file(fault, single, &text, &mut lines, sniffed)?);
        }
    }
    Ok(rows)
}

/// Words in a single column of heights: marks of missing points, if each of them occurs again, else the head of another trace.
#[derive(Default)]
pub(super) struct Words(Vec<Word>);

/// A word, with the line where it occurs first.
struct Word {
    text: String,
    line: usize,
    is_repeated: bool,
}

impl Words {
    /// Adds the word in a line; returns whether there are few others.
    fn add(&mut self, line: usize, text: &str) -> bool {
        const MOST: usize = 8;
        if let Some(word) = self.0.iter_mut().find(|word| word.text == text) {
            word.is_repeated = true;
            return true;
        }
        self.0.push(Word {
            text: text.to_owned(),
            line,
            is_repeated: false,
        });
        self.0.len() <= MOST
    }

    /// Line of the first word that occurs once.
    fn single(&self) -> Option<usize> {
        let single = self.0.iter().find(|word| !word.is_repeated);
        single.map(|word| word.line)
    }
}

/// Line number and text of a row of the table that starts at line `first`, by reading the file again.
pub(super) fn place(
    text: &mut TextSource<'_>,
    first: usize,
    row: usize,
) -> Result<(usize, String), ReadFault> {
    let mut before = row;
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        if line.number < first || line.is_blank() {
            continue;
        }
        if before == 0 {
            return Ok((line.number, shortened(line.text)));
        }
        before -= 1;
    }
    // The file has changed since then.
    Ok((first, String::new()))
}

impl Rows {
    fn push(&mut self, x: f64, z: f64) {
        if let Some(column) = &mut self.x {
            column.push(x);
        }
        self.z.push(z);
    }
}

/// x and height of any row; x is NaN without an x column and in a row without x and height, the height is NaN if it is
/// missing, which any word marks if x states its place.
pub(super) fn row(
    head: &[Line<'_>],
    line: &Line<'_>,
    dialect: Dialect,
    chosen: Chosen,
    words: &mut Words,
) -> Result<(f64, f64), ReadFault> {
    let (mut x_cell, mut z_cell, mut valid_cell) = ("", "", "");
    let (mut count, mut filled) = (0, 0);
    for cell in dialect.joined(line.text) {
        match Some(count) {
            at if at == chosen.x => x_cell = cell,
            at if at == chosen.valid => valid_cell = cell,
            Some(at) if at == chosen.z => z_cell = cell,
            _ => {}
        }
        count += 1;
        if !cell.is_empty() {
            filled = count;
        }
    }
    let unreadable = |cell| table::unreadable(head, line, cell, dialect);
    let number = |cell| match dialect.cell(cell) {
        DialectCell::Number(value) => Ok(value),
        DialectCell::Missing => Ok(f64::NAN),
        DialectCell::Other => Err(unreadable(cell)),
    };
    // The cells are read before they are counted, so that a text line is reported by its text.
    let x = match chosen.x {
        Some(_) => Some(number(x_cell)?),
        None => None,
    };
    let is_word = is_word(z_cell) && dialect.cell(z_cell) == DialectCell::Other;
    let z = if is_word && (x.is_some() || words.add(line.number, z_cell)) {
        f64::NAN
    } else {
        number(z_cell)?
    };
    if count < chosen.count || filled > chosen.count {
        return Err(table::ragged(line, count.max(filled), chosen.count));
    }
    // A height without x has no position.
    if x.is_some_and(f64::is_nan) && !z.is_nan() {
        return Err(unreadable(x_cell));
    }
    let valid = chosen.valid.is_none() || dialect.cell(valid_cell) != DialectCell::Number(0.0);
    Ok((x.unwrap_or(f64::NAN), if valid { z } else { f64::NAN }))
}
