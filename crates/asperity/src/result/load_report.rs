//! Load over the teeth in the result.

use asperity_gear::{EdgeContactNote, LoadMap, LoadMapEvidence, LossFactorBand};
use serde::{Deserialize, Serialize};

use asperity_case::case::Case;
use asperity_case::error::PositionError;

/// Number of strips of the path of contact.
const STRIPS: usize = 96;

/// Load over the teeth, and what follows from it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LoadReport {
    /// Law of the load distribution.
    pub law: String,
    /// Loss factor H_V of the load map.
    pub loss_factor_local: f64,
    /// Band of the loss factor from its uncertain constants; `None` for laws without deflections.
    pub band: Option<LossFactorBand>,
    /// Loss factor with contact of the tip edges outside the path of contact; `None` if they cannot touch.
    pub edge_contact: Option<EdgeContactNote>,
    /// Highest over mean load per width of the face, K_Hβ.
    pub face_load_factor: f64,
    /// Mean transmission error \[µm\]; `None` for laws without deflections.
    pub transmission_error_um: Option<f64>,
    /// Transmission error from peak to peak \[µm\].
    pub transmission_error_peak_to_peak_um: Option<f64>,
    /// Mesh stiffness over the face width, c_γ \[N/(mm µm)\].
    pub mesh_stiffness_n_per_mm_um: Option<f64>,
    /// Evidence of the load distribution.
    pub evidence: LoadMapEvidence,
    /// Load along the path.
    pub path: Vec<LoadRow>,
}

/// Load in a strip of the path of contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[non_exhaustive]
pub struct LoadRow {
    /// Middle of the strip along the line of action from T1 \[mm\].
    pub s_mm: f64,
    /// Place on the path, 0 at A and 1 at E.
    pub path_fraction: f64,
    /// Mean load per length of contact line \[N/mm\].
    pub mean_n_per_mm: f64,
    /// Lowest load over the face \[N/mm\].
    pub lowest_n_per_mm: f64,
    /// Highest load over the face \[N/mm\].
    pub highest_n_per_mm: f64,
}

impl LoadReport {
    /// The report of `map` for `case`.
    pub(crate) fn new(case: &Case, map: &LoadMap) -> Result<Self, PositionError> {
        let error = map.transmission_error()?;
        let error = error.as_ref();
        Ok(Self {
            law: case.load_distribution().name().to_owned(),
            loss_factor_local: map.loss_factor(),
            band: map.loss_factor_band(case.input.gears.relief_tolerance)?,
            edge_contact: map.edge_contact_note()?,
            face_load_factor: map.face_load_factor(),
            transmission_error_um: error.map(|error| error.mean.si() * 1e6),
            transmission_error_peak_to_peak_um: error.map(|error| error.peak_to_peak.si() * 1e6),
            mesh_stiffness_n_per_mm_um: error.map(|error| error.mesh_stiffness * 1e-9),
            evidence: map.evidence().clone(),
            path: rows(map),
        })
    }
}

#[derive(Debug, Clone, Copy)]
struct Strip {
    length: f64,
    force: f64,
    lowest: f64,
    highest: f64,
}

/// Rows of the strips that contain points of the map.
fn rows(map: &LoadMap) -> Vec<LoadRow> {
    let path = map.gears().path();
    let empty = Strip {
        length: 0.0,
        force: 0.0,
        lowest: f64::INFINITY,
        highest: 0.0,
    };
    let mut strips = [empty; STRIPS];
    let place = |xi: f64| (xi / path.eps_alpha * STRIPS as f64).max(0.0) as usize;
    for sample in map.samples() {
        let (load, length) = (sample.load.si(), sample.weight.si());
        let strip = &mut strips[place(sample.xi).min(STRIPS - 1)];
        strip.length += length;
        strip.force += length * load;
        strip.lowest = strip.lowest.min(load);
        strip.highest = strip.highest.max(load);
    }
    let numbered = strips.iter().enumerate();
    numbered
        .filter(|(_, strip)| strip.length > 0.0)
        .map(|(index, strip)| {
            let path_fraction = (index as f64 + 0.5) / STRIPS as f64;
            let s = path.a + (path.e - path.a) * path_fraction;
            LoadRow {
                s_mm: s.si() * 1e3,
                path_fraction,
                mean_n_per_mm: strip.force / strip.length * 1e-3,
                lowest_n_per_mm: strip.lowest * 1e-3,
                highest_n_per_mm: strip.highest * 1e-3,
            }
        })
        .collect()
}
