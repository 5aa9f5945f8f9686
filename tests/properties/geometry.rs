//! Width, size and overlap of a pair.

use asperity::result::RunResult;
use asperity_tests::CaseText;
use proptest::prelude::*;

use crate::cases::{config, drawn};

const ROUNDING: f64 = 1e-12;

/// The result of a case; none where its friction would melt the flanks, which a run refuses by E308 alone.
fn sensible(case: &CaseText) -> Option<RunResult> {
    match asperity::Run::new(&case.load()).execute() {
        Ok(outcome) => Some(outcome.into_only().unwrap().result),
        Err(error) if error.code() == "E308" => None,
        Err(error) => panic!("{error}"),
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn the_mean_contact_length_is_width_times_contact_ratio(drawn in drawn()) {
        let result = drawn.case().run().result;
        let gears = &result.gears;
        let length: f64 = result.path.iter().map(|row| row.weight_m).sum();
        let expected = gears.face_width.si() * gears.path().eps_alpha / gears.base_helix.si().cos();
        prop_assert!((length / expected - 1.0).abs() < ROUNDING);
        // It grows with the width and does not depend on the load.
        let wider = format!("{} mm", 2.0 * drawn.width_mm);
        let torque = format!("{} N m", 3.0 * drawn.torque);
        let double = drawn.case().with("gears.face_width", wider).with("operation.torque", torque).run();
        let double: f64 = double.result.path.iter().map(|row| row.weight_m).sum();
        prop_assert!((double / length - 2.0).abs() < ROUNDING);
    }

    #[test]
    fn a_wider_pair_slides_for_the_same_loss_at_constant_friction(
        drawn in drawn(),
        factor in 1.1..4.0f64,
        mu in 0.01..0.3f64,
    ) {
        // The load of elastic teeth hangs on the overlap, and so on the width.
        let narrow = drawn.with_constant_friction(mu).with("model.load_distribution", "mean-length");
        let wide = narrow.clone().with("gears.face_width", format!("{} mm", factor * drawn.width_mm));
        let (Some(narrow), Some(wide)) = (sensible(&narrow), sensible(&wide)) else {
            return Err(TestCaseError::reject("beyond physical sense"));
        };
        let ratio = wide.summary.sliding_w / narrow.summary.sliding_w;
        prop_assert!((ratio - 1.0).abs() < ROUNDING, "{ratio}");
        // The pressure falls with the root of the width, and more of the oil is rolled.
        let pressure = wide.path[0].hertz_pressure_mpa / narrow.path[0].hertz_pressure_mpa;
        // Where the first cell lies hangs a little on the overlap.
        prop_assert!((pressure * factor.sqrt() - 1.0).abs() < 5e-3);
        prop_assert!(wide.summary.rolling_w > narrow.summary.rolling_w);
    }

    #[test]
    fn a_pair_of_another_size_at_the_same_stress_loses_the_same_share(
        drawn in drawn(),
        scale in 0.5..5.0f64,
        mu in 0.01..0.3f64,
    ) {
        // Lengths times λ, forces times λ², torque times λ³, surface speeds the same.
        let small = drawn.with_constant_friction(mu);
        let large = small
            .clone()
            .with("gears.module", format!("{} mm", 1.3 * scale))
            .with("gears.face_width", format!("{} mm", drawn.width_mm * scale))
            .with("operation.torque", format!("{} N m", drawn.torque * scale.powi(3)))
            .with("operation.speed", format!("{} 1/min", drawn.speed / scale));
        let (Some(small), Some(large)) = (sensible(&small), sensible(&large)) else {
            return Err(TestCaseError::reject("beyond physical sense"));
        };
        let share = |result: &RunResult| {
            result.summary.sliding_w / result.summary.power_in_w
        };
        prop_assert!((share(&large) / share(&small) - 1.0).abs() < ROUNDING);
        for (a, b) in small.path.iter().zip(&large.path) {
            prop_assert!((b.hertz_pressure_mpa / a.hertz_pressure_mpa - 1.0).abs() < ROUNDING);
            prop_assert!((b.half_width_um / a.half_width_um / scale - 1.0).abs() < ROUNDING);
            prop_assert!((b.entrainment_m_per_s / a.entrainment_m_per_s - 1.0).abs() < ROUNDING);
        }
    }

    #[test]
    fn constant_friction_loses_mu_times_the_loss_factor(drawn in drawn(), mu in 0.01..0.3f64) {
        let Some(result) = sensible(&drawn.with_constant_friction(mu)) else {
            return Err(TestCaseError::reject("beyond physical sense"));
        };
        let summary = result.summary;
        let expected = mu * summary.loss_factor_local * summary.power_in_w;
        // Mixed or not: film and asperities rub alike.
        prop_assert!((summary.sliding_w / expected - 1.0).abs() < ROUNDING);
    }
}
