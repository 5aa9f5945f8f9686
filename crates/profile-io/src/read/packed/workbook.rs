//! Workbooks (`.xlsx`, `.ods`, `.xls`): the longest table of numbers in a sheet, read as a table of text with its labels.
//!
//! The rows of the table keep their numbers, so that messages name them. A row above the table is a line of the header:
//! the labels of the columns, or a name with its value. Mitutoyo SurfTest workbooks (`.xlsx` of the USB communication
//! tool) have no labels: sheet `Certificate` states the conditions as label and value side by side (`Profile` R,
//! `Cut-Off` 0.08mm, λs), sheet `DATA` holds printed results in column A ("Ra 0.018 µm") and the profile in two columns,
//! x in millimetres and heights in micrometres.

use super::archive::Archive;
use super::sheet::{MOST_COLUMNS, MOST_ROWS, MOST_TEXTS, Sheet, SheetBlock};
use super::xls;
use super::xml::walk;
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::header::FilterState;
use crate::read::metadata::{self, Metadata, PrintedParameter, short};
use crate::read::options::ReadOptions;
use crate::read::text::Stream;

const FORMAT: Format = Format::Excel;

/// The table of a workbook as text, and what the workbook says about it.
pub(super) struct Table {
    pub text: String,
    pub format: Format,
    pub filter_state: FilterState,
    pub metadata: Metadata,
    /// Whether `row` of the options chose the sheet.
    pub is_chosen: bool,
}

/// The sheets of a workbook.
fn sheets(format: Format, stream: &mut dyn Stream, size: u64) -> Result<Vec<Sheet>, ReadFault> {
    if format == Format::ExcelBinary {
        return xls::sheets(stream, size);
    }
    let mut archive = Archive::open(FORMAT, stream, size)?;
    if archive.holds("content.xml") {
        open_document(&mut archive)
    } else {
        office_open(&mut archive)
    }
}

/// All cells of the only sheet of a workbook with rows of numbers, as text with tabs.
pub(super) fn text(
    format: Format,
    stream: &mut dyn Stream,
    size: u64,
) -> Result<String, ReadFault> {
    let sheets = sheets(format, stream, size)?;
    let mut tables: Vec<String> = sheets.iter().filter_map(Sheet::table).collect();
    match (tables.pop(), tables.len()) {
        (Some(table), 0) => Ok(table),
        (None, _) => Err(ReadFault::not_table(format)),
        (_, others) => Err(ReadFault::several_tables(others + 1)),
    }
}

/// Reads the table of a workbook: of several sheets with tables as long, the one that `options` chooses.
pub(super) fn read(
    format: Format,
    stream: &mut dyn Stream,
    size: u64,
    options: &ReadOptions,
) -> Result<Table, ReadFault> {
    let sheets = sheets(format, stream, size)?;
    let mut metadata = Metadata::default();
    let mut filter_state = FilterState::Unknown;
    let mut is_mitutoyo = false;
    for sheet in &sheets {
        let labels = sheet.labels.iter().map(|(.., label)| label.as_str());
        is_mitutoyo |= describe(
            &labels.collect::<Vec<_>>(),
            &mut metadata,
            &mut filter_state,
        );
    }
    if !is_mitutoyo {
        (metadata, filter_state) = (Metadata::default(), FilterState::Unknown);
    }
    let tables: Vec<(&Sheet, SheetBlock)> = sheets
        .iter()
        .filter_map(|sheet| Some((sheet, sheet.block()?)))
        .collect();
    let longest = tables
        .iter()
        .map(|(_, block)| block.rows)
        .max()
        .unwrap_or(0);
    let longest: Vec<_> = tables
        .iter()
        .filter(|(_, block)| block.rows == longest)
        .collect();
    let is_chosen = longest.len() > 1;
    let asked = if is_chosen {
        options.row.unwrap_or(0)
    } else {
        1
    };
    let Some((sheet, block)) = asked.checked_sub(1).and_then(|at| longest.get(at)) else {
        return Err(match longest.first() {
            None => ReadFault::no_heights(format, "no columns of a hundred numbers"),
            Some((_, block)) => ReadFault::several_profiles(longest.len(), block.rows, options.row),
        });
    };
    let units = is_mitutoyo.then_some("x [mm]\tz [um]");
    Ok(Table {
        text: sheet.text(block, units),
        format: if is_mitutoyo {
            Format::MitutoyoXlsx
        } else {
            format
        },
        filter_state,
        metadata,
        is_chosen,
    })
}

/// The sheets of an `.xlsx`.
fn office_open(archive: &mut Archive<'_>) -> Result<Vec<Sheet>, ReadFault> {
    let texts = texts(archive)?;
    let mut sheets = Vec::new();
    for number in 1.. {
        let name = format!("xl/worksheets/sheet{number}.xml");
        if !archive.holds(&name) {
            break;
        }
        sheets.push(sheet(archive, &name, &texts)?);
    }
    Ok(sheets)
}

/// The shared texts of the workbook.
fn texts(archive: &mut Archive<'_>) -> Result<Vec<String>, ReadFault> {
    let name = "xl/sharedStrings.xml";
    if !archive.holds(name) {
        return Ok(Vec::new());
    }
    archive.read(name, |stream| {
        let mut texts = Vec::new();
        let mut parts = String::new();
        let sound = walk(stream, |leaf| {
            match leaf.name() {
                "t" => parts.push_str(leaf.text),
                "si" => texts.push(std::mem::take(&mut parts)),
                _ => {}
            }
            texts.len() < MOST_TEXTS
        });
        if sound {
            Ok(texts)
        } else {
            Err(damaged(FORMAT, "the texts are not sound XML", ""))
        }
    })
}

