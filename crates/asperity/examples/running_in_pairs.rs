//! Histories of running-in between made traces before and after a test, by three truths: wear by a coefficient, truncation of the
//! highest asperities, and Rq that falls with the logarithm of the engagements. Which clock of a history loses least on them, and
//! how often its interval holds them, is in docs/records/running-in-pairs.md.
//!
//! ```text
//! cargo run --release -p asperity --example running_in_pairs -- 100 > pairs.csv
//! ```

use std::path::Path;

use asperity::case::{LoadedCase, RunningInPlan, load_with};
use asperity::flanks::surfaces::{Surfaces, Texture};
use asperity::quantity::{Length, Torque};
use asperity::running_in::{History, HistorySettings, history, limits};
use asperity_roughness::generate::SelfAffine;
use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// Engagements at which the logarithm begins to count.
const BEGIN: f64 = 1e3;
/// Measured error of Rq over Rq before.
const NOISE: f64 = 0.005;

type Failure = Box<dyn std::error::Error>;

/// A number from 0 to 1.
fn unit(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A number between two ends.
fn between(random: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * unit(random)
}

/// The history of one pair of traces of a recipe.
fn history_of(
    case: &LoadedCase,
    recipe: &SelfAffine,
    seeds: [u64; 2],
    torque: Torque,
) -> Result<(LoadedCase, History), Failure> {
    let [pinion, wheel] = seeds.map(|seed| SelfAffine { seed, ..*recipe }.generate());
    let mut case = case.clone();
    case.surfaces = Surfaces::new(
        [Texture::Trace(pinion?), Texture::Trace(wheel?)],
        None,
        false,
    );
    let settings = HistorySettings {
        plan: RunningInPlan {
            torque,
            engagements: None,
        },
        limit: limits(&case.case)?[1],
        worn: 5e-12,
        least: None,
    };
    let found = history(&case, &settings, &|_| {})?;
    Ok((case, found))
}

/// Rq of the pinion over Rq before, after wear `worn`, between the packages of a history.
fn at_worn(history: &History, worn: f64) -> f64 {
    let first = history.states[0].heights.rq_um[0];
    let points = wear(history);
    asperity::core::numerics::interpolate(&points, worn) / first
}

/// Rq of the pinion over the wear.
fn wear(history: &History) -> Vec<(f64, f64)> {
    let last = history.steps.last().map_or(0.0, |step| step.engagements);
    let states = history
        .states
        .iter()
        .filter(|state| state.engagements == last);
    states
        .map(|state| (state.worn, state.heights.rq_um[0]))
        .collect()
}

/// The least wear at which a history has this Rq over Rq before.
fn worn_at(history: &History, ratio: f64) -> f64 {
    let first = history.states[0].heights.rq_um[0];
    let points = wear(history);
    for pair in points.windows(2) {
        let ((w0, a), (w1, b)) = (pair[0], pair[1]);
        if b / first <= ratio {
            return (w0 + (w1 - w0) * ((a / first - ratio) / ((a - b) / first)).clamp(0.0, 1.0))
                .max(0.0);
        }
    }
    points.last().map_or(0.0, |(worn, _)| *worn)
}

/// Rq of heights without those above the share `cut` of the highest.
fn truncated(heights: &[f64], cut: f64) -> f64 {
    let mut sorted = heights.to_vec();
    sorted.sort_by(f64::total_cmp);
    let level = sorted[((1.0 - cut) * (sorted.len() - 1) as f64) as usize];
    let left: Vec<f64> = heights.iter().map(|z| z.min(level)).collect();
    let middle = left.iter().sum::<f64>() / left.len() as f64;
    1e6 * (left.iter().map(|z| (z - middle).powi(2)).sum::<f64>() / left.len() as f64).sqrt()
}

fn main() -> Result<(), Failure> {
    let count: u64 = std::env::args().nth(1).unwrap_or_default().parse()?;
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases/fzg-c.toml");
    let case = load_with(&file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(5), Some(2));
    })?;
    println!(
        "trial,truth,place,engagements,of_pair,true,archard,logarithm,k_true,k_found,plastic,measured"
    );
    for trial in 0..count {
        let mut random = ChaCha8Rng::seed_from_u64(20_261_130 + trial);
        let recipe = SelfAffine {
            points: 5001,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(between(&mut random, 0.2e-6, 0.5e-6)),
            hurst: between(&mut random, 0.6, 0.9),
            roll_off: Length::from_si(between(&mut random, 30e-6, 100e-6)),
            short_cut: Length::from_si(5e-6),
            seed: 0,
        };
        let torque = Torque::from_si(between(&mut random, 100.0, 400.0));
        let seeds = [1, 2, 3].map(|k| 10 * trial + k);
        // The tooth of the wheel that was traced is not the one that the pinion met.
        let (_, known) = history_of(&case, &recipe, [seeds[0], seeds[1]], torque)?;
        let (_, truth) = history_of(&case, &recipe, [seeds[0], seeds[2]], torque)?;
        let first = truth.states[0].heights.rq_um[0];
        let plastic = at_worn(&known, 0.0);
        let end = truth.states.iter().find(|state| {
            state.worn == 0.0
                && Some(state.engagements) == truth.steps.last().map(|step| step.engagements)
        });
        let flowed = end
            .ok_or("no end of the plastic stage")?
            .surfaces
            .traces()?[0]
            .heights()
            .to_vec();
        let k = 3e-19 * 10_f64.powf(between(&mut random, -1.0, 1.0));
        let cut = between(&mut random, 0.05, 0.25);
        let fall = between(&mut random, 0.01, 0.06);
        let pair = 10_f64.powf(between(&mut random, 4.5, 5.5));
        let noise = NOISE * (0..12).map(|_| unit(&mut random) - 0.5).sum::<f64>();
        let tens = |engagements: f64| (1.0 + engagements / BEGIN).log10();
        let truths: [(&str, &dyn Fn(f64) -> f64); 3] = [
            ("wear", &|n| at_worn(&truth, k * n)),
            ("truncation", &|n| {
                truncated(&flowed, cut * tens(n) / 3.0) / first
            }),
            ("logarithm", &|n| at_worn(&truth, 0.0) - fall * tens(n)),
        ];
        for (name, truth) in truths {
            let measured = truth(pair) + noise;
            let worn = worn_at(&known, measured);
            let per_ten = (plastic - measured) / tens(pair);
            let places = [0.25, 0.5, 0.75].map(|part: f64| BEGIN * (pair / BEGIN).powf(part));
            for (place, engagements) in places.into_iter().chain([5.0 * pair]).enumerate() {
                let archard = at_worn(&known, worn * engagements / pair);
                let logarithm = plastic - per_ten * tens(engagements);
                println!(
                    "{trial},{name},{place},{engagements:.4e},{pair:.4e},{:.5},{archard:.5},{logarithm:.5},{k:.3e},{:.3e},{plastic:.5},{measured:.5}",
                    truth(engagements),
                    worn / pair
                );
            }
        }
    }
    Ok(())
}
