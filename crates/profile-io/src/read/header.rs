//! Header lines of a table: quantity and unit of each column, and the filter state.

use serde::{Deserialize, Serialize};

use super::error::{ReadFault, shortened};
use super::format::extension;
use super::layout::Dialect;
use super::metadata;
use super::options::{Abscissa, Axis, LengthUnit, ReadOptions};
use super::text::Line;

/// Whether the heights are filtered, according to the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum FilterState {
    /// Not stated in the file.
    #[default]
    Unknown,
    /// Primary or unfiltered profile.
    Primary,
    /// Roughness profile, without the long waves.
    Roughness,
}

/// Quantity in a column, by its label.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    X,
    /// Column y: the height, unless another column is named z.
    Y,
    Z,
    /// 1 where the height is valid.
    Valid,
    /// A running number.
    Index,
    /// x of an involute checker.
    Roll(Abscissa),
}

/// A unit stated in a header.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum StatedHeader {
    Length(LengthUnit),
    /// Text in brackets that is not a known unit of length.
    Other(String),
}

impl StatedHeader {
    /// The unit of length of `axis`.
    pub(super) fn length(&self, axis: Axis) -> Result<LengthUnit, ReadFault> {
        match self {
            Self::Length(unit) => Ok(*unit),
            Self::Other(unit) => Err(ReadFault::unknown_unit(axis, &shortened(unit))),
        }
    }
}

/// The unit that a file states for an axis; an unknown one is an error unless `options` state the unit.
pub(super) fn unit_of_file(
    found: Option<&StatedHeader>,
    axis: Axis,
    options: &ReadOptions,
) -> Result<Option<LengthUnit>, ReadFault> {
    match found {
        Some(StatedHeader::Other(_)) if options.unit(axis).is_some() => Ok(None),
        found => found.map(|unit| unit.length(axis)).transpose(),
    }
}

/// Label of a column in the header.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Label {
    /// As it is written in the last line that has a text for the column.
    pub text: String,
    pub role: Option<Role>,
    pub unit: Option<StatedHeader>,
    /// Whether the values are named depths.
    pub is_depth: bool,
}

/// Whether `name` is the name of values that grow into the material: of depths ("Depth", "z_depth [um]", "Profiltiefe") or of
/// distances from a sensor. A name with a number states a value, and a roughness depth is Rz.
pub(super) fn is_depth(name: &str) -> bool {
    const DEPTH: &[&str] = &[
        "depth",
        "depths",
        "tiefe",
        "tiefen",
        "profondeur",
        "profondeurs",
        "profondità",
        "profondita",
        "profundidad",
        "profundidade",
        "diepte",
        "djup",
        "dybde",
        "syvyys",
        "hloubka",
        "głębokość",
        "glebokosc",
        "mélység",
        "melyseg",
        "derinlik",
        "глубина",
        "深さ",
        "深度",
        "깊이",
    ];
    const ROUGHNESS: &[&str] = &["rough", "rauh", "raut", "rugos"];
    const DISTANCE: &[&str] = &[
        "distan",
        "abstand",
        "entfernung",
        "afstand",
        "avstånd",
        "gap",
        "距離",
        "距离",
    ];
    const SENSOR: &[&str] = &[
        "sensor",
        "probe",
        "objective",
        "lens",
        "working",
        "kopf",
        "objektiv",
        "arbeits",
        "luft",
        "air",
        "capteur",
        "palpeur",
        "sonde",
        "sonda",
        "センサ",
        "传感",
    ];
    let lower = name.to_lowercase();
    let before = lower.split(['[', '(']).next().unwrap_or_default();
    let is_value = before.contains(|c: char| c.is_ascii_digit());
    let mut words = before.split(|c: char| !c.is_alphabetic());
    let names_any = |roots: &[&str]| roots.iter().any(|root| before.contains(root));
    let is_of_sensor =
        names_any(&["standoff", "stand-off"]) || (names_any(DISTANCE) && names_any(SENSOR));
    let is_depth = words.any(|word| DEPTH.iter().any(|depth| word.ends_with(depth)));
    !is_value && !names_any(ROUGHNESS) && (is_of_sensor || is_depth)
}

