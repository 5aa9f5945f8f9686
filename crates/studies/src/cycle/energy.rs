//! Energies of a cycle on a map.

use asperity_core::{Code, Estimate, Fault};
use std::f64::consts::PI;
use std::sync::Arc;

use asperity::balance::{efficiency, sum};
use asperity::message::Warning;
use asperity::uncertainty::{differences, median_with_ends};
use serde::Serialize;

use super::coverage::{Coverage, moving_time, share};
use super::draws::{CycleDraws, WATT_HOUR};
use super::trace::{Cycle, CyclePoint};
use crate::map::{Beside, FinishMap, Map, Surface};

/// Energies of a cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CycleResult {
    /// Program and version.
    pub program: String,
    /// Title of the map's case.
    pub title: String,
    /// Name of the cycle.
    pub cycle: String,
    /// Scope of the losses: `mesh`.
    pub scope: String,
    /// Losses in addition to the mesh that the case of the map states; not included in any number here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_aside: Vec<String>,
    /// Temperature of the flanks \[°C\].
    pub temperature_c: f64,
    /// Duration \[s\].
    pub duration_s: f64,
    /// Distance driven \[km\]; `None` without a vehicle.
    pub distance_km: Option<f64>,
    /// Energy at the pinion while it drives \[Wh\].
    pub drive_wh: f64,
    /// Energy at the pinion while the wheel drives \[Wh\].
    pub coast_wh: f64,
    /// Share of the energy at the pinion, driving and braking, outside of the map, where the ratio of loss to torque is constant.
    pub outside_energy_share: f64,
    /// Share of the moving time outside of the map.
    pub outside_share: f64,
    /// Share of the moving time at torques whose sliding loss is scaled from the smallest resolved torque.
    pub extended_share: f64,
    /// Unusual numbers of the vehicle.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<Warning>,
    /// The finishes; the first is the reference of differences.
    pub finishes: Vec<CycleFinish>,
    /// Points of the cycle, for table and chart.
    #[serde(skip)]
    pub points: Vec<CyclePoint>,
    /// Map on which the cycle was evaluated.
    #[serde(skip)]
    pub map: Arc<Map>,
}

/// Energy loss with one finish.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CycleFinish {
    /// Name.
    pub name: String,
    /// Energy lost \[Wh\]: the median of the draws, to which its parts are scaled.
    pub lost_wh: f64,
    /// 5 % and 95 % quantiles of the drawn energies \[Wh\]; `None` on a map without draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost_quantiles_wh: Option<[f64; 2]>,
    /// Energy lost with every constant at its median \[Wh\]; `None` on a map without draws.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lost_at_medians_wh: Option<f64>,
    /// Part of it while the pinion drives \[Wh\].
    pub lost_drive_wh: f64,
    /// Part of it while the wheel drives \[Wh\], and at no torque.
    pub lost_coast_wh: f64,
    /// Energy lost relative to the energy at the pinion while it drives.
    pub share_of_drive: Option<f64>,
    /// Efficiency of the mesh while the pinion drives, weighted by the cycle.
    pub drive_efficiency: Option<f64>,
    /// Energy lost per 100 km \[Wh\].
    pub wh_per_100_km: Option<f64>,
    /// Energy lost minus the energy lost with the first finish \[Wh\], the median over the draws; `None` for the first.
    pub difference_wh: Option<f64>,
    /// 5 % and 95 % quantiles of the difference over the draws \[Wh\].
    #[serde(skip_serializing_if = "Option::is_none")]
    pub difference_quantiles_wh: Option<[f64; 2]>,
    /// Loss at each point \[W\].
    #[serde(skip)]
    pub loss_w: Vec<f64>,
    /// Median with 5 % and 95 % quantiles of the loss at each point \[W\]; empty on a map without draws.
    #[serde(skip)]
    pub drawn_w: Vec<Estimate>,
}

impl CycleFinish {
    /// The energy lost with its quantiles \[Wh\]; `None` on a map without draws.
    #[must_use]
    pub fn lost_drawn_wh(&self) -> Option<Estimate> {
        let ends = self.lost_quantiles_wh?;
        Some(Estimate::new(self.lost_wh, ends))
    }

    /// The difference with its quantiles \[Wh\]; `None` for the first finish, and on a map without draws.
    #[must_use]
    pub fn difference_drawn_wh(&self) -> Option<Estimate> {
        let ends = self.difference_quantiles_wh?;
        Some(Estimate::new(self.difference_wh?, ends))
    }

    /// States the energy as drawn, with its parts in proportion.
    fn put_draws(&mut self, draws: &CycleDraws<'_>, energies: &[f64]) {
        let drawn = median_with_ends(energies);
        let factor = if self.lost_wh > 0.0 {
            drawn.value / self.lost_wh
        } else {
            1.0
        };
        for part in [&mut self.lost_drive_wh, &mut self.lost_coast_wh] {
            *part *= factor;
        }
        self.lost_wh = drawn.value;
        self.lost_quantiles_wh = Some(drawn.ends());
        self.lost_at_medians_wh = Some(draws.at_medians_wh());
        self.drawn_w = draws.losses_w();
    }
}

/// The map has no finish, not the temperature, or points without a result.
fn holes(map: &Map) -> Fault {
    let message = map
        .holes()
        .unwrap_or_else(|| "the map has no points at this temperature".to_owned());
    let help = "Make the map again with axes that leave out these points, or with a model that has a result there: asperity explain names \
        the cause of a code.";
    Fault::new(Code::E402, message).helping(help)
}

