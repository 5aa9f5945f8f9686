//! Summary of a cycle for the terminal.

use asperity_report::wrapped;
use asperity_storage::one_line;

use super::energy::CycleResult;

/// Summary of a cycle for the terminal.
pub(super) fn summary(result: &CycleResult) -> String {
    let way = result
        .distance_km
        .map_or(String::new(), |km| format!(", {km:.2} km"));
    let mut text = format!(
        "{}\ncycle {}: {:.0} s{way}, {:.1} Wh driving, {:.1} Wh braking, flanks at {} °C (loss of the {} only)\n",
        one_line(&result.title),
        one_line(&result.cycle),
        result.duration_s,
        result.drive_wh,
        result.coast_wh,
        result.temperature_c,
        result.scope
    );
    text.push_str(&format!(
        "{:<16} {:>16} {:>10} {:>10} {:>10} {:>12} {:>18}\n",
        "finish", "lost Wh", "driving", "braking", "of drive", "Wh/100 km", "minus the first Wh"
    ));
    for finish in &result.finishes {
        let spread = |value: f64, deviation: f64| format!("{value:.2} ± {deviation:.2}");
        let difference = match (finish.difference_wh, finish.difference_deviation_wh) {
            (Some(value), Some(deviation)) => format!("{value:+.2} ± {deviation:.2}"),
            _ => "reference".to_owned(),
        };
        let share = finish
            .share_of_drive
            .map(|share| format!("{:.3} %", 100.0 * share));
        let way = finish.wh_per_100_km.map(|value| format!("{value:.1}"));
        text.push_str(&format!(
            "{:<16} {:>16} {:>10.2} {:>10.2} {:>10} {:>12} {:>18}\n",
            one_line(&finish.name),
            spread(finish.lost_wh, finish.deviation_wh),
            finish.lost_drive_wh,
            finish.lost_coast_wh,
            share.unwrap_or_else(|| "-".to_owned()),
            way.unwrap_or_else(|| "-".to_owned()),
            difference
        ));
    }
    text.push_str(&format!(
        "± is the standard deviation over the offsets of the traces; {:.1} % of the energy ({:.1} % of the moving time) is outside of the map, {:.1} % of the moving time below the torque that the traces resolve\n",
        100.0 * result.outside_energy_share,
        100.0 * result.outside_share,
        100.0 * result.extended_share
    ));
    if let Some(note) = left_aside(result) {
        text.push_str(&format!("{}\n", wrapped(&note, "     ")));
    }
    text
}

/// W431, if the case of the map states a gearbox.
pub(super) fn left_aside(result: &CycleResult) -> Option<String> {
    (!result.left_aside.is_empty()).then(|| {
        format!(
            "W431 energies are of the mesh; other losses of the case are ignored: {}",
            result.left_aside.join(", ")
        )
    })
}
