//! Traces of all teeth of both gears in a zone of the face, and the contacts that pass over them.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | E_i | engagements of a tooth of gear i in a cycle | - |
//! | z_i | number of teeth | - |
//! | R_i | length of the measured traces of gear i | m |
//! | T_i | length of all traces of gear i, other teeth included | m |
//! | b̄ | mean half width of the contacts | m |
//! | P | contacts in a cycle | - |
//!
//! A trace is periodic: a contact may lie at any point and goes on at the other end, where half of the step between the ends is
//! taken off each of them over the width of a contact, in the gap only. A trace whose place on its flank is known lies where its
//! contacts pass; beyond its ends it is mirrored, as in a run.

use std::ops::Range;

use asperity_contact::{
    Boundary, ContactProblem, ContactSolution, Control, Solver, SolverSettings,
};
use asperity_core::Profile;
use asperity_core::cite;
use asperity_core::numerics::mean;
use asperity_core::quantity::{Length, LineLoad, Pressure};

use crate::mesh::MeshPosition;
use asperity_case::case::Case;
use asperity_case::error::PositionError;
use asperity_case::flanks::placement::PlacedTrace;
use asperity_case::flanks::{LEAST_POINTS_PER_HALF_WIDTH, Surfaces};

/// Engagements of a pinion's tooth in a cycle, in which each of its points is in contact as often.
pub(crate) const ENGAGEMENTS: f64 = 4.0;
/// Tolerance of the contacts: a tighter one changes Rq by less than 1e-3.
const TOLERANCE: f64 = 1e-4;
/// Steps from contact to contact of the mesh position and of the places on pinion and wheel, as parts of the whole: powers of the
/// inverse of the real root of x⁴ = x + 1, which fill three dimensions evenly.
const STEPS: [f64; 3] = [
    0.819_172_513_396_164_4,
    0.671_043_606_703_789_3,
    0.549_700_477_901_970_3,
];
/// Half-widths of a window to each side: without a film rough flanks touch within 1.3 of them.
const REACH: f64 = 1.5;
/// Part of the length of all traces below which no other teeth are added.
const NO_OTHERS: f64 = 1e-9;

/// Trace of a tooth.
#[derive(Debug, Clone)]
struct Tooth {
    heights: Vec<f64>,
    /// Heights when the running-in began.
    first: Vec<f64>,
    /// Place on the flank, where it is known.
    placed: Option<PlacedTrace>,
    /// Height that closes the ends in the gap \[m\].
    closing: Vec<f64>,
}

/// Traces of the teeth of a gear.
#[derive(Debug, Clone)]
struct Teeth {
    /// The measured ones, then others that begin as they do, of which the last is used in part.
    all: Vec<Tooth>,
    measured: usize,
    /// Points that contacts pass on each tooth.
    ways: Vec<f64>,
    /// T_i in points.
    length: f64,
}

/// Traces of both gears in a zone of the face, and the mesh positions there.
#[derive(Debug, Clone)]
pub(crate) struct Track<'a> {
    gears: [Teeth; 2],
    pub positions: Vec<&'a MeshPosition>,
    pub spacing: Length,
    /// Points of a window.
    pub points: usize,
    /// P.
    pub passes: f64,
}

/// A contact of two teeth.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pass {
    /// Number of the mesh position on its track.
    pub position: usize,
    teeth: [usize; 2],
    /// First points of the windows.
    starts: [isize; 2],
}

