//! Elements of a MAT-file of level 5, and the numeric arrays among them.
//!
//! Layout: "MAT-File Format" of MathWorks. An element has a type, a size and data, padded to eight bytes; small
//! ones hold type and size in four bytes. Type 15 is a zlib stream of another element, type 14 an array: flags,
//! sizes, name, numbers column by column. All numbers here have their low byte first.

use super::bytes::{little, part, text};
use super::held::most_unpacked;
use super::raw::RawNumber;
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::packed::inflated;

const FORMAT: Format = Format::Matlab;
const HEADER: usize = 128;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Maximum number of elements; a file of lab data has some dozens.
const MOST_ELEMENTS: usize = 10_000;
/// Flag of complex numbers.
const COMPLEX: u32 = 0x800;
/// Classes of numeric arrays: double, single, and whole numbers of 8 to 64 bits.
const NUMERIC: std::ops::RangeInclusive<u32> = 6..=15;

/// An array of real numbers in two dimensions.
pub(super) struct Array {
    pub name: String,
    pub number: RawNumber,
    pub rows: usize,
    pub columns: usize,
    /// The numbers, column by column.
    pub data: Vec<u8>,
}

/// Type and data of an element, and the offset of the next one.
struct MatElement<'a> {
    kind: u32,
    data: &'a [u8],
    next: usize,
}

fn element(bytes: &[u8], at: usize) -> Option<MatElement<'_>> {
    let first: u32 = little(bytes, at)?;
    if first >> 16 != 0 {
        let data = part(bytes, at + 4, (first >> 16) as usize).filter(|data| data.len() <= 4)?;
        let kind = first & 0xffff;
        return Some(MatElement {
            kind,
            data,
            next: at + 8,
        });
    }
    let size = little::<u32>(bytes, at + 4)? as usize;
    let data = part(bytes, at + 8, size)?;
    let end = at + 8 + size;
    let next = match first {
        COMPRESSED => end,
        _ => end.checked_next_multiple_of(8)?,
    };
    Some(MatElement {
        kind: first,
        data,
        next,
    })
}

/// The numeric arrays of a file.
pub(super) fn arrays(bytes: &[u8]) -> Result<Vec<Array>, ReadFault> {
    let cut = || damaged(FORMAT, "an array is cut off", "");
    let mut found = Vec::new();
    let mut at = HEADER;
    let mut most = most_unpacked(bytes.len() as u64);
    for _ in 0..MOST_ELEMENTS {
        if at >= bytes.len() {
            break;
        }
        let outer = element(bytes, at).ok_or_else(cut)?;
        match outer.kind {
            COMPRESSED => {
                let content = inflated(FORMAT, outer.data, most)?;
                most -= content.len() as u64;
                let inner = element(&content, 0).ok_or_else(cut)?;
                if inner.kind == MATRIX {
                    found.extend(array(inner.data));
                }
            }
            MATRIX => found.extend(array(outer.data)),
            _ => {}
        }
        at = outer.next;
    }
    Ok(found)
}

/// The array in the data of a matrix element; `None` if it is not a two-dimensional array of real numbers.
fn array(bytes: &[u8]) -> Option<Array> {
    let flags = element(bytes, 0)?;
    let kind: u32 = little(flags.data, 0)?;
    if !NUMERIC.contains(&(kind & 0xff)) || kind & COMPLEX != 0 {
        return None;
    }
    let sizes = element(bytes, flags.next)?;
    let size = |at| usize::try_from(little::<i32>(sizes.data, at)?).ok();
    let (rows, columns) = (size(0)?, size(4)?);
    let name = element(bytes, sizes.next)?;
    let numbers = element(bytes, name.next)?;
    let number = storage(numbers.kind)?;
    let whole = rows.checked_mul(columns)?.checked_mul(number.width())?;
    (sizes.data.len() == 8 && whole > 0 && whole == numbers.data.len()).then_some(())?;
    Some(Array {
        name: text(name.data, 0, name.data.len())?,
        number,
        rows,
        columns,
        data: numbers.data.to_vec(),
    })
}

/// Storage by the type of an element.
fn storage(kind: u32) -> Option<RawNumber> {
    Some(match kind {
        1 => RawNumber::I8,
        2 => RawNumber::U8,
        3 => RawNumber::I16,
        4 => RawNumber::U16,
        5 => RawNumber::I32,
        6 => RawNumber::U32,
        7 => RawNumber::F32,
        9 => RawNumber::F64,
        12 => RawNumber::I64,
        13 => RawNumber::U64,
        _ => return None,
    })
}
