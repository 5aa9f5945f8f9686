//! Reading and checks of an oil file.

use std::sync::{Arc, LazyLock};

use asperity_core::quantity::Temperature;
use asperity_oil::LubricantInput;
use serde::Deserialize;
use serde_json::Value as Json;

use super::case_file::{CaseFile, read_part};
use crate::case::calibration::{Calibrated, cholesky};
use crate::case::error::CaseError;
use crate::case::files::{Content, FileSums, Files, OIL_FILE, Reader};
use crate::case::input::CaseInput;
use crate::case::oil_file::{FitQuality, FittedFriction, FittedName, OilFile};
use crate::case::section::Section;
use crate::case::source::Source;

/// Steepest fall of ln Λ of a band \[1/K\]: a wider one has draws for which a film has several temperatures.
const STEEPEST_FALL: f64 = 0.016;

impl CaseFile for OilFile {
    const VALID: &'static str = r#"
schema = "asperity-oil-1"
lubricant = { oil = "m100" }

[film_friction]
pressure_law = "barus"
eyring_stress = { value = "4.8 MPa", low = "4.2 MPa", high = "5.4 MPa" }
limiting_shear = { value = 0.036, low = 0.030, high = 0.042, identified = false }
limiting_shear_temperature = { value = 0.0004, low = -0.0028, high = 0.0035 }
pressure_viscosity_factor = { value = 0.95, low = 0.91, high = 0.99 }
correlations = [{ between = ["eyring_stress", "pressure_viscosity_factor"], value = -0.66 }]
temperatures = ["40 °C", "120 °C"]
pressure_max = "1.19 GPa"
fit = { points = 100, chi2_per_point = 0.76, other_law = 309.0, this_law = 78.0 }
source = "curves.csv"
"#;

    fn schema() -> &'static Json {
        static SCHEMA: LazyLock<Json> = LazyLock::new(|| schemars::schema_for!(OilFile).to_value());
        &SCHEMA
    }
}

