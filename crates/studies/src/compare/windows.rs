//! Roughness of the windows under the contact, by offset.

use asperity::PositionError;
use asperity::case::LoadedCase;
use asperity::flanks::{OffsetIndex, Roughness, WindowPair};
use asperity::mesh::{Mesh, MeshPosition};
use asperity_core::Profile;
use asperity_core::task::try_par_map;
use asperity_report::units::MICRO;
use asperity_roughness::material_ratio::rk_parameters;
use asperity_roughness::section_heights::section_heights;
use asperity_roughness::spectral::moments;
use serde::Serialize;

/// Roughness of both windows under a contact, combined as √(a² + b²); Rpk, Rk and Rvk of the composite profile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct ComparedRoughness {
    pub ra_um: f64,
    pub rq_um: f64,
    pub rz_um: f64,
    pub rdq: f64,
    pub rpk_composite_um: f64,
    pub rk_composite_um: f64,
    pub rvk_composite_um: f64,
}

/// A roughness parameter of a window.
pub(super) type Value = fn(&ComparedRoughness) -> f64;

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

/// Roughness of the windows in contact at each of `offsets` offsets, mean over the path.
pub(super) fn roughness(
    loaded: &LoadedCase,
    offsets: usize,
) -> Result<Vec<ComparedRoughness>, PositionError> {
    let positions = Mesh::new(&loaded.case)?.positions;
    let model = &loaded.case.model;
    let surfaces = &loaded.surfaces;
    let at = |at: &MeshPosition, offset: OffsetIndex| {
        let pair = WindowPair::at(surfaces, at, model.window, loaded.case.modulus, offset)?;
        let roughness = surfaces.roughness_at(at, model.window, offset)?;
        pair.map(|pair| window(&pair, &roughness)).transpose()
    };
    let mean = |k: usize| {
        let found = positions
            .iter()
            .map(|position| at(position, OffsetIndex { k, count: offsets }));
        let resolved = found.filter_map(Result::transpose);
        let resolved = resolved.collect::<Result<Vec<_>, _>>()?;
        let each = |of: Value| resolved.iter().map(of).sum::<f64>() / resolved.len() as f64;
        if resolved.is_empty() {
            return Err(PositionError::no_profile());
        }
        Ok(ComparedRoughness {
            ra_um: each(|window| window.ra_um),
            rq_um: each(|window| window.rq_um),
            rz_um: each(|window| window.rz_um),
            rdq: each(|window| window.rdq),
            rpk_composite_um: each(|window| window.rpk_composite_um),
            rk_composite_um: each(|window| window.rk_composite_um),
            rvk_composite_um: each(|window| window.rvk_composite_um),
        })
    };
    try_par_map(0..offsets, mean)
}

fn window(pair: &WindowPair, roughness: &Roughness) -> Result<ComparedRoughness, PositionError> {
    let [first, second] = &pair.heights;
    let composite: Vec<f64> = first.iter().zip(second).map(|(a, b)| a + b).collect();
    let material = rk_parameters(&composite)?;
    let slope = moments(&Profile::new(pair.spacing, composite)?)?.m2.sqrt();
    let both = |[a, b]: [f64; 2]| a.hypot(b) * MICRO;
    let range = |heights: &[f64]| section_heights(heights).map(|heights| heights.rz.si());
    Ok(ComparedRoughness {
        ra_um: both(roughness.ra),
        rq_um: both(roughness.rq),
        rz_um: both([range(first)?, range(second)?]),
        rdq: slope,
        rpk_composite_um: material.rpk.si() * MICRO,
        rk_composite_um: material.rk.si() * MICRO,
        rvk_composite_um: material.rvk.si() * MICRO,
    })
}
