//! One solved mesh position, as data.

use asperity_contact::ContactWarning;
use asperity_ehl_regime::Regime;

use super::friction::{InFilm, Rubbing};
use super::full_film::FullFilm;
use crate::mesh::MeshPosition;
use crate::records::RecordedShare;
use asperity_case::case::OperatingCase;
use asperity_case::error::PositionError;
use asperity_case::flanks::Roughness;
use asperity_case::formula_film::FormulaFilm;
use asperity_case::window_pressures::{DeformationPower, Pressed};
use asperity_mixed_film::LoadShareSolution;

/// A mesh position with everything that varies over the offsets.
#[derive(Debug, Clone)]
pub(crate) struct LubricatedPosition {
    pub at: MeshPosition,
    pub film: FormulaFilm,
    pub offsets: Vec<LubricatedWindow>,
    /// Elastohydrodynamic solution of the full film, if the case requests it and an offset has a full film.
    pub full_film: Option<FullFilm>,
    /// Doubts about the rough contacts that were solved.
    pub doubts: Vec<ContactWarning>,
    /// Pressures of the first offset, if friction follows from them.
    pub pressed: Option<Pressed>,
}

impl LubricatedPosition {
    /// Largest pressure of the rough contact, as a mean over the offsets where the flanks touch \[MPa\];
    /// `None` if they do not touch.
    pub(crate) fn rough_pressure(&self) -> Option<f64> {
        let contacts = self.offsets.iter().filter_map(|offset| offset.contact);
        let pressures: Vec<f64> = contacts.map(|contact| contact.p_max * 1e-6).collect();
        let sum = || {
            pressures
                .iter()
                .fold(0.0, |sum: f64, pressure| sum + pressure)
        };
        (!pressures.is_empty()).then(|| sum() / pressures.len() as f64)
    }

    /// Largest pressure of the rough contact, or the Hertz pressure if the flanks do not touch: a report shows the
    /// position where it is highest.
    pub(crate) fn shown_pressure(&self) -> f64 {
        let hertz = self.at.hertz.max_pressure.si() * 1e-6;
        self.rough_pressure().unwrap_or(hertz)
    }
}

impl LubricatedPosition {
    /// Pressure of a film that carries the whole load at the points `x` \[m\]: of its solution, or without one of the
    /// smooth dry contact, which a full film takes over all but its inlet and its outlet.
    pub fn film_pressure(&self, x: &[f64]) -> Result<Vec<f64>, PositionError> {
        match &self.full_film {
            Some(film) => Ok(film.pressure_at(x)),
            None => self.at.hertz_pressure(x, 1.0),
        }
    }
}

/// One offset of the traces at a mesh position.
#[derive(Debug, Clone)]
pub(crate) struct LubricatedWindow {
    pub roughness: Roughness,
    /// Λ*; `None` if the flanks have no peaks or these are not known.
    pub lambda_star: Option<f64>,
    /// h_min/S.
    pub film_ratio: f64,
    pub regime: Regime,
    /// Share of the load that the film carries.
    pub film_share: f64,
    /// Share of the asperities' load that rubs with the boundary coefficient.
    pub boundary_part: f64,
    /// Friction coefficient of the lubricated asperities.
    pub lubricated_coefficient: f64,
    /// The rough contact at its share, if the load-share law depends on it.
    pub solved: Option<LoadShareSolution>,
    /// Shares and friction of the neighbouring records, if the load-share law requires them.
    pub recorded: Option<RecordedShare>,
    /// Friction in the film.
    pub friction: InFilm,
    /// Contributions of asperities and film to the friction force.
    pub rubbing: Rubbing,
    /// Friction force per metre of contact line \[N/m\].
    pub friction_force: f64,
    /// Flash temperature of film and asperities together \[K\].
    pub flash: f64,
    /// Numbers of the rough contact, if it was solved and the flanks touch.
    pub contact: Option<ContactNumbers>,
    /// Power of the deformation, if friction follows from pressures.
    pub deformation: Option<DeformationPower>,
}

impl LubricatedWindow {
    /// Shear stress on the pinion's flank \[Pa\] under the pressures `pressed`.
    pub fn shear(
        &self,
        case: &OperatingCase,
        position: &MeshPosition,
        pressed: &Pressed,
    ) -> Vec<f64> {
        // Friction drags the pinion's flank against its sliding.
        let sign = -position.motion.sliding.si().signum();
        let mu_solid = self.asperity_coefficient(case.model.boundary_friction);
        let solid = pressed.solids.as_ref().map(|solids| &solids.pressure);
        let fluid = pressed.fluid.iter().enumerate();
        fluid
            .map(|(i, f)| {
                sign * (mu_solid * solid.map_or(0.0, |solid| solid[i]) + self.friction.mu * f)
            })
            .collect()
    }

    /// Mean friction coefficient of the asperities, with the coefficient `boundary` of the boundary layer.
    pub fn asperity_coefficient(&self, boundary: f64) -> f64 {
        self.boundary_part * boundary + (1.0 - self.boundary_part) * self.lubricated_coefficient
    }
}

/// Numbers of a rough contact.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ContactNumbers {
    pub contact_fraction: f64,
    pub p_max: f64,
    /// Plastic work \[J/m\].
    pub plastic_work: f64,
    pub iterations: usize,
    pub load_error: f64,
    pub duality_gap: f64,
}
