//! Codes of errors and warnings, and what each means.
//!
//! Codes are stable: E1xx files, E2xx cases, E3xx solutions, W1xx about a file, W4xx about a result.
//! No option of a command is named here: an explanation carries the settings it is about, and whoever shows it
//! names them.

use std::borrow::Cow;

use asperity_core::remedy::Setting;
use serde::{Deserialize, Serialize};

/// A warning that goes with a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// Stable code, `W402`.
    pub code: Cow<'static, str>,
    /// Values seen and expected.
    pub text: String,
}

impl Warning {
    /// A warning of this code.
    pub fn new(code: &'static str, text: impl Into<String>) -> Self {
        Self {
            code: code.into(),
            text: text.into(),
        }
    }
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}", self.code, self.text)
    }
}

/// Meaning of a code and its remedy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Explanation {
    /// Stable code.
    pub code: &'static str,
    /// The message in a few words.
    pub title: &'static str,
    /// Why it is said.
    pub meaning: &'static str,
    /// Advice.
    pub remedy: &'static str,
    /// The settings that the remedy is about.
    pub settings: &'static [Setting],
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
    ($($code:literal $title:literal : $meaning:literal => $remedy:literal $([$($setting:ident),+])?;)+) => {
        /// Every code.
        pub const EXPLANATIONS: &[Explanation] = &[$(Explanation {
            code: $code, title: $title, meaning: $meaning, remedy: $remedy,
            settings: &[$($(Setting::$setting),+)?],
        }),+];
    };
}

