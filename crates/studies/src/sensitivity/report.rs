//! Report of a sensitivity study: the largest change, a bar for each change, and the changes of the parts.

use asperity::message::Warning;
use asperity::result::loss_band::{Digits, without_interval};
use asperity_core::{Code, Estimate};
use asperity_report::chart::{Axis, Bar, BarChart, Drawing};
use asperity_report::{Cell, Report, StudyResult, Table, Value, columns};

use super::changes::{HEIGHTS, SCANS};
use super::study::{Effect, Sensitivity, SensitivityRow, SensitivitySettings};
use asperity_report::StudySettings as _;

/// Table of the changes.
const TABLE: &str = "sensitivity.csv";

/// Explanation of the numbers.
const NOTE: &str = "In brackets: 5 to 95 % of the change, of what differs between both cases. Other cut-offs leave other lengths of the traces, hence \
    other windows. Tip relief takes load off the ends of the path. The contact of unrelieved tip edges, of which a run warns, is \
    not in these losses. These are answers of the model, not measurements.";

impl StudyResult for Sensitivity {
    const KIND: &'static str = "sensitivity study";
    const NAME: &'static str = "sensitivity";

    fn report(&self) -> Report<'_> {
        Report::new(&self.title, "sensitivity")
            .section("What you can change")
            .verdict(verdicts(self))
            .figures(|| chart(self, true))
            .text([headline(self)])
            .text([of_finish()])
            .on_page()
            .at(&self.conditions)
            .warning(left_aside(self))
            .section("What is not known well")
            .figures(|| chart(self, false))
            .text([OTHER_CONSTANTS])
            .on_page()
            .section("Parts")
            .table(table(self))
            .text(refused(self))
            .method([SensitivitySettings::METHOD, NOTE])
    }
}

/// Sentence on the change of an oil.
const OF_OIL: &str = " Its viscosity is the same.";

/// Constants without a change.
const OTHER_CONSTANTS: &str =
    "The constants of the oil and of the model are components of the interval of asperity run.";

/// A change with its effect.
type Changed<'a> = (&'a SensitivityRow, &'a Effect);

/// Groups of changes that a designer makes; no drawing states the quantities of the others.
const CHANGEABLE: [&str; 3] = ["flanks", "oil", "gears"];

/// The changes with an effect that a designer makes, or the others, the largest first.
fn changes(study: &Sensitivity, is_changeable: bool) -> Vec<Changed<'_>> {
    let rows = study.rows.iter();
    let rows = rows.filter(|row| CHANGEABLE.contains(&row.group) == is_changeable);
    let mut rows: Vec<Changed<'_>> = rows
        .filter_map(|row| Some((row, row.effect.as_ref()?)))
        .collect();
    let size = |(_, effect): &Changed<'_>| effect.difference_w.abs();
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    rows
}

/// The largest saving that a designer can make, and the largest rise of the loss, in words.
fn verdicts(study: &Sensitivity) -> impl Iterator<Item = String> {
    let changes = changes(study, true);
    let largest = move |is_saving: bool| {
        let mut changes = changes.iter();
        let is_of = |(_, effect): &&Changed<'_>| (effect.difference_w < 0.0) == is_saving;
        let (row, effect) = changes.find(is_of)?;
        let what = if is_saving { "saving" } else { "rise" };
        let of_oil = if row.group == "oil" { OF_OIL } else { "" };
        Some(format!(
            "The largest {what} among these changes: {}, {} W, {} % of the loss.{of_oil}",
            named(row),
            difference(effect),
            share(effect)
        ))
    };
    [true, false].into_iter().filter_map(largest)
}

/// Names of the groups that no drawing states.
fn of_uncertain(study: &Sensitivity) -> &'static str {
    if study.rows.iter().any(|row| row.group == SCANS) {
        "boundary layer, filters and use of the scans"
    } else {
        "boundary layer and filters"
    }
}

/// The changes that a designer makes, or the others, over one axis; `None` if no one has an effect.
fn chart(study: &Sensitivity, is_changeable: bool) -> Option<Drawing> {
    let (id, of) = if is_changeable {
        ("sensitivity", "finish, oil and relief")
    } else {
        ("uncertain", of_uncertain(study))
    };
    let bars = changes(study, is_changeable)
        .into_iter()
        .map(|(row, effect)| Bar {
            name: unbroken(&named(row)),
            value: Some(effect.difference_w),
            spread: effect.quantiles_w,
            text: format!("{} W, {} %", change(effect), share(effect)),
        });
    let bars: Vec<Bar> = bars.collect();
    (!bars.is_empty()).then(|| {
        Drawing::Bars(BarChart {
            id: id.to_owned(),
            title: format!("Change of the loss by {of}, with 5 to 95 %"),
            source: TABLE.to_owned(),
            axis: Axis::new("change of the loss", "W"),
            bars,
        })
    })
}

