//! Computation of a map.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::balance::{self, sum};
use asperity::case::train::{LoadedMesh, Train};
use asperity::case::{LoadedCase, MeshLoad};
use asperity::core::cancel::checkpoint;
use asperity::fingerprint::Fingerprint;
use asperity::pipeline::Progress;
use asperity::result::OffsetRow;
use asperity::result::SCHEMA_VERSION;
use asperity::uncertainty::{DrawnCase, Predictive, common_draws, differences, median_with_ends};
use asperity::{Error, PositionError, Run};
use asperity_core::numerics::{deviation, distinct};
use asperity_core::quantity::{AngularSpeed, Power};
use asperity_core::task::par_map;
use asperity_core::unique;
use asperity_core::{Code, Estimate, Fault, PROGRAM};

use super::axes::Axes;
use super::draws::{Beside, Drawn, DrawnNodes, MapBand, Nodes};
use super::evaluation::{
    EvaluatedMesh, EvaluatedPoint, FlanksOfTorques, at_torque, computed_speed, computed_speeds,
    evaluate, gearbox_of, resolved_from, torque_of,
};
use super::point::{EXTENDED, FinishMap, Map, MapWarning, MeshPart, Numbers, Point, ranges};
use crate::compare::{Finish, differs_by_flanks, files};

/// Computes the losses of every finish at every node of `axes`, with draws at the points of `band`. A point without a
/// result has its error code.
///
/// # Errors
/// When there is no finish, or none of its points has a result.
pub fn map<C: Clone + Into<Train>>(
    finishes: &[Finish<C>],
    axes: &Axes,
    band: MapBand,
    progress: Progress<'_>,
) -> Result<Map, Error> {
    let trains = finishes.iter().map(|finish| Finish {
        name: finish.name.clone(),
        case: finish.case.clone().into(),
    });
    let finishes: &[Finish<Train>] = &trains.collect::<Vec<_>>();
    let Some(Finish { case, .. }) = finishes.first() else {
        return Err(Error::Whole(Box::new(PositionError::no_profile())));
    };
    // A table that does not cover the map is an error before the computation.
    let mut gearbox = gearbox_of(case, axes, &[])?;
    let mut maps: Vec<FinishMap> = Vec::with_capacity(finishes.len());
    let sides = finishes
        .iter()
        .map(|finish| Sides::new(&finish.case, axes))
        .collect::<Result<Vec<_>, _>>()?;
    let speeds = computed_speeds(axes);
    let each = speeds.len() * axes.temperature_c.len();
    let total: usize = sides.iter().map(|sides| sides.torques().len() * each).sum();
    let done = AtomicUsize::new(0);
    let progress = || progress(1 + done.fetch_add(1, Ordering::Relaxed), total);
    for (finish, sides) in finishes.iter().zip(&sides) {
        maps.push(of_finish(finish, sides, axes, &speeds, band, &progress)?);
    }
    if let Some((first, others)) = maps.split_first_mut() {
        for (finish, own) in others.iter_mut().zip(&finishes[1..]) {
            put_common(finish, &own.case, first, case);
            let largest = finish.largest().map(|(at, _)| at);
            finish.difference_w = largest.and_then(|at| {
                let of_first = first.points.get(at)?;
                difference((first, of_first), (finish, finish.points.get(at)?))
            });
        }
    }
    if let (Some(first), true) = (maps.first(), case.shafting.passes_losses) {
        gearbox = gearbox_of(case, axes, &first.meshes)?;
    }
    let operation = case.shafting.operation();
    Ok(Map {
        schema_version: SCHEMA_VERSION,
        program: PROGRAM.to_owned(),
        title: case.title.clone(),
        scope: match case.only() {
            Some(_) => "mesh".to_owned(),
            None => "meshes".to_owned(),
        },
        gearbox,
        axes: axes.clone(),
        ratio: case.ratio(),
        operating_point: [
            operation.torque.si(),
            operation.speed.si() * 30.0 / std::f64::consts::PI,
        ],
        operating_temperature_c: Axes::case_temperature(case),
        warnings: maps.iter().flat_map(warnings).collect(),
        table_warnings: Vec::new(),
        finishes: maps,
        are_variants: !finishes
            .iter()
            .all(|finish| differs_by_flanks(case, &finish.case)),
        input: case.input.clone(),
        defaults: case.defaults.clone(),
    })
}

