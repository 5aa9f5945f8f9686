//! Traces generated like measured ones, against traces of the same surface that were left out of the fit.
#![allow(clippy::unwrap_used)]

use asperity_core::Profile;
use asperity_core::numerics::{deviation, mean};
use asperity_core::quantity::Length;
use asperity_roughness::Warning;
use asperity_roughness::form::{Form, remove};
use asperity_roughness::generate::{
    Ground, Like, Method, Pieces, SelfAffine, State, lower_envelope, truncated,
};
use asperity_roughness::relocation::{Bounds, relocate};
use asperity_roughness::spectral::power_spectrum;

use crate::common::compared::{NAMES, different, parameters};
use crate::common::finishes::{self, FINISHES, made_like, seed_of};

/// Of 3 mm, with a parent of a round number of points.
const POINTS: usize = 6000;
const DX: Length = Length::from_si(0.5e-6);
/// The parameters of ten seeds like `fitted` that differ from those of `left_out`.
fn unlike(fitted: &[Profile], left_out: &[Profile]) -> Vec<&'static str> {
    let like = Like::to(&fitted[0], &fitted[1..], None).unwrap();
    let made = (1..=10).map(|seed| parameters(&like.generate(seed).unwrap().generated.profile));
    let left_out: Vec<_> = left_out.iter().map(parameters).collect();
    let off = different(&made.collect::<Vec<_>>(), &left_out);
    off.into_iter().map(|k| NAMES[k]).collect()
}

/// Points of a long profile from which all traces of a surface are cut.
const ALL: usize = 12 * POINTS;

fn affine(rq: f64, roll_off: f64, seed: u64) -> Profile {
    let recipe = SelfAffine {
        points: ALL,
        spacing: DX,
        rq: Length::from_si(rq),
        hurst: 0.8,
        roll_off: Length::from_si(roll_off),
        short_cut: Length::from_si(2e-6),
        seed,
    };
    recipe.generate().unwrap()
}

/// Grooves of grits on a self-affine background: ridges higher than the valleys are deep.
fn ground() -> Profile {
    let grooves = Ground {
        points: ALL,
        spacing: DX,
        rq: Length::from_si(0.2e-6),
        grit_spacing: Length::from_si(12e-6),
        grit_radius: Length::from_si(60e-6),
        grit_protrusion: Length::from_si(0.5e-6),
        seed: 1,
    };
    let grooves = grooves.generate().unwrap();
    let background = affine(0.2e-6, 80e-6, 2);
    let both = grooves.heights().iter().zip(background.heights());
    Profile::new(DX, both.map(|(a, b)| a + b).collect()).unwrap()
}

/// The lower envelope of a coarse and a fine process: plateaus with valleys.
fn honed() -> Profile {
    let plateaus = affine(0.05e-6, 30e-6, 3);
    let dales = affine(0.4e-6, 60e-6, 4);
    let dales: Vec<f64> = dales.heights().iter().map(|z| z + 0.4e-6).collect();
    lower_envelope(&plateaus, &Profile::new(DX, dales).unwrap()).unwrap()
}

fn traces(surface: &Profile) -> [Vec<Profile>; 2] {
    let cut = |first: usize| {
        let pieces = surface.heights().chunks(POINTS).skip(first).step_by(2);
        let profile = |piece: &[f64]| Profile::new(DX, piece.to_vec()).unwrap();
        pieces.map(profile).collect()
    };
    [cut(0), cut(1)]
}

#[test]
fn eighteen_of_twenty_parameters_are_those_of_traces_left_out() {
    let surfaces = [
        ("ground", ground()),
        ("self-affine", affine(0.3e-6, 80e-6, 5)),
        ("honed", honed()),
    ];
    for (name, surface) in surfaces {
        let [fitted, left_out] = traces(&surface);
        let off = unlike(&fitted, &left_out);
        assert!(off.len() <= 2, "{name}: {off:?}");
    }
}

