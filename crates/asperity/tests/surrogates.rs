//! Flanks known by roughness values: surrogates with these values, and what their contact loses.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests may panic")]

use std::path::PathBuf;

use crate::runs::contacts;
use crate::runs::losses;
use asperity::Error;
use asperity::case::{LoadedCase, load_set, open_source};
use asperity::contacts::dry_contact;
use asperity::core::Profile;
use asperity::flanks::Texture;
use asperity_roughness::Parameters;
use asperity_roughness::height_parameters::Mode;

/// A shipped case with keys of its own.
fn try_case(name: &str, keys: &[(&str, &str)]) -> Result<LoadedCase, Error> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/cases");
    let quick = [("model.positions", "4"), ("model.offsets", "4")];
    let keys = quick.iter().chain(keys);
    let keys: Vec<_> = keys
        .map(|(k, v)| ((*k).to_owned(), (*v).to_owned()))
        .collect();
    let source = open_source(&folder.join(format!("{name}.toml")))?;
    load_set(source, &folder, &keys, &|_| {})
}

fn case(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    try_case(name, keys).unwrap()
}

/// The e-drive with these values of both flanks.
fn by_values(values: &str, keys: &[(&str, &str)]) -> LoadedCase {
    let flank = format!("{{ {values} }}");
    let mut all = vec![("surface.pinion", &*flank), ("surface.wheel", &*flank)];
    all.extend(keys);
    case("e-drive", &all)
}

/// Parameters of both flanks of every pair.
fn parameters(case: &LoadedCase) -> Vec<[Parameters; 2]> {
    let cutoff = case.case.preparation.lambda_c.unwrap();
    let of = |texture: &Texture| match texture {
        Texture::Trace(trace) => Parameters::from_profile(trace, Mode::Iso4287, cutoff).unwrap(),
        _ => panic!("no trace"),
    };
    let pairs = case.surfaces.each();
    pairs
        .map(|pair| pair.textures().each_ref().map(of))
        .collect()
}

fn traces(case: &LoadedCase) -> Vec<Profile> {
    let textures = case.surfaces.each().flat_map(|pair| pair.textures());
    let traces = textures.map(|texture| match texture {
        Texture::Trace(trace) => trace.clone(),
        _ => panic!("no trace"),
    });
    traces.collect()
}

fn warning(case: &LoadedCase, code: &str) -> Option<String> {
    let found = case.warnings.iter().find(|warning| warning.code == code);
    found.map(|warning| warning.text.clone())
}

/// Mean of the logarithm over the pairs, and their standard deviation.
fn logarithm(case: &LoadedCase) -> [f64; 2] {
    let found = losses(case).unwrap();
    let each = found.offsets.len() / case.surfaces.pairs();
    let of_pair = |offsets: &[asperity::result::OffsetRow]| {
        (offsets.iter().map(|row| row.loss_w).sum::<f64>() / offsets.len() as f64).ln()
    };
    let pairs: Vec<f64> = found.offsets.chunks(each).map(of_pair).collect();
    let mean = pairs.iter().sum::<f64>() / pairs.len() as f64;
    let squares = pairs.iter().map(|pair| (pair - mean).powi(2)).sum::<f64>();
    [mean, (squares / (pairs.len() as f64 - 1.0).max(1.0)).sqrt()]
}

#[test]
fn surrogates_have_the_stated_ra_and_differ() {
    let case = by_values("ra = \"0.3 um\"", &[]);
    assert!(case.surfaces.is_surrogate() && case.surfaces.teeth().is_none());
    assert_eq!((case.surfaces.pairs(), case.surfaces.offsets(4)), (12, 48));
    let found = parameters(&case);
    for flank in found.iter().flatten() {
        assert!((flank.heights.ra.si() / 0.3e-6 - 1.0).abs() < 1e-9);
    }
    let rz = |pair: &[Parameters; 2]| 1e6 * pair[0].heights.rz.si();
    let mut all: Vec<f64> = found.iter().map(rz).collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    assert_eq!(all.len(), 12);
    let [pinion, wheel] = &*case.flanks;
    let record = pinion.surrogates.as_ref().unwrap();
    assert_eq!(
        (record.count, &*record.finishes),
        (12, &["ground".to_owned()][..])
    );
    assert!((record.rz_um - all.iter().sum::<f64>() / 12.0).abs() < 1e-9);
    assert!(pinion.file.is_none() && pinion.trace.is_none() && wheel.surrogates.is_some());
}

