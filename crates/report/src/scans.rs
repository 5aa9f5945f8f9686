//! Patches of scans against rows of them, and the loss of each row: one report for page, terminal, folder and studies.

use asperity::result::loss_band::{Digits, PairSampling, rounded, without_interval};
use asperity::result::{GapRow, RunResult, ScanComparison, ScanLoss, ToothTrace};
use asperity_core::Estimate;

use crate::chart::{Axis, Chart, Drawing, Line};
use crate::tables::BODIES;
use crate::{Cell, Table, Value, columns};

/// Name of the section of a page about scans.
pub const SECTION: &str = "Scans";
/// Table of the losses by rows of scans.
pub const ROWS: &str = "scan_rows.csv";
/// Table of the losses by patches and by rows.
pub const LOSSES: &str = "scans.csv";
/// Table of the contact over its gap.
pub const GAPS: &str = "scan_gaps.csv";

/// Explanation of the numbers.
pub(crate) const NOTE: &str = "The rows are traces of the same scans, and their contact is solved in plane strain. The summits of a \
    patch meet wherever they are along the lead, and levelled rows do not contain the heights between rows. The flow factor is the \
    flow in the inlet over the flow of a smooth gap. It is computed through the patch, and of rows by their height and lay. Both are \
    means over the places at the position with the highest pressure, each with the roughness that its inlet leaves.";

/// Words instead of the comparison of patches with rows.
#[must_use]
pub fn without(why: &str) -> String {
    format!("The patches of the scans are not compared with rows of them: {why}.")
}

/// The rows of scans of a run that are taken as lines, with their sampling; `None` without such rows.
pub(crate) fn rows_of(result: &RunResult) -> Option<(Vec<RowOfScan<'_>>, &PairSampling)> {
    let rows = rows(result);
    let sampling = result.pairs.as_ref()?.sampling.as_ref()?;
    (!rows.is_empty()).then_some((rows, sampling))
}

/// The tables of a run with scans, each with its file.
pub(crate) fn tables(result: &RunResult) -> Vec<Table> {
    if let Some(scans) = &result.scans {
        return vec![losses(scans), gaps(scans)];
    }
    let rows = rows_of(result);
    rows.map(|(rows, sampling)| rows_table(&rows, sampling))
        .into_iter()
        .collect()
}

/// A row of a scan with its flank.
pub(crate) type RowOfScan<'a> = (&'static str, &'a ToothTrace);

/// The rows of scans that are taken as lines.
fn rows(result: &RunResult) -> Vec<RowOfScan<'_>> {
    let Some(pairs) = &result.pairs else {
        return Vec::new();
    };
    let flanks = BODIES.into_iter().zip(&pairs.traces);
    let rows = flanks.flat_map(|(body, traces)| traces.iter().map(move |trace| (body, trace)));
    rows.filter(|(_, trace)| trace.row.is_some()).collect()
}

