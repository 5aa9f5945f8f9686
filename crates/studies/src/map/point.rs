//! Data of a map.

use asperity::case::{CaseInput, DefaultUsed};
use asperity::result::Regime;
use asperity_core::message::Warning;
use asperity_core::numerics::NodeInterval;
use asperity_core::{Code, Estimate, number};
use serde::{Deserialize, Serialize};

use super::axes::Axes;
use super::draws::{Beside, Drawn, DrawnNodes};
use super::surface::Surface;
use crate::compare::noun;

/// Mark of points below the smallest torque that the traces resolve.
pub const EXTENDED: &str = "extended";

/// Losses of a mesh over torque, speed and temperature.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Map {
    /// Version of this structure.
    pub schema_version: u32,
    /// Program and version.
    pub program: String,
    /// Title of the case.
    pub title: String,
    /// Scope of the losses: `mesh`, without bearings, seals and churning.
    pub scope: String,
    /// Losses of the gearbox, if the case states them; not included in the points, added to exports.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gearbox: Option<MapGearbox>,
    /// The nodes.
    pub axes: Axes,
    /// Revolutions of the pinion per revolution of the wheel, or of the input shaft per revolution of the output shaft; `None`
    /// of several outputs.
    pub ratio: Option<f64>,
    /// Torque \[N m\] and speed \[1/min\] at which the case states its load.
    pub operating_point: [f64; 2],
    /// Temperature at which the case states its load \[°C\].
    pub operating_temperature_c: f64,
    /// The finishes; the first is the reference of differences.
    pub finishes: Vec<FinishMap>,
    /// Whether they differ by more than their flanks.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub are_variants: bool,
    /// Warnings with their points.
    pub warnings: Vec<MapWarning>,
    /// Warnings about the tables of its exports: the cycle and the added losses.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub table_warnings: Vec<Warning>,
    /// The case as read; each finish has its own traces.
    #[serde(
        serialize_with = "CaseInput::store",
        deserialize_with = "CaseInput::stored"
    )]
    pub input: CaseInput,
    /// All defaults used.
    pub defaults: Vec<DefaultUsed>,
}

/// Losses of the gearbox in addition to the mesh at the points of a map, from the input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapGearbox {
    /// Names of the parts.
    pub parts: Vec<String>,
    /// Their loss torque at the pinion at every point \[N m\], in the order of [`Axes::index`]; at standstill the value
    /// at 1 1/min.
    pub loss_torque_nm: Vec<f64>,
}

/// Losses of a mesh of a gear train at the points of a map.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeshPart {
    /// Name.
    pub name: String,
    /// Number of equal meshes.
    pub count: u32,
    /// Loss torque of all equal meshes at the input shaft \[N m\], in the order of [`Axes::index`]; `None` where the point has
    /// no result.
    pub loss_torque_nm: Vec<Option<f64>>,
}

/// Map of one pair of flanks, or of all flanks of a gear train.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FinishMap {
    /// Name of the finish.
    pub name: String,
    /// SHA-256 of its case, of the content of all files read for it, and of the program version.
    pub fingerprint: String,
    /// Names and SHA-256 of the files that it read.
    pub files: Vec<[String; 2]>,
    /// Names and SHA-256 of the files of the coast flanks, if there are any.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub coast_files: Vec<[String; 2]>,
    /// Loss minus the loss with the first finish at the point of its largest loss: median of the draws with their 5 % and 95 %
    /// quantiles \[W\]; `None` of the first finish, and without draws.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub difference_w: Option<Estimate>,
    /// Smallest torques that the traces resolve, drive and coast \[N m\]; points below are extended.
    pub resolved_from_nm: [f64; 2],
    /// Draws at a few nodes, mesh by mesh, for the drive and, where they are others, the coast flanks; empty for a map without
    /// draws.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub draws: Vec<DrawnNodes>,
    /// The meshes of a gear train; empty for a single mesh.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub meshes: Vec<MeshPart>,
    /// All points, in the order of [`Axes::index`]; written to the table, not to the JSON.
    #[serde(skip)]
    pub points: Vec<Point>,
}

/// Warning with its points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MapWarning {
    /// Code, correlation and input.
    pub text: String,
    /// Name of the finish.
    pub finish: String,
    /// Number of points.
    pub count: usize,
    /// Rows of the finish in the table, counted from 1, such as `1-4,9`.
    pub points: String,
}