/// The changes of the loss and of its parts, those that a designer makes first, the largest first; "-" where the model refuses the change.
fn table(study: &Sensitivity) -> Table {
    let changed = [true, false].map(|is_changeable| changes(study, is_changeable));
    let changed = changed
        .concat()
        .into_iter()
        .map(|(row, effect)| (row, Some(effect)));
    let refused = study.rows.iter().filter(|row| row.effect.is_none());
    let rows = changed.chain(refused.map(|row| (row, None)));
    let in_words = |text: &str| Cell::shown(with_mu(text), text.into());
    let share = |effect: &Effect| Cell::shown(share(effect), Value::Number(100.0 * effect.change));
    let part = |effect: Option<&Effect>, k: usize| {
        let text = effect.map(|effect| parts(effect)[k].clone());
        let value = effect.map_or(Value::Missing, |effect| effect.parts()[k].into());
        Cell::shown(text.unwrap_or("-".to_owned()), value)
    };
    let table = columns! { (row, effect) in rows;
        text group "of" "" = row.group;
        text change "change" "" = in_words(&row.what);
        text to "to" "" = in_words(&row.to);
        interval difference_w "change of the loss" "W" = Cell::with_ends(
            effect.map_or("-".to_owned(), difference),
            effect.map(|effect| effect.difference_w),
            effect.and_then(|effect| effect.quantiles_w),
        );
        number change_percent "of the loss" "%" = Cell::optional(effect.map(share));
        number film_w "film" "W" = part(effect, 0);
        number lubricated_asperity_w "lubricated asperities" "W" = part(effect, 1);
        number boundary_w "boundary layer" "W" = part(effect, 2);
        number rolling_w "rolling" "W" = part(effect, 3);
        file code = Cell::optional(row.refused.as_ref().map(|refused| refused.code.as_str()));
    };
    table
        .brief(&[
            "of",
            "film",
            "lubricated asperities",
            "boundary layer",
            "rolling",
        ])
        .in_file(TABLE)
}

/// The changes that the model refuses, with the reasons.
fn refused(study: &Sensitivity) -> impl Iterator<Item = String> {
    study.rows.iter().filter_map(|row| {
        let refused = row.refused.as_ref()?;
        Some(format!(
            "{}: {} {}",
            named(row),
            refused.code,
            refused.message
        ))
    })
}

/// The change in words.
fn named(row: &SensitivityRow) -> String {
    let [what, to] = [&row.what, &row.to].map(|text| with_mu(text));
    format!("{what} → {to}")
}

/// A name in which a number stays on the line of its unit.
fn unbroken(name: &str) -> String {
    let units = [" µm", " nm", " mm", " °C"];
    units.iter().fold(name.to_owned(), |name, unit| {
        name.replace(unit, &unit.replace(' ', "\u{a0}"))
    })
}

fn with_mu(text: &str) -> String {
    text.replace(" um", " µm")
}

/// W431, if the case states a gearbox.
fn left_aside(study: &Sensitivity) -> Option<Warning> {
    (!study.left_aside.is_empty()).then(|| {
        let text = format!(
            "losses are of the mesh; other losses of the case are ignored: {}",
            study.left_aside.join(", ")
        );
        Warning::new(Code::W431, text)
    })
}

/// Sentence on the heights.
fn of_finish() -> String {
    let [low, high] = HEIGHTS;
    format!(
        "Heights are multiplied by {low} and {high}. Another finish can change the loss by more: asperity compare."
    )
}

/// The loss that the changes are relative to.
fn headline(study: &Sensitivity) -> String {
    let loss = without_interval(study.loss_w);
    format!("Loss {loss} W, and how it changes.")
}

/// The change \[W\] with its interval.
fn difference(effect: &Effect) -> String {
    match effect.quantiles_w {
        Some([low, high]) if low < high => {
            digits(effect).signed_interval(Estimate::new(effect.difference_w, [low, high]))
        }
        _ => change(effect),
    }
}

/// The change \[W\].
fn change(effect: &Effect) -> String {
    digits(effect).signed(effect.difference_w)
}

/// The change in percent.
fn share(effect: &Effect) -> String {
    let whole = (effect.difference_w / effect.change).abs();
    let half = if whole.is_finite() {
        100.0 * half_width(effect) / whole
    } else {
        1.0
    };
    Digits::of_uncertainty(half).signed(100.0 * effect.change)
}

/// The parts of the change with the digits of the total, to which they add up.
fn parts(effect: &Effect) -> [String; 4] {
    let digits = digits(effect);
    let parts = effect.parts();
    let steps = digits.parts(digits.steps(effect.difference_w), &parts);
    std::array::from_fn(|k| digits.signed_text(steps[k]))
}

fn digits(effect: &Effect) -> Digits {
    Digits::of_uncertainty(half_width(effect))
}

/// Uncertainty that determines the digits of a change \[W\]: half of its interval, or a fiftieth of the change.
fn half_width(effect: &Effect) -> f64 {
    const LEAST_W: f64 = 0.1;
    let least = 0.02 * effect.difference_w.abs();
    let half = effect
        .quantiles_w
        .map_or(0.0, |[low, high]| 0.5 * (high - low));
    half.max(least).max(LEAST_W)
}
