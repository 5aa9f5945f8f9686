//! The model at the points of a rig, with stored contacts.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::Contacts;
use asperity::{LoadedCase, Run, TrainLosses};
use asperity_core::Fault;
use asperity_core::numerics::median;
use asperity_core::quantity::{AngularSpeed, Temperature, Torque};
use asperity_core::task::try_par_map;

use crate::parameters::Parameter;

/// Relative difference within which torques share one contact solution; the sliding loss is scaled with the torque.
const SAME_TORQUE: f64 = 0.02;
/// Progress callback, called with the number of evaluations so far.
pub type Progress<'a> = &'a (dyn Fn(usize) + Sync);

/// Operating point of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingPoint {
    /// Index of the case.
    pub case: usize,
    /// Torque \[N m\], speed \[1/min\], temperature \[°C\].
    pub at: [f64; 3],
}

/// Mesh losses at an operating point.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct PointLosses {
    /// Sliding loss \[W\].
    pub sliding_w: f64,
    /// Rolling loss \[W\].
    pub rolling_w: f64,
    /// Share of the load on the boundary layer.
    pub boundary_share: f64,
    /// Median of Λ* over the path; `None` if the flanks have no peaks.
    pub lambda_star: Option<f64>,
}

/// Gear pair at one torque with its stored contacts.
struct RigGroup {
    /// Index of the case.
    of: usize,
    case: LoadedCase,
    tables: Vec<Contacts>,
    torque: f64,
}

/// Operating point with the contact solution that it uses.
#[derive(Debug, Clone, Copy)]
struct PointContacts {
    group: usize,
    /// Torque of the point relative to the torque of its group.
    torque_factor: f64,
    speed: AngularSpeed,
    temperature_c: f64,
}

/// The model at a list of operating points.
pub struct RigModel {
    groups: Arc<[RigGroup]>,
    points: Vec<PointContacts>,
    parameters: Vec<Parameter>,
    evaluations: AtomicUsize,
}

impl RigModel {
    /// Solves the contacts of every torque.
    ///
    /// # Errors
    /// When a contact has no solution.
    pub fn new(
        cases: &[LoadedCase],
        parameters: &[Parameter],
        points: &[OperatingPoint],
    ) -> Result<Self, Fault> {
        let nodes = torque_nodes(points);
        let groups = nodes.iter().map(|(case_number, torque)| {
            let changed = cases[*case_number].with(|input| {
                input.operation.torque = Torque::from_si(*torque);
                input.operation.running_in = None;
                // The table states the scope of the measured losses.
                input.gearbox = None;
            });
            let made = changed.and_then(|case| Ok((Run::new(&case).contacts()?, case)));
            let (tables, case) = made.map_err(|source| at(&format!("{torque:.1} N m"), source))?;
            Ok(RigGroup {
                of: *case_number,
                case,
                tables,
                torque: *torque,
            })
        });
        let groups = groups.collect::<Result<Vec<RigGroup>, Fault>>()?;
        Ok(Self {
            points: assign_contacts(&groups, points),
            groups: groups.into(),
            parameters: parameters.to_vec(),
            evaluations: AtomicUsize::new(0),
        })
    }

    /// The model at other points, with the stored contacts of the nearest torque of each case.
    #[must_use]
    pub(crate) fn at_points(&self, points: &[OperatingPoint]) -> Self {
        Self {
            points: assign_contacts(&self.groups, points),
            groups: Arc::clone(&self.groups),
            parameters: self.parameters.clone(),
            evaluations: AtomicUsize::new(0),
        }
    }

    /// The model with other parameters.
    #[must_use]
    pub(crate) fn with_parameters(mut self, parameters: &[Parameter]) -> Self {
        self.parameters = parameters.to_vec();
        self
    }

    /// Torques of the stored contacts of a case \[N m\], in ascending order.
    #[must_use]
    pub fn torques(&self, case: usize) -> Vec<f64> {
        let of_case = self.groups.iter().filter(|group| group.of == case);
        of_case.map(|group| group.torque).collect()
    }

