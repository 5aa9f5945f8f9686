//! Cam and flat follower: the film over a turn, one steady contact after the other.
//!
//! ```text
//! cargo run --release -p asperity-ehl --example lubricated_cam
//! ```
//!
//! An eccentric circular cam of 15 mm radius and 5 mm eccentricity under a follower with a spring. The
//! contact moves along the follower, so the film is entrained at the mean of the speeds of both surfaces
//! relative to the contact.

use asperity_core::quantity::{LineLoad, Speed};
use asperity_ehl::{LineContact, Oil, SteadySettings, steady};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};

/// Radius of the cam, eccentricity \[m\].
const CAM: (f64, f64) = (15e-3, 5e-3);
/// Rotational speed \[rad/s\].
const SPIN: f64 = 150.0;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let oil = Oil {
        viscosity: "10 mPa s".parse()?,
        pressure_viscosity: "18 1/GPa".parse()?,
        viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
        density_law: DensityLaw::DowsonHigginson,
        shear_law: ShearLaw::Newtonian,
    };
    println!("angle  load N/mm  entrainment m/s      h_c        h_min   Newton");
    for step in 0..12 {
        let turn = 30.0 * f64::from(step);
        let angle = f64::to_radians(turn);
        let (radius, eccentric) = CAM;
        let lift = eccentric * (1.0 - angle.cos());
        // Seen from the contact the cam turns about its own centre, and the follower slides back.
        let (cam_speed, follower_speed) = (SPIN * radius, SPIN * eccentric * angle.cos());
        let contact = LineContact {
            radius: "15 mm".parse()?,
            modulus: "115.4 GPa".parse()?,
            load: LineLoad::from_si(20e3 + 8e6 * lift),
            speed_1: Speed::from_si(cam_speed),
            speed_2: Speed::from_si(follower_speed),
        };
        match steady::solve(&contact, &oil, &SteadySettings::default()) {
            Ok(film) => println!(
                "{turn:5.0}  {:9.1}  {:15.3}  {:>11.4}  {:>11.4}  {:4}",
                1e-3 * contact.load.si(),
                0.5 * (cam_speed + follower_speed),
                film.value.central_film,
                film.value.minimum_film,
                film.evidence.newton_iterations
            ),
            Err(error) => println!("{turn:5.0}  {error}"),
        }
    }
    Ok(())
}
