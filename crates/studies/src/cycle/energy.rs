//! Energies of a cycle on a map.

use std::f64::consts::PI;

use asperity::balance::{Unbalanced, efficiency, finite, sum};
use serde::Serialize;

use super::coverage::{Coverage, Uncovered, moving_time, share};
use super::trace::{Cycle, CyclePoint};
use crate::map::{FinishMap, Map, Surface};

/// Energies of a cycle.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CycleResult {
    /// The program and its version.
    pub program: String,
    /// Title of the map's case.
    pub title: String,
    /// Name of the cycle.
    pub cycle: String,
    /// What loses: `mesh`.
    pub scope: String,
    /// Parts that the case of the map states beside the mesh, and that are in no number here.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub left_aside: Vec<String>,
    /// Temperature of the flanks \[°C\].
    pub temperature_c: f64,
    /// Duration \[s\].
    pub duration_s: f64,
    /// Way driven \[km\]; none where no vehicle tells.
    pub distance_km: Option<f64>,
    /// Energy at the pinion while it drives \[Wh\].
    pub drive_wh: f64,
    /// Energy at the pinion while the wheel drives \[Wh\].
    pub coast_wh: f64,
    /// Share of the energy at the pinion, driving and braking, outside the map, where loss over torque is held.
    pub outside_energy_share: f64,
    /// Share of the moving time outside the map.
    pub outside_share: f64,
    /// Share of the moving time at torques whose sliding loss is scaled from the smallest resolved torque.
    pub extended_share: f64,
    /// The finishes, the first one the reference of differences.
    pub finishes: Vec<CycleFinish>,
    /// The points, for table and plot.
    #[serde(skip)]
    pub points: Vec<CyclePoint>,
}

/// Energy lost with one finish.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CycleFinish {
    /// Its name.
    pub name: String,
    /// Energy lost \[Wh\].
    pub lost_wh: f64,
    /// Its standard deviation over the offsets of the traces \[Wh\]: all points deviate together.
    pub deviation_wh: f64,
    /// Part of it while the pinion drives \[Wh\].
    pub lost_drive_wh: f64,
    /// Part of it while the wheel drives \[Wh\], and at no torque.
    pub lost_coast_wh: f64,
    /// Energy lost over that at the pinion while it drives.
    pub share_of_drive: Option<f64>,
    /// Efficiency of the mesh while the pinion drives, weighted by the cycle.
    pub drive_efficiency: Option<f64>,
    /// Energy lost on 100 km \[Wh\].
    pub wh_per_100_km: Option<f64>,
    /// Energy lost minus that of the first finish \[Wh\]; none for the first.
    pub difference_wh: Option<f64>,
    /// Its standard deviation, both finishes being independent \[Wh\].
    pub difference_deviation_wh: Option<f64>,
    /// Loss at each point \[W\].
    #[serde(skip)]
    pub loss_w: Vec<f64>,
}

/// Joules of a watt-hour.
const WATT_HOUR: f64 = 3600.0;

