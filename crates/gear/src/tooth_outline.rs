//! Outline of a tooth in the normal section: involute flank and the fillet that a rack tool leaves.
//!
//! Source: ISO 21771:2007 (involute); envelope of the rounded edge of a rack, own derivation.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | teeth of the virtual spur gear, z/(cos² β_b cos β) | - |
//! | r, r_b | reference and base radius of the virtual gear | m |
//! | ρ | roll length: radius of curvature of the involute | m |
//! | γ | half the angle that the tooth fills at a radius | rad |
//! | y, X | height above the axis and half thickness of the outline | m |
//! | h_fP*, ρ_fP* | dedendum and tip rounding of the rack, in modules | - |
//!
//! The height η of a point counts from the root chord, away from the body of the gear.

use asperity_core::cite;
use asperity_core::quantity::Length;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::error::{Gear, GearError};
use crate::pair::GearPair;
use crate::quadrature::gauss_legendre;
use std::num::NonZeroUsize;

/// Points on the fillet; its integrals are then exact to 1e-9.
const FILLET_ORDER: NonZeroUsize = NonZeroUsize::MIN.saturating_add(23);

/// The part of the basic rack that makes the root, in normal modules.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RootForm {
    /// Dedendum h_fP* of the rack.
    pub dedendum: f64,
    /// Radius ρ_fP* of the rounding at the tip of the tool.
    pub fillet_radius: f64,
}

impl Default for RootForm {
    /// 1.25 and 0.38 (ISO 53:1998, profile A).
    fn default() -> Self {
        Self {
            dedendum: 1.25,
            fillet_radius: 0.38,
        }
    }
}

/// Involute of a tooth of the virtual spur gear.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Flank {
    /// 1, or −1 for a ring.
    pub(crate) sign: f64,
    pub(crate) teeth: f64,
    pub(crate) module: f64,
    pub(crate) pressure_angle: f64,
    pub(crate) reference_radius: f64,
    pub(crate) base_radius: f64,
    pub(crate) shift: f64,
    /// γ where the involute begins, on the base circle.
    base_half_angle: f64,
}

/// A point of the outline.
#[derive(Debug, Clone, Copy)]
pub(crate) struct OutlinePoint {
    pub(crate) height: f64,
    pub(crate) half_thickness: f64,
    /// dy over the parameter of the curve.
    pub(crate) slope: f64,
}

impl Flank {
    /// z_n = z/(cos² β_b cos β), r_n = m_n z_n/2, r_bn = r_n cos αₙ                [Tooth-1]
    pub(crate) fn new(pair: &GearPair, gear: usize, shift: f64) -> Self {
        cite!("Tooth-1");
        let sign = if pair.internal && gear == 1 {
            -1.0
        } else {
            1.0
        };
        let teeth = f64::from(pair.teeth[gear])
            / (pair.base_helix.si().cos().powi(2) * pair.helix.si().cos());
        let module = pair.normal_module.si();
        let a = pair.normal_pressure_angle.si();
        let reference_radius = 0.5 * module * teeth;
        let half_reference = (std::f64::consts::FRAC_PI_2 + 2.0 * shift * a.tan()) / teeth;
        Self {
            sign,
            teeth,
            module,
            pressure_angle: a,
            reference_radius,
            base_radius: reference_radius * a.cos(),
            shift,
            base_half_angle: half_reference + sign * (a.tan() - a),
        }
    }

    /// γ = (π/2 + 2 x tan αₙ)/z ± (inv αₙ − inv α) at the roll length ρ; minus for a ring.
    pub(crate) fn half_angle(&self, roll: f64) -> f64 {
        let t = roll / self.base_radius;
        self.base_half_angle - self.sign * (t - t.atan())
    }

    pub(crate) fn point(&self, roll: f64) -> OutlinePoint {
        let radius = self.base_radius.hypot(roll);
        let (sin, cos) = self.half_angle(roll).sin_cos();
        let turn = -self.sign * roll * roll / (self.base_radius * radius * radius);
        OutlinePoint {
            height: radius * cos,
            half_thickness: radius * sin,
            slope: roll / radius * cos - radius * sin * turn,
        }
    }
}

