//! Relocation of made pairs: traces of one place before and after a known wear, and of different places.
#![allow(clippy::unwrap_used)]

use asperity_core::quantity::Length;
use asperity_core::{Code, Profile};
use asperity_roughness::form::Form;
use asperity_roughness::generate::{Ground, PlateauHoned, SelfAffine, truncated};
use asperity_roughness::relocation::{Bounds, Relocation, relocate};

use crate::common::Normal;
use std::f64::consts::TAU;

/// Points of the texture for each point of a trace.
const FINER: usize = 4;
/// Length of the texture beyond the traces, in points of a trace.
const BEYOND: usize = 1400;

/// How the flank was made.
#[derive(Debug, Clone, Copy)]
enum Finish {
    Ground,
    Honed,
    Superfinished,
}

const FINISHES: [Finish; 3] = [Finish::Ground, Finish::Honed, Finish::Superfinished];

/// What a test did to it.
#[derive(Debug, Clone, Copy)]
enum Wear {
    None,
    /// All above the height that this share of the trace exceeds is removed.
    Share(f64),
    /// All within this depth of the highest point is removed [m].
    Depth(f64),
    /// As `Share`, and the material moves to its surroundings.
    Levelled(f64),
}

impl Finish {
    fn texture(self, points: usize, dx: f64, seed: u64) -> Profile {
        let length = Length::from_si;
        let affine = |rq: f64, hurst: f64, roll_off: f64, short_cut: f64, seed: u64| SelfAffine {
            points,
            spacing: length(dx),
            rq: length(rq),
            hurst,
            roll_off: length(roll_off),
            short_cut: length(short_cut),
            seed,
        };
        match self {
            Self::Ground => {
                let lay = Ground {
                    points,
                    spacing: length(dx),
                    rq: length(0.12e-6),
                    grit_spacing: length(9e-6),
                    grit_radius: length(60e-6),
                    grit_protrusion: length(0.5e-6),
                    seed,
                };
                let lay = lay.generate().unwrap();
                let rest = affine(0.32e-6, 0.7, 60e-6, 5e-6, seed + 500);
                let rest = rest.generate().unwrap();
                let sum = lay.heights().iter().zip(rest.heights());
                Profile::new(length(dx), sum.map(|(a, b)| a + b).collect()).unwrap()
            }
            Self::Honed => {
                let recipe = PlateauHoned {
                    coarse: affine(0.6e-6, 0.8, 100e-6, 5e-6, seed),
                    fine: affine(0.05e-6, 0.8, 20e-6, 4e-6, seed + 500),
                    depth: length(0.3e-6),
                };
                recipe.generate().unwrap()
            }
            Self::Superfinished => affine(0.08e-6, 0.8, 150e-6, 4e-6, seed).generate().unwrap(),
        }
    }
}

impl Wear {
    fn of(self, texture: &Profile) -> Vec<f64> {
        let z = texture.heights();
        match self {
            Self::None => z.to_vec(),
            Self::Share(share) => truncated(texture, share).unwrap().0.into_heights(),
            Self::Depth(depth) => {
                let highest = z.iter().copied().fold(f64::MIN, f64::max);
                z.iter().map(|z| z.min(highest - depth)).collect()
            }
            Self::Levelled(share) => {
                let cut = truncated(texture, share).unwrap().0;
                let lost: Vec<f64> = z.iter().zip(cut.heights()).map(|(a, b)| a - b).collect();
                let spread = smooth(&lost, 8e-6 / texture.spacing().si());
                let ratio = lost.iter().sum::<f64>() / spread.iter().sum::<f64>();
                let raised = cut.heights().iter().zip(spread);
                raised.map(|(z, gain)| z + ratio * gain).collect()
            }
        }
    }
}

/// Gaussian mean with this standard deviation in points.
fn smooth(z: &[f64], width: f64) -> Vec<f64> {
    let reach = (4.0 * width) as usize;
    let weight = |k: usize| (-0.5 * ((k as f64 - reach as f64) / width).powi(2)).exp();
    let weights: Vec<f64> = (0..=2 * reach).map(weight).collect();
    let n = z.len();
    let at = |i: usize| {
        let each = weights.iter().enumerate().filter_map(|(k, w)| {
            let j = (i + k).checked_sub(reach)?;
            (j < n).then(|| w * z[j])
        });
        each.sum::<f64>()
    };
    (0..n).map(at).collect()
}

