//! Traces at known places of their flanks: however they were exported, the same points meet.

use std::collections::BTreeMap;

use asperity::case::{
    CaseInput, GearFlankInput, LoadedCase, ReliefInput, ReliefSource, TipRelief, from_text,
};
use asperity::gear::AmountDirection;
use asperity::quantity::Length;
use asperity::result::PositionRow;
use asperity_tests::assert_close;

/// Base radii of the pair below \[m\].
const BASE: [f64; 2] = [0.020_966_415_8, 0.061_987_664_2];
/// Arcs from the base circle that the traces cover \[m\], more than those in contact.
const ARCS: [[f64; 2]; 2] = [[0.2e-3, 3.9e-3], [3.2e-3, 7.0e-3]];
/// cos β_b of the pair.
const COS_BASE_HELIX: f64 = 0.927_752_144_885_6;

/// Arcs at the ends of the active flanks towards the tips \[m\].
const TIPS: [f64; 2] = [3.662_471_24e-3, 6.837_287_69e-3];
/// Relief at the tips, normal to the flank, and the arc over which it grows \[m\].
const RELIEF: [f64; 2] = [8e-6, 1.2e-3];

/// Height normal to a flank at an arc \[m\]: waves of many lengths, relief towards the tip.
fn height(body: usize, arc: f64) -> f64 {
    let seed = 1.0 + body as f64;
    let waves = (0..40).map(|k| {
        let length = 12e-6 * 1.08_f64.powi(k);
        let phase = (f64::from(k) * 2.399 + seed).sin() * 9.0;
        0.35e-6 * (length / 250e-6).sqrt() * (std::f64::consts::TAU * arc / length + phase).sin()
    });
    let [amount, length] = RELIEF;
    let relieved = (1.0 - (TIPS[body] - arc) / length).max(0.0);
    waves.sum::<f64>() * 0.45 - amount * relieved * relieved
}

/// A way to export a trace.
#[derive(Clone, Copy, PartialEq)]
enum Export {
    Arc,
    RollLength,
    RollDegrees,
}

/// File and keys of a flank exported one way, from the root or from the tip.
fn exported(body: usize, export: Export, from_tip: bool) -> (String, String) {
    let [low, high] = ARCS[body];
    let base = BASE[body];
    let roll = |arc: f64| (2.0 * base * arc).sqrt();
    let count = match export {
        Export::Arc => ((high - low) / 0.5e-6).round() as usize,
        _ => 12_000,
    };
    let at = |i: usize| i as f64 / count as f64;
    let mut rows: Vec<(f64, f64)> = (0..=count)
        .map(|i| match export {
            Export::Arc => {
                let along = (high - low) * at(i);
                let arc = if from_tip { high - along } else { low + along };
                (along * 1e6, height(body, arc))
            }
            _ => {
                let rho = roll(low) + (roll(high) - roll(low)) * at(i);
                // A checker's deviation counts along the transverse base tangent.
                let z = height(body, rho * rho / (2.0 * base)) / COS_BASE_HELIX;
                let x = match export {
                    Export::RollLength => rho * 1e3,
                    _ => (rho / base).to_degrees(),
                };
                (x, z)
            }
        })
        .collect();
    if from_tip && export != Export::Arc {
        rows.reverse();
    }
    let (label, keys) = match export {
        Export::Arc => {
            let (start, place) = if from_tip {
                ("tip", high)
            } else {
                ("root", low)
            };
            let rho = roll(place) * 1e3;
            let at = format!("from = \"{start}\", at = {{ roll_length = \"{rho:.9} mm\" }}");
            ("x [um]", at)
        }
        Export::RollLength => ("roll length [mm]", format!("base_radius = \"{} m\"", base)),
        Export::RollDegrees => ("roll angle [deg]", format!("base_radius = \"{} m\"", base)),
    };
    let lines = rows.iter().map(|(x, z)| format!("{x:.9},{:.9}\n", z * 1e6));
    let text = format!("{label},z [um]\n{}", lines.collect::<String>());
    (text, keys)
}

