//! Errors of a case file, each with a code, a place and a remedy.

use asperity_core::Code;
use std::borrow::Cow;

use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{DomainError, number_with_unit};
use asperity_profile_io::read::ReadError;

use crate::loss_table::LossTableError;
use asperity_core::message::{IN_MEMORY, Place};

/// Largest tolerance of a rough contact: at 1e-2, pressures were wrong by 56 to 65 %.
pub(super) const LOOSEST_TOLERANCE: f64 = 1e-4;

/// A case that cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// The file cannot be opened.
    #[error("{file}: cannot be opened: {reason}")]
    Open {
        /// Name of the file.
        file: String,
        /// Reason given by the operating system.
        reason: std::io::Error,
    },
    /// A folder in place of a case file.
    #[error("{file}: is a folder; name the case file in it, e.g. {file}/case.toml")]
    Folder {
        /// Name of the folder.
        file: String,
    },
    /// Not text in UTF-8.
    #[error("{place}: is not text in UTF-8 from this line on; save the case file as UTF-8")]
    Encoding {
        /// Place in the case file.
        place: Place,
    },
    /// Not TOML, or not JSON.
    #[error("{place}: {message}")]
    Syntax {
        /// Place in the case file.
        place: Place,
        /// Message of the parser.
        message: String,
    },
    /// A key that does not exist in a case file.
    #[error("{place}: unknown key \"{key}\"{}", did_you_mean(nearest.as_deref()))]
    UnknownKey {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: String,
        /// The most similar known key.
        nearest: Option<String>,
    },
    /// A value that cannot be read, or a key that is missing.
    #[error("{place}: {}{message}", key.as_ref().map(|k| format!("{k}: ")).unwrap_or_default())]
    Value {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Option<String>,
        /// Values seen and expected.
        message: String,
    },
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
    /// A number outside the possible range of gear drives.
    #[error("{place}: {key}{}: {seen} is beyond physical sense; usual is {usual}", as_written(written.as_deref()))]
    Impossible {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// The value as written in the file, if it is there.
        written: Option<String>,
        /// The number with its unit.
        seen: String,
        /// The usual range with its unit.
        usual: String,
    },
    /// A choice that does not apply to these gears.
    #[error("{place}: {key}: {source}")]
    NotForTheseGears {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// The reason.
        source: asperity_gear::GearError,
    },
    /// A gear pair that cannot mesh.
    #[error("{place}: {source}")]
    Gears {
        /// Place in the case file.
        place: Place,
        /// The reason.
        source: asperity_gear::GearError,
    },
    /// An incomplete or impossible lubricant.
    #[error("{place}: {key}{}: {source}", as_written(written.as_deref()))]
    Lubricant {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// The value as written in the file, if a single value causes the error.
        written: Option<String>,
        /// The reason.
        source: asperity_oil::LubricantError,
    },
    /// A steel that is not in the library.
    #[error("{place}: {key} = \"{name}\": the library has no such steel{}; it has: {}", did_you_mean(nearest.as_deref()), known.join(", "))]
    UnknownSteel {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// The name in the case.
        name: String,
        /// The steel with the most similar name.
        nearest: Option<String>,
        /// The names in the library.
        known: Vec<String>,
    },
    /// The library of steels cannot be read.
    #[error("{source}")]
    Steels {
        /// The reason.
        source: asperity_core::presets::PresetError,
    },
    /// A file that the case names and that cannot be opened.
    #[error("{file}: cannot be opened: {reason}{}", named(place, Some(key)))]
    OpenNamed {
        /// Name of the file.
        file: String,
        /// Place at which it is named.
        place: Place,
        /// The key that names it.
        key: Cow<'static, str>,
        /// Reason given by the operating system.
        reason: std::io::Error,
    },
    /// A file that is no longer the one that the case was read from.
    #[error("{file}: changed or was removed since the case was read")]
    FileChanged {
        /// Name of the file.
        file: String,
    },
    /// A pattern that matches no trace.
    #[error("{place}: {key} = \"{pattern}\": {}", no_traces(folder.as_deref()))]
    NoTraces {
        /// Place in the case file.
        place: Place,
        /// The key with the pattern.
        key: Cow<'static, str>,
        /// The pattern.
        pattern: String,
        /// The folder that was searched; `None` for a case without files.
        folder: Option<String>,
    },
    /// A finish of which no surrogates can be generated.
    #[error(
        "{place}: {key} = \"{finish}\": only ground and superfinished have a recipe of surrogates; give the trace of the flank"
    )]
    NoRecipe {
        /// Place in the case file.
        place: Place,
        /// The key, with its table.
        key: Cow<'static, str>,
        /// Name of the finish.
        finish: &'static str,
    },
    /// A part of the gearbox with impossible numbers.
    #[error("{place}: {key}: {part}: {source}")]
    GearboxPart {
        /// Place in the case file.
        place: Place,
        /// The key of its list.
        key: Cow<'static, str>,
        /// Name of the part.
        part: String,
        /// The reason.
        source: asperity_efficiency::EfficiencyError,
    },
    /// A table of losses that cannot be used.
    #[error("{source}{}", named(place, Some(key)))]
    LossTable {
        /// Place at which it is named.
        place: Place,
        /// The key that names it.
        key: Cow<'static, str>,
        /// The reason.
        source: LossTableError,
    },
    /// Several meshes for what takes one of them.
    #[error("{file}: has several meshes: {meshes}; this takes one of them")]
    SeveralMeshes {
        /// Name of the case.
        file: String,
        /// Names of the meshes.
        meshes: String,
    },
    /// No mesh of this name.
    #[error("{file}: {}", no_mesh(name, meshes.as_deref()))]
    NoMesh {
        /// Name of the case.
        file: String,
        /// The name.
        name: String,
        /// Names of the meshes; `None` if the only mesh has no name.
        meshes: Option<String>,
    },
    /// A profile that cannot be read.
    #[error("{source}{}", named(place, None))]
    Profile {
        /// Place at which it is named.
        place: Place,
        /// The reason.
        source: Box<ReadError>,
    },
    /// The mean of a surface, whose roughness is averaged out.
    #[error(
        "{file}: the mean of the surface has Rq {mean:.3}, single lines {lines:.3}: roughness that does not run across the whole surface is averaged out{}",
        named(place, None)
    )]
    AveragedOut {
        /// Place at which the surface is named.
        place: Place,
        /// Name of the file.
        file: String,
        /// Rq of the mean.
        mean: Length,
        /// Rq of single lines.
        lines: Length,
    },
    /// A profile that cannot be prepared.
    #[error("{file}: {source}")]
    Preparation {
        /// Name of the profile's file.
        file: String,
        /// The reason.
        source: asperity_roughness::RoughnessError,
    },
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

