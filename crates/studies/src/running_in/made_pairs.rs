//! Histories of running-in between made traces before and after a test, by three truths: wear by a coefficient, truncation of the
//! highest asperities, and Rq that falls with the logarithm of the engagements. Which clock of a history loses least on them, and
//! how often its interval holds them, is in docs/model/contact.md.

use std::path::Path;

use super::clock::{BEGIN, Clock, Fall, Tested, USUAL};
use super::study::OF_LIMITS;
use asperity::case::{LoadedCase, RunningInPlan, load_with};
use asperity::flanks::surfaces::{Surfaces, Texture};
use asperity::pipeline::{History, HistorySettings, history};
use asperity::quantity::{Length, Torque};
use asperity::running_in::limits;
use asperity_core::Estimate;
use asperity_roughness::generate::SelfAffine;
use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// Measured error of Rq over Rq before.
const NOISE: f64 = 0.005;

/// A number from 0 to 1.
fn unit(random: &mut ChaCha8Rng) -> f64 {
    (random.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
}

/// A number between two ends.
fn between(random: &mut ChaCha8Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * unit(random)
}

/// The history of one pair of traces of a recipe.
fn history_of(case: &LoadedCase, recipe: &SelfAffine, seeds: [u64; 2], torque: Torque) -> History {
    let [pinion, wheel] = seeds.map(|seed| SelfAffine { seed, ..*recipe }.generate().unwrap());
    let flanks = Surfaces::new([Texture::Trace(pinion), Texture::Trace(wheel)], None, false);
    // At the torque of the running-in, so that film and loss are computed once.
    let case = case.with(|input| input.operation.torque = torque).unwrap();
    let case = case.with_surfaces(flanks).at_stated().unwrap();
    let settings = HistorySettings {
        plan: RunningInPlan {
            torque,
            // What flows later changes Rq by two percent, and would take most of the time.
            engagements: Some(OF_LIMITS),
        },
        limit: limits(&case.case).unwrap()[1],
        worn: 5e-12,
        least: None,
    };
    history(&case, &settings, &|_| {}).unwrap()
}

/// Rq of the pinion over Rq before over the wear, and the heights of the pinion after plastic flow.
fn wear(history: &History) -> (Vec<(f64, f64)>, Vec<f64>) {
    let last = history.steps.last().unwrap().engagements;
    let first = history.states[0].heights.rq_um[0];
    let states = || {
        history
            .states
            .iter()
            .filter(|state| state.engagements == last)
    };
    let points = states().map(|state| (state.worn, state.heights.rq_um[0] / first));
    let flowed = states().next().unwrap().surfaces.traces().unwrap()[0].heights();
    (points.collect(), flowed.to_vec())
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

/// Squared errors of both clocks, truths inside the interval of the history, and their number.
#[derive(Default)]
struct Score {
    logarithm: f64,
    proportion: f64,
    inside: f64,
    count: f64,
}

/// The record: 100 trials take ten minutes of processor time.
///
/// ```text
/// cargo test --release -p asperity-studies --lib -- --ignored --nocapture made_pairs
/// ```
#[test]
#[ignore = "takes ten minutes of processor time"]
fn the_clock_of_the_history_loses_least_on_made_pairs() {
    const TRIALS: u64 = 100;
    let file = Path::new("../../fixtures/cases/fzg-c.toml");
    let case = load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(5), Some(2));
    })
    .unwrap();
    let mut scores: [Score; 3] = Default::default();
    let (mut held, mut of_own) = (0, 0);
    // The widths were chosen on the trials from 1000 on.
    for trial in 5000..5000 + TRIALS {
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
        let (known, _) = wear(&history_of(&case, &recipe, [seeds[0], seeds[1]], torque));
        let own = history_of(&case, &recipe, [seeds[0], seeds[2]], torque);
        let first = own.states[0].heights.rq_um[0];
        let (truth, flowed) = wear(&own);
        let k = USUAL * 10_f64.powf(between(&mut random, -1.0, 1.0));
        let cut = between(&mut random, 0.05, 0.25);
        let fall = between(&mut random, 0.01, 0.06);
        let pair = 10_f64.powf(between(&mut random, 4.5, 5.5));
        let noise = NOISE * (0..12).map(|_| unit(&mut random) - 0.5).sum::<f64>();
        let tens = |engagements: f64| (engagements / BEGIN).ln_1p() / 10_f64.ln();
        let truths: [&dyn Fn(f64) -> f64; 3] = [
            &|n| asperity::core::numerics::interpolate(&truth, k * n),
            &|n| truncated(&flowed, cut * tens(n) / 3.0) / first,
            &|n| truth[0].1 - fall * tens(n),
        ];
        for ((law, of), score) in truths.iter().enumerate().zip(&mut scores) {
            let measured = of(pair) + noise;
            let tested = Tested {
                flank: 0,
                fall: Fall::new(known.iter().copied()),
                engagements: pair,
                plastic: known[0].1,
                measured: Estimate::new(
                    measured,
                    [-1.645, 1.645].map(|half| measured + half * NOISE),
                ),
            };
            if law == 0 {
                // Where plastic flow explains the fall, the coefficient is that without a test.
                let usual = || Clock::usual().worn(1.0);
                of_own += 1;
                held += usize::from(tested.coefficient().unwrap_or_else(usual).contains(k));
            }
            let worn = tested.fall.worn(measured.min(tested.plastic));
            let places = [0.25, 0.5, 0.75].map(|part: f64| BEGIN * (pair / BEGIN).powf(part));
            for engagements in places.into_iter().chain([5.0 * pair]) {
                let found = tested.ratio(engagements);
                let truth = of(engagements);
                let proportion = tested.fall.at(worn * engagements / pair);
                score.logarithm += (found.value - truth).powi(2);
                score.proportion += (proportion - truth).powi(2);
                score.inside += f64::from(u8::from(found.contains(truth)));
                score.count += 1.0;
            }
        }
        if trial % 10 == 9 {
            println!("after {} trials: k inside {held} of {of_own}", trial - 4999);
            for (score, name) in scores.iter().zip(["wear", "truncation", "logarithm"]) {
                let rms = |squares: f64| (squares / score.count).sqrt();
                println!(
                    "{name}: rms by logarithm {:.4}, in proportion {:.4}; inside {:.3}",
                    rms(score.logarithm),
                    rms(score.proportion),
                    score.inside / score.count
                );
            }
        }
    }
    let sum = |of: fn(&Score) -> f64| scores.iter().map(of).sum::<f64>();
    assert!(sum(|score| score.logarithm) < sum(|score| score.proportion));
    let inside = sum(|score| score.inside) / sum(|score| score.count);
    assert!((0.85..=0.95).contains(&inside), "{inside}");
    assert!(held >= 85 * of_own / 100, "{held} of {of_own}");
}
