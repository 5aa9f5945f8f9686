//! Displacement of each body, from the displacement of both together.

use asperity_contact::ContactSolution;
use asperity_contact::plasticity::{elastic_shares, plastic_shares};
use asperity_core::material::Material;
use asperity_core::quantity::Pressure;

use asperity_case::error::PositionError;

/// Elastic displacement and plastic displacement of pinion and wheel \[m\].
#[derive(Debug, Clone, PartialEq)]
pub struct Displacements {
    /// Elastic displacement of each body.
    pub elastic: [Vec<f64>; 2],
    /// Plastic displacement of each body.
    pub plastic: [Vec<f64>; 2],
}

/// Shares of pinion and wheel in the plastic displacement.
pub(crate) fn flow_shares(
    materials: &[Material; 2],
    flow_pressure: [Pressure; 2],
) -> Result<[f64; 2], PositionError> {
    // The shares are defined by elastic limits; here the flow pressures stand for them.
    let flowing = |body: usize| Material {
        elastic_limit: flow_pressure[body],
        ..materials[body]
    };
    Ok(plastic_shares(&flowing(0), &flowing(1))?)
}

impl Displacements {
    /// Bodies that keep their shape, at `n` points.
    #[must_use]
    pub fn none(n: usize) -> Self {
        let zero = || [vec![0.0; n], vec![0.0; n]];
        Self {
            elastic: zero(),
            plastic: zero(),
        }
    }

    /// Shares the solution's displacements: the elastic part by compliance (1 − ν²)/E, the plastic
    /// part in inverse proportion to the pressures that the bodies flow at; equal bodies take half each.
    ///
    /// # Errors
    /// When a material has no compliance.
    pub fn new(
        materials: &[Material; 2],
        flow_pressure: [Pressure; 2],
        solution: &ContactSolution,
    ) -> Result<Self, PositionError> {
        let [pinion, wheel] = materials;
        let [elastic_share, _] = elastic_shares(pinion, wheel)?;
        let [plastic_share, _] = flow_shares(materials, flow_pressure)?;
        let split = |field: &[f64], share: f64| {
            [
                field.iter().map(|v| v * share).collect(),
                field.iter().map(|v| v * (1.0 - share)).collect(),
            ]
        };
        Ok(Self {
            elastic: split(&solution.displacement, elastic_share),
            plastic: split(&solution.plastic_displacement, plastic_share),
        })
    }
}
