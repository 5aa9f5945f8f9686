//! Mahr text profiles: sections in brackets, heights under `[PROFILE_VALUES]`.
//!
//! A point is `index=X Y Z C Lock`, or `index=X Z Lock` of the MarSurf PS 10, lengths in millimetres; a locked point has no
//! height. X and Z carry the offset of the machine. The layout is known from files, not from a definition.

use super::damage::{damaged, height, miscounted};
use super::decimal;
use super::error::ReadFault;
use super::file_dialect::BadHeights;
use super::format::Format;
use super::found::Found;
use super::grid::SpacingSource;
use super::header::FilterState;
use super::lengths::Lengths;
use super::metadata::{Metadata, number, short};
use super::options::LengthUnit;
use super::plain_row::past_end;
use super::text::TextSource;
use asperity_core::quantity::Length;

const FORMAT: Format = Format::MahrText;

/// Reads a Mahr text profile.
pub(super) fn read(text: &mut TextSource<'_>) -> Result<Found, ReadFault> {
    let mut header = MahrHeader::default();
    let (mut x, mut heights) = (Vec::new(), Vec::new());
    let mut first_line = None;
    let mut is_values = false;
    let mut lines = text.lines()?;
    while let Some(line) = lines.next()? {
        let (number, line) = (line.number, line.text.trim());
        if line.starts_with('[') {
            is_values = line == "[PROFILE_VALUES]";
        } else if !is_values {
            header.take(line);
        } else if !line.is_empty() && !line.starts_with("//") {
            let (place, z) = match point(line) {
                Ok(point) => point,
                Err(fault) => {
                    let text = values(line);
                    let bad = text.split_whitespace().find(|text| height(text).is_none());
                    let bad = bad.map(|bad| BadHeights::new(FORMAT, bad, (number, text)));
                    return Err(bad.map_or(fault, |bad| bad.in_all(&mut lines, values)));
                }
            };
            first_line.get_or_insert(number);
            x.push(place);
            heights.push(z);
            let (end, at_hand) = (lines.end(), lines.at_hand());
            let (mut rest, mut count) = (at_hand, 0);
            while let Some((place, z, after)) = plain_point(rest)
                && let Some(after) = past_end(after, end)
            {
                x.push(place);
                heights.push(z);
                (rest, count) = (after, count + 1);
            }
            let passed = at_hand.len() - rest.len();
            lines.pass(count, passed);
        }
    }
    if let Some(stated) = header.points.filter(|stated| *stated != heights.len()) {
        return Err(miscounted(FORMAT, heights.len(), stated));
    }
    // Some programs write only zeros for X.
    let is_constant = x.iter().all(|place| Some(place) == x.first());
    Ok(Found {
        x: (!is_constant).then_some(Lengths::new(x, LengthUnit::Millimetre)),
        spacing: header.interval.map(|dx| {
            (
                Lengths::new(dx, LengthUnit::Millimetre),
                SpacingSource::Header,
            )
        }),
        filter_state: header.state,
        metadata: header.metadata,
        first_line,
        ..Found::new(FORMAT, Lengths::new(heights, LengthUnit::Millimetre))
    })
}

#[derive(Default)]
struct MahrHeader {
    points: Option<usize>,
    interval: Option<f64>,
    state: FilterState,
    metadata: Metadata,
}

impl MahrHeader {
    fn take(&mut self, line: &str) {
        let Some((key, value)) = line.split_once('=') else {
            return;
        };
        let value = value.trim();
        match key.trim() {
            "NAME" => self.metadata.title = short(value),
            "NO_POINTS" => self.points = value.parse().ok(),
            "INTERVAL_LIN" => self.interval = number(value).filter(|dx| *dx > 0.0),
            "PB_RADIUS" => {
                let radius = number(value).filter(|radius| *radius > 0.0);
                self.metadata.stylus_radius =
                    radius.map(|r| Length::from_si(LengthUnit::Millimetre.metres(r)));
            }
            "DateTime" => self.metadata.date = short(value),
            "MachineName" => self.metadata.instrument = short(value),
            "ProductName" => {
                let before = self.metadata.instrument.take();
                self.metadata.instrument = before.or_else(|| short(value));
            }
            "Profile.Type" => {
                self.state = match value.to_lowercase().as_str() {
                    "surface" | "primary" | "p" => FilterState::Primary,
                    "roughness" | "r" => FilterState::Roughness,
                    _ => FilterState::Unknown,
                }
            }
            _ => {}
        }
    }
}

