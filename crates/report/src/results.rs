//! The results of a run of a case, whatever its number of meshes: of its only mesh, or of a train as a whole and of every mesh.

use std::path::Path;

use asperity::case::train::mesh_folder;
use asperity::message::Warning;
use asperity::result::{MeshOutcome, RunResult};
use asperity::train::{MeshRow, Outcome, Whole};
use asperity_storage::{check_folder, replace_folder, write_among};

use crate::folder::{
    Fields, FileText, check_fields, fill, load_points, make_subfolder, texts_of_mesh, write_bytes,
};
use crate::ridges;
use crate::summary::{brief, headline, replaced_oil, short_text, summary_within, weightiest};
use crate::tiles::{Tile, tiles};
use crate::whole;
use asperity_core::Fault;
use asperity_core::message::gravest_first;

/// Kind of the folder in messages.
const KIND: &str = "result";

/// The results of a run: of the only mesh, or of a train as a whole with its meshes.
#[derive(Debug, Clone, Copy)]
pub struct Results<'a> {
    /// The train as a whole; `None` if a mesh is all of it.
    whole: Option<&'a Whole>,
    meshes: &'a [MeshOutcome],
}

impl<'a> From<&'a MeshOutcome> for Results<'a> {
    fn from(mesh: &'a MeshOutcome) -> Self {
        Self {
            whole: None,
            meshes: std::slice::from_ref(mesh),
        }
    }
}

impl<'a> From<&'a Outcome> for Results<'a> {
    fn from(run: &'a Outcome) -> Self {
        Self {
            whole: run.only().is_none().then_some(&run.whole),
            meshes: &run.meshes,
        }
    }
}

/// Checks that a result may be written as folder `target`: `target` does not exist, is empty, or holds an unchanged
/// earlier result, which is replaced as a whole.
///
/// # Errors
/// When `target` holds something else.
pub fn check_place(target: &Path) -> Result<(), Fault> {
    Ok(check_folder(target, KIND)?)
}

/// Writes the results of a run as folder `target`.
///
/// The folder of a mesh holds `result.json`, `path.csv`, `load.csv`, tables of losses, friction laws and offsets, and
/// `report.html` with the thinned tables it is drawn from; of scans the tables of [`scans`](crate::scans); with `fields` also
/// `load_map.csv`, tables of the flanks, `convergence.csv`, and a folder `position_NN` for each position. The folder of a train
/// holds `train.json` (`planetary.json` of a case `[planetary]`), `meshes.csv`, `shafts.csv`, `report.html`, and such a folder for each kind of mesh. An earlier result is
/// replaced; anything else is left unchanged and is an error.
///
/// # Errors
/// When a file cannot be written, a position of `fields` does not exist, a number is not finite, or `target`
/// holds something else.
pub fn write_folder<'a>(
    results: impl Into<Results<'a>>,
    target: &Path,
    fields: &Fields,
) -> Result<(), Fault> {
    let results = results.into();
    for mesh in results.meshes {
        check_fields(mesh, fields)?;
    }
    replace_folder(target, KIND, |folder| {
        for (name, text) in results.texts_of_whole()? {
            write_bytes(&folder.join(name), &text)?;
        }
        for (place, mesh) in results.places() {
            let place = match place {
                None => folder.to_owned(),
                Some(place) => folder.join(place),
            };
            if results.whole.is_some() {
                make_subfolder(&place)?;
            }
            fill(mesh, &place, fields)?;
        }
        Ok(())
    })
}

/// The files of [`write_folder`] without fields, in memory, with the folders of the meshes in their names.
///
/// # Errors
/// When a number is not finite.
pub fn texts<'a>(results: impl Into<Results<'a>>) -> Result<Vec<(String, Vec<u8>)>, Fault> {
    let results = results.into();
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    let of_whole = results.texts_of_whole()?.into_iter();
    files.extend(of_whole.map(|(name, text)| (name.to_owned(), text)));
    for (place, mesh) in results.places() {
        for (name, text) in texts_of_mesh(mesh)? {
            files.push((in_place(place.as_deref(), name), text));
        }
    }
    Ok(files)
}

/// Adds all points of the load map of each mesh to its folder in `target`, as `map.csv`.
///
/// # Errors
/// When a file cannot be written.
pub fn write_load_points<'a>(results: impl Into<Results<'a>>, target: &Path) -> Result<(), Fault> {
    let results = results.into();
    let files = results.places().map(|(place, mesh)| {
        let (name, text) = load_points(mesh)?;
        Ok((in_place(place.as_deref(), &name), text))
    });
    let files = files.collect::<Result<Vec<_>, Fault>>()?;
    Ok(write_among(target, &files)?)
}

