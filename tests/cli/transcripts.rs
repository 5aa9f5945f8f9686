//! The transcripts in the documents are what the program prints.
//!
//! Every ```` ```sh ```` block of a document runs, line by line, in a folder of its own; every line of
//! the ```` ```text ```` block after it must be printed, in this order. A block with a file name after its language, as
//! ```` ```toml my_case.toml ````, is that file. After a change of results
//! `UPDATE_TRANSCRIPTS=1 cargo test -p asperity-tests --test cli transcripts` writes the new numbers
//! into the old lines.

use std::cell::RefCell;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use asperity_tests::markdown::{blocks, shell_words};

use crate::bench::{Bench, root};
use crate::first_screens::is_first_screen;

#[path = "../../crates/report/examples/own_law.rs"]
#[allow(dead_code, reason = "its main function is the example")]
mod own_law;

/// A folder in which documents run; a line that two of them show runs once.
pub struct Session {
    bench: Bench,
    printed: RefCell<HashMap<String, Option<String>>>,
}

impl From<Bench> for Session {
    fn from(bench: Bench) -> Self {
        let printed = RefCell::default();
        Self { bench, printed }
    }
}

impl Session {
    /// A file or folder in it.
    pub fn path(&self, name: &str) -> PathBuf {
        self.bench.path(name)
    }

    /// What a line prints.
    fn run(&self, line: &str, may_fail: bool) -> Option<String> {
        let line = &line.replacen("cargo run --release -- ", "asperity ", 1);
        let known = self.printed.borrow().get(line).cloned();
        known.unwrap_or_else(|| {
            let printed = run_line(&self.bench, line, may_fail);
            let mut all = self.printed.borrow_mut();
            all.insert(line.to_owned(), printed.clone());
            printed
        })
    }
}

/// Runs a line and gives what it prints; nothing when it is not ours to run.
fn run_line(bench: &Bench, line: &str, may_fail: bool) -> Option<String> {
    let words = shell_words(line);
    let parts: Vec<&str> = words.iter().map(String::as_str).collect();
    let arguments = match parts.as_slice() {
        ["asperity", arguments @ ..] => arguments,
        [
            "cargo",
            "run",
            ..,
            "--example",
            "own_law",
            "--",
            case,
            folder,
        ] => {
            return Some(own_law::own_law(&bench.path(case), &bench.path(folder)).unwrap());
        }
        ["cargo", "run", rest @ ..] => {
            let end = rest.iter().position(|word| *word == "--")?;
            &rest[end + 1..]
        }
        ["sed" | "cp" | "head", ..] => {
            let mut shell = Command::new("sh");
            let shell = shell.args(["-ec", line]).current_dir(bench.path(""));
            let done = shell.output().unwrap();
            assert!(done.status.success(), "{line}");
            return String::from_utf8(done.stdout).ok();
        }
        _ => return None,
    };
    let said = bench.first_screen(arguments);
    assert!(may_fail || said.status == 0, "{line}\n{}", said.err);
    is_first_screen(arguments, &said.out);
    Some(said.out + &said.err)
}

/// A line without what differs from run to run: seconds, and residuals near round-off.
fn settled(line: &str) -> String {
    let line = match line.find(" (worst load error") {
        Some(end) => &line[..end],
        None => line,
    };
    if let Some((written, more)) = line.split_once("   ").filter(|_| line.ends_with("--notes")) {
        return format!("{}   {more}", settled(written));
    }
    let seconds = line
        .strip_suffix(" s")
        .and_then(|rest| rest.rsplit_once(" in "))
        .filter(|(_, number)| number.parse::<f64>().is_ok());
    match seconds {
        Some((rest, _)) => rest.to_owned(),
        None => line.trim_end().to_owned(),
    }
}

/// A line without its numbers.
fn skeleton(line: &str) -> String {
    let number = |c: char| c.is_ascii_digit() || " .-e±".contains(c);
    line.chars().filter(|c| !number(*c)).collect()
}

/// Runs a document; the lines of its transcripts with the lines that the program prints now.
fn replay(session: &Session, document: &str) -> Vec<(String, String)> {
    let blocks = blocks(document);
    let mut pairs = Vec::new();
    let mut printed: Vec<String> = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        match block.language {
            "sh" => {
                let next = blocks.get(index + 1).filter(|next| next.language == "text");
                let is_error = |line: &&str| {
                    let code = line.strip_prefix('E');
                    code.is_some_and(|rest| rest.starts_with(|c: char| c.is_ascii_digit()))
                };
                let may_fail = next.is_some_and(|next| next.lines.iter().any(is_error));
                let output = block
                    .lines
                    .iter()
                    .filter_map(|line| session.run(line, may_fail));
                let output: String = output.collect();
                // What is not run, such as the tests themselves, prints nothing here.
                if !output.is_empty() {
                    printed = output.lines().map(str::to_owned).collect();
                }
            }
            "text" => {
                let mut from = 0;
                for line in &block.lines {
                    let found = printed[from..]
                        .iter()
                        .position(|now| settled(now) == settled(line));
                    let found = found.or_else(|| {
                        printed[from..]
                            .iter()
                            .position(|now| skeleton(now) == skeleton(line))
                    });
                    match found {
                        Some(at) => {
                            pairs.push(((*line).to_owned(), printed[from + at].clone()));
                            from += at + 1;
                        }
                        None => panic!(
                            "{line:?} is not printed; the program prints\n{}",
                            printed.join("\n")
                        ),
                    }
                }
            }
            language => {
                if let Some((_, file)) = language.split_once(' ') {
                    session.bench.write(file, block.lines.join("\n") + "\n");
                }
            }
        }
    }
    pairs
}