/// X and Z of "index=X Y Z C 0" with plain numbers and single blanks, as for nearly all points, at the start of
/// `bytes`, and the rest.
#[inline]
fn plain_point(bytes: &[u8]) -> Option<(f64, f64, &[u8])> {
    /// Rest after the next `end` on the same line, which must not be the first byte.
    #[inline]
    fn after(bytes: &[u8], end: u8) -> Option<&[u8]> {
        let at = bytes.iter().position(|byte| *byte == end || *byte < b' ')?;
        (at > 0 && bytes[at] == end).then(|| &bytes[at + 1..])
    }
    // Neither the name of a section nor a comment.
    bytes.first().filter(|byte| byte.is_ascii_digit())?;
    let (x, rest) = decimal::prefix(after(bytes, b'=')?, b'.')?;
    let past_y = after(rest.strip_prefix(b" ")?, b' ')?;
    let (z, rest) = decimal::prefix(past_y, b'.')?;
    let lock = after(rest.strip_prefix(b" ")?, b' ')?;
    let rest = lock.strip_prefix(b"0")?;
    (x.is_finite() && z.is_finite()).then_some((x, z, rest))
}

/// The values of a point behind its index.
fn values(line: &str) -> &str {
    line.split_once('=').map_or(line, |(_, values)| values)
}

/// X and Z of "index=X Y Z C Lock" or "index=X Z Lock"; Z is NaN for a locked point.
fn point(line: &str) -> Result<(f64, f64), ReadFault> {
    if let Some((x, z, [])) = plain_point(line.as_bytes()) {
        return Ok((x, z));
    }
    let broken = || damaged(FORMAT, "a point cannot be read", line);
    let (_, values) = line.split_once('=').ok_or_else(broken)?;
    let fields: Vec<&str> = values.split_whitespace().collect();
    let (x, z, lock) = match *fields {
        // A lock is a whole number, a height has decimals.
        [x, z, lock @ ("0" | "1")] => (x, z, Some(lock)),
        [x, _, z, ..] => (x, z, fields.get(4).copied()),
        _ => return Err(broken()),
    };
    let x = number(x).ok_or_else(broken)?;
    let locked = lock.is_some_and(|lock| number(lock).is_some_and(|lock| lock != 0.0));
    let z = if locked {
        f64::NAN
    } else {
        height(z).ok_or_else(broken)?
    };
    Ok((x, z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_in_plain_numbers_read_as_all_others() {
        let plain = |line: &str| match plain_point(line.as_bytes()) {
            Some((x, z, [])) => Some((x, z)),
            _ => None,
        };
        let both = |line: &str| (plain(line), point(line).ok());
        let found = Some((12.5, -0.93));
        assert_eq!(both("7=12.5 0.0 -0.93 0.0 0"), (found, found));
        for spaced in [
            "7=12.5  3.0 -0.93 0.0 0",
            "7=12.5 3.0  -0.93 0.0 0",
            "7= 12.5 3.0 -0.93 0.0 0",
        ] {
            assert_eq!(both(spaced), (None, found), "{spaced}");
        }
        for other in ["[7=12.5 0.0 1 0.0 0", "//7=1 0.0 1 0.0 0", "7\n=1 0 1 0 0"] {
            assert_eq!(plain(other), None, "{other}");
        }
        // Three values: a height and its lock, or X, Y and Z.
        assert_eq!(point("7=12.5 -0.93 0").unwrap(), (12.5, -0.93));
        assert!(point("7=12.5 -0.93 1").unwrap().1.is_nan());
        assert_eq!(point("7=12.5 0.0 -0.93").unwrap(), (12.5, -0.93));
        let locked = point("7=12.5 0.0 -0.93 0.0 1").unwrap();
        assert!(locked.0 == 12.5 && locked.1.is_nan());
        for broken in ["", "=", "7=", "7=1", "7=1 ", "7=1 2", "7=1 2 x3 3 0"] {
            assert!(point(broken).is_err(), "{broken}");
        }
    }
}
