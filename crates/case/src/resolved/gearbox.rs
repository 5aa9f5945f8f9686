//! Seals, bearings, oil jets and tables of losses on the shafts of a train, with their numbers checked.
//!
//! A pair of gears is a train of one mesh, whose shafts are called `pinion` and `wheel`.

use std::path::Path;
use std::sync::Arc;

use asperity_core::DomainError;
use asperity_core::message::Warning;
use asperity_core::quantity::{Angle, Force, Length, Mass, Speed, Temperature, Torque, VolumeFlow};
use asperity_efficiency::EfficiencyError;
use asperity_efficiency::loss_table::LossTable;
use asperity_efficiency::rolling_bearing::{BearingConstants, BearingForm, RollingBearing};
use asperity_efficiency::shaft_seal::seal_torque;
use asperity_gear::gear_train::GearTrain;

use crate::input::files::{Content, Reader};
use crate::input::gearbox_input::{BearingInput, BearingKind, GearboxInput, Hand};
use crate::loss_table::read;
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;

/// Place of a mesh in the gearbox.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MeshPlace {
    /// Name of the stage; empty if it is the only one and has none.
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

impl MeshPlace {
    /// Name of the axes of the planets of a set.
    fn planet(&self) -> String {
        format!("{} planet", self.name).trim_start().to_owned()
    }
}

/// The parts with losses in addition to the meshes.
#[derive(Debug, Clone, PartialEq)]
pub struct Gearbox {
    /// Temperature of their oil; `None` for the temperature of the operation.
    pub temperature: Option<Temperature>,
    /// The parts, in the order of the case file.
    pub parts: Vec<Part>,
    /// Place of each stage.
    pub places: Vec<MeshPlace>,
    /// Doubts about their tables.
    pub warnings: Vec<Warning>,
}

/// A part with a loss.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// Name.
    pub name: String,
    /// Its shaft, by its place in [`GearTrain::shafts`].
    pub shaft: usize,
    /// Kind, with its numbers.
    pub kind: PartKind,
}

