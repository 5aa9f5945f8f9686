//! Summary of a study of ridges for the terminal.

use asperity::result::loss_band::rounded;
use asperity::result::ridges::{Kinks, OctaveRow, Ridges};
use asperity_report::html::ridges::table;
use asperity_report::ridges::{NOTE, notes, saving, watts};
use asperity_report::{columns, wrapped};
use asperity_storage::one_line;

/// Summary of the study for the terminal.
pub(super) fn summary(study: &Ridges) -> String {
    let mut text = format!("{}\n{}\n", one_line(&study.title), headline(study));
    text.push_str(&format!("{}\n", saving(study)));
    text.push_str(&table(&study.rows).text(""));
    text.push_str("\nd(loss)/d ln(height) by wavelength\n");
    let octaves = columns! { octave in &study.octaves;
        text wavelengths "wavelengths" "µm" = wavelengths(octave);
        number pinion_w "pinion" "W" = watts(octave.pinion_w);
        number wheel_w "wheel" "W" = watts(octave.wheel_w);
    };
    text.push_str(&octaves.text(""));
    text.push_str(&format!("{}\n", wrapped(NOTE, "")));
    let kinks = kinks(&study.kinks).into_iter();
    for note in notes(study).into_iter().chain(kinks) {
        text.push_str(&format!("{}\n", wrapped(&note, "")));
    }
    text
}

/// The line about kinks of the loss; `None` if the windows were not counted.
fn kinks(kinks: &Kinks) -> Option<String> {
    let Kinks {
        windows,
        apart,
        first_touch,
        rows,
        limited_slopes,
        floors,
    } = kinks;
    (*windows > 0).then(|| {
        format!(
            "Kinks: of {windows} windows {apart} apart, {first_touch} next to first touch, {rows} next to a row of the contact \
            table, {limited_slopes} with a limited slope of the gap, {floors} at a floor (next to: 1 nm of mean gap)."
        )
    })
}

pub(super) fn headline(study: &Ridges) -> String {
    let loss = rounded(study.loss_w, 0.01 * study.loss_w);
    let steep = watts(study.by_log_height_w);
    format!("loss {loss} W at the medians of all constants; d(loss)/d ln(height) {steep} W")
}

pub(super) fn wavelengths(octave: &OctaveRow) -> String {
    match octave.to_um {
        Some(to) => format!("{}..{}", short(octave.from_um), short(to)),
        None => format!("above {}", short(octave.from_um)),
    }
}

fn short(um: f64) -> String {
    format!("{um:.1}").trim_end_matches(".0").to_owned()
}
