//! Report of a merged study: each result over each axis, then the effects of all inputs.

use asperity::message::explain;
use asperity_core::numerics::{distinct, mean};
use asperity_core::{Estimate, capitalised, unique};
use asperity_report::chart::{
    Axis, Bar, BarChart, Chart, Drawing, Interval, Line, Series, Tornado,
};
use asperity_report::{OF_MESHES, Report, StudyResult, write_bytes};

use super::columns::{InputColumn, InputValues};
use super::known_columns::DRAWN;
use super::merged::{EffectRow, Merged};
use super::settings::OILS;
use super::words::{Output, between, input_name, table};

/// How the effects are computed.
const METHOD: &str = "Change of a result from the mean of the lowest quarter of an input to the mean of the highest quarter. A choice is \
    compared with the first one. The changes follow from a linear regression on all inputs; in brackets are their 5 and 95 % \
    quantiles, without the errors of the model.";
/// Column of a loss: with its interval the median of the draws.
const LOSS: &str = "loss_w";
/// The ends of its interval.
const ENDS: [&str; 2] = [DRAWN[1], DRAWN[2]];
/// Meaning of the indices of Sobol.
const INDICES: &str = "First index: share of the variance of the result by this input alone. Total index: the same with its \
    interactions. Few samples estimate both roughly; an estimate may exceed 1.";
/// How a study computes intervals, and what a loss without one is.
const NO_INTERVAL: &str = "Losses have every constant at its median. With the columns loss_p05_w and loss_p95_w the study samples the \
    loss that asperity run prints, with its interval.";
/// Numbers that an oil of an axis replaces.
const OTHER_OILS: &str = "A case that names an oil leaves out all other numbers of the oil of the case file, and its calibration.";
/// Next step.
const NEXT: &str = "The command asperity run shows where a single case loses its power; asperity sensitivity lists \
    other changes that lower the loss; asperity evidence lists measurements that narrow its interval.";
/// Content of the charts over the axes.
const OVER_AXES: &str = "Mean of the cases at each value of an axis, and the range of all of them.";
/// Content of the charts of a loss with its interval.
const OVER_AXES_DRAWN: &str = "Median of the loss with its 5 and 95 % quantiles, each the mean of the cases at a value of an axis.";

/// Mark of a bar.
const IN_BARS: &str = "The line in a bar is at the first number of its text.";

impl StudyResult for Merged {
    const KIND: &'static str = "sweep";
    const NAME: &'static str = "sweep";

    fn report(&self) -> Report<'_> {
        let has_effects = self.effects.iter().any(|row| row.effect.is_some());
        let has_indices = self.effects.iter().any(|row| row.indices.is_some());
        let outside = self.outside.iter().map(|(code, count)| {
            let title = explain(code).map_or("", |entry| entry.title);
            let count = if *count == self.cases {
                format!("all {count}")
            } else {
                count.to_string()
            };
            format!("{code} in {count} cases: {title}. A run of a case has the details.")
        });
        let inputs = self.inputs.iter().map(|input| &input.name);
        let constant = self.constant.iter().map(|(key, _)| key);
        let has_oils = inputs.chain(constant).any(|key| OILS.contains(&&**key));
        let has_losses = self.outputs.iter().any(|(name, _)| name == LOSS);
        let has_watts = self.outputs.iter().any(|(name, _)| name.ends_with("_w"));
        let charts = axes(self);
        let is_drawn = self.ends(LOSS).is_some();
        let over_axes = if is_drawn { OVER_AXES_DRAWN } else { OVER_AXES };
        let over_axes = (!charts.is_empty()).then_some(over_axes);
        let mut bars = charts.iter();
        let in_bars = bars.any(|chart| matches!(chart, Drawing::Tornado(_)));
        let mut report = Report::new(&self.title, format!("sweep {}", self.name))
            .section("Results over the axes")
            .verdict(largest(self).or_else(|| extremes(self)))
            .figures(move || charts.clone())
            .text(over_axes)
            .on_page()
            .text(in_bars.then_some(IN_BARS))
            .on_page()
            .text((has_losses && !is_drawn).then_some(NO_INTERVAL))
            .text([match self.failed {
                0 => format!("{} cases.", self.cases),
                failed => format!("{} cases, {failed} without a result.", self.cases),
            }])
            .text((!self.conditions.is_empty()).then(|| format!("At {}.", self.conditions)))
            .text(settings(self))
            .text(has_oils.then_some(OTHER_OILS))
            .on_page()
            .text(outside)
            .text(has_losses.then_some(OF_MESHES))
            .on_page()
            .text(has_watts.then_some(NEXT))
            .on_page()
            .section("Effects")
            .figures(|| {
                let outputs = self.outputs.iter();
                outputs.filter_map(|(name, _)| tornado(self, name))
            })
            .table(table(self));
        if !has_effects {
            report = report.in_folder();
        }
        report
            .method(has_effects.then_some(METHOD))
            .on_page()
            .method(has_indices.then_some(INDICES))
            .on_page()
            .section("Study")
            .text([format!("SHA-256 {}", self.sha256)])
            .text([format!("Study {}.", self.study)])
            .on_page()
            .file(|folder| write_bytes(&folder.join("sweep.csv"), &self.table))
    }
}

