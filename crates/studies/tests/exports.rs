//! Every export, read back by a reader of our own, agrees with the map at points of all quadrants.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests may panic"
)]

use std::f64::consts::PI;
use std::io::Read as _;
use std::process::Command;

use asperity::case::{CaseInput, FlankInput, GearsInput, OperationInput};
use asperity_studies::cycle::{cycle, evaluate};
use asperity_studies::export::{AddedLoss, Field, Format, With, c_source, export};
use asperity_studies::map::{Axes, EXTENDED, FinishMap, Map, MeshPart, Numbers, Point, forwards};

/// A made-up loss torque: 0.0075 |T|^1.02, a tenth more where the wheel drives, and 2e-4 √ω.
fn made_up(torque: f64, rpm: f64) -> f64 {
    let coast = if torque < 0.0 { 1.1 } else { 1.0 };
    0.0075 * torque.abs().powf(1.02) * coast + 2e-4 * (rpm * PI / 30.0).sqrt()
}

fn map_of(torque: &[f64], temperatures: &[f64]) -> Map {
    let speed: Vec<f64> = (0..17).map(|k| 1000.0 * f64::from(k)).collect();
    let axes = Axes::new(torque, &speed, temperatures).unwrap();
    let mut points = Vec::new();
    for &temperature_c in &axes.temperature_c {
        for &torque_nm in &axes.torque_nm {
            for &speed_rpm in &axes.speed_rpm {
                let loss = made_up(torque_nm, speed_rpm) * (1.0 + 1e-3 * (temperature_c - 60.0));
                points.push(Point {
                    torque_nm,
                    speed_rpm,
                    temperature_c,
                    numbers: Some(Numbers {
                        loss_w: loss * speed_rpm * PI / 30.0,
                        loss_at_medians_w: None,
                        loss_torque_nm: loss,
                        loss_torque_deviation_nm: None,
                        drawn_w: None,
                        efficiency: None,
                        efficiency_deviation: None,
                        sliding_w: 0.0,
                        film_w: 0.0,
                        lubricated_asperity_w: 0.0,
                        boundary_w: 0.0,
                        rolling_w: 0.0,
                        deformation_w: 0.0,
                        mu_equivalent: None,
                        mixed_share: 0.0,
                    }),
                    outside: Vec::new(),
                    code: None,
                });
            }
        }
    }
    let gears = GearsInput::new(
        [23, 68],
        "1.8 mm".parse().unwrap(),
        "32 mm".parse().unwrap(),
    );
    let operation = OperationInput::new(
        "160 N m".parse().unwrap(),
        "9000 1/min".parse().unwrap(),
        "60 °C".parse().unwrap(),
    );
    Map {
        schema_version: asperity::result::SCHEMA_VERSION,
        program: "asperity".to_owned(),
        title: "made up".to_owned(),
        scope: "mesh".to_owned(),
        gearbox: None,
        axes,
        ratio: Some(RATIO),
        operating_point: [160.0, 9000.0],
        operating_temperature_c: 60.0,
        finishes: vec![FinishMap {
            name: "ground".to_owned(),
            fingerprint: String::new(),
            files: Vec::new(),
            coast_files: Vec::new(),
            difference_w: None,
            resolved_from_nm: [1.0, 1.0],
            draws: Vec::new(),
            meshes: Vec::new(),
            points,
        }],
        are_variants: false,
        warnings: Vec::new(),
        table_warnings: Vec::new(),
        input: CaseInput::new(gears, operation, Default::default(), FlankInput::default()),
        defaults: Vec::new(),
    }
}

/// Turns of the pinion for one turn of the wheel.
const RATIO: f64 = 68.0 / 23.0;

fn map() -> Map {
    let torque: Vec<f64> = (0..33).map(|k| -160.0 + 10.0 * f64::from(k)).collect();
    map_of(&torque, &[60.0])
}

#[test]
fn the_verdict_of_a_map_is_interpolated_to_the_operating_point() {
    let mut map = map();
    let verdict = |map: &Map| {
        let text = asperity_report::StudyResult::report(map).terminal();
        text.split_whitespace().collect::<Vec<_>>().join(" ")
    };
    map.operating_point = [41.0, 3400.0];
    let surface = map.finishes[0].surface(&map.axes, 0).unwrap();
    let loss = surface.loss_torque(41.0, 3400.0).value * 3400.0 * std::f64::consts::PI / 30.0;
    let said = verdict(&map);
    let due = format!("With ground the loss is {loss:.1} W and the efficiency");
    assert!(
        said.contains(&due) && said.contains("at 41 N m and 3400 1/min."),
        "{due}: {said}"
    );
    assert!(
        said.contains("interpolated between the points of the map."),
        "{said}"
    );
    // Outside of the map it is at the next point.
    map.operating_point = [41.0, 34_000.0];
    for celsius in [60.0, 75.0] {
        map.operating_temperature_c = celsius;
        let said = verdict(&map);
        let due = format!(
            "These losses are at the point of the map next to the operating point of the case: 41 N m, 34000 1/min, {celsius} °C."
        );
        assert!(
            said.contains("at 40 N m and 16000 1/min") && said.contains(&due),
            "{said}"
        );
    }
}

