//! A planetary set of a gear train: sun, planets and ring, each mesh an ordinary case of its own.
//!
//! The sun is the pinion of its mesh with a planet, the planet is the pinion of its mesh with the ring. Speeds are relative
//! to the carrier.

use std::sync::Arc;

use asperity_core::quantity::{Angle, AngularSpeed, Torque};
use asperity_gear::gear_train::{GearTrain, Shaft, Stage};
use asperity_gear::planetary::{PlanetarySet, PlanetarySetInput};

use super::train_parts::{MeshParts, StageParts, conflict, refused};
use crate::input::case_input::{
    BodyInput, CaseInput, FlankInput, GearsInput, MaterialInput, OperationInput,
};
pub use crate::input::mesh_input::PlanetaryInput;
use crate::input::one_or_two::OneOrTwo;
use crate::resolved::shafting::StageKind;
use crate::source::case_error::CaseError;
use crate::source::defaults::Defaults;
use crate::source::source_text::{MeshKeys, Source};

/// Table of the set in a case.
pub(crate) const TABLE: &str = "planetary";
/// Speed of a ring that is held.
const HELD: AngularSpeed = AngularSpeed::from_si(0.0);

/// Sun, ring and carrier of a case `[planetary]`, the sun with torque and speed of the operation.
pub(crate) fn shafts(
    set: &PlanetaryInput,
    operation: &OperationInput,
    teeth: [f64; 2],
) -> GearTrain {
    let shaft = |name: &str, speed, torque| Shaft {
        name: name.to_owned(),
        speed,
        torque,
        drag: Torque::from_si(0.0),
    };
    GearTrain {
        shafts: vec![
            shaft("sun", Some(operation.speed), Some(operation.torque)),
            shaft("ring", Some(set.ring_speed.unwrap_or(HELD)), None),
            shaft("carrier", None, None),
        ],
        stages: vec![Stage {
            gears: [0, 1],
            carrier: Some(2),
            teeth,
        }],
    }
}

/// A planetary set with the steel and the flanks of sun, planet and ring.
pub(crate) struct SetOfCase<'a> {
    pub set: &'a PlanetaryInput,
    /// Steel; planets and ring are of the steel of the sun unless they have their own.
    pub steels: [Option<BodyInput>; 3],
    /// Flanks of planet and ring; default: the sun's trace, mirrored, and the planet's trace, mirrored.
    pub flanks: [Option<FlankInput>; 2],
    /// Case without gears and steel whose pinion has the flank of the sun.
    pub common: CaseInput,
}

/// The meshes of a set, named `name` in its train; `in_train` is the key of the train for a key of a case `[planetary]`.
pub(crate) fn stage(
    input: &SetOfCase<'_>,
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
    } = *input.set;
    let table = in_train(TABLE);
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
struct SetMesh {
    gears: [usize; 2],
    name: &'static str,
    long_name: &'static str,
    tables: &'static [(&'static str, &'static str)],
}

const MESHES: [SetMesh; 2] = [
    SetMesh {
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
    SetMesh {
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

fn mesh_case(input: &SetOfCase<'_>, mesh: &SetMesh) -> CaseInput {
    let set = input.set;
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
    let steel = |gear: usize| {
        let own = input.steels[gear].clone();
        own.or_else(|| input.steels[0].clone()).unwrap_or_default()
    };
    let mut case = CaseInput {
        gears,
        material: MaterialInput {
            pinion: steel(i),
            // The steel of the sun by default, which may differ from the planet's.
            wheel: Some(steel(j)),
            ..MaterialInput::default()
        },
        ..input.common.clone()
    };
    let [planet, ring] = &input.flanks;
    case.surface
        .wheel
        .clone_from(if j == 2 { ring } else { planet });
    if let (1, Some(planet)) = (i, planet) {
        case.surface.pinion = planet.clone();
    }
    case
}
