//! Values that lines of a header state by name: spacing, size, unit of the heights, base radius, filter.

use asperity_core::quantity::Length;

use super::error::ReadFault;
use super::header::{self, FilterState, Stated};
use super::metadata;
use super::options::{Axis, LengthUnit};
use super::text::Line;

/// Names of the distance between two points, in lower case, with blanks instead of other marks.
const SPACING: [&str; 37] = [
    "dx",
    "delta x",
    "spacing",
    "x spacing",
    "point spacing",
    "point distance",
    "sample spacing",
    "sample distance",
    "sample interval",
    "sampling interval",
    "sampling distance",
    "sampling step",
    "step",
    "step size",
    "x step",
    "increment",
    "x increment",
    "x resolution",
    "lateral resolution",
    "pixel size",
    "x pixel size",
    "xy calibration",
    "xy spacing",
    "schrittweite",
    "punktabstand",
    "messpunktabstand",
    // Keyence in German, Mitutoyo.
    "xy justierung",
    "pitch",
    "pas",
    "pas d échantillonnage",
    "paso",
    "paso de muestreo",
    "espaciado",
    "passo",
    "passo di campionamento",
    "espaçamento",
    "passo de amostragem",
];
/// Names of the sides of a matrix: Gwyddion in English and German.
const WIDTH: [&str; 2] = ["width", "breite"];
const HEIGHT: [&str; 2] = ["height", "höhe"];
/// Names of the unit of heights: Gwyddion, Bruker NanoScope, Keyence.
const UNIT: [&str; 14] = [
    "unit",
    "einheit",
    "value units",
    "werteinheiten",
    "exported image units",
    "data units",
    "z unit",
    "z units",
    "height unit",
    "height units",
    "unité",
    "unidad",
    "unità",
    "unidade",
];
const BASE_DIAMETER: [&str; 5] = [
    "base diameter",
    "base circle diameter",
    "d b",
    "db",
    "grundkreisdurchmesser",
];
const BASE_RADIUS: [&str; 5] = [
    "base radius",
    "base circle radius",
    "r b",
    "rb",
    "grundkreisradius",
];
/// Name of the filter state in the files of this program.
const FILTER: &str = "filter";

/// Values of the header; `None` for those that it does not state.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct HeaderValues {
    /// Distance between points \[m\].
    pub spacing: Option<f64>,
    /// Length of the rows and columns of a matrix \[m\].
    pub sides: [Option<f64>; 2],
    /// Unit of the heights.
    pub z_unit: Option<Stated>,
    /// Base radius of the gear.
    pub base_radius: Option<Length>,
    /// Filters of the heights.
    pub filter: Option<Filter>,
}

/// The filters that a written profile has passed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Filter {
    pub state: FilterState,
    pub lambda_c: Option<Length>,
    pub lambda_s: Option<Length>,
}

impl HeaderValues {
    /// The values of the lines above a table.
    pub(super) fn of(header: &[Line<'_>]) -> Self {
        let mut values = Self::default();
        for line in header {
            let text = line
                .text
                .trim_start_matches(['#', '%', '/', '*', '!', '\\', ' ', '"']);
            if let Some((key, value)) = text.split_once(['=', ':', '\t', ';', ',']) {
                // Number and unit may be cells of their own.
                let has_commas = text[key.len()..].starts_with(',');
                let cells = value
                    .split(|c: char| "\t;\"".contains(c) || has_commas && c == ',')
                    .map(|cell| cell.trim_matches([' ', ',']));
                let cells: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
                values.take(key, &cells.join(" "));
            }
        }
        values
    }

    fn take(&mut self, key: &str, value: &str) {
        let name = name(key);
        let is = |names: &[&str]| names.contains(&name.as_str());
        let length = || length(key, value);
        match () {
            () if is(&SPACING) => self.spacing = self.spacing.or_else(length),
            () if is(&WIDTH) => self.sides[0] = self.sides[0].or_else(length),
            () if is(&HEIGHT) => self.sides[1] = self.sides[1].or_else(length),
            () if is(&BASE_RADIUS) => self.base_radius = length().map(Length::from_si),
            () if is(&BASE_DIAMETER) => {
                self.base_radius = length().map(|d| Length::from_si(0.5 * d));
            }
            () if is(&UNIT) => {
                self.z_unit = header::unit(value)
                    .map(Stated::Length)
                    .or_else(|| (!value.is_empty()).then(|| Stated::Other(value.to_owned())))
            }
            () if name == FILTER => self.filter = filter(value),
            () => {}
        }
    }

    /// The unit of the heights.
    pub(super) fn unit(&self) -> Result<Option<LengthUnit>, ReadFault> {
        let stated = self.z_unit.as_ref();
        stated.map(|unit| unit.length(Axis::Height)).transpose()
    }

    /// Spacings along the rows and columns of a matrix of `columns` by `rows` heights \[m\].
    pub(super) fn spacings(&self, columns: usize, rows: usize) -> [Option<f64>; 2] {
        let part = |side: Option<f64>, count: usize| side.map(|side| side / count.max(1) as f64);
        [
            part(self.sides[0], columns).or(self.spacing),
            part(self.sides[1], rows).or(self.spacing),
        ]
    }

    /// Whether the header belongs to a matrix of heights.
    pub(super) fn is_of_matrix(&self) -> bool {
        self.z_unit.is_some() && self.sides[0].is_some()
    }
}

/// A name without its unit, in lower case, with single blanks.
fn name(key: &str) -> String {
    let lower = key.trim_matches([' ', '"']).to_lowercase();
    let before = lower.split(['[', '(']).next().unwrap_or_default();
    let before = before.split(" in ").next().unwrap_or_default();
    let words = before.split(|c: char| !c.is_alphanumeric());
    let mut words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    // "dx_um"
    if words.len() > 1
        && words
            .last()
            .is_some_and(|last| header::unit(last).is_some())
    {
        words.pop();
    }
    words.join(" ")
}

/// A positive length \[m\] with its unit behind the number or in the name.
fn length(key: &str, value: &str) -> Option<f64> {
    let in_key = || match header::unit_of(key.trim_matches([' ', '"']))? {
        Stated::Length(unit) => Some(unit.metres(metadata::number(value)?)),
        Stated::Other(_) => None,
    };
    let length = metadata::length(value).map(Length::si).or_else(in_key)?;
    (length.is_finite() && length > 0.0).then_some(length)
}

/// The filters of "roughness, lambda_c 0.8 mm, lambda_s 2.5 um".
fn filter(value: &str) -> Option<Filter> {
    let mut parts = value.split(',').map(str::trim);
    let state = match parts.next()? {
        "roughness" => FilterState::Roughness,
        "primary" => FilterState::Primary,
        _ => return None,
    };
    let mut filter = Filter {
        state,
        lambda_c: None,
        lambda_s: None,
    };
    for part in parts {
        match part.split_once(' ') {
            Some(("lambda_c", length)) => filter.lambda_c = metadata::length(length),
            Some(("lambda_s", length)) => filter.lambda_s = metadata::length(length),
            _ => {}
        }
    }
    Some(filter)
}

#[cfg(test)]
mod tests {
    use super::super::options::LengthUnit;
    use super::super::text::Head;
    use super::*;

