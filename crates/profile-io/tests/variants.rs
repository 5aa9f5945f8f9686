//! Kinds of exports in other languages, separators, orders and marks: each variant has the heights of its kind.

#![allow(clippy::unwrap_used, clippy::panic)]

use asperity_profile_io::read::{Gaps, ReadOptions, Reading, read_bytes, read_surface_bytes};

const POINTS: usize = 130;

/// Heights \[um\] with four decimals.
fn z(i: usize) -> f64 {
    let x = i as f64;
    (1e4 * (0.5 * (0.37 * x).sin() + 0.2 * (0.11 * x).cos())).round() / 1e4
}

/// A number with four decimals, and this decimal sign.
fn text(value: f64, comma: bool) -> String {
    let text = format!("{value:.4}");
    if comma { text.replace('.', ",") } else { text }
}

fn read(name: &str, text: &str, options: &ReadOptions) -> Reading {
    read_bytes(name, text.as_bytes(), options)
        .unwrap_or_else(|error| panic!("{error}\n{}", &text[..200]))
}

fn refused(text: &str) -> (String, String, &'static str) {
    let error = read_bytes("flank.csv", text.as_bytes(), &ReadOptions::default()).unwrap_err();
    (
        error.to_string(),
        error.remedy().to_string(),
        error.code().as_str(),
    )
}

fn assert_heights(reading: &Reading, spacing_um: f64, about: &str) {
    let heights = reading.profile.heights();
    assert_eq!(heights.len(), POINTS, "{about}");
    for (i, height) in heights.iter().enumerate() {
        assert!((height * 1e6 - z(i)).abs() < 1e-9, "{about}: {i}");
    }
    assert!(
        (reading.spacing.si() * 1e6 - spacing_um).abs() < 1e-9,
        "{about}"
    );
}

fn stated(dx: &str, unit: &str) -> ReadOptions {
    ReadOptions {
        dx: (!dx.is_empty()).then(|| dx.parse().unwrap()),
        z_unit: (!unit.is_empty()).then(|| unit.parse().unwrap()),
        ..ReadOptions::default()
    }
}

#[test]
fn points_with_pixel_numbers_ask_for_the_spacing_and_take_it() {
    let row = |y: usize, x: usize| z(x) + if y == 1 { 0.0 } else { 0.3 };
    for (first, separator, order, end, mark) in [
        ([12, 8], " ", "row", "", "No Data"),
        ([12, 8], " ", "row", "#\n", "No Data"),
        ([0, 0], " ", "row", "#\n", "no data"),
        ([0, 0], "\t", "row", "", "No Data"),
        ([0, 0], ",", "row", "", "No Data"),
        ([1, 1], ";", "row", "", "NaN"),
        ([1, 1], " ", "row", "\n#\n\n", "Bad"),
        ([5, 0], "  ", "row", "", "---"),
        ([0, 3], " ", "column", "#\n", "No Data"),
        ([0, 3], "\t", "column", "", "void"),
        ([100, 200], ", ", "row", "", "null"),
        ([100, 200], " ", "column", "", "No Value"),
    ] {
        let about = format!("{first:?} {separator:?} {order} {end:?} {mark}");
        let point = |x: usize, y: usize| {
            let height = match (x, y) {
                (7, 0) | (90, 2) => mark.to_owned(),
                _ => text(row(y, x), false),
            };
            format!(
                "{}{separator}{}{separator}{height}\n",
                x + first[0],
                y + first[1]
            )
        };
        let body: String = match order {
            "row" => (0..3 * POINTS)
                .map(|k| point(k % POINTS, k / POINTS))
                .collect(),
            _ => (0..3 * POINTS).map(|k| point(k / 3, k % 3)).collect(),
        };
        let body = body + end;
        let second = ReadOptions {
            row: Some(2),
            ..stated("", "um")
        };
        let asked = read_bytes("surface.xyz", body.as_bytes(), &second).unwrap_err();
        assert_eq!(asked.code(), "E110", "{about}: {asked}");
        let with = ReadOptions {
            dx: Some("2.5 um".parse().unwrap()),
            ..second
        };
        assert_heights(&read("surface.xyz", &body, &with), 2.5, &about);
    }
}

