//! The oil of a case from the component `lubricant` of a REXS file.

use crate::model::Component;
use crate::units::Unit;
use crate::writer::{Text, quantity, rounded, source};
use asperity_core::Fault;

/// Oil of a file without a lubricant.
const OIL: &str = "m100";

/// Attributes that name the family of the base oil, the most specific first.
const TYPES: [&str; 4] = [
    "lubricant_type_agma_925_2003",
    "lubricant_type_agma_925_a03",
    "lubricant_type_iso_6336_2019",
    "lubricant_type_iso_6336_2006",
];

/// Pressure-viscosity coefficients: at the temperature of the teeth, then at 38 °C.
const COEFFICIENTS: [&str; 3] = [
    "pressure_viscosity_coefficient_agma_925_2003",
    "pressure_viscosity_coefficient_agma_925_a03",
    "pressure_viscosity_coefficient_at_38_degrees_celsius",
];

/// Parameters k and s of α = k η^s (AGMA 925-A03) with η in mPa s and α in mm²/N, by version of REXS.
const PARAMETERS: [[&str; 3]; 2] = [
    [
        "parameter_k_for_calculation_of_pressure_viscosity_coefficient_agma_925_2003",
        "parameter_s_for_calculation_of_pressure_viscosity_coefficient_agma_925_2003",
        "dynamic_viscosity_at_gear_tooth_temperature_agma_925_2003",
    ],
    [
        "parameter_k_for_calculation_of_pressure_viscosity_coefficient_agma_925_a03",
        "parameter_s_for_calculation_of_pressure_viscosity_coefficient_agma_925_a03",
        "dynamic_viscosity_at_gear_tooth_temperature_agma_925_a03",
    ],
];

/// Family of a value of [`TYPES`].
fn family(value: &str) -> Option<&'static str> {
    match value {
        "mineral_oil" => Some("mineral"),
        "pao_based_synthetic_oil" | "polyalfaolefin" => Some("pao"),
        "pag_based_synthetic_oil" | "water_soluble_polyglycol" | "non_water_soluble_polyglycol" => {
            Some("polyglycol")
        }
        // The oils of MIL-L-7808 and MIL-L-23699 are esters.
        "mil_l_23699e" | "mil_l_7808k_grade_3" | "mil_l_7808k_grade_4" => Some("ester"),
        _ => None,
    }
}

/// Family assumed for a value of `basis` that is not a family.
fn assumed(basis: &str) -> &'static str {
    match basis {
        "synthetic" => "pao",
        "biologic-degradable" | "biologic_degradable" => "ester",
        _ => "mineral",
    }
}

