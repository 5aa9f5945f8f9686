//! Reference table of smooth films over Moes' numbers, by extrapolation on graded grids.
//!
//! ```text
//! cargo run --release -p asperity-ehl --features oracle --example smooth_table [doublings]
//! ```
//!
//! Laws: IV isoviscous, BI Barus and RC Roelands z = 0.6 with α = 20 1/GPa, the last one compressible. Rows
//! whose Hertz pressure is outside 0.05 to 3.4 GPa, or α·p₀ above 14 for Barus, are left out. Films are in
//! the units of Moes' diagram, with estimates of their errors.

use std::f64::consts::{PI, TAU};

use asperity_core::quantity::{DynamicViscosity, Length, Pressure, PressureViscosity, Speed};
use asperity_ehl::{LineContact, Oil, graded};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};

/// α of every oil \[1/Pa\].
const ALPHA: f64 = 2e-8;

fn case(m: f64, l: f64, law: &str) -> Result<(LineContact, Oil), Box<dyn std::error::Error>> {
    let (radius, modulus, speed) = (10e-3, 115.4e9, 1.0);
    let exponent = if l > 0.0 { l * (m / TAU).sqrt() } else { 10.0 };
    let p_0 = exponent / ALPHA;
    let load = PI * radius * p_0 * p_0 / modulus;
    let group = (load / (2.0 * modulus * radius) / m).powi(2);
    let (viscosity_law, density_law) = match law {
        "IV" => (PressureViscosityLaw::Isoviscous, DensityLaw::Incompressible),
        "BI" => (PressureViscosityLaw::Barus, DensityLaw::Incompressible),
        _ => (
            PressureViscosityLaw::Roelands { exponent: 0.6 },
            DensityLaw::DowsonHigginson,
        ),
    };
    let oil = Oil {
        viscosity: DynamicViscosity::from_si(group * modulus * radius / speed),
        pressure_viscosity: PressureViscosity::from_si(ALPHA),
        viscosity_law,
        density_law,
        shear_law: ShearLaw::Newtonian,
    };
    let contact = LineContact::at_pressure(
        Length::from_si(radius),
        Pressure::from_si(modulus),
        Pressure::from_si(p_0),
        Speed::from_si(speed),
        0.0,
    )?;
    Ok((contact, oil))
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let doublings = std::env::args().nth(1).map_or(Ok(2), |text| text.parse())?;
    println!("law,M,L,Hc,Hmin,flux,Hc_error,Hmin_error,x_hmin,x_exit,P_spike,newton");
    let loads = [
        0.05, 0.2, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0,
    ];
    for l in [0.0, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0, 30.0] {
        for m in loads {
            let exponent = l * (m / TAU).sqrt();
            let laws: &[&str] = if l == 0.0 { &["IV"] } else { &["BI", "RC"] };
            for law in laws {
                let p_0 = exponent / ALPHA;
                let left_out = match *law {
                    "IV" => false,
                    "BI" => exponent > 14.0 || m < 1.0,
                    _ => !(0.05e9..3.4e9).contains(&p_0) || m < 1.0,
                };
                if left_out {
                    continue;
                }
                let (contact, oil) = case(m, l, law)?;
                match graded::reference(&contact, &oil, None, 160, doublings) {
                    Ok(solved) => {
                        let film = solved.value;
                        println!(
                            "{law},{m},{l},{:.6},{:.6},{:.6},{:.1e},{:.1e},{:.5},{:.5},{:.4},{}",
                            film.central.value,
                            film.minimum.value,
                            film.flux.value,
                            film.central.error,
                            film.minimum.error,
                            film.finest.minimum_place,
                            film.finest.exit,
                            film.finest.spike.map_or(f64::NAN, |spike| spike.0),
                            solved.evidence.newton_iterations,
                        );
                    }
                    Err(error) => println!("{law},{m},{l},{error}"),
                }
            }
        }
    }
    Ok(())
}
