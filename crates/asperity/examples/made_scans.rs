//! Scans of made flanks for a comparison of patches with rows: `cargo run --release -p asperity --example made_scans -- crossed`
//! writes `crossed-pinion.sdf` and `crossed-wheel.sdf`, text of ISO 25178-71. A number behind the finish writes another pair.
//!
//! | finish | heights |
//! |---|---|
//! | `isotropic`, `fine` | summits without a lay, Rq 0.3 and 0.1 µm |
//! | `short` | ridges three times as long as wide along the lead, Rq 0.3 µm |
//! | `ridges-0`, `ridges-30`, `ridges-90` | ridges ten times as long as wide, at this angle to the lead, Rq 0.3 µm |
//! | `crossed` | two sets of such ridges, at 30° to both sides of the lead |
//! | `dimpled` | summits with Rq 0.1 µm, and dimples 2 µm deep and 60 µm wide on a tenth of the area |
//!
//! Points and rows are 1 µm apart. The heights are sums of 600 waves of 4 to 60 µm with a Hurst exponent of 0.8, whose lengths,
//! directions and phases are multiples of irrational numbers.

use std::f64::consts::TAU;
use std::fmt::Write as _;

/// Points of a row, and rows.
const SIZE: [usize; 2] = [3500, 300];
const WAVES: u32 = 600;
/// Numbers whose multiples fill a cube evenly.
const PARTS: [f64; 3] = [0.618_034, 0.754_878, 0.569_84];
/// Distance, radius \[µm\] and depth \[nm\] of dimples.
const DIMPLES: [f64; 3] = [168.0, 30.0, 2000.0];

/// Adds waves whose peaks are `ratio` times as long as wide, at an angle \[deg\] to the lead, with a root mean square `rq` \[nm\].
fn add_waves(heights: &mut [f64], seed: u32, [ratio, angle, rq]: [f64; 3]) {
    let (sine, cosine) = (angle * TAU / 360.0).sin_cos();
    let wave = |k: u32| {
        let [length, way, phase] = PARTS.map(|part| (f64::from(k + seed) * part).fract());
        let length = 4.0 * 15.0_f64.powf(length);
        let (along, across) = (TAU * way).sin_cos();
        let [across, along] = [across / length, along / length / ratio];
        let x = TAU * (across * cosine + along * sine);
        let y = TAU * (along * cosine - across * sine);
        [x, y, TAU * phase, length.powf(0.8)]
    };
    let waves: Vec<[f64; 4]> = (0..WAVES).map(wave).collect();
    let power: f64 = waves.iter().map(|wave| 0.5 * wave[3] * wave[3]).sum();
    for [x, y, phase, size] in waves {
        let size = size * rq / power.sqrt();
        let columns: Vec<(f64, f64)> = (0..SIZE[0]).map(|i| (x * i as f64).sin_cos()).collect();
        for (j, row) in heights.chunks_exact_mut(SIZE[0]).enumerate() {
            let (sine, cosine) = (y * j as f64 + phase).sin_cos();
            for (z, (of_sine, of_cosine)) in row.iter_mut().zip(&columns) {
                *z += size * (cosine * of_cosine - sine * of_sine);
            }
        }
    }
}

/// Cuts dimples, spherical caps at the places of a grid with every second row and each place moved.
fn cut_dimples(heights: &mut [f64], seed: u32) {
    let [pitch, radius, depth] = DIMPLES;
    let [columns, rows] = SIZE.map(|size| (size as f64 / pitch) as i32 + 2);
    let caps = (-1..rows).flat_map(|j| (-1..columns).map(move |i| [i, j]));
    let mut cuts = vec![0.0; heights.len()];
    for (number, [i, j]) in (1..).zip(caps) {
        let moved = |part: f64| 0.4 * (f64::from(number + seed) * part).fract();
        let every_second = 0.5 * f64::from(j.rem_euclid(2));
        let x = pitch * (f64::from(i) + every_second + moved(PARTS[0]));
        let y = pitch * (f64::from(j) + moved(PARTS[1]));
        let reach = |at: f64, size: usize| {
            let first = (at - radius).max(0.0) as usize;
            first..((at + radius).max(0.0) as usize + 1).min(size)
        };
        for row in reach(y, SIZE[1]) {
            for column in reach(x, SIZE[0]) {
                let away = (column as f64 - x).powi(2) + (row as f64 - y).powi(2);
                let cut = &mut cuts[row * SIZE[0] + column];
                *cut = (-depth * (1.0 - away / radius.powi(2)).max(0.0)).min(*cut);
            }
        }
    }
    for (z, cut) in heights.iter_mut().zip(cuts) {
        *z += cut;
    }
}

/// Heights \[nm\] of a finish; `None` of an unknown one.
fn heights(finish: &str, seed: u32) -> Option<Vec<f64>> {
    let mut heights = vec![0.0; SIZE[0] * SIZE[1]];
    let half = 300.0 / 2.0_f64.sqrt();
    match finish {
        "isotropic" => add_waves(&mut heights, seed, [1.0, 0.0, 300.0]),
        "fine" => add_waves(&mut heights, seed, [1.0, 0.0, 100.0]),
        "short" => add_waves(&mut heights, seed, [3.0, 0.0, 300.0]),
        "ridges-0" => add_waves(&mut heights, seed, [10.0, 0.0, 300.0]),
        "ridges-30" => add_waves(&mut heights, seed, [10.0, 30.0, 300.0]),
        "ridges-90" => add_waves(&mut heights, seed, [10.0, 90.0, 300.0]),
        "crossed" => {
            add_waves(&mut heights, seed, [10.0, 30.0, half]);
            add_waves(&mut heights, seed + 2000, [10.0, -30.0, half]);
        }
        "dimpled" => {
            add_waves(&mut heights, seed, [1.0, 0.0, 100.0]);
            cut_dimples(&mut heights, seed);
        }
        _ => return None,
    }
    Some(heights)
}

/// Writes both scans of the finish that is named.
pub fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut arguments = std::env::args().skip(1);
    let finish = arguments.next().unwrap_or_default();
    let pair = arguments.next().unwrap_or_default();
    let other = 10_000 * pair.parse().unwrap_or(0);
    for (body, seed) in [("pinion", 1000), ("wheel", 5000)] {
        let heights = heights(&finish, seed + other)
            .ok_or("name a finish, as in the table of this program")?;
        let [points, rows] = SIZE;
        let mut text = format!(
            "aISO-1.0\nManufacID   = made\nCreateDate  = 271120260000\nModDate     = 271120260000\nNumPoints   = {points}\n\
             NumProfiles = {rows}\nXscale      = 1E-06\nYscale      = 1E-06\nZscale      = 1E-09\nZresolution = -1\n\
             Compression = 0\nDataType    = 7\nCheckType   = 0\n*\n"
        );
        for row in heights.chunks_exact(points) {
            for z in row {
                write!(text, "{z:.2} ")?;
            }
            text.push('\n');
        }
        std::fs::write(format!("{finish}{pair}-{body}.sdf"), text + "*\n")?;
    }
    Ok(())
}
