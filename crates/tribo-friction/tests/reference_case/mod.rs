//! A pair of helical gears (module 1.3 mm, 50/120 teeth, 285 N m, 3000 1/min, oil of 97.5 mPa s)
//! at four positions of the path of contact: its start A, midway to the pitch point, the pitch
//! point C and its end E. The numbers were computed independently
//! by `references/table_2.py`.

#![allow(dead_code, reason = "each test binary reads a part")]

use asperity_core::material::Material;
use asperity_core::quantity::{
    Density, DynamicViscosity, KinematicViscosity, Length, LineLoad, Pressure, PressureViscosity,
    SpecificHeat, Speed, ThermalConductivity,
};
use asperity_tribo_friction::{FrictionConditions, MeshConditions};

/// One position and what is expected of it.
pub struct Position {
    pub radius_mm: f64,
    pub entrainment: f64,
    pub sliding: f64,
    pub half_width_um: f64,
    pub max_pressure_mpa: f64,
    pub thermal_loading: f64,
    pub gupta: f64,
    /// Rolling resistance without and with Gupta's factor [N/m].
    pub rolling: [f64; 2],
    /// Thermal factor of the longer Goksem form.
    pub goksem: f64,
    /// Xu's coefficient at S = √2 · 0.3 um and at 0.1 um.
    pub xu: [f64; 2],
    /// Benedict and Kelley's coefficient; none without sliding.
    pub benedict_kelley: Option<f64>,
    /// Flash temperature with Xu's coefficient [K].
    pub flash: Option<f64>,
}

pub const POSITIONS: [Position; 4] = [
    Position {
        radius_mm: 9.88114442093857,
        entrainment: 4.27194395222793,
        sliding: -1.4375437892738865,
        half_width_um: 111.20093364750424,
        max_pressure_mpa: 649.2606732949997,
        thermal_loading: 0.5931089167567454,
        gupta: 0.751983751105238,
        rolling: [189.69201457512523, 142.64531267491213],
        goksem: 0.802405791931197,
        xu: [0.06270368015400943, 0.04822360375352046],
        benedict_kelley: Some(0.04105473864166244),
        flash: Some(14.431527723752794),
    },
    Position {
        radius_mm: 10.813777298688333,
        entrainment: 4.419926401123771,
        sliding: -0.7187718946369426,
        half_width_um: 116.3304802081749,
        max_pressure_mpa: 620.6317804397543,
        thermal_loading: 0.6349118552189051,
        gupta: 0.7841148370500348,
        rolling: [199.84035374867693, 156.69778641566512],
        goksem: 0.7948372101094343,
        xu: [0.04756790564334416, 0.0365831132637723],
        benedict_kelley: Some(0.045481549414874534),
        flash: Some(5.24713721489411),
    },
    Position {
        radius_mm: 11.626875546138667,
        entrainment: 4.567908850019612,
        sliding: 0.0,
        half_width_um: 120.62472106086729,
        max_pressure_mpa: 598.5372850278331,
        thermal_loading: 0.6781382160178435,
        gupta: 0.8326042429690769,
        rolling: [209.15368509994005, 174.14224564682823],
        goksem: 0.7872585724392404,
        xu: [0.0, 0.0],
        benedict_kelley: None,
        flash: None,
    },
    Position {
        radius_mm: 12.848111791664245,
        entrainment: 4.850671269098024,
        sliding: 1.3734174640951444,
        half_width_um: 126.80152115950233,
        max_pressure_mpa: 569.3811272200243,
        thermal_loading: 0.7646928822277236,
        gupta: 0.7356620904650241,
        rolling: [224.86259226188093, 165.42288469075964],
        goksem: 0.7727948637983686,
        xu: [0.05290371289829524, 0.04068672973629712],
        benedict_kelley: Some(0.03957831302320505),
        flash: Some(10.212536718208998),
    },
];

/// E* of steel on steel.
pub const MODULUS: Pressure = Pressure::from_si(210e9 / (2.0 * 0.91));
pub const LOAD: LineLoad = LineLoad::from_si(113_408.970_605_022_6);
pub const OIL: DynamicViscosity = DynamicViscosity::from_si(0.0975);
pub const ALPHA: PressureViscosity = PressureViscosity::from_si(2e-8);

pub const STEEL: Material = Material {
    young: Pressure::from_si(210e9),
    poisson: 0.3,
    elastic_limit: Pressure::from_si(235e6),
    density: Density::from_si(7830.0),
    conductivity: ThermalConductivity::from_si(45.0),
    heat_capacity: SpecificHeat::from_si(465.0),
};

/// Inputs of the laws: Rq 0.3 um, Ra 0.25 um and Rz 2.5 um on each flank.
pub fn conditions(position: &Position) -> FrictionConditions {
    FrictionConditions {
        load: LOAD,
        radius: Length::from_si(position.radius_mm * 1e-3),
        entrainment: Speed::from_si(position.entrainment),
        sliding: Speed::from_si(position.sliding),
        max_pressure: Pressure::from_si(position.max_pressure_mpa * 1e6),
        viscosity: OIL,
        contact_viscosity: DynamicViscosity::from_si(50.0),
        kinematic_viscosity: KinematicViscosity::from_si(97.7e-6),
        pressure_viscosity: ALPHA,
        central_film: Length::from_si(1.5e-6),
        minimum_film: Length::from_si(1.2e-6),
        combined_roughness: Length::from_si(0.3e-6 * std::f64::consts::SQRT_2),
        mean_ra: Length::from_si(0.25e-6),
        sum_rz: Length::from_si(5e-6),
        boundary_coefficient: 0.1,
        mesh: MeshConditions {
            base_line_load: LineLoad::from_si(164_756.491_723_931_02),
            sum_speed: Speed::from_si(9.135817700039224),
            reduced_radius: Length::from_si(11.626875546138667e-3),
            lubricant_factor: 1.0,
            load_intensity: Pressure::from_si(3.1095794023745755e6),
            pitch_line_speed: Speed::from_si(11.79),
        },
    }
}
