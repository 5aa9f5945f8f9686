//! Smooth gear contact: film, pressure spike, rolling force, on finer and finer grids.
//!
//! ```text
//! cargo run --release -p asperity-ehl --example smooth_line_contact
//! ```

use std::time::Instant;

use asperity_ehl::{LineContact, Oil, SteadySettings, Window, steady};
use asperity_oil::{DensityLaw, PressureViscosityLaw, ShearLaw};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let oil = Oil {
        viscosity: "10 mPa s".parse()?,
        pressure_viscosity: "18 1/GPa".parse()?,
        viscosity_law: PressureViscosityLaw::Roelands { exponent: 0.6 },
        density_law: DensityLaw::DowsonHigginson,
        shear_law: ShearLaw::Newtonian,
    };
    let contact = LineContact::at_pressure(
        "10 mm".parse()?,
        "115.4 GPa".parse()?,
        "1.2 GPa".parse()?,
        "5 m/s".parse()?,
        0.0,
    )?;
    println!("  cells  h_c Moes  h_min Moes  spike P at X      rolling N/m  Newton  GMRES      ms");
    for cells in [128, 256, 512, 1024, 2048] {
        let settings = SteadySettings {
            cells,
            window: Some(Window::ROUGH),
        };
        let film = steady::solve(&contact, &oil, &settings)?;
        let best = (0..20)
            .map(|_| {
                let start = Instant::now();
                let solved = steady::solve(&contact, &oil, &settings).is_ok();
                (solved, start.elapsed().as_secs_f64())
            })
            .fold(f64::INFINITY, |best, (_, time)| best.min(time));
        let value = &film.value;
        let (spike, place) = value.spike.unwrap_or_default();
        let moes = |h: asperity_core::quantity::Length| {
            value
                .scales
                .moes_film(h.si() * contact.radius.si() / value.scales.half_width.si().powi(2))
        };
        println!(
            "{cells:7}  {:8.5}  {:10.5}  {spike:.3} at {place:.4}  {:11.2}  {:6}  {:5}  {:6.2}",
            moes(value.central_film),
            moes(value.minimum_film),
            value.rolling_force.si(),
            film.evidence.newton_iterations,
            film.evidence.gmres_iterations,
            1e3 * best,
        );
    }
    Ok(())
}
