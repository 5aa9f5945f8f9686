//! Viscosity, density and pressure-viscosity coefficient of one oil against temperature, from its data sheet.
//!
//! ```text
//! cargo run -p asperity-oil --example oil_from_data_sheet
//! ```

use asperity_core::quantity::Temperature;
use asperity_oil::{BaseOil, LubricantInput, ViscosityLaw};

/// Prints the properties of one oil at four temperatures.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let bulk: Temperature = "90 °C".parse()?;
    let oil = LubricantInput {
        viscosity: Some(ViscosityLaw::AstmD341 {
            at_40: "30.8 mm2/s".parse()?,
            at_100: "5.9 mm2/s".parse()?,
        }),
        density: Some("845 kg/m3".parse()?),
        base_oil: Some(BaseOil::Pao),
        ..LubricantInput::default()
    }
    .resolve(bulk)?;
    let mut before = f64::INFINITY;
    for celsius in [40.0, 60.0, 80.0, 100.0] {
        let state = oil.at(Temperature::from_celsius(celsius))?.value;
        println!(
            "{celsius:>5} °C  {:.4}  {:.4}  alpha {:.4}",
            state.dynamic_viscosity, state.density, state.pressure_viscosity
        );
        assert!(state.dynamic_viscosity.si() < before);
        before = state.dynamic_viscosity.si();
    }
    for assumption in oil.assumptions() {
        println!("assumed: {} ({})", assumption.key, assumption.source);
    }
    Ok(())
}
