//! Profiles as comma-separated text.

use std::fmt::Write as _;

use super::field::field;
use super::places::Places;
use crate::read::FilterState;
use crate::read::metadata::Metadata;

/// Micrometres of a metre.
const MICROMETRES: f64 = 1e6;

/// Writes x and heights in micrometres, with the spacing of even points and the filters in the header. The heights are in metres
/// where a number of micrometres would not read back to the last bit.
pub(super) fn write(
    places: Places<'_>,
    heights: &[f64],
    metadata: &Metadata,
    filter_state: FilterState,
) -> Vec<u8> {
    let mut text = String::new();
    let mut comment = |name: &str, value: &Option<String>| {
        if let Some(value) = value {
            let line = format!("# {name} = {}", field(value));
            let _ = writeln!(text, "{}", asperity_storage::line_of_cells(&line));
        }
    };
    comment("title", &metadata.title);
    comment("instrument", &metadata.instrument);
    comment("date", &metadata.date);
    // Writing into a string cannot fail.
    if let Some(filter) = filter(metadata, filter_state) {
        let _ = writeln!(text, "# filter: {filter}");
    }
    if let Places::Even(dx) = places {
        let um = micrometres(dx);
        // A spacing that no number of micrometres gives is written in metres.
        let _ = if um / MICROMETRES == dx {
            writeln!(text, "# dx = {um} um")
        } else {
            writeln!(text, "# dx = {dx:e} m")
        };
    }
    let in_um: Option<Vec<f64>> = heights.iter().map(|z| exact_micrometres(*z)).collect();
    let unit = if in_um.is_some() { "um" } else { "m" };
    let _ = writeln!(text, "x [um],z [{unit}]");
    for (i, z) in heights.iter().enumerate() {
        let _ = match places {
            // The spacing above is exact, so x needs no more digits than a reader of the table.
            Places::Even(dx) => write!(text, "{}", rounded(MICROMETRES * (i as f64 * dx))),
            Places::Own(x) => write!(text, "{}", micrometres(x[i])),
        };
        let _ = match &in_um {
            Some(in_um) => writeln!(text, ",{}", in_um[i]),
            None => writeln!(text, ",{z:e}"),
        };
    }
    text.into_bytes()
}

/// "roughness, lambda_c 0.8 mm, lambda_s 2.5 um", of a primary profile the cut-offs that it is to be filtered with; `None` if the state is not
/// known.
fn filter(metadata: &Metadata, state: FilterState) -> Option<String> {
    let name = match state {
        FilterState::Unknown => return None,
        FilterState::Primary => "primary",
        FilterState::Roughness => "roughness",
    };
    let cutoff =
        |name: &str, length: Option<_>| length.map_or(String::new(), |l| format!(", {name} {l}"));
    let cutoffs = cutoff("lambda_c", metadata.lambda_c) + &cutoff("lambda_s", metadata.lambda_s);
    Some(format!("{name}{cutoffs}"))
}

/// The number of micrometres with the fewest digits that a reader converts to `metres`; `None` if there is none: the
/// division by a million skips one number of twenty.
fn exact_micrometres(metres: f64) -> Option<f64> {
    let near = metres * MICROMETRES;
    let candidates = [near, near.next_up(), near.next_down()];
    let exact = candidates
        .into_iter()
        .filter(|um| um / MICROMETRES == metres);
    let digits = |um: &f64| um.to_string().len();
    exact.min_by_key(digits)
}

/// Micrometres of a length in metres, rounded if no number is exact.
fn micrometres(metres: f64) -> f64 {
    exact_micrometres(metres).unwrap_or(metres * MICROMETRES)
}

/// `value` to twelve digits.
fn rounded(value: f64) -> f64 {
    const DIGITS: i32 = 12;
    if value == 0.0 || !value.is_finite() {
        return value;
    }
    let scale = 10f64.powi(DIGITS - 1 - value.abs().log10().floor() as i32);
    (value * scale).round() / scale
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn micrometres_have_the_digits_of_the_file_they_came_from() {
        for um in [0.2796, -1.5, 0.0001, 106_000.123, 0.1 + 0.2, 0.0] {
            assert_eq!(micrometres(um / MICROMETRES), um);
        }
        let odd = micrometres(6.407_687_859_264_384e-9);
        assert!((odd / MICROMETRES / 6.407_687_859_264_384e-9 - 1.0).abs() < f64::EPSILON);
        assert_eq!(rounded(1.500_000_000_000_000_2), 1.5);
    }
}
