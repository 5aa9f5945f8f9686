//! Summary of a study of ridges for the terminal.

use asperity::result::loss_band::rounded;
use asperity_report::wrapped;
use asperity_storage::one_line;

use super::study::{OctaveRow, RidgeRow, Ridges};

/// Explanation of the numbers.
pub(super) const NOTE: &str = "A ridge is a part of a prepared trace above its mean line. \"first\" is what pressing it to the mean \
    line saves by the gradient of the loss; \"mean\" uses the mean of the gradients before and after all listed ridges are \
    pressed, in brackets its 5 and 95 % quantiles by the sampling of the flanks, with the constants at their medians. The saving of all of them together is a run of the model. Sets of the contacts, windows and relief are held in \
    the gradient. Running-in, which presses ridges too, is not in it. These are answers of the model, not measurements.";

/// Least uncertainty of printed watts.
const LEAST_W: f64 = 0.5;

/// Summary of the study for the terminal.
pub(super) fn summary(study: &Ridges) -> String {
    let mut text = format!("{}\n{}\n", one_line(&study.title), headline(study));
    text.push_str(&format!("{}\n", saving(study)));
    text.push_str(&format!(
        "{:6} {:>9} {:>9} {:>10} {:>8} {:>15}\n",
        "flank", "place mm", "width um", "height um", "first W", "mean W"
    ));
    for row in &study.rows {
        text.push_str(&format!(
            "{:6} {:>9.4} {:>9.1} {:>10.3} {:>8} {:>15}\n",
            row.flank,
            row.place_mm,
            row.width_um,
            row.height_um,
            watts(row.first_order_w),
            mean_saving(row),
        ));
    }
    text.push_str("\nd(loss)/d ln(height) by wavelength, W\n");
    text.push_str(&format!("{:>18} {:>8} {:>8}\n", "um", "pinion", "wheel"));
    for octave in &study.octaves {
        text.push_str(&format!(
            "{:>18} {:>8} {:>8}\n",
            wavelengths(octave),
            watts(octave.pinion_w),
            watts(octave.wheel_w)
        ));
    }
    text.push_str(&format!("{}\n", wrapped(NOTE, "")));
    for note in notes(study) {
        text.push_str(&format!("{}\n", wrapped(&note, "")));
    }
    text
}

pub(super) fn headline(study: &Ridges) -> String {
    let loss = rounded(study.loss_w, 0.01 * study.loss_w);
    let steep = watts(study.by_log_height_w);
    format!("loss {loss} W at the medians of all constants; d(loss)/d ln(height) {steep} W")
}

/// The saving of all listed ridges together, by a run.
pub(super) fn saving(study: &Ridges) -> String {
    let saved = study.loss_w - study.pressed_loss_w;
    let quantiles = study.sampling_quantiles_w.map(|[low, high]| [-high, -low]);
    let interval = interval(quantiles);
    format!(
        "pressing these {} ridges to the mean line saves {} W{interval}, by a run",
        study.rows.len(),
        watts(saved)
    )
}

/// Saving by a ridge with its interval, according to the mean of the gradients.
pub(super) fn mean_saving(row: &RidgeRow) -> String {
    let quantiles = row.low_w.zip(row.high_w).map(|(low, high)| [low, high]);
    format!("{}{}", watts(row.mean_gradient_w), interval(quantiles))
}

fn interval(quantiles: Option<[f64; 2]>) -> String {
    match quantiles {
        Some([low, high]) if low < high => format!(" ({}..{})", watts(low), watts(high)),
        _ => String::new(),
    }
}

pub(super) fn notes(study: &Ridges) -> Vec<String> {
    let mut notes = Vec::new();
    if study.unresolved_w > 0.0 {
        notes.push(format!(
            "{} W of sliding loss are where the traces do not resolve the contact; the gradient leaves them out.",
            watts(study.unresolved_w)
        ));
    }
    if study.heat_balance != 1.0 {
        notes.push(format!(
            "The bulk temperature follows from the loss: it multiplies every change by {:.2}.",
            study.heat_balance
        ));
    }
    notes
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

/// Watts with the digits that a scatter of a tenth over the windows leaves, and at most one decimal.
pub(super) fn watts(value: f64) -> String {
    rounded(value, (0.1 * value.abs()).max(LEAST_W))
}