/// The keys that are the same in all cases, in words; `None` without any.
fn settings(merged: &Merged) -> Option<String> {
    let keys = merged.constant.iter();
    let keys: Vec<String> = keys
        .map(|(key, value)| format!("{key} = {value}"))
        .collect();
    (!keys.is_empty()).then(|| {
        format!(
            "All cases have {}. asperity run with the settings of the case gives another number.",
            keys.join(" and ")
        )
    })
}

impl Merged {
    /// The 5 and 95 % quantiles of the cases, of the column of their losses.
    fn ends(&self, name: &str) -> Option<[&[f64]; 2]> {
        let of = |name: &str| {
            let column = self.outputs.iter().find(|(other, _)| other == name)?;
            Some(&column.1[..])
        };
        (name == LOSS).then_some([of(ENDS[0])?, of(ENDS[1])?])
    }
}

/// Every result over every axis; quantiles with their medians.
fn axes(merged: &Merged) -> Vec<Drawing> {
    let axes = &merged.inputs[..merged.axes.min(merged.inputs.len())];
    let is_end = |name: &str| ENDS.contains(&name) && merged.ends(LOSS).is_some();
    let outputs = merged.outputs.iter().filter(|(name, _)| !is_end(name));
    let of = |(name, values): &(String, Vec<f64>)| {
        let ends = merged.ends(name);
        let over_axes = axes
            .iter()
            .filter_map(|axis| over(axis, name, values, ends));
        over_axes.collect::<Vec<Drawing>>()
    };
    outputs.flat_map(of).collect()
}

/// A result over an axis: over a number a line and a range, of choices their ranges, or bars if
/// each is a single case; `None` for a constant axis.
fn over(
    axis: &InputColumn,
    name: &str,
    values: &[f64],
    ends: Option<[&[f64]; 2]>,
) -> Option<Drawing> {
    let output = Output::from_name(name);
    let id = format!("{name}-over-{}", axis.name.replace(['.', ' '], "-"));
    let title = format!("{} over {}", output.name, input_name(&axis.name));
    let title = capitalised(&title);
    let (source, y) = ("sweep.csv", Axis::new(&output.name, output.unit));
    // Mean, lowest and highest result of the cases that have one; of drawn losses the mean of each quantile.
    let group = |is_of: &dyn Fn(usize) -> bool| -> Option<[f64; 3]> {
        let cases = (0..values.len()).filter(|k| is_of(*k) && values[*k].is_finite());
        let cases: Vec<usize> = cases.collect();
        let of_cases = |column: &[f64]| -> Vec<f64> {
            let of_case = |k: &usize| output.factor * column[*k];
            cases.iter().map(of_case).collect()
        };
        let found = of_cases(values);
        let lowest = found.iter().copied().reduce(f64::min)?;
        let highest = found.iter().copied().reduce(f64::max)?;
        let [low, high] = match ends {
            Some(ends) => ends.map(|end| mean(of_cases(end))),
            None => [lowest, highest],
        };
        Some([mean(found), low, high])
    };
    let [middle, range] = match ends {
        Some(_) => ["median", "5 to 95 %"],
        None => ["mean", "lowest to highest"],
    };
    match &axis.values {
        InputValues::Numbers { unit, values, .. } => {
            let nodes = distinct(values.iter().copied());
            let points: Vec<(f64, [f64; 3])> = nodes
                .iter()
                .filter_map(|node| Some((*node, group(&|k| values[k] == *node)?)))
                .collect();
            let of = |which: usize| {
                points
                    .iter()
                    .map(|(_, found)| found[which])
                    .collect::<Vec<f64>>()
            };
            let x: Vec<f64> = points.iter().map(|(node, _)| *node).collect();
            let chart = Chart::new(
                &id,
                &title,
                source,
                Axis::new(&input_name(&axis.name), unit),
                y,
            )
            .curve(middle, Line::Dots, &x, &of(0))
            .with(Series::band(range, &x, &of(1), &of(2)));
            (points.len() > 1).then_some(Drawing::Curves(chart))
        }
        InputValues::Choices(names) => {
            let interval = |choice: &&String| {
                let [mean, low, high] = group(&|k| names[k] == **choice)?;
                let text = match ends {
                    Some(_) => output.interval(Estimate::new(mean, [low, high])),
                    None => format!("mean {}", output.text(mean / output.factor)),
                };
                Some(Interval {
                    name: (*choice).clone(),
                    ends: [low, high],
                    middle: Some(mean),
                    text,
                })
            };
            let intervals: Vec<Interval> = unique(names).iter().filter_map(interval).collect();
            // Of a single case at each choice there is no range to draw.
            if intervals.iter().all(|of| of.ends[0] == of.ends[1]) {
                let bars = intervals.into_iter().map(|of| Bar {
                    name: of.name,
                    value: Some(of.ends[0]),
                    spread: None,
                    text: of.text.trim_start_matches("mean ").to_owned(),
                });
                let bars: Vec<Bar> = bars.collect();
                return (bars.len() > 1).then_some(Drawing::Bars(BarChart {
                    id,
                    title,
                    source: source.to_owned(),
                    axis: y,
                    bars,
                }));
            }
            (intervals.len() > 1).then_some(Drawing::Tornado(Tornado {
                id,
                title,
                source: source.to_owned(),
                axis: y,
                middle: None,
                intervals,
            }))
        }
    }
}

