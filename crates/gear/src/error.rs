//! Errors of gear geometry, kinematics and load.

use std::fmt::Display;

use asperity_core::quantity::Length;
use asperity_core::{Code, DomainError, Fault, decimals, number};
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
    /// A load sharing law for spur gears on a helical pair.
    #[error("the load sharing \"{law}\" is for spur pairs")]
    SpurLawOnHelical {
        /// Name of the law.
        law: &'static str,
    },
    /// An error that no caller distinguishes from others.
    #[error(transparent)]
    Fault(#[from] Fault),
}

impl GearError {
    /// The base circles overlap at the centre distance.
    pub(crate) fn centre_distance_too_small(given: Length, base_radii: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the centre distance {given:.5} must be larger than the sum of the base radii, {base_radii:.5}"
            ),
        ))
    }

    /// Centre distance and profile shifts contradict each other.
    pub(crate) fn inconsistent_centre_distance(
        given: Length,
        from_shifts: Length,
        tolerance: Length,
    ) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the centre distance {given:.5} contradicts the profile shifts, which give {from_shifts:.5}; they may differ by {tolerance:.5} at most"
            ),
        ))
    }

    /// Tip radii are unknown because only the sum of the profile shifts is known, and no division of it is possible.
    pub(crate) fn tip_radius_unknown(sum: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "neither the profile shifts nor the tip diameters are given: the centre distance gives only the sum of the shifts, {sum}; state both shifts with this sum, or both tip diameters",
                sum = decimals(sum, 4)
            ),
        ))
    }

    /// A tip reaches beyond the involute of the other gear.
    pub(crate) fn interference(gear: Gear, reach: Length, limit: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the tip of the {gear} reaches {reach:.5} along the line of action, past the end of the mating involute at {limit:.5}: interference or undercut"
            ),
        ))
    }

    /// The tip of a ring reaches below the involute of the pinion.
    pub(crate) fn ring_interference(start: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the tip of the ring starts contact at {start:.5} from the base tangent point of the pinion, before its involute begins: interference"
            ),
        ))
    }

    /// The flanks of a tooth intersect below its tip.
    pub(crate) fn pointed_tip(gear: Gear, thickness: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the tooth of the {gear} is pointed: its thickness at the tip would be {thickness:.5}"
            ),
        ))
    }

    /// For every division of the profile shifts a tooth is pointed.
    pub(crate) fn pointed_tips(sum: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "however the profile shifts are divided, a tooth is pointed: the tip half-angles times the tooth numbers sum to {sum} rad and must be positive",
                sum = decimals(sum, 4)
            ),
        ))
    }

    /// The tip circles do not overlap.
    pub(crate) fn no_contact(length: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!("the gears do not touch: the path of contact would be {length:.5} long"),
        ))
    }

    /// One spur pair leaves contact before the next enters.
    pub(crate) fn spur_contact_ratio(eps_alpha: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "a spur pair needs a transverse contact ratio above 1, this one has {eps_alpha}",
                eps_alpha = decimals(eps_alpha, 4)
            ),
        ))
    }

    /// One helical pair leaves contact before the next enters.
    pub(crate) fn total_contact_ratio(eps_gamma: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "a helical pair needs a total contact ratio above 1, this one has {eps_gamma}",
                eps_gamma = decimals(eps_gamma, 4)
            ),
        ))
    }

    /// A position outside the path of contact.
    pub(crate) fn off_path(s: Length, from: Length, to: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!("s = {s:.5} is off the path of contact, which goes from {from:.5} to {to:.5}"),
        ))
    }

    /// A profile coordinate outside the path of contact.
    pub(crate) fn coordinate_off_path(xi: f64, eps_alpha: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "xi = {xi} is off the path of contact, which goes from 0 to {eps_alpha}",
                xi = number(xi),
                eps_alpha = number(eps_alpha)
            ),
        ))
    }

    /// The compliance of a tooth is not a positive number.
    pub(crate) fn tooth_compliance(value: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the compliance of the teeth is unusable: {value} m2/N",
                value = number(value)
            ),
        ))
    }

    /// A law that puts no load on the teeth.
    pub fn no_load(law: impl Display) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the load distribution \"{law}\" returns no load at any position of the path of contact, so that no torque is transmitted"
            ),
        ))
    }

    /// Modified flanks require a law with deflections.
    pub(crate) fn modified_flanks(law: &'static str) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the load distribution \"{law}\" has no deflections and cannot take modified flanks; use \"elastic\" or \"iso-stiffness\""
            ),
        ))
    }

    /// Edge contact of a ring gear.
    pub(crate) fn edge_contact_of_ring() -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            "contact of tip edges outside the path of contact is known for external pairs only",
        ))
    }

    /// The planets collide.
    pub(crate) fn planets_collide(planets: u32, distance: Length, needed: Length) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "{planets} planets do not fit: neighbouring axes are {distance:.5} apart and the tips need {needed:.5}"
            ),
        ))
    }

    /// Speed or torque of a shaft does not follow from the stages of a gear train.
    pub fn train(shaft: &str, rule: &'static str) -> Self {
        Self::Fault(Fault::new(Code::E206, format!("shaft \"{shaft}\" {rule}")))
    }

    /// A load sharing law outside its range of contact ratios.
    pub(crate) fn sharing_range(law: &'static str, eps_alpha: f64, low: f64, high: f64) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "the load sharing \"{law}\" holds for transverse contact ratios from {low} to {high}, this pair has {eps_alpha}",
                low = number(low),
                high = number(high),
                eps_alpha = decimals(eps_alpha, 4)
            ),
        ))
    }

    /// An invalid load sharing table.
    pub(crate) fn sharing_table(row: usize, xi: f64, share: f64, rule: &'static str) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "load sharing table, row {row}: xi = {xi}, share = {share}: {rule}",
                xi = number(xi),
                share = number(share)
            ),
        ))
    }

    /// An invalid number of mesh positions.
    pub(crate) fn position_count(count: usize, least: usize, most: usize) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!("{count} mesh positions were requested; this pair needs {least} to {most}"),
        ))
    }

    /// The inverse of the involute function did not converge.
    pub(crate) fn inverse_involute(involute: f64, residual: f64, iterations: usize) -> Self {
        Self::Fault(Fault::new(
            Code::E206,
            format!(
                "no angle with involute {involute} found: the residual is {residual} after {iterations} iterations",
                involute = number(involute),
                residual = number(residual)
            ),
        ))
    }
}
