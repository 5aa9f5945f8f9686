//! `asperity evidence`: measurements that would narrow the interval of a loss.

use std::time::Instant;

use asperity::pipeline::KeptFields;
use asperity_calibration::evidence::{Effort, EvidenceTable};
use asperity_core::Code;

use super::work::check_work;
use super::{load_train, result_name, study};
use crate::args::{Common, EvidenceArgs};
use crate::failure::Failure;

/// `asperity evidence`
pub fn evidence(args: &EvidenceArgs, common: &Common) -> Result<(), Failure> {
    let begin = Instant::now();
    let efforts = efforts(&args.hours)?;
    let loaded = load_train(&args.case, &args.set, None)?;
    // The run, and changes of the constants of the oil.
    check_work(&args.work, loaded.cases(), &KeptFields::Highest, 2)?;
    let (name, title) = (result_name(&args.case), &loaded.title);
    let output = args.output.as_deref();
    let folder = study::folder::<EvidenceTable>(output, &name, "evidence", title)?;
    let Some(table) = EvidenceTable::of(&loaded, &efforts)? else {
        let message = "the loss of this case has no interval: formulation = \"paper\" and a solved full film are computed \
                       without one";
        return Err(Failure::new(Code::E205, message));
    };
    study::finish(&table, (), &folder, Some(begin), common)
}

/// The usual hours, changed by the command line.
fn efforts(changes: &[String]) -> Result<Vec<Effort>, Failure> {
    let mut efforts = Effort::usual().to_vec();
    for change in changes {
        let (name, hours) = change.split_once('=').unwrap_or((change, ""));
        let name = name.trim();
        if efforts.iter().all(|effort| effort.key != name) {
            let names = Effort::usual().map(|effort| effort.key).join(", ");
            let message = format!("--hours {change}: no measurement is called \"{name}\"");
            return Err(Failure::new(Code::E209, message)
                .advising(format!("Give NAME=HOURS with one of the names {names}.")));
        }
        let hours = hours.trim().parse().unwrap_or(f64::NAN);
        if !Effort::set(&mut efforts, name, hours) {
            let message =
                format!("--hours {change}: the hours must be a number from 0 to below 1e6");
            return Err(Failure::new(Code::E209, message));
        }
    }
    Ok(efforts)
}
