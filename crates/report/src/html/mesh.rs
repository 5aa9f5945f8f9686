//! Picture of the pair in mesh: geometry from the result.
//!
//! The pitch point is the origin, the pinion's axis below it, and the line of action rises to the right, so that
//! contact moves from A on the left to E on the right.

use asperity::case::{GearFlankInput, GearsInput};
use asperity::gear::{Gear, GearPair, RootForm, TransverseTooth};
use asperity::result::RunResult;

use crate::chart::{ASPECT, MeshBody, MeshPicture, MeshPoint, MeshTrace};
use crate::tables::BODIES;

/// Millimetres per metre.
const MILLI: f64 = 1e3;

/// Gear whose flank is in contact at a point of the path.
struct GearInContact {
    centre: [f64; 2],
    /// Base radius \[m\].
    base: f64,
    /// Direction from the axis to the foot of its perpendicular on the line of action \[rad\].
    foot: f64,
    /// Roll length of the point of contact \[m\].
    roll: f64,
    /// Sense in which the foot moves on the base circle with increasing roll length: 1 for counterclockwise.
    turn: f64,
    /// Change of the roll length with the distance of the contact: -1 for an external wheel.
    approach: f64,
    /// Sense from the flank to the middle of its tooth: 1 for counterclockwise.
    side: f64,
}

/// The mesh at the instant of contact at the pitch point.
struct MeshTables<'a> {
    gears: &'a GearPair,
    /// Angle of the line of action.
    angle: f64,
}

impl<'a> MeshTables<'a> {
    fn new(gears: &'a GearPair) -> Self {
        Self {
            gears,
            angle: gears.working_pressure_angle.si(),
        }
    }

    fn along(&self) -> [f64; 2] {
        [self.angle.cos(), self.angle.sin()]
    }

    /// Position at the distance s on the path of contact \[mm\].
    fn position(&self, s: f64) -> [f64; 2] {
        let from_pitch_point = MILLI * (s - self.gears.path.c.si());
        self.along().map(|part| part * from_pitch_point)
    }

    /// Gear 0 or 1 in contact at the distance s on the path.
    fn in_contact(&self, body: usize, s: f64) -> GearInContact {
        let gears = self.gears;
        let base = gears.base_radius[body].si().abs();
        let pitch = gears.working_pitch_radius[body].si();
        // The feet are at the angle of the line of action from the line of centres.
        let up = std::f64::consts::FRAC_PI_2 + self.angle;
        let from_second = gears.path.t1t2.si() - s;
        match (body, gears.internal) {
            (0, _) => GearInContact {
                centre: [0.0, -MILLI * pitch],
                base,
                foot: up,
                roll: s,
                turn: 1.0,
                approach: 1.0,
                side: 1.0,
            },
            (_, false) => GearInContact {
                centre: [0.0, MILLI * pitch],
                base,
                foot: up - std::f64::consts::PI,
                roll: from_second,
                turn: 1.0,
                approach: -1.0,
                side: 1.0,
            },
            // The axis of the ring is below as well; its flank is concave and its teeth are outside.
            (_, true) => GearInContact {
                centre: [0.0, MILLI * pitch],
                base,
                foot: up,
                roll: -from_second,
                turn: 1.0,
                approach: 1.0,
                side: -1.0,
            },
        }
    }
}

impl GearInContact {
    /// The point of the flank with the roll length `roll`, moved by `inside` into the tooth \[m\].
    fn flank(&self, roll: f64, inside: f64) -> [f64; 2] {
        let foot = self.foot + self.turn * (roll - self.roll) / self.base;
        let (sin, cos) = foot.sin_cos();
        // The string of the involute leaves the foot to the right of the radius.
        let length = roll - self.side * inside;
        [
            self.centre[0] + MILLI * (self.base * cos + length * sin),
            self.centre[1] + MILLI * (self.base * sin - length * cos),
        ]
    }

    /// Angle, positive counterclockwise, by which the gear turns while the contact moves by a metre \[rad/m\]: the flank
    /// moves with the contact, so that its base point recedes from the foot as the roll length grows.
    fn rotation(&self) -> f64 {
        -self.turn * self.approach / self.base
    }

    /// Direction of the middle of the tooth in contact.
    fn middle(&self, tooth: &TransverseTooth) -> f64 {
        let at = self.foot - (self.roll / self.base).atan();
        at + self.side * tooth.half_angle(self.roll)
    }
}

/// Picture of the pair of `result`; `None` for impossible gears of a damaged file.
pub(super) fn picture(result: &RunResult) -> Option<MeshPicture> {
    let mut picture = pair_in_mesh(&result.gears, &result.inputs.gears)?;
    picture.traces = traces(result, &MeshTables::new(&result.gears));
    Some(picture)
}