/// Places of all quadrants, off the nodes: torque \[N m\], speed \[1/min\].
fn places() -> Vec<[f64; 2]> {
    let at = |k: u32| {
        let k = f64::from(k);
        [
            -157.0 + 314.0 * (0.618_034 * k).fract(),
            -15_500.0 + 31_000.0 * (0.754_878 * k).fract(),
        ]
    };
    (1..=100).map(at).collect()
}

fn text_of(map: &Map, format: Format, with: With<'_>) -> (String, String) {
    let files = export(map, format, with).unwrap();
    assert_eq!(files.len(), 1);
    let name = files[0].name.to_string_lossy().into_owned();
    (name, String::from_utf8(files[0].bytes.clone()).unwrap())
}

fn field(map: &Map) -> Field {
    Field::all(map, 0, None).unwrap().remove(0)
}

/// Bilinear interpolation written again.
fn bilinear(x: &[f64], y: &[f64], value: &dyn Fn(usize, usize) -> f64, at: [f64; 2]) -> f64 {
    let cell = |nodes: &[f64], v: f64| {
        let i = nodes.windows(2).position(|pair| v <= pair[1]).unwrap();
        (i, (v - nodes[i]) / (nodes[i + 1] - nodes[i]))
    };
    // Tables hold positive speeds.
    let [torque, speed] = forwards(at[0], at[1]);
    let ((i, a), (j, b)) = (cell(x, torque), cell(y, speed));
    (1.0 - a) * ((1.0 - b) * value(i, j) + b * value(i, j + 1))
        + a * ((1.0 - b) * value(i + 1, j) + b * value(i + 1, j + 1))
}

#[test]
fn vecto_reads_its_columns_and_its_power_balance_closes() {
    let map = map();
    let (name, text) = text_of(&map, Format::Vecto, With::default());
    assert_eq!(name, "ground.vtlm");
    assert!(text.starts_with("# scope mesh only"), "{text}");
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(
        lines.next().unwrap(),
        "Input Speed [rpm],Input Torque [Nm],Torque Loss [Nm]"
    );
    let rows: Vec<Vec<f64>> = lines
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(rows.len(), 33 * 17);
    assert!(rows.iter().any(|row| row[0] == 0.0));
    assert!(rows.iter().all(|row| row[2] >= 0.0));
    // As VECTO looks up: T_in = T_out/i + loss at (n_in, T_in - loss), here along a row of constant speed.
    for [torque, speed] in places() {
        let speed = (speed.abs() / 1000.0).round() * 1000.0;
        let of_speed: Vec<&Vec<f64>> = rows.iter().filter(|row| row[0] == speed).collect();
        let output: Vec<f64> = of_speed.iter().map(|row| row[1] - row[2]).collect();
        let loss = |k: usize| of_speed[k][2];
        let wanted = torque * 0.99;
        let found = bilinear(&output, &[0.0, 1.0], &|k, _| loss(k), [wanted, 0.0]);
        let input = wanted + found;
        // The balance holds to the error of one interpolation against the other.
        let direct = field(&map).surface().loss_torque(input, speed).value;
        assert!(
            (direct - found).abs() < 1e-6 + 2e-3 * direct,
            "{torque} {speed} {direct} {found}"
        );
    }
}

#[test]
fn modelica_tables_follow_their_grammar() {
    let map = map();
    let (_, text) = text_of(&map, Format::Modelica, With::default());
    assert!(text.starts_with("#1\n"));
    assert!(text.contains("scope = mesh only"));
    let mut body = text.lines().filter(|line| !line.starts_with('#'));
    assert_eq!(body.next().unwrap(), "double lossTorque(34,18)");
    let words = body.flat_map(|line| line.split([' ', '\t', ',', ';']));
    let numbers: Vec<f64> = words.map(|word| word.parse().unwrap()).collect();
    assert_eq!(numbers.len(), 34 * 18);
    let speeds = &numbers[1..18];
    let torques: Vec<f64> = numbers.chunks(18).skip(1).map(|row| row[0]).collect();
    assert!(torques.windows(2).all(|pair| pair[0] < pair[1]));
    let value = |i: usize, j: usize| numbers[(i + 1) * 18 + j + 1];
    let surface = field(&map).surface();
    for [torque, speed] in places() {
        let found = bilinear(&torques, speeds, &value, [torque, speed * PI / 30.0]);
        let expected = surface.loss_torque(torque, speed).value;
        assert!((found - expected).abs() < 1e-12, "{torque} {speed}");
    }
}

/// An array of a MAT-file: class, sizes, data with the first index fastest.
struct Matrix {
    name: String,
    class: u8,
    sizes: Vec<usize>,
    values: Vec<f64>,
}

