//! Messages of parsers in words of their users instead of Rust.

/// `message` of a parser on a value of another type, with the type that it expected in plain words.
///
/// ```
/// use asperity_core::in_plain_words;
/// let message = "invalid type: string \"many\", expected usize";
/// assert_eq!(in_plain_words(message), "invalid type: string \"many\", expected a whole number, 0 or more");
/// ```
pub fn in_plain_words(message: &str) -> String {
    match message.split_once(", expected ") {
        Some((seen, expected)) => format!("{seen}, expected {}", type_in_words(expected)),
        None => message.to_owned(),
    }
}

/// Name of a type in Rust, as a parser expects it, in plain words.
pub fn type_in_words(expected: &str) -> &str {
    match expected {
        "i32" | "i64" => "a whole number",
        "u8" | "u32" | "usize" | "u64" => "a whole number, 0 or more",
        "f64" => "a number",
        "an array of length 2" => "two values, e.g. [first, second]",
        "a boolean" => "true or false",
        "path string" => "the name of a file in quotation marks",
        name if name.starts_with("struct ") || name.starts_with("internally tagged enum ") => {
            "a table, e.g. { key = value }"
        }
        other => other,
    }
}
