//! A planetary set as a case: sun, planets and ring, each mesh an ordinary case of its own.
//!
//! The sun is the pinion of its mesh with a planet, the planet is the pinion of its mesh with the ring. Speeds are relative
//! to the carrier.

use std::sync::{Arc, LazyLock};

use asperity_core::quantity::{Angle, AngularSpeed, Length, Torque};
use asperity_gear::gear_train::{GearTrain, TrainShaft, TrainStage};
use asperity_gear::planetary::{PlanetarySet, PlanetarySetInput};
use asperity_oil::LubricantInput;
use asperity_roughness::form::Form;
use asperity_roughness::gaussian_filter::Ends;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::calibration::CalibrationInput;
use super::case_file::CaseFile;
use super::defaults::Defaults;
use super::error::CaseError;
use super::finish::FinishName;
use super::gear_input::GearFlankInput;
use super::input::{
    BodyInput, CaseInput, FlankInput, GearsInput, MapInput, MaterialInput, OperationInput,
    SurfaceInput, VehicleInput,
};
use super::model::ModelInput;
use super::one_or_two::OneOrTwo;
use super::source::{MeshKeys, Source};
use super::train_flow::StageKind;
use super::train_parts::{MeshParts, StageParts, TrainFile, TrainParts, conflict, refused};

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
    /// Ranges of the default axes of `asperity map`; a run ignores them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<MapInput>,
    /// The vehicle of a cycle stated by its speed, for `asperity cycle`; a run ignores it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vehicle: Option<VehicleInput>,
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

/// The JSON schema of a planetary case file.
pub fn schema() -> serde_json::Value {
    schemars::schema_for!(PlanetaryCaseInput).to_value()
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

impl TrainFile for PlanetaryCaseInput {
    const TABLE: &'static str = "planetary";

    fn parts(&self, source: &Source) -> Result<TrainParts, CaseError> {
        let stage = stage(self, source, None, &str::to_owned)?;
        let ring_speed = self.planetary.ring_speed;
        let shaft = |name: &str, speed, torque| TrainShaft {
            name: name.to_owned(),
            speed,
            torque,
            drag: Torque::from_si(0.0),
        };
        let OperationInput { torque, speed, .. } = self.operation;
        let shafts = GearTrain {
            shafts: vec![
                shaft("sun", Some(speed), Some(torque)),
                shaft("ring", Some(ring_speed.unwrap_or(HELD)), None),
                shaft("carrier", None, None),
            ],
            stages: vec![TrainStage {
                gears: [0, 1],
                carrier: Some(2),
                teeth: stage.teeth,
            }],
        };
        TrainParts::new(self.title.clone(), shafts, false, vec![stage])
            .map_err(refused(source, Self::TABLE))
    }
}

/// Speed of a ring that is held.
const HELD: AngularSpeed = AngularSpeed::from_si(0.0);

/// The meshes of a set, named `name` in its train; `in_train` is the key of the train for a key of a planetary case.
pub(super) fn stage(
    input: &PlanetaryCaseInput,
    source: &Source,
    name: Option<&str>,
    in_train: &dyn Fn(&str) -> String,
) -> Result<StageParts, CaseError> {
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
    let table = in_train(PlanetaryCaseInput::TABLE);
    let key = |name: &str| format!("{table}.{name}");
    let mut defaults = Defaults::default();
    let helix = defaults.take(key("helix"), helix, Angle::from_si(0.0));
    let standard = PlanetarySetInput::standard(
        teeth.map(i32::unsigned_abs),
        planets,
        module,
        helix,
        face_width[0],
    );
    if teeth[0] < 0 || teeth[1] < 0 {
        let rule = "only the ring may have a negative number, as [27, 24, -75]";
        return Err(conflict(source, key("teeth"), rule));
    }
    let set = PlanetarySet::new(&PlanetarySetInput {
        face_width,
        pressure_angle: defaults.take(
            key("pressure_angle"),
            pressure_angle,
            standard.pressure_angle,
        ),
        profile_shift: defaults.take(key("profile_shift"), profile_shift, [0.0; 3]),
        centre_distance,
        tip_radius: tip_diameter.map(|d| d.map(|d| d / 2.0)),
        addendum: defaults.take(key("addendum"), addendum, standard.addendum),
        ..standard
    })
    .map_err(refused(source, &table))?;
    defaults.take(key("ring_speed"), ring_speed, HELD);
    let load_share_factor = defaults.take(key("load_share_factor"), load_share_factor, 1.0);
    let meshes = MESHES.iter().map(|mesh| {
        let mut case = mesh_case(input, mesh);
        if mesh.gears == [1, 2] {
            case.gears.centre_distance = Some(set.sun_planet.centre_distance);
        }
        let of_set = name.map_or(String::new(), |name| format!("{name}, "));
        let tables = mesh.tables.iter();
        MeshParts {
            name: format!("{of_set}{}", mesh.name),
            keys: Arc::new(MeshKeys {
                name: format!("{of_set}{}", mesh.long_name),
                tables: tables
                    .map(|(of_mesh, of_set)| ((*of_mesh).to_owned(), in_train(of_set)))
                    .collect(),
            }),
            case,
        }
    });
    let [sun, _, ring] = teeth.map(i32::unsigned_abs).map(f64::from);
    Ok(StageParts {
        name: name.map(str::to_owned),
        teeth: [sun, ring],
        meshes: meshes.collect(),
        kind: StageKind::Planetary {
            set: set.into(),
            load_share_factor,
        },
        defaults: defaults.into_list(),
    })
}

/// Two of the three gears, the first of them the pinion.
struct Mesh {
    gears: [usize; 2],
    name: &'static str,
    long_name: &'static str,
    tables: &'static [(&'static str, &'static str)],
}

const MESHES: [Mesh; 2] = [
    Mesh {
        gears: [0, 1],
        name: "sun and planet",
        long_name: "mesh of the sun, its pinion, and a planet",
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
    Mesh {
        gears: [1, 2],
        name: "planet and ring",
        long_name: "mesh of a planet, its pinion, and the ring",
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
];

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
    CaseInput {
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
