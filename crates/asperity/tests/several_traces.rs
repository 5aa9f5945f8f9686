//! Several traces of a flank: all pairs of teeth, their mean and its error.

#![allow(clippy::unwrap_used, reason = "tests may panic")]

use std::collections::BTreeMap;

use crate::runs::losses;
use crate::runs::{contacts, losses_with};
use asperity::case::{LoadedCase, Source, from_contents, from_text, load, load_holding};
use asperity::core::Profile;
use asperity::core::numerics::student_t_quantile;
use asperity::message::Warning;
use asperity::pipeline::Kept;
use asperity::quantity::Length;
use asperity::result::loss_band::SamplingPart;
use asperity::uncertainty::{difference, pair_sampling};
use asperity::{Error, Run};
use chacha20::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

/// Spacing of the traces \[m\].
const SPACING: f64 = 0.5e-6;
/// Points of a trace.
const POINTS: usize = 7000;

/// The file of a trace of its own for every `seed`: waves of many lengths.
fn trace(seed: u32) -> String {
    let height = |i: usize| {
        let x = SPACING * i as f64;
        let waves = (0..36).map(|k| {
            let length = 8e-6 * 1.1_f64.powi(k);
            let phase = f64::from(k * 7 + 1) * f64::from(seed + 1) * 1.37;
            let size = 0.25e-6 * (1.0 + 0.1 * f64::from(seed)) * (length / 250e-6).sqrt();
            size * (std::f64::consts::TAU * x / length + phase).sin()
        });
        waves.sum::<f64>()
    };
    let rows = (0..POINTS).map(|i| format!("{:.1},{:.9}\n", 0.5 * i as f64, 1e6 * height(i)));
    format!("x [um],z [um]\n{}", rows.collect::<String>())
}

/// The e-drive, or spur gears in its place, on flanks of these keys; a file is named by its seed.
fn case_of(helix: &str, pinion: &str, wheel: &str) -> Result<LoadedCase, Error> {
    let text = format!(
        "gears = {{ teeth = [23, 68], module = \"1.8 mm\", helix = \"{helix} deg\", face_width = \"32 mm\" }}\n\
         operation = {{ torque = \"145 N m\", speed = \"3000 1/min\", bulk_temperature = \"90 °C\" }}\n\
         lubricant = {{ viscosity = {{ law = \"astm-d341\", at_40 = \"30.8 mm2/s\", at_100 = \"5.9 mm2/s\" }}, \
         density = \"845 kg/m3\", base_oil = \"pao\" }}\n\
         model = {{ positions = 4, offsets = 2 }}\n\
         [surface]\ncutoff = \"0.25 mm\"\npinion = {{ {pinion} }}\n{wheel}\n"
    );
    from_text("case.toml", &text, &|name| match name.parse() {
        Ok(seed) => Ok(trace(seed).into_bytes()),
        Err(_) => Err(std::io::ErrorKind::NotFound.into()),
    })
}

fn case(pinion: &str, wheel: &str) -> LoadedCase {
    case_of("23.4", pinion, &format!("wheel = {{ {wheel} }}")).unwrap()
}

fn loss(case: &LoadedCase) -> f64 {
    losses(case).unwrap().summary.loss_w
}

