//! A case with its traces: from a file, from a text with a resolver, from a value, or changed from another.

use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::derived::Derived;
use asperity_core::provenance::Provenance;
use asperity_core::quantity::Temperature;
use asperity_core::{Code, Profile};
use asperity_tribo_friction::XuCalibration;

use super::flank_inputs::FlankInputs;
use super::flanks::{Flanks, flanks};
use crate::error::{Error, PositionError};
use crate::fingerprint::Fingerprint;
use crate::input::case_input::CaseInput;
use crate::input::files::{
    Content, FileContents, FileSums, Files, HeldTrace, Reader, XU_COEFFICIENTS,
};
use crate::input::gearbox_input::GearboxInput;
use crate::input::law_names::{FullFilmName, LoadShareName};
use crate::laws::Laws;
use crate::resolved::gearbox::{Gearbox, MeshPlace};
use crate::resolved::oil_at::OilAtTemperature;
use crate::resolved::oil_file::OilFile;
use crate::resolved::overrides::Overrides;
use crate::resolved::plausibility::{
    SYMBOLS, at_pitch_point, divided_shifts, little_clearance, step_up, unusual, unusual_oil,
};
use crate::resolved::read_oil_file::oil_file;
use crate::resolved::resolve::{Case, Completed, OfFiles, OfFlanks, resolve_with};
use crate::resolved::shafting::Shafting;
use crate::resolved::solved_teeth::{LoadCheck, SolvedTeeth};
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::{MeshKeys, Source};
use asperity_core::message::{Subject, Warning};
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_flanks::flank_lay::FlankLay;
use asperity_flanks::surfaces::{FlankReport, Surfaces};
use asperity_flanks::trace_pairs::SampledFlanks;
use asperity_mixed_film::{InletSupply, LoadShareSettings};
use asperity_oil::{LubricantInput, LubricantState, library_oil};

/// A case with its traces, ready to run, and read only: [`with`](Self::with) changes its keys, [`overridden`](Self::overridden) what a
/// draw or a study varies in addition, and [`at`](Self::at) gives it the temperature of its flanks.
#[derive(Debug, Clone)]
pub struct LoadedCase {
    loaded: Loaded,
    /// The case without overrides.
    stated: Arc<Case>,
    /// The oil at the temperature that the case states.
    oil: Arc<OilAtTemperature>,
    /// Values that follow from keys and files, each with its inputs.
    derived: Arc<DerivedValues>,
    /// Name of the case, for messages about what is changed.
    name: Arc<str>,
    /// The mesh that this is the case of, in a gear train.
    mesh: Option<Arc<MeshKeys>>,
    files: Arc<Files>,
}

impl Deref for LoadedCase {
    type Target = Loaded;

    fn deref(&self) -> &Loaded {
        &self.loaded
    }
}

impl Deref for Loaded {
    type Target = Case;

    fn deref(&self) -> &Case {
        &self.case
    }
}

/// Whether the steps between the points of both traces are in proportion.
fn is_in_proportion(own: &Profile, other: &Profile) -> bool {
    /// Rounding of the heights in files.
    const ROUNDING: f64 = 1e-3;
    let steps = |of: &Profile| -> Vec<f64> {
        let heights = of.heights().windows(2);
        heights.map(|pair| pair[1] - pair[0]).collect()
    };
    if own.heights().len() != other.heights().len() {
        return false;
    }
    let (own, other) = (steps(own), steps(other));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let product = dot(&own, &other);
    product > 0.0 && product * product > (1.0 - ROUNDING) * dot(&own, &own) * dot(&other, &other)
}

/// The values of a [`LoadedCase`].
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Loaded {
    /// The case.
    pub case: Case,
    /// The flanks.
    pub surfaces: Surfaces,
    /// Reading and preparation of each flank, of the first trace if it has several.
    pub flanks: Arc<[FlankReport; 2]>,
    /// All traces if a flank has several; `None` if each has one.
    pub sampled: Option<Arc<SampledFlanks>>,
    /// Warnings about the files.
    pub warnings: Vec<Warning>,
    /// Equations that the preparation of oil, gears and traces used.
    pub provenance: Provenance,
}

