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
        ("Distance 4.8 mm\n130\n", false),
        ("Altura 7\nLongitud 4,8 mm\n130\n", true),
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
    // In another dialect: separator, and whether the decimal sign is a comma.
    let in_dialect = |separator: &str, comma: bool, bad: &dyn Fn(usize) -> String| -> String {
        let cell = |value: f64| text(value, comma);
        let row = |i: usize| match bad(i) {
            bad if i >= 60 && i.is_multiple_of(3) => {
                format!("{}{separator}{bad}\n", cell(0.5 * i as f64))
            }
            _ => format!("{}{separator}{}\n", cell(0.5 * i as f64), cell(z(i))),
        };
        format!("x [um]{separator}z [um]\n") + &(0..POINTS).map(row).collect::<String>()
    };
    type Row<'a> = (&'a str, String, &'a str, &'a str);
    let rows: [Row<'_>; 10] = [
        (
            "mark",
            with(90, &|i| match i % 3 {
                0 => format!("{:.1};1.#LOST\n", 0.5 * i as f64),
                _ => good(i),
            }),
            "; 14 lines look like this: line 92 \"45.0;1.#LOST\", line 95 \"46.5;1.#LOST\"; the file seems to mark missing points with \"1.#LOST\"",
            "Write NaN instead of the mark",
        ),
        (
            "unit",
            with(100, &|i| good(i).replace('\n', " um\n")),
            "; the numbers seem to be followed by the unit \"um\"",
            "Remove \"um\" from all rows and write it in the line of names, as z [um]",
        ),
        (
            "unit without a blank, between tabs",
            in_dialect("\t", true, &|i| text(z(i), true) + "µm"),
            "; the numbers seem to be followed by the unit \"µm\"",
            "Remove \"µm\" from all rows and write it in the line of names, as z [µm]",
        ),
        (
            "unit of some rows, between commas",
            in_dialect(",", false, &|i| text(z(i), false) + " nm"),
            "; the numbers seem to be followed by the unit \"nm\"",
            "Remove \"nm\" from all rows and write it in the line of names, as z [nm]",
        ),
        (
            "text beside two columns of numbers",
            "x [um];z [um];t [um]\n".to_owned()
                + &(0..POINTS)
                    .map(|i| {
                        let place = format!("{:.1}", 0.5 * i as f64);
                        let x = if i < 60 {
                            &place
                        } else {
                            ["left", "right"][i % 2]
                        };
                        format!("{x};{};{place}\n", text(z(i), false))
                    })
                    .collect::<String>(),
            "; column 1 seems to hold text",
            "Set columns, e.g. 2,3",
        ),
        (
            "tables",
            with(100, &|i| format!("{i};1;2;3\n")),
            "; another table seems to begin here",
            "Export one table to a file, or delete the others",
        ),
        (
            "tables with names",
            with(60, &|i| match i {
                60 => "Second scan\nx [um];z [um]\n".to_owned() + &good(i),
                _ => good(i),
            }),
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
            "decimal commas between commas",
            in_dialect(",", false, &|i| text(z(i), true)),
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
    for (bad, advice) in [
        (
            "7.0;l05t\n",
            "Correct this line, with NaN for a missing height",
        ),
        ("7.0;1;2\n", "Correct or remove this line"),
    ] {
        let (message, remedy, _) = refused(&with(0, &|i| {
            if i == 14 { bad.to_owned() } else { good(i) }
        }));
        assert_eq!(remedy, advice, "{message}");
    }
}

#[test]
fn the_names_of_columns_decide_in_every_language() {
    for (x, height, separator, comma) in [
        ("Position", "Height", ",", false),
        ("Taststrecke", "Höhe", ";", true),
        ("Distance", "Hauteur", ";", true),
        ("Distancia", "Altura", ";", true),
        ("Posizione", "Altezza", "\t", true),
        ("Distância", "Altura", ";", true),
        ("Afstand", "Hoogte", ";", true),
        ("Avstånd", "Höjd", "\t", true),
        ("Afstand", "Højde", ";", true),
        ("Matka", "Korkeus", "\t", true),
        ("Vzdálenost", "Výška", ";", true),
        ("Odległość", "Wysokość", ";", true),
        ("Távolság", "Magasság", ";", true),
        ("Mesafe", "Yükseklik", ";", true),
        ("Расстояние", "Высота", ";", true),
        ("距離", "高さ", ",", false),
        ("距离", "高度", ",", false),
        ("거리", "높이", ",", false),
    ] {
        let cell = |value: f64| text(value, comma);
        let file = |names: [&str; 2], row: &dyn Fn(usize) -> [f64; 2]| {
            let row = |i: usize| row(i).map(cell).join(separator) + "\n";
            names.join(separator) + "\n" + &(0..POINTS).map(row).collect::<String>()
        };
        let names = [format!("{x} [µm]"), format!("{height} [µm]")];
        let [x_name, z_name] = names.each_ref().map(String::as_str);
        let place = |i: usize| 0.5 * i as f64;
        let usual = file([x_name, z_name], &|i| [place(i), z(i)]);
        let turned = file([z_name, x_name], &|i| [z(i), place(i)]);
        for text in [usual, turned] {
            let reading = read("flank.csv", &text, &ReadOptions::default());
            assert_heights(&reading, 0.5, &text[..60]);
        }
    }
}

#[test]
fn heights_alone_take_spacing_and_unit_from_the_lines_above_in_every_language() {
    for (spacing, unit, separator, comma) in [
        ("Spacing,0.5,um", "Unit,um", ",", false),
        ("Point spacing = 0.5 um", "Z unit = um", ",", false),
        ("Punktabstand;0,5;µm", "Einheit;µm", ";", true),
        ("XY-Justierung;500;nm", "Einheit;µm", ";", true),
        ("Messpunktabstand: 0,5 µm", "Einheit: µm", ";", true),
        ("Pas d'échantillonnage;0,5;µm", "Unité;µm", ";", true),
        ("Pas\t0,5\tµm", "Unité\tµm", "\t", true),
        ("Paso;0,5;um", "Unidad;um", ";", true),
        ("Paso de muestreo: 0,5 um", "Unidad: um", ";", true),
        ("Passo di campionamento;0,5;µm", "Unità;µm", ";", true),
        ("Espaçamento;0,5;µm", "Unidade;µm", ";", true),
        ("Pitch;0,5;um", "Unit;um", ";", true),
    ] {
        for [first, second] in [[spacing, unit], [unit, spacing]] {
            let column: String = (0..POINTS).map(|i| text(z(i), comma) + "\n").collect();
            let body = format!("{first}\n{second}\n{column}");
            let reading = read("flank.txt", &body, &ReadOptions::default());
            assert_heights(&reading, 0.5, &format!("{first} {second} {separator}"));
        }
    }
}

#[test]
fn zygo_text_of_every_program_has_spacing_unit_and_missing_points() {
    for (program, comment, phase, origin, end, line_end, mark) in [
        (
            "0 0 0 0",
            "\"flank\"",
            "0 0 300 20 1 255",
            [12, 8],
            "#\n",
            "\n",
            "No Data",
        ),
        (
            "0 8 0 0",
            "\"      \"",
            "0 0 0 0 0 0",
            [0, 0],
            "#\n",
            "\n",
            "No Data",
        ),
        (
            "1 3 2 0",
            "\"\"",
            "0 0 0 0 0 0",
            [0, 0],
            "",
            "\n",
            "No Data",
        ),
        (
            "0 3 0 0",
            "\"Zahnflanke links\"",
            "0 0 130 3 1 255",
            [1, 1],
            "#\n",
            "\r\n",
            "No Data",
        ),
        (
            "2 8 3 9",
            "\"flanc\"",
            "0 0 640 480 1 1023",
            [255, 0],
            "#\r\n",
            "\r\n",
            "no data",
        ),
        (
            "0 0 0 0",
            "\"\"",
            "0 0 0 0 0 0",
            [0, 500],
            "#\n\n\n",
            "\n",
            "NaN",
        ),
        (
            "0 8 0 0",
            "\"\"",
            "0 0 0 0 0 0",
            [7, 0],
            " #\n",
            "\n",
            "Bad",
        ),
        (
            "0 8 0 0",
            "\"1 2 3 4\"",
            "0 0 0 0 0 0",
            [0, 0],
            "",
            "\n",
            "---",
        ),
        (
            "0 8 0 0",
            "#1",
            "0 0 0 0 0 0",
            [0, 0],
            "#\n",
            "\n",
            "No Data",
        ),
        ("0 8 0 0", "", "0 0 0 0 0 0", [0, 0], "#\n", "\n", "null"),
        (
            "0 8 0 0",
            "\"歯面\"",
            "0 0 0 0 0 0",
            [0, 0],
            "#\n",
            "\n",
            "No Data",
        ),
        (
            "0 8 0 0",
            "\"\"",
            "0 0 0 0 0 0",
            [1023, 1023],
            "#\n",
            "\r\n",
            "n/a",
        ),
    ] {
        let about = format!("{program} {comment} {origin:?} {end:?} {mark}");
        let head = [
            "Zygo XYZ Data File - Format 1",
            &format!("{program} \"Mon Nov 02 10:00:00 2026\""),
            phase,
            &format!("{} {} {POINTS} 3", origin[0], origin[1]),
            comment,
            "\"\"",
            "\"\"",
            "0 0.5 5.79245e-07 0.08 1 0 2.5e-06 1773929740",
            "1024 1024 0 0 80044 0 \"\"",
            "0 0 0 0 0 0 0 8.94484 0 0",
            "#",
        ]
        .join(line_end);
        let point = |k: usize| {
            let (x, y) = (k % POINTS, k / POINTS);
            let height = match (x, y) {
                (7, 0) | (90, 2) => mark.to_owned(),
                _ => text(z(x) + if y == 1 { 0.0 } else { 0.3 }, false),
            };
            format!("{} {} {height}{line_end}", x + origin[0], y + origin[1])
        };
        let body: String = (0..3 * POINTS).map(point).collect();
        let body = format!("{head}{line_end}{body}{end}");
        let row = |row: usize| ReadOptions {
            row: Some(row),
            ..ReadOptions::default()
        };
        assert_heights(&read("flank.xyz", &body, &row(2)), 2.5, &about);
        let missing = read_bytes("flank.xyz", body.as_bytes(), &row(1)).unwrap_err();
        assert_eq!(missing.code(), "E107", "{about}: {missing}");
        // Without its resolution it asks for the spacing.
        let bare = body.replace("2.5e-06", "0");
        let asked = read_bytes("flank.xyz", bare.as_bytes(), &row(2)).unwrap_err();
        assert_eq!(asked.code(), "E110", "{about}: {asked}");
        let told = ReadOptions {
            dx: Some("2.5 um".parse().unwrap()),
            ..row(2)
        };
        assert_heights(&read("flank.xyz", &bare, &told), 2.5, &about);
    }
}

#[test]
fn a_matrix_whose_rows_start_with_their_numbers_has_the_points_that_it_states() {
    for (head, separator, comma, width) in [
        ("Number of Points,130\n", ",", false, 0),
        ("Points per trace\t130\nTrace\tData\n", "\t", false, 0),
        ("Anzahl Punkte;130\nAnzahl Profile;3\n", ";", true, 0),
        (
            "Number of Points\t130\r\nNumber of Traces\t3\r\n\r\nTrace\tData\r\n",
            "\t",
            false,
            9,
        ),
        ("Messpunkte: 130\n", ";", true, 0),
        ("# number of points: 130\n", " ", false, 0),
        ("Points = 130\n", "\t", true, 10),
        ("Samples per trace,130\n", ",", false, 8),
        ("Data points;130\n", ";", false, 0),
        ("No. of points 130\n", "  ", false, 0),
        ("\u{feff}Punkte;130\n", ";", true, 0),
        ("Part 7\nPoints per line,130\nx\n", ",", false, 0),
    ] {
        let row = |row: usize| {
            let cells = (0..POINTS).map(|i| {
                let value = text(z(i) + if row == 2 { 0.0 } else { 0.4 }, comma);
                format!("{separator}{value:>width$}")
            });
            format!("{row}{}\n", cells.collect::<String>())
        };
        let body = head.to_owned() + &(1..4).map(row).collect::<String>();
        let second = ReadOptions {
            row: Some(2),
            ..stated("1.25 um", "um")
        };
        assert_heights(&read("surface.txt", &body, &second), 1.25, head);
        let surface = read_surface_bytes("surface.txt", body.as_bytes(), &second).unwrap();
        assert_eq!((surface.columns, surface.rows), (POINTS, 3), "{head}");
        // A height before the others is not the number of its row.
        let other = body.replace("\n3", "\n5");
        let error = read_bytes("surface.txt", other.as_bytes(), &second).unwrap_err();
        assert_eq!(error.code(), "E117", "{head}: {error}");
    }
}

#[test]
fn a_trace_over_the_edge_of_a_flank_proposes_the_range_that_is_left() {
    /// Points of a trace 4 mm long, of which the last `FALL` lie over the edge.
    const LONG: usize = 8000;
    const FALL: usize = 1000;
    for (names, separator, comma, at_start, falls, factor) in [
        (["x [um]", "z [um]"], ",", false, false, false, 1.0),
        (["x [um]", "z [um]"], ",", false, true, false, 1.0),
        (["Weg [µm]", "Höhe [µm]"], ";", true, false, false, 1.0),
        (["Weg [µm]", "Höhe [µm]"], ";", true, true, false, 1.0),
        (["x (um)", "z (um)"], "\t", false, false, true, 1.0),
        (["x (um)", "z (um)"], "\t", false, true, true, 1.0),
        (["x_um", "z_nm"], ",", false, false, false, 1e3),
        (["x_um", "z_nm"], ";", false, true, false, 1e3),
        (
            ["Distance [µm]", "Hauteur [nm]"],
            ";",
            true,
            false,
            false,
            1e3,
        ),
        (
            ["Posizione [µm]", "Quota [nm]"],
            "\t",
            true,
            true,
            false,
            1e3,
        ),
        (["x [um]", "Depth [um]"], ",", false, false, false, -1.0),
        (["x [um]", "Tiefe [µm]"], ";", true, true, false, -1.0),
    ] {
        let about = format!("{names:?} {separator:?} {at_start} {falls}");
        let height = |i: usize| {
            let from_end = if at_start { i } else { LONG - 1 - i };
            let fall = FALL.saturating_sub(from_end).min(20) as f64;
            0.3 * (0.05 * i as f64).sin() - 3.0 * fall
        };
        let row = |i: usize| {
            let i = if falls { LONG - 1 - i } else { i };
            let place = text(0.5 * i as f64, comma);
            format!("{place}{separator}{}\n", text(factor * height(i), comma))
        };
        let body = names.join(separator) + "\n" + &(0..LONG).map(row).collect::<String>();
        let refused = read("edge.csv", &body, &ReadOptions::default());
        let refused = refused.check_heights().unwrap_err();
        assert_eq!(refused.code(), "E131", "{about}: {refused}");
        let remedy = refused.remedy().to_string();
        let range = remedy.strip_prefix("Set range to ");
        let range = range.and_then(|rest| rest.split(" to use").next());
        let range = range.unwrap_or_else(|| panic!("{about}: {remedy}"));
        let part = ReadOptions {
            range: Some(
                range
                    .parse()
                    .unwrap_or_else(|_| panic!("{about}: {remedy}")),
            ),
            ..ReadOptions::default()
        };
        let part = read("edge.csv", &body, &part);
        assert!(part.check_heights().is_ok(), "{about}: {range}");
        // Nearly all of the flank is left.
        assert!(
            part.points > LONG - FALL - 120,
            "{about}: {range}, {}",
            part.points
        );
    }
}

#[test]
fn a_rounded_edge_is_an_edge_and_relief_is_none() {
    /// Points of a trace 3 mm long, of which the last `FALL` round the edge.
    const LONG: usize = 6000;
    const FALL: usize = 200;
    let body = |depth: f64, over: usize| {
        let z = |i: usize| {
            let beyond = (i + over).saturating_sub(LONG) as f64 / over as f64;
            0.3 * (0.05 * i as f64).sin() - depth * beyond * beyond
        };
        let rows = (0..LONG).map(|i| format!("{},{}\n", 0.5 * i as f64, z(i)));
        "x [um],z [um]\n".to_owned() + &rows.collect::<String>()
    };
    let edge = body(200.0, FALL);
    let refused = read("edge.csv", &edge, &ReadOptions::default());
    let refused = refused.check_heights().unwrap_err();
    assert_eq!(refused.code(), "E131", "{refused}");
    let remedy = refused.remedy().to_string();
    let range = remedy.strip_prefix("Set range to ");
    let range = range.and_then(|rest| rest.split(" to use").next()).unwrap();
    let stated = ReadOptions {
        range: Some(range.parse().unwrap()),
        ..ReadOptions::default()
    };
    let part = read("edge.csv", &edge, &stated);
    assert!(part.check_heights().is_ok(), "{range}");
    let [low, high] = part
        .profile
        .heights()
        .iter()
        .fold([0.0_f64; 2], |[low, high], z| [low.min(*z), high.max(*z)]);
    // What is left of the rounding is no more than the waves of the flank.
    assert!(
        high - low < 2e-6 && part.points > LONG - FALL - 120,
        "{range}"
    );
    // Relief of the tip: 20 um over a third of the trace.
    let relieved = read("relief.csv", &body(20.0, LONG / 3), &ReadOptions::default());
    assert!(relieved.check_heights().is_ok());
}
