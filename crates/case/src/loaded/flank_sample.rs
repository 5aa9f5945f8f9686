//! Several traces of a flank: the files that a list names, and their teeth.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::DomainError;
use asperity_flanks::generated_record::GeneratedRecord;
use asperity_flanks::trace_sites::{ScanRow, TraceSite};

use super::scans::Scan;
use crate::input::case_input::FlankInput;
use crate::input::files::{HeldTrace, Reader};
use crate::input::trace_list::{TraceInput, TraceList, is_pattern};
use crate::source::case_error::CaseError;
use crate::source::section::Section;

/// A trace of a list: the keys to read it by, its tooth and its place.
#[derive(Debug, Clone)]
pub(crate) struct Listed {
    /// Keys of a flank with only this trace.
    pub input: FlankInput,
    /// Whether it is an entry of a list.
    pub is_of_a_list: bool,
    /// Whether the list states its place.
    pub has_own_place: bool,
    /// Its tooth, and its place across the face.
    pub site: TraceSite,
    /// Engagements until it was measured.
    pub engagements: Option<f64>,
    /// The trace, if it was generated.
    pub generated: Option<GeneratedSample>,
    /// The scan that it is a row of, if this was read for its rows.
    pub scan: Option<Scan>,
}

/// A generated trace.
#[derive(Debug, Clone)]
pub(crate) struct GeneratedSample {
    /// Its heights, with the filters of the first measured trace.
    pub heights: Arc<HeldTrace>,
    pub record: GeneratedRecord,
}

impl Listed {
    /// Whether it is the file of a flank of which no line is named.
    pub(crate) fn is_without_line(&self) -> bool {
        let input = &self.input;
        !self.is_of_a_list
            && self.generated.is_none()
            && input.file.is_some()
            && input.row.is_none()
            && input.line.is_none()
    }

    /// The one trace of a flank without a list.
    pub(crate) fn alone(input: &FlankInput) -> Self {
        Self {
            input: input.clone(),
            is_of_a_list: false,
            has_own_place: false,
            site: TraceSite::default(),
            engagements: None,
            generated: None,
            scan: None,
        }
    }
}

/// The traces that the list of a flank names, which is at `key` of its table.
pub(crate) fn listed(
    flank: &FlankInput,
    key: &str,
    list: &TraceList,
    section: Section<'_>,
    files: &Reader<'_>,
) -> Result<Vec<Listed>, CaseError> {
    let conflict = |rule| section.conflict(key, rule);
    let mut named: Vec<TraceInput> = Vec::new();
    for entry in list.entries() {
        let files = matching(&entry.file, key, section, files)?.into_iter();
        named.extend(files.map(|file| TraceInput {
            file,
            ..entry.clone()
        }));
    }
    if named.is_empty() {
        return Err(conflict("names no trace; give at least one, or file"));
    }
    if key != "after" && named.iter().any(|trace| trace.engagements.is_some()) {
        return Err(conflict("is not after a test; engagements belong to after"));
    }
    let mut teeth: Vec<Option<u32>> = Vec::new();
    let mut traces: Vec<Listed> = Vec::with_capacity(named.len());
    for trace in named {
        let known = teeth
            .iter()
            .position(|tooth| tooth.is_some() && *tooth == trace.tooth);
        let tooth = known.unwrap_or_else(|| {
            teeth.push(trace.tooth);
            teeth.len() - 1
        });
        if let Some(y) = trace.y {
            DomainError::non_negative("y", y).map_err(section.domain(key))?;
        }
        let is_again = |other: &Listed| {
            other.site.tooth != tooth
                && other.input.file.as_ref() == Some(&trace.file)
                && other.input.row == trace.row.or(flank.row)
        };
        if traces.iter().any(is_again) {
            return Err(conflict(
                "names a trace of several teeth: the scatter between teeth needs a trace of each",
            ));
        }
        let same = traces.iter().filter(|other| other.site.tooth == tooth);
        for other in same {
            if trace.y.is_none() || other.site.y.is_none() {
                return Err(conflict(
                    "several traces of one tooth need y, the place across the face, each",
                ));
            }
            if trace.y == other.site.y {
                return Err(conflict("two traces are of the same tooth at the same y"));
            }
        }
        traces.push(Listed {
            input: FlankInput {
                file: Some(trace.file),
                traces: None,
                like: None,
                after: None,
                engagements: None,
                from: trace.from.or(flank.from),
                at: trace.at.or(flank.at),
                row: trace.row.or(flank.row),
                range: trace.range.or(flank.range),
                ..flank.clone()
            },
            is_of_a_list: true,
            has_own_place: trace.at.is_some() || trace.from.is_some(),
            site: TraceSite {
                tooth,
                number: trace.tooth,
                y: trace.y,
                row: None,
            },
            engagements: trace.engagements,
            generated: None,
            scan: None,
        });
    }
    Ok(traces)
}

/// `rows` of the rows of the scan of a flank, in the middles of as many equal parts or where fewer heights are missing near them.
pub(crate) fn rows(
    flank: &FlankInput,
    rows: usize,
    scan: Option<&Scan>,
    section: Section<'_>,
) -> Result<Vec<Listed>, CaseError> {
    if flank.row.is_some() || flank.line.is_some() {
        return Err(section.conflict("rows", "takes several rows; leave row and line out"));
    }
    let name = "number of rows";
    let rule = "must be from 1 to the number of rows of the surface";
    let has = scan.map_or(1, |scan| scan.surface.rows);
    DomainError::require((1..=has).contains(&rows), name, rows as f64, "-", rule)
        .map_err(section.domain("rows"))?;
    let listed = |k: usize| {
        let row = scan.map_or(1, |scan| scan.row_of_part(k, rows, flank.range));
        let mut trace = Listed::alone(&FlankInput {
            row: Some(row),
            rows: None,
            ..flank.clone()
        });
        trace.scan = scan.cloned();
        trace.site.tooth = k;
        let apart = scan.and_then(|scan| scan.surface.dy);
        trace.site.row = Some(ScanRow {
            number: row,
            along_lead: apart.map(|apart| apart * (row - 1) as f64),
        });
        trace
    };
    Ok((0..rows).map(listed).collect())
}

/// Files whose names match `path`, sorted.
fn matching(
    path: &Path,
    key: &str,
    section: Section<'_>,
    reader: &Reader<'_>,
) -> Result<Vec<PathBuf>, CaseError> {
    if !is_pattern(path) {
        return Ok(vec![path.to_owned()]);
    }
    let found = reader.files.matching(path);
    if !found.is_empty() {
        return Ok(found);
    }
    let folder = reader.files.folder().map(|folder| {
        let shown = folder.join(path.parent().unwrap_or(Path::new("")));
        match shown.display().to_string() {
            shown if shown.is_empty() => ".".to_owned(),
            shown => shown,
        }
    });
    let (place, key) = (section.place(key), section.key(key));
    Err(CaseError::no_traces(place, key, path.display(), folder))
}
