//! Keys of a case that a study sets.

use asperity::case::{CaseInput, DefaultUsed};
use asperity_core::Code;
use toml::Value;

use super::error::SweepError;

/// Keys with their values.
pub type Settings = Vec<(String, String)>;

/// Keys that name an oil, and so replace the whole oil of the case.
pub(super) const OILS: [&str; 2] = ["lubricant.oil", "lubricant.oil_file"];

/// Sets keys of `input`; an oil replaces the oil of the case.
pub(crate) fn set_all(
    input: &mut CaseInput,
    defaults: &[DefaultUsed],
    settings: &[(String, String)],
) -> Result<(), SweepError> {
    input.make_way_for(settings.iter().map(|(key, _)| key.as_str()));
    settings
        .iter()
        .try_for_each(|(key, value)| set(input, defaults, key, value))
}

/// Sets a key of the case. A number at its end is an index in a list of the case or its defaults, as in
/// `gears.profile_shift.0`.
pub(super) fn set(
    input: &mut CaseInput,
    defaults: &[DefaultUsed],
    key: &str,
    value: &str,
) -> Result<(), SweepError> {
    let of_list = key
        .rsplit_once('.')
        .and_then(|(list, index)| Some((list, index.parse::<usize>().ok()?)));
    let Some((list, index)) = of_list else {
        return Ok(input.set(key, value)?);
    };
    let as_text = |error: &dyn std::fmt::Display| SweepError::key(key, error.to_string());
    let root = Value::try_from(&*input).map_err(|error| as_text(&error))?;
    let found = list
        .split('.')
        .try_fold(&root, |table, part| table.get(part));
    let by_default = || {
        let default = defaults.iter().find(|default| default.key == list)?;
        let values: Vec<f64> = serde_json::from_str(&default.value).ok()?;
        Some(values.into_iter().map(Value::Float).collect())
    };
    let given = match found {
        Some(Value::Array(values)) => Some(values.clone()),
        _ => by_default(),
    };
    let Some(mut values) = given else {
        return Err(match input.clone().set(list, value) {
            Err(error) if error.code() == Code::E203 => error.into(),
            _ => SweepError::key(key, "is not a list of the case"),
        });
    };
    let Some(entry) = values.get_mut(index) else {
        return Err(SweepError::key(key, "is beyond the end of the list"));
    };
    *entry = match (entry.is_str(), value.parse::<f64>()) {
        (false, Ok(number)) => Value::Float(number),
        _ => Value::String(value.to_owned()),
    };
    Ok(input.set(list, &Value::Array(values).to_string())?)
}

#[cfg(test)]
mod tests {
    use asperity::case::load;

    use super::*;

    #[test]
    fn an_oil_leaves_out_the_numbers_of_the_oil_of_the_case() {
        let file = std::path::Path::new("../../fixtures/cases/e-drive.toml");
        let mut input = load(file, None).unwrap().case.input.clone();
        let setting = |key: &str, value: &str| (key.to_owned(), value.to_owned());
        let own = [setting("lubricant.pressure_viscosity_factor", "0.94")];
        set_all(&mut input, &[], &own).unwrap();
        assert!(input.lubricant.pressure_viscosity_factor.is_some());
        set_all(&mut input, &[], &[setting("lubricant.oil", "m100")]).unwrap();
        assert!(input.lubricant.pressure_viscosity_factor.is_none());
    }
}
