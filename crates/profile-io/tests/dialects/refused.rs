//! Files that are refused, and what is said about them.

use asperity_profile_io::read::{DecimalSign, Format, ReadOptions, read_bytes};

use super::table::*;

#[test]
fn missing_heights_are_refused_by_line_whatever_they_are_called() {
    for word in ["NaN", "Bad", "", "***", "inf"] {
        let text = PLAIN.text();
        let third = text.lines().nth(3).unwrap();
        let broken = text.replace(third, &format!("1.000000000,{word}"));
        let refused = read_text(&broken).unwrap_err();
        assert_eq!(refused.code(), "E107");
        assert!(
            refused
                .to_string()
                .starts_with("flank.csv:4: 1 of 240 points"),
            "{refused}"
        );
    }
}

#[test]
fn an_unreadable_cell_is_shown_with_what_the_file_looks_like() {
    let german = Dialect {
        header: "x [um];z [um]",
        between: ";",
        decimal: ',',
        ..PLAIN
    };
    let options = ReadOptions {
        decimal: Some(DecimalSign::Point),
        ..ReadOptions::default()
    };
    let refused = read_bytes("flank.csv", german.text().as_bytes(), &options).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "flank.csv:2: cannot read \"0,000000000\" as a number; the file looks like ';' with decimal comma"
    );
    assert_eq!(refused.remedy().to_string(), "Set decimal to comma");
    assert_eq!(refused.code(), "E101");
    let text = PLAIN.text();
    let broken = text.replacen("4.500000000,", "4.5O,", 1);
    assert_ne!(broken, text);
    let refused = read_text(&broken).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "flank.csv:11: cannot read \"4.5O\" as a number; the file looks like ',' with decimal point"
    );
    let pairs: String = (0..POINTS)
        .map(|i| format!("0,{:04},1,{:04}\n", 5 * i, 7 * i))
        .collect();
    assert_eq!(read_text(&pairs).unwrap_err().code(), "E113");
}

#[test]
fn formats_that_are_not_read_are_named() {
    for (name, bytes, format) in [
        ("a.hwp", b"\x00\x01\x02\x03".as_slice(), Format::HommelHwp),
        ("a.pcd", b"\x00\x01\x02\x03", Format::MahrPcd),
        ("a.mnt", b"\x00\x01\x02\x03", Format::MountainsMnt),
        ("a.bin", b"\x00\x01\x02\x03", Format::UnknownBinary),
        ("a.tx3", b"Fecha\t08.04.2025\n", Format::SurfcomConditions),
    ] {
        let refused = read_bytes(name, bytes, &ReadOptions::default()).unwrap_err();
        assert_eq!(refused.code(), "E108");
        let expected = format!("{name}: {format} is not read by this version");
        assert_eq!(refused.to_string(), expected);
    }
    let empty = read_text("").unwrap_err();
    assert_eq!(empty.code(), "E102");
    assert_eq!(
        read_text("no numbers\nat all\n").unwrap_err().code(),
        "E102"
    );
}