/// A part by its kind.
#[derive(Debug, Clone, PartialEq)]
pub enum PartKind {
    /// Shaft seal on a shaft of this diameter.
    Seal(Length),
    /// Rolling bearing.
    Bearing {
        /// Geometry and constants.
        bearing: RollingBearing,
        /// Its load.
        load: BearingLoads,
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

/// Load of a bearing.
#[derive(Debug, Clone, PartialEq)]
pub enum BearingLoads {
    /// As stated.
    Stated {
        /// Radial and axial load.
        load: [Force; 2],
        /// Torque of the operation at which the loads are as stated; `None` if they are constant.
        at_torque: Option<Torque>,
    },
    /// By the forces of all teeth on the shaft.
    OfTeeth {
        /// Places of both bearings of the shaft.
        places: [Length; 2],
        /// Its number among them, 0 or 1.
        number: usize,
        /// The bearing that carries the axial force.
        locating: usize,
    },
}

impl GearboxInput {
    /// The parts on the shafts of `train`, whose stages have the `places`, with their tables read. The shafts of a pair of gears
    /// are `pinion` and `wheel`; its jet is onto its mesh, and its table over the speed of the pinion.
    pub(crate) fn gearbox(
        &self,
        places: Vec<MeshPlace>,
        train: &GearTrain,
        source: &Source,
        files: &Reader<'_>,
    ) -> Result<Gearbox, CaseError> {
        let section = Section::new(source, "gearbox");
        let shaft_of = |key, name: &str| shaft_of(train, &places, section, key, name);
        let (mut parts, mut warnings) = (Vec::new(), Vec::new());
        for (number, seal) in self.seals.iter().enumerate() {
            let name = named(seal.name.as_deref(), "seal", number);
            seal_torque(seal.diameter).map_err(refused(section, "seals", &name))?;
            parts.push(Part {
                shaft: shaft_of("seals", &seal.shaft)?,
                kind: PartKind::Seal(seal.diameter),
                name,
            });
        }
        for (number, bearing) in self.bearings.iter().enumerate() {
            let name = named(bearing.name.as_deref(), "bearing", number);
            let (shaft, kind) = self.bearing(number, &name, train, &places, section)?;
            parts.push(Part { name, shaft, kind });
        }
        let jet = self
            .jet
            .iter()
            .map(|jet| ("jet", "oil jet".to_owned(), "", (jet.flow, jet.speed)));
        let jets = self.jets.iter().enumerate().map(|(number, jet)| {
            let name = named(jet.name.as_deref(), "jet", number);
            ("jets", name, jet.mesh.as_str(), (jet.flow, jet.speed))
        });
        for (key, name, mesh, (flow, speed)) in jet.chain(jets) {
            check_jet(flow, speed).map_err(refused(section, key, &name))?;
            let is_pair = |place: &MeshPlace| !place.is_set && place.name == mesh;
            let Some(stage) = places.iter().position(is_pair) else {
                return Err(section.conflict(key, "must name a pair of gears: mesh"));
            };
            parts.push(Part {
                shaft: train.stages[stage].gears[0],
                kind: PartKind::Jet { stage, flow, speed },
                name,
            });
        }
        if let Some(file) = &self.loss_table {
            let (name, table, warning) = table(file, section, "loss_table", files)?;
            warnings.extend(warning);
            // The input shaft is the first.
            let (shaft, against) = (0, None);
            let kind = PartKind::Table { table, against };
            parts.push(Part { name, shaft, kind });
        }
        for stated in &self.tables {
            let (file, table, warning) = table(&stated.file, section, "tables", files)?;
            warnings.extend(warning);
            let shaft = shaft_of("tables", &stated.shaft)?;
            let against = stated.against.as_ref();
            let against = against.map(|name| shaft_of("tables", name)).transpose()?;
            if against == Some(shaft) {
                return Err(section.conflict("tables", "must name two shafts of a clutch"));
            }
            parts.push(Part {
                name: stated.name.clone().unwrap_or(file),
                shaft,
                kind: PartKind::Table { table, against },
            });
        }
        if parts.is_empty() {
            let rule = if is_only(&places) {
                "names nothing that loses; give seals, bearings, jet or loss_table, or leave it out"
            } else {
                "names nothing that loses; give seals, bearings, jets or tables, or leave it out"
            };
            return Err(section.conflict_of_key("", rule));
        }
        Ok(Gearbox {
            temperature: self.temperature,
            parts,
            places,
            warnings,
        })
    }

    /// The shaft of bearing `number`, called `name`, and its numbers.
    fn bearing(
        &self,
        number: usize,
        name: &str,
        train: &GearTrain,
        places: &[MeshPlace],
        section: Section<'_>,
    ) -> Result<(usize, PartKind), CaseError> {
        let stated = &self.bearings[number];
        let on = stated.shaft.as_str();
        let refused = refused(section, "bearings", name);
        let is_own = |place: &MeshPlace| place.is_set && place.planet() == on;
        if let Some(stage) = places.iter().position(is_own) {
            let kind = of_planet(stated, stage).map_err(refused)?;
            return Ok((train.stages[stage].gears[0], kind));
        }
        let load = if is_only(places) {
            Some(stated_load(stated).map_err(&refused)?)
        } else {
            without_load(stated).map_err(&refused)?;
            None
        };
        let bearing = rolling_bearing(stated).map_err(&refused)?;
        let shaft = shaft_of(train, places, section, "bearings", on)?;
        let load = match load {
            Some(load) => load,
            None => self.of_teeth(number, shaft, train, places, section, refused)?,
        };
        Ok((shaft, PartKind::Bearing { bearing, load }))
    }

    /// The load of bearing `number` on a shaft by the teeth on it, with the other bearing of the shaft.
    fn of_teeth(
        &self,
        number: usize,
        shaft: usize,
        train: &GearTrain,
        places: &[MeshPlace],
        section: Section<'_>,
        refused: impl Fn(EfficiencyError) -> CaseError,
    ) -> Result<BearingLoads, CaseError> {
        let bearing = &self.bearings[number];
        let planet = [
            bearing.planet_mass.map(|_| "planet_mass"),
            bearing.per_planet.map(|_| "per_planet"),
        ];
        unneeded(planet, "is of the bearings of planets").map_err(&refused)?;
        let all = self.bearings.iter().enumerate();
        let on_shaft = all.filter(|(_, other)| other.shaft == bearing.shaft);
        let [(_, one), (second, other)] = on_shaft.collect::<Vec<_>>()[..] else {
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
            [false, false] if !has_thrust(places, train, shaft) => 0,
            _ => {
                let rule = "must have one with locating = true on a shaft with helical gears: it carries the axial force";
                return Err(section.conflict("bearings", rule));
            }
        };
        check_places(places, train, shaft, section)?;
        let rule = "must differ between the bearings of a shaft";
        let [z1_m, z2_m] = [z1, z2].map(Length::si);
        let differ = DomainError::require(z1_m != z2_m, "at", z1_m, "m", rule);
        differ.map_err(|error| refused(error.into()))?;
        Ok(BearingLoads::OfTeeth {
            places: [z1, z2],
            number: usize::from(number == second),
            locating,
        })
    }
}

/// Whether the gearbox is of a pair of gears, the only mesh, which has no name.
fn is_only(places: &[MeshPlace]) -> bool {
    matches!(places, [only] if only.name.is_empty() && !only.is_set)
}

/// The shaft called `name`, which the key names.
fn shaft_of(
    train: &GearTrain,
    places: &[MeshPlace],
    section: Section<'_>,
    key: &'static str,
    name: &str,
) -> Result<usize, CaseError> {
    let known = train.shafts.iter().position(|shaft| shaft.name == name);
    known.ok_or_else(|| {
        if is_only(places) {
            section.value(
                key,
                format!("unknown choice \"{name}\", expected pinion or wheel"),
            )
        } else {
            section.conflict(key, "names a shaft that no mesh of the train has")
        }
    })
}

fn named(stated: Option<&str>, kind: &str, number: usize) -> String {
    stated.map_or_else(|| format!("{kind} {}", number + 1), str::to_owned)
}

fn refused<'a>(
    section: Section<'a>,
    key: &'a str,
    part: &'a str,
) -> impl Fn(EfficiencyError) -> CaseError + use<'a> {
    move |error| CaseError::gearbox_part(section.place(key), section.key(key), part, error)
}