fn case(export: Export, from_tip: bool, swapped: bool) -> LoadedCase {
    let flanks = [0, 1].map(|body| exported(body, export, from_tip));
    let order = if swapped { [1, 0] } else { [0, 1] };
    let [(_, first), (_, second)] = order.map(|body: usize| flanks[body].clone());
    let (teeth, torque, speed) = if swapped {
        ("[68, 23]", 145.0 * 68.0 / 23.0, 9000.0 * 23.0 / 68.0)
    } else {
        ("[23, 68]", 145.0, 9000.0)
    };
    let text = format!(
        "gears = {{ teeth = {teeth}, module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\", \
         pinion.tip_relief = \"none\", wheel.tip_relief = \"none\" }}\n\
         operation = {{ torque = \"{torque} N m\", speed = \"{speed} 1/min\", bulk_temperature = \"90 °C\" }}\n\
         lubricant = {{ viscosity = {{ law = \"astm-d341\", at_40 = \"30.8 mm2/s\", at_100 = \"5.9 mm2/s\" }}, \
         density = \"845 kg/m3\", base_oil = \"pao\" }}\n\
         [surface]\ncutoff = \"0.25 mm\"\n\
         pinion = {{ file = \"{}\", {first} }}\nwheel = {{ file = \"{}\", {second} }}\n",
        order[0], order[1],
    );
    let files: BTreeMap<String, String> = (0..2)
        .map(|body| (body.to_string(), flanks[body].0.clone()))
        .collect();
    from_text("case.toml", &text, &|name| match files.get(name) {
        Some(file) => Ok(file.clone().into_bytes()),
        None => Err(std::io::ErrorKind::NotFound.into()),
    })
    .unwrap()
}

/// The same with the relief of both gears from their traces.
fn relieved(case: &LoadedCase) -> LoadedCase {
    let from_trace = |input: &mut CaseInput| {
        for gear in [&mut input.gears.pinion, &mut input.gears.wheel] {
            *gear = Some(GearFlankInput {
                relief: Some(ReliefSource::FromTrace),
                ..GearFlankInput::default()
            });
        }
    };
    case.with(from_trace).unwrap()
}

fn loss_factor(case: &LoadedCase) -> f64 {
    case.case.load_map().unwrap().loss_factor()
}

fn loss(case: &LoadedCase) -> f64 {
    assert!(case.surfaces.placement().is_some());
    let summary = asperity_tests::losses(case).unwrap().summary;
    assert!(
        summary.boundary_w > 20.0,
        "the flanks must touch: {summary:?}"
    );
    summary.loss_w
}

#[test]
fn a_flank_loses_the_same_however_it_was_exported() {
    let losses = |export, from_tip| {
        let case = case(export, from_tip, false);
        [loss(&case), loss(&relieved(&case))]
    };
    let expected = losses(Export::Arc, false);
    assert!(
        expected[1] < 0.96 * expected[0],
        "the relief counts: {expected:?}"
    );
    for (export, from_tip, name) in [
        (Export::Arc, true, "arc"),
        (Export::RollLength, false, "roll length"),
        (Export::RollLength, true, "roll length"),
        (Export::RollDegrees, false, "roll angle"),
        (Export::RollDegrees, true, "roll angle"),
    ] {
        for (found, expected) in losses(export, from_tip).into_iter().zip(expected) {
            println!("{name}, from the tip {from_tip}: {found:.3} W");
            assert_close(&format!("{name} {from_tip}"), found, expected, 0.01);
        }
    }
}

#[test]
fn pinion_and_wheel_can_change_places() {
    let [one, other] = [
        case(Export::Arc, false, false),
        case(Export::Arc, true, true),
    ];
    for change in [LoadedCase::clone, relieved] {
        let [expected, swapped] = [&one, &other].map(|case| loss(&change(case)));
        println!("{expected:.3} W, swapped {swapped:.3} W");
        assert_close("swapped", swapped, expected, 0.005);
    }
}

#[test]
fn a_trace_that_lies_the_other_way_round_loses_something_else() {
    let right = case(Export::Arc, false, false);
    let [start, end] = ARCS[0].map(|arc| (2.0 * BASE[0] * arc).sqrt() * 1e3);
    let wrong = right.with_key("surface.pinion.from", "tip").unwrap();
    let wrong = wrong
        .with_key("surface.pinion.at.roll_length", &format!("{end:.9} mm"))
        .unwrap();
    assert!(start < end);
    let change = loss(&wrong) / loss(&right) - 1.0;
    assert!(change.abs() > 1e-4, "{change}");
}

