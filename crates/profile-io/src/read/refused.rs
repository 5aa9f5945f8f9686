//! Refusal of packed formats, in a build without the feature `packed`.

use super::areal::trace::Areal;
use super::error::ReadFault;
use super::format::Format;
use super::options::ReadOptions;
use super::text::{Start, Stream};
use super::trace::Trace;

/// Format of a zip archive whose extension names none.
pub(super) fn content(_: &mut dyn Stream, _: u64) -> Format {
    Format::Archive
}

/// Refuses a member of an archive.
pub(super) fn member(
    format: Format,
    _: &mut dyn Stream,
    _: u64,
    _: &str,
) -> Result<Vec<u8>, ReadFault> {
    Err(ReadFault::format_not_read(format))
}

/// Refuses a zlib stream.
pub(super) fn inflated(format: Format, _: &[u8], _: u64) -> Result<Vec<u8>, ReadFault> {
    Err(ReadFault::format_not_read(format))
}

/// Refuses the surface in a file of a packed format; `None` if `format` is another.
pub(super) fn surface(
    _: &str,
    format: Format,
    _: &mut dyn Stream,
    _: &Start,
    _: &ReadOptions,
) -> Result<Option<Areal>, ReadFault> {
    match format {
        Format::X3p
        | Format::Excel
        | Format::ExcelBinary
        | Format::SensofarPlux
        | Format::NplXml => Err(ReadFault::format_not_read(format)),
        _ => Ok(None),
    }
}

/// No table: workbooks are not read.
pub(super) fn table(_: Format, _: &mut dyn Stream, _: &Start) -> Result<Option<String>, ReadFault> {
    Ok(None)
}

/// Refuses the trace in a file of a packed format; `None` if `format` is another.
pub(super) fn trace(
    name: &str,
    format: Format,
    stream: &mut dyn Stream,
    start: &Start,
    options: &ReadOptions,
) -> Result<Option<Trace>, ReadFault> {
    Ok(surface(name, format, stream, start, options)?.and(None))
}

#[cfg(test)]
mod tests {
    use asperity_core::Code;

    use crate::read::{ReadOptions, read_bytes, read_surface_bytes};

    #[test]
    fn a_packed_file_is_refused_by_name_and_says_what_to_do() {
        let mut keyence = b"VK6".to_vec();
        keyence.resize(100, 0);
        let npl = b"<?xml version=\"1.0\"?><DATAFILE><UNITS>um</UNITS></DATAFILE>";
        for (name, bytes) in [
            ("a.x3p", b"PK\x03\x04".as_slice()),
            ("a.xlsx", b"PK\x03\x04"),
            ("a.plux", b"PK\x03\x04"),
            ("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"),
            ("a.vk6", &keyence),
            ("a.xml", npl),
        ] {
            let options = ReadOptions::default();
            let profile = read_bytes(name, bytes, &options).unwrap_err();
            let surface = read_surface_bytes(name, bytes, &options).unwrap_err();
            for refused in [profile, surface] {
                assert_eq!(refused.code(), Code::E108, "{name}: {refused}");
                let remedy = refused.remedy().to_string();
                assert!(remedy.contains("feature packed"), "{name}: {remedy}");
            }
        }
    }
}
