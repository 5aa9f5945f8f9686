//! The film of a line contact, and the classical film ratio of two rough flanks.
//!
//! ```text
//! cargo run -p asperity-ehl-regime --example film_and_regime
//! ```

use asperity_core::quantity::{Length, Speed};
use asperity_ehl_regime::{FilmConditions, FilmLaw};

/// Prints film thickness and regime of one contact.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let rq: Length = "0.4 um".parse()?;
    for speed in [1.0, 4.0, 16.0] {
        let conditions = FilmConditions {
            entrainment: Speed::from_si(speed),
            radius: "11.6 mm".parse()?,
            load: "113 N/mm".parse()?,
            modulus: "115.4 GPa".parse()?,
            viscosity: "10 mPa s".parse()?,
            pressure_viscosity: "15 1/GPa".parse()?,
            contact_length: Some("50 mm".parse()?),
        };
        for law in [FilmLaw::DowsonToyoda, FilmLaw::HamrockDowson] {
            let film = law.film(&conditions)?;
            println!(
                "{speed:>4} m/s  {:.4} central, {:.4} minimum, {:.2} times Rq, {} notes",
                film.value.central,
                film.value.minimum,
                film.value.minimum / rq,
                film.outside.len()
            );
            assert!(film.value.minimum < film.value.central);
        }
    }
    Ok(())
}
