//! Table of a map with one row per point.

use asperity_core::{Code, Estimate, Fault};
use std::borrow::Cow;
use std::path::Path;

use asperity_report::tables;
use serde::{Deserialize, Serialize};

use super::point::{FinishMap, Map, Numbers, Point};

/// Row of a point.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct MapPointRow<'a> {
    torque_nm: f64,
    speed_rpm: f64,
    temperature_c: f64,
    loss_w: Option<f64>,
    loss_p05_w: Option<f64>,
    loss_p95_w: Option<f64>,
    loss_at_medians_w: Option<f64>,
    loss_torque_nm: Option<f64>,
    efficiency: Option<f64>,
    efficiency_deviation: Option<f64>,
    sliding_w: Option<f64>,
    rolling_w: Option<f64>,
    mu_equivalent: Option<f64>,
    mixed_share: Option<f64>,
    outside: Cow<'a, str>,
    code: Option<Code>,
    loss_torque_deviation_nm: Option<f64>,
    film_w: Option<f64>,
    lubricated_asperity_w: Option<f64>,
    boundary_w: Option<f64>,
    finish: Cow<'a, str>,
    deformation_w: Option<f64>,
    regime: Cow<'a, str>,
}

/// Separator between the marks of a point.
const SEPARATOR: &str = "; ";

impl<'a> MapPointRow<'a> {
    fn new(finish: &'a FinishMap, point: &'a Point) -> Self {
        let numbers = point.numbers.as_ref();
        let of = |value: fn(&Numbers) -> f64| numbers.map(value);
        let drawn = numbers.and_then(|numbers| numbers.drawn_w);
        Self {
            torque_nm: point.torque_nm,
            speed_rpm: point.speed_rpm,
            temperature_c: point.temperature_c,
            loss_w: of(|n| n.loss_w),
            loss_p05_w: drawn.map(|drawn| drawn.low),
            loss_p95_w: drawn.map(|drawn| drawn.high),
            loss_at_medians_w: numbers.and_then(|numbers| numbers.loss_at_medians_w),
            loss_torque_nm: of(|n| n.loss_torque_nm),
            efficiency: numbers.and_then(|n| n.efficiency),
            efficiency_deviation: numbers.and_then(|n| n.efficiency_deviation),
            sliding_w: of(|n| n.sliding_w),
            rolling_w: of(|n| n.rolling_w),
            mu_equivalent: numbers.and_then(|n| n.mu_equivalent),
            mixed_share: of(|n| n.mixed_share),
            outside: Cow::Owned(point.outside.join(SEPARATOR)),
            code: point.code,
            loss_torque_deviation_nm: numbers.and_then(|n| n.loss_torque_deviation_nm),
            film_w: of(|n| n.film_w),
            lubricated_asperity_w: of(|n| n.lubricated_asperity_w),
            boundary_w: of(|n| n.boundary_w),
            finish: Cow::Borrowed(&finish.name),
            deformation_w: of(|n| n.deformation_w),
            regime: numbers.map_or("", |n| n.regime().name()).into(),
        }
    }

    /// The point; `None` if its row is incomplete.
    pub(super) fn point(self) -> Option<Point> {
        let drawn = || {
            Some(Estimate {
                value: self.loss_w?,
                low: self.loss_p05_w?,
                high: self.loss_p95_w?,
            })
        };
        let numbers = || {
            Some(Numbers {
                loss_w: self.loss_w?,
                loss_at_medians_w: self.loss_at_medians_w,
                loss_torque_nm: self.loss_torque_nm?,
                loss_torque_deviation_nm: self.loss_torque_deviation_nm,
                drawn_w: drawn(),
                efficiency: self.efficiency,
                efficiency_deviation: self.efficiency_deviation,
                sliding_w: self.sliding_w?,
                film_w: self.film_w?,
                lubricated_asperity_w: self.lubricated_asperity_w?,
                boundary_w: self.boundary_w?,
                rolling_w: self.rolling_w?,
                deformation_w: self.deformation_w?,
                mu_equivalent: self.mu_equivalent,
                mixed_share: self.mixed_share?,
            })
        };
        let code = self.code;
        let numbers = numbers();
        let marks = self
            .outside
            .split(SEPARATOR)
            .filter(|mark| !mark.is_empty());
        (numbers.is_some() != code.is_some()).then(|| Point {
            torque_nm: self.torque_nm,
            speed_rpm: self.speed_rpm,
            temperature_c: self.temperature_c,
            numbers,
            outside: marks.map(str::to_owned).collect(),
            code,
        })
    }
}

/// Writes all points of all finishes.
pub(super) fn write(map: &Map, file: &Path) -> Result<(), Fault> {
    let rows = map.finishes.iter().flat_map(|finish| {
        let points = finish.points.iter();
        points.map(move |point| MapPointRow::new(finish, point))
    });
    tables::write(file, rows)
}