/// States the draws that each mesh of a finish has in common with the first finish.
fn put_common(finish: &mut FinishMap, case: &Train, first: &FinishMap, of_first: &Train) {
    // The correlations follow from the nodes of largest torque and speed.
    let drawn = |train: &Train, draws: &[DrawnNodes]| {
        let cases: Vec<LoadedCase> = train.cases().cloned().collect();
        let nodes = draws.iter().take(cases.len());
        let last: Vec<Predictive> = nodes
            .filter_map(|mesh| mesh.predictive.last().cloned())
            .collect();
        (cases, last)
    };
    let [first, own] = [
        (of_first, first.draws.as_slice()),
        (case, finish.draws.as_slice()),
    ]
    .map(|(train, draws)| drawn(train, draws));
    if own.0.len() != own.1.len() || first.0.len() != first.1.len() {
        return;
    }
    fn both(of: &(Vec<LoadedCase>, Vec<Predictive>)) -> Vec<DrawnCase<'_>> {
        of.0.iter().zip(&of.1).collect()
    }
    let flanks = of_first.first_with_flanks();
    let [first, own] = common_draws(&both(&first), &flanks, &both(&own));
    for (k, mesh) in finish.draws.iter_mut().enumerate() {
        mesh.common = Some([first[k % first.len()], own[k % own.len()]]);
    }
}

/// Loss with a finish minus the loss with the first, each at its point, over the draws that both share; `None` without draws.
pub(super) fn difference(
    first: (&FinishMap, &Point),
    finish: (&FinishMap, &Point),
) -> Option<Estimate> {
    let drawn = |(of, point): (&FinishMap, &Point), beside: Beside<'_>| {
        let Point {
            torque_nm,
            speed_rpm,
            temperature_c,
            numbers,
            ..
        } = point;
        let loss = numbers.as_ref()?.at_medians_w();
        let drawn = of.drawn(beside, 1.0)?;
        let ratios = drawn.ratios(drawn.place(*torque_nm, *speed_rpm, *temperature_c));
        let losses = ratios.into_iter().map(|ratio| loss * ratio);
        Some(losses.collect::<Vec<f64>>())
    };
    let own = drawn(finish, Beside::First)?;
    let of_first = drawn(first, Beside::Other(&finish.0.draws))?;
    Some(median_with_ends(&differences([&of_first, &own])))
}

/// Torque at the pinion of `mesh` over the torque of the input shaft, in the sign of the flanks.
fn torque_ratio(train: &Train, mesh: &LoadedMesh) -> f64 {
    mesh.case.case.torque.si() / train.shafting.operation().torque.si()
}

/// The torques of the input shaft at which a finish is computed \[N m\].
struct Sides {
    /// Smallest torques that the traces of all meshes resolve, drive and coast.
    from: [f64; 2],
    /// Whether a mesh has separate coast flanks.
    has_coast: bool,
    /// Whether negative torques are computed: the meshes have other flanks then, or other torques by the losses passed on.
    differ: bool,
    torques: [Vec<f64>; 2],
}

impl Sides {
    fn new(train: &Train, axes: &Axes) -> Result<Self, Error> {
        let has_coast = |mesh: &LoadedMesh| mesh.case.case.input.surface.coast.is_some();
        let has_coast = train.meshes().any(has_coast);
        // The mesh whose traces resolve least is decisive.
        let resolved = |sign: f64| {
            train.meshes().try_fold(0.0, |most: f64, mesh| {
                let ratio = torque_ratio(train, mesh);
                let from = resolved_from(&mesh.case, sign * ratio.signum())?;
                Ok::<_, Error>(most.max(from / ratio.abs()))
            })
        };
        let drive = resolved(1.0)?;
        let coast = if has_coast { resolved(-1.0)? } else { drive };
        let differ = has_coast || train.shafting.passes_losses;
        let from = [drive, coast];
        let mut torques = [Vec::new(), Vec::new()];
        for &torque in &axes.torque_nm {
            let side = usize::from(differ && torque < 0.0);
            torques[side].push(torque.abs().max(from[side]));
        }
        Ok(Self {
            from,
            has_coast,
            differ,
            torques: torques.map(distinct),
        })
    }

