//! Keys of the place of a trace on its flank.

use asperity_core::quantity::{Angle, Length};
pub use asperity_flanks::read_place::TraceStart;
use asperity_flanks::read_place::{PointOfTrace, StatedPlace};
use asperity_gear::FlankPoint;

use super::rows::table;

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
    /// The point of the trace, with that of the flank if exactly one coordinate is stated.
    fn of_trace(&self) -> PointOfTrace {
        let Self {
            position,
            roll_length,
            radius,
            diameter,
            roll_angle,
            x,
        } = *self;
        let stated = [
            position.map(FlankPoint::Position),
            roll_length.map(FlankPoint::RollLength),
            radius.map(FlankPoint::Radius),
            diameter.map(|d| FlankPoint::Radius(d * 0.5)),
            roll_angle.map(FlankPoint::RollAngle),
        ];
        let mut stated = stated.into_iter().flatten();
        let first = stated.next();
        PointOfTrace {
            point: first.filter(|_| stated.next().is_none()),
            x: x.unwrap_or_default(),
        }
    }
}

/// Place of a trace as the keys of its flank state it.
pub(crate) fn stated_place(
    from: Option<TraceStart>,
    at: Option<FlankPlaceInput>,
    mirrored: Option<bool>,
) -> StatedPlace {
    StatedPlace {
        from,
        at: at.as_ref().map(FlankPlaceInput::of_trace),
        mirrored,
    }
}
