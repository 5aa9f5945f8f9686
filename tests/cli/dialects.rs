//! One table in the dialects of many programs, read alike by every command that takes a table.

use std::io::{Cursor, Write};

use zip::ZipWriter;
use zip::write::SimpleFileOptions;

use crate::bench::{Bench, E_DRIVE, trace};

/// The dialects: separator, decimal sign, whether cells are quoted, and line ends.
const DIALECTS: [(&str, &str, &str, bool, &str); 12] = [
    ("comma", ",", ".", false, "\n"),
    ("comma, quoted", ",", ".", true, "\n"),
    ("semicolon", ";", ".", false, "\n"),
    ("German", ";", ",", false, "\n"),
    ("German, quoted, of Windows", ";", ",", true, "\r\n"),
    ("tab", "\t", ".", false, "\n"),
    ("tab, decimal comma", "\t", ",", false, "\r\n"),
    ("a spreadsheet's mark", "\u{feff};", ",", false, "\r\n"),
    ("rows filled with separators", ";", ",", false, ";;\r\n"),
    ("UTF-16", "\t", ",", false, "\r\n"),
    (WORKBOOK, "", ".", false, ""),
    (ODS, "", ".", false, ""),
];
const WORKBOOK: &str = "workbook of Excel";
const ODS: &str = "workbook of LibreOffice";

/// `table` as the bytes of a file in a dialect.
fn file(table: &str, dialect: (&str, &str, &str, bool, &str)) -> Vec<u8> {
    let text = || written(table, dialect);
    match dialect.0 {
        WORKBOOK => {
            let cell = |(column, text): (usize, &str)| {
                let letter = char::from(b'A' + column as u8);
                match text.parse::<f64>() {
                    Ok(_) => format!("<c r=\"{letter}ROW\"><v>{text}</v></c>"),
                    Err(_) => {
                        format!("<c r=\"{letter}ROW\" t=\"inlineStr\"><is><t>{text}</t></is></c>")
                    }
                }
            };
            let row = |(row, line): (usize, &str)| {
                let cells: String = line.split(',').enumerate().map(cell).collect();
                format!(
                    "<row>{}</row>",
                    cells.replace("ROW", &(row + 1).to_string())
                )
            };
            let rows: String = table.lines().enumerate().map(row).collect();
            let sheet = format!("<worksheet><sheetData>{rows}</sheetData></worksheet>");
            zip(&[
                ("xl/workbook.xml", "<workbook/>"),
                ("xl/worksheets/sheet1.xml", &sheet),
            ])
        }
        ODS => {
            let cell = |text: &str| match text.parse::<f64>() {
                Ok(_) => format!("<table-cell value=\"{text}\"><p>{text}</p></table-cell>"),
                Err(_) => format!("<table-cell><p>{text}</p></table-cell>"),
            };
            let row = |line: &str| {
                let cells: String = line.split(',').map(cell).collect();
                format!("<table-row>{cells}</table-row>")
            };
            let rows: String = table.lines().map(row).collect();
            let content = format!("<document><table>{rows}</table></document>");
            zip(&[
                ("mimetype", "application/vnd.oasis.opendocument.spreadsheet"),
                ("content.xml", &content),
            ])
        }
        "UTF-16" => {
            let words = ["\u{feff}", &text()].concat();
            words.encode_utf16().flat_map(u16::to_le_bytes).collect()
        }
        _ => text().into_bytes(),
    }
}

fn zip(members: &[(&str, &str)]) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in members {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(content.as_bytes()).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// `table`, which has commas between its cells and decimal points, in a dialect.
fn written(
    table: &str,
    (_, separator, decimal, is_quoted, end): (&str, &str, &str, bool, &str),
) -> String {
    let (mark, separator) = match separator.strip_prefix('\u{feff}') {
        Some(separator) => ("\u{feff}", separator),
        None => ("", separator),
    };
    let cell = |(row, cell): (usize, &str)| {
        // Names of columns have no numbers.
        let cell = if row == 0 {
            cell.to_owned()
        } else {
            cell.replace('.', decimal)
        };
        if is_quoted {
            format!("\"{cell}\"")
        } else {
            cell
        }
    };
    let line = |(row, line): (usize, &str)| {
        let cells: Vec<String> = line.split(',').map(|text| cell((row, text))).collect();
        cells.join(separator) + end
    };
    mark.to_owned() + &table.lines().enumerate().map(line).collect::<String>()
}

/// A table with the commands that read it as `table.csv`, and the file of its numbers.
struct Reading {
    table: String,
    commands: Vec<Vec<&'static str>>,
    file: &'static str,
}

/// Traction over slide-to-roll at two temperatures, of the oil m100 itself.
fn curves(bench: &Bench) -> String {
    bench
        .run(&["oil", "traction", "m100", "-o", "curves"])
        .well();
    let file = bench.path("curves/traction_over_slide_to_roll.csv");
    let text = std::fs::read_to_string(file).unwrap();
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').take(5).collect();
        cells.join(",") + "\n"
    };
    let head = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,traction\n";
    head.to_owned()
        + &text
            .lines()
            .skip(1)
            .step_by(18)
            .map(row)
            .collect::<String>()
}

