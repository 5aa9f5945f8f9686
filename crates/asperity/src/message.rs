//! Codes of errors and warnings, and what each means.
//!
//! Codes are stable: E1xx files, E2xx cases, E3xx solutions, W1xx about a file, W4xx about a result.

use serde::Serialize;

/// A warning that goes with a result.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Warning {
    /// Stable code, `W402`.
    pub code: &'static str,
    /// What was seen, what was expected.
    pub text: String,
}

impl Warning {
    /// A warning of this code.
    pub fn new(code: &'static str, text: impl Into<String>) -> Self {
        Self {
            code,
            text: text.into(),
        }
    }
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.code, self.text)
    }
}

/// What a code means and what to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Explanation {
    /// Stable code.
    pub code: &'static str,
    /// The message in a few words.
    pub title: &'static str,
    /// Why it is said.
    pub meaning: &'static str,
    /// What to do.
    pub remedy: &'static str,
}

/// The explanation of `code`, whatever its case.
///
/// ```
/// assert!(asperity::message::explain("w402").is_some());
/// assert!(asperity::message::explain("W999").is_none());
/// ```
pub fn explain(code: &str) -> Option<&'static Explanation> {
    EXPLANATIONS
        .iter()
        .find(|entry| entry.code.eq_ignore_ascii_case(code.trim()))
}

macro_rules! explanations {
    ($($code:literal $title:literal : $meaning:literal => $remedy:literal;)+) => {
        /// Every code.
        pub const EXPLANATIONS: &[Explanation] = &[$(Explanation {
            code: $code, title: $title, meaning: $meaning, remedy: $remedy,
        }),+];
    };
}

