//! XML profiles of ASME B46 and NPL: `DATA/DATAFILE` with `UNITS`, `NUMPOINTS`, `SPACING` and `DATA_POINT_VALUES`.
//!
//! No schema was found; the layout is that of the published samples (NavierPy/surface-roughness-profile-analyser), whose
//! spacing is in the unit of the heights: a softgauge of 8000 points in 4 mm states the spacing 0.5 and the unit um.

use super::xml::walk;
use crate::read::damage::{damaged, height, miscounted, not_a_number};
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::found::Found;
use crate::read::grid::SpacingSource;
use crate::read::header;
use crate::read::lengths::Lengths;
use crate::read::metadata::{Metadata, number, short};
use crate::read::options::{Axis, LengthUnit};
use crate::read::text::Stream;

const FORMAT: Format = Format::NplXml;

/// Reads the profile.
pub(super) fn read(stream: &mut dyn Stream) -> Result<Found, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    stream.rewind()?;
    let mut metadata = Metadata::default();
    let (mut unit, mut points, mut spacing) = (String::new(), None, None);
    let mut values: Option<String> = None;
    let sound = walk(stream, |leaf| {
        match (leaf.parent(), leaf.name()) {
            ("DATAFILE", "UNITS") => unit = leaf.text.to_owned(),
            ("DATAFILE", "NUMPOINTS") => points = leaf.text.parse::<usize>().ok(),
            ("DATAFILE", "SPACING") => spacing = number(leaf.text).filter(|dx| *dx > 0.0),
            ("DATAFILE", "DATA_POINT_VALUES") => values = Some(leaf.text.to_owned()),
            ("PART", "PART_NAME") => metadata.title = short(leaf.text),
            ("PART", "PART_DATE") => metadata.date = short(leaf.text),
            ("MEASUREMENT", "MEASUREMENT_INSTRUMENT_TYPE") => {
                metadata.instrument = short(leaf.text).filter(|name| name != "N/A");
            }
            _ => {}
        }
        values.is_none()
    });
    let values = match values {
        Some(values) if sound => values,
        _ => return Err(fault("there is no DATA_POINT_VALUES in its DATAFILE", "")),
    };
    let unit: LengthUnit =
        header::unit(&unit).ok_or_else(|| ReadFault::unknown_unit(Axis::Height, &unit))?;
    let heights: Vec<f64> = values
        .split_whitespace()
        .map(|value| height(value).ok_or_else(|| not_a_number(FORMAT, value)))
        .collect::<Result<_, _>>()?;
    if let Some(stated) = points.filter(|stated| *stated != heights.len()) {
        return Err(miscounted(FORMAT, heights.len(), stated));
    }
    Ok(Found {
        spacing: spacing.map(|dx| (Lengths::new(dx, unit), SpacingSource::Header)),
        metadata,
        ..Found::new(FORMAT, Lengths::new(heights, unit))
    })
}
