//! Areal formats of instruments: a header, and a matrix of heights that is decoded on request.
//!
//! A reader of a format determines the offset of the matrix in the file and the conversion of numbers to heights
//! ([`raw`]); rows, columns and means are the same for all formats ([`trace`]). Each file names the description of its
//! layout; no code of other readers is used.

mod al3d;
pub(super) mod bytes;
mod chosen;
mod codev;
mod gsf;
mod gwy;
#[cfg(feature = "hdf5")]
mod hdf5;
pub(super) mod held;
mod ibw;
mod mat;
mod mat_elements;
mod metropro;
mod nid;
mod opd;
mod opdx;
mod opdx_items;
mod plu;
pub(crate) mod raw;
mod sdf_binary;
mod sur;
pub(crate) mod trace;
mod vk;
mod wyko_text;
mod zygo_text;

pub(crate) use codev::recognised as is_code_v;
pub(crate) use plu::recognised as is_plu;

use super::error::ReadFault;
use super::format::Format;
use super::text::Stream;
use trace::Areal;

/// The surface or profile in a file of an areal format; `None` if `format` is another.
pub(crate) fn read(
    format: Format,
    stream: &mut dyn Stream,
    size: u64,
) -> Result<Option<Areal>, ReadFault> {
    let held = |stream: &mut dyn Stream| held::whole(stream, size);
    Ok(Some(match format {
        Format::DigitalSurf => sur::read(&held(stream)?)?,
        Format::AliconaAl3d => al3d::read(held(stream)?)?,
        Format::KeyenceVk => vk::read(stream, size)?,
        Format::SensofarPlu => plu::read(held(stream)?)?,
        Format::MetroPro => metropro::read(held(stream)?)?,
        Format::ZygoXyz | Format::ZygoText => zygo_text::read(format, &held(stream)?)?,
        Format::Opd => opd::read(held(stream)?)?,
        Format::WykoText => wyko_text::read(&held(stream)?)?,
        Format::SdfBinary => sdf_binary::read(held(stream)?)?,
        Format::CodeV => codev::read(&held(stream)?)?,
        Format::Opdx => opdx::read(held(stream)?)?,
        Format::Matlab => {
            let bytes = held(stream)?;
            if mat::is_hdf5(&bytes) {
                hdf5_read(&bytes, format)?
            } else {
                mat::read(&bytes)?
            }
        }
        Format::GwyddionSimple => gsf::read(held(stream)?)?,
        Format::Gwyddion => gwy::read(&held(stream)?)?,
        Format::NanosurfNid => nid::read(held(stream)?)?,
        Format::IgorWave => ibw::read(&held(stream)?)?,
        Format::Hdf5 | Format::ZygoDatx => hdf5_read(&held(stream)?, format)?,
        _ => return Ok(None),
    }))
}

/// The surface or profile in a file that is HDF5, in a build that reads HDF5.
#[cfg(feature = "hdf5")]
fn hdf5_read(bytes: &[u8], format: Format) -> Result<Areal, ReadFault> {
    match format {
        Format::ZygoDatx => hdf5::datx(bytes),
        _ => hdf5::arrays(bytes, format),
    }
}

/// Refuses a file that is HDF5.
#[cfg(not(feature = "hdf5"))]
fn hdf5_read(_: &[u8], format: Format) -> Result<Areal, ReadFault> {
    Err(ReadFault::format_not_read(match format {
        Format::Matlab => Format::Hdf5,
        format => format,
    }))
}