    /// Side and torque of all contacts that are solved.
    fn torques(&self) -> Vec<(usize, f64)> {
        let of = |side: usize| self.torques[side].iter().map(move |torque| (side, *torque));
        of(0).chain(of(1)).collect()
    }
}

/// Evaluated points by side and bits of the torque.
type Computed = BTreeMap<(usize, u64), Vec<Result<EvaluatedPoint, Code>>>;

fn of_finish(
    finish: &Finish<Train>,
    sides: &Sides,
    axes: &Axes,
    speeds: &[f64],
    band: MapBand,
    progress: &(dyn Fn() + Sync),
) -> Result<FinishMap, Error> {
    let train = &finish.case;
    let drawn = sides
        .torques
        .each_ref()
        .map(|torques| Nodes::new(band, torques, axes));
    let mut computed = Computed::new();
    let mut run_in = FlanksOfTorques::new();
    for (side, torque) in sides.torques() {
        let sign = if side == 1 { -1.0 } else { 1.0 };
        let nodes = (speeds, axes.temperature_c.as_slice());
        let is_node = |speed, temperature| drawn[side].has(torque, speed, temperature);
        let at = (torque_of(sign * torque), &mut run_in);
        let evaluated = evaluate(train, at, nodes, &is_node, progress);
        checkpoint()?;
        computed.insert((side, torque.to_bits()), evaluated);
    }
    let draws = draws(train, &computed, drawn, sides.differ, axes, speeds);
    let meshes = train.counts().len();
    let drawn = Drawn::new(&draws, meshes, Beside::Nothing, 1.0);
    let nodes = axes.temperature_c.iter().enumerate().flat_map(|(row, t)| {
        let of_torque = move |torque: &f64| {
            let torque = *torque;
            axes.speed_rpm
                .iter()
                .map(move |speed| (row, [torque, *speed, *t]))
        };
        axes.torque_nm.iter().flat_map(of_torque)
    });
    let nodes: Vec<(usize, [f64; 3])> = nodes.collect();
    let of_node = |&(row, node): &(usize, [f64; 3])| {
        let ratios = drawn
            .as_ref()
            .map(|drawn| drawn.quantiles(drawn.place(node[0], node[1], node[2])));
        let (point, of_meshes) = point(train, sides, ratios, &computed, speeds, row, node);
        let parts = point.numbers.and(of_meshes);
        (point, parts)
    };
    let found = par_map(&nodes, of_node).into_iter();
    let (points, parts): (Vec<Point>, Vec<Option<Vec<f64>>>) = found.unzip();
    if points.iter().all(|point| point.numbers.is_none()) {
        // A run of the case gives the full message.
        for mesh in train.meshes() {
            Run::new(&at_torque(&mesh.case, mesh.case.case.torque)?).losses()?;
        }
    }
    let mut fingerprint = Fingerprint::default();
    let (mut drives, mut coasts) = (Vec::new(), Vec::new());
    for mesh in train.meshes() {
        let at = |torque: f64| at_torque(&mesh.case, torque_of(torque * torque_ratio(train, mesh)));
        let drive = at(sides.from[0])?;
        // The case states the gearbox, each side its flanks.
        fingerprint = fingerprint
            .with(mesh.case.fingerprint())
            .with(drive.fingerprint());
        if sides.has_coast {
            let coast = at(-sides.from[1])?;
            fingerprint = fingerprint.with(coast.fingerprint());
            coasts.push(coast);
        }
        drives.push(drive);
    }
    Ok(FinishMap {
        name: finish.name.clone(),
        fingerprint: fingerprint.hex(),
        files: unique(drives.iter().flat_map(files)),
        coast_files: unique(coasts.iter().flat_map(files)),
        difference_w: None,
        resolved_from_nm: sides.from,
        draws,
        meshes: match train.only() {
            Some(_) => Vec::new(),
            None => of_meshes(train, &parts),
        },
        points,
    })
}

/// Loss torques of each mesh at all points.
fn of_meshes(train: &Train, parts: &[Option<Vec<f64>>]) -> Vec<MeshPart> {
    let meshes = train.meshes().zip(train.counts()).enumerate();
    let part = |(k, (mesh, count)): (usize, (&LoadedMesh, u32))| MeshPart {
        name: mesh.name.clone(),
        count,
        loss_torque_nm: parts.iter().map(|parts| Some(parts.as_ref()?[k])).collect(),
    };
    meshes.map(part).collect()
}

