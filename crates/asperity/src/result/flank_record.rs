//! A flank as a result keeps it: what was read, what was done to it, its parameters; no heights.

use asperity_core::quantity::Length;
use asperity_profile_io::read::ReadingRecord;
use asperity_roughness::Parameters;
use asperity_roughness::outliers::OutlierRecord;
use asperity_roughness::preparation::PreparationRecord;
use serde::{Deserialize, Serialize};

use asperity_case::flanks::flank_form::FlankForm;
use asperity_case::flanks::generated_record::GeneratedRecord;
use asperity_case::flanks::sheets::MadeSheet;
use asperity_case::flanks::surfaces::FlankReport;
use asperity_case::flanks::surrogate_record::SurrogateRecord;

/// One flank of a result.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct FlankRecord {
    /// File of the trace as the case names it; none for roughness values.
    pub file: Option<String>,
    /// SHA-256 of the file.
    pub sha256: Option<String>,
    /// Details of the reading of the file.
    pub reading: Option<ReadingRecord>,
    /// Whether the trace was read from its other end.
    pub mirrored: bool,
    /// Spikes that were replaced before.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub outliers: Option<OutlierRecord>,
    /// Form removal and filters applied to the trace.
    pub preparation: Option<PreparationRecord>,
    /// Parameters of the prepared trace.
    pub parameters: Option<Parameters>,
    /// The surrogates of a flank without a trace.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surrogates: Option<SurrogateRecord>,
    /// Generation of the trace from measured ones, if it was generated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub generated: Option<GeneratedRecord>,
    /// Surface that was made from the trace, where the other flank is a scan in contact as a whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub made_sheet: Option<MadeSheet>,
    /// Roll lengths of the first and the last point of the prepared trace \[mm\], where its place on the flank is
    /// known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub roll_lengths_mm: Option<[f64; 2]>,
    /// Form of the flank, where the relief of its gear is taken from the trace.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub form: Option<FormRecord>,
}

/// Form of a flank, parted from the roughness of its trace.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FormRecord {
    /// Cut-off between form and roughness \[mm\].
    pub cutoff_mm: f64,
    /// Missing material at the tip end of the active flank, against where least is missing \[µm\].
    pub at_tip_um: f64,
    /// The same at the root end \[µm\].
    pub at_root_um: f64,
    /// Roll lengths \[mm\].
    pub roll_length_mm: Vec<f64>,
    /// Heights above the involute there, normal to the flank \[µm\].
    pub height_um: Vec<f64>,
}

impl From<&FlankForm> for FormRecord {
    fn from(found: &FlankForm) -> Self {
        let times = |lengths: &[Length], factor: f64| {
            let lengths = lengths.iter();
            lengths.map(|length| length.si() * factor).collect()
        };
        Self {
            cutoff_mm: found.cutoff.si() * 1e3,
            at_tip_um: found.at_tip.si() * 1e6,
            at_root_um: found.at_root.si() * 1e6,
            roll_length_mm: times(&found.form.roll_length, 1e3),
            height_um: times(&found.form.height, 1e6),
        }
    }
}

impl FlankRecord {
    /// Words for several traces of the flank: of measured or of generated ones.
    #[must_use]
    pub fn teeth(&self) -> &'static str {
        match self.generated {
            Some(_) => "generated flanks",
            None => "traced teeth",
        }
    }
}

impl From<&FlankReport> for FlankRecord {
    fn from(flank: &FlankReport) -> Self {
        Self {
            file: flank.file.clone(),
            sha256: flank.sha256.clone(),
            reading: flank.reading.as_ref().map(|read| read.record.clone()),
            mirrored: flank.mirrored,
            outliers: flank.outliers.clone(),
            preparation: flank.preparation.clone(),
            parameters: flank.parameters.clone(),
            surrogates: flank.surrogates.clone(),
            generated: flank.generated.clone(),
            made_sheet: flank.made_sheet,
            roll_lengths_mm: flank
                .roll_lengths
                .map(|ends| ends.map(|end| end.si() * 1e3)),
            form: flank.form.as_ref().map(FormRecord::from),
        }
    }
}
