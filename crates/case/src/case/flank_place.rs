//! Keys of the place of a trace on its flank, and the place that follows from them.

use asperity_core::DomainError;
use asperity_core::quantity::{Angle, Length};
use asperity_gear::{FlankPoint, Gear, GearError, GearPair};
use serde::{Deserialize, Serialize};

use super::rows::table;

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

table! {
    /// A point of a trace whose place on the flank is known, by one of five coordinates.
    #[derive(Copy, Default)]
    FlankPlaceInput;

    /// Coordinate on the path of contact from T1 at which the point is in contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    position: Option<Length> = "mm" usual [0.05, 1000.0] possible [1e-4, 10_000.0];
    /// Roll length.
    #[serde(skip_serializing_if = "Option::is_none")]
    roll_length: Option<Length> = "mm" usual [0.05, 1000.0] possible [1e-4, 10_000.0];
    /// Radius.
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<Length> = "mm" usual [1.0, 2500.0] possible [0.05, 25_000.0];
    /// Diameter.
    #[serde(skip_serializing_if = "Option::is_none")]
    diameter: Option<Length> = "mm" usual [2.0, 5000.0] possible [0.1, 50_000.0];
    /// Roll angle.
    #[serde(skip_serializing_if = "Option::is_none")]
    roll_angle: Option<Angle> = "deg" usual [0.1, 90.0] possible [1e-4, 1000.0];
    /// Distance of the point from the first one of the trace; default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    x: Option<Length> = "mm" usual [0.001, 100.0] possible [-1000.0, 1000.0];
}

impl FlankPlaceInput {
    /// The point of the flank; `None` unless exactly one coordinate is stated.
    fn point(&self) -> Option<FlankPoint> {
        let Self {
            position,
            roll_length,
            radius,
            diameter,
            roll_angle,
            x: _,
        } = *self;
        let stated = [
            position.map(FlankPoint::Position),
            roll_length.map(FlankPoint::RollLength),
            radius.map(FlankPoint::Radius),
            diameter.map(|d| FlankPoint::Radius(d * 0.5)),
            roll_angle.map(FlankPoint::RollAngle),
        ];
        let mut stated = stated.into_iter().flatten();
        let first = stated.next()?;
        stated.next().is_none().then_some(first)
    }
}

/// Contradictions between the keys of a place.
#[derive(Debug)]
pub(super) enum PlaceError {
    /// A rule that the keys break.
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

/// The keys of a flank that state the place of its trace.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlaceKeys {
    pub from: Option<TraceStart>,
    pub at: Option<FlankPlaceInput>,
    /// Whether `mirrored` is stated.
    pub is_mirrored: bool,
}

/// Direction and place of a trace as read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ReadPlace {
    /// Whether the trace must be run from its other end so that it goes along x, towards the pinion's tip.
    pub turned: bool,
    /// Arc of the trace's first point as read, from the base circle \[m\], and its growth along the trace.
    pub reference: Option<[f64; 2]>,
    /// Whether the direction is the default.
    pub assumed_from: bool,
}

/// The place of a trace whose first point is `start` behind the first point measured; `arc_of_first` is the arc of that point
/// according to its file. `None` if no key states it.
pub(super) fn read_place(
    input: PlaceKeys,
    gears: &GearPair,
    gear: Gear,
    arc_of_first: Option<Length>,
    start: Length,
) -> Result<Option<ReadPlace>, PlaceError> {
    let is_stated = input.at.is_some() || input.from.is_some();
    if is_stated && input.is_mirrored {
        return Err(PlaceError::Rule(
            "says how the trace lies on the flank, so mirrored is not asked for; leave mirrored out",
        ));
    }
    if arc_of_first.is_some() && input.at.is_some() {
        return Err(PlaceError::Rule(
            "is told by the roll lengths of the file already; leave it out",
        ));
    }
    let growth = match (arc_of_first, input.from.unwrap_or_default()) {
        // A trace over roll lengths is read in their rising order.
        (Some(_), _) => 1.0,
        (None, TraceStart::Root) => gears.arc_towards_tip(gear),
        (None, TraceStart::Tip) => -gears.arc_towards_tip(gear),
    };
    let reference = match (arc_of_first, &input.at) {
        (Some(arc), _) => Some(arc.si()),
        (None, Some(at)) => {
            let rule = "needs exactly one of position, roll_length, radius, diameter, roll_angle";
            let point = at.point().ok_or(PlaceError::Rule(rule))?;
            let arc = gears.arc_of(gear, point)?.si();
            Some(arc - growth * (at.x.unwrap_or_default() - start).si())
        }
        (None, None) if !is_stated => return Ok(None),
        (None, None) => None,
    };
    // The key `mirrored` takes precedence over the roll lengths of a file.
    if input.is_mirrored {
        return Ok(None);
    }
    Ok(Some(ReadPlace {
        turned: growth != gears.arc_direction(gear),
        reference: reference.map(|arc| [arc, growth]),
        assumed_from: input.from.is_none() && arc_of_first.is_none(),
    }))
}

impl ReadPlace {
    /// Arc of the first point of a prepared trace \[m\], of `points` points as read, `spacing` apart, of which
    /// `dropped` were cut off at each end.
    pub(super) fn first_arc(&self, points: usize, spacing: Length, dropped: usize) -> Option<f64> {
        let [arc, growth] = self.reference?;
        let index = match self.turned {
            false => dropped,
            true => points - 1 - dropped,
        };
        Some(arc + growth * spacing.si() * index as f64)
    }
}
