//! Report of predicted traction curves.

use asperity::result::loss_band::Digits;
use asperity_core::Estimate;
use asperity_report::chart::{Axis, Chart, Drawing, Line, Series};
use asperity_report::{Cell, Column, Kind, Report, StudyResult, Table, columns};

use super::traction::{ComputedCurves, LEAST_RATIO, PredictedPoint, TractionCurves};

const OVER_SLIDE: &str = "traction_over_slide_to_roll.csv";
const OVER_SPEED: &str = "traction_over_speed.csv";
/// Slide-to-roll ratios \[%\] of the summary, with the names of their columns.
const SHOWN: [(f64, &str); 4] = [
    (1.0, "friction_at_1_percent"),
    (5.0, "friction_at_5_percent"),
    (20.0, "friction_at_20_percent"),
    (50.0, "friction_at_50_percent"),
];

impl StudyResult for TractionCurves {
    const KIND: &'static str = "traction curves";
    const NAME: &'static str = "traction";

    fn report(&self) -> Report<'_> {
        let guide = format!(
            "Solid: predicted where the film is at least three times as thick as the roughness. Dashed: a guide to the boundary \
            friction of {}, not a prediction; it is in no file.",
            self.boundary_friction
        );
        Report::new(&self.title, "predicted traction")
            .section("Traction")
            .verdict(verdict(self))
            .text([conditions(self)])
            .text([NEXT])
            .on_page()
            .figures(|| charts(self))
            .text([guide])
            .on_page()
            .table(table(self))
            .text(notes(self))
            .rows(OVER_SLIDE, || &self.over_slide)
            .rows(OVER_SPEED, || &self.over_speed)
    }
}

/// Next step.
const NEXT: &str = "Measured traction curves narrow this interval: asperity oil plan lists the points to measure, and asperity oil fit \
    fits the constants to them.";

/// Film and friction at each temperature.
fn table(traction: &TractionCurves) -> Table {
    let table = columns! { curves in &traction.curves;
        number temperature_c "temperature" "°C" "{:.0}";
        number film_nm "film" "nm" "{:.0}" = curves.film_ratio * traction.roughness_nm;
        number film_ratio "film over roughness" "" "{:.1}";
    };
    let table = table.with(SHOWN.map(|(percent, name)| {
        let heading = format!("friction at {percent} %");
        let cells = traction.curves.iter().map(|curves| {
            let point = nearest(&curves.over_slide, percent);
            Cell::number(point.map(|point| point.traction), |friction| {
                format!("{friction:.4}")
            })
        });
        Column::new(Kind::Number, &heading, "", cells).named(name)
    }));
    table.in_file("traction.csv")
}

/// The friction at the middle temperature and a usual slide-to-roll ratio, with its interval.
fn verdict(traction: &TractionCurves) -> Option<String> {
    const USUAL_PERCENT: f64 = 5.0;
    let curves = traction.curves.get(traction.curves.len() / 2)?;
    let point = nearest(&curves.over_slide, USUAL_PERCENT)?;
    let ends = [point.traction_p05, point.traction_p95];
    Some(format!(
        "At {:.0} °C the friction is {} at a slide-to-roll ratio of {:.0} %.",
        curves.temperature_c,
        Digits::of_interval(ends).interval(Estimate::new(point.traction, ends)),
        point.slide_roll_percent
    ))
}

fn conditions(traction: &TractionCurves) -> String {
    format!(
        "{:.0} N ({:.2} GPa), {} m/s, roughness {:.0} nm, law of pressure {}.",
        traction.load_n,
        traction.max_pressure_gpa,
        traction.mean_speed_m_s,
        traction.roughness_nm,
        traction.pressure_law
    )
}

fn notes(traction: &TractionCurves) -> Vec<String> {
    let percent = traction.deviations.map(|deviation| 100.0 * deviation);
    let mut notes = vec![format!(
        "The band is the 5 to 95 % range of the friction by the constants of the oil only. Their standard deviations are {:.0} % (Eyring stress), {:.0} % (limiting shear stress) and {:.0} % (pressure-viscosity coefficient in friction).",
        percent[0], percent[1], percent[2]
    )];
    let thin = traction
        .curves
        .iter()
        .filter(|curves| curves.film_ratio < LEAST_RATIO);
    let thin: Vec<String> = thin
        .map(|curves| format!("{:.0} °C", curves.temperature_c))
        .collect();
    if !thin.is_empty() {
        notes.push(format!(
            "At {} the film at {} m/s is thinner than three times the roughness: no prediction.",
            thin.join(", "),
            traction.mean_speed_m_s
        ));
    }
    notes
}

fn nearest(points: &[PredictedPoint], percent: f64) -> Option<&PredictedPoint> {
    let far = |point: &PredictedPoint| (point.slide_roll_percent / percent).ln().abs();
    points.iter().min_by(|a, b| far(a).total_cmp(&far(b)))
}

fn charts(traction: &TractionCurves) -> [Drawing; 2] {
    let slide = Chart::new(
        "over-slide",
        &format!(
            "Traction over the slide-to-roll ratio at {} m/s",
            traction.mean_speed_m_s
        ),
        OVER_SLIDE,
        Axis::new("slide-to-roll ratio", "%").log(),
        Axis::new("friction coefficient", "").from_zero(),
    );
    let speed = Chart::new(
        "over-speed",
        &format!(
            "Traction over the speed at a slide-to-roll ratio of {} %",
            traction.slide_roll_percent
        ),
        OVER_SPEED,
        Axis::new("mean speed", "m/s").log(),
        Axis::new("friction coefficient", "").from_zero(),
    );
    let slide = drawn(
        slide,
        traction,
        |curves| &curves.over_slide,
        |point| point.slide_roll_percent,
    );
    let mut speed = drawn(
        speed,
        traction,
        |curves| &curves.over_speed,
        |point| point.mean_speed_m_s,
    );
    for curves in traction
        .curves
        .iter()
        .filter(|curves| !curves.guide.is_empty())
    {
        let name = format!("guide to boundary friction, {:.0} °C", curves.temperature_c);
        let points = curves.guide.iter().copied();
        speed
            .series
            .push(Series::through(&name, Line::Dashed, points));
    }
    [slide, speed].map(Drawing::Curves)
}

fn drawn(
    mut chart: Chart,
    traction: &TractionCurves,
    points: fn(&ComputedCurves) -> &[PredictedPoint],
    x: fn(&PredictedPoint) -> f64,
) -> Chart {
    let shown = traction
        .curves
        .iter()
        .filter(|curves| !points(curves).is_empty());
    let shown: Vec<&ComputedCurves> = shown.collect();
    for curves in &shown {
        let name = format!("{:.0} °C", curves.temperature_c);
        let line = points(curves)
            .iter()
            .map(|point| [x(point), point.traction]);
        chart.series.push(Series::through(&name, Line::Solid, line));
    }
    for (k, curves) in shown.iter().enumerate() {
        let of = |value: fn(&PredictedPoint) -> f64| {
            points(curves).iter().map(value).collect::<Vec<f64>>()
        };
        let name = format!("5 to 95 %, {:.0} °C", curves.temperature_c);
        let (low, high) = (
            of(|point| point.traction_p05),
            of(|point| point.traction_p95),
        );
        chart
            .series
            .push(Series::band_of(k, &name, &of(x), &low, &high));
    }
    chart
}
