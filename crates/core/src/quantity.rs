//! Physical quantities as types: SI inside, text with a unit at the borders.
//!
//! A quantity parses from and prints as text with a unit, and the way there and back is exact to
//! the last bit. Units that are powers of ten of the SI unit shift the decimal exponent of the
//! text, so "1.3 mm" is 0.0013 and not 1.3 · 0.001.
//!
//! ```
//! use asperity_core::quantity::{Length, Pressure, Torque};
//! let module: Length = "1.3 mm".parse()?;
//! assert_eq!(module.si(), 0.0013);
//! assert_eq!(module.to_string(), "1.3 mm");
//! assert_eq!("285 N·m".parse::<Torque>()?, "285 Nm".parse()?);
//! assert!("285".parse::<Torque>().is_err());
//! assert_eq!(Pressure::from_si(210e9).to_string(), "210 GPa");
//! // A precision asks for that many digits, for messages.
//! assert_eq!(format!("{:.4}", Length::from_si(0.002_200_499_999_9)), "2.2 mm");
//! # Ok::<(), asperity_core::quantity::QuantityError>(())
//! ```

use std::f64::consts::PI;

mod error;
mod ratio;
mod text;
mod unit;

pub use error::QuantityError;
pub use ratio::Ratio;
pub use unit::{Description, Quantity, Scale, Unit};

use text::{QuantityVisitor, parse, print};

macro_rules! quantities {
    ($($(#[$doc:meta])* $type:ident, $name:literal, $si:literal: [$($unit:expr),+ $(,)?];)+) => {
    /// Every quantity, for the page of units.
    pub const QUANTITIES: &[Description] = &[$(Description {
        type_name: stringify!($type),
        name: $name,
        si_unit: $si,
        units: $type::UNITS,
        read: |text| Ok(text.parse::<$type>()?.si()),
    }),+];

    $(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd, Default)]
        pub struct $type(f64);

        impl $type {
            /// The quantity of this value in SI units.
            #[inline]
            pub const fn from_si(value: f64) -> Self {
                Self(value)
            }

            /// The value in SI units.
            #[inline]
            pub const fn si(self) -> f64 {
                self.0
            }
        }

        impl Quantity for $type {
            const NAME: &'static str = $name;
            const SI_UNIT: &'static str = $si;
            const UNITS: &'static [Unit] = &[$($unit),+];

            #[inline]
            fn si(self) -> f64 {
                self.0
            }

            #[inline]
            fn from_si(value: f64) -> Self {
                Self(value)
            }
        }

        impl std::str::FromStr for $type {
            type Err = QuantityError;

            fn from_str(text: &str) -> Result<Self, QuantityError> {
                parse(text)
            }
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                print(*self, f)
            }
        }

        impl serde::Serialize for $type {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.collect_str(self)
            }
        }

        impl<'de> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                deserializer.deserialize_any(QuantityVisitor(std::marker::PhantomData))
            }
        }

        #[cfg(feature = "schema")]
        impl schemars::JsonSchema for $type {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($type).into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!({
                    "type": "string",
                    "description": format!("{} with a unit: {}", $name, text::accepted::<Self>()),
                })
            }
        }

        impl std::ops::Add for $type {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                Self(self.0 + other.0)
            }
        }

        impl std::ops::Sub for $type {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                Self(self.0 - other.0)
            }
        }

        impl std::ops::Neg for $type {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        impl std::ops::Mul<f64> for $type {
            type Output = Self;
            #[inline]
            fn mul(self, factor: f64) -> Self {
                Self(self.0 * factor)
            }
        }

        impl std::ops::Div<f64> for $type {
            type Output = Self;
            #[inline]
            fn div(self, divisor: f64) -> Self {
                Self(self.0 / divisor)
            }
        }

        impl std::ops::Div for $type {
            type Output = f64;
            #[inline]
            fn div(self, other: Self) -> f64 {
                self.0 / other.0
            }
        }
    )+};
}

const fn shown(symbol: &'static str, scale: Scale) -> Unit {
    Unit {
        symbol,
        spellings: &[],
        scale,
        prints: true,
    }
}

const fn read(symbol: &'static str, scale: Scale) -> Unit {
    Unit {
        symbol,
        spellings: &[],
        scale,
        prints: false,
    }
}

const fn spelt(
    symbol: &'static str,
    spellings: &'static [&'static str],
    scale: Scale,
    prints: bool,
) -> Unit {
    Unit {
        symbol,
        spellings,
        scale,
        prints,
    }
}

use Scale::{Celsius, Decimal, Factor};