/// Mean and scatter of the losses of rows.
pub(crate) fn rows_line(rows: &[RowOfScan<'_>], sampling: &PairSampling) -> String {
    let count = |body: &str| rows.iter().filter(|(of, _)| *of == body).count();
    let several = |k: &usize| count(BODIES[*k]) > 1;
    let taken: Vec<String> = (0..2)
        .filter(|k| count(BODIES[*k]) > 0)
        .map(|k| format!("{} of the {}", count(BODIES[k]), BODIES[k]))
        .collect();
    let scatter: Vec<String> = (0..2)
        .filter(several)
        .map(|k| {
            let watts = match sampling.between_w[k] {
                watts if watts > 0.0 => rounded(watts, watts),
                _ => "0".to_owned(),
            };
            format!("{watts} W between the rows of the {}", BODIES[k])
        })
        .collect();
    format!(
        "Rows of scans are computed as traces: {}. Each is computed with each trace of the other flank. Mean {} W. Standard deviation \
         {}. Rows of one scan are of one tooth.",
        taken.join(", "),
        rounded(sampling.mean_w, sampling.half_width_w),
        scatter.join(" and ")
    )
}

/// The rows with their losses, each a mean over its pairs.
pub(crate) fn rows_table(rows: &[RowOfScan<'_>], sampling: &PairSampling) -> Table {
    let watts = |loss: f64| rounded(loss, sampling.half_width_w);
    let change = |loss: f64| Digits::of_uncertainty(sampling.half_width_w).signed(loss);
    columns! { (body, trace) in rows;
        head flank "flank" "" = *body;
        number row "row" "" = Cell::optional(trace.row);
        number lead_mm "along the lead" "mm" "{:.3}" = trace.row_mm;
        number loss_w "loss" "W" = Cell::number(trace.loss_w, watts);
        number deviation_w "from the mean" "W" = Cell::number(trace.loss_w.map(|loss| loss - sampling.mean_w), change);
    }
    .in_file(ROWS)
}

/// Loss of each row over its place along the lead; `None` if places are unknown.
pub(crate) fn rows_chart(rows: &[RowOfScan<'_>], mean_w: f64) -> Option<Drawing> {
    let x = Axis::new("along the lead, from the first row of the scan", "mm");
    let title = "Loss of each row over the face";
    let mut chart = Chart::new("scan-rows", title, ROWS, x, Axis::new("loss", "W"));
    for body in BODIES {
        let own = rows.iter().filter(|(of, _)| *of == body);
        let places: Option<Vec<[f64; 2]>> = own
            .map(|(_, trace)| Some([trace.row_mm?, trace.loss_w?]))
            .collect();
        let (places, losses): (Vec<f64>, Vec<f64>) =
            places?.into_iter().map(|[x, y]| (x, y)).unzip();
        if !places.is_empty() {
            chart = chart.curve(body, Line::Dots, &places, &losses);
        }
    }
    Some(Drawing::Curves(chart.level(mean_w, "mean")))
}

/// The loss by patches and by rows, and their difference, in words.
#[must_use]
pub fn verdict(scans: &ScanComparison) -> String {
    let [patches, lines] = [&scans.patches, &scans.lines].map(|of| loss(of).text().to_owned());
    let difference = match scans.difference_w {
        Some([value, low, high]) => difference(Estimate::new(value, [low, high])),
        None => {
            let change = scans.patches.loss_w - scans.lines.loss_w;
            Digits::of_uncertainty(0.1 * change.abs()).signed(change)
        }
    };
    let brackets = if scans.difference_w.is_some() {
        "; in brackets 5 to 95 %"
    } else {
        ""
    };
    let [of_patches, of_lines] = [&scans.patches, &scans.lines].map(share);
    format!(
        "Taken as patches the scans lose {patches} W, by rows {lines} W: a difference of {difference} W{brackets}. \
         The asperities carry {of_patches} % of the load by patches and {of_lines} % by rows."
    )
}

/// The difference of two drawn losses \[W\] with its interval.
#[must_use]
pub fn difference(watts: Estimate) -> String {
    Digits::of_difference(watts.ends()).signed_interval(watts)
}

/// Share of the load on the asperities \[%\].
fn share(of: &ScanLoss) -> String {
    format!("{:.0}", 100.0 * of.asperity_share)
}

fn drawn(of: &ScanLoss) -> Option<Estimate> {
    of.loss_quantiles_w
        .map(|ends| Estimate::new(of.loss_w, ends))
}

/// The loss with its interval, if it is drawn.
fn loss(of: &ScanLoss) -> Cell {
    match drawn(of) {
        Some(estimate) => Cell::interval(estimate),
        None => Cell::with_ends(without_interval(of.loss_w), Some(of.loss_w), None),
    }
}

/// Film, lubricated asperities, boundary layer and rolling with the digits of the loss.
fn parts(of: &ScanLoss) -> [Cell; 4] {
    let parts = [
        of.film_w,
        of.lubricated_asperity_w,
        of.boundary_w,
        of.rolling_w,
    ];
    let digits = Digits::of_drawn(drawn(of), Digits::of_uncertainty(0.1 * of.loss_w));
    let texts = digits.texts_of_parts(of.loss_w, &parts);
    std::array::from_fn(|k| Cell::shown(&*texts[k], Value::Number(parts[k])))
}

/// Loss, its parts and the contact, by patches and by rows.
pub fn losses(scans: &ScanComparison) -> Table {
    let [pinion, wheel] = scans.rows;
    let rows = [
        ("patches".to_owned(), &scans.patches),
        (format!("rows, {pinion} × {wheel}"), &scans.lines),
    ];
    columns! { (contact, of) in rows;
        head contact "contact" "" = contact.as_str();
        interval loss_w "loss" "W" = loss(of);
        number film_w "film" "W" = parts(of)[0].clone();
        number lubricated_asperity_w "lubricated asperities" "W" = parts(of)[1].clone();
        number boundary_w "boundary layer" "W" = parts(of)[2].clone();
        number rolling_w "rolling" "W" = parts(of)[3].clone();
        number asperity_share "load on asperities" "%" = Cell::shown(share(of), of.asperity_share.into());
        number attenuated_rms_um "roughness left" "µm" = Cell::number(of.attenuated_rms_um, |rms| format!("{rms:.2}"));
        number inlet_factor "gap supplied over smooth film" "" = Cell::number(of.inlet_factor, |psi| format!("{psi:.2}"));
    }
    .in_file(LOSSES)
}

/// A length with three significant digits.
fn three_digits(um: f64) -> String {
    let power = if um > 0.0 { um.log10().floor() } else { 0.0 };
    let decimals = (2.0 - power).clamp(0.0, 6.0) as usize;
    format!("{um:.decimals$}")
}

/// The contact over its gap.
pub fn gaps(scans: &ScanComparison) -> Table {
    columns! { row in &scans.gaps;
        number gap_um "gap" "µm" = Cell::number(row.gap_um, three_digits);
        number share_patch "load carried by the patch" "" = Cell::number(row.share_patch, |share| format!("{share:.2}"));
        number share_lines "by rows" "" = Cell::number(row.share_lines, |share| format!("{share:.2}"));
        number flow_patch "flow factor of the patch" "" = Cell::number(row.flow_patch, |flow| format!("{flow:.2}"));
        number flow_lines "of rows" "" = Cell::number(row.flow_lines, |flow| format!("{flow:.2}"));
    }
    .in_file(GAPS)
}

/// Load carried and flow factor over the gap.
pub fn drawings(scans: &ScanComparison) -> Vec<Drawing> {
    let x: Vec<f64> = scans.gaps.iter().map(|row| row.gap_um).collect();
    let chart = |[id, title, axis]: [&str; 3], of: [fn(&GapRow) -> f64; 2]| {
        let column = |of: fn(&GapRow) -> f64| scans.gaps.iter().map(of).collect::<Vec<f64>>();
        let chart = Chart::new(
            id,
            title,
            GAPS,
            Axis::new("mean gap", "µm"),
            Axis::new(axis, "").from_zero(),
        )
        .curve("patch", Line::Solid, &x, &column(of[0]))
        .curve("rows", Line::Dashed, &x, &column(of[1]));
        Drawing::Curves(chart)
    };
    vec![
        chart(
            [
                "scan-share",
                "Share of the load that the asperities carry at a gap",
                "share of the load",
            ],
            [|row| row.share_patch, |row| row.share_lines],
        ),
        chart(
            [
                "scan-flow",
                "Flow in the inlet at a gap, over the flow of a smooth gap",
                "flow factor",
            ],
            [|row| row.flow_patch, |row| row.flow_lines],
        ),
    ]
}

#[cfg(test)]
mod tests {
    use super::three_digits;

    #[test]
    fn gaps_of_thin_films_differ() {
        assert_eq!(three_digits(0.0123), "0.0123");
        assert_eq!(three_digits(1.234), "1.23");
        assert_eq!(three_digits(0.0), "0.00");
    }
}