explanations! {
    "E101" "a number cannot be read": "A cell of a profile file holds text where a height or a position was expected. Often the decimal sign is a comma." => "Look at the line named. Say --decimal comma, --separator or --columns when the file was misread.";
    "E102" "no data": "The file holds no column of numbers." => "Check that the export is of the profile and not of the report, or name the columns with --columns.";
    "E103" "a file cannot be opened": "The system refused to open the file, or its text encoding is unknown." => "Check the path (it is relative to the case file) and the permissions, or say --encoding.";
    "E104" "no unit": "Neither a header nor a unit row names the unit of the heights, and the range fits more than one." => "Say --z-unit um, nm or mm (and --x-unit for the positions).";
    "E105" "positions do not increase": "The column of positions goes back or stands still, so the points are not a trace." => "Export one trace per file, or choose the right columns with --columns.";
    "E106" "too few points": "Fewer than 100 points cannot give a roughness." => "Export the whole trace.";
    "E107" "missing points": "Some heights are missing or not numbers. A missing point is never filled in silence." => "Say --gaps interpolate to bridge them by straight lines; the result records how many.";
    "E108" "format known but not read": "The file is of a format that this version does not read." => "Export the profile as text or CSV from the instrument's software.";
    "E109" "uneven spacing": "The positions are not evenly spaced within what rounding explains." => "Resample the trace in the instrument's software, or leave the position column out and say --dx.";
    "E110" "the trace cannot be prepared": "Form removal or filtering is not possible on this trace, mostly because it is shorter than the cut-off." => "Choose a shorter cut-off (0.25 mm is usual on gears) or another end convention.";
    "E121" "spacing too coarse for the contact": "Fewer than 20 points fall on one Hertz half-width, so the contact cannot be resolved." => "Measure with a finer spacing; with a stylus 0.5 um is usual.";
    "E122" "trace shorter than the contact window": "The prepared trace does not cover the window of the contact." => "Measure a longer trace, choose a shorter cut-off (the filter drops its ends), or reduce model.window.";
    "E123" "spacings of the two flanks differ": "The traces of pinion and wheel have different spacings that cannot be brought together." => "Resample one of them.";
    "E201" "the case file cannot be opened": "The system refused to open the file." => "Check the path; asperity demo writes a case to start from.";
    "E202" "the case file is not TOML": "The text breaks the rules of TOML (or of JSON, for a .json file)." => "Look at the line named; text stands in quotation marks.";
    "E203" "unknown key": "The case file has a key that means nothing." => "Correct the spelling; asperity schema lists every key.";
    "E204" "a value cannot be read": "A value is missing, of the wrong kind, or lacks its unit. Quantities are text with a unit: \"1.3 mm\"." => "Write the value as the message shows.";
    "E205" "keys exclude or need each other": "Two keys say different things about the same, or one needs another that is not there." => "Do as the message says.";
    "E206" "the gear pair cannot mesh": "Geometry as given leads to interference, pointed teeth or too short a path of contact." => "Check teeth, profile shifts, centre distance and tip diameters.";
    "E207" "pressure-viscosity coefficient is impossible": "The value is orders of magnitude away from that of any oil, mostly because of the unit." => "Mineral oils have 15 to 25 1/GPa, that is 1.5e-8 to 2.5e-8 m2/N.";
    "E208" "the oil is incomplete": "The oil's data do not suffice, or contradict each other. The temperature coefficient of viscosity is needed." => "Give nu40, nu100 and density, or viscosity with its temperature coefficient.";
    "E209" "a number outside its domain": "A number in the case cannot be, such as a negative module." => "Correct the value named.";
    "E301" "a position did not converge": "The contact at a mesh position did not reach its tolerance. No efficiency is reported." => "Look at the fields saved in the failed folder; loosen model.tolerance or check the profile for spikes.";
    "E302" "the surface is too soft for the load": "The flow pressure is below what the load needs, so no distribution of pressure can carry it." => "Check material.pinion.flow_pressure and elastic_limit; case-hardened steel has 6 to 8 GPa and 1.5 to 2 GPa.";
    "E303" "a measured profile is needed": "The chosen formulation presses two profiles together, but a flank is given by roughness values only." => "Give surface.pinion.file and surface.wheel.file.";
    "E304" "the marching did not reach the load": "Lowering the surfaces into each other step by step did not meet the load within the numerical error." => "Reduce model.delta_step or raise model.numerical_error.";
    "E305" "outside the model": "An equation refuses the numbers it is given at a mesh position." => "Check the value named against the ranges in docs/EQUATIONS.md.";
    "E401" "the result cannot be written": "The system refused to write the result folder." => "Choose another folder with -o, or free some space.";
    "E501" "internal fault": "The program contradicts itself. This is a fault of the program, not of the input." => "Please report it with the case file.";
    "W111" "a unit was assumed": "The file does not name a unit, and only one is plausible." => "Say --z-unit or --x-unit to be sure.";
    "W112" "form not removed": "The trace still holds the shape of the flank, so its parameters are not of roughness." => "Say --form poly2 (or surface.form in the case).";
    "W113" "spacing coarse for the noise filter": "The spacing is above a fifth of the cut-off λs, so the filter is poorly sampled." => "Raise noise_cutoff or measure finer.";
    "W114" "few sections": "The evaluation length holds fewer than five cut-offs." => "Measure longer or choose a shorter cut-off.";
    "W115" "file read with a note": "Something about the file was unusual but could be read." => "Check the note.";
    "W401" "outside a fitted range": "A correlation was used outside the data it was fitted to; its value may be wrong." => "Compare the other friction laws printed, or choose another law.";
    "W402" "equivalent friction implausible": "The mean friction coefficient that explains the loss is outside 0.01 to 0.12, which lubricated steel does not do." => "Check the roughness (form removed? units?) and the oil.";
    "W403" "roughness clamped in Xu's law": "The term exp(exp S) of Xu's law explodes above S = 0.6 um; the roughness was held there." => "Choose another friction law for rough flanks, or model.clamp_roughness = false to see the law as printed.";
    "W404" "one trace for both flanks": "Both flanks come from the same trace, so their roughness is correlated and S = √(Rq1² + Rq2²) is not exact." => "Measure both flanks.";
    "W405" "yield below the surface": "The contact pressure exceeds what the material bears below the surface (p0 > 1.79 × the elastic limit). Flow in the bulk is not modelled." => "Check elastic_limit; ground gears are case-hardened (1.5 to 2 GPa).";
    "W406" "few asperities": "Fewer than five asperities reach into the peak zone; their mean radius is uncertain." => "Use a longer trace or a wider window.";
    "W407" "offsets overlap": "The traces are so short that the windows of different offsets overlap; the spread is a lower bound." => "Measure longer traces.";
    "W408" "regime without a profile": "A flank is given by roughness values; the rough contact was not computed, and losses in mixed lubrication follow from the load share alone." => "Give a measured profile for contact pressures, plasticity and running-in.";
    "W409" "asperities flow": "The contact reaches the flow pressure: these flanks run in. The energy of one pass is reported apart from the efficiency." => "Look at running_in in the result.";
    "W410" "stress below asperities passes the elastic limit": "The von Mises stress under the rough contact passes the elastic limit; flow below the surface is not modelled." => "Look at the subsurface fields of the positions named.";
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_unique_and_sorted_within_their_kind() {
        let codes: Vec<_> = EXPLANATIONS.iter().map(|entry| entry.code).collect();
        let mut sorted = codes.clone();
        sorted.sort_unstable();
        sorted.dedup();
        assert_eq!(codes, sorted);
    }
}
