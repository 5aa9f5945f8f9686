//! A planetary set as a case: sun, planets and ring, each mesh an ordinary case of its own.
//!
//! The sun is the pinion of its mesh with a planet, the planet is the pinion of its mesh with the ring. Speeds are relative
//! to the carrier.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::{Arc, LazyLock};

use asperity_core::quantity::{Angle, AngularSpeed, Length};
use asperity_gear::GearError;
use asperity_gear::planetary::{PlanetaryOperation, PlanetarySet, PlanetarySetInput};
use asperity_oil::LubricantInput;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::calibration::CalibrationInput;
use super::case_file::CaseFile;
use super::check::{completed, readable};
use super::defaults::{DefaultUsed, Defaults};
use super::error::CaseError;
use super::files::Files;
use super::finish::FinishName;
use super::gear_input::GearFlankInput;
use super::input::{
    BodyInput, CaseInput, FlankInput, GearsInput, MaterialInput, OperationInput, SurfaceInput,
};
use super::known_keys::first_unknown;
use super::loaded::{LoadedCase, complete, open_source};
use super::model::{Formulation, ModelInput};
use super::one_or_two::OneOrTwo;
use super::resolve::title_by_gears;
use super::section::Section;
use super::source::{MeshKeys, Source};
use crate::error::Error;

/// A planetary case as the user writes it. Torque and speed of the operation are those of the sun.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetaryCaseInput {
    /// Title of the case, shown in every output.
    pub title: Option<String>,
    /// The set.
    pub planetary: PlanetaryInput,
    /// Steel; planets and ring are of that of the sun unless they have their own.
    #[serde(default)]
    pub material: PlanetaryMaterialInput,
    /// Torque and speed of the sun, temperature.
    pub operation: OperationInput,
    /// The oil.
    pub lubricant: LubricantInput,
    /// The measured flanks and their preparation.
    pub surface: PlanetarySurfaceInput,
    /// Choices of the model, for both meshes.
    #[serde(default)]
    pub model: ModelInput,
    /// Parameters calibrated on a rig, for both meshes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CalibrationInput>,
}

/// Sun, planets and ring. Three values belong to sun, planet and ring.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetaryInput {
    /// Tooth numbers; the ring's may be negative: `[27, 24, -75]`.
    pub teeth: [i32; 3],
    /// Number of planets.
    pub planets: u32,
    /// Normal module.
    pub module: Length,
    /// Helix angle β; default 0 deg.
    pub helix: Option<Angle>,
    /// Normal pressure angle; default 20 deg.
    pub pressure_angle: Option<Angle>,
    /// Face widths.
    pub face_width: [Length; 3],
    /// Profile shift coefficients; default `[0, 0, 0]`. A positive one brings the ring's teeth towards its axis.
    pub profile_shift: Option<[f64; 3]>,
    /// Distance of the planet axes from that of the sun; derived from the profile shifts when not given.
    pub centre_distance: Option<Length>,
    /// Tip diameters; derived from the addendum when not given.
    pub tip_diameter: Option<[Length; 3]>,
    /// Addendum in modules; default 1.
    pub addendum: Option<f64>,
    /// Speed of the ring; default 0, held.
    pub ring_speed: Option<AngularSpeed>,
    /// Load of the most loaded planet over the mean, K_γ, which raises pressures alone; default 1.
    pub load_share_factor: Option<f64>,
    /// Flanks, tip and root of the sun.
    pub sun: Option<GearFlankInput>,
    /// Flanks, tip and root of the planets.
    pub planet: Option<GearFlankInput>,
    /// Flanks, tip and root of the ring.
    pub ring: Option<GearFlankInput>,
}

/// Steel of the set.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetaryMaterialInput {
    /// The sun; also planets and ring unless given.
    #[serde(default)]
    pub sun: BodyInput,
    /// The planets, where they differ.
    pub planet: Option<BodyInput>,
    /// The ring, where it differs.
    pub ring: Option<BodyInput>,
}

