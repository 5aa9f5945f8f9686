//! Time of a contact over a gap of raw 64-bit numbers in m, to compare callers in other languages with.
//!
//! `cargo run --release -p asperity-contact --example time_of_a_contact -- gap.f64 1e-7 115e9 2e5 11` prints the
//! shortest and the median time in s of eleven solutions, and the largest pressure in Pa.

#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]

use std::time::Instant;

use asperity_contact::{ContactProblem, SolverSettings, solve};
use asperity_core::quantity::{Length, LineLoad, Pressure};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, spacing, modulus, load, times] = arguments.as_slice() else {
        return Err("give file, spacing, modulus, load and the number of solutions".into());
    };
    let bytes = std::fs::read(file)?;
    let gap: Vec<f64> = bytes
        .chunks_exact(8)
        .map(|number| number.try_into().map(f64::from_le_bytes))
        .collect::<Result<_, _>>()?;
    let problem = ContactProblem::new(
        &gap,
        Length::from_si(spacing.parse()?),
        Pressure::from_si(modulus.parse()?),
        LineLoad::from_si(load.parse()?),
    );
    let (mut seconds, mut largest) = (Vec::new(), 0.0);
    for _ in 0..times.parse()? {
        let begin = Instant::now();
        let solution = solve(&problem, &SolverSettings::default())?;
        seconds.push(begin.elapsed().as_secs_f64());
        largest = solution.max_pressure.si();
    }
    seconds.sort_by(f64::total_cmp);
    let [shortest, median] = [0, seconds.len() / 2].map(|at| seconds.get(at));
    let (Some(shortest), Some(median)) = (shortest, median) else {
        return Err("no solution was asked for".into());
    };
    println!("{shortest} {median} {largest}");
    Ok(())
}
