//! Seals, bearings, oil jets and tables of losses on the shafts of a gear train, with the places of gears and bearings.

use std::sync::Arc;

use asperity_core::DomainError;
use asperity_core::quantity::{Angle, Length, Mass, Speed, Temperature, VolumeFlow};
use asperity_efficiency::EfficiencyError;
use asperity_efficiency::loss_table::LossTable;
use asperity_efficiency::rolling_bearing::RollingBearing;
use asperity_efficiency::shaft_seal::seal_torque;
use asperity_gear::gear_train::GearTrain;
use serde::{Deserialize, Serialize};

use super::error::CaseError;
use super::files::Reader;
use super::gearbox::{check_jet, named, refused, rolling_bearing, table};
use super::gearbox_input::{BearingInput, MeshJetInput, SealInput, TableInput};
use super::rows::table;
use super::section::Section;
use super::source::Source;

table! {
    /// Seals, bearings, jets and tables of a gear train; only the losses stated here are added to the losses of the meshes.
    #[derive(Default)]
    TrainGearboxInput;

    /// Temperature of the oil at bearings and jets and in the tables; default that of the operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    temperature: Option<Temperature> = "°C" usual [-40.0, 160.0] possible [-100.0, 400.0];
    /// Radial shaft seals, each a table `[[gearbox.seals]]` with the name of its `shaft`, `diameter` and, if wanted, `name`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    seals: Vec<SealInput<String>> => table;
    /// Rolling bearings, two on a shaft, each a table `[[gearbox.bearings]]` with the name of its `shaft`, its place `at`
    /// along the shaft, and type and constants as for a pair of gears. Their loads follow from the teeth by statics, with
    /// `at`, `angle` and `hand` of each mesh on the shaft; the bearing with `locating = true` carries the axial force. The
    /// bearings of the planets of a set have the shaft `NAME planet` (`planet` in a case `[planetary]`), no place, and, if
    /// wanted, `planet_mass` and `per_planet`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    bearings: Vec<BearingInput<String>> => table;
    /// Oil jets onto pairs of gears, each a table `[[gearbox.jets]]` with the name of its `mesh`, `flow`, `speed` and, if
    /// wanted, `name`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    jets: Vec<MeshJetInput> => table;
    /// Measured losses, as of gears that run idle and of clutches, each a table `[[gearbox.tables]]` with the name of its
    /// `shaft`, `file` and, if wanted, `name`; a clutch names its other shaft `against` which it turns.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    tables: Vec<TableInput>;
}

/// Direction of a helix.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Hand {
    /// Left-handed.
    Left,
    /// Right-handed.
    Right,
}

/// Place of a mesh in the gearbox.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshPlace {
    /// Name of the stage.
    pub name: String,
    /// Middle of the teeth along the shafts.
    pub at: Option<Length>,
    /// Angle of the centre line from pinion to wheel.
    pub angle: Option<Angle>,
    /// Direction of the helix of the pinion or sun.
    pub hand: Option<Hand>,
    /// Whether the teeth are helical.
    pub is_helical: bool,
    /// Whether it is a planetary set, whose radial forces are in balance.
    pub is_set: bool,
}

/// Seals and bearings of a gear train with their numbers checked.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainGearbox {
    /// Temperature of the oil at the bearings; `None` for the temperature of the operation.
    pub temperature: Option<Temperature>,
    /// The parts, in the order of the case file.
    pub parts: Vec<TrainPart>,
    /// Place of each stage.
    pub places: Vec<MeshPlace>,
}

/// A part on a shaft of a gear train.
#[derive(Debug, Clone, PartialEq)]
pub struct TrainPart {
    /// Name.
    pub name: String,
    /// Its shaft, by its place in [`GearTrain::shafts`].
    pub shaft: usize,
    /// Kind, with its numbers.
    pub kind: TrainPartKind,
}

/// A part by its kind.
#[derive(Debug, Clone, PartialEq)]
pub enum TrainPartKind {
    /// Shaft seal on a shaft of this diameter.
    Seal(Length),
    /// Rolling bearing.
    Bearing {
        /// Geometry and constants.
        bearing: RollingBearing,
        /// Places of both bearings of the shaft.
        places: [Length; 2],
        /// Its number among them, 0 or 1.
        number: usize,
        /// The bearing that carries the axial force.
        locating: usize,
    },
    /// Rolling bearings of the planets of a set, whose sun is on the shaft.
    PlanetBearing {
        /// The stage.
        stage: usize,
        /// Geometry and constants.
        bearing: RollingBearing,
        /// Mass of a planet.
        mass: Mass,
        /// Equal bearings of a planet.
        per_planet: u32,
    },
    /// Oil jet onto a pair of gears, whose pinion is on the shaft.
    Jet {
        /// The stage.
        stage: usize,
        /// Flow.
        flow: VolumeFlow,
        /// Speed at the nozzle.
        speed: Speed,
    },
    /// Loss torque over the speed of the shaft, or over its difference from the speed of a second shaft.
    Table {
        /// The table.
        table: Arc<LossTable>,
        /// The second shaft.
        against: Option<usize>,
    },
}