/// Values that follow from the keys of a case and from its files: each is made by a function of its inputs alone, and a changed
/// case with equal inputs has the same. Flanks and gearbox of a case that a program changed itself stay changed.
#[derive(Debug, Clone)]
struct DerivedValues {
    flanks: Derived<FlankInputs, Flanks>,
    gearbox: Derived<Option<GearboxInput>, Read<Option<Gearbox>>>,
    xu: Derived<Option<PathBuf>, Read<Option<XuCalibration>>>,
    oil: Derived<Option<PathBuf>, Read<Option<Arc<OilFile>>>>,
    teeth: SolvedTeeth,
    /// The check of the load with the form that was measured; `None` if no form was.
    formed: Derived<Option<LoadCheck>, ()>,
}

/// A value, and the sums of the files that it was read from.
type Read<T> = (T, Arc<FileSums>);

impl DerivedValues {
    /// Sums of all files.
    fn sums(&self) -> [&Arc<FileSums>; 4] {
        [
            &self.flanks.value().sums,
            &self.gearbox.value().1,
            &self.xu.value().1,
            &self.oil.value().1,
        ]
    }
}

/// Values of a case for the cases that are changed from it.
#[derive(Debug)]
pub(crate) struct KeptParts {
    laws: Laws,
    overrides: Overrides,
    values: DerivedValues,
}

impl LoadedCase {
    /// Reading and preparation of every trace, of the pinion first.
    pub fn all_traces(&self) -> Vec<&FlankReport> {
        match &self.sampled {
            Some(sampled) => sampled.reports().collect(),
            None => self.flanks.iter().collect(),
        }
    }

    /// Whether the flanks of both are the same teeth: each trace as it was measured is that of the other, whatever is filtered from it,
    /// or in proportion to it. Flanks of roughness values are the same if neither has a trace.
    pub fn has_teeth_of(&self, other: &Self) -> bool {
        let (own, theirs) = (self.all_traces(), other.all_traces());
        let of_pair = |(own, theirs): (&&FlankReport, &&FlankReport)| {
            own.mirrored == theirs.mirrored
                && match (&own.trace, &theirs.trace) {
                    (Some(own), Some(theirs)) => is_in_proportion(own, theirs),
                    (None, None) => true,
                    _ => false,
                }
        };
        self.surfaces.has_flanks_of(&other.surfaces)
            || own.len() == theirs.len() && own.iter().zip(&theirs).all(of_pair)
    }

    /// Distributions of the lay of both flanks.
    pub fn flank_lays(&self) -> [FlankLay; 2] {
        self.derived.flanks.value().lays.of_flanks
    }

    /// Lay of both flanks together, if the load share depends on it and exceeds the lay of every reference solution.
    ///
    /// # Errors
    /// When the law of two lays refuses the roughness of the flanks.
    pub fn lay_beyond_records(&self) -> Result<Option<Lay>, PositionError> {
        let law = self.case.share_law();
        let has_rough_inlet = |contact: &LoadShareSettings| contact.supply != InletSupply::Smooth;
        if !law.contact().is_some_and(has_rough_inlet) || !self.surfaces.are_measured() {
            return Ok(None);
        }
        let lay = self.surfaces.lay(self.case.model.lay)?;
        Ok((lay.gamma() > Lay::RECORDED.gamma()).then_some(lay))
    }

    /// Name of the case file without its folder.
    pub fn file_name(&self) -> Option<String> {
        let name = Path::new(&*self.name).file_name()?;
        Some(name.to_string_lossy().into_owned())
    }

    /// Every file that was read for this case, and its SHA-256.
    #[must_use]
    pub fn files_read(&self) -> FileSums {
        let of_all = self.derived.sums().into_iter().flat_map(|sums| sums.iter());
        of_all
            .map(|(name, sum)| (name.clone(), sum.clone()))
            .collect()
    }

    /// Content of every file that was read for this case, with which it can be read again without them.
    ///
    /// # Errors
    /// When a file on disk is no longer the one that the case was read from.
    pub fn contents(&self) -> Result<FileContents, Error> {
        Ok(self.files.contents(&self.files_read())?)
    }

