//! Remedies: what can be done about an error or a warning, as data.
//!
//! A library does not know how its user states things: in a case file, on a command line, in a form on a
//! page. So a remedy names settings and actions, and whoever shows it chooses the words. [`Remedy`] prints in
//! the words of the settings' keys.

use std::borrow::Cow;

use serde::Serialize;

/// A setting of a reader, of the preparation of a trace, or of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Setting {
    /// Unit of the positions.
    XUnit,
    /// Unit of the heights.
    ZUnit,
    /// Spacing of the points.
    Spacing,
    /// Spacing of the rows of a surface.
    RowSpacing,
    /// Columns of positions and heights.
    Columns,
    /// Decimal sign.
    Decimal,
    /// Column separator.
    Separator,
    /// Text encoding.
    Encoding,
    /// Treatment of missing points.
    Gaps,
    /// Number of the profile in a file that holds several.
    Row,
    /// Number of profiles that a case takes from a file that holds several.
    Rows,
    /// Trace that is taken from a surface.
    Line,
    /// Meaning of the column of positions.
    Abscissa,
    /// Base radius of the gear, for positions that are roll lengths.
    BaseRadius,
    /// Treatment of uneven positions.
    Uneven,
    /// Part of the trace that is used.
    Range,
    /// Sign of the heights.
    Invert,
    /// Replacement of spikes.
    Outliers,
    /// Form removed from a trace.
    Form,
    /// Cut-off λc.
    Cutoff,
    /// Cut-off λs.
    NoiseCutoff,
    /// A key of a case, as `model.window`.
    Key(&'static str),
}

impl Setting {
    /// The key of the setting, in its table of a case and in the options of a reader.
    pub const fn key(self) -> &'static str {
        match self {
            Self::XUnit => "x_unit",
            Self::ZUnit => "z_unit",
            Self::Spacing => "dx",
            Self::RowSpacing => "dy",
            Self::Columns => "columns",
            Self::Decimal => "decimal",
            Self::Separator => "separator",
            Self::Encoding => "encoding",
            Self::Gaps => "gaps",
            Self::Row => "row",
            Self::Rows => "rows",
            Self::Line => "line",
            Self::Abscissa => "abscissa",
            Self::BaseRadius => "base_radius",
            Self::Uneven => "uneven",
            Self::Range => "range",
            Self::Invert => "invert",
            Self::Outliers => "outliers",
            Self::Form => "form",
            Self::Cutoff => "cutoff",
            Self::NoiseCutoff => "noise_cutoff",
            Self::Key(key) => key,
        }
    }
}

