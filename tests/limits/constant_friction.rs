//! With one coefficient everywhere the sliding loss is the loss factor times the power.

use asperity::result::Summary;
use asperity_tests::{CaseText, assert_close, constant, table_2};

/// Sums over all points of a load map, and of equal loads over Gauss points.
const ROUNDING: f64 = 1e-12;

fn with_constant(case: CaseText, mu: f64) -> CaseText {
    case.with("model.film_friction", constant(mu))
}

fn spur() -> CaseText {
    table_2().with("gears.helix", "0 deg")
}

fn summary(case: &CaseText) -> Summary {
    case.run().result.summary
}

#[test]
fn a_spur_pair_with_equal_shares_loses_mu_times_the_loss_factor() {
    for mu in [0.001, 0.05, 0.3] {
        let summary = summary(&with_constant(spur(), mu));
        // Ohlendorf's closed form: the pitch point lies in single contact.
        let expected = mu * summary.loss_factor_ohlendorf * summary.power_in_w;
        assert_close("sliding", summary.sliding_w, expected, ROUNDING);
        assert_close(
            "H_V",
            summary.loss_factor_local,
            summary.loss_factor_ohlendorf,
            ROUNDING,
        );
        let eta = 1.0 - mu * summary.loss_factor_ohlendorf - summary.rolling_w / summary.power_in_w;
        assert_close("efficiency", summary.efficiency, eta, ROUNDING);
    }
}

#[test]
fn every_load_distribution_loses_mu_times_its_own_loss_factor() {
    for sharing in [
        "elastic",
        "iso-stiffness",
        "uniform",
        "trapezoid",
        "min-potential",
    ] {
        let case = with_constant(spur(), 0.05).with("model.load_distribution", sharing);
        let summary = summary(&case);
        let expected = 0.05 * summary.loss_factor_local * summary.power_in_w;
        assert_close(sharing, summary.sliding_w, expected, ROUNDING);
    }
}

#[test]
fn a_helical_pair_loses_mu_times_its_local_loss_factor() {
    let summary = summary(&with_constant(table_2(), 0.05));
    let expected = 0.05 * summary.loss_factor_local * summary.power_in_w;
    assert_close("sliding", summary.sliding_w, expected, ROUNDING);
}

#[test]
fn the_equivalent_coefficient_of_a_mesh_that_only_slides_is_its_coefficient() {
    // Rolling goes with the pressure-viscosity product and the viscosity; a thin oil leaves little.
    let case = with_constant(spur(), 0.05).with("lubricant.viscosity.dynamic_viscosity", "2 mPa s");
    let summary = summary(&case);
    let rolling = summary.rolling_w / (summary.loss_factor_local * summary.power_in_w);
    assert_close("mu_eq", summary.mu_equivalent - rolling, 0.05, 1e-12);
    assert!(rolling < 0.002);
}

#[test]
fn without_any_friction_only_rolling_is_lost() {
    let summary = summary(&with_constant(table_2(), 0.0));
    assert_eq!(summary.sliding_w, 0.0);
    assert_close("loss", summary.loss_w, summary.rolling_w, ROUNDING);
}

#[test]
fn a_wheel_that_drives_loses_the_same_and_gives_out_less() {
    let forward = summary(&table_2());
    let backward = summary(&table_2().with("operation.torque", "-285 N m"));
    assert_eq!(backward.sliding_w, forward.sliding_w);
    assert_eq!(backward.rolling_w, forward.rolling_w);
    // The torque known at the pinion is now the one that comes out.
    assert_close("torque out", backward.torque_out_nm, 285.0, ROUNDING);
    let power_in = forward.power_in_w + backward.loss_w;
    assert_close("power in", backward.power_in_w, power_in, ROUNDING);
    assert!(backward.efficiency < 1.0 && backward.efficiency > forward.efficiency);
}
