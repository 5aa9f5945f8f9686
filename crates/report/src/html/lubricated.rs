//! Page of one lubricated contact: film and pressure, load by film thickness, and an animation.

use maud::{Markup, PreEscaped, html};
use serde_json::json;

use super::page::{figure, page};
use super::policy::FRAMES;
use crate::chart::{Axis, Chart, Drawing, Line, round_ticks};

/// Width of the animation.
const WIDTH: f64 = 640.0;
/// Height of a panel.
const PANEL: f64 = 150.0;
/// Margin at the left.
const LEFT: f64 = 62.0;
/// Margin at the right.
const RIGHT: f64 = 26.0;
/// Margin at the top.
const TOP: f64 = 22.0;
/// Approximate number of ticks of a panel.
const PANEL_TICKS: usize = 5;
/// Distance between the panels.
const GAP: f64 = 34.0;

/// Pressure and film at the same positions.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmAndPressure {
    /// Positions in half-widths.
    pub x: Vec<f64>,
    /// Pressure \[GPa\].
    pub pressure: Vec<f64>,
    /// Film \[µm\].
    pub film: Vec<f64>,
}

/// One instant of a record.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmFrame {
    /// Half-widths travelled.
    pub travel: f64,
    /// Pressure on the nodes \[GPa\].
    pub pressure: Vec<f64>,
    /// Film on the nodes \[µm\].
    pub film: Vec<f64>,
}

/// Share of the load at films below a thickness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SharePoint {
    /// Film thickness \[nm\].
    pub film_nm: f64,
    /// Share.
    pub share: f64,
    /// Standard error, if known.
    pub standard_error: Option<f64>,
}

/// Contents of the page of a lubricated contact.
#[derive(Debug, Clone, PartialEq)]
pub struct LubricatedContact {
    /// Title of the page.
    pub title: String,
    /// Subtitle.
    pub subtitle: String,
    /// The result in a sentence.
    pub verdict: String,
    /// Names and values of numbers.
    pub numbers: Vec<(String, String)>,
    /// Meaning of the numbers, and the next step.
    pub notes: Vec<String>,
    /// Codes and texts of warnings.
    pub warnings: Vec<(String, String)>,
    /// Hertz pressure \[GPa\].
    pub hertz_pressure: f64,
    /// Gap in the middle and minimum film by formula \[µm\].
    pub formula: [f64; 2],
    /// The steady solution of smooth surfaces.
    pub smooth: FilmAndPressure,
    /// Mean over time of rough surfaces.
    pub mean: Option<FilmAndPressure>,
    /// Load by film thickness.
    pub shares: Vec<SharePoint>,
    /// Travel, share of the load on thin films, mean film \[µm\], largest pressure \[GPa\] of every step.
    pub history: Vec<[f64; 4]>,
    /// Frames at the positions of `mean`.
    pub frames: Vec<FilmFrame>,
}

/// Renders the page.
pub fn lubricated_contact(contact: &LubricatedContact) -> String {
    let sections = [
        ("Summary", numbers(contact)),
        ("Film and pressure", films(contact)),
        ("Rough film in motion", player(contact)),
        ("Over the travel", history(contact)),
    ];
    page(&contact.title, &contact.subtitle, &sections)
}

fn numbers(contact: &LubricatedContact) -> Markup {
    html! {
        p { strong { (contact.verdict) } }
        dl.tiles {
            @for (name, value) in &contact.numbers { div { dt { (name) } dd { (value) } } }
        }
        @for note in &contact.notes { p { (note) } }
        @if !contact.warnings.is_empty() {
            h3 { "Warnings" }
            ul.warnings {
                @for (code, text) in &contact.warnings { li { code { (code) } " " (text) } }
            }
        }
    }
}

/// Places around the contact, without the far inlet, where gap and pressure say nothing.
fn across() -> Axis {
    Axis::new("distance from the middle, in half-widths", "").within(-2.5, 1.75)
}

