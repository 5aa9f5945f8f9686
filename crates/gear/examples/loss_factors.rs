//! Path of contact and loss factors of a helical pair, from what stands on its drawing.
//!
//! `cargo run -p asperity-gear --example loss_factors`

use asperity_gear::{GearPair, GearPairInput, LoadSharing};

/// Prints the path of contact and the loss factors.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let pair = GearPair::new(&GearPairInput::standard(
        [23, 68],
        "1.8 mm".parse()?,
        "23.4 deg".parse()?,
        "32 mm".parse()?,
    ))?;
    let path = pair.path();
    println!("A to E {}", path.e - path.a);
    for place in [0.0, 0.25, 0.5, 0.75, 1.0] {
        let s = path.a + (path.e - path.a) * place;
        let motion = pair.kinematics(s, "9000 1/min".parse()?)?;
        let load = pair.line_load(s, "145 N m".parse()?, &LoadSharing::Uniform)?;
        println!(
            "{place:.2}  radius {:.4}  sliding {:.3}  load {:.4}",
            motion.radius, motion.sliding, load
        );
    }
    let factors = pair.loss_factors(&LoadSharing::Uniform)?;
    println!(
        "Ohlendorf {:.4}, local {:.4}",
        factors.ohlendorf, factors.local
    );
    Ok(())
}
