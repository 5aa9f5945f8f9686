//! What holds for every profile and every file.

#![allow(clippy::unwrap_used, clippy::panic)]

#[path = "common/drops.rs"]
mod drops;

use std::io::Cursor;

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_roughness::gaussian_filter::{Ends, mean_line};
use asperity_roughness::generate::SelfAffine;
use asperity_roughness::height_parameters::{Mode, in_sections};
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::preparation::{Preparation, prepare};
use asperity_roughness::read::{
    Columns, DecimalSign, Encoding, Gaps, LengthUnit, ReadOptions, Separator, read_bytes,
    read_stream,
};
use asperity_roughness::summits::asperity_radius;
use drops::Drops;
use proptest::prelude::*;

fn any_rough() -> impl Strategy<Value = Profile> {
    (any::<u64>(), 0.2..0.9f64, 20.0..200.0f64).prop_map(|(seed, hurst, roll_off)| {
        let recipe = SelfAffine {
            points: 4000,
            spacing: Length::from_si(0.5e-6),
            rq: Length::from_si(0.3e-6),
            hurst,
            roll_off: Length::from_si(roll_off * 1e-6),
            short_cut: Length::from_si(4e-6),
            seed,
        };
        recipe.generate().unwrap()
    })
}

fn map(profile: &Profile, f: impl Fn(f64) -> f64) -> Profile {
    Profile::new(
        profile.spacing(),
        profile.heights().iter().map(|z| f(*z)).collect(),
    )
    .unwrap()
}

fn close(a: f64, b: f64, relative: f64) -> bool {
    (a - b).abs() <= relative * a.abs().max(b.abs()).max(1e-30)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn heights_scale_and_shape_does_not(profile in any_rough(), factor in 0.01..100.0f64) {
        let scaled = map(&profile, |z| factor * z);
        for mode in [Mode::Iso4287, Mode::Iso21920] {
            let (a, b) = (in_sections(&profile, mode, 5).unwrap(), in_sections(&scaled, mode, 5).unwrap());
            for (a, b) in [(a.ra, b.ra), (a.rq, b.rq), (a.rp, b.rp), (a.rz, b.rz), (a.rt, b.rt)] {
                prop_assert!(close(a.si() * factor, b.si(), 1e-12));
            }
            prop_assert!(close(a.rku.unwrap(), b.rku.unwrap(), 1e-10));
            prop_assert!(close(a.rdq * factor, b.rdq, 1e-12));
            let order = a.ra <= a.rq && a.rq <= a.rt && a.rz <= a.rz1max && a.rz1max <= a.rt;
            prop_assert!(order || close(a.rz1max.si(), a.rt.si(), 1e-12));
        }
    }

    #[test]
    fn turning_a_profile_upside_down_swaps_peaks_and_pits(profile in any_rough()) {
        let turned = map(&profile, |z| -z);
        let (a, b) = (rk_parameters(profile.heights()).unwrap(), rk_parameters(turned.heights()).unwrap());
        prop_assert!(close(a.rk.si(), b.rk.si(), 1e-6));
        prop_assert!(close(a.rpk.si(), b.rvk.si(), 1e-5));
        prop_assert!(close(a.mr1, 100.0 - b.mr2, 1e-5));
        let (a, b) = (in_sections(&profile, Mode::Iso4287, 5).unwrap(), in_sections(&turned, Mode::Iso4287, 5).unwrap());
        prop_assert_eq!((a.rp, a.rv, a.ra), (b.rv, b.rp, b.ra));
        prop_assert!(close(a.rsk.unwrap(), -b.rsk.unwrap(), 1e-9));
    }

    #[test]
    fn running_a_profile_backwards_changes_no_height(profile in any_rough()) {
        let back = profile.mirrored();
        let recipe = Preparation { lambda_c: Some(Length::from_si(0.25e-3)), ..Preparation::default() };
        let (a, b) = (prepare(&profile, &recipe).unwrap(), prepare(&back, &recipe).unwrap());
        for (a, b) in a.profile.heights().iter().zip(b.profile.mirrored().heights()) {
            prop_assert!((a - b).abs() < 1e-18, "{} {}", a, b);
        }
        let radius = |p: &Profile| asperity_radius(p, Length::from_si(2.5e-6)).unwrap();
        prop_assert!(close(radius(&profile).radius.si(), radius(&back).radius.si(), 1e-9));
    }

    #[test]
    fn radius_falls_as_heights_grow(profile in any_rough(), factor in 0.1..10.0f64) {
        let lambda_s = Length::from_si(2.5e-6);
        let (a, b) = (
            asperity_radius(&profile, lambda_s).unwrap(),
            asperity_radius(&map(&profile, |z| factor * z), lambda_s).unwrap(),
        );
        prop_assert!(close(a.radius.si() / factor, b.radius.si(), 1e-9));
        prop_assert_eq!(a.count, b.count);
    }

    #[test]
    fn the_filter_is_linear_and_blind_to_an_offset(
        profile in any_rough(), factor in -3.0..3.0f64, offset in -0.1..0.1f64,
        ends in prop_oneof![Just(Ends::Cut), Just(Ends::Reg0), Just(Ends::Reg1), Just(Ends::Reflect)],
    ) {
        let cutoff = Length::from_si(80e-6);
        let line = mean_line(&profile, cutoff, ends).unwrap();
        let moved = mean_line(&map(&profile, |z| factor * z + offset), cutoff, ends).unwrap();
        for (w, moved) in line.iter().zip(&moved) {
            // Heights of 0.1 m are known to 1.4e-17.
            prop_assert!((factor * w + offset - moved).abs() < 1e-15);
        }
    }
}

