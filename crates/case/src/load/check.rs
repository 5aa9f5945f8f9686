//! All errors of a case at once, before a run.
//!
//! Reading stops at the first error. The check records each error, replaces its value from a valid case, and reads the case
//! again until there is no error. Errors in a table that was replaced are skipped, since the replacement may cause them.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use serde_json::Value as Json;
use toml::{Table, Value};

use crate::error::Error;
use crate::input::case_input::{CaseInput, TEMPERATURE_KEYS};
use crate::input::files::{Files, Reader};
use crate::input::ranges::impossible;
use crate::loaded::loaded_case::{LoadedCase, complete};
use crate::source::case_error::CaseError;
use crate::source::source_text::{MeshKeys, Source};
use crate::text::case_file::{
    CaseFile, VALID, VALID_OF_NAMED, names_meshes, remove_replaced, schema_with,
};
use crate::text::known_keys::first_unknown;
use crate::text::plain_words::plain;
use crate::text::written;
use crate::train::gear_train::Train;
use crate::train::train_input::OfAllMeshes;
use asperity_core::message::Code;

/// No case has more errors than keys.
const MAX_ERRORS: usize = 200;

/// The errors of a case, or the case.
#[derive(Debug)]
#[non_exhaustive]
pub struct Findings {
    /// Every error, in the order of the checks; empty if the case can be run.
    pub errors: Vec<Error>,
    /// The case with its traces; `None` after an error.
    pub case: Option<Train>,
}

/// Reads the case in `source` and the traces it names relative to `folder`, with keys set by their paths.
pub fn check(source: Source, folder: &Path, set: &[(String, String)]) -> Findings {
    let mut source = source;
    let mut errors = Vec::new();
    let case = all(&mut source, folder, set, &mut errors);
    let errors = in_text(errors, source);
    Findings {
        case: case.filter(|_| errors.is_empty()),
        errors,
    }
}

/// The errors with the text that they share.
fn in_text(errors: Vec<CaseError>, text: Source) -> Vec<Error> {
    let text = Arc::new(text);
    let errors = errors.into_iter();
    errors
        .map(|error| Error::in_text(error, Arc::clone(&text)))
        .collect()
}

fn all(
    source: &mut Source,
    folder: &Path,
    set: &[(String, String)],
    errors: &mut Vec<CaseError>,
) -> Option<Train> {
    let (input, mending) = readable(source, set, errors)?;
    if !input.names_meshes() {
        return completed(input, source, folder, mending, errors).map(Train::from);
    }
    errors.extend(impossible(&OfAllMeshes(&input), source));
    let files = Files::in_folder(folder);
    let parts = match input.parts(source, Reader::new(&files)) {
        Ok(parts) => parts,
        Err(error) => {
            let is_blamed = CaseInput::NAMED.iter().any(|table| mending.is_known(table));
            let is_known = errors
                .iter()
                .any(|known| identity(known) == identity(&error));
            if !is_blamed && !is_known {
                errors.push(error);
            }
            return None;
        }
    };
    let mut cases = Vec::new();
    for mesh in parts.meshes() {
        let source = source.of_mesh(&mesh.keys);
        let mending = mending.of_mesh(&mesh.keys)?;
        let mut of_mesh = Vec::new();
        cases.extend(completed(
            mesh.case.clone(),
            &source,
            folder,
            mending,
            &mut of_mesh,
        ));
        // Errors of shared keys occur in all meshes.
        let known: BTreeSet<_> = errors.iter().map(identity).collect();
        let is_new = |error: &CaseError| !known.contains(&identity(error));
        errors.extend(of_mesh.into_iter().filter(is_new));
    }
    let is_whole = cases.len() == parts.meshes().count();
    is_whole.then(|| Train::from_parts(parts, cases, input))
}

/// Identity of an error: its code with its line, or with its text if it has no line.
fn identity(error: &CaseError) -> (Code, Option<usize>, String) {
    let line = error.place().and_then(|place| place.line);
    let text = line.map_or_else(|| error.to_string(), |_| String::new());
    (error.code(), line, text)
}

