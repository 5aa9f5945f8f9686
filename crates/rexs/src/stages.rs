//! The stages of a gearbox.

use crate::model::{Component, Model, Relation};
use crate::units::Unit;
use asperity_core::Fault;

/// A stage with the numbers of its components.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Stage {
    /// Number of the stage, from 1 in the order of the file.
    pub number: usize,
    /// Name given by the exporting program.
    pub name: String,
    /// Its components.
    pub kind: StageKind,
}

/// Kind of a stage, with the numbers of its components.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum StageKind {
    /// Two cylindrical gears, or a gear and a ring.
    Pair {
        /// `cylindrical_stage`.
        stage: String,
        /// Gear with fewer teeth.
        pinion: String,
        /// Gear with more teeth, or the ring.
        wheel: String,
        /// Whether the wheel is a `ring_gear`.
        is_ring: bool,
    },
    /// A planetary set.
    Planetary {
        /// `planetary_stage`.
        set: String,
        /// `cylindrical_stage` of sun and planet.
        stage: String,
        /// The sun.
        sun: String,
        /// One of the planets.
        planet: String,
        /// The ring.
        ring: String,
        /// Number of planets.
        planets: usize,
    },
    /// Bevel gears, worms: not modelled.
    Other {
        /// Type of the stage or of one of its gears.
        kind: String,
    },
}

impl Stage {
    /// Numbers of its gears: pinion and wheel, or sun, planet and ring; empty if it is not of cylindrical gears.
    #[must_use]
    pub fn gears(&self) -> Vec<&str> {
        match &self.kind {
            StageKind::Pair { pinion, wheel, .. } => vec![pinion, wheel],
            StageKind::Planetary {
                sun, planet, ring, ..
            } => vec![sun, planet, ring],
            StageKind::Other { .. } => Vec::new(),
        }
    }
}

/// The stages of a gearbox in the order of the file; a planetary set is one stage.
///
/// # Errors
/// When a relation names a component that is missing, or a gear has no number of teeth.
pub fn stages(model: &Model) -> Result<Vec<Stage>, Fault> {
    let mut stages: Vec<Stage> = Vec::new();
    let mut sets: Vec<&str> = Vec::new();
    for relation in model.related("stage") {
        let stage = model.in_role(relation, "stage")?;
        let (name, kind) = match set_of(model, stage) {
            Some(set) if sets.contains(&set.id.as_str()) => continue,
            Some(set) => {
                sets.push(&set.id);
                (set.name.clone(), planetary(model, set)?)
            }
            None => (stage.name.clone(), pair(model, relation, stage)?),
        };
        stages.push(Stage {
            number: stages.len() + 1,
            name,
            kind,
        });
    }
    Ok(stages)
}

/// The planetary stage that contains a cylindrical stage.
fn set_of<'a>(model: &'a Model, stage: &Component) -> Option<&'a Component> {
    model
        .related("assembly")
        .filter(|relation| relation.role("part") == Some(&stage.id))
        .filter_map(|relation| model.components.get(relation.role("assembly")?))
        .find(|component| component.kind == "planetary_stage")
}

fn is_gear(component: &Component) -> bool {
    ["cylindrical_gear", "ring_gear"].contains(&component.kind.as_str())
}

fn pair(model: &Model, relation: &Relation, stage: &Component) -> Result<StageKind, Fault> {
    let gears = ["gear_1", "gear_2"].map(|role| model.in_role(relation, role));
    let [first, second] = gears;
    let (first, second) = (first?, second?);
    let parts = [stage, first, second];
    let is_cylindrical = |(k, part): (usize, &&Component)| match k {
        0 => part.kind == "cylindrical_stage",
        _ => is_gear(part),
    };
    let other = parts.iter().enumerate().find(|part| !is_cylindrical(*part));
    if let Some((_, part)) = other {
        return Ok(StageKind::Other {
            kind: part.kind.clone(),
        });
    }
    let (pinion, wheel) = if swapped(first, second)? {
        (second, first)
    } else {
        (first, second)
    };
    if pinion.kind == "ring_gear" {
        return Ok(StageKind::Other {
            kind: "pair of two ring gears".into(),
        });
    }
    Ok(StageKind::Pair {
        stage: stage.id.clone(),
        pinion: pinion.id.clone(),
        wheel: wheel.id.clone(),
        is_ring: wheel.kind == "ring_gear",
    })
}

/// Whether the second gear is the pinion.
fn swapped(first: &Component, second: &Component) -> Result<bool, Fault> {
    match (first.kind.as_str(), second.kind.as_str()) {
        ("ring_gear", "cylindrical_gear") => Ok(true),
        ("cylindrical_gear", "ring_gear") => Ok(false),
        _ => Ok(teeth(first)? > teeth(second)?),
    }
}

/// Number of teeth of a gear; some programs write it negative for a ring.
///
/// # Errors
/// When it is missing or not a whole number.
pub fn teeth(gear: &Component) -> Result<u32, Fault> {
    /// Maximum number of teeth of a gear.
    const MAX_TEETH: f64 = 10_000.0;
    let teeth = gear.required("number_of_teeth", Unit::None)?.abs();
    if teeth.fract() == 0.0 && (1.0..=MAX_TEETH).contains(&teeth) {
        // `teeth` is a whole number of at most `MAX_TEETH`.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        Ok(teeth as u32)
    } else {
        Err(gear.refused("number_of_teeth", "expected a whole number of teeth"))
    }
}

fn planetary(model: &Model, set: &Component) -> Result<StageKind, Fault> {
    let mut external: Vec<(&Component, [&Component; 2])> = Vec::new();
    let mut internal: Vec<[&Component; 2]> = Vec::new();
    for relation in model.related("stage") {
        let stage = model.in_role(relation, "stage")?;
        if set_of(model, stage).is_none_or(|of| of.id != set.id) {
            continue;
        }
        let pair = ["gear_1", "gear_2"].map(|role| model.in_role(relation, role));
        let [first, second] = pair;
        let pair = [first?, second?];
        if let Some(other) = pair.iter().find(|gear| !is_gear(gear)) {
            let kind = other.kind.clone();
            return Ok(StageKind::Other { kind });
        }
        match pair.iter().position(|gear| gear.kind == "ring_gear") {
            Some(ring) => internal.push([pair[1 - ring], pair[ring]]),
            None => external.push((stage, pair)),
        }
    }
    let planets: Vec<&str> = internal
        .iter()
        .map(|[planet, _]| planet.id.as_str())
        .collect();
    let gears = internal.first().and_then(|[planet, ring]| {
        let with_planet = |(_, pair): &&(&Component, [&Component; 2])| {
            pair.iter().any(|gear| gear.id == planet.id)
        };
        let (stage, pair) = external.iter().find(with_planet)?;
        let sun = pair.iter().find(|gear| gear.id != planet.id)?;
        Some((stage, sun, planet, ring))
    });
    let Some((stage, sun, planet, ring)) = gears else {
        return Ok(StageKind::Other {
            kind: "planetary set without sun or ring".into(),
        });
    };
    Ok(StageKind::Planetary {
        set: set.id.clone(),
        stage: stage.id.clone(),
        sun: sun.id.clone(),
        planet: planet.id.clone(),
        ring: ring.id.clone(),
        planets: planets.len(),
    })
}
