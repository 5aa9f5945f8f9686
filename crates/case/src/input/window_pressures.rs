//! Pressures of film and solids in a window as an extension point of a formulation, instead of the law of the load share.

use std::fmt::Debug;

use asperity_contact::ContactSolution;
use asperity_core::material::Material;
use asperity_core::quantity::{AngularSpeed, Pressure};
use asperity_gear::GearPair;
use asperity_oil::LubricantState;

use super::model::{Model, PaperChoices};
use crate::error::PositionError;
use asperity_flanks::WindowPair;
use asperity_flanks::mesh_position::MeshPosition;

/// A window at a mesh position with steels, oil and choices of its case.
#[derive(Debug, Clone, Copy)]
pub struct WindowConditions<'a> {
    /// Motion, load and smooth contact.
    pub position: &'a MeshPosition,
    /// Heights of both flanks under the contact and their gap.
    pub pair: &'a WindowPair,
    /// Gear geometry.
    pub gears: &'a GearPair,
    /// Speed of the pinion.
    pub speed: AngularSpeed,
    /// Steel of pinion and wheel.
    pub materials: &'a [Material; 2],
    /// Flow pressure of pinion and wheel.
    pub flow_pressure: [Pressure; 2],
    /// Reduced modulus E*.
    pub modulus: Pressure,
    /// Oil at the temperature of the flanks.
    pub oil: &'a LubricantState,
    /// Choices of the model.
    pub model: &'a Model,
    /// Choices of the formulation `paper`.
    pub paper: &'a PaperChoices,
}

/// Pressures along a window, and the solution of the solids where they touch.
#[derive(Debug, Clone)]
pub struct Pressed {
    /// Pressure in the film \[Pa\].
    pub fluid: Vec<f64>,
    /// Solution of the rough contact; `None` in full film.
    pub solids: Option<ContactSolution>,
    /// History of the approach to the solution.
    pub history: Vec<LoadStep>,
}

/// One step of the approach of the flanks to their load.
#[derive(Debug, Clone, Copy)]
pub struct LoadStep {
    /// Approach from the first step, or from first touch where the flanks march \[m\].
    pub approach: f64,
    /// Load on the solids \[N/m\].
    pub load_solid: f64,
    /// Load on the film \[N/m\].
    pub load_fluid: f64,
    /// Deviation from the load of the position, relative.
    pub load_error: f64,
}

impl Pressed {
    /// A film without touching solids, with the pressure `fluid` \[Pa\].
    #[must_use]
    pub const fn full_film(fluid: Vec<f64>) -> Self {
        Self {
            fluid,
            solids: None,
            history: Vec::new(),
        }
    }

    /// Highest pressure of film and solids together \[Pa\]; 0 where the solids do not touch.
    #[must_use]
    pub fn highest(&self) -> f64 {
        let Some(solids) = &self.solids else {
            return 0.0;
        };
        let sums = solids.pressure.iter().zip(&self.fluid).map(|(s, f)| s + f);
        sums.fold(0.0, f64::max)
    }
}

/// Power of the deformation in a window \[W\], each of pinion and wheel.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DeformationPower {
    /// In contact: elastic and plastic displacement.
    pub in_contact: [f64; 2],
    /// After contact: plastic displacement only, the loss.
    pub after_contact: [f64; 2],
}

/// Pressures of film and solids in a window, from which friction, film share and loss by deformation follow.
pub trait WindowPressures: Debug + Send + Sync {
    /// Pressures that carry the load of a window whose film is not full.
    ///
    /// # Errors
    /// When no pressures carry the load.
    fn press(&self, window: &WindowConditions<'_>) -> Result<Pressed, PositionError>;

    /// Power of the deformation by `pressed` and by the shear stress `shear` \[Pa\] on the pinion's flank.
    ///
    /// # Errors
    /// When an equation refuses the numbers.
    fn deformation(
        &self,
        window: &WindowConditions<'_>,
        pressed: &Pressed,
        shear: &[f64],
    ) -> Result<DeformationPower, PositionError>;

    /// Usual time of a window for each of its points \[s\], for estimates of a run.
    fn seconds_of_a_point(&self, paper: &PaperChoices) -> f64;
}
