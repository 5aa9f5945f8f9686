//! The interval of a loss that is proportional to one constant, by even draws of it.
//!
//! ```sh
//! cargo run -p asperity-uncertainty --example interval_of_a_friction_loss
//! ```

use asperity_core::Estimate;
use asperity_core::numerics::standard_normal_quantile;
use asperity_uncertainty::{Quantiles, Ranged, UncertainParameter, latin_hypercube};

fn main() {
    let friction = Ranged {
        kind: UncertainParameter::BoundaryFriction,
        estimate: Estimate::new(0.09, [0.066, 0.123]),
        measured: None,
        lays: None,
    };
    let draws = latin_hypercube(4096, 1, 1);
    let losses: Vec<f64> = draws
        .iter()
        .map(|place| {
            600.0 * friction.at(standard_normal_quantile(place[0])) / friction.estimate.value
        })
        .collect();
    let found = Quantiles::from_draws(&losses);
    let Estimate { value, low, high } = found.drawn;
    println!("{value:.0} W ({low:.0}..{high:.0})");
}
