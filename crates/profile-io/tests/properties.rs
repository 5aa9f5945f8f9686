//! Laws that hold for every file.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::io::Cursor;

use crate::drops::Drops;
use asperity_core::quantity::Length;
use asperity_profile_io::read::{
    Abscissa, Columns, DecimalSign, Encoding, Gaps, LengthUnit, ReadOptions, Separator, TraceLine,
    Uneven, read_bytes, read_stream,
};
use proptest::prelude::*;

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
    let roll = weighted(
        0.2,
        prop_oneof![Just(Abscissa::RollLength), Just(Abscissa::RollDegrees)],
    );
    let base_radius = weighted(0.3, prop_oneof![Just(50e-3), Just(0.0), Just(f64::NAN)]);
    let uneven = prop_oneof![Just(Uneven::Refuse), Just(Uneven::Resample)];
    let range = weighted(
        0.2,
        prop_oneof![
            Just("0 um .. 60 um"),
            Just("20 um .. 1 mm"),
            Just("1 m .. 2 m")
        ],
    );
    let invert = weighted(0.2, any::<bool>());
    let line = prop_oneof![
        8 => Just(TraceLine::Row),
        1 => Just(TraceLine::Column),
        1 => Just(TraceLine::Mean),
    ];
    (
        unit(),
        unit(),
        columns,
        separator,
        decimal,
        encoding,
        dx,
        gaps,
        (roll, base_radius, uneven, line, range, invert),
    )
        .prop_map(
            |(
                x_unit,
                z_unit,
                columns,
                separator,
                decimal,
                encoding,
                dx,
                gaps,
                (abscissa, base_radius, uneven, line, range, invert),
            )| ReadOptions {
                x_unit,
                z_unit,
                dx: dx.map(Length::from_si),
                dy: dx.map(Length::from_si),
                columns,
                decimal,
                separator,
                encoding,
                gaps,
                row: None,
                line,
                abscissa,
                base_radius: base_radius.map(Length::from_si),
                uneven,
                range: range.map(|range: &str| range.parse().unwrap()),
                invert,
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
            prop_assert!(error.code().as_str().starts_with("E1"));
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
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes_are_read_or_refused_without_panic(
        bytes in prop::collection::vec(any::<u8>(), 0..600),
        name in prop_oneof![Just("a.csv"), Just("a.x3p"), Just("a"), Just("a.tx1"), Just("")],
        options in any_options(),
    ) {
        reads_or_refuses(name, &bytes, &options)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

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
    #![proptest_config(ProptestConfig::with_cases(250))]

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