/// The parts on the shafts of a train, whose stages have the `places`.
pub(super) fn train_gearbox(
    stated: &TrainGearboxInput,
    places: Vec<MeshPlace>,
    train: &GearTrain,
    (source, files): (&Source, &Reader<'_>),
) -> Result<TrainGearbox, CaseError> {
    let section = Section::of(source, "gearbox");
    let shaft_of = |key: &'static str, name: &str| {
        let known = train.shafts.iter().position(|shaft| shaft.name == name);
        known.ok_or_else(|| section.conflict(key, "names a shaft that no mesh of the train has"))
    };
    let mut parts = Vec::new();
    for (number, seal) in stated.seals.iter().enumerate() {
        let name = named(seal.name.as_deref(), "seal", number);
        seal_torque(seal.diameter).map_err(refused(section, "seals", &name))?;
        parts.push(TrainPart {
            shaft: shaft_of("seals", &seal.shaft)?,
            kind: TrainPartKind::Seal(seal.diameter),
            name,
        });
    }
    for (number, bearing) in stated.bearings.iter().enumerate() {
        let name = named(bearing.name.as_deref(), "bearing", number);
        let checked = without_load(bearing).and_then(|()| rolling_bearing(bearing));
        let rolling = checked.map_err(refused(section, "bearings", &name))?;
        let is_planet = |place: &MeshPlace| place.is_set && place.planet() == bearing.shaft;
        if let Some(stage) = places.iter().position(is_planet) {
            let kind = of_planet(bearing, stage, rolling);
            parts.push(TrainPart {
                shaft: train.stages[stage].gears[0],
                kind: kind.map_err(refused(section, "bearings", &name))?,
                name,
            });
            continue;
        }
        let shaft = shaft_of("bearings", &bearing.shaft)?;
        let planet = [
            bearing.planet_mass.map(|_| "planet_mass"),
            bearing.per_planet.map(|_| "per_planet"),
        ];
        if let Some(key) = planet.into_iter().flatten().next() {
            let refusal = unneeded(key, "is of the bearings of planets");
            refusal.map_err(refused(section, "bearings", &name))?;
        }
        let all = stated.bearings.iter().enumerate();
        let on_shaft = all.filter(|(_, other)| other.shaft == bearing.shaft);
        let [(first, one), (second, other)] = on_shaft.collect::<Vec<_>>()[..] else {
            let rule = "must be two on each shaft that has bearings: the loads of others do not follow from statics";
            return Err(section.conflict("bearings", rule));
        };
        let [Some(z1), Some(z2)] = [one.at, other.at] else {
            let rule = "need their places along the shaft, at";
            return Err(section.conflict("bearings", rule));
        };
        let locating = match [one, other].map(|bearing| bearing.locating == Some(true)) {
            [true, false] => 0,
            [false, true] => 1,
            [false, false] if !has_thrust(&places, train, shaft) => 0,
            _ => {
                let rule = "must have one with locating = true on a shaft with helical gears: it carries the axial force";
                return Err(section.conflict("bearings", rule));
            }
        };
        check_places(&places, train, shaft, section)?;
        let rule = "must differ between the bearings of a shaft";
        let [z1_m, z2_m] = [z1, z2].map(Length::si);
        let differ = DomainError::require(z1_m != z2_m, "at", z1_m, "m", rule);
        differ.map_err(|error| refused(section, "bearings", &name)(error.into()))?;
        debug_assert!(number == first || number == second);
        parts.push(TrainPart {
            shaft,
            kind: TrainPartKind::Bearing {
                bearing: rolling,
                places: [z1, z2],
                number: usize::from(number == second),
                locating,
            },
            name,
        });
    }
    for (number, jet) in stated.jets.iter().enumerate() {
        let name = named(jet.name.as_deref(), "jet", number);
        check_jet(jet.flow, jet.speed).map_err(refused(section, "jets", &name))?;
        let is_pair = |place: &MeshPlace| !place.is_set && place.name == jet.mesh;
        let Some(stage) = places.iter().position(is_pair) else {
            return Err(section.conflict("jets", "must name a pair of gears: mesh"));
        };
        parts.push(TrainPart {
            shaft: train.stages[stage].gears[0],
            kind: TrainPartKind::Jet {
                stage,
                flow: jet.flow,
                speed: jet.speed,
            },
            name,
        });
    }
    for stated in &stated.tables {
        let (file, table) = table(&stated.file, (section, "tables"), files)?;
        let shaft = shaft_of("tables", &stated.shaft)?;
        let against = stated.against.as_ref();
        let against = against.map(|name| shaft_of("tables", name)).transpose()?;
        if against == Some(shaft) {
            return Err(section.conflict("tables", "must name two shafts of a clutch"));
        }
        parts.push(TrainPart {
            name: stated.name.clone().unwrap_or(file),
            shaft,
            kind: TrainPartKind::Table { table, against },
        });
    }
    if parts.is_empty() {
        let rule =
            "names nothing that loses; give seals, bearings, jets or tables, or leave it out";
        return Err(section.conflict_of_key("", rule));
    }
    Ok(TrainGearbox {
        temperature: stated.temperature,
        parts,
        places,
    })
}

