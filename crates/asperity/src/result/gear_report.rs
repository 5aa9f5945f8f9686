//! Gears of a case, without running it: geometry, contact ratios, stiffness, transmission error,
//! and the loss factor by every law of load distribution.

use asperity_gear::{
    EdgeContactNote, GearPair, LoadMap, LoadMapEvidence, LossFactorBand, TransmissionError,
};
use serde::Serialize;

use asperity_case::case::Case;
use asperity_case::error::{Error, PositionError};

/// The gears of a case.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct GearReport {
    /// Title of the case.
    pub title: String,
    /// Geometry.
    pub gears: GearPair,
    /// Torque at the pinion \[N m\].
    pub torque_nm: f64,
    /// Force normal to the flanks \[N\].
    pub normal_force_n: f64,
    /// Law of the load distribution in use.
    pub law: String,
    /// Loss factor H_V of that law.
    pub loss_factor_local: f64,
    /// Its band; none for laws without deflections.
    pub band: Option<LossFactorBand>,
    /// Loss factor if tip edges touch outside the path of contact, where they may.
    pub edge_contact: Option<EdgeContactNote>,
    /// Loss factor of Ohlendorf.
    pub loss_factor_ohlendorf: f64,
    /// Loss factor by each law; laws without deflections are tried on unmodified flanks.
    pub loss_factors: Vec<LawFactor>,
    /// Highest over mean load per width of the face, K_Hβ.
    pub face_load_factor: f64,
    /// Transmission error over a mesh cycle; none for laws without deflections.
    pub transmission_error: Option<TransmissionError>,
    /// Mean mesh stiffness of ISO 6336-1, c_γ \[N/(mm µm)\]; `None` outside the range of its polynomial.
    pub iso_mesh_stiffness_n_per_mm_um: Option<f64>,
    /// Evidence of the load distribution.
    pub evidence: LoadMapEvidence,
}

/// Loss factor by one law.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct LawFactor {
    /// Name as in a case file.
    pub law: String,
    /// H_V; none where the law does not hold for the pair.
    pub loss_factor: Option<f64>,
    /// Reason why the law does not apply.
    pub refused: Option<String>,
}

/// The gears of `case` under its torque.
///
/// # Errors
/// When the law in use does not hold for the pair.
pub fn gear_report(case: &Case) -> Result<GearReport, Error> {
    report(case).map_err(|error| Error::Whole(Box::new(error)))
}

fn report(case: &Case) -> Result<GearReport, PositionError> {
    let pair = &case.gears;
    let map = case.load_map()?;
    let every = LoadMap::loss_factor_of_every_law(
        pair,
        case.torque,
        &case.micro_geometry,
        &case.materials,
        &case.load_settings,
    );
    let loss_factors = every.into_iter().map(|(law, found)| LawFactor {
        law: law.name().to_owned(),
        refused: found.as_ref().err().map(ToString::to_string),
        loss_factor: found.ok(),
    });
    let shift = pair.profile_shift.or(map.evidence().assumed_profile_shift);
    let factor = case.load_settings.stiffness_factor;
    let iso = shift.and_then(|shift| pair.iso_mesh_stiffness(shift, factor).ok());
    Ok(GearReport {
        title: case.title.clone(),
        gears: pair.clone(),
        torque_nm: case.torque.si(),
        normal_force_n: pair.forces(case.torque)?.normal_base.si().abs(),
        law: case.load_distribution().name().to_owned(),
        loss_factor_local: map.loss_factor(),
        band: map.loss_factor_band(case.input.gears.relief_tolerance)?,
        edge_contact: map.edge_contact_note()?,
        loss_factor_ohlendorf: pair.ohlendorf_loss_factor(),
        loss_factors: loss_factors.collect(),
        face_load_factor: map.face_load_factor(),
        transmission_error: map.transmission_error()?,
        iso_mesh_stiffness_n_per_mm_um: iso.map(|stiffness| stiffness * 1e-9),
        evidence: map.evidence().clone(),
    })
}