/// Picture of `gears`, with the roots of the teeth as in `input`; `None` for gears that cannot be drawn.
pub fn pair_in_mesh(gears: &GearPair, input: &GearsInput) -> Option<MeshPicture> {
    if !can_be_drawn(gears) {
        return None;
    }
    let mesh = MeshTables::new(gears);
    let path = &gears.path;
    let pitch = std::f64::consts::PI * gears.transverse_module.si();
    let reach = reach(gears, pitch);
    let teeth =
        [Gear::Pinion, Gear::Wheel].map(|gear| gears.transverse_tooth(gear, root(input, gear)));
    let bodies = [0, 1].map(|body| {
        let in_contact = mesh.in_contact(body, path.c.si());
        let radii = [
            gears.tip_radius[body],
            gears.working_pitch_radius[body],
            gears.base_radius[body],
        ];
        MeshBody {
            name: format!("{}, {} teeth", name(gears, body), gears.teeth[body]),
            centre: in_contact.centre,
            radii: radii.map(|radius| MILLI * radius.si().abs()),
            outline: outline(gears, body, &in_contact, &teeth[body], reach),
            turn: in_contact.rotation() / MILLI,
        }
    });
    Some(MeshPicture {
        id: "mesh".to_owned(),
        title: "The pair in mesh, to scale, transverse section".to_owned(),
        source: "result.json".to_owned(),
        bodies,
        path: points(&mesh),
        feet: feet(&mesh),
        along: mesh.along(),
        stations: [path.a, path.c, path.e].map(|s| MILLI * s.si()),
        base_pitch: MILLI * path.base_pitch.si(),
        traces: Vec::new(),
        reach: MILLI * reach,
    })
}

/// Whether the gears can be drawn: a reasonable number of teeth and ordered radii.
fn can_be_drawn(gears: &GearPair) -> bool {
    const MOST_TEETH: u32 = 10_000;
    let module = gears.transverse_module.si();
    let body = |gear: usize| {
        let [base, pitch, tip] = [
            gears.base_radius[gear],
            gears.working_pitch_radius[gear],
            gears.tip_radius[gear],
        ]
        .map(|radius| radius.si().abs());
        (1..=MOST_TEETH).contains(&gears.teeth[gear])
            && base > module
            && pitch >= base
            && tip > base
            && [pitch, tip].iter().all(|radius| radius.is_finite())
    };
    let path = &gears.path;
    let angle = gears.working_pressure_angle.si();
    module > 0.0
        && (0..2).all(body)
        && path.length.si().is_finite()
        && path.e > path.a
        && (0.0..std::f64::consts::FRAC_PI_2).contains(&angle)
}

/// Name of a gear.
fn name(gears: &GearPair, body: usize) -> &'static str {
    match (body, gears.internal) {
        (1, true) => "ring",
        _ => BODIES[body],
    }
}

/// Half of the visible width \[m\]: some pitches, and the path with its letters.
fn reach(gears: &GearPair, pitch: f64) -> f64 {
    const PITCHES: f64 = 1.7;
    const ROOM: f64 = 1.2;
    let path = &gears.path;
    let longest = (path.e - path.c).si().max((path.c - path.a).si());
    (PITCHES * pitch).max(ROOM * longest * gears.working_pressure_angle.si().cos())
}

/// Root form of `gear` in the case.
fn root(input: &GearsInput, gear: Gear) -> RootForm {
    let input: GearFlankInput = match gear {
        Gear::Pinion => input.pinion,
        Gear::Wheel => input.wheel,
    }
    .unwrap_or_default();
    let rack = RootForm::default();
    RootForm {
        dedendum: input.dedendum.unwrap_or(rack.dedendum),
        fillet_radius: input.fillet_radius.unwrap_or(rack.fillet_radius),
    }
}

/// The points A to E on the path, in order.
fn points(mesh: &MeshTables<'_>) -> Vec<MeshPoint> {
    let path = &mesh.gears.path;
    // The ends of single contact of helical gears may lie beyond the path.
    let named = path.named_points().into_iter();
    let mut on_path: Vec<_> = named
        .filter(|(_, s)| *s >= path.a && *s <= path.e)
        .collect();
    on_path.sort_by(|(_, a), (_, b)| a.si().total_cmp(&b.si()));
    let point = |(label, s): (&str, asperity_core::quantity::Length)| MeshPoint {
        label: label.to_owned(),
        at: mesh.position(s.si()),
    };
    on_path.into_iter().map(point).collect()
}