/// The data element at the beginning of `bytes`, and the bytes after it.
fn element(bytes: &[u8]) -> (u32, &[u8], &[u8]) {
    let number = |k: usize| u32::from_le_bytes(bytes[4 * k..4 * k + 4].try_into().unwrap());
    let length = usize::try_from(number(1)).unwrap();
    let rest = &bytes[8 + length.next_multiple_of(8)..];
    (number(0), &bytes[8..8 + length], rest)
}

/// Arrays of a MAT-file of level 5.
fn matrices(bytes: &[u8]) -> Vec<Matrix> {
    assert!(bytes.starts_with(b"MATLAB 5.0 MAT-file"));
    assert_eq!(&bytes[124..128], [0x00, 0x01, b'I', b'M']);
    let mut rest = &bytes[128..];
    let mut found = Vec::new();
    while !rest.is_empty() {
        let (kind, array, after) = element(rest);
        let (flags, sizes, name, data);
        (_, flags, rest) = element(array);
        (_, sizes, rest) = element(rest);
        (_, name, rest) = element(rest);
        let (of_data, ..) = element(rest);
        (_, data, rest) = element(rest);
        assert!(kind == 14 && rest.is_empty());
        let size = |raw: &[u8]| usize::try_from(i32::from_le_bytes(raw.try_into().unwrap()));
        let sizes: Vec<usize> = sizes.chunks(4).map(|raw| size(raw).unwrap()).collect();
        let values: Vec<f64> = match of_data {
            9 => data
                .chunks(8)
                .map(|raw| f64::from_le_bytes(raw.try_into().unwrap()))
                .collect(),
            4 => data
                .chunks(2)
                .map(|raw| f64::from(u16::from_le_bytes(raw.try_into().unwrap())))
                .collect(),
            other => panic!("type {other}"),
        };
        assert_eq!(values.len(), sizes.iter().product::<usize>());
        let name = String::from_utf8(name.to_vec()).unwrap();
        found.push(Matrix {
            name,
            class: flags[0],
            sizes,
            values,
        });
        rest = after;
    }
    found
}

/// The array of this name.
fn matrix<'a>(found: &'a [Matrix], name: &str) -> &'a Matrix {
    found.iter().find(|matrix| matrix.name == name).unwrap()
}

/// A text of a MAT-file.
fn said_in(found: &[Matrix], name: &str) -> String {
    let text = matrix(found, name);
    assert_eq!(text.class, 4);
    text.values
        .iter()
        .map(|code| char::from_u32(*code as u32).unwrap())
        .collect()
}

#[test]
fn mat_files_hold_every_temperature_in_one_array_without_nan() {
    let torque: Vec<f64> = (0..17).map(|k| -160.0 + 20.0 * f64::from(k)).collect();
    let map = map_of(&torque, &[60.0, 90.0]);
    let files = export(&map, Format::Matlab, With::default()).unwrap();
    let found = matrices(&files[0].bytes);
    assert_eq!(said_in(&found, "scope"), "mesh only, input shaft");
    assert!(said_in(&found, "head").contains("finish ground, 60, 90 degC"));
    assert_eq!(matrix(&found, "temperature_c").values, [60.0, 90.0]);
    assert_eq!(matrix(&found, "torque_nm").sizes, [17, 1]);
    assert_eq!(matrix(&found, "omega_rad_s").sizes, [1, 17]);
    let fields = Field::all(&map, 0, None).unwrap();
    let (loss, power) = (matrix(&found, "loss_torque_nm"), matrix(&found, "loss_w"));
    let efficiency = matrix(&found, "efficiency");
    assert_eq!(loss.sizes, [17, 17, 2]);
    for (k, field) in fields.iter().enumerate() {
        for (index, expected) in field.mesh_nm.iter().enumerate() {
            let (i, j) = (index / 17, index % 17);
            let at = (k * 17 + j) * 17 + i;
            assert_eq!(loss.values[at], *expected);
            assert_eq!(power.values[at], expected * field.omega()[j]);
            let torque = field.torque_nm[i];
            if torque > 0.0 {
                assert_eq!(efficiency.values[at], 1.0 - expected / torque);
            } else if torque < 0.0 {
                // The same as 1 − L/(L + |T|), but for rounding.
                let due = -torque / (expected - torque);
                assert!((efficiency.values[at] - due).abs() < 2.0 * f64::EPSILON);
            } else {
                assert_eq!(efficiency.values[at], efficiency.values[at + 1]);
            }
        }
    }
    let all = found.iter().flat_map(|matrix| &matrix.values);
    assert!(all.copied().all(f64::is_finite));
    // One temperature makes matrices.
    let files = export(&map_of(&torque, &[60.0]), Format::Matlab, With::default()).unwrap();
    assert_eq!(matrix(&matrices(&files[0].bytes), "loss_w").sizes, [17, 17]);
}

#[test]
fn an_efficiency_is_not_negative_where_the_loss_exceeds_the_torque() {
    let map = map_of(&[-1e-4, 0.0, 1e-4, 10.0], &[60.0]);
    let files = export(&map, Format::Matlab, With::default()).unwrap();
    let found = matrices(&files[0].bytes);
    let column = |j: usize| &matrix(&found, "efficiency").values[4 * j..4 * j + 4];
    assert_eq!(column(16)[1..3], [0.0, 0.0]);
    assert!((0.0..0.1).contains(&column(16)[0]) && column(16)[3] > 0.98);
}