fn sheet(archive: &mut Archive<'_>, name: &str, texts: &[String]) -> Result<Sheet, ReadFault> {
    archive.read(name, |stream| {
        let mut sheet = Sheet::default();
        let mut value = String::new();
        let sound = walk(stream, |leaf| {
            match leaf.name() {
                "v" | "t" => value = leaf.text.to_owned(),
                "c" => {
                    let value = std::mem::take(&mut value);
                    if let Some((column, row)) = leaf.attribute("r").and_then(cell) {
                        match leaf.attribute("t").unwrap_or_default() {
                            "s" => {
                                let at: Option<usize> = value.parse().ok();
                                let text = at.and_then(|at| texts.get(at));
                                sheet.label(row, column, text.map_or("", String::as_str));
                            }
                            "str" | "inlineStr" => sheet.label(row, column, &value),
                            "" | "n" => sheet.number(row, column, &value),
                            _ => {}
                        }
                    }
                }
                _ => {}
            }
            !sheet.is_full()
        });
        if sound {
            Ok(sheet)
        } else {
            Err(damaged(FORMAT, "a sheet is not sound XML", name))
        }
    })
}

/// A cell of an `.ods`: a number as it is written, or a text.
enum WorkbookContent {
    Number(String),
    Text(String),
}

/// The sheets of an `.ods`, in which neighbours with the same content are one cell or row with a number of repetitions.
fn open_document(archive: &mut Archive<'_>) -> Result<Vec<Sheet>, ReadFault> {
    archive.read("content.xml", |stream| {
        let mut sheets = Vec::new();
        let mut sheet = Sheet::default();
        let (mut row, mut column, mut text) = (0, 0, String::new());
        let mut cells: Vec<(usize, WorkbookContent)> = Vec::new();
        let repeats = |stated: Option<&str>| {
            let count = stated.and_then(|count| count.parse().ok());
            count.unwrap_or(1_usize).min(MOST_ROWS)
        };
        let sound = walk(stream, |leaf| {
            match leaf.name() {
                "p" => text.push_str(leaf.text),
                "table-cell" | "covered-table-cell" => {
                    let text = std::mem::take(&mut text);
                    let count = repeats(leaf.attribute("number-columns-repeated"));
                    for column in column..(column + count).min(MOST_COLUMNS) {
                        let content = match leaf.attribute("value") {
                            Some(value) => WorkbookContent::Number(value.to_owned()),
                            None if text.trim().is_empty() => break,
                            None => WorkbookContent::Text(text.clone()),
                        };
                        cells.push((column, content));
                    }
                    column += count;
                }
                "table-row" => {
                    let count = repeats(leaf.attribute("number-rows-repeated"));
                    for row in row..row + count {
                        if cells.is_empty() || sheet.is_full() {
                            break;
                        }
                        for (column, content) in &cells {
                            match content {
                                WorkbookContent::Number(value) => sheet.number(row, *column, value),
                                WorkbookContent::Text(text) => sheet.label(row, *column, text),
                            }
                        }
                    }
                    cells.clear();
                    row += count;
                    column = 0;
                }
                "table" => {
                    sheets.push(std::mem::take(&mut sheet));
                    row = 0;
                }
                _ => {}
            }
            !sheet.is_full() && sheets.len() < MOST_COLUMNS
        });
        if sound {
            Ok(sheets)
        } else {
            Err(damaged(FORMAT, "the sheets are not sound XML", ""))
        }
    })
}

/// Column and row from 0 of a reference like "F12".
fn cell(reference: &str) -> Option<(usize, usize)> {
    let at = reference.find(|c: char| c.is_ascii_digit())?;
    let (letters, digits) = reference.split_at(at);
    let mut column = 0_usize;
    for letter in letters.chars() {
        let value = (letter.to_ascii_uppercase() as usize).checked_sub('A' as usize)?;
        column = column.checked_mul(26)?.checked_add(value.min(25) + 1)?;
    }
    let row: usize = digits.parse().ok()?;
    Some((column.checked_sub(1)?, row.checked_sub(1)?))
}

/// Stores conditions and printed results; returns whether the sheet is a Mitutoyo export.
fn describe(labels: &[&str], metadata: &mut Metadata, state: &mut FilterState) -> bool {
    let known = labels
        .iter()
        .any(|label| *label == "Mitutoyo" || *label == "SurfTest");
    for (at, label) in labels.iter().enumerate() {
        let value = labels.get(at + 1).copied().unwrap_or("");
        match *label {
            "Mitutoyo" | "SurfTest" => {
                let before = metadata.instrument.take().unwrap_or_default();
                metadata.instrument = short(&format!("{before} {label}"));
            }
            "Work Name" => metadata.title = short(value),
            "Profile" => {
                *state = match value {
                    "R" => FilterState::Roughness,
                    "P" => FilterState::Primary,
                    _ => FilterState::Unknown,
                }
            }
            "Cut-Off" | "λc" => metadata.lambda_c = metadata::length(value),
            "λs" => metadata.lambda_s = metadata::length(value),
            _ if at == 0 && label.contains('-') && label.contains(|c: char| c.is_ascii_digit()) => {
                metadata.date = short(label);
            }
            _ => {
                let parts: Vec<&str> = label.split_whitespace().collect();
                if let [name, value, rest @ ..] = parts.as_slice() {
                    let unit = rest.first().copied().unwrap_or_default();
                    let printed = PrintedParameter::parse(name, value, unit);
                    metadata
                        .printed
                        .extend(printed.filter(|_| name.starts_with(['R', 'P', 'W', 'M'])));
                }
            }
        }
    }
    known
}
