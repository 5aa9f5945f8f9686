//! The cases of the gates of measurement, and estimates of their results with the sampling error of the flanks.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock};

use asperity::Contacts;
use asperity::case::LoadedCase;
use asperity::result::{Losses, OffsetRow};
use asperity::uncertainty::standard_error;
use asperity_tests::{contacts, losses_with};

use crate::gate::Estimate;
use crate::load_share::{with, with_keys};

/// Pitch line speeds m/s and the friction an independent program found there, boundary friction 0.08.
pub const FZG_SPEEDS: [(f64, f64); 6] = [
    (0.5, 0.0596),
    (1.25, 0.0517),
    (2.5, 0.0470),
    (5.0, 0.0435),
    (8.3, 0.0416),
    (20.0, 0.0379),
];

/// Turns per minute of the FZG pinion at a pitch line speed m/s: its working pitch radius is 36.6 mm.
pub fn turns(speed: f64) -> String {
    let radius = 0.0366;
    format!("{} 1/min", speed / radius * 30.0 / std::f64::consts::PI)
}

/// A case of `fixtures/measured` with these keys changed.
pub fn measured(name: &str, keys: &[(&str, &str)]) -> LoadedCase {
    with(&format!("../measured/{name}"), keys)
}

/// Losses of a case, with the standard error of the mean loss over the windows of its traces.
pub struct Sampled {
    pub losses: Losses,
    /// 0 without traces.
    error_w: f64,
}

impl Sampled {
    pub fn new(case: &LoadedCase) -> Self {
        Self::with(case, asperity_tests::losses(case).unwrap())
    }

    fn with(case: &LoadedCase, losses: Losses) -> Self {
        let error = standard_error(&case.at_stated().unwrap(), &losses).unwrap();
        Self {
            error_w: error * losses.summary.loss_w,
            losses,
        }
    }

    /// The mean of `of` over the offsets.
    pub fn mean(&self, of: &dyn Fn(&OffsetRow) -> f64) -> Estimate {
        self.estimate(self.losses.offsets.iter().map(of).collect())
    }

    /// The mean of `of` over the offsets and those of `other` in the same windows, whose scatter cancels in part.
    pub fn paired(&self, other: &Losses, of: &dyn Fn(&OffsetRow, &OffsetRow) -> f64) -> Estimate {
        assert_eq!(self.losses.offsets.len(), other.offsets.len());
        let rows = self.losses.offsets.iter().zip(&other.offsets);
        self.estimate(rows.map(|(own, other)| of(own, other)).collect())
    }

    /// The mean of `values`, one at each offset. Its standard error is the error of the loss times the ratio of their
    /// deviations from offset to offset.
    fn estimate(&self, values: Vec<f64>) -> Estimate {
        let losses: Vec<f64> = self.losses.offsets.iter().map(|row| row.loss_w).collect();
        let spread = deviation(&losses);
        Estimate {
            value: mean(&values),
            // Films without contacts lose the same in every window, within round-off.
            standard_error: if spread > 1e-12 * mean(&losses) {
                self.error_w * deviation(&values) / spread
            } else {
                0.0
            },
        }
    }

    /// Mean coefficient of friction of the mesh.
    pub fn friction(&self) -> Estimate {
        let summary = &self.losses.summary;
        let normal = summary.loss_factor_local * summary.power_in_w;
        self.mean(&|row| row.sliding_w / normal)
    }

    /// Friction over that of `other` in the same windows of the same mesh.
    pub fn friction_over(&self, other: &Self) -> Estimate {
        let below = other.losses.summary.sliding_w;
        let ratio = self.losses.summary.sliding_w / below;
        let residual = |own: &OffsetRow, other: &OffsetRow| {
            ratio + (own.sliding_w - ratio * other.sliding_w) / below
        };
        self.paired(&other.losses, &residual)
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn deviation(values: &[f64]) -> f64 {
    let middle = mean(values);
    let squares = values.iter().map(|value| (value - middle).powi(2));
    (squares.sum::<f64>() / (values.len() as f64 - 1.0).max(1.0)).sqrt()
}

/// A case at other speeds, temperatures or oils, with the contacts solved once.
pub struct Kept {
    pub case: LoadedCase,
    pub tables: Contacts,
}

/// A shipped case with keys changed, whose contacts are solved once for all tables and tests.
pub fn kept(name: &str, keys: &[(&str, &str)]) -> Arc<Kept> {
    static KEPT: Mutex<BTreeMap<String, Arc<OnceLock<Arc<Kept>>>>> = Mutex::new(BTreeMap::new());
    let name_and_keys = format!("{name} {keys:?}");
    let place = Arc::clone(KEPT.lock().unwrap().entry(name_and_keys).or_default());
    let made = place.get_or_init(|| Arc::new(Kept::new(with(name, keys))));
    Arc::clone(made)
}

impl Kept {
    pub fn new(case: LoadedCase) -> Self {
        let tables = contacts(&case).unwrap();
        Self { case, tables }
    }

    pub fn with(&self, keys: &[(&str, &str)]) -> LoadedCase {
        with_keys(&self.case, keys)
    }

    pub fn at(&self, keys: &[(&str, &str)]) -> Sampled {
        let case = self.with(keys);
        let losses = losses_with(&self.tables, &case).unwrap();
        Sampled::with(&case, losses)
    }
}