/// Point of a map.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Torque at the pinion or input shaft \[N m\].
    pub torque_nm: f64,
    /// Speed of the pinion or input shaft \[1/min\].
    pub speed_rpm: f64,
    /// Temperature of the flanks \[°C\].
    pub temperature_c: f64,
    /// Losses; `None` if the point has no result.
    pub numbers: Option<Numbers>,
    /// Inputs out of range at the point.
    pub outside: Vec<String>,
    /// Error code if there is no result.
    pub code: Option<Code>,
}

/// Losses at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Numbers {
    /// Total loss of all meshes \[W\]: the median of the draws, without draws the loss of a run.
    pub loss_w: f64,
    /// Loss of a run with every constant at its median \[W\]; `None` for a map without draws.
    pub loss_at_medians_w: Option<f64>,
    /// Loss torque at the pinion or input shaft \[N m\]; at standstill the value at 1 1/min.
    pub loss_torque_nm: f64,
    /// Standard deviation of the loss torque over the offsets of the traces \[N m\]; `None` with one offset.
    pub loss_torque_deviation_nm: Option<f64>,
    /// The loss with the 5 % and 95 % quantiles of the draws \[W\]; `None` for a map without draws.
    pub drawn_w: Option<Estimate>,
    /// Efficiency; `None` without power.
    pub efficiency: Option<f64>,
    /// Standard deviation of the efficiency over the offsets.
    pub efficiency_deviation: Option<f64>,
    /// Sliding loss \[W\].
    pub sliding_w: f64,
    /// Part of it in the film \[W\].
    pub film_w: f64,
    /// Part of it in lubricated asperities \[W\].
    pub lubricated_asperity_w: f64,
    /// Part of it in the boundary layer \[W\].
    pub boundary_w: f64,
    /// Rolling loss \[W\].
    pub rolling_w: f64,
    /// Loss by deformation of the flanks \[W\].
    pub deformation_w: f64,
    /// Equivalent friction coefficient; `None` without torque, and of a gear train.
    pub mu_equivalent: Option<f64>,
    /// Share of the path in mixed lubrication, the mean over all meshes.
    pub mixed_share: f64,
}

impl Numbers {
    /// The numbers a `share` of the way towards `other`.
    pub(super) fn towards(&self, other: &Self, share: f64) -> Self {
        let way = |from: f64, to: f64| from + share * (to - from);
        let both = |from: Option<f64>, to: Option<f64>| Some(way(from?, to?));
        Self {
            loss_w: way(self.loss_w, other.loss_w),
            loss_at_medians_w: both(self.loss_at_medians_w, other.loss_at_medians_w),
            loss_torque_nm: way(self.loss_torque_nm, other.loss_torque_nm),
            loss_torque_deviation_nm: both(
                self.loss_torque_deviation_nm,
                other.loss_torque_deviation_nm,
            ),
            // Their place is another one.
            drawn_w: None,
            efficiency: both(self.efficiency, other.efficiency),
            efficiency_deviation: both(self.efficiency_deviation, other.efficiency_deviation),
            sliding_w: way(self.sliding_w, other.sliding_w),
            film_w: way(self.film_w, other.film_w),
            lubricated_asperity_w: way(self.lubricated_asperity_w, other.lubricated_asperity_w),
            boundary_w: way(self.boundary_w, other.boundary_w),
            rolling_w: way(self.rolling_w, other.rolling_w),
            deformation_w: way(self.deformation_w, other.deformation_w),
            mu_equivalent: both(self.mu_equivalent, other.mu_equivalent),
            mixed_share: way(self.mixed_share, other.mixed_share),
        }
    }

    /// The numbers of a run at the median of its draws, whose quantiles are `ratios` of the loss with every constant at its median;
    /// `drives` states whether the power enters at the pinion.
    pub(super) fn at_median(&self, ratios: Estimate, drives: bool) -> Self {
        let ratio = ratios.value;
        // The other gear takes the loss in addition to what leaves at the pinion.
        let efficiency = self.efficiency.map(|before| {
            if drives {
                1.0 - ratio * (1.0 - before)
            } else {
                before / (before + ratio * (1.0 - before))
            }
        });
        let lost = efficiency.zip(self.efficiency);
        let lost = lost.filter(|(_, before)| *before < 1.0);
        let lost = lost.map_or(ratio, |(now, before)| (1.0 - now) / (1.0 - before));
        let times = |number: Option<f64>| number.map(|number| ratio * number);
        Self {
            loss_w: ratio * self.loss_w,
            loss_at_medians_w: Some(self.loss_w),
            loss_torque_nm: ratio * self.loss_torque_nm,
            loss_torque_deviation_nm: times(self.loss_torque_deviation_nm),
            drawn_w: Some(ratios.map(|ratio| ratio * self.loss_w)),
            efficiency: efficiency.filter(|efficiency| *efficiency > 0.0),
            efficiency_deviation: times(self.efficiency_deviation),
            sliding_w: ratio * self.sliding_w,
            film_w: ratio * self.film_w,
            lubricated_asperity_w: ratio * self.lubricated_asperity_w,
            boundary_w: ratio * self.boundary_w,
            rolling_w: ratio * self.rolling_w,
            deformation_w: ratio * self.deformation_w,
            mu_equivalent: self.mu_equivalent.map(|mu| lost * mu),
            mixed_share: self.mixed_share,
        }
    }

