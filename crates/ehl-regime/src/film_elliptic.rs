//! Smooth isothermal film thickness of an elliptical contact, and its limit for a line.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | R_x, R_y | relative radius of curvature along and across the motion | m |
//! | k | ellipticity of the contact, across over along | - |
//! | G, U | groups of [`dimensionless`](crate::dimensionless), with R = R_x | - |
//! | W | F/(E′ R_x²), F the total force in N | - |
//! | h_c, h_m | central and minimum film thickness | m |
//!
//! Source: B. J. Hamrock and D. Dowson, ASME J. Lubr. Technol. 99 (1977) 264, flooded contacts.
//! Range of their 34 cases, as it is usually quoted: 1 ≤ k ≤ 8, U 8.4·10⁻¹³ to 5.05·10⁻¹¹,
//! W 1.1·10⁻⁷ to 1.3·10⁻⁶, G 2310 to 6785. Gear contacts lie far outside in W and k: with k → ∞
//! the formulas give films 23 to 30 % below the line formulas, which is why they are not the default.
//!
//! The line limit k → ∞ has two definitions of the load group: W = F/(E′R²) with the force F on the whole
//! face width (the 2022 paper's), and the line group W = w/(E′R). Both are offered by
//! [`FilmLaw`](crate::FilmLaw).

use asperity_core::quantity::Length;
use asperity_core::{Checked, DomainError, FittedRange, OutOfRange, cite};

use crate::dimensionless::FilmGroups;
use crate::error::RegimeError;
use crate::film_line::{PowerLaw, checked};

/// Hamrock and Dowson 1977, central film, without the ellipticity bracket.
pub(crate) const CENTRAL: PowerLaw = PowerLaw {
    factor: 2.69,
    speed: 0.67,
    material: 0.53,
    load: -0.067,
};

/// Hamrock and Dowson 1977, minimum film, without the ellipticity bracket.
pub(crate) const MINIMUM: PowerLaw = PowerLaw {
    factor: 3.63,
    speed: 0.68,
    material: 0.49,
    load: -0.073,
};

/// Factor and exponent of k = 1.03 (R_y/R_x)^(2/π).
const ELLIPTICITY: (f64, f64) = (1.03, 2.0 / std::f64::consts::PI);
/// Decay of the minimum film's bracket with k.
const MINIMUM_DECAY: f64 = 0.68;
/// Factor and decay of the central film's bracket with k.
const CENTRAL_BRACKET: (f64, f64) = (0.61, 0.73);

const NAME: &str = "Hamrock-Dowson";

/// Ranges of Hamrock and Dowson's 34 cases: k, U, W, G.
const RANGES: [FittedRange; 4] = [
    range("ellipticity k", 1.0, 8.0),
    range("speed group U", 8.4e-13, 5.05e-11),
    range("load group W", 1.1e-7, 1.3e-6),
    range("material group G", 2310.0, 6785.0),
];

const fn range(name: &'static str, low: f64, high: f64) -> FittedRange {
    FittedRange::new(name, low, high, "-", NAME)
}

fn notes(groups: &FilmGroups, ellipticity: f64) -> Vec<OutOfRange> {
    let mut outside = Vec::new();
    let values = [ellipticity, groups.speed, groups.load, groups.material];
    for (range, value) in RANGES.iter().zip(values) {
        // A line contact, k = ∞, is a limit of the formula and not outside its range.
        if value.is_finite() {
            range.check(value, &mut outside);
        }
    }
    outside
}

fn ellipticity_in_domain(k: f64) -> Result<f64, DomainError> {
    DomainError::require(
        k > 0.0,
        "ellipticity k",
        k,
        "-",
        "must be greater than zero; infinite for a line contact",
    )
}

/// Ellipticity of a contact from its radii.
///
/// ```text
/// k = 1.03 (R_y/R_x)^(2/π)                                                [Ellipticity]
/// ```
///
/// `radius_ratio` is R_y/R_x; infinite for a line contact, which gives k = ∞.
///
/// # Errors
/// When the ratio is not greater than zero.
///
/// ```
/// use asperity_ehl_regime::film_elliptic::ellipticity;
/// assert!((ellipticity(10.0)? - 4.461254).abs() < 1e-6);
/// assert_eq!(ellipticity(f64::INFINITY)?, f64::INFINITY);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn ellipticity(radius_ratio: f64) -> Result<f64, RegimeError> {
    cite!("Ellipticity");
    let ratio = DomainError::require(
        radius_ratio > 0.0,
        "radius ratio Ry/Rx",
        radius_ratio,
        "-",
        "must be greater than zero; infinite for a line contact",
    )?;
    Ok(ELLIPTICITY.0 * ratio.powf(ELLIPTICITY.1))
}

/// Minimum film of an elliptical contact by Hamrock and Dowson.
///
/// ```text
/// h_m = 3.63 U^0.68 G^0.49 W^−0.073 (1 − e^(−0.68 k)) R_x                         [P13]
/// ```
///
/// # Errors
/// When a group, the radius or k is not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_elliptic::hamrock_dowson_minimum};
/// let groups = FilmGroups { material: 4000.0, speed: 1e-11, load: 1e-6 };
/// let line = hamrock_dowson_minimum(&groups, Length::from_si(0.01), f64::INFINITY)?;
/// let round = hamrock_dowson_minimum(&groups, Length::from_si(0.01), 1.0)?;
/// assert!((round.value.si() / line.value.si() - (1.0 - (-0.68f64).exp())).abs() < 1e-12);
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn hamrock_dowson_minimum(
    groups: &FilmGroups,
    radius: Length,
    ellipticity: f64,
) -> Result<Checked<Length>, RegimeError> {
    cite!("P13");
    checked(groups)?;
    let k = ellipticity_in_domain(ellipticity)?;
    Ok(Checked {
        value: MINIMUM.film(groups, radius)? * (1.0 - (-MINIMUM_DECAY * k).exp()),
        outside: notes(groups, k),
    })
}

/// Central film of an elliptical contact by Hamrock and Dowson.
///
/// ```text
/// h_c = 2.69 U^0.67 G^0.53 W^−0.067 (1 − 0.61 e^(−0.73 k)) R_x                    [P14]
/// ```
///
/// # Errors
/// When a group, the radius or k is not positive.
///
/// ```
/// use asperity_core::quantity::Length;
/// use asperity_ehl_regime::{FilmGroups, film_elliptic::hamrock_dowson_central};
/// let groups = FilmGroups { material: 4000.0, speed: 1e-11, load: 1e-6 };
/// let film = hamrock_dowson_central(&groups, Length::from_si(0.01), 1.03)?;
/// assert!(film.outside.is_empty());
/// # Ok::<(), asperity_ehl_regime::RegimeError>(())
/// ```
pub fn hamrock_dowson_central(
    groups: &FilmGroups,
    radius: Length,
    ellipticity: f64,
) -> Result<Checked<Length>, RegimeError> {
    cite!("P14");
    checked(groups)?;
    let k = ellipticity_in_domain(ellipticity)?;
    let (factor, decay) = CENTRAL_BRACKET;
    Ok(Checked {
        value: CENTRAL.film(groups, radius)? * (1.0 - factor * (-decay * k).exp()),
        outside: notes(groups, k),
    })
}