/// Feet of the perpendiculars from both axes.
fn feet(mesh: &MeshTables<'_>) -> Vec<MeshPoint> {
    let named = [("T₁", 0.0), ("T₂", mesh.gears.path.t1t2.si())];
    let foot = |(label, s): (&str, f64)| MeshPoint {
        label: label.to_owned(),
        at: mesh.position(s),
    };
    let mut feet = named.map(foot).to_vec();
    if mesh.gears.internal {
        // Both feet of a ring pair are before A; the line continues to E.
        feet.reverse();
    }
    feet
}

/// Outline of the visible teeth and of the gear body \[mm\].
fn outline(
    gears: &GearPair,
    body: usize,
    gear: &GearInContact,
    tooth: &TransverseTooth,
    reach: f64,
) -> Vec<[f64; 2]> {
    /// Teeth drawn beyond the edge of the picture, besides those that turn into it.
    const SPARE: f64 = 1.0;
    /// Outer radius of a ring over its root radius.
    const RIM: f64 = 1.2;
    let count = f64::from(gears.teeth[body]);
    let angle = std::f64::consts::TAU / count;
    let radius = gears.working_pitch_radius[body].si().abs();
    // The corner of the picture that is nearest to the axis.
    let corner = reach.atan2(radius - ASPECT * reach);
    let path = &gears.path;
    let turned = path.length.si() / path.base_pitch.si();
    let visible = corner / angle + turned + SPARE;
    let is_whole = 2.0 * visible + 1.0 >= count || reach >= 0.8 * radius;
    let (first, last) = if is_whole {
        (0, gears.teeth[body] as i32 - 1)
    } else {
        (-(visible.ceil() as i32), visible.ceil() as i32)
    };
    let middle = gear.middle(tooth);
    let at = |radius: f64, direction: f64| {
        let (sin, cos) = direction.sin_cos();
        [
            gear.centre[0] + MILLI * radius * cos,
            gear.centre[1] + MILLI * radius * sin,
        ]
    };
    let mut points = Vec::new();
    for k in first..=last {
        let middle = middle + angle * f64::from(k);
        let half = tooth.outline.iter();
        points.extend(half.clone().map(|[r, half]| at(*r, middle - half)));
        points.extend(half.rev().map(|[r, half]| at(*r, middle + half)));
    }
    let is_ring = gears.internal && body == 1;
    if !is_whole {
        // The gear body, up to the axis; of a ring, the rim.
        match (is_ring, points.first().copied(), points.last().copied()) {
            (true, Some(first), Some(last)) => {
                points.extend([last, first].map(|[x, y]| {
                    let [cx, cy] = gear.centre;
                    [cx + RIM * (x - cx), cy + RIM * (y - cy)]
                }));
            }
            _ => points.push(gear.centre),
        }
    } else if is_ring {
        const ARCS: u32 = 4;
        let [root, _] = tooth.outline[0];
        let start = middle - 0.5 * angle;
        let around = (0..=ARCS * gears.teeth[body]).rev();
        points
            .extend(around.map(|k| at(RIM * root, start + angle / f64::from(ARCS) * f64::from(k))));
    }
    points
}

/// Positions of the traces, as lines along the flanks in contact at the pitch point.
fn traces(result: &RunResult, mesh: &MeshTables<'_>) -> Vec<MeshTrace> {
    /// Number of points of a line.
    const POINTS: usize = 24;
    /// Distance of the line from the flank, in modules.
    const INSIDE: f64 = 0.06;
    let inside = INSIDE * mesh.gears.normal_module.si();
    let line = |body: usize, [first, last]: [f64; 2]| -> Vec<[f64; 2]> {
        let in_contact = mesh.in_contact(body, mesh.gears.path.c.si());
        let step = (last - first) / POINTS as f64;
        (0..=POINTS)
            .map(|k| in_contact.flank((first + step * k as f64) / MILLI, inside))
            .collect()
    };
    let all = |body: usize| -> Vec<[f64; 2]> {
        let mut ends: Vec<[f64; 2]> = match &result.pairs {
            Some(pairs) => {
                let traces = pairs.traces[body].iter();
                traces
                    .filter_map(|trace| trace.record.roll_lengths_mm)
                    .collect()
            }
            None => result.flanks[body].roll_lengths_mm.into_iter().collect(),
        };
        ends.dedup();
        ends
    };
    let placed = |(body, ends): (usize, [f64; 2])| {
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        MeshTrace {
            body,
            name: format!(
                "trace of the {}, roll length {low:.2} to {high:.2} mm",
                name(mesh.gears, body)
            ),
            line: line(body, ends),
        }
    };
    let every = [0, 1]
        .into_iter()
        .flat_map(|body| all(body).into_iter().map(move |ends| (body, ends)));
    every.map(placed).collect()
}