impl<'a> Track<'a> {
    /// The track of zone `zone` of the face, with the mesh positions there whose contacts the traces resolve and hold; `None` if
    /// there are none.
    ///
    /// ```text
    /// E₂ = E₁ z₁/z₂,  P = maxᵢ Eᵢ Rᵢ/(2 b̄),  Tᵢ = 2 b̄ P/Eᵢ                                [Engagements-1]
    /// ```
    ///
    /// What Tᵢ is longer than Rᵢ belongs to other teeth of the same gear, which begin as the measured ones, so that each measured
    /// tooth is in contact as often as its gear engages.
    ///
    /// # Errors
    /// When a flank has no trace.
    pub fn new(
        case: &Case,
        surfaces: &Surfaces,
        zone: usize,
        positions: &'a [MeshPosition],
    ) -> Result<Option<Self>, PositionError> {
        cite!("Engagements-1");
        let count = surfaces.teeth().unwrap_or([1, 1]);
        let spacing = surfaces.traces()?[0].spacing();
        let mut least = usize::MAX;
        for (body, teeth) in count.into_iter().enumerate() {
            for tooth in 0..teeth {
                least = least.min(trace_of(surfaces, body, tooth, zone)?.0.len());
            }
        }
        let window = |at: &MeshPosition| window_points(at, spacing);
        let is_held = |at: &&MeshPosition| {
            let points = at.hertz.half_width / spacing;
            at.zone.min(surfaces.zones() - 1) == zone
                && points >= LEAST_POINTS_PER_HALF_WIDTH
                && window(at) <= least
        };
        let positions: Vec<&MeshPosition> = positions.iter().filter(is_held).collect();
        let Some(points) = positions.iter().map(|at| window(at)).max() else {
            return Ok(None);
        };
        let widths = positions
            .iter()
            .map(|at| 2.0 * (at.hertz.half_width / spacing));
        let width = widths.sum::<f64>() / positions.len() as f64;
        let teeth_of = |body: usize| -> Result<Vec<Tooth>, PositionError> {
            let traces = (0..count[body]).map(|tooth| trace_of(surfaces, body, tooth, zone));
            traces
                .map(|found| {
                    let (trace, placed) = found?;
                    Ok(Tooth::new(trace.heights(), placed, width))
                })
                .collect()
        };
        let gears = [teeth_of(0)?, teeth_of(1)?];
        let ways = [0, 1].map(|body: usize| -> Vec<f64> {
            let of = |tooth: &Tooth| tooth.way((&positions, spacing), body);
            gears[body].iter().map(of).collect()
        });
        let teeth = case.gears.teeth.map(f64::from);
        let engagements = [ENGAGEMENTS, ENGAGEMENTS * teeth[0] / teeth[1]];
        let needed = [0, 1].map(|k: usize| engagements[k] * ways[k].iter().sum::<f64>() / width);
        let passes = needed[0].max(needed[1]);
        let ([pinions, wheels], [of_pinion, of_wheel]) = (gears, ways);
        let length = |body: usize| width * passes / engagements[body];
        Ok(Some(Self {
            gears: [
                Teeth::new(pinions, of_pinion, length(0)),
                Teeth::new(wheels, of_wheel, length(1)),
            ],
            positions,
            spacing,
            points,
            passes,
        }))
    }

    /// Contact `number` from 0, in a sequence that fills mesh positions and traces evenly.
    pub fn pass(&self, number: usize) -> Pass {
        let [along, pinion, wheel] = STEPS.map(|step| (number as f64 * step).fract());
        let place = along * self.positions.len() as f64;
        let position = (place as usize).min(self.positions.len() - 1);
        let half = (self.points / 2) as isize;
        let places = [pinion, wheel];
        let found = [0, 1].map(|body: usize| {
            let (tooth, start) = self.gears[body].at(places[body]);
            let of = &self.gears[body].all[tooth];
            let start = match of.middle(&self.positions, self.spacing, body, place) {
                Some(middle) => middle.round() as isize - half,
                None => start as isize,
            };
            (tooth, start)
        });
        Pass {
            position,
            teeth: found.map(|(tooth, _)| tooth),
            starts: found.map(|(_, start)| start),
        }
    }

    /// Whether two contacts have points of a trace in common.
    pub fn overlap(&self, one: &Pass, other: &Pass) -> bool {
        (0..2).any(|body| {
            let apart = one.starts[body].abs_diff(other.starts[body]);
            let of = &self.gears[body].all[one.teeth[body]];
            let apart = match of.placed {
                Some(_) => apart,
                None => apart.min(of.heights.len().saturating_sub(apart)),
            };
            one.teeth[body] == other.teeth[body] && apart < self.points
        })
    }