impl Text<'_> {
    /// Writes the oil of the mesh, with the operating temperature \[°C\] if the file states it.
    pub fn lubricant(&mut self, mesh: &Component, temperature: Option<f64>) -> Result<(), Fault> {
        self.heading("lubricant");
        let model = self.model();
        let mut oils = model.of_kind("lubricant");
        let Some(oil) = oils.next() else {
            self.sourced_line(
                &format!("oil = \"{OIL}\""),
                "default: the file has no lubricant",
            );
            self.note(format!("the file has no lubricant: {OIL}"));
            return Ok(());
        };
        if oils.next().is_some() {
            self.note(format!(
                "the file has several lubricants: {} is used",
                oil.label()
            ));
        }
        if let Some(name) = oil.text("name") {
            self.comment(&format!("{}: name {name}", source(&[oil], "name")));
        }
        if oil.text("kind") == Some("grease") {
            self.note(format!(
                "{} is a grease: the case is that of an oil with the stated viscosity",
                oil.label()
            ));
        }
        let density = "density_at_15_degree_celsius";
        let rho = oil.required(density, Unit::KilogramPerCubicMetre)?;
        self.viscosity(oil, mesh, temperature, rho)?;
        let rho = quantity(rounded(rho), "kg/m3");
        self.entry("density", &rho, &[oil], density);
        self.pressure_viscosity(oil, mesh)?;
        let optional = [
            (
                "thermal_capacity",
                "heat_capacity",
                Unit::JoulePerKilogramKelvin,
                "J/(kg K)",
            ),
            (
                "thermal_conductivity",
                "thermal_conductivity",
                Unit::WattPerMetreKelvin,
                "W/(m K)",
            ),
        ];
        for (attribute, key, unit, written) in optional {
            if let Some(value) = oil.number(attribute, unit)? {
                self.entry(key, &quantity(value, written), &[oil], attribute);
            }
        }
        self.base_oil(oil);
        Ok(())
    }

    /// Writes the viscosity: from those at 40 and 100 °C, otherwise the one at the operating temperature.
    fn viscosity(
        &mut self,
        oil: &Component,
        mesh: &Component,
        temperature: Option<f64>,
        rho: f64,
    ) -> Result<(), Fault> {
        const COLD: &str = "viscosity_at_40_degree_celsius";
        const HOT: &str = "viscosity_at_100_degree_celsius";
        let at = |attribute| oil.number(attribute, Unit::SquareMillimetrePerSecond);
        let operating = self.operating_viscosity(mesh)?;
        let both = at(COLD)?.zip(at(HOT)?);
        match (both, &operating, temperature) {
            (Some((cold, hot)), ..) => {
                self.sourced_line(
                    &format!(
                        "viscosity = {{ law = \"astm-d341\", at_40 = \"{cold} mm2/s\", at_100 = \"{hot} mm2/s\" }}"
                    ),
                    &source(&[oil], "viscosity_at_40_degree_celsius, _at_100_"),
                );
                if let Some((nu, from)) = &operating {
                    self.comment(&format!(
                        "{from} is {nu} mm2/s; the case takes it from the viscosities at 40 and 100 °C"
                    ));
                }
            }
            (None, Some((nu, from)), Some(temperature)) => {
                // mm²/s times kg/m³ is 1e-3 mPa s.
                let eta = rounded(nu * rho * 1e-3);
                self.sourced_line(
                    &format!(
                        "viscosity = {{ law = \"given\", dynamic_viscosity = \"{eta} mPa s\", temperature = \"{temperature} °C\" }}"
                    ),
                    &format!("{from} times the density at 15 °C"),
                );
                self.note(
                    "the viscosity is known at the operating temperature only: write lubricant.viscosity with at_40 and at_100 for other temperatures",
                );
            }
            _ => {
                oil.required(COLD, Unit::SquareMillimetrePerSecond)?;
                oil.required(HOT, Unit::SquareMillimetrePerSecond)?;
            }
        }
        Ok(())
    }

    fn operating_viscosity(&self, mesh: &Component) -> Result<Option<(f64, String)>, Fault> {
        const ATTRIBUTE: &str = "operating_viscosity";
        let casings = self.model().of_kind("gear_casing");
        for component in std::iter::once(mesh).chain(casings) {
            if let Some(nu) = component.number(ATTRIBUTE, Unit::SquareMillimetrePerSecond)? {
                return Ok(Some((nu, source(&[component], ATTRIBUTE))));
            }
        }
        Ok(None)
    }

    fn pressure_viscosity(&mut self, oil: &Component, mesh: &Component) -> Result<(), Fault> {
        let stated = oil.first_of(&COEFFICIENTS, Unit::SquareMillimetrePerNewton)?;
        let stated = stated.filter(|(alpha, _)| *alpha > 0.0);
        if let Some((alpha, from)) = stated {
            let alpha = quantity(alpha, "mm2/N");
            self.entry("pressure_viscosity", &alpha, &[oil], from);
            return Ok(());
        }
        for [k, s, eta] in PARAMETERS {
            let factor = oil.number(k, Unit::None)?;
            let exponent = oil.number(s, Unit::None)?;
            let viscosity = mesh.number(eta, Unit::MillipascalSecond)?;
            let Some((factor, exponent)) = factor.zip(exponent) else {
                continue;
            };
            if let Some(viscosity) = viscosity {
                let alpha = rounded(factor * viscosity.powf(exponent));
                self.sourced_line(
                    &format!("pressure_viscosity = \"{alpha} mm2/N\""),
                    &format!("{k} times {eta} to the power {s}"),
                );
            } else {
                self.note(format!(
                    "{}: α = {factor} η^{exponent} mm2/N (AGMA 925) is left out, because {} has no {eta}: write lubricant.pressure_viscosity",
                    oil.label(),
                    mesh.label()
                ));
            }
            return Ok(());
        }
        Ok(())
    }

    /// Writes the family of the base oil, or the one assumed.
    fn base_oil(&mut self, oil: &Component) {
        let basis = oil.text("basis");
        let stated = TYPES.iter().find_map(|name| Some((oil.text(name)?, *name)));
        if let Some((value, from)) = stated
            && let Some(family) = family(value)
        {
            self.sourced_line(
                &format!("base_oil = \"{family}\""),
                &format!("{}, {value}", source(&[oil], from)),
            );
            return;
        }
        match basis {
            Some("mineral") => {
                self.entry("base_oil", "\"mineral\"", &[oil], "basis");
            }
            _ => {
                let family = basis.map_or("mineral", assumed);
                let why = match (stated, basis) {
                    (Some((value, _)), _) | (None, Some(value)) => {
                        format!("{value} is not the name of a base oil")
                    }
                    (None, None) => "the file does not name the base oil".to_owned(),
                };
                self.sourced_line(
                    &format!("assume_base_oil = \"{family}\""),
                    &format!("assumed: {why}"),
                );
                self.note(format!("the base oil is assumed to be {family}: {why}"));
            }
        }
    }
}
