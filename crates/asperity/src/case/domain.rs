//! Errors of the physics put to the key of the case that they are about.

use asperity_core::DomainError;

use super::error::CaseError;
use super::source::Source;

/// Names `key` as the place of a number outside its domain.
pub(super) fn domain<'a>(
    source: &'a Source,
    key: &'static str,
) -> impl Fn(DomainError) -> CaseError + use<'a> {
    move |error| CaseError::Domain {
        place: source.place_of(key),
        key,
        written: source.written(key).map(str::to_owned),
        source: error,
    }
}
