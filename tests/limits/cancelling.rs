//! Work that is cancelled ends with an error and nothing else.

use std::sync::atomic::{AtomicUsize, Ordering};

use asperity::case;
use asperity::core::cancel::Token;
use asperity::core::task::on_threads;

fn e_drive() -> case::LoadedCase {
    let file = "../fixtures/cases/e-drive.toml".as_ref();
    case::load_with(file, &|input| {
        (input.model.positions, input.model.offsets) = (Some(8), Some(2));
    })
    .unwrap()
}

#[test]
fn a_cancelled_run_is_an_error_whatever_was_computed() {
    let case = e_drive();
    let token = Token::new();
    let on_two = |work: &(dyn Fn() -> Result<(), asperity::Error> + Sync)| {
        on_threads(2, || token.run(work)).unwrap()
    };
    assert!(on_two(&|| asperity_tests::losses(&case).map(drop)).is_ok());
    let done = AtomicUsize::new(0);
    let cancelling = |_, _| {
        done.fetch_add(1, Ordering::Relaxed);
        token.cancel();
    };
    let run = || asperity::Run::new(&case).progress(&cancelling).execute();
    let error = on_two(&|| run().map(drop)).unwrap_err();
    assert_eq!(error.code(), "E502", "{error}");
    assert!(error.position().unwrap().is_cancelled());
    // One position a thread was under way.
    assert!(done.into_inner() <= 2);
    assert!(on_two(&|| asperity_tests::contacts(&case).map(drop)).is_err());
}

#[test]
fn a_cancelled_record_of_mixed_lubrication_is_an_error() {
    let case = e_drive();
    let case = case.with_key("model.load_share", "ehl").unwrap();
    let case = case.with_key("model.ehl.cache", "off").unwrap();
    let token = Token::new();
    token.cancel();
    let error = token.run(|| asperity_tests::losses(&case).unwrap_err());
    assert_eq!(error.code(), "E502", "{error}");
}
