//! Workbooks of Excel 97 to 2003 (`.xls`): the numbers and texts of their sheets.
//!
//! Layout: MS-XLS of Microsoft, "Excel Binary File Format". Stream `Workbook` of a compound file is a sequence of records
//! (number, length, data): first the places of the sheets and the texts that cells share, then each sheet. A number is
//! stored as double, as RK (30 bits of a double or of a whole number, or a hundredth of it), or as the result of a formula.

use std::io::Read;

use super::sheet::{MOST_TEXTS, Sheet};
use crate::read::areal::bytes::little;
use crate::read::areal::held::most_unpacked;
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::text::Stream;

const FORMAT: Format = Format::ExcelBinary;

/// Numbers of records.
const FORMULA: u16 = 0x06;
const END: u16 = 0x0a;
const ENCRYPTED: u16 = 0x2f;
const CONTINUED: u16 = 0x3c;
const PLACE_OF_SHEET: u16 = 0x85;
const SEVERAL_RK: u16 = 0xbd;
const SHARED_TEXTS: u16 = 0xfc;
const SHARED_TEXT: u16 = 0xfd;
const NUMBER: u16 = 0x203;
const TEXT: u16 = 0x204;
const RK: u16 = 0x27e;

/// The sheets of the workbook in `stream`, a file of `size` bytes.
pub(super) fn sheets(stream: &mut dyn Stream, size: u64) -> Result<Vec<Sheet>, ReadFault> {
    let fault = |what: &'static str| damaged(FORMAT, what, "");
    let compound = cfb::CompoundFile::open(stream);
    let mut compound = compound.map_err(|_| fault("the compound file cannot be read"))?;
    let book = compound.open_stream("/Workbook");
    let book = book.map_err(|_| fault("it holds no stream Workbook of Excel 97 or later"))?;
    let mut bytes = Vec::new();
    let read = book.take(most_unpacked(size)).read_to_end(&mut bytes);
    read.map_err(|_| fault("stream Workbook cannot be read"))?;
    of_book(&bytes).map_err(fault)
}

fn of_book(book: &[u8]) -> Result<Vec<Sheet>, &'static str> {
    let mut places = Vec::new();
    let mut texts = Vec::new();
    let mut records = Records { book, at: 0 };
    while let Some((kind, data)) = records.next() {
        match kind {
            ENCRYPTED => return Err("it is encrypted"),
            // The kind of a sheet is 0; others are charts and macros.
            PLACE_OF_SHEET if data.get(5) == Some(&0) => {
                places.extend(little(data, 0).map(|at: u32| at as usize));
            }
            SHARED_TEXTS => {
                let mut parts = vec![data];
                while let Some((CONTINUED, more)) = records.peek() {
                    parts.push(more);
                    records.next();
                }
                texts = Texts::new(&parts).all();
            }
            END => break,
            _ => {}
        }
    }
    // A sheet ends where the next one begins, so that no record is read twice.
    let mut sorted = places.clone();
    sorted.sort_unstable();
    sorted.dedup();
    if sorted.len() != places.len() {
        return Err("two sheets have the same place");
    }
    let sheet = |at: usize| {
        let next = sorted.partition_point(|place| *place <= at);
        let end = sorted.get(next).map_or(book.len(), |end| *end);
        let book = book.get(..end).unwrap_or(book);
        sheet(Records { book, at }, &texts)
    };
    Ok(places.into_iter().map(sheet).collect())
}

/// The sheet whose records start at the place of `records`.
fn sheet(records: Records<'_>, texts: &[String]) -> Sheet {
    let mut sheet = Sheet::default();
    for (kind, data) in records {
        let (Some(row), Some(column)) = (little::<u16>(data, 0), little::<u16>(data, 2)) else {
            if kind == END {
                break;
            }
            continue;
        };
        let (row, column) = (row.into(), usize::from(column));
        match kind {
            NUMBER => sheet.value(row, column, little(data, 6)),
            // A result that is no number ends with two bytes of ones.
            FORMULA if data.get(12..14) != Some(&[0xff, 0xff]) => {
                sheet.value(row, column, little(data, 6));
            }
            RK => sheet.value(row, column, little(data, 6).map(rk)),
            SEVERAL_RK => {
                // Each cell has six bytes, its format first; two bytes with the last column follow.
                for (cell, bytes) in data
                    .get(4..)
                    .unwrap_or_default()
                    .chunks_exact(6)
                    .enumerate()
                {
                    sheet.value(row, column + cell, little(bytes, 2).map(rk));
                }
            }
            SHARED_TEXT => {
                let text = little(data, 6).and_then(|at: u32| texts.get(at as usize));
                sheet.label(row, column, text.map_or("", String::as_str));
            }
            TEXT => {
                let text = Texts::new(&[data.get(6..).unwrap_or_default()]).text();
                sheet.label(row, column, &text.unwrap_or_default());
            }
            _ => {}
        }
        if sheet.is_full() {
            break;
        }
    }
    sheet
}