    /// Loss of a run with every constant at its median \[W\], drawn or not.
    pub(super) fn at_medians_w(&self) -> f64 {
        self.loss_at_medians_w.unwrap_or(self.loss_w)
    }

    /// Lubrication regime of the mesh.
    #[must_use]
    pub fn regime(&self) -> Regime {
        Regime::of_friction(self.mixed_share, self.boundary_w, self.sliding_w)
    }
}

impl Map {
    /// Heading of the names of its finishes.
    pub(crate) fn noun(&self) -> &'static str {
        noun(!self.are_variants)
    }

    /// Points without a result in words, with the code of the first; `None` if all have one.
    pub(crate) fn holes(&self) -> Option<String> {
        let points = || self.finishes.iter().flat_map(|finish| &finish.points);
        let mut without = points().filter(|point| point.numbers.is_none());
        let first = without.next()?;
        let code = first
            .code
            .map_or(String::new(), |code| format!(" ({code})"));
        Some(format!(
            "{} of {} points of the map have no result, the first at {} N m, {} 1/min and {} °C{code}",
            without.count() + 1,
            points().count(),
            number(first.torque_nm),
            number(first.speed_rpm),
            number(first.temperature_c)
        ))
    }

    /// Error code of the first point under load, if no point under load has a loss.
    #[must_use]
    pub fn refused(&self) -> Option<Code> {
        let points = self.finishes.iter().flat_map(|finish| &finish.points);
        let mut loaded = points.filter(|point| point.torque_nm != 0.0 && point.speed_rpm != 0.0);
        let first = loaded.next()?.code?;
        loaded.all(|point| point.code.is_some()).then_some(first)
    }

    /// Index of the temperature next to the one of the case.
    #[must_use]
    pub fn case_temperature(&self) -> usize {
        let away = |node: &f64| (node - self.operating_temperature_c).abs();
        let nodes = self.axes.temperature_c.iter().enumerate();
        let next = nodes.min_by(|a, b| away(a.1).total_cmp(&away(b.1)));
        next.map_or(0, |(index, _)| index)
    }

    /// The operating point of the case with the losses of `finish`, interpolated between points of the map at the temperature
    /// [`case_temperature`](Self::case_temperature); if one finish has no loss around it, the next point for all.
    pub(super) fn typical(&self, finish: &FinishMap) -> Option<Point> {
        if self.has_typical() {
            finish.between(&self.axes, self.case_temperature(), self.operating_point)
        } else {
            finish.points.get(self.next_to_typical()?).cloned()
        }
    }

    /// Whether the operating point of the case is between points of the map, where all finishes have losses.
    pub(super) fn has_typical(&self) -> bool {
        let mut finishes = self.finishes.iter();
        let temperature = self.case_temperature();
        finishes.all(|finish| {
            finish
                .between(&self.axes, temperature, self.operating_point)
                .is_some()
        })
    }

    /// Index of the point next to the operating point of the case, in parts of the largest torque and speed, that has a loss with
    /// the first finish.
    fn next_to_typical(&self) -> Option<usize> {
        let first = self.finishes.first()?;
        let [torque, speed] = self.operating_point;
        let of = |nodes: &[f64]| {
            nodes
                .iter()
                .fold(f64::MIN_POSITIVE, |most, x| most.max(x.abs()))
        };
        let most = [of(&self.axes.torque_nm), of(&self.axes.speed_rpm)];
        let distance = |point: &Point| {
            let torque = (point.torque_nm - torque) / most[0];
            torque.hypot((point.speed_rpm - speed) / most[1])
        };
        let celsius = self.axes.temperature_c.get(self.case_temperature())?;
        let points = first.points.iter().enumerate();
        let known =
            points.filter(|(_, point)| point.numbers.is_some() && point.temperature_c == *celsius);
        let nearest = known.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        nearest.map(|(at, _)| at)
    }

    /// Shafts at which power enters and leaves, in words.
    pub(crate) fn shafts(&self) -> [&'static str; 2] {
        if self.finishes.iter().all(|finish| finish.meshes.is_empty()) {
            ["pinion", "wheel"]
        } else {
            ["input shaft", "output"]
        }
    }
}

