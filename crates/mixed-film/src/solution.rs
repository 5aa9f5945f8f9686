//! Load share and friction of one contact at one temperature.

use asperity_core::numerics::Solved;
use asperity_core::quantity::{Length, LineEnergy, Pressure};
use asperity_tribo_friction::boundary::FrictionParts;
use serde::Serialize;

/// Sliding loss per metre of contact line, by its parts \[W/m\].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LineLosses {
    /// In the film.
    pub film: f64,
    /// In lubricated asperities.
    pub lubricated_asperities: f64,
    /// In the boundary layer.
    pub boundary: f64,
}

impl LineLosses {
    /// The whole sliding loss \[W/m\].
    #[must_use]
    pub fn total(&self) -> f64 {
        self.film + self.lubricated_asperities + self.boundary
    }
}

/// Convergence of the two scalar equations.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ShareEvidence {
    /// Asperity share: gap over supply minus 1 at the last evaluation.
    pub share: Solved,
    /// Friction coefficient against the temperature that it makes.
    pub friction: Solved,
    /// Largest relative load error of the contact solutions next to the share; 0 without contact.
    pub load_error: f64,
    /// Their largest certified duality gap.
    pub duality_gap: f64,
}

/// Load share and friction of one contact at one temperature.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct LoadShareSolution {
    /// Share φ of the load on the asperities.
    pub asperity_share: f64,
    /// Share β of the asperity load on the boundary layer.
    pub boundary_of_asperities: f64,
    /// Share φ β of the load on the boundary layer.
    pub boundary_share: f64,
    /// Friction coefficient μ of the whole contact.
    pub coefficient: f64,
    /// Film friction μ_f.
    pub film_coefficient: f64,
    /// Friction μ_a of lubricated asperities; 0 where nothing touches.
    pub asperity_coefficient: f64,
    /// The parts of μ.
    pub parts: FrictionParts,
    /// The parts of the sliding loss.
    pub losses: LineLosses,
    /// Central film h_c of smooth flanks.
    pub smooth_film: Length,
    /// Thermal factor in it.
    pub thermal_factor: f64,
    /// Standard deviation σ_d of the attenuated window.
    pub attenuated_rms: Length,
    /// Roughness left in the contact over the smooth film. Gap law `inlet`: of both whole traces by the smooth inlet, over
    /// the mass-flow film; `power`: σ_d of the window over h_c.
    pub roughness_over_film: f64,
    /// Ψ of the window, mean gap of rough flanks over the smooth film in the supply.
    pub inlet_factor: f64,
    /// Mean gap of the flanks: what the inlet supplies, or the contact's at the largest share.
    pub mean_gap: Length,
    /// Film h_a of the touching spots, weighted with their load; 0 where nothing touches.
    pub spot_film: Length,
    /// Share of the Hertz contact that touches.
    pub area: f64,
    /// Largest pressure of film and asperities.
    pub max_pressure: Pressure,
    /// Energy that plastic flow dissipates in one pass over the window.
    pub dissipated: LineEnergy,
    /// Rise of the surface temperature T_s over the bulk \[K\].
    pub surface_rise: f64,
    /// Convergence of the equations.
    pub evidence: ShareEvidence,
}
