//! The pressure-viscosity coefficient: an estimate from the family of the base oil, and a check for wrong units.
//!
//! Gold and others (2001) correlate α, taken between ambient pressure and 0.2 GPa, with the
//! kinematic viscosity. The constants are those that Fernandes, Martins and Seabra (2013) use for
//! fully formulated gear oils of ISO VG 320 with four kinds of base oil, between about 40 °C and
//! 110 °C; that span of viscosity is the fitted range here.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | α | pressure-viscosity coefficient | 1/Pa |
//! | ν | kinematic viscosity in mm²/s | - |
//! | s, t | constants of the base oil | 1/GPa, - |

use asperity_core::quantity::{KinematicViscosity, PressureViscosity};
use asperity_core::{Checked, DomainError, FittedRange, cite};

use crate::{BaseOil, LubricantError};

const MM2_PER_M2: f64 = 1e6;
const PASCAL_PER_GPA: f64 = 1e9;
/// Viscosities of the gear oils that the constants were used for (Fernandes and others 2013).
const GOLD_RANGE: FittedRange =
    FittedRange::new("kinematic viscosity", 15.0, 350.0, "mm2/s", GOLD_FIT);
/// Name of Gold's law as a correlation.
pub const GOLD_FIT: &str = "Gold's pressure-viscosity fit";
/// Lowest plausible α \[1/Pa\]. Own choice: lubricants lie between about 5 and 50 1/GPa, and the
/// window leaves a factor of two on either side.
pub const LOWEST_PLAUSIBLE: PressureViscosity = PressureViscosity::from_si(2e-9);
/// Highest plausible α \[1/Pa\]; see [`LOWEST_PLAUSIBLE`].
pub const HIGHEST_PLAUSIBLE: PressureViscosity = PressureViscosity::from_si(1e-7);
/// Wrong units, as powers of ten: mm²/N for m²/N, 1/GPa for 1/Pa, and a factor thousand.
const UNIT_SLIPS: [i32; 6] = [6, -6, 9, -9, 3, -3];

/// α = s·ν^t 1/GPa, ν in mm²/s                                                [Gold-1]
///
/// | base oil | s | t |
/// |---|---|---|
/// | mineral, naphthenic | 9.904 | 0.1390 |
/// | group III (assumed) | 8.5 | 0.1360 |
/// | polyalphaolefin | 7.382 | 0.1335 |
/// | ester | 6.605 | 0.1360 |
/// | polyalkylene glycol | 5.489 | 0.1485 |
///
/// A viscosity outside 15 to 350 mm²/s is noted.
///
/// # Errors
/// When the viscosity is not positive.
///
/// ```
/// use asperity_oil::{BaseOil, gold_pressure_viscosity};
/// let alpha = gold_pressure_viscosity(BaseOil::Mineral, "100 mm2/s".parse()?)?;
/// assert!((alpha.value.si() - 18.78e-9).abs() < 0.01e-9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn gold_pressure_viscosity(
    base_oil: BaseOil,
    viscosity: KinematicViscosity,
) -> Result<Checked<PressureViscosity>, DomainError> {
    cite!("Gold-1");
    let nu = DomainError::positive("kinematic viscosity", viscosity)? * MM2_PER_M2;
    let [s, t] = base_oil.gold_constants();
    let mut outside = Vec::new();
    GOLD_RANGE.check(nu, &mut outside);
    Ok(Checked {
        value: PressureViscosity::from_si(s * nu.powf(t) / PASCAL_PER_GPA),
        outside,
    })
}

/// The coefficient itself if it is plausible.
///
/// # Errors
/// When it is not positive, or outside 2·10⁻⁹ to 10⁻⁷ 1/Pa; the error names the wrong unit
/// that explains the number.
///
/// ```
/// use asperity_oil::plausible_pressure_viscosity;
/// let error = plausible_pressure_viscosity("2e-8 mm2/N".parse()?).unwrap_err();
/// assert_eq!(error.to_string(), "alpha = 2e-14 m2/N is 10^6 below any oil. Did you mean 2e-8 m2/N?");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn plausible_pressure_viscosity(
    coefficient: PressureViscosity,
) -> Result<PressureViscosity, LubricantError> {
    let alpha = DomainError::positive("pressure-viscosity coefficient", coefficient)?;
    let plausible = |value: f64| (LOWEST_PLAUSIBLE.si()..=HIGHEST_PLAUSIBLE.si()).contains(&value);
    if plausible(alpha) {
        return Ok(coefficient);
    }
    Err(LubricantError::ImplausiblePressureViscosity {
        value: alpha,
        low: LOWEST_PLAUSIBLE.si(),
        high: HIGHEST_PLAUSIBLE.si(),
        shift: UNIT_SLIPS
            .into_iter()
            .find(|&shift| plausible(alpha * 10f64.powi(shift))),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mineral_oil_is_stiffer_under_pressure_than_synthetic_oil() {
        let nu = KinematicViscosity::from_si(100e-6);
        let alpha = |oil| gold_pressure_viscosity(oil, nu).unwrap().value.si() * 1e9;
        // s·100^t worked out by hand from the table of constants.
        for (oil, expected) in [
            (BaseOil::Mineral, 18.785),
            (BaseOil::Pao, 13.652),
            (BaseOil::Ester, 12.356),
            (BaseOil::Polyglycol, 10.877),
        ] {
            assert!((alpha(oil) - expected).abs() < 1e-3, "{}", alpha(oil));
        }
        let thin = KinematicViscosity::from_si(6e-6);
        let noted = gold_pressure_viscosity(BaseOil::Pao, thin).unwrap();
        assert_eq!(noted.outside.len(), 1);
    }

    #[test]
    fn a_slip_of_the_unit_of_alpha_is_caught() {
        let check = |v| plausible_pressure_viscosity(PressureViscosity::from_si(v));
        assert!(check(2e-8).is_ok() && check(9.68e-9).is_ok());
        for (value, expected) in [
            (2e-14, Some(6)),
            (20.0, Some(-9)),
            (2e-11, Some(3)),
            (1.0, None),
        ] {
            let Err(LubricantError::ImplausiblePressureViscosity { shift, .. }) = check(value)
            else {
                panic!("{value} passed");
            };
            assert_eq!(shift, expected, "{value}");
        }
        assert!(check(f64::NAN).is_err() && check(0.0).is_err());
    }
}
