//! A case with its traces: from a file, from a text with a resolver, from a value, or changed from another.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use asperity_core::provenance::Provenance;
use asperity_core::{Code, Profile};
use asperity_gear::LoadConditions;
use asperity_tribo_friction::XuCalibration;

use super::calibration::SIMULATED;
use super::defaults::DefaultUsed;
use super::error::CaseError;
use super::files::{Content, FileContents, FileSums, Files, Reader, XU_COEFFICIENTS};
use super::flank_form::shortest_form;
use super::flank_pairs::spacing_of;
use super::flanks::{Flanks, flanks};
use super::gearbox::MeshPlace;
use super::gears::check_load;
use super::input::CaseInput;
use super::law_names::{FullFilmName, LoadShareName};
use super::lay::Lays;
use super::oil_file::OilFile;
use super::plausibility::{
    SYMBOLS, at_pitch_point, divided_shifts, little_clearance, step_up, unusual,
};
use super::resolve::{Case, resolve_checked};
use super::section::Section;
use super::shafting::Shafting;
use super::source::{MeshKeys, Source};
use super::surrogates::solves_contact;
use super::text::oil_file;
use crate::error::{Error, PositionError};
use crate::fingerprint::Fingerprint;
use crate::flanks::flank_lay::FlankLay;
use crate::flanks::surfaces::{FlankReport, Surfaces};
use crate::flanks::trace_pairs::SampledFlanks;
use asperity_core::message::Warning;
use asperity_ehl_regime::inlet_flow::Lay;
use asperity_mixed_film::InletSupply;
use asperity_oil::LubricantInput;

/// A case with its traces, ready to run.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LoadedCase {
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
    /// Equations that the preparation of the traces used, reused if a change of the case does not affect the traces.
    of_flanks: Provenance,
    /// Doubts about the flanks alone.
    flank_warnings: Vec<Warning>,
    /// Lay of each flank.
    lays: Arc<Lays>,
    /// Values that follow from the flanks and their files.
    assumed: Vec<DefaultUsed>,
    /// Name of the case, for messages about what is changed.
    name: Arc<str>,
    /// The mesh that this is the case of, in a gear train.
    mesh: Option<Arc<MeshKeys>>,
    files: Arc<Files>,
    /// Sums of the files that flanks, gearbox, model and oil were read from.
    sums: [Arc<FileSums>; 4],
}

impl LoadedCase {
    /// Reading and preparation of every trace, of the pinion first.
    pub fn all_traces(&self) -> Vec<&FlankReport> {
        match &self.sampled {
            Some(sampled) => sampled.reports().collect(),
            None => self.flanks.iter().collect(),
        }
    }

    /// Distributions of the lay of both flanks.
    pub fn flank_lays(&self) -> [FlankLay; 2] {
        self.lays.of_flanks
    }