/// Options as a user might state them, right or wrong.
fn any_options() -> impl Strategy<Value = ReadOptions> {
    use prop::option::weighted;
    let unit = || {
        weighted(
            0.3,
            prop_oneof![Just(LengthUnit::Millimetre), Just(LengthUnit::Micrometre)],
        )
    };
    let columns = weighted(
        0.2,
        (weighted(0.7, 0usize..4), 0usize..4).prop_map(|(x, z)| Columns { x, z }),
    );
    let separator = weighted(
        0.2,
        prop_oneof![
            Just(Separator::Semicolon),
            Just(Separator::Comma),
            Just(Separator::Blank),
            Just(Separator::None)
        ],
    );
    let decimal = weighted(
        0.2,
        prop_oneof![Just(DecimalSign::Point), Just(DecimalSign::Comma)],
    );
    let encoding = weighted(
        0.2,
        prop_oneof![
            Just(Encoding::Utf16Le),
            Just(Encoding::Utf8),
            Just(Encoding::Windows1252)
        ],
    );
    let dx = weighted(
        0.3,
        prop_oneof![Just(0.5e-6), Just(0.0), Just(f64::NAN), Just(1e300)],
    );
    let gaps = prop_oneof![Just(Gaps::Refuse), Just(Gaps::Interpolate)];
    (
        unit(),
        unit(),
        columns,
        separator,
        decimal,
        encoding,
        dx,
        gaps,
    )
        .prop_map(
            |(x_unit, z_unit, columns, separator, decimal, encoding, dx, gaps)| ReadOptions {
                x_unit,
                z_unit,
                dx: dx.map(Length::from_si),
                columns,
                decimal,
                separator,
                encoding,
                gaps,
                row: None,
            },
        )
}

/// A reading is a profile of finite heights on a positive grid, or an error with a code and a name, and
/// is the same however the bytes come.
fn reads_or_refuses(name: &str, bytes: &[u8], options: &ReadOptions) -> Result<(), TestCaseError> {
    let whole = read_bytes(name, bytes, options);
    // Each fourth file, for time.
    if bytes.len().is_multiple_of(4) {
        match (
            &whole,
            read_stream(name, Drops(Cursor::new(bytes)), options),
        ) {
            (Ok(whole), Ok(drops)) => prop_assert_eq!(whole, &drops),
            (Err(whole), Err(drops)) => prop_assert_eq!(whole.to_string(), drops.to_string()),
            (whole, drops) => prop_assert!(false, "{whole:?} at once, {drops:?} in drops"),
        }
    }
    match whole {
        Ok(reading) => {
            prop_assert!(reading.points >= 100 && reading.points == reading.profile.len());
            prop_assert!(reading.profile.heights().iter().all(|z| z.is_finite()));
            prop_assert!(reading.spacing.si() > 0.0);
        }
        Err(error) => {
            prop_assert!(error.code().starts_with("E1"));
            prop_assert!(error.to_string().starts_with(name));
        }
    }
    Ok(())
}