#[test]
fn points_of_which_some_are_left_out_are_on_their_grid() {
    for (dx, separator, comma, header, order, factor) in [
        (1.5, " ", false, "", "row", 1.0),
        (1.5, ";", true, "x [um];y [um];z [um]\n", "row", 1.0),
        (1.5, "\t", true, "X/µm\tY/µm\tZ/µm\n", "row", 1.0),
        (0.25, ",", false, "x (um),y (um),z (um)\n", "row", 1.0),
        (0.3333, " ", false, "", "row", 1.0),
        (2.0, ";", false, "", "column", 1.0),
        (1.5, "\t", false, "x [mm]\ty [mm]\tz [um]\n", "column", 1e-3),
        (1.5, " ", false, "# x y z\n", "column", 1.0),
        (1.5, ",", false, "X [um],Y [um],Z [um]\n", "reverse", 1.0),
        (0.5, ";", true, "x [µm];y [µm];z [µm]\n", "reverse", 1.0),
        (1.25, "  ", false, "", "reverse", 1.0),
        (1.5, "\t", false, "x [um]\ty [um]\tz [um]\n", "reverse", 1.0),
    ] {
        let about = format!("{dx} {separator:?} {comma} {header:?} {order}");
        let point = |x: usize, y: usize| {
            if [(0, 0), (3, 2), (77, 2), (129, 3)].contains(&(x, y)) {
                return String::new();
            }
            let place = |value: f64| {
                let text = format!("{:.6}", value * factor);
                if comma { text.replace('.', ",") } else { text }
            };
            let height = text(z(x) + if y == 1 { 0.0 } else { 0.4 }, comma);
            format!(
                "{}{separator}{}{separator}{height}\n",
                place(dx * x as f64),
                place(3.0 * y as f64)
            )
        };
        let count = 4 * POINTS;
        let body: String = match order {
            "row" => (0..count).map(|k| point(k % POINTS, k / POINTS)).collect(),
            "column" => (0..count).map(|k| point(k / 4, k % 4)).collect(),
            _ => (0..count)
                .rev()
                .map(|k| point(k % POINTS, k / POINTS))
                .collect(),
        };
        let options = ReadOptions {
            row: Some(2),
            x_unit: header.is_empty().then(|| "um".parse().unwrap()),
            z_unit: (!header.contains('[') && !header.contains('(') && !header.contains('/'))
                .then(|| "um".parse().unwrap()),
            ..ReadOptions::default()
        };
        let options = match header {
            "# x y z\n" => ReadOptions {
                x_unit: Some("um".parse().unwrap()),
                ..options
            },
            _ => options,
        };
        let reading = read("surface.xyz", &(header.to_owned() + &body), &options);
        assert_heights(&reading, dx, &about);
    }
}

#[test]
fn a_point_that_occurs_twice_is_another_scan() {
    let scan: String = (0..3 * POINTS)
        .map(|k| {
            format!(
                "{} {} {}\n",
                2 * (k % POINTS),
                k / POINTS,
                text(z(k % POINTS), false)
            )
        })
        .collect();
    let (message, remedy, code) = refused(&scan.repeat(2));
    assert_eq!(code, "E105");
    assert!(
        message.starts_with("flank.csv:391: the point x = 0, y = 0 occurs a second time"),
        "{message}"
    );
    assert!(
        remedy.starts_with("Export one scan to a file, or set columns, e.g. 1,3"),
        "{remedy}"
    );
}

#[test]
fn a_single_column_below_its_count_and_conditions_is_read() {
    let column =
        |comma: bool| -> String { (0..POINTS).map(|i| text(z(i), comma) + "\n").collect() };
    for (above, comma) in [
        ("130\n", false),
        ("130\n", true),
        ("N = 130\n", false),
        ("Points: 130\nlambda_c 0.8 mm\n", false),
        ("Anzahl Punkte 130\nTaststrecke 4,8 mm\n", true),
        ("Nombre de points;130\nVitesse;0,5\n", true),
        ("Numero di punti 130\n", false),
        ("Lc 0.8\nLs 0.0025\n130\n", false),
        ("Instrument\nDate 2026-01-31\n130\n", false),
        ("\u{feff}130\n", false),
        ("130\n\n", false),
        ("Profil 7\n\n130\n", true),
    ] {
        let body = above.to_owned() + &column(comma);
        let reading = read("flank.txt", &body, &stated("0.5 um", "um"));
        assert_heights(&reading, 0.5, above);
    }
}

