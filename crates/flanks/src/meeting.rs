//! The traces of both flanks: their common spacing, their places, and every pair of teeth in contact.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use asperity_core::cite;
use asperity_core::profile::common_spacing;
use asperity_core::quantity::{Length, Pressure, Torque};
use asperity_gear::{FlankPoint, Gear, GearPair};
use asperity_roughness::RoughnessError;
use asperity_roughness::resampling::respaced;

use crate::placement::{FULL_COVERAGE, Placement};
use crate::surfaces::{FlankReport, LikeMeasured, PairsOfTeeth, Surfaces, Texture};
use crate::trace::Flank;
use crate::trace_sites::{TraceSite, nearest};
use crate::{AVERAGING_WIDTH, LEAST_POINTS_PER_HALF_WIDTH};

/// The traces of both flanks, read and prepared once, from which pairs are formed.
#[derive(Debug, Clone, Copy)]
pub struct Meeting<'a> {
    /// Traces of pinion and wheel.
    pub flanks: &'a [Vec<Flank>; 2],
    /// λs of a flank without a trace.
    pub noise_cutoff: Option<Length>,
    /// Whether the place of every trace is known and used.
    pub is_placed: bool,
    /// Flanks that were generated like measured traces.
    pub like: LikeMeasured,
}

impl Meeting<'_> {
    /// The traces `which` of pinion and wheel in contact.
    #[must_use]
    pub fn surfaces(&self, which: [usize; 2]) -> Surfaces {
        let flanks = [0, 1].map(|body: usize| &self.flanks[body][which[body]]);
        // Rows of one surface are traces of their own.
        let same_trace = flanks[0].raw.is_some() && flanks[0].raw == flanks[1].raw;
        // Two files may have been filtered differently; summits are counted with the longer cut-off.
        let noise_cutoff = flanks
            .into_iter()
            .map(|flank| match &flank.report.preparation {
                Some(record) => record.recipe.lambda_s,
                None => self.noise_cutoff,
            })
            .max_by(|a, b| {
                a.unwrap_or_default()
                    .si()
                    .total_cmp(&b.unwrap_or_default().si())
            })
            .flatten();
        let rz = flanks.map(|flank| {
            let parameters = flank.report.parameters.as_ref();
            parameters.map(|parameters| parameters.heights.rz)
        });
        let textures = flanks.map(|flank| flank.texture.clone());
        let placement = match flanks.map(|flank| flank.placed) {
            [Some(pinion), Some(wheel)] if self.is_placed => Some(Placement {
                traces: [pinion, wheel],
                misplaced: 0.0,
            }),
            _ => None,
        };
        let whole_lengths = flanks.map(|flank| {
            let record = flank.report.preparation.as_ref()?;
            Some(record.spacing * record.points_before.saturating_sub(1) as f64)
        });
        let surfaces = Surfaces::new(textures, noise_cutoff, same_trace)
            .with_rz(rz)
            .with_whole_lengths(whole_lengths);
        surfaces.placed(placement).like_measured(self.like)
    }

    /// Every tooth of the pinion with every tooth of the wheel; in each zone of the face the traces nearest to it.
    #[must_use]
    pub fn pairs(
        &self,
        sites: [&[TraceSite]; 2],
        teeth: [usize; 2],
        zones: &[f64],
        width: Length,
    ) -> PairsOfTeeth {
        let mut made: BTreeMap<[usize; 2], Surfaces> = BTreeMap::new();
        let middles: Vec<f64> = (0..=zones.len())
            .map(|zone| {
                let from = zone.checked_sub(1).map_or(0.0, |below| zones[below]);
                0.5 * (from + zones.get(zone).copied().unwrap_or(1.0))
            })
            .collect();
        let of_pair = |pair: usize| {
            let tooth = [pair / teeth[1], pair % teeth[1]];
            let zone = |across: &f64| {
                let which = [0, 1].map(|body: usize| {
                    nearest(sites[body], tooth[body], *across, width).unwrap_or(0)
                });
                made.entry(which)
                    .or_insert_with(|| self.surfaces(which))
                    .clone()
            };
            middles.iter().map(zone).collect()
        };
        PairsOfTeeth {
            teeth: Some(teeth),
            met: (0..teeth[0] * teeth[1]).map(of_pair).collect(),
        }
    }
}

/// Longest prepared trace of each flank and the length of the active flank, where less than [`FULL_COVERAGE`] of the trace can lie
/// on it.
#[must_use]
pub fn longer_than_active(gears: &GearPair, flanks: &[Vec<Flank>; 2]) -> [Option<[Length; 2]>; 2] {
    let path = gears.path();
    [0, 1].map(|body: usize| {
        let gear = [Gear::Pinion, Gear::Wheel][body];
        let arc = |s| gears.arc_of(gear, FlankPoint::Position(s)).ok();
        let active = Length::from_si((arc(path.e)? - arc(path.a)?).si().abs());
        let traces = flanks[body].iter().filter(|flank| flank.raw.is_some());
        let lengths = traces.filter_map(|flank| match &flank.texture {
            Texture::Trace(profile) => Some(profile.length()),
            Texture::Values { .. } => None,
        });
        let longest = lengths.max_by(|a, b| a.si().total_cmp(&b.si()))?;
        (active / longest < FULL_COVERAGE).then_some([longest, active])
    })
}