    /// Lay of both flanks together, if the load share depends on it and exceeds the lay of every record of mixed lubrication.
    ///
    /// # Errors
    /// When the law of two lays refuses the roughness of the flanks.
    pub fn lay_beyond_records(&self) -> Result<Option<Lay>, PositionError> {
        let supply = self.case.load_share().supply();
        if supply != Some(InletSupply::Rough) || !self.surfaces.are_measured() {
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
        let of_all = self.sums.iter().flat_map(|sums| sums.iter());
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

    pub(super) fn contents_of(&self, sums: &FileSums) -> Result<FileContents, CaseError> {
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
    pub(super) fn sums_of_files<'a>(&self, names: impl Iterator<Item = &'a Path>) -> FileSums {
        self.files.sums_of_names(names.map(Path::to_owned))
    }

    /// SHA-256 of everything that determines the result: every key of the case, every byte of the files read for it, the
    /// version of the program, and every user-defined law by its `Debug` text, which must therefore show everything that
    /// the law depends on. It does not include fields that were changed after the case was read, nor the code of a law.
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
        let read = self.files_read().into_iter();
        let sums = read.fold(
            Fingerprint::default().with(input),
            |sum, (name, of_file)| sum.with(name.as_os_str().as_encoded_bytes()).with(of_file),
        );
        sums.hex()
    }

    /// The case changed by `change`, checked again; traces are read again only if the change affects them.
    ///
    /// The change applies to [`Case::input`]; other changes of the public fields are lost.
    ///
    /// # Errors
    /// When the changed case cannot be run.
    pub fn with(&self, change: impl FnOnce(&mut CaseInput)) -> Result<Self, Error> {
        let mut input = self.case.input.clone();
        change(&mut input);
        Ok(self.changed_to(input, None)?)
    }

    /// The case on its first pair of traces, where several teeth or surrogates are in contact.
    #[must_use]
    pub fn first_pair(&self) -> Self {
        Self {
            surfaces: self.surfaces.first_pair(),
            sampled: None,
            ..self.clone()
        }
    }

    /// The case with further traces in memory, under names that [`Self::with`] can state as files.
    #[must_use]
    pub fn holding(&self, traces: &[(PathBuf, Profile)]) -> Self {
        let mut files = Files::clone(&self.files);
        for (name, trace) in traces {
            files.hold(name, Content::Heights(Arc::new(trace.clone())));
        }
        Self {
            files: files.into(),
            ..self.clone()
        }
    }

    /// Cache folder of records of mixed lubrication; `None` if the case disables it, has no files, or the user has no cache
    /// folder.
    pub fn record_folder(&self) -> Option<PathBuf> {
        let beside = self.files.folder()?;
        match self.case.model.ehl.cache.as_str() {
            "off" => None,
            "user" => user_cache_folder(),
            folder => Some(beside.join(folder)),
        }
    }

    /// Whether traces have a place on the flanks, along the profile or across the face.
    fn is_placed(&self) -> bool {
        let is_rolled = |flank: &FlankReport| {
            let reading = flank.reading.as_ref();
            let arc = reading.and_then(|reading| reading.metadata.arc_from_base);
            flank.roll_lengths.is_some() || arc.is_some()
        };
        !self.case.face_zones.is_empty() || self.all_traces().into_iter().any(is_rolled)
    }

    /// The case with another input; in a gear train of the mesh with these keys, or else of the same mesh as before.
    pub(super) fn changed_to(
        &self,
        mut input: CaseInput,
        mesh: Option<&Arc<MeshKeys>>,
    ) -> Result<Self, CaseError> {
        keep_oil(&self.case.input, &mut input);
        let source = match mesh.or(self.mesh.as_ref()) {
            Some(mesh) => self.source().of_mesh(mesh),
            None => self.source(),
        };
        complete(input, &source, Arc::clone(&self.files), Some(self))
    }

    /// Source of changes of the whole text: its lines hold the earlier values.
    pub(super) fn source(&self) -> Source {
        Source::without_text(&self.name)
    }

    /// Reader of the files of the case.
    pub(super) fn reader(&self) -> Reader<'_> {
        Reader::of(&self.files)
    }

