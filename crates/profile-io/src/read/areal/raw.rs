//! A matrix of numbers in the bytes of a file, and its conversion to heights.

use super::bytes::{PlainBytes, part};

/// Storage of a number.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum RawNumber {
    U8,
    I8,
    U16,
    I16,
    U32,
    I32,
    /// High byte first.
    I32Big,
    U64,
    I64,
    F32,
    F64,
}

impl RawNumber {
    pub(super) fn width(self) -> usize {
        match self {
            Self::U8 | Self::I8 => 1,
            Self::U16 | Self::I16 => 2,
            Self::U32 | Self::I32 | Self::I32Big | Self::F32 => 4,
            Self::U64 | Self::I64 | Self::F64 => 8,
        }
    }

    /// Whether `value` is the smallest 32-bit integer, which several makers write for a missing height.
    fn is_mark(self, value: f64) -> bool {
        matches!(self, Self::I32 | Self::I32Big) && value == f64::from(i32::MIN)
    }

    fn value(self, bytes: &[u8]) -> Option<f64> {
        Some(match self {
            Self::U8 => u8::little(bytes)?.into(),
            Self::I8 => i8::little(bytes)?.into(),
            Self::U16 => u16::little(bytes)?.into(),
            Self::I16 => i16::little(bytes)?.into(),
            Self::U32 => u32::little(bytes)?.into(),
            Self::I32 => i32::little(bytes)?.into(),
            Self::I32Big => i32::big(bytes)?.into(),
            // Numbers beyond 2⁵³ are rounded; no instrument has such numbers.
            Self::U64 => u64::little(bytes)? as f64,
            Self::I64 => i64::little(bytes)? as f64,
            Self::F32 => f32::little(bytes)?.into(),
            Self::F64 => f64::little(bytes)?,
        })
    }
}

/// Marks of missing heights, in addition to numbers that are not finite.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Missing {
    None,
    Equal(f64),
    AtLeast(f64),
    /// Up to the first number, and from the second.
    Outside(f64, f64),
}

impl Missing {
    fn holds(self, value: f64) -> bool {
        match self {
            Self::None => false,
            Self::Equal(mark) => value == mark,
            Self::AtLeast(mark) => value >= mark,
            Self::Outside(low, high) => value <= low || value >= high,
        }
    }
}

/// Unit of heights: metres are value · times / over, evaluated in this order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Unit {
    pub times: f64,
    pub over: f64,
}

impl Unit {
    pub(super) const METRE: Self = Self::part(1.0);
    pub(crate) const MICROMETRE: Self = Self::part(1e6);
    pub(super) const NANOMETRE: Self = Self::part(1e9);
    pub(super) const PICOMETRE: Self = Self::part(1e12);

    /// A metre divided by `over`.
    pub(super) const fn part(over: f64) -> Self {
        Self { times: 1.0, over }
    }

    /// `value` of this unit in metres.
    pub(crate) fn metres(self, value: f64) -> f64 {
        value * self.times / self.over
    }
}

/// Bytes of a file with the layout of the matrix in them.
#[derive(Debug, Clone)]
pub(crate) struct Raw {
    bytes: Vec<u8>,
    number: RawNumber,
    columns: usize,
    rows: usize,
    /// Offset of row 0, column 0.
    first: usize,
    /// Offsets to the next column and to the next row.
    steps: [i64; 2],
    /// A height is number · scale in `unit`.
    pub scale: f64,
    pub unit: Unit,
    pub missing: Missing,
}

/// Layout of a matrix: offset of row 0, column 0, and offsets to the next column and row.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Layout {
    pub first: usize,
    pub columns: usize,
    pub rows: usize,
    pub steps: [i64; 2],
}

impl Layout {
    /// Rows without gaps, from the offset `first`.
    pub(crate) fn packed(first: usize, columns: usize, rows: usize, number: RawNumber) -> Self {
        let width = number.width() as i64;
        let row = width.saturating_mul(i64::try_from(columns).unwrap_or(i64::MAX));
        Self {
            first,
            columns,
            rows,
            steps: [width, row],
        }
    }

    /// Whether the matrix is within `length` bytes.
    fn lies_in(self, length: usize, number: RawNumber) -> Option<bool> {
        let [along, across] = self.steps;
        let last =
            |count: usize, step: i64| i64::try_from(count).ok()?.checked_sub(1)?.checked_mul(step);
        let (x, y) = (last(self.columns, along)?, last(self.rows, across)?);
        let first = i64::try_from(self.first).ok()?;
        let low = first.checked_add(x.min(0))?.checked_add(y.min(0))?;
        let high = first.checked_add(x.max(0))?.checked_add(y.max(0))?;
        let end = high.checked_add(number.width() as i64)?;
        Some(low >= 0 && end <= i64::try_from(length).ok()?)
    }
}

impl Raw {
    /// The matrix at `layout`; `None` if it has no points or is not within `bytes`.
    pub(crate) fn new(bytes: Vec<u8>, number: RawNumber, layout: Layout) -> Option<Self> {
        let whole = layout.columns > 0 && layout.rows > 0;
        let inside = layout.lies_in(bytes.len(), number)?;
        (whole && inside).then_some(Self {
            bytes,
            number,
            columns: layout.columns,
            rows: layout.rows,
            first: layout.first,
            steps: layout.steps,
            scale: 1.0,
            unit: Unit::METRE,
            missing: Missing::None,
        })
    }

    pub(crate) fn size(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// Height `[m]` of a point; NaN if it is missing.
    pub(crate) fn height(&self, column: usize, row: usize) -> f64 {
        let [along, across] = self.steps;
        let at = self.first as i64 + along * column as i64 + across * row as i64;
        let bytes = part(&self.bytes, at as usize, self.number.width());
        match bytes.and_then(|bytes| self.number.value(bytes)) {
            Some(value)
                if value.is_finite()
                    && !self.missing.holds(value)
                    && !self.number.is_mark(value) =>
            {
                self.unit.metres(value * self.scale)
            }
            _ => f64::NAN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_matrix_beyond_its_bytes_is_none() {
        let fits = |first, columns, rows, steps| {
            let layout = Layout {
                first,
                columns,
                rows,
                steps,
            };
            Raw::new(vec![0; 24], RawNumber::I16, layout).is_some()
        };
        assert!(fits(0, 4, 3, [2, 8]));
        assert!(!fits(1, 4, 3, [2, 8]));
        // The last row first, as in OPD files.
        assert!(fits(16, 4, 3, [2, -8]));
        assert!(!fits(14, 4, 3, [2, -8]));
        assert!(!fits(0, 0, 3, [2, 8]));
        assert!(!fits(0, usize::MAX, usize::MAX, [2, i64::MAX]));
    }

    #[test]
    fn heights_are_scaled_and_marks_are_none() {
        let bytes: Vec<u8> = [1_i16, 2, -3, 32767]
            .iter()
            .flat_map(|v| v.to_le_bytes())
            .collect();
        let layout = Layout::packed(0, 2, 2, RawNumber::I16);
        let mut raw = Raw::new(bytes, RawNumber::I16, layout).unwrap();
        (raw.scale, raw.unit, raw.missing) = (0.5, Unit::NANOMETRE, Missing::AtLeast(32767.0));
        assert_eq!(raw.height(0, 1), -1.5e-9);
        assert!(raw.height(1, 1).is_nan());
    }
}