#[test]
fn a_matrix_has_unit_and_spacing_from_the_pairs_of_its_head() {
    for (head, separator, comma, scale) in [
        (
            "\"Unit\",\"um\"\n\"XY Calibration\",\"1250\",\"nm\"\n",
            ",",
            false,
            1.0,
        ),
        (
            "\"Unit\",\"nm\"\n\"XY Calibration\",\"1250\",\"nm\"\n",
            ",",
            false,
            1e3,
        ),
        (
            "\"XY Calibration\",\"1.25\",\"um\"\n\"Unit\",\"um\"\n",
            ",",
            false,
            1.0,
        ),
        ("Unit,um\nXY Calibration,1250,nm\n", ",", false, 1.0),
        ("Unit;um\nXY Calibration;1250;nm\n", ";", false, 1.0),
        ("Unit;um\nXY Calibration;1,25;um\n", ";", true, 1.0),
        ("Unit\tum\nXY Calibration\t1250\tnm\n", "\t", false, 1.0),
        ("Unit\tum\nXY Calibration\t1,25\tum\n", "\t", true, 1.0),
        (
            "\"Unit\",\"mm\"\n\"XY Calibration\",\"1250\",\"nm\"\n",
            ",",
            false,
            1e-3,
        ),
        (
            "\"unit\",\"um\"\n\"xy calibration\",\"1250\",\"nm\"\n",
            ",",
            false,
            1.0,
        ),
        (
            "\"Measured\",\"2026-01-31\"\n\"Unit\",\"um\"\n\"XY Calibration\",\"1250\",\"nm\"\n",
            ",",
            false,
            1.0,
        ),
        (
            "\"Unit\",\"um\"\n\"XY Calibration\",\"1250\",\"nm\"\n\n",
            ",",
            false,
            1.0,
        ),
    ] {
        let rows: String = (0..4)
            .map(|row| {
                let cells = (0..POINTS).map(|i| {
                    let value = scale * (z(i) + if row == 2 { 0.0 } else { 0.4 });
                    let text = format!("{value:.7}");
                    if comma { text.replace('.', ",") } else { text }
                });
                cells.collect::<Vec<_>>().join(separator) + "\n"
            })
            .collect();
        let third = ReadOptions {
            row: Some(3),
            ..ReadOptions::default()
        };
        assert_heights(
            &read("surface.csv", &(head.to_owned() + &rows), &third),
            1.25,
            head,
        );
    }
}

#[test]
fn missing_points_have_the_marks_of_many_programs() {
    for mark in [
        "NaN",
        "nan",
        "Bad",
        "---",
        "null",
        "No Data",
        "n/a",
        "#N/A",
        "void",
        "ungültig",
        "-",
        "1.#QNAN",
        "masked",
        "",
        "-2147.483648",
        "-2147483648",
        "-2.147483648",
    ] {
        for separator in [";", "\t", ","] {
            let point = |i: usize| match i {
                40 | 41 | 99 => format!("{:.1}{separator}{mark}\n", 0.5 * i as f64),
                _ => format!("{:.1}{separator}{:.9}\n", 0.5 * i as f64, z(i)),
            };
            let body =
                format!("x [um]{separator}z [um]\n") + &(0..POINTS).map(point).collect::<String>();
            let refused = read_bytes("flank.csv", body.as_bytes(), &ReadOptions::default());
            assert_eq!(
                refused.unwrap_err().code(),
                "E107",
                "{mark:?} {separator:?}"
            );
            let filled = ReadOptions {
                gaps: Gaps::Interpolate,
                ..ReadOptions::default()
            };
            let reading = read("flank.csv", &body, &filled);
            assert_eq!(
                (reading.gaps_filled, reading.points),
                (3, POINTS),
                "{mark:?}"
            );
            let expected = z(39) + (z(42) - z(39)) / 3.0;
            assert!(
                (reading.profile.heights()[40] * 1e6 - expected).abs() < 1e-9,
                "{mark:?}"
            );
        }
    }
}

#[test]
fn mahr_points_have_three_or_five_values() {
    type Point = fn(usize, f64) -> String;
    let five: Point = |i, z| {
        format!(
            "{i}={:.6} 0.000000 {:.7} 0.000000 0\n",
            5e-4 * i as f64,
            1e-3 * z
        )
    };
    let three: Point = |i, z| format!("{i}={:.6} {:.7} 0\n", 5e-4 * i as f64, 1e-3 * z);
    let bare: Point = |i, z| format!("{i}={:.6} 0.000000 {:.7}\n", 5e-4 * i as f64, 1e-3 * z);
    let heads = [
        "[PROFILE_HEADER]\nINTERVAL_LIN=0.000500\nNO_POINTS=130\n[PROFILE_VALUES]\n",
        "[PROFILE_HEADER]\nNO_POINTS=130\n[PROFILE_HISTORY]\nProductName=MarSurf PS 10\n[PROFILE_VALUES]\n",
        "[PROFILE_HEADER]\n[PROFILE_VALUES]\n",
        "[PROFILE_HEADER]\nDateTime=2026-01-31 12:00:00\n[PROFILE_VALUES]\n// x z\n",
    ];
    for head in heads {
        for point in [five, three, bare] {
            let body: String = (0..POINTS).map(|i| point(i, z(i))).collect();
            let body = head.to_owned() + &body;
            assert_heights(
                &read("flank.txt", &body, &ReadOptions::default()),
                0.5,
                &body[..150],
            );
        }
    }
    let locked: String = (0..POINTS)
        .map(|i| three(i, z(i)).replace(" 0\n", if i == 50 { " 1\n" } else { " 0\n" }))
        .collect();
    let refused = read_bytes(
        "flank.txt",
        (heads[0].to_owned() + &locked).as_bytes(),
        &ReadOptions::default(),
    );
    assert_eq!(refused.unwrap_err().code(), "E107");
}

