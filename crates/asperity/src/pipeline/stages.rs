//! The functions of a run and the values between them.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity_core::cite;
use asperity_core::numerics::mean;
use asperity_core::provenance::Provenance;
use asperity_core::task::{Items, par_map};
use asperity_ehl_regime::inlet_flow::Lay;

use super::bulk_temperature;
use super::kept::Kept;
use super::options::{Options, Progress};

use crate::assembly::{Solved, equations_used, sources_used, warnings_of_case};
use crate::contacts::running_in;
use crate::contacts::{ContactInputs, Contacts, Offsets, WindowContact};
use crate::lubrication::{
    ChosenLaws, LubricatedMesh, LubricatedPosition, LubricatedWindow, check_mesh_position,
    plausible_film, records_of,
};
use crate::mesh::{Mesh, MeshInputs, MeshPosition, numbered};
use crate::pictures::Picture;
use crate::records::PathRecords;
use crate::result::{Losses, MeshOutcome, RunInFlanks, Summary};
use asperity_case::case::{
    Alternative, Case, LoadShareName, LoadedCase, OperatingCase, Positions, ShareLaw,
};
use asperity_case::error::{Error, PositionError};
use asperity_case::flanks::placement::check_coverage;
use asperity_case::flanks::{Surfaces, is_substituted};
use asperity_case::message::Warning;

/// Checks a mesh as [`Run::check`](crate::Run::check); returns the warnings that are not in the loaded case.
pub(crate) fn check(loaded: &LoadedCase) -> Result<Vec<Warning>, Error> {
    let stated = &loaded.at_stated()?;
    let mesh = placed_mesh(loaded, None).map_err(Box::new)?;
    let firsts = |position: &MeshPosition| {
        check_mesh_position(position)?;
        let film = plausible_film(stated, position)?;
        WindowContact::check(loaded, position)?;
        Ok(film)
    };
    let films = numbered(par_map(&mesh.positions, firsts))?;
    if let Some(plan) = &loaded.case.running_in {
        running_in::check(&loaded.case, &loaded.surfaces, plan).map_err(Box::new)?;
    }
    Ok(warnings_of_case(stated, &mesh, &films).map_err(Box::new)?)
}

/// The mesh of a case on traces that cover it, under the load of `contacts` if that is known.
fn placed_mesh(loaded: &LoadedCase, contacts: Option<&Contacts>) -> Result<Mesh, PositionError> {
    let case = &loaded.case;
    // A table that does not reach the operating point is reported before the work.
    crate::gearbox::parts_of_mesh(case)?;
    let mesh = match contacts.and_then(|contacts| contacts.load_map(case)) {
        Some(map) => Mesh::under(&MeshInputs::from_case(case), case.speed, map.clone())?,
        None => Mesh::new(case)?,
    };
    if let Some(coverage) = loaded.surfaces.coverage(mesh.positions.iter()) {
        check_coverage(coverage)?;
    }
    Ok(mesh)
}

/// The rough contacts of a case: those of `known` that are its own, or new ones, which share the windows that the known ones have under
/// the same load.
///
/// # Errors
/// When the traces are too coarse or too short for a contact.
pub(crate) fn contacts(loaded: &LoadedCase, known: &[&Contacts]) -> Result<Contacts, Error> {
    Ok(sampled(loaded, known)?.1.into_owned())
}

/// The case with the number of offsets that its contacts have, and the [`contacts`].
pub(super) fn sampled<'a>(
    loaded: &'a LoadedCase,
    known: &[&'a Contacts],
) -> Result<(Cow<'a, LoadedCase>, Cow<'a, Contacts>), Error> {
    let inputs = ContactInputs::from_case(loaded);
    let own = known.iter().find(|known| known.are_by(&inputs));
    let contacts = match own {
        Some(own) => {
            own.note();
            Cow::Borrowed(*own)
        }
        None => Cow::Owned(Contacts::noted(|| {
            let mesh = placed_mesh(loaded, None).map_err(Box::new)?;
            contacts_of(loaded, &mesh, known.iter().copied())
        })?),
    };
    Ok((with_offsets(loaded, contacts.offsets())?, contacts))
}

/// The contacts of `loaded`, with the load of `mesh` over the flanks.
fn contacts_of<'a>(
    loaded: &LoadedCase,
    mesh: &Mesh,
    others: impl Iterator<Item = &'a Contacts>,
) -> Result<Contacts, Error> {
    numbered(mesh.positions.iter().map(check_mesh_position).collect())?;
    Contacts::solve(ContactInputs::from_case(loaded), mesh.load.clone(), others)
}

