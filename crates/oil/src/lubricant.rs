//! The lubricant of a case: from its input to the state at a temperature.

use serde::{Deserialize, Serialize};

use crate::{
    AstmD341, BaseOil, DensityLine, GivenViscosity, LubricantError, LubricantInput,
    TractionConstants, ViscosityLaw, Vogel, cragoe_conductivity, cragoe_heat_capacity,
    gold_pressure_viscosity, library_oil, plausible_pressure_viscosity, viscosity_index,
};
use asperity_core::quantity::{
    Density, DynamicViscosity, KinematicViscosity, PerKelvin, PressureViscosity, SpecificHeat,
    Temperature, ThermalConductivity,
};
use asperity_core::{Checked, DomainError, OutOfRange};

/// The temperature that data sheets state the density at, 15 °C.
const DATA_SHEET_TEMPERATURE: Temperature = Temperature::from_si(288.15);

/// Property of the lubricant that was not given in the case file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Assumption {
    /// Key of the case file.
    pub key: &'static str,
    /// Value used, as text with a unit, or the formula.
    pub value: String,
    /// Reason or source.
    pub source: &'static str,
}

/// A lubricant whose properties can be evaluated at a temperature.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Lubricant {
    viscosity: Viscosity,
    density: DensityLine,
    pressure_viscosity: PressureCoefficient,
    #[serde(skip_serializing_if = "Option::is_none")]
    pressure_viscosity_factor: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    limiting_shear_temperature: Option<PerKelvin>,
    thermal_conductivity: Option<ThermalConductivity>,
    heat_capacity: Option<SpecificHeat>,
    base_oil: Option<BaseOil>,
    assumptions: Vec<Assumption>,
}

/// Law of the viscosity and density, the properties that set the viscosity over temperature.
pub(crate) type ViscosityKey = (Viscosity, DensityLine);

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) enum Viscosity {
    AstmD341(AstmD341),
    Vogel(Vogel),
    Given(GivenViscosity),
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
enum PressureCoefficient {
    Given(PressureViscosity),
    Gold(BaseOil),
}

/// Everything about the oil at one temperature and ambient pressure.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct LubricantState {
    /// Temperature.
    pub temperature: Temperature,
    /// Dynamic viscosity η₀.
    pub dynamic_viscosity: DynamicViscosity,
    /// Kinematic viscosity ν = η₀/ρ.
    pub kinematic_viscosity: KinematicViscosity,
    /// Density ρ.
    pub density: Density,
    /// Pressure-viscosity coefficient α.
    pub pressure_viscosity: PressureViscosity,
    /// Temperature coefficient β_T = −(dη/dT)/η.
    pub temperature_coefficient: PerKelvin,
    /// Thermal conductivity.
    pub thermal_conductivity: ThermalConductivity,
    /// Specific heat capacity.
    pub heat_capacity: SpecificHeat,
}

