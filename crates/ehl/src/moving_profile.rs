//! Rough surfaces that move through the contact.

use std::f64::consts::PI;

use asperity_core::quantity::Length;
use asperity_core::{DomainError, Profile};

/// Continuation of a surface beyond its profile.
#[derive(Debug, Clone, Copy, PartialEq)]
enum ProfileEnds {
    /// It repeats.
    Periodic,
    /// It is smooth, with a rise over this length \[m\] at both ends.
    Smooth { taper: f64 },
}

/// Heights of a surface over its own coordinate, out of the material.
///
/// The surface moves towards +x and its coordinate rises along x, so the end of the profile enters
/// the contact first.
///
/// ```
/// use asperity_core::Profile;
/// use asperity_ehl::MovingProfile;
/// let trace = Profile::new("1 um".parse()?, vec![1e-7; 1000])?;
/// let once = MovingProfile::single_pass(&trace, "100 um".parse()?)?;
/// assert!(once.length().is_some());
/// let again = MovingProfile::blended(&trace, "100 um".parse()?)?;
/// assert!(again.length().is_none());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct MovingProfile {
    heights: Vec<f64>,
    spacing: f64,
    ends: ProfileEnds,
    offset: f64,
}

impl MovingProfile {
    /// A smooth surface.
    pub fn smooth() -> Self {
        Self {
            heights: vec![0.0],
            spacing: 1.0,
            ends: ProfileEnds::Periodic,
            offset: 0.0,
        }
    }

    /// A surface that repeats `profile`, whose end fits its beginning.
    pub fn periodic(profile: &Profile) -> Self {
        Self {
            heights: profile.heights().to_vec(),
            spacing: profile.spacing().si(),
            ends: ProfileEnds::Periodic,
            offset: 0.0,
        }
    }

    /// A surface that repeats `profile` without a jump: over `overlap` its end fades into its beginning
    /// with the weights cos and sin, which keep the mean square of unrelated heights.
    ///
    /// # Errors
    /// When the overlap is not positive or longer than half of the profile.
    pub fn blended(profile: &Profile, overlap: Length) -> Result<Self, DomainError> {
        let steps = DomainError::positive("overlap", overlap)? / profile.spacing().si();
        let faded = steps.round() as usize;
        DomainError::require(
            (1..=profile.len() / 2).contains(&faded),
            "overlap",
            overlap.si(),
            "m",
            "must span at least one point and at most half of the profile",
        )?;
        let length = profile.len() - faded;
        let z = profile.heights();
        let mut heights = z[..length].to_vec();
        for (k, height) in heights.iter_mut().take(faded).enumerate() {
            let angle = 0.5 * PI * (k as f64 + 0.5) / faded as f64;
            *height = angle.sin() * *height + angle.cos() * z[length + k];
        }
        Ok(Self {
            heights,
            spacing: profile.spacing().si(),
            ends: ProfileEnds::Periodic,
            offset: 0.0,
        })
    }

    /// A surface with `profile` once, smooth before and behind it; at both ends the heights rise from
    /// zero over `taper`.
    ///
    /// # Errors
    /// When the taper is negative or longer than half of the profile.
    pub fn single_pass(profile: &Profile, taper: Length) -> Result<Self, DomainError> {
        let taper = DomainError::non_negative("taper", taper)?;
        DomainError::require(
            2.0 * taper <= profile.length().si(),
            "taper",
            taper,
            "m",
            "must be at most half of the profile",
        )?;
        Ok(Self {
            heights: profile.heights().to_vec(),
            spacing: profile.spacing().si(),
            ends: ProfileEnds::Smooth { taper },
            offset: 0.0,
        })
    }

    /// The same surface, started `offset` further along its profile; without effect on a single pass.
    pub fn shifted(mut self, offset: Length) -> Self {
        self.offset += offset.si();
        self
    }

    /// Length after which the surface repeats; none of one that passes once.
    pub fn period(&self) -> Option<Length> {
        match self.ends {
            ProfileEnds::Periodic => {
                Some(Length::from_si(self.heights.len() as f64 * self.spacing))
            }
            ProfileEnds::Smooth { .. } => None,
        }
    }

