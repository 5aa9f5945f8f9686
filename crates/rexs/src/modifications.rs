//! Modifications of the tooth flanks: components that a flank refers to, from REXS 1.2 on.
//!
//! | REXS | case |
//! |---|---|
//! | `tip_relief`, `root_relief` | `tip_relief`, `root_relief` with amount, roll length or start diameter, power |
//! | `profile_crowning`, `helix_crowning` | `profile_crowning`, `crowning`: mean of the amounts at both ends |
//! | `profile_slope`, `helix_slope` | `profile_slope`, `lead_slope` |
//! | `end_relief_datum_face`, `end_relief_non_datum_face` | `end_relief` of a pair |
//!
//! REXS states amounts in mm. Twists, triangular reliefs, topographies and deviations have no key in a case.

use crate::model::Component;
use crate::units::Unit;
use crate::writer::{Text, quantity, rounded, source};
use asperity_core::Fault;

/// Attributes of a relief at the tip or the root.
struct RexsRelief {
    /// Component and key of the case.
    kind: &'static str,
    amount: &'static str,
    length: &'static str,
    diameter: &'static str,
    /// Diameter or roll length at which the amount is stated.
    stated_at: [&'static str; 2],
}

const RELIEFS: [RexsRelief; 2] = [
    RexsRelief {
        kind: "tip_relief",
        amount: "tip_relief_depth",
        length: "tip_relief_datum_length",
        diameter: "tip_relief_datum_diameter",
        stated_at: [
            "tip_relief_evaluation_reference",
            "tip_relief_evaluation_reference_length",
        ],
    },
    RexsRelief {
        kind: "root_relief",
        amount: "root_relief_depth",
        length: "root_relief_datum_length",
        diameter: "root_relief_datum_diameter",
        stated_at: [
            "root_relief_evaluation_reference",
            "root_relief_evaluation_reference_length",
        ],
    },
];

/// Modification of one amount, or of one amount at each end: type, key of the case, attributes.
const AMOUNTS: [(&str, &str, &[&str]); 4] = [
    (
        "profile_crowning",
        "profile_crowning",
        &["profile_crowning_at_tip", "profile_crowning_at_root"],
    ),
    (
        "helix_crowning",
        "crowning",
        &[
            "helix_crowning_amount_datum_face",
            "helix_crowning_amount_non_datum_face",
        ],
    ),
    ("profile_slope", "profile_slope", &["profile_slope"]),
    ("helix_slope", "lead_slope", &["helix_slope"]),
];

/// Faces of an end relief: type, depth, length.
const ENDS: [[&str; 3]; 2] = [
    [
        "end_relief_datum_face",
        "end_relief_depth_datum_face",
        "end_relief_length_datum_face",
    ],
    [
        "end_relief_non_datum_face",
        "end_relief_depth_non_datum_face",
        "end_relief_length_non_datum_face",
    ],
];

impl Text<'_> {
    /// Writes the modifications of a gear's flank, which has this name in the case.
    pub fn modifications(&mut self, name: &str, gear: &Component) -> Result<(), Fault> {
        let Some(flank) = self.flank(gear) else {
            return Ok(());
        };
        if let Some(other) = self.other_flank(gear).filter(|other| other.id != flank.id)
            && self.modifications_of(flank) != self.modifications_of(other)
        {
            self.note(format!(
                "{}: its two flanks have different modifications; those of {} are used",
                gear.label(),
                flank.label()
            ));
        }
        for relief in &RELIEFS {
            self.relief(name, flank, relief)?;
        }
        for (kind, key, attributes) in AMOUNTS {
            self.amount(name, flank, kind, key, attributes)?;
        }
        Ok(())
    }

    /// Types and numbers of the modifications of a flank.
    fn modifications_of(&self, flank: &Component) -> Vec<(String, Vec<(String, String)>)> {
        let kinds = RELIEFS.iter().map(|relief| relief.kind);
        let kinds = kinds.chain(AMOUNTS.iter().map(|(kind, ..)| *kind));
        let kinds = kinds.chain(ENDS.iter().map(|end| end[0]));
        kinds
            .flat_map(|kind| self.model().referenced(flank, kind))
            .map(|part| {
                let values = part.attributes.iter();
                let values = values.map(|(id, attribute)| (id.clone(), attribute.text.clone()));
                (part.kind.clone(), values.collect())
            })
            .collect()
    }

