//! Two rough windows in contact at a mesh position, and their gap.

use asperity_contact::two_flanks::TwoFlanks;
use asperity_core::Profile;
use asperity_core::numerics::GOLDEN_SECTION;
use asperity_core::profile::mirrored_window;
use asperity_core::quantity::{Length, Pressure};

use crate::Roughness;
use crate::error::PositionError;
use crate::mesh_position::{MeshPosition, Resolution};
use crate::sheets::{PatchPlace, Sheets};
use crate::{Surfaces, Texture};

/// Least points per Hertz half-width at which a contact is resolved.
pub const LEAST_POINTS_PER_HALF_WIDTH: f64 = 20.0;

/// Width b_e in half-widths of a contact over which the loss averages, which is weighted with the pressure of Hertz.
pub const AVERAGING_WIDTH: f64 = 1.6;

/// 1/p and 1/p² of p³ = p + 1: multiples of both, minus their whole parts, fill a square evenly (Roberts 2018).
const SHIFTS: [f64; 2] = [0.569_840_290_998_053_3, 0.754_877_666_246_692_8];

/// Places of the windows on both traces at offset `k` of `count` in a cell of the path, 0 to 1 where a window can start.
///
/// ```text
/// [frac(u_k + i/p²), frac(v_k + i/p)],  p³ = p + 1                            [Window-places]
/// ```
///
/// u_k and v_k are the radical inverses of k + 1 in bases 2 and 3 (Halton), 1/2 and 1/2 of a single offset, and i is the
/// cell from 0. They nest: more offsets keep those before. They shift from cell to cell, as other parts of the flanks are
/// in contact there: the mean over the path then samples more of the traces.
///
/// ```
/// use asperity_flanks::window_places;
/// assert_eq!(window_places(1, 16, 0), [0.25, 2.0 / 3.0]);
/// assert_eq!(window_places(1, 64, 0), window_places(1, 16, 0));
/// ```
#[must_use]
pub fn window_places(k: usize, count: usize, cell: usize) -> [f64; 2] {
    asperity_core::cite!("Window-places");
    let first = match count {
        1 => [0.5; 2],
        _ => [2, 3].map(|base| radical_inverse(k + 1, base)),
    };
    [0, 1].map(|body| (first[body] + cell as f64 * SHIFTS[body]).fract())
}

/// Place along the lead, 0 to 1, of the wheel's rows against the pinion's at offset `k` in a cell of the path; both nest as
/// [`window_places`] do.
///
/// ```text
/// frac(y_k + i/g),  g = (1 + √5)/2                                       [Row-place]
/// ```
///
/// y_k is the radical inverse of k + 1 in base 5.
#[must_use]
pub fn row_place(k: usize, cell: usize) -> f64 {
    asperity_core::cite!("Row-place");
    (radical_inverse(k + 1, 5) + cell as f64 * GOLDEN_SECTION).fract()
}

/// The digits of `n` in `base` mirrored behind the point (van der Corput).
fn radical_inverse(n: usize, base: usize) -> f64 {
    let (mut left, mut place, mut found) = (n, 1.0, 0.0);
    while left > 0 {
        place /= base as f64;
        found += (left % base) as f64 * place;
        left /= base;
    }
    found
}

/// Whether the roughness of the whole traces is used for the windows at `position`.
pub fn is_substituted(surfaces: &Surfaces, position: &MeshPosition) -> bool {
    let [Texture::Trace(first), Texture::Trace(_)] = surfaces.textures() else {
        return false;
    };
    match position.resolution {
        Resolution::Required => false,
        Resolution::WhereFine => {
            position.hertz.half_width / first.spacing() < LEAST_POINTS_PER_HALF_WIDTH
        }
    }
}

/// The windows of both traces in contact at a mesh position, by their places on the traces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Window {
    /// First points of the window on the traces of pinion and wheel; negative where a placed trace begins within the
    /// window.
    pub starts: [isize; 2],
    /// Points of the window, an odd number.
    pub points: usize,
}

impl Window {
    /// The windows at `position` when both flanks are at offset `k` of `count` of all pairs; `None` if a flank is known
    /// by its roughness values only, and where the points are too far apart and need not resolve the contact.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub fn at(
        surfaces: &Surfaces,
        position: &MeshPosition,
        window: f64,
        k: usize,
        count: usize,
    ) -> Result<Option<Self>, PositionError> {
        let (surfaces, k, count) = surfaces.met(position.zone, k, count);
        let [Texture::Trace(first), Texture::Trace(second)] = surfaces.textures() else {
            return Ok(None);
        };
        if is_substituted(surfaces, position) {
            return Ok(None);
        }
        let spacing = first.spacing();
        let points = position.hertz.half_width / spacing;
        if points < LEAST_POINTS_PER_HALF_WIDTH {
            return Err(PositionError::too_coarse(
                spacing.si() * 1e6,
                points,
                LEAST_POINTS_PER_HALF_WIDTH,
            ));
        }
        let reach = (window * points).ceil() as usize;
        let n = 2 * reach + 1;
        let starts = match surfaces.placement() {
            Some(placement) => {
                let (middles, _) =
                    placement.middles(position, [first.len(), second.len()], spacing);
                middles.map(|middle| middle as isize - reach as isize)
            }
            None => {
                let [along, across] = window_places(k, count, position.cell);
                let wanted = WantedWindow {
                    points: n,
                    // Several windows must differ.
                    way: match count {
                        1 => 0,
                        _ => (AVERAGING_WIDTH * points).ceil() as usize,
                    },
                    half_width: points,
                };
                let start = |flank, whole, place| start(flank, whole, wanted, place);
                let [of_first, of_second] = surfaces.whole_lengths();
                [
                    start(first, of_first, along)?,
                    start(second, of_second, across)?,
                ]
            }
        };
        Ok(Some(Self { starts, points: n }))
    }

    /// The patch around the middles of the windows of traces with points `spacing` apart, at least as long as a window; the wheel's
    /// rows begin at the part `place` of all rows.
    #[must_use]
    pub fn patch(self, sheets: &Sheets, spacing: Length, place: f64) -> PatchPlace {
        let ratio = spacing / sheets.spacings()[0];
        let half = (self.points / 2) as isize;
        let reach = (half as f64 * ratio).ceil() as isize;
        let start = |start: isize| ((start + half) as f64 * ratio).round() as isize - reach;
        PatchPlace {
            starts: self.starts.map(start),
            points: (2 * reach + 1) as usize,
            shift: (place * sheets.rows() as f64) as usize % sheets.rows(),
        }
    }

    /// Heights of both flanks in the windows in a zone of the face at offset `k` of `count`, beyond the ends of a trace from its mirror
    /// image.
    pub fn cut(
        self,
        surfaces: &Surfaces,
        zone: usize,
        OffsetIndex { k, count }: OffsetIndex,
    ) -> Result<[Profile; 2], PositionError> {
        let (surfaces, ..) = surfaces.met(zone, k, count);
        let [Texture::Trace(first), Texture::Trace(second)] = surfaces.textures() else {
            return Err(PositionError::no_profile());
        };
        let part = |trace: &Profile, start: isize| {
            let heights = mirrored_window(trace.heights(), start, self.points);
            Profile::new(trace.spacing(), heights)
        };
        Ok([part(first, self.starts[0])?, part(second, self.starts[1])?])
    }
}

