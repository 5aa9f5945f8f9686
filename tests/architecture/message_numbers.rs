//! Messages print numbers by the formatters of the crate core.

use std::fs;
use std::path::Path;

use crate::words::sources;

/// Raw numbers in the messages of a source file: line, field and message.
fn raw_numbers(text: &str) -> Vec<(usize, String, String)> {
    let mut found = Vec::new();
    for (at, _) in text.match_indices("#[error(") {
        let Some((attribute, body)) = text[at..].split_once(")]\n") else {
            continue;
        };
        // The first literal is the message; a quote in it is escaped.
        let masked = attribute.replace("\\\"", "''");
        let Some(message) = masked.split('"').nth(1) else {
            continue;
        };
        let Some((head, fields)) = body.split_once('{') else {
            continue;
        };
        // A variant without fields, or a tuple.
        if head.contains([',', '(', '}']) {
            continue;
        }
        let fields = fields.split('}').next().unwrap_or_default();
        let numbers = fields.lines().filter_map(|line| {
            let line = line.trim().trim_start_matches("pub ");
            line.strip_suffix(": f64,")
        });
        for name in numbers {
            let is_formatted = attribute.contains(&format!(" {name} = "));
            let parts = message.split('{').skip(1);
            let mut formats = parts.filter_map(|part| part.split('}').next()?.strip_prefix(name));
            // An exponent keeps the digits few by itself.
            let is_raw = |format: &str| {
                format.is_empty() || format.starts_with(":.") && !format.ends_with('e')
            };
            if formats.any(is_raw) && !is_formatted {
                let line = 1 + text[..at].matches('\n').count();
                found.push((line, name.to_owned(), message.to_owned()));
            }
        }
    }
    found
}

#[test]
fn errors_and_warnings_print_numbers_by_the_formatters_of_core() {
    let raw = "#[error(\"off by {x:.1} at {y}\", y = number(*y))]\nOff {\n    /// X.\n    x: f64,\n    y: f64,\n},\n";
    assert_eq!(raw_numbers(raw).len(), 1);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../crates");
    let mut places = Vec::new();
    for file in sources(&root) {
        // The crate below core checks that numbers are finite.
        if file.components().any(|part| part.as_os_str() == "storage") {
            continue;
        }
        for (line, name, message) in raw_numbers(&fs::read_to_string(&file).unwrap()) {
            places.push(format!("{}:{line}: {name} in {message:?}", file.display()));
        }
    }
    assert!(
        places.is_empty(),
        "asperity_core::number and decimals keep digits few:\n{}",
        places.join("\n")
    );
}