/// The case in `source` with keys set by their paths; values that cannot be read are recorded and replaced by valid ones.
fn readable(
    source: &mut Source,
    set: &[(String, String)],
    errors: &mut Vec<CaseError>,
) -> Option<(CaseInput, Mending)> {
    let right = if names_meshes(source) {
        VALID_OF_NAMED
    } else {
        VALID
    };
    let mut mending = Mending {
        right: right.parse().ok()?,
        schema: CaseInput::schema_of(source),
        blamed: BTreeSet::new(),
        replaced: BTreeSet::new(),
    };
    let mut table = match source.table() {
        Ok(table) => table,
        Err(error) => {
            errors.push(error);
            return None;
        }
    };
    remove_unknown(&mut table, source, &mut mending, errors);
    let mut input = mending.read(table, source, errors)?;
    input.make_way_for(set.iter().map(|(key, _)| key.as_str()));
    for (key, value) in set {
        if let Err(error) = input.set_in(source, key, value) {
            mending.blamed.insert(part_of(key).to_owned());
            errors.push(error);
        }
    }
    Some((input, mending))
}

/// The case with its traces; every error of its completion is recorded.
fn completed(
    mut input: CaseInput,
    source: &Source,
    folder: &Path,
    mut mending: Mending,
    errors: &mut Vec<CaseError>,
) -> Option<LoadedCase> {
    for error in impossible(&input, source) {
        let key = error.place().and_then(|place| place.key.clone());
        errors.push(error);
        mending.put_right(&mut input, part_of(&key?));
    }
    // Every round replaces a further part, and there are no more parts than keys.
    loop {
        let files = Files::in_folder(folder).into();
        let error = match complete(input.clone(), source, files, None) {
            Ok(case) => return Some(case),
            Err(error) => error,
        };
        let key = error.place().and_then(|place| place.key.clone());
        let part = key.as_deref().map(part_of);
        // A replaced or removed part may cause an error that is not the user's.
        if part.is_none_or(|part| !mending.is_known(part)) {
            errors.push(error);
        }
        if !mending.put_right(&mut input, part?) {
            return None;
        }
    }
}

/// Parts with errors, and parts replaced so far.
struct Mending {
    /// A valid case.
    right: Table,
    /// Schema of the case.
    schema: &'static Json,
    /// Parts with a recorded error.
    blamed: BTreeSet<String>,
    /// Parts that were replaced as a whole.
    replaced: BTreeSet<String>,
}

impl Mending {
    /// The parts of a mesh of a gear train.
    fn of_mesh(&self, mesh: &MeshKeys) -> Option<Self> {
        let blamed = self.blamed.iter().chain(&self.replaced);
        let in_mesh = blamed.map(|part| mesh.in_mesh(part).unwrap_or_else(|| part.clone()));
        Some(Self {
            right: VALID.parse().ok()?,
            schema: schema_with(false),
            blamed: in_mesh.map(|part| part_of(&part).to_owned()).collect(),
            replaced: BTreeSet::new(),
        })
    }

    /// Whether `part` has an error, or was replaced.
    fn is_known(&self, part: &str) -> bool {
        self.blamed.contains(part) || self.replaced.contains(part)
    }

    /// Replaces a part by the valid one; returns whether it was not replaced before.
    fn put_right(&mut self, input: &mut CaseInput, part: &str) -> bool {
        self.replaced.insert(part.to_owned()) && put_right(input, part, &self.right).is_some()
    }

    /// The case, with valid values instead of those that cannot be read.
    fn read(
        &mut self,
        mut table: Table,
        source: &Source,
        errors: &mut Vec<CaseError>,
    ) -> Option<CaseInput> {
        for _ in 0..MAX_ERRORS {
            let (key, message) = match CaseInput::from_keys(table.clone()) {
                Ok(input) => return Some(input),
                Err(error) => error,
            };
            let missing = missing_key(key.as_deref(), &message);
            let is_misspelt = missing
                .as_deref()
                .is_some_and(|key| self.blamed.contains(key));
            if !is_misspelt {
                errors.push(value_error(source, self.schema, key.clone(), &message));
            }
            let blamed = missing.or(key)?;
            self.blamed.insert(part_of(&blamed).to_owned());
            if !change(&mut table, &blamed, value_at(&self.right, &blamed)) {
                return None;
            }
        }
        None
    }
}

