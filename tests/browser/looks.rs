//! Every page as its users see it: in light and dark, wide and narrow, with any fonts.

use std::sync::OnceLock;

use serde_json::{Value, json};

use crate::chromium::{self, Fonts, Look, Opened};
use crate::pages::{self, Page};

/// The page is whole: nothing in the console, nothing fetched, no label cut, no number undefined, every line in its
/// colour, and every chart draws, zooms and slides.
pub fn assert_sound(opened: &Opened) {
    let (name, found) = (&opened.name, &opened.found);
    assert_eq!(opened.console, [""; 0], "{name}");
    for (what, none) in [
        ("faults", "an error"),
        ("resources", "the page fetches nothing"),
        ("labels", "no label is covered or cut"),
        ("undefined", "numbers only"),
        ("beyond", "nothing reaches out of the page"),
    ] {
        assert_eq!(found[what], json!([]), "{name}: {none}");
    }
    assert_eq!(found["colours"]["wrong"], json!([]), "{name}");
    for figure in found["sizes"].as_array().unwrap() {
        assert!(
            figure["size"].as_f64().unwrap() > 5.0,
            "{name}: {figure} has drawn"
        );
        assert!(
            figure["width"].as_f64().unwrap() > 200.0,
            "{name}: {figure} has room"
        );
    }
    for slider in found["sliders"].as_array().unwrap() {
        assert_eq!(slider["different"], slider["positions"], "{name}: {slider}");
        let is_whole =
            (&slider["broken"], &slider["restored"]) == (&Value::Bool(false), &Value::Bool(true));
        assert!(is_whole, "{name}: {slider}");
        assert!(
            slider["width"].as_f64().unwrap() > 150.0,
            "{name}: {slider}"
        );
    }
    for gears in found["gears"].as_array().unwrap() {
        for what in ["turns", "followed", "still"] {
            assert_eq!(gears[what], true, "{name}: {what} of {gears}");
        }
        assert_eq!(gears["moved"], gears["charts"], "{name}: {gears}");
        assert!(gears["width"].as_f64().unwrap() > 150.0, "{name}: {gears}");
    }
    for file in found["saved"].as_array().unwrap() {
        for what in ["whole", "styled", "titled"] {
            assert_eq!(file[what], true, "{name}: {what} of {file}");
        }
    }
    let printed = &found["printed"];
    assert_eq!(
        printed["onPaper"], 0,
        "{name}: folded parts are open on paper"
    );
    assert_eq!(printed["before"], printed["after"], "{name}");
    for chart in found["zoom"].as_array().unwrap() {
        for what in ["readOff", "dragged", "restored", "keyed", "whole"] {
            assert_eq!(chart[what], true, "{name}: {what} of {chart}");
        }
    }
}

/// Widths of the windows.
const WIDTHS: [u32; 2] = [1400, 400];

fn opened(browser: &str, look: &Look) -> Vec<Opened> {
    let texts: Vec<(&str, &str)> = (pages::all().iter())
        .map(|page| (page.name.as_str(), page.text.as_str()))
        .collect();
    chromium::open(browser, &texts, look)
}

/// Every page in light colours with the fonts installed, wide and narrow, opened once for all tests.
pub fn first_look(browser: &str) -> &'static [[Opened; 2]] {
    static SEEN: OnceLock<Vec<[Opened; 2]>> = OnceLock::new();
    SEEN.get_or_init(|| {
        let mut seen = opened(browser, &Look::at(&WIDTHS)).into_iter();
        std::iter::from_fn(|| Some([seen.next()?, seen.next()?])).collect()
    })
}

