//! Errors of a case file, each with a code, a place and a remedy.

use std::borrow::Cow;
use std::fmt::Display;

use asperity_core::{Code, Fault};

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{DomainError, did_you_mean, number_with_unit};
use asperity_oil::LubricantError;
use asperity_profile_io::read::ReadError;

use asperity_core::message::{IN_MEMORY, Place};

/// Largest tolerance of a rough contact: at 1e-2, pressures were wrong by 56 to 65 %.
pub(crate) const LOOSEST_TOLERANCE: f64 = 1e-4;

/// A case that cannot be run.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// Keys that exclude or need each other.
    #[error("{place}: {key}: {rule}")]
    Conflict {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// Rule.
        rule: &'static str,
    },
    /// A number outside its domain.
    #[error("{place}: {key}{}: {}", as_written(written.as_deref()), rule(source, written.is_some()))]
    Domain {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// The value as written in the file, if it is there.
        written: Option<String>,
        /// The number and the rule.
        source: DomainError,
    },
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl CaseError {
    fn new(code: Code, message: String) -> Self {
        Self::Fault(Fault::new(code, message))
    }

    fn at(code: Code, message: String, place: Place) -> Self {
        Self::Fault(Fault::new(code, message).at(place))
    }

    fn with(self, remedy: Remedy) -> Self {
        match self {
            Self::Fault(fault) => Self::Fault(fault.with(remedy)),
            other => other,
        }
    }

    /// The remedy to write the most similar known name, if there is one.
    fn or_write(self, nearest: Option<&str>) -> Self {
        match nearest {
            Some(nearest) => self.with(Remedy::act(format!("write {nearest}"))),
            None => self,
        }
    }

    /// The file cannot be opened.
    #[cfg(feature = "case-files")]
    pub(crate) fn open(file: impl Display, reason: std::io::Error) -> Self {
        Self::new(Code::E201, format!("{file}: cannot be opened: {reason}"))
            .with(Remedy::act("check the path"))
    }

    /// A folder instead of a case file.
    #[cfg(feature = "case-files")]
    pub(crate) fn folder(file: &str) -> Self {
        Self::new(
            Code::E201,
            format!("{file}: is a folder; name the case file in it, e.g. {file}/case.toml"),
        )
    }

    /// Not text in UTF-8.
    #[cfg(feature = "case-files")]
    pub(crate) fn encoding(place: Place) -> Self {
        Self::at(
            Code::E202,
            format!("{place}: is not text in UTF-8 from this line on; save the case file as UTF-8"),
            place,
        )
    }

    /// Not TOML, or not JSON.
    #[cfg(feature = "case-files")]
    pub(crate) fn syntax(place: Place, message: impl Display) -> Self {
        Self::at(Code::E202, format!("{place}: {message}"), place)
    }

    /// A key that does not exist in a case file.
    #[cfg(feature = "case-files")]
    pub(crate) fn unknown_key(place: Place, key: &str, nearest: Option<String>) -> Self {
        Self::at(
            Code::E203,
            format!(
                "{place}: unknown key \"{key}\"{}",
                did_you_mean(nearest.as_deref())
            ),
            place,
        )
        .or_write(nearest.as_deref())
    }

    /// A value that cannot be read, or a key that is missing.
    pub(crate) fn value(place: Place, key: Option<&str>, message: impl Display) -> Self {
        Self::at(
            Code::E204,
            format!(
                "{place}: {}{message}",
                key.map(|key| format!("{key}: ")).unwrap_or_default()
            ),
            place,
        )
    }

    /// A number outside the possible range of gear drives.
    pub(crate) fn impossible(
        place: Place,
        key: impl Display,
        written: Option<String>,
        seen: impl Display,
        usual: &str,
    ) -> Self {
        Self::at(
            Code::E212,
            format!(
                "{place}: {key}{}: {seen} is beyond physical sense; usual is {usual}",
                as_written(written.as_deref())
            ),
            place,
        )
    }

    /// A choice that does not apply to these gears.
    pub(crate) fn not_for_these_gears(
        place: Place,
        key: impl Display,
        source: asperity_gear::GearError,
    ) -> Self {
        Self::at(Code::E209, format!("{place}: {key}: {source}"), place)
    }

    /// A gear pair that cannot mesh.
    pub(crate) fn gears(place: Place, source: asperity_gear::GearError) -> Self {
        Self::at(Code::E206, format!("{place}: {source}"), place)
    }

    /// An incomplete or impossible lubricant.
    pub(crate) fn lubricant(
        place: Place,
        key: impl Display,
        written: Option<String>,
        source: LubricantError,
    ) -> Self {
        let code = match source {
            LubricantError::ImplausiblePressureViscosity { .. } => Code::E207,
            _ => Code::E208,
        };
        Self::at(
            code,
            format!("{place}: {key}{}: {source}", as_written(written.as_deref())),
            place,
        )
    }

    /// A steel that is not in the library.
    pub(crate) fn unknown_steel(
        place: Place,
        key: impl Display,
        name: impl Display,
        nearest: Option<String>,
        known: &[String],
    ) -> Self {
        Self::at(
            Code::E220,
            format!(
                "{place}: {key} = \"{name}\": the library has no such steel{}; it has: {}",
                did_you_mean(nearest.as_deref()),
                known.join(", ")
            ),
            place,
        )
        .or_write(nearest.as_deref())
    }

    /// The library of steels cannot be read.
    pub(crate) fn steels(source: asperity_core::presets::PresetError) -> Self {
        Self::new(Code::E501, format!("{source}"))
    }

    /// A file that the case names and that cannot be opened.
    pub(crate) fn open_named(
        file: impl Display,
        place: Place,
        key: &str,
        reason: std::io::Error,
    ) -> Self {
        Self::at(
            Code::E103,
            format!(
                "{file}: cannot be opened: {reason}{}",
                named(&place, Some(key))
            ),
            place,
        )
    }

    /// A file that is no longer the one that the case was read from.
    pub(crate) fn file_changed(file: impl Display) -> Self {
        Self::new(
            Code::E140,
            format!("{file}: changed or was removed since the case was read"),
        )
    }

    /// A pattern that matches no trace.
    pub(crate) fn no_traces(
        place: Place,
        key: impl Display,
        pattern: impl Display,
        folder: Option<String>,
    ) -> Self {
        Self::at(
            Code::E137,
            format!(
                "{place}: {key} = \"{pattern}\": {}",
                no_traces(folder.as_deref())
            ),
            place,
        )
    }

    /// Traces that no others can be generated like.
    pub(crate) fn not_generated(place: Place, key: impl Display, fault: &Fault) -> Self {
        Self::at(fault.code(), format!("{place}: {key}: {fault}"), place)
    }

    /// A finish of which no surrogates can be generated.
    pub(crate) fn no_recipe(place: Place, key: impl Display, finish: &'static str) -> Self {
        Self::at(
            Code::E223,
            format!(
                "{place}: {key} = \"{finish}\": only ground and superfinished have a recipe of surrogates; give the trace of the flank"
            ),
            place,
        )
    }

    /// A part of the gearbox with impossible numbers.
    pub(crate) fn gearbox_part(
        place: Place,
        key: impl Display,
        part: impl Display,
        source: asperity_efficiency::EfficiencyError,
    ) -> Self {
        Self::at(
            Code::E222,
            format!("{place}: {key}: {part}: {source}"),
            place,
        )
    }

    /// A table of losses that cannot be used.
    pub(crate) fn loss_table(place: Place, key: &str, source: Fault) -> Self {
        Self::at(
            Code::E138,
            format!("{source}{}", named(&place, Some(key))),
            place,
        )
    }

    /// Several meshes for what takes one of them.
    pub(crate) fn several_meshes(file: impl Display, meshes: impl Display) -> Self {
        Self::new(
            Code::E205,
            format!("{file}: has several meshes: {meshes}; this takes one of them"),
        )
    }

    /// No mesh of this name; `meshes` names those there are, `None` if the only mesh has no name.
    pub(crate) fn no_mesh(file: impl Display, name: &str, meshes: Option<&str>) -> Self {
        Self::new(Code::E205, format!("{file}: {}", no_mesh(name, meshes)))
    }

    /// A profile that cannot be read.
    pub(crate) fn profile(place: Place, source: &ReadError) -> Self {
        let remedy = source.remedy();
        Self::at(
            source.code(),
            format!("{source}{}", named(&place, None)),
            place,
        )
        .with(remedy)
    }

    /// The mean of a surface, whose roughness is averaged out.
    pub(crate) fn averaged_out(
        place: Place,
        file: impl Display,
        mean: Length,
        lines: Length,
    ) -> Self {
        Self::at(Code::E141, format!("{file}: the mean of the surface has Rq {mean:.3}, single lines {lines:.3}: roughness that does not run across the whole surface is averaged out{}", named(&place, None)), place).with(Remedy::set(Setting::Rows, Value::This("8".into())).because("instead of line"))
    }

    /// A profile that cannot be prepared.
    pub(crate) fn preparation(
        file: impl Display,
        source: asperity_roughness::RoughnessError,
    ) -> Self {
        let remedy = if source.is_of_noise_cutoff() {
            Remedy::state(Setting::NoiseCutoff).because("to five times the spacing of the trace")
        } else {
            Remedy::state(Setting::Cutoff).because("to suit the trace")
        };
        Self::new(Code::E120, format!("{file}: {source}")).with(remedy)
    }
}

