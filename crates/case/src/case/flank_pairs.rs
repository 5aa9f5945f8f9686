//! The traces of both flanks: their common spacing, their places, and every pair of teeth in contact.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use asperity_core::Code;
use asperity_core::cite;
use asperity_core::profile::common_spacing;
use asperity_core::quantity::Length;
use asperity_gear::{FlankPoint, Gear};
use asperity_roughness::resampling::respaced;

use super::error::CaseError;
use super::flank_sample::{self, Listed};
use super::flank_trace::Flank;
use super::plausibility::at_pitch;
use super::resolve::Case;
use crate::flanks::LEAST_POINTS_PER_HALF_WIDTH;
use crate::flanks::placement::{FULL_COVERAGE, Placement};
use crate::flanks::surfaces::{FlankReport, PairsOfTeeth, Surfaces, Texture};
use asperity_core::message::Warning;

/// The traces of both flanks, read and prepared once, from which pairs are formed.
pub(super) struct Meeting<'a> {
    pub case: &'a Case,
    pub flanks: &'a [Vec<Flank>; 2],
    pub is_placed: bool,
}

impl Meeting<'_> {
    /// The traces `which` of pinion and wheel in contact.
    pub(super) fn surfaces(&self, which: [usize; 2]) -> Surfaces {
        let flanks = [0, 1].map(|body: usize| &self.flanks[body][which[body]]);
        // Rows of one surface are traces of their own.
        let same_trace = flanks[0].raw.is_some() && flanks[0].raw == flanks[1].raw;
        // Two files may have been filtered differently; summits are counted with the longer cut-off.
        let noise_cutoff = flanks
            .into_iter()
            .map(|flank| match &flank.report.preparation {
                Some(record) => record.recipe.lambda_s,
                None => self.case.preparation.lambda_s,
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
        let surfaces = Surfaces::new(textures, noise_cutoff, same_trace).with_rz(rz);
        surfaces.placed(placement)
    }

    /// Every tooth of the pinion with every tooth of the wheel; in each zone of the face the traces nearest to it.
    pub(super) fn pairs(
        &self,
        lists: &[Vec<Listed>; 2],
        teeth: [usize; 2],
        (zones, width): (&[f64], Length),
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
                    flank_sample::nearest(&lists[body], tooth[body], *across, width).unwrap_or(0)
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

/// Whether the place of every trace is known; known places of only some traces raise a warning and are not used.
pub(super) fn all_placed(flanks: &[Vec<Flank>; 2], warnings: &mut Vec<Warning>) -> bool {
    let placed = flanks
        .iter()
        .flatten()
        .filter(|flank| flank.placed.is_some());
    let is_missing = |body: usize| flanks[body].iter().any(|flank| flank.placed.is_none());
    let missing = match [is_missing(0), is_missing(1)] {
        [false, false] => return true,
        _ if placed.count() == 0 => return false,
        [true, false] => "the trace of the pinion",
        [false, true] => "the trace of the wheel",
        [true, true] => "some traces of pinion and wheel",
    };
    warnings.push(Warning::new(
        Code::W418,
        format!(
            "the place on the flank is not known of {missing}: windows do not follow from the mesh, all traces stand for any place of their flanks"
        ),
    ));
    false
}

/// W448: flanks with traces so long that less than [`FULL_COVERAGE`] of them can lie on the active flank.
pub(super) fn longer_than_active(
    case: &Case,
    flanks: &[Vec<Flank>; 2],
    tables: [&str; 2],
) -> Option<Warning> {
    let path = case.gears.path();
    let of_flank = |body: usize| {
        let gear = [Gear::Pinion, Gear::Wheel][body];
        let arc = |s| case.gears.arc_of(gear, FlankPoint::Position(s)).ok();
        let active = Length::from_si((arc(path.e)? - arc(path.a)?).si().abs());
        let traces = flanks[body].iter().filter(|flank| flank.raw.is_some());
        let lengths = traces.filter_map(|flank| match &flank.texture {
            Texture::Trace(profile) => Some(profile.length()),
            Texture::Values { .. } => None,
        });
        let longest = lengths.max_by(|a, b| a.si().total_cmp(&b.si()))?;
        (active / longest < FULL_COVERAGE).then(|| {
            let table = tables[body];
            format!("{longest:.3} in {table} on {active:.3}")
        })
    };
    let found: Vec<String> = [0, 1].into_iter().filter_map(of_flank).collect();
    (!found.is_empty()).then(|| {
        let text = format!(
            "filtered traces are longer than the active flank: {}. The rest was not measured there, and windows are taken from it, too. State the part on the active flank as range or the place of the trace as at; keep the trace if it was measured along the tooth or on a specimen of the same finish",
            found.join(", and ")
        );
        Warning::new(Code::W448, text)
    })
}

/// Usual spacing of a stylus instrument \[m\].
const USUAL_SPACING: f64 = 0.5e-6;
/// Half-width at the pitch point, with the whole load on one pair of teeth, over the narrowest on the path: more than gears have.
const NARROWER_ON_THE_PATH: f64 = 4.0;

/// Common spacing of prepared traces: as large as the shortest λs and the narrowest contact of the case admit, and not above the usual
/// spacing of instruments, so that another λs leaves the points of their traces; the finest one of traces that are all coarser.
/// `None` without a prepared trace.
///
/// ```text
/// d = max(dx_min, min(λs/5, 0.5 µm, a_min/20))                                    [Common-spacing]
/// ```
///
/// dx_min if a trace has no λs.
pub(super) fn spacing_of<'a>(
    case: &Case,
    traces: impl Iterator<Item = &'a FlankReport>,
) -> Option<Length> {
    cite!("Common-spacing");
    let (load, radius) = at_pitch(&case.gears, case.torque);
    let half_width = (4.0 * load * radius / (PI * case.modulus.si())).sqrt();
    let of_contacts = half_width / (NARROWER_ON_THE_PATH * LEAST_POINTS_PER_HALF_WIDTH);
    let prepared = traces.filter_map(|trace| trace.preparation.as_ref());
    let [largest, finest] = prepared.fold(
        [of_contacts.min(USUAL_SPACING), f64::INFINITY],
        |[largest, finest], of| {
            let coarsest = of.recipe.coarsest_spacing().unwrap_or_default();
            [largest.min(coarsest.si()), finest.min(of.spacing.si())]
        },
    );
    finest
        .is_finite()
        .then(|| Length::from_si(largest.max(finest)))
}

/// Puts all traces on one spacing, [`spacing_of`] them.
pub(super) fn on_common_spacing(
    case: &Case,
    flanks: &mut [Vec<Flank>; 2],
    warnings: &mut Vec<Warning>,
) -> Result<(), CaseError> {
    let all = flanks.iter().flatten().map(|flank| &flank.report);
    let Some(common) = spacing_of(case, all) else {
        return Ok(());
    };
    let own = |flank: &Flank| match &flank.texture {
        Texture::Trace(profile) => Some(profile.spacing()),
        Texture::Values { .. } => None,
    };
    let first_of = |flanks: &[Flank]| flanks.iter().find_map(own);
    let [pinion, wheel] = [first_of(&flanks[0]), first_of(&flanks[1])];
    let mut is_refined = false;
    for flank in flanks.iter_mut().flatten() {
        if let Texture::Trace(profile) = &flank.texture {
            let is_same = common_spacing(profile.spacing(), common).is_some();
            is_refined |= !is_same && profile.spacing() > common;
            let changed = respaced(profile, common).map_err(|source| {
                CaseError::preparation(flank.report.file.clone().unwrap_or_default(), source.into())
            })?;
            flank.texture = Texture::Trace(changed);
        }
    }
    if is_refined {
        let text = match ([flanks[0].len(), flanks[1].len()], pinion, wheel) {
            ([1, 1], Some(a), Some(b)) => format!(
                "the flanks are spaced {a:.5} and {b:.5}; the coarser was resampled to {common:.5}"
            ),
            _ => format!(
                "the traces have different spacings; the coarser ones were resampled to {common:.5}"
            ),
        };
        warnings.push(Warning::new(Code::W119, text));
    }
    Ok(())
}