/// The labels of the columns, from at most the last four header lines.
pub(super) fn labels(header: &[Line<'_>], dialect: Dialect, columns: usize) -> Vec<Label> {
    const LINES_LOOKED_AT: usize = 4;
    let mut labels = vec![Label::default(); columns];
    // The unit of a stated length, as in "dx = 0.5 mm", is not that of a column.
    let is_length = |line: &&Line<'_>| {
        let value = line.text.split_once(['=', ':']);
        value.is_some_and(|(_, value)| metadata::length(value).is_some())
    };
    let lines = header.iter().rev().take(LINES_LOOKED_AT);
    for line in lines.filter(|line| !is_length(line)) {
        let text = line.text.trim_start_matches(['#', '%', '/', '*', '!', ' ']);
        let mut cells: Vec<&str> = dialect.cells(text).collect();
        while cells.len() > columns && cells.last().is_some_and(|cell| cell.is_empty()) {
            cells.pop();
        }
        if cells.len() != columns {
            // Labels of several words stand further apart than their words.
            let apart = text.split(['\t']).flat_map(|part| part.split("  "));
            let apart: Vec<&str> = apart
                .map(str::trim)
                .filter(|cell| !cell.is_empty())
                .collect();
            if apart.len() == columns && columns > 1 {
                cells = apart;
            }
        }
        if cells.len() == columns {
            for (label, cell) in labels.iter_mut().zip(&cells) {
                if label.text.is_empty() {
                    label.text = (*cell).to_owned();
                }
                if label.role.is_none() {
                    label.role = role_of(cell);
                    label.is_depth = is_depth(cell);
                }
                label.unit = label.unit.take().or_else(|| unit_of(cell));
            }
        } else {
            // "x [mm]  z [um]" over blank-separated columns has more cells than columns.
            let units = units_in_order(text);
            if units.len() == columns {
                for (label, unit) in labels.iter_mut().zip(units) {
                    label.unit = label.unit.take().or(Some(unit));
                }
                if let [_, label] = &mut labels[..] {
                    label.is_depth |= is_depth(text);
                }
            }
        }
    }
    // "# Roll length in mm" on a line of its own.
    if columns == 2 && labels.iter().all(|label| label.role.is_none()) {
        let is_name = |line: &&Line<'_>| !line.text.contains(|c: char| c.is_ascii_digit());
        for line in header.iter().filter(is_name) {
            if let Some(abscissa) = roll(&line.text.to_lowercase()) {
                labels[0].role = Some(Role::Roll(abscissa));
                labels[0].unit = labels[0].unit.take().or_else(|| unit_of(line.text));
            }
        }
    }
    labels
}

pub(super) fn role_of(cell: &str) -> Option<Role> {
    const X: &[&str] = &[
        "x",
        "weg",
        "distance",
        "position",
        "pos",
        "lateral",
        "strecke",
        "taststrecke",
        "length",
        "abscissa",
        "scan",
        "abscisse",
        "longueur",
        "distancia",
        "posición",
        "posicion",
        "longitud",
        "distância",
        "posição",
        "distanza",
        "posizione",
        "lunghezza",
        "afstand",
        "positie",
        "avstånd",
        "avstand",
        "matka",
        "etäisyys",
        "vzdálenost",
        "poloha",
        "odległość",
        "pozycja",
        "távolság",
        "mesafe",
        "расстояние",
        "距離",
        "距离",
        "거리",
    ];
    const Z: &[&str] = &[
        "z",
        "height",
        "heights",
        "altitude",
        "höhe",
        "hoehe",
        "profil",
        "profile",
        "altura",
        "hauteur",
        "amplitude",
        "altezza",
        "quota",
        "hoogte",
        "höjd",
        "højde",
        "høyde",
        "korkeus",
        "výška",
        "wysokość",
        "magasság",
        "yükseklik",
        "высота",
        "高さ",
        "高度",
        "높이",
    ];
    const VALID: &[&str] = &["valid", "lock", "flag", "mask", "gültig", "quality"];
    const INDEX: &[&str] = &["index", "idx", "nr", "no", "n", "i", "point", "punkt", "#"];
    let lower = cell.to_lowercase();
    let name: String = lower
        .chars()
        .take_while(|c| c.is_alphabetic() || *c == '#')
        .collect();
    let is = |names: &[&str]| names.contains(&name.as_str());
    if let Some(abscissa) = roll(&lower) {
        return Some(Role::Roll(abscissa));
    }
    match () {
        () if is_depth(&lower) => Some(Role::Z),
        () if is(X) => Some(Role::X),
        () if is(Z) => Some(Role::Z),
        () if name == "y" => Some(Role::Y),
        () if is(VALID) || lower.contains("[1/0]") => Some(Role::Valid),
        () if is(INDEX) => Some(Role::Index),
        () => None,
    }
}

