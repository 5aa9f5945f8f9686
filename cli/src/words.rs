//! Remedies and explanations of the libraries in terms of the command line: settings by their options. For changes of a
//! case file the library names the keys.

use std::borrow::Cow;

use asperity::key_words::{ended, explained, keys_in_tables};
use asperity::remedy::{Action, Remedy, Setting, Value};
use asperity_core::Code;

/// Option of `setting`, or its name for a key of a case.
fn option(setting: Setting) -> Cow<'static, str> {
    let option = match setting {
        Setting::XUnit => "--x-unit",
        Setting::ZUnit => "--z-unit",
        Setting::Spacing => "--dx",
        Setting::RowSpacing => "--dy",
        Setting::Columns => "--columns",
        Setting::Decimal => "--decimal",
        Setting::Separator => "--separator",
        Setting::Encoding => "--encoding",
        Setting::Gaps => "--gaps",
        Setting::Row => "--row",
        // A command on one profile takes one of them.
        Setting::Rows => "surface.pinion.rows",
        Setting::Line => "--line",
        Setting::Abscissa => "--abscissa",
        Setting::BaseRadius => "--base-radius",
        Setting::Uneven => "--uneven",
        Setting::Range => "--range",
        Setting::Invert => "--invert",
        Setting::Outliers => "--outliers",
        Setting::Form => "--form",
        Setting::Cutoff => "--lambda-c",
        Setting::NoiseCutoff => "--lambda-s",
        // A setting of a function has an option of its name, a key of a case has a table.
        Setting::Key(key) if !key.contains('.') => {
            return format!("--{}", key.replace('_', "-")).into();
        }
        other => other.key(),
    };
    option.into()
}

/// `message` with its remedy in options of the command line.
pub fn with_options(message: &str, remedy: &Remedy) -> String {
    ended(message, &remedy.sentence(in_options))
}

/// An action in options of the command line.
pub fn in_options(action: &Action) -> String {
    match action {
        Action::Do { what } => what.to_string(),
        Action::Omit { setting } => format!("leave {} out", option(*setting)),
        Action::Set { settings, to, why } => {
            let names: Vec<_> = settings.iter().map(|setting| option(*setting)).collect();
            let names = names.join(" and ");
            let verb = if names.starts_with("--") {
                "pass"
            } else {
                "set"
            };
            let instruction = match to {
                Value::This(value) if settings[..] == [Setting::Invert] => match value.as_ref() {
                    "true" => format!("{verb} {names}"),
                    value => format!("{verb} {names}={value}"),
                },
                Value::This(value) | Value::OneOf(value) => {
                    format!("{verb} {names} {}", argument(settings, value))
                }
                Value::Like(value) => {
                    format!("{verb} {names}, e.g. {names} {}", argument(settings, value))
                }
                _ => format!("{verb} {names}"),
            };
            explained(instruction, why)
        }
        _ => String::new(),
    }
}

/// A value as an argument: a cut-off of zero is `none`, and a quantity has no space.
fn argument(settings: &[Setting], value: &str) -> String {
    match (settings, value) {
        ([Setting::Cutoff | Setting::NoiseCutoff], "0 mm") => "none".to_owned(),
        (
            [
                Setting::Spacing
                | Setting::RowSpacing
                | Setting::BaseRadius
                | Setting::Cutoff
                | Setting::NoiseCutoff
                | Setting::Range,
            ],
            value,
        ) => value.replace(' ', ""),
        (_, value) => value.to_owned(),
    }
}

/// General advice for a code, with its options, its keys and the commands that help.
pub fn advice(code: Code) -> String {
    let entry = code.explain();
    let mut text = entry.remedy.to_owned();
    if !entry.settings.is_empty() {
        let options: Vec<_> = entry.settings.iter().map(|s| option(*s)).collect();
        text = format!(
            "{} ({}; in a case {}).",
            text.trim_end_matches('.'),
            options.join(", "),
            keys_in_tables(entry.settings),
        );
    }
    match command(code) {
        Some(more) => format!("{text} {more}"),
        None => text,
    }
}

/// Commands that help with a code.
fn command(code: Code) -> Option<&'static str> {
    Some(match code {
        Code::E201 => "asperity demo writes a case to start from.",
        Code::E202 => "asperity demo writes a case to compare with.",
        Code::E203 => "asperity schema lists every key.",
        Code::E204 => "asperity schema lists every key with its unit.",
        Code::E210 => "asperity equations and asperity explain list them all.",
        Code::E301 => {
            "asperity profile info shows the profile; the gap of the unsolved contact is saved in the folder \"failed\" next to the results."
        }
        Code::E212 | Code::E308 | Code::W201 => {
            "asperity check lists every unusual number of a case."
        }
        Code::E310 => "asperity design takes these as --torque-max, --speed-max and --temperature.",
        Code::E322 => "asperity oil stribeck takes times of rubbing as --rubbing \"0 s,2 h\".",
        Code::E319 => "asperity oil fit takes it for all readings as --point-floor 0.001.",
        Code::E401 => "Most commands take another target with -o.",
        Code::W401 => "asperity run --laws prints the published friction laws.",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_remedy_is_told_in_options() {
        let unit = Remedy::set(Setting::ZUnit, Value::OneOf("um | nm | mm".into()));
        assert_eq!(
            with_options("a.csv: no unit", &unit),
            "a.csv: no unit. Pass --z-unit um | nm | mm"
        );
        let spacing = Remedy::set(Setting::Spacing, Value::Like("0.5 um".into()));
        assert_eq!(with_options("m", &spacing), "m. Pass --dx, e.g. --dx 0.5um");
        let none = Remedy::set(Setting::Cutoff, Value::This("0 mm".into()));
        assert_eq!(with_options("m", &none), "m. Pass --lambda-c none");
        assert_eq!(with_options("m?", &none), "m?");
        let invert = |value: &'static str| Remedy::set(Setting::Invert, Value::This(value.into()));
        assert_eq!(with_options("m", &invert("true")), "m. Pass --invert");
        assert_eq!(
            with_options("m", &invert("false")),
            "m. Pass --invert=false"
        );
    }

    #[test]
    fn advice_names_options_and_keys() {
        assert_eq!(
            advice(Code::E110),
            "State the spacing of the points, e.g. 0.5 um (--dx; in a case dx in surface.pinion)."
        );
        // Keys of several tables.
        let says = "; in a case z_unit, gaps in surface.pinion, outliers in surface).";
        assert!(advice(Code::E131).ends_with(says));
    }
}
