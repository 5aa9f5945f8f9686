//! The result folder: written as a whole, next to its target and then moved there, and read back.

use crate::error;
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use asperity::UnsolvedContact;
use asperity::pipeline::Kept;
use asperity::result::{MeshOutcome, RunResult, SCHEMA_VERSION};
use asperity::train::Whole;
use asperity_core::Fault;
use asperity_storage::{check_written, json_line, save, whole_file, write_among};
use serde::de::Error as _;
use serde::{Deserialize, Serialize};

use crate::page_tables::{PageTables, shown_position};
use crate::tables::{self, CONVERGENCE, ContactTables, FlankTables, PATCH, folder_of};
use crate::{html, scans};

/// The file that marks a folder as a result.
const MARK: &str = "result.json";
/// The file that marks a folder as a planetary result.
pub(crate) const PLANETARY_MARK: &str = "planetary.json";
/// The file that marks a folder as the result of a gear train.
pub(crate) const TRAIN_MARK: &str = "train.json";
/// The page of a result.
pub const PAGE: &str = "report.html";
/// Thinned tables of the page.
const PAGE_TABLES: &str = "page.json";
/// Largest table in bytes that is read back.
const LARGEST: u64 = 1_000_000_000;

/// All points of the load map, on request.
const MAP: &str = "map.csv";

/// Fields along the contact in a result folder, in addition to its page.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum Fields {
    /// Only the thinned fields of the page.
    #[default]
    Page,
    /// All fields of these positions, counted from 1 at A, and the tables of the flanks.
    Positions(Vec<usize>),
    /// All fields of all positions, and the tables of the flanks.
    All,
}

impl Fields {
    /// The fields that a run must hold for this folder and its page.
    #[must_use]
    pub fn kept(&self) -> Kept {
        match self {
            Self::Page => Kept::Highest,
            Self::Positions(numbers) => Kept::Positions(numbers.clone()),
            Self::All => Kept::All,
        }
    }

    fn keep(&self, position: usize) -> bool {
        match self {
            Self::Page => false,
            Self::Positions(numbers) => numbers.contains(&position),
            Self::All => true,
        }
    }
}

/// Title of the result in folder `target`; `None` if there is none, or no title can be read.
pub fn title_of(target: &Path) -> Option<String> {
    let mut marks = [MARK, PLANETARY_MARK, TRAIN_MARK].iter();
    marks.find_map(|mark| title_in(&target.join(mark)))
}

/// Title of the result or study in the JSON file `file`; `None` if it cannot be read.
pub(crate) fn title_in(file: &Path) -> Option<String> {
    #[derive(serde::Deserialize)]
    struct Titled {
        title: String,
    }
    let titled: Titled = read_json(file, |json| serde_json::from_slice(json)).ok()?;
    Some(titled.title)
}

/// Checks that `outcome` holds the fields to write.
pub(crate) fn check_fields(outcome: &MeshOutcome, fields: &Fields) -> Result<(), Fault> {
    let Fields::Positions(numbers) = fields else {
        return Ok(());
    };
    for &number in numbers {
        shown_position(&outcome.result, Some(number))?;
        if outcome.fields.iter().all(|held| held.position != number) {
            return Err(error::no_fields(number, None));
        }
    }
    Ok(())
}

/// Name and content of the table of all points of the load map.
pub fn load_points(outcome: &MeshOutcome) -> Result<(String, Vec<u8>), Fault> {
    let text = tables::text(Path::new(MAP), tables::load_points(&outcome.load_map))?;
    Ok((MAP.to_owned(), text))
}

/// Writes the gap of a contact without solution as CSV.
///
/// # Errors
/// When a file cannot be written.
pub fn write_unsolved(contact: &UnsolvedContact, file: &Path) -> Result<(), Fault> {
    let mut text = String::from("x_m,h_m\n");
    for (x, h) in contact.x.iter().zip(&contact.gap) {
        text.push_str(&format!("{x:e},{h:e}\n"));
    }
    if let Some(parent) = file.parent() {
        make_folder(parent)?;
    }
    Ok(save(file, text.as_bytes())?)
}

