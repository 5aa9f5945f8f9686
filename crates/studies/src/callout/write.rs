//! Output of a call-out: `callout.json`, tables, page and summary.

use std::path::Path;

use asperity_core::Fault;
use asperity_report::StudyResult;
use asperity_report::tables::write as write_table;

use super::page;
use super::study::CallOut;
use super::summary::summary;

impl StudyResult for CallOut {
    const KIND: &'static str = "call-out";
    const NAME: &'static str = "callout";
    type Context<'a> = ();

    fn summary(&self, (): ()) -> String {
        summary(self)
    }

    fn page(&self, (): ()) -> String {
        page::render(self)
    }

    fn write_tables(&self, (): (), folder: &Path) -> Result<(), Fault> {
        write_table(&folder.join("limits.csv"), &self.limits)?;
        write_table(&folder.join("parameters.csv"), &self.parameters)?;
        write_table(&folder.join("traces.csv"), &self.by_traces)?;
        write_table(&folder.join("curve.csv"), &self.curve)
    }
}
