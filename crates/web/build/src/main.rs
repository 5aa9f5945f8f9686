//! Builds the page of Asperity: one folder that any file server can serve.
//!
//! ```text
//! cargo run --manifest-path crates/web/build/Cargo.toml -- FOLDER
//! ```
//!
//! The bindings are made by the library that wasm-bindgen's own program is built on, at the version that the lock
//! names, so that nothing else has to be installed.

use std::error::Error;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::{env, fs};

use wasm_bindgen_cli_support::Bindgen;

/// Where the page is compiled for.
const TARGET: &str = "wasm32-unknown-unknown";

/// Vectors of 128 bits, which every present browser has; a stack as large as that of a command (1 MB otherwise).
const FLAGS: [&str; 2] = [
    "-Ctarget-feature=+simd128",
    "-Clink-arg=-zstack-size=8388608",
];

/// Name of the script and of the binary.
const NAME: &str = "asperity";

/// Folders that are copied: from where in the repository, to where in the page, with which endings.
const COPIED: [(&str, &str, &[&str]); 4] = [
    ("crates/web/page", "", &["html", "css", "js", "svg"]),
    ("crates/report/src/chart", "", &["css"]),
    ("fixtures/cases", "examples", &["toml"]),
    ("fixtures/profiles", "examples", &["csv"]),
];

/// Pictures of the start, from where in the repository.
const PICTURES: [&str; 3] = [
    "docs/gallery/finishes.svg",
    "docs/figures/band.svg",
    "docs/figures/gates.svg",
];

fn main() -> ExitCode {
    let Some(folder) = env::args_os().nth(1) else {
        eprintln!("name the folder to write, e.g. target/web");
        return ExitCode::from(2);
    };
    match build(Path::new(&folder)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn build(folder: &Path) -> Result<(), Box<dyn Error>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../..")
        .canonicalize()?;
    let binary = compile(&root)?;
    fs::create_dir_all(folder)?;
    Bindgen::new()
        .input_path(&binary)
        .out_name(NAME)
        .web(true)?
        .typescript(false)
        .remove_name_section(true)
        .remove_producers_section(true)
        .generate(folder)?;
    for (from, to, endings) in COPIED {
        copy(&root.join(from), &folder.join(to), endings)?;
    }
    for picture in PICTURES.map(Path::new) {
        let name = picture.file_name().ok_or("a picture has no name")?;
        fs::copy(root.join(picture), folder.join(name))?;
    }
    println!(
        "wrote {}; serve it by any file server, e.g.",
        folder.display()
    );
    println!(
        "  python3 -m http.server --bind 127.0.0.1 --directory {}",
        folder.display()
    );
    Ok(())
}

/// Compiles the crate and gives the place of its binary.
fn compile(root: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let mut flags = env::var("CARGO_ENCODED_RUSTFLAGS").unwrap_or_default();
    for flag in FLAGS {
        if !flags.is_empty() {
            flags.push('\x1f');
        }
        flags.push_str(flag);
    }
    let cargo = env::var_os("CARGO").unwrap_or_else(|| OsString::from("cargo"));
    let done = Command::new(cargo)
        .args(["build", "--release", "--locked", "--target", TARGET])
        .args(["--message-format", "json-render-diagnostics"])
        .arg("--manifest-path")
        .arg(root.join("crates/web/Cargo.toml"))
        .env("CARGO_ENCODED_RUSTFLAGS", flags)
        .stdout(Stdio::piped())
        .stderr(Stdio::inherit())
        .output()?;
    if !done.status.success() {
        return Err(format!(
            "the page could not be compiled; where the target is missing: rustup target add {TARGET}"
        )
        .into());
    }
    let told = String::from_utf8(done.stdout)?;
    let mut binaries = told.lines().rev().filter_map(binary_of);
    binaries
        .next()
        .ok_or_else(|| "cargo named no binary of the page".into())
}

/// The binary that a message of cargo tells of.
fn binary_of(line: &str) -> Option<PathBuf> {
    let message: serde_json::Value = serde_json::from_str(line).ok()?;
    let mut files = message["filenames"].as_array()?.iter();
    let wasm = files.find_map(|file| file.as_str().filter(|name| name.ends_with(".wasm")))?;
    Some(PathBuf::from(wasm))
}

/// Copies the files of these endings.
fn copy(from: &Path, to: &Path, endings: &[&str]) -> std::io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)? {
        let path = entry?.path();
        let ending = path.extension().and_then(|ending| ending.to_str());
        if let (Some(name), Some(ending)) = (path.file_name(), ending)
            && endings.contains(&ending)
        {
            fs::copy(&path, to.join(name))?;
        }
    }
    Ok(())
}
