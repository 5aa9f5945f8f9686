//! A rough cylinder on a smooth one, from a measured profile: one height in micrometres per line.
//!
//! ```text
//! cargo run -p asperity-contact --example rough_cylinder -- profile.txt 0.5
//! ```
//!
//! Without a file, a profile is made up. The second argument is the spacing in micrometres; the
//! fields are written to the file that the third one names.

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use std::fs::File;
use std::io::BufWriter;

use asperity_contact::SolverSettings;
use asperity_contact::two_flanks::TwoFlanks;
use asperity_core::Profile;
use asperity_core::quantity::Length;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let heights: Vec<f64> = match arguments.next() {
        Some(path) => std::fs::read_to_string(path)?
            .lines()
            .map(|line| line.trim().parse::<f64>().map(|um| 1e-6 * um))
            .collect::<Result<_, _>>()?,
        None => made_up(),
    };
    let spacing: f64 = arguments.next().as_deref().unwrap_or("0.5").parse()?;
    let rough = Profile::new(Length::from_si(1e-6 * spacing), heights)?;
    let smooth = Profile::new(rough.spacing(), vec![0.0; rough.len()])?;
    let flanks = TwoFlanks {
        first: &rough,
        second: &smooth,
        radius: "8 mm".parse()?,
        load: "200 N/mm".parse()?,
        modulus: "115.4 GPa".parse()?,
        pressure_limit: Some("2 GPa".parse()?),
    };
    let solution = flanks.press(&SolverSettings::default())?;
    println!("contact fraction {:.3}", solution.contact_fraction);
    println!(
        "largest pressure {:.4} GPa",
        1e-9 * solution.max_pressure.si()
    );
    println!("energy dissipated {:.4e} J/m", solution.dissipated.si());
    if let Some(path) = arguments.next() {
        solution.write_csv(&mut BufWriter::new(File::create(path)?))?;
    }
    Ok(())
}

/// Grinding marks of 4 to 40 µm.
fn made_up() -> Vec<f64> {
    let wave = |i: usize, k: f64| (k * k * 17.0 + k * i as f64 / 80.0).sin() / k.powf(1.2);
    let height = |i| (1..=10).map(|k| 0.3e-6 * wave(i, f64::from(k))).sum();
    (0..1600).map(height).collect()
}
