//! Converts profile files to X3P: `cargo run --example convert -- flank.csv wheel.prf`.
//!
//! Without arguments it writes a table to a temporary folder and converts that.

use std::error::Error;
use std::path::{Path, PathBuf};

use asperity_profile_io::read::{ReadOptions, read};
use asperity_profile_io::write::{WrittenFormat, write};

fn main() -> Result<(), Box<dyn Error>> {
    let files: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    if files.is_empty() {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("flank.csv");
        std::fs::write(&path, table())?;
        return convert(&path);
    }
    files.iter().try_for_each(|path| convert(path))
}

/// Writes the profile of `path` beside it as X3P.
fn convert(path: &Path) -> Result<(), Box<dyn Error>> {
    let reading = read(path, &ReadOptions::default())?;
    for warning in &reading.warnings {
        println!("{} {warning}", warning.code());
    }
    let target = path.with_extension("x3p");
    let bytes = write(&reading.profile, &reading.metadata, WrittenFormat::X3p)?;
    std::fs::write(&target, &bytes)?;
    let again = read(&target, &ReadOptions::default())?;
    println!(
        "{}: {} points every {} written to {}, {} to the last bit",
        path.display(),
        reading.points,
        reading.spacing,
        target.display(),
        if again.profile == reading.profile {
            "equal"
        } else {
            "not equal"
        },
    );
    Ok(())
}

/// A table as instruments export it.
fn table() -> String {
    let row = |i: u32| {
        let x = 0.0005 * f64::from(i);
        format!("{x:.4};{:.4}\n", 0.4 * (0.063 * f64::from(i)).sin())
    };
    let rows: String = (0..1000).map(row).collect();
    format!("x [mm];z [um]\n{rows}")
}
