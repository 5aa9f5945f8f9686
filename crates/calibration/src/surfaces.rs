//! Response surfaces of the model at the points of a rig.

use crate::parameters::Parameter;
use crate::problem::PointSurfaces;
use crate::response::{Region, Response};
use crate::rig_model::{PointLosses, Progress, RigModel};
use asperity::case::CalibratedName;
use asperity_core::Fault;

/// Half width of the first box along the logarithm of a parameter: about its range in a case.
const fn first_half_width(name: CalibratedName) -> f64 {
    match name {
        CalibratedName::BoundaryFriction | CalibratedName::EyringStress => 0.35,
        CalibratedName::BoundaryLayer => 0.6,
        CalibratedName::LimitingShear => 0.2,
    }
}
/// Half width of the first box along the temperature \[K\].
const FIRST_TEMPERATURE: f64 = 4.0;
/// Step of the derivatives of a design by the logarithm of a parameter.
const STEP: f64 = 0.1;
/// Step of the derivatives of a design by the temperature \[K\].
const TEMPERATURE_STEP: f64 = 1.0;

/// First box, about the centres of the parameters.
#[must_use]
pub(crate) fn first_region(parameters: &[Parameter]) -> Region {
    let widths = parameters
        .iter()
        .map(|parameter| first_half_width(parameter.name));
    Region {
        centre: vec![0.0; parameters.len() + 1],
        half_width: widths.chain([FIRST_TEMPERATURE]).collect(),
    }
}

/// Box about the centres for derivatives.
#[must_use]
pub(crate) fn slope_region(parameters: &[Parameter]) -> Region {
    let mut half_width = vec![STEP; parameters.len()];
    half_width.push(TEMPERATURE_STEP);
    Region {
        centre: vec![0.0; parameters.len() + 1],
        half_width,
    }
}

/// Surfaces of every point of `model` over `region`.
///
/// # Errors
/// When the model has no solution at a point.
pub fn surfaces(
    model: &RigModel,
    region: &Region,
    progress: Progress<'_>,
) -> Result<Vec<PointSurfaces>, Fault> {
    made(
        model,
        region,
        &region.settings(),
        Response::through,
        progress,
    )
}

/// Planes of every point of `model` about the centre of `region`.
///
/// # Errors
/// When the model has no solution at a point.
pub(crate) fn tangents(
    model: &RigModel,
    region: &Region,
    progress: Progress<'_>,
) -> Result<Vec<PointSurfaces>, Fault> {
    made(
        model,
        region,
        &region.forward_settings(),
        Response::tangent,
        progress,
    )
}

fn made(
    model: &RigModel,
    region: &Region,
    settings: &[Vec<f64>],
    through: fn(usize, &[f64]) -> Response,
    progress: Progress<'_>,
) -> Result<Vec<PointSurfaces>, Fault> {
    let axes = region.centre.len();
    let surface = |parts: &[PointLosses], of: fn(&PointLosses) -> f64| {
        let logarithms: Vec<f64> = parts.iter().map(|parts| of(parts).ln()).collect();
        through(axes, &logarithms)
    };
    let losses = model.evaluate(settings, progress)?;
    let points = losses.iter().map(|parts| PointSurfaces {
        sliding: surface(parts, |parts| parts.sliding_w),
        rolling: surface(parts, |parts| parts.rolling_w),
    });
    Ok(points.collect())
}
