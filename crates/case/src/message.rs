//! Codes of errors and warnings, and what each means.
//!
//! Codes are stable: E1xx files, E2xx cases, E3xx solutions, W1xx about a file, W4xx about a result.
//! No option of a command is named here: an explanation lists its settings, and the program that shows it names them.

use std::borrow::Cow;
use std::collections::BTreeSet;

use asperity_core::remedy::Setting;
use serde::{Deserialize, Serialize};

/// A warning about a result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Warning {
    /// Stable code, `W402`.
    pub code: Cow<'static, str>,
    /// Values found and expected.
    pub text: String,
    /// Component of the uncertainty that the warning is about, if its code leaves it open.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub about: Option<Subject>,
}

/// Component of the uncertainty that a warning can be about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum Subject {
    /// Pressure-viscosity coefficient of the oil.
    PressureViscosity,
    /// Tip relief that is not stated.
    TipRelief,
    /// Error of the fast model.
    FastModel,
    /// Sampling of the flanks.
    Sampling,
    /// Lay beyond the records of mixed lubrication.
    Lay,
}

impl Warning {
    /// A warning of this code.
    pub fn new(code: &'static str, text: impl Into<String>) -> Self {
        Self {
            code: code.into(),
            text: text.into(),
            about: None,
        }
    }

    /// The warning with `more` behind its text.
    #[must_use]
    pub fn with(&self, more: &str) -> Self {
        Self {
            code: self.code.clone(),
            text: self.text.clone() + more,
            ..*self
        }
    }
}

/// Codes of the warnings about an input outside of a fitted, tested or usual range.
const OUTSIDE: [&str; 6] = ["W401", "W402", "W403", "W405", "W428", "W443"];

/// The column `outside` of a table of cases: distinct codes of warnings about an input outside of its range, with spaces.
///
/// ```
/// use asperity_case::message::outside_codes;
/// assert_eq!(outside_codes(["W443", "W409", "W401", "W401"]), "W401 W443");
/// ```
pub fn outside_codes<'a>(codes: impl IntoIterator<Item = &'a str>) -> String {
    let codes = codes.into_iter().filter(|code| OUTSIDE.contains(code));
    let codes = Vec::from_iter(BTreeSet::from_iter(codes));
    codes.join(" ")
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
    /// Cause of the message.
    pub meaning: &'static str,
    /// General advice; empty if every message of the code has its own.
    pub remedy: &'static str,
    /// The settings that the remedy is about.
    pub settings: &'static [Setting],
}

