//! Archard's wear coefficient of a flank from the height that a test removed.
//!
//! The contact passes over a point of a flank once per engagement. Pressure times sliding distance, summed over an engagement, is the load of
//! the contact line times the slip: the width of the contact cancels.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | h | mean height removed | m |
//! | N | engagements of a tooth | - |
//! | k, K | wear coefficient, with and without its dimension | 1/Pa, - |
//! | H | indentation hardness of the flank | Pa |
//! | F' | load per length of contact line | N/m |
//! | p̄ | mean Hertz pressure | Pa |
//! | a | half width of the contact | m |
//! | s | sliding distance of a point in an engagement | m |
//! | V_s, u | sliding speed; speed of this flank through the contact | m/s |
//! | β_b | base helix angle | rad |

use asperity::gear::{Gear, GearPair};
use asperity::mesh::Mesh;
use asperity::uncertainty::median_with_ends;
use asperity_core::numerics::{
    Z_95, deviation, interpolate, mean, standard_normal_quantile, student_t_quantile,
};
use asperity_core::quantity::Length;
use asperity_core::{Code, Estimate, Fault, cite};

/// Steps of an integral along a trace.
const STEPS: usize = 200;
/// Places of a trace that are tried where its place is not known.
const PLACES: usize = 41;
/// Strata of the height that was removed.
const STRATA: usize = 101;
/// Confidence of an interval from 5 to 95 %.
const CONFIDENCE: f64 = 0.90;

/// Severity of an engagement along the flank of a gear, in each zone of the face.
pub(super) struct Severity {
    /// By the arc from the base circle \[m\]: load times slip \[N/m\], sliding distance \[m\].
    zones: Vec<[Vec<(f64, f64)>; 2]>,
    /// Arcs of the ends of the active flank \[m\].
    active: [f64; 2],
}

/// Means over the place of a trace: load times slip \[N/m\], sliding distance of an engagement \[m\].
#[derive(Debug, Clone, Copy)]
pub(super) struct AtPlace {
    pub load_times_slip: f64,
    pub sliding: f64,
}

impl Severity {
    /// The flank of `gear` in the mesh of a case.
    ///
    /// ```text
    /// s = 2 a |V_s|/(u cos β_b)                                                  [Sliding-distance]
    /// ```
    ///
    /// u is the speed of the flank of this gear, so that s differs from pinion to wheel.
    pub(super) fn new(mesh: &Mesh, gears: &GearPair, gear: Gear) -> Self {
        cite!("Sliding-distance");
        let base = gears.base_radius[gear as usize].si().abs();
        let cosine = gears.base_helix.si().cos();
        let arc = |roll: Length| roll.si() * roll.si() / (2.0 * base);
        let last = mesh.positions.iter().map(|at| at.zone).max().unwrap_or(0);
        let mut zones = vec![[Vec::new(), Vec::new()]; last + 1];
        for at in &mesh.positions {
            let motion = &at.motion;
            let (roll, speed) = match gear {
                Gear::Pinion => (motion.rho1, motion.u1),
                Gear::Wheel => (motion.rho2, motion.u2),
            };
            let slip = (motion.sliding.si() / speed.si()).abs() / cosine;
            let sliding = 2.0 * at.hertz.half_width.si() * slip;
            let [loads, distances] = &mut zones[at.zone];
            loads.push((arc(roll), at.load.si() * slip));
            distances.push((arc(roll), sliding));
        }
        for line in zones.iter_mut().flatten() {
            line.sort_by(|a, b| a.0.total_cmp(&b.0));
        }
        let path = gears.path();
        let roll = |s: Length| match gear {
            Gear::Pinion => s,
            Gear::Wheel => path.t1t2 - s,
        };
        let [a, b] = [path.a, path.e].map(|s| arc(roll(s)));
        Self {
            zones,
            active: [a.min(b), a.max(b)],
        }
    }

    /// The means between two `arcs`; a part beyond the active flank has no contact.
    fn means(&self, zone: usize, [low, high]: [f64; 2]) -> AtPlace {
        let step = (high - low) / STEPS as f64;
        let arcs = || (0..STEPS).map(|k| low + (k as f64 + 0.5) * step);
        let is_active = |arc: &f64| (self.active[0]..=self.active[1]).contains(arc);
        let of = |line: &[(f64, f64)]| {
            let values = arcs().map(|arc| {
                if is_active(&arc) {
                    interpolate(line, arc)
                } else {
                    0.0
                }
            });
            mean(values)
        };
        let [loads, distances] = &self.zones[zone];
        AtPlace {
            load_times_slip: of(loads),
            sliding: of(distances),
        }
    }