/// The flanks of the set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlanetarySurfaceInput {
    /// Trace of the sun's flank.
    pub sun: FlankInput,
    /// Trace of a planet's flank, for both of its meshes; default: the sun's trace, mirrored.
    pub planet: Option<FlankInput>,
    /// Trace of the ring's flank; default: the planet's trace, mirrored.
    pub ring: Option<FlankInput>,
    /// Finish of flanks without a file; default by Ra.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub finish: Option<FinishName>,
    /// Form removed from each trace; default `level` (a straight line).
    pub form: Option<Form>,
    /// Cut-off λc; default as the file states, else 0.25 mm.
    pub cutoff: Option<Length>,
    /// Cut-off λs; default as the file states, else 2.5 um.
    pub noise_cutoff: Option<Length>,
    /// Treatment of the ends of a trace in filtering; default `cut`.
    pub ends: Option<Ends>,
    /// Robust standard deviations from the running median beyond which spikes are replaced; default none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outliers: Option<f64>,
}

/// A planetary case, ready to run.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct LoadedPlanetary {
    /// Title.
    pub title: String,
    /// The set.
    pub set: PlanetarySet,
    /// Operating point.
    pub operation: PlanetaryOperation,
    /// The meshes of sun and planet, and of planet and ring.
    pub meshes: [LoadedCase; 2],
    /// The case as read.
    pub input: PlanetaryCaseInput,
    /// Every default in use, by the keys of the set.
    pub defaults: Vec<DefaultUsed>,
}

/// The JSON schema of a planetary case file.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(PlanetaryCaseInput).to_value()
}

/// Whether the text is of a planetary set: it has a table `[planetary]`.
pub fn is_planetary(source: &Source) -> bool {
    source.key_paths().any(|key| key == "planetary")
}

/// Reads the planetary case file `path` and the traces it names; `None` if the file holds no `[planetary]`.
///
/// # Errors
/// When a file cannot be read or holds impossible values.
pub fn load(path: &Path) -> Result<Option<LoadedPlanetary>, Error> {
    // The loader of ordinary cases reports files that cannot be read.
    let Ok(source) = open_source(path) else {
        return Ok(None);
    };
    if !is_planetary(&source) {
        return Ok(None);
    }
    load_set(source, path.parent().unwrap_or(Path::new(".")), &[], None).map(Some)
}

/// Reads the planetary case in `source`, whose files are in `folder`, with keys set by their paths; `formulation` is that
/// of both meshes.
///
/// # Errors
/// As for [`load`], or when a key is not known or its value cannot be read.
pub fn load_set(
    source: Source,
    folder: &Path,
    keys: &[(String, String)],
    formulation: Option<Formulation>,
) -> Result<LoadedPlanetary, Error> {
    let mut source = source;
    let read = |source: &mut Source| -> Result<LoadedPlanetary, CaseError> {
        let mut input = PlanetaryCaseInput::read(source)?;
        for (key, value) in keys {
            input.set_in(source, key, value)?;
        }
        let files = Arc::new(Files::in_folder(folder));
        let Derived {
            set,
            operation,
            defaults,
            cases,
        } = derived(&input, source)?;
        let mut meshes = Vec::with_capacity(2);
        for (case, mesh) in cases.into_iter().zip(&MESHES) {
            let case = CaseInput {
                formulation,
                ..case
            };
            let source = source.of_mesh(mesh.keys);
            meshes.push(complete(case, &source, Arc::clone(&files), None)?);
        }
        loaded(input, set, operation, defaults, meshes)
    };
    read(&mut source).map_err(|error| Error::in_text(error, source))
}

/// The errors of a planetary case, or the case.
#[derive(Debug)]
#[non_exhaustive]
pub struct SetFindings {
    /// Every error, in the order of the checks; empty if the case can be run.
    pub errors: Vec<Error>,
    /// The case with its traces, if there is no error.
    pub case: Option<LoadedPlanetary>,
}