/// Draws at the nodes of every side, mesh by mesh; none if a node has no result or the case no draws.
fn draws(
    train: &Train,
    computed: &Computed,
    nodes: [Nodes; 2],
    sides_differ: bool,
    axes: &Axes,
    speeds: &[f64],
) -> Vec<DrawnNodes> {
    let of_mesh = |side: usize, nodes: &Nodes, mesh: usize| {
        let mut predictive = Vec::new();
        for temperature in &nodes.temperature_c {
            let row = axes
                .temperature_c
                .partition_point(|node| node < temperature);
            for torque in &nodes.torque_nm {
                let evaluated = computed.get(&(side, torque.to_bits()))?;
                for speed in &nodes.speed_rpm {
                    let column = speeds.partition_point(|node| node < speed);
                    let found = evaluated.get(row * speeds.len() + column)?;
                    let found = found.as_ref().ok()?.meshes.get(mesh)?;
                    predictive.push(found.predictive.clone()?);
                }
            }
        }
        Some(predictive).filter(|predictive| !predictive.is_empty())
    };
    let meshes = train.counts().into_iter().zip(train.first_with_flanks());
    let meshes: Vec<(usize, (u32, usize))> = meshes.enumerate().collect();
    let sides = nodes.iter().take(1 + usize::from(sides_differ)).enumerate();
    let drawn = sides.flat_map(|(side, nodes)| {
        meshes.iter().map(move |(mesh, (count, flanks))| {
            Some(DrawnNodes {
                torque_nm: nodes.torque_nm.clone(),
                speed_rpm: nodes.speed_rpm.clone(),
                temperature_c: nodes.temperature_c.clone(),
                predictive: of_mesh(side, nodes, *mesh)?,
                count: *count,
                flanks: *flanks,
                common: None,
            })
        })
    });
    drawn.collect::<Option<_>>().unwrap_or_default()
}

/// A point with the loss torque of each mesh at the input shaft \[N m\], at the median of the draws, whose quantiles are `ratios` of
/// the loss with every constant at its median.
fn point(
    train: &Train,
    sides: &Sides,
    ratios: Option<Estimate>,
    computed: &Computed,
    speeds: &[f64],
    row: usize,
    [torque_nm, speed_rpm, temperature_c]: [f64; 3],
) -> (Point, Option<Vec<f64>>) {
    let side = usize::from(sides.differ && torque_nm < 0.0);
    let at = torque_nm.abs().max(sides.from[side]);
    let column = speeds.partition_point(|speed| *speed < computed_speed(speed_rpm));
    let evaluated = computed
        .get(&(side, at.to_bits()))
        .and_then(|values| values.get(row * speeds.len() + column));
    let mut point = Point {
        torque_nm,
        speed_rpm,
        temperature_c,
        numbers: None,
        outside: Vec::new(),
        code: None,
    };
    let evaluated = match evaluated {
        Some(Ok(evaluated)) => evaluated,
        Some(Err(code)) => {
            point.code = Some(*code);
            return (point, None);
        }
        None => {
            point.code = Some(Code::E501);
            return (point, None);
        }
    };
    let is_extended = torque_nm.abs() < sides.from[side];
    point.outside = outside(train, evaluated);
    if is_extended {
        point.outside.push(EXTENDED.to_owned());
    }
    let computed_at = if side == 1 { -at } else { at };
    let at_torque = |mesh: &EvaluatedMesh| {
        if is_extended {
            extended(mesh, evaluated.omega, torque_nm, at)
        } else {
            numbers(
                mesh,
                evaluated.omega,
                (torque_nm < 0.0) != (computed_at < 0.0),
            )
        }
    };
    let of_mesh = |mesh: &EvaluatedMesh| {
        let of_run = match &mesh.lowered {
            Some((share, other)) => at_torque(mesh).towards(&at_torque(other), *share),
            None => at_torque(mesh),
        };
        match ratios {
            Some(ratios) => of_run.at_median(ratios, torque_nm >= 0.0),
            None => of_run,
        }
    };
    let of_meshes: Vec<Numbers> = evaluated.meshes.iter().map(of_mesh).collect();
    let found = match &of_meshes[..] {
        [only] if train.only().is_some() => Ok((*only, pinion_w(only, evaluated.omega, torque_nm))),
        _ => together(train, &of_meshes, evaluated.omega, torque_nm),
    };
    let checked = found.and_then(|(numbers, power_in_w)| {
        check(&numbers, evaluated.omega, power_in_w)?;
        Ok(numbers)
    });
    match checked {
        Err(error) => point.code = Some(error.code()),
        Ok(numbers) if speed_rpm == 0.0 => point.numbers = Some(at_standstill(numbers)),
        Ok(numbers) => point.numbers = Some(numbers),
    }
    let counts = train.counts().into_iter().map(f64::from);
    let parts = of_meshes.iter().zip(counts);
    let parts = parts.map(|(mesh, count)| count * mesh.loss_torque_nm);
    (point, Some(parts.collect()))
}