    /// The means at every place at which a trace of this `length` may lie: the one between its `arcs`, or all of the active flank where
    /// they are not known, in each zone of the face.
    pub(super) fn at_places(&self, arcs: Option<[f64; 2]>, length: f64) -> Vec<AtPlace> {
        let [low, high] = self.active;
        let middle = 0.5 * (low + high);
        let reach = (0.5 * (high - low - length)).max(0.0);
        let place = |k: usize| match arcs {
            Some(arcs) => arcs,
            None => {
                let from_middle = reach * (2.0 * k as f64 / (PLACES - 1) as f64 - 1.0);
                [-0.5, 0.5].map(|end| middle + from_middle + end * length)
            }
        };
        let zones = 0..self.zones.len();
        zones
            .flat_map(|zone| (0..PLACES).map(move |k| (zone, k)))
            .map(|(zone, k)| self.means(zone, place(k)))
            .collect()
    }
}

/// Wear coefficient of a flank.
#[derive(Debug, Clone, Copy)]
pub(super) enum WearCoefficient {
    /// With its interval from 5 to 95 % \[1/Pa\].
    Found(Estimate),
    /// Noise explains the removal: at most this one \[1/Pa\].
    AtMost(f64),
    /// The whole interval of the removal is below zero.
    Gained,
}

/// The wear coefficient from the heights removed in several pairs of traces of a flank \[m\], after `engagements` at these places.
///
/// ```text
/// k = h/(N ⟨F' |V_s|/(u cos β_b)⟩) = h/(N ⟨p̄ s⟩)                                          [Archard-1]
/// ```
///
/// ⟨⟩ is the mean over the trace. The interval has the height removed, its scatter from pair to pair, and the places at which the trace
/// may lie, each as likely as another.
///
/// # Errors
/// When no place of the trace slides.
pub(super) fn coefficient(
    removed: &[Estimate],
    places: &[Vec<AtPlace>],
    engagements: f64,
) -> Result<WearCoefficient, Fault> {
    cite!("Archard-1");
    let loads: Vec<f64> = (0..places[0].len())
        .map(|k| mean(places.iter().map(|of_pair| of_pair[k].load_times_slip)))
        .filter(|load| *load > 0.0)
        .collect();
    if loads.is_empty() {
        let message =
            "the traces lie where no contact slides, so that their loss has no wear coefficient";
        let help = "Check the place of the trace in the case, or leave engagements out.";
        return Err(Fault::new(Code::E205, message).helping(help));
    }
    let removed = with_scatter(removed);
    let per_metre = |height: f64, load: &f64| height / (engagements * load);
    if removed.high <= 0.0 {
        return Ok(WearCoefficient::Gained);
    }
    if removed.low <= 0.0 {
        let of_end = loads.iter().map(|load| per_metre(removed.high, load));
        return Ok(WearCoefficient::AtMost(
            median_with_ends(&of_end.collect::<Vec<_>>()).high,
        ));
    }
    let heights = (0..STRATA).map(|k| {
        let z = standard_normal_quantile((k as f64 + 0.5) / STRATA as f64) / Z_95;
        let end = if z < 0.0 { removed.low } else { removed.high };
        removed.value + z * (end - removed.value).abs()
    });
    let heights: Vec<f64> = heights.collect();
    let all = loads
        .iter()
        .flat_map(|load| heights.iter().map(move |height| per_metre(*height, load)));
    Ok(WearCoefficient::Found(median_with_ends(
        &all.collect::<Vec<_>>(),
    )))
}

