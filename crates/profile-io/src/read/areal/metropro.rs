//! Zygo MetroPro DAT: a header, intensities, and a phase map as whole numbers, high byte first.
//!
//! Layout: MetroPro Reference Guide OMP-0347 as its public readers state it (Gwyddion metropro.c,
//! SurfaceTopography, prysm). A height is number · S · W · O / R: interferometric scale factor, wavelength,
//! obliquity factor, and 4096, 32768 or 131072 for phase resolution 0, 1 or 2; a sign field that is not zero
//! turns it round.

use super::bytes::{big, text};
use super::raw::{Layout, Missing, Raw, RawNumber};
use super::trace::{Areal, ArealHeights};
use crate::read::damage::damaged;
use crate::read::error::ReadFault;
use crate::read::format::Format;
use crate::read::metadata::short;

const FORMAT: Format = Format::MetroPro;
/// R by the phase resolution.
pub(super) const RESOLUTIONS: [f64; 3] = [4096.0, 32768.0, 131_072.0];
/// Numbers from here up are missing heights.
pub(super) const INVALID: f64 = 2_147_483_640.0;

/// Reads the phase map.
pub(super) fn read(bytes: Vec<u8>) -> Result<Areal, ReadFault> {
    let fault = |what, seen: &str| damaged(FORMAT, what, seen);
    let cut = || fault("the header is cut off", "");
    let short_at = |at| big::<u16>(&bytes, at).map(usize::from).ok_or_else(cut);
    let float = |at| big::<f32>(&bytes, at).map(f64::from).ok_or_else(cut);
    let header: u32 = big(&bytes, 6).ok_or_else(cut)?;
    let intensities: u32 = big(&bytes, 60).ok_or_else(cut)?;
    let (columns, rows) = (short_at(68)?, short_at(70)?);
    if columns == 0 || rows == 0 {
        return Err(ReadFault::no_heights(FORMAT, "intensities alone"));
    }
    let (scale, wavelength, obliquity) = (float(164)?, float(168)?, float(176)?);
    let spacing = float(184)?;
    let resolution = short_at(218)?;
    let Some(steps) = RESOLUTIONS.get(resolution) else {
        return Err(fault(
            "the phase resolution is not known",
            &resolution.to_string(),
        ));
    };
    let turned = short_at(230)? != 0;
    let title = text(&bytes, 80, 82);
    let first = (header as usize).saturating_add(intensities as usize);
    let layout = Layout::packed(first, columns, rows, RawNumber::I32Big);
    let raw = Raw::new(bytes, RawNumber::I32Big, layout);
    let mut raw = raw.ok_or_else(|| fault("the phase map is cut off", ""))?;
    raw.missing = Missing::AtLeast(INVALID);
    let factor = scale * obliquity * wavelength / steps;
    raw.scale = if turned { -factor } else { factor };
    let mut found = Areal::new(FORMAT, ArealHeights::Raw(raw)).spaced(spacing, spacing);
    found.metadata.title = title.as_deref().and_then(short);
    found.metadata.instrument = Some("Zygo".into());
    Ok(found)
}