#[test]
fn the_wide_table_has_torques_down_and_speeds_across() {
    let map = map_of(&[-50.0, 0.0, 50.0], &[60.0, 90.0]);
    let files = export(&map, Format::Wide, With::default()).unwrap();
    let names: Vec<_> = files
        .iter()
        .map(|file| file.name.to_string_lossy())
        .collect();
    let expected = [
        "ground_60c_loss_torque_nm.csv",
        "ground_90c_loss_torque_nm.csv",
    ];
    assert_eq!(names, expected);
    let fields = Field::all(&map, 0, None).unwrap();
    for (file, field) in files.iter().zip(fields) {
        let mut table = csv::Reader::from_reader(&file.bytes[..]);
        let head = table.headers().unwrap().clone();
        assert_eq!(&head[0], "torque_nm/speed_rpm");
        let speeds: Vec<f64> = head
            .iter()
            .skip(1)
            .map(|cell| cell.parse().unwrap())
            .collect();
        assert_eq!(speeds, field.speed_rpm);
        let rows = table.records().map(Result::unwrap);
        let rows: Vec<Vec<f64>> = rows
            .map(|row| row.iter().map(|cell| cell.parse().unwrap()).collect())
            .collect();
        let torques: Vec<f64> = rows.iter().map(|row| row[0]).collect();
        assert_eq!(torques, field.torque_nm);
        let values: Vec<f64> = rows.iter().flat_map(|row| row[1..].to_vec()).collect();
        assert_eq!(values, field.mesh_nm);
    }
}

/// Loss torque of `LossyGear` by the formulas of its description, from a row of its table.
fn of_lossy_gear(row: &[f64], torque: f64) -> f64 {
    let [eta1, eta2, tau1, tau2] = row.try_into().unwrap();
    // The torque that the bearing on the input side takes, which decides what drives.
    let of_bearing = (tau1 - tau2) / (eta1 - 1.0 / eta2);
    if torque - of_bearing >= 0.0 {
        (1.0 - eta1) * torque + tau1
    } else {
        (1.0 - 1.0 / eta2) * torque + tau2
    }
}

/// `lossTable` row by row, and the file.
fn loss_table(map: &Map) -> (Vec<Vec<f64>>, Vec<Matrix>) {
    let files = export(map, Format::LossyGear, With::default()).unwrap();
    assert_eq!(files[0].name.to_string_lossy(), "ground_lossy_gear.mat");
    let found = matrices(&files[0].bytes);
    let table = matrix(&found, "lossTable");
    let rows = table.sizes[0];
    assert_eq!(table.sizes[1], 5);
    let row = |i: usize| (0..5).map(|j| table.values[j * rows + i]).collect();
    ((0..rows).map(row).collect(), found)
}

#[test]
fn the_lossy_gear_leaves_what_it_says() {
    let map = map();
    let (table, found) = loss_table(&map);
    let field = field(&map);
    let omega: Vec<f64> = table.iter().map(|row| row[0]).collect();
    assert_eq!(omega, field.omega());
    let residual = |(index, loss): (usize, &f64)| {
        of_lossy_gear(&table[index % 17][1..], field.torque_nm[index / 17]) - loss
    };
    let residuals: Vec<f64> = field.mesh_nm.iter().enumerate().map(residual).collect();
    let most = residuals.iter().fold(0.0_f64, |most, r| most.max(r.abs()));
    let rms = (residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len() as f64).sqrt();
    let of = |name: &str| matrix(&found, name).values[0];
    assert!((of("fit_max_nm") - most).abs() < 1e-12 && (of("fit_rms_nm") - rms).abs() < 1e-12);
    assert!(said_in(&found, "fit").contains("N m rms"));
    assert!((of("ratio") - RATIO).abs() < 1e-15);
    let mean = field.mesh_nm.iter().sum::<f64>() / residuals.len() as f64;
    assert!(most < 0.03 * mean, "{most} {mean}");
}

