//! Roughness of the windows under the contact, by offset.

use asperity::PositionError;
use asperity::case::LoadedCase;
use asperity::flanks::{Roughness, WindowPair};
use asperity::mesh::Mesh;
use asperity_core::Profile;
use asperity_report::units::MICRO;
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::section_heights::section_heights;
use asperity_roughness::spectral::moments;
use serde::Serialize;

/// Roughness of both windows under a contact, combined as √(a² + b²); Rpk, Rk and Rvk of the composite profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct WindowRoughness {
    pub ra_um: f64,
    pub rq_um: f64,
    pub rz_um: f64,
    pub rdq: f64,
    pub rpk_composite_um: f64,
    pub rk_composite_um: f64,
    pub rvk_composite_um: f64,
}

/// A roughness parameter of a window.
pub(super) type Value = fn(&WindowRoughness) -> f64;

/// Names and values of the parameters that are correlated with the loss.
pub(super) const PARAMETERS: &[(&str, Value)] = &[
    ("Ra", |window| window.ra_um),
    ("Rq", |window| window.rq_um),
    ("Rz", |window| window.rz_um),
    ("Rdq", |window| window.rdq),
    ("Rpk", |window| window.rpk_composite_um),
    ("Rk", |window| window.rk_composite_um),
    ("Rvk", |window| window.rvk_composite_um),
];

/// Roughness of the windows at the middle position of the path, whose offsets are the same at all positions.
pub(super) fn roughness(loaded: &LoadedCase) -> Result<Vec<WindowRoughness>, PositionError> {
    let model = &loaded.case.model;
    let positions = Mesh::of(&loaded.case)?.positions;
    let Some(at) = positions.get(positions.len() / 2) else {
        return Ok(Vec::new());
    };
    let offsets = loaded.surfaces.offsets(model.offsets);
    (0..offsets)
        .map(|k| {
            let (surfaces, offset) = (&loaded.surfaces, (k, offsets));
            let pair = WindowPair::at(surfaces, at, (model.window, loaded.case.modulus), offset)?;
            let roughness = surfaces.roughness_at(at, model.window, offset)?;
            window(&pair.ok_or(PositionError::NoProfile)?, &roughness)
        })
        .collect()
}

fn window(pair: &WindowPair, roughness: &Roughness) -> Result<WindowRoughness, PositionError> {
    let [first, second] = &pair.heights;
    let composite: Vec<f64> = first.iter().zip(second).map(|(a, b)| a + b).collect();
    let material = rk_parameters(&composite)?;
    let slope = moments(&Profile::new(pair.spacing, composite)?)?.m2.sqrt();
    let both = |[a, b]: [f64; 2]| a.hypot(b) * MICRO;
    let range = |heights: &[f64]| section_heights(heights).map(|heights| heights.rz.si());
    Ok(WindowRoughness {
        ra_um: both(roughness.ra),
        rq_um: both(roughness.rq),
        rz_um: both([range(first)?, range(second)?]),
        rdq: slope,
        rpk_composite_um: material.rpk.si() * MICRO,
        rk_composite_um: material.rk.si() * MICRO,
        rvk_composite_um: material.rvk.si() * MICRO,
    })
}
