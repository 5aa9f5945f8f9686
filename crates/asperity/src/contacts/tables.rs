//! Rough contacts of a whole mesh, stored for other oils, speeds and temperatures.

use std::collections::BTreeMap;
use std::sync::Arc;

use asperity_core::provenance::Provenance;
use asperity_core::quantity::AngularSpeed;
use asperity_core::task::par_map;
use asperity_gear::LoadMap;

use super::inputs::{ContactInputs, Offsets, WindowInputs};
use super::offsets::offsets_needed;
use super::window_contact::WindowContact;
use crate::mesh::{Mesh, MeshPosition, numbered};
use asperity_case::case::{Case, LoadedCase};
use asperity_case::error::{Error, PositionError};
use asperity_case::flanks::placement::check_coverage;

/// Speed at which the mesh of the contacts is laid out: its places, loads and radii are the same at any speed.
const ANY_SPEED: AngularSpeed = AngularSpeed::from_si(1.0);

/// Rough contact of every window of a mesh.
///
/// The contacts follow from the prepared traces, steels, gears and load, and from the keys of the contact, of which a single struct
/// is made: from neither oil, temperature nor speed, nor from the order or the number of threads in which cases are computed.
/// Another oil, temperature or speed costs film laws only ([`Run::known`](crate::Run::known)). A contact is solved at
/// the shares that a film needs, and stored.
#[derive(Debug, Clone)]
pub struct Contacts {
    inputs: ContactInputs,
    load: LoadMap,
    /// Offsets of each pair of traces.
    each: usize,
    rows: BTreeMap<[u64; 4], Vec<Arc<WindowContact>>>,
    /// Equations of their solution.
    used: Provenance,
    /// Those of the windows alone.
    of_windows: Provenance,
}