/// A standard normal deviate.
fn normal(random: &mut ChaCha8Rng) -> f64 {
    let mut uniform = || ((random.next_u64() >> 11) as f64 + 0.5) / (1_u64 << 53) as f64;
    let (a, b) = (uniform(), uniform());
    (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
}

/// Share of the 95 % intervals of P_ij = a_i + b_j + c_ij that hold the mean, which is 0.
fn coverage(teeth: [usize; 2], [a, b, c]: [f64; 3], random: &mut ChaCha8Rng) -> f64 {
    const REPEATS: usize = 1000;
    let covered = (0..REPEATS).filter(|_| {
        let mut draw = |size: f64, count: usize| -> Vec<f64> {
            (0..count).map(|_| size * normal(random)).collect()
        };
        let (rows, columns) = (draw(a, teeth[0]), draw(b, teeth[1]));
        let rest = draw(c, teeth[0] * teeth[1]);
        let losses: Vec<f64> = (0..rest.len())
            .map(|k| rows[k / teeth[1]] + columns[k % teeth[1]] + rest[k])
            .collect();
        let found = pair_sampling(&losses, teeth).unwrap();
        found.mean_w.abs() <= found.half_width_w
    });
    covered.count() as f64 / REPEATS as f64
}

#[test]
fn intervals_between_traces_cover_the_mean_of_all_teeth() {
    let mut random = ChaCha8Rng::seed_from_u64(20261121);
    // With very unlike numbers of teeth and the scatter in the flank of the few, d comes out too large.
    for (teeth, least) in [
        ([2, 2], 0.91),
        ([3, 3], 0.91),
        ([4, 4], 0.91),
        ([8, 8], 0.91),
        ([5, 3], 0.91),
        ([2, 5], 0.87),
    ] {
        for parts in [
            [1.0, 1.0, 0.3],
            [1.0, 0.3, 0.3],
            [0.3, 1.0, 0.0],
            [1.0, 1.0, 1.0],
        ] {
            let found = coverage(teeth, parts, &mut random);
            println!("{teeth:?} {parts:?}: {found:.3}");
            let is_right = (least..=0.995).contains(&found);
            assert!(is_right, "{teeth:?} {parts:?}: {found}");
        }
    }
    // A flank of which a single tooth was traced: the interval is of the other flank alone.
    let alone = coverage([6, 1], [1.0, 0.0, 0.3], &mut random);
    let bound = coverage([6, 1], [1.0, 2.0, 0.3], &mut random);
    assert!(
        (0.93..=0.97).contains(&alone) && bound < 0.8,
        "{alone} {bound}"
    );
}

#[test]
fn every_pair_loses_what_it_loses_alone() {
    let several = case("traces = [\"0\", \"1\"]", "traces = [\"2\", \"3\"]");
    assert_eq!(several.surfaces.teeth(), Some([2, 2]));
    let result = asperity::Run::new(&several)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result;
    let pairs = result.pairs.unwrap();
    let mut sum = 0.0;
    let of_wheel = 0.5 * (pairs.losses_w[0][1] + pairs.losses_w[1][1]);
    assert_eq!(pairs.traces[1][1].loss_w, Some(of_wheel));
    for (i, row) in pairs.losses_w.iter().enumerate() {
        for (j, found) in row.iter().enumerate() {
            let alone = case(&format!("file = \"{i}\""), &format!("file = \"{}\"", j + 2));
            let alone = loss(&alone);
            assert!(
                (found / alone - 1.0).abs() < 1e-14,
                "{i} {j}: {found} {alone}"
            );
            sum += alone;
        }
    }
    assert!((result.summary.loss_w / (0.25 * sum) - 1.0).abs() < 1e-14);
    assert!((pairs.sampling.unwrap().mean_w / (0.25 * sum) - 1.0).abs() < 1e-14);
    assert!(pairs.sampling.unwrap().standard_error_w > 0.0);
    let files = pairs.traces.each_ref().map(|traces| {
        let files = traces
            .iter()
            .map(|trace| trace.record.file.clone().unwrap());
        files.collect::<Vec<_>>()
    });
    assert_eq!(files, [["0", "1"], ["2", "3"]]);
    assert_eq!(result.summary.offsets, 8);
}

#[test]
fn identical_traces_lose_what_one_loses_without_any_error() {
    let one = case("file = \"0\"", "file = \"2\"");
    let same = case(
        "traces = [\"0\", \"00\"]",
        "traces = [\"2\", \"02\", \"002\"]",
    );
    let found = losses(&same).unwrap();
    assert!((found.summary.loss_w / loss(&one) - 1.0).abs() < 1e-15);
    let sampling = found.pairs.unwrap();
    assert_eq!(sampling.between_w, [0.0, 0.0]);
    assert_eq!(
        (sampling.standard_error_w, sampling.half_width_w),
        (0.0, 0.0)
    );
}

#[test]
fn the_order_of_the_traces_changes_nothing() {
    let sampling = |pinion: &str, wheel: &str| losses(&case(pinion, wheel)).unwrap().pairs.unwrap();
    let first = sampling("traces = [\"0\", \"1\"]", "traces = [\"2\", \"3\", \"4\"]");
    let other = sampling("traces = [\"1\", \"0\"]", "traces = [\"4\", \"2\", \"3\"]");
    for (a, b) in [
        (first.mean_w, other.mean_w),
        (first.standard_error_w, other.standard_error_w),
        (first.half_width_w, other.half_width_w),
        (first.interaction_w, other.interaction_w),
    ] {
        assert!((a / b - 1.0).abs() < 1e-9, "{a} {b}");
    }
}

#[test]
fn kept_contacts_are_those_of_every_pair() {
    let several = case("traces = [\"0\", \"1\"]", "traces = [\"2\", \"3\"]");
    let tables = contacts(&several).unwrap();
    let warmer = several
        .with_key("operation.bulk_temperature", "100 °C")
        .unwrap();
    let kept = losses_with(&tables, &warmer).unwrap();
    let anew = losses(&warmer).unwrap();
    assert_eq!(kept.summary.loss_w, anew.summary.loss_w);
    assert_eq!(kept.pairs, anew.pairs);
    // Those of another pair are not taken.
    let other = case("traces = [\"0\", \"1\"]", "traces = [\"2\", \"4\"]");
    let kept = losses_with(&tables, &other).unwrap();
    assert_eq!(kept.summary, losses(&other).unwrap().summary);
    assert_eq!(kept.pairs, losses(&other).unwrap().pairs);
}

#[test]
fn the_draws_have_the_error_between_traces() {
    let several = case("traces = [\"0\", \"1\", \"5\"]", "traces = [\"2\", \"3\"]");
    let run = Run::new(&several).pictures(Kept::Highest);
    let (outcome, drawn) = run
        .interval(true)
        .execute()
        .unwrap()
        .only_with_draws()
        .unwrap();
    let (result, drawn) = (outcome.result, drawn.unwrap());
    let (found, pairs) = (result.uncertainty.unwrap(), result.pairs.unwrap());
    let SamplingPart::Pairs(sampling) = &found.sampling else {
        panic!("{:?}", found.sampling)
    };
    assert_eq!(sampling.traces, [3, 2]);
    let of_pairs = pairs.sampling.unwrap();
    assert!((sampling.standard_error_w / of_pairs.standard_error_w - 1.0).abs() < 1e-12);
    assert_eq!(sampling.misplaced_w, None);
    // Of ln loss: the same over the mean, to second order.
    let part = found
        .loss
        .parts
        .iter()
        .find(|part| part.name == "sampling of the flanks")
        .unwrap();
    let relative = of_pairs.standard_error_w / of_pairs.mean_w;
    let [low, high] = part.quantiles_w;
    let half = student_t_quantile(0.90, of_pairs.freedom) * relative;
    assert!(
        ((high / low).ln() / (2.0 * half) - 1.0).abs() < 0.03,
        "{low} {high} {half}"
    );
    assert!(
        result
            .path
            .iter()
            .all(|row| row.sliding_standard_error_w_per_m.is_some())
    );
    // A finish compared with itself.
    let own = (&several, &drawn, &found);
    let nothing = difference(own, own);
    assert_eq!(
        (nothing.at_medians_w, nothing.watts.ends()),
        (0.0, [0.0, 0.0])
    );
}

#[test]
fn one_traced_tooth_of_the_wheel_makes_the_error_a_lower_bound() {
    let several = case("traces = [\"0\", \"1\", \"5\"]", "file = \"2\"");
    let found = losses(&several).unwrap();
    let one_tooth = |w: &&Warning| w.code == "W450" && w.text.starts_with("one tooth of the wheel");
    let listed = [
        found.warnings,
        asperity::Run::new(&several).check().unwrap(),
    ];
    assert_eq!(
        listed.map(|all| all.iter().filter(one_tooth).count()),
        [1, 1]
    );
    let sampling = found.pairs.unwrap();
    assert_eq!(sampling.traces, [3, 1]);
    assert!(sampling.standard_error_w > 0.0 && sampling.between_w[1] == 0.0);
}

#[test]
fn a_contact_takes_the_trace_nearest_in_y() {
    // On a spur pair without width errors the load is the same all over the face: two traces 8 and 16 mm from its end
    // stand for 12 and 20 mm of its 32. Loads of equal zones differ in their last digit, and contacts by their tolerance.
    let spur = |pinion: &str| case_of("0", pinion, "wheel = { file = \"2\" }").unwrap();
    let both = spur(
        "traces = [{ file = \"0\", tooth = 3, y = \"8 mm\" }, { file = \"1\", tooth = 3, y = \"16 mm\" }]",
    );
    assert_eq!(both.surfaces.teeth(), Some([1, 1]));
    let found = losses(&both).unwrap();
    let [first, second] = ["file = \"0\"", "file = \"1\""].map(|keys| loss(&spur(keys)));
    let expected = (12.0 * first + 20.0 * second) / 32.0;
    assert!((first / second - 1.0).abs() > 1e-3, "{first} {second}");
    let loss_w = found.summary.loss_w;
    assert!(
        (loss_w / expected - 1.0).abs() < 1e-9,
        "{loss_w} {expected} {first} {second}"
    );
    // One tooth each: no error to tell.
    assert_eq!(found.pairs, None);
    assert_eq!(found.path.len(), 8);
    let zones: Vec<_> = found.path.iter().map(|row| row.face_zone).collect();
    assert_eq!(zones[..4], [Some(0), Some(1), Some(0), Some(1)]);
    // The same trace at both places is the trace alone, on helical gears too.
    let helical = case(
        "traces = [{ file = \"0\", tooth = 3, y = \"8 mm\" }, { file = \"0\", tooth = 3, y = \"16 mm\" }]",
        "file = \"2\"",
    );
    let alone = case("file = \"0\"", "file = \"2\"");
    let [zones, one] = [&helical, &alone].map(|case| {
        let finer = case.with_key("model.positions", "32").unwrap();
        losses(&finer).unwrap().summary
    });
    // Cells and windows are cut anew for each zone; the more of them, the less that changes (2.4 % at 4 positions).
    assert!((zones.loss_w / one.loss_w - 1.0).abs() < 1e-2);
    assert!((zones.rolling_w / one.rolling_w - 1.0).abs() < 1e-4);
}

#[test]
fn each_trace_may_lie_at_a_place_of_its_own() {
    let at = |seed: u32, roll: f64| {
        format!("{{ file = \"{seed}\", at = {{ roll_length = \"{roll} mm\" }} }}")
    };
    let pinion = format!("traces = [{}, {}]", at(0, 3.9), at(1, 4.4));
    let placed = case(&pinion, "file = \"2\", at = { roll_length = \"20.7 mm\" }");
    let found = losses(&placed).unwrap();
    assert_eq!(found.offsets.len(), 2);
    let alone = |seed: u32, roll: f64| {
        let keys = format!("file = \"{seed}\", at = {{ roll_length = \"{roll} mm\" }}");
        loss(&case(
            &keys,
            "file = \"2\", at = { roll_length = \"20.7 mm\" }",
        ))
    };
    let expected = 0.5 * (alone(0, 3.9) + alone(1, 4.4));
    assert!((found.summary.loss_w / expected - 1.0).abs() < 1e-14);
    let result = Run::new(&placed)
        .pictures(Kept::Highest)
        .interval(true)
        .execute()
        .unwrap()
        .into_only()
        .unwrap()
        .result;
    let SamplingPart::Pairs(sampling) = result.uncertainty.unwrap().sampling else {
        panic!("two pairs were sampled")
    };
    assert!(sampling.misplaced_w.is_some());
    // Where one place is missing nothing is placed.
    let some = case(
        &format!("traces = [{}, \"1\"]", at(0, 3.9)),
        "file = \"2\", at = { roll_length = \"20.7 mm\" }",
    );
    assert!(some.surfaces.placement().is_none());
    assert!(some.warnings.iter().any(|warning| warning.code == "W418"));
}

#[test]
fn the_micropitting_film_stands_over_the_roughness_of_all_traces() {
    let rated = |case: &LoadedCase| {
        let case = case.with(|input| input.micropitting = Some(Default::default()));
        let result = asperity::Run::new(&case.unwrap())
            .execute()
            .unwrap()
            .into_only()
            .unwrap()
            .result;
        let found = result.micropitting.unwrap();
        let rq =
            |cell: &asperity::result::MicropittingCell| cell.film_um / cell.lambda_short.unwrap();
        (found.ra_um, found.cells.iter().map(rq).collect::<Vec<_>>())
    };
    let (ra, rq) = rated(&case("traces = [\"0\", \"5\"]", "file = \"2\""));
    let alone = ["0", "5"].map(|seed| rated(&case(&format!("file = \"{seed}\""), "file = \"2\"")));
    let near = |found: f64, a: f64, b: f64| (found / (0.5 * (a + b)) - 1.0).abs() < 1e-12;
    assert!(
        (alone[0].0[0] / alone[1].0[0] - 1.0).abs() > 0.1,
        "{alone:?}"
    );
    for body in [0, 1] {
        assert!(near(ra[body], alone[0].0[body], alone[1].0[body]), "{ra:?}");
    }
    for (k, rq) in rq.iter().enumerate() {
        assert!(near(*rq, alone[0].1[k], alone[1].1[k]), "{k}: {rq}");
    }
}

#[test]
fn patterns_take_the_files_of_a_folder_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let files: BTreeMap<&str, u32> =
        [("pinion_b.csv", 1), ("pinion_a.csv", 0), ("wheel.csv", 2)].into();
    for (name, seed) in &files {
        std::fs::write(folder.path().join(name), trace(*seed)).unwrap();
    }
    let drive = include_str!("../../../fixtures/cases/e-drive.toml");
    let head = drive.split("[surface]").next().unwrap();
    let write = |surface: &str| {
        let path = folder.path().join("case.toml");
        std::fs::write(&path, format!("{head}[surface]\n{surface}\n")).unwrap();
        load(&path, None)
    };
    let wheel = "wheel = { file = \"wheel.csv\" }";
    let several = write(&format!(
        "pinion = {{ traces = \"pinion_*.csv\" }}\n{wheel}"
    ))
    .unwrap();
    let named: Vec<_> = several
        .all_traces()
        .iter()
        .map(|flank| flank.file.clone().unwrap())
        .collect();
    assert_eq!(named, ["pinion_a.csv", "pinion_b.csv", "wheel.csv"]);
    let none = write(&format!("pinion = {{ traces = \"gear_*.csv\" }}\n{wheel}")).unwrap_err();
    assert_eq!(none.code(), "E137");
    let folder_named = folder.path().display().to_string();
    assert!(
        none.to_string().contains("gear_*.csv") && none.to_string().contains(&folder_named),
        "{none}"
    );
    // The case as a value is the same case.
    let text = several.case.input.to_toml().unwrap();
    assert!(text.contains("traces = \"pinion_*.csv\""), "{text}");
    let again: asperity::CaseInput = text.parse().unwrap();
    assert_eq!(again, several.case.input);
    // So is the case of its content, whose files are in memory.
    let contents = several.contents().unwrap();
    let held = from_contents(several.name(), &text, contents).unwrap();
    assert_eq!(held.fingerprint(), several.fingerprint());
}

