//! Outline of a tooth in the transverse section, for drawings: root of the tool, involute, tip.
//!
//! Source: ISO 21771:2007 (involute); own derivation of the envelope of the rounded tip edge of the rack, which is
//! stretched by 1/cos β in the transverse section.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | r, r_b | reference and base radius | m |
//! | ρ | roll length on the involute | m |
//! | γ | half the angular thickness of the tooth at a radius | rad |
//! | h_fP*, ρ_fP* | dedendum and tip rounding of the rack, in normal modules | - |
//! | ψ, t | position on the rounding, 0 at its deepest point; t = tan ψ | rad, - |
//!
//! Tooth compliance uses the normal section ([`crate::tooth_outline`]).

use asperity_core::cite;
use asperity_core::numerics::find_root;
use asperity_core::quantity::Length;

use crate::error::Gear;
use crate::pair::GearPair;
use crate::tooth_outline::{RackEdge, RootForm};

/// Points on a fillet and on an involute.
const POINTS: usize = 24;

/// Outline of half a tooth; the other half is its mirror image.
#[derive(Debug, Clone, PartialEq)]
pub struct TransverseTooth {
    /// Radius \[m\] and half the angular thickness of the tooth \[rad\], from the middle of the tooth space at the root
    /// to the middle of the tip.
    pub outline: Vec<[f64; 2]>,
    /// Roll length of the lowest point of the involute \[m\].
    pub involute_start: f64,
    /// Whether the root is the envelope of the tool; otherwise it is replaced by a radial line.
    pub is_root_cut: bool,
    involute: ToothInvolute,
}

/// γ over the roll length of an involute.
#[derive(Debug, Clone, Copy, PartialEq)]
struct ToothInvolute {
    /// 1, or −1 for a ring.
    sign: f64,
    base_radius: f64,
    base_half_angle: f64,
}

impl ToothInvolute {
    /// γ = (π/2 + 2 x tan αₙ)/z ± (inv αₜ − inv α) at the roll length ρ; minus for a ring.
    fn half_angle(&self, roll: f64) -> f64 {
        let t = roll / self.base_radius;
        self.base_half_angle - self.sign * (t - t.atan())
    }

    fn roll_at(&self, radius: f64) -> f64 {
        let square = (radius - self.base_radius) * (radius + self.base_radius);
        square.max(0.0).sqrt()
    }

    fn point(&self, roll: f64) -> [f64; 2] {
        [self.base_radius.hypot(roll), self.half_angle(roll)]
    }
}

/// Envelope of the rounded edge of a rack in the transverse section.
#[derive(Debug, Clone, Copy)]
struct TransverseFillet {
    rack: RackEdge,
    radius: f64,
    teeth: f64,
    /// cos β.
    lean: f64,
}

impl TransverseFillet {
    /// P = ((h + k) t cos β, r − h − k), k = ρ/√(1 + t²), turned back by ((h + k) t cos β − (E + k t)/cos β)/r;
    /// h and E as in Tooth-2                                                       [Tooth-4]
    ///
    /// Returns the radius of the point and γ.
    fn point(&self, t: f64) -> [f64; 2] {
        cite!("Tooth-4");
        let k = self.rack.rounding / (1.0 + t * t).sqrt();
        let (x, y) = (
            (self.rack.depth + k) * t * self.lean,
            self.radius - self.rack.depth - k,
        );
        let turn = (x - (self.rack.edge + k * t) / self.lean) / self.radius;
        let space = x.atan2(y) - turn;
        [x.hypot(y), std::f64::consts::PI / self.teeth - space]
    }
}

impl TransverseTooth {
    /// Half the angular thickness of the tooth at the roll length `roll` \[m\], in radians.
    #[must_use]
    pub fn half_angle(&self, roll: f64) -> f64 {
        self.involute.half_angle(roll)
    }
}

