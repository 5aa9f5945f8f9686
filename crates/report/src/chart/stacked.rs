//! Several charts below each other as one file.

use std::fmt::Write as _;

use super::dress::Dress;
use super::frame::{WIDTH, alone};
use super::xy::Chart;

/// Room for the title of the file.
const HEAD: f64 = 34.0;

/// Charts below each other under a title, as an SVG file of its own.
pub fn stacked(title: &str, charts: &[Chart]) -> String {
    let mut body = String::new();
    let mut top = HEAD;
    for chart in charts {
        let svg = chart.svg(Dress::Alone);
        let height = chart.height_alone();
        let place = format!("<svg y=\"{top:.0}\" width=\"{WIDTH}\" height=\"{height:.0}\" ");
        let _ = write!(body, "{}", svg.replacen("<svg ", &place, 1));
        top += height;
    }
    alone("", title, top, &body)
}
