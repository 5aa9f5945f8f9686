//! The page on how the program works: its figure is drawn from the demo, and its numbers are those of the demo.

use std::fs;
use std::sync::LazyLock;

use asperity::Run;
use asperity::pipeline::Kept;
use asperity::result::MeshOutcome;
use asperity_report::chart::{Axis, Chart, Line, Mark, Series};
use asperity_tests::markdown::{prose, root, without_code};
use asperity_tests::picture::{hold_picture, panels};

use crate::pictures::over_path;

static DEMO: LazyLock<MeshOutcome> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    for file in asperity_fixtures::demo::files().unwrap() {
        fs::write(folder.path().join(file.name), file.content).unwrap();
    }
    let case = asperity::case::load(&folder.path().join("case.toml"), None).unwrap();
    let run = Run::new(&case).pictures(Kept::Highest).interval(true);
    run.execute().unwrap().into_only().unwrap()
});

/// A loss with the digits that its interval leaves.
fn tens(watts: f64) -> String {
    format!("{:.0}", 10.0 * (watts / 10.0).round())
}

fn panel(id: &str, title: &str, x: Axis, y: Axis) -> Chart {
    let chart = Chart::new(id, title, "how-it-works.md", x, y);
    Chart {
        width: 325.0,
        height: 120.0,
        ..chart
    }
}

/// A panel over the path of contact with its points A to E.
fn path_panel(id: &str, title: &str, y: Axis) -> Chart {
    let x = Axis::new("path of contact, A to E", "");
    let marks = DEMO.result.points.iter().map(|point| Mark {
        at: point.row.path_fraction,
        label: point.point.to_string(),
    });
    panel(id, title, x, y.from_zero()).marked(&marks.collect::<Vec<_>>())
}

fn trace() -> Chart {
    let profile = DEMO.traces[0].as_ref().unwrap();
    let step = 1e3 * profile.spacing().si();
    let heights = profile.heights().iter().enumerate();
    let points = heights.map(|(i, z)| [step * i as f64, 1e6 * z]);
    let axes = [
        Axis::new("along the flank", "mm"),
        Axis::new("height", "µm"),
    ];
    let [x, y] = axes;
    panel("trace", "1 Trace of the pinion", x, y).with(Series::through(
        "pinion",
        Line::Solid,
        points,
    ))
}

fn load() -> Chart {
    let rows = DEMO.result.load.path.iter();
    let points = rows.map(|row| [row.path_fraction, row.mean_n_per_mm]);
    let y = Axis::new("load", "N/mm");
    path_panel("load", "2 Load of a line of contact", y).with(Series::through(
        "load",
        Line::Solid,
        points,
    ))
}

fn film() -> Chart {
    let path = &DEMO.result.path;
    let gap = over_path("mean gap, rough", Line::Dashed, path, |row| {
        row.mean_gap_um.unwrap_or(f64::NAN)
    });
    path_panel("film", "3 Oil film", Axis::new("thickness", "µm"))
        .with(over_path("smooth film", Line::Solid, path, |row| {
            row.film_central_um
        }))
        .with(gap)
}

fn contact() -> Chart {
    /// Half of the visible width [µm].
    const REACH: f64 = 85.0;
    let view = &DEMO.views[0];
    let visible = |column: &[f64]| -> Vec<f64> {
        let pairs = view.x_um.iter().zip(column);
        let near = pairs.filter(|(x, _)| x.abs() <= REACH);
        near.map(|(_, value)| *value).collect()
    };
    let [x, pinion, wheel] = [&view.x_um, &view.pinion_um, &view.wheel_um].map(|c| visible(c));
    let across = Axis::new("across the contact", "µm").within(-REACH, REACH);
    let height = Axis::new("height", "µm");
    panel("contact", "4 Rough contact near A", across, height)
        .curve("pinion", Line::Solid, &x, &pinion)
        .curve("wheel", Line::Solid, &x, &wheel)
        .with(Series::area("oil", &x, &pinion, &wheel))
}

fn friction() -> Chart {
    let path = &DEMO.result.path;
    let places: Vec<f64> = path.iter().map(|row| row.path_fraction).collect();
    let y = Axis::new("loss", "kW/m");
    let mut chart = path_panel("friction", "5 Friction of three parts", y);
    let mut low = vec![0.0; path.len()];
    for name in ["boundary layer", "lubricated asperities", "film"] {
        let parts = path.iter().map(|row| match name {
            "film" => row.film_w_per_m,
            "boundary layer" => row.boundary_w_per_m,
            _ => row.lubricated_asperity_w_per_m,
        });
        let sums = low.iter().zip(parts).map(|(low, part)| low + 1e-3 * part);
        let high: Vec<f64> = sums.collect();
        chart = chart.with(Series::area(name, &places, &low, &high));
        low = high;
    }
    chart
}