#[test]
fn traces_give_way_to_other_keys_one_after_the_other() {
    let mut input = case_of(
        "23.4",
        "traces = [\"0\", \"1\"]",
        "wheel = { traces = [\"2\"] }",
    )
    .unwrap()
    .case
    .input
    .clone();
    input.unset("surface.pinion.traces").unwrap();
    input.unset("surface.wheel.traces").unwrap();
    input.set("model.positions", "4").unwrap();
    input.set("surface.pinion.rq", "0.2 um").unwrap();
    input.set("surface.wheel.rq", "0.3 um").unwrap();
    let surface = input.surface;
    let rq = |flank: asperity::case::FlankInput| flank.rq.unwrap().si();
    assert_eq!(
        (rq(surface.pinion), rq(surface.wheel.unwrap())),
        (0.2e-6, 0.3e-6)
    );
}

#[test]
fn what_several_traces_cannot_mean_is_refused() {
    let refused = |pinion: &str, wheel: &str| {
        let error = case_of("23.4", pinion, wheel).unwrap_err();
        (error.code(), error.to_string())
    };
    let wheel = "wheel = { file = \"2\" }";
    for (pinion, wheel, code, says) in [
        (
            "traces = [\"0\", \"1\"]",
            "",
            "E205",
            "give traces of the wheel",
        ),
        ("traces = []", wheel, "E205", "names no trace"),
        (
            "traces = [\"0\"], file = \"1\"",
            wheel,
            "E205",
            "instead of file",
        ),
        ("traces = \"*\"", wheel, "E137", "name the files one by one"),
        (
            "traces = [{ file = \"0\", tooth = 1 }, { file = \"1\", tooth = 1 }]",
            wheel,
            "E205",
            "need y",
        ),
        (
            "traces = [{ file = \"0\", tooth = 1, y = \"1 mm\" }, { file = \"1\", tooth = 1, y = \"1 mm\" }]",
            wheel,
            "E205",
            "same tooth at the same y",
        ),
        (
            "traces = [{ file = \"0\", y = \"33 mm\" }]",
            wheel,
            "E209",
            "must not exceed the face width",
        ),
        (
            "traces = [{ file = \"0\", tooth = 24 }]",
            wheel,
            "E209",
            "must not exceed the number of teeth",
        ),
        (
            "traces = [\"0\", \"1\", \"0\"]",
            wheel,
            "E205",
            "of several teeth",
        ),
        ("traces = [{ tooth = 1 }]", wheel, "E204", "file"),
        (
            "traces = [{ file = \"0\", teeth = 1 }]",
            wheel,
            "E204",
            "teeth",
        ),
        ("traces = [3]", wheel, "E204", "a file, or a table"),
    ] {
        let (found, said) = refused(pinion, wheel);
        assert_eq!(found, code, "{pinion}: {said}");
        assert!(said.contains(says), "{pinion}: {said}");
    }
    let several = case("traces = [\"0\", \"1\"]", "file = \"2\"");
    for (key, value) in [
        ("model.load_share", "ehl"),
        ("model.full_film", "ehl-transient"),
    ] {
        let error = several.with_key(key, value).unwrap_err();
        assert_eq!(error.code(), "E205", "{error}");
        assert!(error.to_string().contains("one pair of traces"), "{error}");
    }
    several.with_key("operation.running_in", "true").unwrap();
    let dry = asperity::contacts::dry_contact::dry_contact(&several, 0.5).unwrap_err();
    assert_eq!(dry.code(), "E312");
    let gradient = asperity::pipeline::gradient(&several).unwrap_err();
    assert_eq!(gradient.code(), "E312");
}

