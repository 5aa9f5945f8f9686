//! The studies of one case, which command and Python walk.

use serde::Serialize;

use crate::study::{CaseStudy, Setting};

/// The values of `$visit::<S>()` for every study `S` of one case.
#[macro_export]
macro_rules! every_study {
    ($visit:ident) => {
        [
            $visit::<$crate::sensitivity::SensitivitySettings>(),
            $visit::<$crate::ridges::RidgeSettings>(),
            $visit::<$crate::callout::CallOutSettings>(),
        ]
    };
}

/// Description of a study of one case.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Described {
    /// Name of the command, and of the function in Python.
    pub name: &'static str,
    /// What it answers.
    pub about: &'static str,
    /// Explanation of the method.
    pub method: &'static str,
    /// What its progress counts.
    pub steps: &'static str,
    /// Its settings.
    pub settings: Vec<Setting>,
}

/// The studies of one case.
#[must_use]
pub fn studies() -> Vec<Described> {
    crate::every_study!(described).into()
}

fn described<S: CaseStudy>() -> Described {
    Described {
        name: S::COMMAND,
        about: S::ABOUT,
        method: S::METHOD,
        steps: S::STEPS,
        settings: S::described(),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;
    use crate::callout::CallOutSettings;
    use crate::study::Settings as _;

    #[test]
    fn settings_that_are_left_out_have_their_defaults_and_wrong_ones_are_named() {
        let of = |stated: serde_json::Value| {
            CallOutSettings::of_json(stated).map_err(|fault| fault.to_string())
        };
        let found = of(json!({ "loss": "600 W", "lots": 20 })).unwrap();
        assert_eq!((found.lots, found.seed, found.traces), (20, 1, None));
        assert_eq!(found.confidence.value(), 0.9);
        let refused = |stated: serde_json::Value| of(stated).unwrap_err();
        assert!(refused(json!({ "loss": "600 W", "lots": "many" })).contains("lots: "));
        assert!(refused(json!({ "lots": 20 })).contains("`loss`"));
        assert!(refused(json!({ "loss": "600 W", "lot": 20 })).contains("`lot`"));
        assert!(refused(json!(["600 W"])).contains("CallOutSettings"));
    }

    #[test]
    fn every_study_has_a_name_of_its_own_and_every_setting_is_described() {
        let all = studies();
        for (k, study) in all.iter().enumerate() {
            assert!(all[..k].iter().all(|other| other.name != study.name));
            assert!(!study.about.is_empty() && !study.steps.is_empty());
            let mut settings = study.settings.iter();
            assert!(settings.all(|setting| !setting.about.is_empty()));
        }
    }
}