    pub(crate) fn contents_of(&self, sums: &FileSums) -> Result<FileContents, CaseError> {
        self.files.contents(sums)
    }

    /// The case with `folder` as the folder of files that a change names; those in memory come before those on disk.
    #[must_use]
    pub fn in_folder(self, folder: &Path) -> Self {
        let held = self.files.held.clone();
        Self {
            files: Files::holding(Some(folder), held).into(),
            ..self
        }
    }

    /// Folder that names of files are relative to; `None` if all files are in memory.
    pub fn folder(&self) -> Option<&Path> {
        self.files.folder()
    }

    /// Name of the case in messages: the path of its file as the user gave it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Files that the case would read with any of `inputs`, and their SHA-256; unreadable files are left out.
    #[must_use]
    pub fn files_of(&self, inputs: &[CaseInput]) -> FileSums {
        self.files.sums_of(inputs)
    }

    /// SHA-256 of the files with these names; unreadable files are left out.
    pub(crate) fn sums_of_files<'a>(&self, names: impl Iterator<Item = &'a Path>) -> FileSums {
        self.files.sums_of_names(names.map(Path::to_owned))
    }

    /// SHA-256 of everything that determines the result: every key of the case, every override, every byte of the files read for it,
    /// the version of the program, and every user-defined law by its `Debug` text, which must therefore show everything that
    /// the law depends on. It does not include flanks that a program changed, nor the code of a law.
    ///
    /// ```
    /// use asperity_case::case;
    /// let case = case::load("../../fixtures/cases/e-drive.toml".as_ref(), None)?;
    /// let hotter = case.with_key("operation.bulk_temperature", "91 °C")?;
    /// assert_ne!(case.fingerprint(), hotter.fingerprint());
    /// assert_eq!(case.fingerprint(), hotter.with_key("operation.bulk_temperature", "90 °C")?.fingerprint());
    /// # Ok::<(), asperity_case::error::Error>(())
    /// ```
    #[must_use]
    pub fn fingerprint(&self) -> String {
        // Debug prints every digit of a number.
        let mut input = format!("{:?}", self.case.input);
        let laws = &self.case.laws;
        if laws.is_any() {
            input += &format!("{laws:?}");
        }
        let overrides = &self.case.overrides;
        if !overrides.are_none() {
            input += &format!("{overrides:?}");
        }
        let read = self.files_read().into_iter();
        let sums = read.fold(
            Fingerprint::default().with(input),
            |sum, (name, of_file)| sum.with(name.as_os_str().as_encoded_bytes()).with(of_file),
        );
        sums.hex()
    }

    /// The case with other keys, checked again; traces are read again only if the change affects them. Laws, overrides and flanks of a
    /// program stay.
    ///
    /// # Errors
    /// When the changed case cannot be run.
    pub fn with(&self, change: impl FnOnce(&mut CaseInput)) -> Result<Self, Error> {
        let mut input = self.case.input.clone();
        change(&mut input);
        Ok(self.changed_to(input, None)?)
    }

    /// The case with the values that `change` overrides.
    ///
    /// # Errors
    /// When a value is outside its domain.
    pub fn overridden(&self, change: impl FnOnce(&mut Overrides)) -> Result<Self, Error> {
        let mut overrides = self.case.overrides.clone();
        change(&mut overrides);
        let case = self.stated.overridden(overrides, self.flank_lays());
        let case = case.map_err(Box::new)?;
        Ok(self.having(|loaded| Loaded { case, ..loaded }))
    }

    /// The case with other user-defined laws.
    #[must_use]
    pub fn with_laws(&self, change: impl FnOnce(&mut Laws)) -> Self {
        let mut laws = self.case.laws.clone();
        change(&mut laws);
        self.remade(|case| case.with_laws(laws.clone()))
    }

    /// The case on other flanks.
    #[must_use]
    pub fn with_surfaces(&self, surfaces: Surfaces) -> Self {
        self.having(|loaded| Loaded { surfaces, ..loaded })
    }

    /// The case on its first pair of traces, where several teeth or surrogates are in contact.
    #[must_use]
    pub fn first_pair(&self) -> Self {
        self.having(|loaded| Loaded {
            surfaces: loaded.surfaces.first_pair(),
            sampled: None,
            ..loaded
        })
    }

    /// The case with a set of its own of the equations that made it, to which those `used` are added.
    pub(super) fn with_provenance(&self, used: &Provenance) -> Self {
        let provenance = Provenance::new();
        provenance.include(&self.provenance);
        provenance.include(used);
        self.having(|loaded| Loaded {
            provenance,
            ..loaded
        })
    }

    fn having(&self, change: impl FnOnce(Loaded) -> Loaded) -> Self {
        let mut other = self.clone();
        other.loaded = change(other.loaded);
        other
    }

    /// The case with another one as resolved, which has the same overrides.
    fn remade(&self, change: impl Fn(Case) -> Case) -> Self {
        let stated = Arc::new(change(Case::clone(&self.stated)));
        let case = change(self.case.clone());
        Self {
            stated,
            ..self.having(|loaded| Loaded { case, ..loaded })
        }
    }

    /// The oil at a temperature, without overrides.
    pub(super) fn oil_at(&self, at: Temperature) -> Result<Arc<OilAtTemperature>, Error> {
        if at == self.stated.stated_temperature {
            return Ok(Arc::clone(&self.oil));
        }
        Ok(Arc::new(self.stated.oil_at(at, &self.source())?))
    }

    /// The warnings of the case, those about its oil at another temperature.
    pub(super) fn warnings_at(&self, oil: &LubricantState, at: Temperature) -> Vec<Warning> {
        let case = &self.stated;
        if at == case.stated_temperature {
            return self.warnings.clone();
        }
        let stated = oil_warnings(case, &self.oil.state, case.stated_temperature);
        let others = self.warnings.iter().filter(|one| !stated.contains(one));
        others.cloned().chain(oil_warnings(case, oil, at)).collect()
    }

    /// The case, and every case that is changed from it, without the losses besides its mesh; its input still states them.
    #[must_use]
    pub fn without_gearbox(&self) -> Self {
        let mut values = DerivedValues::clone(&self.derived);
        values.gearbox = values.gearbox.with(|(_, sums)| (None, sums));
        Self {
            derived: values.into(),
            ..self.remade(Case::without_gearbox)
        }
    }

    /// The case with further traces in memory, under names that [`Self::with`] can state as files.
    #[must_use]
    pub fn holding<T: Clone + Into<HeldTrace>>(&self, traces: &[(PathBuf, T)]) -> Self {
        let mut files = Files::clone(&self.files);
        for (name, trace) in traces {
            files.hold(name, Content::Heights(Arc::new(trace.clone().into())));
        }
        Self {
            files: files.into(),
            ..self.clone()
        }
    }

    /// Cache folder of reference solutions; `None` if the case disables it, has no files, or the user has no cache
    /// folder.
    pub fn record_folder(&self) -> Option<PathBuf> {
        let beside = self.files.folder()?;
        match self.case.model.ehl.cache.as_str() {
            "off" => None,
            "user" => user_cache_folder(),
            folder => Some(beside.join(folder)),
        }
    }

    /// The case with another input; in a gear train of the mesh with these keys, or else of the same mesh as before.
    pub(crate) fn changed_to(
        &self,
        mut input: CaseInput,
        mesh: Option<&Arc<MeshKeys>>,
    ) -> Result<Self, CaseError> {
        keep_oil(&self.case.input, &mut input);
        let source = match mesh.or(self.mesh.as_ref()) {
            Some(mesh) => self.source().of_mesh(mesh),
            None => self.source(),
        };
        complete(input, &source, Arc::clone(&self.files), Some(self.kept()))
    }

    /// The values that a changed case keeps where their inputs are equal, with the flanks as they are now.
    fn kept(&self) -> KeptParts {
        let mut values = DerivedValues::clone(&self.derived);
        values.flanks = values.flanks.with(|flanks| Flanks {
            surfaces: self.surfaces.clone(),
            reports: Arc::clone(&self.flanks),
            sampled: self.sampled.clone(),
            ..flanks
        });
        KeptParts {
            laws: self.case.laws.clone(),
            overrides: self.case.overrides.clone(),
            values,
        }
    }

    /// Source of changes of the whole text: its lines hold the earlier values.
    pub(crate) fn source(&self) -> Source {
        Source::without_text(&self.name)
    }

    /// Reader of the files of the case.
    pub(crate) fn reader(&self) -> Reader<'_> {
        Reader::new(&self.files)
    }

    pub(crate) fn built(input: CaseInput, files: Files) -> Result<Self, Error> {
        Ok(complete(input, &Source::in_memory(), files.into(), None)?)
    }
}