/// A pair as a test rig leaves it.
struct Pair {
    before: Profile,
    after: Profile,
    shift: f64,
    stretch: f64,
    /// Texture before minus texture after, `fine` apart from the first point of the first trace.
    removed: Vec<f64>,
    fine: f64,
}

/// Noise of both traces [m], points and spacing.
#[derive(Debug, Clone, Copy)]
struct Setup {
    noise: [f64; 2],
    points: usize,
    dx: f64,
}

fn between(z: &[f64], fine: f64, x: f64) -> f64 {
    let place = x / fine;
    let i = place.floor() as usize;
    z[i] + (place - i as f64) * (z[i + 1] - z[i])
}

fn pair(finish: Finish, wear: Wear, setup: Setup, seed: u64) -> Pair {
    let Setup { noise, points, dx } = setup;
    let fine = dx / FINER as f64;
    let texture = finish.texture((points + BEYOND) * FINER, fine, seed);
    let worn = wear.of(&texture);
    let mut random = Normal(seed.wrapping_mul(7919).wrapping_add(17));
    let shift = (random.uniform() - 0.3) / 0.7 * 0.3e-3;
    let stretch = (random.uniform() - 0.5) * 0.004;
    let [tilt, height] = [1e-3, 3e-6].map(|most| (random.uniform() - 0.5) * most);
    // The first trace begins inside the texture.
    let begin = 0.2e-3;
    let mut trace = |z: &[f64], place: &dyn Fn(f64) -> f64, level: [f64; 2], noise: f64| {
        let heights = (0..points).map(|i| {
            let x = i as f64 * dx;
            between(z, fine, begin + place(x)) + level[0] * x + level[1] + noise * random.next()
        });
        Profile::new(Length::from_si(dx), heights.collect()).unwrap()
    };
    let before = trace(texture.heights(), &|x| x, [0.0; 2], noise[0]);
    let after = trace(
        &worn,
        &|x| shift + (1.0 + stretch) * x,
        [tilt, height],
        noise[1],
    );
    let from = (begin / fine).round() as usize;
    let pairs = texture.heights()[from..].iter().zip(&worn[from..]);
    Pair {
        before,
        after,
        shift,
        stretch,
        removed: pairs.map(|(a, b)| a - b).collect(),
        fine,
    }
}

impl Pair {
    /// Shift of the middle of the second trace \[m\].
    fn shift(&self) -> f64 {
        let length = (self.after.len() - 1) as f64 * self.after.spacing().si();
        self.shift + 0.5 * self.stretch * length
    }

    /// Mean height removed over the overlap \[m\].
    fn truth(&self, found: &Relocation) -> f64 {
        let dx = found.before.spacing().si();
        let n = found.before.len();
        let at = |i: usize| between(&self.removed, self.fine, found.start.si() + i as f64 * dx);
        (0..n).map(at).sum::<f64>() / n as f64
    }
}

/// Setups that differ in length, spacing, and in which trace is noisy.
const SETUPS: [Setup; 4] = [
    Setup {
        noise: [0.0, 10e-9],
        points: 6001,
        dx: 0.5e-6,
    },
    Setup {
        noise: [10e-9, 10e-9],
        points: 3001,
        dx: 1e-6,
    },
    Setup {
        noise: [10e-9, 0.0],
        points: 3001,
        dx: 0.5e-6,
    },
    Setup {
        noise: [7e-9, 7e-9],
        points: 10_001,
        dx: 0.5e-6,
    },
];

const WEARS: [Wear; 6] = [
    Wear::None,
    Wear::Share(0.02),
    Wear::Share(0.1),
    Wear::Share(0.4),
    Wear::Depth(0.1e-6),
    Wear::Depth(0.2e-6),
];

/// Pairs relocated and what was found.
#[derive(Debug, Default)]
struct Tally {
    pairs: usize,
    refused: usize,
    removal_inside: usize,
    shift_inside: usize,
    worst_removal: f64,
    worst_shift: f64,
}

impl Tally {
    fn add(&mut self, pair: &Pair) {
        self.pairs += 1;
        let Ok(found) = relocate(&pair.before, &pair.after, Bounds::default()) else {
            self.refused += 1;
            return;
        };
        let [truth, removed] = [pair.truth(&found), found.removed.value.si()];
        self.removal_inside += usize::from(found.removed.map(Length::si).contains(truth));
        self.worst_removal = self.worst_removal.max((removed - truth).abs());
        let [truth, shift] = [pair.shift(), found.shift.value.si()];
        self.shift_inside += usize::from(found.shift.map(Length::si).contains(truth));
        self.worst_shift = self.worst_shift.max((shift - truth).abs());
    }
}