impl GearPair {
    /// Outline of a tooth of `gear`, cut by a tool with the root `root`. If only the sum of the profile shifts is
    /// known, it is divided according to the tip radii.
    ///
    /// ```
    /// use asperity_gear::{Gear, GearPair, GearPairInput, RootForm};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [20, 40], "2 mm".parse()?, "0 deg".parse()?, "20 mm".parse()?,
    /// ))?;
    /// let tooth = pair.transverse_tooth(Gear::Pinion, RootForm::default());
    /// let tip = tooth.outline[tooth.outline.len() - 1];
    /// assert!(tooth.is_root_cut && (tip[0] - pair.tip_radius[0].si()).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn transverse_tooth(&self, gear: Gear, root: RootForm) -> TransverseTooth {
        let index = gear as usize;
        let is_ring = self.internal && index == 1;
        let sign = if is_ring { -1.0 } else { 1.0 };
        let shifts = self.profile_shift;
        let shift = shifts.unwrap_or_else(|| self.likely_profile_shift())[index];
        let teeth = f64::from(self.teeth[index]);
        let normal = self.normal_pressure_angle.si();
        let reference = self.transverse_pressure_angle.si();
        let half_reference = (std::f64::consts::FRAC_PI_2 + 2.0 * shift * normal.tan()) / teeth;
        let involute = ToothInvolute {
            sign,
            base_radius: self.base_radius[index].si().abs(),
            base_half_angle: half_reference + sign * (reference.tan() - reference),
        };
        let tip = self.tip_radius[index].si().abs();
        let radius = self.reference_radius[index].si().abs();
        let module = self.normal_module.si();
        let root_radius = radius - sign * module * (root.dedendum - shift);
        let fillet = TransverseFillet {
            rack: RackEdge::new(root, shift, module, normal),
            radius,
            teeth,
            lean: self.helix.si().cos(),
        };
        let cut = if is_ring {
            None
        } else {
            cut_root(&fillet, &involute, 1.0 / normal.tan())
        };
        let middle = std::f64::consts::PI / teeth;
        let (foot, involute_start) = match &cut {
            Some((points, start)) => (points.clone(), *start),
            None => {
                let start = involute.roll_at(root_radius);
                (vec![[root_radius, involute.half_angle(start)]], start)
            }
        };
        let end = involute.roll_at(tip);
        let step = (end - involute_start) / POINTS as f64;
        let flank = (0..=POINTS).map(|k| involute.point(involute_start + step * k as f64));
        let from_middle = foot.first().map(|point| [point[0], middle]);
        let mut outline: Vec<[f64; 2]> = from_middle.into_iter().chain(foot).collect();
        outline.extend(flank);
        outline.push([tip, 0.0]);
        for point in &mut outline {
            // A tooth ends in the middle of the tooth space.
            point[1] = point[1].clamp(0.0, middle);
        }
        TransverseTooth {
            outline,
            involute_start,
            is_root_cut: cut.is_some() || is_ring,
            involute,
        }
    }

    /// Length of contact below the involute of `gear`, as a roll length: the mating tip is then in contact with the
    /// fillet, which no load distribution models. `None` if all contact is on the involute (within a hundredth of a
    /// module), for a ring, and if the profile shifts or the root are unknown.
    ///
    /// ```
    /// use asperity_gear::{Gear, GearPair, GearPairInput, RootForm};
    /// let [module, width] = ["2 mm".parse()?, "20 mm".parse()?];
    /// let standard = GearPairInput::standard([20, 40], module, "0 deg".parse()?, width);
    /// let pair = |addendum| GearPair::new(&GearPairInput { addendum, ..standard });
    /// let root = RootForm::default();
    /// assert_eq!(pair(1.0)?.contact_below_involute(Gear::Pinion, root), None);
    /// assert!(pair(1.2)?.contact_below_involute(Gear::Pinion, root).is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn contact_below_involute(&self, gear: Gear, root: RootForm) -> Option<Length> {
        /// Neglected roll length in modules.
        const TOLERANCE: f64 = 0.01;
        self.profile_shift?;
        let is_ring = self.internal && gear == Gear::Wheel;
        let tooth = self.transverse_tooth(gear, root);
        let lowest = match gear {
            Gear::Pinion => self.path.a.si(),
            Gear::Wheel => self.path.t1t2.si() - self.path.e.si(),
        };
        let below = tooth.involute_start - lowest;
        let is_known = tooth.is_root_cut && !is_ring;
        (is_known && below > TOLERANCE * self.normal_module.si()).then(|| Length::from_si(below))
    }
}

