//! Alicona AL3D: tags of 52 bytes, and a depth image in metres as floats.
//!
//! Layout: AL3D File Format Specification 1.0 (2005) as its public readers state it (Gwyddion alicona.c,
//! SurfaceTopography, surfalize). Rows are padded to eight bytes. Depths from `InvalidPixelValue` up are missing. The
//! quality map, by which MeasureSuite filters, is not applied.

use std::collections::HashMap;

use super::bytes::text;
use super::raw::{Layout, Missing, Raw, RawNumber};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::{number, short};

const FORMAT: Format = Format::AliconaAl3d;
/// Bytes of the mark at the start.
const MARK: usize = 17;
/// Bytes of a tag: name, value, line end.
const TAG: [usize; 3] = [20, 30, 2];
/// Maximum number of tags; real files have some twenty.
const MOST_TAGS: usize = 1000;
/// Rows start at multiples of this.
const ALIGNED: usize = 8;
/// Default of `InvalidPixelValue`.
const INVALID: f64 = 3e15;

/// Reads the depth image.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let tags = tags(&bytes).ok_or_else(|| fault("a tag is cut off or has no line end", ""))?;
    let stated = |name: &str| tags.get(name).and_then(|text| number(text));
    let whole = |name: &'static str| {
        let found = tags.get(name).and_then(|text| text.parse::<usize>().ok());
        found.ok_or_else(|| fault("a tag is missing or no whole number", name))
    };
    let (columns, rows) = (whole("Cols")?, whole("Rows")?);
    let first = whole("DepthImageOffset")?;
    let row = columns.checked_mul(RawNumber::F32.width());
    let row = row.and_then(|row| row.checked_next_multiple_of(ALIGNED));
    let row = row.and_then(|row| i64::try_from(row).ok());
    let layout = row.map(|row| Layout {
        first,
        columns,
        rows,
        steps: [4, row],
    });
    let title = tags.get("CreatingApplication").cloned();
    let raw = layout.and_then(|layout| Raw::new(bytes, RawNumber::F32, layout));
    let mut raw = raw.ok_or_else(|| fault("the depth image is shorter than its size", ""))?;
    // The mark is a float; as a double its text is a little larger or smaller.
    let mark = stated("InvalidPixelValue").unwrap_or(INVALID) as f32;
    raw.missing = Missing::AtLeast(f64::from(if mark.is_finite() {
        mark
    } else {
        INVALID as f32
    }));
    let spacing = |name| stated(name).unwrap_or(f64::NAN);
    let spacings = [spacing("PixelSizeXMeter"), spacing("PixelSizeYMeter")];
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(spacings[0], spacings[1]);
    found.metadata.instrument = title.as_deref().and_then(short);
    Ok(found)
}

/// The tags by name; `None` if they are truncated.
fn tags(bytes: &[u8]) -> Option<HashMap<String, String>> {
    let mut tags = HashMap::new();
    let length: usize = TAG.iter().sum();
    let mut count = 2;
    let mut at = 0;
    while at < count {
        let start = MARK + at * length;
        let end = start + TAG[0] + TAG[1];
        if bytes.get(end..end + TAG[2])? != b"\r\n" {
            return None;
        }
        let (name, value) = (
            text(bytes, start, TAG[0])?,
            text(bytes, start + TAG[0], TAG[1])?,
        );
        if name == "TagCount" {
            // The version and the count precede the counted tags.
            count = value.parse::<usize>().ok()?.min(MOST_TAGS) + 2;
        }
        tags.insert(name, value);
        at += 1;
    }
    Some(tags)
}
