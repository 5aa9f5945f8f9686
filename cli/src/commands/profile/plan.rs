//! Preparation of a trace by the options of the command.

use asperity_core::quantity::Length;
use asperity_core::{Code, Profile};
use asperity_profile_io::Warning as ReadWarning;
use asperity_profile_io::read::{FilterState, Reading};
use asperity_roughness::ambiguity::Sections;
use asperity_roughness::form::Form;
use asperity_roughness::involute::{Involute, form_left, remove};
use asperity_roughness::preparation::{Preparation, PreparationRecord, RoughnessFilter};
use asperity_roughness::{RoughnessError, Warning};
use serde_json::{Value, json};

use crate::args::{FormArg, PreparingArgs, name_of};
use crate::failure::Failure;

/// Sections of a trace that is not filtered.
const SECTIONS: usize = 5;

/// Error of involute options without the removal of an involute.
const INVOLUTE_ONLY: &str = "--base-radius, --roll-length and --towards-root go with --form involute only, and --base-radius with files against roll length";

/// Form removal, filters and sections.
#[derive(Debug, Clone, Copy)]
pub struct PreparationPlan {
    /// Form other than an involute, and filters.
    pub recipe: Preparation,
    /// The filter at lambda_c.
    pub filter: RoughnessFilter,
    /// Involute that is removed first.
    pub involute: Option<Involute>,
    /// Evaluation of the result.
    pub sections: Sections,
}

impl PreparationPlan {
    /// Makes the plan of the options, for any file.
    pub fn from_args(args: &PreparingArgs) -> Result<Self, Failure> {
        Self::with(args, None)
    }

    /// Makes the plan of the options for a file, whose stated cut-offs are the default.
    pub fn for_reading(args: &PreparingArgs, reading: &Reading) -> Result<Self, Failure> {
        let converts =
            |warning: &ReadWarning| matches!(warning, ReadWarning::RollLengthConverted { .. });
        if args.base_radius.is_some()
            && args.form != Some(FormArg::Involute)
            && !reading.warnings.iter().any(converts)
        {
            return Err(Failure::new(Code::E205, INVOLUTE_ONLY));
        }
        Self::with(args, Some(reading))
    }

    fn with(args: &PreparingArgs, reading: Option<&Reading>) -> Result<Self, Failure> {
        let usual = if args.as_is || args.level {
            Preparation {
                lambda_s: None,
                lambda_c: None,
                ..Preparation::default()
            }
        } else {
            let usual = Preparation::default();
            // A filtered profile has been filtered with its stated cut-offs.
            let unfiltered = reading.filter(|r| r.filter_state != FilterState::Roughness);
            let stated = unfiltered.map(|reading| &reading.metadata);
            Preparation {
                lambda_s: stated.and_then(|s| s.lambda_s).or(usual.lambda_s),
                lambda_c: stated.and_then(|s| s.lambda_c).or(usual.lambda_c),
                ..usual
            }
        };
        let chosen = |option: Option<Length>, default: Option<Length>| match option {
            None => default,
            Some(length) => (length.si() != 0.0).then_some(length),
        };
        let recipe = Preparation {
            form: form(args),
            lambda_s: chosen(args.lambda_s, usual.lambda_s),
            lambda_c: chosen(args.lambda_c, usual.lambda_c),
            ends: args.ends.unwrap_or(usual.ends),
        };
        if args.robust && recipe.lambda_c.is_none() {
            let text = "--robust applies to the lambda_c filter, which is off; pass --lambda-c, e.g. --lambda-c 0.8mm";
            return Err(Failure::new(Code::E205, text));
        }
        Ok(Self {
            recipe,
            filter: if args.robust {
                RoughnessFilter::RobustGaussian
            } else {
                RoughnessFilter::Gaussian
            },
            involute: involute(args)?,
            sections: match (args.sections, recipe.lambda_c) {
                (Some(number), _) => Sections::Number(number.into()),
                (None, Some(lambda_c)) => Sections::OfLength(lambda_c),
                (None, None) => Sections::Number(SECTIONS),
            },
        })
    }

    /// The trace without its involute, the input of the recipe; `None` if no involute is removed.
    pub fn without_involute(&self, profile: &Profile) -> Result<Option<Profile>, RoughnessError> {
        let flank = self.involute.as_ref();
        flank.map(|flank| remove(profile, flank)).transpose()
    }