impl LubricantInput {
    /// The lubricant that the input describes, in a case whose bulk temperature is `bulk`.
    ///
    /// # Errors
    /// When the oil is not in the library, the viscosity, its temperature coefficient, the density
    /// or the pressure-viscosity coefficient is missing, α is implausible (a slip of its unit), or a number is
    /// outside its domain.
    ///
    /// ```
    /// use asperity_oil::{LubricantInput, LubricantError, ViscosityLaw};
    /// let input = LubricantInput {
    ///     viscosity: Some(ViscosityLaw::Given { dynamic_viscosity: "97.5 mPa s".parse()?, temperature: None }),
    ///     density: Some("998 kg/m3".parse()?),
    ///     pressure_viscosity: Some("2e-8 m2/N".parse()?),
    ///     ..LubricantInput::default()
    /// };
    /// // A viscosity at one temperature does not give its slope.
    /// assert!(input.resolve("60 °C".parse()?).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn resolve(&self, bulk: Temperature) -> Result<Lubricant, LubricantError> {
        let mut input = self.complete()?;
        let mut assumptions = Vec::new();
        if let (None, Some(assumed)) = (input.base_oil, input.assume_base_oil) {
            assumptions.push(Assumption {
                key: "base_oil",
                value: assumed.name().to_owned(),
                source: "assumed as asked for: limiting shear 0.030 to 0.055 of the pressure is possible",
            });
            input.base_oil = Some(assumed);
        }
        let viscosity = input.resolve_viscosity(bulk, &mut assumptions)?;
        let density = input.resolve_density(bulk, &mut assumptions)?;
        let pressure_viscosity = input.resolve_coefficient(&mut assumptions)?;
        for (name, given) in [
            ("thermal_conductivity", input.thermal_conductivity.is_some()),
            ("heat_capacity", input.heat_capacity.is_some()),
        ] {
            if !given {
                assumptions.push(Assumption {
                    key: name,
                    value: "from the density".to_owned(),
                    source: "Cragoe 1929",
                });
            }
        }
        let lubricant = Lubricant {
            viscosity,
            density,
            pressure_viscosity,
            pressure_viscosity_factor: input.pressure_viscosity_factor,
            limiting_shear_temperature: input.limiting_shear_temperature,
            thermal_conductivity: input.thermal_conductivity,
            heat_capacity: input.heat_capacity,
            base_oil: input.base_oil,
            assumptions,
        };
        // Numbers outside their domain are found here and not at the first position.
        lubricant.at(bulk)?;
        Ok(lubricant)
    }

    /// This input completed by the library's oil that it names.
    fn complete(&self) -> Result<Self, LubricantError> {
        Ok(match &self.oil {
            Some(name) => self.over(&library_oil(name)?.lubricant),
            None => self.clone(),
        })
    }

    /// This input, completed by the library's oil that it names and then by `base`.
    ///
    /// # Errors
    /// When an oil is not in the library.
    ///
    /// ```
    /// use asperity_oil::LubricantInput;
    /// let base = LubricantInput { oil: Some("m100".into()), ..LubricantInput::default() };
    /// let own = LubricantInput { density: Some("870 kg/m3".parse()?), ..LubricantInput::default() };
    /// let oil = own.completed_by(&base)?;
    /// assert_eq!(oil.density, own.density);
    /// assert!(oil.viscosity.is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn completed_by(&self, base: &Self) -> Result<Self, LubricantError> {
        match self.oil {
            // An oil has all of its properties.
            Some(_) => Ok(self.clone()),
            None => Ok(self.over(&base.complete()?)),
        }
    }

    /// This input, where a viscosity given at one temperature, and its density, hold at `bulk` unless they state a
    /// temperature: for a case whose temperature is changed afterwards, so that the oil becomes thinner as it is heated.
    ///
    /// # Errors
    /// When the oil is not in the library.
    ///
    /// ```
    /// use asperity_oil::{LubricantInput, ViscosityLaw};
    /// let oil = LubricantInput {
    ///     viscosity: Some(ViscosityLaw::Given { dynamic_viscosity: "97.5 mPa s".parse()?, temperature: None }),
    ///     temperature_coefficient: Some("0.045 1/K".parse()?),
    ///     density: Some("998 kg/m3".parse()?),
    ///     pressure_viscosity: Some("2e-8 m2/N".parse()?),
    ///     ..LubricantInput::default()
    /// };
    /// let (stated, hot) = ("60 °C".parse()?, "80 °C".parse()?);
    /// let state = oil.stated_at(stated)?.resolve(hot)?.at(hot)?.value;
    /// assert!((state.dynamic_viscosity.si() - 0.0975 * (-0.9f64).exp()).abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn stated_at(&self, bulk: Temperature) -> Result<Self, LubricantError> {
        let complete = self.complete()?;
        let Some(ViscosityLaw::Given {
            dynamic_viscosity,
            temperature,
        }) = complete.viscosity
        else {
            return Ok(self.clone());
        };
        let mut stated = self.clone();
        if temperature.is_none() {
            stated.viscosity = Some(ViscosityLaw::Given {
                dynamic_viscosity,
                temperature: Some(bulk),
            });
            stated.temperature_coefficient = complete.temperature_coefficient;
        }
        if complete.density_temperature.is_none() {
            stated.density = complete.density;
            stated.density_temperature = Some(bulk);
        }
        Ok(stated)
    }

    /// This input, completed by the values of `base`.
    fn over(&self, base: &Self) -> Self {
        Self {
            replaced: self.replaced.clone(),
            oil: self.oil.clone(),
            oil_file: self.oil_file.clone(),
            viscosity: self.viscosity.or(base.viscosity),
            // The slope belongs to the viscosity that it is the slope of.
            temperature_coefficient: match self.viscosity {
                Some(_) => self.temperature_coefficient,
                None => self
                    .temperature_coefficient
                    .or(base.temperature_coefficient),
            },
            density: self.density.or(base.density),
            density_temperature: match self.density {
                Some(_) => self.density_temperature,
                None => self.density_temperature.or(base.density_temperature),
            },
            thermal_expansion: self.thermal_expansion.or(base.thermal_expansion),
            base_oil: self.base_oil.or(base.base_oil),
            assume_base_oil: self.assume_base_oil.or(base.assume_base_oil),
            pressure_viscosity: self.pressure_viscosity.or(base.pressure_viscosity),
            pressure_viscosity_factor: self
                .pressure_viscosity_factor
                .or(base.pressure_viscosity_factor),
            limiting_shear_temperature: self
                .limiting_shear_temperature
                .or(base.limiting_shear_temperature),
            thermal_conductivity: self.thermal_conductivity.or(base.thermal_conductivity),
            heat_capacity: self.heat_capacity.or(base.heat_capacity),
        }
    }

    fn resolve_viscosity(
        &self,
        bulk: Temperature,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Viscosity, LubricantError> {
        let law = self.viscosity.ok_or_else(LubricantError::no_viscosity)?;
        let second = |law| match self.temperature_coefficient {
            Some(_) => Err(LubricantError::second_temperature_coefficient(law)),
            None => Ok(()),
        };
        match law {
            ViscosityLaw::AstmD341 { at_40, at_100 } => {
                second("astm-d341")?;
                Ok(Viscosity::AstmD341(AstmD341::from_data_sheet(
                    at_40, at_100,
                )?))
            }
            ViscosityLaw::IsoVg {
                grade,
                viscosity_index: index,
            } => {
                second("iso-vg")?;
                let at_40 = viscosity_index::grade(grade)?;
                let at_100 = viscosity_index::viscosity_at_100(at_40, index)?;
                Ok(Viscosity::AstmD341(AstmD341::from_data_sheet(
                    at_40, at_100,
                )?))
            }
            ViscosityLaw::Vogel {
                limit_viscosity,
                slope_kelvin,
                pole_kelvin,
            } => {
                second("vogel")?;
                Ok(Viscosity::Vogel(Vogel {
                    limit_viscosity,
                    slope_kelvin,
                    pole_kelvin,
                }))
            }
            ViscosityLaw::Given {
                dynamic_viscosity,
                temperature,
            } => Ok(Viscosity::Given(GivenViscosity {
                viscosity: dynamic_viscosity,
                temperature: temperature.unwrap_or_else(|| {
                    assumptions.push(Assumption {
                        key: "viscosity.temperature",
                        value: bulk.to_string(),
                        source: "the bulk temperature of the case",
                    });
                    bulk
                }),
                temperature_coefficient: self
                    .temperature_coefficient
                    .ok_or_else(LubricantError::no_temperature_coefficient)?,
            })),
        }
    }

    fn resolve_density(
        &self,
        bulk: Temperature,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<DensityLine, LubricantError> {
        let density = self.density.ok_or({
            if self.pressure_viscosity.is_none() && self.base_oil.is_none() {
                LubricantError::no_density_nor_pressure_viscosity()
            } else {
                LubricantError::no_density()
            }
        })?;
        let temperature = self.density_temperature.unwrap_or_else(|| {
            let (temperature, source) = match self.viscosity {
                Some(ViscosityLaw::Given { .. }) => (bulk, "the bulk temperature of the case"),
                _ => (DATA_SHEET_TEMPERATURE, "usual on data sheets"),
            };
            assumptions.push(Assumption {
                key: "density_temperature",
                value: temperature.to_string(),
                source,
            });
            temperature
        });
        let expansion = self.thermal_expansion.unwrap_or_else(|| {
            let (base_oil, source) = match self.base_oil {
                Some(base_oil) => (base_oil, "Fernandes 2013, for the base oil"),
                None => (BaseOil::Mineral, "Fernandes 2013, for mineral oil"),
            };
            let expansion = base_oil.thermal_expansion();
            assumptions.push(Assumption {
                key: "thermal_expansion",
                value: expansion.to_string(),
                source,
            });
            expansion
        });
        Ok(DensityLine {
            density,
            temperature,
            expansion,
        })
    }

    fn resolve_coefficient(
        &self,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<PressureCoefficient, LubricantError> {
        if let Some(alpha) = self.pressure_viscosity {
            return Ok(PressureCoefficient::Given(plausible_pressure_viscosity(
                alpha,
            )?));
        }
        let base_oil = self
            .base_oil
            .ok_or_else(LubricantError::no_pressure_viscosity)?;
        assumptions.push(Assumption {
            key: "pressure_viscosity",
            value: "from the kinematic viscosity and the base oil".to_owned(),
            source: "Gold 2001 with the constants of Fernandes 2013",
        });
        Ok(PressureCoefficient::Gold(base_oil))
    }
}

impl Lubricant {
    /// Family of the base oil, where it is known or assumed.
    pub fn base_oil(&self) -> Option<BaseOil> {
        self.base_oil
    }

    /// Whether `other` is the same oil, by its viscosity and its base oil, whatever else is stated of either.
    #[must_use]
    pub fn is_oil_of(&self, other: &Self) -> bool {
        self.viscosity == other.viscosity && self.base_oil == other.base_oil
    }

    /// Largest |ln| of the ratio of both kinematic viscosities at 40 and at 100 °C; infinite if a law has no viscosity there.
    #[must_use]
    pub fn viscosity_distance(&self, other: &Self) -> f64 {
        let viscosity = |of: &Self, celsius: f64| {
            let found = of.viscosity(Temperature::from_celsius(celsius), &mut Vec::new());
            found.map_or(f64::NAN, |(density, eta, _)| eta.si() / density.si())
        };
        let distance = |celsius: f64| (viscosity(self, celsius) / viscosity(other, celsius)).ln();
        let distances = [40.0, 100.0].map(|celsius| distance(celsius).abs());
        if distances.iter().all(|one| one.is_finite()) {
            distances[0].max(distances[1])
        } else {
            f64::INFINITY
        }
    }

    /// Whether its viscosity is known over temperature, and not only at one.
    #[must_use]
    pub fn has_viscosity_law(&self) -> bool {
        !matches!(self.viscosity, Viscosity::Given(_))
    }

    /// Pressure-viscosity coefficient, where it is given and not estimated.
    pub fn given_pressure_viscosity(&self) -> Option<PressureViscosity> {
        match self.pressure_viscosity {
            PressureCoefficient::Given(alpha) => Some(alpha),
            PressureCoefficient::Gold(_) => None,
        }
    }

    /// Thermal conductivity, where it is given and not estimated.
    pub fn given_thermal_conductivity(&self) -> Option<ThermalConductivity> {
        self.thermal_conductivity
    }

    /// Constants of the film friction: the constants of the family `base_oil`, with the properties that the input gives.
    ///
    /// # Errors
    /// As [`BaseOil::data`].
    pub fn traction_constants(
        &self,
        base_oil: BaseOil,
    ) -> Result<TractionConstants, LubricantError> {
        let of_family = TractionConstants::from_family(base_oil)?;
        Ok(TractionConstants {
            conductivity: self.thermal_conductivity.unwrap_or(of_family.conductivity),
            pressure_viscosity_factor: self
                .pressure_viscosity_factor
                .unwrap_or(of_family.pressure_viscosity_factor),
            limiting_shear_fall: self
                .limiting_shear_temperature
                .unwrap_or(of_family.limiting_shear_fall),
            ..of_family
        })
    }

    /// Missing input.
    pub fn assumptions(&self) -> &[Assumption] {
        &self.assumptions
    }

    /// The state at a temperature, with a note of every correlation that left its range.
    ///
    /// # Errors
    /// When the temperature is not positive or a law has no value there.
    ///
    /// ```
    /// use asperity_oil::{LubricantInput, ViscosityLaw};
    /// let oil = LubricantInput {
    ///     viscosity: Some(ViscosityLaw::Given { dynamic_viscosity: "97.5 mPa s".parse()?, temperature: None }),
    ///     temperature_coefficient: Some("0.045 1/K".parse()?),
    ///     density: Some("998 kg/m3".parse()?),
    ///     pressure_viscosity: Some("2e-8 m2/N".parse()?),
    ///     ..LubricantInput::default()
    /// }
    /// .resolve("60 °C".parse()?)?;
    /// let state = oil.at("60 °C".parse()?)?;
    /// assert!(state.outside.is_empty());
    /// assert_eq!(state.value.dynamic_viscosity, "97.5 mPa s".parse()?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn at(&self, temperature: Temperature) -> Result<Checked<LubricantState>, LubricantError> {
        let mut outside = Vec::new();
        let (density, eta, beta) = self.viscosity(temperature, &mut outside)?;
        let nu = KinematicViscosity::from_si(eta.si() / density.si());
        let alpha = match self.pressure_viscosity {
            PressureCoefficient::Given(alpha) => alpha,
            PressureCoefficient::Gold(base_oil) => {
                noted(gold_pressure_viscosity(base_oil, nu)?, &mut outside)
            }
        };
        let density_15 = self.density.at(DATA_SHEET_TEMPERATURE)?;
        let conductivity = match self.thermal_conductivity {
            Some(given) => {
                DomainError::positive("thermal conductivity", given)?;
                given
            }
            None => noted(cragoe_conductivity(density_15, temperature)?, &mut outside),
        };
        let heat_capacity = match self.heat_capacity {
            Some(given) => {
                DomainError::positive("specific heat capacity", given)?;
                given
            }
            None => noted(cragoe_heat_capacity(density_15, temperature)?, &mut outside),
        };
        Ok(Checked {
            value: LubricantState {
                temperature,
                dynamic_viscosity: eta,
                kinematic_viscosity: nu,
                density,
                pressure_viscosity: alpha,
                temperature_coefficient: beta,
                thermal_conductivity: conductivity,
                heat_capacity,
            },
            outside,
        })
    }

    pub(crate) fn viscosity_key(&self) -> ViscosityKey {
        (self.viscosity, self.density)
    }

    /// ρ, η and β_T; of a kinematic law the expansion of the oil has its share in β_T.
    pub(crate) fn viscosity(
        &self,
        temperature: Temperature,
        outside: &mut Vec<OutOfRange>,
    ) -> Result<(Density, DynamicViscosity, PerKelvin), LubricantError> {
        let density = self.density.at(temperature)?;
        let (eta, beta) = match self.viscosity {
            Viscosity::AstmD341(law) => {
                let (nu, beta) = law.viscosity_and_slope(temperature)?;
                let nu = noted(nu, outside);
                let expansion = self.density.temperature_coefficient(temperature)?;
                (
                    DynamicViscosity::from_si(nu.si() * density.si()),
                    beta + expansion,
                )
            }
            Viscosity::Vogel(law) => (
                law.dynamic_viscosity(temperature)?,
                law.temperature_coefficient(temperature)?,
            ),
            Viscosity::Given(law) => (
                noted(law.dynamic_viscosity(temperature)?, outside),
                law.temperature_coefficient,
            ),
        };
        Ok((density, eta, beta))
    }
}

/// The value, its notes moved to `outside`.
fn noted<T>(checked: Checked<T>, outside: &mut Vec<OutOfRange>) -> T {
    outside.extend(checked.outside);
    checked.value
}
