//! Traces whose points are not evenly spaced: kept as they are, put on an even grid on request, refused where they are
//! no trace.

#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)]

use asperity_core::quantity::Length;
use asperity_core::{Code, Profile};
use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Format, Gaps, Metadata, Positions, ReadOptions, Trace, TraceRange, Uneven, read_bytes,
    read_trace_bytes,
};
use asperity_profile_io::write::{WrittenFormat, write, write_trace};
use proptest::prelude::*;

const DX: f64 = 0.5e-6;
/// Wavelength and height of the sine of the tests.
const WAVE: f64 = 40e-6;
const HEIGHT: f64 = 1e-6;

fn sine(x: f64) -> f64 {
    HEIGHT * (x / WAVE * std::f64::consts::TAU).sin()
}

/// Rising positions with steps between 0.2 and 1.8 of the mean.
fn uneven_x(shares: &[f64]) -> Vec<f64> {
    let steps = shares.iter().map(|share| DX * (0.2 + 1.6 * share));
    let mut x = vec![0.0];
    x.extend(steps.scan(0.0, |at, step| {
        *at += step;
        Some(*at)
    }));
    x
}

fn csv(x: &[f64], z: impl Fn(f64) -> f64) -> String {
    let row = |x: &f64| format!("{x:e},{:e}\n", z(*x));
    format!("x_m,z_m\n{}", x.iter().map(row).collect::<String>())
}

fn kept(name: &str, bytes: &[u8]) -> Trace {
    read_trace_bytes(name, bytes, &ReadOptions::default()).unwrap()
}