/// The records of a stream from a place on.
#[derive(Clone, Copy)]
struct Records<'a> {
    book: &'a [u8],
    at: usize,
}

impl<'a> Records<'a> {
    fn peek(mut self) -> Option<(u16, &'a [u8])> {
        self.next()
    }
}

impl<'a> Iterator for Records<'a> {
    type Item = (u16, &'a [u8]);

    fn next(&mut self) -> Option<(u16, &'a [u8])> {
        let rest = self.book.get(self.at..)?;
        let (kind, length) = (little(rest, 0)?, usize::from(little::<u16>(rest, 2)?));
        let data = rest.get(4..4 + length)?;
        self.at += 4 + length;
        Some((kind, data))
    }
}

/// Texts that may continue in further records. The characters of a text have one or two bytes, which is stated before them
/// and again where they continue.
struct Texts<'a> {
    parts: Vec<&'a [u8]>,
    part: usize,
    at: usize,
}

impl<'a> Texts<'a> {
    fn new(parts: &[&'a [u8]]) -> Self {
        let parts = parts.to_vec();
        Self {
            parts,
            part: 0,
            at: 0,
        }
    }

    /// The shared texts: a number of uses, the number of texts, the texts.
    fn all(mut self) -> Vec<String> {
        let count = self.parts.first().and_then(|part| little::<u32>(part, 4));
        let count = count.map_or(0, |count| (count as usize).min(MOST_TEXTS));
        self.at = 8;
        (0..count).map_while(|_| self.text()).collect()
    }

    /// The next text; `None` at the end.
    fn text(&mut self) -> Option<String> {
        let count = u16::from_le_bytes([self.byte()?, self.byte()?]);
        let state = self.byte()?;
        let mut is_wide = state & 1 != 0;
        let runs = if state & 8 != 0 {
            u16::from_le_bytes([self.byte()?, self.byte()?])
        } else {
            0
        };
        let extension = if state & 4 != 0 {
            u32::from_le_bytes([self.byte()?, self.byte()?, self.byte()?, self.byte()?])
        } else {
            0
        };
        let mut units = Vec::with_capacity(count.into());
        for _ in 0..count {
            if self.at >= self.parts.get(self.part)?.len() {
                is_wide = self.byte()? & 1 != 0;
            }
            let low = self.byte()?;
            let high = if is_wide { self.byte()? } else { 0 };
            units.push(u16::from_le_bytes([low, high]));
        }
        // Formats of parts of the text, four bytes each, and phonetic text.
        self.skip((4 * usize::from(runs)).saturating_add(extension as usize));
        Some(String::from_utf16_lossy(&units))
    }

    fn byte(&mut self) -> Option<u8> {
        while self.at >= self.parts.get(self.part)?.len() {
            self.part += 1;
            self.at = 0;
        }
        self.at += 1;
        self.parts[self.part].get(self.at - 1).copied()
    }

    fn skip(&mut self, mut bytes: usize) {
        while let Some(part) = self.parts.get(self.part)
            && bytes > part.len() - self.at
        {
            bytes -= part.len() - self.at;
            self.part += 1;
            self.at = 0;
        }
        self.at = self.at.saturating_add(bytes);
    }
}

/// The number of an RK: with bit 0 a hundredth; with bit 1 a whole number, else the upper bits of a double.
fn rk(bits: u32) -> f64 {
    let number = if bits & 2 != 0 {
        f64::from(bits.cast_signed() >> 2)
    } else {
        f64::from_bits(u64::from(bits & !3) << 32)
    };
    if bits & 1 != 0 {
        number / 100.0
    } else {
        number
    }
}
