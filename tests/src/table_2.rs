//! The two cases of the literature that the workspace tests start from.

#![allow(clippy::unwrap_used, reason = "a helper of tests may panic")]

use std::path::Path;

use asperity::ehl_regime::CentralFilm;
use asperity::formulation::{Formulation, register};
use asperity::tribo_friction::RoughnessReading;

use crate::CaseText;

/// Films as the reference computation prints them, as mass flows; with another roughness in Xu's law than 0.6 µm at most.
#[derive(Debug)]
struct OfReference {
    name: &'static str,
    xu_roughness: RoughnessReading,
}

impl Formulation for OfReference {
    fn name(&self) -> &'static str {
        self.name
    }

    fn about(&self) -> &'static str {
        "Films as mass flows"
    }

    fn printed_film(&self) -> CentralFilm {
        CentralFilm::MassFlow
    }

    fn xu_roughness(&self) -> RoughnessReading {
        self.xu_roughness
    }
}

/// Makes the formulations `reference` and, with any roughness in Xu's law, `reference-as-is` known.
pub(crate) fn register_references() {
    register(&OfReference {
        name: "reference",
        xu_roughness: RoughnessReading::Clamped,
    });
    register(&OfReference {
        name: "reference-as-is",
        xu_roughness: RoughnessReading::AsIs,
    });
}

/// Table 2 of the 2022 paper with the module read as normal, flanks known by their Rq: S is
/// 0.3·√2 = 0.424 µm, and peaks of 10 nm let the film part them all along the path. What the paper leaves
/// out is filled in as in the reference computation: β_T 0.045 1/K, steel k 45 W/(m K), ρ 7830 kg/m³,
/// c 465 J/(kg K). The reference takes the load at the mean length of the contact lines.
pub fn table_2() -> CaseText {
    CaseText::new(
        r#"
        formulation = "reference"

        [gears]
        teeth = [50, 120]
        module = "1.3 mm"
        helix = "30 deg"
        pressure_angle = "20 deg"
        face_width = "50 mm"

        [material.pinion]
        young = "210 GPa"
        poisson = 0.3
        elastic_limit = "235 MPa"
        density = "7830 kg/m3"
        conductivity = "45 W/(m K)"
        heat_capacity = "465 J/(kg K)"

        [operation]
        torque = "285 N m"
        speed = "3000 1/min"
        bulk_temperature = "60 °C"

        [lubricant]
        viscosity = { law = "given", dynamic_viscosity = "97.5 mPa s" }
        temperature_coefficient = "0.045 1/K"
        density = "998 kg/m3"
        pressure_viscosity = "2e-8 m2/N"
        thermal_conductivity = "0.135 W/(m K)"
        heat_capacity = "2000 J/(kg K)"

        [surface]
        pinion = { rq = "0.3 um", rpk = "10 nm", asperity_radius = "0.1 mm" }
        wheel = { rq = "0.3 um", rpk = "10 nm", asperity_radius = "0.1 mm" }

        [model]
        load_distribution = "mean-length"
        # The laws of the reference computation, by name.
        film_friction = "xu"
        load_share = "lambda-star"
        boundary_friction = 0.1
        hysteresis = "0 %"
        "#,
    )
}

/// The spur gears of Petry-Johnson et al., Journal of Mechanical Design 130 (2008) 062601: 40/40 teeth,
/// m = 92.74/40 mm, 28°, outside diameter 95.95 mm, face 26.7 mm, a = 91.5 mm, 413 N m, superfinished
/// to an Rq of 0.07 µm, read as that of both flanks together, a 75W90 of 0.0106 Pa s.
///
/// Not printed there and taken as in the independent computation of the numbers compared with:
/// E 207 GPa, β_T 0.04 1/K, k 0.135 W/(m K). The temperature has no part: the viscosity is given.
///
/// # Panics
/// When the fixture cannot be read.
pub fn petry_johnson() -> CaseText {
    let model = toml::toml! {
        load_distribution = "trapezoid"
        // Cells enough for the digits of the computation compared with.
        positions = 256
        // The laws of the reference computation, by name.
        film_friction = "xu"
        load_share = "lambda-star"
        boundary_friction = 0.1
        hysteresis = "0 %"
    };
    let file =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../fixtures/measured/petry-johnson.toml");
    let case = CaseText::new(&std::fs::read_to_string(file).unwrap()).with("model", model);
    // Peaks for Lambda*, which are not printed.
    let peaks = [("rpk", "10 nm"), ("asperity_radius", "0.1 mm")];
    ["pinion", "wheel"].iter().fold(case, |case, flank| {
        peaks.iter().fold(case, |case, (key, value)| {
            case.with(&format!("surface.{flank}.{key}"), *value)
        })
    })
}
