//! Pairs of traces as one instrument writes them: the spacings differ in their last digits.

use asperity::case::{LoadedCase, from_text};
use asperity::flanks::Texture;
use asperity_core::Profile;
use asperity_core::profile::common_spacing;
use asperity_core::quantity::Length;
use proptest::prelude::*;
use proptest::test_runner::Config;

/// A trace as it is written: its first position and its positions' decimals in um.
#[derive(Debug, Clone)]
struct Written {
    spacing_um: f64,
    start_um: f64,
    points: usize,
    decimals: usize,
    seed: u32,
    /// Distance of the points from an even grid, in spacings.
    jitter: f64,
}

impl Written {
    fn text(&self) -> String {
        let height = |i: usize| {
            let x = self.spacing_um * i as f64;
            let wave = |length: f64, size: f64| {
                let phase = f64::from(self.seed) * length;
                size * (std::f64::consts::TAU * x / length + phase).sin()
            };
            wave(11.0, 0.05) + wave(31.0, 0.15) + wave(83.0, 0.2)
        };
        let row = |i: usize| {
            let x = self.start_um + self.spacing_um * (i as f64 + self.jitter * (i as f64).sin());
            format!("{x:.*},{:.6}\n", self.decimals, height(i))
        };
        let rows: String = (0..self.points).map(row).collect();
        format!("x_um,z_um\n{rows}")
    }
}

/// The pair at one position, with a load share that follows from the roughness of the windows.
fn loaded(pinion: &str, wheel: &str, uneven: bool) -> Result<LoadedCase, asperity::Error> {
    let uneven = if uneven {
        ", uneven = \"resample\""
    } else {
        ""
    };
    let text = format!(
        "gears = {{ teeth = [23, 68], module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\" }}\n\
         operation = {{ torque = \"145 N m\", speed = \"3000 1/min\", bulk_temperature = \"90 °C\" }}\n\
         lubricant = {{ oil = \"m100\" }}\n\
         model = {{ positions = 2, offsets = 2, load_share = \"lambda-star\" }}\n\
         [surface]\ncutoff = \"0.25 mm\"\n\
         pinion = {{ file = \"pinion\"{uneven} }}\nwheel = {{ file = \"wheel\"{uneven} }}\n"
    );
    from_text("case.toml", &text, &|name| {
        let trace = if name == "pinion" { pinion } else { wheel };
        Ok(trace.as_bytes().to_vec())
    })
}

fn spacings(loaded: &LoadedCase) -> [Length; 2] {
    loaded
        .surfaces
        .textures()
        .each_ref()
        .map(|texture| match texture {
            Texture::Trace(profile) => Profile::spacing(profile),
            _ => panic!("a trace was given"),
        })
}

/// Relative differences of spacings from rounding up to a tenth of a per cent.
fn difference() -> impl Strategy<Value = f64> {
    let size = (-12.0..-3.0f64).prop_map(|power| 10f64.powf(power));
    (prop_oneof![Just(0.0), size], any::<bool>())
        .prop_map(|(size, up)| if up { size } else { -size })
}

prop_compose! {
    fn written(spacing_um: f64)(
        start_um in prop_oneof![Just(0.0), -50.0..20_000.0f64],
        points in 900..2500usize,
        decimals in 3..13usize,
        seed in 1..1000u32,
        jitter in prop_oneof![Just(0.0), 0.0..0.1f64],
    ) -> Written {
        Written { spacing_um, start_um, points, decimals, seed, jitter }
    }
}

prop_compose! {
    fn pair()(spacing_um in 0.2..0.6f64, difference in difference())(
        pinion in written(spacing_um),
        wheel in written(spacing_um * (1.0 + difference)),
    ) -> [Written; 2] {
        [pinion, wheel]
    }
}

proptest! {
    #![proptest_config(Config::with_cases(48))]

    #[test]
    fn traces_of_one_instrument_run_in_every_pairing(pair in pair(), uneven: bool) {
        let [pinion, wheel] = &pair.map(|written| written.text());
        for [first, second] in [[pinion, wheel], [wheel, pinion], [pinion, pinion]] {
            let loaded = loaded(first, second, uneven);
            let Ok(loaded) = loaded else {
                // Too short for its filter, which has nothing to do with the other trace.
                prop_assert_eq!(loaded.unwrap_err().code(), "E120");
                continue;
            };
            let read = loaded.flanks.each_ref().map(|flank| {
                flank.preparation.as_ref().map(|record| record.spacing).unwrap()
            });
            let [a, b] = spacings(&loaded);
            prop_assert_eq!(a, b);
            // The usual spacing of instruments at most, or that of traces that are all coarser.
            let finest = read[0].si().min(read[1].si());
            prop_assert!((finest..finest.max(0.500_01e-6)).contains(&a.si()) || a.si() == finest, "{a}");
            let is_coarser = |own: Length| own > a && common_spacing(own, a).is_none();
            let is_resampled = loaded.warnings.iter().any(|warning| warning.code == "W119");
            prop_assert_eq!(is_resampled, read.into_iter().any(is_coarser));
            let checked = asperity::Run::new(&loaded).check().map_err(|error| error.to_string());
            let run = asperity_tests::losses(&loaded).map_err(|error| error.to_string());
            if let Err(error) = &run {
                prop_assert!(error.contains("that the windows of the contact need"), "{error}");
            }
            prop_assert_eq!(checked.err(), run.err());
        }
    }
}

#[test]
fn several_traces_of_one_instrument_keep_their_points() {
    let written = |k: u32| Written {
        spacing_um: 0.5 * (1.0 + 4e-6 * f64::from(k)),
        start_um: 8672.2 + 3.1 * f64::from(k),
        points: 3000 + 7 * k as usize,
        decimals: 6,
        seed: 1 + k,
        jitter: 0.0,
    };
    let text = "gears = { teeth = [23, 68], module = \"1.8 mm\", helix = \"23.4 deg\", face_width = \"32 mm\" }\n\
         operation = { torque = \"145 N m\", speed = \"3000 1/min\", bulk_temperature = \"90 °C\" }\n\
         lubricant = { oil = \"m100\" }\n\
         model = { positions = 2, offsets = 2, load_share = \"lambda-star\" }\n\
         [surface]\ncutoff = \"0.25 mm\"\npinion = { traces = [\"0\", \"1\"] }\nwheel = { traces = [\"2\"] }\n";
    let loaded = from_text("case.toml", text, &|name| {
        Ok(written(name.parse().unwrap()).text().into_bytes())
    })
    .unwrap();
    assert!(loaded.warnings.iter().all(|warning| warning.code != "W119"));
    let [a, b] = spacings(&loaded);
    assert_eq!((a, b), (Length::from_si(0.5e-6), Length::from_si(0.5e-6)));
    asperity::Run::new(&loaded).check().unwrap();
    asperity_tests::losses(&loaded).unwrap();
}
