//! The study of a plan of traction measurements.

use asperity_core::Fault;
use asperity_report::{StudySettings, Watch, Work};

use super::plan::OilPlan;
use super::studies::{OilOfCase, OilPlanSettings};
use crate::evidence::EvidenceTable;

impl StudySettings for OilPlanSettings {
    type Input = OilOfCase;
    type Found = OilPlan;
    const COMMAND: &'static str = "oil plan";
    const FUNCTION: &'static str = "oil_plan";
    const FOLDER: &'static str = "plan";
    const ABOUT: &'static str = "Traction measurements that would determine the constants of an oil, with the errors they would leave";
    const EXAMPLES: &'static [&'static [(&'static str, &'static str)]] =
        &[&[("oil", "m100")], &[("oil", "case.toml")]];
    const METHOD: &'static str = "plan.csv in the result is the table to fill in for asperity oil fit. With a case, the error of its loss \
        by the constants is listed too, and the points are chosen that narrow it most.";
    const STEPS: &'static str = "";

    fn work(&self, _: &OilOfCase) -> Result<Option<Work>, Fault> {
        Ok(None)
    }

    fn run(&self, given: OilOfCase, watch: &Watch<'_>) -> Result<OilPlan, Fault> {
        let plan = OilPlan::new(&given.oil, given.case.as_ref(), &self.plan()?)?;
        let remaining_width = match given.case {
            // The interval of a case has the constants of its oil.
            Some(case) if given.is_of_case => {
                EvidenceTable::of_standard_plan(case, watch.progress)?
            }
            _ => None,
        };
        Ok(OilPlan {
            remaining_width,
            ..plan
        })
    }
}