/// Reads the planetary case in `source` as [`load_set`] does, and goes on after an error.
pub fn check(source: Source, folder: &Path, keys: &[(String, String)]) -> SetFindings {
    let mut source = source;
    let mut errors = Vec::new();
    let case = all(&mut source, folder, keys, &mut errors);
    let errors: Vec<Error> = errors
        .into_iter()
        .map(|error| Error::in_text(error, source.clone()))
        .collect();
    SetFindings {
        case: case.filter(|_| errors.is_empty()),
        errors,
    }
}

fn all(
    source: &mut Source,
    folder: &Path,
    keys: &[(String, String)],
    errors: &mut Vec<CaseError>,
) -> Option<LoadedPlanetary> {
    let (input, mending) = readable::<PlanetaryCaseInput>(source, keys, errors)?;
    let derived = match derived(&input, source) {
        Ok(derived) => derived,
        Err(error) => {
            if !mending.is_known("planetary") {
                errors.push(error);
            }
            return None;
        }
    };
    let Derived {
        set,
        operation,
        defaults,
        cases,
    } = derived;
    let mut meshes = Vec::with_capacity(2);
    for (case, mesh) in cases.into_iter().zip(&MESHES) {
        let source = source.of_mesh(mesh.keys);
        let mending = mending.of_mesh(mesh.keys)?;
        let mut of_mesh = Vec::new();
        meshes.extend(completed(case, &source, folder, mending, &mut of_mesh));
        // Errors of shared keys occur in both meshes.
        let known: BTreeSet<_> = errors.iter().map(identity).collect();
        let is_new = |error: &CaseError| !known.contains(&identity(error));
        errors.extend(of_mesh.into_iter().filter(is_new));
    }
    loaded(input, set, operation, defaults, meshes).ok()
}

/// Identity of an error: its code with its line, or with its text if it has no line.
fn identity(error: &CaseError) -> (&'static str, Option<usize>, String) {
    let line = error.place().and_then(|place| place.line);
    let text = line.map_or_else(|| error.to_string(), |_| String::new());
    (error.code(), line, text)
}

impl CaseFile for PlanetaryCaseInput {
    const VALID: &'static str = r#"
planetary = { teeth = [27, 24, -75], planets = 3, module = "2 mm", face_width = ["30 mm", "30 mm", "30 mm"] }
operation = { torque = "100 N m", speed = "3000 1/min", bulk_temperature = "60 °C" }
lubricant = { oil = "m100" }
surface = { sun = { rq = "0.3 um" }, planet = { rq = "0.3 um" }, ring = { rq = "0.3 um" } }
"#;

    fn schema() -> &'static serde_json::Value {
        static SCHEMA: LazyLock<serde_json::Value> = LazyLock::new(schema);
        &SCHEMA
    }
}

/// Set and mesh cases derived from a planetary case.
struct Derived {
    set: PlanetarySet,
    operation: PlanetaryOperation,
    defaults: Vec<DefaultUsed>,
    cases: [CaseInput; 2],
}

fn derived(input: &PlanetaryCaseInput, source: &Source) -> Result<Derived, CaseError> {
    let (set, operation, defaults) = set(input, source)?;
    let cases = meshes(input, &set, &operation).map_err(refused(source))?;
    Ok(Derived {
        set,
        operation,
        defaults,
        cases,
    })
}

/// Adds the defaults of a mesh that are keys of the set.
fn add_defaults(defaults: &mut Vec<DefaultUsed>, mesh: &LoadedCase, keys: MeshKeys) {
    let schema = PlanetaryCaseInput::schema();
    for default in &mesh.case.defaults {
        let key = match keys.in_set(&default.key) {
            Some(in_set) => in_set.into(),
            None => default.key.clone(),
        };
        let is_known = first_unknown(schema, std::iter::once(&*key)).is_none();
        if is_known && defaults.iter().all(|before| before.key != key) {
            defaults.push(DefaultUsed {
                key,
                ..default.clone()
            });
        }
    }
}

