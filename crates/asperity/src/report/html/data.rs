//! A result folder as the page reads it: `result.json` and the tables beside it.

use std::path::{Path, PathBuf};

use asperity_core::quantity::Length;
use serde_json::Value;

use crate::report::ReportError;

/// A result folder.
#[derive(Debug)]
pub(crate) struct ResultFolder {
    pub folder: PathBuf,
    pub json: Value,
}

impl ResultFolder {
    /// Opens a result by its folder or by its `result.json`.
    pub fn open(path: &Path) -> Result<Self, ReportError> {
        let file = if path.is_dir() {
            path.join("result.json")
        } else {
            path.to_owned()
        };
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        let refused = |reason| {
            Err(ReportError::NotAResult {
                path: file.clone(),
                reason,
            })
        };
        let Ok(text) = std::fs::read_to_string(&file) else {
            return refused("there is no such file");
        };
        let Ok(json) = serde_json::from_str::<Value>(&text) else {
            return refused("it is not JSON");
        };
        if json.pointer("/summary/efficiency").is_none() {
            return refused("it has no summary");
        }
        Ok(Self { folder, json })
    }

    /// The number at a JSON pointer.
    pub fn number(&self, pointer: &str) -> Option<f64> {
        self.json.pointer(pointer)?.as_f64()
    }

    /// The text at a JSON pointer.
    pub fn text(&self, pointer: &str) -> &str {
        self.json
            .pointer(pointer)
            .and_then(Value::as_str)
            .unwrap_or_default()
    }

    /// The rows at a JSON pointer.
    pub fn rows(&self, pointer: &str) -> &[Value] {
        self.json
            .pointer(pointer)
            .and_then(Value::as_array)
            .map_or(&[], Vec::as_slice)
    }

    /// The length at a JSON pointer [m].
    pub fn length(&self, pointer: &str) -> Option<f64> {
        self.text(pointer).parse::<Length>().ok().map(Length::si)
    }

    /// A choice of the model: as the case says, or its default.
    pub fn choice(&self, key: &str) -> Option<Value> {
        let given = self
            .json
            .pointer(&format!("/inputs/{}", key.replace('.', "/")));
        if let Some(value) = given.filter(|value| !value.is_null()) {
            return Some(value.clone());
        }
        let default = self
            .rows("/defaults")
            .iter()
            .find(|entry| entry["key"] == key)?;
        serde_json::from_str(default["value"].as_str()?).ok()
    }

    /// A table of the folder; none when it is not there.
    pub fn table(&self, name: &str) -> Result<Option<Table>, ReportError> {
        let file = self.folder.join(name);
        if !file.is_file() {
            return Ok(None);
        }
        Table::read(&file).map(Some)
    }
}

/// Columns of numbers; what is not a number is missing.
#[derive(Debug)]
pub(crate) struct Table {
    names: Vec<String>,
    columns: Vec<Vec<f64>>,
}

impl Table {
    fn read(file: &Path) -> Result<Self, ReportError> {
        let failed = |source| ReportError::Csv {
            path: file.to_owned(),
            source,
        };
        let mut reader = csv::Reader::from_path(file).map_err(failed)?;
        let names: Vec<String> = reader
            .headers()
            .map_err(failed)?
            .iter()
            .map(str::to_owned)
            .collect();
        let mut columns = vec![Vec::new(); names.len()];
        let mut record = csv::StringRecord::new();
        while reader.read_record(&mut record).map_err(failed)? {
            for (column, field) in columns.iter_mut().zip(record.iter()) {
                column.push(field.parse().unwrap_or(f64::NAN));
            }
        }
        Ok(Self { names, columns })
    }

    /// A column by its name; empty when there is none, so that its curve is not drawn.
    pub fn column(&self, name: &str) -> &[f64] {
        let place = self.names.iter().position(|known| known == name);
        place.map_or(&[], |place| self.columns[place].as_slice())
    }

    /// The rows in which `column` is `value`, of another column.
    pub fn where_equal(&self, column: &str, value: f64, wanted: &str) -> Vec<f64> {
        let pairs = self.column(column).iter().zip(self.column(wanted));
        pairs
            .filter(|(key, _)| **key == value)
            .map(|(_, v)| *v)
            .collect()
    }
}

/// Element-wise combination of two columns.
pub(crate) fn combined(a: &[f64], b: &[f64], with: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| with(*a, *b)).collect()
}
