//! Faults that repeat: a dialect of the file, not a wrong line.

use std::fmt;

/// Number of like faults from which a file is written differently; fewer are wrong lines.
const DIALECT: usize = 10;

/// Like faults of a file: their number, and the first two with their lines, from 1.
///
/// ```
/// use asperity_core::RepeatedFault;
/// let mut faults = RepeatedFault::default();
/// for line in 3..13 {
///     faults.add(line, "0.5 um");
/// }
/// assert!(faults.is_dialect());
/// assert_eq!(faults.to_string(), "10 lines look like this: line 3 \"0.5 um\", line 4 \"0.5 um\"");
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RepeatedFault {
    count: usize,
    shown: Vec<(usize, String)>,
}

impl RepeatedFault {
    /// Adds a fault at `line`, which reads `text`.
    pub fn add(&mut self, line: usize, text: &str) {
        /// Number of lines shown, and of characters of each.
        const SHOWN: (usize, usize) = (2, 40);
        self.count += 1;
        if self.shown.len() < SHOWN.0 {
            let text = text.trim();
            let cut = text.char_indices().nth(SHOWN.1);
            let text = cut.map_or(text.to_owned(), |(at, _)| format!("{}…", &text[..at]));
            self.shown.push((line, text));
        }
    }

    /// Whether there are enough faults for a dialect of the file.
    pub fn is_dialect(&self) -> bool {
        self.count >= DIALECT
    }
}

impl fmt::Display for RepeatedFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown = |(line, text): &(usize, String)| format!("line {line} \"{text}\"");
        let shown: Vec<String> = self.shown.iter().map(shown).collect();
        write!(
            f,
            "{} lines look like this: {}",
            self.count,
            shown.join(", ")
        )
    }
}
