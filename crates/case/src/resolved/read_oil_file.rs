//! Reading and checks of an oil file.

use std::path::Path;
use std::sync::{Arc, LazyLock};

use asperity_core::Estimate;
use asperity_core::quantity::Temperature;
use asperity_oil::LubricantInput;
use serde::Deserialize;
use serde_json::Value as Json;

use super::oil_file::{FitQuality, FittedFriction, FittedName, OilFile, STEEPEST_FALL};
use crate::input::calibration::cholesky;
use crate::input::files::{Content, FileSums, Files, OIL_FILE, Reader};
use crate::source::case_error::CaseError;
use crate::source::section::Section;
use crate::source::source_text::Source;
use crate::text::case_file::{CaseFile, read_part, refuse_unknown, schema_with};

impl CaseFile for OilFile {
    fn schema_of(_: &Source) -> &'static Json {
        static SCHEMA: LazyLock<Json> = LazyLock::new(|| schemars::schema_for!(OilFile).to_value());
        &SCHEMA
    }

    fn schema(&self) -> &'static Json {
        Self::schema_of(&Source::in_memory())
    }
}

/// The oil file that a case names, and its sum.
pub(crate) fn oil_file(
    name: Option<&Path>,
    source: &Source,
    files: &Files,
) -> Result<(Option<Arc<OilFile>>, Arc<FileSums>), CaseError> {
    let Some(name) = name else {
        return Ok((None, Arc::default()));
    };
    let reader = Reader::new(files);
    let Content::Bytes(bytes) = reader.open(name, source, OIL_FILE)?.0 else {
        let message = "names a trace, not an oil file";
        return Err(Section::new(source, OIL_FILE).value("", message));
    };
    let file = Source::from_bytes(&files.path_of(name).display().to_string(), &bytes)?;
    let file = OilFile::of_source(&file)?;
    Ok((Some(file.into()), reader.into_sums().into()))
}

impl OilFile {
    /// Whether a text is an oil file, and not a case.
    #[must_use]
    pub fn is_one(source: &Source) -> bool {
        let mut keys = source.key_paths();
        keys.any(|key| key == "film_friction")
    }

    /// The oil of a file with the table `lubricant` only, as a case states it; `None` of any other file.
    ///
    /// # Errors
    /// When a key is not known, or a value has no unit.
    pub fn data_sheet(source: &Source) -> Result<Option<LubricantInput>, CaseError> {
        #[derive(Deserialize)]
        struct DataSheet {
            lubricant: LubricantInput,
        }
        let is_own = |key: &str| key.split('.').next() == Some("lubricant");
        let names_a_file = |key: &str| key == OIL_FILE;
        let mut keys = source.key_paths().peekable();
        if keys.peek().is_none() || !keys.all(|key| is_own(key) && !names_a_file(key)) {
            return Ok(None);
        }
        refuse_unknown(schema_with(false), source.key_paths(), |key| {
            source.place_of_key(key)
        })?;
        let place = |key: &str| source.place_of(key);
        let sheet: DataSheet = read_part(source.table()?, schema_with(false), place)?;
        Ok(Some(sheet.lubricant))
    }

    /// Reads and checks an oil file.
    ///
    /// # Errors
    /// When a key is not known or missing, or a value impossible, with its place.
    pub fn of_source(source: &Source) -> Result<Self, CaseError> {
        let file = Self::read(source)?;
        file.check(source)?;
        Ok(file)
    }

    /// Refuses bands that do not contain their value, and correlations that contradict each other.
    fn check(&self, source: &Source) -> Result<(), CaseError> {
        let lubricant = Section::new(source, "lubricant");
        let section = Section::new(source, "film_friction");
        let LubricantInput {
            oil_file,
            pressure_viscosity_factor,
            limiting_shear_temperature,
            ..
        } = &self.lubricant;
        let elsewhere = [
            ("oil_file", oil_file.is_some()),
            (
                "pressure_viscosity_factor",
                pressure_viscosity_factor.is_some(),
            ),
            (
                "limiting_shear_temperature",
                limiting_shear_temperature.is_some(),
            ),
        ];
        if let Some((key, _)) = elsewhere.into_iter().find(|(_, is_stated)| *is_stated) {
            let rule = "is a key of a case; an oil file has film_friction";
            return Err(lubricant.conflict_of_key(key, rule));
        }
        self.film_friction.check(section)?;
        let Some(other) = &self.other_law else {
            return Ok(());
        };
        let section = Section::new(source, "other_law");
        if other.pressure_law == self.film_friction.pressure_law {
            let rule = "needs another law than film_friction";
            return Err(section.conflict("pressure_law", rule));
        }
        other.check(section)
    }
}

impl FittedFriction {
    fn check(&self, section: Section<'_>) -> Result<(), CaseError> {
        for name in FittedName::ALL {
            let found = self.of(name);
            let Estimate { value, low, high } = found;
            let is_within = low < high && found.contains(value) && high.is_finite();
            let is_fall = name == FittedName::LimitingShearTemperature;
            let rule = match is_fall {
                _ if !is_within || (!is_fall && low <= 0.0) => {
                    if is_fall {
                        "needs low < high with the value between them"
                    } else {
                        "needs 0 < low < high with the value between them"
                    }
                }
                true if low < -STEEPEST_FALL || high > STEEPEST_FALL => {
                    "needs -0.016 <= low and high <= 0.016 1/K: the film would have no single temperature"
                }
                _ if name == FittedName::LimitingShear && high >= 1.0 => "must be below 1",
                _ => continue,
            };
            return Err(section.conflict(name.key(), rule));
        }
        let FitQuality {
            points,
            chi2_per_point,
            other_law,
            this_law,
        } = self.fit;
        let is_sum = |value: f64| value.is_finite() && value >= 0.0;
        let is_known = |kelvin: &Temperature| kelvin.si().is_finite() && kelvin.si() > 0.0;
        let faults = [
            (
                "temperatures",
                !self.temperatures.is_empty() && self.temperatures.iter().all(is_known),
                "needs the temperatures of the curves",
            ),
            (
                "pressure_max",
                self.pressure_max.si() > 0.0 && self.pressure_max.si().is_finite(),
                "must be positive",
            ),
            (
                "fit",
                points > 0
                    && [chi2_per_point, other_law, this_law]
                        .into_iter()
                        .all(is_sum),
                "needs points, and squares of 0 or more",
            ),
            (
                "correlations",
                self.has_distribution(),
                "contradict each other: no measurements have these correlations",
            ),
        ];
        match faults.into_iter().find(|(_, holds, _)| !holds) {
            None => Ok(()),
            Some((key, _, rule)) => Err(section.conflict(key, rule)),
        }
    }

    fn has_distribution(&self) -> bool {
        let [all, found] = [FittedName::ALL, FittedName::ALL];
        let names = |i: usize, j: usize| self.correlation(all[i], found[j]);
        cholesky(FittedName::ALL.len(), names).is_some()
    }
}