    /// The windows of a contact pressed together under `load`, in addition to the pressure `film` of a film.
    ///
    /// # Errors
    /// When the contact has no solution.
    pub fn press(
        &self,
        solver: &mut Solver,
        case: &Case,
        pass: &Pass,
        load: LineLoad,
        film: Option<&[f64]>,
        limit: Pressure,
    ) -> Result<ContactSolution, PositionError> {
        let line = self.positions[pass.position].line_contact(case.modulus, case.materials);
        let heights = [0, 1].map(|body: usize| {
            let tooth = &self.gears[body].all[pass.teeth[body]];
            tooth.window(pass.starts[body], self.points)
        });
        let places = self.places();
        let pairs = heights[0].iter().zip(&heights[1]);
        let gap: Vec<f64> = places
            .zip(pairs)
            .map(|(x, (pinion, wheel))| x * x / (2.0 * line.radius.si()) - pinion - wheel)
            .collect();
        let problem = ContactProblem {
            gap: &gap,
            spacing: self.spacing,
            modulus: case.modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Load(load),
            lead: None,
            prescribed_pressure: film,
            pressure_limit: Some(limit),
            start: None,
        };
        let settings = SolverSettings {
            tolerance: TOLERANCE.max(case.model.tolerance),
            ..SolverSettings::default()
        };
        Ok(solver.solve(&problem, &settings)?)
    }

    /// Places of the points of a window, 0 in its middle \[m\].
    pub fn places(&self) -> impl Iterator<Item = f64> {
        let reach = 0.5 * (self.points as f64 - 1.0);
        let spacing = self.spacing.si();
        (0..self.points).map(move |i| (i as f64 - reach) * spacing)
    }

    /// Lowers a tooth of gear `body` under a contact by `by` at each point of the window.
    pub fn lower(&mut self, body: usize, pass: &Pass, by: impl Iterator<Item = f64>) {
        let tooth = &mut self.gears[body].all[pass.teeth[body]];
        tooth.lower(pass.starts[body], by);
    }

    /// Zeros for every point of every tooth of gear `body`, to be filled by [`add`](Self::add).
    pub fn zeros(&self, body: usize) -> Vec<Vec<f64>> {
        let teeth = self.gears[body].all.iter();
        teeth.map(|tooth| vec![0.0; tooth.heights.len()]).collect()
    }

    /// Adds `values` at the points under a contact to `fields` of gear `body`.
    pub fn add(
        &self,
        (body, fields): (usize, &mut [Vec<f64>]),
        pass: &Pass,
        values: impl Iterator<Item = f64>,
    ) {
        let tooth = &self.gears[body].all[pass.teeth[body]];
        let field = &mut fields[pass.teeth[body]];
        for (i, value) in values.enumerate() {
            if let Some(at) = tooth.index(pass.starts[body] + i as isize) {
                field[at] += value;
            }
        }
    }

    /// Lowers every point of gear `body` by `factor` times its value in `fields`.
    pub(crate) fn lower_all(&mut self, body: usize, fields: &[Vec<f64>], factor: f64) {
        for (tooth, field) in self.gears[body].all.iter_mut().zip(fields) {
            for (z, value) in tooth.heights.iter_mut().zip(field) {
                *z -= factor * value;
            }
        }
    }

    /// Heights of the measured teeth of gear `body` from their mean lines.
    pub fn heights(&self, body: usize) -> impl Iterator<Item = Vec<f64>> {
        self.measured(body).map(Tooth::about_mean_line)
    }

    /// Heights of a measured tooth of gear `body` from its mean line.
    pub fn heights_of(&self, body: usize, tooth: usize) -> Vec<f64> {
        self.gears[body].all[tooth].about_mean_line()
    }

