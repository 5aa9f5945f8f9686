//! A cam with a crowned and slightly wavy nose on a flat follower, over a turn of its load: any gap
//! function will do.
//!
//! ```text
//! cargo run -p asperity-contact --example cam
//! ```

use asperity_contact::{Boundary, ContactProblem, Control, Path, SolverSettings};
use asperity_core::quantity::{Length, LineLoad};

/// Gap of nose and follower in m at x in m: radius 12 mm, flatter by a fourth power, waves of 20 µm.
fn gap(x: f64) -> f64 {
    let form = x * x / (2.0 * 12e-3) - 3e2 * x.powi(4);
    form + 50e-9 * (std::f64::consts::TAU * x / 20e-6).cos()
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points = 3000;
    let spacing = Length::from_si(1e-3 / points as f64);
    let gap: Vec<f64> = (0..points)
        .map(|i| gap((i as f64 + 0.5) * spacing.si() - 0.5e-3))
        .collect();
    let problem = |load| -> Result<ContactProblem, Box<dyn std::error::Error>> {
        Ok(ContactProblem {
            gap: &gap,
            spacing,
            modulus: "115.4 GPa".parse()?,
            boundary: Boundary::FreeEnds,
            control: Control::Load(load),
            lead: None,
            prescribed_pressure: None,
            pressure_limit: None,
            start: None,
        })
    };
    let settings = SolverSettings::default();
    let mut path = Path::new(points, Boundary::FreeEnds, settings)?;
    println!("load N/mm  p_max GPa  approach um  contact  iterations");
    for step in 1..=10 {
        let load = LineLoad::from_si(4e4 * f64::from(step));
        let solution = path.step(&problem(load)?)?;
        println!(
            "{:>9}  {:>9.4}  {:>11.4}  {:>7.4}  {:>10}",
            1e-3 * load.si(),
            1e-9 * solution.max_pressure.si(),
            1e6 * solution.approach.si(),
            solution.contact_fraction,
            solution.iterations
        );
    }
    Ok(())
}
