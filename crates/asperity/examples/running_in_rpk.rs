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
use asperity_roughness::generate::SelfAffine;
use asperity_roughness::material_ratio::rk_parameters;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let points = 1200;
    // Ground flanks of other seeds.
    let flank = |seed| {
        SelfAffine {
            points,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(0.2e-6),
            hurst: 0.8,
            roll_off: Length::from_si(100e-6),
            short_cut: Length::from_si(5e-6),
            seed,
        }
        .generate()
    };
    let (pinion, wheel) = (flank(1)?, flank(2)?);
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
    RunningIn::evenly(points, 6)?.run_watched(&flanks, &SolverSettings::default(), report)?;
    Ok(())
}
