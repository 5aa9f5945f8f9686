//! Formats of zip and XML.

use asperity_core::Code;
use asperity_profile_io::Warning;
use asperity_profile_io::read::{FilterState, Format, Gaps, LengthUnit, ReadOptions, read_bytes};

use super::samples::*;

#[test]
fn x3p_reads_in_every_data_type_with_and_without_folder_and_namespace() {
    let exact: Vec<f64> = (0..POINTS).map(|i| height(i) * 1e-6).collect();
    let count = |step: f64| exact.iter().map(move |z| (z / step).round());
    let cases: [(&str, f64, Vec<u8>, i32); 4] = [
        (
            "D",
            1.0,
            exact.iter().flat_map(|z| z.to_le_bytes()).collect(),
            12,
        ),
        (
            "F",
            1.0,
            exact
                .iter()
                .flat_map(|z| (*z as f32).to_le_bytes())
                .collect(),
            6,
        ),
        (
            "L",
            1e-12,
            count(1e-12)
                .flat_map(|v| (v as i32).to_le_bytes())
                .collect(),
            6,
        ),
        (
            "I",
            1e-10,
            count(1e-10)
                .flat_map(|v| (v as i16).to_le_bytes())
                .collect(),
            4,
        ),
    ];
    for (data_type, increment, data, decimals) in cases {
        for (folder, namespace) in [("", true), ("export/flank/", false)] {
            let xml = main_xml(namespace, "PRF", data_type, increment, 1, &link(&data, ""));
            let checksum = format!("{} *main.xml", hash(xml.as_bytes()));
            let bytes = zip(&[
                (&format!("{folder}main.xml"), xml.as_bytes()),
                (&format!("{folder}md5checksum.hex"), checksum.as_bytes()),
                (&format!("{folder}bindata/data.bin"), &data),
            ]);
            let reading = read_as("a.x3p", &bytes);
            check(&reading, Format::X3p, decimals);
            assert_eq!(reading.warnings, []);
            assert_eq!(reading.metadata.instrument.as_deref(), Some("maker one"));
        }
    }
    let text = exact
        .iter()
        .map(|z| format!("<Datum>{z:e}</Datum>"))
        .collect::<String>();
    let xml = main_xml(
        true,
        "PRF",
        "D",
        1.0,
        1,
        &format!("<DataList>{text}</DataList>"),
    );
    let reading = read_as("a.zip", &zip(&[("main.xml", xml.as_bytes())]));
    assert_eq!(reading.profile.heights(), exact);
}

#[test]
fn x3p_masks_and_checksums_and_rows_are_heeded() {
    let exact: Vec<f64> = (0..3 * POINTS)
        .map(|i| height(i % POINTS) * 1e-6 + (i / POINTS) as f64 * 1e-6)
        .collect();
    let data: Vec<u8> = exact.iter().flat_map(|z| z.to_le_bytes()).collect();
    let surface = main_xml(true, "SUR", "D", 1.0, 3, &link(&data, ""));
    let bytes = zip(&[
        ("main.xml", surface.as_bytes()),
        ("bindata/data.bin", &data),
    ]);
    let refused = read_bytes("a.x3p", &bytes, &ReadOptions::default()).unwrap_err();
    assert_eq!(refused.code(), "E119");
    assert_eq!(
        refused.fault.to_string(),
        format!("the file holds 3 profiles of {POINTS} points")
    );
    let second = ReadOptions {
        row: Some(2),
        ..ReadOptions::default()
    };
    let reading = read_bytes("a.x3p", &bytes, &second).unwrap();
    assert_eq!(reading.profile.heights(), &exact[POINTS..2 * POINTS]);
    let fourth = ReadOptions {
        row: Some(4),
        ..ReadOptions::default()
    };
    assert_eq!(
        read_bytes("a.x3p", &bytes, &fourth).unwrap_err().code(),
        "E119"
    );

    let one = &data[..8 * POINTS];
    let mut mask = vec![0xff_u8; POINTS / 8];
    mask[2] = 0b1111_0111;
    let linked = link(one, "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>");
    let xml = main_xml(true, "PRF", "D", 1.0, 1, &linked);
    let bytes = zip(&[
        ("main.xml", xml.as_bytes()),
        ("bindata/data.bin", one),
        ("bindata/valid.bin", &mask),
    ]);
    let refused = read_bytes("a.x3p", &bytes, &ReadOptions::default()).unwrap_err();
    assert_eq!((refused.code(), refused.place().1), (Code::E107, None));
    let start = format!("1 of {POINTS} points have no height, ");
    assert!(refused.fault.to_string().starts_with(&start), "{refused}");
    let filled = ReadOptions {
        gaps: Gaps::Interpolate,
        ..ReadOptions::default()
    };
    let reading = read_bytes("a.x3p", &bytes, &filled).unwrap();
    assert!((reading.profile.heights()[19] - 0.5 * (exact[18] + exact[20])).abs() < 1e-18);

    let wrong = xml.replace(&hash(one), "00112233445566778899aabbccddeeff");
    let checksum = "00112233445566778899aabbccddeeff *main.xml";
    let bytes = zip(&[
        (
            "main.xml",
            wrong
                .replace("<ValidPointsLink>bindata/valid.bin</ValidPointsLink>", "")
                .as_bytes(),
        ),
        ("md5checksum.hex", checksum.as_bytes()),
        ("bindata/data.bin", one),
    ]);
    let codes: Vec<_> = read_as("a.x3p", &bytes)
        .warnings
        .iter()
        .map(Warning::code)
        .collect();
    assert_eq!(codes, ["W120", "W120"]);
}

