//! Nanosurf NID: sections of `name=value` lines up to the mark `#!`, then the data of the channels in their order.
//!
//! Layout as public readers state it (Gwyddion nanosurf.c, NSFopen). A height is Dim2Min + Dim2Range·v/2^bits, where v
//! is the number counted from the smallest one. The channel is the first one of a name with Z and a unit of length.

use std::collections::HashMap;

use super::bytes::part;
use super::raw::{Layout, Raw, RawNumber, Unit};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header;
use crate::read::metadata::{number, short};

const FORMAT: Format = Format::NanosurfNid;
/// Mark before the data.
const DATA: &[u8] = b"#!";
/// Maximum size of the text in bytes; real files have some ten thousand.
const LONGEST_TEXT: usize = 1 << 20;
/// Maximum number of groups and channels.
const MOST: usize = 64;

type NidSection = HashMap<String, String>;

/// Reads the first channel of heights.
pub(super) fn read(mut bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let text = &bytes[..bytes.len().min(LONGEST_TEXT)];
    let end = text.windows(DATA.len()).position(|mark| mark == DATA);
    let end = end.ok_or_else(|| fault("the mark before the data is missing", ""))?;
    let sections = sections(&encoding_rs::WINDOWS_1252.decode(&text[..end]).0);
    let mut first = end + DATA.len();
    let none = NidSection::new();
    let index = sections.get("DataSet").unwrap_or(&none);
    for name in (0..MOST).flat_map(|group| (0..MOST).map(move |channel| (group, channel))) {
        let Some(name) = index.get(&format!("Gr{}-Ch{}", name.0, name.1)) else {
            continue;
        };
        let channel = sections.get(name.as_str());
        let channel = channel.ok_or_else(|| fault("a channel has no section", name))?;
        let value = |name: &'static str| {
            let found = channel.get(name).and_then(|text| number(text));
            found.ok_or_else(|| fault("a value of a channel is missing or no number", name))
        };
        let (columns, rows) = (value("Points")? as usize, value("Lines")? as usize);
        let bits = value("SaveBits")?;
        let of_kind = match bits as u32 {
            8 => RawNumber::I8,
            16 => RawNumber::I16,
            32 => RawNumber::I32,
            _ => {
                return Err(fault(
                    "the numbers have an unknown width",
                    &bits.to_string(),
                ));
            }
        };
        let size = columns
            .checked_mul(rows)
            .and_then(|points| points.checked_mul(of_kind.width()));
        let size = size.ok_or_else(|| fault("a channel is too large", name))?;
        let unit = channel.get("Dim2Unit").and_then(|unit| header::unit(unit));
        let is_height = channel
            .get("Dim2Name")
            .is_some_and(|name| name.starts_with('Z'));
        let (true, Some(unit)) = (is_height, unit) else {
            first = first.saturating_add(size);
            continue;
        };
        if part(&bytes, first, size).is_none() {
            return Err(fault("the data end before the channel", name));
        }
        // The offset of all heights is left out: a trace has none.
        let scale = unit.metres(value("Dim2Range")?) / bits.exp2();
        let spacing = |range: &'static str, unit: &str, count: usize| {
            let unit = channel.get(unit).and_then(|unit| header::unit(unit));
            let range = value(range)
                .ok()
                .zip(unit)
                .map(|(range, unit)| unit.metres(range));
            range.unwrap_or(f64::NAN) / count.max(1) as f64
        };
        let dx = spacing("Dim0Range", "Dim0Unit", columns);
        let dy = spacing("Dim1Range", "Dim1Unit", rows);
        let title = channel.get("Dim2Name").and_then(|name| short(name));
        let layout = Layout::packed(first, columns, rows, of_kind);
        let raw = Raw::new(std::mem::take(&mut bytes), of_kind, layout);
        let mut raw = raw.ok_or_else(|| fault("a channel has no points", name))?;
        (raw.scale, raw.unit) = (scale, Unit::METRE);
        let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(dx, dy);
        found.metadata.title = title;
        found.metadata.instrument = Some("Nanosurf".to_owned());
        return Ok(found);
    }
    Err(ReadFault::no_heights(FORMAT, "no channel of heights"))
}

/// The lines `name=value` of each section.
fn sections(text: &str) -> HashMap<String, NidSection> {
    let mut sections: HashMap<String, NidSection> = HashMap::new();
    let mut current = String::new();
    for line in text.lines() {
        let line = line.trim();
        if let Some(name) = line
            .strip_prefix('[')
            .and_then(|name| name.strip_suffix(']'))
        {
            current = name.to_owned();
            sections.entry(current.clone()).or_default();
        } else if let Some((name, value)) = line.split_once('=') {
            let section = sections.entry(current.clone()).or_default();
            section.insert(name.to_owned(), value.to_owned());
        }
    }
    sections
}
