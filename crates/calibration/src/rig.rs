//! Rig table prepared for the fit: operating points, assemblies, and the model at the points.

use crate::error;
use asperity::LoadedCase;
use asperity::case::CalibratedName;
use asperity_core::Fault;

use asperity_table::RowFault;

use crate::parameters::Parameter;
use crate::problem::{Observation, PointSurfaces};
use crate::response::Region;
use crate::rig_model::{OperatingPoint, PointLosses, Progress, RigModel};
use crate::rig_table::{RigRow, RigTable};
use crate::surfaces::{first_region, surfaces};

/// Case of a name in the column `case` of a table.
#[derive(Debug, Clone)]
pub struct RigCase {
    /// Name in the table; `None` for the case of rows without a name.
    pub name: Option<String>,
    /// The case.
    pub case: LoadedCase,
}

/// Table prepared for its fit.
pub struct Rig {
    /// The table.
    pub table: RigTable,
    /// The fitted parameters.
    pub parameters: Vec<Parameter>,
    /// The model at every operating point.
    pub model: RigModel,
    /// The operating points.
    pub operating_points: Vec<OperatingPoint>,
    /// Index of the operating point of every row.
    pub point_of: Vec<usize>,
    /// The model with the parameters at their centres, at every operating point.
    pub nominal: Vec<PointLosses>,
    /// Title of the first case.
    pub title: String,
    /// Whether a case states losses of a gearbox, which are ignored.
    pub has_gearbox: bool,
}

impl Rig {
    /// Solves the contacts of every torque of `table` and evaluates the model once at every operating point.
    /// The parameters `held` keep the values of the case.
    ///
    /// # Errors
    /// When a row has no case, or the model has no solution at a point.
    pub fn new(
        table: RigTable,
        cases: &[RigCase],
        held: &[CalibratedName],
        progress: Progress<'_>,
    ) -> Result<Self, Fault> {
        let first = cases.first().ok_or_else(|| error::no_case(&table.name))?;
        let parameters = parameters(&first.case, held)?;
        let mut operating_points: Vec<OperatingPoint> = Vec::new();
        let mut point_of = Vec::with_capacity(table.rows.len());
        for row in &table.rows {
            let case = cases.iter().position(|case| case.name == row.case);
            let case = case.ok_or_else(|| error::no_case(&table.name))?;
            let point = OperatingPoint {
                case,
                at: [row.torque_nm, row.speed_rpm, row.temperature_c],
            };
            let known = operating_points.iter().position(|other| *other == point);
            point_of.push(known.unwrap_or(operating_points.len()));
            if known.is_none() {
                operating_points.push(point);
            }
        }
        let all: Vec<LoadedCase> = cases.iter().map(|case| case.case.clone()).collect();
        let mut solved = operating_points.clone();
        if let (Some(most), Some(first)) = (table.reach.torque_max_nm, operating_points.first()) {
            let [torque, speed, temperature] = first.at;
            solved.push(OperatingPoint {
                at: [most.copysign(torque), speed, temperature],
                ..*first
            });
        }
        let model = RigModel::new(&all, &parameters, &solved)?.at_points(&operating_points);
        let centre = vec![0.0; parameters.len() + 1];
        let nominal = model
            .evaluate(&[centre], progress)?
            .into_iter()
            .flatten()
            .collect();
        let title = first.case.case.title.clone();
        Ok(Self {
            table,
            parameters,
            model,
            operating_points,
            point_of,
            nominal,
            title,
            has_gearbox: all.iter().any(|case| case.case.gearbox.is_some()),
        })
    }

    /// The first response surfaces, about the centres of the parameters.
    ///
    /// # Errors
    /// When the model has no solution at a point.
    pub fn first_surfaces(
        &self,
        progress: Progress<'_>,
    ) -> Result<(Region, Vec<PointSurfaces>), Fault> {
        let region = first_region(&self.parameters);
        let made = surfaces(&self.model, &region, progress)?;
        Ok((region, made))
    }

    /// Measurements of `rows`: rows of the table, possibly with other losses.
    #[must_use]
    pub fn observations(&self, rows: &[RigRow]) -> Vec<Observation> {
        let assemblies = self.table.assemblies();
        let number = |row: &RigRow| assemblies.iter().position(|name| *name == row.assembly);
        rows.iter()
            .zip(&self.point_of)
            .map(|(row, point)| Observation::new(row, *point, number(row).unwrap_or_default()))
            .collect()
    }

    /// Standard deviations of the priors of the parameters.
    #[must_use]
    pub fn priors(&self) -> Vec<f64> {
        self.parameters
            .iter()
            .map(|parameter| parameter.prior)
            .collect()
    }

    /// Rejects rows whose loss is several times the loss of the model, or a small part of it.
    ///
    /// # Errors
    /// When there are such rows.
    pub fn check_size(&self) -> Result<(), Fault> {
        /// Ratio that no set of parameters reaches; the unit of the loss must be wrong.
        const FACTOR: f64 = 5.0;
        let rows = self.table.rows.iter().zip(&self.point_of);
        let faults: Vec<RowFault> = rows
            .filter_map(|(row, point)| {
                let parts = &self.nominal[*point];
                let model = parts.sliding_w + parts.rolling_w;
                let ratio = row.loss_w / model;
                let holds = (FACTOR.recip()..=FACTOR).contains(&ratio);
                (!holds).then(|| RowFault {
                    line: row.line,
                    column: "loss_w".into(),
                    rule: format!(
                        "{:.4} W is {ratio:.2} times the {model:.1} W predicted by the model; a unit, the scope or the case is wrong",
                        row.loss_w
                    ),
                })
            })
            .collect();
        if faults.is_empty() {
            Ok(())
        } else {
            Err(error::rows(&self.table.name, &faults))
        }
    }
}

/// Parameters of a case that are not held.
///
/// # Errors
/// When there is no such parameter.
pub fn parameters(case: &LoadedCase, held: &[CalibratedName]) -> Result<Vec<Parameter>, Fault> {
    let of_case =
        Parameter::all(case).map_err(|error| Fault::from(error).about(&case.case.title))?;
    let free: Vec<Parameter> = of_case
        .into_iter()
        .filter(|parameter| !held.contains(&parameter.name))
        .collect();
    if free.is_empty() {
        Err(error::no_parameter(&case.case.title))
    } else {
        Ok(free)
    }
}
