//! Simulated rigs: losses of the model with the errors of a rig. All files that hold them declare them as simulated.

use asperity_core::Fault;
use asperity_core::numerics::{median, standard_normal_quantile};
use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

use crate::parameters::{ASSEMBLY, NO_LOAD, ROLLING, TEMPERATURE};
use crate::rig_model::RigModel;

/// Measurement to simulate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Simulated {
    /// Index of its operating point.
    pub point: usize,
    /// Index of its assembly.
    pub assembly: usize,
    /// Speed \[rad/s\].
    pub omega: f64,
}

/// Standard normal numbers of a seed.
pub(crate) fn normals(seed: u64) -> impl FnMut() -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    move || {
        const STEPS: f64 = (1_u64 << 53) as f64;
        standard_normal_quantile(((random.next_u64() >> 11) as f64 + 0.5) / STEPS)
    }
}

/// Simulates the losses \[W\] of `measurements` by the model with the true parameters `truth`, as logarithms relative to
/// their centres. Each loss has an independent normal error of `sigma`; the errors of assembly scales, rolling loss, oil
/// temperature and loss without load are drawn from their priors.
///
/// # Errors
/// When the model has no solution at a point.
pub fn losses(
    model: &RigModel,
    truth: &[f64],
    measurements: &[Simulated],
    sigma: f64,
    seed: u64,
) -> Result<Vec<f64>, Fault> {
    let mut normal = normals(seed);
    let assemblies = measurements
        .iter()
        .map(|one| one.assembly + 1)
        .max()
        .unwrap_or(0);
    let mut setting = truth.to_vec();
    setting.push(TEMPERATURE * normal());
    let rolling = (ROLLING * normal()).exp();
    let without_load = NO_LOAD * normal();
    let scales: Vec<f64> = (0..assemblies)
        .map(|_| (ASSEMBLY * normal()).exp())
        .collect();
    let parts = model.evaluate(&[setting], &|_| {})?;
    let clean: Vec<f64> = measurements
        .iter()
        .map(|one| {
            let parts = &parts[one.point][0];
            scales[one.assembly] * (parts.sliding_w + rolling * parts.rolling_w)
        })
        .collect();
    let with_speed = || clean.iter().zip(measurements);
    let torques = with_speed().map(|(loss, one)| loss / one.omega);
    let offset = without_load * median(torques).unwrap_or(0.0);
    let measured =
        with_speed().map(|(loss, one)| (loss + offset * one.omega) * (sigma * normal()).exp());
    Ok(measured.collect())
}