/// A case as a value; files it names are relative to the working directory.
impl TryFrom<CaseInput> for LoadedCase {
    type Error = Error;

    fn try_from(input: CaseInput) -> Result<Self, Error> {
        Self::built(input, Files::in_folder(Path::new("")))
    }
}

/// States the temperature of a viscosity and a density that hold at the temperature of the case, if that is changed.
pub(crate) fn keep_oil(stated: &CaseInput, input: &mut CaseInput) {
    let Some(temperature) = stated.operation.stated_temperature() else {
        return;
    };
    let is_kept = input.operation.stated_temperature() == Some(temperature);
    if is_kept || input.lubricant != stated.lubricant {
        return;
    }
    // An oil that is not in the library is reported with its place when the case is completed.
    if let Ok(lubricant) = stated.lubricant.stated_at(temperature) {
        input.lubricant = lubricant;
    }
}

/// Completes the case and reads its files; values of the case that it was changed from are taken where their inputs are equal.
pub(crate) fn complete(
    input: CaseInput,
    source: &Source,
    files: Arc<Files>,
    kept: Option<KeptParts>,
) -> Result<LoadedCase, CaseError> {
    let provenance = Provenance::new();
    let known = kept.as_ref().map(|kept| &kept.values);
    let oil = Derived::renewed(
        known.map(|known| &known.oil),
        input.lubricant.oil_file.clone(),
        |file| oil_file(file.as_deref(), source, &files),
    )?;
    let Completed {
        case,
        teeth,
        oil: state,
    } = provenance.collect(|| {
        let file = oil.value().0.clone();
        resolve_with(input, file, source, known.map(|known| &known.teeth))
    })?;
    let xu = Derived::renewed(
        known.map(|known| &known.xu),
        xu_coefficients(&case.input),
        |file| xu_calibration(file.as_deref(), source, &files),
    )?;
    let gearbox = Derived::renewed(
        known.map(|known| &known.gearbox),
        case.input.gearbox.clone(),
        |stated| gearbox_of_one_mesh(stated.as_ref(), source, &files),
    )?;
    let case = case.with_files(OfFiles {
        xu: xu.value().0.as_ref(),
        gearbox: gearbox.value().0.clone(),
        laws: kept.as_ref().map(|kept| kept.laws.clone()),
    });
    let flanks = Derived::renewed(
        known.map(|known| &known.flanks),
        provenance.collect(|| FlankInputs::from_case(&case)),
        |inputs| flanks(inputs, source, &files),
    )?;
    let of_flanks = flanks.value();
    let case = case.with_flanks(OfFlanks {
        assumed: &of_flanks.assumed,
        lay: of_flanks.lays.in_place_of_default(),
        zones: &of_flanks.zones,
        forms: &of_flanks.forms,
    });
    let formed = known.map(|known| &known.formed);
    let formed = check_flanks(of_flanks, &case, formed, source)?;
    let warnings = warnings_of(&case, &state.state, of_flanks, source);
    provenance.include(&of_flanks.provenance);
    let loaded = Loaded {
        surfaces: of_flanks.surfaces.clone(),
        flanks: Arc::clone(&of_flanks.reports),
        sampled: of_flanks.sampled.clone(),
        case: case.clone(),
        warnings,
        provenance,
    };
    let overrides = kept.map(|kept| kept.overrides).unwrap_or_default();
    let plain = LoadedCase {
        loaded,
        stated: Arc::new(case),
        oil: Arc::new(state),
        derived: Arc::new(DerivedValues {
            flanks,
            gearbox,
            xu,
            oil,
            teeth,
            formed,
        }),
        name: source.name().into(),
        mesh: source.mesh().cloned(),
        files,
    };
    if overrides.are_none() {
        return Ok(plain);
    }
    let refused = |error: Error| Section::new(source, "model").value("lay", error.to_string());
    plain.overridden(|over| *over = overrides).map_err(refused)
}

