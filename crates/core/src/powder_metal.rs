//! Sintered steel: modulus, Poisson's ratio, strength and conductivity from the density.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ρ, ρ₀ | density, and that without pores | kg/m³ |
//! | P = 1 − ρ/ρ₀ | porosity, the pores' share of the volume | - |
//! | E, ν | Young's modulus, Poisson's ratio | Pa, - |
//! | σ | strength in tension | Pa |
//! | k, k₀ | thermal conductivity, and that without pores | W/(m K) |

use crate::checked::{Checked, FittedRange, Treatment};
use crate::error::DomainError;
use crate::quantity::{Density, Pressure, ThermalConductivity};

/// Density of gear steel without pores: Table 2 of the 2022 paper.
pub const PORE_FREE: Density = Density::from_si(7830.0);

/// Porosity below which Poisson's ratio was fitted.
const MOST_POROSITY: f64 = 0.2;

/// Densities of the rows that modulus and strength were fitted to \[kg/m³\].
const FITTED: FittedRange = FittedRange::new(
    "density",
    6700.0,
    7400.0,
    "kg/m3",
    "modulus and strength of sintered steel from its density (MPIF Standard 35)",
);

/// P = 1 − ρ/ρ₀.
///
/// # Errors
/// When the density is not above 80 % and below 100 % of that without pores.
pub fn porosity(density: Density) -> Result<f64, DomainError> {
    let porosity = 1.0 - density.si() / PORE_FREE.si();
    DomainError::require(
        porosity > 0.0 && porosity < MOST_POROSITY,
        "density",
        density.si(),
        "kg/m3",
        "must lie between 6264 and 7830 kg/m3 for a sintered steel; steel without pores has a name of its own",
    )?;
    Ok(porosity)
}

/// E = 206.74 GPa·(ρ/7830 kg/m³)^3.390                                                `[Sinter-1]`
///
/// Least squares through the logarithms of the 13 rows of the standard, which are rounded to 5 GPa: none is off by
/// more than 2 GPa.
///
/// # Errors
/// As [`porosity`].
///
/// ```
/// let modulus = asperity_core::powder_metal::young("7.1 g/cm3".parse()?)?.value;
/// assert!((modulus.si() - 150e9).abs() < 2.5e9);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn young(density: Density) -> Result<Checked<Pressure>, DomainError> {
    crate::cite!("Sinter-1");
    let relative = 1.0 - porosity(density)?;
    let mut outside = Vec::new();
    FITTED.check_as(Treatment::SinteredSteel, density.si(), &mut outside);
    Ok(Checked {
        value: Pressure::from_si(206.74e9 * relative.powf(3.390)),
        outside,
    })
}

/// ν = 0.300 − 0.266·P + 0.579·P²                                                     `[Sinter-2]`
///
/// For Fe-4Ni-1.5Cu-0.5Mo with 0.8 % carbon, sintered at 1423 K and heat-treated, porosity below 20 %.
///
/// # Errors
/// As [`porosity`].
pub fn poisson(density: Density) -> Result<f64, DomainError> {
    crate::cite!("Sinter-2");
    let porosity = porosity(density)?;
    Ok(0.300 - 0.266 * porosity + 0.579 * porosity * porosity)
}

/// σ = 724 MPa·(ρ/6750 kg/m³)^5.241                                                   `[Sinter-3]`
///
/// The power through both ends of the range of hardened FD-0205, whose yield strength is taken as the strength.
///
/// # Errors
/// As [`porosity`].
pub fn strength(density: Density) -> Result<Checked<Pressure>, DomainError> {
    crate::cite!("Sinter-3");
    porosity(density)?;
    let mut outside = Vec::new();
    FITTED.check_as(Treatment::SinteredSteel, density.si(), &mut outside);
    Ok(Checked {
        value: Pressure::from_si(724e6 * (density.si() / 6750.0).powf(5.241)),
        outside,
    })
}