#[cfg(test)]
mod tests {
    use asperity::gear::GearPairInput;

    use super::*;

    fn input(teeth: [u32; 2], module: &str, helix: &str) -> GearPairInput {
        let width = "20 mm".parse().unwrap();
        GearPairInput::standard(
            teeth,
            module.parse().unwrap(),
            helix.parse().unwrap(),
            width,
        )
    }

    fn pairs() -> Vec<GearPair> {
        let high = GearPairInput {
            addendum: 1.35,
            ..input([60, 90], "2 mm", "0 deg")
        };
        let shifted = GearPairInput {
            profile_shift: Some([0.182, 0.172]),
            ..input([16, 24], "4.5 mm", "0 deg")
        };
        // A ring reaches deeper than the rack that cut the pinion. With a full addendum contact would begin at a roll
        // length of 1.19 mm, where the involute of the pinion begins at 1.77 mm, and the tip cuts into the fillet.
        let short = GearPairInput {
            addendum: 0.9,
            ..input([24, 75], "1.5 mm", "0 deg")
        };
        vec![
            GearPair::new(&input([23, 68], "1.8 mm", "23.4 deg")).unwrap(),
            GearPair::new(&shifted).unwrap(),
            GearPair::new(&high).unwrap(),
            GearPair::new(&input([50, 120], "1.3 mm", "30 deg")).unwrap(),
            GearPair::internal(&short).unwrap(),
        ]
    }

