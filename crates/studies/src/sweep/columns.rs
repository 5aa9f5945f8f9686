//! The inputs of a merged study, column by column: numbers with one unit, or choices.

use asperity_core::unique;
use toml::Value;

use super::amount::Amount;
use super::effects::Regressor;

/// An input of a study with its values in every case.
#[derive(Debug, Clone, PartialEq)]
pub struct InputColumn {
    /// Key or name of the input.
    pub name: String,
    /// Its values.
    pub values: InputValues,
}

/// Values of an input in every case.
#[derive(Debug, Clone, PartialEq)]
pub enum InputValues {
    /// Numbers, with their unit, and as they were written.
    Numbers {
        /// The unit; empty for a number without one.
        unit: String,
        /// The numbers.
        values: Vec<f64>,
        /// The same as text.
        texts: Vec<String>,
    },
    /// Names.
    Choices(Vec<String>),
}

impl InputColumn {
    /// The column of these cells: numbers if all are numbers of the same unit.
    pub(super) fn new(name: String, cells: Vec<String>) -> Self {
        let amounts: Vec<Amount> = cells
            .iter()
            .map_while(|cell| Amount::read(&name, &Value::String(cell.clone())).ok())
            .collect();
        let unit = amounts.first().map(|first| first.unit.clone());
        let values = match unit {
            Some(unit)
                if amounts.len() == cells.len()
                    && amounts.iter().all(|amount| amount.unit == unit) =>
            {
                let text = |cell: &String| cell.trim_end_matches(unit.as_str()).trim().to_owned();
                InputValues::Numbers {
                    values: amounts.iter().map(|amount| amount.value).collect(),
                    texts: cells.iter().map(text).collect(),
                    unit,
                }
            }
            _ => InputValues::Choices(cells),
        };
        Self { name, values }
    }

    /// Header of the column, with the unit in brackets.
    pub(super) fn header(&self) -> String {
        match &self.values {
            InputValues::Numbers { unit, .. } if !unit.is_empty() => {
                format!("{} [{unit}]", self.name)
            }
            _ => self.name.clone(),
        }
    }

    /// Cells of the column, numbers without their unit.
    pub(super) fn cells(&self) -> &[String] {
        match &self.values {
            InputValues::Numbers { texts, .. } => texts,
            InputValues::Choices(names) => names,
        }
    }

    /// The input in a regression over the cases `at`: a number, or each choice but the first.
    pub(super) fn regressors(&self, at: &[usize]) -> Vec<Regressor> {
        match &self.values {
            InputValues::Numbers { values, .. } => vec![Regressor {
                name: self.name.clone(),
                values: at.iter().map(|k| values[*k]).collect(),
                is_choice: false,
            }],
            InputValues::Choices(names) => {
                let of = |choice: &String| Regressor {
                    name: format!("{}: {choice}", self.name),
                    values: at
                        .iter()
                        .map(|k| f64::from(u8::from(names[*k] == *choice)))
                        .collect(),
                    is_choice: true,
                };
                unique(names).into_iter().skip(1).map(of).collect()
            }
        }
    }
}