fn films(contact: &LubricatedContact) -> Markup {
    let smooth = &contact.smooth;
    let hertz = |x: &f64| contact.hertz_pressure * (1.0 - x * x).max(0.0).sqrt();
    let hertz: Vec<f64> = smooth.x.iter().map(hertz).collect();
    let pressure_axis = Axis::new("pressure", "GPa").from_zero();
    let mut pressure = Chart::new("pressure", "Pressure", "this page", across(), pressure_axis)
        .curve("smooth, solved", Line::Solid, &smooth.x, &smooth.pressure);
    let within: Vec<f64> = smooth
        .x
        .iter()
        .copied()
        .filter(|x| x.abs() <= 1.0)
        .collect();
    let [central, minimum] = contact.formula;
    let flat = |film: f64| vec![film; within.len()];
    // Gaps above a few central film thicknesses are not shown.
    let most = 4.0 * central.max(contact.mean.as_ref().map_or(0.0, middle));
    let shown = |film: &[f64]| -> Vec<f64> {
        film.iter()
            .map(|h| if *h <= most { *h } else { f64::NAN })
            .collect()
    };
    let film_axis = Axis::new("film", "µm").from_zero();
    let mut film = Chart::new("film", "Film", "this page", across(), film_axis).curve(
        "smooth, solved",
        Line::Solid,
        &smooth.x,
        &shown(&smooth.film),
    );
    if let Some(mean) = &contact.mean {
        pressure = pressure.curve(
            "rough, mean over time",
            Line::Solid,
            &mean.x,
            &mean.pressure,
        );
        film = film.curve(
            "rough, mean over time",
            Line::Solid,
            &mean.x,
            &shown(&mean.film),
        );
    }
    pressure = pressure.curve("Hertz", Line::Dashed, &smooth.x, &hertz);
    film = film
        .curve("formula, smooth gap", Line::Dashed, &within, &flat(central))
        .curve("formula, minimum", Line::Dashed, &within, &flat(minimum));
    let mut charts = vec![Drawing::Curves(pressure), Drawing::Curves(film)];
    charts.extend(shares(contact));
    html! { div.charts { @for chart in &charts { (figure(chart)) } } }
}

/// Film in the middle.
fn middle(curve: &FilmAndPressure) -> f64 {
    let nearest = curve.x.iter().zip(&curve.film);
    let nearest = nearest.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
    nearest.map_or(0.0, |(_, film)| *film)
}

fn shares(contact: &LubricatedContact) -> Option<Drawing> {
    if contact.shares.is_empty() {
        return None;
    }
    let films: Vec<f64> = contact.shares.iter().map(|point| point.film_nm).collect();
    let of = |sign: f64| -> Vec<f64> {
        let value = |point: &SharePoint| point.share + sign * point.standard_error.unwrap_or(0.0);
        contact
            .shares
            .iter()
            .map(|point| value(point).max(0.0))
            .collect()
    };
    let axis = Axis::new("film", "nm").log();
    let chart = Chart::new(
        "load-below",
        "Share of the load carried below a film thickness",
        "this page",
        axis,
        Axis::new("share of the load", "").from_zero(),
    )
    .curve("mean", Line::Dots, &films, &of(0.0))
    .curve("minus one standard error", Line::Dashed, &films, &of(-1.0))
    .curve("plus one standard error", Line::Dashed, &films, &of(1.0));
    Some(Drawing::Curves(chart))
}

fn history(contact: &LubricatedContact) -> Markup {
    if contact.history.is_empty() {
        return html! {};
    }
    let column = |k: usize| -> Vec<f64> { contact.history.iter().map(|row| row[k]).collect() };
    let travel = column(0);
    let chart = |id: &str, title: &str, unit: &str, k: usize| {
        let axis = Axis::new("travel in half-widths", "");
        let values = Axis::new(&title.to_lowercase(), unit).from_zero();
        let chart = Chart::new(id, title, "this page", axis, values);
        Drawing::Curves(chart.curve(title, Line::Solid, &travel, &column(k)))
    };
    let charts = [
        chart("share-in-time", "Share of the load on thin films", "", 1),
        chart("gap-in-time", "Mean film", "µm", 2),
        chart("peak-in-time", "Largest pressure", "GPa", 3),
    ];
    html! { div.charts { @for chart in &charts { (figure(chart)) } } }
}

/// Panel of the animation.
struct Panel {
    top: f64,
    most: f64,
    name: &'static str,
    unit: &'static str,
}

impl Panel {
    fn y(&self, value: f64) -> i64 {
        // Integers in tenths of a unit of the drawing keep the page small.
        (10.0 * (self.top + PANEL * (1.0 - value / self.most))).round() as i64
    }

    fn frame(&self) -> Markup {
        let (left, right) = (LEFT, WIDTH - RIGHT);
        let ticks = round_ticks([0.0, self.most], PANEL_TICKS).into_iter();
        let ticks = ticks.map(|(value, label)| (self.y(value) as f64 / 10.0, label));
        html! {
            rect.box x=(left) y=(self.top) width=(right - left) height=(PANEL) {}
            text x=(left) y=(self.top - 7.0) { (self.name) " [" (self.unit) "]" }
            @for (y, label) in ticks {
                line.grid x1=(left) x2=(right) y1=(y) y2=(y) {}
                text.tick x=(left - 6.0) y=(y + 4.0) text-anchor="end" { (label) }
            }
        }
    }
}

