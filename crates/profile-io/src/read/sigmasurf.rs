//! SigmaSurf text (`.sig`): `NAME: value` lines, then the heights in micrometres under `PROFILE_UM:`.

use super::damage::{damaged, height, miscounted};
use super::error::ReadFault;
use super::file_dialect::BadHeights;
use super::format::Format;
use super::found::Found;
use super::grid::SpacingSource;
use super::lengths::Lengths;
use super::metadata::{Metadata, number, short};
use super::options::LengthUnit;
use super::plain_row::take_numbers;
use super::text::TextSource;

const FORMAT: Format = Format::SigmaSurf;

/// Reads a SigmaSurf profile.
pub(super) fn read(text: &mut TextSource<'_>) -> Result<Found, ReadFault> {
    let mut metadata = Metadata::default();
    let (mut spacing, mut points, mut first_line) = (None, None, 1);
    let mut heights: Option<Vec<f64>> = None;
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        let (at, line) = (line.number, line.text.trim());
        if let Some(heights) = &mut heights {
            if !line.is_empty() {
                let Some(height) = height(line) else {
                    let bad = BadHeights::new(FORMAT, line, (at, line));
                    return Err(bad.in_all(&mut lines, |line| line));
                };
                heights.push(height);
                take_numbers(&mut lines, usize::MAX, heights);
            }
            continue;
        }
        let (key, value) = line.split_once(':').unwrap_or((line, ""));
        match key.trim() {
            "IDENTIFICATION" => metadata.title = short(value),
            "DATE" => metadata.date = short(value),
            "SPACING_UM" => spacing = number(value).filter(|dx| *dx > 0.0),
            "NUMBER_OF_POINTS" => points = value.trim().parse::<usize>().ok(),
            "PROFILE_UM" => {
                heights = Some(Vec::new());
                first_line = at + 1;
            }
            _ => {}
        }
    }
    let heights = heights.ok_or_else(|| damaged(FORMAT, "there is no PROFILE_UM", ""))?;
    if let Some(stated) = points.filter(|stated| *stated != heights.len()) {
        return Err(miscounted(FORMAT, heights.len(), stated));
    }
    Ok(Found {
        spacing: spacing.map(|dx| {
            (
                Lengths::new(dx, LengthUnit::Micrometre),
                SpacingSource::Header,
            )
        }),
        metadata,
        first_line: Some(first_line),
        ..Found::new(FORMAT, Lengths::new(heights, LengthUnit::Micrometre))
    })
}