pub(crate) fn fill(outcome: &MeshOutcome, folder: &Path, fields: &Fields) -> Result<(), Fault> {
    let whole = PageTables::new(outcome, None)?;
    for (name, text) in texts_of(outcome, &whole)? {
        write_bytes(&folder.join(name), &text)?;
    }
    if *fields != Fields::Page {
        write_fields(outcome, &whole, folder, fields)?;
    }
    Ok(())
}

/// Name and content of a file.
pub(crate) type FileText = (&'static str, Vec<u8>);

/// The files of the folder of a mesh without fields, in memory.
pub(crate) fn texts_of_mesh(outcome: &MeshOutcome) -> Result<Vec<FileText>, Fault> {
    texts_of(outcome, &PageTables::new(outcome, None)?)
}

fn texts_of(outcome: &MeshOutcome, whole: &PageTables) -> Result<Vec<FileText>, Fault> {
    fn table<R: Serialize>(
        name: &'static str,
        rows: impl IntoIterator<Item = R>,
    ) -> Result<FileText, Fault> {
        Ok((name, tables::text(Path::new(name), rows)?))
    }
    let result = &outcome.result;
    let shown = whole.thinned(result, PAGE_TABLES)?;
    let page_tables = json_line(&shown).map_err(error::not_json(Path::new(PAGE_TABLES)))?;
    let mut files = vec![
        (MARK, json_text(Path::new(MARK), result)?.into_bytes()),
        table("path.csv", &result.path)?,
        table("load.csv", &result.load.path)?,
        table("offsets.csv", &outcome.offsets)?,
        table("losses.csv", tables::losses(result))?,
        table("friction_laws.csv", tables::friction_laws(result))?,
        (PAGE_TABLES, page_tables.into_bytes()),
        (PAGE, html::render(result, &shown)?.into_bytes()),
    ];
    for table in scans::tables(result) {
        files.push(table.file_text()?);
    }
    Ok(files)
}

fn write_fields(
    outcome: &MeshOutcome,
    whole: &PageTables,
    folder: &Path,
    fields: &Fields,
) -> Result<(), Fault> {
    tables::write(&folder.join("load_map.csv"), &whole.load_map)?;
    for (body, record) in outcome.result.flanks.iter().enumerate() {
        let flank = FlankTables::new(record, outcome.traces[body].as_ref());
        if let Some(flank) = flank.map_err(error::of_flank)? {
            flank.write(folder, body)?;
        }
    }
    let selected = || outcome.fields.iter().filter(|at| fields.keep(at.position));
    let steps: Vec<_> = selected().flat_map(tables::convergence).collect();
    if !steps.is_empty() {
        tables::write(&folder.join(CONVERGENCE), &steps)?;
    }
    for fields in selected() {
        if let Some(row) = shown_position(&outcome.result, Some(fields.position))? {
            let place = folder.join(folder_of(fields.position));
            make_subfolder(&place)?;
            write_position(&ContactTables::new(fields, row), &place)?;
        }
    }
    Ok(())
}

fn write_position(contact: &ContactTables, place: &Path) -> Result<(), Fault> {
    tables::write(&place.join("surface.csv"), &contact.surface)?;
    if !contact.subsurface.is_empty() {
        tables::write(&place.join("subsurface.csv"), &contact.subsurface)?;
    }
    if let Some(patch) = &contact.patch {
        tables::write(&place.join(PATCH), patch.rows())?;
    }
    Ok(())
}

/// Writes `value` as JSON that ends with a line feed.
///
/// # Errors
/// When a file cannot be written, a number is not finite, or JSON cannot hold the value.
pub fn write_json(file: &Path, value: &dyn erased_serde::Serialize) -> Result<(), Fault> {
    write_text(file, &json_text(file, value)?)
}

/// Value as JSON that ends with a line feed; `file` is the name in messages.
pub(crate) fn json_text(file: &Path, value: &dyn erased_serde::Serialize) -> Result<String, Fault> {
    let mut text = asperity_storage::json_text(value).map_err(error::not_json(file))?;
    text.push('\n');
    Ok(text)
}

/// Writes `text` into a folder under construction.
///
/// # Errors
/// When a file cannot be written.
pub fn write_text(file: &Path, text: &str) -> Result<(), Fault> {
    write_bytes(file, text.as_bytes())
}

/// Writes `bytes` as a new file into a folder under construction.
///
/// # Errors
/// When a file cannot be written, or another one has its name.
pub fn write_bytes(file: &Path, bytes: &[u8]) -> Result<(), Fault> {
    let written = fs::File::create_new(file).and_then(|mut new| new.write_all(bytes));
    written.map_err(error::io(file))
}

/// Makes `folder` and its parents.
///
/// # Errors
/// When a file cannot be written.
pub fn make_folder(folder: &Path) -> Result<(), Fault> {
    fs::create_dir_all(folder).map_err(error::io(folder))
}

/// Makes `folder` in a folder under construction, but not that folder itself, which a signal may have removed.
///
/// # Errors
/// When a file cannot be written.
pub(crate) fn make_subfolder(folder: &Path) -> Result<(), Fault> {
    fs::create_dir(folder).map_err(error::io(folder))
}

/// Reads a result from its JSON. Not generic, so that other crates do not compile the reader again.
///
/// # Errors
/// When a value is missing or damaged.
pub fn parse_result(json: &str) -> Result<RunResult, serde_json::Error> {
    parsed(json.as_bytes())
}

/// The version of the names and meanings in a result.
#[derive(Deserialize)]
struct Version {
    schema_version: u32,
}

fn parsed(json: &[u8]) -> Result<RunResult, serde_json::Error> {
    if let Ok(Version { schema_version }) = serde_json::from_slice(json)
        && schema_version != SCHEMA_VERSION
    {
        return Err(serde_json::Error::custom(format!(
            "schema version {schema_version}, and this program reads {SCHEMA_VERSION}; run the case again"
        )));
    }
    serde_json::from_slice(json)
}

/// Reads `train.json` or `planetary.json`, the values of a gear train as a whole.
///
/// # Errors
/// When the file does not exist, or a value in it is missing or damaged.
pub fn read_whole(file: &Path) -> Result<Whole, Fault> {
    read_json(file, |bytes| serde_json::from_slice(bytes))
}

/// Reads a result from its folder or its `result.json`, and returns the folder and the result.
///
/// # Errors
/// When there is no result, or a value of it is missing or damaged.
pub fn read_result(path: &Path) -> Result<(PathBuf, RunResult), Fault> {
    let holds = |mark: &&str| path.join(mark).is_file();
    if !holds(&MARK) && [PLANETARY_MARK, TRAIN_MARK].iter().any(holds) {
        return Err(error::of_train(path));
    }
    let file = if path.is_dir() {
        path.join(MARK)
    } else {
        path.to_owned()
    };
    let folder = match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    };
    let result = read_json(&file, parsed)?;
    Ok((folder, result))
}

