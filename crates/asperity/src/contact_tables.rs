//! Rough contacts of a whole mesh, kept for other oils, speeds and temperatures.

use std::collections::BTreeMap;
use std::sync::OnceLock;

use asperity_core::material::Material;
use asperity_core::quantity::{Length, Torque};
use asperity_gear::{GearPair, LoadLaw, LoadMap, LoadMapSettings, MicroGeometry};

use crate::case::Case;
use crate::encounter::Encounter;
use crate::error::PositionError;
use crate::local_roughness::Roughness;
use crate::station::Station;
use crate::surfaces::Surfaces;
use asperity_mixed_film::ContactTable;

/// Contact tables of every position and offset of a case, made by
/// [`pipeline::contact_tables`](crate::pipeline::contact_tables).
///
/// They know gears, torque, flanks and steel, but neither oil nor temperature nor speed: of those another
/// costs film laws only, by [`pipeline::losses_with`](crate::pipeline::losses_with). Where the load share
/// does not look at the rough contact they hold the roughness of the windows alone.
#[derive(Debug, Clone)]
pub struct ContactTables {
    fingerprint: Vec<u64>,
    surfaces: Surfaces,
    load: KeptLoad,
    rows: BTreeMap<[u64; 4], Vec<KeptContact>>,
}

/// The load over the teeth and all that it follows from.
#[derive(Debug, Clone)]
struct KeptLoad {
    map: LoadMap,
    /// None of a law of a user's own.
    law: Option<LoadLaw>,
    gears: GearPair,
    micro_geometry: MicroGeometry,
    materials: [Material; 2],
    settings: LoadMapSettings,
    torque: Torque,
}

impl KeptLoad {
    fn new(case: &Case, map: LoadMap) -> Self {
        Self {
            map,
            law: case
                .laws
                .load_distribution
                .is_none()
                .then(|| case.model.load_distribution.clone()),
            gears: case.gears.clone(),
            micro_geometry: case.micro_geometry.clone(),
            materials: case.materials,
            settings: case.load_settings,
            torque: case.torque,
        }
    }

    fn is_of(&self, case: &Case) -> bool {
        case.laws.load_distribution.is_none()
            && self.law.as_ref() == Some(&case.model.load_distribution)
            && self.torque == case.torque
            && self.gears == case.gears
            && self.micro_geometry == case.micro_geometry
            && self.materials == case.materials
            && self.settings == case.load_settings
    }
}

/// The contact of one window with what else does not hang on oil, speed and temperature.
#[derive(Debug, Clone)]
pub(crate) struct KeptContact {
    /// Made at first need: windows that stay apart need none.
    table: OnceLock<ContactTable>,
    /// Mean gap at which the flanks first touch, where a film asked for it.
    pub first_touch: Option<Length>,
    pub roughness: Roughness,
    /// First points of the window on both traces, and its points.
    pub starts: [isize; 2],
    pub points: usize,
}

/// What a film found of a contact: the gap of first touch, and the table where the flanks touch.
#[derive(Debug, Clone)]
pub(crate) struct FoundContact {
    pub first_touch: Length,
    pub table: Option<ContactTable>,
}

impl KeptContact {
    /// The contact of a window; `found` none where no film looked at it.
    pub(crate) fn new(met: &Encounter, roughness: Roughness, found: Option<FoundContact>) -> Self {
        let first_touch = found.as_ref().map(|found| found.first_touch);
        let table = OnceLock::new();
        if let Some(made) = found.and_then(|found| found.table) {
            table.get_or_init(|| made);
        }
        Self {
            table,
            first_touch,
            roughness,
            starts: met.starts,
            points: met.x.len(),
        }
    }

    /// The table, where it was made.
    pub(crate) fn table(&self) -> Option<&ContactTable> {
        self.table.get()
    }

    /// Keeps the table for the next oil.
    pub(crate) fn keep(&self, made: ContactTable) -> &ContactTable {
        self.table.get_or_init(|| made)
    }
}

impl ContactTables {
    pub(crate) fn new(
        case: &Case,
        surfaces: &Surfaces,
        map: LoadMap,
        rows: impl Iterator<Item = (Station, Vec<KeptContact>)>,
    ) -> Self {
        Self {
            fingerprint: fingerprint(case, surfaces),
            surfaces: surfaces.clone(),
            load: KeptLoad::new(case, map),
            rows: rows
                .map(|(station, tables)| (key(&station), tables))
                .collect(),
        }
    }

    /// Whether the tables are those of `case`.
    pub(crate) fn check(&self, case: &Case, surfaces: &Surfaces) -> Result<(), PositionError> {
        let ours: Vec<&Surfaces> = self.surfaces.each().collect();
        let theirs: Vec<&Surfaces> = surfaces.each().collect();
        let mut pairs = ours.iter().zip(&theirs);
        let has_textures =
            ours.len() == theirs.len() && pairs.all(|(one, other)| one.has_textures_of(other));
        if has_textures && self.fingerprint == fingerprint(case, surfaces) {
            Ok(())
        } else {
            let differs = "flank, steel, window or number of offsets";
            Err(PositionError::OtherTables { differs })
        }
    }

    /// The contact at one offset; none where no window was resolved.
    ///
    /// # Errors
    /// When there is no such position.
    pub(crate) fn at(
        &self,
        station: &Station,
        offset: usize,
    ) -> Result<Option<&KeptContact>, PositionError> {
        let differs = "line load or radius";
        let row = self.rows.get(&key(station));
        let row = row.ok_or(PositionError::OtherTables { differs })?;
        Ok(row.get(offset))
    }

    /// The load over the teeth of `case`, where it is that of the tables.
    pub(crate) fn load_map(&self, case: &Case) -> Option<&LoadMap> {
        self.load.is_of(case).then_some(&self.load.map)
    }

    /// Number of windows kept.
    #[must_use]
    pub fn len(&self) -> usize {
        self.rows.values().map(Vec::len).sum()
    }

    /// Whether there is none: the flanks are not measured.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// Load and radius decide the contact of a window, the place on path and face which one it is.
fn key(station: &Station) -> [u64; 4] {
    let [load, radius, place] = [
        station.load.si(),
        station.motion.radius.si(),
        station.s.si(),
    ]
    .map(f64::to_bits);
    [load, radius, place, station.zone as u64]
}

/// Bits of all other inputs of the contacts, except the traces.
fn fingerprint(case: &Case, surfaces: &Surfaces) -> Vec<u64> {
    let [pinion, wheel] = case.flow_pressure;
    let mut bits: Vec<u64> = [
        pinion.si(),
        wheel.si(),
        case.modulus.si(),
        case.model.window,
        case.model.tolerance,
    ]
    .map(f64::to_bits)
    .to_vec();
    bits.push(case.model.offsets as u64);
    let noise = case.preparation.lambda_s.map_or(0.0, |cutoff| cutoff.si());
    bits.push(noise.to_bits());
    bits.extend(case.face_zones.iter().map(|edge| edge.to_bits()));
    for met in surfaces.each() {
        if let Some(placement) = met.placement() {
            let places = placement.traces.iter();
            bits.extend(places.flat_map(|placed| {
                [placed.first_arc, placed.direction, placed.base_radius].map(f64::to_bits)
            }));
            bits.push(placement.misplaced.to_bits());
        }
    }
    bits
}
