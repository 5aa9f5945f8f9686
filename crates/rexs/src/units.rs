//! Conversion of REXS units to the units of a case.

/// Unit of a number in a case, with its spellings in REXS files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unit {
    /// Dimensionless.
    None,
    /// mm
    Millimetre,
    /// µm
    Micrometre,
    /// Degrees of angle.
    Degree,
    /// °C
    Celsius,
    /// mm²/s
    SquareMillimetrePerSecond,
    /// kg/m³
    KilogramPerCubicMetre,
    /// mm²/N
    SquareMillimetrePerNewton,
    /// MPa
    Megapascal,
    /// N m
    NewtonMetre,
    /// 1/min
    PerMinute,
    /// %
    Percent,
    /// J/(kg K)
    JoulePerKilogramKelvin,
    /// W/(m K)
    WattPerMetreKelvin,
    /// mPa s
    MillipascalSecond,
    /// HV
    Vickers,
}

impl Unit {
    /// Spellings without blanks, each with the factor to the unit of the case; the usual spelling is first.
    fn spellings(self) -> &'static [(&'static str, f64)] {
        match self {
            Self::None => &[("none", 1.0), ("", 1.0), ("-", 1.0)],
            Self::Millimetre => &[("mm", 1.0), ("m", 1e3), ("mum", 1e-3)],
            Self::Micrometre => &[("mum", 1.0), ("um", 1.0), ("µm", 1.0), ("mm", 1e3)],
            // Angles without a unit are in degrees.
            Self::Degree => &[
                ("deg", 1.0),
                ("°", 1.0),
                ("none", 1.0),
                ("", 1.0),
                ("rad", 180.0 / std::f64::consts::PI),
            ],
            Self::Celsius => &[("C", 1.0), ("°C", 1.0)],
            Self::SquareMillimetrePerSecond => &[("mm^2/s", 1.0), ("cSt", 1.0)],
            Self::KilogramPerCubicMetre => &[("kg/dm^3", 1e3), ("kg/m^3", 1.0), ("g/cm^3", 1e3)],
            Self::SquareMillimetrePerNewton => &[("mm^2/N", 1.0)],
            Self::Megapascal => &[("N/mm^2", 1.0), ("MPa", 1.0), ("GPa", 1e3)],
            Self::NewtonMetre => &[("Nm", 1.0), ("kNm", 1e3)],
            Self::PerMinute => &[("1/min", 1.0), ("rpm", 1.0)],
            Self::Percent => &[("%", 1.0)],
            Self::JoulePerKilogramKelvin => &[("J/(kgK)", 1.0)],
            Self::WattPerMetreKelvin => &[("W/(mK)", 1.0)],
            Self::MillipascalSecond => &[("mPas", 1.0), ("Pas", 1e3)],
            Self::Vickers => &[("HV", 1.0), ("none", 1.0), ("", 1.0)],
        }
    }

    fn usual(self) -> &'static str {
        self.spellings()[0].0
    }
}

/// Error of a number or its unit.
pub enum UnitError {
    /// The unit is not a spelling of the expected one, which is given here.
    Unit(&'static str),
    /// Not a finite number.
    Number,
}

/// Parses `text` and converts it from the unit `written` to the unit of the case.
pub fn converted(text: &str, written: &str, unit: Unit) -> Result<f64, UnitError> {
    let written: String = written.split_whitespace().collect();
    let spelling = unit.spellings().iter().find(|(text, _)| *text == written);
    let Some((_, factor)) = spelling else {
        return Err(UnitError::Unit(unit.usual()));
    };
    match text.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value * factor),
        _ => Err(UnitError::Number),
    }
}
