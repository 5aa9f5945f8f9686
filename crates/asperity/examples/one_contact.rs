//! One rough contact alone: a wavy cylinder on a plane, solved with a certificate.
//!
//! ```text
//! cargo run -p asperity --example one_contact
//! ```

use asperity::contact::{Boundary, ContactProblem, Control, SolverSettings, solve};

/// Prints one rough contact.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Radius 3 mm, waves of 50 nm; gap in metres at points 0.6 µm apart.
    let gap: Vec<f64> = (0..1000)
        .map(|i| {
            let x = 0.6e-6 * (f64::from(i) - 499.5);
            x * x / 6e-3 - 50e-9 * (x / 3e-6).cos()
        })
        .collect();
    let problem = ContactProblem {
        gap: &gap,
        spacing: "0.6 um".parse()?,
        modulus: "115.4 GPa".parse()?,
        boundary: Boundary::FreeEnds,
        control: Control::Load("300 N/mm".parse()?),
        lead: None,
        prescribed_pressure: None,
        pressure_limit: Some("4 GPa".parse()?),
        start: None,
    };
    let found = solve(&problem, &SolverSettings::default())?;
    println!(
        "{:.4} of the window in contact, p_max {:.4}, duality gap {:.1e}",
        found.contact_fraction, found.max_pressure, found.certificate.duality_gap
    );
    assert!(found.certificate.duality_gap <= 1e-8);
    Ok(())
}
