//! The parts of a study: tables of finished cases, each written completely or not at all.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use asperity::fingerprint::sha256;
use asperity_report::tables;
use asperity_storage::{StorageError, line_of_cells, save, whole_file, whole_text};
use serde::Serialize;

use super::case_list::CaseList;
use super::error::SweepError;
use super::study::{LARGEST_TABLE, Study};
use crate::map::ranges;

/// Rows by the numbers of their cases: the cells of a row as text.
pub(super) type CaseRows = BTreeMap<usize, Vec<String>>;

/// Progress of a study.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Status {
    /// Hash of the study.
    pub study: String,
    /// Cases of the study.
    pub cases: usize,
    /// Cases in closed parts.
    pub done: usize,
    /// Numbers of the cases that are not in a part, such as `1-4,9`.
    pub missing: String,
    /// Finished cases without a result by code.
    pub failed: BTreeMap<String, usize>,
    /// Parts.
    pub parts: usize,
}

/// Progress of a study by the parts in `folder`.
///
/// # Errors
/// When the study is not valid, or a part is damaged.
pub fn status(study: &Study, folder: &Path) -> Result<Status, SweepError> {
    let list = CaseList::new(study)?;
    let (rows, parts) = read(study, &list, folder)?;
    let missing: Vec<usize> = (0..list.count())
        .filter(|n| !rows.contains_key(n))
        .collect();
    let mut failed = BTreeMap::new();
    for code in rows.values().filter_map(|row| row.last()) {
        if !code.is_empty() {
            *failed.entry(code.clone()).or_insert(0) += 1;
        }
    }
    Ok(Status {
        study: study.hash.clone(),
        cases: list.count(),
        done: rows.len(),
        missing: ranges(&missing),
        failed,
        parts,
    })
}

/// Folder of the parts of one study.
pub(super) fn folder_of_parts(study: &Study, folder: &Path) -> PathBuf {
    folder.join(&study.hash)
}

/// Column of the codes of warnings about inputs outside of their ranges.
const OUTSIDE: &str = "outside";

/// Header of the table: number and id of the case, inputs, results, codes of warnings, error code.
pub(super) fn header(study: &Study, list: &CaseList) -> Vec<String> {
    let mut names = vec!["case".to_owned(), "id".to_owned()];
    names.extend(list.columns());
    names.extend(outputs(study));
    names.extend([OUTSIDE, "code"].map(str::to_owned));
    names
}

/// Columns of the results.
pub(super) fn outputs(study: &Study) -> Vec<String> {
    /// Default columns, also of a gear train.
    const USUAL: [&str; 4] = ["efficiency", "loss_w", "sliding_w", "rolling_w"];
    /// Further default columns of a pair of gears.
    const OF_PAIR: [&str; 2] = ["mu_equivalent", "mixed_share"];
    /// Further default columns if the case states losses of its gearbox; the other columns are for the meshes.
    const OF_GEARBOX: [&str; 2] = ["gearbox_efficiency", "gearbox_loss_w"];
    if let Some(columns) = &study.input.columns {
        return columns.clone();
    }
    let train = &study.case;
    let is_only = train.only().is_some();
    let of_pair = OF_PAIR.iter().filter(|_| is_only);
    let of_gearbox = OF_GEARBOX.iter().filter(|_| train.gearbox.is_some());
    let usual = USUAL.iter().chain(of_pair).chain(of_gearbox);
    let mut names: Vec<String> = usual.map(ToString::to_string).collect();
    names.extend(train.heat.iter().map(|_| "oil_c".to_owned()));
    if !is_only {
        names.extend(
            train
                .meshes()
                .map(|mesh| format!("mesh.{}.loss_w", mesh.name)),
        );
    }
    names
}

/// Table as text.
pub(super) fn text_of(
    header: &[String],
    rows: impl Iterator<Item = Vec<String>>,
    path: &Path,
) -> Result<Vec<u8>, SweepError> {
    let head = std::iter::once(header.to_vec());
    Ok(tables::text_of_cells(path, head.chain(rows))?)
}

/// Writes finished rows of a shard as a part.
pub(super) fn close(
    study: &Study,
    list: &CaseList,
    shard: usize,
    shards: usize,
    rows: &mut CaseRows,
    folder: &Path,
) -> Result<(), SweepError> {
    let Some(first) = rows.keys().next().copied() else {
        return Ok(());
    };
    let name = format!("part-{shard:04}-of-{shards:04}-{first:08}.csv");
    let path = folder_of_parts(study, folder).join(name);
    let rows = std::mem::take(rows);
    let table = text_of(&header(study, list), rows.into_values(), &path)?;
    let mut part = head(&study.name, &study.hash, &table).into_bytes();
    part.extend(table);
    save(&path, &part)?;
    Ok(())
}

