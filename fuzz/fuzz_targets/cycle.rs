//! Any text is a cycle and an added loss, with its own names or others, or refused.

#![no_main]

use asperity_studies::cycle::{cycle, named_cycle};
use asperity_studies::export::AddedLoss;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let names = ["time_s", "-", "torque_nm", "speed_rpm"].map(str::to_owned);
    for found in [cycle(text, None), named_cycle(text, Some(&names), None)] {
        match found {
            Ok(cycle) => {
                let rises =
                    |pair: &[asperity_studies::cycle::CyclePoint]| pair[0].time_s < pair[1].time_s;
                assert!(cycle.points.len() > 1 && cycle.points.windows(2).all(rises));
                assert!(
                    cycle
                        .points
                        .iter()
                        .all(|point| point.torque_nm.is_finite() && point.speed_rpm.is_finite())
                );
            }
            Err(error) => assert!(!error.to_string().is_empty()),
        }
    }
    let _ = AddedLoss::read("loss.csv", text);
});