/// Gears with a face of 20 mm on short traces of these keys; a file is named by its seed.
fn short(pinion: &str, wheel: &str) -> LoadedCase {
    let text = format!(
        "gears = {{ teeth = [23, 68], module = \"1.8 mm\", face_width = \"20 mm\" }}\n\
         operation = {{ torque = \"145 N m\", speed = \"3000 1/min\", bulk_temperature = \"90 °C\" }}\n\
         lubricant = {{ oil = \"m100\" }}\n\
         [surface]\ncutoff = \"0.025 mm\"\npinion = {{ {pinion} }}\nwheel = {{ {wheel} }}\n"
    );
    let trace = |name: &str| {
        let seed: u32 = name.parse().unwrap();
        let height = |i: u32| (f64::from(i) * (0.3 + 1e-3 * f64::from(seed))).sin();
        let rows = (0..500).map(|i| format!("{:.1},{:.4}\n", 0.5 * f64::from(i), height(i)));
        format!("x [um],z [um]\n{}", rows.collect::<String>())
    };
    from_text("case.toml", &text, &|name| Ok(trace(name).into_bytes())).unwrap()
}

#[test]
fn zones_lie_between_the_traces_of_a_tooth() {
    let at = |file: u32, y: &str| format!("{{ file = \"{file}\", tooth = 1, y = \"{y} mm\" }}");
    let pinion = format!("traces = [{}, {}, \"2\"]", at(0, "4"), at(1, "16"));
    let wheel = [at(3, "15"), at(4, "5"), at(5, "10")].join(", ");
    let several = short(&pinion, &format!("traces = [{wheel}]"));
    let edges = &several.case.face_zones;
    let expected = [7.5 / 20.0, 0.5, 12.5 / 20.0];
    assert_eq!(edges.len(), 3);
    assert!(
        edges
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() < 1e-12)
    );
    // In each zone the nearest traces of both teeth of the pinion and of the tooth of the wheel.
    let alone = [(0, 3), (1, 4), (2, 5)].map(|(pinion, wheel)| {
        let [pinion, wheel] = [pinion, wheel].map(|file: u32| format!("file = \"{file}\""));
        short(&pinion, &wheel).surfaces.clone()
    });
    for (zone, [pinion, wheel]) in [[0, 4], [0, 5], [1, 5], [1, 3]].into_iter().enumerate() {
        for (pair, pinion) in [pinion, 2].into_iter().enumerate() {
            let met = several.surfaces.met(zone, pair, 2).0.textures();
            assert_eq!(met[0], alone[pinion].textures()[0], "{zone} {pair}");
            assert_eq!(met[1], alone[wheel - 3].textures()[1], "{zone} {pair}");
        }
    }
}