#[test]
fn surrogates_are_the_same_in_every_run() {
    let case = || by_values("ra = \"0.3 um\"", &[]);
    assert_eq!(traces(&case()), traces(&case()));
    // Another speed has the same contacts.
    let faster = case().with_key("operation.speed", "4000 1/min").unwrap();
    assert!(contacts(&case()).unwrap().len() == 4 * 48);
    assert_eq!(traces(&case()), traces(&faster));
}

#[test]
fn a_second_value_selects_the_surrogates_that_have_it() {
    let mean = |keys: &str, ratio: fn(&Parameters) -> f64| {
        let found = parameters(&by_values(keys, &[("surface.noise_cutoff", "2.5 um")]));
        found.iter().flatten().map(ratio).sum::<f64>() / 24.0
    };
    let rz = |found: &Parameters| found.heights.rz / found.heights.ra;
    let rpk = |found: &Parameters| found.material.rpk / found.heights.ra;
    let [flat, high] =
        ["1.8", "2.4"].map(|rz_um| mean(&format!("ra = \"0.3 um\", rz = \"{rz_um} um\""), rz));
    assert!(flat < 6.5 && high > 7.0, "{flat} {high}");
    let [low, peaked] =
        ["0.4", "0.9"].map(|rpk_um| mean(&format!("ra = \"0.3 um\", rpk = \"{rpk_um} um\""), rpk));
    assert!(low < 1.8 && peaked > 2.4, "{low} {peaked}");
    let far = by_values("ra = \"0.3 um\", rz = \"6 um\"", &[]);
    let text = warning(&far, "W438").unwrap();
    assert!(text.contains("where 6.000 um is stated"), "{text}");
}

#[test]
fn the_finish_is_stated_or_follows_from_ra() {
    let finishes = |case: &LoadedCase| case.flanks[0].surrogates.clone().unwrap().finishes;
    let fine = by_values("ra = \"0.05 um\"", &[]);
    assert_eq!(finishes(&fine), ["superfinished"]);
    assert!(warning(&fine, "W437").is_none());
    let key = |default: &&asperity::case::DefaultUsed| default.key == "surface.pinion.finish";
    let assumed = fine.case.defaults.iter().find(key).unwrap();
    assert_eq!(assumed.value, "\"superfinished\"");
    let open = by_values("ra = \"0.1 um\"", &[]);
    assert_eq!(finishes(&open), ["ground", "superfinished"]);
    assert!(
        warning(&open, "W437")
            .unwrap()
            .contains("State surface.finish")
    );
    let stated = by_values("ra = \"0.1 um\"", &[("surface.finish", "ground")]);
    assert_eq!(finishes(&stated), ["ground"]);
    assert!(warning(&stated, "W437").is_none());
    let one = by_values(
        "ra = \"0.1 um\", finish = \"superfinished\"",
        &[("surface.finish", "ground")],
    );
    assert_eq!(finishes(&one), ["superfinished"]);
    let honed = [
        ("surface.pinion", "{ ra = \"0.3 um\" }"),
        ("surface.wheel", "{ ra = \"0.3 um\", finish = \"honed\" }"),
    ];
    let error = try_case("e-drive", &honed).unwrap_err();
    assert_eq!(error.code(), "E223");
    assert!(
        error
            .to_string()
            .contains("surface.wheel.finish = \"honed\""),
        "{error}"
    );
    // A flank with a trace may have any finish.
    assert!(try_case("e-drive", &[("surface.finish", "honed")]).is_ok());
}

