//! Load of a rough patch over the load of its lines at the same gap: by how much lines fall short of a surface whose peaks
//! are short along the lead.
//!
//! `cargo run --release -p asperity-contact --example patch_over_lines` prints means and standard errors of eight seeds: periodic
//! patches of 256 µm with Gaussian heights, waves of 4 to 100 µm, a Hurst exponent of 0.8, E* 115 GPa, lines levelled one by one.

use asperity_contact::{
    Boundary, ContactError, ContactProblem, ContactSolution, Lead, PeriodicKernel, SolverSettings,
    solve,
};
use asperity_core::numerics::FourierNumber;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use realfft::num_complex::Complex;

/// Cells along each side.
const CELLS: usize = 256;
const SPACING: Length = Length::from_si(1e-6);
const SEEDS: u64 = 8;
/// Mean pressures of the patch [Pa].
const OF_PATCH: [f64; 4] = [0.05e9, 0.1e9, 0.2e9, 0.4e9];
/// Mean pressures of the lines [Pa].
const OF_LINES: [f64; 10] = [
    5e6, 15e6, 30e6, 60e6, 100e6, 200e6, 400e6, 800e6, 1600e6, 3200e6,
];

/// Normal numbers from the outputs of splitmix64 (Steele, Lea and Flood 2014) by Box and Muller's transform.
fn normal(state: &mut u64) -> f64 {
    let mut uniform = || {
        *state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = *state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (((z ^ (z >> 31)) >> 11) as f64 + 0.5) * 2f64.powi(-53)
    };
    (-2.0 * uniform().ln()).sqrt() * (std::f64::consts::TAU * uniform()).cos()
}

/// Transforms rows, then columns, and leaves the result turned.
fn transformed(mut values: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    f64::forward(&mut f64::planner(), CELLS).process(&mut values);
    let turned = (0..CELLS * CELLS).map(|k| values[k % CELLS * CELLS + k / CELLS]);
    turned.collect()
}

/// Heights with a root mean square of one, whose waves are `ratio` times as long along the lead.
fn heights(ratio: f64, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x100_0000_01B3);
    let noise = (0..CELLS * CELLS)
        .map(|_| normal(&mut state).into())
        .collect();
    let mut waves = transformed(transformed(noise));
    let length = SPACING.si() * CELLS as f64;
    for (k, wave) in waves.iter_mut().enumerate() {
        let [along, across] = [k % CELLS, k / CELLS].map(|n| n.min(CELLS - n) as f64 / length);
        let q = along.hypot(ratio * across);
        let inside = (1.0 / 100e-6..=1.0 / 4e-6).contains(&q);
        *wave = wave.scale(if inside { q.powf(-1.8) } else { 0.0 });
    }
    let heights: Vec<f64> = transformed(transformed(waves))
        .iter()
        .map(|z| z.re)
        .collect();
    let power = heights.iter().map(|z| z * z).sum::<f64>() / heights.len() as f64;
    heights.iter().map(|z| z / power.sqrt()).collect()
}

/// The contact of a surface at a mean pressure, and its mean gap.
fn pressed(
    heights: &[f64],
    rows: usize,
    pressure: f64,
    start: Option<&ContactSolution>,
) -> Result<(ContactSolution, f64), ContactError> {
    let gap: Vec<f64> = heights.iter().map(|z| -z).collect();
    let load = LineLoad::from_si(pressure * SPACING.si() * CELLS as f64);
    let spacing = SPACING;
    let problem = ContactProblem {
        boundary: Boundary::Periodic(PeriodicKernel::Spectral),
        lead: (rows > 1).then_some(Lead { rows, spacing }),
        start: start.map(|solution| &solution.pressure[..]),
        ..ContactProblem::new(&gap, spacing, Pressure::from_si(115e9), load)
    };
    let found = solve(&problem, &SolverSettings::default())?;
    let mean = found.gap.iter().sum::<f64>() / gap.len() as f64;
    Ok((found, mean))
}

/// Mean pressure of a line at a gap, from its gaps at [`OF_LINES`]: the logarithm of the pressure is interpolated.
fn line_pressure(gaps: &[f64], gap: f64) -> f64 {
    let after = gaps.partition_point(|g| *g > gap).clamp(1, gaps.len() - 1);
    let part = (gap - gaps[after - 1]) / (gaps[after] - gaps[after - 1]);
    let [a, b] = [after - 1, after].map(|k| OF_LINES[k].ln());
    (a + part.min(1.0) * (b - a)).exp()
}

fn main() -> Result<(), ContactError> {
    for sigma in [0.3e-6, 0.1e-6] {
        for ratio in [1.0, 3.0, 10.0] {
            let mut logs = [[0.0; 2]; 4];
            for seed in 0..SEEDS {
                let z: Vec<f64> = heights(ratio, seed).iter().map(|z| sigma * z).collect();
                let mut lines = Vec::new();
                for line in z.chunks_exact(CELLS).step_by(8) {
                    let mean = line.iter().sum::<f64>() / CELLS as f64;
                    let level: Vec<f64> = line.iter().map(|z| z - mean).collect();
                    let gaps = OF_LINES.map(|pressure| Ok(pressed(&level, 1, pressure, None)?.1));
                    let gaps: Result<Vec<f64>, ContactError> = gaps.into_iter().collect();
                    lines.push(gaps?);
                }
                let mut last = None;
                for (pressure, sums) in OF_PATCH.into_iter().zip(&mut logs) {
                    let (found, gap) = pressed(&z, CELLS, pressure, last.as_ref())?;
                    let of_lines = lines.iter().map(|gaps| line_pressure(gaps, gap));
                    let mean = of_lines.sum::<f64>() / lines.len() as f64;
                    let log = (pressure / mean).ln();
                    sums[0] += log;
                    sums[1] += log * log;
                    last = Some(found);
                }
            }
            let n = SEEDS as f64;
            print!("σ {:.1} µm, ratio {ratio:2}:", sigma * 1e6);
            for (pressure, [sum, squares]) in OF_PATCH.into_iter().zip(logs) {
                let error = ((squares - sum * sum / n) / (n - 1.0) / n).sqrt();
                print!(
                    "  {:.2} GPa {:.2} ± {error:.2}",
                    pressure * 1e-9,
                    (sum / n).exp()
                );
            }
            println!();
        }
    }
    Ok(())
}
