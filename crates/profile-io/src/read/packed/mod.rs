//! Formats in archives, containers and XML, and the unpacking of zlib streams.
//!
//! Built with the feature `packed`; without it `refused.rs` is in the place of this module.

mod archive;
mod hashed;
mod inflate;
mod npl_xml;
mod plux;
mod sheet;
mod workbook;
mod x3p;
mod xls;
mod xml;

use std::io::Cursor;

pub(super) use archive::{content, member};
pub(super) use inflate::inflated;

use super::areal::trace::Areal;
use super::delimited;
use super::error::ReadFault;
use super::format::Format;
use super::header::FilterState;
use super::options::{Encoding, ReadOptions, TraceLine};
use super::recognise::ZIP;
use super::text::{Start, Stream, TextSource};
use super::trace::Trace;
use crate::warning::Warning;

/// The surface in the file `name` of a packed format; `None` if `format` is another.
pub(super) fn surface(
    name: &str,
    format: Format,
    stream: &mut dyn Stream,
    start: &Start,
    options: &ReadOptions,
) -> Result<Option<Areal>, ReadFault> {
    Ok(Some(match format {
        Format::X3p => x3p::surface(stream, start.size)?,
        Format::SensofarPlux => plux::read(stream, start.size)?,
        format if is_workbook(format, start) => {
            let table = workbook::read(format, stream, start.size, options)?;
            let mut bytes = Cursor::new(table.text);
            let start = Start::read(&mut bytes)?;
            let (head, mut text) = TextSource::new(name, &mut bytes, &start, Some(Encoding::Utf8));
            delimited::surface(&head, &mut text, options)?
        }
        _ => return Ok(None),
    }))
}

/// The trace in the file `name` of a packed format; `None` if `format` is another.
pub(super) fn trace(
    name: &str,
    format: Format,
    stream: &mut dyn Stream,
    start: &Start,
    options: &ReadOptions,
) -> Result<Option<Trace>, ReadFault> {
    let found = match format {
        Format::X3p if options.line == TraceLine::Row => x3p::read(stream, start.size, options)?,
        Format::NplXml => npl_xml::read(stream)?,
        format if is_workbook(format, start) => {
            let table = workbook::read(format, stream, start.size, options)?;
            return trace_of_table(name, table, options).map(Some);
        }
        _ => match surface(name, format, stream, start, options)? {
            Some(found) => found.trace(options)?,
            None => return Ok(None),
        },
    };
    found.finish(name, options).map(Some)
}

/// The table in a workbook as text with tabs; `None` if `format` is another.
pub(super) fn table(
    format: Format,
    stream: &mut dyn Stream,
    start: &Start,
) -> Result<Option<String>, ReadFault> {
    if is_workbook(format, start) {
        workbook::text(format, stream, start.size).map(Some)
    } else {
        Ok(None)
    }
}

fn is_workbook(format: Format, start: &Start) -> bool {
    let zipped = start.bytes.starts_with(ZIP);
    (format == Format::Excel && zipped) || format == Format::ExcelBinary
}

/// Reads the trace in the table of a workbook.
fn trace_of_table(
    name: &str,
    table: workbook::Table,
    options: &ReadOptions,
) -> Result<Trace, ReadFault> {
    let mut options = options.clone();
    if table.is_chosen {
        options.row = None;
    }
    let mut bytes = Cursor::new(table.text);
    let start = Start::read(&mut bytes)?;
    let (head, mut text) = TextSource::new(name, &mut bytes, &start, Some(Encoding::Utf8));
    let mut trace = delimited::read(&head, &mut text, &options)?;
    if let Some(asked) = options.row.filter(|row| *row != 1)
        && !trace.format.may_hold_several()
    {
        return Err(ReadFault::several_profiles(
            1,
            trace.heights.len(),
            Some(asked),
        ));
    }
    if table.filter_state == FilterState::Roughness {
        trace.warnings.push(Warning::AlreadyFiltered);
    }
    if table.format == Format::MitutoyoXlsx {
        (trace.filter_state, trace.metadata) = (table.filter_state, table.metadata);
    }
    Ok(Trace {
        format: table.format,
        encoding: None,
        ..trace
    })
}
