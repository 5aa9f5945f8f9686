//! Two measured flanks pressed together.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | z₁, z₂ | heights of the flanks, each out of its own material | m |
//! | x | position from the middle of the profiles | m |
//! | R | relative radius of curvature | m |
//! | h | undeformed gap | m |

use asperity_core::profile::common_spacing;
use asperity_core::quantity::{Length, LineLoad, Pressure};
use asperity_core::{DomainError, Profile, cite};

use crate::boundary::Boundary;
use crate::error::ContactError;
use crate::plasticity::displaced_profile;
use crate::problem::{ContactProblem, ContactSolution, Control, SolverSettings};
use crate::solver::solve;

/// Two profiles and the conditions of their contact.
///
/// ```
/// use asperity_contact::{SolverSettings, two_flanks::TwoFlanks};
/// use asperity_core::Profile;
/// let smooth = Profile::new("0.5 um".parse()?, vec![0.0; 1200])?;
/// let flanks = TwoFlanks {
///     first: &smooth, second: &smooth, radius: "3 mm".parse()?,
///     load: "300 N/mm".parse()?, modulus: "115.4 GPa".parse()?, pressure_limit: None,
/// };
/// let solution = flanks.press(&SolverSettings::default())?;
/// assert!((solution.max_pressure.si() / 1.9166e9 - 1.0).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct TwoFlanks<'a> {
    /// One flank.
    pub first: &'a Profile,
    /// The other flank, in the direction of the first: point i faces point i of the first.
    pub second: &'a Profile,
    /// Relative radius of curvature R.
    pub radius: Length,
    /// Load per metre of face width.
    pub load: LineLoad,
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Pressure at which the softer flank flows.
    pub pressure_limit: Option<Pressure>,
}

impl TwoFlanks<'_> {
    /// h = x²/(2·R) − z₁ − z₂, x from the middle                                  [Flanks-1]
    ///
    /// # Errors
    /// When the profiles differ in length or spacing, or the radius is not positive.
    pub fn gap(&self) -> Result<Vec<f64>, ContactError> {
        cite!("Flanks-1");
        let (first, second) = (self.first, self.second);
        if first.len() != second.len() {
            return Err(ContactError::WrongLength {
                name: "second flank",
                need: first.len(),
                got: second.len(),
            });
        }
        let dx = self.spacing()?.si();
        let r = DomainError::positive("radius of curvature", self.radius)?;
        let middle = 0.5 * (first.len() - 1) as f64;
        let heights = first.heights().iter().zip(second.heights());
        Ok(heights
            .enumerate()
            .map(|(i, (z1, z2))| {
                let x = (i as f64 - middle) * dx;
                x * x / (2.0 * r) - z1 - z2
            })
            .collect())
    }

    /// Presses the flanks together, with free ends.
    ///
    /// # Errors
    /// When an input is not valid or the contact is not solved to the tolerance.
    pub fn press(&self, settings: &SolverSettings) -> Result<ContactSolution, ContactError> {
        solve(&self.problem(&self.gap()?)?, settings)
    }

    /// Spacing of the gap: the finer spacing of the flanks.
    ///
    /// # Errors
    /// When the spacings differ by more than [`common_spacing`] allows.
    pub fn spacing(&self) -> Result<Length, ContactError> {
        let [first, second] = [self.first, self.second].map(Profile::spacing);
        let common = common_spacing(first, second).ok_or(DomainError {
            name: "spacing of the second flank",
            value: second.si(),
            unit: "m",
            rule: "must equal the spacing of the first flank within 1e-5: resample one of the profiles",
        })?;
        Ok(common)
    }

    /// The contact problem over this gap.
    pub(crate) fn problem<'a>(&self, gap: &'a [f64]) -> Result<ContactProblem<'a>, ContactError> {
        Ok(ContactProblem {
            gap,
            spacing: self.spacing()?,
            modulus: self.modulus,
            boundary: Boundary::FreeEnds,
            control: Control::Load(self.load),
            lead: None,
            prescribed_pressure: None,
            pressure_limit: self.pressure_limit,
            start: None,
        })
    }

    /// The flanks after unloading, each lowered by its share of the plastic displacement
    /// ([`plastic_shares`](crate::plasticity::plastic_shares)).
    ///
    /// # Errors
    /// When a share is not finite.
    pub fn residual(
        &self,
        solution: &ContactSolution,
        shares: [f64; 2],
    ) -> Result<[Profile; 2], ContactError> {
        let residual = |flank: &Profile, share: f64| {
            let heights = displaced_profile(flank.heights(), &solution.plastic_displacement, share);
            Profile::new(flank.spacing(), heights)
        };
        Ok([
            residual(self.first, shares[0])?,
            residual(self.second, shares[1])?,
        ])
    }
}