/// The rounded edge of a rack that cuts a gear, in the normal section \[m\].
#[derive(Debug, Clone, Copy)]
pub(crate) struct RackEdge {
    /// h, depth of the middle of the rounding below the reference circle.
    pub(crate) depth: f64,
    /// ρ
    pub(crate) rounding: f64,
    /// E, distance of the middle of the rounding from that of the tooth of the rack.
    pub(crate) edge: f64,
}

impl RackEdge {
    /// h = (h_fP* − ρ_fP* − x) m, E = π m/4 − h_fP* m tan αₙ − (1 − sin αₙ) ρ/cos αₙ, as part of Tooth-2
    pub(crate) fn new(root: RootForm, shift: f64, module: f64, pressure_angle: f64) -> Self {
        let (m, a) = (module, pressure_angle);
        let rounding = root.fillet_radius * m;
        Self {
            depth: (root.dedendum - root.fillet_radius - shift) * m,
            rounding,
            edge: std::f64::consts::FRAC_PI_4 * m
                - root.dedendum * m * a.tan()
                - (1.0 - a.sin()) * rounding / a.cos(),
        }
    }
}

/// Envelope of the rounded edge of a rack: P(t) for t from 0 at the root circle to cot αₙ.
#[derive(Debug, Clone, Copy)]
struct Fillet {
    rack: RackEdge,
    radius: f64,
    pitch_half_angle: f64,
}

impl Fillet {
    /// P = (h t + ρ t/√(1 + t²), r − h − ρ/√(1 + t²)), turned back by (h t − E)/r;
    /// h = (h_fP* − ρ_fP* − x) m, E = π m/4 − h_fP* m tan αₙ − (1 − sin αₙ) ρ/cos αₙ   [Tooth-2]
    fn new(flank: &Flank, root: RootForm) -> Self {
        cite!("Tooth-2");
        Self {
            rack: RackEdge::new(root, flank.shift, flank.module, flank.pressure_angle),
            radius: flank.reference_radius,
            pitch_half_angle: std::f64::consts::PI / flank.teeth,
        }
    }

    /// Radius and half angle γ of the tooth at t, and their derivatives.
    fn polar(&self, t: f64) -> [f64; 4] {
        let root = (1.0 + t * t).sqrt();
        let (h, k) = (self.rack.depth, self.rack.rounding / root);
        let (px, py) = (h * t + k * t, self.radius - h - k);
        let dk = self.rack.rounding / (root * root * root);
        let (dx, dy) = (h + dk, dk * t);
        let radius = px.hypot(py);
        let space = px.atan2(py) - (h * t - self.rack.edge) / self.radius;
        let turn = (py * dx - px * dy) / (radius * radius) - h / self.radius;
        [
            radius,
            self.pitch_half_angle - space,
            (px * dx + py * dy) / radius,
            -turn,
        ]
    }

    fn point(&self, t: f64) -> OutlinePoint {
        let [radius, angle, dradius, dangle] = self.polar(t);
        let (sin, cos) = angle.sin_cos();
        OutlinePoint {
            height: radius * cos,
            half_thickness: radius * sin,
            slope: dradius * cos - radius * sin * dangle,
        }
    }
}

/// The outline from the root to the tip.
#[derive(Debug, Clone)]
pub(crate) struct Outline {
    pub(crate) flank: Flank,
    fillet: Option<Fillet>,
    /// Parameter at which the fillet ends.
    fillet_end: f64,
    /// (η, X, weight dη) of the whole fillet.
    fillet_nodes: Vec<[f64; 3]>,
    /// Height of the end of the fillet above the root chord.
    fillet_height: f64,
    /// Roll length at which the involute takes over, or of the root circle of a ring.
    pub(crate) involute_start: f64,
    /// Height of the root chord above the axis.
    pub(crate) root_height: f64,
    /// Length s_f of the root chord.
    pub(crate) root_chord: f64,
    /// Whether the tool has cut into the involute.
    pub(crate) undercut: bool,
}

