//! Reference numbers with ours beside them.

use std::fmt::Write;

/// A number from elsewhere and ours.
pub struct Comparison {
    quantity: String,
    unit: &'static str,
    expected: f64,
    actual: f64,
    /// Largest relative deviation.
    tolerance: f64,
}

impl Comparison {
    /// Ours must be within the relative `tolerance` of `expected`.
    pub fn new(
        quantity: impl Into<String>,
        unit: &'static str,
        expected: f64,
        actual: f64,
        tolerance: f64,
    ) -> Self {
        Self {
            quantity: quantity.into(),
            unit,
            expected,
            actual,
            tolerance,
        }
    }

    /// Ours must round to the number printed, whose last digit counts `last`.
    pub fn printed(
        quantity: impl Into<String>,
        unit: &'static str,
        (expected, last): (f64, f64),
        actual: f64,
    ) -> Self {
        // A hair more than half a unit, for numbers that lie on the edge.
        let tolerance = 0.501 * last / expected.abs();
        Self::new(quantity, unit, expected, actual, tolerance)
    }

    fn hold(&self) {
        asperity_tests::assert_close(&self.quantity, self.actual, self.expected, self.tolerance);
    }
}

/// Comparisons that one test holds.
pub struct Table {
    /// Name of the place in a document, or of the file of `tests/golden/evidence`.
    pub name: &'static str,
    /// The test that holds it.
    pub test: &'static str,
    /// The comparisons.
    pub rows: Vec<Comparison>,
}

impl Table {
    /// Panics at the first comparison that does not hold.
    pub fn hold(&self) {
        assert!(!self.rows.is_empty());
        self.rows.iter().for_each(Comparison::hold);
    }

    /// The table as Markdown.
    pub fn markdown(&self) -> String {
        let mut text = String::from(
            "| quantity | unit | reference | here | deviation | held to |\n|---|---|---|---|---|---|\n",
        );
        for row in &self.rows {
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} |",
                row.quantity,
                row.unit,
                digits(row.expected),
                digits(row.actual),
                percent(row.actual / row.expected - 1.0),
                tolerance(row.tolerance),
            );
        }
        let _ = writeln!(text, "\nTest: `{}`.", self.test);
        text
    }
}

/// Six significant digits, without zeros that say nothing.
pub fn digits(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let size = value.abs().log10().floor() as i32;
    if !(-5..9).contains(&size) {
        return format!("{value:.3e}");
    }
    let text = format!("{value:.*}", (5 - size).max(0) as usize);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A deviation in per cent; what rounds to nothing is nothing, on every processor.
fn percent(deviation: f64) -> String {
    let text = format!("{:+.4} %", 100.0 * deviation);
    match text.as_str() {
        "+0.0000 %" | "-0.0000 %" => "0".to_owned(),
        _ => text,
    }
}

fn tolerance(relative: f64) -> String {
    format!("{:.1e}", relative)
}
