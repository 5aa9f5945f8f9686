//! Parabolic velocity through the film.
//!
//! Wall 2 is at y = 0, wall 1 at y = h. The two wall speeds and the speed in the middle determine the
//! parabola; the middle speed follows from the flow.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | y | distance from wall 2 | m |
//! | h, H | thickness of the film | m |
//! | u₁, u₂ | speeds of the walls | m/s |
//! | u_m, u∞ | speed in the middle, here and in the paper | m/s |
//! | q | flow per unit width | m²/s |
//! | A, B, C | coefficients of the parabola | 1/(m s), 1/s, m/s |

use asperity_core::DomainError;
use asperity_core::quantity::{Length, Speed};
use serde::Serialize;

use crate::FilmError;

/// Parabolic velocity profile between two walls.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct VelocityProfile {
    /// Speed u₁ of wall 1, at y = h.
    pub wall_1: Speed,
    /// Speed in the middle of the film.
    pub middle: Speed,
    /// Speed u₂ of wall 2, at y = 0.
    pub wall_2: Speed,
    /// Thickness h of the film.
    pub thickness: Length,
}

impl VelocityProfile {
    /// u_m = (6·q/h − u₁ − u₂)/4                                                 [Profile-1]
    ///
    /// The profile that carries the flow q \[m²/s\] (Simpson's rule, exact for a parabola).
    ///
    /// # Errors
    /// When a speed or the flow is not finite or the thickness is not positive.
    ///
    /// ```
    /// use asperity_ns_film::velocity_profile::VelocityProfile;
    /// // A flow of the mean speed times the gap needs no pressure: the profile is a straight line.
    /// let profile = VelocityProfile::carrying(3e-6, "2 m/s".parse()?, "4 m/s".parse()?, "1 um".parse()?)?;
    /// assert!((profile.middle.si() - 3.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn carrying(
        flow: f64,
        wall_1: Speed,
        wall_2: Speed,
        thickness: Length,
    ) -> Result<Self, FilmError> {
        asperity_core::cite!("Profile-1");
        let q = DomainError::require(flow.is_finite(), "flow", flow, "m2/s", "must be finite")?;
        let u1 = DomainError::finite("speed of wall 1", wall_1)?;
        let u2 = DomainError::finite("speed of wall 2", wall_2)?;
        let h = DomainError::positive("film thickness", thickness)?;
        Ok(Self {
            wall_1,
            middle: Speed::from_si((6.0 * q / h - u1 - u2) / 4.0),
            wall_2,
            thickness,
        })
    }

    /// u(y) = A·y² + B·y + C                                                    `[P30]`
    ///
    /// # Errors
    /// When the thickness is not positive, a speed is not finite, or y is not within the film.
    ///
    /// ```
    /// use asperity_ns_film::velocity_profile::VelocityProfile;
    /// let profile = VelocityProfile { wall_1: "1 m/s".parse()?, middle: "2 m/s".parse()?, wall_2: "0 m/s".parse()?, thickness: "2 um".parse()? };
    /// assert!((profile.speed("1 um".parse()?)?.si() - 2.0).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn speed(&self, height: Length) -> Result<Speed, FilmError> {
        asperity_core::cite!("P30");
        let [a, b, c] = self.coefficients()?;
        let y = self.inside(height)?;
        Ok(Speed::from_si((a * y + b) * y + c))
    }

    /// du/dy = 2·A·y + B \[1/s\], the shear rate.
    ///
    /// # Errors
    /// As for [`speed`](Self::speed).
    pub fn shear_rate(&self, height: Length) -> Result<f64, FilmError> {
        let [a, b, _] = self.coefficients()?;
        Ok(2.0 * a * self.inside(height)? + b)
    }

    /// q = h·(u₁ + 4·u_m + u₂)/6 \[m²/s\], the flow.
    pub fn flow(&self) -> f64 {
        let sum = self.wall_1.si() + 4.0 * self.middle.si() + self.wall_2.si();
        self.thickness.si() * sum / 6.0
    }

    /// A = (4/H²)·((u₁ + u₂)/2 − u∞),  B = (4·u∞ − u₁ − 3·u₂)/H,  C = u₂               `[P32]`
    ///
    /// in 1/(m s), 1/s and m/s.
    ///
    /// # Errors
    /// When the thickness is not positive or a speed is not finite.
    ///
    /// ```
    /// use asperity_ns_film::velocity_profile::VelocityProfile;
    /// let profile = VelocityProfile { wall_1: "3 m/s".parse()?, middle: "2 m/s".parse()?, wall_2: "1 m/s".parse()?, thickness: "1 mm".parse()? };
    /// assert_eq!(profile.coefficients()?, [0.0, 2000.0, 1.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn coefficients(&self) -> Result<[f64; 3], FilmError> {
        asperity_core::cite!("P32");
        let u1 = DomainError::finite("speed of wall 1", self.wall_1)?;
        let um = DomainError::finite("speed in the middle", self.middle)?;
        let u2 = DomainError::finite("speed of wall 2", self.wall_2)?;
        let h = DomainError::positive("film thickness", self.thickness)?;
        Ok(parabola([u1, um, u2], h))
    }

    fn inside(&self, height: Length) -> Result<f64, DomainError> {
        let y = height.si();
        DomainError::require(
            (0.0..=self.thickness.si()).contains(&y),
            "height in the film",
            y,
            "m",
            "must lie between the walls",
        )
    }
}

/// [`VelocityProfile::coefficients`] of speeds and a thickness that were checked.
#[inline]
pub(crate) fn parabola([u1, um, u2]: [f64; 3], h: f64) -> [f64; 3] {
    [
        4.0 / (h * h) * (0.5 * (u1 + u2) - um),
        (4.0 * um - u1 - 3.0 * u2) / h,
        u2,
    ]
}