/// Runs the document `name`, which shows `least` lines or more; checks or renews them.
pub fn holds(name: &str, session: &Session, least: usize) {
    let file = root().join(name);
    let mut document = fs::read_to_string(&file).unwrap();
    let pairs = replay(session, &document);
    assert!(pairs.len() >= least, "{name} shows {} lines", pairs.len());
    let stale: Vec<_> = pairs
        .iter()
        .filter(|(shown, now)| settled(shown) != settled(now))
        .collect();
    if std::env::var_os("UPDATE_TRANSCRIPTS").is_some() {
        // Pairs stand in the order of the document, in which a line may occur twice.
        let mut from = 0;
        for (shown, now) in &pairs {
            let Some(at) = document[from..].find(&format!("\n{shown}\n")) else {
                continue;
            };
            let line = from + at + 1..from + at + 1 + shown.len();
            from = line.start;
            if settled(shown) != settled(now) {
                document.replace_range(line, now);
            }
        }
        fs::write(&file, document).unwrap();
    } else {
        let lines: Vec<String> = stale
            .iter()
            .map(|(shown, now)| format!("- {shown}\n+ {now}"))
            .collect();
        assert!(stale.is_empty(), "{name} is stale:\n{}", lines.join("\n"));
    }
}

/// A folder with the shipped cases, and a flank under the name that the README gives the reader's own.
pub fn bench() -> Session {
    let bench = Bench::new();
    for folder in ["fixtures/cases", "fixtures/profiles"] {
        fs::create_dir_all(bench.path(folder)).unwrap();
        for entry in fs::read_dir(root().join(folder)).unwrap() {
            let path = entry.unwrap().path();
            let name = Path::new(folder).join(path.file_name().unwrap());
            fs::copy(&path, bench.path(name.to_str().unwrap())).unwrap();
        }
    }
    let flank = root().join("fixtures/profiles/superfinished.csv");
    fs::copy(flank, bench.path("my_flank.csv")).unwrap();
    bench.into()
}

/// Pages with commands, each in an empty folder as a reader has it, and the least number of lines it shows.
macro_rules! pages {
    ($($test:ident: $page:literal $least:literal,)+) => {$(
        #[test]
        fn $test() {
            holds($page, &Bench::new().into(), $least);
        }
    )+};
}

pages! {
    the_page_on_traces_prints_what_it_shows: "docs/howto/profile.md" 12,
    the_page_on_gears_prints_what_it_shows: "docs/howto/gears.md" 9,
    the_page_on_oils_prints_what_it_shows: "docs/howto/oil.md" 20,
    the_page_on_gearboxes_prints_what_it_shows: "docs/howto/trains.md" 2,
    the_chapter_on_the_contact_prints_what_it_shows: "docs/model/contact.md" 2,
    the_page_on_the_paper_prints_what_it_shows: "docs/PAPER.md" 6,
    the_page_of_questions_prints_what_it_shows: "docs/faq.md" 4,
}

#[test]
fn every_page_that_shows_output_is_replayed() {
    let read = |file| fs::read_to_string(root().join("tests/cli").join(file)).unwrap();
    let here = read("transcripts.rs") + &read("gallery.rs");
    for page in asperity_tests::markdown::pages() {
        let text = fs::read_to_string(root().join(&page)).unwrap();
        let shown = blocks(&text);
        let mut pairs = shown.windows(2);
        let has_output = pairs.any(|pair| pair[0].language == "sh" && pair[1].language == "text");
        let is_replayed = here.contains(&format!("\"{page}\""));
        assert!(!has_output || is_replayed, "{page} is not replayed here");
        // Pages that run in one folder make what they need themselves.
        let commands = shown.iter().filter(|block| block.language == "sh");
        let commands: Vec<&str> = commands.flat_map(|block| block.lines.clone()).collect();
        for folder in ["demo", "rig"] {
            let is_named = |line: &&str| line.contains(&format!(" {folder}/"));
            let is_made = |line: &&str| line.ends_with(&format!(" {folder}"));
            let is_there = !commands.iter().any(is_named) || commands.iter().any(is_made);
            assert!(!is_replayed || is_there, "{page}: {folder}");
        }
    }
}

#[test]
fn the_commands_in_the_readme_of_the_demo_run() {
    let bench = Bench::new();
    for file in asperity_fixtures::demo::files().unwrap() {
        bench.write(file.name, file.content);
    }
    // No number is shown, so a small case whose contacts are not solved will do.
    let case = std::fs::read_to_string(bench.path("case.toml")).unwrap();
    assert!(!case.contains("[model]"), "{case}");
    let small = "\n[model]\npositions = 2\noffsets = 2\nload_share = \"lambda-star\"\n";
    bench.write("case.toml", case + small);
    holds("fixtures/src/demo/README.md", &bench.into(), 0);
}

#[test]
fn lines_of_a_shell_are_parted_as_a_shell_parts_them() {
    assert_eq!(
        shell_words("asperity run \"a b.toml\"  # note"),
        ["asperity", "run", "a b.toml"]
    );
    assert_eq!(settled("wrote x in 0.4 s"), settled("wrote x in 12.0 s"));
    assert_ne!(settled("loss 3 W"), settled("loss 4 W"));
}
