//! The archive of the command, as a release has it.

use std::os::unix::fs::PermissionsExt;
use std::process::Command;

use crate::bench::{Bench, program, root};

#[test]
fn the_archive_of_the_command_holds_its_man_page_and_completions() {
    let bench = Bench::new();
    // A program of a test is too large to be compressed in a second.
    let caller = format!("#!/bin/sh\nexec {} \"$@\"\n", program().display());
    bench.write("asperity", caller);
    let file = bench.path("asperity");
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o755)).unwrap();
    let packed = Command::new(root().join(".ci/package-command"))
        .arg("here")
        .args([&file, &bench.path("dist")])
        .status();
    assert!(packed.unwrap().success());
    let unpacked = Command::new("tar")
        .arg("-xzf")
        .arg(bench.path("dist/asperity-here.tar.gz"))
        .current_dir(bench.path("."))
        .status();
    assert!(unpacked.unwrap().success());
    for (name, holds) in [
        ("asperity", "exec"),
        ("LICENSE-MIT", "Permission is hereby granted"),
        ("LICENSE-APACHE", "Apache License"),
        ("asperity.1", ".TH asperity 1"),
        ("completions/asperity.bash", "complete -F _asperity"),
        ("completions/asperity.fish", "complete -c asperity"),
        ("completions/_asperity", "#compdef asperity"),
        ("completions/_asperity.ps1", "Register-ArgumentCompleter"),
        ("completions/asperity.elv", "edit:completion"),
    ] {
        let text = std::fs::read_to_string(bench.path("asperity-here").join(name)).unwrap();
        assert!(text.contains(holds), "{name}");
    }
}