#[test]
fn pairs_of_one_place_are_relocated_and_their_removal_is_in_its_interval() {
    let mut tally = Tally::default();
    for (k, finish) in FINISHES.into_iter().enumerate() {
        for (l, wear) in WEARS.into_iter().enumerate() {
            let seed = (10 * k + l) as u64 + 1;
            tally.add(&pair(finish, wear, SETUPS[(k + l) % 3], seed));
        }
    }
    println!("{tally:?}");
    assert_eq!(tally.refused, 0);
    assert!(tally.worst_removal < 2e-9 && tally.worst_shift < 0.2e-6);
    // Of 18 intervals that hold with 90 %, fewer than 14 hold with a probability of 3 %; the seeds are fixed.
    assert!(tally.removal_inside >= 16 && tally.shift_inside >= 14);
}

#[test]
#[ignore = "minutes; prints its table"]
fn intervals_of_removal_hold_their_truth() {
    let seeds = std::env::var("ASPERITY_SEEDS").map_or(9, |seeds| seeds.parse().unwrap());
    for finish in FINISHES {
        for (name, wears) in [("removed", &WEARS[..]), ("levelled", &LEVELLED[..])] {
            let [mut inside, mut found] = [0; 2];
            for (k, setup) in SETUPS.into_iter().enumerate() {
                let mut tally = Tally::default();
                for (l, wear) in wears.iter().enumerate() {
                    let first = 1000 * (k + 1) + 100 * l;
                    for seed in first..first + seeds {
                        tally.add(&pair(finish, *wear, setup, seed as u64));
                    }
                }
                println!("{finish:?}, {name}, {setup:?}: {tally:?}");
                let is_close = tally.worst_removal < 2e-9 && tally.worst_shift < 0.2e-6;
                assert!(is_close || name == "levelled");
                inside += tally.removal_inside;
                found += tally.pairs - tally.refused;
            }
            println!("{finish:?}, {name}: {inside} of {found}");
            assert!(inside * 100 >= found * 90);
        }
    }
}

const LEVELLED: [Wear; 2] = [Wear::Levelled(0.1), Wear::Levelled(0.25)];

#[test]
fn levelling_that_conserves_material_is_not_called_wear() {
    for (k, finish) in FINISHES.into_iter().enumerate() {
        for (l, wear) in LEVELLED.into_iter().enumerate() {
            let pair = pair(finish, wear, SETUPS[k], 70 + (k + 3 * l) as u64);
            let found = relocate(&pair.before, &pair.after, Bounds::default()).unwrap();
            let removed = found.removed.map(Length::si);
            assert!(removed.contains(0.0), "{finish:?} {wear:?}: {removed:?}");
            let is_seen = found.gained.low > Length::from_si(0.0);
            assert!(is_seen || !matches!(finish, Finish::Ground), "{wear:?}");
        }
    }
}

#[test]
fn forty_of_forty_pairs_of_different_places_are_refused() {
    for seed in 0..40 {
        let (finish, setup) = (FINISHES[seed % 3], SETUPS[seed % 3]);
        let [one, other] =
            [0, 500].map(|more| pair(finish, Wear::Share(0.1), setup, seed as u64 + more));
        let refusal = relocate(&one.before, &other.after, Bounds::default()).unwrap_err();
        assert_eq!(refusal.code(), Code::E143, "{finish:?} {seed}: {refusal}");
    }
}

#[test]
fn a_trace_on_itself_changed_nothing_above_the_noise_floor() {
    for (k, finish) in FINISHES.into_iter().enumerate() {
        let setup = SETUPS[k];
        let measured = pair(finish, Wear::None, setup, 7);
        let itself = relocate(&measured.before, &measured.before, Bounds::default()).unwrap();
        assert!(itself.shift.value.si().abs() < 1e-12 && itself.stretch.value.abs() < 1e-9);
        let removed = itself.removed.map(Length::si);
        assert!(
            removed.value.abs() < 1e-12 && removed.contains(0.0),
            "{removed:?}"
        );
        assert!(
            itself
                .parameters()
                .unwrap()
                .iter()
                .all(|change| !change.is_clear())
        );
        let again = relocate(&measured.before, &measured.after, Bounds::default()).unwrap();
        assert!(again.removed.map(Length::si).contains(0.0));
        for change in again.parameters().unwrap() {
            // One of twenty numbers exceeds its floor, and fifteen are compared.
            let difference = change.difference().si().abs();
            assert!(
                difference < 2.0 * change.floor.si(),
                "{finish:?} {change:?}"
            );
        }
        let levels = again.material_ratio(&[5.0, 50.0, 95.0]).unwrap();
        assert!(levels.iter().all(|level| !level.is_clear()), "{levels:?}");
    }
}

