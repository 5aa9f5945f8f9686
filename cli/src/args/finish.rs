//! A finish on the command line.

use std::path::PathBuf;

/// Finish with its name and trace files.
#[derive(Debug, Clone)]
pub struct FinishArg {
    /// Name.
    pub name: String,
    /// Mesh of a gear train that has the traces; `None` for all.
    pub mesh: Option<String>,
    /// Trace of the pinion.
    pub pinion: PathBuf,
    /// Trace of the wheel, if it is a separate file.
    pub wheel: Option<PathBuf>,
}

impl std::str::FromStr for FinishArg {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const FORM: &str = "must be a name and one or two files, e.g. ground=pinion.csv,wheel.csv";
        let (name, files) = text.split_once('=').ok_or(FORM)?;
        let (pinion, wheel) = match files.split_once(',') {
            None => (files, None),
            Some((pinion, wheel)) => (pinion, Some(wheel)),
        };
        // A name may begin with @.
        let (name, mesh) = match name.split_once('@').filter(|(name, _)| !name.is_empty()) {
            None => (name, None),
            Some((name, mesh)) => (name, Some(mesh)),
        };
        if [Some(name), mesh, Some(pinion), wheel]
            .into_iter()
            .flatten()
            .any(str::is_empty)
        {
            return Err(FORM);
        }
        Ok(Self {
            name: name.to_owned(),
            mesh: mesh.map(str::to_owned),
            pinion: pinion.into(),
            wheel: wheel.map(PathBuf::from),
        })
    }
}