    /// Heights \[m\] of a surface that repeats, at neighbouring points, and the coordinate that it starts with; none of one that
    /// passes once.
    pub fn repeated(&self) -> Option<(&[f64], Length)> {
        match self.ends {
            ProfileEnds::Periodic => Some((&self.heights, Length::from_si(self.offset))),
            ProfileEnds::Smooth { .. } => None,
        }
    }

    /// Length of a surface that does not repeat.
    pub fn length(&self) -> Option<Length> {
        match self.ends {
            ProfileEnds::Periodic => None,
            ProfileEnds::Smooth { .. } => Some(Length::from_si(self.reach())),
        }
    }

    fn reach(&self) -> f64 {
        (self.heights.len() - 1) as f64 * self.spacing
    }

    /// Coordinate of the surface at x = 0 and T = 0 in a window that begins at `inlet` \[m\].
    pub(crate) fn start(&self, inlet: f64) -> f64 {
        match self.ends {
            ProfileEnds::Periodic => self.offset,
            ProfileEnds::Smooth { .. } => self.reach() - inlet,
        }
    }

    /// Height at the coordinate `s` \[m\], linear between the points.
    pub(crate) fn height(&self, s: f64) -> f64 {
        let z = &self.heights;
        let count = z.len();
        match self.ends {
            ProfileEnds::Periodic => {
                let place = (s / self.spacing).rem_euclid(count as f64);
                let k = (place as usize).min(count - 1);
                let part = place - k as f64;
                let next = if k + 1 == count { 0 } else { k + 1 };
                z[k] * (1.0 - part) + z[next] * part
            }
            ProfileEnds::Smooth { taper } => {
                let reach = self.reach();
                let inside = s.min(reach - s);
                if inside <= 0.0 {
                    return 0.0;
                }
                let k = ((s / self.spacing) as usize).min(count - 2);
                let part = s / self.spacing - k as f64;
                let fade = if inside < taper {
                    0.5 - 0.5 * (PI * inside / taper).cos()
                } else {
                    1.0
                };
                fade * (z[k] * (1.0 - part) + z[k + 1] * part)
            }
        }
    }

    /// Whether the surface is smooth everywhere.
    pub(crate) fn is_smooth(&self) -> bool {
        self.heights.iter().all(|z| *z == 0.0)
    }

    /// Length of the rise at the ends \[m\].
    pub(crate) fn taper(&self) -> f64 {
        match self.ends {
            ProfileEnds::Periodic => 0.0,
            ProfileEnds::Smooth { taper } => taper,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn trace() -> Profile {
        let heights = (0..400)
            .map(|i| 1e-7 * (0.37 * f64::from(i)).sin())
            .collect();
        Profile::new(Length::from_si(1e-6), heights).unwrap()
    }

    #[test]
    fn an_overlap_beyond_half_of_the_profile_is_refused() {
        for overlap in [1e308, 1.0, f64::MIN_POSITIVE] {
            assert!(MovingProfile::blended(&trace(), Length::from_si(overlap)).is_err());
        }
    }

    #[test]
    fn a_blended_surface_has_no_jump_where_it_repeats() {
        let surface = MovingProfile::blended(&trace(), Length::from_si(40e-6)).unwrap();
        let period = 360e-6;
        let step = |s: f64| (surface.height(s + 0.5e-6) - surface.height(s - 0.5e-6)).abs();
        // A wave of 0.1 µm and 17 µm rises by less than 0.04 µm in 1 µm.
        for k in 0..360 {
            assert!(step(1e-6 * f64::from(k)) < 6e-8);
        }
        assert!((surface.height(7.3e-6) - surface.height(7.3e-6 + 3.0 * period)).abs() < 1e-20);
    }

    #[test]
    fn a_single_pass_is_smooth_outside_of_its_profile() {
        let surface = MovingProfile::single_pass(&trace(), Length::from_si(20e-6)).unwrap();
        assert_eq!(surface.height(-1e-6), 0.0);
        assert_eq!(surface.height(1.0), 0.0);
        assert!((surface.height(100e-6) - trace().heights()[100]).abs() < 1e-20);
        assert!(surface.height(1e-6).abs() < 1e-9);
        assert!(MovingProfile::single_pass(&trace(), Length::from_si(1e-3)).is_err());
    }
}