#[test]
fn stars_and_question_marks_stand_for_characters() {
    let files = [
        "pinion_.csv",
        "pinion_1.csv",
        "pinion_1.csv.bak",
        "t1.txt",
        "t12.txt",
        "wheel_1.csv",
        "xaab",
        "xaba",
    ];
    let heights = (0..500).map(|i| 1e-6 * (f64::from(i) * 0.3).sin());
    let trace = Profile::new(Length::from_si(SPACING), heights.collect()).unwrap();
    let held = files.map(|file| (file.into(), trace.clone()));
    let folder = tempfile::tempdir().unwrap();
    let drive = include_str!("../../../fixtures/cases/e-drive.toml");
    let head = drive.split("[surface]").next().unwrap();
    for (pattern, expected) in [
        ("pinion_*.csv", &files[..2]),
        ("*a*b", &["xaab"]),
        ("t?.txt", &["t1.txt"]),
        ("*", &files),
    ] {
        let text = format!(
            "{head}[surface]\ncutoff = \"0.025 mm\"\npinion = {{ traces = \"{pattern}\" }}\n\
             wheel = {{ file = \"wheel_1.csv\" }}\n"
        );
        let source = Source::new("case.toml", &text).unwrap();
        let case = load_holding(source, folder.path(), &held, &[], &|_| {}).unwrap();
        let traces = case.all_traces();
        let (_, of_pinion) = traces.split_last().unwrap();
        let named: Vec<_> = of_pinion
            .iter()
            .map(|trace| trace.file.as_deref().unwrap())
            .collect();
        assert_eq!(named, expected, "{pattern}");
    }
}