impl MeshKeys {
    /// The part of the mesh's case that `part` of the train describes.
    fn in_mesh(&self, part: &str) -> Option<String> {
        self.tables.iter().find_map(|(of_mesh, of_train)| {
            let rest = part.strip_prefix(of_train.as_str())?;
            (rest.is_empty() || rest.starts_with('.')).then(|| format!("{of_mesh}{rest}"))
        })
    }
}

/// Removes and records the unknown keys.
fn remove_unknown(
    table: &mut Table,
    source: &Source,
    mending: &mut Mending,
    errors: &mut Vec<CaseError>,
) {
    let mut unknown: BTreeSet<String> = BTreeSet::new();
    for path in source.key_paths() {
        let mut above = path.match_indices('.').map(|(end, _)| &path[..end]);
        if above.any(|table| unknown.contains(table)) {
            continue;
        }
        if let Some((key, nearest)) = first_unknown(mending.schema, std::iter::once(path)) {
            // The intended key will be missing.
            if let Some(meant) = &nearest {
                let meant = match key.rsplit_once('.') {
                    // A key of another table has its path already.
                    Some((table, _)) if !meant.contains('.') => format!("{table}.{meant}"),
                    _ => meant.clone(),
                };
                mending.blamed.insert(part_of(&meant).to_owned());
                mending.blamed.insert(meant);
            }
            errors.push(CaseError::unknown_key(
                source.place_of_key(key),
                key,
                nearest,
            ));
            unknown.insert(key.to_owned());
            change(table, key, None);
        }
    }
}

fn value_error(source: &Source, schema: &Json, key: Option<String>, message: &str) -> CaseError {
    CaseError::value(
        source.place_of(key.as_deref().unwrap_or_default()),
        key.as_deref(),
        plain(schema, key.as_deref(), message),
    )
}

/// The key missing in `table`, if that is the error.
fn missing_key(table: Option<&str>, message: &str) -> Option<String> {
    let rest = message.strip_prefix("missing field `")?;
    let name = &rest[..rest.find('`')?];
    Some(table.map_or(name.to_owned(), |table| format!("{table}.{name}")))
}

/// The part of a case that is replaced as a whole: a table with related keys, or a single key.
fn part_of(key: &str) -> &str {
    const WHOLE: [&str; 14] = [
        "calibration",
        "gearbox",
        "gears",
        "lubricant",
        "map",
        "micropitting",
        "surface.coast",
        "surface.pinion",
        "surface.wheel",
        // Tables of a planetary set.
        "planetary",
        "surface.sun",
        "surface.planet",
        "surface.ring",
        "vehicle",
    ];
    // The keys that state a temperature replace each other, and one of them the law of the bulk temperature.
    let is_temperature = TEMPERATURE_KEYS.iter().any(|(name, _)| *name == key);
    if is_temperature || key.starts_with("operation.bulk.") {
        return TEMPERATURE_KEYS[0].0;
    }
    let is_in = |part: &&str| {
        key.strip_prefix(*part)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    WHOLE
        .iter()
        .copied()
        .find(|part| is_in(part))
        .unwrap_or(key)
}

fn put_right(input: &mut CaseInput, part: &str, right: &Table) -> Option<()> {
    let mut table = written::table(input).ok()?;
    change(&mut table, part, value_at(right, part)).then_some(())?;
    let of_part = part.rsplit_once('.').map_or("", |(above, _)| above);
    if let Some(Value::Table(inner)) = table.get_mut(of_part) {
        remove_replaced(inner, part);
    }
    *input = CaseInput::from_keys(table).ok()?;
    Some(())
}

fn value_at(table: &Table, path: &str) -> Option<Value> {
    let mut parts = path.split('.');
    let mut value = table.get(parts.next()?)?;
    for part in parts {
        value = value.as_table()?.get(part)?;
    }
    Some(value.clone())
}

/// Puts `value` at `path`, or removes the value there; returns whether its tables exist.
fn change(table: &mut Table, path: &str, value: Option<Value>) -> bool {
    let (above, last) = path.rsplit_once('.').unwrap_or(("", path));
    let mut at = table;
    for part in above.split('.').filter(|part| !part.is_empty()) {
        match at.get_mut(part).and_then(Value::as_table_mut) {
            Some(inner) => at = inner,
            None => return false,
        }
    }
    match value {
        Some(value) => {
            at.insert(last.to_owned(), value);
            true
        }
        None => at.remove(last).is_some(),
    }
}