#[test]
fn every_page_is_whole_in_light_and_dark_wide_and_narrow_with_any_fonts() {
    let Some(browser) = chromium::find() else {
        return;
    };
    for (number, fonts) in Fonts::choices().into_iter().enumerate() {
        let look = Look {
            widths: WIDTHS.to_vec(),
            is_dark: number % 2 == 1,
            fonts,
            // Other fonts move the texts only, and other colours no curve.
            colours: number < 2,
            drives: number < 1,
        };
        let other;
        let seen: Vec<&Opened> = if number == 0 {
            first_look(browser).iter().flatten().collect()
        } else {
            other = opened(browser, &look);
            other.iter().collect()
        };
        assert_eq!(seen.len(), 2 * pages::all().len());
        for opened in &seen {
            assert_sound(opened);
            assert_eq!(opened.found["dark"], look.is_dark, "{}", opened.name);
        }
        let counts = seen
            .iter()
            .map(|opened| opened.found["colours"]["count"].as_u64().unwrap());
        assert_eq!(
            counts.sum::<u64>() > 400,
            look.colours,
            "lines were looked at"
        );
    }
}

/// A picture that is not high enough lacks the colours of the curves below it.
fn assert_rendered(browser: &str, page: &Page, height: u32, is_dark: bool) {
    /// Least share of the places on a curve at which its colour is seen, or at which any of the curves of its chart is,
    /// where others lie on it.
    const SEEN: f64 = 0.15;
    const COVERED: f64 = 0.8;
    let look = Look {
        is_dark,
        ..Look::at(&[])
    };
    let picture = chromium::render(browser, &page.text, [1400, height], &look);
    let curves = picture.found["pixels"].as_array().unwrap();
    assert!(!curves.is_empty(), "{}", page.name);
    let number = |value: &Value| value.as_f64().unwrap();
    let colour = |curve: &Value| [0, 1, 2].map(|k| number(&curve["colour"][k]));
    let share = |curve: &Value, due: &[[f64; 3]]| {
        let places = curve["places"].as_array().unwrap();
        let seen = places.iter().filter(|place| {
            let place = [number(&place[0]), number(&place[1])];
            due.iter().any(|colour| picture.shows(place, *colour))
        });
        seen.count() as f64 / places.len() as f64
    };
    for curve in curves {
        let same = curves
            .iter()
            .filter(|other| other["chart"] == curve["chart"]);
        let all: Vec<[f64; 3]> = same.map(colour).collect();
        let (own, any) = (share(curve, &[colour(curve)]), share(curve, &all));
        assert!(
            own > SEEN || all.len() > 1 && any > COVERED,
            "{}, dark {is_dark}: {} of {} is seen at {own:.2} of its places, any curve at {any:.2}",
            page.name,
            curve["curve"],
            curve["chart"]
        );
    }
}

#[test]
fn curves_are_rendered_in_their_colours_in_light_and_dark() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let rendered = [
        ("report, helical", 9000, true),
        ("report, helical", 9000, false),
        ("found/calibration.html", 7000, true),
        ("driven/cycle.html", 3200, false),
        ("figures", 5400, false),
    ];
    for (name, height, is_dark) in rendered {
        let page = pages::all().iter().find(|page| page.name == name);
        assert_rendered(browser, page.unwrap(), height, is_dark);
    }
}

#[test]
fn a_fault_of_a_page_would_be_noticed() {
    let Some(browser) = chromium::find() else {
        return;
    };
    let report = pages::all()
        .iter()
        .find(|page| page.name == "report, paper")
        .unwrap();
    let broken = |from: &str, to: &str| {
        let text = report.text.replacen(from, to, 1);
        assert_ne!(text, report.text, "{from}");
        text
    };
    let faults = [
        broken("\"series\":[{", "\"series\":[null,{"),
        // A style of one kind of chart that reaches into another.
        broken(".contour-chart .dots{", "svg.chart .dots{"),
        broken(
            ".tick{fill:var(--soft);font-size:11px",
            ".tick{fill:var(--soft);font-size:40px",
        ),
        broken(" d=\"M", " d=\"MNaN 1M"),
    ];
    let texts: Vec<(&str, &str)> = faults
        .iter()
        .map(|text| ("broken", text.as_str()))
        .collect();
    for (number, opened) in chromium::open(browser, &texts, &Look::at(&[1000]))
        .iter()
        .enumerate()
    {
        let is_noticed = std::panic::catch_unwind(|| assert_sound(opened)).is_err();
        assert!(is_noticed, "fault {number}");
    }
}
