//! The tree of named items of a Bruker OPDx file.
//!
//! Layout: Gwyddion dektakvca.c and SurfaceTopography. An item has a name, a type and data. Containers hold
//! items up to a terminator; lengths have one, two or four bytes, preceded by this width.

use super::bytes::{Cursor, PlainBytes};

/// Maximum nesting and number of items.
const DEEPEST: usize = 16;
const MOST_ITEMS: usize = 100_000;
/// Maximum length of a path in bytes.
const LONGEST_PATH: usize = 1000;
/// Types of items.
const MATRIX: u8 = 0x00;
const BOOLEAN: u8 = 0x01;
const I16: u8 = 0x04;
const U16: u8 = 0x05;
const I32: u8 = 0x06;
const U32: u8 = 0x07;
const I64: u8 = 0x0a;
const U64: u8 = 0x0b;
const F32: u8 = 0x0c;
const F64: u8 = 0x0d;
const TYPE_ID: u8 = 0x0e;
const STRING: u8 = 0x12;
const QUANTITY: u8 = 0x13;
const TIME: u8 = 0x15;
const UNITS: u8 = 0x18;
const ARRAY: u8 = 0x40;
const STRINGS: u8 = 0x42;
const RAW: u8 = 0x46;
const RAW_2D: u8 = 0x47;
const POSITIONS: u8 = 0x7c;
const CONTAINER: u8 = 0x7d;
const TERMINATOR: u8 = 0x7f;

/// Used data of an item.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Item {
    Text(String),
    Texts(Vec<String>),
    Number(f64),
    /// A value and the symbol of its unit.
    Quantity(f64, String),
    /// First byte and length of the numbers.
    Array(usize, usize),
    /// First byte of the numbers, rows and columns.
    Matrix(usize, usize, usize),
    Other,
}

/// The items of a file by their paths, `/1D_Data/Raw/Array`; `None` if the tree is truncated.
pub(super) fn items(bytes: &[u8], at: usize) -> Option<Vec<(String, Item)>> {
    let mut reader = OpdxReader {
        cursor: Cursor { bytes, at },
        found: Vec::new(),
    };
    while reader.item("", 0)? {}
    Some(reader.found)
}

struct OpdxReader<'a> {
    cursor: Cursor<'a>,
    found: Vec<(String, Item)>,
}

impl OpdxReader<'_> {
    /// Reads an item; returns whether another may follow in its container.
    fn item(&mut self, prefix: &str, depth: usize) -> Option<bool> {
        let at_end = self.cursor.at >= self.cursor.bytes.len();
        if at_end && depth == 0 {
            return Some(false);
        }
        if depth > DEEPEST || self.found.len() > MOST_ITEMS {
            return None;
        }
        let path = format!("{prefix}/{}", self.name()?);
        if path.len() > LONGEST_PATH {
            return None;
        }
        let kind: u8 = self.cursor.number()?;
        let item = match kind {
            TERMINATOR => return Some(false),
            CONTAINER | RAW | RAW_2D => {
                let end = self.end()?;
                while self.item(&path, depth + 1)? {}
                self.cursor.at = (self.cursor.at <= end).then_some(end)?;
                Item::Other
            }
            POSITIONS => self.skipped_named()?,
            STRING => {
                let length = self.length()?;
                Item::Text(self.text(length)?)
            }
            QUANTITY => {
                let end = self.end()?;
                let value = self.cursor.number()?;
                self.name()?;
                let symbol = self.name()?;
                self.cursor.at = end;
                Item::Quantity(value, symbol)
            }
            UNITS => {
                let end = self.end()?;
                self.cursor.at = end;
                Item::Other
            }
            TIME => {
                self.cursor.take(9)?;
                Item::Other
            }
            ARRAY => {
                self.name()?;
                let end = self.end()?;
                let first = self.cursor.at;
                self.cursor.at = end;
                Item::Array(first, end - first)
            }
            STRINGS => self.texts()?,
            TYPE_ID => self.skipped_named()?,
            MATRIX => self.matrix()?,
            BOOLEAN => Item::Number(self.number::<u8>()?),
            I16 => Item::Number(self.number::<i16>()?),
            U16 => Item::Number(self.number::<u16>()?),
            I32 => Item::Number(self.number::<i32>()?),
            U32 => Item::Number(self.number::<u32>()?),
            I64 => Item::Number(self.cursor.number::<i64>()? as f64),
            U64 => Item::Number(self.cursor.number::<u64>()? as f64),
            F32 => Item::Number(self.number::<f32>()?),
            F64 => Item::Number(self.number::<f64>()?),
            _ => return None,
        };
        self.found.push((path, item));
        Some(true)
    }

    fn number<T: PlainBytes + Into<f64>>(&mut self) -> Option<f64> {
        self.cursor.number::<T>().map(T::into)
    }

    fn name(&mut self) -> Option<String> {
        let length: u32 = self.cursor.number()?;
        self.text(length as usize)
    }

    fn text(&mut self, length: usize) -> Option<String> {
        let bytes = self.cursor.take(length)?;
        Some(String::from_utf8_lossy(bytes).into_owned())
    }

    /// A length, preceded by its width.
    fn length(&mut self) -> Option<usize> {
        Some(match self.cursor.number::<u8>()? {
            1 => self.cursor.number::<u8>()?.into(),
            2 => self.cursor.number::<u16>()?.into(),
            4 => self.cursor.number::<u32>()? as usize,
            _ => return None,
        })
    }

    /// The byte after data whose length comes next.
    fn end(&mut self) -> Option<usize> {
        let length = self.length()?;
        let end = self.cursor.at.checked_add(length)?;
        (end <= self.cursor.bytes.len()).then_some(end)
    }

    /// Skips the name and data of a type.
    fn skipped_named(&mut self) -> Option<Item> {
        self.name()?;
        self.cursor.at = self.end()?;
        Some(Item::Other)
    }

    fn texts(&mut self) -> Option<Item> {
        self.name()?;
        let end = self.end()?;
        let mut texts = Vec::new();
        while self.cursor.at < end {
            texts.push(self.name()?);
        }
        self.cursor.at = end;
        Some(Item::Texts(texts))
    }

    fn matrix(&mut self) -> Option<Item> {
        self.name()?;
        self.cursor.number::<u32>()?;
        self.name()?;
        let end = self.end()?;
        let rows = self.cursor.number::<u32>()? as usize;
        let columns = self.cursor.number::<u32>()? as usize;
        let first = self.cursor.at;
        self.cursor.at = (first <= end).then_some(end)?;
        Some(Item::Matrix(first, rows, columns))
    }
}
