//! Results and inputs of a study in words, with their units.

use asperity::result::loss_band::Digits;
use asperity_report::{Cell, Table, columns};

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
    pub(super) fn of(name: &str) -> Self {
        if let Some((mesh, column)) = name
            .strip_prefix("mesh.")
            .and_then(|rest| rest.rsplit_once('.'))
        {
            let of_mesh = Self::of(column);
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
        let digits = match value == 0.0 {
            true => 0,
            false => (3 - value.abs().log10().floor() as i32).clamp(0, 6) as usize,
        };
        format!("{value:.digits$} {}", self.unit)
            .trim_end()
            .to_owned()
    }

    /// A change with its interval, the digits that this leaves, and the unit.
    pub(super) fn change(&self, effect: &Effect) -> String {
        let [low, high] = effect.quantiles.map(|end| self.factor * end);
        let value = self.factor * effect.difference;
        let half = (0.5 * (high - low)).max(0.01 * value.abs());
        let decimals = match half > 0.0 {
            true => -(0.5 * half).log10().floor() as i32,
            false => 0,
        };
        let digits = Digits::of_decimals(decimals);
        let signed = |value: f64| match digits.steps(value) > 0.0 {
            true => format!("+{}", digits.rounded(value)),
            false => digits.rounded(value),
        };
        let text = format!(
            "{} ({}..{}) {}",
            signed(value),
            signed(low),
            signed(high),
            self.unit
        );
        text.trim_end().to_owned()
    }
}

/// The effects of the inputs by the regression.
pub(super) fn table(merged: &Merged) -> Table {
    let effects = merged.effects.iter();
    let rows = effects.filter_map(|row| Some((row, Output::of(&row.output), row.effect?)));
    let table = columns! { (row, output, effect) in rows.clone();
        text output "result" "" = &output.name;
        text input "input" "" = input_name(&row.input);
        code key "key" "" = &row.input;
        number change "change" "" = output.change(&effect);
        number correlation "correlation" "" "{:+.2}" = effect.correlation;
    };
    if rows.clone().all(|(row, ..)| row.indices.is_none()) {
        return table;
    }
    let index = |value: f64, [low, high]: [f64; 2]| format!("{value:.2} ({low:.2}..{high:.2})");
    table.with(columns! { (row, _, _) in rows;
        number first "first index" "" = Cell::optional(row.indices.map(|of| index(of.first, of.first_interval)));
        number total "total index" "" = Cell::optional(row.indices.map(|of| index(of.total, of.total_interval)));
    })
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
            let output = Output::of(column);
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
            ("lubricant.viscosity.at_100", "viscosity at 100"),
            ("finish: smooth", "finish: smooth"),
        ] {
            assert_eq!(input_name(key), words);
        }
        let effect = Effect {
            low: 0.0,
            high: 0.0,
            difference: -130.4,
            quantiles: [-141.0, -120.0],
            correlation: 0.0,
        };
        assert_eq!(Output::of("loss_w").change(&effect), "-130 (-141..-120) W");
    }
}
