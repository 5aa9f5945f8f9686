//! Cases drawn at random around Table 2.

use asperity_tests::{CaseText, constant, table_2};
use proptest::prelude::*;
use proptest::test_runner::Config;
use toml::Value;

/// Cases a property is tried on: a mesh of values takes a few milliseconds.
pub fn config() -> Config {
    Config::with_cases(24)
}

/// A helical or spur pair in operation, its flanks known by values; about half run mixed.
#[derive(Debug, Clone)]
pub struct Drawn {
    pub teeth: [u32; 2],
    pub helix_deg: f64,
    pub width_mm: f64,
    pub torque: f64,
    pub speed: f64,
    pub viscosity_mpas: f64,
    pub rq_um: [f64; 2],
    pub rpk_um: f64,
}

impl Drawn {
    pub fn case(&self) -> CaseText {
        let flank = |rq: f64| {
            let mut flank = toml::Table::new();
            for (key, value) in [("rq", rq), ("rpk", self.rpk_um), ("asperity_radius", 100.0)] {
                flank.insert(key.to_owned(), Value::from(format!("{value} um")));
            }
            flank
        };
        table_2()
            .with(
                "gears.teeth",
                self.teeth.map(i64::from).map(Value::from).to_vec(),
            )
            .with("gears.helix", format!("{} deg", self.helix_deg))
            .with("gears.face_width", format!("{} mm", self.width_mm))
            .with("operation.torque", format!("{} N m", self.torque))
            .with("operation.speed", format!("{} 1/min", self.speed))
            .with(
                "lubricant.viscosity.dynamic_viscosity",
                format!("{} mPa s", self.viscosity_mpas),
            )
            .with("surface.pinion", flank(self.rq_um[0]))
            .with("surface.wheel", flank(self.rq_um[1]))
    }

    /// The same with one coefficient in film and asperities.
    pub fn with_constant_friction(&self, mu: f64) -> CaseText {
        self.case()
            .with("model.film_friction", constant(mu))
            .with("model.boundary_friction", mu)
    }
}

prop_compose! {
    /// Any case.
    pub fn drawn()(
        z1 in 22u32..60,
        z2 in 22u32..130,
        helix_deg in prop_oneof![Just(0.0), 8.0..32.0f64],
        width_mm in 10.0..80.0f64,
        torque in 50.0..500.0f64,
        speed in 300.0..8000.0f64,
        viscosity_mpas in 5.0..150.0f64,
        rq_um in [0.05..0.5f64, 0.05..0.5f64],
        rpk_um in 0.02..2.0f64,
    ) -> Drawn {
        Drawn { teeth: [z1, z2], helix_deg, width_mm, torque, speed, viscosity_mpas, rq_um, rpk_um }
    }
}
