//! `asperity report`: redraws the page of a result.

use asperity_report::redraw;

use crate::args::{Common, ReportArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text, shown};

/// `asperity report`
pub fn report(args: &ReportArgs, common: &Common) -> Result<(), Failure> {
    let page = redraw(&args.result, args.position)?;
    if common.json {
        return print_json(&serde_json::json!({ "report": page }));
    }
    print_text(common, &format!("wrote {}\n", shown(&page)))
}
