//! Rough contacts of a whole mesh, stored for other oils, speeds and temperatures.

use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

use asperity_core::cancel::checkpoint;
use asperity_core::material::Material;
use asperity_core::quantity::Torque;
use asperity_gear::{GearPair, LoadLaw, LoadMap, LoadMapSettings, MicroGeometry};
use asperity_mixed_film::ContactTable;

use crate::mesh::{Mesh, MeshPosition};
use asperity_case::case::{Case, Formulation, LoadedCase};
use asperity_case::error::PositionError;
use asperity_case::flanks::{Roughness, Surfaces, Window};

/// Rough contact of every window of a mesh.
///
/// The contacts depend on gears, torque, flanks and steel, but on neither oil, temperature nor speed: another of
/// these costs film laws only ([`losses_with`](crate::pipeline::losses_with)). A contact is solved at the shares that a
/// film needs, and stored.
#[derive(Debug, Clone)]
pub struct Contacts {
    fingerprint: Vec<u64>,
    surfaces: Surfaces,
    load: StoredLoad,
    /// Offsets of each pair of traces.
    each: usize,
    rows: BTreeMap<[u64; 4], Vec<Arc<WindowContact>>>,
}

/// The load over the teeth and all that it follows from.
#[derive(Debug, Clone)]
struct StoredLoad {
    map: LoadMap,
    /// `None` of a user-defined law.
    law: Option<LoadLaw>,
    gears: GearPair,
    micro_geometry: MicroGeometry,
    materials: [Material; 2],
    settings: LoadMapSettings,
    torque: Torque,
}

