//! Values that lines of a header state by name: spacing, size, unit of the heights, base radius, filter.

use asperity_core::quantity::Length;

use super::header::{self, FilterState, Role, StatedHeader};
use super::metadata;
use super::options::LengthUnit;
use super::text::Line;

/// Names of the distance between two points, in lower case, with blanks instead of other marks.
const SPACING: [&str; 43] = [
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
    "x pitch",
    "scale x",
    "lateral resolution",
    "pixel size",
    // Profilm.
    "pixelsize",
    "pixel pitch",
    "x pixel size",
    "xy calibration",
    "xy spacing",
    "schrittweite",
    "punktabstand",
    "messpunktabstand",
    // Keyence in German and Japanese, Mitutoyo.
    "xy justierung",
    "xyキャリブレーション",
    "pitch x",
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
/// Names of the distance between two rows.
const ROW_SPACING: [&str; 9] = [
    "dy",
    "delta y",
    "y spacing",
    "y step",
    "y increment",
    "y resolution",
    "y pitch",
    "pitch y",
    "scale y",
];
/// Names of the sides of a matrix: Gwyddion in all its languages, SPIP.
const WIDTH: [&str; 11] = [
    "width",
    "breite",
    "largeur",
    "anchura",
    "larghezza",
    "largura",
    "šířka",
    "ширина",
    "幅",
    "폭",
    "x length",
];
const HEIGHT: [&str; 10] = [
    "height",
    "höhe",
    "hauteur",
    "altura",
    "altezza",
    "výška",
    "высота",
    "高さ",
    "높이",
    "y length",
];
/// Names of the numbers of points of a row and of rows: SPIP, Profilm, Nova, holographic microscopes.
const COLUMNS: [&str; 4] = ["x pixels", "numcols", "nx", "w"];
const ROWS: [&str; 4] = ["y pixels", "numrows", "ny", "h"];
/// Names of the length that one in the numbers of a matrix is: holographic microscopes, SPIP in nanometres.
const SCALE: &str = "height conversion factor";
const SCALE_IN_NANOMETRES: &str = "bit2nm";
/// Names of the unit of lengths that are stated without one.
const LATERAL_UNIT: [&str; 4] = ["x unit", "unit x", "xy unit", "lateral unit"];
/// First line of SPIP ASCII, whose sides are in nanometres.
const SPIP: &str = "File Format = ASCII";
/// Names of the unit of heights: Gwyddion in all its languages, Bruker NanoScope, Keyence, Nova, holographic microscopes.
const UNIT: [&str; 26] = [
    "unit",
    "einheit",
    "value units",
    "werteinheiten",
    "einheiten",
    "unités",
    "unità valore",
    "unidades de valor",
    "jednotky hodnot",
    "единицы измерения",
    "値の単位",
    "값 단위",
    "exported image units",
    "data unit",
    "data units",
    "unit data",
    "z unit",
    "z units",
    "height unit",
    "height units",
    "unité",
    "unidad",
    "unità",
    "unidade",
    "単位",
    "单位",
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
    /// Distance between rows \[m\].
    row_spacing: Option<f64>,
    /// Length of the rows and columns of a matrix \[m\].
    sides: [Option<f64>; 2],
    /// Numbers of columns and rows of a matrix.
    sizes: [Option<usize>; 2],
    /// Units of spacings and of sides without one.
    lateral: Option<LengthUnit>,
    lateral_of_sides: Option<LengthUnit>,
    /// Unit of the heights.
    pub z_unit: Option<StatedHeader>,
    /// Length that one in the numbers of a matrix is \[m\].
    scale: Option<f64>,
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
    pub(super) fn from_header<'l>(header: &[Line<'l>]) -> Self {
        let mut values = Self::default();
        let text = |line: &Line<'l>| {
            let marks = ['#', '%', '/', '*', '!', '\\', ' ', '"'];
            line.text.trim_start_matches(marks)
        };
        let texts = header.iter().map(text);
        let stated: Vec<(&str, String)> = texts
            .clone()
            .flat_map(statements)
            .filter_map(stated)
            .collect();
        let names = texts.clone().zip(texts.clone().skip(1));
        let below: Vec<_> = names
            .flat_map(|(above, below)| named_above(above, below))
            .collect();
        let all = || stated.iter().chain(&below);
        for (_, unit) in all().filter(|(key, _)| LATERAL_UNIT.contains(&name(key).as_str())) {
            values.lateral = values.lateral.or_else(|| header::unit(unit));
        }
        let is_spip = texts.clone().next().is_some_and(|first| first == SPIP);
        let of_sides = is_spip.then_some(LengthUnit::Nanometre);
        values.lateral_of_sides = values.lateral.or(of_sides);
        for (key, value) in all() {
            values.take(key, value);
        }
        // A line with the name and the unit of the heights.
        let is_name = |c: char| !c.is_ascii_digit() && !"=:;\t".contains(c);
        let is_heights =
            |text: &&str| header::role_of(text) == Some(Role::Z) && text.chars().all(is_name);
        let of_heights = texts.filter(is_heights).find_map(header::unit_of);
        values.z_unit = values.z_unit.or(of_heights);
        values
    }

    fn take(&mut self, key: &str, value: &str) {
        let name = name(key);
        let is = |names: &[&str]| names.contains(&name.as_str());
        let lateral = if is(&WIDTH) || is(&HEIGHT) {
            self.lateral_of_sides
        } else {
            self.lateral
        };
        let length = || length(key, value, lateral);
        let count = || metadata::number(value).filter(|n| *n >= 1.0 && n.fract() == 0.0);
        match () {
            () if is(&SPACING) => self.spacing = self.spacing.or_else(length),
            () if is(&ROW_SPACING) => self.row_spacing = self.row_spacing.or_else(length),
            () if is(&COLUMNS) => self.sizes[0] = count().map(|n| n as usize),
            () if is(&ROWS) => self.sizes[1] = count().map(|n| n as usize),
            () if is(&WIDTH) => self.sides[0] = self.sides[0].or_else(length),
            () if is(&HEIGHT) => self.sides[1] = self.sides[1].or_else(length),
            () if is(&BASE_RADIUS) => self.base_radius = length().map(Length::from_si),
            () if is(&BASE_DIAMETER) => {
                self.base_radius = length().map(|d| Length::from_si(0.5 * d));
            }
            () if is(&UNIT) => {
                self.z_unit = header::unit(value)
                    .map(StatedHeader::Length)
                    .or_else(|| (!value.is_empty()).then(|| StatedHeader::Other(value.to_owned())))
            }
            () if name == SCALE => self.scale = self::length(&key.replace("->", ""), value, None),
            () if name == SCALE_IN_NANOMETRES => {
                self.scale = self::length(key, value, Some(LengthUnit::Nanometre));
            }
            () if name == FILTER => self.filter = filter(value),
            () => {}
        }
    }

    /// Spacings along the rows and columns of a matrix of `columns` by `rows` heights \[m\].
    pub(super) fn spacings(&self, columns: usize, rows: usize) -> [Option<f64>; 2] {
        let part = |axis: usize, count: usize| {
            let count = self.sizes[axis].unwrap_or(count).max(1);
            self.sides[axis].map(|side| side / count as f64)
        };
        [
            part(0, columns).or(self.spacing),
            part(1, rows).or(self.row_spacing).or(self.spacing),
        ]
    }

    /// Length that one in the heights of a matrix is \[m\], unless they have a unit of length.
    pub(super) fn scale(&self) -> Option<f64> {
        let has_unit = matches!(self.z_unit, Some(StatedHeader::Length(_)));
        self.scale.filter(|_| !has_unit)
    }

    /// Whether the header belongs to a matrix of heights whose lines have this number of columns.
    pub(super) fn are_of_matrix(&self, columns: usize) -> bool {
        let is_stated = self.size().is_some_and(|[stated, _]| stated == columns);
        let is_of_gwyddion = self.z_unit.is_some() && self.sides[0].is_some();
        columns > 2 && (is_stated || is_of_gwyddion) || self.is_wrapped(columns)
    }

    /// Stated numbers of columns and rows of a matrix.
    pub(super) fn size(&self) -> Option<[usize; 2]> {
        let [columns, rows] = self.sizes;
        Some([columns?, rows?])
    }

    /// Whether the lines, with this number of columns, are not the rows of the stated size; two or three columns are positions
    /// with heights.
    pub(super) fn is_wrapped(&self, columns: usize) -> bool {
        self.size().is_some_and(|[stated, rows]| {
            stated != columns && stated > 2 && (columns > 3 || columns == 1 && rows > 1)
        })
    }
}