impl Outline {
    /// # Errors
    /// When no simple outline exists: the root has no thickness, the fillet folds back, or the
    /// fillet of an undercut tooth does not meet its involute.
    pub(crate) fn new(flank: Flank, root: RootForm, gear: Gear) -> Result<Self, GearError> {
        if flank.sign < 0.0 {
            return Self::ring(flank, root, gear);
        }
        let fillet = Fillet::new(&flank, root);
        let refuse = |reason| Err(GearError::RootForm { gear, reason });
        if fillet.rack.edge < 0.0 {
            return refuse("the rack is pointed above its rounding");
        }
        let end = 1.0 / flank.pressure_angle.tan();
        let sin = flank.pressure_angle.sin();
        let flank_start =
            flank.reference_radius * sin - (fillet.rack.depth + fillet.rack.rounding * sin) / sin;
        let undercut = flank_start < 0.0;
        let (fillet_end, involute_start) = if undercut {
            match crossing(&fillet, &flank, end) {
                Some(found) => found,
                None => {
                    return refuse("the fillet of the undercut tooth does not meet the involute");
                }
            }
        } else {
            (end, flank_start)
        };
        let foot = fillet.point(0.0);
        if !(foot.half_thickness > 0.0 && foot.height > 0.0) {
            return refuse("the tooth has no thickness at its root");
        }
        let nodes: Vec<[f64; 3]> = gauss_legendre(FILLET_ORDER)
            .into_iter()
            .map(|(t, weight)| {
                let point = fillet.point(t * fillet_end);
                [
                    point.height - foot.height,
                    point.half_thickness,
                    weight * fillet_end * point.slope,
                ]
            })
            .collect();
        if nodes
            .iter()
            .any(|[_, x, weight]| !(*x > 0.0 && *weight > 0.0))
        {
            return refuse("the fillet is not single-valued over the height of the tooth");
        }
        Ok(Self {
            flank,
            fillet: Some(fillet),
            fillet_end,
            fillet_nodes: nodes,
            fillet_height: fillet.point(fillet_end).height - foot.height,
            involute_start,
            root_height: foot.height,
            root_chord: 2.0 * foot.half_thickness,
            undercut,
        })
    }

    /// A ring tooth: no fillet, heights inwards from |r_f| = |r| + m (h_f − x).
    fn ring(flank: Flank, root: RootForm, gear: Gear) -> Result<Self, GearError> {
        let radius = flank.reference_radius + flank.module * (root.dedendum - flank.shift);
        let reason = "the root circle of the ring lies inside its base circle";
        if radius <= flank.base_radius {
            return Err(GearError::RootForm { gear, reason });
        }
        let start = ((radius - flank.base_radius) * (radius + flank.base_radius)).sqrt();
        let foot = flank.point(start);
        Ok(Self {
            flank,
            fillet: None,
            fillet_end: 0.0,
            fillet_nodes: Vec::new(),
            fillet_height: 0.0,
            involute_start: start,
            root_height: foot.height,
            root_chord: 2.0 * foot.half_thickness,
            undercut: false,
        })
    }

    /// Height η of the point of the flank with roll length ρ.
    pub(crate) fn flank_height(&self, roll: f64) -> f64 {
        self.flank.sign * (self.flank.point(roll).height - self.root_height)
    }

