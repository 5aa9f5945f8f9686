//! Parameters of a profile as JSON, lengths in micrometres: the keys of the command and of the Python module.

use asperity_core::by_size;
use asperity_core::quantity::Length;
use asperity_roughness::height_parameters::HeightParameters;
use asperity_roughness::material_ratio::RkParameters;
use asperity_roughness::spectral::SpectralMoments;
use serde_json::{Value, json};

/// A length in micrometres.
pub fn um(length: Length) -> f64 {
    length.si() * 1e6
}

/// A height in micrometres as text, with more than four decimals if it is small.
#[must_use]
pub fn height(length: Length) -> String {
    by_size(um(length), 4)
}

/// Height parameters.
pub fn heights(p: &HeightParameters) -> Value {
    json!({
        "ra_um": um(p.ra), "rq_um": um(p.rq), "rz_um": um(p.rz), "rp_um": um(p.rp), "rv_um": um(p.rv),
        "rt_um": um(p.rt), "rz1max_um": um(p.rz1max), "rsk": p.rsk, "rku": p.rku,
        "rsm_um": p.rsm.map(um), "rc_um": p.rc.map(um), "rdq": p.rdq, "sections": p.sections,
    })
}

/// Parameters of the material ratio curve.
pub fn material(m: &RkParameters) -> Value {
    json!({
        "rk_um": um(m.rk), "rpk_um": um(m.rpk), "rvk_um": um(m.rvk),
        "mr1_percent": m.mr1, "mr2_percent": m.mr2,
    })
}

/// Spectral moments and bandwidth.
pub fn spectral(s: &SpectralMoments) -> Value {
    json!({
        "m0_um2": s.m0 * 1e12, "m2": s.m2, "m4_per_um2": s.m4 * 1e-12, "bandwidth": s.bandwidth(),
    })
}