/// Points of the fillet, and the roll length of its end on the involute; `None` if the rack is pointed above its
/// rounding, cuts the teeth off at their roots, or does not reach the involute.
fn cut_root(
    fillet: &TransverseFillet,
    involute: &ToothInvolute,
    end: f64,
) -> Option<(Vec<[f64; 2]>, f64)> {
    let foot = fillet.point(0.0);
    let rack = fillet.rack;
    if rack.edge < 0.0 || rack.depth + rack.rounding >= fillet.radius || foot[1] <= 0.0 {
        return None;
    }
    // Positive if the fillet is wider than the involute.
    let excess = |t: f64| {
        let [radius, angle] = fillet.point(t);
        angle - involute.half_angle(involute.roll_at(radius))
    };
    let last = fillet.point(end);
    // Start of the involute generated by the straight flank of the rack; negative with undercut.
    let sin = end.recip() / (fillet.lean.powi(2) + end.recip().powi(2)).sqrt();
    let start = fillet.radius * sin - (rack.depth + rack.rounding / (1.0 + end * end).sqrt()) / sin;
    let (stop, start) = if start >= 0.0 {
        (end, involute.roll_at(last[0]))
    } else {
        let base = find_root(
            |t| fillet.point(t)[0] - involute.base_radius,
            0.0,
            end,
            1e-12 * end,
        )
        .map_or(0.0, |root| root.value);
        let stop = find_root(excess, base, end * (1.0 - 1e-9), 1e-12 * end)
            .ok()?
            .value;
        (stop, involute.roll_at(fillet.point(stop)[0]))
    };
    let points = (0..=POINTS).map(|k| fillet.point(stop * k as f64 / POINTS as f64));
    Some((points.collect(), start))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::GearPairInput;

    fn pair(teeth: [u32; 2], helix: &str) -> GearPair {
        GearPair::new(&GearPairInput::standard(
            teeth,
            "2 mm".parse().unwrap(),
            helix.parse().unwrap(),
            "20 mm".parse().unwrap(),
        ))
        .unwrap()
    }

    fn fillet_end(tooth: &TransverseTooth) -> ([f64; 2], [f64; 2]) {
        // Middle of the space, then POINTS + 1 points of the fillet, then the involute.
        (tooth.outline[POINTS + 1], tooth.outline[POINTS + 2])
    }

    #[test]
    fn the_fillet_of_a_helical_tooth_meets_its_involute() {
        for (teeth, helix) in [
            ([23, 68], "23.4 deg"),
            ([40, 41], "0 deg"),
            ([30, 90], "45 deg"),
        ] {
            let pair = pair(teeth, helix);
            for gear in [Gear::Pinion, Gear::Wheel] {
                let tooth = pair.transverse_tooth(gear, RootForm::default());
                assert!(tooth.is_root_cut);
                let (fillet, involute) = fillet_end(&tooth);
                // Radius and angle at which two independent formulas meet, to rounding.
                assert!((fillet[0] / involute[0] - 1.0).abs() < 1e-12, "{teeth:?}");
                assert!((fillet[1] - involute[1]).abs() < 1e-12, "{teeth:?} {helix}");
            }
        }
    }

    #[test]
    fn an_undercut_tooth_passes_from_its_fillet_to_its_involute_without_a_step() {
        let pair = pair([14, 20], "0 deg");
        let tooth = pair.transverse_tooth(Gear::Pinion, RootForm::default());
        assert!(tooth.is_root_cut && tooth.involute_start > 0.0);
        let (fillet, involute) = fillet_end(&tooth);
        assert!((fillet[0] / involute[0] - 1.0).abs() < 1e-9);
        assert!((fillet[1] - involute[1]).abs() < 1e-9);
        // The fillet has cut into the involute: its neck is narrower than where it meets that.
        let neck = tooth.outline.iter().map(|point| point[1]).take(POINTS + 1);
        assert!(neck.fold(f64::INFINITY, f64::min) < involute[1]);
    }

    #[test]
    fn the_root_lies_a_dedendum_below_the_reference_circle() {
        let tooth = pair([20, 40], "0 deg").transverse_tooth(Gear::Pinion, RootForm::default());
        // r − 1.25 m = 20 mm − 2.5 mm.
        assert!((tooth.outline[0][0] - 17.5e-3).abs() < 1e-12);
        assert!((tooth.outline[0][1] - std::f64::consts::PI / 20.0).abs() < 1e-12);
    }

    #[test]
    fn a_pointed_tool_leaves_a_straight_root() {
        let root = RootForm {
            dedendum: 1.25,
            fillet_radius: 0.9,
        };
        let tooth = pair([20, 40], "0 deg").transverse_tooth(Gear::Pinion, root);
        assert!(!tooth.is_root_cut && tooth.outline.iter().flatten().all(|v| v.is_finite()));
    }

    #[test]
    fn the_tip_of_a_ring_with_full_addendum_meets_the_fillet_of_its_pinion() {
        let full = GearPairInput::standard(
            [24, 75],
            "1.5 mm".parse().unwrap(),
            "0 deg".parse().unwrap(),
            "20 mm".parse().unwrap(),
        );
        let ring = |addendum| GearPair::internal(&GearPairInput { addendum, ..full }).unwrap();
        let root = RootForm::default();
        // Contact begins at 1.19 mm, the involute of the pinion at 1.77 mm.
        let below = ring(1.0)
            .contact_below_involute(Gear::Pinion, root)
            .unwrap();
        assert!((below.si() - 0.58e-3).abs() < 0.01e-3, "{below:?}");
        assert_eq!(ring(1.0).contact_below_involute(Gear::Wheel, root), None);
        assert_eq!(ring(0.85).contact_below_involute(Gear::Pinion, root), None);
    }

    #[test]
    fn a_ring_tooth_is_thinner_towards_its_tip() {
        let ring = GearPair::internal(&GearPairInput::standard(
            [24, 75],
            "1.5 mm".parse().unwrap(),
            "0 deg".parse().unwrap(),
            "20 mm".parse().unwrap(),
        ))
        .unwrap();
        let tooth = ring.transverse_tooth(Gear::Wheel, RootForm::default());
        let (root, tip) = (tooth.outline[1], tooth.outline[tooth.outline.len() - 2]);
        assert!(tip[0] < root[0] && tip[1] < root[1]);
        // Half the pitch at the reference circle of a ring without shift.
        let reference = 1.5e-3 * 75.0 / 2.0;
        let roll = tooth.involute.roll_at(reference);
        let half = tooth.half_angle(roll);
        assert!((half - std::f64::consts::FRAC_PI_2 / 75.0).abs() < 1e-12);
    }
}
