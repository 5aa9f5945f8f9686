//! Results and inputs of a study in words, with their units.

use asperity::result::loss_band::{Digits, rounded};
use asperity_core::Estimate;
use asperity_report::{Cell, Table, columns};

use super::columns::InputValues;
use super::effects::Effect;
use super::merged::Merged;

/// A result in words.
pub(super) struct Output {
    pub(super) name: String,
    pub(super) unit: &'static str,
    /// Factor from the column of the table to the unit.
    pub(super) factor: f64,
}

/// Endings of columns with their units.
const UNITS: [(&str, &str); 5] = [
    ("_w", "W"),
    ("_nm", "N m"),
    ("_um", "µm"),
    ("_mpa", "MPa"),
    ("_c", "°C"),
];

impl Output {
    /// The result in the column `name`.
    pub(super) fn from_name(name: &str) -> Self {
        if let Some((mesh, column)) = name
            .strip_prefix("mesh.")
            .and_then(|rest| rest.rsplit_once('.'))
        {
            let of_mesh = Self::from_name(column);
            return Self {
                name: format!("{} of {mesh}", of_mesh.name),
                ..of_mesh
            };
        }
        let is_share = name.ends_with("share") || name.ends_with("efficiency");
        let unit = UNITS.into_iter().find(|(ending, _)| name.ends_with(ending));
        let (stem, unit, factor) = match (is_share, unit) {
            (true, _) => (name, "%", 100.0),
            (false, Some((ending, unit))) => (name.trim_end_matches(ending), unit, 1.0),
            _ => (name, "", 1.0),
        };
        let name = match stem {
            "mu_equivalent" => "equivalent friction".to_owned(),
            "mixed_share" => "mixed lubrication".to_owned(),
            stem if unit == "W" && stem != "loss" && !stem.ends_with("_loss") => {
                format!("{} loss", stem.replace('_', " "))
            }
            stem => stem.replace('_', " "),
        };
        Self { name, unit, factor }
    }

    /// A value of the column with four digits and the unit.
    pub(super) fn text(&self, value: f64) -> String {
        let value = self.factor * value;
        let digits = if value == 0.0 {
            0
        } else {
            (3 - value.abs().log10().floor() as i32).clamp(0, 6) as usize
        };
        format!("{value:.digits$} {}", self.unit)
            .trim_end()
            .to_owned()
    }

    /// A value in the unit with its interval.
    pub(super) fn interval(&self, drawn: Estimate) -> String {
        let unit = format!(" {}", self.unit);
        Digits::of_interval(drawn.ends()).interval_with(&unit, drawn)
    }

    /// A change with its interval, the digits that this leaves, and the unit.
    pub(super) fn change(&self, effect: &Effect) -> String {
        let change = effect.difference.map(|change| self.factor * change);
        let half = change.half_width().max(0.01 * change.value.abs());
        let text = Digits::of_uncertainty(half).signed_interval(change);
        format!("{text} {}", self.unit).trim_end().to_owned()
    }
}

/// Table of the effects.
pub(super) const EFFECTS: &str = "effects.csv";