#[test]
fn a_point_is_one_place_by_each_of_its_coordinates() {
    let placed = case(Export::Arc, false, false);
    let expected = placed.surfaces.placement().unwrap().traces[0].first_arc;
    let (base, arc) = (BASE[0] * 1e3, ARCS[0][0] * 1e3);
    let roll = (2.0 * base * arc).sqrt();
    let radius = base.hypot(roll);
    let farther = (2.0 * base * (arc + 0.7)).sqrt();
    for at in [
        format!("roll_length = \"{roll:.12} mm\""),
        format!("position = \"{roll:.12} mm\""),
        format!("radius = \"{radius:.12} mm\""),
        format!("diameter = \"{:.12} mm\"", 2.0 * radius),
        format!("roll_angle = \"{:.12} deg\"", (roll / base).to_degrees()),
        format!("roll_length = \"{farther:.12} mm\", x = \"0.7 mm\""),
    ] {
        let case = placed.with_key("surface.pinion.at", &format!("{{ {at} }}"));
        let found = case.unwrap().surfaces.placement().unwrap().traces[0].first_arc;
        // The base radius above has ten digits.
        assert!((found - expected).abs() < 1e-9, "{at}: {found} {expected}");
    }
}

#[test]
fn the_share_that_the_traces_cover_is_that_of_the_loss() {
    const FIRST_ARC: f64 = 1.2e-3;
    let roll = (2.0 * BASE[0] * FIRST_ARC).sqrt() * 1e3;
    let late = case(Export::Arc, false, false)
        .with_key("surface.pinion.at.roll_length", &format!("{roll:.9} mm"))
        .unwrap();
    let result = asperity_tests::run(&late).result;
    let preparation = result.flanks[0].preparation.as_ref().unwrap();
    let cut_off = preparation.dropped_each_end as f64 * 0.5e-6;
    let sliding =
        |row: &PositionRow| row.weight_m * row.line_load_n_per_mm * row.sliding_m_per_s.abs();
    let arc = |row: &PositionRow| (1e-3 * row.s_mm).powi(2) / (2.0 * BASE[0]);
    let covered = result
        .path
        .iter()
        .filter(|row| arc(row) > FIRST_ARC + cut_off);
    let share = covered.map(sliding).sum::<f64>() / result.path.iter().map(sliding).sum::<f64>();
    assert!((0.5..0.9).contains(&share), "{share}");
    let warning = result.warnings.iter().find(|found| found.code == "W417");
    let says = format!("the traces cover {:.0} % of the loss", 100.0 * share);
    assert!(
        warning.unwrap().text.starts_with(&says),
        "{says} {warning:?}"
    );
}

#[test]
fn the_form_of_a_trace_is_the_relief_that_was_ground() {
    let placed = case(Export::RollLength, false, false);
    let measured = relieved(&placed);
    let [amount, length] = RELIEF;
    let drawn = placed.with(|input| {
        input.gears.amounts = Some(AmountDirection::Normal);
        let tips = [&mut input.gears.pinion, &mut input.gears.wheel];
        for (body, gear) in tips.into_iter().enumerate() {
            // It grows with the square of the arc, which is nearly that of the roll length.
            let roll = |arc: f64| (2.0 * BASE[body] * arc).sqrt();
            gear.get_or_insert_default().tip_relief = Some(TipRelief::Drawn(ReliefInput {
                amount: Length::from_si(amount),
                length: Some(Length::from_si(
                    roll(TIPS[body]) - roll(TIPS[body] - length),
                )),
                start_diameter: None,
                power: Some(2),
            }));
        }
    });
    let factors = [&measured, &drawn.unwrap(), &placed].map(loss_factor);
    println!(
        "H_V from the traces {:.5}, drawn {:.5}, without {:.5}",
        factors[0], factors[1], factors[2]
    );
    // The Gaussian filter rounds the beginning of a relief; 6e-4 was seen.
    assert_close("H_V", factors[0], factors[1], 2e-3);
    assert!(factors[2] > 1.05 * factors[1]);
    for report in measured.flanks.iter() {
        // Waves of 12 to 250 um leave some of their height in a mean line that ends here, and the filter rounds the relief.
        let form = report.form.as_ref().unwrap();
        assert_close("at the tip", form.at_tip.si(), amount, 0.2);
        assert!(
            (0.0..0.2 * amount).contains(&form.at_root.si()),
            "{:?}",
            form.at_root
        );
    }
}

