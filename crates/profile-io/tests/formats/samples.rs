//! A file of every format, made in memory as its writers make it.

use std::io::{Cursor, Write};

use asperity_core::Profile;
use asperity_core::quantity::Length;
use asperity_profile_io::read::{Format, Metadata, ReadOptions, Reading, read_bytes};
use asperity_profile_io::write::{WrittenFormat, write};
use md5::{Digest, Md5};
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

pub const POINTS: usize = 240;

/// Height of point `i` in um.
pub fn height(i: usize) -> f64 {
    0.6 * (0.37 * i as f64).sin() + 0.001 * i as f64
}

pub fn rows(line: impl Fn(f64) -> String) -> String {
    (0..POINTS).map(|i| line(height(i))).collect()
}

pub fn read_as(name: &str, bytes: &[u8]) -> Reading {
    read_bytes(name, bytes, &ReadOptions::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// n, dx and heights to the `decimals` of a micrometre that were written.
pub fn check(reading: &Reading, format: Format, decimals: i32) {
    assert_eq!((reading.format, reading.points), (format, POINTS));
    assert!(
        (reading.spacing.si() / 0.5e-6 - 1.0).abs() < 1e-9,
        "{}",
        reading.spacing
    );
    for (i, z) in reading.profile.heights().iter().enumerate() {
        let off = (z * 1e6 - height(i)).abs();
        assert!(off <= 0.51 * 10f64.powi(-decimals), "{i}: {off}");
    }
}

pub fn sig() -> String {
    let head = "SigmaSurf_Data 1.0\r\nIDENTIFICATION: flank 7\r\nDATE: 20 Nov 2026 - 10:00\r\n";
    let rows = rows(|z| format!("{z:.6}\r\n"));
    format!("{head}SPACING_UM: 0.50000\r\nNUMBER_OF_POINTS: {POINTS}\r\nPROFILE_UM:\r\n{rows}")
}

pub fn sdf(profiles: usize) -> String {
    let rows = rows(|z| format!("{z:.9}\n")).repeat(profiles);
    format!(
        "aISO-1.0\nManufacID   = maker\nCreateDate  = 201120261000\nNumPoints   = {POINTS}\n\
         NumProfiles = {profiles}\nXscale      = 5E-07\nYscale      = 0\nZscale      = 1.0E-6\n\
         Zresolution = -1\nCompression = 0\nDataType    = 7\nCheckType   = 0\n*\n{rows}*\n"
    )
}

pub fn mahr() -> String {
    let points = (0..POINTS).map(|i| {
        let (x, z) = (12.0 + 0.0005 * i as f64, height(i) / 1e3 - 0.93);
        format!("{i}={x:.9} 0.000000000 {z:.9} 0.000000000 0\r\n")
    });
    format!(
        "[PROFILE_HEADER]\r\nNAME=flank 7\r\nINTERVAL_LIN=0.000500000\r\nNO_POINTS={POINTS}\r\n\
         PB_RADIUS=0.002\r\n[PROFILE_HISTORY]\r\nDateTime=2026-11-20 (Mitteleurop\u{e4}ische Zeit)\r\n\
         MachineName=PCV\r\nProfile.Type=Surface\r\n[PROFILE_VALUES]\r\n// X,Y,Z,C,Lock\r\n{}",
        points.collect::<String>()
    )
}

pub fn prf() -> String {
    let rows = rows(|z| format!("{:.0}\r\n", z * 1e6));
    format!(
        "1 2\r\nSG2004 0.000000e+000 PRF\r\nCX M {POINTS} MM 1.000000e+000 D\r\n\
         CZ M {POINTS} UM 1.000000e-006 L\r\nEOR\r\nSTYLUS_RADIUS 2.0e-003 MM\r\n\
         SPACING CX 5.000000e-004\r\nMAP 1.000000e+000 CZ CZ 1.000000e+000 1.000000e+000\r\n\
         MAP 2.000000e+000 CZ CX 1.000000e+000 0.000000e+000\r\nCOMMENT flank 7\r\nEOR\r\n{rows}EOR\r\nEOF\r\n"
    )
}

pub fn smd_with_blanks() -> String {
    let rows = rows(|z| format!("{z:.6}\r\n"));
    format!(
        "ISO 5436 - 2000 ground01\r\nPRF 1 ISO5436\r\nCX I {POINTS} mm 1.0e0 D 5.0e-4\r\n\
         CZ A {POINTS} um 1.0e0 D\r\n\r\nDATE 25-Nov-2004\r\nTIME 10:57\r\nCREATED_BY a laboratory\r\n\
         PARAMETER_VALUE Ra 0.383 um 0\r\nPARAMETER_VALUE Rq 0 mm 0\r\n\
         PROFILE_FILTER Gaussian LS 2.5e-3 LC 8.0e-1\r\n\r\n{rows}"
    )
}

pub fn pr(german: bool) -> String {
    let (length, resolution, points) = if german {
        ("X-Ma\u{df} =", "X-Aufl\u{f6}sung", "Punkte/Zeile :")
    } else {
        ("X-len =", "X-resolution", "points/scanline:")
    };
    let rows = rows(|z| format!("{z:.6}\r\n"));
    let text = format!(
        "Profil a.pr\r\n{length} 0.1195 {resolution} 2000.000000 {points} {POINTS}\r\n{rows}"
    );
    text.trim_end().to_owned()
}

/// The bytes of a text in the code page of western Windows.
pub fn windows(text: &str) -> Vec<u8> {
    encoding_rs::WINDOWS_1252.encode(text).0.into_owned()
}

pub fn zip(members: &[(&str, &[u8])]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in members {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

pub fn hash(bytes: &[u8]) -> String {
    Md5::digest(bytes)
        .iter()
        .map(|byte| format!("{byte:02x}"))
        .collect()
}

/// `main.xml` of `rows` profiles, heights scaled by `increment`, with `record3` as its data.
pub fn main_xml(
    namespace: bool,
    feature: &str,
    data_type: &str,
    increment: f64,
    rows: usize,
    record3: &str,
) -> String {
    let (open, close) = match namespace {
        true => (
            "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">",
            "</p:ISO5436_2>",
        ),
        false => ("<ISO5436_2>", "</ISO5436_2>"),
    };
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>{open}<Record1><FeatureType>{feature}</FeatureType><Axes>\
         <CX><AxisType>I</AxisType><DataType>D</DataType><Increment>5e-07</Increment><Offset>0</Offset></CX>\
         <CY><AxisType>I</AxisType><Increment>5e-07</Increment><Offset>0</Offset></CY>\
         <CZ><AxisType>A</AxisType><DataType>{data_type}</DataType><Increment>{increment:e}</Increment><Offset>0</Offset></CZ>\
         </Axes></Record1><Record2><Date>2026-11-20T10:00:00</Date><Instrument><Manufacturer>maker</Manufacturer>\
         <Model>one</Model></Instrument></Record2><Record3><MatrixDimension><SizeX>{POINTS}</SizeX><SizeY>{rows}</SizeY>\
         <SizeZ>1</SizeZ></MatrixDimension>{record3}</Record3></{close}",
        close = &close[2..]
    )
}

pub fn link(data: &[u8], mask: &str) -> String {
    format!(
        "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>{}</MD5ChecksumPointData>{mask}</DataLink>",
        hash(data)
    )
}

/// A workbook as Mitutoyo's tool writes it.
pub fn workbook() -> Vec<u8> {
    let texts = ["Mitutoyo", " Profile", "R"]
        .map(|text| format!("<si><t>{text}</t></si>"))
        .concat();
    let label = |i: usize| format!("<c r=\"B{}\" t=\"s\"><v>{i}</v></c>", i + 1);
    let labels: String = (0..3).map(label).collect();
    let point = |i: usize| {
        let (row, x) = (i + 1, 0.0005 * (i + 1) as f64);
        format!(
            "<row><c r=\"E{row}\"><v>{x:.4}</v></c><c r=\"F{row}\"><v>{:.6}</v></c></row>",
            height(i)
        )
    };
    let points: String = (0..POINTS).map(point).collect();
    let sheet = |rows: &str| format!("<worksheet><sheetData>{rows}</sheetData></worksheet>");
    zip(&[
        (
            "xl/sharedStrings.xml",
            format!("<sst>{texts}</sst>").as_bytes(),
        ),
        (
            "xl/worksheets/sheet1.xml",
            sheet(&format!("<row>{labels}</row>")).as_bytes(),
        ),
        ("xl/worksheets/sheet2.xml", sheet(&points).as_bytes()),
    ])
}

/// An XML profile as ASME B46 and NPL publish it.
pub fn npl_xml() -> String {
    let rows = rows(|z| format!("{z:.6}\n"));
    format!(
        "<?xml version='1.0' encoding='UTF-8'?>\n<!DOCTYPE DATA SYSTEM \"data.dtd\">\n<DATA>\n<PART>\n\
         <PART_NAME>flank 7</PART_NAME>\n</PART>\n<DATAFILE>\n<UNITS>um</UNITS>\n<NUMPOINTS>{POINTS}</NUMPOINTS>\n\
         <SPACING>0.5</SPACING>\n<DATA_POINT_VALUES>{rows}</DATA_POINT_VALUES>\n</DATAFILE>\n</DATA>\n"
    )
}

/// A sheet of an ordinary `.xlsx`: a remark, names with values, labels, then the rows of numbers of each line.
pub fn sheet_xml(
    remarks: &[&str],
    labels: &[&str],
    lines: impl Iterator<Item = Vec<f64>>,
) -> String {
    let text = |column: usize, row: usize, text: &str| {
        let letter = char::from(b'B' + column as u8);
        format!("<c r=\"{letter}{row}\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
    };
    let number = |column: usize, row: usize, value: f64| {
        let letter = char::from(b'B' + column as u8);
        format!("<c r=\"{letter}{row}\"><v>{value}</v></c>")
    };
    let mut xml = String::new();
    for (row, remark) in remarks.iter().enumerate() {
        let cells = remark.split('|').enumerate();
        let cells: String = cells.map(|(at, cell)| text(at, row + 1, cell)).collect();
        xml += &format!("<row>{cells}</row>");
    }
    let row = remarks.len() + 2;
    let cells: String = labels
        .iter()
        .enumerate()
        .map(|(at, cell)| text(at, row, cell))
        .collect();
    xml += &format!("<row>{cells}</row>");
    for (i, line) in lines.enumerate() {
        let cells: String = line
            .iter()
            .enumerate()
            .map(|(at, v)| number(at, row + 1 + i, *v))
            .collect();
        xml += &format!("<row>{cells}</row>");
    }
    format!("<worksheet><sheetData>{xml}</sheetData></worksheet>")
}

/// An ordinary `.xlsx` of the sheets.
pub fn xlsx(sheets: &[String]) -> Vec<u8> {
    let names: Vec<String> = (1..=sheets.len())
        .map(|number| format!("xl/worksheets/sheet{number}.xml"))
        .collect();
    let mut members = vec![("xl/workbook.xml", b"<workbook/>".as_slice())];
    members.extend(
        names
            .iter()
            .zip(sheets)
            .map(|(name, sheet)| (name.as_str(), sheet.as_bytes())),
    );
    zip(&members)
}

/// An `.ods` with labels, x in millimetres and heights in micrometres, and cells repeated to the end of the sheet.
pub fn ods() -> Vec<u8> {
    let text = |text: &str| {
        format!(
            "<table:table-cell office:value-type=\"string\"><text:p>{text}</text:p></table:table-cell>"
        )
    };
    let number = |value: f64| {
        format!(
            "<table:table-cell office:value-type=\"float\" office:value=\"{value}\"><text:p>shown</text:p></table:table-cell>"
        )
    };
    let row = |cells: String| {
        format!(
            "<table:table-row>{cells}<table:table-cell table:number-columns-repeated=\"16382\"/></table:table-row>"
        )
    };
    let mut rows = row(text("Weg [mm]") + &text("Höhe [µm]"));
    for i in 0..POINTS {
        rows += &row(number(0.0005 * i as f64) + &number(height(i)));
    }
    let content = format!(
        "<office:document-content xmlns:office=\"o\" xmlns:table=\"t\" xmlns:text=\"x\"><office:body>\
         <office:spreadsheet><table:table>{rows}<table:table-row table:number-rows-repeated=\"1048000\">\
         <table:table-cell/></table:table-row></table:table></office:spreadsheet></office:body></office:document-content>"
    );
    zip(&[
        (
            "mimetype",
            b"application/vnd.oasis.opendocument.spreadsheet".as_slice(),
        ),
        ("content.xml", content.as_bytes()),
    ])
}

/// One valid file of every format.
pub fn seeds() -> Vec<(&'static str, Vec<u8>)> {
    let heights = (0..POINTS).map(|i| height(i) * 1e-6).collect();
    let profile = Profile::new(Length::from_si(0.5e-6), heights).unwrap();
    let written = |format| write(&profile, &Metadata::default(), format).unwrap();
    vec![
        ("a.x3p", written(WrittenFormat::X3p)),
        ("a.smd", written(WrittenFormat::Smd)),
        ("b.smd", smd_with_blanks().into_bytes()),
        ("a.sig", sig().into_bytes()),
        ("a.sdf", sdf(1).into_bytes()),
        ("a.txt", mahr().into_bytes()),
        ("a.prf", prf().into_bytes()),
        ("a.pr", pr(true).into_bytes()),
        (
            "a.tx1",
            format!("0.12\n{POINTS}\n{}", rows(|z| format!("{z:.4}\n"))).into_bytes(),
        ),
        ("a.xml", npl_xml().into_bytes()),
        ("a.xlsx", workbook()),
        ("a.ods", ods()),
    ]
}
