//! Settings of studies, each stated once; the faces make options, arguments and documents from them.

use asperity_core::{Code, Fault, in_plain_words};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value, json};

/// Description of a setting, or of the subject of a study, from which the faces make an option or an argument.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Setting {
    /// Name of the field.
    pub name: &'static str,
    /// Type in Rust.
    pub kind: &'static str,
    /// Meaning.
    pub about: &'static str,
    /// Value if none is stated; `None` if it must be stated or has none.
    pub default: Option<Value>,
}

impl Setting {
    /// Setting `name` of type `kind`.
    #[must_use]
    pub fn new(
        name: &'static str,
        kind: &'static str,
        about: &'static str,
        default: Option<Value>,
    ) -> Self {
        Self {
            name,
            kind,
            about,
            default,
        }
    }

    /// Whether it must be stated: a type that can be absent is `None`, `false` or empty.
    fn is_required(&self) -> bool {
        let can_be_absent = ["Option<", "Vec<", "bool"];
        let is_absent = can_be_absent.iter().any(|kind| self.kind.starts_with(kind));
        self.default.is_none() && !is_absent
    }
}

/// JSON Schema of a type.
pub type SchemaOf = fn(&mut SchemaGenerator) -> Schema;

/// JSON Schema of the type `T`, which may refer to a definition.
pub fn schema_of<T: JsonSchema>(generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<T>()
}

/// Settings as an object of JSON.
pub type Stated = Map<String, Value>;

/// Settings of a study; [`settings!`](crate::settings) makes them.
pub trait Settings: Sized {
    /// The settings in their order.
    fn described() -> Vec<Setting>;

    /// JSON Schemas of their types in the same order.
    fn types() -> Vec<SchemaOf>;

    /// JSON Schema of an object that [`Settings::of_json`] reads.
    fn schema(generator: &mut SchemaGenerator) -> Schema {
        let mut properties = Stated::new();
        let settings = Self::described();
        for (setting, of_type) in settings.iter().zip(Self::types()) {
            let mut schema = of_type(generator);
            schema.insert("description".to_owned(), setting.about.into());
            if let Some(default) = &setting.default {
                schema.insert("default".to_owned(), default.clone());
            }
            properties.insert(setting.name.to_owned(), schema.to_value());
        }
        let required = settings.iter().filter(|setting| setting.is_required());
        let required: Vec<&str> = required.map(|setting| setting.name).collect();
        json_schema!({
            "type": "object",
            "properties": properties,
            "required": required,
            "additionalProperties": false,
        })
    }

    /// Removes the settings from an object of JSON; a setting that it lacks has its default.
    ///
    /// # Errors
    /// Names a setting that is missing or of another type.
    fn take(stated: &mut Stated) -> Result<Self, Fault>;

    /// The settings if none is stated.
    ///
    /// # Errors
    /// When one must be stated.
    fn usual() -> Result<Self, Fault> {
        Self::take(&mut Stated::new())
    }

    /// Settings from an object of JSON; a setting that it lacks has its default.
    ///
    /// # Errors
    /// Names a setting that is missing, unknown, or of another type.
    fn of_json(stated: Value) -> Result<Self, Fault> {
        let Value::Object(mut stated) = stated else {
            let message = format!("settings: {stated} is not an object");
            return Err(Fault::new(Code::E204, message));
        };
        let settings = Self::take(&mut stated)?;
        match stated.keys().next() {
            None => Ok(settings),
            Some(unknown) => {
                let known: Vec<&str> = Self::described().iter().map(|one| one.name).collect();
                let message = format!("unknown setting `{unknown}`, expected {}", known.join(", "));
                Err(Fault::new(Code::E204, message))
            }
        }
    }
}

