//! Length of the lines of contact at a mesh phase and over a mesh cycle.
//!
//! Source: Niemann and Winter, Maschinenelemente II; the strips are exact for true involutes.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | φ | mesh phase: the profile coordinate of one tooth at the front face, modulo 1 | - |
//! | l | total length of the contact lines | m |
//! | ξ | profile coordinate in base pitches | - |
//!
//! A tooth at φ + j on the front face is in contact on φ + j ≤ ξ ≤ φ + j + ε_β, limited to the path 0 ≤ ξ ≤ ε_α: a
//! strip.

use asperity_core::DomainError;
use asperity_core::cite;
use asperity_core::quantity::Length;

use crate::error::GearError;
use crate::pair::GearPair;
use crate::quadrature::breakpoints;

impl GearPair {
    /// l(φ) = (b/(ε_β cos β_b))·Σⱼ \[min(φ + j + ε_β, ε_α) − max(φ + j, 0)\]₊; a spur pair has b for each pair of teeth
    /// in contact                                               [Length-1]
    ///
    /// # Errors
    /// When the phase is not finite.
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let spur = GearPair::new(&GearPairInput::standard(
    ///     [20, 40], "2 mm".parse()?, "0 deg".parse()?, "20 mm".parse()?,
    /// ))?;
    /// assert_eq!(spur.contact_length(0.1)?.si(), 2.0 * 20e-3);
    /// assert_eq!(spur.contact_length(0.9)?.si(), 20e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn contact_length(&self, phase: f64) -> Result<Length, GearError> {
        cite!("Length-1");
        DomainError::require(
            phase.is_finite(),
            "mesh phase",
            phase,
            "-",
            "must be finite",
        )?;
        Ok(self.length_at(phase.rem_euclid(1.0)))
    }

    /// l̄ = b ε_α/cos β_b, exactly                                               [Length-2]
    ///
    /// ```
    /// use asperity_gear::{GearPair, GearPairInput};
    /// let pair = GearPair::new(&GearPairInput::standard(
    ///     [50, 120], "1.3 mm".parse()?, "30 deg".parse()?, "50 mm".parse()?,
    /// ))?;
    /// assert!((pair.mean_contact_length().si() - 82.28644e-3).abs() < 1e-8);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn mean_contact_length(&self) -> Length {
        cite!("Length-2");
        self.face_width * (self.path.eps_alpha / self.base_helix.si().cos())
    }

    fn length_at(&self, phase: f64) -> Length {
        let eps_alpha = self.path.eps_alpha;
        if self.is_spur() {
            let pairs = (eps_alpha - phase).ceil().max(0.0);
            return self.face_width * pairs;
        }
        let covered: f64 = self.strips(phase).map(|(from, to)| to - from).sum();
        self.face_width * (covered / (self.path.eps_beta * self.base_helix.si().cos()))
    }

    /// The strips (from ξ, to ξ) of a helical pair in contact at a phase in 0..1.
    pub(crate) fn strips(&self, phase: f64) -> impl Iterator<Item = (f64, f64)> {
        self.numbered_strips(phase).map(|(_, from, to)| (from, to))
    }

    /// The strips with the number j of the tooth, which is at φ + j on the front face.
    pub(crate) fn numbered_strips(&self, phase: f64) -> impl Iterator<Item = (i64, f64, f64)> {
        let (eps_alpha, eps_beta) = (self.path.eps_alpha, self.path.eps_beta);
        let first = (-eps_beta - phase).floor() as i64;
        let last = (eps_alpha - phase).ceil() as i64;
        (first..=last).filter_map(move |tooth| {
            let front = phase + tooth as f64;
            let (from, to) = (front.max(0.0), (front + eps_beta).min(eps_alpha));
            (to > from).then_some((tooth, from, to))
        })
    }

    /// Phases 0..1 at which the end of a strip passes an end of the path or one of the coordinates `marks`.
    pub(crate) fn phase_breakpoints(&self, marks: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let eps_beta = self.path.eps_beta;
        let ends = [0.0, self.path.eps_alpha].into_iter().chain(marks);
        let phases = ends.flat_map(|xi| [xi.rem_euclid(1.0), (xi - eps_beta).rem_euclid(1.0)]);
        breakpoints(0.0, 1.0, phases)
    }
}
