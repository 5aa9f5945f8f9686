//! Malicious folders: whatever a manifest, a journal or a hidden folder says, nothing outside the target folder
//! changes, and no file of the user is removed.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::time::{Duration, SystemTime};

use asperity_storage::{StorageError, check_folder, replace_folder, save, write_among};

/// SHA-256 of `mine`.
const SUM_OF_MINE: &str = "3fd30542fe3f61b14bd4a4b2dc0b6fb30fa6f63ebce52dd1778aaa8c4dc02cff";
/// Text of the lock of a draft whose process ended.
const LOCK: &str = "asperity draft of process 1\n";

/// Every file below `folder` with its content.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    let mut found = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let entry = entry.unwrap();
        if entry.file_type().unwrap().is_dir() {
            found.extend(files(&entry.path()))
        } else {
            drop(found.insert(entry.path(), fs::read(entry.path()).unwrap()))
        }
    }
    found
}

fn write(target: &Path) -> Result<(), StorageError> {
    replace_folder(target, "result", |made| save(&made.join("a.txt"), b"new"))
}

fn manifest_of(names: &[&str]) -> String {
    let sums: Vec<String> = names
        .iter()
        .map(|name| format!("{name:?}: [\"{SUM_OF_MINE}\"]"))
        .collect();
    format!(
        "{{\"written_by\": \"asperity 0.1.0\", \"sha256\": {{{}}}}}",
        sums.join(", ")
    )
}

#[test]
fn a_manifest_with_a_name_outside_its_folder_is_not_ours_and_removes_nothing() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    fs::create_dir(at("box")).unwrap();
    fs::write(at("victim.txt"), "mine").unwrap();
    fs::write(at("box/victim.txt"), "mine").unwrap();
    let absolute = at("victim.txt").display().to_string();
    for name in [
        "../victim.txt",
        "../../victim.txt",
        "../../../victim.txt",
        "sub/../../../victim.txt",
        "./a.txt",
        "sub//a.txt",
        "",
        "/",
        absolute.as_str(),
    ] {
        fs::create_dir(at("box/result")).unwrap();
        fs::write(at("box/result/a.txt"), "mine").unwrap();
        fs::write(
            at("box/result/manifest.json"),
            manifest_of(&["a.txt", name]),
        )
        .unwrap();
        let before = files(place.path());
        let refused = write(&at("box/result"));
        assert!(
            matches!(refused, Err(StorageError::NotOurs { .. })),
            "{name:?}: {refused:?}"
        );
        let among = write_among(
            &at("box/result"),
            &[("page.html".to_owned(), b"1".to_vec())],
        );
        assert!(among.is_err(), "{name:?}");
        assert_eq!(files(place.path()), before, "{name:?}");
        fs::remove_dir_all(at("box/result")).unwrap();
    }
}

#[test]
fn a_folder_with_a_manifest_of_another_program_is_kept() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("extension");
    fs::create_dir(&target).unwrap();
    fs::write(target.join("manifest.json"), "{\"name\": \"mine\"}").unwrap();
    let before = files(place.path());
    assert!(matches!(write(&target), Err(StorageError::NotOurs { .. })));
    assert_eq!(files(place.path()), before);
}

#[cfg(unix)]
#[test]
fn a_hidden_folder_without_the_lock_of_a_draft_is_the_users() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    for (folder, lock) in [
        (".asperity-backup", None),
        (".asperity-locked", Some("")),
        (".asperity-textof", Some("my own lock\n")),
        (".asperity-number", Some("asperity draft of process x\n")),
    ] {
        for file in ["new/notes.txt", "old/notes.txt", "notes.txt", "journal"] {
            let file = at(folder).join(file);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, "mine").unwrap();
        }
        fs::write(
            at(folder).join("old/manifest.json"),
            manifest_of(&["notes.txt"]),
        )
        .unwrap();
        fs::write(at(folder).join("making"), "mine").unwrap();
        if let Some(text) = lock {
            fs::write(at(folder).join("lock"), text).unwrap();
        }
        let opened = fs::File::open(at(folder)).unwrap();
        let hour = Duration::from_secs(3600);
        opened.set_modified(SystemTime::now() - hour).unwrap();
    }
    let before = files(place.path());
    check_folder(&at("result"), "result").unwrap();
    assert_eq!(files(place.path()), before);
}

#[test]
fn a_journal_that_names_another_folder_moves_nothing() {
    let outer = tempfile::tempdir().unwrap();
    let place = outer.path().join("box");
    let absolute = outer.path().join("moved").display().to_string();
    for journal in ["../moved", "sub/moved", "..", ".", "", "/", &absolute] {
        let draft = place.join(".asperity-abc123");
        fs::create_dir_all(draft.join("old")).unwrap();
        fs::create_dir_all(place.join("sub")).unwrap();
        fs::write(draft.join("old/notes.txt"), "mine").unwrap();
        fs::write(draft.join("old/a.txt"), "mine").unwrap();
        fs::write(draft.join("old/manifest.json"), manifest_of(&["a.txt"])).unwrap();
        fs::write(draft.join("journal"), journal).unwrap();
        fs::write(draft.join("lock"), LOCK).unwrap();
        let before = files(outer.path());
        check_folder(&place.join("result"), "result").unwrap();
        assert_eq!(files(outer.path()), before, "{journal:?}");
        fs::remove_dir_all(&place).unwrap();
    }
}

#[cfg(unix)]
#[test]
fn a_link_inside_a_draft_is_not_followed() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    fs::create_dir(at("precious")).unwrap();
    fs::write(at("precious/a.txt"), "mine").unwrap();
    for part in ["new", "old"] {
        let folder = at(".asperity-abc123").join(part);
        fs::create_dir_all(&folder).unwrap();
        std::os::unix::fs::symlink(at("precious"), folder.join("link")).unwrap();
        fs::write(folder.join("manifest.json"), manifest_of(&["link/a.txt"])).unwrap();
    }
    fs::write(at(".asperity-abc123/journal"), "precious").unwrap();
    fs::write(at(".asperity-abc123/lock"), LOCK).unwrap();
    check_folder(&at("result"), "result").unwrap();
    assert_eq!(fs::read(at("precious/a.txt")).unwrap(), b"mine");
}

#[cfg(unix)]
#[test]
fn a_pipe_in_place_of_a_file_of_ours_makes_nobody_wait() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    let pipe = |name: &str| {
        let made = std::process::Command::new("mkfifo").arg(at(name)).status();
        assert!(made.unwrap().success());
    };
    for folder in ["result", ".asperity-abc123", ".asperity-def456/old"] {
        fs::create_dir_all(at(folder)).unwrap();
    }
    pipe("result/manifest.json");
    pipe(".asperity-abc123/lock");
    pipe(".asperity-def456/journal");
    fs::write(at(".asperity-def456/lock"), LOCK).unwrap();
    let target = at("result");
    let (sender, receiver) = std::sync::mpsc::channel();
    std::thread::spawn(move || sender.send(check_folder(&target, "result").is_err()));
    assert_eq!(receiver.recv_timeout(Duration::from_secs(10)), Ok(true));
    assert!(at(".asperity-abc123/lock").exists() && at(".asperity-def456/journal").exists());
}