/// Inputs out of range in the meshes, with the name of the mesh in a train.
fn outside(train: &Train, evaluated: &EvaluatedPoint) -> Vec<String> {
    let meshes = train.meshes().zip(&evaluated.meshes);
    let of_mesh = |(mesh, evaluated): (&LoadedMesh, &EvaluatedMesh)| {
        let marks = evaluated.losses.outside.iter().map(ToString::to_string);
        match train.only() {
            Some(_) => marks.collect::<Vec<String>>(),
            None => marks
                .map(|mark| format!("{mark} ({})", mesh.name))
                .collect(),
        }
    };
    meshes.flat_map(of_mesh).collect()
}

/// Power into a pair of gears \[W\].
fn pinion_w(n: &Numbers, omega: f64, torque_nm: f64) -> f64 {
    let pinion = torque_nm.abs() * omega;
    if torque_nm < 0.0 {
        pinion + n.loss_w
    } else {
        pinion
    }
}

/// Sums over all meshes of a train, and the power into the train \[W\]. Deviations add up as for independent flanks.
fn together(
    train: &Train,
    of_meshes: &[Numbers],
    omega: f64,
    torque_nm: f64,
) -> Result<(Numbers, f64), PositionError> {
    let counts: Vec<f64> = train.counts().into_iter().map(f64::from).collect();
    let sum = |of: fn(&Numbers) -> f64| -> f64 {
        let meshes = of_meshes.iter().zip(&counts);
        meshes.map(|(mesh, count)| count * of(mesh)).sum()
    };
    let losses = of_meshes.iter().map(|mesh| Power::from_si(mesh.loss_w));
    let losses: Vec<Power> = losses.collect();
    let loss_w = train.loss(&losses).si();
    let power_in_w = if torque_nm == 0.0 {
        0.0
    } else {
        let load = MeshLoad {
            torque: torque_of(torque_nm),
            speed: AngularSpeed::from_si(omega),
        };
        train
            .shafting
            .at(load)
            .power_in(&train.by_stage(&losses))?
            .si()
    };
    let deviations = of_meshes.iter().zip(&counts);
    let square =
        deviations.map(|(mesh, count)| Some((count * mesh.loss_torque_deviation_nm?).powi(2)));
    let deviation = square.sum::<Option<f64>>().map(f64::sqrt);
    let efficiency = 1.0 - loss_w / power_in_w;
    let efficiency = (0.0..1.0).contains(&efficiency).then_some(efficiency);
    let drawn = of_meshes.iter().map(|mesh| mesh.drawn_w);
    let drawn = drawn.collect::<Option<Vec<Estimate>>>();
    let total = |of: fn(&Estimate) -> f64, drawn: &[Estimate]| -> f64 {
        drawn
            .iter()
            .zip(&counts)
            .map(|(mesh, count)| count * of(mesh))
            .sum()
    };
    let at_medians = of_meshes.iter().map(|mesh| mesh.loss_at_medians_w);
    let at_medians = at_medians
        .zip(&counts)
        .map(|(loss, count)| Some(count * loss?));
    let numbers = Numbers {
        loss_w,
        loss_at_medians_w: at_medians.sum(),
        loss_torque_nm: loss_w / omega,
        loss_torque_deviation_nm: deviation,
        // All meshes have the ratios of the whole.
        drawn_w: drawn.map(|drawn| Estimate {
            value: loss_w,
            low: total(|of| of.low, &drawn),
            high: total(|of| of.high, &drawn),
        }),
        efficiency,
        efficiency_deviation: efficiency
            .and(deviation)
            .map(|loss| loss * omega / power_in_w),
        sliding_w: sum(|n| n.sliding_w),
        film_w: sum(|n| n.film_w),
        lubricated_asperity_w: sum(|n| n.lubricated_asperity_w),
        boundary_w: sum(|n| n.boundary_w),
        rolling_w: sum(|n| n.rolling_w),
        deformation_w: sum(|n| n.deformation_w),
        mu_equivalent: None,
        mixed_share: sum(|n| n.mixed_share) / counts.iter().sum::<f64>(),
    };
    Ok((numbers, power_in_w))
}

