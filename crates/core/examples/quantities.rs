//! Quantities as text with a unit, in SI inside.
//!
//! ```text
//! cargo run -p asperity-core --example quantities
//! ```

use asperity_core::quantity::{Length, LineLoad, Temperature};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let radius: Length = "9.5 mm".parse()?;
    let load: LineLoad = "300 N/mm".parse()?;
    let bulk: Temperature = "90 °C".parse()?;
    println!("radius {radius} = {} m", radius.si());
    println!("load {load} = {} N/m", load.si());
    println!("bulk temperature {bulk} = {} K", bulk.si());
    Ok(())
}