/// Refuses the first of keys that a part does not have.
fn unneeded<const N: usize>(
    stated: [Option<&'static str>; N],
    rule: &'static str,
) -> Result<(), EfficiencyError> {
    match stated.into_iter().flatten().next() {
        None => Ok(()),
        Some(key) => Ok(DomainError::require(false, key, f64::NAN, "-", rule).map(|_| ())?),
    }
}

/// The stated load of a bearing of a pair of gears.
fn stated_load(stated: &BearingInput) -> Result<BearingLoads, EfficiencyError> {
    let of_train = [
        stated.at.map(|_| "at"),
        stated.locating.map(|_| "locating"),
        stated.planet_mass.map(|_| "planet_mass"),
        stated.per_planet.map(|_| "per_planet"),
    ];
    let rule = "is of a gear train, where the load of a bearing follows from the teeth";
    unneeded(of_train, rule)?;
    let radial = stated.radial.unwrap_or(Force::from_si(f64::NAN));
    let axial = stated.axial.unwrap_or(Force::from_si(0.0));
    DomainError::positive("radial", radial)?;
    DomainError::non_negative("axial", axial)?;
    if let Some(torque) = stated.at_torque {
        let (value, rule) = (torque.si(), "must be finite and not zero");
        let holds = value.is_finite() && value != 0.0;
        DomainError::require(holds, "at_torque", value, "N m", rule)?;
    }
    Ok(BearingLoads::Stated {
        load: [radial, axial],
        at_torque: stated.at_torque,
    })
}

/// Bearings of the planets of a set.
fn of_planet(stated: &BearingInput, stage: usize) -> Result<PartKind, EfficiencyError> {
    without_load(stated)?;
    let bearing = rolling_bearing(stated)?;
    let of_shaft = [stated.at.map(|_| "at"), stated.locating.map(|_| "locating")];
    unneeded(of_shaft, "is not of the bearings of planets")?;
    let mass = stated.planet_mass.unwrap_or(Mass::from_si(0.0));
    DomainError::non_negative("planet_mass", mass)?;
    let per_planet = stated.per_planet.unwrap_or(1);
    let rule = "must be at least 1";
    DomainError::require(per_planet >= 1, "per_planet", per_planet.into(), "-", rule)?;
    Ok(PartKind::PlanetBearing {
        stage,
        bearing,
        mass,
        per_planet,
    })
}

/// Refuses loads of a bearing, which follow from the teeth.
fn without_load(stated: &BearingInput) -> Result<(), EfficiencyError> {
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

/// A rolling bearing with the constants that its kind needs.
fn rolling_bearing(stated: &BearingInput) -> Result<RollingBearing, EfficiencyError> {
    let &BearingInput {
        name: _,
        shaft: _,
        kind,
        bore,
        outside_diameter,
        at: _,
        locating: _,
        planet_mass: _,
        per_planet: _,
        radial: _,
        axial: _,
        at_torque: _,
        static_rating,
        axial_factor,
        r1,
        r2,
        s1,
        s2,
        k_z,
        k_rs,
        mu_bl,
        mu_ehl,
    } = stated;
    let positive = "is needed here, and must be greater than zero";
    let needed = |name, value: Option<f64>, unit| {
        let value = value.unwrap_or(f64::NAN);
        DomainError::require(value > 0.0, name, value, unit, positive)
    };
    let unused = |name, value: Option<f64>, unit| match value {
        None => Ok(0.0),
        Some(value) => {
            DomainError::require(false, name, value, unit, "is of another kind of bearing")
        }
    };
    let rating = static_rating.map(Force::si);
    let form = match kind {
        BearingKind::DeepGrooveBall => {
            unused("axial_factor", axial_factor, "-")?;
            let rating = needed("static_rating", rating, "N")?;
            BearingForm::DeepGrooveBall {
                static_rating: Force::from_si(rating),
            }
        }
        BearingKind::CylindricalRoller => {
            unused("axial_factor", axial_factor, "-")?;
            unused("static_rating", rating, "N")?;
            unused("r2", r2, "-")?;
            BearingForm::CylindricalRoller
        }
        BearingKind::TaperedRoller => {
            unused("static_rating", rating, "N")?;
            BearingForm::TaperedRoller {
                axial_factor: needed("axial_factor", axial_factor, "-")?,
            }
        }
    };
    let r2 = match kind {
        BearingKind::CylindricalRoller => 0.0,
        _ => needed("r2", r2, "-")?,
    };
    let bearing = RollingBearing {
        form,
        bore,
        outside_diameter,
        constants: BearingConstants {
            r1,
            r2,
            s1,
            s2,
            k_z,
            k_rs,
            mu_bl,
            mu_ehl,
        },
    };
    bearing.check()?;
    Ok(bearing)
}

/// Name and content of the table `file`, which is stated at `key`, and a doubt about it.
fn table(
    file: &Path,
    section: Section<'_>,
    key: &str,
    files: &Reader<'_>,
) -> Result<(String, Arc<LossTable>, Option<Warning>), CaseError> {
    let name = file
        .file_name()
        .unwrap_or(file.as_os_str())
        .to_string_lossy();
    let bytes = match files.open(file, section.source, section.key(key).into_owned())? {
        (Content::Bytes(bytes), _) => bytes,
        (Content::Heights(_), _) => {
            return Err(section.value(key, "names a trace, not a table of losses"));
        }
    };
    let (table, warning) = read(&name, &String::from_utf8_lossy(&bytes))
        .map_err(|error| CaseError::loss_table(section.place(key), &section.key(key), error))?;
    Ok((name.into_owned(), Arc::new(table), warning))
}

/// Checks the numbers of a jet.
fn check_jet(flow: VolumeFlow, speed: Speed) -> Result<(), EfficiencyError> {
    DomainError::positive("flow", flow)?;
    DomainError::non_negative("speed", speed)?;
    Ok(())
}