/// Invariants of the numbers of a point, with the input shaft at `omega` \[rad/s\].
fn check(n: &Numbers, omega: f64, power_in_w: f64) -> Result<(), Fault> {
    let sliding = [n.film_w, n.lubricated_asperity_w, n.boundary_w];
    sum("sliding loss", "W", n.sliding_w, &sliding)?;
    let loss = [n.sliding_w, n.rolling_w, n.deformation_w];
    sum("loss", "W", n.loss_w, &loss)?;
    sum("loss torque", "N m", n.loss_torque_nm, &[n.loss_w / omega])?;
    n.efficiency.map_or(Ok(()), |value| {
        balance::efficiency("efficiency", value, n.loss_w, power_in_w)
    })
}

/// The losses as computed, or with the other gear driving.
fn numbers(evaluated: &EvaluatedMesh, omega: f64, is_reversed: bool) -> Numbers {
    let summary = &evaluated.losses.summary;
    let (efficiency, efficiency_deviation, mu) = match (is_reversed, &evaluated.reversed) {
        (false, _) => (
            Some(summary.efficiency),
            summary.efficiency_deviation,
            Some(summary.mu_equivalent),
        ),
        (true, Some(other)) => (
            Some(other.efficiency),
            other.efficiency_deviation,
            Some(other.mu_equivalent),
        ),
        (true, None) => (None, None, None),
    };
    let losses: Vec<f64> = evaluated
        .losses
        .offsets
        .iter()
        .map(|row| row.loss_w)
        .collect();
    Numbers {
        loss_w: summary.loss_w,
        loss_at_medians_w: None,
        loss_torque_nm: summary.loss_w / omega,
        loss_torque_deviation_nm: deviation(&losses).map(|loss| loss / omega),
        drawn_w: None,
        efficiency,
        efficiency_deviation,
        sliding_w: summary.sliding_w,
        film_w: summary.film_w,
        lubricated_asperity_w: summary.lubricated_asperity_w,
        boundary_w: summary.boundary_w,
        rolling_w: summary.rolling_w,
        deformation_w: summary.deformation_w.iter().sum(),
        mu_equivalent: mu,
        mixed_share: summary.mixed_share,
    }
}

/// Losses below the smallest resolved torque: the rolling loss at that torque, and its other losses in proportion to
/// the torque.
fn extended(evaluated: &EvaluatedMesh, omega: f64, torque_nm: f64, at: f64) -> Numbers {
    let summary = &evaluated.losses.summary;
    let share = torque_nm.abs() / at;
    let scaled = |row: &OffsetRow| row.rolling_w + share * (row.loss_w - row.rolling_w);
    let losses: Vec<f64> = evaluated.losses.offsets.iter().map(scaled).collect();
    let count = losses.len() as f64;
    let loss_w = losses.iter().sum::<f64>() / count;
    let pinion_w = torque_nm.abs() * omega;
    let efficiency_of = |loss: &f64| {
        if torque_nm < 0.0 {
            1.0 - loss / (pinion_w + loss)
        } else {
            1.0 - loss / pinion_w
        }
    };
    let efficiencies: Vec<f64> = losses
        .iter()
        .map(efficiency_of)
        .filter(|efficiency| (0.0..1.0).contains(efficiency))
        .collect();
    let is_whole = torque_nm != 0.0 && efficiencies.len() == losses.len();
    let efficiency = is_whole.then(|| efficiency_of(&loss_w));
    Numbers {
        loss_w,
        loss_at_medians_w: None,
        loss_torque_nm: loss_w / omega,
        loss_torque_deviation_nm: deviation(&losses).map(|loss| loss / omega),
        drawn_w: None,
        efficiency,
        efficiency_deviation: is_whole.then(|| deviation(&efficiencies)).flatten(),
        sliding_w: share * summary.sliding_w,
        film_w: share * summary.film_w,
        lubricated_asperity_w: share * summary.lubricated_asperity_w,
        boundary_w: share * summary.boundary_w,
        rolling_w: summary.rolling_w,
        deformation_w: share * summary.deformation_w.iter().sum::<f64>(),
        mu_equivalent: efficiency.map(|value| (1.0 - value) / summary.loss_factor_local),
        mixed_share: summary.mixed_share,
    }
}