#[test]
fn pieces_are_taken_where_heights_slopes_or_curvatures_are_not_gaussian() {
    let method = |surface: &Profile, count: usize| {
        let traces = &traces(surface)[0][..count];
        let like = Like::to(&traces[0], &traces[1..], None).unwrap();
        (like.method(), like.warnings)
    };
    let (gaussian, ridged, plateaus) = (affine(0.3e-6, 80e-6, 5), ground(), honed());
    assert_eq!(method(&gaussian, 6), (Method::Spectrum, Vec::new()));
    assert_eq!(method(&ridged, 6), (Method::Pieces, Vec::new()));
    let length = DX * (POINTS - 1) as f64;
    let one = vec![Warning::OneTrace { length }];
    assert_eq!(method(&plateaus, 1), (Method::Pieces, one));
}

#[test]
fn traces_of_other_finishes_spacings_and_lengths_are_named() {
    let [fine, coarse] = [0.1e-6, 0.25e-6].map(|rq| traces(&affine(rq, 80e-6, 5))[0][0].clone());
    let like = Like::to(&fine, std::slice::from_ref(&coarse), None).unwrap();
    assert!(matches!(like.warnings[..], [Warning::HeightsDiffer { .. }]));
    let refused = |other: Profile| {
        let error = Like::to(&fine, &[other], Some(Method::Pieces)).unwrap_err();
        error.to_string()
    };
    let wider = Profile::new(DX * 2.0, coarse.heights().to_vec()).unwrap();
    assert!(refused(wider).contains("spaced"));
    let short = coarse.slice(0..1000).unwrap();
    assert!(refused(short).contains("needs at least"));
}

#[test]
#[ignore = "a minute; prints its table"]
fn parameters_of_generated_flanks() {
    println!(
        "| finish | method | generated against left out | given against left out | parameters that differ, over those left out (of the given ones) |"
    );
    println!("|---|---|---|---|---|");
    for finish in FINISHES {
        let [mut of_made, mut of_given, mut names] = [Vec::new(), Vec::new(), Vec::new()];
        let mut method = None;
        for repetition in 1..=3 {
            let all = finishes::traces(finish, 12, seed_of(repetition));
            let (given, left_out) = all.split_at(6);
            let (like, made) = made_like(given, 20);
            method = Some(like.method());
            let [given, left_out, made] = [given, left_out, &made]
                .map(|traces| traces.iter().map(parameters).collect::<Vec<_>>());
            let off = different(&made, &left_out);
            of_made.push((NAMES.len() - off.len()).to_string());
            of_given.push((NAMES.len() - different(&given, &left_out).len()).to_string());
            let ratio = |k: usize| {
                let of = |rows: &[[f64; 20]]| {
                    mean(rows.iter().map(|row| row[k])) / mean(left_out.iter().map(|row| row[k]))
                };
                format!("{} {:.2} ({:.2})", NAMES[k], of(&made), of(&given))
            };
            names.push(off.into_iter().map(ratio).collect::<Vec<_>>().join(", "));
        }
        println!(
            "| {} | {} | {} | {} | {} |",
            finish.0,
            method.map_or("", |method| match method {
                Method::Pieces => "pieces",
                Method::Spectrum => "spectrum",
            }),
            of_made.join(", "),
            of_given.join(", "),
            names.join("; ")
        );
    }
}

/// A trace and what is left of it without the peaks above a fifth of its length, measured from another place on.
fn worn(before: &Profile) -> [Profile; 2] {
    let after = truncated(before, 0.2).unwrap().0;
    [before.clone(), after.slice(200..before.len()).unwrap()]
}

/// A flank in state 0 has the heights before the test, with all waves of the traces.
#[test]
fn flanks_in_the_state_before_a_test_are_not_filtered() {
    let given = &traces(&honed())[0];
    let after: Vec<Profile> = given.iter().map(|trace| worn(trace)[1].clone()).collect();
    let slope = |like: &Like| {
        let made = (1..=8).map(|seed| like.generate(seed).unwrap().generated.achieved.rdq);
        mean(made.map(Option::unwrap))
    };
    let before = Like::of_stages(given, &after, State::of_one_stage(0.0).unwrap()).unwrap();
    let like = Like::to(&given[0], &given[1..], Some(Method::Pieces)).unwrap();
    let ratio = slope(&before) / slope(&like);
    // Both take pieces of the same traces: the filter of the relocation would take off the shortest waves.
    assert!((ratio - 1.0).abs() < 0.015, "{ratio}");
}