/// The statements of a line: each word of "h=650 w=650", or the line.
fn statements(text: &str) -> Vec<&str> {
    let words: Vec<&str> = text.split_whitespace().collect();
    let is_statement = |word: &&str| {
        let parts = word.split_once('=');
        parts.is_some_and(|(key, value)| !key.is_empty() && !value.is_empty())
    };
    if words.len() > 1 && words.iter().all(is_statement) {
        words
    } else {
        vec![text]
    }
}

/// Name and value of a line, whose value may be in several cells, number and unit for example.
fn stated(text: &str) -> Option<(&str, String)> {
    let (key, value) = text.split_once(['=', ':', '：', '\t', ';', ','])?;
    let has_commas = text[key.len()..].starts_with(',');
    let cells = value
        .split(|c: char| "\t;\"".contains(c) || has_commas && c == ',')
        .map(|cell| cell.trim_matches([' ', ',']));
    let cells: Vec<&str> = cells.filter(|cell| !cell.is_empty()).collect();
    Some((key, cells.join(" ")))
}

/// Names and values of a line of names above a line of numbers, separated by tabs.
fn named_above<'l>(above: &'l str, below: &'l str) -> Vec<(&'l str, String)> {
    let [names, values] = [above, below].map(|line| line.split('\t').collect::<Vec<_>>());
    let is_number = |cell: &&str| metadata::number(cell).is_some();
    let fits = names.len() > 1 && names.len() == values.len();
    if fits && values.iter().all(is_number) && !names.iter().any(is_number) {
        names
            .into_iter()
            .zip(values.into_iter().map(str::to_owned))
            .collect()
    } else {
        Vec::new()
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

/// A positive length \[m\] with its unit behind the number or in the name, or in the unit of lengths without one.
fn length(key: &str, value: &str, lateral: Option<LengthUnit>) -> Option<f64> {
    let number = || match header::unit_of(key.trim_matches([' ', '"'])) {
        Some(StatedHeader::Length(unit)) => Some(unit.metres(metadata::number(value)?)),
        Some(StatedHeader::Other(_)) => None,
        None => Some(lateral?.metres(metadata::number(value)?)),
    };
    let length = metadata::length(value).map(Length::si).or_else(number)?;
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
        let head = Head::from_text(text);
        let lines: Vec<_> = head.lines().collect();
        HeaderValues::from_header(&lines)
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
    fn a_gwyddion_header_gives_both_spacings_and_the_unit_in_any_language() {
        for text in [
            "# Channel: a\n# Width: 12 µm\n# Height: 6000 nm\n# Value units: nm",
            "# Kanal: a\n# Breite: 12 µm\n# Höhe: 6000 nm\n# Value units: nm",
            "# Canal : a\n# Largeur : 12 µm\n# Hauteur : 6000 nm\n# Unités : nm",
            "# チャネル：a\n# 幅：12 µm\n# 高さ：6000 nm\n# 値の単位：nm",
            "# Канал: a\n# Ширина: 12 µm\n# Высота: 6000 nm\n# Единицы измерения: nm",
        ] {
            let values = of(text);
            let [x, y] = values.spacings(24, 12).map(Option::unwrap);
            assert!((x / 0.5e-6 - 1.0).abs() < 1e-12 && (y / 0.5e-6 - 1.0).abs() < 1e-12);
            assert_eq!(
                values.z_unit,
                Some(StatedHeader::Length(LengthUnit::Nanometre))
            );
            assert!(values.are_of_matrix(24));
        }
        let bruker = of("\\Exported image units: nm");
        assert_eq!(
            bruker.z_unit,
            Some(StatedHeader::Length(LengthUnit::Nanometre))
        );
        let keyence = of("\"Output image data\",\"Height\"\n\"Unit\",\"um\"");
        assert_eq!(
            keyence.z_unit,
            Some(StatedHeader::Length(LengthUnit::Micrometre))
        );
        let radians = of("# Width: 1 um\n# Value units: rad");
        assert_eq!(radians.z_unit, Some(StatedHeader::Other("rad".into())));
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