/// Numbers at standstill: no power, but a loss torque.
fn at_standstill(numbers: Numbers) -> Numbers {
    Numbers {
        loss_w: 0.0,
        loss_at_medians_w: numbers.loss_at_medians_w.map(|_| 0.0),
        drawn_w: numbers.drawn_w.map(|drawn| drawn.map(|_| 0.0)),
        efficiency: None,
        efficiency_deviation: None,
        sliding_w: 0.0,
        film_w: 0.0,
        lubricated_asperity_w: 0.0,
        boundary_w: 0.0,
        rolling_w: 0.0,
        deformation_w: 0.0,
        ..numbers
    }
}

/// Inputs out of range in a finish, and points without a result.
fn warnings(finish: &FinishMap) -> Vec<MapWarning> {
    let mut rows_of: BTreeMap<String, Vec<usize>> = BTreeMap::new();
    for (index, point) in finish.points.iter().enumerate() {
        for text in &point.outside {
            rows_of.entry(text.clone()).or_default().push(index);
        }
        if let Some(code) = &point.code {
            let text = format!("{code} no result");
            rows_of.entry(text).or_default().push(index);
        }
    }
    let warning = |(text, at): (String, Vec<usize>)| MapWarning {
        text,
        finish: finish.name.clone(),
        count: at.len(),
        points: ranges(&at),
    };
    rows_of.into_iter().map(warning).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Code of the point at `torque_nm` and 3000 1/min whose losses at 40 N m have a fault.
    fn code(
        train: &Train,
        whole: &EvaluatedPoint,
        torque_nm: f64,
        fault: fn(&mut EvaluatedMesh),
    ) -> Option<Code> {
        let mut faulty = whole.clone();
        fault(&mut faulty.meshes[0]);
        let computed = Computed::from([((0, 40f64.to_bits()), vec![Ok(faulty)])]);
        let sides = Sides {
            from: [40.0; 2],
            has_coast: false,
            differ: false,
            torques: [vec![40.0], Vec::new()],
        };
        let node = [torque_nm, 3000.0, 90.0];
        let (point, _) = point(train, &sides, None, &computed, &[3000.0], 0, node);
        assert_eq!(point.numbers.is_none(), point.code.is_some());
        point.code
    }

    #[test]
    fn a_fault_in_the_balance_of_a_point_has_its_code() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let case = asperity::case::load_with(file, &|input| {
            input.model.positions = Some(3);
            input.model.offsets = Some(1);
        });
        let places: (&[f64], &[f64]) = (&[3000.0], &[90.0]);
        let torque = torque_of(40.0);
        let train = Train::from(case.unwrap());
        let mut found = evaluate(
            &train,
            (torque, &mut FlanksOfTorques::new()),
            places,
            &|_, _| false,
            &|| (),
        );
        let whole = found.remove(0).unwrap();
        // As computed, with the wheel driving, and below the smallest torque that the traces resolve.
        for torque_nm in [40.0, -40.0, 10.0] {
            let code = |fault| code(&train, &whole, torque_nm, fault);
            assert_eq!(code(|_| ()), None);
            let deformation =
                |point: &mut EvaluatedMesh| point.losses.summary.deformation_w[0] += 1.0;
            assert_eq!(code(deformation), Some(Code::E501));
            let sliding = |point: &mut EvaluatedMesh| point.losses.summary.sliding_w *= 1.01;
            assert_eq!(code(sliding), Some(Code::E501));
            let rolling = |point: &mut EvaluatedMesh| point.losses.summary.rolling_w = f64::NAN;
            assert_eq!(code(rolling), Some(Code::E308));
        }
    }
}
