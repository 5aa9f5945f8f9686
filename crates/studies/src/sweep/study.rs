//! A study: its file, its case, and the fingerprint of both and of all files that they name.

use std::path::{Path, PathBuf};

use asperity::case::{FileSums, Train};
use asperity::fingerprint::Fingerprint;
use asperity_storage::{whole_file, whole_text};

use super::axes::SweepAxes;
use super::error::{SweepError, unopened};
use super::study_input::StudyInput;

/// Name of a study that was not read from a file.
const IN_MEMORY: &str = "study";
/// Largest size of a study in bytes.
const LARGEST_STUDY: u64 = 10_000_000;
/// Largest size of a table of a study in bytes.
pub(super) const LARGEST_TABLE: u64 = 1_000_000_000;

/// Study with its case.
#[derive(Debug, Clone)]
pub struct Study {
    pub(super) input: StudyInput,
    /// The case of the study, a pair of gears or a gear train.
    pub case: Train,
    /// Name of the study, without folder and extension.
    pub name: String,
    /// First sixteen hexadecimal digits of the fingerprint of all inputs of the study: the study, its table, the case, the
    /// files that any case reads, and the program version.
    pub hash: String,
    /// Folder of the study.
    pub folder: PathBuf,
    pub(super) axes: SweepAxes,
    /// Table of the sample, if it is a list.
    pub(super) table: Option<Vec<u8>>,
    /// Hashes of the files that any case of the study reads.
    pub(super) sums: FileSums,
}

impl Study {
    /// Reads the study in `file` and the case that it names.
    ///
    /// # Errors
    /// When either cannot be read.
    pub fn load(file: &Path) -> Result<Self, SweepError> {
        let text = whole_text(file, LARGEST_STUDY).map_err(|source| unopened(file, source))?;
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        let input = StudyInput::of_toml(&text).map_err(|error| SweepError::Study {
            path: file.to_owned(),
            message: error.to_string().trim().replace('\n', "; "),
        })?;
        let case_file = input.case.as_ref();
        let case_file = case_file.ok_or_else(|| SweepError::Study {
            path: file.to_owned(),
            message: "missing field `case`".to_owned(),
        })?;
        let case = case_of(&folder.join(case_file), input.mesh.as_deref())?;
        let stem = file.file_stem().unwrap_or_default();
        let name = stem.to_string_lossy().into_owned();
        Self::new(input, &text.replace('\r', ""), case, name, folder)
    }

    /// Makes a study of `case` with the other keys of a study file, as the text of a JSON object; files that it names are
    /// relative to `folder`.
    ///
    /// # Errors
    /// When the text is not a valid study, or a file cannot be read.
    pub fn of_case(case: impl Into<Train>, text: &str, folder: &Path) -> Result<Self, SweepError> {
        let input = serde_json::from_str(text).map_err(|error| {
            let message = error.to_string();
            // Nobody wrote the lines of this text.
            let place = format!(" at line {} column {}", error.line(), error.column());
            SweepError::key(IN_MEMORY, message.strip_suffix(&place).unwrap_or(&message))
        })?;
        let (name, folder) = (IN_MEMORY.to_owned(), folder.to_owned());
        Self::new(input, text, case.into(), name, folder)
    }

    fn new(
        input: StudyInput,
        text: &str,
        case: Train,
        name: String,
        folder: PathBuf,
    ) -> Result<Self, SweepError> {
        let table = match input
            .sample
            .as_ref()
            .and_then(|sample| sample.file.as_ref())
        {
            None => None,
            Some(list) => {
                let path = folder.join(list);
                let bytes = whole_file(&path, LARGEST_TABLE);
                Some(bytes.map_err(|source| unopened(&path, source))?)
            }
        };
        let axes = SweepAxes::from_input(&input)?;
        let sums = axes.files(&case);
        let mut hash = Fingerprint::default()
            .with(text)
            .with(table.as_deref().unwrap_or_default())
            .with(case.fingerprint());
        for (name, sum) in &sums {
            hash = hash.with(name.as_os_str().as_encoded_bytes()).with(sum);
        }
        Ok(Self {
            input,
            case,
            name,
            hash: short(hash),
            folder,
            axes,
            table,
            sums,
        })
    }
}

/// The case in `file`, or its mesh called `mesh`.
fn case_of(file: &Path, mesh: Option<&str>) -> Result<Train, SweepError> {
    let train = Train::load(file)?;
    let Some(mesh) = mesh else { return Ok(train) };
    train.of_mesh(mesh).map_err(|error| SweepError::Study {
        path: file.to_owned(),
        message: format!("`mesh` of the study must name one of the meshes: {error}"),
    })
}

/// The first sixteen digits of a fingerprint.
pub(super) fn short(fingerprint: Fingerprint) -> String {
    fingerprint.hex()[..16].to_owned()
}