/// Removes the setting `name` from an object of JSON and returns its value. Without a value and a default it is `None`, `false` or empty.
///
/// # Errors
/// When it must be stated and is not, or has another type.
pub fn taken<T: DeserializeOwned>(
    stated: &mut Stated,
    name: &str,
    default: Option<Value>,
) -> Result<T, Fault> {
    if let Some(value) = stated.remove(name).or(default) {
        return serde_json::from_value(value).map_err(|error| {
            Fault::new(
                Code::E204,
                format!("{name}: {}", in_plain_words(&error.to_string())),
            )
        });
    }
    let mut absent = [Value::Null, json!(false), json!([])].into_iter();
    absent
        .find_map(|value| serde_json::from_value(value).ok())
        .ok_or_else(|| Fault::new(Code::E204, format!("missing setting `{name}`")))
}

/// The settings of a study, each stated once: `name: type = default`, or `name: type` for one that must be stated, is an
/// `Option`, a `bool` or a `Vec`; words in brackets before the name are further ones of its option. Settings that several
/// studies share come last, `..name: Type`. All are read from JSON, and with the feature `clap` of the crate they are
/// options of a command with the same words.
///
/// ```
/// use asperity_report::{Settings, settings};
/// settings! {
///     /// Settings of specimens.
///     pub struct Specimens {
///         /// Radius of the ball
///         ball_radius: String = "9.5 mm",
///     }
/// }
/// settings! {
///     /// Settings of a fit.
///     pub struct FitSettings {
///         /// Number of terms
///         [value_name = "N"] terms: usize = 3,
///         /// Accept any constants
///         force: bool,
///         ..specimens: Specimens,
///     }
/// }
/// let names: Vec<&str> = FitSettings::described().iter().map(|one| one.name).collect();
/// assert_eq!(names, ["terms", "force", "ball_radius"]);
/// let settings = FitSettings::of_json(serde_json::json!({ "ball_radius": "4 mm" }))?;
/// assert_eq!((settings.terms, settings.force, &*settings.specimens.ball_radius), (3, false, "4 mm"));
/// assert!(FitSettings::of_json(serde_json::json!({ "term": 4 })).is_err());
/// # Ok::<(), asperity_core::Fault>(())
/// ```
#[macro_export]
macro_rules! settings {
    ($(#[$about:meta])+ $visibility:vis struct $type:ident {
        $($(#[doc = $doc:literal])+ $([$($words:tt)+])? $name:ident: $kind:ty $(= $default:literal)?,)*
        $(..$part:ident: $parts:ty,)*
    }) => {
        $(#[$about])+
        #[derive(Debug, Clone, PartialEq)]
        #[cfg_attr(feature = "clap", derive(clap::Args))]
        $visibility struct $type {
            $(
                $(#[doc = $doc])+
                #[cfg_attr(feature = "clap", arg(long $(, default_value = concat!($default))? $(, $($words)+)?))]
                pub $name: $kind,
            )*
            $(
                /// Settings that other studies share.
                #[cfg_attr(feature = "clap", command(flatten))]
                pub $part: $parts,
            )*
        }

        impl $crate::Settings for $type {
            fn described() -> Vec<$crate::Setting> {
                let own: Vec<$crate::Setting> = vec![$($crate::Setting::new(
                    stringify!($name),
                    stringify!($kind),
                    concat!($($doc),+).trim_ascii(),
                    $crate::settings!(@default $($default)?),
                )),*];
                let all = own.into_iter();
                $(let all = all.chain(<$parts as $crate::Settings>::described());)*
                all.collect()
            }

            fn types() -> Vec<$crate::SchemaOf> {
                let own: Vec<$crate::SchemaOf> = vec![$($crate::schema_of::<$kind>),*];
                let all = own.into_iter();
                $(let all = all.chain(<$parts as $crate::Settings>::types());)*
                all.collect()
            }

            fn take(stated: &mut $crate::Stated) -> Result<Self, asperity_core::Fault> {
                let _: &$crate::Stated = stated;
                Ok(Self {
                    $($name: $crate::taken(stated, stringify!($name), $crate::settings!(@default $($default)?))?,)*
                    $($part: <$parts as $crate::Settings>::take(stated)?,)*
                })
            }
        }
    };
    (@default) => { None };
    (@default $default:literal) => { Some(serde_json::json!($default)) };
}