#[test]
fn truncated_peaks_lower_the_peaks_of_the_material_ratio_curve() {
    let pair = pair(Finish::Ground, Wear::Share(0.25), SETUPS[0], 3);
    let found = relocate(&pair.before, &pair.after, Bounds::default()).unwrap();
    let [ra, rq, rpk, ..] = found.parameters().unwrap();
    for change in [ra, rq, rpk] {
        assert!(
            change.is_clear() && change.difference().si() < 0.0,
            "{change:?}"
        );
    }
    let levels = found.material_ratio(&[5.0, 80.0]).unwrap();
    assert!(levels[0].is_clear() && !levels[1].is_clear(), "{levels:?}");
}

#[test]
fn the_noise_of_a_match_is_that_of_the_traces() {
    let pair = pair(Finish::Ground, Wear::Share(0.1), SETUPS[3], 5);
    let found = relocate(&pair.before, &pair.after, Bounds::default()).unwrap();
    let spacing = pair.before.spacing();
    let weights =
        asperity_roughness::gaussian_filter::weights(found.noise_cutoff, spacing).unwrap();
    let both: f64 =
        weights.iter().skip(1).map(|w| 2.0 * w * w).sum::<f64>() + weights[0] * weights[0];
    let expected = 7e-9 * (2.0 * both).sqrt();
    crate::common::close(found.noise.si(), expected, 0.1);
}

/// A flank with feed marks \[m\]: marks of a period \[m\] with a second harmonic, a rest of this root mean square height \[m\], and the
/// part that stays below its upper 15 %.
fn feed_marks(period: f64, rest: f64, seed: u64) -> [Vec<f64>; 2] {
    let points = 12_000;
    let between = SelfAffine {
        points,
        spacing: Length::from_si(0.5e-6),
        rq: Length::from_si(rest.max(1e-12)),
        hurst: 0.8,
        roll_off: Length::from_si(100e-6),
        short_cut: Length::from_si(5e-6),
        seed,
    };
    let between = between.generate().unwrap();
    let mark = |(k, z): (usize, &f64)| {
        let angle = TAU * k as f64 * 0.5e-6 / period;
        0.6e-6 * angle.cos() + 0.15e-6 * (2.0 * angle).cos() + if rest > 0.0 { *z } else { 0.0 }
    };
    let before: Vec<f64> = between.heights().iter().enumerate().map(mark).collect();
    let profile = Profile::new(Length::from_si(0.5e-6), before.clone()).unwrap();
    let after = truncated(&profile, 0.15).unwrap().0.into_heights();
    [before, after]
}

/// Traces of 3 mm of such a flank, the second `shift` \[points\] behind the first, with 5 nm of noise, and the height removed there.
fn feed_mark_pair(period: f64, rest: f64, shift: usize) -> ([Profile; 2], f64) {
    let [before, after] = feed_marks(period, rest, 31);
    let mut random = Normal(41);
    let begin = 2000;
    let mut trace = |z: &[f64], begin: usize| {
        let heights = z[begin..begin + 6001].iter();
        let heights = heights.map(|z| z + 5e-9 * random.next());
        Profile::new(Length::from_si(0.5e-6), heights.collect()).unwrap()
    };
    let traces = [trace(&before, begin), trace(&after, begin + shift)];
    let common = begin + shift..begin + 6001;
    let count = common.len() as f64;
    let removed = common.map(|k| before[k] - after[k]).sum::<f64>() / count;
    (traces, removed)
}

fn within(shift_um: f64) -> Bounds {
    Bounds {
        shift: Length::from_si(1e-6 * shift_um),
        ..Bounds::default()
    }
}

