//! Reading a REXS file of any of the three formats.

use crate::error;
use std::borrow::Cow;
use std::io::{Cursor, Read};

use asperity_core::{Fault, is_of_system};
use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};
use zip::ZipArchive;

use crate::model::Model;
use crate::{json, xml};

/// Maximum size of an unpacked file in bytes: real gearboxes have up to 1 MB.
const MAX_BYTES: u64 = 64 << 20;
const MIB: u64 = 1 << 20;
/// Start of a zip file.
const ZIP: &[u8] = b"PK\x03\x04";

impl Model {
    /// Reads a REXS file: XML, JSON, or a zip that holds one of either.
    ///
    /// # Errors
    /// When it has another format, is damaged, or has an unknown version.
    ///
    /// ```
    /// let xml = r#"<model version="1.4"><relations/><components>
    ///   <component id="1" type="gear_casing" name="Casing"/>
    /// </components></model>"#;
    /// let model = asperity_rexs::Model::read(xml.as_bytes())?;
    /// assert_eq!(model.components["1"].kind, "gear_casing");
    /// # Ok::<(), asperity_core::Fault>(())
    /// ```
    pub fn read(bytes: &[u8]) -> Result<Self, Fault> {
        if bytes.len() as u64 > MAX_BYTES {
            return Err(too_large());
        }
        let model = if bytes.starts_with(ZIP) {
            text(&unpacked(bytes)?)?
        } else {
            text(bytes)?
        };
        let known = ["1", "2"].iter().any(|major| {
            let rest = model.version.strip_prefix(major);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
        });
        if known {
            Ok(model)
        } else {
            Err(error::version(&model.version))
        }
    }
}

fn too_large() -> Fault {
    error::too_large(MAX_BYTES / MIB)
}

fn text(bytes: &[u8]) -> Result<Model, Fault> {
    let text = decoded(bytes);
    match text.trim_start().chars().next() {
        Some('<') => xml::read(&text),
        Some('{') => json::read(&text),
        _ => Err(error::not_rexs()),
    }
}

/// The text of a file: in the encoding of its byte order mark, of the zeros of UTF-16, or of its XML declaration, else UTF-8.
fn decoded(bytes: &[u8]) -> Cow<'_, str> {
    /// Bytes in which the declaration is looked for.
    const HEAD: usize = 200;
    let by_zeros = match bytes {
        [b'<' | b'{', 0, ..] => Some(UTF_16LE),
        [0, b'<' | b'{', ..] => Some(UTF_16BE),
        _ => None,
    };
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(HEAD)]);
    let declared = head.split_once("encoding=").and_then(|(before, rest)| {
        let label = rest.strip_prefix(['"', '\''])?.split(['"', '\'']).next()?;
        let is_declaration = before.trim_start_matches('\u{feff}').starts_with("<?xml");
        Encoding::for_label(label.as_bytes()).filter(|_| is_declaration)
    });
    // Whether bytes or words are swapped is not in a declaration that could be read as bytes.
    let declared = declared.filter(|encoding| encoding.is_ascii_compatible());
    let encoding = by_zeros.or(declared).unwrap_or(UTF_8);
    encoding.decode(bytes).0
}

/// Unpacks the only REXS file in a zip; `.rexs` is preferred to `.rexsj`.
fn unpacked(bytes: &[u8]) -> Result<Vec<u8>, Fault> {
    let damaged = |error: zip::result::ZipError| error::zip(&format!("is damaged: {error}"));
    let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
    let names: Vec<String> = (0..archive.len())
        .filter_map(|index| {
            let entry = archive.by_index_raw(index).ok()?;
            entry.name().ok().map(std::borrow::Cow::into_owned)
        })
        .filter(|name| !is_of_system(name))
        .collect();
    let ending = |ending: &str| -> Vec<&String> {
        let fits = |name: &&String| name.to_ascii_lowercase().ends_with(ending);
        names.iter().filter(fits).collect()
    };
    let by_ending = [".rexs", ".rexsj"].map(ending);
    let name = match by_ending.iter().find(|names| !names.is_empty()) {
        Some(names) if names.len() == 1 => names[0].clone(),
        Some(_) => return Err(error::zip("holds several REXS files")),
        None => return Err(error::zip("holds no .rexs or .rexsj file")),
    };
    let entry = archive.by_name(&name).map_err(damaged)?;
    let mut content = Vec::new();
    let read = entry.take(MAX_BYTES + 1).read_to_end(&mut content);
    read.map_err(|error| error::zip(&format!("is damaged: {error}")))?;
    if content.len() as u64 > MAX_BYTES {
        return Err(too_large());
    }
    Ok(content)
}
