//! Errors and their remedies in keys of a case: the keys to write and their tables.
//!
//! A command uses them if a case file is to be changed, a page if it shows the text of the case.

use asperity_core::Code;
use asperity_core::remedy::{Action, Remedy, Setting, Value};

use crate::error::Error;

impl Error {
    /// The error with its remedy in keys of the case.
    ///
    /// ```
    /// use asperity_case::case::from_text;
    /// let text = r#"
    ///     gears = { teeth = [23, 68], module = "1.8 mm", face_width = "32 mm" }
    ///     operation = { torque = "145 N m", speed = "9000 1/min", bulk_temperature = "90 °C" }
    ///     lubricant = { oil = "m100" }
    ///     surface = { pinion = { file = "flank.txt", z_unit = "um" } }
    /// "#;
    /// let heights = "0.25\n0.5\n".repeat(100);
    /// let error = from_text("case.toml", text, &|_| Ok(heights.clone().into_bytes())).unwrap_err();
    /// assert!(error.in_keys().ends_with("Write dx = \"0.5 um\" in surface.pinion"), "{}", error.in_keys());
    /// ```
    pub fn in_keys(&self) -> String {
        with_keys(&self.to_string(), &self.remedy(), self.flank())
    }

    /// The flank that the error is about, by its table in the case.
    pub fn flank(&self) -> &'static str {
        let key = self.place().and_then(|place| place.key.as_deref());
        match key {
            Some(key) if key.starts_with("surface.wheel") => "surface.wheel",
            _ => "surface.pinion",
        }
    }
}

/// Table of a case with the key of `setting`, for the flank at `flank`; `None` for a key that includes its table.
pub fn table(setting: Setting, flank: &str) -> Option<&str> {
    match setting {
        Setting::Key(_) => None,
        Setting::Outliers | Setting::Form | Setting::Cutoff | Setting::NoiseCutoff => {
            Some("surface")
        }
        _ => Some(flank),
    }
}

/// `message` with its remedy in keys of the case file, for the flank at `flank`.
pub fn with_keys(message: &str, remedy: &Remedy, flank: &str) -> String {
    ended(message, &remedy.sentence(|action| in_keys(action, flank)))
}

/// Appends the advice, unless the message ends in a question that implies it.
pub fn ended(message: &str, advice: &str) -> String {
    if advice.is_empty() || message.ends_with('?') {
        message.to_owned()
    } else {
        format!("{}. {advice}", message.trim_end_matches('.'))
    }
}

fn in_keys(action: &Action, flank: &str) -> String {
    match action {
        Action::Do { what } => what.to_string(),
        Action::Omit { setting } => match table(*setting, flank) {
            Some(table) => format!("leave {} out of {table}", setting.key()),
            None => format!("leave {} out", setting.key()),
        },
        Action::Set { settings, to, why } => {
            let keys: Vec<&str> = settings.iter().map(|setting| setting.key()).collect();
            let keys = keys.join(" and ");
            let assignment = match to {
                Value::This(value) | Value::Like(value) => {
                    format!("{keys} = {}", written(settings, value))
                }
                Value::OneOf(values) => {
                    let each: Vec<_> = values
                        .split(" | ")
                        .map(|value| written(settings, value))
                        .collect();
                    format!("{keys} = {}", each.join(", or "))
                }
                _ => keys,
            };
            let table = settings.first().and_then(|first| table(*first, flank));
            let instruction = match table {
                Some(table) => format!("write {assignment} in {table}"),
                None => format!("set {assignment}"),
            };
            explained(instruction, why)
        }
        _ => String::new(),
    }
}

/// A value as written in a case file.
fn written(settings: &[Setting], value: &str) -> String {
    match settings {
        [Setting::Columns] => match value.split_once(',') {
            Some((x, z)) => format!("{{ x = {x}, z = {z} }}"),
            None => format!("{{ z = {value} }}"),
        },
        [Setting::Row | Setting::Rows | Setting::Invert] => value.to_owned(),
        _ if value.parse::<f64>().is_ok() => value.to_owned(),
        _ => format!("\"{value}\""),
    }
}

/// `instruction` with its purpose or condition, if any.
pub fn explained(instruction: String, why: &str) -> String {
    match why {
        "" => instruction,
        why => format!("{instruction} {why}"),
    }
}

/// General advice for a code, with the keys that it is about.
///
/// ```
/// use asperity_core::Code;
/// assert_eq!(
///     asperity_case::key_words::advice(Code::E110),
///     "State the spacing of the points, e.g. 0.5 um (dx in surface.pinion)."
/// );
/// ```
pub fn advice(code: Code) -> String {
    let entry = code.explain();
    if entry.settings.is_empty() {
        return entry.remedy.to_owned();
    }
    let general = entry.remedy.trim_end_matches('.');
    format!("{general} ({}).", keys_in_tables(entry.settings))
}

/// Keys of settings with the tables that they belong to: `z_unit, gaps in surface.pinion, outliers in surface`.
pub fn keys_in_tables(settings: &[Setting]) -> String {
    let table = |setting: &Setting| table(*setting, "surface.pinion");
    let groups = settings.chunk_by(|a, b| table(a) == table(b));
    let texts = groups.map(|group| {
        let keys: Vec<&str> = group.iter().map(|setting| setting.key()).collect();
        let keys = keys.join(", ");
        match group.first().and_then(table) {
            Some(table) => format!("{keys} in {table}"),
            None => keys,
        }
    });
    texts.collect::<Vec<_>>().join(", ")
}