impl StoredLoad {
    fn new(case: &Case, map: LoadMap) -> Self {
        let is_named = case.laws.load_distribution.is_none();
        Self {
            map,
            law: is_named.then(|| case.model.load_distribution.clone()),
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

/// The rough contact of one window, and its roughness.
#[derive(Debug, Clone)]
pub(crate) struct WindowContact {
    /// Roughness of the window, or of the flanks as a whole where no window is resolved.
    pub roughness: Roughness,
    /// Place of the window on the traces; `None` where no window is resolved.
    pub window: Option<Window>,
    /// The contact at the shares solved so far, once a film needed it.
    pub table: OnceLock<ContactTable>,
}

impl WindowContact {
    /// The windows of all offsets at `position`, with their roughness; those that `known` contacts have are shared.
    ///
    /// # Errors
    /// When the traces are too coarse or too short for the contact.
    pub(crate) fn of_position(
        loaded: &LoadedCase,
        position: &MeshPosition,
        known: &[&Contacts],
    ) -> Result<Vec<Arc<Self>>, PositionError> {
        let count = loaded.surfaces.offsets(loaded.case.model.offsets);
        let contact = |k: usize| {
            let mut shared = known
                .iter()
                .filter_map(|known| known.of_offset(position, (k, count)));
            match shared.next() {
                Some(shared) => Ok(shared),
                None => Self::of_offset(loaded, position, (k, count)),
            }
        };
        (0..count).map(contact).collect()
    }

    /// The window of offset `k` of `count` at `position`, with its roughness.
    fn of_offset(
        loaded: &LoadedCase,
        position: &MeshPosition,
        (k, count): (usize, usize),
    ) -> Result<Arc<Self>, PositionError> {
        checkpoint()?;
        let (surfaces, model) = (&loaded.surfaces, &loaded.case.model);
        Ok(Arc::new(Self {
            window: Window::at(surfaces, position, model.window, k, count)?,
            roughness: surfaces.roughness_at(position, model.window, (k, count))?,
            table: OnceLock::new(),
        }))
    }

    /// Whether the contact was solved at any share.
    fn is_solved(&self) -> bool {
        (self.table.get()).is_some_and(|table| table.rows().next().is_some())
    }

    /// Checks the windows at the first offset of each pair of teeth as [`of_position`](Self::of_position) does.
    ///
    /// # Errors
    /// When the traces do not have the windows, or the paper's formulation has no traces.
    pub(crate) fn check(loaded: &LoadedCase, position: &MeshPosition) -> Result<(), PositionError> {
        let (surfaces, model) = (&loaded.surfaces, &loaded.case.model);
        let count = surfaces.offsets(model.offsets);
        for k in (0..count).filter(|k| surfaces.begins_a_pair(*k, count)) {
            let window = Window::at(surfaces, position, model.window, k, count)?;
            if window.is_none() && loaded.case.formulation == Formulation::Paper {
                return Err(PositionError::NoProfile);
            }
            surfaces.roughness_at(position, model.window, (k, count))?;
        }
        Ok(())
    }
}

impl Contacts {
    /// The contacts of a case with the windows of each position of `mesh`.
    pub(crate) fn new(
        loaded: &LoadedCase,
        mesh: &Mesh,
        rows: Vec<Vec<Arc<WindowContact>>>,
    ) -> Self {
        let (case, surfaces) = (&loaded.case, &loaded.surfaces);
        Self {
            each: case.model.offsets,
            fingerprint: fingerprint(case, surfaces),
            surfaces: surfaces.clone(),
            load: StoredLoad::new(case, mesh.load.clone()),
            rows: mesh.positions.iter().map(key).zip(rows).collect(),
        }
    }

    /// Number of offsets of each pair of traces.
    #[must_use]
    pub fn offsets(&self) -> usize {
        self.each
    }

    /// Addresses of the windows whose contact was solved; contacts that share a window have the same one.
    pub fn solved(&self) -> impl Iterator<Item = usize> {
        let windows = self.rows.values().flatten();
        let solved = windows.filter(|window| window.is_solved());
        solved.map(|window| Arc::as_ptr(window) as usize)
    }

    /// Whether these have windows of the flanks of `loaded`, of the same steels and size.
    pub(crate) fn have_windows_of(&self, loaded: &LoadedCase) -> bool {
        self.surfaces.has_flanks_of(&loaded.surfaces)
            && self.fingerprint == fingerprint(&loaded.case, &loaded.surfaces)
    }

    /// The contact of offset `k` of `count` at `position`; `None` if these have fewer offsets. The places of the windows
    /// nest.
    fn of_offset(
        &self,
        position: &MeshPosition,
        (k, count): (usize, usize),
    ) -> Option<Arc<WindowContact>> {
        let row = self.rows.get(&key(position))?;
        let pairs = self.surfaces.pairs();
        let [each, known] = [count, row.len()].map(|all| (all / pairs).max(1));
        let place = (k % each < known).then_some(k / each * known + k % each)?;
        row.get(place).cloned()
    }

    /// The first `each` offsets of every pair of traces, shared with these.
    #[must_use]
    pub fn first(&self, each: usize) -> Self {
        let first = |row: &Vec<Arc<WindowContact>>| {
            let of_a_pair = (row.len() / self.surfaces.pairs()).max(1);
            let pairs = row.chunks(of_a_pair);
            pairs
                .flat_map(|pair| pair.iter().take(each).cloned())
                .collect()
        };
        let mut part = Self {
            each: each.min(self.each),
            rows: BTreeMap::new(),
            ..self.clone()
        };
        part.rows = self
            .rows
            .iter()
            .map(|(key, row)| (*key, first(row)))
            .collect();
        part
    }

    /// The contacts of the first pair of traces, which `first` has alone.
    pub(crate) fn of_first_pair(&self, first: &LoadedCase) -> Self {
        let of_a_pair = |row: &Vec<Arc<WindowContact>>| {
            let count = row.len() / self.surfaces.pairs();
            row.iter().take(count.max(1)).cloned().collect()
        };
        let mut part = Self {
            fingerprint: fingerprint(&first.case, &first.surfaces),
            surfaces: first.surfaces.clone(),
            rows: BTreeMap::new(),
            ..self.clone()
        };
        part.rows = self
            .rows
            .iter()
            .map(|(key, row)| (*key, of_a_pair(row)))
            .collect();
        part
    }

    /// Refuses contacts whose flanks, steels, windows or offsets differ from `loaded`.
    pub(crate) fn check(&self, loaded: &LoadedCase) -> Result<(), PositionError> {
        let is_same = self.have_windows_of(loaded) && self.each == loaded.case.model.offsets;
        match is_same {
            true => Ok(()),
            false => Err(PositionError::OtherTables {
                differs: "flank, steel, window or number of offsets",
            }),
        }
    }

    /// The contacts of all offsets at `position`.
    ///
    /// # Errors
    /// When there is no such position.
    pub(crate) fn at(
        &self,
        position: &MeshPosition,
    ) -> Result<&[Arc<WindowContact>], PositionError> {
        let row = self.rows.get(&key(position)).map(Vec::as_slice);
        row.ok_or(PositionError::OtherTables {
            differs: "line load or radius",
        })
    }

    /// The load over the teeth of `case`, if it is the load of the contacts.
    pub(crate) fn load_map(&self, case: &Case) -> Option<&LoadMap> {
        self.load.is_of(case).then_some(&self.load.map)
    }

    /// Number of windows.
    #[must_use]
    pub fn len(&self) -> usize {
        let windows = self.rows.values().flatten();
        windows.filter(|contact| contact.window.is_some()).count()
    }

    /// Whether there is no window: the flanks are not measured.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// Load and radius decide the contact of a window, the place on path and face which one it is.
fn key(position: &MeshPosition) -> [u64; 4] {
    let [load, radius, place] = [
        position.load.si(),
        position.motion.radius.si(),
        position.s.si(),
    ]
    .map(f64::to_bits);
    [load, radius, place, position.zone as u64]
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
    let noise = case.preparation.lambda_s.map_or(0.0, |cutoff| cutoff.si());
    bits.push(noise.to_bits());
    bits.push(u64::from(case.laws.exact_contacts));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pipeline::outcome;
    use asperity_case::case;

    fn at(settings: &[(&str, &str)]) -> LoadedCase {
        let file = concat!(
            env!("CARGO_MANIFEST_DIR"),
            "/../../fixtures/cases/e-drive.toml"
        );
        let few = [
            ("model.positions", "4"),
            ("model.offsets", "2"),
            ("model.depths", "0"),
        ];
        case::load_with(file.as_ref(), &|input| {
            for (key, value) in few.iter().chain(settings) {
                input.set(key, value).unwrap();
            }
        })
        .unwrap()
    }

    fn windows(contacts: &Contacts) -> Vec<*const WindowContact> {
        contacts.rows.values().flatten().map(Arc::as_ptr).collect()
    }

    #[test]
    fn meshes_with_the_same_windows_under_the_same_load_share_their_contacts() {
        let first = outcome(&at(&[]), None, &[], &|_, _| {}).unwrap().2;
        let known = std::slice::from_ref(&first);
        assert!(
            first
                .rows
                .values()
                .flatten()
                .any(|window| window.is_solved())
        );
        // Speed and temperature are not of the contact, and more offsets nest.
        let other = [
            ("operation.speed", "3000 1/min"),
            ("operation.bulk_temperature", "70 °C"),
        ];
        let (shared, _, contacts) = outcome(&at(&other), None, known, &|_, _| {}).unwrap();
        assert_eq!(windows(&contacts), windows(&first));
        let (alone, _, own) = outcome(&at(&other), None, &[], &|_, _| {}).unwrap();
        assert_eq!(shared.result, alone.result);
        assert!(
            windows(&own)
                .iter()
                .all(|window| !windows(&first).contains(window))
        );
        let more = outcome(&at(&[("model.offsets", "4")]), None, known, &|_, _| {})
            .unwrap()
            .2;
        let of_first = |contacts: &Contacts| {
            let known = windows(&first);
            windows(contacts)
                .iter()
                .filter(|window| known.contains(window))
                .count()
        };
        assert_eq!(of_first(&more), windows(&first).len());
        // Another load or other steels have other contacts.
        for other in [
            ("operation.torque", "140 N m"),
            ("material.pinion.flow_pressure", "6 GPa"),
        ] {
            let contacts = outcome(&at(&[other]), None, known, &|_, _| {}).unwrap().2;
            assert_eq!(of_first(&contacts), 0, "{other:?}");
        }
    }
}
