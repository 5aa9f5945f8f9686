//! Check that all numbers of a value are finite before it is written.

use serde::ser::{self, Serialize, Serializer};

/// A number that is not finite, with its path in the value.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{path} is {value}, which is not a result")]
pub struct NotFinite {
    /// Path of the number, `summary.loss_w`.
    pub path: String,
    /// The number.
    pub value: f64,
}

/// Checks that every number of `value` is finite.
///
/// # Errors
/// With the first number that is not.
///
/// ```
/// use asperity_storage::check_finite;
/// assert!(check_finite(&[Some(1.0), None]).is_ok());
/// let bad = check_finite(&[("a", 1.0), ("b", f64::NAN)]);
/// assert_eq!(bad.map_err(|number| number.path), Err("[1][1]".to_owned()));
/// ```
pub fn check_finite(value: &dyn erased_serde::Serialize) -> Result<(), NotFinite> {
    match value.serialize(Walk) {
        // A value that cannot be serialised is reported when it is written.
        Ok(()) | Err(Stop::Other) => Ok(()),
        Err(Stop::NotFinite { mut path, value }) => {
            path.reverse();
            let path = path.concat();
            Err(NotFinite {
                path: path.strip_prefix('.').unwrap_or(&path).to_owned(),
                value,
            })
        }
    }
}

#[derive(Debug)]
enum Stop {
    NotFinite { path: Vec<String>, value: f64 },
    Other,
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("stopped")
    }
}

impl std::error::Error for Stop {}

impl ser::Error for Stop {
    fn custom<T: std::fmt::Display>(_: T) -> Self {
        Self::Other
    }
}

impl Stop {
    fn within(self, part: impl FnOnce() -> String) -> Self {
        match self {
            Self::NotFinite { mut path, value } => {
                path.push(part());
                Self::NotFinite { path, value }
            }
            Self::Other => Self::Other,
        }
    }
}

fn finite(value: f64) -> Result<(), Stop> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(Stop::NotFinite {
            path: Vec::new(),
            value,
        })
    }
}

struct Walk;

/// Index of the next element of a sequence, or key of the next entry of a map.
struct NumberParts {
    next: usize,
    key: String,
}

fn parts() -> NumberParts {
    NumberParts {
        next: 0,
        key: String::new(),
    }
}

macro_rules! nothing {
    ($($name:ident: $type:ty),+ $(,)?) => {
        $(fn $name(self, _: $type) -> Result<(), Stop> { Ok(()) })+
    };
}

impl Serializer for Walk {
    type Ok = ();
    type Error = Stop;
    type SerializeSeq = NumberParts;
    type SerializeTuple = NumberParts;
    type SerializeTupleStruct = NumberParts;
    type SerializeTupleVariant = NumberParts;
    type SerializeMap = NumberParts;
    type SerializeStruct = NumberParts;
    type SerializeStructVariant = NumberParts;

    nothing!(
        serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32,
        serialize_i64: i64, serialize_i128: i128, serialize_u8: u8, serialize_u16: u16,
        serialize_u32: u32, serialize_u64: u64, serialize_u128: u128, serialize_char: char,
        serialize_str: &str, serialize_bytes: &[u8], serialize_unit_struct: &'static str,
    );

    fn serialize_f32(self, value: f32) -> Result<(), Stop> {
        finite(value.into())
    }

    fn serialize_f64(self, value: f64) -> Result<(), Stop> {
        finite(value)
    }

    fn serialize_none(self) -> Result<(), Stop> {
        Ok(())
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), Stop> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Result<(), Stop> {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Stop> {
        Ok(())
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), Stop> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Stop> {
        value
            .serialize(self)
            .map_err(|stop| stop.within(|| format!(".{variant}")))
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<NumberParts, Stop> {
        Ok(parts())
    }

    fn serialize_tuple(self, _: usize) -> Result<NumberParts, Stop> {
        Ok(parts())
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<NumberParts, Stop> {
        Ok(parts())
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<NumberParts, Stop> {
        Ok(parts())
    }

    fn serialize_map(self, _: Option<usize>) -> Result<NumberParts, Stop> {
        Ok(parts())
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<NumberParts, Stop> {
        Ok(parts())
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        _: &'static str,
        _: usize,
    ) -> Result<NumberParts, Stop> {
        Ok(parts())
    }
}

impl NumberParts {
    fn element<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Stop> {
        let index = self.next;
        self.next += 1;
        value
            .serialize(Walk)
            .map_err(|stop| stop.within(|| format!("[{index}]")))
    }

    fn field<T: Serialize + ?Sized>(&mut self, key: &str, value: &T) -> Result<(), Stop> {
        value
            .serialize(Walk)
            .map_err(|stop| stop.within(|| format!(".{key}")))
    }
}

macro_rules! sequences {
    ($($trait:ident $method:ident),+ $(,)?) => {$(
        impl ser::$trait for NumberParts {
            type Ok = ();
            type Error = Stop;

            fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Stop> {
                self.element(value)
            }

            fn end(self) -> Result<(), Stop> {
                Ok(())
            }
        }
    )+};
}

sequences!(
    SerializeSeq serialize_element,
    SerializeTuple serialize_element,
    SerializeTupleStruct serialize_field,
    SerializeTupleVariant serialize_field,
);

macro_rules! structures {
    ($($trait:ident),+) => {$(
        impl ser::$trait for NumberParts {
            type Ok = ();
            type Error = Stop;

            fn serialize_field<T: Serialize + ?Sized>(
                &mut self,
                key: &'static str,
                value: &T,
            ) -> Result<(), Stop> {
                self.field(key, value)
            }

            fn end(self) -> Result<(), Stop> {
                Ok(())
            }
        }
    )+};
}

structures!(SerializeStruct, SerializeStructVariant);

impl ser::SerializeMap for NumberParts {
    type Ok = ();
    type Error = Stop;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Stop> {
        let text = serde_json::to_value(key).ok();
        let text = text.and_then(|key| key.as_str().map(str::to_owned));
        self.key = text.unwrap_or_else(|| "?".to_owned());
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Stop> {
        let key = std::mem::take(&mut self.key);
        self.field(&key, value)
    }

    fn end(self) -> Result<(), Stop> {
        Ok(())
    }
}
