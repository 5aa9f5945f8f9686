//! A value with its interval.

use serde::de::{Error, MapAccess, Visitor};
use serde::ser::SerializeStruct;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::marker::PhantomData;

/// A value with the ends of its interval. Who holds it states the unit and the probability of the ends, 95 % in all inputs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Estimate<T = f64> {
    /// The value.
    pub value: T,
    /// Lower end of its interval.
    #[cfg_attr(
        feature = "schema",
        schemars(description = "Lower end of the 95 % interval.")
    )]
    pub low: T,
    /// Upper end of its interval.
    #[cfg_attr(
        feature = "schema",
        schemars(description = "Upper end of the 95 % interval.")
    )]
    pub high: T,
}

impl<T> Estimate<T> {
    /// A value with the lower and the upper end of its interval.
    pub fn new(value: T, [low, high]: [T; 2]) -> Self {
        Self { value, low, high }
    }

    /// The same of a monotonic function of the value.
    ///
    /// ```
    /// use asperity_core::Estimate;
    /// let loss = Estimate::new(5.0, [4.0, 8.0]);
    /// assert_eq!(loss.map(|loss| 100.0 - loss), Estimate::new(95.0, [92.0, 96.0]));
    /// ```
    #[must_use]
    pub fn map<U: PartialOrd>(self, function: impl Fn(T) -> U) -> Estimate<U> {
        let [value, low, high] = [self.value, self.low, self.high].map(function);
        if low > high {
            Estimate::new(value, [high, low])
        } else {
            Estimate::new(value, [low, high])
        }
    }

    /// Lower and upper end.
    pub fn ends(self) -> [T; 2] {
        [self.low, self.high]
    }
}

impl Estimate {
    /// Half the width of the interval.
    #[must_use]
    pub fn half_width(self) -> f64 {
        0.5 * (self.high - self.low)
    }

    /// Width of the interval of the logarithm.
    #[must_use]
    pub fn log_width(self) -> f64 {
        (self.high / self.low).ln()
    }

    /// Whether `value` lies in the interval, its ends included.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }
}

/// Keys under which an estimate lies among the fields of another object: `#[serde(flatten, with = "…")]` of an [`Estimate`], or
/// of an `Option` of one, which is written as null under both keys if it is missing.
///
/// ```
/// use asperity_core::{Estimate, EstimateKeys, estimate_keys};
/// # use serde::{Deserialize, Serialize};
/// estimate_keys! { Watts: "median_w" "quantiles_w"; }
/// #[derive(Serialize, Deserialize)]
/// struct Drawn {
///     #[serde(flatten, with = "Watts")]
///     loss: Estimate,
///     draws: usize,
/// }
/// let text = r#"{"median_w":5.0,"quantiles_w":[4.0,8.0],"draws":100}"#;
/// let drawn: Drawn = serde_json::from_str(text)?;
/// assert_eq!(drawn.loss, Estimate::new(5.0, [4.0, 8.0]));
/// assert_eq!(serde_json::to_string(&drawn)?, text);
/// # Ok::<(), serde_json::Error>(())
/// ```
pub trait EstimateKeys {
    /// Key of the value, and of the pair of ends.
    const KEYS: &'static [&'static str; 2];

    /// Writes both keys.
    ///
    /// # Errors
    /// As the serializer.
    fn serialize<S: Serializer>(
        estimate: &(impl Copy + Into<Option<Estimate>>),
        to: S,
    ) -> Result<S::Ok, S::Error> {
        let estimate = (*estimate).into();
        let [value, ends] = *Self::KEYS;
        let mut object = to.serialize_struct("Estimate", Self::KEYS.len())?;
        object.serialize_field(value, &estimate.map(|of| of.value))?;
        object.serialize_field(ends, &estimate.map(Estimate::ends))?;
        object.end()
    }

    /// Reads both keys.
    ///
    /// # Errors
    /// When one of the keys is missing.
    fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Estimate, D::Error> {
        let visitor = OfKeys(PhantomData::<Self>);
        from.deserialize_struct("Estimate", Self::KEYS, visitor)
    }
}

/// Declares [`EstimateKeys`]: the name of each pair, the key of the value and the key of the ends.
#[macro_export]
macro_rules! estimate_keys {
    ($($(#[$doc:meta])* $vis:vis $name:ident: $value:literal $ends:literal;)+) => {$(
        $(#[$doc])*
        #[derive(Debug)]
        $vis enum $name {}

        impl $crate::EstimateKeys for $name {
            const KEYS: &'static [&'static str; 2] = &[$value, $ends];
        }
    )+};
}

struct OfKeys<K: ?Sized>(PhantomData<K>);

impl<'de, K: EstimateKeys + ?Sized> Visitor<'de> for OfKeys<K> {
    type Value = Estimate;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [value, ends] = K::KEYS;
        write!(f, "{value} and {ends}")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut object: A) -> Result<Estimate, A::Error> {
        let [of_value, of_ends] = *K::KEYS;
        let (mut value, mut ends) = (None, None);
        while let Some(key) = object.next_key::<String>()? {
            // A flat object gives no other keys.
            if key == of_value {
                value = Some(object.next_value()?)
            } else {
                ends = Some(object.next_value()?)
            }
        }
        Ok(Estimate::new(
            value.ok_or_else(|| A::Error::missing_field(of_value))?,
            ends.ok_or_else(|| A::Error::missing_field(of_ends))?,
        ))
    }
}