#[test]
fn the_bcr_proposal_marks_missing_points_with_its_largest_number() {
    for (magic, kind, mark, missing) in [
        ("aBCR-1.0", 0, "255", 1),
        ("aBCR-1.0", 1, "65535", 1),
        ("aBCR-1.0", 2, "4294967295", 1),
        ("aBCR-1.0", 3, "3.4E+38", 1),
        ("aBCR-1.0", 4, "127", 1),
        ("aBCR-1.0", 5, "32767", 1),
        ("aBCR-1.0", 5, "-32768", 1),
        ("aBCR-1.0", 6, "2147483647", 1),
        ("aBCR-1.0", 7, "1.7E+308", 1),
        ("aBCR-1.0", 5, "BAD", 1),
        ("aISO-1.0", 5, "BAD", 1),
        ("aISO-1.0", 5, "32767", 0),
    ] {
        let head = format!(
            "{magic}\nManufacID = x\nNumPoints = {POINTS}\nNumProfiles = 2\nXscale = 5e-7\nYscale = 5e-7\n\
             Zscale = 1e-9\nZresolution = -1\nCompression = 0\nDataType = {kind}\nCheckType = 0\n*\n"
        );
        let heights: Vec<String> = (0..2 * POINTS)
            .map(|k| {
                if k == 9 {
                    mark.to_owned()
                } else {
                    (k % 7).to_string()
                }
            })
            .collect();
        let text = head + &heights.join(" ") + "\n*\n";
        let surface = read_surface_bytes("a.sdf", text.as_bytes(), &ReadOptions::default());
        let surface = surface.unwrap_or_else(|error| panic!("{magic} {kind} {mark}: {error}"));
        let found = surface.z.iter().filter(|z| !z.is_finite()).count();
        assert_eq!(found, missing, "{magic} {kind} {mark}");
    }
}

#[test]
fn a_fault_that_repeats_says_what_the_file_seems_to_be() {
    let table = |row: &dyn Fn(usize) -> String| -> String {
        "x [um];z [um]\n".to_owned() + &(0..POINTS).map(row).collect::<String>()
    };
    let good = |i: usize| format!("{:.1};{}\n", 0.5 * i as f64, text(z(i), false));
    let with = |from: usize, bad: &dyn Fn(usize) -> String| {
        table(&|i| if i < from { good(i) } else { bad(i) })
    };
    type Row<'a> = (&'a str, String, &'a str, &'a str);
    let rows: [Row<'_>; 6] = [
        (
            "mark",
            with(90, &|i| match i % 3 {
                0 => format!("{:.1};lost\n", 0.5 * i as f64),
                _ => good(i),
            }),
            "; 14 lines are like it: line 92 \"45.0;lost\", line 95 \"46.5;lost\"; the file seems to mark missing points with \"lost\"",
            "Write NaN or nothing in place of the mark",
        ),
        (
            "unit",
            with(100, &|i| good(i).replace('\n', " um\n")),
            "; the numbers seem to be followed by the unit \"um\"",
            "Remove \"um\" from all rows and write it in the line of names, as z [um]",
        ),
        (
            "text",
            with(100, &|i| {
                format!("{:.1};{}\n", 0.5 * i as f64, ["a", "b"][i % 2])
            }),
            "; column 2 seems to hold text",
            "Export the position and the height as numbers",
        ),
        (
            "tables",
            with(100, &|i| format!("{i};1;2;3\n")),
            "; another table seems to begin here",
            "Export one table to a file, or delete the others",
        ),
        (
            "ragged",
            with(60, &|i| match i % 3 {
                0 => format!("{:.1};0;25\n", 0.5 * i as f64),
                _ => good(i),
            }),
            "; the file seems to have cells with its separator in them",
            "Export with ';' or a tab between the columns",
        ),
        (
            "sign",
            with(60, &|i| {
                format!("{:.1};{}\n", 0.5 * i as f64, text(z(i), true))
            }),
            "",
            "",
        ),
    ];
    for (kind, text, seems, advice) in rows {
        let (message, remedy, code) = refused(&text);
        assert!(["E101", "E111"].contains(&code), "{kind}: {message}");
        assert!(message.contains(seems), "{kind}: {message}");
        assert!(remedy.contains(advice), "{kind}: {remedy}");
        assert!(
            !remedy.contains("orrect or remove this line"),
            "{kind}: {remedy}"
        );
    }
    // A single wrong line is a wrong line.
    for bad in ["7.0;lost\n", "7.0;1;2\n"] {
        let (message, remedy, _) = refused(&with(0, &|i| {
            if i == 14 { bad.to_owned() } else { good(i) }
        }));
        assert_eq!(remedy, "Correct or remove this line", "{message}");
    }
}
