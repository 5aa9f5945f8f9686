//! Ra, Rq and Rz of a single section, for windows too short to be divided into sections.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z | heights from the mean line | m |

use asperity_core::cite;
use asperity_core::numerics::{extremes, sum};
use asperity_core::quantity::Length;

use crate::error::RoughnessError;

/// Ra, Rq and Rz of one section.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct SectionHeights {
    /// Arithmetic mean height Ra.
    pub ra: Length,
    /// Root mean square height Rq.
    pub rq: Length,
    /// Maximum height Rz.
    pub rz: Length,
}

/// Ra = ⟨|z|⟩,  Rq = √⟨z²⟩,  Rz = max z − min z                                [Section-2]
///
/// Equal to the height parameters of a profile of one section, without widths and slopes.
///
/// # Errors
/// When `heights` is empty.
///
/// ```
/// use asperity_roughness::section_heights::section_heights;
/// let section = section_heights(&[1e-6, -1e-6, 1e-6, -1e-6])?;
/// assert_eq!((section.ra.si(), section.rz.si()), (1e-6, 2e-6));
/// # Ok::<(), asperity_roughness::RoughnessError>(())
/// ```
pub fn section_heights(heights: &[f64]) -> Result<SectionHeights, RoughnessError> {
    cite!("Section-2");
    RoughnessError::at_least(heights.len(), 1, "a section")?;
    let n = heights.len() as f64;
    let (low, high) = extremes(heights);
    Ok(SectionHeights {
        ra: Length::from_si(sum(heights, f64::abs) / n),
        rq: Length::from_si((sum(heights, |z| z * z) / n).sqrt()),
        rz: Length::from_si(high - low),
    })
}

#[cfg(test)]
mod tests {
    use asperity_core::Profile;

    use super::*;
    use crate::height_parameters::{Mode, in_sections};

    #[test]
    fn one_section_has_the_heights_of_a_profile_of_one_section() {
        let z: Vec<f64> = (0..501)
            .map(|i| 1e-6 * (f64::from(i) * 0.37).sin() + 2e-7 * (f64::from(i) * 1.9).cos())
            .collect();
        let found = section_heights(&z).unwrap();
        let profile = Profile::new(Length::from_si(1e-6), z).unwrap();
        let whole = in_sections(&profile, Mode::Iso4287, 1).unwrap();
        assert_eq!((found.ra, found.rq), (whole.ra, whole.rq));
        assert!((found.rz / whole.rz - 1.0).abs() < 1e-15);
    }

    #[test]
    fn no_heights_are_refused() {
        assert!(section_heights(&[]).is_err());
    }
}
