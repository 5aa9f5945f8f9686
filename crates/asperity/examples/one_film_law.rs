//! One film law alone: the central film of a cylinder against speed.
//!
//! ```text
//! cargo run -p asperity --example one_film_law
//! ```

use asperity::ehl_regime::{FilmConditions, FilmLaw};
use asperity::quantity::Speed;

/// Prints film thicknesses of several laws.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    println!("{:>8} {:>12} {:>12}", "m/s", "central um", "minimum um");
    let mut before = 0.0;
    for speed in [1.0, 2.0, 5.0, 10.0, 20.0] {
        let film = FilmLaw::DowsonToyoda.film(&FilmConditions {
            entrainment: Speed::from_si(speed),
            radius: "11.6 mm".parse()?,
            load: "113 N/mm".parse()?,
            modulus: "115.4 GPa".parse()?,
            viscosity: "10 mPa s".parse()?,
            pressure_viscosity: "15 1/GPa".parse()?,
            contact_length: None,
        })?;
        let [central, minimum] = [film.value.central, film.value.minimum].map(|h| 1e6 * h.si());
        println!("{speed:>8} {central:>12.4} {minimum:>12.4}");
        assert!(minimum < central && before < central);
        before = central;
    }
    Ok(())
}
