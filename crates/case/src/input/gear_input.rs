//! Modifications of the flanks and root form of a gear, as on its drawing.

use asperity_core::quantity::Length;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::rows::{Judge, KeyPath, OPEN, RangedKey, table};

table! {
    /// Modifications of the flanks of one gear, its tip and its root.
    #[derive(Copy, Default)]
    GearFlankInput;

    /// Where the form of the profile comes from: `drawn` (default), as the keys below give it, or `from-trace`, from the
    /// trace of the flank, which must be placed and span the active flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    relief: Option<ReliefSource>;
    /// Relief of the tips, `"none"` where there is none; where it is not stated it is uncertain, and a run takes half of
    /// the approach of the teeth under load.
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_relief: Option<TipRelief> => table;
    /// Relief of the roots; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    root_relief: Option<ReliefInput> => table;
    /// Radial chamfer of the tips, which shortens the active flank; default 0 mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    tip_chamfer: Option<Length> = "mm" per module usual [0.005, 0.3] possible [1e-4, 1.0];
    /// Lead crowning, zero in the middle of the face width; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    crowning: Option<Length> = "um" per module usual [-5.0, 30.0] possible [-500.0, 500.0];
    /// Lead slope over the face width, including shaft tilt; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    lead_slope: Option<Length> = "um" per module usual [-40.0, 40.0] possible [-500.0, 500.0];
    /// Profile slope, positive where material is missing at the tip; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    profile_slope: Option<Length> = "um" per module usual [-25.0, 25.0] possible [-500.0, 500.0];
    /// Profile crowning, zero in the middle of the path of contact; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    profile_crowning: Option<Length> = "um" per module usual [-5.0, 25.0] possible [-500.0, 500.0];
    /// Dedendum h_fP* of the basic rack, in modules; default 1.25.
    #[serde(skip_serializing_if = "Option::is_none")]
    dedendum: Option<f64> = "" usual [1.0, 1.6] possible OPEN;
    /// Root fillet radius ρ_fP* of the basic rack, in modules; default 0.38.
    #[serde(skip_serializing_if = "Option::is_none")]
    fillet_radius: Option<f64> = "" usual [0.1, 0.5] possible OPEN;
}

impl GearFlankInput {
    /// Whether the form of the profile is that of the trace.
    #[must_use]
    pub fn is_from_trace(&self) -> bool {
        self.relief == Some(ReliefSource::FromTrace)
    }
}

/// Where the form of a profile comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum ReliefSource {
    /// From the drawing: tip relief, root relief, slope and crowning of the profile.
    #[default]
    Drawn,
    /// From the trace of the flank.
    FromTrace,
}

table! {
    /// Relief of tips or roots: `{ amount = "10 um", length = "2.9 mm" }`.
    #[derive(Copy)]
    ReliefInput;

    /// Amount at the end of the active flank.
    amount: Length = "um" per module usual [0.1, 40.0] possible [0.001, 500.0];
    /// Roll length from the end of the active flank; this or `start_diameter`.
    #[serde(skip_serializing_if = "Option::is_none")]
    length: Option<Length> = "mm" per module usual [0.05, 5.0] possible [0.001, 50.0];
    /// Diameter at which the relief starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    start_diameter: Option<Length> = "mm" usual [3.0, 5000.0] possible [0.1, 50_000.0];
    /// Power with which the relief grows: 1 (linear, default) or 2 (parabolic).
    #[serde(skip_serializing_if = "Option::is_none")]
    power: Option<u8> = "" usual [1.0, 2.0] possible OPEN;
}

/// Tip relief as a drawing states it: an amount over a length, or `"none"`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum TipRelief {
    /// No relief.
    None(NoRelief),
    /// A relief.
    Drawn(ReliefInput),
}

/// The word for no relief.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum NoRelief {
    /// No relief.
    None,
}

impl TipRelief {
    /// The relief, if there is one.
    #[must_use]
    pub fn drawn(self) -> Option<ReliefInput> {
        match self {
            Self::None(_) => None,
            Self::Drawn(relief) => Some(relief),
        }
    }
}

impl RangedKey for TipRelief {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let drawn = stated.and_then(|relief| relief.drawn());
        ReliefInput::visit(drawn.as_ref(), at, judge);
    }
}

impl<'de> Deserialize<'de> for TipRelief {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(TipReliefVisitor)
    }
}

struct TipReliefVisitor;

impl<'de> Visitor<'de> for TipReliefVisitor {
    type Value = TipRelief;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "\"none\", or a relief like {{ amount = \"10 um\", length = \"3 mm\" }}"
        )
    }

    fn visit_str<E: de::Error>(self, word: &str) -> Result<TipRelief, E> {
        match word {
            "none" => Ok(TipRelief::None(NoRelief::None)),
            other => Err(E::invalid_value(de::Unexpected::Str(other), &self)),
        }
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<TipRelief, A::Error> {
        ReliefInput::deserialize(MapAccessDeserializer::new(map)).map(TipRelief::Drawn)
    }
}

table! {
    /// Relief of both ends of the face: `{ amount = "10 um", length = "3 mm" }`.
    #[derive(Copy)]
    EndReliefInput;

    /// Amount at the ends of the face width.
    amount: Length = "um" per module usual [0.1, 60.0] possible [0.001, 500.0];
    /// Length along the face width.
    length: Length = "mm" usual [0.1, 200.0] possible [0.001, 5000.0];
    /// Power with which it grows: 1 (linear, default) or 2 (parabolic).
    #[serde(skip_serializing_if = "Option::is_none")]
    power: Option<u8> = "" usual [1.0, 2.0] possible OPEN;
}