/// A valid file in one of several dialects.
fn any_file() -> impl Strategy<Value = String> {
    let shape = prop_oneof![
        Just(("x in um,z in um\n", ",", ".", "\n")),
        Just(("Weg [mm];Höhe [µm]\r\n", ";", ",", "\r\n")),
        Just(("", "\t", ".", "\r\r\n")),
        Just(("X Y\n[mm] [mm]\n", "  ", ",", " \n")),
    ];
    (shape, 100usize..160, any::<u32>()).prop_map(
        |((header, between, decimal, end), rows, seed)| {
            let mut text = header.to_owned();
            for i in 0..rows {
                let z = ((i as u64 * 2_654_435_761 + u64::from(seed)) % 1000) as f64 * 1e-3;
                text +=
                    &format!("{:.4}{between}{z:.4}{end}", 0.0005 * i as f64).replace('.', decimal);
            }
            text
        },
    )
}

/// A change of a few bytes: overwritten, removed, doubled or inserted.
fn mutate(bytes: &mut Vec<u8>, changes: &[(prop::sample::Index, u8, u8)]) {
    const TELLING: &[u8] = b",;.\t \r\n-+eE0\"[]\0\xff\xb5Nn";
    for (at, kind, byte) in changes {
        if bytes.is_empty() {
            return;
        }
        let at = at.index(bytes.len());
        let new = if kind & 4 == 0 {
            *byte
        } else {
            TELLING[usize::from(*byte) % TELLING.len()]
        };
        match kind % 4 {
            0 => bytes[at] = new,
            1 => drop(bytes.remove(at)),
            2 => bytes.insert(at, new),
            _ => {
                let end = (at + usize::from(*byte)).min(bytes.len());
                let piece = bytes[at..end].to_vec();
                bytes.splice(at..at, piece);
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5000))]

    #[test]
    fn any_bytes_are_read_or_refused_without_panic(
        bytes in prop::collection::vec(any::<u8>(), 0..600),
        name in prop_oneof![Just("a.csv"), Just("a.x3p"), Just("a"), Just("a.tx1"), Just("")],
        options in any_options(),
    ) {
        reads_or_refuses(name, &bytes, &options)?;
    }

    #[test]
    fn any_text_is_read_or_refused_without_panic(
        text in "([-+0-9eE.,;\t nNaAx_\\[\\]µm]{0,12}(\r|\n|\r\n)){0,140}",
        options in any_options(),
    ) {
        reads_or_refuses("a.csv", text.as_bytes(), &options)?;
    }

    #[test]
    fn a_damaged_file_is_read_or_refused_without_panic(
        file in any_file(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), any::<u8>()), 0..6),
        options in any_options(),
    ) {
        let mut bytes = file.into_bytes();
        mutate(&mut bytes, &changes);
        reads_or_refuses("flank.csv", &bytes, &options)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn one_damaged_height_is_refused_or_changes_only_itself(
        file in any_file(), at in any::<prop::sample::Index>(), byte in any::<u8>(),
    ) {
        let options = ReadOptions {
            x_unit: Some(LengthUnit::Millimetre), z_unit: Some(LengthUnit::Micrometre), ..ReadOptions::default()
        };
        let whole = read_bytes("a.csv", file.as_bytes(), &options).unwrap();
        // The last digit of each row in the table.
        let mut start = 0;
        let mut rows = Vec::new();
        for line in file.split_inclusive('\n') {
            let text = line.trim_end();
            if text.ends_with(|c: char| c.is_ascii_digit()) {
                rows.push(start + text.len() - 1);
            }
            start += line.len();
        }
        let mut bytes = file.into_bytes();
        bytes[rows[at.index(rows.len())]] = byte;
        if let Ok(damaged) = read_bytes("a.csv", &bytes, &options) {
            prop_assert_eq!(damaged.spacing, whole.spacing);
            let (a, b) = (damaged.profile.heights(), whole.profile.heights());
            let differing = a.iter().zip(b).filter(|(a, b)| a != b).count();
            prop_assert!(a.len() == b.len() && differing <= 1, "{} differ of {}/{}", differing, a.len(), b.len());
        }
    }
}