#[test]
fn a_mitutoyo_workbook_gives_profile_conditions_and_printed_values() {
    let texts = [
        "Mitutoyo",
        "SurfTest",
        " Profile",
        "R",
        "Cut-Off",
        "0.08mm",
        "Ra     0.383  \u{b5}m      ",
    ];
    let shared: String = texts
        .iter()
        .map(|text| format!("<si><t>{text}</t></si>"))
        .collect();
    let cells: String = (0..6)
        .map(|i| format!("<c r=\"B{}\" t=\"s\"><v>{i}</v></c>", i + 1))
        .collect();
    let points = |off: f64| {
        (0..POINTS).map(|i| {
        let (row, x) = (i + 1, 0.0005 * ((i + 1) as f64 + off * (i % 2) as f64));
        format!("<row r=\"{row}\"><c r=\"E{row}\"><v>{x:.4}</v></c><c r=\"F{row}\"><v>{:.9}</v></c></row>", height(i))
    }).collect::<String>()
    };
    let book_with = |shared: &str, points: &str| {
        zip(&[
        ("xl/workbook.xml", b"<workbook/>".as_slice()),
        ("xl/sharedStrings.xml", format!("<sst>{shared}</sst>").as_bytes()),
        ("xl/worksheets/sheet1.xml", format!("<worksheet><sheetData><row>{cells}</row></sheetData></worksheet>").as_bytes()),
        ("xl/worksheets/sheet2.xml", format!("<worksheet><sheetData><row><c r=\"A1\" t=\"s\"><v>6</v></c></row>{points}</sheetData></worksheet>").as_bytes()),
    ])
    };
    let book = |shared: &str| book_with(shared, &points(0.0));
    let reading = read_as("a.xlsx", &book(&shared));
    check(&reading, Format::MitutoyoXlsx, 9);
    assert_eq!(
        (reading.filter_state, reading.z_unit),
        (FilterState::Roughness, LengthUnit::Micrometre)
    );
    assert_eq!(reading.metadata.lambda_c, Some("0.08 mm".parse().unwrap()));
    let printed = &reading.metadata.printed[0];
    assert_eq!(
        (printed.name.as_str(), printed.value, printed.decimals),
        ("Ra", 0.383, 3)
    );
    let other = shared
        .replace("Mitutoyo", "Sheet")
        .replace("SurfTest", "one");
    // Without these labels it is an ordinary workbook, whose units are not known.
    let options = ReadOptions {
        x_unit: Some(LengthUnit::Millimetre),
        z_unit: Some(LengthUnit::Micrometre),
        ..ReadOptions::default()
    };
    let ordinary = read_bytes("a.xlsx", &book(&other), &options).unwrap();
    check(&ordinary, Format::Excel, 9);
    assert_eq!(ordinary.filter_state, FilterState::Unknown);
    // The grid is checked as that of a text file is.
    let uneven = read_bytes(
        "a.xlsx",
        &book_with(&shared, &points(0.6)),
        &ReadOptions::default(),
    );
    assert_eq!(uneven.unwrap_err().code(), "E109");
}

#[test]
fn a_checksum_that_cannot_be_unpacked_is_one_that_differs() {
    // Found by fuzzing: what was read of it before the damage showed depended on the size of the reads.
    let values: String = (0..POINTS)
        .map(|i| format!("<Datum>{:e}</Datum>", height(i) * 1e-6))
        .collect();
    let list = format!("<DataList>{values}</DataList>");
    let xml = main_xml(true, "PRF", "D", 1.0, 1, &list);
    let checksum = format!("{} *main.xml", hash(xml.as_bytes()));
    let members = [
        ("main.xml", xml.as_bytes()),
        ("md5checksum.hex", checksum.as_bytes()),
    ];
    let mut bytes = zip(&members);
    assert_eq!(read_as("a.x3p", &bytes).warnings, []);
    // The name stands last in the directory, the member's own check 30 bytes before it.
    let name = b"md5checksum.hex";
    let at = bytes.windows(name.len()).rposition(|part| part == name);
    bytes[at.unwrap() - 30] ^= 1;
    assert!(matches!(
        read_as("a.x3p", &bytes).warnings.as_slice(),
        [Warning::ChecksumDiffers { what, stated, .. }] if what == "main.xml" && stated.is_empty()
    ));
}