/// The oil file that `input` names, and its sum.
pub(crate) fn oil_file(
    input: &CaseInput,
    source: &Source,
    files: &Files,
) -> Result<(Option<Arc<OilFile>>, Arc<FileSums>), CaseError> {
    let Some(name) = &input.lubricant.oil_file else {
        return Ok((None, Arc::default()));
    };
    let reader = Reader::of(files);
    let Content::Bytes(bytes) = reader.open(name, source, OIL_FILE)?.0 else {
        let message = "names a trace, not an oil file";
        return Err(Section::of(source, OIL_FILE).value("", message));
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
        CaseInput::refuse_unknown(source.key_paths(), |key| source.place_of_key(key))?;
        let place = |key: &str| source.place_of(key);
        let sheet: DataSheet = read_part(source.table()?, CaseInput::schema(), place)?;
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
        let lubricant = Section::of(source, "lubricant");
        let section = Section::of(source, "film_friction");
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
        let section = Section::of(source, "other_law");
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
            let Calibrated { value, low, high } = self.of(name);
            let is_within = low < high && (low..=high).contains(&value) && high.is_finite();
            let is_fall = name == FittedName::LimitingShearTemperature;
            let rule = match is_fall {
                _ if !is_within || (!is_fall && low <= 0.0) => match is_fall {
                    true => "needs low < high with the value between them",
                    false => "needs 0 < low < high with the value between them",
                },
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

#[cfg(test)]
mod tests {
    use asperity_oil::PressureLaw;

    use super::*;

    fn read(text: &str) -> Result<OilFile, CaseError> {
        OilFile::of_source(&Source::new("oil.toml", text)?)
    }

    #[test]
    fn a_written_file_reads_back() {
        let file = read(OilFile::VALID).unwrap();
        let text = file.to_string();
        assert_eq!(read(&text).unwrap(), file, "{text}");
        assert!(
            text.contains(
                "eyring_stress = { value = \"4.8 MPa\", low = \"4.2 MPa\", high = \"5.4 MPa\" }\n"
            ),
            "{text}"
        );
        let own = LubricantInput {
            oil: None,
            viscosity: Some(asperity_oil::ViscosityLaw::IsoVg {
                grade: 100.0,
                viscosity_index: 95.0,
            }),
            ..LubricantInput::default()
        };
        let file = OilFile {
            lubricant: own,
            ..file
        };
        assert_eq!(read(&file.to_string()).unwrap(), file, "{file}");
    }

    /// The valid file with constants by Roelands as well.
    fn undecided() -> OilFile {
        let first = OilFile::VALID.replace("other_law = 309.0", "other_law = 80.0");
        let (_, table) = first.split_once("[film_friction]").unwrap();
        let other = table
            .replace("barus", "roelands")
            .replace("4.8 MPa", "5.0 MPa")
            .replace(
                "other_law = 80.0, this_law = 78.0",
                "other_law = 78.0, this_law = 80.0",
            );
        read(&format!("{first}\n[other_law]{other}")).unwrap()
    }

    #[test]
    fn an_undecided_law_of_pressure_has_the_odds_of_the_fits() {
        let file = undecided();
        assert_eq!(read(&file.to_string()).unwrap(), file, "{file}");
        let odds = file.film_friction.probability_of_other_law();
        assert!((odds - 1.0 / (1.0 + 1f64.exp())).abs() < 1e-15);
        let file = Arc::new(file);
        let law_of = |file: &Arc<OilFile>, stated| {
            let found = Arc::clone(file).by_law(stated);
            let other = found.other_law.as_ref().unwrap().pressure_law;
            assert_ne!(other, found.film_friction.pressure_law);
            found
        };
        let by_roelands = law_of(&file, Some(PressureLaw::Roelands));
        assert_eq!(by_roelands.film_friction.eyring_stress.value.si(), 5e6);
        // The better law returns once no law is stated.
        assert_eq!(law_of(&by_roelands, None), file);
        assert_eq!(law_of(&file, Some(PressureLaw::Barus)), file);
        let text = file.to_string().replace("roelands", "barus");
        let error = read(&text).unwrap_err().to_string();
        assert!(
            error.contains("other_law.pressure_law: needs another law"),
            "{error}"
        );
    }

    #[test]
    fn impossible_files_are_refused_with_key_and_line() {
        for (from, to, code, says) in [
            (
                "asperity-oil-1",
                "asperity-oil-2",
                "E204",
                "oil.toml:2: schema: unknown choice `asperity-oil-2`",
            ),
            (
                "pressure_law = \"barus\"\n",
                "",
                "E204",
                "missing key \"pressure_law\"",
            ),
            (
                "eyring_stress",
                "eyring_strain",
                "E203",
                "oil.toml:7: unknown key \"film_friction.eyring_strain\"",
            ),
            (
                "low = \"4.2 MPa\"",
                "low = \"5.2 MPa\"",
                "E205",
                "oil.toml:7: film_friction.eyring_stress: needs 0 < low < high",
            ),
            (
                "low = 0.030",
                "low = 0",
                "E205",
                "film_friction.limiting_shear: needs 0 < low",
            ),
            (
                "high = 0.042",
                "high = 1.2",
                "E205",
                "film_friction.limiting_shear: must be below 1",
            ),
            (
                "low = -0.0028",
                "low = 0.0028",
                "E205",
                "film_friction.limiting_shear_temperature: needs low < high",
            ),
            (
                "high = 0.0035",
                "high = 0.02",
                "E205",
                "no single temperature",
            ),
            (
                "value = \"4.8 MPa\"",
                "value = 4.8",
                "E204",
                "film_friction.eyring_stress",
            ),
            (
                "value = -0.66",
                "value = -1.66",
                "E205",
                "film_friction.correlations: contradict",
            ),
            (
                "\"eyring_stress\", \"pr",
                "\"eyring\", \"pr",
                "E204",
                "film_friction.correlations",
            ),
            (
                "[\"40 °C\", \"120 °C\"]",
                "[]",
                "E205",
                "film_friction.temperatures",
            ),
            ("1.19 GPa", "-1 GPa", "E205", "film_friction.pressure_max"),
            ("points = 100", "points = 0", "E205", "film_friction.fit"),
            (
                "oil = \"m100\"",
                "oil_file = \"b.toml\"",
                "E205",
                "oil.toml:3: lubricant.oil_file: is a key of a case",
            ),
        ] {
            assert!(OilFile::VALID.contains(from), "{from}");
            let error = read(&OilFile::VALID.replacen(from, to, 1)).unwrap_err();
            assert_eq!(error.code(), code, "{error}");
            assert!(error.to_string().contains(says), "{error}");
        }
        assert_eq!(read("x y").unwrap_err().code(), "E202");
    }

    #[test]
    fn the_error_of_the_law_grows_beyond_the_tested_temperatures() {
        let mut found = read(OilFile::VALID).unwrap().film_friction;
        let at = |celsius: f64| Temperature::from_celsius(celsius);
        for (celsius, error) in [(90.0, 0.02), (139.0, 0.02), (15.0, 0.02f64.hypot(0.0625))] {
            assert!((found.law_error(at(celsius)) - error).abs() < 1e-12);
        }
        found.fit.chi2_per_point = 2.0;
        assert_eq!(found.law_error(at(90.0)), 0.12);
    }
}