/// k = k₀·(1 − P)/(1 + P/2)                                                           `[Sinter-4]`
///
/// Exact for separate spheres; no isotropic body with this porosity conducts better.
///
/// # Errors
/// As [`porosity`].
pub fn conductivity(
    pore_free: ThermalConductivity,
    density: Density,
) -> Result<ThermalConductivity, DomainError> {
    crate::cite!("Sinter-4");
    let porosity = porosity(density)?;
    Ok(pore_free * ((1.0 - porosity) / (1.0 + 0.5 * porosity)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(grams: f64) -> Density {
        Density::from_si(1000.0 * grams)
    }

    #[test]
    fn the_modulus_is_that_of_every_row_of_the_standard() {
        // FD-0208-55, -60, -65; FD-0405-55, -60, -65, -100HT, -130HT; FD-0408-50, -55, -60, -65.
        let rows = [
            (6.90, 135.0),
            (7.10, 150.0),
            (7.25, 160.0),
            (6.75, 125.0),
            (7.05, 145.0),
            (7.35, 165.0),
            (6.75, 125.0),
            (7.05, 145.0),
            (6.70, 120.0),
            (6.95, 140.0),
            (7.20, 155.0),
            (7.40, 170.0),
        ];
        for (density, expected) in rows {
            let computed = young(of(density)).unwrap();
            // The standard prints multiples of 5 GPa.
            let off = computed.value.si() / 1e9 - expected;
            assert!(off.abs() <= 2.5, "{density}: {off}");
            assert!(computed.outside.is_empty());
        }
        // Without pores what steel has.
        let whole = young(of(7.829)).unwrap();
        assert!((whole.value.si() / 1e9 - 206.7).abs() < 0.3);
        assert_eq!(whole.outside.len(), 1);
        assert!(young(of(7.83)).is_err() && young(of(6.2)).is_err());
        assert!(young(Density::from_si(f64::NAN)).is_err());
    }

    #[test]
    fn poissons_ratio_falls_with_the_first_pores() {
        // The abstract's own numbers at a tenth of pores.
        let tenth = Density::from_si(0.9 * PORE_FREE.si());
        assert!((poisson(tenth).unwrap() - 0.27919).abs() < 1e-12);
        assert!((poisson(of(7.8299)).unwrap() - 0.300).abs() < 1e-4);
    }

    #[test]
    fn the_strength_is_that_of_both_ends_of_the_standard() {
        // 105 and 170 thousand psi of 6.894757 kPa.
        for (density, ksi) in [(6.75, 105.0), (7.4, 170.0)] {
            let computed = strength(of(density)).unwrap();
            assert!((computed.value.si() / (ksi * 6.894757e6) - 1.0).abs() < 1e-3);
            assert!(computed.outside.is_empty());
        }
        // FD-0405-130HT, another steel of the standard: 970 MPa at 7.05 g/cm3.
        let other = strength(of(7.05)).unwrap().value.si();
        assert!((other / 970e6 - 1.0).abs() < 0.1, "{other}");
    }

    #[test]
    fn the_conductivity_is_that_of_maxwell_and_below_the_mixture() {
        let k0 = ThermalConductivity::from_si(45.0);
        for p in [0.01, 0.05, 0.1, 0.19] {
            let computed = conductivity(k0, PORE_FREE * (1.0 - p)).unwrap().si();
            // Maxwell's formula for spheres of conductivity zero in a body of k₀.
            let (body, pore) = (45.0, 0.0);
            let maxwell = body * (2.0 * body + pore - 2.0 * p * (body - pore))
                / (2.0 * body + pore + p * (body - pore));
            assert!((computed / maxwell - 1.0).abs() < 1e-12);
            assert!(computed < 45.0 * (1.0 - p));
            // Few spheres take away one and a half times their volume.
            assert!((computed - 45.0 * (1.0 - 1.5 * p)).abs() < 45.0 * 0.8 * p * p);
        }
    }
}
