//! Two rough windows that meet at a mesh position: their gap and the film's view of it.

use asperity_contact::two_flanks::TwoFlanks;
use asperity_core::Profile;
use asperity_core::profile::mirrored_window;
use asperity_core::quantity::Length;

use crate::error::PositionError;
use crate::local_roughness::Roughness;
use crate::station::{Resolution, Station};
use crate::surfaces::{Surfaces, Texture};

/// Least points per Hertz half-width at which a contact is resolved.
pub const LEAST_POINTS_PER_HALF_WIDTH: f64 = 20.0;

/// The golden section: multiples of it, minus their whole part, fill an interval evenly.
const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;

/// Windows that meet at `station` at offset `k` of `count` of all pairs and their roughness: that of the window, or
/// where no window is resolved that of the flanks as a whole.
pub(crate) fn meeting(
    surfaces: &Surfaces,
    station: &Station,
    window: f64,
    k: usize,
    count: usize,
) -> Result<(Option<Encounter>, Roughness), PositionError> {
    let (surfaces, k, count) = surfaces.met(station.zone, k, count);
    let found = match is_substituted(surfaces, station) {
        true => None,
        false => Encounter::new(surfaces, station, window, k, count)?,
    };
    let roughness = match &found {
        Some(encounter) => encounter.roughness,
        None => surfaces.roughness_as_a_whole()?,
    };
    Ok((found, roughness))
}

/// Whether the roughness of the whole traces is used for the windows at `station`.
pub(crate) fn is_substituted(surfaces: &Surfaces, station: &Station) -> bool {
    let [Texture::Trace(first), Texture::Trace(_)] = surfaces.textures() else {
        return false;
    };
    match station.resolution {
        Resolution::Required => false,
        Resolution::WhereFine => {
            station.hertz.half_width / first.spacing() < LEAST_POINTS_PER_HALF_WIDTH
        }
    }
}

/// The two flanks under the contact at one offset.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Encounter {
    /// Position across the contact, 0 at its middle \[m\].
    pub x: Vec<f64>,
    /// Distance of the points.
    pub spacing: Length,
    /// First point of the window on the traces of pinion and wheel; negative where a placed trace begins within
    /// the window.
    pub starts: [isize; 2],
    /// Heights of pinion and wheel under the contact \[m\].
    pub heights: [Vec<f64>; 2],
    /// Undeformed gap x²/2R − z₁ − z₂ \[m\].
    pub gap: Vec<f64>,
    /// Roughness under the contact.
    pub roughness: Roughness,
}

impl Encounter {
    /// Windows that meet at `station` when both flanks are at offset `k` of `count`, which go on from pair to pair of
    /// traces; `None` when a flank is known by its roughness values only.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub fn new(
        surfaces: &Surfaces,
        station: &Station,
        window: f64,
        k: usize,
        count: usize,
    ) -> Result<Option<Self>, PositionError> {
        let (surfaces, k, count) = surfaces.met(station.zone, k, count);
        let [Texture::Trace(first), Texture::Trace(second)] = surfaces.textures() else {
            return Ok(None);
        };
        let spacing = first.spacing();
        let half_width = station.hertz.half_width;
        let points = half_width / spacing;
        if points < LEAST_POINTS_PER_HALF_WIDTH {
            return Err(PositionError::TooCoarse {
                spacing_um: spacing.si() * 1e6,
                points,
                least: LEAST_POINTS_PER_HALF_WIDTH,
            });
        }
        let reach = (window * points).ceil() as usize;
        let n = 2 * reach + 1;
        let [(pinion, start_1), (wheel, start_2)] = match surfaces.placement() {
            Some(placement) => {
                let points = [first.len(), second.len()];
                let (middles, _) = placement.middles(station, points, spacing);
                [
                    around(first, middles[0], reach)?,
                    around(second, middles[1], reach)?,
                ]
            }
            None => {
                // Evenly along the pinion; along the wheel in another order, so that the pairs differ.
                let along = (k as f64 + 0.5) / count as f64;
                let across = (0.5 + k as f64 * GOLDEN_SECTION).fract();
                [part(first, n, along)?, part(second, n, across)?]
            }
        };
        let flanks = [pinion, wheel];
        let dx = spacing.si();
        let x: Vec<f64> = (0..n).map(|i| (i as f64 - reach as f64) * dx).collect();
        let gap = TwoFlanks {
            first: &flanks[0],
            second: &flanks[1],
            radius: station.motion.radius,
            load: station.load,
            modulus: station.film_conditions.modulus,
            pressure_limit: None,
        }
        .gap()?;
        let roughness = surfaces.roughness_of(&flanks)?;
        let heights = flanks.map(|flank| flank.heights().to_vec());
        Ok(Some(Self {
            x,
            spacing,
            starts: [start_1, start_2],
            heights,
            gap,
            roughness,
        }))
    }
}

impl Encounter {
    /// Sum of the heights of both flanks \[m\].
    #[must_use]
    pub fn composite(&self) -> Vec<f64> {
        let [first, second] = &self.heights;
        first.iter().zip(second).map(|(a, b)| a + b).collect()
    }
}

/// Window of `n` neighbouring points of `profile`, from the fraction `place` of where they can start, and its
/// first point.
fn part(profile: &Profile, n: usize, place: f64) -> Result<(Profile, isize), PositionError> {
    let free = profile
        .len()
        .checked_sub(n)
        .ok_or(PositionError::TraceTooShort {
            available_um: profile.length().si() * 1e6,
            needed_um: profile.spacing().si() * (n - 1) as f64 * 1e6,
        })?;
    let start = (place * free as f64).round() as usize;
    let window = profile.heights()[start..start + n].to_vec();
    Ok((Profile::new(profile.spacing(), window)?, start as isize))
}

/// Window of `reach` points to each side of the point `middle`, and its first point; beyond the ends of the
/// trace its mirror image.
fn around(
    profile: &Profile,
    middle: usize,
    reach: usize,
) -> Result<(Profile, isize), PositionError> {
    let start = middle as isize - reach as isize;
    let window = mirrored_window(profile.heights(), start, 2 * reach + 1);
    Ok((Profile::new(profile.spacing(), window)?, start))
}