/// Where the case names a file, for the end of a message; a case in memory has no places, only keys.
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

/// The end of a message about an unknown name, with the most similar known name.
pub fn did_you_mean(nearest: Option<&str>) -> String {
    nearest
        .map(|key| format!(". Did you mean \"{key}\"?"))
        .unwrap_or_default()
}

impl CaseError {
    /// Stable code of the message.
    pub fn code(&self) -> Code {
        use asperity_oil::LubricantError;
        match self {
            Self::Open { .. } | Self::Folder { .. } => Code::E201,
            Self::Encoding { .. } | Self::Syntax { .. } => Code::E202,
            Self::UnknownKey { .. } => Code::E203,
            Self::Value { .. } => Code::E204,
            Self::Conflict { .. } | Self::SeveralMeshes { .. } | Self::NoMesh { .. } => Code::E205,
            Self::Gears { .. } => Code::E206,
            Self::Lubricant {
                source: LubricantError::ImplausiblePressureViscosity { .. },
                ..
            } => Code::E207,
            Self::Lubricant { .. } => Code::E208,
            Self::Domain { key, source, .. }
                if key == "model.tolerance" && source.value > LOOSEST_TOLERANCE =>
            {
                Code::E211
            }
            Self::Impossible { .. } => Code::E212,
            Self::Domain { .. } | Self::NotForTheseGears { .. } => Code::E209,
            Self::UnknownSteel { .. } => Code::E220,
            Self::Steels { .. } => Code::E501,
            Self::OpenNamed { .. } => Code::E103,
            Self::FileChanged { .. } => Code::E140,
            Self::NoTraces { .. } => Code::E137,
            Self::LossTable { .. } => Code::E138,
            Self::GearboxPart { .. } => Code::E222,
            Self::NoRecipe { .. } => Code::E223,
            Self::Profile { source, .. } => source.code(),
            Self::Preparation { .. } => Code::E120,
            Self::AveragedOut { .. } => Code::E141,
        }
    }

    /// Remedy that is more specific than that of the code.
    pub fn remedy(&self) -> Remedy {
        match self {
            Self::Open { .. } => Remedy::act("check the path"),
            Self::UnknownKey {
                nearest: Some(nearest),
                ..
            }
            | Self::UnknownSteel {
                nearest: Some(nearest),
                ..
            } => Remedy::act(format!("write {nearest}")),
            Self::Profile { source, .. } => source.remedy(),
            Self::AveragedOut { .. } => {
                Remedy::set(Setting::Rows, Value::This("8".into())).because("in place of line")
            }
            Self::Preparation { source, .. } => {
                let cutoff = match source.is_of_noise_cutoff() {
                    true => Setting::NoiseCutoff,
                    false => Setting::Cutoff,
                };
                Remedy::state(cutoff).because("to suit the trace")
            }
            _ => Remedy::none(),
        }
    }

    /// Place in the case file, if the error is about one.
    pub fn place(&self) -> Option<&Place> {
        match self {
            Self::Encoding { place }
            | Self::Syntax { place, .. }
            | Self::UnknownKey { place, .. }
            | Self::Value { place, .. }
            | Self::Conflict { place, .. }
            | Self::Domain { place, .. }
            | Self::Gears { place, .. }
            | Self::Impossible { place, .. }
            | Self::NotForTheseGears { place, .. }
            | Self::Lubricant { place, .. }
            | Self::UnknownSteel { place, .. }
            | Self::OpenNamed { place, .. }
            | Self::NoTraces { place, .. }
            | Self::LossTable { place, .. }
            | Self::GearboxPart { place, .. }
            | Self::NoRecipe { place, .. }
            | Self::Profile { place, .. }
            | Self::AveragedOut { place, .. } => Some(place),
            Self::Open { .. }
            | Self::Folder { .. }
            | Self::FileChanged { .. }
            | Self::SeveralMeshes { .. }
            | Self::NoMesh { .. }
            | Self::Steels { .. }
            | Self::Preparation { .. } => None,
        }
    }
}