/// Pairs left out are relocated as well, and compared as they were measured.
#[test]
fn flanks_between_two_states_are_those_of_pairs_left_out() {
    let [given, left_out] = traces(&honed());
    let after: Vec<Profile> = given.iter().map(|trace| worn(trace)[1].clone()).collect();
    let left_out = left_out.iter().map(|before| {
        let [before, after] = worn(before);
        let found = relocate(&before, &after, Bounds::default()).unwrap();
        found.as_measured(&before, &after).unwrap()
    });
    let left_out: Vec<_> = left_out.collect();
    for state in [0.0, 0.5, 1.0] {
        let like = Like::of_stages(&given, &after, State::of_one_stage(state).unwrap()).unwrap();
        let made = (1..=8).map(|seed| parameters(&like.generate(seed).unwrap().generated.profile));
        let kept = left_out.iter().map(|[before, after]| {
            let both = before.heights().iter().zip(after.heights());
            let heights = both.map(|(before, after)| before - state * (before - after));
            parameters(&Profile::new(DX, heights.collect()).unwrap())
        });
        let off = different(&made.collect::<Vec<_>>(), &kept.collect::<Vec<_>>());
        let off: Vec<_> = off.into_iter().map(|k| NAMES[k]).collect();
        assert!(off.is_empty(), "{state}: {off:?}");
    }
    let error = State::of_one_stage(1.5).unwrap_err();
    assert!(error.to_string().contains("from 0 to 1"), "{error}");
    let error = Like::of_stages(&given, &after[1..], State::of_one_stage(1.0).unwrap());
    let error = error.unwrap_err().to_string();
    assert!(error.contains("one for each trace"), "{error}");
}

/// The stages begin at other places than the trace before, and than each other.
#[test]
fn flanks_between_stages_have_lost_what_was_cut() {
    let given = &traces(&ground())[0][..3];
    let cut = |part: f64, from: usize| -> Vec<Profile> {
        let each = given.iter().map(|before| {
            let after = truncated(before, part).unwrap().0;
            after.slice(from..before.len()).unwrap()
        });
        each.collect()
    };
    let after = [cut(0.1, 150), cut(0.3, 220)].concat();
    let stages = [1e4, 1e6];
    let at = |engagements: f64| {
        let state = State::after(engagements, &stages).unwrap();
        let pieces = Pieces::of_stages(given, &after, state).unwrap();
        let made = pieces.generate(10 * POINTS, 1).unwrap();
        made.generated.profile.heights().to_vec()
    };
    let [start, first, between, last] = [0.0, 1e4, 2.575e5, 1e6].map(at);
    for (k, z) in between.iter().enumerate() {
        assert!((z - 0.75 * first[k] - 0.25 * last[k]).abs() < 1e-12);
    }
    let lost = |part: f64| {
        let each = given.iter().map(|before| {
            let after = truncated(before, part).unwrap().0;
            mean(
                before
                    .heights()
                    .iter()
                    .zip(after.heights())
                    .map(|(a, b)| a - b),
            )
        });
        mean(each)
    };
    let removed = |after: &[f64]| mean(start.iter().zip(after).map(|(a, b)| a - b));
    for (part, after) in [(0.1, &first), (0.3, &last)] {
        let ratio = removed(after) / lost(part);
        assert!((ratio - 1.0).abs() < 0.1, "{part}: {ratio}");
        // No dale is deeper and no peak is left where traces are shifted on each other.
        let gained = start
            .iter()
            .zip(after)
            .map(|(a, b)| b - a)
            .fold(0.0, f64::max);
        assert!(gained < 0.2 * lost(part), "{part}: {gained}");
    }
}