fn loss() -> Chart {
    let loss = &DEMO.result.uncertainty.as_ref().unwrap().loss;
    let windows = &DEMO.offsets;
    let ends = [0.0, 1.0 + windows.len() as f64];
    let [low, high, median] =
        [loss.quantiles_w[0], loss.quantiles_w[1], loss.median_w].map(|watts| [watts; 2]);
    let points = windows.iter().map(|row| [row.offset as f64, row.loss_w]);
    let x = Axis::new("part of the traces", "").within(ends[0], ends[1]);
    let named = format!("median {} W", tens(loss.median_w));
    panel("loss", "6 Loss and interval", x, Axis::new("loss", "W"))
        .with(Series::through(
            "one part of the traces",
            Line::Scatter,
            points,
        ))
        .with(Series::band("90 % interval", &ends, &low, &high))
        .curve(&named, Line::Ink, &ends, &median)
}

#[test]
fn the_figure_of_how_it_works_is_new() {
    let charts = [trace(), load(), film(), contact(), friction(), loss()];
    let figure = panels("From two traces to watts", &charts);
    hold_picture("figures/how-it-works.svg", &figure);
}

/// What the page says with numbers, by the run.
fn facts() -> Vec<String> {
    let result = &DEMO.result;
    let summary = &result.summary;
    let [first, last] = [&result.path[0], &result.path[result.path.len() - 1]];
    let trace = DEMO.traces[0].as_ref().unwrap();
    let recipe = &result.flanks[0].preparation.as_ref().unwrap().recipe;
    let [short, long] = [recipe.lambda_s, recipe.lambda_c].map(|cutoff| cutoff.unwrap().si());
    let uncertainty = result.uncertainty.as_ref().unwrap();
    let mut constants = uncertainty.constants.iter();
    let boundary = constants.find(|constant| constant.name == "boundary friction");
    let [low, high] = uncertainty.loss.quantiles_w.map(tens);
    let asperities = summary.boundary_w + summary.lubricated_asperity_w;
    vec![
        format!("power of {:.0} kW", 1e-3 * summary.power_in_w),
        format!(
            "{} points, {:.1} µm apart",
            trace.len(),
            1e6 * trace.spacing().si()
        ),
        format!("shorter than {:.1} µm", 1e6 * short),
        format!("longer than {:.2} mm", 1e3 * long),
        format!("at {} positions", summary.positions),
        format!("{:.0} N/mm", first.line_load_n_per_mm),
        format!("{:.0} MPa", first.hertz_pressure_mpa),
        format!("{:.1} m/s", first.sliding_m_per_s.abs()),
        format!("oil at {}", result.lubricant.temperature),
        format!("{:.3} µm near A", first.film_central_um),
        format!("{:.3} µm near E", last.film_central_um),
        format!("{:.2} µm apart on average", first.mean_gap_um.unwrap()),
        format!(
            "{:.0} % of the load near A",
            100.0 * (1.0 - first.film_share)
        ),
        format!("the mean of {} pairs", summary.offsets),
        format!("coefficient of {}", boundary.unwrap().value),
        format!("loses {:.0} kW per metre", 1e-3 * first.sliding_w_per_m),
        format!("{:.0} kW in the film", 1e-3 * first.film_w_per_m),
        format!(
            "{:.0} kW at lubricated asperities",
            1e-3 * first.lubricated_asperity_w_per_m
        ),
        format!(
            "{:.0} kW in the boundary layer",
            1e-3 * first.boundary_w_per_m
        ),
        format!("{:.0} W with every constant", summary.at_medians_w()),
        format!("{} samples", uncertainty.draws),
        format!("median of {} W", tens(uncertainty.loss.median_w)),
        format!("90 % interval from {low} to {high} W"),
        format!("Sliding in the film causes {} W", tens(summary.film_w)),
        format!("sliding of the asperities {} W", tens(asperities)),
        format!("boundary layer {} W", tens(summary.boundary_w)),
        format!("rolling {} W", tens(summary.rolling_w)),
    ]
}

#[test]
fn numbers_of_how_it_works_are_those_of_the_demo() {
    let page = fs::read_to_string(root().join("docs/how-it-works.md")).unwrap();
    let is_text = |line: &&str| !line.starts_with('#');
    let lines = prose(&page).into_iter().filter(is_text);
    let mut text = lines.map(without_code).collect::<Vec<_>>().join(" ");
    for fact in facts() {
        assert!(text.contains(&fact), "the page does not say {fact:?}");
        text = text.replace(&fact, "");
    }
    let rest = text.split(|c: char| !c.is_ascii_digit());
    let rest: Vec<&str> = rest.filter(|number| !number.is_empty()).collect();
    assert!(rest.is_empty(), "numbers that no run gives: {rest:?}");
}
