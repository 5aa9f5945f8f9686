//! The form of a flank from its trace: separation of the form, which sets the load over the teeth, from the roughness.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | λ_f | cut-off between form and roughness | m |
//! | λ_c | cut-off of the roughness filter | m |
//! | a_H | half-width of the contact at the pitch point under the mean line load | m |
//! | w | mean line of the trace at λ_f | m |
//!
//! The trace counts as the deviation of the flank from its involute, as gear inspection exports it: the form goes to
//! the load over the teeth, the rest is pressed into the mating flank; the two parts do not overlap.

use asperity_contact::hertz_line::HertzLine;
use asperity_core::numerics::range;
use asperity_core::quantity::{AngularSpeed, Length, LineLoad, Pressure, Torque};
use asperity_core::{Profile, cite};
use asperity_gear::{FlankPoint, Gear, GearPair, MeasuredForm};
use asperity_roughness::form::Form;
use serde::Serialize;

use crate::placement::PlacedTrace;

/// Form of a flank as its trace shows it.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct FlankForm {
    /// Cut-off λ_f between form and roughness.
    pub cutoff: Length,
    /// Missing material at the tip end of the active flank, against where least is missing.
    pub at_tip: Length,
    /// The same at the root end.
    pub at_root: Length,
    /// The form over the roll length.
    pub form: MeasuredForm,
}

/// Shortest wave of a form that is taken from a trace:
///
/// ```text
/// λ_f = max(λ_c, 8 a_H)                                                        [Form-split]
/// ```
///
/// This function returns 8 a_H, rounded up to whole micrometres: a shorter wave lies within the window of a contact, where it
/// is roughness.
///
/// # Errors
/// When gears or contact refuse the numbers.
pub fn shortest_form(
    gears: &GearPair,
    torque: Torque,
    speed: AngularSpeed,
    modulus: Pressure,
) -> Result<Length, FormError> {
    /// Half-widths of the shortest form.
    const HALF_WIDTHS: f64 = 8.0;
    const MICRO: f64 = 1e6;
    cite!("Form-split");
    let path = gears.path();
    let lines = gears.face_width * (path.eps_alpha / gears.base_helix.si().cos());
    let forces = gears.forces(torque).map_err(unsolved)?;
    let force = forces.normal_base.si().abs();
    let load = LineLoad::from_si(force / lines.si());
    let motion = gears.kinematics(path.c, speed).map_err(unsolved)?;
    let hertz = HertzLine::new(load, motion.radius, modulus).map_err(unsolved)?;
    let shortest = (HALF_WIDTHS * hertz.half_width.si() * MICRO).ceil() / MICRO;
    Ok(Length::from_si(shortest))
}

/// Reasons why a trace has no form.
#[derive(Debug, Clone, PartialEq)]
pub enum FormError {
    /// The place of the trace on the flank is not known.
    NotPlaced,
    /// The file holds a roughness profile.
    Filtered,
    /// The form was removed before.
    Removed(Form),
    /// Roll lengths of the trace and of the active flank.
    Short([Length; 2], [Length; 2]),
    /// Range of the form, and the largest range of a relief.
    High(Length, Length),
    /// Gears or contact refuse the numbers, with the reason.
    Unsolved(String),
}

fn unsolved(error: impl std::fmt::Display) -> FormError {
    FormError::Unsolved(error.to_string())
}

/// The form of a flank, with the mean line `waviness` of its trace filtered at `cutoff` and placed as `placed`.
pub(crate) fn measured(
    waviness: &Profile,
    cutoff: Length,
    placed: &PlacedTrace,
    gears: &GearPair,
    gear: Gear,
) -> Result<FlankForm, FormError> {
    /// Largest share of the active flank that may be missing at either end of the trace.
    const MAY_MISS: f64 = 0.01;
    /// Points of a cut-off: straight lines between them are off by under 1e-3 of the amplitude of a wave that long.
    const POINTS: f64 = 64.0;
    /// Largest range of a form, in modules; reliefs have up to 0.02.
    const LARGEST: f64 = 0.05;
    let path = gears.path();
    let arc = |s: Length| {
        let arc = gears.arc_of(gear, FlankPoint::Position(s));
        arc.map(|arc| arc.si()).map_err(unsolved)
    };
    let [from, to] = {
        let ends = [arc(path.a)?, arc(path.e)?];
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    };
    let roll = |arc: f64| placed.roll_length(arc);
    let arc_at =
        |i: usize| placed.first_arc + placed.direction * waviness.spacing().si() * i as f64;
    let last = waviness.len() - 1;
    let ends = [arc_at(0).min(arc_at(last)), arc_at(0).max(arc_at(last))];
    let slack = MAY_MISS * (to - from);
    if ends[0] > from + slack || ends[1] < to - slack {
        return Err(FormError::Short(ends.map(roll), [from, to].map(roll)));
    }
    let every = ((cutoff / waviness.spacing()) / POINTS).floor().max(1.0) as usize;
    let sampled = (0..=last).filter(|i| i.is_multiple_of(every) || *i == last);
    let on_flank = sampled.filter(|i| arc_at(*i) > 0.0);
    let mut points: Vec<(Length, Length)> = on_flank
        .map(|i| (roll(arc_at(i)), Length::from_si(waviness.heights()[i])))
        .collect();
    if placed.direction < 0.0 {
        points.reverse();
    }
    let (roll_length, height) = points.into_iter().unzip();
    let form = MeasuredForm {
        roll_length,
        height,
    };
    let [shortest, longest] = [from, to].map(roll);
    let is_active = |at: &&Length| (shortest..=longest).contains(*at);
    let inner = form.roll_length.iter().filter(is_active).copied();
    let active = inner.chain([shortest, longest]).map(|at| form.at(at));
    let [lowest, highest] = range(active);
    let largest = gears.normal_module * LARGEST;
    let range = Length::from_si(highest - lowest);
    if range > largest {
        return Err(FormError::High(range, largest));
    }
    let missing = |at: Length| Length::from_si(highest - form.at(at));
    // Roll lengths grow towards the tip, of a ring towards the root.
    let [at_root, at_tip] = match (gear, gears.internal) {
        (Gear::Wheel, true) => [missing(longest), missing(shortest)],
        _ => [missing(shortest), missing(longest)],
    };
    Ok(FlankForm {
        cutoff,
        at_tip,
        at_root,
        form,
    })
}