impl FinishMap {
    /// Loss torque over torque and speed at one temperature node; `None` if a point has no result.
    #[must_use]
    pub fn surface(&self, axes: &Axes, temperature: usize) -> Option<Surface> {
        let value = |of: &dyn Fn(&Numbers) -> f64| -> Option<Vec<f64>> {
            let nodes = axes.torque_nm.len() * axes.speed_rpm.len();
            let first = axes.index(temperature, 0, 0);
            let points = self.points.get(first..first + nodes)?;
            let numbers = points.iter().map(|point| Some(of(point.numbers.as_ref()?)));
            numbers.collect()
        };
        Some(Surface {
            torque_nm: axes.torque_nm.clone(),
            speed_rpm: axes.speed_rpm.clone(),
            loss_torque_nm: value(&|numbers| numbers.loss_torque_nm)?,
        })
    }

    /// Losses at a torque \[N m\] and a speed \[1/min\] within the points of a temperature, with their quantiles; `None` if a point
    /// around has no losses.
    fn between(
        &self,
        axes: &Axes,
        temperature: usize,
        [torque_nm, speed_rpm]: [f64; 2],
    ) -> Option<Point> {
        let interval = |nodes: &[f64], at: f64| {
            let is_within = nodes.first()? <= &at && &at <= nodes.last()?;
            is_within.then(|| NodeInterval::from_nodes(nodes, |node| *node, at).held())
        };
        let torque = interval(&axes.torque_nm, torque_nm)?;
        let speed = interval(&axes.speed_rpm, speed_rpm)?;
        let at = |i: usize| {
            let of = |j: usize| self.points.get(axes.index(temperature, i, j))?.numbers;
            Some(of(speed.low)?.towards(&of(speed.high)?, speed.part))
        };
        let mut numbers = at(torque.low)?.towards(&at(torque.high)?, torque.part);
        // As in a cycle, the loss torque is linear between the points.
        numbers.loss_w = numbers.loss_torque_nm * speed_rpm * std::f64::consts::PI / 30.0;
        let temperature_c = *axes.temperature_c.get(temperature)?;
        if let Some(drawn) = self.drawn(Beside::Nothing, 1.0) {
            let ratios = drawn.quantiles(drawn.place(torque_nm, speed_rpm, temperature_c));
            let at_medians = numbers.loss_w / ratios.value;
            numbers.loss_at_medians_w = Some(at_medians);
            numbers.drawn_w = Some(Estimate {
                value: numbers.loss_w,
                ..ratios.map(|ratio| ratio * at_medians)
            });
        }
        Some(Point {
            torque_nm,
            speed_rpm,
            temperature_c,
            numbers: Some(numbers),
            outside: Vec::new(),
            code: None,
        })
    }

    /// Index of the point with the largest loss, and its losses.
    pub(super) fn largest(&self) -> Option<(usize, Numbers)> {
        let points = self.points.iter().enumerate();
        let numbers = points.filter_map(|(at, point)| Some((at, point.numbers?)));
        numbers.max_by(|a, b| a.1.loss_w.total_cmp(&b.1.loss_w))
    }

    /// The draws, in common with those of the finish `beside`, and the standard error of the sampling multiplied by `sampling`. `None`
    /// for a map without draws.
    #[must_use]
    pub(crate) fn drawn(&self, beside: Beside<'_>, sampling: f64) -> Option<Drawn<'_>> {
        Drawn::new(&self.draws, self.meshes.len().max(1), beside, sampling)
    }
}

impl Point {
    /// Whether the losses are scaled from another torque.
    #[must_use]
    pub fn is_extended(&self) -> bool {
        self.outside.iter().any(|mark| mark == EXTENDED)
    }
}

/// Numbers counted from 1 as ranges, `1-4,9`; `at` holds ascending indices counted from 0.
///
/// ```
/// assert_eq!(asperity_studies::map::ranges(&[0, 1, 2, 3, 8]), "1-4,9");
/// ```
#[must_use]
pub fn ranges(at: &[usize]) -> String {
    let mut runs: Vec<[usize; 2]> = Vec::new();
    for &index in at {
        match runs.last_mut() {
            Some(run) if run[1] + 1 == index => run[1] = index,
            _ => runs.push([index, index]),
        }
    }
    let text = runs.iter().map(|&[from, to]| {
        if from == to {
            format!("{}", from + 1)
        } else {
            format!("{}-{}", from + 1, to + 1)
        }
    });
    text.collect::<Vec<_>>().join(",")
}