/// Whether the number of offsets of `loaded` follows from its contacts: the case states none, and its load share follows from
/// windows of traces whose place on the flank is not known.
pub fn chooses_offsets(loaded: &LoadedCase) -> bool {
    Offsets::from_case(loaded) == Offsets::Needed
}

/// `loaded` with this number of offsets.
fn with_offsets(loaded: &LoadedCase, offsets: usize) -> Result<Cow<'_, LoadedCase>, Error> {
    if offsets == loaded.case.model.offsets {
        return Ok(Cow::Borrowed(loaded));
    }
    let more = loaded.overridden(|over| over.offsets = Some(offsets))?;
    Ok(Cow::Owned(more))
}

/// Losses of a case at a bulk temperature, with its rough contacts.
///
/// # Errors
/// When a position has no solution, and when the contacts belong to other flanks, gears or loads.
pub(crate) fn losses_at(contacts: &Contacts, case: &OperatingCase) -> Result<Losses, Error> {
    contacts.check(case).map_err(Box::new)?;
    let used = Provenance::new();
    let case = if contacts.offsets() == case.model.offsets {
        Cow::Borrowed(case)
    } else {
        Cow::Owned(case.overridden(|over| over.offsets = Some(contacts.offsets()))?)
    };
    losses_of_stages(&case, contacts, &|_, _| {}, used)
}

/// The case at its bulk temperature, stated or in equilibrium with its loss.
///
/// # Errors
/// As [`losses_of`], and when the temperature does not settle.
pub(crate) fn settled(loaded: &LoadedCase, options: &Options<'_>) -> Result<OperatingCase, Error> {
    if loaded.case.bulk.is_none() {
        return loaded.at_stated();
    }
    let (sampled, contacts) = sampled(loaded, &options.known)?;
    warmed(&sampled, &contacts, options.seeks_hotter)
}

/// The case at its bulk temperature, with its contacts; a hotter equilibrium is sought if `seeks_hotter` is set.
pub(super) fn warmed(
    loaded: &LoadedCase,
    contacts: &Contacts,
    seeks_hotter: bool,
) -> Result<OperatingCase, Error> {
    let Some(model) = loaded.case.bulk else {
        return loaded.at_stated();
    };
    let losses = |case: &OperatingCase| losses_at(contacts, case);
    let mesh = |case: &LoadedCase| placed_mesh(case, Some(contacts));
    bulk_temperature::settle(loaded, model, mesh, losses, seeks_hotter)
}

/// Losses of a mesh. They equal the losses of a whole run to the last digit.
///
/// # Errors
/// When a position has no solution; the first one along the path is named.
pub(crate) fn losses_of(loaded: &LoadedCase, options: &Options<'_>) -> Result<Losses, Error> {
    let used = Provenance::new();
    let (sampled, contacts) = used.collect(|| sampled(loaded, &options.known))?;
    let warmed = warmed(&sampled, &contacts, options.seeks_hotter)?;
    losses_of_stages(&warmed, &contacts, options.progress, used)
}

fn losses_of_stages(
    case: &OperatingCase,
    contacts: &Contacts,
    progress: Progress<'_>,
    used: Provenance,
) -> Result<Losses, Error> {
    let stages = Stages::new(case, contacts, progress, used)?;
    let positions = stages.lubricated()?;
    let mut losses = stages.summed(|| stages.solved(positions)?.losses())?;
    losses.run_in = stages.run_in()?;
    losses.equations = equations_used(&stages.tags());
    Ok(losses)
}