/// Six honed traces, whose heights differ between teeth by a fifth or not at all.
#[test]
fn flanks_like_teeth_that_differ_differ_as_these() {
    let honed = traces(&honed())[0].clone();
    let like = |scatter: f64| {
        let places =
            [-1.27, 0.2, -0.64, 1.27, 0.64, -0.2].map(|place: f64| (scatter * place).exp());
        let given = honed.iter().zip(places).map(|(trace, factor)| {
            let heights = trace.heights().iter().map(|z| z * factor);
            Profile::new(DX, heights.collect()).unwrap()
        });
        let given: Vec<_> = given.collect();
        Like::to(&given[0], &given[1..], Some(Method::Pieces)).unwrap()
    };
    let spread = |like: &Like| {
        let made = (1..=40).map(|seed| like.generate(seed).unwrap().generated.achieved);
        let slopes: Vec<f64> = made.map(|made| made.rdq.unwrap().ln()).collect();
        deviation(&slopes).unwrap()
    };
    let [equal, different] = [0.0, 0.2].map(like);
    assert_eq!(equal.teeth.scatter.unwrap().value, 0.0);
    let scatter = different.teeth.scatter.unwrap();
    assert!(
        scatter.low < 0.2 && scatter.high > 0.2 && scatter.low > 0.05,
        "{scatter:?}"
    );
    // Of 40 teeth, one standard error is 11 %.
    let within = spread(&equal);
    let found = spread(&different) / scatter.value.hypot(within);
    assert!(
        (found - 1.0).abs() < 0.25 && within < 0.15,
        "{found} {within}"
    );
    let one = Like::to(&honed[0], &[], Some(Method::Pieces)).unwrap();
    assert_eq!(one.teeth.scatter, None);
}

/// The order of the pieces alone would lose a third of the waves of 0.4 to 0.6 mm.
#[test]
fn waves_longer_than_the_pieces_are_as_strong_as_measured() {
    let given = traces(&affine(0.3e-6, 400e-6, 5))[0].clone();
    let like = Like::to(&given[0], &given[1..], Some(Method::Pieces)).unwrap();
    let power = |traces: &[Profile]| {
        let each = traces.iter().map(|trace| {
            let found = power_spectrum(&remove(trace, Form::Level).unwrap()).unwrap();
            let at = |wave: f64| (1.0 / (wave * found.frequency_step)) as usize;
            found.density[at(700e-6)..at(250e-6)].iter().sum::<f64>()
        });
        mean(each)
    };
    let made = (1..=60).map(|seed| like.generate(seed).unwrap().generated.profile);
    let ratio = (power(&made.collect::<Vec<_>>()) / power(&given)).sqrt();
    assert!((ratio - 1.0).abs() < 0.07, "{ratio}");
}

const SETS: usize = 25;
const MADE: u64 = 24;
const LEFT: usize = 200;