    pub(super) fn built(input: CaseInput, files: Files) -> Result<Self, Error> {
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
pub(super) fn keep_oil(stated: &CaseInput, input: &mut CaseInput) {
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

/// Completes the case and reads its traces, or takes them from `before` if they are the same.
pub(super) fn complete(
    input: CaseInput,
    source: &Source,
    files: Arc<Files>,
    before: Option<&LoadedCase>,
) -> Result<LoadedCase, CaseError> {
    let provenance = Provenance::new();
    // The load over the teeth was checked if only speed and temperature differ.
    let alike = before.map(|before| &before.case);
    let alike = alike.filter(|before| loads_alike(&before.input, &input));
    let is_checked = alike.is_some();
    let (oil, oil_sums) = match before {
        Some(before) if before.case.input.lubricant.oil_file == input.lubricant.oil_file => {
            (before.case.oil_file.clone(), Arc::clone(&before.sums[3]))
        }
        _ => oil_file(&input, source, &files)?,
    };
    let mut case = provenance.collect(|| resolve_checked(input, oil, source, alike))?;
    let model_sums = match (before, &case.input.model.xu_coefficients) {
        (_, None) => Arc::default(),
        (Some(before), file) if before.case.input.model.xu_coefficients == *file => {
            let settings = &before.case.model.friction_settings;
            case.model.friction_settings.xu.coefficients = settings.xu.coefficients;
            Arc::clone(&before.sums[2])
        }
        (_, Some(file)) => {
            let reader = Reader::of(&files);
            let calibration = xu_calibration(file, source, &reader)?;
            case.model.friction_settings.xu.coefficients = calibration.coefficients;
            reader.into_sums().into()
        }
    };
    let gearbox_sums;
    (case.gearbox, gearbox_sums) = match (before, &case.input.gearbox) {
        (Some(before), stated) if before.case.input.gearbox == *stated => {
            (before.case.gearbox.clone(), Arc::clone(&before.sums[1]))
        }
        (_, Some(stated)) => {
            let reader = Reader::of(&files);
            let train = Shafting::of_pair(&case).shafts;
            let places = vec![MeshPlace::default()];
            let parts = stated.gearbox(places, &train, (source, &reader))?;
            (Some(parts), reader.into_sums().into())
        }
        (_, None) => (None, Arc::default()),
    };
    if let Some(before) = before {
        case.laws = before.case.laws.clone();
        case.list_laws();
    }
    let Flanks {
        surfaces,
        reports,
        sampled,
        forms,
        lays,
        zones,
        warnings,
        assumed,
        provenance: of_flanks,
        sums: flank_sums,
    } = match before {
        Some(before) if same_flanks(before, &case) => Flanks {
            surfaces: before.surfaces.clone(),
            reports: before.flanks.clone(),
            sampled: before.sampled.clone(),
            forms: before.case.micro_geometry.measured.clone(),
            lays: Arc::clone(&before.lays),
            zones: before.case.face_zones.clone(),
            warnings: before.flank_warnings.clone(),
            assumed: before.assumed.clone(),
            provenance: before.of_flanks.clone(),
            sums: Arc::clone(&before.sums[0]),
        },
        _ => flanks(&case, source, &files)?,
    };
    // Values that a file states replace the defaults.
    let is_default = |default: &DefaultUsed| assumed.iter().all(|stated| stated.key != default.key);
    case.defaults.retain(is_default);
    case.defaults.extend(assumed.iter().cloned());
    lays.enter(&mut case);
    if case.model.run_in && (!surfaces.are_measured() || surfaces.is_surrogate()) {
        let section = Section::of(source, "model");
        return Err(section.conflict("run_in", "needs the traces of both flanks"));
    }
    case.face_zones = zones;
    if forms != [None, None] {
        let of_before = before.map(|before| &before.case.micro_geometry.measured);
        let is_checked = is_checked && of_before == Some(&forms);
        case.micro_geometry.measured = forms;
        if !is_checked {
            check_load_of(&case, source)?;
        }
    }
    if surfaces.teeth().is_some() || surfaces.is_surrogate() {
        refuse_several(&case, source)?;
    }
    let flank_warnings = warnings.clone();
    let mut warnings = warnings;
    let loads = at_pitch_point(&case.gears, case.modulus, case.torque, case.speed);
    let unusual = unusual(&case.input, source, &case.oil, &loads);
    warnings.splice(
        0..0,
        unusual.into_iter().chain(step_up(&case.gears, source)),
    );
    warnings.extend(divided_shifts(&case.input.gears, &case.gears, source));
    warnings.extend(little_clearance(&case.input.gears, &case.gears, source));
    warnings.extend(read_as_keys(source));
    let gearbox = case.gearbox.iter();
    warnings.extend(gearbox.flat_map(|gearbox| gearbox.warnings.iter().cloned()));
    let oil = case.oil_file.iter();
    warnings.extend(oil.flat_map(|oil| oil.warnings(&case.input, case.temperature)));
    warnings.extend(replaced_viscosity(&case.input.lubricant));
    warnings.extend(simulated(&case.input, case.oil_file.as_deref()));
    provenance.include(&of_flanks);
    Ok(LoadedCase {
        case,
        surfaces,
        flanks: reports,
        sampled,
        warnings,
        provenance,
        of_flanks,
        flank_warnings,
        lays,
        assumed,
        name: source.name().into(),
        mesh: source.mesh().cloned(),
        files,
        sums: [flank_sums, gearbox_sums, model_sums, oil_sums],
    })
}

/// Refuses models of one pair of traces if there are several.
fn refuse_several(case: &Case, source: &Source) -> Result<(), CaseError> {
    let model = &case.model;
    let of_one_pair = [
        ("run_in", model.run_in),
        ("load_share", model.load_share == LoadShareName::Ehl),
        ("full_film", model.full_film == FullFilmName::EhlTransient),
    ];
    match of_one_pair.into_iter().find(|(_, is_chosen)| *is_chosen) {
        None => Ok(()),
        Some((key, _)) => {
            let rule =
                "is of one pair of traces: name one trace of each flank, as surface.pinion.file";
            Err(Section::of(source, "model").conflict(key, rule))
        }
    }
}

/// Whether gears, steel, torque and the model are the same in both cases.
fn loads_alike(before: &CaseInput, input: &CaseInput) -> bool {
    before.gears == input.gears
        && before.material == input.material
        && before.model == input.model
        && before.formulation == input.formulation
        && before.operation.torque == input.operation.torque
}

/// Solves for the load once, so that a form that the model refuses is reported with its place.
fn check_load_of(case: &Case, source: &Source) -> Result<(), CaseError> {
    let mesh = LoadConditions {
        pair: &case.gears,
        torque: case.torque,
        micro: &case.micro_geometry,
        materials: &case.materials,
        settings: &case.load_settings,
    };
    check_load(&mesh, &case.model, case.formulation.positions(), source)
}

/// Whether the same flanks carry the load in both cases, prepared alike.
fn same_flanks(loaded: &LoadedCase, case: &Case) -> bool {
    let before = &loaded.case;
    let (old, new) = (&before.input.surface, &case.input.surface);
    let shortest = |case| shortest_form(case).ok().flatten();
    let forms = [shortest(before), shortest(case)];
    // Place and form of a trace and the length of a surrogate depend on the gears.
    let is_of_gears = loaded.is_placed() || loaded.surfaces.is_surrogate() || forms != [None, None];
    let spacing = |case: &Case| spacing_of(case, loaded.all_traces().into_iter());
    old == new
        && spacing(before) == spacing(case)
        // Flanks without a trace are surrogates only where their contact is solved.
        && solves_contact(before) == solves_contact(case)
        && old.loaded(before.torque).2 == new.loaded(case.torque).2
        && (!is_of_gears || before.input.gears == case.input.gears)
        && forms[0] == forms[1]
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

fn xu_calibration(
    file: &Path,
    source: &Source,
    files: &Reader<'_>,
) -> Result<XuCalibration, CaseError> {
    let refused = |message: String| Section::of(source, XU_COEFFICIENTS).value("", message);
    let bytes = match files.open(file, source, XU_COEFFICIENTS)? {
        (Content::Bytes(bytes), _) => bytes,
        (Content::Heights(_), _) => {
            return Err(refused("names a trace, not coefficients".to_owned()));
        }
    };
    let text = std::str::from_utf8(&bytes)
        .map_err(|error| refused(format!("is not text in UTF-8: {error}")))?;
    XuCalibration::from_json(text).map_err(|error| refused(error.to_string()))
}

/// Names the keys that symbols in the case file are read as.
fn read_as_keys(source: &Source) -> Option<Warning> {
    let pairs: Vec<String> = (source.symbols())
        .map(|[symbol, key]| format!("{symbol} is {key}"))
        .collect();
    (!pairs.is_empty()).then(|| Warning::new(SYMBOLS, pairs.join(", ")))
}

/// W442 if the case names an oil of the library and states its viscosity.
fn replaced_viscosity(oil: &LubricantInput) -> Option<Warning> {
    let (name, _) = (oil.oil.as_ref()?, oil.viscosity.as_ref()?);
    let text = format!(
        "lubricant.viscosity of the case replaces that of the oil {name}, of which only what the case leaves out is used"
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
    // Files of former versions say it in the source.
    let simulated = fits.filter(|(_, simulated, source)| *simulated || source.contains(SIMULATED));
    let warning = |(key, _, source)| {
        let text = format!("{key}: constants were fitted to simulated measurements: {source}");
        Warning::new(Code::W446, text)
    };
    simulated.map(warning).collect()
}
