//! Nodes of an axis, as text or numbers.

use std::convert::Infallible;
use std::str::FromStr;

use asperity_core::{Code, Fault};
use schemars::JsonSchema;
use serde::Deserialize;

/// Largest number of nodes of an axis.
pub const MOST_NODES: usize = 1000;

/// The text is not an axis.
fn not_an_axis(text: &str) -> Fault {
    Fault::new(
        Code::E209,
        format!(
            "{text:?} is not an axis; write a list as 10,20,50, or 10..100:5, or 10..100:5:log"
        ),
    )
}

/// Parses nodes: `10,20,50`, `10..100:5` in equal steps, or `10..100:5:log` in equal ratios.
///
/// # Errors
/// When the text is none of these.
///
/// ```
/// use asperity_report::axis::axis;
/// assert_eq!(axis("10, 20,50")?, [10.0, 20.0, 50.0]);
/// assert_eq!(axis("-10..10:5")?, [-10.0, -5.0, 0.0, 5.0, 10.0]);
/// assert_eq!(axis("1..100:3:log")?, [1.0, 10.0, 100.0]);
/// assert!(axis("10..100").is_err());
/// # Ok::<(), asperity_core::Fault>(())
/// ```
pub fn axis(text: &str) -> Result<Vec<f64>, Fault> {
    let refused = || not_an_axis(text);
    let number = |part: &str| part.trim().parse::<f64>().map_err(|_| refused());
    let Some((low, rest)) = text.split_once("..") else {
        return text.split(',').map(number).collect();
    };
    let mut parts = rest.split(':');
    let mut next = || parts.next().ok_or_else(refused);
    let (low, high) = (number(low)?, number(next()?)?);
    let count: usize = next()?.trim().parse().map_err(|_| refused())?;
    let is_log = match parts.next().map(str::trim) {
        None => false,
        Some("log") if low > 0.0 && high > 0.0 => true,
        Some(_) => return Err(refused()),
    };
    if parts.next().is_some()
        || !(2..=MOST_NODES).contains(&count)
        || !low.is_finite()
        || !high.is_finite()
    {
        return Err(refused());
    }
    Ok(range(low, high, count, is_log))
}

/// `count` nodes from `low` to `high`, in equal steps or in equal ratios, rounded to 12 digits.
#[must_use]
pub fn range(low: f64, high: f64, count: usize, is_log: bool) -> Vec<f64> {
    let last = (count - 1) as f64;
    let node = |k: usize| {
        let share = k as f64 / last;
        match k {
            0 => low,
            k if k + 1 == count => high,
            _ if is_log => rounded_to(low * (high / low).powf(share), 12),
            _ => rounded_to(low + (high - low) * share, 12),
        }
    };
    (0..count).map(node).collect()
}

/// Nodes of a text that ends with their unit, `10..100:5 N m`, and the unit, which can be missing.
///
/// # Errors
/// When the text before the first blank is not an axis.
///
/// ```
/// use asperity_report::axis::with_unit;
/// assert_eq!(with_unit("20..100:2 N m")?, (vec![20.0, 100.0], "N m"));
/// assert_eq!(with_unit("0.1..1:2:log")?, (vec![0.1, 1.0], ""));
/// # Ok::<(), asperity_core::Fault>(())
/// ```
pub fn with_unit(text: &str) -> Result<(Vec<f64>, &str), Fault> {
    let text = text.trim();
    let (nodes, unit) = text.split_once(' ').unwrap_or((text, ""));
    Ok((axis(nodes)?, unit.trim()))
}

/// `value` rounded to `digits` decimal digits.
#[must_use]
pub fn rounded_to(value: f64, digits: i32) -> f64 {
    let text = format!("{value:.*e}", (digits - 1).max(0) as usize);
    text.parse().unwrap_or(value)
}

/// Nodes of a setting, as text that [`axis`] parses or as numbers.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Nodes {
    /// Numbers.
    Numbers(Vec<f64>),
    /// Text.
    Text(String),
}

impl FromStr for Nodes {
    type Err = Infallible;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Ok(Self::Text(text.to_owned()))
    }
}

impl Nodes {
    /// The nodes of the setting `name`.
    ///
    /// # Errors
    /// When the text is not an axis, or has no nodes.
    pub fn nodes(&self, name: &str) -> Result<Vec<f64>, Fault> {
        self.parsed(name, None)
    }

    /// The nodes of the setting `name`; a text that ends with % has parts of `whole`, the value of the case.
    ///
    /// # Errors
    /// As [`nodes`](Self::nodes).
    ///
    /// ```
    /// use asperity_report::axis::Nodes;
    /// let nodes: Nodes = "50,100,120 %".parse()?;
    /// assert_eq!(nodes.nodes_of("torque", 145.0)?, [72.5, 145.0, 174.0]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn nodes_of(&self, name: &str, whole: f64) -> Result<Vec<f64>, Fault> {
        self.parsed(name, Some(whole))
    }

    /// The nodes of the setting `name`, if it is stated, as [`nodes_of`](Self::nodes_of).
    ///
    /// # Errors
    /// As [`nodes`](Self::nodes).
    pub fn of_case(
        stated: Option<&Self>,
        name: &str,
        whole: f64,
    ) -> Result<Option<Vec<f64>>, Fault> {
        stated
            .map(|stated| stated.nodes_of(name, whole))
            .transpose()
    }

    fn parsed(&self, name: &str, whole: Option<f64>) -> Result<Vec<f64>, Fault> {
        let percent = |text: &str| Some((text.trim_end().strip_suffix('%')?.to_owned(), whole?));
        let nodes = match self {
            Self::Numbers(numbers) => Ok(numbers.clone()),
            Self::Text(text) => match percent(text) {
                Some((percents, whole)) => axis(percents.trim_end()).map(|nodes| {
                    let part = |percent: &f64| rounded_to(whole * percent / 100.0, 12);
                    nodes.iter().map(part).collect()
                }),
                None => axis(text),
            },
        };
        let none = || Fault::new(Code::E209, "at least one node is required");
        nodes
            .and_then(|nodes| {
                if nodes.is_empty() {
                    Err(none())
                } else {
                    Ok(nodes)
                }
            })
            .map_err(|error| error.about(name))
    }
}
