//! Error of the model in close conditions: its correlation follows by likelihood from reference solutions.
//!
//! | symbol | meaning |
//! |---|---|
//! | e | ln of the model's friction over that of the reference, in the windows of the reference, over its stated deviation |
//! | ν | standard deviation of e by windows of another place or width |

use std::collections::BTreeMap;

use asperity::case::cholesky;
use asperity::uncertainty::{MODEL_LENGTHS, model_correlation};
use asperity_core::numerics::deviation;

use crate::ehl_records::mean_and_rms;
use crate::film_records::{BLIND, CLOSE, GEAR_MESHES, Row, SECOND_BLIND, rows};

/// A solution with what its error depends on.
struct Solved {
    name: String,
    error: f64,
    deviation: f64,
    conditions: [f64; 4],
    /// Solutions with equal windows have the same text.
    windows: String,
}

type Groups = BTreeMap<String, Vec<Solved>>;

/// ν and the four lengths.
type Parameters = [f64; 5];

/// Largest part of a covariance that rounding of the stored numbers makes up, in deviations.
const ROUNDING: f64 = 0.01;

fn covariance(at: &Parameters, a: &Solved, b: &Solved) -> f64 {
    let [windows, lengths @ ..] = *at;
    let of_windows = if a.windows == b.windows {
        windows * windows
    } else {
        0.0
    };
    let own = if a.name == b.name {
        ROUNDING * ROUNDING
    } else {
        0.0
    };
    model_correlation(lengths, a.conditions, b.conditions) + of_windows + own
}

/// ln of the likelihood of all groups, without its constant.
fn ln_likelihood(groups: &Groups, at: &Parameters) -> f64 {
    let of_group = |group: &Vec<Solved>| {
        let Some(lower) = cholesky(group.len(), |i, j| covariance(at, &group[i], &group[j])) else {
            return f64::NEG_INFINITY;
        };
        let mut solved: Vec<f64> = Vec::with_capacity(group.len());
        let mut ln = 0.0;
        for (row, one) in lower.iter().zip(group) {
            let known: f64 = row.iter().zip(&solved).map(|(l, x)| l * x).sum();
            let diagonal = row[solved.len()];
            let x = (one.error - known) / diagonal;
            ln -= diagonal.ln() + 0.5 * x * x;
            solved.push(x);
        }
        ln
    };
    groups.values().map(of_group).sum()
}

/// The solutions of tables up to s = 3, by their traces.
fn groups(tables: &[&str]) -> Groups {
    let mut groups = Groups::new();
    for row in tables.iter().flat_map(|table| rows(table)) {
        if row.is_within_reference() {
            groups
                .entry(traces_of(&row.name))
                .or_default()
                .push(solved(&row));
        }
    }
    groups
}

/// The groups at full load, on which the lengths were fitted, or those at part load, which were solved afterwards.
fn at_full_load(groups: Groups, is_full: bool) -> Groups {
    const LIGHT_BELOW_GPA: f64 = 0.8;
    let is_wanted = |group: &[Solved]| {
        let is_light = group.iter().all(|one| one.conditions[2] < LIGHT_BELOW_GPA);
        is_light != is_full
    };
    let groups = groups.into_iter();
    groups.filter(|(_, group)| is_wanted(group)).collect()
}

/// The words of a name that name its flanks.
fn traces_of(name: &str) -> String {
    if name.starts_with("close-") {
        return name.split('_').next().unwrap().to_owned();
    }
    let is_word = |part: &&str| part.starts_with(|sign: char| sign.is_ascii_alphabetic());
    name.split('_')
        .take_while(is_word)
        .collect::<Vec<_>>()
        .join("_")
}

fn solved(row: &Row) -> Solved {
    // Speed, temperature, heights and oil leave the windows where they are.
    let windows = match row.name.split_once('_') {
        Some((flanks, change)) if flanks.starts_with("close-") => {
            let is_moved = change.starts_with("torque") || change.starts_with("place");
            let change = if is_moved { change } else { "" };
            format!("{flanks} {change}")
        }
        _ => row.name.clone(),
    };
    let deviation = row.deviation(false);
    Solved {
        name: row.name.clone(),
        error: row.passed_error() / deviation,
        deviation,
        conditions: row.conditions(),
        windows,
    }
}

/// The most likely parameters from `start` on, by steps along each axis that are halved; the one that is `held` stays.
fn most_likely(groups: &Groups, start: Parameters, held: Option<usize>) -> (Parameters, f64) {
    const LEAST_STEP: f64 = 0.02;
    /// Bounds of all parameters.
    const BOUNDS: [f64; 2] = [1e-3, 20.0];
    let mut best = (start, ln_likelihood(groups, &start));
    let mut step = 0.3_f64;
    while step > LEAST_STEP {
        let before = best.1;
        for k in (0..start.len()).filter(|k| Some(*k) != held) {
            for factor in [step.exp(), (-step).exp()] {
                let mut other = best.0;
                other[k] = (factor * other[k]).clamp(BOUNDS[0], BOUNDS[1]);
                let found = ln_likelihood(groups, &other);
                if found > best.1 {
                    best = (other, found);
                }
            }
        }
        if best.1 - before < 1e-2 {
            step *= 0.5;
        }
    }
    best
}

/// Values of a length at which ln L, the others at their most likely, is 1.92 below its largest: 95 %.
fn range_of(groups: &Groups, k: usize, (best, ln): (Parameters, f64)) -> [f64; 2] {
    const BELOW: f64 = 1.92;
    const STEP: f64 = 1.1;
    [STEP.recip(), STEP].map(|step| {
        let mut at = best;
        while ln_likelihood_held(groups, k, &mut at) > ln - BELOW && (1e-2..10.0).contains(&at[k]) {
            at[k] *= step;
        }
        at[k]
    })
}

