//! Gwyddion documents: `GWYP`, then a container of named items, of which `/N/data` are surfaces.
//!
//! Layout: section "GWY file format" of the Gwyddion user guide. An object is its name, its size and its items; an item is
//! a name, a letter for its type, and a value, low byte first. The first surface whose heights have a unit of length is
//! read, a surface whose title names a height before others; without such a surface, the first one without a unit.

use std::collections::BTreeMap;

use super::bytes::{Cursor, PlainBytes};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header;
use crate::read::metadata::short;
use crate::read::options::LengthUnit;

const FORMAT: Format = Format::Gwyddion;
/// Words of titles of heights.
const NAMES: [&str; 4] = ["height", "topo", "zsensor", "z-axis"];

/// A value of an item.
enum Value<'a> {
    Whole(i64),
    Real(f64),
    Text(String),
    /// Name and items of an object.
    Object(String, &'a [u8]),
    Reals(&'a [u8]),
    /// A value of a type that no surface needs.
    Other,
}

/// Reads the first surface of heights.
pub(super) fn read(bytes: &[u8]) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let broken = || fault("an item is cut off or of an unknown type", "");
    let mut cursor = Cursor { bytes, at: 4 };
    let Some((_, items)) = object(&mut cursor) else {
        return Err(broken());
    };
    let items = items_of(items).ok_or_else(broken)?;
    let numbered = items.iter().filter_map(|(key, value)| {
        let number: usize = key.strip_prefix('/')?.strip_suffix("/data")?.parse().ok()?;
        match value {
            Value::Object(kind, content) if kind == "GwyDataField" => Some((number, *content)),
            _ => None,
        }
    });
    let surfaces: BTreeMap<usize, &[u8]> = numbered.collect();
    let title = |number: usize| match items.get(&format!("/{number}/data/title")) {
        Some(Value::Text(title)) => title.clone(),
        _ => String::new(),
    };
    let is_height = |number: usize| {
        let title = title(number).to_lowercase();
        NAMES.iter().any(|name| title.contains(name))
    };
    let mut order: Vec<usize> = surfaces.keys().copied().collect();
    order.sort_by_key(|number| !is_height(*number));
    let mut fields = Vec::new();
    for number in order {
        fields.push((number, items_of(surfaces[&number]).ok_or_else(broken)?));
    }
    let has_length = |field: &GwyItems<'_>| unit(field, "si_unit_z").is_some();
    let has_none =
        |field: &GwyItems<'_>| unit_text(field, "si_unit_z").is_none_or(|unit| unit.is_empty());
    let first = |is: &dyn Fn(&GwyItems<'_>) -> bool| fields.iter().position(|(_, field)| is(field));
    if let Some(at) = first(&has_length).or_else(|| first(&has_none)) {
        let (number, field) = &fields[at];
        let (number, unit) = (*number, unit(field, "si_unit_z"));
        let side = |name: &str| match field.get(name) {
            Some(Value::Whole(count)) => usize::try_from(*count).ok(),
            _ => None,
        };
        let (Some(columns), Some(rows), Some(Value::Reals(data))) =
            (side("xres"), side("yres"), field.get("data"))
        else {
            return Err(fault("a surface has no size or no data", &title(number)));
        };
        let (values, _) = data.as_chunks::<8>();
        if columns == 0 || columns.checked_mul(rows) != Some(values.len()) {
            return Err(fault(
                "a surface has not as many heights as its size",
                &title(number),
            ));
        }
        let values = values.iter().map(|z| f64::from_le_bytes(*z));
        let lateral = self::unit(field, "si_unit_xy");
        let spacing = |name: &str, count: usize| match (field.get(name), lateral) {
            (Some(Value::Real(length)), Some(unit)) => unit.metres(*length) / count as f64,
            _ => f64::NAN,
        };
        let (dx, dy) = (spacing("xreal", columns), spacing("yreal", rows));
        let heights = ArealHeights::Values {
            values: values.collect(),
            columns,
        };
        let mut found = Areal::in_own_unit(FORMAT, heights, unit).spaced(dx, dy);
        found.metadata.title = short(&title(number));
        return Ok(found);
    }
    Err(ReadFault::no_heights(
        FORMAT,
        "no surface of heights in a unit of length",
    ))
}

/// Items by name.
type GwyItems<'a> = BTreeMap<String, Value<'a>>;

/// A unit of length of a surface.
fn unit(field: &GwyItems<'_>, name: &str) -> Option<LengthUnit> {
    header::unit(&unit_text(field, name)?)
}

/// The text of a unit of a surface.
fn unit_text(field: &GwyItems<'_>, name: &str) -> Option<String> {
    let Some(Value::Object(_, content)) = field.get(name) else {
        return None;
    };
    match items_of(content)?.remove("unitstr") {
        Some(Value::Text(unit)) => Some(unit),
        _ => None,
    }
}

/// Name and items of the next object.
fn object<'a>(cursor: &mut Cursor<'a>) -> Option<(String, &'a [u8])> {
    let name = name(cursor)?;
    let size: u32 = cursor.number()?;
    Some((name, cursor.take(usize::try_from(size).ok()?)?))
}

/// The next text, which ends with a zero.
fn name(cursor: &mut Cursor<'_>) -> Option<String> {
    let rest = cursor.bytes.get(cursor.at..)?;
    let length = rest.iter().position(|byte| *byte == 0)?;
    let text = cursor.take(length + 1)?;
    Some(String::from_utf8_lossy(&text[..length]).into_owned())
}

/// The items of an object; `None` if one is damaged.
fn items_of(bytes: &[u8]) -> Option<GwyItems<'_>> {
    let mut cursor = Cursor { bytes, at: 0 };
    let mut items = BTreeMap::new();
    while cursor.at < bytes.len() {
        let key = name(&mut cursor)?;
        let kind: u8 = cursor.number()?;
        items.insert(key, value(&mut cursor, kind)?);
    }
    Some(items)
}

fn value<'a>(cursor: &mut Cursor<'a>, kind: u8) -> Option<Value<'a>> {
    let array = |cursor: &mut Cursor<'a>, width: usize| {
        let count: u32 = cursor.number()?;
        cursor.take(usize::try_from(count).ok()?.checked_mul(width)?)
    };
    Some(match kind {
        b'b' | b'c' => {
            cursor.take(u8::WIDTH)?;
            Value::Other
        }
        b'i' => Value::Whole(cursor.number::<i32>()?.into()),
        b'q' => Value::Whole(cursor.number()?),
        b'd' => Value::Real(cursor.number()?),
        b's' => Value::Text(name(cursor)?),
        b'o' => {
            let (name, content) = object(cursor)?;
            Value::Object(name, content)
        }
        b'D' => Value::Reals(array(cursor, f64::WIDTH)?),
        b'C' => {
            array(cursor, u8::WIDTH)?;
            Value::Other
        }
        b'I' => {
            array(cursor, i32::WIDTH)?;
            Value::Other
        }
        b'Q' => {
            array(cursor, i64::WIDTH)?;
            Value::Other
        }
        b'S' => {
            for _ in 0..cursor.number::<u32>()? {
                name(cursor)?;
            }
            Value::Other
        }
        b'O' => {
            for _ in 0..cursor.number::<u32>()? {
                object(cursor)?;
            }
            Value::Other
        }
        _ => return None,
    })
}
