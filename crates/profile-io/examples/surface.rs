//! Reads surfaces and says what was found; with `--raw FOLDER` their heights are written there as doubles.
//!
//! `cargo run -p asperity-profile-io --example surface -- plate.sur`

use std::path::{Path, PathBuf};

use asperity_profile_io::read::{ReadOptions, Surface, read_surface};

fn main() -> std::io::Result<()> {
    let mut files: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let raw = match files.first() {
        Some(first) if first == Path::new("--raw") => {
            let folder = files.get(1).cloned();
            files.drain(..2.min(files.len()));
            folder
        }
        _ => None,
    };
    // Files without units are taken in metres: they are compared number by number.
    let without_unit = ReadOptions {
        z_unit: "m".parse().ok(),
        ..ReadOptions::default()
    };
    for file in files {
        let found = read_surface(&file, &ReadOptions::default());
        let found = match found {
            Err(error) if error.code() == "E104" => read_surface(&file, &without_unit),
            found => found,
        };
        match found {
            Ok(surface) => {
                println!("{}\tread\t{}", file.display(), described(&surface));
                if let (Some(folder), Some(name)) = (&raw, file.file_name()) {
                    let bytes: Vec<u8> = surface.z.iter().flat_map(|z| z.to_le_bytes()).collect();
                    let name = name.to_string_lossy();
                    std::fs::write(folder.join(format!("{name}.f64")), bytes)?;
                }
            }
            Err(error) => println!("{}\trefused\t{} {error}", file.display(), error.code()),
        }
    }
    Ok(())
}

fn described(surface: &Surface) -> String {
    let length =
        |spacing: Option<asperity_core::quantity::Length>| spacing.map_or(f64::NAN, |l| l.si());
    format!(
        "{}\t{}\t{}\t{:e}\t{:e}\t{}",
        surface.format,
        surface.columns,
        surface.rows,
        length(surface.dx),
        length(surface.dy),
        surface.measured()
    )
}
