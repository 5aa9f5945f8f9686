//! Displacement of each body, from the displacement of both together.

use asperity_contact::ContactSolution;
use asperity_contact::plasticity::{elastic_shares, plastic_shares};
use asperity_core::material::Material;
use asperity_core::quantity::Length;

use crate::mesh::MeshPosition;
use asperity_case::case::Case;
use asperity_case::error::PositionError;

/// Elastic displacement and plastic displacement of pinion and wheel \[m\].
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Displacements {
    /// Elastic displacement of each body.
    pub elastic: [Vec<f64>; 2],
    /// Plastic displacement of each body.
    pub plastic: [Vec<f64>; 2],
}

/// Shares of pinion and wheel in the plastic displacement.
pub(crate) fn flow_shares(case: &Case) -> Result<[f64; 2], PositionError> {
    // The shares are defined by elastic limits; here the flow pressures stand for them.
    let flowing = |body: usize| Material {
        elastic_limit: case.flow_pressure[body],
        ..case.materials[body]
    };
    Ok(plastic_shares(&flowing(0), &flowing(1))?)
}

impl Displacements {
    /// Bodies that keep their shape, at `n` points.
    pub(crate) fn none(n: usize) -> Self {
        let zero = || [vec![0.0; n], vec![0.0; n]];
        Self {
            elastic: zero(),
            plastic: zero(),
        }
    }

    /// Shares the solution's displacements: the elastic part by compliance (1 − ν²)/E, the plastic
    /// part in inverse proportion to the pressures that the bodies flow at; equal bodies take half each.
    pub(crate) fn new(case: &Case, solution: &ContactSolution) -> Result<Self, PositionError> {
        let [pinion, wheel] = &case.materials;
        let [elastic_share, _] = elastic_shares(pinion, wheel)?;
        let [plastic_share, _] = flow_shares(case)?;
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

    /// Displacement inside the contact from its edge, so that it does not depend on a datum: the
    /// least displacement under pressure counts as zero, and so does all that lies outside.
    pub(crate) fn measured_from_edge(mut self, pressure: &[f64]) -> Self {
        for field in &mut self.elastic {
            let loaded = || pressure.iter().map(|&p| p > 0.0);
            let edge = field
                .iter()
                .zip(loaded())
                .filter(|(_, loaded)| *loaded)
                .map(|(u, _)| *u)
                .fold(f64::INFINITY, f64::min);
            for (u, loaded) in field.iter_mut().zip(loaded()) {
                *u = if loaded { *u - edge } else { 0.0 };
            }
        }
        self
    }

    /// Displacement of smooth bodies under Hertz's pressure, (a² − x²)/2R from the edge.
    pub(crate) fn hertz(
        case: &Case,
        position: &MeshPosition,
        x: &[f64],
    ) -> Result<Self, PositionError> {
        let shares = elastic_shares(&case.materials[0], &case.materials[1])?;
        let radius = position.motion.radius;
        let both = x
            .iter()
            .map(|&x| {
                let place = Length::from_si(x);
                Ok(position.hertz.displacement_from_edge(place, radius)?.si())
            })
            .collect::<Result<Vec<f64>, PositionError>>()?;
        let elastic = shares.map(|share| both.iter().map(|u| share * u).collect());
        Ok(Self {
            elastic,
            plastic: [vec![0.0; x.len()], vec![0.0; x.len()]],
        })
    }
}
