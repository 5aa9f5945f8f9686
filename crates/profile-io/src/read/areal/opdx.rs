//! Bruker OPDx: a profile of a Dektak stylus instrument, or a surface.
//!
//! Layout: Gwyddion dektakvca.c and SurfaceTopography; confirmed on one public profile and its text export.
//! A profile of n points has the length `Extent`, so its spacing is `Extent`/(n − 1), as in the text export. A
//! height is number · `DataScale`. The layout of surfaces is not confirmed by a public file.

use super::opdx_items::{Item, items};
use super::raw::{Layout, Raw, RawNumber, Unit};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::{ReadFault, shortened};
use crate::read::format::Format;
use crate::read::metadata::short;
use crate::read::options::LengthUnit;

const FORMAT: Format = Format::Opdx;
/// Bytes of the mark at the start.
const MARK: usize = 12;
/// Bytes between the start of an array and its numbers.
const ARRAY_HEAD: usize = 5;

/// Items by their paths.
struct Tree {
    items: Vec<(String, Item)>,
}

impl Tree {
    fn get(&self, path: &str) -> Option<&Item> {
        let found = self.items.iter().find(|(known, _)| known == path);
        found.map(|(_, item)| item)
    }

    fn text(&self, path: &str) -> Option<&str> {
        match self.get(path) {
            Some(Item::Text(text)) => Some(text),
            _ => None,
        }
    }

    fn number(&self, path: &str) -> Option<f64> {
        match self.get(path) {
            Some(Item::Number(number)) => Some(*number),
            _ => None,
        }
    }

    /// A quantity: its value and its unit.
    fn quantity(&self, path: &str) -> Result<(f64, Unit), ReadFault> {
        let Some(Item::Quantity(value, symbol)) = self.get(path) else {
            return Err(damaged(FORMAT, "an item is missing", path));
        };
        let unit = match symbol.parse() {
            Ok(LengthUnit::Metre) => Unit::METRE,
            Ok(LengthUnit::Millimetre) => Unit::part(1e3),
            Ok(LengthUnit::Micrometre) => Unit::MICROMETRE,
            Ok(LengthUnit::Nanometre) => Unit::NANOMETRE,
            Ok(LengthUnit::Angstrom) => Unit::part(1e10),
            _ => {
                return Err(ReadFault::unknown_unit(
                    crate::read::options::Axis::Height,
                    &shortened(symbol),
                ));
            }
        };
        Ok((*value, unit))
    }
}

/// Reads the profile or surface.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let items = items(&bytes, MARK);
    let items = items.ok_or_else(|| damaged(FORMAT, "the tree of its items breaks off", ""))?;
    let tree = Tree { items };
    let mut found = match tree.text("/MetaData/DataKind") {
        Some("Surface Profile") => profile(&tree, bytes)?,
        Some("Surface Height") => surface(&tree, bytes)?,
        _ => {
            return Err(ReadFault::no_heights(
                FORMAT,
                "neither a profile nor a surface",
            ));
        }
    };
    let said = |path| tree.text(path).and_then(short);
    found.metadata.date = said("/MetaData/Date");
    found.metadata.title = said("/MetaData/DataSetName");
    found.metadata.instrument = said("/MetaData/MeasurementSettings/InstrumentName");
    Ok(found)
}

fn profile(tree: &Tree, bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let channel = match tree.get("/MetaData/1D_Channels/Height") {
        Some(Item::Texts(names)) => names.first().cloned(),
        _ => None,
    };
    let channel = channel.ok_or_else(|| fault("it names no channel of heights", ""))?;
    let prefix = format!("/1D_Data/{channel}");
    let points = tree.number(&format!("{prefix}/NumPoints"));
    let points = points.filter(|n| *n >= 1.0 && *n < 1e9 && n.fract() == 0.0);
    let points = points.ok_or_else(|| fault("NumPoints is missing", ""))? as usize;
    let Some(&Item::Array(first, length)) = tree.get(&format!("{prefix}/Array")) else {
        return Err(fault("its heights are missing", ""));
    };
    if length != points * RawNumber::F64.width() + ARRAY_HEAD {
        return Err(fault(
            "the number of heights is not that of the header",
            &length.to_string(),
        ));
    }
    let (extent, along) = tree.quantity(&format!("{prefix}/Extent"))?;
    let (scale, unit) = tree.quantity(&format!("{prefix}/DataScale"))?;
    let layout = Layout::packed(first + ARRAY_HEAD, points, 1, RawNumber::F64);
    let raw = Raw::new(bytes, RawNumber::F64, layout);
    let mut raw = raw.ok_or_else(|| fault("its heights are cut off", ""))?;
    (raw.scale, raw.unit) = (scale, unit);
    let spacing = along.metres(extent / (points as f64 - 1.0));
    Ok(Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(spacing, f64::NAN))
}

fn surface(tree: &Tree, bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let channel = tree.text("/MetaData/PrimaryData2D");
    let channel = channel.ok_or_else(|| fault("it names no channel of heights", ""))?;
    let prefix = format!("/2D_Data/{channel}");
    let Some(&Item::Matrix(first, rows, columns)) = tree.get(&format!("{prefix}/Matrix")) else {
        return Err(fault("its heights are missing", ""));
    };
    let (height, across) = tree.quantity(&format!("{prefix}/Dimension1Extent"))?;
    let (width, along) = tree.quantity(&format!("{prefix}/Dimension2Extent"))?;
    let (scale, unit) = tree.quantity(&format!("{prefix}/DataScale"))?;
    let layout = Layout::packed(first, columns, rows, RawNumber::F32);
    let raw = Raw::new(bytes, RawNumber::F32, layout);
    let mut raw = raw.ok_or_else(|| fault("its heights are cut off", ""))?;
    (raw.scale, raw.unit) = (scale, unit);
    let dx = along.metres(width / columns as f64);
    let dy = across.metres(height / rows as f64);
    Ok(Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(dx, dy))
}