/// Mean of the heights removed, with the scatter from pair to pair in its interval.
fn with_scatter(removed: &[Estimate]) -> Estimate {
    let of = |end: fn(&Estimate) -> f64| mean(removed.iter().map(end));
    let value = of(|one| one.value);
    let values: Vec<f64> = removed.iter().map(|one| one.value).collect();
    let count = values.len() as f64;
    let scatter = deviation(&values).map_or(0.0, |deviation| {
        deviation / count.sqrt() * student_t_quantile(CONFIDENCE, count - 1.0)
    });
    let half = |end: f64| (end - value).hypot(scatter);
    let [low, high] = [half(of(|one| one.low)), half(of(|one| one.high))];
    Estimate::new(value, [value - low, value + high])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(loads: &[f64]) -> Vec<AtPlace> {
        let at = |load: &f64| AtPlace {
            load_times_slip: *load,
            sliding: 1e-5,
        };
        loads.iter().map(at).collect()
    }

    #[test]
    fn a_point_slides_by_the_width_of_the_contact_times_its_slip() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let case = asperity::case::load(file, None).unwrap().case.clone();
        let mesh = Mesh::new(&case).unwrap();
        let found = [Gear::Pinion, Gear::Wheel].map(|gear| Severity::new(&mesh, &case.gears, gear));
        let at = &mesh.positions[0];
        // While the contact passes over a point of a flank, the flanks slide past each other.
        for (k, (speed, roll)) in [
            (at.motion.u1, at.motion.rho1),
            (at.motion.u2, at.motion.rho2),
        ]
        .into_iter()
        .enumerate()
        {
            let time =
                2.0 * at.hertz.half_width.si() / speed.si() / case.gears.base_helix.si().cos();
            let expected = time * at.motion.sliding.si().abs();
            let arc = roll.si().powi(2) / (2.0 * case.gears.base_radius[k].si());
            let [loads, distances] = &found[k].zones[at.zone];
            assert!((interpolate(distances, arc) / expected - 1.0).abs() < 1e-12);
            // The mean pressure over the width is the load.
            let pressure = std::f64::consts::FRAC_PI_4 * at.hertz.max_pressure.si();
            let both = interpolate(loads, arc) / (pressure * expected);
            assert!((both - 1.0).abs() < 1e-9, "{both}");
            // A trace of this place has these values, and one that begins beyond the flank less.
            let [_, end] = found[k].active;
            let within = found[k].at_places(Some([end - 2e-4, end]), 2e-4);
            let beyond = found[k].at_places(Some([end - 1e-4, end + 1e-4]), 2e-4);
            assert!(beyond[0].load_times_slip < 0.8 * within[0].load_times_slip);
        }
    }

    #[test]
    fn the_coefficient_is_the_height_over_load_slip_and_engagements() {
        let removed = [Estimate::new(1e-7, [0.8e-7, 1.2e-7])];
        let of = |removed: &[Estimate], loads: &[f64]| {
            let places: Vec<_> = removed.iter().map(|_| places(loads)).collect();
            coefficient(removed, &places, 1e6).unwrap()
        };
        // 0.1 µm after a million engagements of 100 N/mm that slip by a tenth.
        let WearCoefficient::Found(k) = of(&removed, &[1e4]) else {
            panic!("it was found");
        };
        assert!((k.value / 1e-17 - 1.0).abs() < 1e-12, "{k:?}");
        assert!((k.low / 0.8e-17 - 1.0).abs() < 0.02 && (k.high / 1.2e-17 - 1.0).abs() < 0.02);
        // An unknown place, or another loss of a second pair, widens it.
        let WearCoefficient::Found(wider) = of(&removed, &[0.5e4, 1e4, 2e4]) else {
            panic!("it was found");
        };
        assert!(wider.low < 0.6e-17 && wider.high > 1.7e-17, "{wider:?}");
        let two = [removed[0], Estimate::new(1.5e-7, [1.3e-7, 1.7e-7])];
        let WearCoefficient::AtMost(most) = of(&two, &[1e4]) else {
            panic!("two pairs that differ leave it open");
        };
        assert!(most > 1.2e-17, "{most}");
        let none = [Estimate::new(1e-9, [-2e-9, 4e-9])];
        let WearCoefficient::AtMost(most) = of(&none, &[1e4]) else {
            panic!("noise explains it");
        };
        assert!((most / 4e-19 - 1.0).abs() < 1e-12);
        let gained = [Estimate::new(-2e-9, [-3e-9, -1e-9])];
        assert!(matches!(of(&gained, &[1e4]), WearCoefficient::Gained));
        assert!(coefficient(&removed, &[places(&[0.0])], 1e6).is_err());
    }
}