    fn drawn(gears: &GearPair) -> MeshTables<'_> {
        MeshTables::new(gears)
    }

    fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
        (a[0] - b[0]).hypot(a[1] - b[1])
    }

    fn outlines(gears: &GearPair) -> [Vec<[f64; 2]>; 2] {
        let mesh = drawn(gears);
        let reach = reach(gears, std::f64::consts::PI * gears.transverse_module.si());
        [Gear::Pinion, Gear::Wheel].map(|gear| {
            // Long addenda want deep roots.
            let root = match gears.teeth {
                [60, 90] => RootForm {
                    dedendum: 1.6,
                    fillet_radius: 0.25,
                },
                _ => RootForm::default(),
            };
            let tooth = gears.transverse_tooth(gear, root);
            let in_contact = mesh.in_contact(gear as usize, gears.path.c.si());
            outline(gears, gear as usize, &in_contact, &tooth, reach)
        })
    }

    /// Distance of a point from a closed line.
    fn from_line(line: &[[f64; 2]], point: [f64; 2]) -> f64 {
        let next = line.iter().cycle().skip(1);
        let distances = line.iter().zip(next).map(|(a, b)| {
            let edge = [b[0] - a[0], b[1] - a[1]];
            let square = edge[0] * edge[0] + edge[1] * edge[1];
            let along = (point[0] - a[0]) * edge[0] + (point[1] - a[1]) * edge[1];
            let share = if square > 0.0 {
                (along / square).clamp(0.0, 1.0)
            } else {
                0.0
            };
            distance(point, [a[0] + share * edge[0], a[1] + share * edge[1]])
        });
        distances.fold(f64::INFINITY, f64::min)
    }

    fn is_inside(line: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
        let next = line.iter().cycle().skip(1);
        let crossings = line.iter().zip(next).filter(|([x1, y1], [x2, y2])| {
            (*y1 > y) != (*y2 > y) && x < x1 + (y - y1) / (y2 - y1) * (x2 - x1)
        });
        crossings.count() % 2 == 1
    }

    /// Largest deviation of a chord between two points from the flank \[mm\].
    const CHORD: f64 = 2e-3;

    #[test]
    fn the_point_of_contact_lies_on_both_flanks_wherever_it_is() {
        for gears in pairs() {
            let (mesh, path) = (drawn(&gears), &gears.path);
            for share in [0.0, 0.3, 0.5, 1.0] {
                let s = path.a.si() + share * path.length.si();
                for body in [0, 1] {
                    let in_contact = mesh.in_contact(body, s);
                    let point = in_contact.flank(in_contact.roll, 0.0);
                    assert!(
                        distance(point, mesh.position(s)) < 1e-9,
                        "{:?}",
                        gears.teeth
                    );
                }
            }
            for line in outlines(&gears) {
                assert!(from_line(&line, [0.0; 2]) < CHORD, "{:?}", gears.teeth);
            }
        }
    }

    #[test]
    fn the_pinion_pushes_and_neither_gear_cuts_into_the_other() {
        for gears in pairs() {
            let [pinion, wheel] = outlines(&gears);
            let [x, y] = drawn(&gears).along().map(|part| 0.05 * part);
            assert!(is_inside(&pinion, [-x, -y]) && !is_inside(&wheel, [-x, -y]));
            assert!(is_inside(&wheel, [x, y]) && !is_inside(&pinion, [x, y]));
            for (own, other) in [(&pinion, &wheel), (&wheel, &pinion)] {
                let inside = own.iter().filter(|point| is_inside(other, **point));
                let deepest = inside
                    .map(|point| from_line(other, *point))
                    .fold(0.0, f64::max);
                // Bodies end at the edge of the picture, beyond which they may meet.
                assert!(deepest < 2.0 * CHORD, "{:?}: {deepest} mm", gears.teeth);
            }
        }
    }

    #[test]
    fn turned_gears_touch_at_the_next_point_of_the_path() {
        for gears in pairs() {
            let (mesh, path) = (drawn(&gears), &gears.path);
            let lines = outlines(&gears);
            for s in [path.a.si(), path.e.si()] {
                let point = mesh.position(s);
                for body in [0, 1] {
                    let in_contact = mesh.in_contact(body, path.c.si());
                    let (sin, cos) = (in_contact.rotation() * (s - path.c.si())).sin_cos();
                    let [cx, cy] = in_contact.centre;
                    let turned: Vec<[f64; 2]> = lines[body]
                        .iter()
                        .map(|[x, y]| [x - cx, y - cy])
                        .map(|[x, y]| [cx + cos * x - sin * y, cy + sin * x + cos * y])
                        .collect();
                    let apart = from_line(&turned, point);
                    assert!(apart < CHORD, "{:?} {body}: {apart} mm", gears.teeth);
                }
            }
        }
    }

    #[test]
    fn the_line_of_action_is_tangent_to_both_base_circles() {
        for gears in pairs() {
            let mesh = drawn(&gears);
            let [dx, dy] = mesh.along();
            let mut feet = feet(&mesh);
            feet.sort_by(|a, b| a.label.cmp(&b.label));
            for (body, foot) in feet.iter().enumerate() {
                let in_contact = mesh.in_contact(body, gears.path.c.si());
                let [cx, cy] = [
                    foot.at[0] - in_contact.centre[0],
                    foot.at[1] - in_contact.centre[1],
                ];
                assert!((cx * dx + cy * dy).abs() < 1e-9, "{}", foot.label);
                assert!(
                    (cx.hypot(cy) - MILLI * in_contact.base).abs() < 1e-9,
                    "{}",
                    foot.label
                );
            }
        }
    }

    #[test]
    fn contact_begins_at_the_tip_of_the_wheel_and_ends_at_that_of_the_pinion() {
        for gears in pairs() {
            let (mesh, path) = (drawn(&gears), &gears.path);
            for (body, s) in [(1, path.a), (0, path.e)] {
                let centre = mesh.in_contact(body, path.c.si()).centre;
                let radius = distance(mesh.position(s.si()), centre);
                assert!((radius - MILLI * gears.tip_radius[body].si().abs()).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn letters_follow_each_other_along_the_path() {
        let letters = |gears: &GearPair| -> String {
            let found = points(&drawn(gears));
            assert!(found.windows(2).all(|pair| pair[0].at[0] <= pair[1].at[0]));
            found.into_iter().map(|point| point.label).collect()
        };
        let [helical, spur, high, ..] = &pairs()[..] else {
            panic!("there are three pairs")
        };
        assert_eq!(letters(helical), "ABCDE");
        assert_eq!(letters(spur), "ABCDE");
        // With more than two pairs in contact, D lies before B.
        assert!(high.path.eps_alpha > 2.0);
        assert_eq!(letters(high), "ADCBE");
        let short = GearPair::new(&input([20, 25], "1 mm", "45 deg")).unwrap();
        assert_eq!(short.path.eps_alpha < 1.0, letters(&short) == "ACE");
    }

    #[test]
    fn a_trace_lies_inside_its_tooth_beside_the_flank() {
        for gears in pairs() {
            let mesh = drawn(&gears);
            let lines = outlines(&gears);
            let inside = 0.05 * gears.normal_module.si();
            for body in [0, 1] {
                let in_contact = mesh.in_contact(body, gears.path.c.si());
                let point = in_contact.flank(in_contact.roll, inside);
                assert!(is_inside(&lines[body], point), "{:?} {body}", gears.teeth);
                assert!((from_line(&lines[body], point) - MILLI * inside).abs() < CHORD);
            }
        }
    }
}
