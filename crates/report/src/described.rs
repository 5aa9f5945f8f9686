//! Studies as the faces walk them: subject, settings, work and run.

use asperity::case::LoadedCase;
use asperity::case::train::Train;
use asperity::pipeline::Progress;
use asperity_core::Fault;
use schemars::generate::SchemaSettings;
use serde::Serialize;
use serde_json::{Map, Value, json};

use crate::settings::{SchemaOf, Setting, Settings};
use crate::study::StudyResult;

/// Subject of a study: a case, an oil, measured curves. Each face makes it from its own arguments.
pub trait Input: Sized {
    /// Its arguments in their order.
    fn described() -> Vec<Setting>;

    /// Its title.
    fn title(&self) -> String;
}

/// The argument of a case.
fn case() -> Vec<Setting> {
    vec![Setting::new("case", "Case", "The case", None)]
}

/// All meshes of a case.
impl Input for Train {
    fn described() -> Vec<Setting> {
        case()
    }

    fn title(&self) -> String {
        self.title.clone()
    }
}

/// The only mesh of a case.
impl Input for LoadedCase {
    fn described() -> Vec<Setting> {
        case()
    }

    fn title(&self) -> String {
        self.case.title.clone()
    }
}

/// Callbacks of a study.
pub struct Watch<'a> {
    /// Called with the number of steps so far and the number of all, 0 where it is not known.
    pub progress: Progress<'a>,
    /// Called with what is known before the result.
    pub say: &'a dyn Fn(&str),
}

impl Watch<'_> {
    /// No callbacks.
    pub const SILENT: Watch<'static> = Watch {
        progress: &|_, _| {},
        say: &|_| {},
    };
}

/// Work of a study, for the estimate of its time and memory before it begins.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Work {
    /// Meshes as they run.
    pub meshes: Vec<LoadedCase>,
    /// Number of times that they run.
    pub runs: usize,
}

impl Work {
    /// `runs` runs of `meshes`.
    #[must_use]
    pub fn new(meshes: Vec<LoadedCase>, runs: usize) -> Self {
        Self { meshes, runs }
    }
}

/// A study by its settings. `registry.rs` of `asperity-studies` lists all.
pub trait StudySettings: Settings {
    /// Its subject.
    type Input: Input;
    /// Result of the study.
    type Found: StudyResult + Send + Sync + 'static;
    /// Words of the command.
    const COMMAND: &'static str;
    /// Name of the function in Python.
    const FUNCTION: &'static str = Self::COMMAND;
    /// End of the name of its folder; empty if the name of its subject is the whole name.
    const FOLDER: &'static str = Self::COMMAND;
    /// Question that it answers, in a line.
    const ABOUT: &'static str;
    /// Examples: the arguments and settings that each states, by name and value.
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]];
    /// Explanation of the method.
    const METHOD: &'static str;
    /// Steps that its progress counts; empty if it reports none.
    const STEPS: &'static str;

    /// Title of the result.
    fn title(input: &Self::Input) -> String {
        input.title()
    }

    /// Its work; `None` if it takes seconds.
    ///
    /// # Errors
    /// When a setting has no sense.
    fn work(&self, input: &Self::Input) -> Result<Option<Work>, Fault>;

    /// Runs the study.
    ///
    /// # Errors
    /// When a setting has no sense, or the study has no result.
    fn run(&self, input: Self::Input, watch: &Watch<'_>) -> Result<Self::Found, Fault>;
}

/// Description of a study.
#[derive(Debug, Clone, Serialize)]
#[non_exhaustive]
pub struct Described {
    /// Words of the command.
    pub command: &'static str,
    /// Name of the function in Python.
    pub function: &'static str,
    /// Question that it answers.
    pub about: &'static str,
    /// Explanation of the method.
    pub method: &'static str,
    /// Steps that its progress counts; empty if it reports none.
    pub steps: &'static str,
    /// Its subject.
    pub input: Vec<Setting>,
    /// Its settings.
    pub settings: Vec<Setting>,
    /// JSON Schema of its settings.
    #[serde(skip)]
    pub schema: SchemaOf,
}

impl Described {
    /// Description of the study `S`.
    #[must_use]
    pub fn new<S: StudySettings>() -> Self {
        Self {
            command: S::COMMAND,
            function: S::FUNCTION,
            about: S::ABOUT,
            method: S::METHOD,
            steps: S::STEPS,
            input: S::Input::described(),
            settings: S::described(),
            schema: S::schema,
        }
    }
}

/// JSON Schema of an object with the settings of some of the `studies`, each by the name of its function.
#[must_use]
pub fn schema_of_settings(studies: &[Described]) -> Value {
    let mut generator = SchemaSettings::draft2020_12().into_generator();
    let mut properties = Map::new();
    for study in studies {
        let mut schema = (study.schema)(&mut generator);
        schema.insert("description".to_owned(), study.about.into());
        properties.insert(study.function.to_owned(), schema.to_value());
    }
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Settings of studies",
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
        "$defs": generator.take_definitions(true),
    })
}
