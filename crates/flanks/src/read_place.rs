//! The place of a trace on its flank that follows from what is stated about it.

use asperity_core::DomainError;
use asperity_core::quantity::Length;
use asperity_gear::{FlankPoint, Gear, GearError, GearPair};
use serde::{Deserialize, Serialize};

/// End of the flank at which a trace begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum TraceStart {
    /// From the root towards the tip.
    #[default]
    Root,
    /// From the tip towards the root.
    Tip,
}

/// A point of a trace whose place on the flank is stated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointOfTrace {
    /// The point of the flank; `None` unless exactly one coordinate is stated.
    pub point: Option<FlankPoint>,
    /// Its distance from the first point measured.
    pub x: Length,
}

/// Statements about the place of a trace.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StatedPlace {
    /// End at which it begins.
    pub from: Option<TraceStart>,
    /// A point of known place.
    pub at: Option<PointOfTrace>,
    /// Whether it is run from its other end.
    pub mirrored: Option<bool>,
}

/// Contradictions in what is stated about a place.
#[derive(Debug, Clone, PartialEq)]
pub enum PlaceError {
    /// A rule that the statements break.
    Rule(&'static str),
    /// A coordinate outside of the flank.
    Domain(DomainError),
}

impl From<GearError> for PlaceError {
    fn from(error: GearError) -> Self {
        match error {
            GearError::Domain(error) => Self::Domain(error),
            _ => Self::Rule("has no place on this flank"),
        }
    }
}

/// Direction and place of a trace as read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ReadPlace {
    /// Whether the trace must be run from its other end so that it goes along x, towards the pinion's tip.
    pub turned: bool,
    /// Arc of the trace's first point as read, from the base circle \[m\], and its growth along the trace.
    pub reference: Option<[f64; 2]>,
    /// Whether the direction is the default.
    pub assumed_from: bool,
}

/// The place of a trace whose first point is `start` behind the first point measured; `arc_of_first` is the arc of that point
/// according to its file. `None` if nothing states it.
pub(crate) fn read_place(
    stated: StatedPlace,
    gears: &GearPair,
    gear: Gear,
    arc_of_first: Option<Length>,
    start: Length,
) -> Result<Option<ReadPlace>, PlaceError> {
    let is_stated = stated.at.is_some() || stated.from.is_some();
    if is_stated && stated.mirrored.is_some() {
        return Err(PlaceError::Rule(
            "states how the trace lies on the flank; leave mirrored out",
        ));
    }
    if arc_of_first.is_some() && stated.at.is_some() {
        return Err(PlaceError::Rule(
            "follows from the roll lengths of the file; leave it out",
        ));
    }
    let growth = match (arc_of_first, stated.from.unwrap_or_default()) {
        // A trace over roll lengths is read in their rising order.
        (Some(_), _) => 1.0,
        (None, TraceStart::Root) => gears.arc_towards_tip(gear),
        (None, TraceStart::Tip) => -gears.arc_towards_tip(gear),
    };
    let reference = match (arc_of_first, &stated.at) {
        (Some(arc), _) => Some(arc.si()),
        (None, Some(at)) => {
            let rule = "needs exactly one of position, roll_length, radius, diameter, roll_angle";
            let point = at.point.ok_or(PlaceError::Rule(rule))?;
            let arc = gears.arc_of(gear, point)?.si();
            Some(arc - growth * (at.x - start).si())
        }
        (None, None) if !is_stated => return Ok(None),
        (None, None) => None,
    };
    // What is stated as mirrored takes precedence over the roll lengths of a file.
    if stated.mirrored.is_some() {
        return Ok(None);
    }
    Ok(Some(ReadPlace {
        turned: growth != gears.arc_direction(gear),
        reference: reference.map(|arc| [arc, growth]),
        assumed_from: stated.from.is_none() && arc_of_first.is_none(),
    }))
}

impl ReadPlace {
    /// Arc of the first point of a prepared trace \[m\], of `points` points as read, `spacing` apart, of which
    /// `dropped` were cut off at each end.
    pub(crate) fn first_arc(&self, points: usize, spacing: Length, dropped: usize) -> Option<f64> {
        let [arc, growth] = self.reference?;
        let index = if self.turned {
            points - 1 - dropped
        } else {
            dropped
        };
        Some(arc + growth * spacing.si() * index as f64)
    }
}
