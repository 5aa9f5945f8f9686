//! What the worker of the page sees: text and bytes, errors as JSON.

use std::cell::RefCell;

use asperity::message::Code;
use js_sys::{Error, Function};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use crate::failure::Failure;
use crate::gearbox_file::gearbox_stage;
use crate::look::{Stated, look as look_at};
use crate::versus::versus;
use crate::{files, job};

thread_local! {
    /// Told how far a run is. A page has one thread, and a run calls back from wherever it is.
    static LISTENER: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// Fits a fault of the program, which ends the work, with the words that it leaves behind, and registers the formulations.
#[wasm_bindgen(start)]
pub fn start() {
    crate::register();
    std::panic::set_hook(Box::new(|fault| {
        wasm_bindgen::throw_val(Error::new(&fault.to_string()).into())
    }));
}

fn thrown(failure: Failure) -> JsValue {
    let text = serde_json::to_string(&failure);
    JsValue::from_str(&text.unwrap_or(failure.message))
}

/// An answer as JSON.
fn written<T: Serialize>(answer: Result<T, Failure>) -> Result<String, JsValue> {
    let text = answer.and_then(|answer| Ok(serde_json::to_string(&answer)?));
    text.map_err(thrown)
}

/// Files in memory by their names.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Files(files::Files);

#[wasm_bindgen]
impl Files {
    /// No files yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Keeps `bytes` as the file `name`.
    pub fn hold(&mut self, name: &str, bytes: Vec<u8>) {
        self.0.hold(name, bytes);
    }
}

/// A result.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Finished(job::Finished);

#[wasm_bindgen]
impl Finished {
    /// Title of the case.
    #[wasm_bindgen(getter)]
    pub fn title(&self) -> String {
        self.0.train.title.clone()
    }

    /// The summary as the command prints it.
    #[wasm_bindgen(getter)]
    pub fn summary(&self) -> String {
        self.0.summary()
    }

    /// The keys of the case as JSON.
    ///
    /// # Errors
    /// When they cannot be written: the failure as JSON.
    pub fn inputs(&self) -> Result<String, JsValue> {
        written(Ok(self.0.inputs()))
    }

    /// This result (A) and `other` (B) side by side, as JSON.
    ///
    /// # Errors
    /// As [`crate::versus`]: the failure as JSON.
    pub fn versus(&self, other: &Self) -> Result<String, JsValue> {
        written(versus(&self.0, &other.0))
    }

    /// Names of the files of the result.
    #[wasm_bindgen(getter)]
    pub fn names(&self) -> Vec<String> {
        let files = self.0.files.iter();
        files.map(|(name, _)| name.clone()).collect()
    }

    /// Content of the file `name` of the result; none where there is none of that name.
    pub fn file(&self, name: &str) -> Option<Vec<u8>> {
        let mut files = self.0.files.iter();
        let (_, content) = files.find(|(known, _)| known == name)?;
        Some(content.clone())
    }
}

/// Runs the case in `text`, called `name`, on `files`; calls `progress` with the positions done and their number.
///
/// # Errors
/// As [`crate::run`]: the failure as JSON.
#[wasm_bindgen]
pub fn run(name: &str, text: &str, files: &Files, progress: Function) -> Result<Finished, JsValue> {
    LISTENER.set(Some(progress));
    let told = |done: usize, total: usize| {
        LISTENER.with_borrow(|listener| {
            if let Some(listener) = listener {
                // The page may fail to draw its bar; the run goes on.
                let _ = listener.call2(&JsValue::NULL, &done.into(), &total.into());
            }
        });
    };
    let done = job::run(name, text, &files.0, &told);
    LISTENER.set(None);
    done.map(Finished).map_err(thrown)
}

/// What the file `name` holds, as JSON, with what the form states about it, as JSON, for the flank at `flank`.
///
/// # Errors
/// As [`crate::look()`]: the failure as JSON.
#[wasm_bindgen]
pub fn look(name: &str, bytes: &[u8], flank: &str, stated: &str) -> Result<String, JsValue> {
    let stated: Result<Stated, Failure> = serde_json::from_str(stated)
        .map_err(|error| Failure::new(Code::E204, format!("{flank}: {error}")));
    written(stated.and_then(|stated| look_at(name, bytes, flank, &stated)))
}

/// The keys of the case in `text` as JSON.
///
/// # Errors
/// As [`crate::keys`]: the failure as JSON.
#[wasm_bindgen]
pub fn keys(name: &str, text: &str) -> Result<String, JsValue> {
    job::keys(name, text).map_err(thrown)
}

/// Gears, steels and oils by name, as JSON.
///
/// # Errors
/// As [`crate::library()`]: the failure as JSON.
#[wasm_bindgen]
pub fn library() -> Result<String, JsValue> {
    crate::library::library().map_err(thrown)
}

/// Picture of the gears in `text` and what follows from them, as JSON.
///
/// # Errors
/// As [`crate::pair()`]: the failure as JSON.
#[wasm_bindgen]
pub fn pair(name: &str, text: &str) -> Result<String, JsValue> {
    written(crate::pair::pair(name, text))
}

/// The case of a stage of the REXS file `name`, as JSON; of the whole gearbox where `stage` is 0.
///
/// # Errors
/// As [`crate::gearbox_stage`]: the failure as JSON.
#[wasm_bindgen]
pub fn gearbox(
    name: &str,
    bytes: &[u8],
    stage: usize,
    pinion: &str,
    wheel: &str,
) -> Result<String, JsValue> {
    written(gearbox_stage(name, bytes, stage, [pinion, wheel]))
}