/// Why a cycle has no energies on a map.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum EnergyError {
    /// The map has no finish, no such temperature, or points without a result.
    #[error("points of the map have no result")]
    Holes,
    /// Too much of the cycle is outside of the map.
    #[error(transparent)]
    Uncovered(#[from] Uncovered),
    /// Energies that cannot be.
    #[error(transparent)]
    Unbalanced(#[from] Unbalanced),
}

/// Energies of `cycle` on `map` at one of its temperatures; `takes_any` accepts any share of it outside the map.
///
/// # Errors
/// When a point of the map has no result, too much of the cycle is outside of the map, or the energies do not add up.
pub fn evaluate(
    map: &Map,
    temperature: usize,
    (cycle, name): (&Cycle, &str),
    takes_any: bool,
) -> Result<CycleResult, EnergyError> {
    let omega = |point: &CyclePoint| point.speed_rpm.abs() * PI / 30.0;
    let power = |point: &CyclePoint| point.torque_nm * omega(point);
    let energy = |is_meant: &dyn Fn(f64) -> bool| {
        let of = cycle.points.iter().filter(|point| is_meant(power(point)));
        of.map(|point| power(point).abs() * point.weight_s)
            .sum::<f64>()
            / WATT_HOUR
    };
    let (drive_wh, coast_wh) = (energy(&|power| power > 0.0), energy(&|power| power < 0.0));
    let mut finishes: Vec<CycleFinish> = Vec::new();
    let surfaces = map.finishes.iter();
    let surfaces = surfaces.map(|finish| finish.surface(&map.axes, temperature));
    let surfaces: Vec<Surface> = surfaces.collect::<Option<_>>().ok_or(EnergyError::Holes)?;
    // The nodes are those of every finish.
    let first = surfaces.first().ok_or(EnergyError::Holes)?;
    let coverage = Coverage::of(first, cycle);
    if !takes_any {
        coverage.check()?;
    }
    for (finish, surface) in map.finishes.iter().zip(&surfaces) {
        let mut found = of_finish(finish, surface, cycle);
        found.share_of_drive = (drive_wh > 0.0).then(|| found.lost_wh / drive_wh);
        found.drive_efficiency = (drive_wh > 0.0).then(|| 1.0 - found.lost_drive_wh / drive_wh);
        found.wh_per_100_km = cycle
            .distance_km
            .filter(|km| *km > 0.0)
            .map(|km| found.lost_wh * 100.0 / km);
        if let Some(first) = finishes.first() {
            found.difference_wh = Some(found.lost_wh - first.lost_wh);
            found.difference_deviation_wh = Some(found.deviation_wh.hypot(first.deviation_wh));
        }
        check(&found, drive_wh)?;
        finishes.push(found);
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
        temperature_c: map.axes.temperature_c[temperature],
        duration_s: time(cycle.points.last()) - time(cycle.points.first()),
        distance_km: cycle.distance_km,
        drive_wh,
        coast_wh,
        outside_energy_share: coverage.outside_energy,
        outside_share: coverage.outside_time,
        extended_share: map.finishes.first().map_or(0.0, |finish| {
            let [drive, coast] = finish.resolved_from_nm;
            let is_extended = |point: &CyclePoint| (-coast..drive).contains(&point.torque_nm);
            share(cycle, &moving_time, &is_extended)
        }),
        finishes,
        points: cycle.points.clone(),
    })
}

/// Invariants of the energies of a finish.
fn check(finish: &CycleFinish, drive_wh: f64) -> Result<(), Unbalanced> {
    let parts = [finish.lost_drive_wh, finish.lost_coast_wh];
    sum("energy lost over the cycle", "Wh", finish.lost_wh, &parts)?;
    finite("deviation of the energy lost", "Wh", finish.deviation_wh)?;
    let of = "efficiency while the pinion drives";
    finish.drive_efficiency.map_or(Ok(()), |value| {
        efficiency(of, value, finish.lost_drive_wh, drive_wh)
    })
}

/// The energies of a finish.
fn of_finish(finish: &FinishMap, surface: &Surface, cycle: &Cycle) -> CycleFinish {
    let mut lost = [0.0; 2];
    let mut deviation = 0.0;
    let mut loss_w = Vec::with_capacity(cycle.points.len());
    for point in &cycle.points {
        let found = surface.loss_torque(point.torque_nm, point.speed_rpm);
        let omega = point.speed_rpm.abs() * PI / 30.0;
        let energy = found.value * omega * point.weight_s / WATT_HOUR;
        lost[usize::from(point.torque_nm <= 0.0)] += energy;
        deviation += found.deviation * omega * point.weight_s / WATT_HOUR;
        loss_w.push(found.value * omega);
    }
    CycleFinish {
        name: finish.name.clone(),
        lost_wh: lost[0] + lost[1],
        deviation_wh: deviation,
        lost_drive_wh: lost[0],
        lost_coast_wh: lost[1],
        share_of_drive: None,
        drive_efficiency: None,
        wh_per_100_km: None,
        difference_wh: None,
        difference_deviation_wh: None,
        loss_w,
    }
}