fn resampling() -> ReadOptions {
    ReadOptions {
        uneven: Uneven::Resample,
        ..ReadOptions::default()
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_position_is_kept_and_an_uneven_sine_met_within_its_bound(
        shares in prop::collection::vec(0.0..1.0_f64, 150..400),
        finer in 1.0..6.0_f64,
    ) {
        let x = uneven_x(&shares);
        let text = csv(&x, sine);
        let trace = kept("a.csv", text.as_bytes());
        prop_assert!(!trace.is_even());
        prop_assert_eq!(&trace.x()[..], &x[..]);
        prop_assert!(trace.heights.iter().zip(&x).all(|(z, x)| *z == sine(*x)));
        // A line between points h apart is at most h² max|z''|/8 off the curve.
        let steps = x.windows(2).map(|pair| pair[1] - pair[0]);
        let longest = steps.fold(0.0, f64::max);
        let bend = HEIGHT * (std::f64::consts::TAU / WAVE).powi(2);
        let bound = longest.powi(2) * bend / 8.0 * (1.0 + 1e-9) + 1e-18;
        let step = trace.spacing().si() / finer;
        let even = trace.resampled(Length::from_si(step)).unwrap();
        for (i, z) in even.profile.heights().iter().enumerate() {
            prop_assert!((z - sine(step * i as f64)).abs() <= bound, "{i}");
        }
        let covered = step * (even.profile.len() - 1) as f64;
        prop_assert!(covered <= trace.length().si() * (1.0 + 1e-9) && covered > trace.length().si() - 1.001 * step);
        // What is told of the change is below what it can be: two such lines.
        prop_assert!(even.rms <= even.most && even.most.si() <= 2.0 * bound);
        // In as many steps: the same as the reading.
        let reading = read_bytes("a.csv", text.as_bytes(), &resampling()).unwrap();
        prop_assert_eq!(reading.points, x.len());
        let resampled = |warning: &Warning| matches!(warning, Warning::Resampled { .. });
        prop_assert!(reading.warnings.iter().any(resampled));
        for (i, z) in reading.profile.heights().iter().enumerate() {
            prop_assert!((z - sine(reading.spacing.si() * i as f64)).abs() <= bound, "{i}");
        }
    }

    #[test]
    fn resampling_an_even_trace_in_its_step_changes_nothing(
        heights in prop::collection::vec(-1e-6..1e-6_f64, 100..300),
        dx in 1e-7..2e-6_f64,
    ) {
        let profile = Profile::new(Length::from_si(dx), heights).unwrap();
        let bytes = write(&profile, &Metadata::default(), WrittenFormat::X3p).unwrap();
        let trace = kept("a.x3p", &bytes);
        prop_assert_eq!(&trace.positions, &Positions::Even { spacing: profile.spacing() });
        let even = trace.resampled(trace.spacing()).unwrap();
        prop_assert_eq!(&even.profile, &profile);
        prop_assert_eq!((even.rms.si(), even.most.si()), (0.0, 0.0));
        // Half the step keeps every point and adds the middles.
        let halves = trace.resampled(trace.spacing() * 0.5).unwrap();
        prop_assert_eq!(halves.profile.len(), 2 * profile.len() - 1);
        for (i, pair) in profile.heights().windows(2).enumerate() {
            let found = &halves.profile.heights()[2 * i..2 * i + 2];
            prop_assert!((found[0] - pair[0]).abs() < 1e-15);
            prop_assert!((found[1] - 0.5 * (pair[0] + pair[1])).abs() < 1e-15);
        }
        prop_assert_eq!(trace.reading(Uneven::Resample).unwrap().profile, profile);
    }

    #[test]
    fn what_is_written_of_an_uneven_trace_reads_back_to_the_last_bit_or_the_one_before(
        shares in prop::collection::vec(0.0..1.0_f64, 150..300),
    ) {
        let trace = kept("a.csv", csv(&uneven_x(&shares), sine).as_bytes());
        for (name, format) in [("b.csv", WrittenFormat::Csv), ("b.x3p", WrittenFormat::X3p)] {
            let again = kept(name, &write_trace(&trace, format).unwrap());
            // CSV holds micrometres, which reach 19 of 20 numbers of metres.
            let most = if format == WrittenFormat::Csv { f64::EPSILON } else { 0.0 };
            let near = |(again, value): (&f64, &f64)| (again - value).abs() <= most * value.abs();
            prop_assert_eq!(again.heights.len(), trace.heights.len());
            prop_assert!(again.x().iter().zip(trace.x().iter()).all(near));
            prop_assert!(again.heights.iter().zip(&trace.heights).all(near));
        }
    }
}

/// Points on `x` µm with one taken for another.
fn with(index: usize, value: &str) -> String {
    let row = |i: usize| match i {
        i if i == index => format!("{value};0.1\n"),
        i => format!(
            "{:.3};0.1\n",
            0.5 * i as f64 + if i % 2 == 0 { 0.2 } else { 0.0 }
        ),
    };
    format!("x [um];z [um]\n{}", (0..300).map(row).collect::<String>())
}

#[test]
fn what_is_no_trace_is_refused() {
    let refused = |text: &str, options: &ReadOptions| {
        let even = read_bytes("a.csv", text.as_bytes(), options).unwrap_err();
        let kept = read_trace_bytes("a.csv", text.as_bytes(), options).unwrap_err();
        assert_eq!(even.to_string(), kept.to_string());
        (even.code().as_str(), even.place().1)
    };
    for options in [ReadOptions::default(), resampling()] {
        // x falls at 101, repeats itself at 102, is none at 103.
        assert_eq!(refused(&with(100, "49.0"), &options), ("E105", Some(102)));
        assert_eq!(refused(&with(101, "50.2"), &options), ("E105", Some(103)));
        assert_eq!(refused(&with(102, "NaN"), &options), ("E101", Some(104)));
    }
    assert!(kept("a.csv", with(999, "").as_bytes()).heights.len() == 300);
}

#[test]
fn uneven_points_are_told_by_the_worst_line_and_a_gap_by_its_ends() {
    let text = with(100, "50.45");
    let options = ReadOptions::default();
    let refused = read_bytes("a.csv", text.as_bytes(), &options).unwrap_err();
    assert_eq!((refused.code(), refused.place().1), (Code::E109, Some(102)));
    let start = "uneven spacing, x = 50.45 (unit of the file) is ";
    assert!(refused.fault.to_string().starts_with(start), "{refused}");
    let gap: String = (0..300)
        .map(|i| {
            format!(
                "{:.1};0.1\n",
                0.5 * f64::from(i) + if i > 150 { 9.0 } else { 0.0 }
            )
        })
        .collect();
    let gap = format!("x [um];z [um]\n{gap}");
    for options in [ReadOptions::default(), resampling()] {
        let refused = read_bytes("a.csv", gap.as_bytes(), &options).unwrap_err();
        assert_eq!(refused.code(), "E136", "{refused}");
        assert!(
            refused
                .to_string()
                .contains("between x = 75 um and 84.5 um"),
            "{refused}"
        );
    }
    let trace = kept("a.csv", gap.as_bytes());
    assert_eq!(trace.heights.len(), 300);
    assert_eq!(
        trace.resampled("1 um".parse().unwrap()).unwrap_err().code(),
        "E136"
    );
}

#[test]
fn steps_that_give_no_trace_are_refused() {
    let trace = kept("a.csv", with(999, "").as_bytes());
    for step in [0.0, -1e-6, f64::NAN, 1.0, 1e-9] {
        let refused = trace.resampled(Length::from_si(step)).unwrap_err();
        assert_eq!(refused.code(), "E116", "{step}: {refused}");
    }
    assert!(trace.resampled(trace.length()).is_ok());
}

#[test]
fn missing_points_are_left_out_and_never_moved() {
    let text = with(150, "75.1").replace("75.1;0.1", "75.1;NaN");
    assert_eq!(
        read_trace_bytes("a.csv", text.as_bytes(), &ReadOptions::default())
            .unwrap_err()
            .code(),
        "E107"
    );
    let filled = ReadOptions {
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    };
    let trace = read_trace_bytes("a.csv", text.as_bytes(), &filled).unwrap();
    assert_eq!((trace.heights.len(), trace.gaps_filled), (299, 1));
    assert_eq!(trace.warnings[0].code(), "W115");
    assert!(!trace.x().contains(&75.1e-6));
}

#[test]
fn a_falling_uneven_trace_is_turned_round() {
    let x = uneven_x(&[0.1, 0.9, 0.4, 0.7].repeat(50));
    let falling: Vec<f64> = x.iter().rev().copied().collect();
    let trace = kept("a.csv", csv(&falling, sine).as_bytes());
    assert_eq!(trace.x(), x);
    assert!(trace.heights.iter().zip(&x).all(|(z, x)| *z == sine(*x)));
    assert_eq!(trace.warnings, [Warning::Reversed]);
}

#[test]
fn mahr_points_keep_their_x() {
    let x = |i: usize| 12.0 + 5e-4 * (i as f64 + if i == 100 { 0.6 } else { 0.0 });
    let point = |i: usize| {
        format!(
            "{i}={:.9} 0.0 {:.9} 0.0 0\n",
            x(i),
            1e-3 * (0.1 * i as f64).sin()
        )
    };
    let points: String = (0..200).map(point).collect();
    let file =
        format!("[PROFILE_HEADER]\nINTERVAL_LIN=0.0005\nNO_POINTS=200\n[PROFILE_VALUES]\n{points}");
    let trace = kept("a.txt", file.as_bytes());
    assert_eq!(trace.format, Format::MahrText);
    assert!((trace.x()[100] - 12.0503e-3).abs() < 1e-15 && !trace.is_even());
    let refused = read_bytes("a.txt", file.as_bytes(), &ReadOptions::default()).unwrap_err();
    assert_eq!(
        (refused.code().as_str(), refused.place().1),
        ("E109", Some(105))
    );
    assert_eq!(
        read_bytes("a.txt", file.as_bytes(), &resampling())
            .unwrap()
            .points,
        200
    );
    // Without places the interval of the header holds.
    let still = file.replace("=12.", "=0.0 0.0 0.0 0.0 0\n//");
    let reading = read_bytes("a.txt", still.as_bytes(), &ReadOptions::default());
    assert_eq!(reading.unwrap().spacing, "0.5 um".parse().unwrap());
}

#[test]
fn points_along_an_involute_are_kept_too() {
    let roll = |i: usize| 8.0 + 0.002 * i as f64;
    let row = |i: usize| format!("{:.4};{:.6}\n", roll(i), (0.05 * i as f64).sin());
    let file = format!(
        "Roll length [mm];z [um]\n{}",
        (0..1000).map(row).collect::<String>()
    );
    let options = ReadOptions {
        base_radius: Some("40 mm".parse().unwrap()),
        ..ReadOptions::default()
    };
    let trace = read_trace_bytes("a.csv", file.as_bytes(), &options).unwrap();
    assert_eq!(trace.heights.len(), 1000);
    for (i, s) in trace.x().iter().enumerate() {
        assert!((s / (roll(i).powi(2) / 80e3) - 1.0).abs() < 1e-12, "{i}");
    }
    let reading = trace.reading(Uneven::Refuse).unwrap();
    assert_eq!(reading.warnings.last().unwrap().code(), "W127");
    assert_eq!(
        reading,
        read_bytes("a.csv", file.as_bytes(), &options).unwrap()
    );
}

#[test]
fn a_range_keeps_the_positions_of_its_points() {
    let x: Vec<f64> = (0..400)
        .map(|i| 2e-3 + 0.5e-6 * f64::from(i) + 0.2e-6 * f64::from(i % 2))
        .collect();
    let text = csv(&x, sine);
    let within = |range: &str| {
        let options = ReadOptions {
            range: Some(range.parse().unwrap()),
            ..ReadOptions::default()
        };
        read_trace_bytes("a.csv", text.as_bytes(), &options)
    };
    let part = within("20 um .. 0.12 mm").unwrap();
    assert_eq!(&part.x()[..], &x[40..241]);
    let cut = part.cut.unwrap();
    assert_eq!(cut.start, Length::from_si(x[40] - x[0]));
    assert_eq!(cut.of, Length::from_si(x[399] - x[0]));
    let refused = within("0 mm .. 0.3 mm").unwrap_err();
    assert_eq!(refused.code(), "E139");
    assert!(
        refused.to_string().contains("which is 199.7 um long"),
        "{refused}"
    );
    assert_eq!(within("0 um .. 10 um").unwrap_err().code(), "E106");
    for wrong in ["3 mm .. 1 mm", "-1 mm .. 1 mm", "1 mm", "1 .. 2"] {
        assert!(wrong.parse::<TraceRange>().is_err(), "{wrong}");
    }
}
