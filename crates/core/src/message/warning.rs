//! Warnings about a result.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use super::table::Code;

/// A warning about a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// Stable code, `W402`.
    pub code: Code,
    /// Values found and expected.
    pub text: String,
    /// Component of the uncertainty that the warning is about, if its code leaves it open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<Subject>,
}

/// Component of the uncertainty that a warning can be about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Subject {
    /// Pressure-viscosity coefficient of the oil.
    PressureViscosity,
    /// Tip relief that is not stated.
    TipRelief,
    /// Error of the model.
    FastModel,
    /// Sampling of the flanks.
    Sampling,
    /// Lay above 1/3.
    Lay,
    /// Oil that replaces the oil of the case.
    Oil,
}

impl Warning {
    /// A warning of this code.
    pub fn new(code: Code, text: impl Into<String>) -> Self {
        Self {
            code,
            text: text.into(),
            about: None,
        }
    }

    /// The warning with `more` behind its text.
    #[must_use]
    pub fn with(&self, more: &str) -> Self {
        Self {
            code: self.code,
            text: self.text.clone() + more,
            ..*self
        }
    }
}

/// Codes of warnings about gears, inputs or a solution that make the result doubtful, the gravest first.
const DOUBTFUL: [Code; 24] = [
    Code::W204,
    Code::W433,
    Code::W451,
    Code::W423,
    Code::W201,
    Code::W412,
    Code::W402,
    Code::W426,
    Code::W425,
    Code::W467,
    Code::W452,
    Code::W405,
    Code::W441,
    Code::W322,
    Code::W117,
    Code::W124,
    Code::W327,
    Code::W128,
    Code::W112,
    Code::W132,
    Code::W448,
    Code::W118,
    Code::W111,
    Code::W125,
];

impl Code {
    /// Place among the warnings that make a result doubtful, 0 for the gravest; `None` for other codes.
    ///
    /// ```
    /// use asperity_core::message::Code;
    /// assert_eq!(Code::W204.doubt(), Some(0));
    /// assert_eq!(Code::W439.doubt(), None);
    /// ```
    pub fn doubt(self) -> Option<usize> {
        DOUBTFUL.iter().position(|code| *code == self)
    }
}

/// Sorts warnings for a reader: those that make the result doubtful come first, the gravest before others, the rest in their order.
///
/// ```
/// use asperity_core::message::{Code, gravest_first};
/// let mut codes = [Code::W439, Code::W405, Code::W401, Code::W433];
/// gravest_first(&mut codes, |code| Some(*code));
/// assert_eq!(codes, [Code::W433, Code::W405, Code::W439, Code::W401]);
/// ```
pub fn gravest_first<T>(warnings: &mut [T], code: impl Fn(&T) -> Option<Code>) {
    warnings.sort_by_key(|warning| {
        let doubt = code(warning).and_then(Code::doubt);
        doubt.unwrap_or(DOUBTFUL.len())
    });
}

/// The text of [`Code::W454`]: `columns` of a table, which `table` names in words, were not read.
///
/// ```
/// use asperity_core::message::columns_not_read;
/// let text = columns_not_read("the cycle", &["gear", "remark"]);
/// assert_eq!(text, "columns of the cycle that are not read: gear, remark");
/// ```
pub fn columns_not_read(table: &str, columns: &[impl AsRef<str>]) -> String {
    let columns: Vec<&str> = columns.iter().map(AsRef::as_ref).collect();
    format!(
        "columns of {table} that are not read: {}",
        columns.join(", ")
    )
}

/// Codes of the warnings about an input outside of a fitted, tested or usual range.
const OUTSIDE: [Code; 6] = [
    Code::W401,
    Code::W402,
    Code::W403,
    Code::W405,
    Code::W428,
    Code::W443,
];

/// The column `outside` of a table of cases: distinct codes of warnings about an input outside of its range, with spaces.
///
/// ```
/// use asperity_core::message::{Code, outside_codes};
/// let codes = [Code::W443, Code::W409, Code::W401, Code::W401];
/// assert_eq!(outside_codes(codes), "W401 W443");
/// ```
pub fn outside_codes(codes: impl IntoIterator<Item = Code>) -> String {
    listed(codes, |code| OUTSIDE.contains(&code))
}

/// The same for rows that name their oil: with W442, as the case states other properties than the oil of the row.
///
/// ```
/// use asperity_core::message::{Code, outside_codes_of_case};
/// assert_eq!(outside_codes_of_case([Code::W442, Code::W409, Code::W401]), "W401 W442");
/// ```
pub fn outside_codes_of_case(codes: impl IntoIterator<Item = Code>) -> String {
    listed(codes, |code| OUTSIDE.contains(&code) || code == Code::W442)
}

fn listed(codes: impl IntoIterator<Item = Code>, is_listed: impl Fn(Code) -> bool) -> String {
    let codes = codes.into_iter().filter(|code| is_listed(*code));
    let codes = BTreeSet::from_iter(codes).into_iter().map(Code::as_str);
    Vec::from_iter(codes).join(" ")
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.code, self.text)
    }
}
