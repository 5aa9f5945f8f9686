//! The film laws a case file can name.
//!
//! | name | central | minimum |
//! |---|---|---|
//! | `steady` | steady solutions, as factors K(M, L) on Dowson–Toyoda | and K_m(M, L) on Dowson–Higginson |
//! | `dowson-toyoda` | Dowson–Toyoda | Dowson–Higginson |
//! | `moes` | Moes | Dowson–Higginson |
//! | `ertel-grubin` | Ertel–Grubin | Dowson–Higginson |
//! | `hamrock-dowson` | P14, k → ∞, W = F/(E′R²) | P13, k → ∞, W = F/(E′R²) |
//! | `hamrock-dowson-line` | P14, k → ∞, W = w/(E′R) | P13, k → ∞, W = w/(E′R) |
//!
//! Moes and Ertel–Grubin give one film thickness only. Their minimum is
//! Dowson–Higginson's own fit: an independent formula, not a ratio applied to the central film.

use asperity_core::quantity::{Force, Length};
use asperity_core::{Checked, DomainError};
use serde::{Deserialize, Serialize};

use crate::dimensionless::{FilmConditions, FilmGroups};
use crate::error::RegimeError;
use crate::steady_film::steady_film;
use crate::{film_elliptic, film_line};

/// Central and minimum thickness of the smooth film.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FilmThickness {
    /// Central film thickness h_c.
    pub central: Length,
    /// Minimum film thickness h_m.
    pub minimum: Length,
}

impl FilmThickness {
    /// Both thicknesses multiplied by a reduction factor.
    pub fn reduced(self, factor: f64) -> Self {
        Self {
            central: self.central * factor,
            minimum: self.minimum * factor,
        }
    }
}

/// Central and minimum film at one position.
type Film = fn(&FilmConditions) -> Result<Checked<FilmThickness>, RegimeError>;

/// Rows `Name "name in a case file", exponent X of the speed group U in the central film, film;`.
macro_rules! film_laws {
    ($($(#[$meta:meta])+ $law:ident $name:literal, $exponent:expr, $film:expr;)+) => {
        /// Law of the smooth isothermal film thickness.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        #[serde(deny_unknown_fields)]
        pub enum FilmLaw {
            $($(#[$meta])+ #[serde(rename = $name)] $law),+
        }

        const ROWS: &[(&str, f64, Film)] = &[$(($name, $exponent, $film)),+];

        impl FilmLaw {
            /// Every law, in the order of the table above.
            pub const ALL: &[Self] = &[$(Self::$law),+];
        }
    };
}

film_laws! {
    /// Line contact: this project's steady solutions, over the formulas of Dowson–Toyoda and Dowson–Higginson.
    #[default]
    Steady "steady", film_line::DOWSON_TOYODA.speed, steady;
    /// Line contact: Dowson–Toyoda central, Dowson–Higginson minimum film.
    DowsonToyoda "dowson-toyoda", film_line::DOWSON_TOYODA.speed, |at| line(film_line::dowson_toyoda, at);
    /// Line contact: Moes' four-regime central film, Dowson–Higginson minimum film.
    Moes "moes", MOES_EXPONENT, |at| line(film_line::moes, at);
    /// Line contact: Ertel–Grubin central film, Dowson–Higginson minimum film.
    ErtelGrubin "ertel-grubin", film_line::ERTEL_GRUBIN.speed, |at| line(film_line::ertel_grubin, at);
    /// The 2022 paper's: Hamrock–Dowson for k → ∞ with the load on the whole contact length,
    /// W = F/(E′R²).
    HamrockDowson "hamrock-dowson", film_elliptic::CENTRAL.speed, hamrock_dowson;
    /// Hamrock–Dowson for k → ∞ with the line load group W = w/(E′R).
    HamrockDowsonLine "hamrock-dowson-line", film_elliptic::CENTRAL.speed, |at| long_ellipse(&at.line_groups()?, at.radius);
}

/// Moes' form is not a power law; its elastic piezoviscous asymptote H_EP √U_Σ goes with U^(3/4): 1/16 from M^(−1/8),
/// 3/16 from L^(3/4) and 1/2.
const MOES_EXPONENT: f64 = 3.0 / 4.0;

impl FilmLaw {
    fn row(self) -> &'static (&'static str, f64, Film) {
        // The rows are in the order of the variants.
        &ROWS[self as usize]
    }

    /// The name in a case file.
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// The exponent X of the speed group U in the central film, which Λ* needs; of `steady` that of its formula, without the factor's.
    pub fn speed_exponent(self) -> f64 {
        self.row().1
    }

    /// The smooth isothermal film at one position.
    ///
    /// # Errors
    /// When a quantity is not finite and positive, or `hamrock-dowson` has no contact length.
    ///
    /// ```
    /// use asperity_ehl_regime::{FilmConditions, FilmLaw};
    /// let position = FilmConditions {
    ///     entrainment: "4.567909 m/s".parse()?, radius: "11.62688 mm".parse()?,
    ///     load: "113.409 N/mm".parse()?, modulus: "115.3846 GPa".parse()?,
    ///     viscosity: "97.5 mPa s".parse()?, pressure_viscosity: "20 1/GPa".parse()?,
    ///     contact_length: Some("50 mm".parse()?),
    /// };
    /// let paper = FilmLaw::HamrockDowson.film(&position)?;
    /// assert!((paper.value.central.si() - 1.366e-6).abs() < 1e-9);
    /// assert!(!paper.outside.is_empty(), "gear loads are outside the fitted range");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn film(self, position: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
        let (_, _, film) = self.row();
        film(position)
    }
}

/// `central` with Dowson and Higginson's minimum film.
fn line(
    central: fn(&FilmGroups, Length) -> Result<Length, RegimeError>,
    at: &FilmConditions,
) -> Result<Checked<FilmThickness>, RegimeError> {
    let groups = at.line_groups()?;
    Ok(Checked::inside(FilmThickness {
        central: central(&groups, at.radius)?,
        minimum: film_line::dowson_higginson(&groups, at.radius)?,
    }))
}

fn steady(at: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
    let [central, minimum] = steady_film(&at.line_groups()?, at.radius)?;
    Ok(Checked::inside(FilmThickness { central, minimum }))
}

fn hamrock_dowson(at: &FilmConditions) -> Result<Checked<FilmThickness>, RegimeError> {
    let length = at.contact_length.ok_or_else(|| {
        RegimeError::missing_input(FilmLaw::HamrockDowson.name(), "contact_length")
    })?;
    let load = DomainError::positive("line load", at.load)?;
    let length = DomainError::positive("contact length", length)?;
    let force = Force::from_si(load * length);
    long_ellipse(&at.force_groups(force)?, at.radius)
}

/// Hamrock and Dowson's films for k → ∞.
fn long_ellipse(
    groups: &FilmGroups,
    radius: Length,
) -> Result<Checked<FilmThickness>, RegimeError> {
    let minimum = film_elliptic::hamrock_dowson_minimum(groups, radius, f64::INFINITY)?.value;
    let central = film_elliptic::hamrock_dowson_central(groups, radius, f64::INFINITY)?;
    Ok(central.map(|central| FilmThickness { central, minimum }))
}
