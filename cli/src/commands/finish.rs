//! A case on the traces of a finish, and its variants.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use asperity::case::CaseInput;
use asperity::case::train::Train;
use asperity_core::{Code, Fault};
use asperity_storage::{regular_file, whole_text};
use asperity_studies::compare::{
    Finish, KeyOrFile, NamedVariant, Variant, WrittenVariant, keys_in, variants,
};
use asperity_studies::sweep::Keys;

use super::{load_text, load_train, source};
use crate::args::{FinishArg, SetArgs};
use crate::failure::Failure;

/// Rejects finishes with equal names, or for the same mesh.
fn check_names(finishes: &[FinishArg]) -> Result<(), Failure> {
    for (index, finish) in finishes.iter().enumerate() {
        let FinishArg { name, mesh, .. } = finish;
        let mut before = finishes[..index].iter();
        if before.any(|other| other.name == *name && other.mesh == *mesh) {
            let message = match mesh {
                None => format!("--finish {name}: two finishes have this name; rename one"),
                Some(mesh) => format!("--finish {name}@{mesh}: stated twice; leave one out"),
            };
            return Err(Failure::new(Code::E205, message));
        }
    }
    Ok(())
}

/// The case with the traces of each finish, and its variants; meshes that a finish does not name keep their flanks.
pub fn finishes(
    case: &Path,
    set: &SetArgs,
    stated: &[FinishArg],
    of_keys: &[String],
) -> Result<Vec<Finish<Train>>, Failure> {
    check_names(stated)?;
    // Read once for all finishes, since standard input can be read only once.
    let (text, folder) = source(case)?;
    let mut names: Vec<&str> = Vec::new();
    for finish in stated {
        if !names.contains(&finish.name.as_str()) {
            names.push(&finish.name);
        }
    }
    let load = |name: &str| {
        let of_name = stated.iter().filter(|finish| finish.name == name);
        let traces = of_name.map(|finish| Ok((finish.mesh.as_deref(), Traces::from_args(finish)?)));
        let traces = traces.collect::<Result<Vec<_>, Failure>>()?;
        let of_all = |input: &mut CaseInput| {
            for (_, traces) in traces.iter().filter(|(mesh, _)| mesh.is_none()) {
                traces.put_into(input);
            }
        };
        let train = load_text(text.clone(), folder, set, &of_all)?;
        let is_of =
            |stated: &str, stage: Option<&str>, mesh: &str| stated == mesh || Some(stated) == stage;
        let named = || {
            traces
                .iter()
                .filter_map(|(mesh, traces)| Some(((*mesh)?, traces)))
        };
        let all = |stated: &str| {
            let stages = train.stages.iter();
            stages
                .flat_map(|stage| {
                    stage
                        .meshes
                        .iter()
                        .map(|mesh| (stage.name.as_deref(), mesh))
                })
                .any(|(stage, mesh)| is_of(stated, stage, &mesh.name))
        };
        if let Some((mesh, _)) = named().find(|(mesh, _)| !all(mesh)) {
            let known = match train.only() {
                Some(_) => "the case has a single mesh".to_owned(),
                None => format!("there is no mesh \"{mesh}\", only {}", train.names()),
            };
            return Err(Failure::new(
                Code::E205,
                format!("--finish {name}@{mesh}: {known}"),
            ));
        }
        if named().next().is_none() {
            return Ok(train);
        }
        let changed = train.with_each(&|stage, mesh, input| {
            for (_, traces) in named().filter(|(stated, _)| is_of(stated, stage, mesh)) {
                traces.put_into(input);
            }
        });
        changed.map_err(|error| Failure::from_error(&error))
    };
    let finish = |name: &&str| {
        let case = load(name).map_err(|error| error.adding(&format!(" (--finish {name})")))?;
        let name = (*name).to_owned();
        Ok(Finish { name, case })
    };
    let found = names
        .iter()
        .map(finish)
        .collect::<Result<Vec<_>, Failure>>()?;
    if of_keys.is_empty() {
        return Ok(found);
    }
    let base = load_text(text.clone(), folder, set, &|_| {})?;
    let written = of_keys.iter().map(|text| variant(text, set));
    let written = written.collect::<Result<Vec<_>, Failure>>()?;
    Ok(variants(&base, found, written)?)
}

/// A variant from its text, with the files that it names.
fn variant(text: &str, set: &SetArgs) -> Result<(String, Variant), Failure> {
    let NamedVariant { name, is } = text.parse()?;
    let is = match is {
        WrittenVariant::Case(path) => {
            let case = load_train(&path, set, None);
            Variant::Case(Box::new(
                case.map_err(|error| error.adding(&format!(" (--variant {name})")))?,
            ))
        }
        WrittenVariant::Keys(entries) => {
            let mut keys = Keys::new();
            for entry in entries {
                match entry {
                    KeyOrFile::Key(key, value) => keys.push((key, value)),
                    KeyOrFile::File(file) => keys.extend(keys_of(&file, &name)?),
                    _ => {}
                }
            }
            Variant::Keys(keys)
        }
        _ => Variant::AsIs,
    };
    Ok((name, is))
}

/// The keys in a file.
fn keys_of(file: &Path, name: &str) -> Result<Keys, Failure> {
    /// Bytes of the largest file of keys.
    const LARGEST: u64 = 10_000_000;
    let text = whole_text(file, LARGEST).map_err(|error| {
        let fault = Fault::unopened(file.display(), error);
        let help = "Write each key of a variant as KEY=VALUE, or name a file of keys.";
        fault.adding(&format!(" (--variant {name})")).helping(help)
    })?;
    Ok(keys_in(&text).map_err(|fault| fault.about(file.display()))?)
}

/// Traces of a finish by absolute path.
pub struct Traces {
    pinion: PathBuf,
    wheel: Option<PathBuf>,
}

impl Traces {
    /// The traces that `finish` names.
    pub fn from_args(finish: &FinishArg) -> Result<Self, Failure> {
        let name = &finish.name;
        let whole = |file: &PathBuf| {
            // Reported here, because the case does not name this file.
            if let Err(error) = regular_file(file) {
                let reason = match error.kind() {
                    ErrorKind::NotFound => "there is no such file".to_owned(),
                    _ => error.to_string(),
                };
                let message = format!("{}: {reason} (named by --finish {name})", file.display());
                return Err(Failure::new(Code::E103, message));
            }
            std::path::absolute(file)
                .map_err(|error| Failure::new(Code::E103, format!("{}: {error}", file.display())))
        };
        Ok(Self {
            pinion: whole(&finish.pinion)?,
            wheel: finish.wheel.as_ref().map(whole).transpose()?,
        })
    }

    /// Replaces the traces of the case; a single trace is used for both flanks, mirrored for the wheel.
    pub fn put_into(&self, input: &mut CaseInput) {
        input
            .surface
            .put_traces(&self.pinion, self.wheel.as_deref());
    }
}