/// Refuses what flanks do not admit, and checks the load with their measured form, if they have one.
fn check_flanks(
    flanks: &Flanks,
    case: &Case,
    known: Option<&Derived<Option<LoadCheck>, ()>>,
    source: &Source,
) -> Result<Derived<Option<LoadCheck>, ()>, CaseError> {
    let surfaces = &flanks.surfaces;
    if case.running_in.is_some() && (!surfaces.are_measured() || surfaces.is_surrogate()) {
        let section = Section::new(source, "operation");
        return Err(section.conflict(
            "running_in",
            "needs the traces of both flanks, files of surface.pinion and surface.wheel",
        ));
    }
    let check = (flanks.forms != [None, None]).then(|| case.load_check());
    let formed = Derived::renewed(known, check, |check| match check {
        Some(check) => check.solve(source),
        None => Ok(()),
    })?;
    if surfaces.teeth().is_some() || surfaces.is_surrogate() {
        refuse_several(case, source)?;
    }
    Ok(formed)
}

/// Doubts about the keys of a case and its files.
fn warnings_of(
    case: &Case,
    oil: &LubricantState,
    flanks: &Flanks,
    source: &Source,
) -> Vec<Warning> {
    let (input, gears) = (&case.input, &case.gears);
    let loads = at_pitch_point(gears, case.modulus, case.torque, case.speed);
    let running_in = case.running_in.filter(|plan| plan.torque != case.torque);
    let of_plan = running_in
        .map(|plan| plan.load(&input.operation, (gears, case.modulus), case.flow_pressure));
    let loads = loads.into_iter().chain(of_plan);
    let mut warnings = unusual(input, source, loads);
    warnings.extend(oil_warnings(case, oil, case.stated_temperature));
    warnings.extend(step_up(gears, source));
    warnings.extend(flanks.warnings.iter().cloned());
    warnings.extend(divided_shifts(&input.gears, gears, source));
    warnings.extend(little_clearance(&input.gears, gears, source));
    warnings.extend(read_as_keys(source));
    let gearbox = case.gearbox.iter();
    warnings.extend(gearbox.flat_map(|gearbox| gearbox.warnings.iter().cloned()));
    warnings.extend(replaced_oil(&input.lubricant));
    warnings.extend(replaced_properties(&input.lubricant));
    warnings.extend(simulated(input, case.oil_file.as_deref()));
    warnings
}

