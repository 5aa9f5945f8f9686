//! Names that Python passes as text: read by serde, and listed for the types of the package.

use std::cell::Cell;

use asperity::case::CalibratedName;
use asperity::ehl_regime::FilmLaw;
use asperity::ehl_regime::thermal_reduction::ThermalLaw;
use asperity::formulation::registered;
use asperity::message::{Code, Subject};
use asperity::profile_io::read::{
    Abscissa, DecimalSign, Encoding, Gaps, LengthUnit, Separator, TraceLine, Uneven,
};
use asperity::result::{
    PositionRow, Regime, RunResult, SamplingPart, Scope, Summary, Trust, Uncertainty,
};
use asperity::roughness::form::Form;
use asperity::roughness::gaussian_filter::Ends;
use asperity::roughness::generate::{Amplitudes, Method, Surface};
use asperity::roughness::height_parameters::Mode;
use asperity::tribo_friction::friction_law::FrictionLaw;
use asperity_calibration::oil::Probe;
use asperity_calibration::oil::problem::Zero;
use asperity_studies::callout::RoughnessParameter;
use asperity_studies::change::WornFlank;
use asperity_studies::export::Format;
use asperity_studies::map::MapBand;
use pyo3::prelude::*;
use serde::de::value::Error;
use serde::de::{DeserializeOwned, Deserializer, Error as _, Visitor};
use serde::{Deserialize, forward_to_deserialize_any};
use serde_reflection::{Tracer, TracerConfig};

use crate::contact::ContactNumbers;
use crate::failure::{self, Failure};
use crate::maps::COLUMNS;

/// The choice called `name`; `what` is the argument that it was given to.
pub fn named<T: DeserializeOwned>(what: &str, name: &str) -> Result<T, Failure> {
    serde_json::from_value(serde_json::Value::String(name.to_owned())).map_err(|error| {
        let like = asperity::core::nearest_name(name, &names::<T>());
        let meant = like.map_or(String::new(), |like| format!(". Did you mean `{like}`?"));
        Failure::new(Code::E204, format!("{what}: {error}{meant}"))
    })
}

/// Choices of arguments that no library type has.
macro_rules! choices {
    ($($(#[$about:meta])+ $kind:ident { $($(#[$rename:meta])* $choice:ident),+ $(,)? })+) => {$(
        $(#[$about])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
        #[serde(rename_all = "kebab-case")]
        pub enum $kind { $($(#[$rename])* $choice),+ }
    )+};
}

choices! {
    /// Detail of a run.
    Detail { Losses, Contacts, Fields }
    /// Form that is removed from a profile.
    FormOfProfile { None, Mean, Level, Poly2, Circle, Involute }
    /// Ends of a contact.
    BoundaryOfContact { Free, Periodic, PeriodicSpectral }
    /// Law that a user-defined one replaces.
    LawOf { FilmFriction, FilmThickness, LoadShare, LoadDistribution }
}

/// Reads the names that a derived implementation passes: fields of a structure, variants of an enumeration.
struct Names<'a>(&'a Cell<&'static [&'static str]>);

impl<'de> Deserializer<'de> for Names<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, _: V) -> Result<V::Value, Error> {
        Err(Error::custom("no names"))
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        fields: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Error> {
        self.0.set(fields);
        Err(Error::custom("only names"))
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        variants: &'static [&'static str],
        _: V,
    ) -> Result<V::Value, Error> {
        self.0.set(variants);
        Err(Error::custom("only names"))
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map identifier ignored_any
    }
}

fn names<T: DeserializeOwned>() -> Vec<String> {
    let found = Cell::new([].as_slice());
    let _: Result<T, Error> = T::deserialize(Names(&found));
    found.get().iter().map(|name| (*name).to_owned()).collect()
}

/// A name in Python, the name of its type in Rust, and the names of its choices or columns.
type Listed = (&'static str, &'static str, Vec<String>);

fn listed<T: DeserializeOwned>(name: &'static str) -> Listed {
    let path = std::any::type_name::<T>();
    (name, path.rsplit("::").next().unwrap_or(path), names::<T>())
}

fn trace<T: DeserializeOwned>(tracer: &mut Tracer) -> Result<(), Failure> {
    let traced = tracer.trace_simple_type::<T>();
    traced.map(|_| ()).map_err(|error| {
        Failure::new(
            Code::E501,
            format!("{}: {error}", std::any::type_name::<T>()),
        )
    })
}

/// Names and types of the values of results, as JSON of [`serde_reflection::Registry`].
#[pyfunction]
pub fn values() -> PyResult<String> {
    let mut tracer = Tracer::new(TracerConfig::default().is_human_readable(true));
    trace::<Summary>(&mut tracer)?;
    trace::<PositionRow>(&mut tracer)?;
    trace::<Uncertainty>(&mut tracer)?;
    trace::<ContactNumbers>(&mut tracer)?;
    // Of an enumeration that is a part, only one variant is traced.
    trace::<Regime>(&mut tracer)?;
    trace::<SamplingPart>(&mut tracer)?;
    trace::<Scope>(&mut tracer)?;
    trace::<Subject>(&mut tracer)?;
    trace::<Trust>(&mut tracer)?;
    let traced = tracer.registry();
    let registry = traced.map_err(|error| Failure::new(Code::E501, error.to_string()))?;
    Ok(failure::json(&registry)?)
}

/// The name of `known` most similar to `seen`, if one is similar.
#[pyfunction]
pub fn nearest(seen: &str, known: Vec<String>) -> Option<String> {
    asperity::core::nearest_name(seen, &known)
}

/// Choices of arguments and columns of results, by the names of their types in Python and in Rust.
#[pyfunction]
pub fn choices() -> Vec<Listed> {
    let columns = COLUMNS.iter().map(|(name, _)| (*name).to_owned());
    let own = ["extended", "code", "regime"].map(str::to_owned);
    let formulations = registered();
    let formulations = formulations.iter().map(|known| known.name().to_owned());
    vec![
        ("Formulation", "", formulations.collect()),
        listed::<Detail>("Detail"),
        listed::<MapBand>("Band"),
        listed::<Format>("ExportFormat"),
        listed::<FormOfProfile>("Form"),
        listed::<Form>("TraceForm"),
        listed::<Ends>("Ends"),
        listed::<Mode>("Standard"),
        listed::<BoundaryOfContact>("Boundary"),
        listed::<FilmLaw>("FilmLaw"),
        listed::<ThermalLaw>("ThermalLaw"),
        listed::<FrictionLaw>("FrictionLaw"),
        listed::<LawOf>("LawOf"),
        listed::<Zero>("Zero"),
        listed::<Probe>("TemperatureColumn"),
        listed::<CalibratedName>("CalibratedParameter"),
        listed::<RoughnessParameter>("RoughnessParameter"),
        listed::<WornFlank>("WornFlank"),
        listed::<Surface>("SurfaceKind"),
        listed::<Method>("LikeMethod"),
        listed::<Amplitudes>("Amplitudes"),
        listed::<LengthUnit>("LengthUnit"),
        listed::<DecimalSign>("DecimalSign"),
        listed::<Separator>("Separator"),
        listed::<Encoding>("Encoding"),
        listed::<Gaps>("Gaps"),
        listed::<TraceLine>("TraceLine"),
        listed::<Abscissa>("Abscissa"),
        listed::<Uneven>("Uneven"),
        listed::<RunResult>("ResultName"),
        listed::<Summary>("SummaryName"),
        listed::<PositionRow>("PathColumn"),
        ("MapName", "", columns.chain(own).collect()),
    ]
}
