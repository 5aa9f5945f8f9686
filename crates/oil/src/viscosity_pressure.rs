//! Viscosity over pressure at a fixed temperature.
//!
//! Barus' exponential is right in slope at zero pressure and far too steep beyond about half a
//! gigapascal; Roelands' form bends it over. Both have the same slope α at zero pressure.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | η₀ | viscosity at ambient pressure | Pa s |
//! | α | pressure-viscosity coefficient, d(ln η)/dp at p = 0 | 1/Pa |
//! | p | pressure | Pa |
//! | Z | Roelands' exponent | - |

use asperity_core::checked::{Checked, FittedRange};
use asperity_core::error::DomainError;
use asperity_core::quantity::{DynamicViscosity, Pressure, PressureViscosity};

/// Roelands' constant 1/p_r = 5.1·10⁻⁹ 1/Pa (Roelands 1966).
const ROELANDS_PER_PASCAL: f64 = 5.1e-9;
/// Roelands' constant −ln η_r with η_r = 6.31·10⁻⁵ Pa s (Roelands 1966).
const ROELANDS_LOG: f64 = 9.67;
/// Range in which Barus' law has no serious error (Stachowiak and Batchelor 2014).
const BARUS_RANGE: FittedRange = FittedRange {
    name: "pressure",
    low: 0.0,
    high: 0.5,
    unit: "GPa",
    correlation: "Barus",
};
const PASCAL_PER_GPA: f64 = 1e9;

/// η(p) = η₀·exp(α·p)                                                        [Barus-1]
///
/// Pressures above 0.5 GPa are noted: there the law overrates the viscosity by decades.
///
/// # Errors
/// When the viscosity or α is not positive, the pressure is negative, or η(p) is not finite.
///
/// ```
/// use asperity_oil::barus;
/// let eta = barus("97.5 mPa s".parse()?, "2e-8 1/Pa".parse()?, "0.6 GPa".parse()?)?;
/// assert!((eta.value.si() - 15_868.592).abs() < 1e-3 && eta.outside.len() == 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn barus(
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
    pressure: Pressure,
) -> Result<Checked<DynamicViscosity>, DomainError> {
    asperity_core::cite!("Barus-1");
    let eta0 = DomainError::positive("viscosity", viscosity)?;
    let alpha = DomainError::positive("pressure-viscosity coefficient", pressure_viscosity)?;
    let p = DomainError::non_negative("pressure", pressure)?;
    let mut outside = Vec::new();
    BARUS_RANGE.check(p / PASCAL_PER_GPA, &mut outside);
    Ok(Checked {
        value: finite(eta0 * (alpha * p).exp(), p)?,
        outside,
    })
}

/// Z = α/(5.1·10⁻⁹·(ln η₀ + 9.67))                                           [Roelands-1]
///
/// # Errors
/// When α is not positive, or the viscosity is not above 6.31·10⁻⁵ Pa s, where the form ends.
///
/// ```
/// use asperity_oil::roelands_exponent;
/// let z = roelands_exponent("97.5 mPa s".parse()?, "2e-8 1/Pa".parse()?)?;
/// assert!((z - 0.5341210521410198).abs() < 1e-14);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn roelands_exponent(
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
) -> Result<f64, DomainError> {
    asperity_core::cite!("Roelands-1");
    let alpha = DomainError::positive("pressure-viscosity coefficient", pressure_viscosity)?;
    Ok(alpha / (ROELANDS_PER_PASCAL * roelands_log(viscosity)?))
}

/// η(p) = η₀·exp((ln η₀ + 9.67)·((1 + 5.1·10⁻⁹·p)^Z − 1))                      [Roelands-2]
///
/// # Errors
/// When α is not positive, the pressure is negative, the viscosity is not above
/// 6.31·10⁻⁵ Pa s, or η(p) is not finite.
///
/// ```
/// use asperity_oil::roelands;
/// let eta = roelands("97.5 mPa s".parse()?, "2e-8 1/Pa".parse()?, "0.6 GPa".parse()?)?;
/// assert!((eta.si() - 346.676).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn roelands(
    viscosity: DynamicViscosity,
    pressure_viscosity: PressureViscosity,
    pressure: Pressure,
) -> Result<DynamicViscosity, DomainError> {
    asperity_core::cite!("Roelands-2");
    let p = DomainError::non_negative("pressure", pressure)?;
    let z = roelands_exponent(viscosity, pressure_viscosity)?;
    // (1 + x)^Z − 1 through ln_1p and exp_m1: no digit is lost at small pressures.
    let growth = (z * (ROELANDS_PER_PASCAL * p).ln_1p()).exp_m1();
    finite(
        viscosity.si() * (roelands_log(viscosity)? * growth).exp(),
        p,
    )
}

/// ln η₀ + 9.67, which must be positive.
fn roelands_log(viscosity: DynamicViscosity) -> Result<f64, DomainError> {
    let eta0 = DomainError::positive("viscosity", viscosity)?;
    let log = eta0.ln() + ROELANDS_LOG;
    DomainError::require(
        log > 0.0,
        "viscosity",
        eta0,
        "Pa s",
        "must be above 6.31e-5 Pa s for Roelands' law",
    )?;
    Ok(log)
}

fn finite(viscosity: f64, pressure: f64) -> Result<DynamicViscosity, DomainError> {
    DomainError::require(
        viscosity.is_finite(),
        "pressure",
        pressure,
        "Pa",
        "is too high for a finite viscosity",
    )?;
    Ok(DynamicViscosity::from_si(viscosity))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ETA0: DynamicViscosity = DynamicViscosity::from_si(0.0975);
    const ALPHA: PressureViscosity = PressureViscosity::from_si(2e-8);

    #[test]
    fn roelands_and_barus_hit_the_reference_case() {
        // The paper's oil at 0.6 GPa, recomputed independently in double precision.
        let p = Pressure::from_si(0.6e9);
        let r = roelands(ETA0, ALPHA, p).unwrap().si();
        assert!((r / 346.676_116_367_33 - 1.0).abs() < 1e-12);
        let b = barus(ETA0, ALPHA, p).unwrap().value.si();
        assert!((b / 15_868.592_163_352_881 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn both_laws_start_with_the_slope_alpha() {
        // A second-order term of (α p)² or less remains of the relative slope.
        let p = Pressure::from_si(1e3);
        for eta in [
            roelands(ETA0, ALPHA, p).unwrap(),
            barus(ETA0, ALPHA, p).unwrap().value,
        ] {
            let slope = (eta.si() / ETA0.si()).ln() / p.si();
            assert!((slope / ALPHA.si() - 1.0).abs() < 1e-5);
        }
        let none = Pressure::from_si(0.0);
        assert_eq!(roelands(ETA0, ALPHA, none).unwrap(), ETA0);
        assert_eq!(barus(ETA0, ALPHA, none).unwrap().value, ETA0);
    }

    #[test]
    fn runaway_viscosities_and_nonsense_are_errors() {
        assert!(barus(ETA0, ALPHA, Pressure::from_si(1e12)).is_err());
        assert!(roelands(ETA0, ALPHA, Pressure::from_si(-1.0)).is_err());
        assert!(roelands_exponent(DynamicViscosity::from_si(5e-5), ALPHA).is_err());
        assert!(
            barus(
                ETA0,
                PressureViscosity::from_si(f64::NAN),
                Pressure::from_si(1.0)
            )
            .is_err()
        );
    }
}
