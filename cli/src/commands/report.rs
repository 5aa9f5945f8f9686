//! `asperity report`: redraws the page of a result.

use asperity_report::{ReportError, redraw};

use crate::args::{Common, ReportArgs};
use crate::failure::Failure;
use crate::output::{print_json, print_text, shown};

/// `asperity report`
pub fn report(args: &ReportArgs, common: &Common) -> Result<(), Failure> {
    let page = redraw(&args.result, args.position).map_err(|error| refused(&error))?;
    if common.json {
        return print_json(&serde_json::json!({ "report": page }));
    }
    print_text(common, &format!("wrote {}\n", shown(&page)))
}

fn refused(error: &ReportError) -> Failure {
    let code = match error {
        ReportError::NotAResult { .. }
        | ReportError::Damaged { .. }
        | ReportError::BadTable { .. }
        | ReportError::NoValue { .. }
        | ReportError::NoFields { .. }
        | ReportError::NoSuchPosition { .. } => "E402",
        ReportError::NotFinite { .. } => "E501",
        _ => "E401",
    };
    Failure::new(code, error.to_string())
}