/// Doubts about the oil at a temperature.
fn oil_warnings(case: &Case, oil: &LubricantState, at: Temperature) -> Vec<Warning> {
    let thin_or_stiff = unusual_oil(&case.input, oil).into_iter();
    let file = case.oil_file.iter();
    let of_file = file.flat_map(|file| file.warnings(&case.input, at));
    thin_or_stiff.chain(of_file).collect()
}

/// Refuses models of one pair of traces if there are several.
fn refuse_several(case: &Case, source: &Source) -> Result<(), CaseError> {
    let model = &case.model;
    let of_one_pair = [
        ("load_share", model.load_share == LoadShareName::Ehl),
        ("full_film", model.full_film == FullFilmName::EhlTransient),
    ];
    match of_one_pair.into_iter().find(|(_, is_chosen)| *is_chosen) {
        None => Ok(()),
        Some((key, _)) => {
            let rule =
                "is of one pair of traces: name one trace of each flank, as surface.pinion.file";
            Err(Section::new(source, "model").conflict(key, rule))
        }
    }
}

/// The cache folder of the user by the rules of the system.
fn user_cache_folder() -> Option<PathBuf> {
    let named = |name: &str| {
        let folder = PathBuf::from(std::env::var_os(name)?);
        folder.is_absolute().then_some(folder)
    };
    let root = named("XDG_CACHE_HOME")
        .or_else(|| named("LOCALAPPDATA"))
        .or_else(|| Some(named("HOME")?.join(".cache")))?;
    Some(root.join("asperity"))
}

