//! Variants of a case: other values of its keys, or other cases.

use std::path::PathBuf;
use std::str::FromStr;

use asperity::case::CaseInput;
use asperity::case::train::Train;
use asperity_core::{Code, Fault};
use toml::Value;

use super::comparison::Finish;
use crate::sweep::{Keys, set_keys, written};

/// Name of the case itself among its variants.
pub const AS_IS: &str = "as is";
/// Ways to write a variant.
const FORMS: &str = "Write \"NAME: KEY=VALUE, KEY=VALUE\", \"NAME: FILE\" with a file of keys, NAME=CASE.toml, or \"as is\" for the case itself.";

/// Variant as written: `NAME: KEY=VALUE, ...`, `NAME: FILE`, `NAME=CASE.toml`, or `as is`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedVariant {
    /// Name.
    pub name: String,
    /// Its keys, or its case.
    pub is: WrittenVariant,
}

/// Keys or case of a variant, as written.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum WrittenVariant {
    /// The case itself.
    AsIs,
    /// Keys with their values, and files of such keys.
    Keys(Vec<KeyOrFile>),
    /// Another case, in a file.
    Case(PathBuf),
}

/// Key with its value, or a file of keys.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum KeyOrFile {
    /// A key with its value.
    Key(String, String),
    /// A file of keys, as in a case file.
    File(PathBuf),
}

/// Reads a variant.
///
/// ```
/// use asperity_studies::compare::{KeyOrFile, NamedVariant, WrittenVariant};
/// let of = |text: &str| text.parse::<NamedVariant>();
/// let key = |key: &str, value: &str| KeyOrFile::Key(key.to_owned(), value.to_owned());
/// let keys = vec![key("lubricant.oil", "m100"), key("gears.profile_shift", "[0.1, -0.1]")];
/// let found = of("mineral: lubricant.oil=m100, gears.profile_shift=[0.1, -0.1]")?;
/// assert_eq!((found.name.as_str(), found.is), ("mineral", WrittenVariant::Keys(keys)));
/// assert_eq!(of("new=new.toml")?.is, WrittenVariant::Case("new.toml".into()));
/// assert_eq!(of("as is")?.is, WrittenVariant::AsIs);
/// assert!(of("new").is_err() && of("new:").is_err());
/// # Ok::<(), asperity_core::Fault>(())
/// ```
impl FromStr for NamedVariant {
    type Err = Fault;

    fn from_str(text: &str) -> Result<Self, Fault> {
        let refused =
            |why: &str| Fault::new(Code::E205, format!("variant \"{text}\": {why}")).helping(FORMS);
        let named = |name: &str, is| match name.trim() {
            "" => Err(refused("it has no name")),
            name => Ok(Self {
                name: name.to_owned(),
                is,
            }),
        };
        let end = text.find([':', '=']).unwrap_or(text.len());
        let (name, rest) = text.split_at(end);
        let Some(rest) = rest.strip_prefix(':') else {
            return match rest.strip_prefix('=').map(str::trim) {
                Some("") => Err(refused("it names no case")),
                Some(case) => named(name, WrittenVariant::Case(case.into())),
                None if text.trim() == AS_IS => named(AS_IS, WrittenVariant::AsIs),
                None => Err(refused("it changes nothing of the case")),
            };
        };
        let entries = entries(rest);
        let entries = entries.iter().map(|entry| entry.trim());
        let read = |entry: &str| match entry.split_once('=') {
            Some((key, value)) => KeyOrFile::Key(key.trim().to_owned(), value.trim().to_owned()),
            None => KeyOrFile::File(entry.into()),
        };
        let keys: Vec<KeyOrFile> = entries
            .filter(|entry| !entry.is_empty())
            .map(read)
            .collect();
        if keys.is_empty() {
            Err(refused("it changes nothing of the case"))
        } else {
            named(name, WrittenVariant::Keys(keys))
        }
    }
}

/// Parts between the commas that are in no bracket and no quotation.
fn entries(text: &str) -> Vec<&str> {
    let (mut depth, mut quote, mut begin) = (0_i32, None, 0);
    let mut found = Vec::new();
    for (at, sign) in text.char_indices() {
        match (quote, sign) {
            (Some(open), _) if sign == open => quote = None,
            (Some(_), _) => {}
            (None, '"' | '\'') => quote = Some(sign),
            (None, '[' | '{') => depth += 1,
            (None, ']' | '}') => depth -= 1,
            (None, ',') if depth <= 0 => {
                found.push(&text[begin..at]);
                begin = at + 1;
            }
            _ => {}
        }
    }
    found.push(&text[begin..]);
    found
}