fn in_place(place: Option<&str>, name: &str) -> String {
    place.map_or_else(|| name.to_owned(), |place| format!("{place}/{name}"))
}

impl<'a> Results<'a> {
    fn texts_of_whole(self) -> Result<Vec<FileText>, Fault> {
        match self.whole {
            Some(whole) => whole::texts(whole, &self.warnings()),
            None => Ok(Vec::new()),
        }
    }

    /// Every mesh, with its folder in the folder of the whole.
    fn places(self) -> impl Iterator<Item = (Option<String>, &'a MeshOutcome)> {
        let rows = self.whole.map_or(&[][..], |whole| &whole.meshes).iter();
        let places = rows.map(|row| Some(mesh_folder(&row.mesh)));
        places.chain(std::iter::repeat(None)).zip(self.meshes)
    }

    /// The meshes of a train with their rows.
    fn named(self, whole: &'a Whole) -> impl Iterator<Item = (&'a MeshRow, &'a RunResult)> {
        let runs = self.meshes.iter().map(|mesh| &mesh.result);
        whole.meshes.iter().zip(runs)
    }

    fn runs(self) -> impl Iterator<Item = &'a RunResult> {
        self.meshes.iter().map(|mesh| &mesh.result)
    }

    /// All warnings, in a train with the names of the meshes.
    fn warnings(self) -> Vec<Warning> {
        let Some(whole) = self.whole else {
            return self.runs().flat_map(|run| run.warnings.clone()).collect();
        };
        let meshes = self.named(whole);
        let of_meshes = meshes.flat_map(|(row, run)| {
            let warnings = run.warnings.iter();
            warnings.map(move |warning| of_mesh(warning, row))
        });
        let mut all: Vec<Warning> = whole.warnings.iter().cloned().chain(of_meshes).collect();
        gravest_first(&mut all, |warning| Some(warning.code));
        all
    }

    /// The line with efficiency and loss, as in [`brief`](Self::brief) and [`summary`](Self::summary).
    #[must_use]
    pub fn headline(self) -> String {
        match self.whole {
            Some(whole) => whole::headline(whole),
            None => self.runs().map(headline).collect(),
        }
    }

    /// The result in `columns`, with all warnings.
    #[must_use]
    pub fn summary(self, columns: usize) -> String {
        let Some(whole) = self.whole else {
            let each = self.runs().map(|run| summary_within(run, columns));
            return each.collect();
        };
        let warnings = self.warnings();
        let warnings = warnings.iter().map(ToString::to_string);
        whole::report(whole, warnings).terminal()
    }

    /// The first screen in `columns`, in at most `lines` lines.
    #[must_use]
    pub fn brief(self, columns: usize, lines: usize) -> String {
        let Some(whole) = self.whole else {
            let each = self.runs().map(|run| brief(run, columns, lines));
            return each.collect();
        };
        let of_train = whole.warnings.iter().map(|one| short_text(one, columns));
        let of_meshes = self.named(whole).filter_map(|(row, run)| {
            let warning = weightiest(run)?;
            Some(short_text(&of_mesh(&warning, row), columns))
        });
        let ridges = self
            .named(whole)
            .filter_map(|(row, run)| Some(format!("{}: {}", row.mesh, ridges::line(run)?)));
        // All meshes have the oil of the case.
        let oil = self.runs().find_map(|run| replaced_oil(&run.warnings));
        let report = whole::report(whole, of_train.chain(of_meshes));
        let report = report.text(oil).text(ridges);
        report.brief(lines).0
    }

    /// The result with every mesh as `of_mesh` prints it.
    #[must_use]
    pub fn with_each(self, of_mesh: &dyn Fn(&RunResult) -> String) -> String {
        let Some(whole) = self.whole else {
            return self.runs().map(of_mesh).collect();
        };
        let each = self.runs().map(|run| format!("\n{}", of_mesh(run)));
        whole::report(whole, []).terminal() + &each.collect::<String>()
    }

    /// The headline of the result.
    #[must_use]
    pub fn tiles(self) -> Vec<Tile> {
        match self.whole {
            Some(whole) => whole::tiles(whole),
            None => self.runs().flat_map(tiles).collect(),
        }
    }
}

/// A warning with the mesh that it is about.
fn of_mesh(warning: &Warning, mesh: &MeshRow) -> Warning {
    warning.with(&format!(" [{}]", mesh.mesh))
}
