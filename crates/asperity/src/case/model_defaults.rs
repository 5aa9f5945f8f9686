//! Defaults of the model that hang on its reading.

use asperity_efficiency::swept::HYSTERESIS;
use asperity_ehl_regime::inlet_flow::CentralFilm;
use asperity_ehl_regime::{FilmLaw, ThermalLaw};
use asperity_gear::LoadLaw;
use asperity_ns_film::FluidModel;
use asperity_tribo_friction::boundary::BOUNDARY_FRICTION;

use super::input::Formulation;
use super::law_names::{FilmFrictionLaw, LoadShareName};

/// Defaults of a formulation for keys left out of the case.
#[derive(Debug, Clone)]
pub(super) struct ModelDefaults {
    /// One position represents the whole mesh.
    pub one_position: bool,
    pub offsets: usize,
    pub load_distribution: LoadLaw,
    pub film_friction: FilmFrictionLaw,
    pub load_share: LoadShareName,
    pub boundary_friction: f64,
    pub hysteresis: f64,
    pub film: FilmLaw,
    pub lambda_film: CentralFilm,
    pub thermal: ThermalLaw,
    pub fluid_pressure: FluidModel,
    pub clamp_roughness: bool,
}

const CORRECTED: ModelDefaults = ModelDefaults {
    one_position: false,
    offsets: 16,
    load_distribution: LoadLaw::Elastic,
    film_friction: FilmFrictionLaw::Eyring,
    load_share: LoadShareName::Solved,
    boundary_friction: BOUNDARY_FRICTION,
    hysteresis: HYSTERESIS,
    film: FilmLaw::DowsonToyoda,
    lambda_film: CentralFilm::Gap,
    thermal: ThermalLaw::Gupta,
    fluid_pressure: FluidModel::ReynoldsCross,
    clamp_roughness: true,
};

const PAPER: ModelDefaults = ModelDefaults {
    one_position: true,
    offsets: 1,
    load_distribution: LoadLaw::MeanLength,
    film_friction: FilmFrictionLaw::Xu,
    load_share: LoadShareName::LambdaStar,
    // Metal on metal as the 2022 paper takes it (its Table 2).
    boundary_friction: 0.3,
    hysteresis: 0.0,
    film: FilmLaw::HamrockDowson,
    lambda_film: CentralFilm::MassFlow,
    thermal: ThermalLaw::None,
    fluid_pressure: FluidModel::Paper,
    clamp_roughness: false,
};

impl ModelDefaults {
    /// The defaults of `formulation`.
    pub(super) fn of(formulation: Formulation) -> &'static Self {
        match formulation {
            Formulation::Corrected => &CORRECTED,
            Formulation::Paper => &PAPER,
        }
    }
}
