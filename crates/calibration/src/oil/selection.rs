//! Selection of the set points that the law of the film describes, never by the measured friction.

use std::fmt;

use asperity_core::Fault;
use serde::{Deserialize, Serialize};

use super::base::OilBase;
use super::reading::SetPoint;
use super::traction::LEAST_RATIO;

/// Least slide-to-roll ratio: below, the creep of the bodies and the elastic film count.
pub(super) const LEAST_SLIDE: f64 = 0.005;
/// Largest rise of the surface temperature \[K\].
const LARGEST_RISE: f64 = 40.0;
/// Tolerance of the limits, which settings meet exactly.
const ROUNDING: f64 = 1e-9;

/// Rule that leaves a set point out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Dropped {
    /// The film is thinner than three times the roughness.
    ThinFilm,
    /// The slide-to-roll ratio is below 0.5 %.
    SmallSlide,
    /// The surfaces are heated by more than 40 K.
    Heated,
}

impl Dropped {
    /// All rules.
    pub const ALL: [Self; 3] = [Self::ThinFilm, Self::SmallSlide, Self::Heated];
}

impl fmt::Display for Dropped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ThinFilm => "film thinner than three times the roughness",
            Self::SmallSlide => "slide-to-roll ratio below 0.5 %",
            Self::Heated => "surfaces heated by more than 40 K",
        })
    }
}

/// Conditions at a set point with the family's values of the constants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Judged {
    /// Largest Hertz pressure \[Pa\].
    pub max_pressure: f64,
    /// Film over roughness.
    pub film_ratio: f64,
    /// Rule that leaves it out; `None` if it is kept.
    pub dropped: Option<Dropped>,
}

/// Judges a set point.
///
/// # Errors
/// When the film has no solution.
pub fn judge(oil: &OilBase, point: &SetPoint) -> Result<Judged, Fault> {
    let reading = &point.reading;
    let machine = &reading.machine;
    let found = machine.predict_with(&oil.rheology, &reading.setting, reading.film, 1.0)?;
    let film_ratio = found.film / machine.roughness;
    let slide = reading.setting.slide_to_roll;
    let dropped = if film_ratio < LEAST_RATIO * (1.0 - ROUNDING) {
        Some(Dropped::ThinFilm)
    } else if slide < LEAST_SLIDE * (1.0 - ROUNDING) {
        Some(Dropped::SmallSlide)
    } else if found.friction.surface_rise > LARGEST_RISE {
        Some(Dropped::Heated)
    } else {
        None
    };
    Ok(Judged {
        max_pressure: found.hertz.max_pressure.si(),
        film_ratio,
        dropped,
    })
}
