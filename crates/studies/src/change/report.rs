//! Report of a change of traces: what was removed and moved, both traces over each other, and the parameters.

use asperity::result::loss_band::Digits;
use asperity_core::Estimate;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Cell, Report, StudyResult, StudySettings as _, Table, columns, thin};

use super::digits::{LEAST_NM, digits, height, shown};
use super::study::{
    ChangeSettings, ChangedPointRow, CurveRow, Heights, PairRow, ParameterRow, TraceChange,
    is_undecided,
};
use super::worth;

const PAIRS: &str = "pairs.csv";
const PARAMETERS: &str = "parameters.csv";
const CURVE: &str = "material_ratio.csv";
/// Pairs that are drawn.
const DRAWN: usize = 4;
/// Bins of a drawn trace.
const BINS: usize = 350;
/// Width of the close-up \[mm\].
const CLOSE: f64 = 0.2;
/// Last places that a measured trace leaves of a height in µm, of a shift \[µm\], of a stretch \[%\] and of a tilt \[µm/mm\].
const LEAST_UM: f64 = 1e-4;
const LEAST_SHIFT: f64 = 1e-3;
const LEAST_STRETCH: f64 = 1e-4;
const LEAST_TILT: f64 = 1e-4;
/// Half width of an interval over a noise floor, which one of twenty exceeds.
const OF_FLOOR: f64 = 0.84;

impl StudyResult for TraceChange {
    const KIND: &'static str = "change of traces";
    const NAME: &'static str = "change";

    fn report(&self) -> Report<'_> {
        let report = Report::new(&self.title, "change of traces")
            .section("What changed")
            .verdict(self.in_case.iter().map(worth::loss_line))
            .verdict(verdict(self))
            .verdict(order(self))
            .verdict(scatter(self))
            .verdict(moved(&self.mean))
            .verdict([parameters_line(self)])
            .verdict(self.in_case.iter().flat_map(worth::wear_lines))
            .text(without_noise(self))
            .text(self.in_case.iter().filter_map(worth::run_in))
            .figures(|| charts(self))
            .warning(&self.warnings)
            .warning(self.in_case.iter().flat_map(|of| &of.warnings));
        let report = match &self.in_case {
            Some(of) => worth::sections(report, of),
            None => report,
        };
        let mut report = report
            .section("Roughness parameters")
            .text([OF_CORE])
            .on_page()
            .table(parameters(self))
            .section("Material ratio curve")
            .figures(|| [curve_chart(self)])
            .table(curve(self))
            .section("Match")
            .text(self.pairs.iter().map(place))
            .table(pairs(self))
            .method([ChangeSettings::METHOD]);
        for (k, points) in self.points.iter().enumerate() {
            report = report.rows(trace_file(k), move || points);
        }
        report
    }
}

/// Meaning of a change of Rk and Rvk.
const OF_CORE: &str = "Rk and Rvk are heights from a line through the core. It moves where peaks are lost, so that Rvk can change \
    with the same valleys: the levels of the material ratio show the valleys themselves.";

/// Noise below which a trace is taken as computed \[nm\]: half of the 0.1 nm that the quietest interferometers state (assumed).
const LEAST_NOISE_NM: f64 = 0.05;

/// That the traces have no noise, as computed ones.
fn without_noise(study: &TraceChange) -> Option<&'static str> {
    let all = study
        .pairs
        .iter()
        .all(|pair| pair.noise_nm < LEAST_NOISE_NM);
    all.then_some(
        "The traces agree to less than the noise of any instrument, as computed traces do. The intervals say nothing of an instrument.",
    )
}

fn trace_file(pair: usize) -> String {
    format!("traces_{}.csv", pair + 1)
}

fn nanometres(estimate: Estimate) -> String {
    digits(estimate, LEAST_NM).interval_with(" nm", estimate)
}

/// The height removed, that there is none, or that the traces do not decide it.
fn verdict(study: &TraceChange) -> [String; 1] {
    let removed = study.mean.removed_nm;
    let height = nanometres(removed);
    [if removed.low > 0.0 {
        format!("The test removed {height} of height, as mean over the trace.")
    } else if removed.high < 0.0 {
        format!(
            "Nothing was removed: the trace is higher by {}, relative to its valleys.",
            nanometres(removed.map(|nm| -nm))
        )
    } else if is_undecided(&study.mean, &study.parameters) {
        format!(
            "Inconclusive: {height} of height was removed, as mean over the trace, and yet the peaks are lower. {}",
            way_out(study)
        )
    } else {
        format!(
            "Nothing was removed within the noise floor: {height} of height, as mean over the trace."
        )
    }]
}

/// How to decide what was removed.
fn way_out(study: &TraceChange) -> String {
    match study.mean_with_bow.map(|mean| mean.removed_nm) {
        Some(removed) if removed.low > 0.0 => format!(
            "If the second trace is bowed by its clamping or temperature, the test removed {}: state form = poly2.",
            nanometres(removed)
        ),
        _ => "Form or noise between the traces hides it: compare a shorter part of both (range), or measure with less noise.".to_owned(),
    }
}