fn loaded(
    input: PlanetaryCaseInput,
    set: PlanetarySet,
    operation: PlanetaryOperation,
    mut defaults: Vec<DefaultUsed>,
    meshes: Vec<LoadedCase>,
) -> Result<LoadedPlanetary, CaseError> {
    for (loaded, mesh) in meshes.iter().zip(&MESHES) {
        add_defaults(&mut defaults, loaded, mesh.keys);
    }
    let meshes = <[LoadedCase; 2]>::try_from(meshes).map_err(|_| {
        Section::of(&Source::in_memory(), "planetary").conflict("", "needs both of its meshes")
    })?;
    let [sun, planet] = set.sun_planet.teeth;
    let [_, ring] = set.planet_ring.teeth;
    let (title, teeth) = (input.title.clone(), [sun, planet, ring]);
    Ok(LoadedPlanetary {
        title: title.unwrap_or_else(|| title_by_gears(&teeth, set.sun_planet.normal_module)),
        meshes,
        set,
        operation,
        input,
        defaults,
    })
}

/// A set that cannot mesh.
fn refused(source: &Source) -> impl Fn(GearError) -> CaseError + '_ {
    |error| CaseError::Gears {
        place: source.place_of_key("planetary"),
        source: error,
    }
}

fn set(
    input: &PlanetaryCaseInput,
    source: &Source,
) -> Result<(PlanetarySet, PlanetaryOperation, Vec<DefaultUsed>), CaseError> {
    // The other keys are of the meshes.
    let PlanetaryInput {
        teeth,
        planets,
        module,
        helix,
        pressure_angle,
        face_width,
        profile_shift,
        centre_distance,
        tip_diameter,
        addendum,
        ring_speed,
        load_share_factor,
        sun: _,
        planet: _,
        ring: _,
    } = input.planetary;
    let mut defaults = Defaults::default();
    let helix = defaults.take("planetary.helix", helix, Angle::from_si(0.0));
    let standard = PlanetarySetInput::standard(
        teeth.map(i32::unsigned_abs),
        planets,
        module,
        helix,
        face_width[0],
    );
    if teeth[0] < 0 || teeth[1] < 0 {
        let rule = "only the ring may have a negative number, as [27, 24, -75]";
        return Err(Section::of(source, "planetary").conflict("teeth", rule));
    }
    let set = PlanetarySet::new(&PlanetarySetInput {
        face_width,
        pressure_angle: defaults.take(
            "planetary.pressure_angle",
            pressure_angle,
            standard.pressure_angle,
        ),
        profile_shift: defaults.take("planetary.profile_shift", profile_shift, [0.0; 3]),
        centre_distance,
        tip_radius: tip_diameter.map(|d| d.map(|d| d / 2.0)),
        addendum: defaults.take("planetary.addendum", addendum, standard.addendum),
        ..standard
    })
    .map_err(refused(source))?;
    let held = AngularSpeed::from_si(0.0);
    let operation = PlanetaryOperation {
        sun_torque: input.operation.torque,
        sun_speed: input.operation.speed,
        ring_speed: defaults.take("planetary.ring_speed", ring_speed, held),
        load_share_factor: defaults.take("planetary.load_share_factor", load_share_factor, 1.0),
    };
    Ok((set, operation, defaults.into_list()))
}

/// Two of the three gears, the first of them the pinion.
struct Mesh {
    gears: [usize; 2],
    name: &'static str,
    keys: MeshKeys,
}

