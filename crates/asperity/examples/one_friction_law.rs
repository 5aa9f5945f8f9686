//! One friction law alone: Xu's coefficient against the slide-to-roll ratio, with what left its fitted range.
//!
//! ```text
//! cargo run -p asperity --example one_friction_law
//! ```

use asperity::tribo_friction::xu::{XuConditions, XuLaw};

/// Prints one friction coefficient.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    for slide_to_roll in [0.05, 0.1, 0.2, 0.5, 1.0] {
        let found = XuLaw::default().coefficient(&XuConditions {
            slide_to_roll,
            max_pressure: "1 GPa".parse()?,
            viscosity: "10 mPa s".parse()?,
            entrainment: "10 m/s".parse()?,
            radius: "10 mm".parse()?,
            combined_roughness: "0.1 um".parse()?,
        })?;
        println!("SRR {slide_to_roll:.2}  mu {:.5}", found.value);
        assert!(found.value > 0.0 && found.value < 0.1);
        for outside in &found.outside {
            println!("  {outside}");
        }
    }
    Ok(())
}