/// That the traces may be in the other order: wear raises no trace without lowering it elsewhere.
fn order(study: &TraceChange) -> Option<String> {
    let Heights {
        lost_nm: lost,
        gained_nm: gained,
        ..
    } = study.mean;
    (gained.low > 0.0 && lost.low <= 0.0).then(|| {
        format!(
            "The second trace gained {} where it is higher and lost nothing, which no wear does. Are the traces in the other order?",
            nanometres(gained)
        )
    })
}

/// Scatter from pair to pair; `None` of a single one.
fn scatter(study: &TraceChange) -> Option<String> {
    study.scatter_nm.map(|scatter| {
        let digits = digits(study.mean.removed_nm, LEAST_NM);
        format!(
            "From pair to pair it scatters by {} nm (standard deviation of {}).",
            digits.rounded(scatter),
            study.pairs.len()
        )
    })
}

/// Height that moved; `None` if noise explains it.
fn moved(mean: &Heights) -> Option<String> {
    let [lost, gained] = [mean.lost_nm, mean.gained_nm];
    (gained.low > 0.0 && lost.low > 0.0).then(|| {
        let share = 100.0 * (gained.value / lost.value).min(1.0);
        format!(
            "Material moved: where the trace fell it lost {}, where it rose it gained {}, {share:.0} % of that.",
            nanometres(lost),
            nanometres(gained)
        )
    })
}

/// Digits of a change that noise leaves. A change above its floor is printed above it.
fn digits_of_change(change: f64, floor: f64) -> Digits {
    /// Places more at most.
    const MOST_MORE: usize = 4;
    let is_clear = change.abs() > floor;
    let mut digits = Digits::of_uncertainty(OF_FLOOR * floor);
    for _ in 0..MOST_MORE {
        if is_clear == (digits.steps(change.abs()) > digits.steps(floor)) {
            break;
        }
        digits = digits.finer();
    }
    digits
}

/// Change of a parameter with the digits that noise leaves.
fn change_of(row: &ParameterRow) -> String {
    digits_of_change(row.change_um, row.floor_um).signed(row.change_um)
}

/// The parameters that changed.
fn parameters_line(study: &TraceChange) -> String {
    let clear: Vec<String> = study
        .parameters
        .iter()
        .filter(|row| row.is_clear())
        .map(|row| {
            let percent = 100.0 * row.change_um / row.before_um;
            format!("{} {} µm ({percent:+.0} %)", row.parameter, change_of(row))
        })
        .collect();
    if clear.is_empty() {
        "No roughness parameter changed by more than its noise floor.".to_owned()
    } else {
        format!("Changed by more than noise: {}.", clear.join(", "))
    }
}

/// Where the second trace of a pair lies on the first.
fn place(pair: &PairRow) -> String {
    let interval = |estimate: Estimate, least| digits(estimate, least).interval(estimate);
    let bow = pair
        .bow_um
        .map(|bow| format!(" and bowed by {} µm", interval(bow, LEAST_UM)));
    format!(
        "{} lies {} µm along {}, stretched by {} %{}; their valleys correlate by {:.3}, elsewhere by {:.3}.",
        pair.after,
        interval(pair.shift_um, LEAST_SHIFT),
        pair.before,
        interval(pair.stretch_percent, LEAST_STRETCH),
        bow.unwrap_or_default(),
        pair.correlation,
        pair.elsewhere
    )
}

fn parameters(study: &TraceChange) -> Table {
    let um = |value: f64, row: &ParameterRow| {
        let digits = digits_of_change(row.change_um, row.floor_um);
        Cell::number(value, |value| digits.rounded(value))
    };
    let table = columns! { row in &study.parameters;
        head parameter "parameter" "" = row.parameter;
        number before_um "before" "µm" = um(row.before_um, row);
        number after_um "after" "µm" = um(row.after_um, row);
        number change_um "change" "µm" = Cell::number(row.change_um, |_| change_of(row));
        number floor_um "noise floor" "µm" = um(row.floor_um, row);
    };
    table.in_file(PARAMETERS)
}

fn curve(study: &TraceChange) -> Table {
    let digits = |row: &CurveRow| digits_of_change(row.change_um, row.floor_um);
    let um = |value: f64, row: &CurveRow| Cell::number(value, |value| digits(row).rounded(value));
    let signed = |row: &CurveRow| Cell::number(row.change_um, |value| digits(row).signed(value));
    let table = columns! { row in &study.material_ratio;
        number material_ratio_percent "material ratio" "%" "{:.0}";
        number before_um "level before" "µm" = um(row.before_um, row);
        number after_um "level after" "µm" = um(row.after_um, row);
        number change_um "change" "µm" = signed(row);
        number floor_um "noise floor" "µm" = um(row.floor_um, row);
    };
    table.in_file(CURVE)
}