    fn relief(&mut self, name: &str, flank: &Component, names: &RexsRelief) -> Result<(), Fault> {
        let model = self.model();
        let mut reliefs = model.referenced(flank, names.kind);
        let Some(part) = reliefs.next() else {
            return Ok(());
        };
        if reliefs.next().is_some() {
            self.note(format!(
                "{}: of several components {} only {} is used",
                flank.label(),
                names.kind,
                part.label()
            ));
        }
        let Some(amount) = part.number(names.amount, Unit::Micrometre)? else {
            return Ok(());
        };
        let length = part.number(names.length, Unit::Millimetre)?;
        let diameter = part.number(names.diameter, Unit::Millimetre)?;
        let (extent, from) = match (length, diameter) {
            (Some(length), _) => (format!("length = \"{} mm\"", rounded(length)), names.length),
            (None, Some(diameter)) => (
                format!("start_diameter = \"{} mm\"", rounded(diameter)),
                names.diameter,
            ),
            (None, None) => {
                self.note(format!(
                    "{}: {} µm without its length or diameter are left out",
                    part.label(),
                    rounded(amount)
                ));
                return Ok(());
            }
        };
        let power = self.power(part);
        for at in names.stated_at {
            if let Some(place) = part.number(at, Unit::Millimetre)? {
                self.note(format!(
                    "{}: the amount is stated at {at} {} mm and taken as that at the end of the flank",
                    part.label(),
                    rounded(place)
                ));
            }
        }
        self.sourced_line(
            &format!(
                "{name}.{} = {{ amount = \"{} um\", {extent}{power} }}",
                names.kind,
                rounded(amount)
            ),
            &source(&[part], &format!("{}, {from}", names.amount)),
        );
        Ok(())
    }

    /// Power with which a relief grows, as a key of its table.
    fn power(&mut self, part: &Component) -> &'static str {
        const PARABOLIC: &str = ", power = 2";
        match part.text("shape_of_relief") {
            None | Some("linear") => "",
            Some("parabolic") => PARABOLIC,
            Some(shape) => {
                self.note(format!(
                    "{}: its shape {shape} is taken as parabolic",
                    part.label()
                ));
                PARABOLIC
            }
        }
    }

    fn amount(
        &mut self,
        name: &str,
        flank: &Component,
        kind: &'static str,
        key: &str,
        attributes: &[&'static str],
    ) -> Result<(), Fault> {
        let model = self.model();
        let Some(part) = model.referenced(flank, kind).next() else {
            return Ok(());
        };
        let mut stated = Vec::new();
        for attribute in attributes {
            if let Some(amount) = part.number(attribute, Unit::Micrometre)? {
                stated.push((amount, *attribute));
            }
        }
        let Some((first, _)) = stated.first().copied() else {
            return Ok(());
        };
        let mean = stated.iter().map(|(amount, _)| amount).sum::<f64>() / stated.len() as f64;
        if stated.iter().any(|(amount, _)| *amount != first) {
            self.note(format!(
                "{}: the mean of its amounts, {} µm, is used",
                part.label(),
                rounded(mean)
            ));
        }
        if key == "profile_slope" {
            self.note(format!(
                "{}: a positive amount is taken as material missing at the tip; change the sign of {name}.profile_slope if the program that wrote the file counts the other way",
                part.label()
            ));
        }
        let names: Vec<&str> = stated.iter().map(|(_, attribute)| *attribute).collect();
        let mean = quantity(rounded(mean), "um");
        let key = format!("{name}.{key}");
        self.entry(&key, &mean, &[part], &names.join(", "));
        Ok(())
    }

    /// Writes the end relief of a pair: a case has one for both gears and both faces.
    pub fn end_relief(&mut self, gears: &[&Component]) -> Result<(), Fault> {
        let mut reliefs = Vec::new();
        for gear in gears {
            let Some(flank) = self.flank(gear) else {
                continue;
            };
            for [kind, depth, length] in ENDS {
                let Some(part) = self.model().referenced(flank, kind).next() else {
                    continue;
                };
                let amount = part.number(depth, Unit::Micrometre)?;
                let along = part.number(length, Unit::Millimetre)?;
                if let (Some(amount), Some(along)) = (amount, along) {
                    reliefs.push((amount, along, self.power(part), part));
                }
            }
        }
        let Some((amount, length, power, part)) = reliefs.first().copied() else {
            return Ok(());
        };
        let is_one = reliefs
            .iter()
            .all(|(other, along, shape, _)| (*other, *along, *shape) == (amount, length, power));
        let parts: Vec<&Component> = reliefs.iter().map(|(.., part)| *part).collect();
        if !is_one || reliefs.len() != ENDS.len() {
            self.note(format!(
                "a case has one end relief for both faces of the pair: that of {} is used",
                part.label()
            ));
        }
        self.sourced_line(
            &format!(
                "end_relief = {{ amount = \"{} um\", length = \"{} mm\"{power} }}",
                rounded(amount),
                rounded(length)
            ),
            &source(&parts, "depth, length"),
        );
        Ok(())
    }
}
