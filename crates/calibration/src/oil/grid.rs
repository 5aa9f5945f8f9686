//! Grids of settings of a machine, for points that are still to be measured.

use asperity_core::Fault;
use asperity_core::quantity::{Force, Speed, Temperature};
use asperity_core::task::try_par_map;

use super::base::OilBase;
use super::machine::{Machine, Setting};
use super::reading::{Reading, SetPoint};
use super::selection::judge;

/// Every combination of loads \[N\], mean speeds \[m/s\], temperatures \[°C\] and slide-to-roll ratios.
#[derive(Debug, Clone, Copy)]
pub(super) struct OilGrid<'a> {
    pub loads: &'a [f64],
    pub speeds: &'a [f64],
    pub slides: &'a [f64],
    pub temperatures: &'a [f64],
}

impl OilGrid<'_> {
    /// The points, to be measured with both signs of the slide-to-roll ratio; a curve has one load, speed and temperature.
    pub fn points(&self, machine: &Machine) -> Vec<SetPoint> {
        let mut points = Vec::new();
        let mut curve = 0;
        for load in self.loads {
            for speed in self.speeds {
                for celsius in self.temperatures {
                    points.extend(self.slides.iter().map(|slide_to_roll| {
                        let setting = Setting {
                            load: Force::from_si(*load),
                            mean_speed: Speed::from_si(*speed),
                            slide_to_roll: *slide_to_roll,
                            temperature: Temperature::from_celsius(*celsius),
                        };
                        SetPoint::planned(*machine, setting, curve)
                    }));
                    curve += 1;
                }
            }
        }
        points
    }

    /// The points that the law of the film describes.
    ///
    /// # Errors
    /// When the film has no solution.
    pub fn described(&self, oil: &OilBase, machine: &Machine) -> Result<Vec<SetPoint>, Fault> {
        let judged = try_par_map(self.points(machine), |point| -> Result<_, Fault> {
            Ok((judge(oil, &point)?.dropped.is_none(), point))
        })?;
        let kept = judged.into_iter().filter(|(is_described, _)| *is_described);
        Ok(kept.map(|(_, point)| point).collect())
    }
}

impl SetPoint {
    /// A point that is still to be measured, with both signs of the slide-to-roll ratio.
    fn planned(machine: Machine, setting: Setting, curve: usize) -> Self {
        Self {
            reading: Reading {
                file: String::new(),
                line: 0,
                step: 0,
                group: String::new(),
                machine,
                setting,
                set_temperature_c: setting.temperature.celsius(),
                rubbing_s: None,
                traction: 0.0,
                sigma: None,
                film: None,
                contradiction: None,
            },
            readings: 1,
            curve,
            has_both_signs: true,
        }
    }
}
