//! Summary of a cycle for the terminal.

use asperity::message::Warning;
use asperity::result::loss_band::Digits;
use asperity_core::{Code, decimals, number};
use asperity_report::{Cell, Table, columns, wrapped};
use asperity_storage::one_line;

use super::energy::{CycleFinish, CycleResult};
use crate::map::banded;

/// Summary of a cycle for the terminal.
pub(super) fn summary(result: &CycleResult) -> String {
    let way = result
        .distance_km
        .map_or(String::new(), |km| format!(", {} km", decimals(km, 2)));
    let mut text = format!(
        "{}\ncycle {}: {} s{way}, {} Wh driving, {} Wh braking, flanks at {} °C (loss of the {} only)\n",
        one_line(&result.title),
        one_line(&result.cycle),
        decimals(result.duration_s, 0),
        decimals(result.drive_wh, 1),
        decimals(result.coast_wh, 1),
        number(result.temperature_c),
        result.scope
    );
    text.push_str(&table(result).text(""));
    let brackets = match is_banded(result) {
        true => "in brackets 5 and 95 % quantiles; ",
        false => "",
    };
    text.push_str(&format!(
        "{brackets}{:.1} % of the energy ({:.1} % of the moving time) is outside of the map, {:.1} % of the moving time below the torque that the traces resolve\n",
        100.0 * result.outside_energy_share,
        100.0 * result.outside_share,
        100.0 * result.extended_share
    ));
    if let Some(note) = left_aside(result) {
        text.push_str(&format!("{}\n", wrapped(&note, "     ")));
    }
    for warning in &result.warnings {
        text.push_str(&format!("{}\n", wrapped(&warning.to_string(), "     ")));
    }
    text
}

/// The energies of each finish.
pub(super) fn table(result: &CycleResult) -> Table {
    let rows = result.finishes.iter().map(|finish| (finish, lost(finish)));
    columns! { (finish, [lost, drive, coast]) in rows;
        head name "finish" "" = &finish.name;
        number lost "lost" "Wh" = lost;
        number drive "driving" "Wh" = drive;
        number coast "braking" "Wh" = coast;
        number share "of drive energy" "%" = Cell::optional(share_of_drive(finish));
        number way "per 100 km" "Wh" = Cell::optional(per_100_km(finish));
        number difference "minus the first" "Wh" = difference(finish);
    }
}

/// Whether the energies have quantiles.
pub(super) fn is_banded(result: &CycleResult) -> bool {
    let mut finishes = result.finishes.iter();
    finishes.any(|finish| finish.lost_quantiles_wh.is_some())
}

/// Energy lost with its quantiles, and its parts while the pinion and while the wheel drives, which add up to it as printed.
fn lost(finish: &CycleFinish) -> [String; 3] {
    let parts = [finish.lost_drive_wh, finish.lost_coast_wh];
    let drawn = finish.lost_median_wh.zip(finish.lost_quantiles_wh);
    let digits = match drawn {
        Some((_, quantiles)) => Digits::of_interval(quantiles),
        None => Digits::of_decimals(2),
    };
    let factor = finish.median_over_medians();
    let total = digits.steps(factor * finish.lost_wh);
    let parts = digits.parts(total, &parts.map(|part| factor * part));
    let whole = match drawn {
        Some(_) => banded(finish.lost_wh, drawn),
        None => digits.text(total),
    };
    [whole, digits.text(parts[0]), digits.text(parts[1])]
}

/// `value`, in proportion to the energy lost, as its median with the digits that the interval leaves.
fn proportional(finish: &CycleFinish, value: f64) -> String {
    let median = value * finish.median_over_medians();
    let half = match finish.lost_quantiles_wh {
        Some([low, high]) if finish.lost_wh > 0.0 => 0.5 * (high - low) / finish.lost_wh * value,
        _ => 0.0,
    };
    Digits::of_uncertainty(half).rounded(median)
}

/// The energy lost over the energy at the pinion while it drives \[%\].
fn share_of_drive(finish: &CycleFinish) -> Option<String> {
    Some(proportional(finish, 100.0 * finish.share_of_drive?))
}

/// The energy lost per 100 km \[Wh\].
fn per_100_km(finish: &CycleFinish) -> Option<String> {
    Some(proportional(finish, finish.wh_per_100_km?))
}

/// The energy lost with each finish, and its difference from the first, in words.
pub(super) fn verdicts(result: &CycleResult) -> Vec<String> {
    let verdict = |finish: &CycleFinish| {
        let [whole, ..] = lost(finish);
        let share = share_of_drive(finish).map(|share| format!(", {share} % of the drive energy"));
        let against = finish.difference_wh.and_then(|_| {
            let first = result.finishes.first()?;
            Some(format!(
                "; {} Wh against {}",
                difference(finish),
                first.name
            ))
        });
        let [share, against] = [share, against].map(Option::unwrap_or_default);
        format!("{} loses {whole} Wh{share}{against}.", finish.name)
    };
    result.finishes.iter().map(verdict).collect()
}

/// Difference from the first finish with its quantiles.
fn difference(finish: &CycleFinish) -> String {
    let Some(value) = finish.difference_wh else {
        return "reference".to_owned();
    };
    match finish
        .difference_median_wh
        .zip(finish.difference_quantiles_wh)
    {
        Some(drawn) => banded(value, Some(drawn)),
        None => format!("{value:+.2}"),
    }
}

/// W431, if the case of the map states a gearbox.
pub(super) fn left_aside(result: &CycleResult) -> Option<String> {
    (!result.left_aside.is_empty()).then(|| {
        let text = format!(
            "energies are of the mesh; other losses of the case are ignored: {}",
            result.left_aside.join(", ")
        );
        Warning::new(Code::W431, text).to_string()
    })
}