/// Roll length or roll angle by the words of a label.
fn roll(label: &str) -> Option<Abscissa> {
    const LENGTHS: &[&str] = &[
        "roll length",
        "rolllength",
        "rolling length",
        "roll path",
        "length of roll",
        "wälzlänge",
        "waelzlaenge",
        "wälzweg",
        "waelzweg",
    ];
    const ANGLES: &[&str] = &[
        "roll angle",
        "rollangle",
        "rolling angle",
        "angle of roll",
        "wälzwinkel",
        "waelzwinkel",
    ];
    let label = label.replace(['_', '-'], " ");
    let says = |words: &[&str]| words.iter().any(|word| label.contains(word));
    match () {
        () if says(LENGTHS) => Some(Abscissa::RollLength),
        () if says(ANGLES) && label.contains("rad") => Some(Abscissa::RollRadians),
        () if says(ANGLES) => Some(Abscissa::RollDegrees),
        () => None,
    }
}

/// The unit in a label: "[mm]", "(um)", "x in um", "x_mm", "z / nm", "z µm", "mm".
pub(super) fn unit_of(cell: &str) -> Option<StatedHeader> {
    let opening = cell.rfind(['[', '(']);
    if let Some(at) = opening {
        let inside = cell[at + 1..].trim_end_matches([']', ')', ' ']);
        if matches!(inside, "in" | "\"") {
            return Some(StatedHeader::Length(LengthUnit::Inch));
        }
        let is_unit =
            inside.chars().next().is_some_and(char::is_alphabetic) || inside.starts_with('"');
        return match unit(inside) {
            Some(unit) => Some(StatedHeader::Length(unit)),
            None if is_unit => Some(StatedHeader::Other(inside.to_owned())),
            None => None,
        };
    }
    let (before, last) = match cell.rfind([' ', '_', '/', ':', '=']) {
        Some(at) => (cell[..at].trim_end(), &cell[at + 1..]),
        None => ("", cell),
    };
    let unit = unit(last)?;
    // A lone "m" after a blank may be any word's initial; after "in", "_" or "/" it is metre.
    let certain = unit != LengthUnit::Metre
        || before.is_empty()
        || before.to_lowercase().ends_with(" in")
        || cell.contains(['_', '/']);
    certain.then_some(StatedHeader::Length(unit))
}

/// All units of a line, in order: in brackets, or after the word "in".
fn units_in_order(line: &str) -> Vec<StatedHeader> {
    let mut units = Vec::new();
    let mut after_in = false;
    for word in line
        .split([' ', '\t', ';', ','])
        .filter(|word| !word.is_empty())
    {
        let bracketed = word.contains(['[', '(']);
        if bracketed {
            units.extend(unit_of(word));
        } else if after_in {
            units.extend(unit(word).map(StatedHeader::Length));
        }
        after_in = word.eq_ignore_ascii_case("in");
    }
    units
}

pub(super) fn unit(text: &str) -> Option<LengthUnit> {
    let text = text.trim().to_lowercase().replace(['µ', 'μ'], "u");
    match text.as_str() {
        "micron" | "microns" | "micrometer" | "micrometers" | "micrometre" | "micrometres"
        | "mikrometer" => Some(LengthUnit::Micrometre),
        "millimeter" | "millimeters" | "millimetre" | "millimetres" => Some(LengthUnit::Millimetre),
        "nanometer" | "nanometers" | "nanometre" | "nanometres" => Some(LengthUnit::Nanometre),
        "meter" | "meters" | "metre" | "metres" => Some(LengthUnit::Metre),
        "å" | "a\u{30a}" => Some(LengthUnit::Angstrom),
        "inches" => Some(LengthUnit::Inch),
        "mils" | "thou" => Some(LengthUnit::Mil),
        "uinch" | "microinch" | "microinches" => Some(LengthUnit::Microinch),
        other => other.parse().ok(),
    }
}

