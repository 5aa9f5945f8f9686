//! Errors of gear geometry, kinematics and load.

use asperity_core::quantity::Length;
use asperity_core::{DomainError, decimals, number};
use serde::{Deserialize, Serialize};

/// One of the two gears of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Gear {
    /// Gear 1.
    Pinion,
    /// Gear 2.
    Wheel,
}

impl std::fmt::Display for Gear {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::Pinion => "pinion",
            Self::Wheel => "wheel",
        })
    }
}

/// Errors of the geometry, load and kinematics of a gear pair.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GearError {
    /// A single number outside its domain.
    #[error(transparent)]
    Domain(#[from] DomainError),
    /// The base circles overlap at the centre distance.
    #[error(
        "the centre distance {given:.5} must be larger than the sum of the base radii, {base_radii:.5}"
    )]
    CentreDistanceTooSmall {
        /// Given centre distance.
        given: Length,
        /// Sum of the base radii.
        base_radii: Length,
    },
    /// Centre distance and profile shifts contradict each other.
    #[error(
        "the centre distance {given:.5} contradicts the profile shifts, which give {from_shifts:.5}; they may differ by {tolerance:.5} at most"
    )]
    InconsistentCentreDistance {
        /// Given centre distance.
        given: Length,
        /// Centre distance without backlash from the profile shifts.
        from_shifts: Length,
        /// Permitted difference.
        tolerance: Length,
    },
    /// Tip radii are unknown because only the sum of the profile shifts is known, and no division of it is possible.
    #[error(
        "neither the profile shifts nor the tip diameters are given: the centre distance gives only the sum of the shifts, {sum}; state both shifts with this sum, or both tip diameters", sum = decimals(*sum, 4))]
    TipRadiusUnknown {
        /// Sum of the profile shifts.
        sum: f64,
    },
    /// A tip reaches beyond the involute of the other gear.
    #[error(
        "the tip of the {gear} reaches {reach:.5} along the line of action, past the end of the mating involute at {limit:.5}: interference or undercut"
    )]
    Interference {
        /// The gear with the interfering tip.
        gear: Gear,
        /// Distance of the end of contact from the gear's own base tangent point.
        reach: Length,
        /// Distance of the other base tangent point.
        limit: Length,
    },
    /// The tip of a ring reaches below the involute of the pinion.
    #[error(
        "the tip of the ring starts contact at {start:.5} from the base tangent point of the pinion, before its involute begins: interference"
    )]
    RingInterference {
        /// Coordinate of A; must be positive.
        start: Length,
    },
    /// The flanks of a tooth intersect below its tip.
    #[error("the tooth of the {gear} is pointed: its thickness at the tip would be {thickness:.5}")]
    PointedTip {
        /// The gear.
        gear: Gear,
        /// Thickness of the tooth at the tip, in the transverse section.
        thickness: Length,
    },
    /// For every division of the profile shifts a tooth is pointed.
    #[error(
        "however the profile shifts are divided, a tooth is pointed: the tip half-angles times the tooth numbers sum to {sum} rad and must be positive", sum = decimals(*sum, 4))]
    PointedTips {
        /// Σ z·(half-angle of the tip land) \[rad\].
        sum: f64,
    },
    /// The tip circles do not overlap.
    #[error("the gears do not touch: the path of contact would be {length:.5} long")]
    NoContact {
        /// Length A to E.
        length: Length,
    },
    /// One spur pair leaves contact before the next enters.
    #[error("a spur pair needs a transverse contact ratio above 1, this one has {eps_alpha}", eps_alpha = decimals(*eps_alpha, 4))]
    SpurContactRatio {
        /// Transverse contact ratio.
        eps_alpha: f64,
    },
    /// One helical pair leaves contact before the next enters.
    #[error("a helical pair needs a total contact ratio above 1, this one has {eps_gamma}", eps_gamma = decimals(*eps_gamma, 4))]
    TotalContactRatio {
        /// Total contact ratio.
        eps_gamma: f64,
    },
    /// A position outside the path of contact.
    #[error("s = {s:.5} is off the path of contact, which goes from {from:.5} to {to:.5}")]
    OffPath {
        /// Requested distance from T₁.
        s: Length,
        /// Lower end.
        from: Length,
        /// Upper end.
        to: Length,
    },
    /// A profile coordinate outside the path of contact.
    #[error("xi = {xi} is off the path of contact, which goes from 0 to {eps_alpha}", xi = number(*xi), eps_alpha = number(*eps_alpha))]
    CoordinateOffPath {
        /// Requested profile coordinate, in base pitches from A.
        xi: f64,
        /// Transverse contact ratio, the coordinate of E.
        eps_alpha: f64,
    },
    /// The root outline of a tooth cannot be constructed from the rack.
    #[error("the root of the {gear} cannot be drawn: {reason}")]
    RootForm {
        /// The gear.
        gear: Gear,
        /// Reason.
        reason: &'static str,
    },
    /// Undercut reaches into the path of contact.
    #[error(
        "the {gear} is undercut: its involute begins at the radius {form_radius:.5} of the normal section, above the lowest contact at {contact_radius:.5}"
    )]
    UndercutContact {
        /// The gear.
        gear: Gear,
        /// Radius at which the involute begins, in the normal section.
        form_radius: Length,
        /// Radius of the lowest contact, in the normal section.
        contact_radius: Length,
    },
    /// The compliance of a tooth is not a positive number.
    #[error("the compliance of the teeth is unusable: {value} m2/N", value = number(*value))]
    ToothCompliance {
        /// The computed value.
        value: f64,
    },
    /// A law that puts no load on the teeth.
    #[error(
        "the load distribution \"{law}\" returns no load at any position of the path of contact, so that no torque is transmitted"
    )]
    NoLoad {
        /// Name of the law.
        law: String,
    },
    /// Modified flanks require a law with deflections.
    #[error(
        "the load distribution \"{law}\" has no deflections and cannot take modified flanks; use \"elastic\" or \"iso-stiffness\""
    )]
    ModifiedFlanks {
        /// Name of the law.
        law: &'static str,
    },
    /// A relief starts beyond the flank.
    #[error(
        "the relief of the {gear} starts at the diameter {diameter:.5}, which leaves a roll length of {length:.5}: it must be positive"
    )]
    ReliefStart {
        /// The gear.
        gear: Gear,
        /// Given start diameter.
        diameter: Length,
        /// Roll length from the end of the active flank.
        length: Length,
    },
    /// Edge contact of a ring gear.
    #[error("contact of tip edges outside the path of contact is known for external pairs only")]
    EdgeContactOfRing,
    /// The planets collide.
    #[error(
        "{planets} planets do not fit: neighbouring axes are {distance:.5} apart and the tips need {needed:.5}"
    )]
    PlanetsCollide {
        /// Number of planets.
        planets: u32,
        /// Distance of neighbouring planet axes.
        distance: Length,
        /// Tip diameter of a planet.
        needed: Length,
    },
    /// Speed or torque of a shaft does not follow from the stages of a gear train.
    #[error("shaft \"{shaft}\" {rule}")]
    Train {
        /// Name of the shaft.
        shaft: String,
        /// Reason.
        rule: &'static str,
    },
    /// A load sharing law for spur gears on a helical pair.
    #[error("the load sharing \"{law}\" is for spur pairs")]
    SpurLawOnHelical {
        /// Name of the law.
        law: &'static str,
    },
    /// A load sharing law outside its range of contact ratios.
    #[error(
        "the load sharing \"{law}\" holds for transverse contact ratios from {low} to {high}, this pair has {eps_alpha}", low = number(*low), high = number(*high), eps_alpha = decimals(*eps_alpha, 4))]
    SharingRange {
        /// Name of the law.
        law: &'static str,
        /// Transverse contact ratio.
        eps_alpha: f64,
        /// Lower end of the range, excluded.
        low: f64,
        /// Upper end of the range.
        high: f64,
    },
    /// An invalid load sharing table.
    #[error("load sharing table, row {row}: xi = {xi}, share = {share}: {rule}", xi = number(*xi), share = number(*share))]
    SharingTable {
        /// Row, from 0.
        row: usize,
        /// Position in the row.
        xi: f64,
        /// Weight in the row.
        share: f64,
        /// Expectation.
        rule: &'static str,
    },
    /// An invalid number of mesh positions.
    #[error("{count} mesh positions were requested; this pair needs {least} to {most}")]
    PositionCount {
        /// Requested number.
        count: usize,
        /// Minimum: one for each segment of the path.
        least: usize,
        /// Maximum.
        most: usize,
    },
    /// The inverse of the involute function did not converge.
    #[error(
        "no angle with involute {involute} found: the residual is {residual} after {iterations} iterations", involute = number(*involute), residual = number(*residual))]
    InverseInvolute {
        /// Value of the involute function.
        involute: f64,
        /// Residual tan α − α − involute of the last iteration.
        residual: f64,
        /// Number of iterations.
        iterations: usize,
    },
}
