//! Igor binary waves of version 5: a header of 384 bytes, the numbers with the first index running fastest, then texts.
//!
//! Layout: Technical Note PTN003 of WaveMetrics. Of several layers the first one named a height is read. Instruments of
//! Asylum Research leave the unit of a height out, which is metres. Curves, such as forces, are refused.

use super::bytes::{PlainBytes, part, text};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header;
use crate::read::metadata::short;
use crate::read::options::LengthUnit;

const FORMAT: Format = Format::IgorWave;
/// Bytes of the two headers.
const HEADERS: usize = 384;
/// Bytes of a label.
const LABEL: usize = 32;
/// Words of layers that are heights.
const NAMES: [&str; 4] = ["height", "zsensor", "topography", "z sensor"];

/// Numbers of a header in the byte order of the file.
#[derive(Clone, Copy)]
struct IbwHeader<'a> {
    bytes: &'a [u8],
    is_big: bool,
}

impl IbwHeader<'_> {
    fn number<T: PlainBytes>(self, at: usize) -> Option<T> {
        let bytes = part(self.bytes, at, T::WIDTH)?;
        if self.is_big {
            T::big(bytes)
        } else {
            T::little(bytes)
        }
    }

    /// A size of bytes or points; none if it is negative.
    fn size(self, at: usize) -> Option<usize> {
        usize::try_from(self.number::<i32>(at)?).ok()
    }
}

fn short_file() -> ReadFault {
    damaged(FORMAT, "it ends within its header or its numbers", "")
}

/// Type of the numbers of a wave.
struct IbwNumbers {
    kind: i16,
    /// Bytes of a number.
    width: usize,
}

impl IbwNumbers {
    /// The number at this place of the file.
    fn at(&self, header: &IbwHeader<'_>, at: usize) -> Option<f64> {
        Some(match self.kind {
            0x08 => header.number::<i8>(at)?.into(),
            0x48 => header.number::<u8>(at)?.into(),
            0x10 => header.number::<i16>(at)?.into(),
            0x50 => header.number::<u16>(at)?.into(),
            0x20 => header.number::<i32>(at)?.into(),
            0x60 => header.number::<u32>(at)?.into(),
            0x02 => header.number::<f32>(at)?.into(),
            _ => header.number::<f64>(at)?,
        })
    }
}

/// The numbers of a wave, with its columns, the points of a layer, and its layers.
fn numbers(header: &IbwHeader<'_>) -> Result<(IbwNumbers, [usize; 3]), ReadFault> {
    let refused = |content| ReadFault::no_heights(FORMAT, content);
    let mut sides = [0; 4];
    for (k, side) in sides.iter_mut().enumerate() {
        *side = header.size(64 + 68 + 4 * k).ok_or_else(short_file)?;
    }
    let [columns, rows, layers, chunks] = sides;
    if columns == 0 || chunks > 1 {
        return Err(refused("no image"));
    }
    let kind: i16 = header.number(64 + 16).ok_or_else(short_file)?;
    let width = match kind {
        0x08 | 0x48 => 1,
        0x10 | 0x50 => 2,
        0x02 | 0x20 | 0x60 => 4,
        0x04 => 8,
        0x00 => return Err(refused("texts")),
        _ => {
            let what = "its numbers are of an unknown kind";
            return Err(damaged(FORMAT, what, &kind.to_string()));
        }
    };
    let points = columns.checked_mul(rows.max(1)).ok_or_else(short_file)?;
    Ok((IbwNumbers { kind, width }, [columns, points, layers.max(1)]))
}

/// Reads the first layer of heights.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let header = IbwHeader {
        bytes,
        is_big: bytes.first() == Some(&0),
    };
    let refused = |content| ReadFault::no_heights(FORMAT, content);
    let size = |at| header.size(at).ok_or_else(short_file);
    let (numbers, [columns, points, layers]) = numbers(&header)?;
    let layer_size = points.checked_mul(numbers.width).ok_or_else(short_file)?;
    let data_size = layer_size.checked_mul(layers).ok_or_else(short_file)?;
    // Behind the numbers: formula, note, units of data and axes, labels of the axes.
    let mut before_labels = HEADERS.checked_add(data_size).ok_or_else(short_file)?;
    for at in [8, 12, 16, 20, 24, 28, 32] {
        before_labels = before_labels
            .checked_add(size(at)?)
            .ok_or_else(short_file)?;
    }
    let labels = |axis: usize| -> Result<Vec<String>, ReadFault> {
        let start = (0..axis).try_fold(before_labels, |at, k| {
            size(36 + 4 * k).map(|length| at.saturating_add(length))
        })?;
        let count = size(36 + 4 * axis)? / LABEL;
        let label = |k| text(bytes, start.saturating_add(LABEL * k), LABEL).unwrap_or_default();
        // The first one names the axis.
        Ok((1..count.min(1000)).map(label).collect())
    };
    if layers == 1 && labels(1)?.iter().any(|label| !label.is_empty()) {
        return Err(refused("curves side by side"));
    }
    let names = labels(2)?;
    let is_height = |name: &String| {
        let name = name.to_lowercase();
        NAMES.iter().any(|height| name.contains(height))
    };
    let layer = names.iter().position(is_height);
    if layer.is_none() && layers > 1 {
        return Err(refused("several layers, none of which is named a height"));
    }
    let unit_at = |at| text(bytes, 64 + at, 4).unwrap_or_default();
    let data_unit = header::unit(&unit_at(148));
    let unit = match (data_unit, layer) {
        (Some(unit), _) => Some(unit),
        (None, _) if !unit_at(148).is_empty() => {
            return Err(refused("numbers that are not lengths"));
        }
        (None, layer) => layer.map(|_| LengthUnit::Metre),
    };
    let first = HEADERS + layer_size * layer.unwrap_or(0);
    let value = |i: usize| numbers.at(&header, first + i * numbers.width);
    if part(bytes, first, layer_size).is_none() {
        return Err(short_file());
    }
    let values = (0..points).map(|i| value(i).unwrap_or(f64::NAN));
    let spacing = |axis: usize| {
        let unit = header::unit(&unit_at(152 + 4 * axis));
        let step: Option<f64> = header.number(64 + 84 + 8 * axis);
        unit.zip(step)
            .map_or(f64::NAN, |(unit, step)| unit.metres(step.abs()))
    };
    let values = values.collect();
    let heights = ArealHeights::Values { values, columns };
    let mut found = Areal::in_own_unit(FORMAT, heights, unit).spaced(spacing(0), spacing(1));
    found.metadata.title = text(bytes, 64 + 28, LABEL).as_deref().and_then(short);
    Ok(found)
}