/// Creates the folder of the parts.
pub(super) fn make_folder_of_parts(study: &Study, folder: &Path) -> Result<(), SweepError> {
    let folder_of_parts = folder_of_parts(study, folder);
    fs::create_dir_all(&folder_of_parts).map_err(StorageError::io(&folder_of_parts))?;
    Ok(())
}

/// Begin of the line with the name of the study, above the table of a part.
const STUDY: &str = "# study ";
/// Begin of the line with the fingerprint of its inputs.
const INPUTS: &str = "# inputs ";
/// Begin of the line with the SHA-256 of the table.
const SUM: &str = "# sha256 ";

/// Lines above the table of a part.
fn head(name: &str, hash: &str, table: &[u8]) -> String {
    let name: String = name.chars().filter(|c| !c.is_control()).collect();
    let name = line_of_cells(&name);
    format!("{STUDY}{name}\n{INPUTS}{hash}\n{SUM}{}\n", sha256(table))
}

/// The files of the closed parts in `folder_of_parts`, by name.
fn files_in(folder_of_parts: &Path) -> Vec<PathBuf> {
    let mut files: Vec<PathBuf> = match fs::read_dir(folder_of_parts) {
        Ok(entries) => entries.flatten().map(|entry| entry.path()).collect(),
        Err(_) => Vec::new(),
    };
    files.retain(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("part-") && name.ends_with(".csv")
    });
    files.sort();
    files
}

/// Other folders with parts of the same study that were computed from other inputs.
pub(super) fn other_inputs(study: &Study, folder: &Path) -> Vec<PathBuf> {
    let parts = folder_of_parts(study, folder);
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut others: Vec<PathBuf> = entries
        .map(|entry| entry.path())
        .filter(|path| *path != parts)
        .filter(|path| {
            let begin = head(&study.name, "", &[]);
            let first = files_in(path).into_iter().next();
            let text = first.and_then(|file| whole_text(&file, LARGEST_TABLE).ok());
            text.is_some_and(|text| text.lines().next() == begin.lines().next())
        })
        .collect();
    others.sort();
    others
}

/// The rows of all closed parts, and the number of parts.
pub(super) fn read(
    study: &Study,
    list: &CaseList,
    folder: &Path,
) -> Result<(CaseRows, usize), SweepError> {
    let files = files_in(&folder_of_parts(study, folder));
    let expected = (header(study, list), list.count());
    let mut rows = CaseRows::new();
    for path in &files {
        read_part(path, study, &expected.0, expected.1, &mut rows)?;
    }
    Ok((rows, files.len()))
}

fn read_part(
    path: &Path,
    study: &Study,
    expected: &[String],
    count: usize,
    rows: &mut CaseRows,
) -> Result<(), SweepError> {
    let refused = |reason: String| SweepError::Part {
        path: path.to_owned(),
        reason,
    };
    let bytes = whole_file(path, LARGEST_TABLE).map_err(|error| refused(error.to_string()))?;
    let mut lines = bytes.splitn(4, |byte| *byte == b'\n');
    let mut after = |word: &str| {
        let line = lines.next().and_then(|line| std::str::from_utf8(line).ok());
        let rest = line.and_then(|line| line.strip_prefix(word));
        rest.map(str::to_owned)
            .ok_or_else(|| refused(format!("no line {word:?} above its table")))
    };
    let (_, inputs, sum) = (after(STUDY)?, after(INPUTS)?, after(SUM)?);
    if inputs != study.hash {
        let now = &study.hash;
        return Err(refused(format!(
            "it was computed from inputs {inputs}, now they are {now}"
        )));
    }
    let table = lines.next().unwrap_or_default();
    if sha256(table) != sum {
        return Err(refused(
            "it is damaged: its table has another SHA-256 than it states".to_owned(),
        ));
    }
    let lines = asperity_table::own::cells(table).map_err(|source| refused(source.to_string()))?;
    let mut lines = lines.into_iter();
    if lines.next().as_deref() != Some(expected) {
        return Err(refused("it has other columns".to_owned()));
    }
    for cells in lines {
        let number = cells[0]
            .parse()
            .ok()
            .filter(|number: &usize| *number < count);
        let number = number.ok_or_else(|| refused(format!("there is no case {}", cells[0])))?;
        match rows.get(&number) {
            Some(other) if *other != cells => {
                return Err(SweepError::Contradiction {
                    path: path.to_owned(),
                    number,
                });
            }
            _ => rows.insert(number, cells),
        };
    }
    Ok(())
}
