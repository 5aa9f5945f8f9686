//! Report of a merged study: each result over each axis, then the effects of all inputs.

use asperity::message::explain;
use asperity_core::numerics::distinct;
use asperity_core::{capitalised, unique};
use asperity_report::chart::{
    Axis, Bar, BarChart, Chart, Drawing, Interval, Line, Series, Tornado,
};
use asperity_report::{Report, StudyResult, write_bytes};

use super::columns::{InputColumn, InputValues};
use super::merged::{EffectRow, Merged};
use super::words::{Output, input_name, table};

/// How the effects are computed.
const METHOD: &str = "Change of a result from the mean of the lowest quarter of an input to the mean of the highest quarter. A choice is \
    compared with the first one. The changes follow from a linear regression on all inputs; in brackets are their 5 and 95 % \
    quantiles, without the errors of the model.";
/// Meaning of the indices of Sobol.
const INDICES: &str = "First index: share of the variance of the result by this input alone. Total index: the same with its \
    interactions. Few samples estimate both roughly; an estimate may exceed 1.";
/// Losses of a sweep beside the loss of a run.
const AT_MEDIANS: &str = "loss_w is computed with the constants at their stated or median values. The loss that asperity run prints \
    first is the median over drawn constants, with its interval.";
/// Content of the charts over the axes.
const OVER_AXES: &str = "Mean of the cases at each value of an axis, and the range of all of them.";

impl StudyResult for Merged {
    const KIND: &'static str = "sweep";
    const NAME: &'static str = "sweep";

    fn report(&self) -> Report<'_> {
        let has_effects = self.effects.iter().any(|row| row.effect.is_some());
        let has_indices = self.effects.iter().any(|row| row.indices.is_some());
        let outside = self.outside.iter().map(|(code, count)| {
            let title = explain(code).map_or("", |entry| entry.title);
            let count = match *count == self.cases {
                true => format!("all {count}"),
                false => count.to_string(),
            };
            format!("{code} in {count} cases: {title}. A run of a case names the range.")
        });
        let has_losses = self.outputs.iter().any(|(name, _)| name == "loss_w");
        let charts = axes(self);
        let over_axes = (!charts.is_empty()).then_some(OVER_AXES);
        let mut report = Report::new(&self.title, format!("sweep {}", self.name))
            .section("Results over the axes")
            .verdict(largest(self).or_else(|| extremes(self)))
            .text([format!(
                "{} cases, {} without a result.",
                self.cases, self.failed
            )])
            .text(outside)
            .figures(move || charts.clone())
            .text(over_axes)
            .on_page()
            .text(has_losses.then_some(AT_MEDIANS))
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

/// Every result over every axis.
fn axes(merged: &Merged) -> Vec<Drawing> {
    let axes = &merged.inputs[..merged.axes.min(merged.inputs.len())];
    let outputs = merged.outputs.iter();
    outputs
        .flat_map(|(name, values)| axes.iter().filter_map(|axis| over(axis, name, values)))
        .collect()
}

/// A result over an axis: over a number a line and a range, of choices their ranges about the mean of all, or bars if
/// each is a single case; `None` for a constant axis.
fn over(axis: &InputColumn, name: &str, values: &[f64]) -> Option<Drawing> {
    let output = Output::of(name);
    let id = format!("{name}-over-{}", axis.name.replace(['.', ' '], "-"));
    let title = format!("{} over {}", output.name, input_name(&axis.name));
    let title = capitalised(&title);
    let (source, y) = ("sweep.csv", Axis::new(&output.name, output.unit));
    // Mean, lowest and highest result of the cases that have one.
    let group = |is_of: &dyn Fn(usize) -> bool| -> Option<[f64; 3]> {
        let cases = (0..values.len()).filter(|k| is_of(*k) && values[*k].is_finite());
        let found: Vec<f64> = cases.map(|k| output.factor * values[k]).collect();
        let mean = found.iter().sum::<f64>() / found.len() as f64;
        let low = found.iter().copied().reduce(f64::min)?;
        Some([mean, low, found.iter().copied().reduce(f64::max)?])
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
            .curve("mean", Line::Dots, &x, &of(0))
            .with(Series::band("lowest to highest", &x, &of(1), &of(2)));
            (points.len() > 1).then_some(Drawing::Curves(chart))
        }
        InputValues::Choices(names) => {
            let interval = |choice: &&String| {
                let [mean, low, high] = group(&|k| names[k] == **choice)?;
                let mean = output.text(mean / output.factor);
                Some(Interval {
                    name: (*choice).clone(),
                    ends: [low, high],
                    text: format!("mean {mean}"),
                })
            };
            let intervals: Vec<Interval> = unique(names).iter().filter_map(interval).collect();
            let [middle, ..] = group(&|_| true)?;
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
                middle,
                intervals,
            }))
        }
    }
}

/// The input with the largest effect on the first result, in words; `None` without effects.
fn largest(merged: &Merged) -> Option<String> {
    let (name, _) = merged.outputs.first()?;
    let output = Output::of(name);
    let row = *by_size(merged, name).first()?;
    Some(format!(
        "{} changes most with {}: {}; interval of the regression only, not of the model.",
        output.name,
        input_name(&row.input),
        output.change(&row.effect?)
    ))
}

/// The lowest and the highest of the first result with their axes, in words; `None` if all are equal.
fn extremes(merged: &Merged) -> Option<String> {
    let (name, values) = merged.outputs.first()?;
    let output = Output::of(name);
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
        let value = output.text(values[k]);
        format!("{value} with {}", texts.collect::<Vec<_>>().join(", "))
    };
    (values[low] < values[high]).then(|| {
        let name = &output.name;
        format!("Lowest {name}: {}. Highest {name}: {}.", at(low), at(high))
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
    let output = Output::of(name);
    let rows = by_size(merged, name);
    let bar = |row: &&EffectRow| {
        let effect = row.effect?;
        Some(Bar {
            name: input_name(&row.input),
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