/// Friction of rubbed specimens over speed.
fn stribeck() -> String {
    let head = "load_n,mean_speed_m_s,slide_roll_percent,temperature_c,rubbing_s,traction\n";
    let row = |rubbing: u32, k: i32| {
        let speed = 0.002 * 1.5_f64.powi(k);
        let boundary = if rubbing > 0 { 0.117 } else { 0.059 };
        let friction = 0.02 + (boundary - 0.02) / (1.0 + (speed / 0.3).powi(2));
        format!("50.5,{speed},50,120,{rubbing},{friction}\n")
    };
    let rows = [0, 7200].map(|time| (0..20).map(|k| row(time, k)).collect::<String>());
    head.to_owned() + &rows.concat()
}

const STUDY: &str = r#"case = "case.toml"
columns = ["loss_w"]

[sample]
method = "list"
file = "table.csv"
"#;

#[test]
#[ignore = "slow: just test-all"]
fn slow_every_command_reads_one_table_in_every_dialect() {
    let bench = Bench::new();
    bench.write_flanks();
    let quick = "positions = 2\noffsets = 1\nload_share = \"lambda-star\"\n";
    let quick = E_DRIVE.replace("positions = 2\noffsets = 2\n", quick);
    assert_ne!(quick, E_DRIVE);
    bench.write("case.toml", quick);
    bench.write("study.toml", STUDY);
    let map = [
        "map",
        "case.toml",
        "-o",
        "m",
        "-q",
        "--torque=-100,100",
        "--speed=9000",
        "--band",
        "none",
    ];
    bench.run(&map).well();
    let readings = [
        Reading {
            table: trace("x_um,z_um", 2400),
            commands: vec![vec!["profile", "info", "table.csv", "--json"]],
            file: "",
        },
        Reading {
            table: "time_s,torque_nm,speed_rpm\n0,0,0\n1.5,60.25,1500\n2.5,60.5,3000\n3.5,-30.25,3000.5\n4,0,0\n".to_owned(),
            commands: vec![vec!["cycle", "m", "table.csv", "-o", "out"]],
            file: "out/cycle.json",
        },
        Reading {
            table: "speed_rpm,loss_torque_nm\n0,0.25\n4500,0.75\n9000.5,1.5\n".to_owned(),
            commands: vec![vec!["map", "case.toml", "-o", "out", "-q", "--torque=-100,100", "--speed=9000", "--band", "none", "--add-loss", "table.csv", "--export", "csv"]],
            file: "out/export/case.csv",
        },
        Reading {
            table: "operation.torque [N m],operation.speed [1/min]\n100.5,3000\n120.25,4500.5\n".to_owned(),
            commands: vec![vec!["sweep", "run", "study.toml", "-q"], vec!["sweep", "merge", "study.toml", "-o", "out"]],
            file: "out/sweep.csv",
        },
        Reading {
            table: "torque_nm,speed_rpm,temperature_c,loss_w,sigma_w,includes\n60.5,2000,60,38.74,5.5,mesh\n60.5,4500.5,60,80.39,5.5,mesh\n60.5,9000,60,150.0,5.5,mesh\n145.5,2000,60,85.24,5.5,mesh\n145.5,4500.5,60,176.86,5.5,mesh\n145.5,9000,60,330.0,5.5,mesh\n".to_owned(),
            commands: vec![vec!["calibrate", "table.csv", "case.toml", "-o", "out"]],
            file: "out/points.csv",
        },
        Reading {
            table: curves(&bench),
            commands: vec![vec!["oil", "fit", "table.csv", "--oil", "m100", "-o", "out"]],
            file: "out/oil.toml",
        },
        Reading {
            table: stribeck(),
            commands: vec![vec!["oil", "stribeck", "table.csv", "--oil", "m100", "-o", "out"]],
            file: "out/stribeck.json",
        },
    ];
    for reading in readings {
        let mut first = None;
        for dialect in DIALECTS {
            bench.write("table.csv", file(&reading.table, dialect));
            let run = |command: &Vec<&str>| bench.run(command).well().out;
            let said: String = reading.commands.iter().map(run).collect();
            let found = match reading.file {
                // It also states the dialect.
                "" => serde_json::from_str::<serde_json::Value>(&said).unwrap()["parameters"]
                    .to_string(),
                file => std::fs::read_to_string(bench.path(file)).unwrap(),
            };
            // The checksum of the file differs, and nothing else.
            let is_number = |line: &&str| {
                let is_checksum = line.trim().trim_matches('"').len() == 64;
                !is_checksum && !line.contains("sha256") && !line.contains("table.csv")
            };
            let lines = found.lines().filter(is_number);
            let found: Vec<String> = lines.map(str::to_owned).collect();
            let first = first.get_or_insert_with(|| found.clone());
            assert_eq!(&found, first, "{:?} as {}", reading.commands, dialect.0);
            if bench.path("out").exists() {
                std::fs::remove_dir_all(bench.path("out")).unwrap();
            }
        }
    }
}