/// The input with the largest effect on the first result, in words; `None` without effects.
fn largest(merged: &Merged) -> Option<String> {
    let (name, _) = merged.outputs.first()?;
    let output = Output::from_name(name);
    let row = *by_size(merged, name).first()?;
    let effect = row.effect?;
    let between = between(merged, &row.input, &effect).map_or(String::new(), |[low, high]| {
        format!(" from {low} to {high}")
    });
    Some(format!(
        "{} changes most with {}{between}: {}. The interval is of the regression, not of the model.",
        output.name,
        input_name(&row.input),
        output.change(&effect)
    ))
}

/// Sentence on two intervals that overlap.
const OVERLAP: &str = " Their intervals overlap, and do not tell whether these two differ: asperity compare has the difference with its interval.";

/// The lowest and the highest of the first result with their axes, in words; `None` if all are equal.
fn extremes(merged: &Merged) -> Option<String> {
    let (name_of, values) = merged.outputs.first()?;
    let output = Output::from_name(name_of);
    let cases = || (0..values.len()).filter(|k| values[*k].is_finite());
    let by_value = |a: &usize, b: &usize| values[*a].total_cmp(&values[*b]);
    let (low, high) = (cases().min_by(by_value)?, cases().max_by(by_value)?);
    let at = |k: usize| {
        let axes = &merged.inputs[..merged.axes.min(merged.inputs.len())];
        let varied = axes
            .iter()
            .filter(|axis| axis.cells().iter().any(|cell| *cell != axis.cells()[0]));
        let texts = varied.map(|axis| {
            let unit = match &axis.values {
                InputValues::Numbers { unit, .. } => unit.as_str(),
                InputValues::Choices(_) => "",
            };
            let text = format!("{} {} {unit}", input_name(&axis.name), axis.cells()[k]);
            text.trim_end().to_owned()
        });
        let value = match merged.ends(name_of) {
            Some(ends) => output.interval(Estimate::new(values[k], ends.map(|end| end[k]))),
            None => output.text(values[k]),
        };
        format!("{value} with {}", texts.collect::<Vec<_>>().join(", "))
    };
    (values[low] < values[high]).then(|| {
        let name = &output.name;
        // The intervals have constants in common, which the difference is free of.
        let overlap = merged
            .ends(name_of)
            .filter(|[from, to]| from[high] <= to[low]);
        let overlap = overlap.map_or("", |_| OVERLAP);
        format!(
            "Lowest {name}: {}. Highest {name}: {}.{overlap}",
            at(low),
            at(high)
        )
    })
}

/// The inputs by the size of their effect on a result, the largest first.
fn by_size<'a>(merged: &'a Merged, name: &str) -> Vec<&'a EffectRow> {
    let rows = merged.effects.iter().filter(|row| row.output == name);
    let mut rows: Vec<&EffectRow> = rows.filter(|row| row.effect.is_some()).collect();
    let size = |row: &EffectRow| {
        row.effect
            .map_or(0.0, |effect| effect.difference.value.abs())
    };
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    rows
}

/// Inputs by the size of their effect on a result, largest first; to the left where the result falls.
fn tornado(merged: &Merged, name: &str) -> Option<Drawing> {
    let output = Output::from_name(name);
    let rows = by_size(merged, name);
    let bar = |row: &&EffectRow| {
        let effect = row.effect?;
        Some(Bar {
            name: match between(merged, &row.input, &effect) {
                Some([low, high]) => format!("{}, {low} to {high}", input_name(&row.input)),
                None => input_name(&row.input),
            },
            value: Some(output.factor * effect.difference.value),
            spread: Some(effect.difference.ends().map(|end| output.factor * end)),
            text: output.change(&effect),
        })
    };
    let bars: Vec<Bar> = rows.iter().filter_map(bar).collect();
    (!bars.is_empty()).then(|| {
        Drawing::Bars(BarChart {
            id: format!("tornado-{name}"),
            title: format!("Effects on {}", output.name),
            source: "effects.csv".to_owned(),
            axis: Axis::new(&format!("change of {}", output.name), output.unit),
            bars,
        })
    })
}
