//! Transmission of ADVISOR: efficiency over speed and torque of the output shaft.

use std::fmt::Write as _;

use super::error;
use super::field::Field;
use crate::map::Surface;
use asperity_core::Fault;

/// Variables `tx_map_spd` \[rad/s\], `tx_map_trq` \[N m\] and `tx_eff_map`, speeds down and torques across.
///
/// If the output drives with a torque below the loss, no power reaches the input shaft: the efficiency is 0.
pub(super) fn text(field: &Field) -> Result<String, Fault> {
    const FORMAT: &str = "ADVISOR";
    field.check_size(FORMAT)?;
    field.check_slope(FORMAT)?;
    let ratio = field.ratio.ok_or_else(|| error::no_ratio(FORMAT))?;
    let surface = field.surface();
    let torques: Vec<f64> = (field.torque_nm.iter())
        .filter(|torque| **torque != 0.0)
        .map(|torque| torque * ratio)
        .collect();
    let speeds: Vec<f64> = (field.speed_rpm.iter().copied())
        .filter(|speed| *speed > 0.0)
        .collect();
    let mut text = format!(
        "% scope {}\n% {}\n% {}\n% speed and torque of the output shaft; efficiency of the {}\n",
        field.scope,
        field.head(),
        Field::BEYOND,
        field.scope
    );
    let list = |values: &mut dyn Iterator<Item = f64>| {
        let texts: Vec<String> = values.map(|value| value.to_string()).collect();
        texts.join(" ")
    };
    let omega = |rpm: &f64| rpm * std::f64::consts::PI / 30.0 / ratio;
    // Writing into a string cannot fail.
    let _ = writeln!(
        text,
        "tx_map_spd=[{}];",
        list(&mut speeds.iter().map(omega))
    );
    let _ = writeln!(text, "tx_map_trq=[{}];", list(&mut torques.iter().copied()));
    text.push_str("tx_eff_map=[");
    for speed in &speeds {
        let row = torques
            .iter()
            .map(|torque| efficiency(&surface, torque / ratio, *speed));
        let _ = writeln!(text, "{}", list(&mut row.into_iter()));
    }
    text.push_str("];\n");
    Ok(text)
}

/// Efficiency at an output torque over the ratio \[N m\]: T_in = T_out/i + L(T_in).
fn efficiency(surface: &Surface, output_nm: f64, speed_rpm: f64) -> f64 {
    /// Number of iterations: the loss is a few percent of the torque, so each adds about two digits.
    const PASSES: usize = 60;
    let mut input = output_nm;
    for _ in 0..PASSES {
        input = output_nm + surface.loss_torque(input, speed_rpm).value;
    }
    if output_nm > 0.0 {
        output_nm / input
    } else {
        (input / output_nm).max(0.0)
    }
}
