//! Recovery: the next process restores or removes the drafts of a killed one; files of the user stay.

#![allow(clippy::disallowed_methods, reason = "tests read their own files")]
#![allow(clippy::unwrap_used, reason = "helpers of tests fail as tests do")]

use std::fs;
use std::path::Path;

use asperity_storage::{Draft, StorageError, check_folder, replace_folder, save};

/// Text of the lock of a draft whose process ended.
const LOCK: &str = "asperity draft of process 1\n";

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

fn write(folder: &Path, text: &str) {
    let fill = |made: &Path| -> Result<(), StorageError> {
        fs::write(made.join("a.txt"), text).unwrap();
        Ok(())
    };
    replace_folder(folder, "result", fill).unwrap();
}

#[test]
fn a_folder_that_was_moved_aside_gets_its_name_back() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    write(&at("result"), "old");
    // The state between the two renames of a process that is gone: its lock is free.
    fs::create_dir(at(".asperity-abc123")).unwrap();
    fs::write(at(".asperity-abc123/lock"), LOCK).unwrap();
    fs::write(at(".asperity-abc123/journal"), "result").unwrap();
    fs::create_dir(at(".asperity-abc123/new")).unwrap();
    fs::write(at(".asperity-abc123/new/a.txt"), "new").unwrap();
    fs::rename(at("result"), at(".asperity-abc123/old")).unwrap();
    check_folder(&at("result"), "result").unwrap();
    assert_eq!(names(place.path()), ["result"]);
    assert_eq!(fs::read_to_string(at("result/a.txt")).unwrap(), "old");
}

#[test]
fn drafts_of_the_dead_go_and_all_else_stays() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    for folder in [
        ".asperity-abc123/new",
        ".asperity-mine",
        ".asperity-new456/new",
    ] {
        fs::create_dir_all(at(folder)).unwrap();
    }
    fs::write(at(".asperity-abc123/lock"), LOCK).unwrap();
    fs::write(at(".asperity-abc123/new/half.csv"), "1,").unwrap();
    fs::write(at(".asperity-notes"), "mine").unwrap();
    let alive = Draft::beside(&at("other.csv")).unwrap();
    let name_of_alive = names(place.path());
    save(&at("out.csv"), b"2").unwrap();
    // One is at work, one has no lock yet, the others are not ours.
    let mut kept = name_of_alive;
    kept.push("out.csv".to_owned());
    kept.sort();
    assert_eq!(names(place.path()), kept);
    assert!(!at(".asperity-abc123").exists());
    drop(alive);
    let rest = [
        ".asperity-mine",
        ".asperity-new456",
        ".asperity-notes",
        "out.csv",
    ];
    assert_eq!(names(place.path()), rest);
}

#[cfg(unix)]
#[test]
fn a_draft_killed_before_its_lock_goes_at_the_next_start_once_it_is_old() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    for (folder, age) in [(".asperity-old789", 10), (".asperity-new789", 1)] {
        fs::create_dir(at(folder)).unwrap();
        fs::write(at(folder).join("making"), "").unwrap();
        let then = std::time::SystemTime::now() - std::time::Duration::from_secs(age);
        let folder = fs::File::open(at(folder)).unwrap();
        folder.set_modified(then).unwrap();
    }
    save(&at("out.csv"), b"1").unwrap();
    assert_eq!(names(place.path()), [".asperity-new789", "out.csv"]);
}

#[test]
fn a_file_of_the_user_in_a_replaced_folder_is_refused_and_kept() {
    let place = tempfile::tempdir().unwrap();
    let target = place.path().join("result");
    write(&target, "1");
    for foreign in ["position_99", "position_notes/diary.txt", "notes.txt"] {
        let file = target.join(foreign);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(&file, "mine").unwrap();
        let refused = check_folder(&target, "result");
        assert!(
            matches!(refused, Err(StorageError::NotOurs { .. })),
            "{refused:?}"
        );
        assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
        fs::remove_file(&file).unwrap();
        let _ = fs::remove_dir(target.join("position_notes"));
    }
    fs::write(target.join("a.txt"), "changed by hand").unwrap();
    let refused = check_folder(&target, "result");
    let said = refused.unwrap_err().to_string();
    assert!(
        said.contains(": was changed since it was written"),
        "{said}"
    );
}

#[cfg(unix)]
#[test]
fn links_are_not_followed() {
    let place = tempfile::tempdir().unwrap();
    let at = |name: &str| place.path().join(name);
    write(&at("result"), "1");
    fs::write(at("precious.txt"), "mine").unwrap();
    std::os::unix::fs::symlink(at("precious.txt"), at("link.csv")).unwrap();
    std::os::unix::fs::symlink(at("result"), at("link")).unwrap();
    let is_of_link = |refused: Result<(), StorageError>| {
        let said = refused.unwrap_err().to_string();
        assert!(
            said.contains(": is a link, which is not followed"),
            "{said}"
        );
    };
    is_of_link(save(&at("link.csv"), b"1"));
    let refused = check_folder(&at("link"), "result");
    is_of_link(refused);
    fs::remove_file(at("result/a.txt")).unwrap();
    std::os::unix::fs::symlink(at("precious.txt"), at("result/a.txt")).unwrap();
    assert!(check_folder(&at("result"), "result").is_err());
    assert_eq!(fs::read_to_string(at("precious.txt")).unwrap(), "mine");
}

#[cfg(unix)]
#[test]
fn a_saved_file_has_the_permissions_of_any_other() {
    use std::os::unix::fs::PermissionsExt;
    let place = tempfile::tempdir().unwrap();
    let mode = |name: &str| {
        let metadata = fs::metadata(place.path().join(name)).unwrap();
        metadata.permissions().mode()
    };
    save(&place.path().join("saved"), b"1").unwrap();
    fs::write(place.path().join("plain"), b"1").unwrap();
    assert_eq!(mode("saved"), mode("plain"));
}
