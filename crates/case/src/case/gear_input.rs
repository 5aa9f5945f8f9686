//! Modifications of the flanks and root form of a gear, as on its drawing.

use asperity_core::quantity::Length;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

/// Modifications of the flanks of one gear, its tip and its root.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct GearFlankInput {
    /// Where the form of the profile comes from: `drawn` (default), as the keys below give it, or `from-trace`, from the
    /// trace of the flank, which must be placed and span the active flank.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub relief: Option<ReliefSource>,
    /// Relief of the tips, `"none"` where there is none; where it is not stated it is uncertain, and a run takes half of
    /// the approach of the teeth under load.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tip_relief: Option<TipRelief>,
    /// Relief of the roots; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub root_relief: Option<ReliefInput>,
    /// Radial chamfer of the tips, which shortens the active flank; default 0 mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tip_chamfer: Option<Length>,
    /// Lead crowning, zero in the middle of the face width; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub crowning: Option<Length>,
    /// Lead slope over the face width, including shaft tilt; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lead_slope: Option<Length>,
    /// Profile slope, positive where material is missing at the tip; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile_slope: Option<Length>,
    /// Profile crowning, zero in the middle of the path of contact; default 0 um.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub profile_crowning: Option<Length>,
    /// Dedendum h_fP* of the basic rack, in modules; default 1.25.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dedendum: Option<f64>,
    /// Root fillet radius ρ_fP* of the basic rack, in modules; default 0.38.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub fillet_radius: Option<f64>,
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

/// Relief of tips or roots: `{ amount = "10 um", length = "2.9 mm" }`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ReliefInput {
    /// Amount at the end of the active flank.
    pub amount: Length,
    /// Roll length from the end of the active flank; this or `start_diameter`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length: Option<Length>,
    /// Diameter at which the relief starts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub start_diameter: Option<Length>,
    /// Power with which the relief grows: 1 (linear, default) or 2 (parabolic).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power: Option<u8>,
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

/// Relief of both ends of the face: `{ amount = "10 um", length = "3 mm" }`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct EndReliefInput {
    /// Amount at the ends of the face width.
    pub amount: Length,
    /// Length along the face width.
    pub length: Length,
    /// Power with which it grows: 1 (linear, default) or 2 (parabolic).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub power: Option<u8>,
}