/// The outcome of a run of a mesh with the case and the contacts that it has in the end.
pub(crate) fn outcome(
    loaded: &LoadedCase,
    options: &Options<'_>,
    progress: Progress<'_>,
) -> Result<(MeshOutcome, OperatingCase, Contacts), Error> {
    let used = Provenance::new();
    let kept = &options.kept;
    let (sampled, contacts) = used.collect(|| sampled(loaded, &options.known))?;
    let warmed = warmed(&sampled, &contacts, options.seeks_hotter)?;
    let stages = Stages::new(&warmed, &contacts, progress, used)?;
    let mut positions = stages.lubricated()?;
    stages.press(&mut positions)?;
    let has_points = *kept != Kept::Nothing;
    let pictures = match kept {
        Kept::NoPictures => Vec::new(),
        kept => stages.pictures(&positions, kept)?,
    };
    for (position, picture) in positions.iter_mut().zip(&pictures) {
        let doubts = picture.iter().flat_map(|picture| &picture.doubts);
        position.doubts.extend(doubts.cloned());
    }
    let mut outcome = stages.summed(|| {
        let points = if has_points {
            stages.points()?
        } else {
            Vec::new()
        };
        stages.solved(positions)?.outcome(pictures, &points)
    })?;
    let result = &mut outcome.result;
    result.run_in = stages.run_in()?;
    let tags = stages.tags();
    (result.equations, result.references) = (equations_used(&tags), sources_used(&tags));
    drop(stages);
    Ok((outcome, warmed, contacts.into_owned()))
}

/// The flanks as measured of the case by the model, with β_i as it is: reference solutions have no spots.
pub(crate) fn by_solved_contacts(case: &OperatingCase) -> Result<OperatingCase, Error> {
    case.overridden(|over| {
        over.alternative = Some(Alternative::LoadShare(LoadShareName::Solved));
        over.inner_boundary = Some(case.model.inner_boundary);
        over.as_measured = true;
    })
}

/// Sliding loss at the lay of the flanks over the loss with ridges across rolling, which reference solutions have.
///
/// ```text
/// k = S_fast(θ₀, lay)/S_fast(θ₀, lay 0)                                               [Record-lay]
/// ```
///
/// S_fast: sliding loss by the model \[W\]; θ₀: constants at their medians.
fn friction_of_lay(case: &OperatingCase) -> Result<f64, Error> {
    cite!("Record-lay");
    let case = by_solved_contacts(case)?;
    let lay = case.surfaces.lay(case.model.lay).map_err(Box::new)?;
    if lay == Lay::ACROSS {
        return Ok(1.0);
    }
    let contacts = contacts(&case, &[])?;
    let own = losses_at(&contacts, &case)?.summary.sliding_w;
    let across = case.overridden(|over| over.lay = Some([Lay::ACROSS; 2]))?;
    let across = losses_at(&contacts, &across)?.summary.sliding_w;
    Ok(if across > 0.0 { own / across } else { 1.0 })
}

/// A case on flanks that have run in.
pub(super) struct OnFlanks {
    pub summary: Summary,
    /// Share of the load on asperities at each mesh position.
    pub shares: Vec<f64>,
    /// Minimum film over composite Rq, mean over the positions.
    pub film_ratio: f64,
}

/// The losses of a case, whose bulk temperature is known, on other flanks in a mesh.
///
/// # Errors
/// As [`losses`].
pub(super) fn on_flanks(
    case: &OperatingCase,
    surfaces: &Surfaces,
    mesh: &Mesh,
) -> Result<OnFlanks, Error> {
    let worn = case.with_surfaces(surfaces.clone());
    let contacts = Cow::Owned(contacts_of(&worn, mesh, [].iter())?);
    let stages = Stages::on(&worn, mesh.clone(), contacts, &|_, _| {}, Provenance::new())?;
    let positions = stages.lubricated()?;
    let over = |position: &LubricatedPosition, of: fn(&LubricatedWindow) -> f64| {
        mean(position.offsets.iter().map(of))
    };
    let shares = positions
        .iter()
        .map(|position| over(position, |window| 1.0 - window.film_share));
    let shares = shares.collect();
    let ratios = positions
        .iter()
        .map(|position| over(position, |window| window.film_ratio));
    let film_ratio = mean(ratios);
    let summary = stages.summed(|| stages.solved(positions)?.summary())?;
    Ok(OnFlanks {
        summary,
        shares,
        film_ratio,
    })
}

/// The values of a run between its functions.
pub(super) struct Stages<'a> {
    case: &'a OperatingCase,
    laws: ChosenLaws,
    pub mesh: Mesh,
    pub contacts: Cow<'a, Contacts>,
    records: Option<PathRecords>,
    /// Steps done before the positions, the records.
    record_count: usize,
    progress: Progress<'a>,
    /// Equations that were used.
    used: Provenance,
}

impl<'a> Stages<'a> {
    pub fn new(
        case: &'a OperatingCase,
        contacts: &'a Contacts,
        progress: Progress<'a>,
        used: Provenance,
    ) -> Result<Self, Error> {
        let mesh = used
            .collect(|| placed_mesh(case, Some(contacts)))
            .map_err(Box::new)?;
        Self::on(case, mesh, Cow::Borrowed(contacts), progress, used)
    }