    /// Height removed from the measured teeth of gear `body`, mean over their points \[m\].
    pub fn removed(&self, body: usize) -> f64 {
        let points = |tooth: &Tooth| tooth.heights.len() as f64;
        let removed = self.measured(body).map(|of| points(of) * of.removed());
        removed.sum::<f64>() / self.measured(body).map(points).sum::<f64>()
    }

    /// T_i of gear `body`: the way that places on its traces fill evenly \[m\].
    pub fn way(&self, body: usize) -> f64 {
        self.gears[body].length * self.spacing.si()
    }

    fn measured(&self, body: usize) -> impl Iterator<Item = &Tooth> {
        let teeth = &self.gears[body];
        teeth.all[..teeth.measured].iter()
    }
}

impl Teeth {
    /// The measured teeth, whose points in contact are `ways`, with others up to `length` points together.
    fn new(all: Vec<Tooth>, ways: Vec<f64>, length: f64) -> Self {
        let measured = all.len();
        let mut teeth = Self {
            all,
            measured,
            ways,
            length,
        };
        let mut left = length - teeth.ways.iter().sum::<f64>();
        while left > NO_OTHERS * length {
            let like = teeth.all.len() % measured;
            left -= teeth.ways[like];
            teeth.ways.push(teeth.ways[like]);
            teeth.all.push(teeth.all[like].clone());
        }
        teeth
    }

    /// Tooth and point at the part `place` of all traces.
    fn at(&self, place: f64) -> (usize, usize) {
        let mut left = place * self.length;
        for (k, way) in self.ways.iter().enumerate() {
            if left < *way {
                return (k, left as usize);
            }
            left -= way;
        }
        (self.ways.len() - 1, 0)
    }
}

impl Tooth {
    /// A trace with contacts `width` points wide.
    fn new(heights: &[f64], placed: Option<PlacedTrace>, width: f64) -> Self {
        let step = match (placed, heights.first(), heights.last()) {
            (None, Some(first), Some(last)) => first - last,
            _ => 0.0,
        };
        let count = heights.len();
        let points = (width as usize).clamp(1, (count / 2).max(1));
        let mut closing = vec![0.0; count];
        for from_end in 0..points.min(count / 2) {
            let half = 0.5 * step * (1.0 - from_end as f64 / points as f64);
            closing[from_end] = -half;
            closing[count - 1 - from_end] = half;
        }
        Self {
            heights: heights.to_vec(),
            first: heights.to_vec(),
            placed,
            closing,
        }
    }

    /// Middle of the contact on a trace whose place is known, at a part of the positions counted in positions.
    fn middle(
        &self,
        positions: &[&MeshPosition],
        spacing: Length,
        body: usize,
        place: f64,
    ) -> Option<f64> {
        let placed = self.placed?;
        let middle = |k: usize| {
            let motion = &positions[k].motion;
            placed.middle([motion.rho1, motion.rho2][body], spacing)
        };
        let last = positions.len() - 1;
        let nearest = (place as usize).min(last);
        let (before, after) = (nearest.saturating_sub(1), (nearest + 1).min(last));
        let cell = (middle(after) - middle(before)) / (after - before).max(1) as f64;
        Some(middle(nearest) + (place - nearest as f64 - 0.5) * cell)
    }

    /// Points that contacts pass: all of a periodic trace, the active ones of a trace whose place is known.
    fn way(&self, on: (&[&MeshPosition], Length), body: usize) -> f64 {
        let end = on.0.len() as f64;
        let ends = [0.0, end].map(|place| self.middle(on.0, on.1, body, place));
        match ends {
            [Some(first), Some(last)] if on.0.len() > 1 => (last - first).abs(),
            _ => self.heights.len() as f64,
        }
    }

    /// The point at an index beyond the ends: of a periodic trace at the other end, none of one whose place is known.
    fn index(&self, at: isize) -> Option<usize> {
        let count = self.heights.len() as isize;
        match self.placed {
            None => usize::try_from(at.rem_euclid(count)).ok(),
            Some(_) => usize::try_from(at)
                .ok()
                .filter(|at| *at < self.heights.len()),
        }
    }

