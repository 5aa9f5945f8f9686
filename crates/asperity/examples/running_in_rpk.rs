//! Two rough flanks run in: energy, contact, Rq and Rpk of every cycle until shakedown.
//!
//! ```text
//! cargo run -p asperity --example running_in_rpk
//! ```

use asperity_contact::SolverSettings;
use asperity_contact::running_in::{Cycle, RunningIn};
use asperity_contact::two_flanks::TwoFlanks;
use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::material_ratio::rk_parameters;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points = 1200;
    let flank = |phase: f64| {
        let wave = |i: usize, k: f64| (phase * k * k + k * i as f64 / 40.0).sin() / k.powf(1.3);
        let heights = (0..points)
            .map(|i| (1..=15).map(|k| 0.25e-6 * wave(i, f64::from(k))).sum())
            .collect();
        Profile::new(Length::from_si(0.5e-6), heights)
    };
    let (pinion, wheel) = (flank(1.7)?, flank(2.9)?);
    let flanks = TwoFlanks {
        first: &pinion,
        second: &wheel,
        radius: "3 mm".parse()?,
        load: "300 N/mm".parse()?,
        modulus: "115.4 GPa".parse()?,
        pressure_limit: Some("2.5 GPa".parse()?),
    };
    println!("cycle  energy J/m   largest flow nm  contact   Rq nm          Rpk nm");
    let mut number = 0;
    let report = |cycle: &Cycle, flanks: &[Profile; 2]| {
        number += 1;
        let nanometres = |length: Length| 1e9 * length.si();
        let [rpk_1, rpk_2] = flanks.each_ref().map(|flank| {
            rk_parameters(flank.heights()).map_or(f64::NAN, |found| nanometres(found.rpk))
        });
        let [rq_1, rq_2] = cycle.rq.map(nanometres);
        println!(
            "{number:>5}  {:.4e}   {:>10.4}       {:.4}   {rq_1:.2} {rq_2:.2}  {rpk_1:.2} {rpk_2:.2}",
            cycle.dissipated.si(),
            nanometres(cycle.largest_flow),
            cycle.contact_fraction,
        );
    };
    RunningIn::evenly(points, 6).run_watched(&flanks, &SolverSettings::default(), report)?;
    Ok(())
}