    /// The stages on flanks whose contacts are known, with their records.
    fn on(
        case: &'a OperatingCase,
        mesh: Mesh,
        contacts: Cow<'a, Contacts>,
        progress: Progress<'a>,
        used: Provenance,
    ) -> Result<Self, Error> {
        let laws = ChosenLaws::from_case(case);
        let later = RunInSteps::from_case(case);
        let shown = |done, total| progress(done, total + later.after(total));
        let records = || records_of(case, &laws, &mesh.positions, &shown);
        let (mut records, record_count) = used.collect(records).map_err(Box::new)?;
        if let (ShareLaw::Reference, Some(records)) = (&laws.load_share, &mut records) {
            records.of_lay = used.collect(|| friction_of_lay(case))?;
        }
        Ok(Self {
            case,
            laws,
            mesh,
            contacts,
            records,
            record_count,
            progress,
            used,
        })
    }

    /// `work` of each position in parallel, with its equations noted.
    fn each<I: Items, T: Send>(
        &self,
        positions: I,
        work: impl Fn(I::Item) -> Result<T, PositionError> + Sync + Send,
    ) -> Result<Vec<T>, Error> {
        numbered(self.used.collect(|| par_map(positions, work)))
    }

    pub fn lubrication(&self) -> LubricatedMesh<'_> {
        LubricatedMesh {
            case: self.case,
            laws: &self.laws,
            surfaces: &self.case.surfaces,
            records: self.records.as_ref(),
        }
    }

    /// Film, load share and friction of every position, in parallel.
    pub fn lubricated(&self) -> Result<Vec<LubricatedPosition>, Error> {
        let lubrication = self.lubrication();
        let case = self.case;
        let done = AtomicUsize::new(self.record_count);
        let count = self.record_count + self.mesh.positions.len();
        let later = RunInSteps::from_case(case).after(count);
        let solve = |at: &MeshPosition| {
            let contacts = self.contacts.at(at)?;
            let position = lubrication.position(at, contacts)?;
            (self.progress)(1 + done.fetch_add(1, Ordering::Relaxed), count + later);
            Ok(position)
        };
        self.each(&self.mesh.positions, solve)
    }

    /// The rough contact of every window whose load share did not solve it.
    fn press(&self, positions: &mut [LubricatedPosition]) -> Result<(), Error> {
        let lubrication = self.lubrication();
        let press = |position: &mut LubricatedPosition| {
            let contacts = self.contacts.at(&position.at)?;
            lubrication.press(position, contacts)
        };
        self.each(positions, press).map(|_| ())
    }

    /// The contact of every position at its first offset; fields are held for the positions `kept`.
    fn pictures(
        &self,
        positions: &[LubricatedPosition],
        kept: &Kept,
    ) -> Result<Vec<Option<Picture>>, Error> {
        let lubrication = self.lubrication();
        let is_resolved = |position: &LubricatedPosition| {
            let contacts = self.contacts.at(&position.at);
            contacts.is_ok_and(|row| row.first().is_some_and(|first| first.window.is_some()))
        };
        let held = kept.held(positions, is_resolved);
        let picture = |(position, held): (&LubricatedPosition, bool)| {
            let contacts = self.contacts.at(&position.at)?;
            Picture::new(&lubrication, position, contacts, held)
        };
        self.each((positions, held), picture)
    }

    /// The points A to E of the path, solved as the positions are, without pictures. Left out are points whose contact
    /// the traces do not resolve, as another law would give the load share there, and points whose window is
    /// longer than the traces.
    fn points(&self) -> Result<Vec<(&'static str, LubricatedPosition)>, PositionError> {
        let case = self.case;
        if case.formulation.positions() == Positions::Single {
            return Ok(Vec::new());
        }
        let lubrication = self.lubrication();
        let named: Vec<(&'static str, MeshPosition)> = self
            .mesh
            .named_points(case)?
            .into_iter()
            .filter(|(_, at)| !is_substituted(&case.surfaces, at))
            .collect();
        let solve = |(name, at): &(&'static str, MeshPosition)| {
            check_mesh_position(at)?;
            let (windows, each) = (&self.contacts.inputs().windows, self.contacts.offsets());
            let contacts = match WindowContact::of_position(windows, each, at) {
                // Its window is wider than those of the positions, which have theirs.
                Err(PositionError::TraceTooShort { .. }) => return Ok(None),
                contacts => contacts?,
            };
            let mut position = lubrication.position(at, &contacts)?;
            lubrication.press(&mut position, &contacts)?;
            Ok(Some((*name, position)))
        };
        let points: Vec<Result<Option<_>, PositionError>> =
            self.used.collect(|| par_map(&named, solve));
        points.into_iter().filter_map(Result::transpose).collect()
    }

    /// The positions with their sums over the path.
    pub fn solved(&self, positions: Vec<LubricatedPosition>) -> Result<Solved<'_>, PositionError> {
        Solved::new(self.case, &self.mesh.load, positions, self.records.as_ref())
    }

    /// The result of `sums` with its equations noted.
    pub fn summed<T>(&self, sums: impl FnOnce() -> Result<T, PositionError>) -> Result<T, Error> {
        Ok(self.used.collect(sums).map_err(Box::new)?)
    }

    /// Tags of the equations that preparation and run used.
    fn tags(&self) -> BTreeSet<&'static str> {
        let mut tags = self.case.provenance.tags();
        tags.extend(self.used.tags());
        tags
    }

    /// The flanks of the case run in and what the mesh then loses, if the case requests it.
    fn run_in(&self) -> Result<Option<RunInFlanks>, Error> {
        let case = self.case;
        let Some(plan) = &case.running_in else {
            return Ok(None);
        };
        let measured = self.record_count + self.mesh.positions.len();
        let before = measured + running_in::MAX_STEPS;
        let total = before + measured;
        let cycle = |number| (self.progress)(measured + number, total);
        let flanks = || running_in::run_in(case, &case.surfaces, plan, &cycle);
        let ran_in = self.summed(flanks)?;
        let worn = case.overridden(|over| over.offsets = Some(self.contacts.offsets()))?;
        let worn = worn.with_surfaces(ran_in.surfaces.clone());
        let shown = |done, _| (self.progress)(before + done, total);
        let mesh = self.mesh.clone();
        let contacts = Cow::Owned(self.used.collect(|| contacts_of(&worn, &mesh, [].iter()))?);
        let stages = Stages::on(&worn, mesh, contacts, &shown, Provenance::new())?;
        let positions = stages.lubricated()?;
        let report = stages.summed(|| stages.solved(positions)?.run_in_flanks(ran_in))?;
        self.used.include(&stages.used);
        Ok(Some(report))
    }
}

