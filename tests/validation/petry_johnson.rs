//! Spur gears of Petry-Johnson et al., Journal of Mechanical Design 130 (2008) 062601: against an
//! independent evaluation of the same equations, and beside the measured losses.

use std::fmt::Write;

use asperity::result::Summary;
use asperity_tests::petry_johnson;

use crate::comparison::{Comparison, Table};

/// Speed 1/min; sliding and rolling loss W evaluated independently in Python (trapezoid sharing,
/// Xu's friction, rolling on both surfaces with Gupta's reduction); measured loss W, from and to.
///
/// The measured interval is not read from the paper: it follows from relative errors of other models
/// against the measurement that a later thesis prints.
const SPEEDS: [(u32, f64, f64, [f64; 2]); 5] = [
    (2000, 110.061_651, 17.415_251, [165.8, 174.1]),
    (4000, 205.296_763, 50.442_010, [285.7, 320.3]),
    (6000, 295.636_740, 90.310_632, [456.3, 499.0]),
    (8000, 382.937_748, 132.934_255, [605.7, 633.3]),
    (10_000, 468.046_441, 176.016_115, [471.5, 639.8]),
];

fn at(speed: u32) -> Summary {
    let case = petry_johnson().with("operation.speed", format!("{speed} 1/min"));
    case.run().result.summary
}

pub fn losses() -> Table {
    // E, β_T and k are not printed; those found to give the rolling losses leave this deviation.
    const INPUTS: f64 = 2e-4;
    let mut rows = Vec::new();
    for (speed, sliding, rolling, _) in SPEEDS {
        let ours = at(speed);
        let mut push = |kind, expected, actual| {
            let quantity = format!("{kind} loss at {speed} 1/min");
            rows.push(Comparison::new(quantity, "W", expected, actual, INPUTS));
        };
        push("sliding", sliding, ours.sliding_w);
        push("rolling", rolling, ours.rolling_w);
        push("total", sliding + rolling, ours.loss_w);
    }
    Table {
        name: "petry-johnson",
        test: "spur_gears_lose_what_was_computed_elsewhere",
        rows,
    }
}

#[test]
fn spur_gears_lose_what_was_computed_elsewhere() {
    losses().hold();
}

pub fn beside_measured() -> String {
    let mut text = String::from(
        "| speed 1/min | P_in kW | measured loss W | here W | measured η % | here η % |\n\
         |---|---|---|---|---|---|\n",
    );
    for (speed, _, _, [low, high]) in SPEEDS {
        let ours = at(speed);
        let efficiency = |loss: f64| 100.0 * (1.0 - loss / ours.power_in_w);
        let _ = writeln!(
            text,
            "| {speed} | {:.1} | {low:.0} .. {high:.0} | {:.0} | {:.3} .. {:.3} | {:.3} |",
            ours.power_in_w * 1e-3,
            ours.loss_w,
            efficiency(high),
            efficiency(low),
            100.0 * ours.efficiency,
        );
    }
    text.push_str("\nTest: `spur_gears_come_within_a_third_of_the_measured_loss`.\n");
    text
}

#[test]
fn spur_gears_come_within_a_third_of_the_measured_loss() {
    for (speed, _, _, [low, high]) in SPEEDS {
        let ours = at(speed);
        // The sliding of asperities is left out, since no peak heights are published: too little is
        // expected. A third of the loss is 0.06 % of the power.
        assert!(
            0.67 * low < ours.loss_w && ours.loss_w < 1.33 * high,
            "{speed} 1/min: {} W, measured {low} to {high} W",
            ours.loss_w
        );
    }
}