fn read_json<T>(
    file: &Path,
    parsed: impl Fn(&[u8]) -> Result<T, serde_json::Error>,
) -> Result<T, Fault> {
    let refused = |reason| error::not_a_result(file, reason);
    let bytes = whole_file(file, LARGEST).map_err(|error| match error.kind() {
        std::io::ErrorKind::Other => refused("it is not a file, or too large for a result"),
        _ => refused("there is no such file"),
    })?;
    parsed(&bytes).map_err(|error| {
        if error.is_data() {
            error::damaged(file, &value_path(&bytes, &error), error)
        } else {
            refused("it is not JSON")
        }
    })
}

/// Path of the value at which reading JSON failed, `path[0].s_mm`; empty for the whole.
///
/// A reader that tracks the path is compiled again for every type, and was a third of this crate.
fn value_path(json: &[u8], error: &serde_json::Error) -> String {
    let lines = json.split_inclusive(|byte| *byte == b'\n');
    let before: usize = lines
        .take(error.line().saturating_sub(1))
        .map(<[u8]>::len)
        .sum();
    let end = (before + error.column()).min(json.len());
    // The containers that are open at the error: the last key of an object, the index in an array.
    let mut open: Vec<Step> = Vec::new();
    let mut rest = &json[..end];
    while let [byte, after @ ..] = rest {
        rest = after;
        match byte {
            b'{' => open.push(Step::Key(String::new())),
            b'[' => open.push(Step::Index(0)),
            b'}' | b']' => drop(open.pop()),
            b',' => {
                if let Some(Step::Index(index)) = open.last_mut() {
                    *index += 1;
                }
            }
            b'"' => {
                let is_escape =
                    |k: usize| rest[..k].iter().rev().take_while(|b| **b == b'\\').count() % 2 == 1;
                let length = (0..rest.len()).find(|k| rest[*k] == b'"' && !is_escape(*k));
                let (text, after) = rest.split_at(length.unwrap_or(rest.len()));
                rest = after.get(1..).unwrap_or_default();
                // Text before a colon is a key.
                if let (Some(Step::Key(key)), b':') = (open.last_mut(), next_byte(rest)) {
                    *key = String::from_utf8_lossy(text).into_owned();
                }
            }
            _ => {}
        }
    }
    let mut path = String::new();
    for step in open {
        match step {
            Step::Key(key) if key.is_empty() => {}
            Step::Key(key) if path.is_empty() => path = key,
            Step::Key(key) => path.extend([".", &key]),
            Step::Index(index) => path += &format!("[{index}]"),
        }
    }
    path
}

