//! Parameters of two synthetic flanks and of their composite profile.

use std::error::Error;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::Parameters;
use asperity_roughness::composite::{Pairing, combined_rq, compose};
use asperity_roughness::generate::SelfAffine;
use asperity_roughness::height_parameters::Mode;
use asperity_roughness::preparation::{Preparation, prepare};

fn main() -> Result<(), Box<dyn Error>> {
    let pinion = flank(1, "0.4 um")?;
    let wheel = flank(2, "0.3 um")?;
    let rq = |name: &str, profile: &Profile| -> Result<Length, Box<dyn Error>> {
        let found = Parameters::from_profile(profile, Mode::Iso4287, "0.25 mm".parse()?)?;
        let (heights, material) = (&found.heights, &found.material);
        println!(
            "{name:<10} Ra {:.3}  Rq {:.3}  Rz {:.3}  Rk {:.3}  Rpk {:.3}",
            heights.ra, heights.rq, heights.rz, material.rk, material.rpk
        );
        Ok(heights.rq)
    };
    let (first, second) = (rq("pinion", &pinion)?, rq("wheel", &wheel)?);
    let composite = compose(&pinion, &wheel, Pairing::default())?;
    let of_both = rq("composite", &composite.profile)?;
    println!(
        "composite Rq {of_both:.3}, {:.3} expected of uncorrelated flanks",
        combined_rq(first, second)?
    );
    Ok(())
}

/// A ground flank with its form removed and filtered.
fn flank(seed: u64, rq: &str) -> Result<Profile, Box<dyn Error>> {
    let recipe = SelfAffine {
        points: 12_000,
        spacing: "0.5 um".parse()?,
        rq: rq.parse()?,
        hurst: 0.8,
        roll_off: "80 um".parse()?,
        short_cut: "3 um".parse()?,
        seed,
    };
    let preparation = Preparation {
        lambda_c: Some("0.25 mm".parse()?),
        ..Preparation::default()
    };
    Ok(prepare(&recipe.generate()?, &preparation)?.profile)
}
