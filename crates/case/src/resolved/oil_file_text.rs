//! The text of an oil file.

use asperity_core::Estimate;
use std::fmt;

use asperity_oil::LubricantInput;
use serde::Serialize;

use super::oil_file::{FitQuality, FittedFriction, FittedName, OilConstant, OilFile};
use crate::input::calibration::CorrelationInput;
use crate::text::written;

/// The file as TOML.
impl fmt::Display for OilFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        #[derive(Serialize)]
        struct OilText<'a> {
            lubricant: &'a LubricantInput,
        }
        let Self {
            schema,
            lubricant,
            film_friction,
            other_law,
        } = self;
        let oil = written::file(&OilText { lubricant }).map_err(|_| fmt::Error)?;
        write!(f, "schema = {}\n\n{oil}", inline(schema)?)?;
        table(f, "film_friction", film_friction)?;
        match other_law {
            None => Ok(()),
            Some(other) => table(f, "other_law", other),
        }
    }
}

/// The constants by one law of pressure.
fn table(f: &mut fmt::Formatter<'_>, name: &str, found: &FittedFriction) -> fmt::Result {
    let FittedFriction {
        pressure_law,
        eyring_stress,
        limiting_shear,
        limiting_shear_temperature,
        pressure_viscosity_factor,
        correlations,
        temperatures,
        pressure_max,
        fit,
        source,
        simulated,
        doubts,
    } = found;
    writeln!(f, "\n[{name}]\npressure_law = {}", inline(pressure_law)?)?;
    constant(f, FittedName::EyringStress, eyring_stress)?;
    constant(f, FittedName::LimitingShear, limiting_shear)?;
    let fall = FittedName::LimitingShearTemperature;
    constant(f, fall, limiting_shear_temperature)?;
    let factor = FittedName::PressureViscosityFactor;
    constant(f, factor, pressure_viscosity_factor)?;
    writeln!(f, "correlations = [")?;
    for CorrelationInput { between, value } in correlations {
        let [between, value] = [inline(between)?, inline(value)?];
        writeln!(f, "  {{ between = {between}, value = {value} }},")?;
    }
    writeln!(f, "]\ntemperatures = {}", inline(temperatures)?)?;
    writeln!(f, "pressure_max = {}", inline(pressure_max)?)?;
    let FitQuality {
        points,
        chi2_per_point,
        other_law,
        this_law,
    } = fit;
    let [per_point, other, own] = [chi2_per_point, other_law, this_law].map(inline);
    writeln!(
        f,
        "fit = {{ points = {points}, chi2_per_point = {}, other_law = {}, this_law = {} }}",
        per_point?, other?, own?
    )?;
    writeln!(f, "source = {}", inline(source)?)?;
    if *simulated {
        writeln!(f, "simulated = true")?;
    }
    if doubts.is_empty() {
        Ok(())
    } else {
        writeln!(f, "doubts = {}", inline(doubts)?)
    }
}

/// A line of a constant.
fn constant<T: Serialize>(
    f: &mut fmt::Formatter<'_>,
    name: FittedName,
    fitted: &OilConstant<T>,
) -> fmt::Result {
    let OilConstant { fitted, identified } = fitted;
    let Estimate { value, low, high } = fitted;
    let unit = match name {
        FittedName::LimitingShearTemperature => "  # 1/K",
        _ => "",
    };
    let identified = match identified {
        Some(is_identified) => format!(", identified = {is_identified}"),
        None => String::new(),
    };
    writeln!(
        f,
        "{} = {{ value = {}, low = {}, high = {}{identified} }}{unit}",
        name.key(),
        inline(value)?,
        inline(low)?,
        inline(high)?
    )
}

/// A value on one line.
fn inline<T: Serialize>(value: &T) -> Result<String, fmt::Error> {
    let value = written::value(value).map_err(|_| fmt::Error)?;
    Ok(value.to_string())
}