/// Animation of the rough film; without scripts the first frame is shown.
fn player(contact: &LubricatedContact) -> Markup {
    let (Some(mean), Some(first)) = (&contact.mean, contact.frames.first()) else {
        return html! {};
    };
    let largest = |of: fn(&FilmFrame) -> &Vec<f64>| {
        let values = contact.frames.iter().flat_map(of);
        values.copied().fold(0.0, f64::max)
    };
    let panels = [
        Panel {
            top: TOP,
            most: largest(|frame| &frame.pressure),
            name: "pressure",
            unit: "GPa",
        },
        Panel {
            top: TOP + PANEL + GAP,
            most: 4.0 * middle(mean),
            name: "film",
            unit: "µm",
        },
    ];
    let (low, high) = (mean.x[0], mean.x[mean.x.len() - 1]);
    let px = |x: f64| 10.0 * (LEFT + (WIDTH - LEFT - RIGHT) * (x - low) / (high - low));
    let xs: Vec<i64> = mean.x.iter().map(|x| px(*x).round() as i64).collect();
    let line = |xs: &[i64], ys: &[i64]| -> String {
        let points = xs.iter().zip(ys).enumerate();
        points
            .map(|(k, (x, y))| format!("{}{x} {y}", if k == 0 { "M" } else { "L" }))
            .collect()
    };
    let rows = |panel: &Panel, values: &[f64]| -> Vec<i64> {
        values.iter().map(|v| panel.y(*v)).collect()
    };
    let frames: Vec<_> = contact
        .frames
        .iter()
        .map(|frame| {
            json!({
                "t": format!("{:.2}", frame.travel),
                "y": [rows(&panels[0], &frame.pressure), rows(&panels[1], &frame.film)],
            })
        })
        .collect();
    let data = json!({ "x": xs, "frames": frames })
        .to_string()
        .replace('<', "\\u003c");
    let smooth = [&contact.smooth.pressure, &contact.smooth.film];
    let smooth_x: Vec<i64> = contact
        .smooth
        .x
        .iter()
        .map(|x| px(*x).round() as i64)
        .collect();
    let dashed = |k: usize| line(&smooth_x, &rows(&panels[k], smooth[k]));
    let height = TOP + 2.0 * PANEL + GAP + 50.0;
    let across = round_ticks([low, high], 6).into_iter();
    let across: Vec<_> = across.map(|(x, label)| (px(x) / 10.0, label)).collect();
    html! {
        p { "The surfaces move from left to right through the contact; dashed: smooth surfaces." }
        figure.player id="motion" {
            figcaption { "Pressure and film at one instant" }
            div.slider {
                button type="button" data-player="play" { "Play" }
                input type="range" min="0" max=(contact.frames.len() - 1) value="0" aria-label="Frame" data-player="frame" {}
                span { output data-player="travel" { (format!("{:.2}", first.travel)) } " half-widths travelled" }
            }
            svg.chart.player-chart viewBox={ "0 0 " (WIDTH) " " (height) } role="img" aria-label="Pressure and film at one instant" {
                @for panel in &panels { (panel.frame()) }
                @for (x, label) in &across {
                    @for panel in &panels { line.grid x1=(x) x2=(x) y1=(panel.top) y2=(panel.top + PANEL) {} }
                    text.tick x=(x) y=(height - 30.0) text-anchor="middle" { (label) }
                }
                text x=(0.5 * (LEFT + WIDTH - RIGHT)) y=(height - 8.0) text-anchor="middle" { (self::across().text()) }
                @for k in 0..2 {
                    clipPath id={ "clip-player" (k) } { rect x=(LEFT) y=(panels[k].top) width=(WIDTH - LEFT - RIGHT) height=(PANEL) {} }
                    g clip-path={ "url(#clip-player" (k) ")" } { g."tenths curves" transform="scale(0.1)" {
                        path."curve dashed c1" d=(dashed(k)) {}
                        path."curve c0" data-player={ "curve" (k) }
                            d=(line(&xs, &rows(&panels[k], [&first.pressure, &first.film][k]))) {}
                    } }
                }
            }
        }
        script type="application/json" id="frames" { (PreEscaped(data)) }
        script { (PreEscaped(FRAMES)) }
    }
}