#[test]
fn a_cut_trace_keeps_its_place() {
    let [start, end] = [0.3e-3, 3.4e-3];
    for (export, from_tip) in [
        (Export::Arc, false),
        (Export::Arc, true),
        (Export::RollLength, false),
        (Export::RollDegrees, false),
    ] {
        let mut case = case(export, from_tip, false);
        for gear in ["pinion", "wheel"] {
            let key = format!("surface.{gear}.range");
            case = case.with_key(&key, "0.3 mm .. 3.4 mm").unwrap();
        }
        for body in [0, 1] {
            let [low, high] = ARCS[body];
            let expected = if from_tip {
                [high - end, high - start]
            } else {
                [low + start, low + end]
            };
            let found = case.flanks[body].roll_lengths.unwrap();
            let mut arcs = found.map(|roll| roll.si() * roll.si() / (2.0 * BASE[body]));
            arcs.sort_by(f64::total_cmp);
            for (found, expected) in arcs.into_iter().zip(expected) {
                // A point of the checker's files is up to 0.7 um from the end of the range.
                assert!((found - expected).abs() < 0.7e-6, "{found} {expected}");
            }
            let cut = case.flanks[body].reading.as_ref().unwrap().cut.unwrap();
            assert_close("length", cut.of.si(), high - low, 1e-6);
        }
    }
}

#[test]
fn the_form_follows_torque_and_gears() {
    let at = |torque: &str| {
        let case = case(Export::RollLength, false, false);
        relieved(&case.with_key("operation.torque", torque).unwrap())
    };
    let cutoff = |case: &LoadedCase| case.flanks[0].form.as_ref().unwrap().cutoff.si();
    let (half, whole) = (at("72.5 N m"), at("145 N m"));
    // Eight half-widths, in whole micrometres, go with the root of the load.
    assert_close(
        "cut-off",
        cutoff(&half),
        0.5_f64.sqrt() * cutoff(&whole),
        2e-3,
    );
    let again = half.with_key("operation.torque", "145 N m").unwrap();
    assert_eq!(loss(&again), loss(&whole));
    assert!(whole.warnings.iter().any(|warning| warning.code == "W434"));
    // A cut-off above them holds at every torque.
    for case in [&half, &whole] {
        let longer = case.with_key("surface.cutoff", "1.9 mm").unwrap();
        assert_eq!(cutoff(&longer), 1.9e-3);
        assert!(longer.warnings.iter().all(|warning| warning.code != "W434"));
    }
    // Of other gears the same roll lengths are other places, and these do not span the flank.
    assert!(whole.with_key("gears.module", "2 mm").is_err());
}

#[test]
fn several_traces_have_the_mean_of_their_forms() {
    let form = |traces: &str| {
        let flank = |factor: f64| {
            let (text, _) = exported(0, Export::RollLength, false);
            let (header, rows) = text.split_once('\n').unwrap();
            let times = |row: &str| {
                let (x, z) = row.split_once(',').unwrap();
                format!("{x},{:.9}\n", factor * z.parse::<f64>().unwrap())
            };
            format!("{header}\n{}", rows.lines().map(times).collect::<String>())
        };
        let text = format!(
            "gears = {{ teeth = [23, 68], module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\", \
             pinion = {{ relief = \"from-trace\" }} }}\n\
             operation = {{ torque = \"145 N m\", speed = \"9000 1/min\", bulk_temperature = \"90 °C\" }}\n\
             lubricant = {{ oil = \"m100\" }}\n\
             [surface]\npinion = {{ traces = [{traces}] }}\nwheel = {{ rq = \"0.4 um\" }}\n"
        );
        let read = |name: &str| match name.parse() {
            Ok(factor) => Ok(flank(factor).into_bytes()),
            Err(_) => Err(std::io::ErrorKind::NotFound.into()),
        };
        let case = from_text("case.toml", &text, &read).unwrap().case.clone();
        case.micro_geometry.measured[0].clone().unwrap()
    };
    let (one, three) = (form("\"1\""), form("\"0.5\", \"1\", \"1.5\""));
    for (one, mean) in one.height.iter().zip(&three.height) {
        assert!((one.si() - mean.si()).abs() < 1e-12);
    }
}