#[test]
fn losses_on_lines_are_those_of_the_lossy_gear() {
    // 0.3 N m and .01 of the torque where the input drives, .015 where the output drives.
    let lines = |torque: f64| 0.3 + if torque < 0.0 { 0.015 } else { 0.01 } * torque.abs();
    let on_lines = |torque: &[f64]| {
        let mut map = map_of(torque, &[60.0]);
        for point in &mut map.finishes[0].points {
            point.numbers.as_mut().unwrap().loss_torque_nm = lines(point.torque_nm);
        }
        loss_table(&map).0
    };
    let both: Vec<f64> = (0..9).map(|k| -80.0 + 20.0 * f64::from(k)).collect();
    for row in on_lines(&both) {
        let expected = [0.99, 1.0 / 1.015, 0.3, 0.3];
        assert!(
            row[1..]
                .iter()
                .zip(expected)
                .all(|(a, b)| (a - b).abs() < 1e-12),
            "{row:?}"
        );
    }
    // A direction without torques has the losses of the other.
    for row in on_lines(&[0.0, 40.0, 80.0]) {
        assert!((1.0 / row[2] - 1.01).abs() < 1e-12 && (row[1] - 0.99).abs() < 1e-12);
    }
    // A loss that falls with the torque has friction only; one that rises faster than a line has none.
    let of = |of: &dyn Fn(f64) -> f64| {
        let mut map = map_of(&both, &[60.0]);
        for point in &mut map.finishes[0].points {
            point.numbers.as_mut().unwrap().loss_torque_nm = of(point.torque_nm);
        }
        loss_table(&map).0.remove(0)
    };
    let falling = of(&|torque| 1.0 - 1e-3 * torque.abs());
    assert!(
        falling[1] == 1.0 && falling[2] == 1.0 && falling[3] > 0.9,
        "{falling:?}"
    );
    let rising = of(&|torque| 1e-4 * torque * torque);
    assert!(
        rising[3] == 0.0 && rising[1] < 1.0 && rising[2] < 1.0,
        "{rising:?}"
    );
}

#[test]
fn fastsim_takes_the_efficiency_of_a_cycle() {
    let map = map();
    let drive = cycle(
        "time_s,torque_nm,speed_rpm\n0,100,3000\n1,100,3000\n2,-50,3000\n",
        None,
    )
    .unwrap();
    let with = With {
        cycle: Some(&drive),
        ..With::default()
    };
    let (name, text) = text_of(&map, Format::Fastsim, with);
    assert_eq!(name, "ground_fastsim.yaml");
    assert!(
        text.starts_with("# scope mesh only") && text.contains("0 of its points outside"),
        "{text}"
    );
    let line = text.lines().last().unwrap();
    let found: f64 = line.strip_prefix("eff_interp: ").unwrap().parse().unwrap();
    assert!((found - (1.0 - made_up(100.0, 3000.0) / 100.0)).abs() < 1e-12);
    let braking = cycle("time_s,torque_nm,speed_rpm\n0,-50,3000\n1,-50,3000\n", None).unwrap();
    let with = With {
        cycle: Some(&braking),
        ..With::default()
    };
    let said = export(&map, Format::Fastsim, with).unwrap_err().to_string();
    assert!(said.contains("never does"), "{said}");
    let without = export(&map, Format::Fastsim, With::default());
    let said = without.unwrap_err().to_string();
    assert!(said.ends_with("and no cycle was given"), "{said}");
}

#[test]
fn added_loss_is_a_part_of_its_own() {
    let map = map();
    let added = AddedLoss::read(
        "bearings.csv",
        "speed_rpm,loss_torque_nm\n0,0.1\n16000,0.5\n",
    )
    .unwrap();
    let with = With {
        added: Some(&added),
        ..With::default()
    };
    let (_, text) = text_of(&map, Format::Csv, with);
    let mut rows = csv::Reader::from_reader(text.as_bytes());
    let header = rows.headers().unwrap().clone();
    let column = |name: &str| header.iter().position(|found| found == name).unwrap();
    let mut count = 0;
    for row in rows.records() {
        let row = row.unwrap();
        let of = |name: &str| row[column(name)].parse::<f64>().unwrap();
        let expected = 0.1 + 0.4 * of("speed_rpm") / 16000.0;
        assert!((of("added_loss_torque_nm") - expected).abs() < 1e-12);
        let mesh = made_up(of("torque_nm"), of("speed_rpm"));
        assert_eq!(of("mesh_loss_torque_nm"), mesh);
        assert!((of("loss_torque_nm") - mesh - expected).abs() < 1e-12);
        assert_eq!(
            &row[column("scope")],
            "mesh and added bearings.csv, input shaft"
        );
        count += 1;
    }
    assert_eq!(count, 33 * 17);
    let (_, text) = text_of(&map, Format::Modelica, with);
    assert!(text.contains("double addedLossTorque(34,18)"));
    let short = AddedLoss::read(
        "bearings.csv",
        "speed_rpm,loss_torque_nm\n0,0.1\n9000,0.5\n",
    )
    .unwrap();
    let with = With {
        added: Some(&short),
        ..With::default()
    };
    let error = export(&map, Format::Vecto, with).unwrap_err().to_string();
    assert!(error.contains("10000 1/min"), "{error}");
}

#[test]
fn a_map_of_one_sign_or_with_holes_is_refused() {
    let drive = map_of(&[10.0, 20.0], &[60.0]);
    let refused = export(&drive, Format::Vecto, With::default());
    let said = refused.unwrap_err().to_string();
    assert!(said.contains("needs torques of both signs"), "{said}");
    let mut holes = map();
    holes.finishes[0].points[5].numbers = None;
    let refused = export(&holes, Format::Matlab, With::default());
    let said = refused.unwrap_err().to_string();
    assert!(said.contains("points of the map have no result"), "{said}");
}

