//! Studies of one case, each described once: its settings, its work and its run. `registry.rs` lists them.

use asperity::case::LoadedCase;
use asperity::case::train::Train;
use asperity::pipeline::Progress;
use asperity_core::{Code, Fault};
use asperity_report::StudyResult;
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

/// Description of a setting, from which the faces make an option or an argument.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Setting {
    /// Name of the field.
    pub name: &'static str,
    /// Type in Rust.
    pub kind: &'static str,
    /// What it is.
    pub about: &'static str,
    /// Value if none is stated; `None` if it must be stated or has none.
    pub default: Option<Value>,
}

/// Work of a study, for the estimate of its time and memory before it begins.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Work {
    /// Meshes as they run.
    pub meshes: Vec<LoadedCase>,
    /// How often they run.
    pub runs: usize,
}

impl Work {
    /// `runs` runs of `meshes`.
    #[must_use]
    pub fn new(meshes: Vec<LoadedCase>, runs: usize) -> Self {
        Self { meshes, runs }
    }
}

/// Settings of a study of one case; [`settings!`](crate::settings) makes them.
pub trait Settings: DeserializeOwned {
    /// The settings in their order.
    fn described() -> Vec<Setting>;

    /// Settings from an object of JSON; those that it lacks have their defaults.
    ///
    /// # Errors
    /// Names a setting that is missing, unknown, or of another type.
    fn of_json(mut stated: Value) -> Result<Self, Fault> {
        for setting in Self::described() {
            if let (Some(default), Some(stated)) = (setting.default, stated.as_object_mut()) {
                stated.entry(setting.name).or_insert(default);
            }
        }
        serde_path_to_error::deserialize(stated).map_err(|error| Fault::of(Code::E204, error))
    }
}

/// A study of one case, by its settings.
pub trait CaseStudy: Settings {
    /// Result of the study.
    type Found: for<'a> StudyResult<Context<'a> = ()> + Send + Sync + 'static;
    /// Name of the command, and of the function in Python.
    const COMMAND: &'static str;
    /// What it answers, in a line.
    const ABOUT: &'static str;
    /// Examples: the settings that each states, by name and value.
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]];
    /// Explanation of the method.
    const METHOD: &'static str;
    /// What its progress counts.
    const STEPS: &'static str;
    /// Whether it takes a gear train; otherwise one mesh of it.
    const TAKES_TRAINS: bool;

    /// Its work for `train`.
    ///
    /// # Errors
    /// When it does not take this train.
    fn work(&self, train: &Train) -> Result<Work, Fault>;

    /// Runs the study.
    ///
    /// # Errors
    /// When a setting has no sense, or the case cannot be run.
    fn run(&self, train: &Train, progress: Progress<'_>) -> Result<Self::Found, Fault>;
}

/// The settings of a study, each stated once: `name: type` for one that must be stated or is optional, `name: type = default` for
/// the others. They are read from JSON, and with the feature `clap` they are options of a command with the same words.
#[macro_export]
macro_rules! settings {
    ($(#[$about:meta])+ $visibility:vis struct $type:ident { $($(#[doc = $doc:literal])+ $name:ident: $kind:ty $(= $default:literal)?,)* }) => {
        $(#[$about])+
        #[derive(Debug, Clone, PartialEq, serde::Deserialize)]
        #[cfg_attr(feature = "clap", derive(clap::Args))]
        #[serde(deny_unknown_fields)]
        $visibility struct $type {
            $(
                $(#[doc = $doc])+
                #[cfg_attr(feature = "clap", arg(long, allow_hyphen_values = true $(, default_value = concat!($default))?))]
                pub $name: $kind,
            )*
        }

        impl $crate::study::Settings for $type {
            fn described() -> Vec<$crate::study::Setting> {
                vec![$($crate::study::Setting {
                    name: stringify!($name),
                    kind: stringify!($kind),
                    about: concat!($($doc),+).trim_ascii(),
                    default: $crate::settings!(@default $($default)?),
                }),*]
            }
        }
    };
    (@default) => { None };
    (@default $default:literal) => { Some(serde_json::json!($default)) };
}