/// The filter state by keywords in the header, or by a Surfcom file name.
pub(super) fn filter_state(name: &str, header: &[Line<'_>]) -> FilterState {
    const ROUGHNESS: &[&str] = &[
        "roughness profile",
        "r-profil",
        "r profil",
        "rauheitsprofil",
        "rauheit",
        "r_profile",
        "profil de rugosité",
        "perfil de rugosidad",
        "profilo di rugosità",
    ];
    const PRIMARY: &[&str] = &[
        "primary",
        "p-profil",
        "p profil",
        "primärprofil",
        "profil primaire",
        "perfil primario",
        "perfil primário",
        "profilo primario",
        "unfiltered",
        "ungefiltert",
        "raw profile",
    ];
    match extension(name).as_str() {
        "tx1" => return FilterState::Primary,
        "tx2" => return FilterState::Roughness,
        _ => {}
    }
    let says = |words: &[&str]| {
        header.iter().any(|line| {
            let line = line.text.to_lowercase();
            words.iter().any(|word| line.contains(word))
        })
    };
    match (says(ROUGHNESS), says(PRIMARY)) {
        (true, false) => FilterState::Roughness,
        (false, true) => FilterState::Primary,
        _ => FilterState::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::super::options::{DecimalSign, Separator};
    use super::super::text::Head;
    use super::*;

    #[test]
    fn units_are_found_in_every_spelling() {
        use LengthUnit::{Metre, Micrometre, Millimetre, Nanometre};
        for (label, expected) in [
            ("x in um", Micrometre),
            ("x_mm", Millimetre),
            ("z [µm]", Micrometre),
            ("z (μm)", Micrometre),
            ("[mm]", Millimetre),
            ("height / nm", Nanometre),
            ("Höhe [m]", Metre),
            ("z in m", Metre),
            ("m", Metre),
            ("Z µm", Micrometre),
        ] {
            assert_eq!(
                unit_of(label),
                Some(StatedHeader::Length(expected)),
                "{label}"
            );
        }
        for (label, expected) in [
            ("z [inch]", LengthUnit::Inch),
            ("x [in]", LengthUnit::Inch),
            ("z [µin]", LengthUnit::Microinch),
            ("z in microinches", LengthUnit::Microinch),
            ("z (mil)", LengthUnit::Mil),
        ] {
            assert_eq!(
                unit_of(label),
                Some(StatedHeader::Length(expected)),
                "{label}"
            );
        }
        assert_eq!(unit_of("z in"), None);
        assert_eq!(
            unit_of("z [furlong]"),
            Some(StatedHeader::Other("furlong".into()))
        );
        assert_eq!(unit_of("[1/0]"), None);
        assert_eq!(unit_of("column m"), None);
    }

    #[test]
    fn distances_from_a_sensor_grow_into_the_material_as_depths_do() {
        for name in [
            "Distance to sensor (um)",
            "Sensor distance [mm]",
            "Abstand zum Sensor (µm)",
            "Arbeitsabstand [mm]",
            "Working distance",
            "stand-off_um",
            "Air gap (um)",
            "Distance au capteur (µm)",
            "Distanza dal sensore [um]",
            "センサ距離",
            "Depth (um)",
        ] {
            assert!(is_depth(name), "{name}");
            assert_eq!(role_of(name), Some(Role::Z), "{name}");
        }
        for name in [
            "Distance (mm)",
            "Abstand [mm]",
            "Position (mm)",
            "Sensor (um)",
            "Height",
        ] {
            assert!(!is_depth(name), "{name}");
        }
    }

    #[test]
    fn columns_of_involute_checkers_are_told_by_their_words() {
        for (label, expected) in [
            ("Roll length [mm]", Abscissa::RollLength),
            ("Wälzlänge (mm)", Abscissa::RollLength),
            ("roll_angle [deg]", Abscissa::RollDegrees),
            ("Wälzwinkel [rad]", Abscissa::RollRadians),
        ] {
            assert_eq!(role_of(label), Some(Role::Roll(expected)), "{label}");
        }
        assert_eq!(role_of("length [mm]"), Some(Role::X));
    }

    #[test]
    fn labels_of_several_words_are_told_by_wider_gaps() {
        let head =
            Head::from_text("# \tPosition (mm)     Distance (microns)    Light Intensity (0-255)");
        let header: Vec<_> = head.lines().collect();
        let dialect = Dialect {
            separator: Separator::Blank,
            decimal: DecimalSign::Point,
        };
        let found = labels(&header, dialect, 3);
        assert_eq!(found[0].role, Some(Role::X));
        let units: Vec<_> = found.into_iter().map(|label| label.unit).collect();
        assert_eq!(
            units,
            [
                Some(StatedHeader::Length(LengthUnit::Millimetre)),
                Some(StatedHeader::Length(LengthUnit::Micrometre)),
                None
            ]
        );
    }

    #[test]
    fn a_header_with_more_words_than_columns_still_gives_its_units() {
        let head = Head::from_text("# x (mm)  z in um");
        let header: Vec<_> = head.lines().collect();
        let dialect = Dialect {
            separator: Separator::Blank,
            decimal: DecimalSign::Point,
        };
        let units: Vec<_> = labels(&header, dialect, 2)
            .into_iter()
            .map(|label| label.unit)
            .collect();
        assert_eq!(
            units,
            [
                Some(StatedHeader::Length(LengthUnit::Millimetre)),
                Some(StatedHeader::Length(LengthUnit::Micrometre))
            ]
        );
    }
}