/// The keys in the text of a file of keys, which is written like a case file.
///
/// # Errors
/// When the text is not valid TOML, or has no keys.
pub fn keys_in(text: &str) -> Result<Keys, Fault> {
    fn gather(path: &str, value: &Value, into: &mut Keys) {
        match value {
            // A law and its numbers are one value.
            Value::Table(table) if !table.contains_key("law") => {
                for (name, inner) in table {
                    let path = match path {
                        "" => name.clone(),
                        path => format!("{path}.{name}"),
                    };
                    gather(&path, inner, into);
                }
            }
            value => into.push((path.to_owned(), written(value))),
        }
    }
    let table: toml::Table = text
        .parse()
        .map_err(|error: toml::de::Error| Fault::new(Code::E202, error.message().to_owned()))?;
    let mut keys = Keys::new();
    gather("", &Value::Table(table), &mut keys);
    if keys.is_empty() {
        Err(Fault::new(Code::E205, "the file has no keys").helping(FORMS))
    } else {
        Ok(keys)
    }
}

/// Keys or case of a variant.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub enum Variant {
    /// The case itself.
    AsIs,
    /// The case with other values of these keys.
    Keys(Keys),
    /// Another case.
    Case(Box<Train>),
}

/// The variants of a case behind its finishes. A single variant comes behind the case itself.
///
/// # Errors
/// When two have one name, a key is not known or set twice, a variant changes nothing, or a changed case cannot be run.
pub fn variants(
    base: &Train,
    finishes: Vec<Finish<Train>>,
    mut given: Vec<(String, Variant)>,
) -> Result<Vec<Finish<Train>>, Fault> {
    let mut found = finishes;
    if let ([], [(_, Variant::Keys(_) | Variant::Case(_))]) = (&found[..], &given[..]) {
        given.insert(0, (AS_IS.to_owned(), Variant::AsIs));
    }
    for (name, is) in given {
        if found.iter().any(|known| known.name == name) {
            let message = format!("variant {name}: two variants have this name");
            let help =
                "Rename one, or write all keys of a variant behind its name, separated by commas.";
            return Err(Fault::new(Code::E205, message).helping(help));
        }
        let case = match is {
            Variant::AsIs => base.clone(),
            Variant::Case(case) => *case,
            Variant::Keys(keys) => {
                varied(base, &keys, &[]).map_err(|fault| fault.about(format!("variant {name}")))?
            }
        };
        found.push(Finish { name, case });
    }
    Ok(found)
}

/// The case with the values `keys` and without the keys `unset`. One that names an oil leaves out the oil of the case, and its
/// calibration.
///
/// # Errors
/// When a key is not known or set twice, nothing changes, or the changed case cannot be run.
pub fn varied(base: &Train, keys: &Keys, unset: &[String]) -> Result<Train, Fault> {
    let is_within = |whole: &str, part: &str| {
        part.strip_prefix(whole)
            .is_some_and(|rest| rest.is_empty() || rest.starts_with('.'))
    };
    for (k, (key, _)) in keys.iter().enumerate() {
        let mut before = keys[..k].iter();
        if let Some((other, _)) =
            before.find(|(other, _)| is_within(other, key) || is_within(key, other))
        {
            let message = if other == key {
                format!("{key} is set twice")
            } else {
                format!("{key} and {other} set the same")
            };
            return Err(Fault::new(Code::E205, message).helping("Leave one of them out."));
        }
    }
    let mut input = base.input.clone();
    for key in unset {
        input.unset(key)?;
    }
    set_keys(&mut input, &base.defaults, keys)?;
    if is_same(&input, &base.input) {
        let stated = keys.first();
        let stated = stated.map_or(String::new(), |(key, value)| {
            format!(": the case has {key} = {value} already")
        });
        let message = format!("it changes nothing{stated}");
        let help = "Give it another value, or name the case itself \"as is\".";
        return Err(Fault::new(Code::E205, message).helping(help));
    }
    Ok(base.with_input(input)?)
}

/// Whether two inputs state the same.
fn is_same(a: &CaseInput, b: &CaseInput) -> bool {
    let text = |of: &CaseInput| of.to_toml().ok();
    a == b || text(a).is_some_and(|own| Some(own) == text(b))
}