#[test]
fn above_64_pairs_as_many_teeth_as_make_64_are_paired() {
    for (named, paired) in [
        ([8, 8], [8, 8]),
        ([64, 1], [64, 1]),
        ([5, 13], [5, 12]),
        ([65, 1], [64, 1]),
        ([32, 32], [8, 8]),
        ([9, 100], [8, 8]),
        ([20, 4], [16, 4]),
    ] {
        let [pinion, wheel] = named.map(|teeth: u32| {
            let files: Vec<String> = (0..teeth).map(|k| format!("\"{k}\"")).collect();
            format!("traces = [{}]", files.join(", "))
        });
        assert_eq!(short(&pinion, &wheel).surfaces.teeth(), Some(paired));
    }
}

#[test]
fn above_64_pairs_the_first_eight_teeth_are_taken_and_it_is_said() {
    let nine = (0..9)
        .map(|k| format!("\"{k}\""))
        .collect::<Vec<_>>()
        .join(", ");
    let many = case(&format!("traces = [{nine}]"), &format!("traces = [{nine}]"));
    assert_eq!(many.surfaces.teeth(), Some([8, 8]));
    let said = many
        .warnings
        .iter()
        .find(|warning| warning.code == "W427")
        .unwrap();
    assert!(
        said.text
            .contains("make 81 pairs: the first 8 of the pinion and the first 8 of the wheel"),
        "{said}"
    );
}
