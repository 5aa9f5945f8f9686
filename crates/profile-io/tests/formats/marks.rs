//! Words instead of heights, thousands separators, and distances from a sensor.

use asperity_profile_io::Warning;
use asperity_profile_io::read::{
    Gaps, ReadError, ReadOptions, Reading, read_bytes, read_surface_bytes,
};

use super::samples::*;

fn filled(text: &str) -> Result<Reading, ReadError> {
    let options = ReadOptions {
        gaps: Gaps::Interpolate,
        dx: (!text.contains("x [")).then(|| "0.5 um".parse().unwrap()),
        z_unit: "um".parse().ok(),
        ..ReadOptions::default()
    };
    read_bytes("a.csv", text.as_bytes(), &options)
}

fn refused(text: &str) -> (String, String) {
    let options = ReadOptions {
        dx: (!text.contains("x [")).then(|| "0.5 um".parse().unwrap()),
        z_unit: "um".parse().ok(),
        ..ReadOptions::default()
    };
    let error = read_bytes("a.csv", text.as_bytes(), &options).unwrap_err();
    (
        format!("{} {error}", error.code()),
        error.remedy().to_string(),
    )
}

#[test]
fn any_word_in_place_of_a_height_is_a_missing_point_that_is_filled_on_request() {
    let is_missing = |i: usize| [40, 41, 90, 150].contains(&i);
    for mark in [
        "OVER",
        "****",
        "out of range",
        "lost",
        "kaputt",
        "hors échelle",
        "<<<",
        "?",
        "測定不能",
        "#DIV/0!",
        "+++++",
    ] {
        for (separator, comma) in [
            (",", false),
            (";", true),
            ("\t", true),
            (" ", false),
            ("  ", true),
        ] {
            let number = |value: f64| {
                let text = format!("{value:.4}");
                if comma { text.replace('.', ",") } else { text }
            };
            let row = |i: usize| {
                let z = if is_missing(i) {
                    mark.to_owned()
                } else {
                    number(height(i))
                };
                format!("{}{separator}{z}\n", number(0.5 * i as f64))
            };
            let text = format!(
                "x [um]{separator}z [um]\n{}",
                (0..POINTS).map(row).collect::<String>()
            );
            // A mark with a digit is none of these, and is named where it repeats often.
            if mark.contains('0') {
                assert!(refused(&text).0.starts_with("E101"), "{mark}");
                continue;
            }
            let (said, remedy) = refused(&text);
            assert!(
                said.starts_with("E107 a.csv:42: 4 of 240 points have no height, the first reads")
                    && said.contains(mark),
                "{said}"
            );
            assert_eq!(remedy, "Set gaps to interpolate to fill them");
            let reading = filled(&text).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!((reading.points, reading.gaps_filled), (POINTS, 4), "{mark}");
            let between = 0.5 * (height(89) + height(91));
            assert!(
                (reading.profile.heights()[90] * 1e6 - between).abs() < 1e-4,
                "{mark}"
            );
        }
    }
}

#[test]
fn marks_in_the_first_rows_are_rows_and_those_of_a_matrix_are_missing_points() {
    let row = |i: usize| {
        let z = if i < 3 {
            "OVER".to_owned()
        } else {
            format!("{:.4}", height(i))
        };
        format!("{:.1};{z}\n", 0.5 * i as f64)
    };
    let text = format!(
        "x [um];z [um]\n{}",
        (0..POINTS).map(row).collect::<String>()
    );
    assert!(
        refused(&text)
            .0
            .contains("a.csv:2: 3 of 240 points have no height")
    );
    let reading = filled(&text).unwrap();
    assert_eq!(reading.points, POINTS - 3);
    let line = |k: usize| {
        let cell = |i: usize| {
            if i == 7 * k + 5 {
                "OVER".to_owned()
            } else {
                format!("{:.4}", height(i))
            }
        };
        (0..POINTS).map(cell).collect::<Vec<_>>().join("\t") + "\n"
    };
    let matrix: String = (0..4).map(line).collect();
    let options = ReadOptions {
        z_unit: "um".parse().ok(),
        ..ReadOptions::default()
    };
    let surface = read_surface_bytes("a.txt", matrix.as_bytes(), &options).unwrap();
    assert_eq!((surface.rows, surface.z.len() - surface.measured()), (4, 4));
    let row = ReadOptions {
        row: Some(2),
        dx: "0.5 um".parse().ok(),
        ..options
    };
    let refused = read_bytes("a.txt", matrix.as_bytes(), &row).unwrap_err();
    let said = "1 of 240 points have no height, the first is column 13 of row 2, \"OVER\"";
    assert!(refused.to_string().ends_with(said), "{refused}");
}