/// Computes the energies of `cycle` on `map` at one of its temperatures. `takes_any` permits any share outside of the map.
///
/// # Errors
/// When a point of the map has no result, too much of the cycle is outside of the map, or the energies do not add up.
pub fn evaluate(
    map: &Arc<Map>,
    temperature: usize,
    cycle: &Cycle,
    name: &str,
    takes_any: bool,
) -> Result<CycleResult, Fault> {
    let energy = |is_meant: &dyn Fn(f64) -> bool| {
        let of = cycle
            .points
            .iter()
            .filter(|point| is_meant(point.power_w()));
        of.map(|point| point.power_w().abs() * point.weight_s)
            .sum::<f64>()
            / WATT_HOUR
    };
    let (drive_wh, coast_wh) = (energy(&|power| power > 0.0), energy(&|power| power < 0.0));
    let mut finishes: Vec<CycleFinish> = Vec::new();
    let surfaces = map.finishes.iter();
    let surfaces = surfaces.map(|finish| finish.surface(&map.axes, temperature));
    let surfaces: Vec<Surface> = surfaces.collect::<Option<_>>().ok_or_else(|| holes(map))?;
    // All finishes have the same nodes.
    let first = surfaces.first().ok_or_else(|| holes(map))?;
    let coverage = Coverage::new(first, cycle);
    if !takes_any {
        coverage.check()?;
    }
    let celsius = map.axes.temperature_c[temperature];
    let mut of_first: Option<CycleDraws<'_>> = None;
    for (finish, surface) in map.finishes.iter().zip(&surfaces) {
        let mut result = of_finish(finish, surface, cycle);
        let draws = CycleDraws::new(finish, celsius, cycle, &result.loss_w);
        let deltas = of_first.as_ref().and_then(|first| {
            let own = draws.as_ref()?.energies_wh(Beside::First)?;
            let first = first.energies_wh(Beside::Other(&finish.draws))?;
            Some(differences([&first, &own]))
        });
        if let Some(draws) = draws
            && let Some(energies) = draws.energies_wh(Beside::Nothing)
        {
            result.put_draws(&draws, &energies);
            of_first.get_or_insert(draws);
        }
        result.share_of_drive = (drive_wh > 0.0).then(|| result.lost_wh / drive_wh);
        result.drive_efficiency = (drive_wh > 0.0).then(|| 1.0 - result.lost_drive_wh / drive_wh);
        result.wh_per_100_km = cycle
            .distance_km
            .filter(|km| *km > 0.0)
            .map(|km| result.lost_wh * 100.0 / km);
        let drawn = deltas.as_deref().map(median_with_ends);
        let of_medians = finishes.first().map(|first| result.lost_wh - first.lost_wh);
        result.difference_wh = drawn.map(|drawn| drawn.value).or(of_medians);
        result.difference_quantiles_wh = drawn.map(Estimate::ends);
        check(&result, drive_wh)?;
        finishes.push(result);
    }
    let time = |point: Option<&CyclePoint>| point.map_or(0.0, |point| point.time_s);
    Ok(CycleResult {
        program: map.program.clone(),
        title: map.title.clone(),
        cycle: name.to_owned(),
        scope: map.scope.clone(),
        left_aside: map
            .gearbox
            .as_ref()
            .map_or_else(Vec::new, |gearbox| gearbox.parts.clone()),
        temperature_c: celsius,
        duration_s: time(cycle.points.last()) - time(cycle.points.first()),
        distance_km: cycle.distance_km,
        drive_wh,
        coast_wh,
        outside_energy_share: coverage.outside_energy,
        outside_share: coverage.outside_time,
        extended_share: map.finishes.first().map_or(0.0, |finish| {
            let [drive, coast] = finish.resolved_from_nm;
            let is_extended = |point: &CyclePoint| (-coast..drive).contains(&point.forwards()[0]);
            share(cycle, &moving_time, &is_extended)
        }),
        warnings: cycle.warnings.clone(),
        finishes,
        points: cycle.points.clone(),
        map: Arc::clone(map),
    })
}

/// Invariants of the energies of a finish.
fn check(finish: &CycleFinish, drive_wh: f64) -> Result<(), Fault> {
    let parts = [finish.lost_drive_wh, finish.lost_coast_wh];
    sum("energy lost over the cycle", "Wh", finish.lost_wh, &parts)?;
    let of = "efficiency while the pinion drives";
    finish.drive_efficiency.map_or(Ok(()), |value| {
        efficiency(of, value, finish.lost_drive_wh, drive_wh)
    })
}

/// Energies of a finish.
fn of_finish(finish: &FinishMap, surface: &Surface, cycle: &Cycle) -> CycleFinish {
    let mut lost = [0.0; 2];
    let mut loss_w = Vec::with_capacity(cycle.points.len());
    for point in &cycle.points {
        let loss = surface.loss_torque(point.torque_nm, point.speed_rpm);
        let omega = point.speed_rpm.abs() * PI / 30.0;
        let energy = loss.value * omega * point.weight_s / WATT_HOUR;
        lost[usize::from(point.forwards()[0] <= 0.0)] += energy;
        loss_w.push(loss.value * omega);
    }
    CycleFinish {
        name: finish.name.clone(),
        lost_wh: lost[0] + lost[1],
        lost_quantiles_wh: None,
        lost_at_medians_wh: None,
        lost_drive_wh: lost[0],
        lost_coast_wh: lost[1],
        share_of_drive: None,
        drive_efficiency: None,
        wh_per_100_km: None,
        difference_wh: None,
        difference_quantiles_wh: None,
        loss_w,
        drawn_w: Vec::new(),
    }
}