/// Load per length w \[N/m\] on one pair of teeth, and radius of curvature R \[m\], at the pitch point.
#[must_use]
pub fn at_pitch(gears: &GearPair, torque: Torque) -> (f64, f64) {
    let path = gears.path();
    let (c, whole) = (path.c.si(), path.t1t2.si());
    let radius = c * (whole - c) / whole / gears.base_helix.si().cos();
    let load = torque.si().abs() / (gears.base_radius[0].si() * gears.face_width.si());
    (load, radius)
}

/// Half-width \[m\] at the pitch point with the whole load on one pair of teeth.
fn half_width_at_pitch(gears: &GearPair, torque: Torque, modulus: Pressure) -> f64 {
    let (load, radius) = at_pitch(gears, torque);
    (4.0 * load * radius / (PI * modulus.si())).sqrt()
}

/// Length of a prepared trace that holds windows of `window` half-widths to each side at places that differ, by the half-width at the
/// pitch point with the whole load on one pair of teeth: more than the contacts need where several pairs share the load.
#[must_use]
pub fn needed_length(gears: &GearPair, torque: Torque, modulus: Pressure, window: f64) -> Length {
    let half_width = half_width_at_pitch(gears, torque, modulus);
    Length::from_si((2.0 * window + AVERAGING_WIDTH) * half_width)
}

/// Usual spacing of a stylus instrument \[m\].
const USUAL_SPACING: f64 = 0.5e-6;
/// Half-width at the pitch point, with the whole load on one pair of teeth, over the narrowest on the path: more than gears have.
const NARROWER_ON_THE_PATH: f64 = 4.0;

/// Largest common spacing that the contacts of a mesh admit, and not above the usual spacing of instruments, so that another λs
/// leaves the points of its traces:
///
/// ```text
/// d = max(dx_min, min(λs/5, 0.5 µm, a_min/20))                                    [Common-spacing]
/// ```
///
/// This function returns min(0.5 µm, a_min/20); [`spacing_of`] the whole.
#[must_use]
pub fn largest_spacing(gears: &GearPair, torque: Torque, modulus: Pressure) -> Length {
    cite!("Common-spacing");
    let of_contacts = half_width_at_pitch(gears, torque, modulus)
        / (NARROWER_ON_THE_PATH * LEAST_POINTS_PER_HALF_WIDTH);
    Length::from_si(of_contacts.min(USUAL_SPACING))
}

/// Common spacing of prepared traces, \[Common-spacing\]: as large as `largest` and the shortest λs admit; the finest one of traces
/// that are all coarser. `None` without a prepared trace.
///
/// dx_min if a trace has no λs.
pub fn spacing_of<'a>(
    largest: Length,
    traces: impl Iterator<Item = &'a FlankReport>,
) -> Option<Length> {
    let prepared = traces.filter_map(|trace| trace.preparation.as_ref());
    let [largest, finest] =
        prepared.fold([largest.si(), f64::INFINITY], |[largest, finest], of| {
            let coarsest = of.recipe.coarsest_spacing().unwrap_or_default();
            [largest.min(coarsest.si()), finest.min(of.spacing.si())]
        });
    finest
        .is_finite()
        .then(|| Length::from_si(largest.max(finest)))
}

/// Traces that were put on a finer spacing than their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refined {
    /// The common spacing.
    pub common: Length,
    /// Spacings of both traces before, if each flank has one.
    pub before: Option<[Length; 2]>,
}

/// Puts all traces on one spacing, [`spacing_of`] them. Returns the spacings if traces were refined.
///
/// # Errors
/// With the name of its file, when a trace cannot be resampled.
pub fn on_common_spacing(
    largest: Length,
    flanks: &mut [Vec<Flank>; 2],
) -> Result<Option<Refined>, (String, RoughnessError)> {
    let all = flanks.iter().flatten().map(|flank| &flank.report);
    let Some(common) = spacing_of(largest, all) else {
        return Ok(None);
    };
    let own = |flank: &Flank| match &flank.texture {
        Texture::Trace(profile) => Some(profile.spacing()),
        Texture::Values { .. } => None,
    };
    let first_of = |flanks: &[Flank]| flanks.iter().find_map(own);
    let before = match flanks
        .each_ref()
        .map(|flanks| (flanks.len(), first_of(flanks)))
    {
        [(1, Some(pinion)), (1, Some(wheel))] => Some([pinion, wheel]),
        _ => None,
    };
    let mut is_refined = false;
    for flank in flanks.iter_mut().flatten() {
        if let Texture::Trace(profile) = &flank.texture {
            let is_same = common_spacing(profile.spacing(), common).is_some();
            is_refined |= !is_same && profile.spacing() > common;
            let file = || flank.report.file.clone().unwrap_or_default();
            let changed = respaced(profile, common).map_err(|error| (file(), error.into()))?;
            flank.texture = Texture::Trace(changed);
        }
    }
    Ok(is_refined.then_some(Refined { common, before }))
}