#[test]
fn a_word_in_a_single_column_is_a_mark_if_it_occurs_again_and_else_the_head_of_another_trace() {
    let column = |words: &[(usize, &str)]| -> String {
        let line = |i: usize| match words.iter().find(|(at, _)| *at == i) {
            Some((_, word)) => format!("{word}\n"),
            None => format!("{:.4}\n", height(i)),
        };
        (0..POINTS).map(line).collect()
    };
    let twice = column(&[(50, "OVER"), (120, "OVER")]);
    assert!(
        refused(&twice)
            .0
            .starts_with("E107 a.csv:51: 2 of 240 points")
    );
    assert_eq!(filled(&twice).unwrap().gaps_filled, 2);
    let once = column(&[(120, "Profile")]);
    for said in [
        refused(&once),
        (filled(&once).unwrap_err().to_string(), String::new()),
    ] {
        assert!(
            said.0.contains("cannot read \"Profile\" as a number"),
            "{said:?}"
        );
    }
    assert_eq!(
        refused(&once).1,
        "Correct this line, with NaN for a missing height"
    );
}

#[test]
fn thousands_separators_are_read_or_named() {
    let grouped = |value: f64, group: &str, point: &str| {
        let text = format!("{value:.2}");
        let (whole, decimals) = text.split_once('.').unwrap();
        let whole = match whole.len() {
            4.. => format!(
                "{}{group}{}",
                &whole[..whole.len() - 3],
                &whole[whole.len() - 3..]
            ),
            _ => whole.to_owned(),
        };
        format!("{whole}{point}{decimals}")
    };
    for (separator, group, point, quote) in [
        (",", ",", ".", "\""),
        (";", ",", ".", ""),
        (";", ".", ",", ""),
        ("\t", "'", ".", ""),
        ("\t", "\u{2019}", ",", ""),
        (";", " ", ",", ""),
        ("\t", "\u{a0}", ",", ""),
        (";", "\u{202f}", ".", ""),
    ] {
        let row = |i: usize| {
            let x = grouped(20.0 * i as f64, group, point);
            let z = format!("{:.5}", height(i)).replace('.', point);
            format!("{quote}{x}{quote}{separator}{quote}{z}{quote}\n")
        };
        let text = format!(
            "x [um]{separator}z [um]\n{}",
            (0..POINTS).map(row).collect::<String>()
        );
        let reading = read_bytes("a.csv", text.as_bytes(), &ReadOptions::default());
        let reading = reading.unwrap_or_else(|error| panic!("{group}: {error}"));
        assert_eq!(reading.points, POINTS, "{group}");
        assert!(
            (reading.length.si() - 20e-6 * (POINTS - 1) as f64).abs() < 1e-12,
            "{group}"
        );
    }
    // Whole numbers with a separator may be numbers with three decimals.
    let whole = |group: &str, point: &str| -> String {
        let row = |i: usize| {
            let x = grouped(20.0 * i as f64, group, ".00").replace(".0000", "");
            format!("{x};{}\n", format!("{:.5}", height(i)).replace('.', point))
        };
        format!(
            "x [um];z [um]\n{}",
            (0..POINTS).map(row).collect::<String>()
        )
    };
    let named = "Export the numbers without thousands separators";
    for text in [
        whole(".", ","),
        whole(",", "."),
        whole(".", "."),
        whole(",", ","),
    ] {
        let (said, remedy) = refused(&text);
        assert_eq!(remedy, named, "{said}");
    }
    // Blanks and commas that separate columns cannot group, too.
    for sign in [" ", ","] {
        let (said, remedy) = refused(&whole(sign, ".").replace(';', sign));
        assert!(remedy == named, "{said}");
    }
}

#[test]
fn distances_from_a_sensor_are_turned_as_depths_are() {
    let of = |name: &str| {
        let row = |i: usize| format!("{:.4},{:.4}\n", 0.5e-3 * i as f64, 500.0 - height(i));
        let text = format!(
            "Position (mm),{name}\n{}",
            (0..POINTS).map(row).collect::<String>()
        );
        read_bytes("a.csv", text.as_bytes(), &ReadOptions::default()).unwrap()
    };
    for name in [
        "Distance to sensor (um)",
        "Abstand zum Sensor (µm)",
        "stand-off [um]",
    ] {
        let reading = of(name);
        assert_eq!(reading.warnings, [Warning::DepthsTurned], "{name}");
        let z = reading.profile.heights();
        assert!(
            (1e6 * (z[9] - z[0]) - (height(9) - height(0))).abs() < 2e-4,
            "{name}"
        );
    }
    assert!(of("Height (um)").warnings.is_empty());
}
