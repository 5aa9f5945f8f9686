//! Comparison of the number of points stated in the header of a text file with the number of heights.
//!
//! If there are more heights than stated, another number was read as a height, for example the number of a trace before
//! its heights. If there are fewer, the trace was aborted or the file is truncated.

use super::error::ReadFault;
use super::format::Format;
use super::metadata::short;
use super::text::Line;
use crate::warning::Warning;

/// Labels of the number of points of one trace, in lower case without punctuation.
const LABELS: [&str; 20] = [
    "points",
    "number of points",
    "no of points",
    "num points",
    "numpoints",
    "data points",
    "number of data points",
    "num data points",
    "points per trace",
    "number of points per trace",
    "points per line",
    "points per profile",
    "points per scan",
    "samples",
    "number of samples",
    "samples per trace",
    "punkte",
    "anzahl punkte",
    "messpunkte",
    "anzahl messpunkte",
];

/// Compares the number `heights` of heights of a trace with the number in `header`.
///
/// # Errors
/// When there are more heights than stated.
pub(super) fn check(
    format: Format,
    header: &[Line<'_>],
    heights: usize,
) -> Result<Option<Warning>, ReadFault> {
    let Some((line, stated)) = points(header) else {
        return Ok(None);
    };
    if heights > stated {
        return Err(ReadFault::damaged(
            format,
            "more heights than its header states, so that a number is none of them",
            &format!(
                "line {}: {}, {heights} read",
                line.number,
                short(line.text).unwrap_or_default()
            ),
        ));
    }
    Ok((heights < stated).then_some(Warning::FewerHeights { stated, heights }))
}

/// The line of the header that states a number of points, and the number.
pub(super) fn points<'a, 'l>(header: &'a [Line<'l>]) -> Option<(&'a Line<'l>, usize)> {
    header.iter().find_map(stated)
}

/// The line and its number of points, if it states one.
fn stated<'a, 'l>(line: &'a Line<'l>) -> Option<(&'a Line<'l>, usize)> {
    let text = line.text.trim_end_matches([' ', '\t', ';', ',']);
    let before = text.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = &text[before.len()..];
    let words = before.split(|c: char| !c.is_alphabetic());
    let label: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    if before.contains(|c: char| c.is_ascii_digit()) {
        return None;
    }
    let is_known = LABELS.contains(&label.join(" ").to_lowercase().as_str());
    Some((line, number.parse().ok().filter(|_| is_known)?))
}

#[cfg(test)]
mod tests {
    use super::super::text::Head;
    use super::*;

    #[test]
    fn a_number_of_points_is_found_behind_its_label_only() {
        for (text, expected) in [
            ("Points per trace\t4000", Some(4000)),
            ("# Number of points: 12", Some(12)),
            ("No. of points = 7;", Some(7)),
            ("POINTS,8000,", Some(8000)),
            ("Points 4000 of trace 3", None),
            ("Trace 12", None),
            ("Points per trace 1.5", None),
            ("Points", None),
            ("µ", None),
            ("µ12", None),
            ("12", None),
            ("", None),
        ] {
            let head = Head::from_text(text);
            let found = head.lines().find_map(|line| Some(stated(&line)?.1));
            assert_eq!(found, expected, "{text}");
        }
    }
}