impl MeshPlace {
    /// Name of the axes of the planets of a set.
    fn planet(&self) -> String {
        format!("{} planet", self.name).trim_start().to_owned()
    }
}

/// Refuses a key that a part does not have.
fn unneeded(key: &'static str, rule: &'static str) -> Result<(), EfficiencyError> {
    Ok(DomainError::require(false, key, f64::NAN, "-", rule).map(|_| ())?)
}

/// Bearings of the planets of a set.
fn of_planet(
    stated: &BearingInput<String>,
    stage: usize,
    bearing: RollingBearing,
) -> Result<TrainPartKind, EfficiencyError> {
    let of_shaft = [stated.at.map(|_| "at"), stated.locating.map(|_| "locating")];
    if let Some(key) = of_shaft.into_iter().flatten().next() {
        unneeded(key, "is not of the bearings of planets")?;
    }
    let mass = stated.planet_mass.unwrap_or(Mass::from_si(0.0));
    DomainError::non_negative("planet_mass", mass)?;
    let per_planet = stated.per_planet.unwrap_or(1);
    let rule = "must be at least 1";
    DomainError::require(per_planet >= 1, "per_planet", per_planet.into(), "-", rule)?;
    Ok(TrainPartKind::PlanetBearing {
        stage,
        bearing,
        mass,
        per_planet,
    })
}

/// Refuses loads of a bearing, which follow from the teeth.
fn without_load(stated: &BearingInput<String>) -> Result<(), EfficiencyError> {
    let rule = "follows from the teeth in a gear train; leave it out";
    let loads = [("radial", stated.radial), ("axial", stated.axial)];
    for (name, load) in loads {
        let load = load.map_or(0.0, |load| load.si());
        DomainError::require(load == 0.0, name, load, "N", rule)?;
    }
    let torque = stated.at_torque.map_or(0.0, |torque| torque.si());
    DomainError::require(torque == 0.0, "at_torque", torque, "N m", rule)?;
    Ok(())
}

fn has_thrust(places: &[MeshPlace], train: &GearTrain, shaft: usize) -> bool {
    train
        .places_of(shaft)
        .any(|(stage, _)| places[stage].is_helical)
}

/// Checks that the places of all meshes on a shaft with bearings are known.
fn check_places(
    places: &[MeshPlace],
    train: &GearTrain,
    shaft: usize,
    section: Section<'_>,
) -> Result<(), CaseError> {
    let on_shaft = || train.places_of(shaft).map(|(stage, _)| &places[stage]);
    let pairs = || on_shaft().filter(|place| !place.is_set);
    let rule = match () {
        () if pairs().any(|place| place.at.is_none()) => {
            "need the place of each pair of gears on their shaft: mesh.NAME.at"
        }
        () if pairs().count() > 1 && pairs().any(|place| place.angle.is_none()) => {
            "need the angle of the centre line of each pair of gears on a shaft of several: mesh.NAME.angle"
        }
        () if on_shaft().any(|place| place.is_helical && place.hand.is_none()) => {
            "need the direction of the helix of each pinion or sun on their shaft: mesh.NAME.hand"
        }
        () => return Ok(()),
    };
    Err(section.conflict("bearings", rule))
}
