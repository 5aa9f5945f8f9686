//! The amplitudes of a wave of three periods.
//!
//! ```text
//! cargo run -p asperity-fourier --example spectrum
//! ```

use std::f64::consts::TAU;

/// Prints the amplitude of each frequency.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    const POINTS: usize = 16;
    let wave = |i: usize| 2.0 * (3.0 * TAU * i as f64 / POINTS as f64).cos();
    let mut values: Vec<f64> = (0..POINTS).map(wave).collect();
    let (forward, _) = asperity_fourier::real_transforms(POINTS);
    let mut spectrum = forward.make_output_vec();
    forward.process(&mut values, &mut spectrum)?;
    for (periods, bin) in spectrum.iter().enumerate() {
        let amplitude = 2.0 * bin.norm() / POINTS as f64;
        println!("{periods} periods: {amplitude:.3}");
        assert!((amplitude - if periods == 3 { 2.0 } else { 0.0 }).abs() < 1e-12);
    }
    Ok(())
}
