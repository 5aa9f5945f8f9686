//! `asperity report`: redraws the page of a result.

use asperity_report::redraw;

use crate::args::{Common, ReportArgs};
use crate::failure::Failure;
use crate::output::{print, shown};

/// `asperity report`
pub fn report(args: &ReportArgs, common: &Common) -> Result<(), Failure> {
    let page = redraw(&args.result, args.position)?;
    print(
        common,
        || serde_json::json!({ "report": page }),
        || format!("wrote {}\n", shown(&page)),
    )
}