explanations! {
    "E101" "a number cannot be read": "A cell of a file holds text where a height or a position was expected. Often the decimal sign is a comma." => "Look at the line named. If the file was misread, state its decimal sign, its separator or its columns." [Decimal, Separator, Columns];
    "E102" "no rows of numbers": "No line of the file is a row of numbers, or the columns asked for are not there." => "Check that the export is of the profile and not of the report, or state the columns." [Columns];
    "E103" "a file cannot be opened": "The system refused to open a file that is to be read." => "Check the name and the permissions; names in a case are relative to the case file.";
    "E104" "no unit": "Neither a header nor a unit row names the unit, and the values fit more than one." => "State the unit of the heights (um, nm or mm) and of the positions." [ZUnit, XUnit];
    "E105" "positions do not increase": "The column of positions goes back or stands still, so the points are not a trace." => "Export one trace per file, or state the right columns." [Columns];
    "E106" "too few points": "Fewer points than a roughness needs (100), or a contact." => "Export the whole trace.";
    "E107" "missing points": "Some heights are missing or not numbers. A missing point is never filled in silence." => "Let the gaps be interpolated, which bridges them by straight lines; the result records how many." [Gaps];
    "E108" "format known but not read": "The file is of a format that this version does not read." => "Export the profile as text or CSV from the instrument's software.";
    "E109" "uneven spacing": "The positions are not evenly spaced within what rounding explains." => "Let the trace be resampled by straight lines, or state the spacing to leave the positions out." [Uneven, Spacing];
    "E110" "spacing not known": "The file holds heights alone, so the distance of the points must be stated." => "State the spacing of the points, as 0.5 um." [Spacing];
    "E111" "a row of another width": "A line has more or fewer columns than the others." => "Correct or remove the line.";
    "E112" "columns not clear": "Several columns and no header that tells which are position and height." => "State the columns of position and height." [Columns];
    "E113" "commas not clear": "The commas may separate columns or be decimal signs, and both readings make sense." => "State the separator and the decimal sign, or export with semicolons." [Separator, Decimal];
    "E114" "unit not known": "The header names a unit that is not one of m, mm, um, nm, inch, mil, uin." => "Convert the file, or state the unit if the header is wrong." [ZUnit, XUnit];
    "E115" "separator does not fit": "The file does not read with the separator that was stated." => "Leave the separator out, or state what separates the columns." [Separator];
    "E116" "impossible trace": "The numbers make no profile: no extent, or beyond all measure." => "Check units, columns and spacing." [ZUnit, XUnit, Columns, Spacing];
    "E117" "damaged file": "The file breaks the rules of its own format: a header that cannot be read, or fewer heights than it says." => "Export it again, or as text; a file that was cut off in transfer is the usual cause.";
    "E118" "file too large": "The file, one of its lines, or what it unpacks to, is larger than any profile." => "Export a single profile.";
    "E119" "several profiles": "The file holds several profiles, and none was chosen." => "State the number of one of them, from 1." [Row];
    "E120" "the trace cannot be prepared": "Form removal or filtering is not possible on this trace, mostly because it is shorter than the cut-off or too coarse for it." => "Choose another cut-off; 0.25 mm is usual on gears." [Cutoff, NoiseCutoff];
    "E121" "spacing too coarse for the contact": "Fewer than 20 points fall on one Hertz half-width, so the contact cannot be resolved." => "Measure with a finer spacing; with a stylus 0.5 um is usual.";
    "E122" "trace shorter than the contact window": "The prepared trace does not cover the window of the contact." => "Measure a longer trace, choose a shorter cut-off (the filter drops its ends), or reduce model.window.";
    "E123" "the traces lie beside the contact": "Where at, from and the roll lengths of the files place the traces, they meet on less than a third of the loss along the path of contact." => "Check at, its unit and from of both flanks, or leave at out: the traces are then taken for any place of the flank.";
    "E130" "positions are roll lengths": "The positions are roll lengths or roll angles of an involute checker, which are no distances along the flank." => "State the base radius of the gear, d_b/2, with which they are converted." [BaseRadius, Abscissa];
    "E131" "heights that no flank has": "The slopes of the trace are above 2 root mean square, or a single step is steeper than 5: a wrong unit, or a mark for missing points." => "State the unit of the heights, or write NaN where the mark stands." [ZUnit, Gaps];
    "E201" "the case file cannot be opened": "The system refused to open the case file." => "Check the path.";
    "E202" "the case file is not TOML": "The text breaks the rules of TOML (or of JSON, for a .json file), or is not text in UTF-8." => "Look at the line named: a line is key = value, text stands in quotation marks, the encoding is UTF-8.";
    "E203" "unknown key": "The case file has a key that means nothing." => "Correct the spelling or remove the key.";
    "E204" "a value cannot be read": "A value is missing, of the wrong kind, or lacks its unit. Quantities are text with a unit: \"1.3 mm\"." => "Write the value as the message shows.";
    "E205" "keys exclude or need each other": "Two keys or settings say different things about the same, or one needs another that is not there." => "Do as the message says.";
    "E206" "the gear pair cannot mesh": "Geometry as given leads to interference, pointed teeth or too short a path of contact." => "Check teeth, profile shifts, centre distance and tip diameters.";
    "E207" "pressure-viscosity coefficient is impossible": "The value is orders of magnitude away from that of any oil, mostly because of the unit." => "Mineral oils have 15 to 25 1/GPa, that is 1.5e-8 to 2.5e-8 m2/N.";
    "E208" "the oil is incomplete": "The oil's data do not suffice, or contradict each other." => "Give nu at 40 and 100 °C, density and base_oil, or the name of an oil of the library.";
    "E209" "a number outside its domain": "A number in the case or beside it cannot be, such as a negative module." => "Correct the value named.";
    "E210" "nothing of that name": "No equation has that tag, or no message that code." => "Look the name up in the list.";
    "E211" "the tolerance is too large": "A contact solved to a tolerance above 1e-4 can have pressures far off, and takes hardly less time." => "Give a tolerance of at most 1e-4; 1e-8 is the default.";
    "E212" "a number beyond physical sense": "The value is beyond what any gear drive has, mostly because of a wrong unit or a slip of the decimal point." => "Check the unit; the usual range is named.";
    "E301" "a position did not converge": "The contact at a mesh position did not reach its tolerance. No efficiency is reported." => "Loosen model.tolerance, or look for spikes in the profile.";
    "E302" "the surface is too soft for the load": "The flow pressure is below what the load needs, so no distribution of pressure can carry it." => "Check material.pinion.flow_pressure and elastic_limit; case-hardened steel has 6 to 8 GPa and 1.5 to 2 GPa.";
    "E303" "a measured profile is needed": "The rough contact presses two profiles together, but a flank is given by roughness values only." => "Give surface.pinion.file and surface.wheel.file, or run the case in the corrected formulation.";
    "E304" "the marching did not reach the load": "Lowering the surfaces into each other step by step did not meet the load within the numerical error." => "Reduce model.delta_step or raise model.numerical_error.";
    "E305" "outside the model": "An equation refuses the numbers it is given at a mesh position." => "Check the value named against the ranges in docs/EQUATIONS.md, or choose another law in model.";
    "E306" "the film alone would make the flank flow": "The flow pressure is below one and a half times the Hertz pressure, which the film carries without any asperity." => "Set material.pinion.flow_pressure to the indentation hardness: 6 to 8 GPa for case-hardened steel.";
    "E307" "the lubricated contact did not converge": "Newton's method found no solution of the lubricated contact, or a time step failed at its smallest length. No result is reported." => "Take more cells, smoother profiles, a flow pressure where the surfaces flow, or another viscosity law.";
    "E308" "a state beyond physical sense": "Pressure, film, speed, friction or flash temperature at a mesh position are beyond what is physically possible, so that no efficiency would mean anything." => "Check the numbers of the case, the unusual ones first.";
    "E401" "a result cannot be written": "The system refused to write, or the place is taken by something that is not a result." => "Choose another place or name, make its folder, or free some space.";
    "E402" "not a result": "What was named is not a result of a run, or lacks what was asked of it." => "Name a result folder, as results/e-drive, or its result.json.";
    "E501" "internal fault": "The program contradicts itself. This is a fault of the program, not of the input." => "Please report it with the case file.";
    "W111" "a unit was assumed": "The file does not name a unit, and only one is plausible." => "State the unit to be sure." [ZUnit, XUnit];
    "W112" "form not removed": "The trace still holds the shape of the flank, so its parameters are not of roughness." => "Remove the form, as poly2." [Form];
    "W113" "spacing coarse for the noise filter": "The spacing is above a fifth of the cut-off lambda_s, so the filter is poorly sampled." => "Choose a longer noise cut-off lambda_s, or measure finer." [NoiseCutoff];
    "W114" "few sections": "The evaluation length holds fewer than five cut-offs." => "Measure longer or choose a shorter cut-off.";
    "W115" "missing points filled": "Missing heights were bridged by straight lines, as asked for." => "Measure again if they are many or in one place.";
    "W116" "trace turned round": "The positions fall along the file, so the trace was read from its other end." => "Nothing, unless the direction of the flank matters: then say mirrored in the case.";
    "W117" "stated spacing differs": "The spacing that was stated is not that of the column of positions; the stated one was used." => "Leave the spacing out unless the column is wrong." [Spacing];
    "W118" "filtered already": "The file says that its heights are a roughness profile, and filtering twice changes it." => "Choose no cut-off, or export the unfiltered profile." [Cutoff];
    "W119" "flanks spaced differently": "The traces of pinion and wheel have different spacings; the coarser was resampled by straight lines." => "Measure both flanks with one spacing.";
    "W120" "checksum differs": "A checksum in the file is not that of its content: the file was changed after the measurement, or its writer counts differently." => "Compare with the original; the heights are read as they stand.";
    "W121" "trace aborted": "The header states a nominal length that was not traced. The spacing follows from what was traced." => "Measure again if the whole length is needed.";
    "W122" "spacing from line 1": "Line 1 is written unlike the rest and is taken as the spacing in um, as in NPL text profiles." => "State the spacing to be sure." [Spacing];
    "W123" "length rounded": "The spacing follows from a length that is printed with few digits." => "State the spacing to be exact." [Spacing];
    "W124" "heights that no flank has": "The slopes of the trace are above 2 root mean square, or a single step is steeper than 5: a wrong unit, or a mark for missing points. A case refuses such a flank." => "State the unit of the heights, or write NaN where the mark stands." [ZUnit, Gaps];
    "W125" "uneven spacing": "The positions are off an even grid by 2 to 25 % of a spacing; the points were taken as even, so slopes are off by as much." => "Let the trace be resampled." [Uneven];
    "W126" "trace resampled": "The positions were not even; the heights were put on an even grid by straight lines, as asked for." => "Nothing, unless the shortest waves matter.";
    "W127" "roll lengths converted": "The positions were roll lengths or angles and are now distances along the involute." => "Check the base radius.";
    "W128" "another involute": "A parabola or cubic is left after the involute came off: the flank is crowned, or its base radius or roll length is another." => "Check base radius and roll length; the roll length that fits best is named.";
    "W129" "other cut-offs than the file's": "The file states the cut-offs that its instrument was set to, and the case asks for others, so that parameters differ from those of the instrument." => "Leave surface.cutoff and surface.noise_cutoff out of the case to filter as the instrument did.";
    "W201" "outside the usual range": "A number of the case is outside the range that gear drives have. It may be right, but a wrong unit is more likely." => "Check the unit and the decimal point.";
    "W401" "outside a fitted range": "A correlation was used outside the data it was fitted to; its value may be wrong." => "Compare the other friction laws printed, or choose another law.";
    "W402" "equivalent friction implausible": "The mean friction coefficient that explains the loss is outside 0.01 to 0.12, which lubricated steel does not do." => "Check the roughness (form removed? units?) and the oil. In the paper formulation look at model.position: at the pitch point C nothing slides.";
    "W403" "an input held at the end of a range": "A law means nothing beyond the range it was fitted in, so its input was held at the end of that range: the roughness in Xu's law, whose exp(exp S) explodes above S = 0.6 um, or the speeds and loads of Gupta's thermal factor. The warning names law and input." => "Choose another law for this input; for Xu's, model.clamp_roughness = false shows the law as printed.";
    "W404" "one trace for both flanks": "Both flanks come from the same trace, so their roughness is correlated and S = √(Rq1² + Rq2²) is not exact." => "Measure both flanks.";
    "W405" "yield below the surface": "The contact pressure exceeds what the material bears below the surface (p0 > 1.79 × the elastic limit). Flow in the bulk is not modelled." => "Check elastic_limit; ground gears are case-hardened (1.5 to 2 GPa).";
    "W406" "few asperities": "Fewer than five asperities reach into the peak zone; their mean radius is uncertain." => "Use a longer trace or a wider window.";
    "W407" "no interval of the sampling": "The traces are hardly longer than the window of the contact: all offsets show the same place, and what another place would give is not known." => "Measure longer traces, or choose a shorter cut-off (the filter drops its ends)." [Cutoff];
    "W408" "regime without a profile": "A flank is given by roughness values; the rough contact was not computed. A load share that needs it (solved, jgp) is taken by lambda-star, which has all asperity load rub with the boundary coefficient; without rpk and asperity_radius the classical film ratio decides." => "Give a measured profile for contact pressures, plasticity and running-in.";
    "W409" "asperities flow": "The contact reaches the flow pressure: these flanks run in. The energy of one pass is reported apart from the efficiency." => "Look at running_in in the result.";
    "W410" "stress below asperities passes the elastic limit": "The von Mises stress under the rough contact passes the elastic limit: by the stress field at the first offset of a position, at the others where the pressure passes that at which a line contact first yields. Flow below the surface is not modelled." => "Look at the subsurface fields of the positions.";
    "W411" "no peaks under the contact": "The windows that meet have no peaks above the core of the profile, so Lambda* is not defined; the classical film ratio decided between full film and mixed." => "Look at the trace: a regular pattern (feed marks) has no peaks in the sense of ISO 13565-2.";
    "W412" "no sliding at the paper's position": "The paper's reading takes one position for the whole mesh; at the pitch point nothing slides, so there is no sliding loss." => "Set model.position between 0 (A) and 1 (E), or use the corrected formulation.";
    "W413" "the contact runs into the end of the window": "The pressure is not zero at a free end, so the contact would go on beyond it; the pressures are those of a strip that ends there." => "Widen the gap on that side, or lower the load.";
    "W414" "the gap spans far more than the deformation": "The undeformed gap spans more than 1000 times what the bodies deform: an outlier, a sentinel for missing points, or a wrong unit." => "Look at the gap; the contact itself is solved to its tolerance.";
    "W415" "ridges that cannot leak": "The roughness that is left in the contact is above three smooth films. The ridges of the model go across the whole face and oil cannot pass beside them, so that its mean film is too thick and its friction too low." => "Take it as no referee here: measurement decides.";
    "W416" "full film off its formulas": "A film that carries the whole load was taken from its elastohydrodynamic solution, and central film, minimum film or friction differ by more than 10 % from the formulas of the case." => "Nothing for this run, which uses the solution. Compare another model.film for runs with formulas.";
    "W417" "traces cover part of the path": "At some positions a contact lies beyond an end of a placed trace; the nearest window on it stands for those." => "Measure longer traces, or check the places given.";
    "W418" "traces not placed": "The place on the flank is known of one trace alone, so windows do not follow from the mesh: both are taken for any place of their flanks." => "Give at for both flanks.";
    "W421" "tip edges are not relieved": "Under load the teeth approach each other by more than 5 um, so unrelieved tip edges touch before A and after E. The load map leaves that out; both loss factors are told." => "Give gears.pinion.tip_relief and gears.wheel.tip_relief, or set model.edge_contact = true.";
    "W422" "contact of lightly loaded cells not resolved": "Cells that carry almost no loss have a contact narrower than the points of the traces resolve. The roughness of the whole traces stands for their windows." => "Measure with a smaller spacing if these cells matter.";
    "W423" "load over the teeth did not settle": "The load map ended its rounds before the loads settled." => "Compare another model.load_distribution, and please report the case.";
    "W424" "stiffness from ISO 6336-1": "The root of a tooth is undercut or cannot be drawn from the rack, so its compliance cannot be computed from its outline." => "Check gears.pinion.dedendum and gears.wheel.dedendum, or choose model.load_distribution = \"iso-stiffness\".";
    "W425" "tips may foul": "A ring with fewer than ten teeth more than its pinion may foul its tips away from the line of action, which is not checked." => "Check the tip clearance on the drawing.";
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