quantities! {
    /// A length \[m\].
    Length, "length", "m": [
        shown("mm", Decimal(-3)), spelt("um", &["micron", "micrometer", "micrometre"], Decimal(-6), true), shown("nm", Decimal(-9)), read("m", Decimal(0)), read("cm", Decimal(-2)),
    ];
    /// A plane angle \[rad\].
    Angle, "angle", "rad": [
        spelt("deg", &["degree", "degrees"], Factor(PI / 180.0), true), read("rad", Decimal(0)),
    ];
    /// A time \[s\].
    Time, "time", "s": [shown("s", Decimal(0)), shown("ms", Decimal(-3)), read("min", Factor(60.0)), read("h", Factor(3600.0))];
    /// A speed \[m/s\].
    Speed, "speed", "m/s": [shown("m/s", Decimal(0)), read("mm/s", Decimal(-3)), read("km/h", Factor(1.0 / 3.6))];
    /// A rotational speed \[rad/s\].
    AngularSpeed, "rotational speed", "rad/s": [
        spelt("1/min", &["rpm", "min-1", "r/min", "rev/min", "U/min"], Factor(PI / 30.0), true), read("rad/s", Decimal(0)), read("1/s", Factor(2.0 * PI)),
    ];
    /// A mass \[kg\].
    Mass, "mass", "kg": [shown("kg", Decimal(0)), read("t", Decimal(3)), read("g", Decimal(-3))];
    /// An area \[m²\].
    Area, "area", "m2": [shown("m2", Decimal(0)), read("cm2", Decimal(-4)), read("mm2", Decimal(-6))];
    /// A force \[N\].
    Force, "force", "N": [shown("kN", Decimal(3)), shown("N", Decimal(0))];
    /// A force per length of contact line \[N/m\].
    LineLoad, "line load", "N/m": [
        shown("N/mm", Decimal(3)), shown("N/m", Decimal(0)), read("kN/m", Decimal(3)),
    ];
    /// A torque \[N m\].
    Torque, "torque", "N m": [shown("N m", Decimal(0)), read("kN m", Decimal(3)), read("N mm", Decimal(-3))];
    /// A power \[W\].
    Power, "power", "W": [shown("kW", Decimal(3)), shown("W", Decimal(0)), read("MW", Decimal(6))];
    /// An energy \[J\].
    Energy, "energy", "J": [shown("J", Decimal(0)), shown("mJ", Decimal(-3)), read("kJ", Decimal(3))];
    /// An energy per length of contact line \[J/m\].
    LineEnergy, "energy per length", "J/m": [shown("J/m", Decimal(0)), shown("mJ/m", Decimal(-3))];
    /// A pressure, stress or elastic modulus \[Pa\].
    Pressure, "pressure", "Pa": [
        shown("GPa", Decimal(9)), spelt("MPa", &["N/mm2"], Decimal(6), true), shown("kPa", Decimal(3)), spelt("Pa", &["N/m2"], Decimal(0), true), read("bar", Decimal(5)),
    ];
    /// A dynamic viscosity \[Pa s\].
    DynamicViscosity, "dynamic viscosity", "Pa s": [
        spelt("mPa s", &["cP"], Decimal(-3), true), read("Pa s", Decimal(0)),
    ];
    /// A kinematic viscosity \[m²/s\].
    KinematicViscosity, "kinematic viscosity", "m2/s": [
        spelt("mm2/s", &["cSt"], Decimal(-6), true), read("m2/s", Decimal(0)),
    ];
    /// A density \[kg/m³\].
    Density, "density", "kg/m3": [shown("kg/m3", Decimal(0)), spelt("g/cm3", &["g/ml", "kg/l"], Decimal(3), false)];
    /// A pressure-viscosity coefficient \[1/Pa\].
    PressureViscosity, "pressure-viscosity coefficient", "1/Pa": [
        spelt("1/GPa", &["GPa-1"], Decimal(-9), true), spelt("1/Pa", &["m2/N", "Pa-1"], Decimal(0), false), spelt("mm2/N", &["1/MPa"], Decimal(-6), false),
    ];
    /// A temperature \[K\]; text may say °C.
    Temperature, "temperature", "K": [spelt("°C", &["C"], Celsius, true), read("K", Decimal(0))];
    /// A difference of temperatures \[K\].
    TemperatureDifference, "temperature difference", "K": [shown("K", Decimal(0))];
    /// A thermal conductivity \[W/(m K)\].
    ThermalConductivity, "thermal conductivity", "W/(m K)": [spelt("W/(m K)", &["W/m/K"], Decimal(0), true)];
    /// A thermal conductance \[W/K\].
    ThermalConductance, "thermal conductance", "W/K": [shown("W/K", Decimal(0)), read("kW/K", Decimal(3))];
    /// A volume of fluid per time \[m³/s\].
    VolumeFlow, "volume flow", "m3/s": [spelt("l/min", &["L/min"], Factor(1e-3 / 60.0), true), read("m3/s", Decimal(0)), read("m3/h", Factor(1.0 / 3600.0))];
    /// A specific heat capacity \[J/(kg K)\].
    SpecificHeat, "specific heat capacity", "J/(kg K)": [spelt("J/(kg K)", &["J/kg/K"], Decimal(0), true), spelt("kJ/(kg K)", &["kJ/kg/K"], Decimal(3), false)];
    /// A relative change per kelvin \[1/K\].
    PerKelvin, "temperature coefficient", "1/K": [spelt("1/K", &["K-1", "1/degC"], Decimal(0), true)];
}

impl Temperature {
    /// The temperature from its number of degrees Celsius.
    ///
    /// ```
    /// use asperity_core::quantity::Temperature;
    /// assert_eq!(Temperature::from_celsius(90.0).si(), 363.15);
    /// ```
    #[must_use]
    pub fn from_celsius(celsius: f64) -> Self {
        Self::from_si(celsius + unit::ICE)
    }

    /// The temperature in °C.
    #[must_use]
    pub fn celsius(self) -> f64 {
        self.si() - unit::ICE
    }
}
