//! Running-in of the flanks before the loss is computed: `true`, or a table.

use asperity_core::quantity::Torque;
use serde::de::value::MapAccessDeserializer;
use serde::de::{self, MapAccess, Visitor};
use serde::{Deserialize, Deserializer, Serialize};

use super::rows::{Judge, KeyPath, RangedKey, table};

/// Engagements of a running-in: one, and more than the life of any gear.
pub(crate) const ENGAGEMENTS: [f64; 2] = [1.0, 1e10];

table! {
    /// Running-in of the flanks: `{ torque = "302 N m", engagements = 1e3 }`.
    #[derive(Copy, Default)]
    RunningInInput;

    /// Torque at which the flanks run in, at the pinion or input shaft; its sign is that of the operation. Default that of
    /// the operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    torque: Option<Torque> = "N m" usual [0.01, 1e6] possible [1e-9, 1e8];
    /// Engagements of a tooth of the pinion, 1 to 1e10; by default until the roughness no longer changes.
    #[serde(skip_serializing_if = "Option::is_none")]
    engagements: Option<f64> = "" usual [1.0, 1e7] possible ENGAGEMENTS;
}

/// Running-in as a case states it: whether the flanks run in, or how.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum RunningInEntry {
    /// Whether the flanks run in, at the torque of the operation.
    Whether(bool),
    /// At a torque and for a number of engagements.
    Stated(RunningInInput),
}

impl RunningInEntry {
    /// The running-in, if the flanks run in.
    #[must_use]
    pub fn stated(self) -> Option<RunningInInput> {
        match self {
            Self::Whether(runs_in) => runs_in.then(RunningInInput::default),
            Self::Stated(stated) => Some(stated),
        }
    }
}

impl RangedKey for RunningInEntry {
    fn visit(stated: Option<&Self>, at: KeyPath<'_>, judge: Judge<'_>) {
        let stated = stated.and_then(|entry| entry.stated());
        RunningInInput::visit(stated.as_ref(), at, judge);
    }
}

impl<'de> Deserialize<'de> for RunningInEntry {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(RunningInVisitor)
    }
}

struct RunningInVisitor;

impl<'de> Visitor<'de> for RunningInVisitor {
    type Value = RunningInEntry;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(
            f,
            "true, false, or a table like {{ torque = \"302 N m\", engagements = 1e3 }}"
        )
    }

    fn visit_bool<E: de::Error>(self, runs_in: bool) -> Result<RunningInEntry, E> {
        Ok(RunningInEntry::Whether(runs_in))
    }

    fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<RunningInEntry, A::Error> {
        RunningInInput::deserialize(MapAccessDeserializer::new(map)).map(RunningInEntry::Stated)
    }
}
