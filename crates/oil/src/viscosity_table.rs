//! Viscosity over temperature as a table, for the thousands of evaluations of a film law.
//!
//! Cubic Hermite interpolation of ln η₀ through values and exact slopes, half a kelvin apart: the
//! interpolation error is h⁴/384 of the fourth derivative, below 10⁻⁹ in ln η₀ for mineral and
//! synthetic oils above -20 °C, 10⁻¹¹ at working temperatures. Beyond the ends ln η₀ continues with the last slope.

use std::sync::{Arc, Mutex, PoisonError};

use asperity_core::quantity::{DynamicViscosity, PerKelvin, Temperature};

use crate::lubricant::ViscosityKey;
use crate::{Lubricant, LubricantError};

/// Distance of the entries \[K\].
const STEP: f64 = 0.5;
/// Range of the table: −60 °C to 500 °C, beyond the temperatures of any lubricated contact.
const SPAN: [f64; 2] = [213.15, 773.15];
/// Largest viscosity of the table, at its cold end: no oil flows there \[Pa s\].
const THICKEST: f64 = 1e6;

/// ln η₀ and its slope over temperature.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ViscosityTable {
    /// First temperature \[K\].
    first: f64,
    /// ln η₀ and its slope over one step.
    entries: Vec<[f64; 2]>,
}

impl ViscosityTable {
    /// The table of a law that gives η₀ and β = −(dη/dT)/η, over the temperatures where it does.
    pub(crate) fn new(
        mut law: impl FnMut(Temperature) -> Option<(DynamicViscosity, PerKelvin)>,
    ) -> Result<Self, LubricantError> {
        let count = ((SPAN[1] - SPAN[0]) / STEP) as usize;
        let mut first = SPAN[0];
        let mut entries = Vec::with_capacity(count + 1);
        for k in 0..=count {
            let t = SPAN[0] + k as f64 * STEP;
            let entry = law(Temperature::from_si(t))
                .filter(|(eta, _)| eta.si() > 0.0 && eta.si() < THICKEST)
                .map(|(eta, beta)| [eta.si().ln(), -beta.si() * STEP])
                .filter(|entry| entry.iter().all(|v| v.is_finite()) && entry[1] < 0.0);
            match entry {
                Some(entry) => {
                    if entries.is_empty() {
                        first = t;
                    }
                    entries.push(entry);
                }
                None if entries.is_empty() => {}
                None => break,
            }
        }
        if entries.len() < 2 {
            return Err(LubricantError::no_viscosity_at_any_temperature());
        }
        Ok(Self { first, entries })
    }

    /// The table of a lubricant. The last one is cached: cases of a study mostly have one oil.
    pub(crate) fn from_lubricant(lubricant: &Lubricant) -> Result<Arc<Self>, LubricantError> {
        static LAST: Mutex<Option<(ViscosityKey, Arc<ViscosityTable>)>> = Mutex::new(None);
        let key = lubricant.viscosity_key();
        let mut last = LAST.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, table)) = last.as_ref().filter(|(known, _)| *known == key) {
            return Ok(Arc::clone(table));
        }
        let mut outside = Vec::new();
        let table = Arc::new(Self::new(|t| {
            outside.clear();
            let (_, eta, beta) = lubricant.viscosity(t, &mut outside).ok()?;
            Some((eta, beta))
        })?);
        *last = Some((key, Arc::clone(&table)));
        Ok(table)
    }

    /// First and last temperature \[K\].
    pub(crate) fn ends(&self) -> [f64; 2] {
        let last = self.first + (self.entries.len() - 1) as f64 * STEP;
        [self.first, last]
    }

    /// ln η₀ and d(ln η₀)/dT at a temperature \[K\].
    #[inline(always)]
    pub(crate) fn at(&self, temperature: f64) -> [f64; 2] {
        let place = (temperature - self.first) / STEP;
        let last = self.entries.len() - 1;
        // Beyond its ends the table goes on in a straight line.
        let inside = place.clamp(0.0, last as f64);
        let k = (inside as usize).min(last - 1);
        let t = inside - k as f64;
        let ([l0, d0], [l1, d1]) = (self.entries[k], self.entries[k + 1]);
        let rise = l1 - l0;
        // l0 + d0 t + (3 rise − 2 d0 − d1) t² + (d0 + d1 − 2 rise) t³
        let (c2, c3) = (3.0 * rise - 2.0 * d0 - d1, d0 + d1 - 2.0 * rise);
        let value = l0 + t * (d0 + t * (c2 + t * c3));
        let slope = d0 + t * (2.0 * c2 + t * 3.0 * c3);
        [value + slope * (place - inside), slope / STEP]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{BaseOil, LubricantInput};

    #[test]
    fn the_table_is_the_law_between_its_entries() {
        let oil = LubricantInput {
            oil: Some("m100".to_owned()),
            base_oil: Some(BaseOil::Mineral),
            ..LubricantInput::default()
        };
        let oil = oil.resolve("90 °C".parse().unwrap()).unwrap();
        let table = ViscosityTable::from_lubricant(&oil).unwrap();
        for (celsius, tolerance) in [(-20.13, 1e-9), (0.2, 1e-9), (90.37, 1e-11), (180.11, 1e-11)] {
            let t = Temperature::from_celsius(celsius);
            let state = oil.at(t).unwrap().value;
            let [l, slope] = table.at(t.si());
            assert!(
                (l - state.dynamic_viscosity.si().ln()).abs() < tolerance,
                "{celsius}"
            );
            let beta = state.temperature_coefficient.si();
            assert!(
                (slope / -beta - 1.0).abs() < 1e-6,
                "{celsius}: {slope} {beta}"
            );
        }
        // Beyond its ends ln η goes straight on.
        for (end, way) in table.ends().into_iter().zip([-10.0, 10.0]) {
            let ([at_end, slope], [beyond, same]) = (table.at(end), table.at(end + way));
            assert!(slope < 0.0 && same == slope);
            assert!((beyond - (at_end + way * slope)).abs() < 1e-10);
        }
    }

    #[test]
    fn an_oil_without_viscosity_is_an_error() {
        assert!(ViscosityTable::new(|_| None).is_err());
    }
}
