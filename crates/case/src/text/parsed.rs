//! The text of a case file: its keys with their places, and its values.

use std::ops::Range;
use std::path::Path;

use serde::de::DeserializeOwned;
use toml::de::{DeTable, DeValue};
use toml::{Table, Value};

use super::keyed::from_keys;
use super::symbols::{key_of_symbol, key_of_text, moved, name_viscosity_law};
use crate::source::case_error::CaseError;
use crate::source::source_text::{Source, is_within};
use asperity_core::Place;

impl Source {
    /// Indexes `text`; JSON when the name ends in `.json`, TOML otherwise.
    ///
    /// # Errors
    /// When the text is not TOML (or JSON), with the place.
    pub fn new(name: &str, text: &str) -> Result<Self, CaseError> {
        let mut source = Self::without_text(name);
        text.clone_into(&mut source.text);
        source.is_json = source.has_ending("json");
        if source.is_json {
            let value: serde_json::Value = serde_json::from_str(text).map_err(|error| {
                CaseError::syntax(
                    source.at_line(error.line()),
                    without_place(&error.to_string()),
                )
            })?;
            source.index_json("", &value);
        } else {
            let table = DeTable::parse(text).map_err(|error| CaseError::syntax(source.at_span(error.span()), match text.trim_start().starts_with('{') {
                    true => format!("{} (JSON goes into a file named .json)", error.message()),
                    false if source.has_ending("toml") => error.message().to_owned(),
                    false => format!(
                        "{} (a case is a .toml or .json file; it names a trace as file of surface.pinion or surface.wheel)",
                        error.message()
                    ),
                }))?;
            source.index_toml("", table.get_ref());
        }
        Ok(source)
    }

    /// Indexes the text of a file; a byte-order mark is removed.
    ///
    /// # Errors
    /// When the bytes are not UTF-8, or the text is not TOML (or JSON), with the place.
    pub fn from_bytes(name: &str, bytes: &[u8]) -> Result<Self, CaseError> {
        match std::str::from_utf8(bytes) {
            Ok(text) => Self::new(name, text.trim_start_matches('\u{feff}')),
            Err(error) => {
                let good = &bytes[..error.valid_up_to()];
                let line = 1 + good.iter().filter(|byte| **byte == b'\n').count();
                Err(CaseError::encoding(Self::without_text(name).at_line(line)))
            }
        }
    }

    fn has_ending(&self, ending: &str) -> bool {
        let own = Path::new(&self.name).extension();
        own.is_some_and(|own| own.eq_ignore_ascii_case(ending))
    }

    /// Records that `key` was set to `value` after the text was read, so that messages name no line for it or the keys
    /// below it.
    pub(crate) fn set(&mut self, key: &str, value: &str) {
        self.changed.insert(key.to_owned());
        self.written.retain(|name, _| !is_within(name, key));
        match value.parse::<Value>() {
            Ok(Value::Table(table)) => self.note_table(key, &table),
            _ => {
                self.written.insert(key.to_owned(), value.to_owned());
            }
        }
    }

    fn note_table(&mut self, path: &str, table: &Table) {
        for (name, value) in table {
            let path = join(path, name);
            match value {
                Value::Table(inner) => self.note_table(&path, inner),
                value => {
                    self.written.insert(path, value.to_string());
                }
            }
        }
    }

    /// Reads the text into a value.
    ///
    /// # Errors
    /// When a value is missing or of the wrong kind, with its place.
    pub fn read<T: DeserializeOwned>(&self) -> Result<T, CaseError> {
        from_table(self.table()?).map_err(|(key, message)| {
            CaseError::value(
                self.place_of(key.as_deref().unwrap_or_default()),
                key.as_deref(),
                message,
            )
        })
    }

    /// The table of the text, with keys for symbols; a null of JSON counts as a missing key.
    ///
    /// # Errors
    /// When the text is not a table of TOML or JSON, with the place.
    pub fn table(&self) -> Result<Table, CaseError> {
        let mut table = self.as_written()?;
        for [written, key] in &self.symbols {
            moved(&mut table, written, key);
        }
        Ok(table)
    }

    fn as_written(&self) -> Result<Table, CaseError> {
        let (place, message) = if self.is_json {
            match serde_json::from_str(&self.text).map(stated) {
                Ok(Some(Value::Table(table))) => return Ok(table),
                Ok(_) => (self.at_line(1), "a case is a JSON object".to_owned()),
                Err(error) => {
                    let message = without_place(&error.to_string());
                    (self.at_line(error.line()), message)
                }
            }
        } else {
            match toml::from_str(&self.text) {
                Ok(table) => return Ok(table),
                Err(error) => (self.at_span(error.span()), error.message().to_owned()),
            }
        };
        Err(CaseError::value(place, None, message))
    }