    fn of(text: &str) -> HeaderValues {
        let head = Head::of(text);
        let lines: Vec<_> = head.lines().collect();
        HeaderValues::of(&lines)
    }

    #[test]
    fn spacings_are_found_in_every_spelling() {
        for text in [
            "# dx = 0.5 um",
            "dx_um;0.5",
            "X-Resolution: 0.5 µm",
            "\"Sampling interval [mm]\"\t0.0005",
            "% Punktabstand in um: 0,5",
            "// Step size (nm): 500",
            "\"XY Calibration\",\"0.5\",\"um\"",
            "dx;0,0005;mm",
        ] {
            let spacing = of(text).spacing.unwrap_or_else(|| panic!("{text}"));
            assert!((spacing / 0.5e-6 - 1.0).abs() < 1e-12, "{text}");
        }
        for text in ["X-Resolution: 1024", "dx = -1 um", "dx", "spacing: fine"] {
            assert_eq!(of(text).spacing, None, "{text}");
        }
    }

    #[test]
    fn a_gwyddion_header_gives_both_spacings_and_the_unit() {
        for text in [
            "# Channel: a\n# Width: 12 µm\n# Height: 6000 nm\n# Value units: nm",
            "# Kanal: a\n# Breite: 12 µm\n# Höhe: 6000 nm\n# Value units: nm",
        ] {
            let values = of(text);
            let [x, y] = values.spacings(24, 12).map(Option::unwrap);
            assert!((x / 0.5e-6 - 1.0).abs() < 1e-12 && (y / 0.5e-6 - 1.0).abs() < 1e-12);
            assert_eq!(values.z_unit, Some(Stated::Length(LengthUnit::Nanometre)));
            assert!(values.is_of_matrix());
        }
        let bruker = of("\\Exported image units: nm");
        assert_eq!(bruker.z_unit, Some(Stated::Length(LengthUnit::Nanometre)));
        let keyence = of("\"Output image data\",\"Height\"\n\"Unit\",\"um\"");
        assert_eq!(keyence.z_unit, Some(Stated::Length(LengthUnit::Micrometre)));
        let radians = of("# Width: 1 um\n# Value units: rad");
        assert_eq!(radians.z_unit, Some(Stated::Other("rad".into())));
    }

    #[test]
    fn base_circle_and_filter_are_found() {
        let radius = Some(Length::from_si(50e-3));
        assert_eq!(of("# Base diameter = 100 mm").base_radius, radius);
        assert_eq!(of("r_b [mm];50").base_radius, radius);
        let filter = of("# filter: roughness, lambda_c 0.8 mm, lambda_s 2.5 um").filter;
        assert_eq!(
            filter,
            Some(Filter {
                state: FilterState::Roughness,
                lambda_c: Some(Length::from_si(0.8e-3)),
                lambda_s: Some(Length::from_si(2.5e-6)),
            })
        );
    }
}
