//! The place of the second trace among those at which the valleys match.

use asperity_core::cancel::checkpoint;
use asperity_core::quantity::Length;
use asperity_core::remedy::{Remedy, Setting, Value};
use asperity_core::{Code, Fault, decimals};

use super::fit::RelocationFit;
use super::search::{Match, Matches};
use super::traces::Trace;
use crate::error::RoughnessError;
use crate::form::Form;

/// Least correlation of the valleys.
const LEAST_CORRELATION: f64 = 0.7;
/// The place is certain if its noise is below this part of the noise at every other place. Places that are all wrong differ less: the
/// noise of thirty of them, each from about fifty independent points, scatters by a tenth.
const CLEARLY: f64 = 0.7;
/// Noise that differs by less is rounding \[m\].
const ROUNDING: f64 = 1e-11;
/// Places that are fitted at most; a flank with more repeats within a few wavelengths of its noise cut-off.
const MOST_FITTED: usize = 60;
/// Places that a message lists at most.
const MOST_LISTED: usize = 40;
/// Factor from the shift found to the bound that a message proposes.
const WIDER: f64 = 1.2;

/// The fit at the place of the second trace, with the correlation of its valleys.
pub(super) fn placed(
    traces: [&Trace; 2],
    found: &Matches,
    most_shift: f64,
    form: Form,
) -> Result<(RelocationFit, f64), Fault> {
    let fit = |place: &Match| RelocationFit::new(traces, *place, form == Form::Poly2);
    let best = found.alike.first();
    let Some(best) = best.filter(|best| best.correlation >= LEAST_CORRELATION) else {
        let message = format!(
            "not the same place: the valleys of both traces correlate by {:.2} at best",
            best.map_or(0.0, |best| best.correlation)
        );
        return Err(Fault::new(Code::E143, message));
    };
    let (fit, best) = match &found.alike[..] {
        [_] => (fit(best)?, *best),
        several if several.len() > MOST_FITTED => return Err(alike(several)),
        several => {
            let fits: Vec<_> = several.iter().map(fit).collect();
            checkpoint().map_err(RoughnessError::from)?;
            clearest(several, fits).ok_or_else(|| alike(several))?
        }
    };
    if best.shift.abs() > most_shift + traces[0].dx {
        return Err(beyond(best, most_shift));
    }
    Ok((fit, best.correlation))
}

/// The place whose noise is clearly below the noise at all others. A place without a fit leaves none certain.
fn clearest(
    places: &[Match],
    fits: Vec<Result<RelocationFit, Fault>>,
) -> Option<(RelocationFit, Match)> {
    let fits: Vec<RelocationFit> = fits.into_iter().collect::<Result<_, _>>().ok()?;
    let mut fits: Vec<(RelocationFit, Match)> =
        fits.into_iter().zip(places.iter().copied()).collect();
    let noise = |(fit, _): &(RelocationFit, Match)| fit.noise.deviation();
    fits.sort_by(|a, b| noise(a).total_cmp(&noise(b)));
    let is_clear = noise(fits.first()?) + ROUNDING < CLEARLY * noise(fits.get(1)?);
    is_clear.then(|| fits.swap_remove(0))
}

/// Several places match alike.
fn alike(places: &[Match]) -> Fault {
    let mut shifts: Vec<f64> = places.iter().map(|place| 1e6 * place.shift).collect();
    shifts.sort_by(f64::total_cmp);
    let mut listed: Vec<String> = shifts.iter().map(|shift| decimals(*shift, 0)).collect();
    let more = listed.len().saturating_sub(MOST_LISTED);
    listed.truncate(MOST_LISTED);
    let more = match more {
        0 => String::new(),
        more => format!(" and {more} more"),
    };
    let least = places.iter().map(|place| place.correlation);
    let message = format!(
        "several places alike: the traces match as well at each of these shifts: {}{more} um; their valleys correlate by {:.3} or more there",
        listed.join(", "),
        least.fold(f64::INFINITY, f64::min),
    );
    let help = "The flank repeats along the trace, and what differs from one repeat to the next is hardly above the noise; narrower bounds \
        make none of these places certain. Compare traces with a mark that does not repeat (an indentation, a scratch, the end of the \
        flank), or measure with less noise.";
    Fault::new(Code::E143, message).helping(help)
}

/// The place is beyond the bound of the shift.
fn beyond(place: Match, most_shift: f64) -> Fault {
    let [shift, most] = [place.shift, most_shift].map(Length::from_si);
    let message = format!(
        "the traces match at a shift of {shift:.4}, beyond the bound of {most:.4}; their valleys correlate by {:.3} there",
        place.correlation
    );
    let wider = format!("{:.2} mm", (WIDER * 1e5 * place.shift.abs()).ceil() / 1e2);
    let remedy = Remedy::set(Setting::Key("max_shift"), Value::This(wider.into()));
    Fault::new(Code::E143, message).with(remedy)
}
