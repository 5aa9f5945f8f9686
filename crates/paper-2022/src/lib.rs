//! The formulation of the 2022 paper: one position of the path, flanks that march to their load, its film pressure and its
//! printed deformation loss; and the figures of the paper.
//!
//! It is used by the programs: `cli`, `python` and `web`. It does not know studies or options of a command.
//!
//! The program does without it. [`register`] makes it a value of the key `formulation` of a case:
//!
//! ```
//! let paper = asperity_paper_2022::register();
//! let case = std::path::Path::new("../../fixtures/cases/table2.toml");
//! let loaded = asperity::case::load(case, Some(paper))?;
//! let path = asperity::Run::new(&loaded).losses()?.into_only()?.path;
//! assert_eq!(path.len(), 1);
//! # Ok::<(), asperity::Error>(())
//! ```

pub mod figures;
mod film_pressure;
mod film_survey;
mod marching;
mod printed_deformation;

pub use film_pressure::film_between;
pub use film_survey::{FilmRow, FilmSurvey, film};

use asperity::PositionError;
use asperity::case::{LoadShareName, ModelInput, PaperChoices, Positions};
use asperity::formulation::{self, FilmRegime, Formulation, FormulationChoice};
use asperity::window_pressures::{DeformationPower, Pressed, WindowConditions, WindowPressures};
use asperity_core::quantity::Ratio;
use asperity_efficiency::RollingSurfaces;
use asperity_ehl_regime::inlet_flow::CentralFilm;
use asperity_ehl_regime::{FilmLaw, Regime, ThermalLaw};
use asperity_gear::LoadLaw;
use asperity_tribo_friction::{FrictionLaw, RoughnessReading};

/// Coefficient of dry steel on steel, Table 2 of the paper.
const METAL_ON_METAL: f64 = 0.3;
/// Time per point and step \[s\] of the march.
const SECONDS_OF_A_STEP: f64 = 1.5e-7;
/// Total distance by which the march lowers the surfaces \[m\].
const LOWERED: f64 = 6.4e-6;

/// Reason to refuse a key that only the formulation of the program has.
const OF_CORRECTED: &str = "belongs to the corrected formulation; leave one of the two out";

/// Makes the formulation a value of the key `formulation`; a program calls it before it reads its first case.
pub fn register() -> FormulationChoice {
    formulation::register(&Paper)
}

/// The formulation of the 2022 paper.
#[derive(Debug)]
struct Paper;

impl Formulation for Paper {
    fn name(&self) -> &'static str {
        "paper"
    }

    fn about(&self) -> &'static str {
        "The paper's formulation, with only its misprints corrected"
    }

    fn defaults(&self) -> ModelInput {
        ModelInput {
            offsets: Some(1),
            load_distribution: Some(LoadLaw::MeanLength),
            film_friction: Some(FrictionLaw::Xu.into()),
            boundary_friction: Some(METAL_ON_METAL),
            film: Some(FilmLaw::HamrockDowson),
            thermal: Some(ThermalLaw::None),
            load_share: Some(LoadShareName::LambdaStar),
            hysteresis: Some(Ratio::new(0.0)),
            ..ModelInput::default()
        }
    }

    fn unused_keys(&self) -> &'static [&'static str] {
        &[
            "model.film_pressure_law",
            "model.boundary_layer",
            "model.lay",
            "model.inner_boundary",
        ]
    }

    fn refused_keys(&self) -> &'static [(&'static str, &'static str)] {
        &[
            (
                "operation.temperature_deviation",
                "widens an interval, which the paper's formulation does not have; leave one of the two out",
            ),
            (
                "micropitting",
                "rates the whole path, and the paper's formulation has one position; leave one of the two out",
            ),
            ("calibration", OF_CORRECTED),
            ("lubricant.oil_file", OF_CORRECTED),
            ("operation.running_in", OF_CORRECTED),
            (
                "model.inlet_layer",
                "starves the film of the formulas in the corrected formulation; leave it out or choose these",
            ),
            ("operation.bulk", OF_CORRECTED),
        ]
    }

    fn positions(&self) -> Positions {
        Positions::Single
    }

    fn assumes_relief(&self) -> bool {
        false
    }

    fn rolling_surfaces(&self) -> RollingSurfaces {
        RollingSurfaces::One
    }

    fn printed_film(&self) -> CentralFilm {
        CentralFilm::MassFlow
    }

    fn xu_roughness(&self) -> RoughnessReading {
        RoughnessReading::AsIs
    }

    /// The paper takes everything as printed.
    fn has_interval(&self) -> bool {
        false
    }

    fn regime(&self, _: f64, film_ratio: f64) -> Result<FilmRegime, PositionError> {
        let regime = Regime::from_lambda_star(film_ratio)?;
        Ok(FilmRegime {
            regime,
            is_full: regime == Regime::FullFilm,
        })
    }

    fn pressures(&self) -> Option<&dyn WindowPressures> {
        Some(self)
    }
}

impl WindowPressures for Paper {
    fn press(&self, window: &WindowConditions<'_>) -> Result<Pressed, PositionError> {
        marching::march(window)
    }

    fn deformation(
        &self,
        window: &WindowConditions<'_>,
        pressed: &Pressed,
        shear: &[f64],
    ) -> Result<DeformationPower, PositionError> {
        printed_deformation::printed_deformation_of(window, pressed, shear)
    }

    fn seconds_of_a_point(&self, paper: &PaperChoices) -> f64 {
        SECONDS_OF_A_STEP * (LOWERED / paper.delta_step.si())
    }
}
