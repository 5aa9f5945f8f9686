//! Balance: power that goes in comes out or is lost.

use asperity::result::MeshOutcome;
use proptest::prelude::*;

use crate::cases::{config, drawn};

/// Differences of powers some thousand times the losses.
const ROUNDING: f64 = 1e-12;

/// Power that comes out \[W\].
fn power_out(outcome: &MeshOutcome, speed: f64) -> f64 {
    let ratio = outcome.result.gears.ratio;
    outcome.result.summary.torque_out_nm * speed * std::f64::consts::TAU / 60.0 / ratio
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn what_goes_in_comes_out_or_is_lost(drawn in drawn()) {
        let outcome = drawn.case().run();
        let summary = &outcome.result.summary;
        let lost = summary.power_in_w - power_out(&outcome, drawn.speed);
        let parts = summary.sliding_w
            + summary.rolling_w
            + summary.deformation_w.iter().sum::<f64>();
        prop_assert!((lost - parts).abs() <= ROUNDING * summary.power_in_w, "{lost} W, {parts} W");
        prop_assert!((summary.loss_w - parts).abs() <= ROUNDING * parts);
    }

    #[test]
    fn every_loss_is_a_loss(drawn in drawn()) {
        let outcome = drawn.case().run();
        let summary = &outcome.result.summary;
        prop_assert!(summary.sliding_w > 0.0 && summary.rolling_w > 0.0);
        prop_assert!(summary.efficiency > 0.0 && summary.efficiency < 1.0);
        for row in &outcome.result.path {
            prop_assert!(row.mu > 0.0 && row.sliding_w_per_m >= 0.0 && row.rolling_w_per_m > 0.0);
            prop_assert!((0.0..=1.0).contains(&row.film_share));
        }
    }

    #[test]
    fn the_rows_of_the_path_add_up_to_the_summary(drawn in drawn()) {
        let outcome = drawn.case().run();
        let summary = &outcome.result.summary;
        let sum = |of: fn(&asperity::result::PositionRow) -> f64| -> f64 {
            outcome.result.path.iter().map(|row| row.weight_m * of(row)).sum()
        };
        let (sliding, rolling) = (sum(|row| row.sliding_w_per_m), sum(|row| row.rolling_w_per_m));
        prop_assert!((sliding / summary.sliding_w - 1.0).abs() < ROUNDING);
        prop_assert!((rolling / summary.rolling_w - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn the_pairs_in_contact_carry_the_tooth_force(drawn in drawn()) {
        let result = drawn.case().run().result;
        let force = result.gears.forces(result.inputs.operation.torque).unwrap().normal_base.si();
        let carried: f64 = result
            .path
            .iter()
            .map(|row| row.weight_m * row.line_load_n_per_mm * 1e3)
            .sum();
        prop_assert!((carried / force - 1.0).abs() < ROUNDING);
    }

    #[test]
    fn the_wheel_drives_with_the_same_losses(drawn in drawn()) {
        let forward = drawn.case().run().result.summary;
        let torque = format!("{} N m", -drawn.torque);
        let backward = drawn.case().with("operation.torque", torque).run().result.summary;
        prop_assert_eq!(forward.loss_w, backward.loss_w);
        // The same loss from a power greater by it.
        let expected = 1.0 / (2.0 - forward.efficiency);
        prop_assert!((backward.efficiency - expected).abs() < ROUNDING);
    }
}
