//! The pressure difference across a film against its thickness, by two models.
//!
//! ```text
//! cargo run -p asperity-ns-film --example across_the_film
//! ```

use asperity_ns_film::{FilmConditions, FluidModel, pressure_difference_over_thickness};

/// Prints the pressure across one film.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let film = FilmConditions {
        wall_1: "4.57 m/s".parse()?,
        wall_2: "4.57 m/s".parse()?,
        radius_1: "14.54 mm".parse()?,
        radius_2: "34.896 mm".parse()?,
        film_thickness: "100 nm".parse()?,
        angle: "0 deg".parse()?,
        base_radius: "34.56 mm".parse()?,
        middle_speed: None,
        viscosity: "97.5 mPa s".parse()?,
        density: "998 kg/m3".parse()?,
    };
    let thicknesses = [1e-7, 1e-6, 1e-5];
    for model in [FluidModel::ReynoldsCross, FluidModel::Paper] {
        let found = pressure_difference_over_thickness(model, &film, &thicknesses)?;
        for (h, difference) in thicknesses.iter().zip(&found) {
            println!("{model:?}: {:.1} um  {difference:.3e} Pa", 1e6 * h);
            assert!(difference.is_finite());
        }
    }
    Ok(())
}