/// The coefficients in `file`.
/// The file with coefficients of Xu's law.
fn xu_coefficients(input: &CaseInput) -> Option<PathBuf> {
    let friction = input.model.film_friction.as_ref()?;
    friction.xu_coefficients().map(Path::to_owned)
}

fn xu_calibration(
    file: Option<&Path>,
    source: &Source,
    files: &Files,
) -> Result<Read<Option<XuCalibration>>, CaseError> {
    let Some(file) = file else {
        return Ok((None, Arc::default()));
    };
    let reader = Reader::new(files);
    let refused = |message: String| Section::new(source, XU_COEFFICIENTS).value("", message);
    let Content::Bytes(bytes) = reader.open(file, source, XU_COEFFICIENTS)?.0 else {
        return Err(refused("names a trace, not coefficients".to_owned()));
    };
    let text = std::str::from_utf8(&bytes)
        .map_err(|error| refused(format!("is not text in UTF-8: {error}")))?;
    let calibration = XuCalibration::from_json(text);
    let calibration = calibration.map_err(|error| refused(error.to_string()))?;
    Ok((Some(calibration), reader.into_sums().into()))
}

/// The parts of the gearbox of a pair of gears.
fn gearbox_of_one_mesh(
    stated: Option<&GearboxInput>,
    source: &Source,
    files: &Files,
) -> Result<Read<Option<Gearbox>>, CaseError> {
    let Some(stated) = stated else {
        return Ok((None, Arc::default()));
    };
    let reader = Reader::new(files);
    let places = vec![MeshPlace::default()];
    let parts = stated.gearbox(places, &Shafting::shafts_of_one_mesh(), source, &reader)?;
    Ok((Some(parts), reader.into_sums().into()))
}

/// Names the keys that symbols in the case file are read as.
fn read_as_keys(source: &Source) -> Option<Warning> {
    let pairs: Vec<String> = (source.symbols())
        .map(|[symbol, key]| format!("{symbol} is {key}"))
        .collect();
    (!pairs.is_empty()).then(|| Warning::new(SYMBOLS, pairs.join(", ")))
}

/// W442 if an oil named over the case replaces what the case states of its oil.
fn replaced_oil(own: &LubricantInput) -> Option<Warning> {
    let file = own.oil_file.as_ref().map(|file| file.display().to_string());
    let name = own.oil.clone().or(file)?;
    let text = format!("{name} replaces {} of the case", own.replaced.join(", "));
    (!own.replaced.is_empty()).then(|| Warning {
        about: Some(Subject::Oil),
        ..Warning::new(Code::W442, text)
    })
}

/// W442 if the case names an oil of the library and states other properties than those of the oil.
fn replaced_properties(own: &LubricantInput) -> Option<Warning> {
    let name = own.oil.as_ref()?;
    let oil = library_oil(name).ok()?;
    let keys = own.stated_otherwise(&oil.lubricant);
    let keys: Vec<String> = keys.map(|key| format!("lubricant.{key}")).collect();
    let replaces = match keys.len() {
        0 => return None,
        1 => "replaces that",
        _ => "replace those",
    };
    let text = format!(
        "{} of the case {replaces} of the oil {name}, of which only what the case leaves out is used",
        keys.join(", ")
    );
    Some(Warning::new(Code::W442, text))
}

/// W446: constants of the case that were fitted to simulated measurements.
fn simulated(input: &CaseInput, oil_file: Option<&OilFile>) -> Vec<Warning> {
    let of_oil = oil_file.map(|file| {
        let fit = &file.film_friction;
        ("lubricant.oil_file", fit.simulated, fit.source.as_str())
    });
    let of_rig = input.calibration.as_ref().map(|fit| {
        let source = fit.source.as_deref().unwrap_or("source not stated");
        ("calibration", fit.simulated.unwrap_or(false), source)
    });
    let fits = of_oil.into_iter().chain(of_rig);
    let simulated = fits.filter(|(_, simulated, _)| *simulated);
    let warning = |(key, _, source)| {
        let text = format!("{key}: constants were fitted to simulated measurements: {source}");
        Warning::new(Code::W446, text)
    };
    simulated.map(warning).collect()
}
