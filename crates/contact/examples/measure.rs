//! Time, iterations and certificate of one of the problems of `tests/common/peers.rs`, and the time of an iteration over the time
//! of its transforms.
//!
//! ```text
//! cargo run --release -p asperity-contact --example measure -- d 10000
//! ```
#![allow(clippy::disallowed_methods, reason = "an example reads its own files")]
#![allow(
    clippy::unwrap_used,
    reason = "a problem that cannot be solved has no time"
)]

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;
use std::time::Instant;

use asperity_contact::{Boundary, ContactProblem, Control, Solver, SolverSettings, solve};
use asperity_core::numerics::{FourierNumber, good_fft_length};
use common::peers::Peer;
use realfft::num_complex::Complex;

/// Least time spent on a measurement, so that its best run is one without disturbance \[s\].
const PATIENCE: f64 = 1.0;
/// Runs longer than this are measured by the time on the processor \[s\].
const SHARED: f64 = 0.05;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or("d".into());
    let points = arguments.next().map_or(10_000, |n| n.parse().unwrap());
    let once = arguments.next().is_some_and(|word| word == "once");
    let peer = Peer::new(&name, points).unwrap();
    let problem = peer.problem();
    let settings = SolverSettings::default();
    if once {
        let solution = solve(&problem, &settings).unwrap();
        println!("{name} {points}: {} iterations", solution.iterations);
        return;
    }
    let (cold, solution) = best(|| solve(&problem, &settings).unwrap());
    let certificate = solution.certificate;
    println!(
        "{name} {}: cold {:.3} ms, {} iterations, gap {:.1e}, penetration {:.1e}, load {:.1e}",
        peer.gap.len(),
        1e3 * cold,
        solution.iterations,
        certificate.duality_gap,
        certificate.penetration,
        certificate.load_error,
    );
    if problem.lead.is_some() {
        let mean = solution.gap.iter().sum::<f64>() / solution.gap.len() as f64;
        println!(
            "  largest pressure {:.6} GPa, mean gap {:.4} nm",
            solution.max_pressure.si() * 1e-9,
            mean * 1e9
        );
        return;
    }
    let mut solver = Solver::new(points, problem.boundary).unwrap();
    let (kept, _) = best(|| solver.solve(&problem, &settings).unwrap());
    let lighter = ContactProblem {
        control: scaled(problem.control, 0.95),
        ..problem
    };
    let start = solver.solve(&lighter, &settings).unwrap().pressure;
    let neighbour = ContactProblem {
        start: Some(&start),
        ..problem
    };
    let (warm, neighbour) = best(|| solver.solve(&neighbour, &settings).unwrap());
    println!(
        "  plans kept {:.3} ms; from 5 % less load {:.3} ms, {} iterations",
        1e3 * kept,
        1e3 * warm,
        neighbour.iterations
    );
    if points > 1_000 {
        let (iteration, transforms) = (per_iteration(&problem), transforms(points, &problem));
        println!(
            "  an iteration {:.3} ms, its transforms {:.3} ms: {:.2}; cold solution over transforms {:.0}",
            1e3 * iteration,
            1e3 * transforms,
            iteration / transforms,
            cold / transforms,
        );
    }
}

fn scaled(control: Control, factor: f64) -> Control {
    match control {
        Control::Load(load) => Control::Load(load * factor),
        approach => approach,
    }
}

/// Time of an iteration on the whole grid: what the last four digits of the tolerance cost.
fn per_iteration(problem: &ContactProblem) -> f64 {
    let mut solver = Solver::new(problem.gap.len(), problem.boundary).unwrap();
    let [loose, tight] = [1e-4, 1e-8].map(|tolerance| {
        let settings = SolverSettings {
            tolerance,
            cascade: false,
            window: false,
            ..SolverSettings::default()
        };
        let (time, solution) = best(|| solver.solve(problem, &settings).unwrap());
        (time, solution.iterations as f64)
    });
    (tight.0 - loose.0) / (tight.1 - loose.1)
}

/// Time of the two pairs of real transforms that an iteration needs.
fn transforms(points: usize, problem: &ContactProblem) -> f64 {
    let padded = match problem.boundary {
        Boundary::FreeEnds => good_fft_length(2 * points - 1),
        _ => points,
    };
    pair::<f64>(padded) + pair::<f32>(good_fft_length(points))
}

fn pair<T: FourierNumber>(length: usize) -> f64 {
    let (forward, inverse) = T::real_transforms(length);
    let (mut signal, mut spectrum) = (forward.make_input_vec(), forward.make_output_vec());
    let mut scratch = forward.make_scratch_vec();
    let longest = scratch.len().max(inverse.get_scratch_len());
    scratch.resize(longest, Complex::new(T::zero(), T::zero()));
    // Of zeros: the time does not depend on the values.
    best(|| {
        forward
            .process_with_scratch(&mut signal, &mut spectrum, &mut scratch)
            .unwrap();
        inverse
            .process_with_scratch(&mut spectrum, &mut signal, &mut scratch)
            .unwrap();
    })
    .0
}

/// Least time of several runs \[s\], and the result of the last.
fn best<T>(mut run: impl FnMut() -> T) -> (f64, T) {
    let begin = Instant::now();
    let mut least = f64::INFINITY;
    loop {
        let (clock, processor) = (Instant::now(), processor_time());
        let result = black_box(run());
        let elapsed = clock.elapsed().as_secs_f64();
        // A long run shares the processor with others; a short one may have it for itself.
        let time = match (processor, processor_time()) {
            (Some(before), Some(after)) if elapsed > SHARED => after - before,
            _ => elapsed,
        };
        least = least.min(time);
        if begin.elapsed().as_secs_f64() > PATIENCE {
            return (least, result);
        }
    }
}

/// Time that this thread has been running \[s\], to some milliseconds, where the system tells.
fn processor_time() -> Option<f64> {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    let nanoseconds: f64 = told.split(' ').next()?.parse().ok()?;
    Some(1e-9 * nanoseconds)
}