    /// Heights of a window, closed at the ends of a periodic trace.
    fn window(&self, start: isize, points: usize) -> Vec<f64> {
        if self.placed.is_some() {
            return asperity_core::profile::mirrored_window(&self.heights, start, points);
        }
        let count = self.heights.len();
        let start = start.rem_euclid(count as isize) as usize;
        let before_end = points.min(count - start);
        let closed = |points: Range<usize>| {
            let heights = self.heights[points.clone()].iter();
            heights
                .zip(&self.closing[points])
                .map(|(z, closing)| z + closing)
        };
        let window = closed(start..start + before_end);
        window.chain(closed(0..points - before_end)).collect()
    }

    /// Height removed, mean over all points.
    fn removed(&self) -> f64 {
        let both = self.first.iter().zip(&self.heights);
        mean(both.map(|(first, now)| first - now))
    }

    /// Heights from the mean line, which goes down with what is removed.
    fn about_mean_line(&self) -> Vec<f64> {
        let removed = self.removed();
        self.heights.iter().map(|z| z + removed).collect()
    }

    fn lower(&mut self, start: isize, by: impl Iterator<Item = f64>) {
        // Most points of a contact do not flow.
        for (i, by) in by.enumerate().filter(|(_, by)| *by != 0.0) {
            if let Some(at) = self.index(start + i as isize) {
                self.heights[at] -= by;
            }
        }
    }
}

/// The trace of a tooth of gear `body` in a zone of the face, and its place.
fn trace_of(
    surfaces: &Surfaces,
    body: usize,
    tooth: usize,
    zone: usize,
) -> Result<(&Profile, Option<PlacedTrace>), PositionError> {
    let mut teeth = [0, 0];
    teeth[body] = tooth;
    let met = surfaces.of_teeth(teeth, zone);
    let placed = met.placement().map(|placement| placement.traces[body]);
    Ok((met.traces()?[body], placed))
}