/// The explanation of `code`, in upper or lower case.
///
/// ```
/// assert!(asperity_case::message::explain("w402").is_some());
/// assert!(asperity_case::message::explain("W999").is_none());
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
    "E102" "no rows of numbers": "No line of the file is a row of numbers, or the requested columns do not exist." => "Check that the export is of the profile and not of the report, or state the columns." [Columns];
    "E103" "a file cannot be opened": "The system refused to open a file that is to be read." => "Check the name and the permissions; names in a case are relative to the case file.";
    "E104" "no unit": "Neither a header nor a unit row names the unit, and the values fit more than one." => "State the unit of the heights (um, nm or mm) and of the positions." [ZUnit, XUnit];
    "E105" "positions do not increase": "The column of positions goes backwards or repeats a value, so the points are not a trace." => "Export one trace per file, or state the right columns." [Columns];
    "E106" "too few points": "The file holds fewer points than a roughness evaluation (100) or a contact needs." => "Export the whole trace.";
    "E107" "missing points": "Some heights are missing or not numbers. Missing points are never filled silently." => "Have the gaps interpolated by straight lines; the result records how many points were filled." [Gaps];
    "E108" "format known but not read": "The file is in a format that this version does not read." => "Export the profile as text or CSV from the instrument's software.";
    "E109" "uneven spacing": "The spacing of the positions varies by more than rounding explains." => "Have the trace resampled by straight lines, or state the spacing, which then replaces the positions." [Uneven, Spacing];
    "E110" "spacing not known": "The file contains heights only, so the spacing of the points must be stated." => "State the spacing of the points, e.g. 0.5 um." [Spacing];
    "E111" "a row with a different number of columns": "A line has more or fewer columns than the others." => "Correct or remove the line.";
    "E112" "columns unclear": "The file has several columns and no header that names position and height." => "State the columns of position and height." [Columns];
    "E113" "commas unclear": "The commas may separate columns or be decimal signs, and both readings make sense." => "State the separator and the decimal sign, or export with semicolons." [Separator, Decimal];
    "E114" "unknown unit": "The header names a unit that is not one of m, mm, um, nm, angstrom, inch, mil, uin." => "Convert the file, or state the unit if the header is wrong." [ZUnit, XUnit];
    "E115" "separator does not fit": "The file cannot be read with the separator that was stated." => "Leave the separator out, or state what separates the columns." [Separator];
    "E116" "impossible trace": "The numbers are not a profile: they have no extent, or an absurd one." => "Check units, columns and spacing." [ZUnit, XUnit, Columns, Spacing];
    "E117" "damaged file": "The file breaks the rules of its own format: a header that cannot be read, or another number of heights than it says." => "Export it again, or as text; a file that was cut off in transfer is the usual cause.";
    "E118" "file too large": "The file, one of its lines, or its unpacked content is larger than any profile." => "Export a single profile.";
    "E119" "several profiles": "The file holds several profiles, and none was chosen." => "State the number of one of them, counted from 1, or in a case how many of them are taken. Their mean has the form, and the roughness only of ridges across all of them." [Row, Rows];
    "E120" "the trace cannot be prepared": "Form removal or filtering is not possible on this trace, usually because it is shorter than the cut-off or too coarsely spaced for it. The robust filter has no line below a feature that is wider than the cut-off and deep." => "Measure a longer trace, or choose another cut-off; 0.25 mm is usual on gear flanks, 0.08 mm for short traces. Where the robust filter fails, use the plain one, or the part of the trace without the feature." [Cutoff, NoiseCutoff];
    "E121" "spacing too coarse for the contact": "Fewer than 20 points fall on one Hertz half-width, so the contact cannot be resolved. A spacing up to a twentieth of the half-width is accepted; half a micrometre also resolves the waves that the default cut-off keeps." => "Measure with a finer spacing; with a stylus 0.5 um is usual. Where far fewer points are left, check the units of torque and sizes: a small load has a narrow contact.";
    "E122" "trace shorter than the contact window": "The prepared trace does not cover the window of the contact and, with several offsets, 1.6 half-widths more by which the windows can differ." => "Measure a longer trace, choose a shorter cut-off (the filter drops its ends), or reduce model.window.";
    "E123" "the traces are outside the contact": "Placed by at, from and the roll lengths of their files, the traces are in contact on less than a third of the loss along the path of contact." => "Check at, its unit and from of both flanks, or leave at out: the traces then represent any place on the flank.";
    "E130" "positions are roll lengths": "The positions are roll lengths or roll angles from a gear inspection machine, not distances along the flank." => "State the base radius of the gear, d_b/2, so that they can be converted." [BaseRadius, Abscissa];
    "E131" "heights that no flank has": "The root mean square slope of the trace is above 2 or below 1e-6, or a single step is steeper than 5: the unit is wrong, a marker value denotes missing points, or the trace has spikes of dust or lost light." => "State the unit of the heights, write NaN in place of the marker, or have the spikes replaced, as the message says." [ZUnit, Gaps, Outliers];
    "E132" "the REXS file cannot be used": "The file is not REXS 1.0 to 2.0, is damaged, or lacks what a case needs; the message names the component and the attribute." => "Export the gearbox again, with the attribute named.";
    "E133" "no such stage": "The stage or load case is not in the REXS file, or the stage does not consist of cylindrical gears." => "List the stages of the file first.";
    "E134" "a rig's table cannot be used": "A row or column of the table of measured points is missing or has another unit, or a standard deviation or scope is missing; without them a point has no weight." => "Correct the rows that are named. Every row needs torque_nm, speed_rpm, temperature_c, loss_w (or torque_loss_nm), sigma_w and includes.";
    "E135" "measured points are outliers": "Rows are off the fit of all others by more than ten times their standard deviation: a wrong reading, a standard deviation that is far too small, or a case that is not that of the rig." => "Correct or remove the named rows, or state their real sigma_w; if many are named, check case, scope and unit.";
    "E136" "a gap in the positions": "Two neighbours of an uneven trace are more than ten mean steps apart. Resampling would draw a straight line where points are missing." => "Export the whole trace, or only its part before or after the gap.";
    "E137" "no trace of this name": "A pattern names the traces of a flank, and no file has such a name, or no folder is known to search in." => "Check folder and pattern: * stands for any characters of a file's name and ? for one. Names are relative to the case file.";
    "E138" "a table of losses cannot be used": "The file is not a table of loss torques: a column is missing, a cell is not a number, a loss is negative, or the rows do not form a complete grid of torques and speeds at each temperature." => "Give the columns speed_rpm and loss_torque_nm and, if the loss depends on them, torque_nm and temperature_c, with a row for every combination.";
    "E139" "a range outside of the trace": "The range of a trace that is to be used ends beyond its last point. The message states the length of the trace." => "";
    "E140" "a file changed since the case was read": "A case is stored with the content of every file that was read for it, and a file on disk is no longer the one that the case was read from." => "Read the case again.";
    "E141" "roughness averaged out": "The trace is the mean of the lines of a surface, and its Rq is below .9 of that of eight of its lines: the roughness does not run across the whole surface, and the mean of its lines has lost it." => "Take several lines of the surface. The mean is a trace of ground flanks whose ridges run across all of it." [Rows, Line];
    "E201" "the case file cannot be opened": "The system refused to open the case file." => "";
    "E202" "the case file is not TOML": "The text breaks the rules of TOML (or of JSON, for a .json file), or is not text in UTF-8." => "Look at the line named: each line is key = value, text is in quotation marks, the encoding is UTF-8.";
    "E203" "unknown key": "The case file has a key that does not exist, or a study a key or column." => "Correct the spelling or remove the key.";
    "E204" "a value cannot be read": "A value is missing, of the wrong kind, or lacks its unit. Quantities are text with a unit: \"1.3 mm\"." => "Write the value as the message shows.";
    "E205" "keys or options do not go together": "Two keys or options exclude each other, one needs another that is missing, or the command does not work with a choice of the case: the gradient of the loss, for example, is known for the default model only. The message names them." => "";
    "E206" "the gear pair cannot mesh": "The geometry given leads to interference, pointed teeth or too short a path of contact, or does not determine the gears." => "Check teeth, profile shifts, centre distance and tip diameters.";
    "E207" "pressure-viscosity coefficient is impossible": "The value is orders of magnitude away from that of any oil, usually because of the unit." => "Mineral oils have 15 to 25 1/GPa, that is 1.5e-8 to 2.5e-8 m2/N.";
    "E208" "the oil is incomplete": "The data of the oil are insufficient, or contradict each other." => "Give the kinematic viscosity at 40 and 100 °C, density and base_oil, or the name of an oil in the library.";
    "E209" "a number outside its domain": "A number in the case or on the command line is impossible, such as a negative module." => "Correct the value named.";
    "E210" "unknown tag or code": "No equation has that tag, or no message has that code." => "Look the name up in the list.";
    "E211" "the tolerance is too large": "A contact solved to a tolerance above 1e-4 can have grossly wrong pressures, and saves hardly any time." => "Give a tolerance of at most 1e-4; 1e-8 is the default.";
    "E212" "a number beyond physical sense": "The value, or a quantity that follows from it and other keys, is beyond that of any gear drive, usually because of a wrong unit or a misplaced decimal point." => "Check the unit; the message names the usual range.";
    "E213" "the command line cannot be read": "A command, an option or an argument is unknown, missing or of another form, or two options exclude each other." => "";
    "E220" "no such preset": "No gears, steel or oil of the library has this name." => "Take one of the names that the message lists.";
    "E222" "an impossible part of the gearbox": "A number of a seal, a bearing or the oil jet is outside its domain, is missing for this kind of bearing, or belongs to another kind. The constants of a bearing are those of its catalogue, in the units printed there." => "Correct the number that is named.";
    "E223" "a finish without a recipe": "A flank of this finish is known by roughness values only, and surrogates can be generated of ground and superfinished flanks only." => "Give the trace of the flank: surface.pinion.file, surface.wheel.file.";
    "E301" "a position did not converge": "The contact at a mesh position did not reach its tolerance. No efficiency is reported." => "Loosen model.tolerance, or look for spikes in the profile.";
    "E302" "the surface is too soft for the load": "The flow pressure is below what the load needs, so no pressure distribution can carry it." => "Check material.pinion.flow_pressure and elastic_limit; case-hardened steel has 6 to 8 GPa and 1.5 to 2 GPa, respectively.";
    "E303" "a measured profile is needed": "The rough contact presses two profiles together, but a flank is given by roughness values only." => "Give surface.pinion.file and surface.wheel.file. A run in the corrected formulation also takes roughness values; the rough contact and its ridges need traces of both flanks.";
    "E304" "the marching did not reach the load": "Lowering the surfaces into each other step by step did not reach the load within the numerical error." => "Reduce model.delta_step or raise model.numerical_error.";
    "E305" "outside the model": "The values at a mesh position are outside the domain of an equation." => "Check the value named against the ranges in docs/EQUATIONS.md, or choose another law in model.";
    "E306" "the flank would yield under the film": "The flow pressure is below one and a half times the Hertz pressure, which the film reaches without asperity contact." => "Set material.pinion.flow_pressure to the indentation hardness: 6 to 8 GPa for case-hardened steel.";
    "E307" "the lubricated contact did not converge": "Newton's method found no solution of the lubricated contact, or a time step failed at its smallest length. No result is reported." => "Use more cells or smoother profiles, give a flow pressure if the surfaces yield, or choose another viscosity law.";
    "E308" "a state beyond physical sense": "Pressure, film, speed, friction or flash temperature at a mesh position are beyond what is physically possible, so an efficiency would be meaningless." => "Check the values in the case, starting with the unusual ones.";
    "E309" "cases of a study are missing": "Some cases of a study are in no finished part, because a shard was not run or was stopped." => "Run the missing shards; finished cases are not run again.";
    "E310" "the points do not determine the boundary layer": "The thickness of the boundary layer determines the part of the load with boundary friction in asperities that keep the film of the inlet; those that come into contact past it have at least the part model.inner_boundary, whatever the layer is. It affects the loss only where speed and temperature lead from the boundary layer into the full film; at one temperature it cannot be distinguished from film traction." => "Measure the points that the message names as missing, or hold the boundary layer. A design for the limits of the rig, its largest torque and speed and its temperatures, proposes points and reports whether they suffice.";
    "E311" "the bulk temperature does not converge": "The iteration between the loss and the bulk temperature finds no equilibrium." => "Check operation.bulk and the oil, or state operation.bulk_temperature in place of operation.oil_temperature and the law.";
    "E312" "one pair of traces is needed": "The case has several traces of a flank, and the requested result needs a single pair of traces." => "Name one trace of each flank, as surface.pinion.file, and leave traces out.";
    "E313" "the table of losses does not reach the operating point": "Losses are interpolated in the table and never extrapolated." => "Extend the table to torque, speed and temperature of the case. A torque is negative if the wheel drives; gearbox.temperature sets the temperature if it is not the operating temperature.";
    "E314" "the cycle leaves the map": "More than 5 % of the energy of the cycle is at torques or speeds outside of the map, where its losses are extrapolated at the ratio of loss to torque of its edge." => "Extend the map to the torques and speeds of the cycle, including negative torques if the wheel drives, or accept the extrapolation.";
    "E315" "the model does not explain the measured points": "The residuals of the best fit are more than three times the stated standard deviations, so its values and bands would mean nothing. No calibrated values are written." => "Check case, traces, oil, scope and units, starting with the rows named; state the real sigma_w if the rig is less accurate than stated.";
    "E316" "too few measured points": "At least three rows more than fitted parameters are required: otherwise the residuals cannot confirm the stated errors." => "Measure more points, or hold parameters.";
    "E317" "a traction curve cannot be read": "A column of a traction curve is missing or has another unit, two columns contradict each other, or a temperature is not the one of the oil." => "Correct what is named. A table needs load_n, mean_speed_m_s, slide_roll_percent (200 is pure sliding), temperature_c and traction.";
    "E318" "too few traction points": "The law of the film describes points with a film of at least three roughnesses, a slide-to-roll ratio of at least 0.5 %, surfaces heated by at most 40 K and a Hertz pressure of at least 0.4 GPa. Six of them are the fewest for a fit." => "Check the units of the columns first: loads in N (or max_pressure_gpa), slide-to-roll ratios in per cent, speeds in m/s. Then measure faster or colder where the film is too thin, slower where the surfaces are too hot; state the roughness of the specimens.";
    "E319" "the film law does not explain the traction curves": "The residuals are too large by both laws of pressure, a machine would have to be further out of calibration than machines are, or the constants are those of no known oil. No constants are written." => "Check the viscosity of the oil, the roughness, the temperatures and the sign and unit of the slide-to-roll ratio, starting with the points named. Compare the readings with the traction expected of an oil of the family: curves far from it are of another law or another quantity. If single readings scatter more than assumed, state their standard deviation, in a column sigma or for all.";
    "E320" "a file without heights": "The file is of a known format but contains something other than heights on an even grid: an image, a spectrum, a thickness, or points with individual positions." => "Export the heights from the instrument's software.";
    "E321" "several arrays": "The MATLAB file holds several arrays, and none is named z, heights, height or profile." => "Save only the heights, or name them z.";
    "E322" "the Stribeck curves give no boundary friction": "Boundary friction is the friction of rubbed specimens where the film is at most a fifth of the roughness, and does not depend on the speed there. Four points at two speeds are the fewest. New specimens may have half of the friction." => "State the time of rubbing, in a column rubbing_s or for each file; measure slower or hotter; state the roughness of the specimens.";
    "E323" "the finish does not decide about the loss": "A call-out limits the roughness so that lots of flanks meet a stated loss. Smooth flanks (Ra 0.01 um) lose more than the stated loss, or the roughest ones considered (Ra 1.6 um or more) lose less." => "";
    "E401" "a result cannot be written": "The system refused to write, or the place is taken by something that is not a result." => "Choose another place or name, create its folder, or free some space.";
    "E402" "not a result": "The file or folder named is not the result of a run, or lacks the requested data." => "Name a result folder, e.g. results/e-drive, or its result.json.";
    "E501" "internal fault": "A consistency check within the program failed. This is a fault of the program, not of the input." => "Please report it with the case file.";
    "E502" "cancelled": "The program that had started the work, or Ctrl-C, cancelled it; there is no result. A sweep has written the rows of its finished cases." => "Start it again.";
    "W111" "a unit was assumed": "The file does not name a unit, and only one is plausible." => "State the unit to be sure." [ZUnit, XUnit];
    "W112" "form not removed": "The trace still contains the shape of the flank, so its parameters do not describe roughness." => "Remove the form, e.g. with poly2." [Form];
    "W113" "spacing coarse for the noise filter": "The spacing is above a fifth of the cut-off lambda_s, so the filter is poorly sampled." => "Choose a longer noise cut-off lambda_s, or measure with a finer spacing." [NoiseCutoff];
    "W114" "few sections": "The evaluation length holds fewer than five cut-offs." => "Measure a longer trace or choose a shorter cut-off.";
    "W115" "missing points filled": "Missing heights were bridged by straight lines, as requested." => "Measure again if there are many of them or they lie in one place.";
    "W116" "trace reversed": "The positions decrease along the file, so the trace was read from its other end." => "Nothing, unless the direction along the flank matters: then set mirrored in the case.";
    "W117" "stated spacing differs": "The spacing stated is not that of the position column; the stated one was used." => "Leave the spacing out unless the column is wrong." [Spacing];
    "W118" "already filtered": "The file states that its heights are a roughness profile, and filtering it again changes it." => "Set no cut-off, or export the unfiltered profile." [Cutoff];
    "W119" "flanks spaced differently": "The traces of pinion and wheel have different spacings; the coarser one was resampled by straight lines." => "Measure both flanks with the same spacing.";
    "W120" "checksum differs": "A checksum in the file does not match its content: the file was changed after the measurement, or the program that wrote it computes the checksum differently." => "Compare with the original; the heights are used as read.";
    "W121" "trace aborted": "The header states a nominal length that was not traced in full. The spacing follows from the traced length." => "Measure again if the whole length is needed.";
    "W122" "spacing from line 1": "Line 1 is written differently from the rest and is taken as the spacing in um, as in NPL text profiles." => "State the spacing to be sure." [Spacing];
    "W123" "length rounded": "The spacing follows from a length that is printed with few digits." => "State the spacing to be exact." [Spacing];
    "W124" "heights that no flank has": "The root mean square slope of the trace is above 2 or below 1e-6, or a single step is steeper than 5: the unit is wrong, or a marker value denotes missing points. A case refuses such a flank." => "State the unit of the heights, or write NaN in place of the marker." [ZUnit, Gaps];
    "W125" "uneven spacing": "The positions are off an even grid by 2 to 25 % of a spacing; the points were taken as evenly spaced, so slopes are wrong by as much." => "Have the trace resampled." [Uneven];
    "W126" "trace resampled": "The positions were unevenly spaced; the heights were interpolated linearly onto an even grid, as requested. The message states the distance of the points of the file from the resampled trace." => "Nothing, unless the heights moved by a noticeable part of the roughness: straight lines flatten the shortest wavelengths.";
    "W127" "roll lengths converted": "The positions were roll lengths or angles and are now distances along the involute." => "Check the base radius.";
    "W128" "involute does not fit": "A parabola or cubic remains after the involute was removed: the flank is crowned, or its base radius or roll length is not the one stated." => "Check base radius and roll length; the message names the roll length that fits best.";
    "W129" "cut-offs differ from the file's": "The file states the cut-offs that the instrument was set to, and the case states others, so the parameters differ from those of the instrument." => "Leave surface.cutoff and surface.noise_cutoff out of the case to filter as the instrument did.";
    "W130" "outliers replaced": "Points farther from the running median than surface.outliers (in a case) or the option allows were replaced by straight lines between their neighbours." => "Nothing, if they are dust or lost light. If the surface has such peaks, raise the limit." [Outliers];
    "W131" "fewer heights than stated": "The header of the file states more points than the file holds: the trace was aborted, or the file was cut off." => "Export the file again, or measure again, if the whole trace is needed.";
    "W132" "few sections dominate the trace": "The highest section of the trace at the usual cut-off of 0.25 mm has several times the median Rz of all: more than 4.4 + 0.7 ln n for n sections, which less than one ground flank in a thousand reaches. The trace crosses a groove, a pit or a step, or reaches beyond the edge of the flank, and its parameters are not those of a finish." => "Use only the sound part of the trace, which the message names, unless the whole flank has such features." [Range];
    "W201" "outside the usual range": "A number in the case, or a quantity that follows from several, such as the face width over the pitch diameter, is outside the usual range for gear drives. It may be right, but a wrong unit is more likely." => "Check the unit and the decimal point.";
    "W202" "symbols read as keys": "The case file has symbols of a gear drawing in place of keys; each was read as the key named." => "Nothing, if the keys are the ones meant.";
    "W203" "a key by its former name": "The case states a key by a name of an earlier version, which is still read with its former meaning." => "Rename the key as the message says.";
    "W204" "planets cannot be equally spaced": "Equally spaced planets mesh with sun and ring only if the sum of the tooth numbers of sun and ring is a multiple of the number of planets." => "Check the tooth numbers and the number of planets. The losses of a set whose planets are not equally spaced are the same.";
    "W320" "mean of a surface": "The trace is the mean of the rows or columns of a surface. Roughness that does not run across all of them is averaged out, so its parameters are smaller than those of a single line." => "Take single lines for roughness parameters, the mean for the form." [Row, Line];
    "W321" "measured on a replica": "The file says that a replica was measured, so that peaks and valleys have changed places." => "Have the heights turned." [Invert];
    "W322" "the unit of the file is overridden": "A unit was stated for a column whose unit the file states too, and they differ. The stated one is used." => "Leave the unit out, unless the file is known to be wrong." [ZUnit, XUnit];
    "W323" "a stated unit is not used": "A unit was stated for a file that has scales and units of its own in its header. The lengths are those of the header." => "Leave the unit out." [ZUnit, XUnit];
    "W324" "positions kept": "The points of the trace are uneven and were written with their positions. Programs that assume even spacing read another trace." => "Have the trace resampled if the file has to be even." [Uneven];
    "W325" "the header of a profile is contradicted": "The header of the file states a spacing or a base radius that differs by more than 1 % from the x column or from the stated value." => "Check which one is right, and state it." [Spacing, BaseRadius];
    "W326" "empty rows left out": "Rows of the table hold neither a position nor a height, as some programs write behind an aborted trace. They were left out." => "None needed.";
    "W327" "equal heights": "All heights of the trace are equal, so it has no roughness: a run takes the flank as perfectly smooth." => "Export the trace anew, unless a smooth flank is meant: columns of position and height may be confused, or the heights have too few digits.";
    "W328" "depths turned into heights": "The file names its values depths, which grow into the material. The program works with heights, which point out of it, so the values were turned." => "State the sign, which also confirms it." [Invert];
    "W401" "outside a fitted range": "A correlation was used outside the data it was fitted to, so its value is extrapolated: slightly beyond a limit it changes little, far beyond it may be wrong. A first screen states what it is worth, if it is a component of the interval of the loss." => "State the value if you know it, as lubricant.pressure_viscosity for the fit of Gold; otherwise compare the result with other laws, or choose a law fitted to this range.";
    "W402" "equivalent friction implausible": "The mean friction coefficient that explains the loss is outside 0.01 to 0.12, the range of lubricated steel." => "Check the roughness (form removed? units?) and the oil. In the paper formulation look at model.position: at the pitch point C nothing slides.";
    "W403" "an input held at the end of a range": "A fitted law is meaningless beyond its fitted range, so its input was held at the end of that range: the roughness in Xu's law, whose exp(exp S) diverges above S = 0.6 um, or the speeds and loads of Gupta's thermal factor. The warning names law and input." => "Choose another law for this input; for Xu's, model.clamp_roughness = false shows the law as printed.";
    "W404" "one trace for both flanks": "Both flanks use the same trace, so their roughness is correlated and S = √(Rq1² + Rq2²) is not exact." => "Measure both flanks.";
    "W405" "yield below the surface": "The contact pressure makes the material yield below the surface (p0 > 1.79 × the elastic limit). Plastic flow in the bulk is not modelled." => "Check elastic_limit; ground gears are case-hardened (1.5 to 2 GPa).";
    "W406" "few asperities": "Fewer than five asperities reach into the peak zone; their mean radius is uncertain." => "Use a longer trace or a wider window.";
    "W407" "few independent windows": "The traces are hardly longer than the window of the contact: the offsets use much the same part of the traces. The sampling error then is mostly that expected of like flanks." => "Measure longer traces, or choose a shorter cut-off (the filter drops its ends)." [Cutoff];
    "W408" "regime without a profile": "A flank is given by roughness values only and the chosen law of the load share takes the values themselves, so the rough contact was not computed. Without rpk and asperity_radius the classical film ratio is used." => "Leave model.load_share out: the contact is then solved on surrogate flanks. Give a measured profile for contact pressures, plasticity and running-in.";
    "W409" "asperities yield": "The contact reaches the flow pressure: expect running-in. The plastic work of one pass is reported separately from the efficiency." => "Set model.run_in = true: the run then also prints the loss of the flanks run in.";
    "W410" "stress below asperities exceeds the elastic limit": "The von Mises stress under single asperities exceeds the elastic limit, a few micrometres below the surface. Nearly all contacts of ground flanks do so before running-in; it is not a rating of pitting. At the first offset of a position this is judged from the stress field, at the others from the pressure at which a line contact first yields. Plastic flow below the surface is not modelled; running-in flattens the asperities concerned." => "Nothing for ground flanks as made. Set model.run_in = true for the loss of the flanks run in; a table [micropitting] rates the gears against micropitting.";
    "W411" "no peaks under the contact": "The profile windows in contact have no peaks above the core of the profile, so Lambda* is undefined; the load share, or the regime of the paper's formulation, followed from the classical film ratio." => "Check the trace: a regular pattern (feed marks) has no peaks in the sense of ISO 13565-2.";
    "W412" "no sliding at the paper's position": "The paper's formulation uses one position for the whole mesh; at the pitch point there is no sliding, so there is no sliding loss." => "Set model.position between 0 (A) and 1 (E), or use the corrected formulation.";
    "W413" "the contact runs into the end of the window": "The pressure is not zero at a free end, so the contact extends beyond it; the pressures are those of a strip that ends there." => "Widen the gap on that side, or lower the load.";
    "W414" "the gap spans far more than the deformation": "The undeformed gap spans more than 1000 times the deformation of the bodies: an outlier, a marker value for missing points, or a wrong unit." => "Check the gap; the contact itself is solved to its tolerance.";
    "W415" "ridges that cannot leak": "The roughness that remains in the contact exceeds three smooth films. The ridges of the model run across the whole face width and oil cannot pass round them, so the mean film is too thick and the friction too low." => "Do not use this solution as a reference here; rely on measurements.";
    "W416" "full film differs from the formulas": "A film that carries the whole load was taken from its elastohydrodynamic solution, and central film, minimum film or friction differ by more than 10 % from the formulas of the case." => "Nothing for this run, which uses the solution. For runs with formulas, try another model.film.";
    "W417" "traces cover part of the path": "At some positions a contact lies beyond an end of a placed trace; the nearest window on the trace is used there." => "Measure longer traces, or check the stated places.";
    "W418" "traces not placed": "The place on the flank is known for one trace only, so the windows do not follow from the mesh: both traces represent any place on their flanks." => "Give at for both flanks.";
    "W419" "the fit does not explain the scatter": "The residuals of the measured points drift with the order of measurement, or the optimum is outside the usual ranges: the rig changed, or the model lacks something." => "Check the residuals over speed, torque, temperature and order; the bands are too narrow.";
    "W420" "few data for the bands": "There are few assemblies, so their scatter follows from the prior only, flanks in several states are fitted together, or rows repeat others, which narrows the bands if they were copied." => "Measure more assemblies; fit fresh and run-in flanks apart, each with its own traces; leave copied rows out.";
    "W421" "tip edges are not relieved": "Under load the teeth approach each other by more than 5 um, so unrelieved tip edges touch before A and after E. The load map neglects this; both loss factors are printed." => "Give gears.pinion.tip_relief and gears.wheel.tip_relief, or set model.edge_contact = true.";
    "W422" "contact of lightly loaded cells not resolved": "In cells that contribute almost no loss, the contact is too narrow for the spacing of the traces. The roughness of the whole traces is used there instead of that of the windows." => "Measure with a smaller spacing if these cells matter.";
    "W423" "load over the teeth did not settle": "The load map used up its iterations before the loads settled." => "Try another model.load_distribution, and please report the case.";
    "W424" "stiffness from ISO 6336-1": "The root of a tooth is undercut or cannot be drawn from the rack, so its compliance cannot be computed from its outline." => "Check gears.pinion.dedendum and gears.wheel.dedendum, or choose model.load_distribution = \"iso-stiffness\".";
    "W425" "tips may foul": "A ring with fewer than ten teeth more than its pinion may foul its tips away from the line of action, which is not checked." => "Check the tip clearance on the drawing.";
    "W426" "a second, hotter equilibrium": "Friction that rises with the temperature can maintain a second, hotter equilibrium, or heat the flanks beyond the range of the oil's laws: an iteration started 60 K above the oil does not end at the bulk temperature. All numbers are for the bulk temperature." => "Check the loss over the temperature, as asperity map shows it; a better cooled mesh has a single equilibrium.";
    "W427" "traced teeth left out": "The traced teeth of both flanks make more than 64 pairs, so as many teeth of each flank are paired as make 64 pairs: the first of a list, rows of a surface spread evenly." => "State the most important teeth first, or fewer teeth or rows.";
    "W428" "density outside the fitted range": "Modulus and strength of a sintered steel were taken from its density by relations fitted to 6.7 to 7.4 g/cm3, and the density lies outside." => "Give young, poisson and elastic_limit as measured.";
    "W430" "cases of a sweep cannot be run": "The cases, of a large study the corners of its axes and a sample, were resolved before the first was run, and some of them are refused; each will be a row without results, with its code." => "Stop and correct the study if they are not meant to fail. A plan of the study lists them without running it.";
    "W431" "losses outside the mesh left out": "The case states losses of its gearbox, and the numbers here are for the mesh only." => "Nothing, if the mesh is meant; asperity run adds the gearbox.";
    "W432" "outside of the micropitting specification": "ISO/TS 6336-22 was made from external gears of 3 to 11 mm module at 8 to 60 m/s and holds for virtual contact ratios below 2.5 and pressure and helix angles up to 25 degrees. The gears or their operation lie outside." => "Compare the specific film with your own tests of such gears only; it is not a rating.";
    "W433" "contact on the fillet": "The tip of the mating gear reaches below the involute that the tool has left, into the fillet: the gears interfere, or rub where no law of the model is valid. The path of contact is still evaluated to its end." => "Check addendum, tip diameters, dedendum and fillet radius on the drawing: shorten the tips, or state the root as it is cut.";
    "W434" "form separated above the cut-off": "The relief of a gear is taken from its trace. Waves shorter than eight half-widths of the contact do not separate the teeth, so form and roughness are separated there, above the requested cut-off, and the roughness contains the longer waves as well." => "Nothing, or set surface.cutoff to at least the length named, so that it does not change with the torque.";
    "W435" "elastic record above the flow pressure": "The surfaces of a record of mixed lubrication are elastic, or yield only above the strength of the hardest steel, and the pressure passes 7 GPa, the indentation hardness of case-hardened steel. Real flanks yield there: their pressures, the load on thin films and the friction are lower." => "Limit the pressure to the flow pressure of the surfaces: material.pinion.flow_pressure in a case.";
    "W436" "the boundary layer is held in the design": "Within the limits of the rig no points identify the boundary layer. The design is for the other parameters, and the boundary layer keeps its default and range." => "Hold the boundary layer in the calibration on these points too. If the rig reaches further, state its largest torque and speed and its temperatures.";
    "W437" "finish not known": "Ra of a flank without a trace lies between superfinished and ground flanks, and no finish is stated. Half of the surrogates are of each." => "State surface.finish.";
    "W438" "surrogate flanks": "A flank has no trace. Profiles of its finish are generated and scaled to the stated roughness values, with shapes and, if surface.noise_cutoff is not stated, cut-offs of 12 kinds, and the contact is solved on all of them." => "Measure the flanks: traces narrow the interval of the loss. State surface.finish, surface.noise_cutoff and Rz or Rpk, if there are no traces.";
    "W439" "tip relief not stated": "The drawing of a gear is not known: its tip relief lies between none and the approach of the teeth under the largest load. A run takes the middle, the draws of the loss all of it. Without relief the edges of the tips of external gears carry load too, which a run includes with model.edge_contact = true only." => "State gears.pinion.tip_relief and gears.wheel.tip_relief: \"none\" where there is none, then with model.edge_contact = true, as the message assumes.";
    "W440" "draws of limited precision": "The draws of the loss interpolate evaluations of the case over its constants, and evaluations that they were not fitted to lie further than 2 % off, which is drawn as part of the error of the model; or the losses of draws reach the power into the mesh and were set to it." => "State the largest of the drawn constants, which narrows their range, or read the band as wider by the error named.";
    "W441" "traction fit of limited value": "The constants follow from the traction curves under a condition that is named: few temperatures, many dropped points, a machine out of calibration, an oil unlike its family, stated errors that are too large or too small, or a law of pressure that the points do not decide." => "Measure the points that lack, or read the bands with the condition named.";
    "W442" "stated for the oil as well": "The case, or its table calibration, states a constant or a property of the oil that its oil file states too, or the viscosity of the oil of the library that it names. The value of the case is used." => "Leave one of the two out.";
    "W443" "outside of the traction tests": "The constants of an oil file are used at temperatures or pressures beyond its curves, or the fit left something open that is named. The error of the film friction is larger there." => "Measure the curves that lack, or read the interval with the condition named.";
    "W444" "lay of a surface not used": "The lay of a flank is taken from the surface of its traces: the ratio of the correlation lengths along and across the rows. Here the surface does not show it, because its rows are too few, too short or too far apart, or its ridges run along the traces, which the law of the inlet does not cover." => "Measure an area with rows at least as close as the ridges are long and the area longer than the ridges, or state model.lay.";
    "W445" "profile shifts divided": "The case gives a centre distance and neither profile shifts nor tip diameters. The centre distance determines only the sum of the shifts; it is divided so that the specific sliding of the roots of pinion and wheel is equal at both ends of contact. For seven pairs of the library it gives a loss factor 13 % lower to 2 % higher than the shifts of the drawing, for FZG-A, made to slide unequally, 37 % lower." => "State gears.profile_shift = [x1, x2] of the drawing, or gears.tip_diameter.";
    "W446" "fitted to simulated measurements": "The source in an oil file or in the table calibration declares the measurements as simulated; a rehearsed plan writes such a source. The constants, their intervals and the loss are no evidence about the oil or the drive." => "Fit the constants to measured curves or losses, or use this result only to rehearse the evaluation.";
    "W447" "lines of one surface count as teeth": "Several traces of a flank are lines of one surface. Each is computed as a tooth of its own, with all teeth of the other flank, so the standard error of the mean has the scatter within one flank only." => "Measure other teeth, and name a surface or trace of each in surface.pinion.traces and surface.wheel.traces; state the same number as tooth, and y, for lines of one tooth.";
    "W448" "trace longer than the active flank": "A trace without a known place is longer than the active flank of its gear, so that more than a tenth of it was not measured there; windows of the contact are taken from all of it." => "State the part on the active flank as range of the trace, or the place of the trace by at. If it was measured along the tooth or on a specimen of the same finish, keep it.";
    "W450" "one tooth of a flank traced": "Several teeth of one flank are traced and one of the other, so the standard error of the mean loss leaves out the scatter between the teeth of that flank: it is a lower bound." => "Trace another tooth of the gear named.";
    "W451" "load reached roughly": "The solved contacts carry their load with an error above the 1 % at which the paper stops, within the model.numerical_error that is stated." => "State a smaller model.numerical_error.";
    "W452" "lay beyond the records": "The roughness of the flanks is less drawn out across the motion than that of every record of mixed lubrication that the load share was compared with (lay up to 1/3), and above a lay of 1/6 the contact of lines itself is not confirmed. The loss depends on the lay; its interval has a part from the loss at a lay of 1/6 to that at the lay of the case." => "Measure losses of such flanks on a rig (asperity calibrate), or state the lay that a surface shows in model.lay.";
    "W453" "tips without their alteration": "Tip diameters are not stated, and the profile shifts bring the gears so close together that tips of the addendum alone leave less than four fifths of the usual clearance. Drawings then shorten both tips by the tip alteration of ISO 21771, which lowers contact ratio and loss factor." => "State gears.tip_diameter of the drawing.";
    "W454" "columns of a table not read": "The table of a cycle has columns that are not its time, its torques and speeds, or the speed of its vehicle and the grade of its road. They do not enter the result." => "If one of them is meant, state the names of the columns.";
}