impl Contacts {
    /// The contacts of `inputs` under their load over the flanks, which share the windows that `others` have under the same load.
    /// Where the number of offsets follows from the contacts, it is settled here, once for all oils and speeds.
    ///
    /// # Errors
    /// With the number of the position, when traces are too coarse or too short for a contact, or a contact has no solution.
    pub(crate) fn solve<'a>(
        inputs: ContactInputs,
        load: LoadMap,
        others: impl Iterator<Item = &'a Self>,
    ) -> Result<Self, Error> {
        let mesh = Mesh::under(&inputs.mesh, ANY_SPEED, load).map_err(Box::new)?;
        if let Some(coverage) = inputs.windows.surfaces.coverage(mesh.positions.iter()) {
            check_coverage(coverage).map_err(Box::new)?;
        }
        let known: Vec<&Self> = others
            .filter(|other| other.inputs.windows == inputs.windows)
            .collect();
        let mut contacts = Self {
            each: inputs.offsets.first(),
            load: mesh.load,
            rows: BTreeMap::new(),
            inputs,
            used: Provenance::new(),
            of_windows: Provenance::new(),
        };
        contacts.rows = contacts.rows_of(&mesh.positions, &known)?;
        if contacts.inputs.offsets == Offsets::Needed {
            let each = offsets_needed(
                &contacts.inputs.windows,
                &|at| contacts.at(at),
                &mesh.positions,
            )?;
            if each > contacts.each {
                let first = contacts.clone();
                contacts.each = each;
                let known: Vec<&Self> = known.into_iter().chain([&first]).collect();
                contacts.rows = contacts.rows_of(&mesh.positions, &known)?;
            }
        }
        Ok(contacts)
    }

    fn rows_of(
        &self,
        positions: &[MeshPosition],
        known: &[&Self],
    ) -> Result<BTreeMap<[u64; 4], Vec<Arc<WindowContact>>>, Error> {
        let windows = &self.inputs.windows;
        let count = windows.surfaces.offsets(self.each);
        let of_offset = |at, k| {
            let mut shared = known
                .iter()
                .filter_map(|known| known.of_offset(at, k, count));
            match shared.next() {
                Some(shared) => Ok(shared),
                None => WindowContact::of_offset(windows, at, k, count),
            }
        };
        let of_position = |at| (0..count).map(|k| of_offset(at, k)).collect();
        let rows = self.of_windows.collect(|| par_map(positions, of_position));
        let rows = numbered(rows)?;
        for known in known {
            self.of_windows.include(&known.of_windows);
        }
        self.of_windows.note();
        Ok(positions.iter().map(key).zip(rows).collect())
    }

    /// Inputs of the contacts.
    pub(crate) fn inputs(&self) -> &ContactInputs {
        &self.inputs
    }

    /// Whether these are the contacts by `inputs`.
    pub(crate) fn are_by(&self, inputs: &ContactInputs) -> bool {
        self.have_windows_of(inputs) && self.inputs.mesh == inputs.mesh
    }

    /// Whether flanks, steels, size of the windows and number of offsets are the same as in `inputs`.
    fn have_windows_of(&self, inputs: &ContactInputs) -> bool {
        let same_number = match inputs.offsets {
            Offsets::Fixed(each) => self.each == each,
            Offsets::Needed => self.inputs.offsets == Offsets::Needed,
        };
        same_number && self.inputs.windows == inputs.windows
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

    /// The contact of offset `k` of `count` at `position`; `None` if these have fewer offsets. The places of the windows
    /// nest.
    fn of_offset(
        &self,
        position: &MeshPosition,
        k: usize,
        count: usize,
    ) -> Option<Arc<WindowContact>> {
        let row = self.rows.get(&key(position))?;
        let pairs = self.inputs.windows.surfaces.pairs();
        let [each, known] = [count, row.len()].map(|all| (all / pairs).max(1));
        let place = (k % each < known).then_some(k / each * known + k % each)?;
        row.get(place).cloned()
    }

    /// The first `each` offsets of every pair of traces, shared with these.
    #[must_use]
    pub fn first(&self, each: usize) -> Self {
        let pairs = self.inputs.windows.surfaces.pairs();
        let each = each.min(self.each);
        self.part(self.inputs.windows.clone(), each, |row| {
            let of_a_pair = (row.len() / pairs).max(1);
            let pairs = row.chunks(of_a_pair);
            pairs
                .flat_map(|pair| pair.iter().take(each).cloned())
                .collect()
        })
    }

    /// The contacts of the first pair of traces, which are the only ones of `first`.
    pub(crate) fn of_first_pair(&self, first: &LoadedCase) -> Self {
        let pairs = self.inputs.windows.surfaces.pairs();
        let windows = WindowInputs::new(&first.case, &first.surfaces).into();
        self.part(windows, self.each, |row| {
            let count = row.len() / pairs;
            row.iter().take(count.max(1)).cloned().collect()
        })
    }

    /// A part of the windows of every position, as the contacts of a case that states their number.
    fn part(
        &self,
        windows: Arc<WindowInputs>,
        each: usize,
        of_row: impl Fn(&[Arc<WindowContact>]) -> Vec<Arc<WindowContact>>,
    ) -> Self {
        let rows = self.rows.iter().map(|(key, row)| (*key, of_row(row)));
        Self {
            inputs: ContactInputs {
                mesh: self.inputs.mesh.clone(),
                windows,
                offsets: Offsets::Fixed(each),
            },
            load: self.load.clone(),
            each,
            rows: rows.collect(),
            used: self.used.clone(),
            of_windows: self.of_windows.clone(),
        }
    }

    /// The contacts that `solve` makes, with the equations of their solution.
    pub(crate) fn noted(solve: impl FnOnce() -> Result<Self, Error>) -> Result<Self, Error> {
        let used = Provenance::new();
        let found = used.collect(solve)?;
        used.note();
        Ok(Self { used, ..found })
    }

    /// Notes the equations of their solution, which was found before.
    pub(crate) fn note(&self) {
        self.used.note();
    }

    /// Refuses contacts whose flanks, steels, windows or offsets differ from `loaded`.
    pub(crate) fn check(&self, loaded: &LoadedCase) -> Result<(), PositionError> {
        if self.have_windows_of(&ContactInputs::from_case(loaded)) {
            Ok(())
        } else {
            Err(PositionError::other_tables(
                "flank, steel, window or number of offsets",
            ))
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
        row.ok_or_else(|| PositionError::other_tables("line load or radius"))
    }

    /// The load over the teeth of `case`, if it is the load of the contacts.
    pub(crate) fn load_map(&self, case: &Case) -> Option<&LoadMap> {
        (self.inputs.mesh.load == case.load_inputs()).then_some(&self.load)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pipeline::{Kept, Options, outcome};
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
        let first = outcome(&at(&[]), &Options::default(), &|_, _| {})
            .unwrap()
            .2;
        let known = Options {
            kept: Kept::NoPictures,
            ..Options::known(&first)
        };
        let alone = Options {
            kept: Kept::NoPictures,
            ..Options::default()
        };
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
        let (shared, _, contacts) = outcome(&at(&other), &known, &|_, _| {}).unwrap();
        assert_eq!(windows(&contacts), windows(&first));
        let (alone, _, own) = outcome(&at(&other), &alone, &|_, _| {}).unwrap();
        assert_eq!(shared.result, alone.result);
        assert!(
            windows(&own)
                .iter()
                .all(|window| !windows(&first).contains(window))
        );
        let more = outcome(&at(&[("model.offsets", "4")]), &known, &|_, _| {})
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
            let contacts = outcome(&at(&[other]), &known, &|_, _| {}).unwrap().2;
            assert_eq!(of_first(&contacts), 0, "{other:?}");
        }
    }
}
