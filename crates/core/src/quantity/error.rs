//! Text that is not a quantity.

/// Text that is not a quantity, and what was expected.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum QuantityError {
    /// No number at the front.
    #[error(
        "cannot read \"{text}\" as {}: it must start with a number; accepted units: {accepted}",
        with_article(quantity)
    )]
    NotANumber {
        /// Name of the quantity.
        quantity: &'static str,
        /// The text seen.
        text: String,
        /// Accepted units.
        accepted: String,
    },
    /// A decimal comma.
    #[error(
        "cannot read \"{text}\" as {}: write the decimal sign as a point",
        with_article(quantity)
    )]
    DecimalComma {
        /// Name of the quantity.
        quantity: &'static str,
        /// The text seen.
        text: String,
    },
    /// A number without a unit.
    #[error(
        "{text} has no unit; {} needs one of: {accepted} (as \"{text} {example}\")",
        with_article(quantity)
    )]
    NoUnit {
        /// Name of the quantity.
        quantity: &'static str,
        /// The text seen.
        text: String,
        /// Accepted units.
        accepted: String,
        /// One accepted unit.
        example: &'static str,
    },
    /// A unit of something else, or misspelt.
    #[error("\"{unit}\" is not a unit of {quantity}; accepted: {accepted}")]
    UnknownUnit {
        /// Name of the quantity.
        quantity: &'static str,
        /// The unit seen.
        unit: String,
        /// Accepted units.
        accepted: String,
    },
    /// Too large for a number, or below absolute zero.
    #[error("\"{text}\" is not a possible {quantity}")]
    Impossible {
        /// Name of the quantity.
        quantity: &'static str,
        /// The text seen.
        text: String,
    },
}

/// The name of a quantity with its article.
pub(super) fn with_article(name: &str) -> String {
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) {
        "an"
    } else {
        "a"
    };
    format!("{article} {name}")
}
