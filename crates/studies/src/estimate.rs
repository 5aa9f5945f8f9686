//! Estimate of the work of a run, before it is done.

use asperity::case::LoadedCase;
use asperity::pipeline::stations;
use asperity::surfaces::Texture;
use asperity::{Error, PositionError};

/// Time and memory that a run will take, within a factor of about three.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
#[non_exhaustive]
pub struct Estimate {
    /// Rough contacts, one for every position and offset.
    pub contacts: usize,
    /// Points of all contacts together.
    pub points: f64,
    /// Time on the threads that are used \[s\].
    pub seconds: f64,
    /// Memory of the fields that are held \[bytes\].
    pub bytes: f64,
}

/// Time of a point of a contact \[s\], on a machine of 2020: the e-drive case, 512 contacts.
const SECONDS_PER_POINT: f64 = 2e-6;
/// Numbers held for a point of the surface, and for a point at a depth.
const NUMBERS: [f64; 2] = [12.0, 4.0];
/// Bytes of a number.
const BYTES: f64 = 8.0;

/// Estimates the run of `loaded` on the threads of the pool.
///
/// # Errors
/// When a position of the mesh has no smooth contact.
pub fn estimate(loaded: &LoadedCase) -> Result<Estimate, Error> {
    of_case(loaded).map_err(|error| Error::Whole(Box::new(error)))
}

fn of_case(loaded: &LoadedCase) -> Result<Estimate, PositionError> {
    let model = &loaded.case.model;
    let spacing = loaded
        .surfaces
        .textures()
        .iter()
        .find_map(|texture| match texture {
            Texture::Trace(profile) => Some(profile.spacing()),
            _ => None,
        });
    let stations = stations(&loaded.case)?;
    let Some(spacing) = spacing.filter(|_| loaded.surfaces.are_measured()) else {
        return Ok(Estimate {
            contacts: 0,
            points: 0.0,
            seconds: 0.0,
            bytes: 0.0,
        });
    };
    let windows = stations
        .iter()
        .map(|station| 2.0 * model.window * (station.hertz.half_width / spacing));
    let once: f64 = windows.sum();
    let points = once * model.offsets as f64;
    let depths = model.depths as f64;
    Ok(Estimate {
        contacts: stations.len() * model.offsets,
        points,
        seconds: SECONDS_PER_POINT * points / rayon::current_num_threads() as f64,
        bytes: once * BYTES * (NUMBERS[0] + NUMBERS[1] * depths),
    })
}
