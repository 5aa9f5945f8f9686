//! Two rough flanks run in: energy, contact and roughness of every cycle until shakedown.
//!
//! ```text
//! cargo run -p asperity-contact --example running_in
//! ```

use asperity_contact::SolverSettings;
use asperity_contact::running_in::RunningIn;
use asperity_contact::two_flanks::TwoFlanks;
use asperity_core::Profile;
use asperity_core::quantity::Length;

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
    let ran_in = RunningIn::evenly(points, 6)?.run(&flanks, &SolverSettings::default())?;
    println!("cycle  energy J/m   largest flow nm  contact  Rq1 nm  Rq2 nm");
    for (number, cycle) in ran_in.cycles.iter().enumerate() {
        println!(
            "{:>5}  {:.4e}   {:>10.4}       {:.4}   {:.2}  {:.2}",
            number + 1,
            cycle.dissipated.si(),
            1e9 * cycle.largest_flow.si(),
            cycle.contact_fraction,
            1e9 * cycle.rq[0].si(),
            1e9 * cycle.rq[1].si(),
        );
    }
    Ok(())
}