#[test]
fn the_fmu_describes_its_source_and_the_source_interpolates() {
    let map = map();
    let added = AddedLoss::read(
        "bearings.csv",
        "speed_rpm,loss_torque_nm\n0,0.1\n16000,0.5\n",
    )
    .unwrap();
    let with = With {
        added: Some(&added),
        ..With::default()
    };
    let files = export(&map, Format::Fmu, with).unwrap();
    let mut unit = zip::ZipArchive::new(std::io::Cursor::new(files[0].bytes.clone())).unwrap();
    let mut text = |name: &str| {
        let mut text = String::new();
        unit.by_name(name)
            .unwrap()
            .read_to_string(&mut text)
            .unwrap();
        text
    };
    let (xml, source) = (text("modelDescription.xml"), text("sources/loss.c"));
    let guid = xml
        .split("guid=\"")
        .nth(1)
        .unwrap()
        .split('"')
        .next()
        .unwrap();
    assert!(source.contains(&format!("#define GUID \"{guid}\"")));
    assert!(xml.contains("mesh and added bearings.csv"));
    for index in 3..=7 {
        assert_eq!(
            xml.matches(&format!("<Unknown index=\"{index}\"")).count(),
            2
        );
    }
    let fields = Field::all(&map, 0, Some(&added)).unwrap();
    assert_eq!(c_source(&fields).unwrap(), source);
    let beyond = [
        [300.0, 3000.0],
        [-300.0, -3000.0],
        [300.0, 20_000.0],
        [50.0, 20_000.0],
        [0.0, 3000.0],
    ];
    let places: Vec<[f64; 2]> = places().into_iter().chain(beyond).collect();
    let Some(found) = driven(&source, &places) else {
        eprintln!("NOTICE: no cc here; the source of the FMU is not compiled");
        return;
    };
    let surface = fields[0].surface();
    for ([torque, speed], [found, power, outside]) in places.into_iter().zip(found) {
        let expected = surface.loss_torque(torque, speed);
        let value = expected.value;
        assert!(
            (found - value).abs() < 1e-12,
            "{torque} {speed} {found} {value}"
        );
        assert!((power - value * speed.abs() * PI / 30.0).abs() < 1e-9 * power.abs());
        assert_eq!(outside == 1.0, expected.is_outside, "{torque} {speed}");
    }
}

#[test]
fn finishes_whose_files_would_have_one_name_are_refused() {
    let map = map();
    let named = |names: [&str; 2]| {
        let mut map = map.clone();
        map.finishes = names
            .map(|name| FinishMap {
                name: name.to_owned(),
                ..map.finishes[0].clone()
            })
            .into();
        map
    };
    for (names, format) in [
        (["a b", "a_b"], Format::Csv),
        (["a b", "a_b"], Format::Matlab),
        (["Ground", "ground"], Format::Vecto),
        (["µ", "é"], Format::Fmu),
    ] {
        let error = export(&named(names), format, With::default()).unwrap_err();
        let [first, second] = names;
        let message = format!("finishes {first:?} and {second:?} would both be exported as ");
        assert!(error.to_string().contains(&message), "{error}");
    }
    for names in [["a b", "a-b"], ["a", "b"]] {
        assert_eq!(
            export(&named(names), Format::Csv, With::default())
                .unwrap()
                .len(),
            2
        );
    }
}

#[test]
fn a_cycle_in_reverse_has_the_energies_of_the_same_cycle_forwards() {
    let map = map();
    let of = |sign: f64| {
        let row = |(time, [torque, speed]): (usize, [f64; 2])| {
            format!("{time},{},{}\n", sign * torque, sign * speed)
        };
        let points = [[0.0, 0.0], [120.0, 3000.0], [20.0, 2000.0], [-60.0, 2500.0]];
        let rows: String = points.into_iter().enumerate().map(row).collect();
        let trace = cycle(&format!("time_s,torque_nm,speed_rpm\n{rows}"), None).unwrap();
        evaluate(&map.clone().into(), 0, &trace, "made up", false).unwrap()
    };
    let (forwards, reverse) = (of(1.0), of(-1.0));
    assert!(forwards.drive_wh > 0.0 && forwards.coast_wh > 0.0);
    assert_eq!(
        (forwards.drive_wh, forwards.coast_wh),
        (reverse.drive_wh, reverse.coast_wh)
    );
    assert_eq!(forwards.finishes, reverse.finishes);
}

#[test]
fn beyond_the_map_loss_over_torque_is_held_and_marked() {
    let map = map();
    let field = field(&map);
    let surface = field.surface();
    let edge = made_up(160.0, 3000.0);
    let found = surface.loss_torque(300.0, 3000.0);
    assert!(found.is_outside && (found.value - edge * 300.0 / 160.0).abs() < 1e-12);
    // Of a map for one direction the other one is that of its torques.
    let one_sided = map_of(&[10.0, 20.0], &[60.0]);
    let source = c_source(&Field::all(&one_sided, 0, None).unwrap()).unwrap();
    let nan = f64::NAN;
    let places = [
        [-20.0, 3000.0],
        [-40.0, 3000.0],
        [nan, 3000.0],
        [10.0, nan],
        [20.0, 3000.0],
    ];
    let Some(said) = driven(&source, &places) else {
        eprintln!("NOTICE: no cc here; the source of the FMU is not compiled");
        return;
    };
    let edge = made_up(20.0, 3000.0);
    let [back, far, ..] = said[..] else { panic!() };
    assert!((back[0] - edge).abs() < 1e-12 && (far[0] - 2.0 * edge).abs() < 1e-12);
    let outside: Vec<f64> = said.iter().map(|[.., outside]| *outside).collect();
    assert_eq!(outside, [1.0, 1.0, 1.0, 1.0, 0.0]);
    assert!(said[2..4].iter().all(|[torque, ..]| torque.is_nan()));
}