    /// Warning that the involute does not match the trace.
    pub fn involute_left(&self, profile: &Profile) -> Result<Option<Warning>, RoughnessError> {
        let flank = self.involute.as_ref();
        let left = flank.map(|flank| form_left(profile, flank));
        Ok(left.transpose()?.flatten())
    }

    /// Advice for a trace that is too short for the filters: its length, and the options that it permits.
    pub fn advice_for(&self, reading: &Reading) -> String {
        if reading.filter_state == FilterState::Roughness {
            let options = as_is(reading);
            return format!(". It was filtered before: pass {options}");
        }
        /// Cut-offs of ISO 3274, in mm.
        const USUAL: [f64; 5] = [8.0, 2.5, 0.8, 0.25, 0.08];
        let (length, dx) = (1e3 * reading.length.si(), 1e3 * reading.spacing.si());
        // With cut ends a trace must have two cut-offs; a cut-off has at least five points.
        let fits = |cutoff: &&f64| 2.0 * **cutoff <= length && **cutoff >= 5.0 * dx;
        let unfiltered = "--level for no filter";
        let options = USUAL.iter().find(fits).map_or_else(
            || unfiltered.to_owned(),
            |cutoff| format!("--lambda-c {cutoff}mm, or {unfiltered}"),
        );
        format!(
            ". It was read as {}, {} points. Pass {options}",
            reading.format, reading.points
        )
    }

    /// Removed form as text.
    pub fn form(&self) -> String {
        let Some(flank) = &self.involute else {
            return name_of(&self.recipe.form);
        };
        format!(
            "involute (base radius {}, roll length {} at the middle, towards the {})",
            flank.base_radius,
            flank.roll_length,
            if flank.towards_root { "root" } else { "tip" }
        )
    }

    /// Record of the preparation, with the involute.
    pub fn recorded(&self, record: &PreparationRecord) -> Value {
        let mut value = json!(record);
        if let Some(flank) = &self.involute {
            value["recipe"]["form"] = json!("involute");
            value["involute"] = json!({
                "base_radius_mm": 1e3 * flank.base_radius.si(),
                "roll_length_mm": 1e3 * flank.roll_length.si(),
                "towards_root": flank.towards_root,
            });
        }
        value
    }
}

/// Options for a roughness profile with the sections of its instrument.
pub fn as_is(reading: &Reading) -> String {
    let sections = reading
        .metadata
        .lambda_c
        .map(|lambda_c| (reading.length / lambda_c).round())
        .filter(|sections| *sections >= 1.0);
    let option = sections.map_or(String::new(), |n| format!(" --sections {n}"));
    format!("--as-is{option}")
}

/// Form removed by the recipe; an involute includes the line.
pub(super) fn form(args: &PreparingArgs) -> Form {
    match args.form {
        None if args.as_is => Form::None,
        None => Form::Level,
        Some(FormArg::None | FormArg::Involute) => Form::None,
        Some(FormArg::Mean) => Form::Mean,
        Some(FormArg::Level) => Form::Level,
        Some(FormArg::Poly2) => Form::Poly2,
        Some(FormArg::Circle) => Form::Circle,
    }
}

fn involute(args: &PreparingArgs) -> Result<Option<Involute>, Failure> {
    let contradiction = |text: &str| Err(Failure::new(Code::E205, text));
    let options = [args.base_radius, args.roll_length];
    if args.form != Some(FormArg::Involute) {
        if args.towards_root || args.roll_length.is_some() {
            return contradiction(INVOLUTE_ONLY);
        }
        return Ok(None);
    }
    match options {
        [Some(base_radius), Some(roll_length)] => Ok(Some(Involute {
            base_radius,
            roll_length,
            towards_root: args.towards_root,
        })),
        [None, _] => contradiction(
            "--form involute needs --base-radius, the base radius of the gear, e.g. --base-radius 50mm",
        ),
        [_, None] => contradiction(
            "--form involute needs --roll-length, the radius of curvature at the middle of the trace: \
             √(r² − r_b²) at radius r on the flank, e.g. --roll-length 15mm",
        ),
    }
}
