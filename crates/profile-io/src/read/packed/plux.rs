//! Sensofar PLUX: a zip with `index.xml` and heights in micrometres as floats.
//!
//! Layout: SurfaceTopography and surfalize. `GENERAL` states the points and their distance, `LAYER_0` the
//! member with the heights; NaN is a missing height. The first layer is read.

use super::archive::Archive;
use super::xml::{Leaf, walk};
use crate::read::areal::raw::{Layout, Raw, RawNumber, Unit};
use crate::read::areal::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::{Metadata, number, short};
use crate::read::text::Stream;

const FORMAT: Format = Format::SensofarPlux;
const INDEX: &str = "index.xml";
const HEIGHTS: &str = "LAYER_0.raw";

/// Content of `index.xml`.
#[derive(Default)]
struct Index {
    size: [Option<usize>; 2],
    spacing: [Option<f64>; 2],
    member: Option<String>,
    item: Option<String>,
    metadata: Metadata,
}

impl Index {
    fn take(&mut self, leaf: &Leaf<'_>) -> bool {
        let text = leaf.text;
        match (leaf.parent(), leaf.name()) {
            ("GENERAL", "IMAGE_SIZE_X") => self.size[0] = text.parse().ok(),
            ("GENERAL", "IMAGE_SIZE_Y") => self.size[1] = text.parse().ok(),
            ("GENERAL", "FOV_X") => self.spacing[0] = number(text),
            ("GENERAL", "FOV_Y") => self.spacing[1] = number(text),
            ("GENERAL", "DATE") => self.metadata.date = short(text),
            ("LAYER_0", "FILENAME_Z") => self.member = Some(text.to_owned()),
            (_, "NAME") => self.item = Some(text.to_owned()),
            (_, "VALUE") if self.item.as_deref() == Some("Device") => {
                self.metadata.instrument = short(text);
            }
            _ => {}
        }
        true
    }
}

/// Reads the first layer.
pub(super) fn read(stream: &mut dyn Stream, size: u64) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let mut archive = Archive::open(FORMAT, stream, size)?;
    let name = archive.find(INDEX);
    let name = name.ok_or_else(|| fault("it holds no index.xml", ""))?;
    let index = archive.read(&name, |stream| {
        let mut index = Index::default();
        if walk(stream, |leaf| index.take(&leaf)) {
            Ok(index)
        } else {
            Err(fault("index.xml is not sound XML", ""))
        }
    })?;
    let [Some(columns), Some(rows)] = index.size else {
        return Err(fault("index.xml states no size", ""));
    };
    let member = index.member.as_deref().unwrap_or(HEIGHTS);
    let member = archive.find(member).unwrap_or_else(|| member.to_owned());
    let bytes = archive.bytes(&member)?;
    let layout = Layout::packed(0, columns, rows, RawNumber::F32);
    let raw = Raw::new(bytes, RawNumber::F32, layout);
    let mut raw = raw.ok_or_else(|| fault("fewer heights than index.xml says", ""))?;
    raw.unit = Unit::MICROMETRE;
    let [dx, dy] = index.spacing;
    let metres = |um: Option<f64>| um.map_or(f64::NAN, |um| Unit::MICROMETRE.metres(um));
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(metres(dx), metres(dy));
    found.metadata = index.metadata;
    Ok(found)
}
