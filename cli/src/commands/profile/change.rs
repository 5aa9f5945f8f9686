//! Traces before and after a test, read for `asperity profile change`.

use std::path::{Path, PathBuf};

use asperity::message::Warning;
use asperity_core::Code;
use asperity_studies::change::{TracePair, TracePairs};

use super::evaluated::{Note, opened};
use crate::args::{Given, GivenTracePairs, NoLimits, SetArgs, Subject};
use crate::commands::{load_case, result_name};
use crate::failure::Failure;

impl Given for TracePairs {
    type Args = GivenTracePairs;
    type Limits = NoLimits;
    const NAMED_BY: &'static str = "<name of the first trace after>";

    fn read(args: &GivenTracePairs, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        if args.case.is_none() && (!set.keys.is_empty() || set.mesh.is_some()) {
            let text = "--set and --mesh change a case, and none is named with --case";
            return Err(Failure::new(Code::E205, text));
        }
        let files: Vec<&PathBuf> = [&args.before, &args.after]
            .into_iter()
            .chain(&args.more)
            .collect();
        let (pairs, rest) = files.as_chunks::<2>();
        if let [alone] = rest {
            let text = format!(
                "{}: the trace has no second one; each trace before a test needs one after it",
                alone.display()
            );
            return Err(Failure::new(Code::E205, text));
        }
        let pairs = pairs
            .iter()
            .map(|files| pair(files.map(PathBuf::as_path), args));
        let given = Self::new(pairs.collect::<Result<_, Failure>>()?);
        let case = args.case.as_ref().map(|case| load_case(case, set, None));
        Ok(Subject {
            input: match case.transpose()? {
                Some(case) => given.on(case),
                None => given,
            },
            name: result_name(&args.after),
            file: None,
        })
    }
}

fn pair(files: [&Path; 2], args: &GivenTracePairs) -> Result<TracePair, Failure> {
    let mut warnings = Vec::new();
    let mut read = |file: &Path| -> Result<_, Failure> {
        let reading = opened(file, &args.reading, args.base_radius)?;
        let notes = reading.warnings.iter().map(|warning| {
            let note = Note::Read(warning);
            Warning::new(note.code(), format!("{}: {note}", reading.name))
        });
        warnings.extend(notes);
        Ok((reading.name.clone(), reading.profile))
    };
    let [(before, first), (after, second)] = [read(files[0])?, read(files[1])?];
    let mut pair = TracePair::new([&before, &after], [first, second]);
    pair.warnings = warnings;
    Ok(pair)
}