/// Place of a value in the object or array that holds it.
enum Step {
    Key(String),
    Index(usize),
}

/// The next byte that is not white space; a space at the end.
fn next_byte(text: &[u8]) -> u8 {
    let next = text.iter().find(|byte| !byte.is_ascii_whitespace());
    next.copied().unwrap_or(b' ')
}

/// Redraws `report.html` next to the `result.json` at `path` (or in the folder `path`) and returns its path. The page
/// shows the fields of `position`, or of the position with the highest pressure.
///
/// # Errors
/// When the result cannot be read or was changed, the fields of `position` were not stored, or the page cannot be written.
pub fn redraw(path: &Path, position: Option<usize>) -> Result<PathBuf, Fault> {
    let (folder, result) = read_result(path)?;
    let name = path.file_name().filter(|_| !path.is_dir());
    let name = name.map_or(MARK.into(), |name| name.to_string_lossy().into_owned());
    let mut read = vec![name, PAGE_TABLES.to_owned()];
    let mut shown: PageTables = read_json(&folder.join(PAGE_TABLES), |json| {
        serde_json::from_slice(json)
    })?;
    let chosen = shown_position(&result, position)?;
    let is_there = |number: usize| {
        shown
            .contact
            .as_ref()
            .is_some_and(|at| at.position == number)
    };
    if let Some(row) = chosen.filter(|row| !is_there(row.position)) {
        let contact = ContactTables::read(&folder, row.position)?;
        read.extend(ContactTables::files(&folder, row.position));
        shown.contact = match (contact, position) {
            (Some(contact), _) => Some(contact),
            (None, None) => None,
            (None, Some(number)) => {
                return Err(error::no_fields(number, Some(&folder)));
            }
        };
        let whole = PageTables {
            flanks: [None, None],
            ..shown.clone()
        };
        shown.contact = whole.thinned(&result, PAGE_TABLES)?.contact;
    }
    let read: Vec<&str> = read.iter().map(String::as_str).collect();
    check_written(&folder, "result", &read)?;
    let page = html::render(&result, &shown)?;
    write_among(&folder, &[(PAGE.to_owned(), page.into_bytes())])?;
    Ok(folder.join(PAGE))
}