fn as_written(written: Option<&str>) -> String {
    written.map(|text| format!(" = {text}")).unwrap_or_default()
}

/// The rule, after the number if the text does not show it.
fn rule(source: &DomainError, is_shown: bool) -> String {
    let DomainError {
        name,
        value,
        unit,
        rule,
    } = source;
    match (is_shown, *unit) {
        (true, _) => (*rule).to_owned(),
        (false, unit) => format!("{name} = {}: {rule}", number_with_unit(*value, unit)),
    }
}

/// Place at which the case names a file, for the end of a message; a case in memory has no places, only keys.
fn named(place: &Place, key: Option<&str>) -> String {
    let is_in_memory = place.line.is_none() && place.file == IN_MEMORY;
    match (is_in_memory, key.or(place.key.as_deref())) {
        (true, None) => String::new(),
        (true, Some(key)) => format!(" (named by {key})"),
        (false, _) => match key {
            Some(key) => format!(" (named at {place}, {key})"),
            None => format!(" (named at {place})"),
        },
    }
}

fn no_traces(folder: Option<&str>) -> String {
    match folder {
        Some(folder) => format!("no file in {folder} has such a name"),
        None => "no folder is known to search in; name the files one by one".to_owned(),
    }
}

fn no_mesh(name: &str, meshes: Option<&str>) -> String {
    match meshes {
        Some(meshes) => format!("has no mesh \"{name}\", only {meshes}"),
        None => format!("has a single mesh; leave its name, \"{name}\", out"),
    }
}

impl CaseError {
    /// Stable code of the message.
    pub fn code(&self) -> Code {
        match self {
            Self::Conflict { .. } => Code::E205,
            Self::Domain { key, source, .. }
                if key == "model.tolerance" && source.value > LOOSEST_TOLERANCE =>
            {
                Code::E211
            }
            Self::Domain { .. } => Code::E209,
            Self::Fault(fault) => fault.code(),
        }
    }

    /// Remedy, if it is more specific than the advice of the code.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::Fault(fault) => fault.remedy().clone(),
            _ => Remedy::none(),
        }
    }

    /// Place in the case file, if the error is about one.
    pub fn place(&self) -> Option<&Place> {
        match self {
            Self::Conflict { place, .. } | Self::Domain { place, .. } => Some(place),
            Self::Fault(fault) => fault.place(),
        }
    }
}
