//! Areal formats of instruments: a header, and a matrix of heights that is decoded where it is asked for.
//!
//! A reader of a format finds where in the file the matrix lies and how a number becomes a height
//! ([`raw`]); rows, columns and means of it are then the same for all ([`trace`]). No code of other
//! readers was taken; each file names where its layout is described.

mod al3d;
mod bytes;
mod inflate;
mod mat;
mod mat_elements;
mod metropro;
mod opd;
mod opdx;
mod opdx_items;
mod plu;
mod plux;
pub(in crate::read) mod raw;
mod sdf_binary;
mod sur;
pub(in crate::read) mod trace;
mod vk;

pub(in crate::read) use plu::recognised as is_plu;

use std::io::Read;

use super::error::ReadError;
use super::format::Format;
use super::text::Stream;
use trace::Areal;

/// Bytes of the largest file of these formats; it is held while it is decoded.
const MOST_BYTES: u64 = 1 << 30;

/// The surface or profile in a file of an areal format; none where `format` is another.
pub(in crate::read) fn read(
    file: &str,
    format: Format,
    stream: &mut dyn Stream,
    size: u64,
) -> Result<Option<Areal>, ReadError> {
    let held = |stream: &mut dyn Stream| whole(file, stream, size);
    Ok(Some(match format {
        Format::DigitalSurf => sur::read(file, &held(stream)?)?,
        Format::AliconaAl3d => al3d::read(file, held(stream)?)?,
        Format::KeyenceVk => vk::read(file, stream, size)?,
        Format::SensofarPlu => plu::read(file, held(stream)?)?,
        Format::SensofarPlux => plux::read(file, stream, size)?,
        Format::MetroPro => metropro::read(file, held(stream)?)?,
        Format::Opd => opd::read(file, held(stream)?)?,
        Format::SdfBinary => sdf_binary::read(file, held(stream)?)?,
        Format::Opdx => opdx::read(file, held(stream)?)?,
        Format::Matlab => mat::read(file, &held(stream)?)?,
        _ => return Ok(None),
    }))
}

/// The bytes of a file of `size` bytes.
fn whole(file: &str, stream: &mut dyn Stream, size: u64) -> Result<Vec<u8>, ReadError> {
    if size > MOST_BYTES {
        return Err(ReadError::TooLarge {
            file: file.to_owned(),
            what: "the file",
            bytes: size,
            most: MOST_BYTES,
        });
    }
    let mut bytes = Vec::new();
    let read = stream
        .rewind()
        .and_then(|()| stream.take(MOST_BYTES).read_to_end(&mut bytes));
    read.map_err(|source| ReadError::NotReadable {
        file: file.to_owned(),
        source,
    })?;
    Ok(bytes)
}