/// Steps that running-in adds to the progress of a run.
struct RunInSteps(bool);

impl RunInSteps {
    fn from_case(case: &Case) -> Self {
        Self(case.running_in.is_some())
    }

    /// Steps after `measured`, the steps of the flanks as measured: the cycles, and the flanks run in.
    fn after(&self, measured: usize) -> usize {
        if self.0 {
            running_in::MAX_STEPS + measured
        } else {
            0
        }
    }
}

#[cfg(test)]
mod tests {
    use asperity_core::Code;
    use std::sync::Arc;

    use asperity_core::Checked;
    use asperity_core::quantity::Length;
    use asperity_ehl_regime::{FilmConditions, FilmThickness, FilmThicknessLaw, RegimeError};

    use super::check;
    use crate::pipeline::losses;
    use crate::pipeline::survey;
    use asperity_case::case::load_with;

    /// A film without thickness.
    #[derive(Debug)]
    struct NoFilm;

    impl FilmThicknessLaw for NoFilm {
        fn name(&self) -> &str {
            "no film"
        }

        fn film(&self, _: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
            let [central, minimum] = [1e-7, 0.0].map(Length::from_si);
            Ok(Checked::inside(FilmThickness { central, minimum }))
        }

        fn speed_exponent(&self) -> f64 {
            0.7
        }
    }

    #[test]
    fn a_film_that_cannot_be_is_refused_by_check_survey_and_run_alike() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let case = load_with(file, &|input| input.model.positions = Some(4)).unwrap();
        check(&case).unwrap();
        let case = case.with_laws(|laws| laws.film = Some(Arc::new(NoFilm)));
        assert_eq!(losses(&case).unwrap_err().code(), Code::E308);
        assert_eq!(check(&case).unwrap_err().code(), Code::E308);
        assert_eq!(survey(&case).unwrap_err().code(), Code::E308);
    }
}
