//! A smooth cylinder on a flat: the solver against Hertz, and the stress below.
//!
//! ```text
//! cargo run -p asperity-contact --example hertz_cylinder
//! ```

use asperity_contact::hertz_line::{self, HertzLine};
use asperity_contact::subsurface::{graded_depths, subsurface_stress};
use asperity_contact::{Boundary, ContactProblem, Control, SolverSettings, solve};
use asperity_core::quantity::{Length, LineLoad, Pressure};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let (radius, modulus): (Length, Pressure) = ("3 mm".parse()?, "115.385 GPa".parse()?);
    let load: LineLoad = "300 N/mm".parse()?;
    let (points, window) = (2000, Length::from_si(600e-6));
    let spacing = window / points as f64;
    let gap: Vec<f64> = (0..points)
        .map(|i| {
            let x = (i as f64 + 0.5) * spacing.si() - 0.5 * window.si();
            x * x / (2.0 * radius.si())
        })
        .collect();
    let problem = ContactProblem {
        gap: &gap,
        spacing,
        modulus,
        boundary: Boundary::FreeEnds,
        control: Control::Load(load),
        lead: None,
        prescribed_pressure: None,
        pressure_limit: None,
        start: None,
    };
    let solution = solve(&problem, &SolverSettings::default())?;
    let hertz = HertzLine::new(load, radius, modulus)?;
    let approach = hertz_line::approach(load, radius, modulus, solution.datum)?;
    let table = [
        (
            "p_max in GPa  ",
            1e-9 * solution.max_pressure.si(),
            1e-9 * hertz.max_pressure.si(),
        ),
        (
            "approach in um",
            1e6 * solution.approach.si(),
            1e6 * approach.si(),
        ),
    ];
    for (name, solved, exact) in table {
        println!("{name}  solved {solved:.8}  Hertz {exact:.8}");
    }
    let certificate = solution.certificate;
    println!(
        "{} iterations, duality gap {:.1e}, penetration {:.1e}, load error {:.1e}",
        solution.iterations,
        certificate.duality_gap,
        certificate.penetration,
        certificate.load_error
    );

    let depths = graded_depths(spacing, hertz.half_width, 80)?;
    let stress = subsurface_stress(&solution.pressure, None, spacing, &depths)?;
    if let Some(peak) = stress.peak(&stress.max_shear()) {
        let (share, depth) = (
            peak.value / hertz.max_pressure,
            peak.depth / hertz.half_width,
        );
        println!("largest shear {share:.4} p0 at {depth:.3} b (0.3003 at 0.786)");
    }
    Ok(())
}
