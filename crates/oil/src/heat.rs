//! Thermal conductivity and specific heat capacity of oils, estimated when not given.
//!
//! Cragoe's formulas for petroleum products (1929), from density and temperature only: within
//! about 10 % for the conductivity and 4 % for the heat capacity of liquid petroleum products
//! between 0 °C and 200 °C. Synthetic oils conduct up to a fifth better.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | d | density at 15.6 °C relative to water | - |
//! | t | temperature | °C |

use asperity_core::quantity::{Density, SpecificHeat, Temperature, ThermalConductivity};
use asperity_core::{Checked, DomainError, FittedRange, OutOfRange, cite};

/// Density of water at 15.6 °C \[kg/m³\].
const WATER: f64 = 999.0;
/// Range of temperature of one of his formulas.
const fn range(correlation: &'static str) -> FittedRange {
    FittedRange::new("temperature", 0.0, 200.0, "°C", correlation)
}

/// k = 0.1172/d·(1 − 0.00054·t)  W/(m K)                                     [Cragoe-1]
///
/// # Errors
/// When the density or the temperature is not positive.
///
/// ```
/// use asperity_oil::cragoe_conductivity;
/// let k = cragoe_conductivity("880 kg/m3".parse()?, "60 °C".parse()?)?;
/// assert!((k.value.si() - 0.1287).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn cragoe_conductivity(
    density_15: Density,
    temperature: Temperature,
) -> Result<Checked<ThermalConductivity>, DomainError> {
    cite!("Cragoe-1");
    /// Cragoe's 0.813 BTU in/(h ft² °F) \[W/(m K)\].
    const SCALE: f64 = 0.1172;
    /// Cragoe's 0.0003 1/°F \[1/K\].
    const FALL: f64 = 0.00054;
    let range = range("Cragoe's thermal conductivity");
    let (d, t, outside) = gravity_and_celsius(density_15, temperature, range)?;
    Ok(Checked {
        value: ThermalConductivity::from_si(SCALE / d * (1.0 - FALL * t)),
        outside,
    })
}

/// c = (1685 + 3.39·t)/√d  J/(kg K)                                          [Cragoe-2]
///
/// # Errors
/// When the density or the temperature is not positive.
///
/// ```
/// use asperity_oil::cragoe_heat_capacity;
/// let c = cragoe_heat_capacity("880 kg/m3".parse()?, "60 °C".parse()?)?;
/// assert!((c.value.si() - 2012.0).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn cragoe_heat_capacity(
    density_15: Density,
    temperature: Temperature,
) -> Result<Checked<SpecificHeat>, DomainError> {
    cite!("Cragoe-2");
    /// Cragoe's 0.388 + 0.00045·32 BTU/(lb °F) \[J/(kg K)\].
    const SCALE: f64 = 1685.0;
    /// Cragoe's 0.00045 BTU/(lb °F²) [J/(kg K²)].
    const RISE: f64 = 3.39;
    let range = range("Cragoe's heat capacity");
    let (d, t, outside) = gravity_and_celsius(density_15, temperature, range)?;
    Ok(Checked {
        value: SpecificHeat::from_si((SCALE + RISE * t) / d.sqrt()),
        outside,
    })
}

fn gravity_and_celsius(
    density_15: Density,
    temperature: Temperature,
    range: FittedRange,
) -> Result<(f64, f64, Vec<OutOfRange>), DomainError> {
    let d = DomainError::positive("density at 15 °C", density_15)? / WATER;
    DomainError::positive("temperature", temperature)?;
    let t = temperature.celsius();
    let mut outside = Vec::new();
    range.check(t, &mut outside);
    Ok((d, t, outside))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heat_properties_agree_with_cragoe_in_his_own_units() {
        // d = 0.9 at 100 °F: c = (0.388 + 0.00045·100)/√0.9 BTU/(lb °F), k = 0.813/0.9·(1 − 0.0003·68)
        // BTU in/(h ft² °F), converted with 4186.8 J/(kg K) and 0.144228 W/(m K).
        let density = Density::from_si(0.9 * 999.0);
        let t = Temperature::from_celsius(68.0 / 1.8);
        let c = cragoe_heat_capacity(density, t).unwrap().value.si();
        let k = cragoe_conductivity(density, t).unwrap().value.si();
        // The constants are rounded to three or four digits.
        assert!((c / (0.433 / 0.9f64.sqrt() * 4186.8) - 1.0).abs() < 5e-4);
        assert!((k / (0.813 / 0.9 * (1.0 - 0.0204) * 0.144_228) - 1.0).abs() < 1e-3);
        assert_eq!(
            cragoe_conductivity(density, Temperature::from_si(500.0))
                .unwrap()
                .outside
                .len(),
            1
        );
    }
}