    fn at_line(&self, line: usize) -> Place {
        Place {
            file: self.name.clone(),
            key: None,
            line: (line > 0).then_some(line),
            column: None,
            span: None,
            mesh: None,
        }
    }

    fn index_json(&mut self, path: &str, value: &serde_json::Value) {
        let serde_json::Value::Object(fields) = value else {
            self.written.insert(path.to_owned(), value.to_string());
            return;
        };
        for (name, field) in keys_first(path, fields.iter(), |name| name) {
            let span = self.only_place_of(name);
            let text = field.is_string().then_some(&span);
            let path = self.key_of(path, name, text, field.is_object());
            self.keys.insert(path.clone(), span.clone());
            self.values.insert(path.clone(), span);
            self.index_json(&path, field);
        }
    }

    /// Place of a JSON key that occurs once; an empty range otherwise, since the parser does not report places.
    fn only_place_of(&self, name: &str) -> Range<usize> {
        let quoted = serde_json::Value::from(name).to_string();
        let mut places = self.text.match_indices(&quoted).filter(|(at, name)| {
            let after = self.text[at + name.len()..].trim_start();
            after.starts_with(':')
        });
        match (places.next(), places.next()) {
            (Some((at, name)), None) => at..at + name.len(),
            _ => 0..0,
        }
    }

    /// The path of the key that `name` in the table `above` is read as; `text` is the place of the name of a text.
    fn key_of(
        &mut self,
        above: &str,
        name: &str,
        text: Option<&Range<usize>>,
        is_table: bool,
    ) -> String {
        let written = join(above, name);
        let symbol = if is_table && written == "oil" {
            Some("lubricant".to_owned())
        } else {
            key_of_symbol(above, name)
        };
        let key = match text.and_then(|span| Some((span, key_of_text(&written)?))) {
            Some((span, key)) => {
                self.keys.insert(written.clone(), span.clone());
                Some(key)
            }
            None => symbol,
        };
        match key.filter(|key| !self.keys.contains_key(key)) {
            Some(key) => {
                self.symbols.push([written, key.clone()]);
                key
            }
            None => written,
        }
    }

    fn index_toml(&mut self, path: &str, table: &DeTable<'_>) {
        for (name, value) in keys_first(path, table.iter(), |name| name.get_ref()) {
            let is_text = matches!(value.get_ref(), DeValue::String(_));
            let is_table = matches!(value.get_ref(), DeValue::Table(_));
            let text = is_text.then_some(name.span());
            let path = self.key_of(path, name.get_ref(), text.as_ref(), is_table);
            self.keys.insert(path.clone(), name.span());
            self.values.insert(path.clone(), value.span());
            if let DeValue::Table(inner) = value.get_ref() {
                self.index_toml(&path, inner);
            } else if let Some(text) = self.text.get(value.span()) {
                self.written.insert(path, text.to_owned());
            }
        }
    }
}

/// The entries of the table at `path`, those that are not symbols first.
fn keys_first<'a, K: 'a, V: 'a>(
    path: &str,
    entries: impl Iterator<Item = (&'a K, &'a V)>,
    name: impl Fn(&K) -> &str,
) -> Vec<(&'a K, &'a V)> {
    let (symbols, mut keys): (Vec<_>, Vec<_>) =
        entries.partition(|(key, _)| key_of_symbol(path, name(key)).is_some());
    keys.extend(symbols);
    keys
}

fn join(path: &str, name: &str) -> String {
    if path.is_empty() {
        name.to_owned()
    } else {
        format!("{path}.{name}")
    }
}

/// A JSON value without its nulls; `None` for a null.
pub(crate) fn stated(value: serde_json::Value) -> Option<Value> {
    use serde_json::Value as Json;
    Some(match value {
        Json::Null => return None,
        Json::Bool(truth) => Value::Boolean(truth),
        Json::Number(number) => match number.as_i64() {
            Some(integer) => Value::Integer(integer),
            None => Value::Float(number.as_f64()?),
        },
        Json::String(text) => Value::String(text),
        Json::Array(values) => Value::Array(values.into_iter().filter_map(stated).collect()),
        Json::Object(fields) => {
            let fields = fields.into_iter();
            Value::Table(
                fields
                    .filter_map(|(key, value)| Some((key, stated(value)?)))
                    .collect(),
            )
        }
    })
}

/// Reads a value from a table of its keys; the key and the message of what cannot be read. All formats are read through
/// it, because the code that reads every key is large and is compiled again for every format.
pub(crate) fn from_table<T: DeserializeOwned>(
    mut root: Table,
) -> Result<T, (Option<String>, String)> {
    name_viscosity_law(&mut root);
    from_keys(root)
}

/// The message of the JSON parser without the place at its end.
fn without_place(message: &str) -> String {
    match message.rfind(" at line ") {
        Some(end) => message[..end].to_owned(),
        None => message.to_owned(),
    }
}