/// Traces of teeth whose heights scatter by `teeth`, the standard deviation of their logarithm.
fn of_teeth(finish: finishes::Finish, teeth: f64, count: usize, seed: u64) -> Vec<Profile> {
    use asperity_core::numerics::standard_normal_quantile;
    let each = finishes::traces(finish, count, seed)
        .into_iter()
        .enumerate();
    let scaled = each.map(|(k, trace)| {
        // A sequence of low discrepancy would scatter too little: hash of the number of the trace.
        let mut x =
            (seed << 20) + ((finish.0.len() as u64) << 50) + k as u64 + 0x9E37_79B9_7F4A_7C15;
        for _ in 0..3 {
            x = (x ^ (x >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            x = (x ^ (x >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            x ^= x >> 31;
        }
        let factor =
            teeth * standard_normal_quantile(((x >> 11) as f64 + 0.5) / (1_u64 << 53) as f64);
        let scaled = trace.heights().iter().map(|z| z * factor.exp()).collect();
        Profile::new(trace.spacing(), scaled).unwrap()
    });
    scaled.collect()
}

#[test]
#[ignore = "minutes; prints its table"]
fn scatter_of_generated_flanks() {
    const SHOWN: [usize; 10] = [0, 1, 2, 11, 12, 13, 14, 7, 9, 17];
    println!(
        "finish | teeth | method | {}",
        SHOWN.map(|k| NAMES[k]).join(" ")
    );
    for finish in FINISHES {
        for teeth in [0.0, 0.2] {
            let left: Vec<_> = of_teeth(finish, teeth, LEFT, 3)
                .iter()
                .map(parameters)
                .collect();
            let spread = |rows: &[[f64; 20]], k: usize| {
                deviation(&rows.iter().map(|row| row[k]).collect::<Vec<_>>()).unwrap()
            };
            let (mut ratios, mut means) = (vec![Vec::new(); 20], vec![Vec::new(); 20]);
            let mut method = Method::Pieces;
            for set in 0..SETS {
                let given = of_teeth(finish, teeth, 6, 100 + set as u64);
                let like = Like::to(&given[0], &given[1..], None).unwrap();
                method = like.method();
                let made: Vec<_> = (1..=MADE)
                    .map(|seed| {
                        parameters(
                            &like
                                .generate(1000 * set as u64 + seed)
                                .unwrap()
                                .generated
                                .profile,
                        )
                    })
                    .collect();
                let given: Vec<_> = given.iter().map(parameters).collect();
                for k in 0..20 {
                    ratios[k].push(spread(&made, k) / spread(&left, k));
                    let of = |rows: &[[f64; 20]]| mean(rows.iter().map(|row| row[k]));
                    means[k].push(of(&made) / of(&given));
                }
            }
            let median = |k: usize| {
                let mut all = ratios[k].clone();
                all.sort_by(f64::total_cmp);
                format!("{:.2}", 0.5 * (all[SETS / 2] + all[(SETS - 1) / 2]))
            };
            let of_mean = |k: usize| format!("{:.2}", mean(means[k].iter().copied()));
            println!(
                "{} | {teeth} | {method:?} | {} || {}",
                finish.0,
                SHOWN.map(median).join(" "),
                SHOWN.map(of_mean).join(" ")
            );
        }
    }
}

#[test]
#[ignore = "minutes; prints its table"]
fn waves_of_generated_flanks() {
    const ENDS: [f64; 8] = [20.0, 60.0, 150.0, 250.0, 400.0, 600.0, 1500.0, 3100.0];
    let power = |traces: &[Profile]| -> Vec<f64> {
        let spectra: Vec<_> = traces
            .iter()
            .map(|trace| power_spectrum(&remove(trace, Form::Level).unwrap()).unwrap())
            .collect();
        let band = |ends: &[f64]| {
            let each = spectra.iter().map(|found| {
                let lines = found.density.iter().enumerate().skip(1);
                let within = lines.filter(|(k, _)| {
                    let wave = 1e6 / (*k as f64 * found.frequency_step);
                    wave >= ends[0] && wave < ends[1]
                });
                within.map(|(_, density)| density).sum::<f64>()
            });
            mean(each)
        };
        ENDS.windows(2).map(band).collect()
    };
    for finish in FINISHES {
        let mut sums = vec![0.0; ENDS.len() - 1];
        for set in 0..3 {
            let given = finishes::traces(finish, 6, 500 + set);
            let like = Like::to(&given[0], &given[1..], Some(Method::Pieces)).unwrap();
            let made: Vec<_> = (1..=48)
                .map(|seed| like.generate(100 * set + seed).unwrap().generated.profile)
                .collect();
            for (sum, (a, b)) in sums.iter_mut().zip(power(&made).iter().zip(power(&given))) {
                *sum += (a / b).sqrt() / 3.0;
            }
        }
        println!(
            "{} | {}",
            finish.0,
            sums.iter()
                .map(|r| format!("{r:.2}"))
                .collect::<Vec<_>>()
                .join(" ")
        );
    }
}
