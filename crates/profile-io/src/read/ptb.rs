//! Text profiles (`.pr`) of PTB's reference software.
//!
//! Line 1 is `Profil` and a name; line 2 gives length, resolution in points per millimetre and number of points, in
//! German (`X-Maß = 5.6 X-Auflösung 2000 Punkte/Zeile : 11201`) or English (`X-len`, `X-resolution`,
//! `points/scanline`); heights in micrometres follow. The layout follows a public writer of the format; no original PTB
//! file was available. The length is not used, because writers state it in millimetres or micrometres.

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

const FORMAT: Format = Format::PtbPr;
const HEADER_LINES: usize = 2;

/// Whether line 2 is a PTB header.
pub(super) fn recognised(line: &str) -> bool {
    line.starts_with("X-") && (line.contains("Punkte/Zeile") || line.contains("points/scanline"))
}

/// Reads a `.pr` profile.
pub(super) fn read(text: &mut TextSource<'_>) -> Result<Found, ReadFault> {
    let mut lines = text.lines()?;
    let title = lines.next()?.map_or("", |line| line.text.trim()).to_owned();
    let header = lines.next()?.map_or("", |line| line.text);
    let numbers: Vec<f64> = header
        .split(|c: char| c.is_whitespace() || c == '=' || c == ':')
        .filter_map(number)
        .collect();
    let &[_, per_millimetre, points] = numbers.as_slice() else {
        return Err(damaged(
            FORMAT,
            "line 2 gives no length, resolution and number",
            header,
        ));
    };
    let mut heights = Vec::new();
    while let Some(line) = lines.next()? {
        if !line.is_blank() {
            let Some(height) = height(line.text) else {
                let bad = BadHeights::new(FORMAT, line.text, (line.number, line.text));
                return Err(bad.in_all(&mut lines, |line| line));
            };
            heights.push(height);
            take_numbers(&mut lines, usize::MAX, &mut heights);
        }
    }
    if heights.len() as f64 != points {
        return Err(miscounted(FORMAT, heights.len(), points));
    }
    let dx = Some(1.0 / per_millimetre).filter(|dx| dx.is_finite() && *dx > 0.0);
    Ok(Found {
        spacing: dx.map(|dx| {
            (
                Lengths::new(dx, LengthUnit::Millimetre),
                SpacingSource::Header,
            )
        }),
        metadata: Metadata {
            title: short(title.trim_start_matches("Profil ")),
            ..Metadata::default()
        },
        first_line: Some(HEADER_LINES + 1),
        ..Found::new(FORMAT, Lengths::new(heights, LengthUnit::Micrometre))
    })
}