    /// Evaluates all points at all `settings`: the logarithms of the parameters relative to their centres, then an offset
    /// of the temperature \[K\]. Returns the losses by point.
    ///
    /// # Errors
    /// When the model has no solution at a point.
    pub fn evaluate(
        &self,
        settings: &[Vec<f64>],
        progress: Progress<'_>,
    ) -> Result<Vec<Vec<PointLosses>>, Fault> {
        let count = settings.len();
        let all = try_par_map(0..self.points.len() * count, |k| {
            let losses = self.at(&self.points[k / count], &settings[k % count]);
            progress(self.evaluations.fetch_add(1, Ordering::Relaxed) + 1);
            losses
        })?;
        Ok(all
            .chunks(count.max(1))
            .map(<[PointLosses]>::to_vec)
            .collect())
    }

    fn at(&self, place: &PointContacts, setting: &[f64]) -> Result<PointLosses, Fault> {
        let group = &self.groups[place.group];
        let named = |source: asperity::Error| {
            let text = format!(
                "{:.1} N m, {:.0} 1/min, {:.1} °C",
                group.torque * place.torque_factor,
                place.speed.si() * 30.0 / std::f64::consts::PI,
                place.temperature_c
            );
            at(&text, source)
        };
        let (offset, logarithms) = setting
            .split_last()
            .map_or((0.0, setting), |(offset, parameters)| (*offset, parameters));
        let changed = group.case.with(|input| {
            input.operation.speed = place.speed;
            let temperature = Temperature::from_celsius(place.temperature_c + offset);
            input.operation.set_temperature(temperature);
        });
        let changed = changed.and_then(|case| {
            case.overridden(|over| {
                for (parameter, logarithm) in self.parameters.iter().zip(logarithms) {
                    let value = parameter.default.value * logarithm.exp();
                    over.set(parameter.name.into(), value);
                }
            })
        });
        let case = changed.map_err(named)?;
        let run = Run::new(&case).known(&group.tables).coldest();
        let result = run
            .losses()
            .and_then(TrainLosses::into_only)
            .map_err(named)?;
        Ok(PointLosses {
            sliding_w: result.summary.sliding_w * place.torque_factor,
            rolling_w: result.summary.rolling_w,
            boundary_share: result.summary.boundary_share,
            lambda_star: median(result.path.iter().filter_map(|row| row.lambda_star)),
        })
    }
}

fn assign_contacts(groups: &[RigGroup], points: &[OperatingPoint]) -> Vec<PointContacts> {
    let place = |point: &OperatingPoint| {
        let [torque, speed_rpm, temperature_c] = point.at;
        let far = |k: &usize| (groups[*k].torque - torque).abs();
        let of_case = (0..groups.len()).filter(|k| groups[*k].of == point.case);
        let group = of_case.min_by(|a, b| far(a).total_cmp(&far(b)));
        let group = group.unwrap_or_default();
        PointContacts {
            group,
            torque_factor: torque / groups[group].torque,
            speed: AngularSpeed::from_si(speed_rpm * std::f64::consts::PI / 30.0),
            temperature_c,
        }
    };
    points.iter().map(place).collect()
}

fn at(place: &str, source: asperity::Error) -> Fault {
    Fault::from(source).about(place)
}

/// Cases and torques of the contacts that are solved; close torques are replaced by their mean.
fn torque_nodes(points: &[OperatingPoint]) -> Vec<(usize, f64)> {
    let mut torques_of_points: Vec<(usize, f64)> = points
        .iter()
        .map(|point| (point.case, point.at[0]))
        .collect();
    torques_of_points.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
    torques_of_points.dedup();
    let mut nodes: Vec<(usize, Vec<f64>)> = Vec::new();
    for (case, torque) in torques_of_points {
        match nodes.last_mut() {
            Some((of, torques))
                if *of == case && (torque - torques[0]).abs() <= SAME_TORQUE * torque.abs() =>
            {
                torques.push(torque);
            }
            _ => nodes.push((case, vec![torque])),
        }
    }
    let mean = |torques: &[f64]| torques.iter().sum::<f64>() / torques.len() as f64;
    nodes
        .iter()
        .map(|(case, torques)| (*case, mean(torques)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn torques_close_together_share_their_contacts() {
        let point = |case, torque| OperatingPoint {
            case,
            at: [torque, 100.0, 90.0],
        };
        let points = [
            point(0, 100.0),
            point(1, 100.0),
            point(0, 101.0),
            point(0, 140.0),
        ];
        let nodes = torque_nodes(&points);
        assert_eq!(nodes, [(0, 100.5), (0, 140.0), (1, 100.0)]);
    }
}
