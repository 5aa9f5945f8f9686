//! The published friction laws, one row each.
//!
//! | name | law | local or whole mesh | roughness by |
//! |---|---|---|---|
//! | `xu` | [`mod@xu`] | local | S |
//! | `iso-14179-2` | [`iso_14179_2`], Schlenk | whole mesh | Ra |
//! | `iso-14179-1` | [`iso_14179_1`] | whole mesh | - |
//! | `benedict-kelley` | [`benedict_kelley`] | local | Ra |
//! | `matsumoto` | [`matsumoto`] | local | Rz |
//! | `doleschel` | [`doleschel`] | local | Ra |
//! | `eyring-arana` | [`eyring`], full film | local | - |
//! | `constant` | the setting `constant` | whole mesh | - |
//!
//! A whole-mesh law gives the same coefficient at every position. `matsumoto` and `doleschel`
//! share the load between the boundary coefficient and a fluid one: the setting
//! `fluid_coefficient`, or Eyring's coefficient without it.

pub mod benedict_kelley;
pub mod doleschel;
pub mod eyring;
pub mod iso_14179_1;
pub mod iso_14179_2;
pub mod matsumoto;
pub mod xu;

use asperity_core::{Checked, DomainError};
use serde::{Deserialize, Serialize};

use crate::conditions::FrictionConditions;
use crate::error::FrictionError;
use crate::published_law::{Asperities, PublishedLaw};
use benedict_kelley::BenedictKelleyConditions;
use eyring::EyringConditions;
use xu::XuConditions;
pub use xu::{RoughnessReading, XuCalibration, XuCoefficients, XuLaw};

/// Coefficient at one mesh position.
type Coefficient =
    fn(&FrictionSettings, &FrictionConditions) -> Result<Checked<f64>, FrictionError>;

/// Rows `Name "name in a case file" "title" { fields of PublishedLaw } = coefficient;`.
macro_rules! friction_laws {
    ($($(#[$meta:meta])+ $law:ident $name:literal $title:literal { $($field:ident: $value:expr),+ } = $coefficient:path;)+) => {
        /// Law of the friction coefficient.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub enum FrictionLaw {
            $($(#[$meta])+ #[serde(rename = $name)] $law),+
        }

        const ROWS: &[(PublishedLaw, Coefficient)] = &[$((
            PublishedLaw { name: $name, judged: concat!($title, " (assumed)"), $($field: $value),+ },
            $coefficient,
        )),+];

        impl FrictionLaw {
            /// Every law, in the order of the table above.
            pub const ALL: &[Self] = &[$(Self::$law),+];
        }
    };
}

// The ranges of temperature and pressure are assumed, the texts give none. Xu's and Arana's laws check the pressure
// themselves.
friction_laws! {
    /// Xu 2005: regression of thermal mixed EHL solutions.
    #[default]
    Xu "xu" "Xu" {
        asperities: Asperities::Included, fitted_to: "mixed-EHL solutions of one 75W90",
        excludes_rolling: true, is_whole: true, celsius: Some([40.0, 120.0]), gigapascals: None
    } = xu;
    /// ISO/TR 14179-2 (Schlenk 1994): one coefficient for the mesh.
    Iso14179Part2 "iso-14179-2" "ISO/TR 14179-2" {
        asperities: Asperities::Included, fitted_to: "FZG gears; mineral, PAO and PAG by X_L",
        excludes_rolling: false, is_whole: true, celsius: Some([30.0, 120.0]), gigapascals: Some([0.3, 2.0])
    } = iso_part_2;
    /// ISO/TR 14179-1: one coefficient for the mesh.
    Iso14179Part1 "iso-14179-1" "ISO/TR 14179-1" {
        asperities: Asperities::Included, fitted_to: "gears with mineral oils",
        excludes_rolling: false, is_whole: true, celsius: Some([30.0, 110.0]), gigapascals: Some([0.3, 2.0])
    } = iso_part_1;
    /// Benedict and Kelley 1961: roller tests.
    BenedictKelley "benedict-kelley" "Benedict-Kelley" {
        asperities: Asperities::Included, fitted_to: "roller tests with mineral oils",
        excludes_rolling: true, is_whole: true, celsius: Some([30.0, 120.0]), gigapascals: Some([0.3, 2.0])
    } = rollers;
    /// Matsumoto and Morikawa 2014: load sharing by maximum heights.
    Matsumoto "matsumoto" "Matsumoto" {
        asperities: Asperities::Shared, fitted_to: "twin-disc tests; coefficients of the oils tested",
        excludes_rolling: true, is_whole: false, celsius: Some([40.0, 120.0]), gigapascals: Some([0.3, 2.0])
    } = shared_by_heights;
    /// Doleschel 2002: load sharing by the film ratio.
    Doleschel "doleschel" "Doleschel" {
        asperities: Asperities::Shared, fitted_to: "FZG gears and twin discs; coefficients of the oils tested",
        excludes_rolling: true, is_whole: false, celsius: Some([40.0, 120.0]), gigapascals: Some([0.3, 2.0])
    } = shared_by_film_ratio;
    /// Eyring with a limiting shear stress: fluid friction of a full film.
    Eyring "eyring-arana" "Eyring (Arana)" {
        asperities: Asperities::Excluded, fitted_to: "twin discs, base oils of ISO VG 100",
        excludes_rolling: true, is_whole: false, celsius: Some([40.0, 120.0]), gigapascals: None
    } = full_film;
    /// A given constant.
    Constant "constant" "constant" {
        asperities: Asperities::Unknown, fitted_to: "a given number",
        excludes_rolling: true, is_whole: false, celsius: None, gigapascals: None
    } = constant;
}

/// Choices that the laws leave open.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields)]
pub struct FrictionSettings {
    /// Coefficients and choices of Xu's law.
    pub xu: XuLaw,
    /// The coefficient of the law `constant`.
    pub constant: Option<f64>,
    /// Fluid coefficient of `matsumoto` and `doleschel`; without it, Eyring's coefficient.
    pub fluid_coefficient: Option<f64>,
    /// Limiting shear stress over pressure of the oil.
    pub limiting_stress: f64,
}

impl Default for FrictionSettings {
    fn default() -> Self {
        Self {
            xu: XuLaw::default(),
            constant: None,
            fluid_coefficient: None,
            limiting_stress: eyring::MINERAL_OIL_LIMIT,
        }
    }
}

impl FrictionLaw {
    fn row(self) -> &'static (PublishedLaw, Coefficient) {
        // The rows are in the order of the variants.
        &ROWS[self as usize]
    }

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        self.published().name
    }

    /// Scope of the law: roughness in its coefficient, data, ranges.
    ///
    /// ```
    /// use asperity_tribo_friction::{FrictionLaw, published_law::Asperities};
    /// assert_eq!(FrictionLaw::Xu.published().asperities, Asperities::Included);
    /// assert_eq!(FrictionLaw::Eyring.published().asperities, Asperities::Excluded);
    /// ```
    #[must_use]
    pub fn published(self) -> &'static PublishedLaw {
        &self.row().0
    }

    /// The friction coefficient at one mesh position.
    ///
    /// Without sliding `benedict-kelley` gives 0: its logarithm diverges there, but no sliding
    /// friction does work, and μ V_s → 0 is what the losses need.
    ///
    /// # Errors
    /// When an input that the law reads is outside its domain or a setting is missing.
    pub fn coefficient(
        self,
        settings: &FrictionSettings,
        position: &FrictionConditions,
    ) -> Result<Checked<f64>, FrictionError> {
        let (_, coefficient) = self.row();
        coefficient(settings, position)
    }
}