#[test]
fn feed_marks_are_placed_by_the_roughness_between_them() {
    for (period, rest) in [
        (100e-6, 30e-9),
        (100e-6, 10e-9),
        (200e-6, 20e-9),
        (47e-6, 30e-9),
    ] {
        let ([before, after], removed) = feed_mark_pair(period, rest, 460);
        let found = relocate(&before, &after, Bounds::default()).unwrap();
        let shift = found.shift.value.si();
        assert!((shift - 230e-6).abs() < 0.1e-6, "{period} {rest}: {shift}");
        let lost = found.removed.map(Length::si);
        assert!(
            (lost.value - removed).abs() < 1.5e-9,
            "{period} {rest}: {lost:?} {removed}"
        );
        // A bound that leaves another place only makes it no more certain, and the message says where the match is.
        let refused = relocate(&before, &after, within(120.0)).unwrap_err();
        let text = refused.to_string();
        assert_eq!(refused.code(), Code::E143);
        assert!(
            text.contains("match at a shift of 230 um, beyond the bound of 120 um"),
            "{text}"
        );
        assert_eq!(refused.remedy().to_string(), "Set max_shift to 0.28 mm");
    }
}

#[test]
fn places_alike_are_all_listed_and_none_is_chosen() {
    for period_um in [47.0, 100.0, 200.0] {
        let ([before, after], _) = feed_mark_pair(1e-6 * period_um, 0.0, 460);
        for bounds in [500.0, 120.0, 40.0] {
            let refused = relocate(&before, &after, within(bounds)).unwrap_err();
            assert_eq!(refused.code(), Code::E143);
            let text = refused.to_string();
            let shifts = text.split_once("these shifts: ").unwrap().1;
            let shifts = shifts.split_once(" um;").unwrap().0;
            let shifts: Vec<f64> = shifts
                .split(" and ")
                .next()
                .unwrap()
                .split(", ")
                .map(|shift| shift.parse().unwrap())
                .collect();
            let step = |pair: &[f64]| (pair[1] - pair[0] - period_um).abs() < 2.0;
            assert!(shifts.windows(2).all(step), "{shifts:?}");
            assert!(shifts.len() > 9, "{shifts:?}");
            assert!(!refused.help().contains("Mirror"), "{refused:?}");
        }
    }
}

#[test]
fn a_trace_with_a_bow_needs_a_parabola() {
    let pair = pair(Finish::Ground, Wear::Share(0.2), SETUPS[0], 9);
    let n = pair.after.len() as f64;
    let bow = |(k, z): (usize, &f64)| z + 0.3e-6 * (2.0 * k as f64 / n - 1.0).powi(2);
    let bowed = pair.after.heights().iter().enumerate().map(bow);
    let bowed = Profile::new(pair.after.spacing(), bowed.collect()).unwrap();
    let level = relocate(&pair.before, &bowed, Bounds::default()).unwrap();
    assert!(level.removed.map(Length::si).contains(0.0) && level.bow.is_none());
    let form = Form::Poly2;
    let found = relocate(
        &pair.before,
        &bowed,
        Bounds {
            form,
            ..Bounds::default()
        },
    )
    .unwrap();
    let [truth, removed] = [pair.truth(&found), found.removed.value.si()];
    assert!((removed - truth).abs() < 1.5e-9, "{removed} {truth}");
    assert!(found.removed.map(Length::si).contains(truth));
    let bow = found.bow.unwrap().map(Length::si);
    assert!((bow.value + 0.3e-6).abs() < 5e-9, "{bow:?}");
    // The second trace as measured lies on the first, but for what was removed.
    let [first, second] = found.as_measured(&pair.before, &bowed).unwrap();
    let pairs = first.heights().iter().zip(second.heights());
    let higher = pairs.map(|(a, b)| b - a).fold(0.0, f64::max);
    assert!(higher < 0.08e-6, "{higher}");
    for form in [Form::None, Form::Mean, Form::Circle] {
        let refused = relocate(
            &pair.before,
            &bowed,
            Bounds {
                form,
                ..Bounds::default()
            },
        );
        assert_eq!(refused.unwrap_err().code(), Code::E205);
    }
}

#[test]
fn bounds_of_no_sense_are_refused() {
    let pair = pair(Finish::Ground, Wear::None, SETUPS[2], 1);
    for (shift, stretch) in [(-1e-6, 0.0), (f64::NAN, 0.0), (1e-3, 0.2), (1e-3, f64::NAN)] {
        let shift = Length::from_si(shift);
        let refused = relocate(
            &pair.before,
            &pair.after,
            Bounds {
                shift,
                stretch,
                ..Bounds::default()
            },
        );
        assert!(refused.is_err());
    }
}
