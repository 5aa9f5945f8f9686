//! Subsurface stress of a solved contact.

use std::path::Path;

use asperity_contact::plasticity::plastic_stress;
use asperity_contact::subsurface::{
    Peak, StressField, YieldZone, graded_depths, subsurface_stress,
};
use asperity_core::Code;
use asperity_core::number;
use asperity_core::quantity::Length;
use serde_json::{Value, json};

use super::solved::SolvedContact;
use crate::args::ContactArgs;
use crate::failure::Failure;
use crate::output::save;

/// Number of depths of the field.
const DEPTHS: usize = 60;

/// Largest values of a stress field.
pub struct Stress {
    von_mises: Peak,
    shear: Peak,
    yield_zone: Option<YieldZone>,
    has_limit: bool,
    /// Position of the first point \[m\].
    first: f64,
}

/// Computes the stress under `contact` and writes it to the file that `args` names.
pub fn stress(contact: &SolvedContact, args: &ContactArgs, path: &Path) -> Result<Stress, Failure> {
    let outside = |error: &dyn std::fmt::Display| Failure::new(Code::E209, error.to_string());
    let pressure = &contact.solution.pressure;
    let touches = |p: &f64| *p > 0.0;
    let (Some(first), Some(last)) = (
        pressure.iter().position(touches),
        pressure.iter().rposition(touches),
    ) else {
        return Err(Failure::new(
            Code::E209,
            "--stress: the bodies do not touch",
        ));
    };
    let half_width = contact.spacing * (0.5 * (last - first + 1) as f64);
    let depths = graded_depths(contact.spacing * 0.5, half_width, DEPTHS)
        .map_err(|error| outside(&error))?;
    let friction = args.friction;
    if !friction.is_finite() {
        return Err(Failure::new(
            Code::E209,
            format!("--friction {}: must be finite", number(friction)),
        ));
    }
    let traction: Option<Vec<f64>> =
        (friction != 0.0).then(|| pressure.iter().map(|p| friction * p).collect());
    let field = subsurface_stress(pressure, traction.as_deref(), contact.spacing, &depths)
        .map_err(|error| outside(&error))?;
    let mises = field
        .von_mises(args.poisson)
        .map_err(|error| outside(&error))?;
    let none = || Failure::new(Code::E501, "a stress field without values");
    let yield_zone = match args.elastic_limit {
        Some(limit) => {
            let plastic = plastic_stress(&mises, limit).map_err(|error| outside(&error))?;
            field.yield_zone(&plastic)
        }
        None => None,
    };
    let result = Stress {
        von_mises: field.peak(&mises).ok_or_else(none)?,
        shear: field.peak(&field.max_shear()).ok_or_else(none)?,
        yield_zone,
        has_limit: args.elastic_limit.is_some(),
        first: contact.x[0],
    };
    save(path, table(&field, &mises, contact).as_bytes())?;
    Ok(result)
}

/// Table of x, z, the stresses in the plane and the von Mises stress per point.
fn table(field: &StressField, mises: &[f64], contact: &SolvedContact) -> String {
    let mut text = String::from("x_m,z_m,sigma_xx_pa,sigma_zz_pa,tau_xz_pa,von_mises_pa\n");
    for (index, mises) in mises.iter().enumerate() {
        text.push_str(&format!(
            "{:e},{:e},{:e},{:e},{:e},{mises:e}\n",
            contact.x[index % field.points],
            field.depths[index / field.points],
            field.sigma_xx[index],
            field.sigma_zz[index],
            field.tau_xz[index],
        ));
    }
    text
}

impl Stress {
    fn peak_json(&self, peak: &Peak) -> Value {
        json!({
            "value_pa": peak.value.si(),
            "x_m": self.first + peak.position.si(),
            "z_m": peak.depth.si(),
        })
    }

    /// The largest values as JSON.
    pub fn json(&self) -> Value {
        let zone = self.yield_zone.map(|zone| {
            json!({
                "points": zone.points,
                "shallowest_m": zone.shallowest.si(),
                "deepest_m": zone.deepest.si(),
                "first_m": self.first + zone.first.si(),
                "last_m": self.first + zone.last.si(),
            })
        });
        json!({
            "von_mises_max": self.peak_json(&self.von_mises),
            "shear_max": self.peak_json(&self.shear),
            "yield_zone": zone,
        })
    }

    /// The largest values, and the depths at which the elastic limit is exceeded.
    pub fn lines(&self) -> Vec<String> {
        let peak = |name: &str, peak: &Peak| {
            let x = Length::from_si(self.first + peak.position.si());
            format!(
                "largest {name} {:.6} at x {x:.4}, {:.4} deep",
                peak.value, peak.depth
            )
        };
        let mut lines = vec![
            peak("von Mises stress", &self.von_mises),
            peak("shear stress", &self.shear),
        ];
        lines.extend(match (&self.yield_zone, self.has_limit) {
            (Some(zone), _) => Some(format!(
                "elastic limit exceeded from {:.4} to {:.4} deep",
                zone.shallowest, zone.deepest
            )),
            (None, true) => Some("elastic limit exceeded nowhere".to_owned()),
            (None, false) => None,
        });
        lines
    }
}