const MESHES: [Mesh; 2] = [
    Mesh {
        gears: [0, 1],
        name: "sun and planet",
        keys: MeshKeys {
            name: "mesh of the sun, its pinion, and a planet",
            tables: &[
                ("gears.pinion", "planetary.sun"),
                ("gears.wheel", "planetary.planet"),
                ("gears", "planetary"),
                ("material.pinion", "material.sun"),
                ("material.wheel", "material.planet"),
                ("surface.pinion", "surface.sun"),
                ("surface.wheel", "surface.planet"),
            ],
        },
    },
    Mesh {
        gears: [1, 2],
        name: "planet and ring",
        keys: MeshKeys {
            name: "mesh of a planet, its pinion, and the ring",
            tables: &[
                ("gears.pinion", "planetary.planet"),
                ("gears.wheel", "planetary.ring"),
                ("gears", "planetary"),
                ("material.pinion", "material.planet"),
                ("material.wheel", "material.ring"),
                ("surface.pinion", "surface.planet"),
                ("surface.wheel", "surface.ring"),
            ],
        },
    },
];

/// The case of each mesh.
fn meshes(
    input: &PlanetaryCaseInput,
    set: &PlanetarySet,
    operation: &PlanetaryOperation,
) -> Result<[CaseInput; 2], GearError> {
    let loads = set.meshes(operation)?;
    let distance = set.sun_planet.centre_distance;
    let of = |mesh: usize| {
        let mut case = mesh_case(input, &MESHES[mesh]);
        case.operation.torque = loads[mesh].torque;
        case.operation.speed = loads[mesh].speed;
        if mesh == 1 {
            case.gears.centre_distance = Some(distance);
        }
        case
    };
    Ok([of(0), of(1)])
}

fn mesh_case(input: &PlanetaryCaseInput, mesh: &Mesh) -> CaseInput {
    let set = &input.planetary;
    let [i, j] = mesh.gears;
    let flanks = [set.sun, set.planet, set.ring];
    let teeth = set.teeth.map(i32::abs);
    let wheel = if j == 2 { -teeth[j] } else { teeth[j] };
    let mut gears = GearsInput::new([teeth[i], wheel], set.module, set.face_width[i]);
    gears.helix = set.helix;
    gears.pressure_angle = set.pressure_angle;
    gears.face_width = OneOrTwo::Two([set.face_width[i], set.face_width[j]]);
    let shift = set.profile_shift.unwrap_or_default();
    gears.profile_shift = Some([shift[i], shift[j]]);
    gears.centre_distance = set.centre_distance;
    gears.tip_diameter = set.tip_diameter.map(|d| [d[i], d[j]]);
    gears.addendum = set.addendum;
    (gears.pinion, gears.wheel) = (flanks[i], flanks[j]);
    let steel = &input.material;
    let steels = [Some(&steel.sun), steel.planet.as_ref(), steel.ring.as_ref()];
    let surface = &input.surface;
    let traces = [
        Some(surface.sun.clone()),
        surface.planet.clone(),
        surface.ring.clone(),
    ];
    let title = input.title.clone();
    let title =
        title.unwrap_or_else(|| title_by_gears(&set.teeth.map(i32::unsigned_abs), set.module));
    CaseInput {
        title: Some(format!("{title}: {}", mesh.name)),
        gears,
        material: MaterialInput {
            pinion: steels[i].unwrap_or(&steel.sun).clone(),
            // The steel of the sun by default, which may differ from that of the planet.
            wheel: Some(steels[j].unwrap_or(&steel.sun).clone()),
        },
        operation: input.operation,
        lubricant: input.lubricant.clone(),
        surface: SurfaceInput {
            pinion: traces[i].clone().unwrap_or_else(|| surface.sun.clone()),
            wheel: traces[j].clone(),
            finish: surface.finish,
            form: surface.form,
            cutoff: surface.cutoff,
            noise_cutoff: surface.noise_cutoff,
            ends: surface.ends,
            outliers: surface.outliers,
            coast: None,
        },
        model: input.model.clone(),
        calibration: input.calibration.clone(),
        ..CaseInput::default()
    }
}
