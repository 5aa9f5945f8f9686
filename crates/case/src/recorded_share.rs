//! Load share and friction between two records.

use asperity_ehl::RecordMean;

/// Shares and friction at one mesh position, interpolated between the neighbouring records.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordedShare {
    /// Share of the load at films no thicker than the solid film.
    pub solid_share: RecordMean,
    /// Share of that load on the boundary layer.
    pub boundary_part: f64,
    /// Film friction of that load, with the heat of the smooth film.
    pub lubricated_coefficient: f64,
    /// Film friction of the other load; none where the case names a published law for it.
    pub film_coefficient: Option<f64>,
    /// Mean gap within the half-width \[m\].
    pub mean_gap: RecordMean,
    /// Mean of the largest pressure \[Pa\].
    pub max_pressure: f64,
}