/// Points of the window at a position.
fn window_points(position: &MeshPosition, spacing: Length) -> usize {
    2 * (REACH * (position.hertz.half_width / spacing)).ceil() as usize + 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contacts::running_in::limits;
    use crate::mesh::Mesh;
    use asperity_case::case::{LoadedCase, load_with};
    use asperity_case::flanks::Texture;

    fn case() -> LoadedCase {
        let file = std::path::Path::new("../../fixtures/cases/fzg-c.toml");
        load_with(file, &|input| input.model.positions = Some(8)).unwrap()
    }

    fn on(case: &LoadedCase, heights: [Vec<f64>; 2]) -> Surfaces {
        let spacing = case.surfaces.traces().unwrap()[0].spacing();
        let texture = |z| Texture::Trace(Profile::new(spacing, z).unwrap());
        Surfaces::new(heights.map(texture), None, false)
    }

    /// Fails on windows that fit side by side into a trace, as flanks ran in before.
    #[test]
    fn each_tooth_is_in_contact_as_often_as_its_gear_engages() {
        let case = case();
        let mesh = Mesh::new(&case.case).unwrap();
        // The wheel's trace is half as long: its teeth of the gear that are not measured take what is left.
        let mut heights = case
            .surfaces
            .traces()
            .unwrap()
            .map(|trace| trace.heights().to_vec());
        let whole = heights[1].len();
        heights[1].truncate(2 * whole / 3);
        for surfaces in [case.surfaces.clone(), on(&case, heights)] {
            let track = Track::new(&case.case, &surfaces, 0, &mesh.positions)
                .unwrap()
                .unwrap();
            let cycles = 50.0;
            let mut touched = [track.zeros(0), track.zeros(1)];
            let widths = track
                .positions
                .iter()
                .map(|at| 2.0 * (at.hertz.half_width / track.spacing));
            let width = widths.sum::<f64>() / track.positions.len() as f64;
            for number in 0..(cycles * track.passes) as usize {
                let pass = track.pass(number);
                for (body, fields) in touched.iter_mut().enumerate() {
                    track.add((body, fields), &pass, (0..width as usize).map(|_| 1.0));
                }
            }
            for (body, expected) in [(0, ENGAGEMENTS), (1, ENGAGEMENTS * 16.0 / 24.0)] {
                let of = &touched[body][0];
                let mean = of.iter().sum::<f64>() / of.len() as f64 / cycles;
                assert!((mean / expected - 1.0).abs() < 0.01, "{body}: {mean}");
                // Evenly: no point is in contact half or twice as often.
                let of_mean = of.iter().map(|n| n / cycles / mean);
                assert!(of_mean.clone().fold(f64::MAX, f64::min) > 0.85);
                assert!(of_mean.fold(0.0, f64::max) < 1.15);
            }
        }
    }

    /// A guard: it held of windows side by side, too.
    #[test]
    fn the_same_load_at_the_same_place_flows_once_and_more_load_flows_more() {
        let case = case();
        let mesh = Mesh::new(&case.case).unwrap();
        let [_, limit, _] = limits(&case.case).unwrap();
        let fresh = Track::new(&case.case, &case.surfaces, 0, &mesh.positions)
            .unwrap()
            .unwrap();
        let mut solver = Solver::new(fresh.points, Boundary::FreeEnds).unwrap();
        let mut last = 0.0;
        for factor in [0.5, 1.0, 1.5, 2.0] {
            let mut track = fresh.clone();
            let pass = track.pass(3);
            let load = LineLoad::from_si(factor * track.positions[pass.position].load.si());
            let mut press = |track: &Track<'_>| {
                track
                    .press(&mut solver, &case.case, &pass, load, None, limit)
                    .unwrap()
            };
            let once = press(&track).plastic_displacement;
            let untouched: Vec<bool> = once.iter().map(|w| *w == 0.0).collect();
            for body in 0..2 {
                track.lower(body, &pass, once.iter().map(|w| 0.5 * w));
                // What does not flow keeps every bit.
                for (i, untouched) in untouched.iter().enumerate() {
                    let (of, start) = (&track.gears[body].all[pass.teeth[body]], pass.starts[body]);
                    let at = of.index(start + i as isize).unwrap();
                    assert!(*untouched == (of.heights[at] == of.first[at]));
                }
            }
            let again = press(&track);
            // The work of the flow over the load is within the tolerance of the gap.
            let flow = again.dissipated.si() / again.load.si();
            let tolerated = TOLERANCE * again.certificate.reference_gap.si();
            assert!(flow <= tolerated, "{factor}: {flow} above {tolerated}");
            let once: f64 = once.iter().sum();
            assert!(once > last, "{factor}: {once}");
            last = once;
        }
    }

    #[test]
    fn a_periodic_trace_closes_and_contacts_go_on_at_its_other_end() {
        let heights: Vec<f64> = (0..1000).map(|i| 1e-9 * f64::from(i)).collect();
        let mut tooth = Tooth::new(&heights, None, 100.0);
        assert!(tooth.about_mean_line() == heights);
        let window = tooth.window(800, 300);
        // Half of the step is taken off each end: the heights meet in the middle.
        assert!((window[199] - window[200]).abs() < 1e-15);
        assert!((window[0] - 800e-9).abs() < 1e-15 && (window[299] - 104e-9).abs() < 1e-9);
        tooth.lower(990, (0..20).map(|_| 1e-9));
        assert!(
            (tooth.heights[5] - 4e-9).abs() < 1e-18 && (tooth.heights[995] - 994e-9).abs() < 1e-15
        );
        assert!(tooth.heights[10..990] == heights[10..990]);
        // 20 of 1000 points are 1 nm lower, and so is a fiftieth of it the mean line.
        assert!((tooth.about_mean_line()[500] - heights[500] - 0.02e-9).abs() < 1e-20);
    }
}
