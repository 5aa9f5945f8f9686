//! The oil file of a fit to traction curves.

use asperity::case::{
    CorrelationInput, FitQuality, FittedFriction, FittedName, OilConstant, OilFile, OilSchema,
};
use asperity::oil::PressureLaw;
use asperity_core::Estimate;
use asperity_core::quantity::{Pressure, Temperature};

use super::oil_fit::{FittedConstant, OilFit};
use super::text::is_simulated_source;
use crate::block::{digits, rounded};

impl OilFit {
    /// The oil file of the fit, with four digits of a number; `None` if the fit does not have its constants.
    #[must_use]
    pub fn oil_file(&self) -> Option<OilFile> {
        let other = &self.other_law;
        let [this_law, other_law] = self.total_squared;
        let by_other = || {
            self.film_friction(
                other.pressure_law,
                other.squares_per_point,
                &other.constants,
                &other.correlations,
                [other_law, this_law],
            )
        };
        Some(OilFile {
            schema: OilSchema::Version1,
            lubricant: self.lubricant.clone(),
            film_friction: self
                .film_friction(
                    self.pressure_law,
                    self.squares_per_point,
                    &self.constants,
                    &self.correlations,
                    [this_law, other_law],
                )
                .map(|fitted| FittedFriction {
                    doubts: self.doubts.clone(),
                    ..fitted
                })?,
            other_law: if self.is_law_decided {
                None
            } else {
                Some(by_other()?)
            },
        })
    }

    /// The constants by a law of pressure; `None` if the fit does not have them.
    fn film_friction(
        &self,
        pressure_law: PressureLaw,
        chi2_per_point: f64,
        constants: &[FittedConstant],
        correlations: &[Vec<f64>],
        [this_law, other_law]: [f64; 2],
    ) -> Option<FittedFriction> {
        let [stress, limit, fall, factor] = constants else {
            return None;
        };
        let megapascals = |value: f64| quantity(value, "MPa");
        let plain = |value: f64| digits(value).parse().ok();
        let numbers: Vec<usize> = (0..FittedName::ALL.len()).collect();
        let written = rounded(&numbers, correlations);
        let pairs = FittedName::ALL.into_iter().enumerate();
        let correlations = pairs.flat_map(|(i, first)| {
            let others = FittedName::ALL.into_iter().enumerate().skip(i + 1);
            let written = &written;
            others.map(move |(j, other)| CorrelationInput {
                between: [first, other],
                value: written[(i, j)],
            })
        });
        let sources = self.sources.iter();
        let sources = sources.map(|[file, sum]| format!("{file}, SHA-256 {sum}"));
        let temperatures = self.temperatures_c.iter();
        Some(FittedFriction {
            pressure_law,
            eyring_stress: constant(stress, megapascals)?,
            limiting_shear: constant(limit, plain)?,
            limiting_shear_temperature: constant(fall, plain)?,
            pressure_viscosity_factor: constant(factor, plain)?,
            correlations: correlations.collect(),
            temperatures: temperatures
                .map(|t| Temperature::from_celsius(*t))
                .collect(),
            pressure_max: quantity(self.pressure_max_gpa, "GPa")?,
            fit: FitQuality {
                points: self.counts[2],
                chi2_per_point: plain(chi2_per_point)?,
                other_law: plain(other_law)?,
                this_law: plain(this_law)?,
            },
            source: sources.collect::<Vec<String>>().join("; "),
            simulated: self.sources.iter().any(is_simulated_source),
            doubts: Vec::new(),
        })
    }
}

/// A constant with its numbers written by `number`.
fn constant<T>(
    fitted: &FittedConstant,
    number: impl Fn(f64) -> Option<T>,
) -> Option<OilConstant<T>> {
    let [low, high] = fitted.band;
    Some(OilConstant {
        fitted: Estimate {
            value: number(fitted.fitted.value)?,
            low: number(low)?,
            high: number(high)?,
        },
        identified: (!fitted.is_identified).then_some(false),
    })
}

/// A quantity of four digits in a unit.
fn quantity(value: f64, unit: &str) -> Option<Pressure> {
    format!("{} {unit}", digits(value)).parse().ok()
}