fn pairs(study: &TraceChange) -> Table {
    let table = columns! { pair in &study.pairs;
        head before "before" "";
        head after "after" "";
        interval removed_nm "removed" "nm" = height(pair.heights.removed_nm);
        interval lost_nm "lost" "nm" = height(pair.heights.lost_nm);
        interval gained_nm "gained" "nm" = height(pair.heights.gained_nm);
        interval shift_um "shift" "µm" = shown(pair.shift_um, LEAST_SHIFT);
        interval stretch_percent "stretch" "%" = shown(pair.stretch_percent, LEAST_STRETCH);
        interval height_um "height" "µm" = shown(pair.height_um, LEAST_UM);
        interval tilt_um_per_mm "tilt" "µm/mm" = shown(pair.tilt_um_per_mm, LEAST_TILT);
        interval bow_um "bow" "µm" = pair.bow_um.map_or(Cell::estimate("-", None), |bow| shown(bow, LEAST_UM));
        number correlation "correlation" "" "{:.3}";
        number elsewhere "elsewhere" "" "{:.3}";
        number matched_percent "valleys matched" "%" "{:.0}";
        number noise_nm "noise" "nm" "{:.1}";
        number overlap_mm "common length" "mm" "{:.3}";
        number removed_um2 "section removed" "µm²" "{:.1}";
    };
    table.in_file(PAIRS)
}

fn charts(study: &TraceChange) -> Vec<Drawing> {
    let mut charts = Vec::new();
    for (k, (pair, points)) in study
        .pairs
        .iter()
        .zip(&study.points)
        .take(DRAWN)
        .enumerate()
    {
        let title = format!("{} (after) on {} (before)", pair.after, pair.before);
        charts.push(traces(&format!("traces-{}", k + 1), &title, k, points));
        if k == 0 {
            let title = "Where most was lost";
            charts.push(traces("close-up", title, k, close_up(points)));
        }
    }
    charts
}

/// The points about the place of the largest loss.
fn close_up(points: &[ChangedPointRow]) -> &[ChangedPointRow] {
    let most = |point: &&ChangedPointRow| point.lost_nm;
    let most = points.iter().max_by(|a, b| most(a).total_cmp(&most(b)));
    let middle = most.map_or(0.0, |point| point.x_mm);
    let begin = points.partition_point(|point| point.x_mm < middle - 0.5 * CLOSE);
    let end = points.partition_point(|point| point.x_mm <= middle + 0.5 * CLOSE);
    &points[begin..end]
}

/// Both traces over each other; the lost part is an area.
fn traces(id: &str, title: &str, pair: usize, points: &[ChangedPointRow]) -> Drawing {
    let drawn = thin(
        points,
        BINS,
        |point| point.x_mm,
        |point| [point.before_um, point.after_um, point.lost_nm],
    );
    let of = |value: fn(&ChangedPointRow) -> f64| drawn.iter().map(value).collect::<Vec<f64>>();
    let x = of(|point| point.x_mm);
    let [before, after] = [of(|point| point.before_um), of(|point| point.after_um)];
    let lower = of(|point| point.before_um.min(point.after_um));
    let chart = Chart::new(
        id,
        title,
        &trace_file(pair),
        Axis::new("place on the first trace", "mm"),
        Axis::new("height above the mean line before", "µm"),
    );
    let chart = chart
        .curve("before", Line::Solid, &x, &before)
        .curve("after", Line::Solid, &x, &after)
        .with(Series::area("lost", &x, &lower, &before));
    Drawing::Curves(chart)
}

fn curve_chart(study: &TraceChange) -> Drawing {
    let of =
        |value: fn(&CurveRow) -> f64| study.material_ratio.iter().map(value).collect::<Vec<f64>>();
    let x = of(|row| row.material_ratio_percent);
    let chart = Chart::new(
        "material-ratio",
        "Material ratio curve before and after",
        CURVE,
        Axis::new("material ratio", "%"),
        Axis::new("level above the mean line before", "µm"),
    );
    let chart = chart
        .curve("before", Line::Dots, &x, &of(|row| row.before_um))
        .curve("after", Line::Dots, &x, &of(|row| row.after_um));
    Drawing::Curves(chart)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_above_its_floor_is_printed_above_it() {
        let shown = |change: f64, floor: f64| {
            let digits = digits_of_change(change, floor);
            [digits.signed(change), digits.rounded(floor)]
        };
        assert_eq!(shown(0.000_52, 0.000_48), ["+0.00052", "0.00048"]);
        assert_eq!(shown(-0.0142, 0.0002), ["-0.0142", "0.0002"]);
        assert_eq!(shown(0.000_48, 0.000_52), ["+0.0005", "0.0005"]);
        assert_eq!(shown(0.1049, 0.1041), ["+0.105", "0.104"]);
    }
}