/// The effects of the inputs by the regression.
pub(super) fn table(merged: &Merged) -> Table {
    let effects = merged.effects.iter();
    let rows = effects.map(|row| (row, Output::from_name(&row.output), row.effect.as_ref()));
    let table = columns! { (row, output, effect) in rows;
        text output "result" "" = Cell::shown(output.name.clone(), row.output.as_str().into());
        shown words "input" "" = input_name(&row.input);
        code input "key" "" = &row.input;
        shown between "between" "" = effect
            .and_then(|effect| between(merged, &row.input, effect))
            .map_or("-".to_owned(), |ends| ends.join(" and "));
        file input_low = Cell::optional(effect.and_then(|effect| effect.between).map(|of| of[0]));
        file input_high = Cell::optional(effect.and_then(|effect| effect.between).map(|of| of[1]));
        file low = Cell::optional(effect.map(|effect| effect.low));
        file high = Cell::optional(effect.map(|effect| effect.high));
        interval difference "change" "" = Cell::estimate(
            effect.map_or("-".to_owned(), |effect| output.change(effect)),
            effect.map(|effect| effect.difference),
        );
        number correlation "correlation" "" "{:+.2}" = effect.map(|effect| effect.correlation);
    };
    let digits = Digits::of_decimals(2);
    let index = |of: Option<Estimate>| {
        Cell::optional(of.map(|of| Cell::shown(digits.interval(of), of.value.into())))
    };
    let indices = columns! { row in &merged.effects;
        number first "first index" "" = index(row.indices.map(|of| of.first));
        file first_low = Cell::optional(row.indices.map(|of| of.first.low));
        file first_high = Cell::optional(row.indices.map(|of| of.first.high));
        number total "total index" "" = index(row.indices.map(|of| of.total));
        file total_low = Cell::optional(row.indices.map(|of| of.total.low));
        file total_high = Cell::optional(row.indices.map(|of| of.total.high));
    };
    let indices = if merged.effects.iter().any(|row| row.indices.is_some()) {
        indices
    } else {
        indices.unshown_of(&["first index", "total index"])
    };
    table
        .with(indices)
        .brief(&["input", "between"])
        .in_file(EFFECTS)
}

/// The values of an input between which a result changes, the second with their unit; `None` of a choice.
pub(super) fn between(merged: &Merged, input: &str, effect: &Effect) -> Option<[String; 2]> {
    let ends = effect.between?;
    let column = merged.inputs.iter().find(|column| column.name == input);
    let unit = match column.map(|column| &column.values) {
        Some(InputValues::Numbers { unit, .. }) => unit,
        _ => "",
    };
    let largest = ends[0].abs().max(ends[1].abs());
    let [low, high] = ends.map(|end| rounded(end, 0.01 * largest));
    Some([low, format!("{high} {unit}").trim_end().to_owned()])
}

/// An input in words: the parts of its key after the table, indices of lists as the gears.
pub(super) fn input_name(key: &str) -> String {
    let (key, choice) = match key.split_once(": ") {
        Some((key, choice)) => (key, format!(": {choice}")),
        None => (key, String::new()),
    };
    let parts: Vec<&str> = key.split('.').collect();
    let own = match parts.len() {
        1 => &parts[..],
        _ => &parts[1..],
    };
    let words = own.iter().map(|part| match *part {
        "0" => "of the pinion".to_owned(),
        "1" => "of the wheel".to_owned(),
        "at_40" => "at 40 °C".to_owned(),
        "at_100" => "at 100 °C".to_owned(),
        part => part.replace('_', " "),
    });
    words.collect::<Vec<_>>().join(" ") + &choice
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_and_keys_are_named_in_words() {
        let named = |column: &str| {
            let output = Output::from_name(column);
            (output.name, output.unit)
        };
        assert_eq!(named("loss_w"), ("loss".to_owned(), "W"));
        assert_eq!(named("sliding_w"), ("sliding loss".to_owned(), "W"));
        assert_eq!(named("efficiency"), ("efficiency".to_owned(), "%"));
        assert_eq!(
            named("mesh.first.loss_w"),
            ("loss of first".to_owned(), "W")
        );
        assert_eq!(
            named("mu_equivalent"),
            ("equivalent friction".to_owned(), "")
        );
        for (key, words) in [
            ("operation.torque", "torque"),
            ("gears.profile_shift.0", "profile shift of the pinion"),
            ("lubricant.viscosity.at_100", "viscosity at 100 °C"),
            ("finish: smooth", "finish: smooth"),
        ] {
            assert_eq!(input_name(key), words);
        }
        let effect = Effect {
            low: 0.0,
            high: 0.0,
            between: None,
            difference: Estimate::new(-130.4, [-141.0, -120.0]),
            correlation: 0.0,
        };
        assert_eq!(
            Output::from_name("loss_w").change(&effect),
            "-130 (-141..-120) W"
        );
    }
}