#[test]
fn tables_without_a_rule_beyond_their_nodes_state_it() {
    let map = map();
    for format in [Format::Vecto, Format::Modelica] {
        let (name, text) = text_of(&map, format, With::default());
        assert!(
            text.contains("outside the table hold loss torque over torque"),
            "{name}"
        );
    }
    let files = export(&map, Format::Matlab, With::default()).unwrap();
    let said = said_in(&matrices(&files[0].bytes), "beyond");
    assert!(said.contains("outside the table hold loss torque over torque"));
}

#[test]
fn heads_name_what_is_outside_its_range() {
    let mut map = map();
    for (index, point) in map.finishes[0].points.iter_mut().enumerate() {
        point.outside.push("the fit: viscosity".to_owned());
        if index < 3 {
            point.outside.push(EXTENDED.to_owned());
        }
    }
    let (_, text) = text_of(&map, Format::Vecto, With::default());
    for stated in [
        "traces resolve: 3 of 561 nodes",
        "; outside a fitted range: the fit: viscosity (every node)",
    ] {
        assert!(text.contains(stated), "{text}");
    }
    assert!(!text.contains("561 of 561"));
}

#[test]
fn a_cycle_that_leaves_the_map_gives_no_single_efficiency() {
    let text = "time_s,torque_nm,speed_rpm\n0,100,3000\n1,100,3000\n2,300,3000\n3,300,3000\n";
    let drive = cycle(text, None).unwrap();
    let with = With {
        cycle: Some(&drive),
        ..With::default()
    };
    let error = export(&map(), Format::Fastsim, with).unwrap_err();
    assert_eq!(error.code(), "E205");
    let said = error.to_string();
    assert!(
        said.contains("75.0 % of the energy") && said.contains("300.0 at line 4 (t = 2.00 s)"),
        "{said}"
    );
}

/// Loss torque, loss power and mark of the places by the C source, driven as a unit; none without a compiler.
fn driven(source: &str, places: &[[f64; 2]]) -> Option<Vec<[f64; 3]>> {
    let number = |value: f64| {
        if value.is_nan() {
            "0.0 / 0.0".to_owned()
        } else {
            format!("{value:?}")
        }
    };
    let set = |[torque, speed]: &[f64; 2]| {
        let [torque, speed] = [number(*torque), number(speed * PI / 30.0)];
        vec![("TAU", torque), ("OMEGA", speed)]
    };
    let places: Vec<_> = places.iter().map(set).collect();
    let rows = said(source, &places, ["LOSS_TORQUE", "LOSS_POWER", "OUTSIDE"])?;
    Some(rows.into_iter().map(|row| row.unwrap()).collect())
}

/// Three variables of the compiled source after each set of inputs, `None` where an input is refused; `None` without a
/// compiler.
fn said(
    source: &str,
    inputs: &[Vec<(&str, String)>],
    outputs: [&str; 3],
) -> Option<Vec<Option<[f64; 3]>>> {
    let folder = tempfile::tempdir().unwrap();
    let call = |inputs: &Vec<(&str, String)>| {
        let set = inputs.iter().map(|(name, value)| {
            format!("r = {name}; v = {value}; if (fmi2SetReal(c, &r, 1, &v)) {{ puts(\"refused\"); fmi2Reset(c); }} else\n")
        });
        format!("{} say(c);\n", set.collect::<String>())
    };
    let calls: String = inputs.iter().map(call).collect();
    let main = format!(
        "{source}\n#include <stdio.h>\nstatic void say(Component c) {{\n\
         Reference out[] = {{{}}}; double r[3];\n\
         fmi2GetReal(c, out, 3, r); printf(\"%.17g %.17g %.17g\\n\", r[0], r[1], r[2]); }}\n\
         int main(void) {{ Component c = fmi2Instantiate(\"a\", 0, GUID, \"\", 0, 0, 0); Reference r; double v;\n\
         if (!c) return 1;\n{calls}return 0; }}\n",
        outputs.join(", ")
    );
    let (code, program) = (folder.path().join("main.c"), folder.path().join("main"));
    std::fs::write(&code, main).unwrap();
    let made = Command::new("cc")
        .args(["-w", "-o"])
        .args([&program, &code])
        .output()
        .ok()?;
    assert!(
        made.status.success(),
        "{}",
        String::from_utf8_lossy(&made.stderr)
    );
    let said = Command::new(&program).output().unwrap();
    assert!(said.status.success());
    let text = String::from_utf8(said.stdout).unwrap();
    let row = |line: &str| {
        let numbers = line.split(' ').map(|word| word.parse().ok());
        let numbers: Vec<f64> = numbers.collect::<Option<_>>()?;
        Some(<[f64; 3]>::try_from(numbers).unwrap())
    };
    Some(text.lines().map(row).collect())
}