fn ln_likelihood_held(groups: &Groups, k: usize, at: &mut Parameters) -> f64 {
    let (found, ln) = most_likely(groups, *at, Some(k));
    *at = found;
    ln
}

/// Differences within a group that their 90 % interval by the error of the model holds, with their number, by group; only of pairs
/// that are `compared`.
fn covered(groups: &Groups, compared: &dyn Fn(&Solved, &Solved) -> bool) -> Vec<[f64; 2]> {
    const NINETY_PERCENT: f64 = 1.645;
    let of_group = |group: &Vec<Solved>| {
        let mut found = [0.0; 2];
        for (k, a) in group.iter().enumerate() {
            for b in group[k + 1..].iter().filter(|b| compared(a, b)) {
                let rho = model_correlation(MODEL_LENGTHS, a.conditions, b.conditions);
                let both = 2.0 * rho * a.deviation * b.deviation;
                let square = a.deviation * a.deviation + b.deviation * b.deviation - both;
                let difference = a.error * a.deviation - b.error * b.deviation;
                // Four digits of a friction.
                let rounding = ROUNDING * a.deviation;
                let is_within =
                    difference.abs() <= NINETY_PERCENT * (square + rounding * rounding).sqrt();
                found[0] += f64::from(u8::from(is_within));
                found[1] += 1.0;
            }
        }
        found
    };
    let found = groups.values().map(of_group);
    found.filter(|[_, count]| *count > 0.0).collect()
}

fn share<'a>(of: impl Iterator<Item = &'a [f64; 2]>) -> f64 {
    let [within, all] = of.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
    within / all
}

/// The share of all groups with its standard error, by groups drawn anew.
fn with_error(groups: &[[f64; 2]]) -> [f64; 2] {
    const TIMES: usize = 2000;
    let mut state = 1_u64;
    let mut next = || {
        const STEP: [u64; 2] = [6_364_136_223_846_793_005, 1_442_695_040_888_963_407];
        state = state.wrapping_mul(STEP[0]).wrapping_add(STEP[1]);
        (state >> 33) as usize % groups.len()
    };
    let mut drawn = || -> f64 {
        let picked: Vec<usize> = groups.iter().map(|_| next()).collect();
        share(picked.iter().map(|k| &groups[*k]))
    };
    let shares: Vec<f64> = (0..TIMES).map(|_| drawn()).collect();
    [share(groups.iter()), deviation(&shares).unwrap()]
}

#[test]
fn the_error_of_the_model_belongs_to_the_traces() {
    let close = at_full_load(groups(&[CLOSE]), true);
    let count: usize = close.values().map(Vec::len).sum();
    assert_eq!((count, close.len()), (107, 6));
    let start = [&[0.05][..], &MODEL_LENGTHS].concat().try_into().unwrap();
    let best = most_likely(&close, start, None);
    println!(
        "ln L {:.1} at ν {:.3}, lengths {:.3?}",
        best.1,
        best.0[0],
        &best.0[1..]
    );
    for (k, length) in (1..).zip(MODEL_LENGTHS) {
        let [low, high] = range_of(&close, k, best);
        println!("length {k}: {length}, 95 % {low:.2} to {high:.2}");
        assert!((low..high).contains(&length), "{k}: {low} to {high}");
    }
    // Together: a fourth of χ² of four degrees of freedom has 95 % below 9.49.
    let mut shipped = start;
    shipped[0] = best.0[0];
    let shipped = ln_likelihood(&close, &shipped);
    assert!(best.1 - shipped < 0.5 * 9.49, "{shipped} {}", best.1);
}

#[test]
fn differences_of_conditions_lie_in_their_interval() {
    let close = groups(&[CLOSE]);
    let of_base = |a: &Solved, b: &Solved| {
        let is_small = |name: &str| {
            let small = ["speed_1.01", "warmer_1", "torque_0.997", "heights_0.97"];
            small.iter().any(|change| name.ends_with(change))
        };
        a.name.ends_with("base") && is_small(&b.name)
    };
    let light = at_full_load(groups(&[CLOSE]), false);
    let far = groups(&[GEAR_MESHES, BLIND, SECOND_BLIND]);
    for (name, groups, compared, least) in [
        (
            "all pairs of close conditions",
            &close,
            (&|_: &Solved, _: &Solved| true) as &dyn Fn(&Solved, &Solved) -> bool,
            0.85,
        ),
        ("changes by 1 to 3 %", &close, &of_base, 0.85),
        ("close conditions at part load", &light, &|_, _| true, 0.85),
        ("other places of the same traces", &far, &|_, _| true, 0.75),
    ] {
        let by_group = covered(groups, compared);
        let count: f64 = by_group.iter().map(|[_, count]| count).sum();
        let [within, error] = with_error(&by_group);
        println!("{name}: {within:.2} ± {error:.2} of {count}");
        assert!(within >= least, "{name}: {within}");
    }
    // Root mean square of the change of ln friction, model over reference, from each base.
    for change in [
        "speed_1.01",
        "speed_1.1",
        "speed_1.4",
        "warmer_1",
        "warmer_15",
        "torque_0.97",
        "torque_0.85",
        "heights_0.9",
        "heights_0.7",
        "eyring_1.3",
        "place_0.3",
    ] {
        let changes = close.values().filter_map(|group| {
            let of = |end: &str| group.iter().find(|one| one.name.ends_with(end));
            let [base, changed] = [of("_base")?, of(&format!("_{change}"))?];
            Some(changed.error * changed.deviation - base.error * base.deviation)
        });
        let [_, rms] = mean_and_rms(changes);
        println!("{change}: {rms:.4}");
    }
}