fn xu(settings: &FrictionSettings, at: &FrictionConditions) -> Result<Checked<f64>, FrictionError> {
    settings.xu.coefficient(&XuConditions {
        slide_to_roll: at.slide_to_roll()?,
        max_pressure: at.max_pressure,
        viscosity: at.viscosity,
        entrainment: at.entrainment,
        radius: at.radius,
        combined_roughness: at.combined_roughness,
    })
}

fn rollers(_: &FrictionSettings, at: &FrictionConditions) -> Result<Checked<f64>, FrictionError> {
    if at.sliding.si() == 0.0 {
        return Ok(Checked::inside(0.0));
    }
    benedict_kelley::coefficient(&BenedictKelleyConditions {
        load: at.load,
        viscosity: at.viscosity,
        sliding: at.sliding,
        sum_speed: at.entrainment * 2.0,
        mean_ra: at.mean_ra,
    })
}

fn iso_part_1(
    _: &FrictionSettings,
    at: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    let mesh = &at.mesh;
    iso_14179_1::coefficient(
        at.kinematic_viscosity,
        mesh.load_intensity,
        mesh.pitch_line_speed,
    )
}

fn iso_part_2(
    _: &FrictionSettings,
    at: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    iso_14179_2::coefficient(&at.mesh, at.viscosity, at.mean_ra)
}

fn shared_by_heights(
    settings: &FrictionSettings,
    at: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    let fluid = fluid_coefficient(settings, at)?;
    let boundary = at.boundary_coefficient;
    let value = matsumoto::coefficient(at.minimum_film, at.sum_rz, fluid.value, boundary)?;
    Ok(fluid.map(|_| value))
}

fn shared_by_film_ratio(
    settings: &FrictionSettings,
    at: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    let fluid = fluid_coefficient(settings, at)?;
    let boundary = at.boundary_coefficient;
    let value = doleschel::coefficient(at.central_film, at.mean_ra, fluid.value, boundary)?;
    Ok(fluid.map(|_| value))
}

fn fluid_coefficient(
    settings: &FrictionSettings,
    at: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    match settings.fluid_coefficient {
        Some(value) => Ok(Checked::inside(value)),
        None => full_film(settings, at),
    }
}

fn full_film(
    settings: &FrictionSettings,
    at: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    eyring::coefficient(&EyringConditions {
        max_pressure: at.max_pressure,
        contact_viscosity: at.contact_viscosity,
        pressure_viscosity: at.pressure_viscosity,
        sliding: at.sliding,
        central_film: at.central_film,
        limiting_stress: settings.limiting_stress,
    })
}

fn constant(
    settings: &FrictionSettings,
    _: &FrictionConditions,
) -> Result<Checked<f64>, FrictionError> {
    let value = settings
        .constant
        .ok_or_else(|| FrictionError::missing_setting(FrictionLaw::Constant.name(), "constant"))?;
    let rule = "must be finite and not negative";
    let valid = value.is_finite() && value >= 0.0;
    let value = DomainError::require(valid, "constant friction coefficient", value, "-", rule)?;
    Ok(Checked::inside(value))
}
