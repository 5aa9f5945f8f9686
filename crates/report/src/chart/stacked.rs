//! Several charts in one file, one below the other.

use std::fmt::Write as _;

use super::dress::Dress;
use super::frame::{WIDTH, alone};
use super::xy::Chart;

/// Height of the title of the file.
const HEAD: f64 = 34.0;

/// Charts one below the other under a title, as an SVG file.
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
