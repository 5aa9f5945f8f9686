//! Response surfaces of a rig's points, made from the model.

use crate::error::CalibrationError;
use crate::parameters::Parameter;
use crate::problem::PointSurfaces;
use crate::response::{Region, Response};
use crate::rig_model::{Parts, RigModel, Told};
use asperity::case::CalibratedName;

/// Half-width of the first box along the logarithm of a parameter: its range in a case, roughly.
const fn first_half_width(name: CalibratedName) -> f64 {
    match name {
        CalibratedName::BoundaryFriction | CalibratedName::EyringStress => 0.35,
        CalibratedName::BoundaryLayer => 0.6,
        CalibratedName::LimitingShear => 0.2,
    }
}
/// The same along the temperature \[K\].
const FIRST_TEMPERATURE: f64 = 4.0;
/// Steps of the slopes of a design: logarithms, and temperature \[K\].
const STEP: f64 = 0.1;
const TEMPERATURE_STEP: f64 = 1.0;

/// The first box: about the centres of the parameters.
#[must_use]
pub fn first_region(parameters: &[Parameter]) -> Region {
    let widths = parameters
        .iter()
        .map(|parameter| first_half_width(parameter.name));
    Region {
        centre: vec![0.0; parameters.len() + 1],
        half_width: widths.chain([FIRST_TEMPERATURE]).collect(),
    }
}

/// A box for slopes about the centres.
#[must_use]
pub fn slope_region(parameters: &[Parameter]) -> Region {
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
    told: Told<'_>,
) -> Result<Vec<PointSurfaces>, CalibrationError> {
    made(model, region, &region.settings(), Response::through, told)
}

/// Planes of every point of `model` about the centre of `region`.
///
/// # Errors
/// When the model has no solution at a point.
pub fn tangents(
    model: &RigModel,
    region: &Region,
    told: Told<'_>,
) -> Result<Vec<PointSurfaces>, CalibrationError> {
    made(
        model,
        region,
        &region.forward_settings(),
        Response::tangent,
        told,
    )
}

fn made(
    model: &RigModel,
    region: &Region,
    settings: &[Vec<f64>],
    through: fn(usize, &[f64]) -> Response,
    told: Told<'_>,
) -> Result<Vec<PointSurfaces>, CalibrationError> {
    let axes = region.centre.len();
    let surface = |parts: &[Parts], of: fn(&Parts) -> f64| {
        let logarithms: Vec<f64> = parts.iter().map(|parts| of(parts).ln()).collect();
        through(axes, &logarithms)
    };
    let found = model.evaluate(settings, told)?;
    let points = found.iter().map(|parts| PointSurfaces {
        sliding: surface(parts, |parts| parts.sliding_w),
        rolling: surface(parts, |parts| parts.rolling_w),
    });
    Ok(points.collect())
}