#[test]
fn an_unknown_cut_off_is_drawn_and_a_stated_one_is_kept() {
    let lambda_s = |keys: &[(&str, &str)]| {
        let case = by_values("ra = \"0.3 um\"", keys);
        let text = warning(&case, "W438").unwrap();
        let asks = text.contains("state surface.noise_cutoff");
        (case.flanks[1].surrogates.clone().unwrap().lambda_s_um, asks)
    };
    let ([low, high], asks) = lambda_s(&[]);
    assert!(low > 2.5 && low < 3.0 && high > 20.0 && high < 25.0 && asks);
    let ([low, high], asks) = lambda_s(&[("surface.noise_cutoff", "8 um")]);
    assert!((low - 8.0).abs() < 1e-9 && (high - 8.0).abs() < 1e-9 && !asks);
}

#[test]
fn a_trace_is_in_contact_with_every_surrogate_of_the_other_flank() {
    let measured = case("e-drive", &[]);
    let mixed = case("e-drive", &[("surface.wheel", "{ ra = \"0.24 um\" }")]);
    let (own, all) = (traces(&measured), traces(&mixed));
    assert_eq!(all.len(), 24);
    assert!(all.iter().step_by(2).all(|trace| *trace == own[0]));
    let [pinion, wheel] = &*mixed.flanks;
    assert!(pinion.surrogates.is_none() && pinion.file.is_some());
    assert_eq!(wheel.surrogates.as_ref().unwrap().count, 12);
    let [a, b] = [logarithm(&measured)[0], logarithm(&mixed)[0]];
    assert!((a - b).abs() < 0.1, "{a} {b}");
}

#[test]
fn only_a_law_that_takes_values_does_without_the_contact() {
    let formula = by_values("ra = \"0.3 um\"", &[("model.load_share", "lambda-star")]);
    assert!(!formula.surfaces.are_measured());
    // Back to the contact.
    let solved = formula.with_key("model.load_share", "solved").unwrap();
    assert!(solved.surfaces.is_surrogate());
    let [of_formula, of_contact] = [&formula, &solved].map(|case| logarithm(case)[0]);
    assert!(of_formula > of_contact + 0.2, "{of_formula} {of_contact}");
    let lists = |case: &LoadedCase| {
        case.case
            .defaults
            .iter()
            .any(|default| default.key == "surface.pinion.rq")
    };
    assert!(lists(&formula) && !lists(&solved));
    for (key, value) in [
        ("operation.running_in", "true"),
        ("model.load_share", "ehl"),
    ] {
        let error = solved.with_key(key, value).unwrap_err();
        assert_eq!(error.code(), "E205", "{error}");
    }
}

#[test]
fn a_single_contact_is_the_contact_of_the_first_pair() {
    let case = by_values("ra = \"0.3 um\"", &[]);
    asperity::Run::new(&case).check().unwrap();
    let first = case.first_pair();
    assert_eq!(
        (first.surfaces.pairs(), first.surfaces.is_surrogate()),
        (1, false)
    );
    assert_eq!(traces(&first), traces(&case)[..2]);
    let [all, one] = [&case, &first].map(|case| dry_contact(case, 0.5).unwrap());
    assert_eq!(all.solution.pressure, one.solution.pressure);
}

#[test]
fn surrogates_lose_what_the_traces_of_their_ra_lose() {
    for name in ["e-drive", "e-drive-superfinished"] {
        let measured = case(name, &[("model.offsets", "32")]);
        let [pinion, wheel] = [0, 1].map(|body: usize| {
            let found = measured.flanks[body].parameters.as_ref().unwrap();
            format!("{{ ra = \"{} um\" }}", 1e6 * found.heights.ra.si())
        });
        let keys = [
            ("surface.pinion", &*pinion),
            ("surface.wheel", &*wheel),
            ("surface.noise_cutoff", "2.5 um"),
        ];
        let surrogates = case(name, &keys);
        let [expected, _] = logarithm(&measured);
        let [mean, deviation] = logarithm(&surrogates);
        assert!((mean - expected).abs() < 0.1, "{name}: {mean} {expected}");
        // 0.116 of ground flanks, of whose sliding loss the asperities have 73 %.
        assert!(deviation < 0.125, "{name}: {deviation}");
    }
}