/// Value a setting is to be set to.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind", content = "text")]
#[non_exhaustive]
pub enum Value {
    /// Whatever holds; only the user knows.
    Any,
    /// This value.
    This(Cow<'static, str>),
    /// A value of this form.
    Like(Cow<'static, str>),
    /// One of these values, or a range: "um | nm | mm", "1 .. 3".
    OneOf(Cow<'static, str>),
}

/// One thing that can be done.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "kind")]
#[non_exhaustive]
pub enum Action {
    /// Give settings a value.
    Set {
        /// The settings; more than one belong together.
        settings: Cow<'static, [Setting]>,
        /// The value of a single setting.
        to: Value,
        /// To what end, or in which case: "to fill them", "if x is another column"; may be empty.
        why: Cow<'static, str>,
    },
    /// Leave a setting away.
    Omit {
        /// The setting.
        setting: Setting,
    },
    /// Something that is done elsewhere, as a phrase: "export the whole trace".
    Do {
        /// The phrase, beginning in lower case.
        what: Cow<'static, str>,
    },
}

/// Remedies of an error or a warning: alternatives, the best first.
///
/// ```
/// use asperity_core::remedy::{Remedy, Setting, Value};
/// let remedy = Remedy::set(Setting::ZUnit, Value::OneOf("um | nm | mm".into()))
///     .or_do("export the trace with its unit");
/// assert_eq!(
///     remedy.to_string(),
///     "Set z_unit to um | nm | mm, or export the trace with its unit"
/// );
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
#[serde(transparent)]
pub struct Remedy(Vec<Action>);

impl Remedy {
    /// No remedy.
    pub const fn none() -> Self {
        Self(Vec::new())
    }

    /// Give `setting` a value.
    pub fn set(setting: Setting, to: Value) -> Self {
        Self::none().or_set(setting, to)
    }

    /// State `setting`; only the user knows its value.
    pub fn state(setting: Setting) -> Self {
        Self::set(setting, Value::Any)
    }

    /// Leave `setting` away.
    pub fn omit(setting: Setting) -> Self {
        Self(vec![Action::Omit { setting }])
    }

    /// Do something elsewhere: a phrase that begins in lower case.
    pub fn act(what: impl Into<Cow<'static, str>>) -> Self {
        Self::none().or_do(what)
    }

    /// State settings that belong together.
    pub fn state_all(settings: &'static [Setting]) -> Self {
        Self(vec![Action::Set {
            settings: settings.into(),
            to: Value::Any,
            why: "".into(),
        }])
    }

    /// Adds the alternative to give `setting` a value.
    #[must_use]
    pub fn or_set(mut self, setting: Setting, to: Value) -> Self {
        self.0.push(Action::Set {
            settings: vec![setting].into(),
            to,
            why: "".into(),
        });
        self
    }

    /// Adds the alternative to do something elsewhere.
    #[must_use]
    pub fn or_do(mut self, what: impl Into<Cow<'static, str>>) -> Self {
        self.0.push(Action::Do { what: what.into() });
        self
    }

    /// Adds the purpose of the last action, or its condition: "to fill them", "if x is another column".
    #[must_use]
    pub fn because(mut self, reason: impl Into<Cow<'static, str>>) -> Self {
        if let Some(Action::Set { why, .. }) = self.0.last_mut() {
            *why = reason.into();
        }
        self
    }

    /// The alternatives, the best first.
    pub fn actions(&self) -> &[Action] {
        &self.0
    }

    /// Whether the remedy is empty.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The remedy as a sentence without its full stop, each action in the words of `say`.
    pub fn sentence(&self, say: impl Fn(&Action) -> String) -> String {
        let parts: Vec<String> = self.0.iter().map(say).collect();
        capitalised(&parts.join(", or "))
    }
}

/// `text` with a capital at the beginning.
///
/// ```
/// assert_eq!(asperity_core::capitalised("ground flanks lose more."), "Ground flanks lose more.");
/// ```
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next();
    let first = first.into_iter().flat_map(char::to_uppercase);
    first.chain(letters).collect()
}

/// In the words of the keys.
impl std::fmt::Display for Remedy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.sentence(|action| match action {
            Action::Do { what } => what.to_string(),
            Action::Omit { setting } => format!("leave {} out", setting.key()),
            Action::Set { settings, to, why } => {
                let keys: Vec<&str> = settings.iter().map(|setting| setting.key()).collect();
                let keys = keys.join(" and ");
                let phrase = match to {
                    Value::Any => format!("set {keys}"),
                    Value::This(value) | Value::OneOf(value) => format!("set {keys} to {value}"),
                    Value::Like(value) => format!("set {keys}, e.g. {value}"),
                };
                match why.as_ref() {
                    "" => phrase,
                    why => format!("{phrase} {why}"),
                }
            }
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_remedy_reads_like_a_sentence() {
        let remedy = Remedy::act("remove the doubled part")
            .or_set(Setting::Columns, Value::Any)
            .because("if x is another column");
        assert_eq!(
            remedy.to_string(),
            "Remove the doubled part, or set columns if x is another column"
        );
        let both = Remedy::state_all(&[Setting::Separator, Setting::Decimal]);
        assert_eq!(both.to_string(), "Set separator and decimal");
        assert_eq!(Remedy::none().to_string(), "");
    }

    #[test]
    fn a_remedy_is_data() {
        let remedy = Remedy::set(Setting::Spacing, Value::Like("0.5 um".into()));
        assert_eq!(
            serde_json::to_value(&remedy).unwrap(),
            serde_json::json!([{
                "kind": "set", "settings": ["spacing"],
                "to": { "kind": "like", "text": "0.5 um" }, "why": "",
            }])
        );
    }
}