    /// ∫ from the root to η = `top` of g(η, X) dη, g summed into as many integrals as wanted.
    pub(crate) fn integrate<const N: usize>(
        &self,
        top: f64,
        rule: &[(f64, f64)],
        kernel: impl Fn(f64, f64) -> [f64; N],
    ) -> [f64; N] {
        let mut sums = [0.0; N];
        let mut add = |height: f64, half_thickness: f64, weight: f64| {
            for (sum, value) in sums.iter_mut().zip(kernel(height, half_thickness)) {
                *sum += weight * value;
            }
        };
        if let Some(fillet) = self.fillet.filter(|_| top < self.fillet_height) {
            let height = |t: f64| fillet.point(t).height - self.root_height;
            let end = bisect(|t| height(t) - top, 0.0, self.fillet_end);
            for &(node, weight) in rule {
                let point = fillet.point(node * end);
                let eta = point.height - self.root_height;
                add(eta, point.half_thickness, weight * end * point.slope);
            }
            return sums;
        }
        for &[eta, x, weight] in &self.fillet_nodes {
            add(eta, x, weight);
        }
        let end = self.roll_at_height(top);
        let (start, sign) = (self.involute_start, self.flank.sign);
        for &(node, weight) in rule {
            let point = self.flank.point(start + (end - start) * node);
            let eta = sign * (point.height - self.root_height);
            let step = sign * weight * (end - start) * point.slope;
            add(eta, point.half_thickness, step);
        }
        sums
    }

    /// Roll length at which the involute has the height η; the base circle if it does not get there.
    fn roll_at_height(&self, height: f64) -> f64 {
        let miss = |roll: f64| self.flank_height(roll) - height;
        if self.flank.sign < 0.0 {
            return bisect(|roll| -miss(roll), 0.0, self.involute_start);
        }
        let mut far = self.involute_start + self.flank.module;
        while miss(far) < 0.0 && far < self.flank.reference_radius + self.involute_start {
            far += self.flank.module;
        }
        bisect(miss, self.involute_start, far)
    }
}

/// Parameter of the fillet and roll length at which an undercut tooth passes to its involute.
fn crossing(fillet: &Fillet, flank: &Flank, end: f64) -> Option<(f64, f64)> {
    let roll = |radius: f64| {
        ((radius - flank.base_radius) * (radius + flank.base_radius))
            .max(0.0)
            .sqrt()
    };
    // Positive where the fillet is wider than the involute, as it is at its end.
    let excess = |t: f64| {
        let [radius, angle, ..] = fillet.polar(t);
        angle - flank.half_angle(roll(radius))
    };
    // The fillet leaves the base circle inside of the involute and ends outside of it.
    let base = bisect(|t| fillet.polar(t)[0] - flank.base_radius, 0.0, end);
    if !(excess(base) <= 0.0 && excess(end) > 0.0) {
        return None;
    }
    let t = bisect(excess, base, end);
    Some((t, roll(fillet.polar(t)[0])))
}

/// Root of a function that rises from `low` to `high`; the nearer end when it does not change sign.
fn bisect(function: impl Fn(f64) -> f64, low: f64, high: f64) -> f64 {
    let tolerance = 1e-13 * high.abs().max(low.abs());
    match asperity_core::numerics::find_root(&function, low, high, tolerance) {
        Ok(root) => root.value,
        Err(_) if function(low) >= 0.0 => low,
        Err(_) => high,
    }
}

/// The contact point seen from the tooth that it loads.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LoadLine {
    /// Angle a′ between the load and the normal of the centre line of the tooth.
    pub(crate) angle: f64,
    /// Height η at which the load line crosses the centre line.
    pub(crate) arm: f64,
}

impl Flank {
    /// a′ = α − γ (ring: α + γ), y_P = r_b/cos a′, h = r_C sin γ/cos a′              [Tooth-3]
    pub(crate) fn load(&self, roll: f64) -> (f64, f64, f64) {
        let roll = roll.abs();
        let half = self.half_angle(roll);
        let angle = (roll / self.base_radius).atan() - self.sign * half;
        let cos = angle.cos();
        let radius = self.base_radius.hypot(roll);
        (angle, self.base_radius / cos, radius * half.sin() / cos)
    }
}

impl Outline {
    pub(crate) fn load_line(&self, roll: f64) -> LoadLine {
        cite!("Tooth-3");
        let (angle, crossing, _) = self.flank.load(roll);
        LoadLine {
            angle,
            arm: self.flank.sign * (crossing - self.root_height),
        }
    }

    /// Radius at which the involute begins, in the virtual gear.
    pub(crate) fn form_radius(&self) -> Length {
        Length::from_si(self.flank.base_radius.hypot(self.involute_start))
    }
}
