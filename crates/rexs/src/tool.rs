//! Basic rack of a gear: its addendum, and dedendum and fillet from the tool that cuts the root.
//!
//! A tool with addendum h_aP0* and tip radius ρ_aP0* cuts the dedendum h_fP* = h_aP0* − (x_E − x) and the fillet
//! ρ_fP* = ρ_aP0*, where x_E is the profile shift that the tool generates.

use crate::model::Component;
use crate::units::Unit;
use crate::writer::{Text, rounded};
use asperity_core::Fault;

/// Tools whose reference profile is the counterpart of the basic rack.
const RACKS: [&str; 2] = ["rack_shaped_tool", "profile_tool"];

impl<'a> Text<'a> {
    /// Writes the dedendum and the root fillet of a gear from the first tool that cuts it.
    pub fn tool(&mut self, name: &str, gear: &Component) -> Result<(), Fault> {
        let Some((tool, settings)) = self.tool_of(gear) else {
            return Ok(());
        };
        let module = gear.required("normal_module", Unit::Millimetre)?;
        let relative = |factors: &[&'static str], lengths: &[&'static str]| {
            let factor = tool.first_of(factors, Unit::None)?;
            let length = tool.first_of(lengths, Unit::Millimetre)?;
            Ok::<_, Fault>(factor.or(length.map(|(value, from)| (value / module, from))))
        };
        let addendum = relative(
            &["addendum_coefficient_reference_profile"],
            &["addendum_reference_profile"],
        )?;
        if let Some((addendum, from)) = addendum.filter(|(addendum, _)| *addendum > 0.0) {
            let of = |part: Option<&Component>, attribute| {
                part.map_or(Ok(None), |part| part.number(attribute, Unit::None))
            };
            let generated = of(settings, "generated_addendum_modification_coefficient")?;
            let nominal = of(self.flank(gear), "addendum_modification_coefficient")?;
            let (less, from) = match generated.zip(nominal) {
                Some((generated, nominal)) => (
                    generated - nominal,
                    format!(
                        "{from}, less generated_addendum_modification_coefficient - addendum_modification_coefficient"
                    ),
                ),
                None => (0.0, from.to_owned()),
            };
            let key = format!("{name}.dedendum");
            self.entry(&key, &rounded(addendum - less), &[tool], &from);
        }
        let radius = relative(
            &[
                "tip_corner_radius_factor_reference_profile",
                "tip_radius_factor",
            ],
            &["tip_corner_radius_reference_profile", "tip_radius"],
        )?;
        if let Some((radius, from)) = radius.filter(|(radius, _)| *radius > 0.0) {
            let key = format!("{name}.fillet_radius");
            self.entry(&key, &rounded(radius), &[tool], from);
        }
        Ok(())
    }

    /// The first tool of a gear or of its flank, with the settings of the manufacturing step.
    fn tool_of(&self, gear: &Component) -> Option<(&'a Component, Option<&'a Component>)> {
        let model = self.model();
        let flank = self.flank(gear);
        let is_rack = |tool: &&'a Component| RACKS.contains(&tool.kind.as_str());
        let in_role = |relation: &'a crate::model::Relation, role| {
            relation.role(role).and_then(|id| model.components.get(id))
        };
        let step = model
            .related("manufacturing_step")
            .filter(|step| {
                let piece = step.role("workpiece");
                piece == Some(&gear.id) || piece == flank.map(|flank| flank.id.as_str())
            })
            .find_map(|step| {
                let tool = in_role(step, "tool").filter(is_rack)?;
                Some((tool, in_role(step, "manufacturing_settings")))
            });
        let referred = |origin: &Component| {
            model
                .components
                .get(&origin.id)
                .and_then(|origin| {
                    RACKS
                        .iter()
                        .find_map(|kind| model.referenced(origin, kind).next())
                })
                .map(|tool| (tool, None))
        };
        step.or_else(|| referred(gear))
            .or_else(|| flank.and_then(referred))
    }

    /// Writes the addendum of the basic rack if the flanks of all gears state the same one.
    pub fn addendum(&mut self, gears: &[&Component]) -> Result<(), Fault> {
        const ATTRIBUTE: &str = "addendum_coefficient_basic_profile";
        let (stated, flanks) = self.on_flanks(gears, ATTRIBUTE, Unit::None)?;
        let Some(first) = stated.first().copied() else {
            return Ok(());
        };
        if stated.len() < gears.len() || stated.iter().any(|other| *other != first) {
            let texts: Vec<String> = stated.iter().map(|value| rounded(*value)).collect();
            self.note(format!(
                "a case has one addendum for all gears: {ATTRIBUTE} {} is left out, write tip_diameter",
                texts.join(", ")
            ));
            return Ok(());
        }
        self.entry("addendum", &rounded(first), &flanks, ATTRIBUTE);
        Ok(())
    }
}