/// Flanks like measured ones are named as generated, with the sums of the traces; pinion and wheel differ, and so do seeds.
#[test]
fn generated_flanks_are_teeth_of_their_own_and_never_called_measured() {
    let like = |seed: &str| {
        let flank = format!(
            "{{ like = [\"../profiles/ground_pinion.csv\", \"../profiles/ground_wheel.csv\"], seed = {seed} }}"
        );
        case(
            "e-drive",
            &[("surface.pinion", &flank), ("surface.wheel", &flank)],
        )
    };
    let first = like("1");
    assert_eq!(first.surfaces.each().count(), 4);
    let made = traces(&first);
    assert_eq!(made, traces(&like("1")));
    let again = traces(&like("2"));
    assert!(made.iter().all(|trace| !again.contains(trace)));
    assert_ne!(made[0], made[1]);
    for flank in first.all_traces() {
        let record = flank.generated.as_ref().unwrap();
        assert_eq!(record.like.len(), 2);
        assert!(record.like.iter().all(|trace| trace.sha256.len() == 64));
        let file = flank.file.as_deref().unwrap();
        assert!(file.starts_with("generated from 2 traces"), "{file}");
        assert!(flank.reading.is_none() && flank.sha256.is_none());
    }
    let codes = first
        .warnings
        .iter()
        .map(|warning| warning.code.to_string());
    assert_eq!(codes.filter(|code| code == "W463").count(), 2);
    for (keys, rule) in [
        (
            "like = [\"../profiles/ground_pinion.csv\"], rq = \"0.3 um\"",
            "instead of",
        ),
        ("rq = \"0.3 um\", seed = 2", "needs like"),
        (
            "like = [\"../profiles/ground_pinion.csv\"], state = 0.5",
            "needs after",
        ),
        (
            "like = [{ file = \"../profiles/ground_pinion.csv\", tooth = 1 }]",
            "without a tooth",
        ),
        (
            "like = [\"../profiles/ground_pinion.csv\"], engagements = 1e4",
            "needs after",
        ),
        (
            "traces = [{ file = \"../profiles/ground_pinion.csv\", engagements = 1e4 }]",
            "belong to after",
        ),
        (
            "like = [\"../profiles/ground_pinion.csv\"], after = [\"../profiles/ground_pinion.csv\"], engagements = 1e4",
            "states no engagements",
        ),
        (
            "like = [\"../profiles/ground_pinion.csv\"], after = [\"../profiles/ground_pinion.csv\", \"../profiles/ground_wheel.csv\"]",
            "a trace for each of like",
        ),
        (
            "like = [\"../profiles/ground_pinion.csv\"], after = [{ file = \"../profiles/ground_pinion.csv\", engagements = 1e4 }], engagements = 2e4",
            "last stage",
        ),
        (
            "like = [\"../profiles/ground_pinion.csv\"], after = [{ file = \"../profiles/ground_pinion.csv\", engagements = 1e4 }], engagements = 5e3, state = 0.5",
            "engagements instead",
        ),
    ] {
        let refused = try_case("e-drive", &[("surface.pinion", &format!("{{ {keys} }}"))]);
        let error = refused.unwrap_err().to_string();
        assert!(error.contains(rule), "{error}");
    }
}

/// The record of flanks between the stages of a test has the engagements of flank and traces.
#[test]
fn flanks_between_stages_have_their_engagements() {
    let keys = "like = [\"../profiles/ground_pinion.csv\"], after = [{ file = \"../profiles/ground_?inion.csv\", engagements = 1e4 }]";
    let of = |stated: &str| {
        let flank = format!("{{ {keys}{stated} }}");
        let case = case(
            "e-drive",
            &[("surface.pinion", &flank), ("surface.wheel", &flank)],
        );
        case.all_traces()[0].clone()
    };
    for (stated, words) in [
        (", engagements = 5e3", "after 5000 engagements"),
        (", state = 0.5", "in state 0.5 from before"),
        ("", "in state 1 from before"),
    ] {
        let flank = of(stated);
        assert!(
            flank.file.as_deref().unwrap().contains(words),
            "{:?}",
            flank.file
        );
        let record = flank.generated.unwrap();
        assert_eq!(record.after.len(), 1);
        assert_eq!(record.after[0].engagements, Some(1e4));
        assert_eq!(record.engagements.is_some(), stated.contains("engagements"));
    }
}
