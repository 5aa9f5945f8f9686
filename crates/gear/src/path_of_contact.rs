//! The path of contact: the part of the line of action on which the teeth are in contact.
//!
//! Source: ISO 21771:2007.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | s | distance from T₁ along the transverse line of action | m |
//! | T₁, T₂ | feet of the perpendiculars from the axes to the line of action | |
//! | A, E | first and last point of contact when gear 1 drives | m |
//! | B, D | ends of single contact of a spur pair, 1 < ε_α < 2 | m |
//! | C | pitch point | m |
//! | p_et | transverse base pitch | m |
//! | ε₁, ε₂, ε_α | tip contact ratios, transverse contact ratio | - |
//! | ε_β, ε_γ | overlap ratio, total contact ratio | - |
//! | ξ | (s − A)/p_et, profile coordinate | - |

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::Length;
use serde::{Deserialize, Serialize};

use crate::error::{Gear, GearError};

/// Overlap ratio below which the helix angle is a rounding error and the pair is a spur pair.
pub(crate) const MIN_OVERLAP: f64 = 1e-9;

/// Overlap ratio above which an error of units is assumed.
const MAX_OVERLAP: f64 = 1000.0;

/// Points along the line of action, as distances from T₁, and the contact ratios.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PathOfContact {
    /// A: start of contact at the tip of gear 2.
    pub a: Length,
    /// B = E − p_et: the pair ahead leaves contact. Before A when ε_α < 1.
    pub b: Length,
    /// C: the pitch point, without sliding.
    pub c: Length,
    /// D = A + p_et: the pair behind enters contact. After E when ε_α < 1.
    pub d: Length,
    /// E: end of contact at the tip of gear 1.
    pub e: Length,
    /// Distance T₁T₂; negative for a ring, whose T₂ lies behind T₁.
    pub t1t2: Length,
    /// Length of the path, A to E.
    pub length: Length,
    /// Transverse base pitch p_et.
    pub base_pitch: Length,
    /// Tip contact ratio of gear 1, ε₁; negative when C lies beyond E.
    pub eps_1: f64,
    /// Tip contact ratio of gear 2, ε₂; negative when C lies before A.
    pub eps_2: f64,
    /// Transverse contact ratio ε_α.
    pub eps_alpha: f64,
    /// Overlap ratio ε_β.
    pub eps_beta: f64,
    /// Total contact ratio ε_γ.
    pub eps_gamma: f64,
}

impl PathOfContact {
    /// The points A to E with their letters. B and D are outside the path if ε_α < 1.
    #[must_use]
    pub fn named_points(&self) -> [(&'static str, Length); 5] {
        [
            ("A", self.a),
            ("B", self.b),
            ("C", self.c),
            ("D", self.d),
            ("E", self.e),
        ]
    }

    /// T₁T₂ = (r_b1 + r_b2)·tan α_wt, A = T₁T₂ − sgn(z₂)·√(r_a2² − r_b2²), E = √(r_a1² − r_b1²),
    /// C = r_b1·tan α_wt, B = E − p_et, D = A + p_et                           [Path-1]
    ///
    /// ε₁ = (E − C)/p_et, ε₂ = (C − A)/p_et, ε_α = ε₁ + ε₂, ε_β = b·tan β_b/p_et  [Path-2]
    ///
    /// `advance` is b·tan β_b, the advance of the contact over the face width.
    pub(crate) fn new(
        base_radius: [Length; 2],
        tip_radius: [Length; 2],
        working_angle: f64,
        base_pitch: Length,
        advance: Length,
    ) -> Result<Self, GearError> {
        cite!("Path-1");
        cite!("Path-2");
        let [rb1, rb2] = base_radius.map(Length::si);
        let [ra1, ra2] = tip_radius.map(Length::si);
        let t1t2 = (rb1 + rb2) * working_angle.tan();
        // (r_a − r_b)(r_a + r_b) avoids the cancellation of r_a² − r_b².
        let reach_1 = ((ra1 - rb1) * (ra1 + rb1)).sqrt();
        let reach_2 = ((ra2 - rb2) * (ra2 + rb2)).sqrt();
        for (gear, reach) in [(Gear::Pinion, reach_1), (Gear::Wheel, reach_2)] {
            DomainError::finite("length of the path of contact", Length::from_si(reach))?;
            if rb2 > 0.0 && reach > t1t2 {
                return Err(GearError::interference(
                    gear,
                    Length::from_si(reach),
                    Length::from_si(t1t2),
                ));
            }
        }
        let p = DomainError::positive("base pitch", base_pitch)?;
        let (a, c, e) = (
            t1t2 - reach_2.copysign(rb2),
            rb1 * working_angle.tan(),
            reach_1,
        );
        if a <= 0.0 && rb2 < 0.0 {
            return Err(GearError::ring_interference(Length::from_si(a)));
        }
        let path = Self {
            a: Length::from_si(a),
            b: Length::from_si(e - p),
            c: Length::from_si(c),
            d: Length::from_si(a + p),
            e: Length::from_si(e),
            t1t2: Length::from_si(t1t2),
            length: Length::from_si(e - a),
            base_pitch,
            eps_1: (e - c) / p,
            eps_2: (c - a) / p,
            eps_alpha: (e - a) / p,
            eps_beta: advance / base_pitch,
            eps_gamma: (e - a) / p + advance / base_pitch,
        };
        path.require_continuous_contact()?;
        Ok(path)
    }

    fn require_continuous_contact(&self) -> Result<(), GearError> {
        let Self {
            eps_alpha,
            eps_beta,
            eps_gamma,
            ..
        } = *self;
        if eps_alpha <= 0.0 {
            return Err(GearError::no_contact(self.length));
        }
        DomainError::require(
            eps_beta < MAX_OVERLAP,
            "overlap ratio",
            eps_beta,
            "-",
            "is impossible; check face width and module",
        )?;
        if eps_beta < MIN_OVERLAP && eps_alpha <= 1.0 {
            return Err(GearError::spur_contact_ratio(eps_alpha));
        }
        if eps_gamma <= 1.0 {
            return Err(GearError::total_contact_ratio(eps_gamma));
        }
        Ok(())
    }

    /// ξ = (s − A)/p_et, the profile coordinate in base pitches: 0 at A, ε_α at E   [Path-3]
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [20, 40], "2 mm".parse()?, "0 deg".parse()?, "20 mm".parse()?,
    /// ))?;
    /// assert_eq!(pair.path().coordinate(pair.path().e), pair.path().eps_alpha);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn coordinate(&self, s: Length) -> f64 {
        cite!("Path-3");
        (s - self.a) / self.base_pitch
    }

    /// Distance from T₁ of the profile coordinate ξ.
    pub fn place(&self, xi: f64) -> Length {
        self.a + self.base_pitch * xi
    }

    /// The profile coordinate of `s`, which must be on the path.
    pub(crate) fn coordinate_on_path(&self, s: Length) -> Result<f64, GearError> {
        if s >= self.a && s <= self.e {
            Ok(self.coordinate(s))
        } else {
            Err(GearError::off_path(s, self.a, self.e))
        }
    }
}
