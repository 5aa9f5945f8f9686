//! Markdown documents of the project: their fenced blocks, links, headings and text.

use std::path::Path;

/// A fenced block of a document.
#[derive(Debug)]
pub struct Block<'a> {
    /// What follows the opening fence.
    pub language: &'a str,
    /// The lines.
    pub lines: Vec<&'a str>,
}

/// The fenced blocks of a document, in order.
pub fn blocks(document: &str) -> Vec<Block<'_>> {
    let mut found: Vec<Block<'_>> = Vec::new();
    let mut is_open = false;
    for line in document.lines() {
        match line.strip_prefix("```") {
            Some(language) => {
                if !is_open {
                    let lines = Vec::new();
                    found.push(Block { language, lines });
                }
                is_open = !is_open;
            }
            None if is_open => {
                if let Some(block) = found.last_mut() {
                    block.lines.push(line);
                }
            }
            None => {}
        }
    }
    found
}

/// The words of a line as a shell would part them; a comment is dropped.
pub fn shell_words(line: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            '#' if !quoted && word.is_empty() => break,
            ' ' if !quoted => {
                if !word.is_empty() {
                    words.push(std::mem::take(&mut word));
                }
            }
            c => word.push(c),
        }
    }
    if !word.is_empty() {
        words.push(word);
    }
    words
}

/// The pages of the project, relative to its root with `/`: at the root, in `docs`, of crates, fixtures and references.
///
/// # Panics
/// When a folder cannot be read.
pub fn pages() -> Vec<String> {
    fn collect(root: &Path, folder: &str, pages: &mut Vec<String>) {
        let entries = std::fs::read_dir(root.join(folder)).unwrap();
        for entry in entries.map(|entry| entry.unwrap()) {
            let name = entry.file_name().into_string().unwrap();
            let path = match folder {
                "" => name.clone(),
                _ => format!("{folder}/{name}"),
            };
            // Folders that builds and readers of the documentation make.
            let is_made = ["target", "results", "node_modules"].contains(&name.as_str());
            if entry.file_type().unwrap().is_dir() {
                if !(is_made || name.starts_with('.')) {
                    collect(root, &path, pages);
                }
            } else if name.ends_with(".md") {
                pages.push(path);
            }
        }
    }
    let mut pages = Vec::new();
    collect(&root(), "", &mut pages);
    pages.sort();
    pages
}

/// The root of the project.
pub fn root() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The lines of a document outside its fenced blocks.
pub fn prose(document: &str) -> Vec<&str> {
    let mut is_open = false;
    let outside = |line: &&str| {
        let is_fence = line.trim_start().starts_with("```");
        is_open ^= is_fence;
        !is_open && !is_fence
    };
    document.lines().filter(outside).collect()
}

/// A line without its code spans.
pub fn without_code(line: &str) -> String {
    line.split('`').step_by(2).collect::<Vec<_>>().join(" ")
}

/// Targets of the links and pictures of a document.
pub fn links(document: &str) -> Vec<String> {
    let mut links = Vec::new();
    for line in prose(document) {
        let line = without_code(line);
        for part in line.split("](").skip(1) {
            let target = part.split(')').next().unwrap_or_default();
            links.push(target.trim().to_owned());
        }
    }
    links
}

/// Anchors of the headings of a document, as code hosts and mdBook make them.
pub fn anchors(document: &str) -> Vec<String> {
    let mut anchors: Vec<String> = Vec::new();
    for line in prose(document) {
        let title = line.trim_start_matches('#');
        if title.len() == line.len() || !title.starts_with(' ') {
            continue;
        }
        let kept = title.trim().chars().filter_map(|c| match c {
            ' ' => Some('-'),
            c if c.is_alphanumeric() || c == '-' || c == '_' => Some(c),
            _ => None,
        });
        let anchor = kept.collect::<String>().to_lowercase();
        let count = anchors.iter().filter(|known| **known == anchor).count();
        anchors.push(match count {
            0 => anchor,
            _ => format!("{anchor}-{count}"),
        });
    }
    anchors
}