impl Surfaces {
    /// Roughness of the windows in contact at `position` at offset `k` of `count`, or of the flanks as a whole where no
    /// window is resolved.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub fn roughness_at(
        &self,
        position: &MeshPosition,
        window: f64,
        OffsetIndex { k, count }: OffsetIndex,
    ) -> Result<Roughness, PositionError> {
        let (of_pair, ..) = self.met(position.zone, k, count);
        match Window::at(self, position, window, k, count)? {
            Some(window) => {
                of_pair.roughness_of(&window.cut(self, position.zone, OffsetIndex { k, count })?)
            }
            None => of_pair.roughness_as_a_whole(),
        }
    }
}

/// An offset of the traces: number `k` of `count`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(clippy::exhaustive_structs)]
pub struct OffsetIndex {
    /// Number, from 0.
    pub k: usize,
    /// Number of offsets.
    pub count: usize,
}

/// The two flanks under the contact at one offset.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct WindowPair {
    /// Position across the contact, 0 at its middle \[m\].
    pub x: Vec<f64>,
    /// Distance of the points.
    pub spacing: Length,
    /// Heights of pinion and wheel under the contact \[m\].
    pub heights: [Vec<f64>; 2],
    /// Undeformed gap x²/2R − z₁ − z₂ \[m\].
    pub gap: Vec<f64>,
}

impl WindowPair {
    /// The windows of `window` half-widths to each side in contact at `position` at offset `k` of `count`, with the reduced
    /// modulus of the contact; `None` where no window is resolved.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub fn at(
        surfaces: &Surfaces,
        position: &MeshPosition,
        window: f64,
        modulus: Pressure,
        OffsetIndex { k, count }: OffsetIndex,
    ) -> Result<Option<Self>, PositionError> {
        let Some(window) = Window::at(surfaces, position, window, k, count)? else {
            return Ok(None);
        };
        let flanks = window.cut(surfaces, position.zone, OffsetIndex { k, count })?;
        Self::new(flanks, position, modulus).map(Some)
    }

    /// The heights of two windows, and their undeformed gap at a mesh position with the reduced modulus `modulus`.
    ///
    /// # Errors
    /// When the gap refuses the numbers.
    pub fn new(
        flanks: [Profile; 2],
        position: &MeshPosition,
        modulus: Pressure,
    ) -> Result<Self, PositionError> {
        let spacing = flanks[0].spacing();
        let n = flanks[0].len();
        let (reach, dx) = ((n / 2) as f64, spacing.si());
        let gap = TwoFlanks {
            first: &flanks[0],
            second: &flanks[1],
            radius: position.motion.radius,
            load: position.load,
            modulus,
            pressure_limit: None,
        }
        .gap()?;
        Ok(Self {
            x: (0..n).map(|i| (i as f64 - reach) * dx).collect(),
            spacing,
            heights: flanks.map(Profile::into_heights),
            gap,
        })
    }
}

/// Points of a window, and of a half-width of the contact.
#[derive(Clone, Copy)]
struct WantedWindow {
    points: usize,
    /// Least number of points that it can be moved by.
    way: usize,
    half_width: f64,
}

/// First point of a window on `profile`, at the fraction `place` of where it can start. `whole` is its length with the ends that
/// filtering drops.
fn start(
    profile: &Profile,
    whole: Option<Length>,
    wanted: WantedWindow,
    place: f64,
) -> Result<isize, PositionError> {
    let WantedWindow {
        points,
        way,
        half_width,
    } = wanted;
    let free = profile.len().checked_sub(points);
    let Some(free) = free.filter(|free| *free >= way) else {
        let length = profile.length();
        let left = profile.len().saturating_sub(1 + way);
        return Err(PositionError::TraceTooShort {
            available_um: length.si() * 1e6,
            whole_um: whole.unwrap_or(length).si() * 1e6,
            needed_um: profile.spacing().si() * (points + way - 1) as f64 * 1e6,
            half_widths: (left / 2) as f64 / half_width,
        });
    };
    Ok((place * free as f64).round() as isize)
}