/// A map at 60 and 100 °C of two meshes, the second of which has a quarter of the loss.
fn two_meshes() -> Map {
    let mut map = map_of(&[-100.0, 0.0, 100.0], &[60.0, 100.0]);
    let part = |name: &str, count: u32, share: f64| MeshPart {
        name: name.to_owned(),
        count,
        loss_torque_nm: map.finishes[0]
            .points
            .iter()
            .map(|point| Some(share * point.numbers.unwrap().loss_torque_nm))
            .collect(),
    };
    map.finishes[0].meshes = vec![part("sun <and> planet", 3, 0.75), part("second", 1, 0.25)];
    map
}

#[test]
fn the_fmu_of_several_temperatures_has_the_temperature_as_input_and_the_parts_of_the_meshes() {
    let map = two_meshes();
    let files = export(&map, Format::Fmu, With::default()).unwrap();
    assert_eq!(files.len(), 1);
    let mut unit = zip::ZipArchive::new(std::io::Cursor::new(files[0].bytes.clone())).unwrap();
    let mut xml = String::new();
    let mut description = unit.by_name("modelDescription.xml").unwrap();
    description.read_to_string(&mut xml).unwrap();
    for stated in [
        r#"name="temperature" valueReference="7" causality="input""#,
        r#"<Real unit="degC" start="60"/>"#,
        r#"name="mesh_1_loss_torque" valueReference="8" causality="output""#,
        "part of 3 sun &lt;and&gt; planet at the input shaft",
        r#"<Unknown index="10" dependencies="1 2 3"/>"#,
        "finish ground, 60, 100 °C; negative torque: the same flanks",
    ] {
        assert!(xml.contains(stated), "{stated}: {xml}");
    }
    let source = c_source(&Field::all(&map, 0, None).unwrap()).unwrap();
    let at = |temperature: &str| {
        let [torque, speed] = ["100.0", "314.1592653589793"].map(str::to_owned);
        vec![
            ("TAU", torque),
            ("OMEGA", speed),
            ("TEMPERATURE", temperature.to_owned()),
        ]
    };
    let inputs = [
        at("60.0"),
        at("90.0"),
        at("100.0"),
        at("120.0"),
        at("0.0 / 0.0"),
    ];
    let outputs = ["LOSS_TORQUE", "PART_TORQUE + 1", "OUTSIDE"];
    let Some(rows) = said(&source, &inputs, outputs) else {
        eprintln!("NOTICE: no cc here; the source of the FMU is not compiled");
        return;
    };
    // The made-up loss rises by 0.1 % per kelvin, and is held at 100 °C.
    let cold = made_up(100.0, 3000.0);
    for (row, [factor, outside]) in
        rows.iter()
            .zip([[1.0, 0.0], [1.03, 0.0], [1.04, 0.0], [1.04, 1.0]])
    {
        let [whole, second, is_outside] = row.unwrap();
        assert!((whole / (factor * cold) - 1.0).abs() < 1e-12, "{row:?}");
        assert!((second / (0.25 * whole) - 1.0).abs() < 1e-12, "{row:?}");
        assert_eq!(is_outside, outside);
    }
    // NaN is outside, and has no number.
    assert!(rows[4].is_none_or(|[whole, _, outside]| whole.is_nan() && outside == 1.0));
    // A map of one temperature has no such input.
    let single = c_source(&Field::all(&map_of(&[0.0, 100.0], &[60.0]), 0, None).unwrap()).unwrap();
    let refused = said(
        &single,
        &[at("90.0")],
        ["LOSS_TORQUE", "ADDED_TORQUE", "OUTSIDE"],
    );
    assert_eq!(refused.unwrap(), [None]);
}

#[test]
fn the_table_of_the_meshes_adds_up_to_the_loss() {
    let map = two_meshes();
    let files = export(&map, Format::Csv, With::default()).unwrap();
    let names: Vec<_> = files
        .iter()
        .map(|file| file.name.to_string_lossy())
        .collect();
    assert_eq!(names, ["ground.csv", "ground_meshes.csv"]);
    let column = |bytes: &[u8], name: &str| -> Vec<f64> {
        let mut table = csv::Reader::from_reader(bytes);
        let place = table
            .headers()
            .unwrap()
            .iter()
            .position(|head| head == name)
            .unwrap();
        table
            .records()
            .map(|row| row.unwrap()[place].parse().unwrap())
            .collect()
    };
    let whole: f64 = column(&files[0].bytes, "loss_torque_nm").iter().sum();
    let parts: f64 = column(&files[1].bytes, "loss_torque_nm").iter().sum();
    assert!((parts / whole - 1.0).abs() < 1e-12);
}
