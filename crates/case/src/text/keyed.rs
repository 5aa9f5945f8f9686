//! Values from tables of keys, with the key that cannot be read.
//!
//! One layer between values and types: wrappers that track the path in addition to the deserializer of the values are
//! compiled for every type, and were 8 % of the program.

use std::cell::RefCell;

use serde::de::value::{Error, StringDeserializer};
use serde::de::{
    DeserializeOwned, DeserializeSeed, Deserializer, EnumAccess, Error as _, IntoDeserializer,
    MapAccess, SeqAccess, Unexpected, VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;
use toml::{Table, Value, map};

use crate::input::ranges::range_in_pair;

/// Keys from the root to the value that is being read; after an error, to the value that cannot be read.
type TablePath = RefCell<Vec<String>>;

/// Reads a value from a table; the key and the message of what cannot be read. Entries of a list have the key of the
/// list, as in TOML.
pub(crate) fn from_keys<T: DeserializeOwned>(root: Table) -> Result<T, (Option<String>, String)> {
    let path = TablePath::default();
    let keyed = Keyed {
        value: Value::Table(root),
        path: Some(&path),
    };
    T::deserialize(keyed).map_err(|error| {
        let key = path.take().join(".");
        let message = with_usual_unit(&key, error.to_string());
        ((!key.is_empty()).then_some(key), message)
    })
}

/// The message of a number without unit, whose example has the unit that is usual at `key`: Ra is stated in um, a module in mm.
fn with_usual_unit(key: &str, message: String) -> String {
    let usual = || {
        let (number, rest) = message.split_once(" has no unit; ")?;
        let (units, _) = rest.rsplit_once(" (as \"")?;
        let unit = range_in_pair(key)?.unit;
        Some(format!(
            "{number} has no unit; {units} (as \"{number} {unit}\")"
        ))
    };
    usual().unwrap_or(message)
}

/// A value; without a path within a list or a variant.
struct Keyed<'p> {
    value: Value,
    path: Option<&'p TablePath>,
}

impl<'de> Deserializer<'de> for Keyed<'_> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.value {
            Value::String(text) => visitor.visit_string(text),
            Value::Integer(number) => visitor.visit_i64(number),
            Value::Float(number) => visitor.visit_f64(number),
            Value::Boolean(truth) => visitor.visit_bool(truth),
            Value::Datetime(time) => visitor.visit_string(time.to_string()),
            Value::Array(values) => {
                let count = values.len();
                let mut values = values.into_iter();
                let read = visitor.visit_seq(KeyValues(&mut values))?;
                match values.len() {
                    0 => Ok(read),
                    _ => Err(Error::invalid_length(count, &"fewer elements in array")),
                }
            }
            Value::Table(table) => visitor.visit_map(Keys::new(table, self.path)),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        match self.value {
            Value::String(text) => visitor.visit_enum(text.into_deserializer()),
            Value::Table(table) if table.len() == 1 => {
                let mut entries = table.into_iter();
                let entry = entries.next();
                let (name, value) = entry.ok_or_else(|| Error::custom("no variant"))?;
                visitor.visit_enum(KeyVariant { name, value })
            }
            Value::Table(_) => Err(Error::custom("one variant expected")),
            _ => Err(Error::invalid_type(Unexpected::UnitVariant, &"string only")),
        }
    }

    /// A table only: fields of a list have no names, and the code that reads them by place would be compiled for every type.
    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        match self.value {
            Value::Table(table) => visitor.visit_map(Keys::new(table, self.path)),
            value => Err(Error::invalid_type(unexpected(&value), &visitor)),
        }
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf unit unit_struct seq tuple
        tuple_struct map identifier ignored_any
    }
}

/// A value as errors name it.
fn unexpected(value: &Value) -> Unexpected<'_> {
    match value {
        Value::String(text) => Unexpected::Str(text),
        Value::Integer(number) => Unexpected::Signed(*number),
        Value::Float(number) => Unexpected::Float(*number),
        Value::Boolean(truth) => Unexpected::Bool(*truth),
        Value::Datetime(_) => Unexpected::Other("time"),
        Value::Array(_) => Unexpected::Seq,
        Value::Table(_) => Unexpected::Map,
    }
}

/// Entries of a table.
struct Keys<'p> {
    entries: map::IntoIter<String, Value>,
    value: Option<Value>,
    path: Option<&'p TablePath>,
}

impl<'p> Keys<'p> {
    fn new(table: Table, path: Option<&'p TablePath>) -> Self {
        Self {
            entries: table.into_iter(),
            value: None,
            path,
        }
    }
}

impl<'de> MapAccess<'de> for Keys<'_> {
    type Error = Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Error> {
        let Some((key, value)) = self.entries.next() else {
            return Ok(None);
        };
        self.value = Some(value);
        if let Some(path) = self.path {
            path.borrow_mut().push(key.clone());
        }
        let key: StringDeserializer<Error> = key.into_deserializer();
        seed.deserialize(key).map(Some)
    }

    fn next_value_seed<S: DeserializeSeed<'de>>(&mut self, seed: S) -> Result<S::Value, Error> {
        let value = self.value.take();
        let value = value.ok_or_else(|| Error::custom("no value"))?;
        let read = seed.deserialize(Keyed {
            value,
            path: self.path,
        })?;
        if let Some(path) = self.path {
            path.borrow_mut().pop();
        }
        Ok(read)
    }
}

/// Entries of a list.
struct KeyValues<'a>(&'a mut std::vec::IntoIter<Value>);

impl<'de> SeqAccess<'de> for KeyValues<'_> {
    type Error = Error;

    fn next_element_seed<S: DeserializeSeed<'de>>(
        &mut self,
        seed: S,
    ) -> Result<Option<S::Value>, Error> {
        let value = self.0.next();
        value
            .map(|value| seed.deserialize(Keyed { value, path: None }))
            .transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// A variant with its content.
struct KeyVariant {
    name: String,
    value: Value,
}

impl<'de> EnumAccess<'de> for KeyVariant {
    type Error = Error;
    type Variant = Keyed<'static>;

    fn variant_seed<S: DeserializeSeed<'de>>(
        self,
        seed: S,
    ) -> Result<(S::Value, Self::Variant), Error> {
        let name: StringDeserializer<Error> = self.name.into_deserializer();
        let content = Keyed {
            value: self.value,
            path: None,
        };
        Ok((seed.deserialize(name)?, content))
    }
}

impl<'de> VariantAccess<'de> for Keyed<'_> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        match self.value {
            Value::Table(table) if table.is_empty() => Ok(()),
            _ => Err(Error::custom("expected empty table")),
        }
    }

    fn newtype_variant_seed<S: DeserializeSeed<'de>>(self, seed: S) -> Result<S::Value, Error> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'de>>(self, _: usize, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_any(visitor)
    }

    fn struct_variant<V: Visitor<'de>>(
        self,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.deserialize_any(visitor)
    }
}
