//! Imports between the files of a crate, read from its sources.
//!
//! A file imports another when it names one of the other's items by a path that begins with `crate`,
//! `self`, `super` or one of its own modules. Re-exports are followed to the file that defines the
//! item, so a parent that only lists and re-exports its children does not close a circle with them.
//! Comments, strings and modules that exist in tests only do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// Path of a module from the root of its crate, without `crate`.
type Module = Vec<String>;

/// One source file.
#[derive(Default)]
struct Source {
    file: String,
    /// Names of child modules in files of their own.
    children: BTreeSet<String>,
    /// Names of modules written out in this file.
    inline: BTreeSet<String>,
    /// Imported paths: full path, name it goes by here, whether it is re-exported.
    imports: Vec<(Vec<String>, String, bool)>,
    /// Paths written out where they are used.
    mentions: Vec<Vec<String>>,
    /// Macros used by a path.
    macros: BTreeSet<String>,
    /// Macros defined here.
    own_macros: BTreeSet<String>,
}

/// Groups of files that import each other in a circle, of the crate with these `sources`.
pub fn circles(sources: &Path) -> Vec<Vec<String>> {
    let tops = ["lib.rs", "main.rs"].into_iter();
    tops.filter(|top| sources.join(top).exists())
        .flat_map(|top| {
            let mut files = BTreeMap::new();
            read(sources, top, &[], &mut files);
            let edges = files
                .iter()
                .map(|(module, source)| (source.file.clone(), targets(&files, module, source)))
                .collect();
            strong_components(&edges)
        })
        .collect()
}

/// The modules at the top of a crate as layers: each below those that import it.
pub struct Layers {
    /// Modules of the longest chain of imports, the uppermost first.
    pub longest: Vec<String>,
    /// Imports that close a circle of modules.
    pub upward: Vec<String>,
}

/// Layers of the crate with these `sources`, of its modules at the top with all files below them.
pub fn layers(sources: &Path) -> Layers {
    let mut files = BTreeMap::new();
    let top = ["lib.rs", "main.rs"].into_iter();
    for top in top.filter(|top| sources.join(top).exists()) {
        read(sources, top, &[], &mut files);
    }
    let module_of = |file: &str| {
        let first = file.split('/').next().unwrap_or(file);
        first.trim_end_matches(".rs").to_owned()
    };
    let is_top = |module: &String| module == "lib" || module == "main";
    let mut edges: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    for (module, source) in &files {
        let from = module_of(&source.file);
        let to = targets(&files, module, source);
        let to = to.iter().map(|file| module_of(file));
        let to = to.filter(|to| *to != from && !is_top(to));
        edges.entry(from.clone()).or_default().extend(to);
    }
    edges.retain(|module, _| !is_top(module));
    let circles = strong_components(&edges);
    let closes = |from: &String, to: &String| {
        let mut circles = circles.iter();
        circles.any(|circle| circle.contains(from) && circle.contains(to))
    };
    let mut upward = Vec::new();
    for (from, to) in &edges {
        let closing = to.iter().filter(|to| closes(from, to));
        upward.extend(closing.map(|to| format!("{from} -> {to}")));
    }
    let mut longest = Vec::new();
    if upward.is_empty() {
        let mut known = BTreeMap::new();
        for module in edges.keys() {
            let chain = chain_below(module, &edges, &mut known);
            if chain.len() > longest.len() {
                longest = chain;
            }
        }
    }
    Layers { longest, upward }
}

/// Longest chain of imports from a module, of modules without a circle.
fn chain_below(
    module: &String,
    edges: &BTreeMap<String, BTreeSet<String>>,
    known: &mut BTreeMap<String, Vec<String>>,
) -> Vec<String> {
    if let Some(chain) = known.get(module) {
        return chain.clone();
    }
    let mut longest = Vec::new();
    for next in edges.get(module).into_iter().flatten() {
        let chain = chain_below(next, edges, known);
        if chain.len() > longest.len() {
            longest = chain;
        }
    }
    longest.insert(0, module.clone());
    known.insert(module.clone(), longest.clone());
    longest
}

/// Reads a file and all its children.
fn read(root: &Path, file: &str, module: &[String], files: &mut BTreeMap<Module, Source>) {
    let text = fs::read_to_string(root.join(file)).unwrap();
    let tokens = without_tests(tokens(&text));
    let mut source = parse(&tokens);
    source.file = file.to_owned();
    let folder = match file.strip_suffix(".rs").unwrap() {
        "lib" | "main" => String::new(),
        stem => format!("{}/", stem.strip_suffix("/mod").unwrap_or(stem)),
    };
    for child in &source.children {
        let found = [
            format!("{folder}{child}.rs"),
            format!("{folder}{child}/mod.rs"),
        ];
        // A module with a path attribute of its own is none of the house's.
        if let Some(found) = found.iter().find(|name| root.join(name).exists()) {
            let child = [module, std::slice::from_ref(child)].concat();
            read(root, found, &child, files);
        }
    }
    files.insert(module.to_vec(), source);
}

/// Words and single marks, without comments and the contents of strings.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens = vec![];
    let chars: Vec<char> = text.chars().collect();
    let at = |i: usize| chars.get(i).copied().unwrap_or('\0');
    let mut i = 0;
    while i < chars.len() {
        let c = chars[i];
        if c == '/' && at(i + 1) == '/' {
            while i < chars.len() && chars[i] != '\n' {
                i += 1;
            }
        } else if c == '/' && at(i + 1) == '*' {
            while i < chars.len() && !(chars[i] == '*' && at(i + 1) == '/') {
                i += 1;
            }
            i += 2;
        } else if c == '"' {
            i += 1;
            while i < chars.len() && chars[i] != '"' {
                i += if chars[i] == '\\' { 2 } else { 1 };
            }
            i += 1;
        } else if c == 'r' && matches!((at(i + 1), at(i + 2)), ('"', _) | ('#', '"' | '#')) {
            let hashes = chars[i + 1..].iter().take_while(|&&c| c == '#').count();
            let end: Vec<char> = std::iter::once('"')
                .chain(std::iter::repeat_n('#', hashes))
                .collect();
            i += hashes + 2;
            while i < chars.len() && !chars[i..].starts_with(&end) {
                i += 1;
            }
            i += end.len();
        } else if c == '\'' && (at(i + 2) == '\'' || at(i + 1) == '\\') {
            // A character; lifetimes have no second quote.
            i += if at(i + 1) == '\\' { 3 } else { 2 };
            while i < chars.len() && chars[i] != '\'' {
                i += 1;
            }
            i += 1;
        } else if c.is_alphanumeric() || c == '_' || c == '$' {
            let first = i;
            while i < chars.len() && (chars[i].is_alphanumeric() || "_$".contains(chars[i])) {
                i += 1;
            }
            tokens.push(chars[first..i].iter().collect());
        } else if c == ':' && at(i + 1) == ':' {
            tokens.push("::".to_owned());
            i += 2;
        } else {
            if !c.is_whitespace() {
                tokens.push(c.to_string());
            }
            i += 1;
        }
    }
    tokens
}

/// Leaves out the items behind `#[cfg(test)]` and `#[cfg(doctest)]`.
fn without_tests(tokens: Vec<String>) -> Vec<String> {
    let mut kept = vec![];
    let mut i = 0;
    while i < tokens.len() {
        let attribute: String = tokens[i..].iter().take(7).map(String::as_str).collect();
        if !matches!(&*attribute, "#[cfg(test)]" | "#[cfg(doctest)]") {
            kept.push(tokens[i].clone());
            i += 1;
            continue;
        }
        i += 7;
        // To the end of the item: its semicolon or its braces.
        let mut depth = 0;
        while i < tokens.len() {
            match tokens[i].as_str() {
                "{" => depth += 1,
                "}" => depth -= 1,
                _ => {}
            }
            let ends = matches!(tokens[i].as_str(), ";" | "}");
            i += 1;
            if depth == 0 && ends {
                break;
            }
        }
    }
    kept
}

fn parse(tokens: &[String]) -> Source {
    let mut source = Source::default();
    let word = |i: usize| tokens.get(i).map_or("", String::as_str);
    let mut i = 0;
    while i < tokens.len() {
        match word(i) {
            "mod" if word(i + 2) == ";" => {
                source.children.insert(word(i + 1).to_owned());
            }
            "mod" if word(i + 2) == "{" => {
                source.inline.insert(word(i + 1).to_owned());
            }
            "macro_rules" => {
                source.own_macros.insert(word(i + 2).to_owned());
            }
            "use" if i == 0 || matches!(word(i - 1), ";" | "}" | "{" | "]" | "pub" | ")") => {
                let public = i > 0 && matches!(word(i - 1), "pub" | ")");
                let end = i + tokens[i..].iter().take_while(|token| *token != ";").count();
                let mut found = vec![];
                expand(&tokens[i + 1..end], &[], &mut found);
                let imports = found.into_iter().map(|(path, name)| (path, name, public));
                source.imports.extend(imports);
                i = end;
            }
            _ if word(i + 1) == "::" && (i == 0 || word(i - 1) != "::") => {
                let mut path = vec![word(i).to_owned()];
                while word(i + 1) == "::" && !matches!(word(i + 2), "<" | "{" | "*") {
                    path.push(word(i + 2).to_owned());
                    i += 2;
                }
                // A macro is found by its name wherever it is defined.
                match word(i + 1) {
                    "!" => source.macros.extend(path.pop()),
                    _ => source.mentions.push(path),
                }
            }
            _ => {}
        }
        i += 1;
    }
    source
}

/// The single paths of a tree of imports, each with the name it goes by.
fn expand(tree: &[String], before: &[String], found: &mut Vec<(Vec<String>, String)>) {
    let mut path = before.to_vec();
    let mut name = String::new();
    let mut i = 0;
    while i < tree.len() {
        match tree[i].as_str() {
            "{" => {
                let (mut depth, mut begin) = (0, i + 1);
                for (k, token) in tree.iter().enumerate().skip(i) {
                    match token.as_str() {
                        "{" => depth += 1,
                        "}" => depth -= 1,
                        _ => {}
                    }
                    if (token == "," && depth == 1) || depth == 0 {
                        if begin < k {
                            expand(&tree[begin..k], &path, found);
                        }
                        begin = k + 1;
                    }
                    if depth == 0 {
                        break;
                    }
                }
                return;
            }
            "as" => {
                name.clone_from(&tree[i + 1]);
                break;
            }
            "::" | "," => {}
            "self" if !path.is_empty() => {}
            token => path.push(token.to_owned()),
        }
        i += 1;
    }
    if name.is_empty() {
        name = path.last().cloned().unwrap_or_default();
    }
    found.push((path, name));
}

/// Files that the items named in `source` are defined in, but for its own.
fn targets(files: &BTreeMap<Module, Source>, module: &Module, source: &Source) -> BTreeSet<String> {
    let imports = source.imports.iter().map(|(path, _, _)| path);
    let of_macros = files
        .values()
        .filter(|file| !file.own_macros.is_disjoint(&source.macros))
        .map(|file| file.file.clone());
    imports
        .chain(&source.mentions)
        .filter_map(|path| absolute(module, source, path))
        .map(|path| files[&definition(files, &path, 0)].file.clone())
        .chain(of_macros)
        .filter(|file| *file != source.file)
        .collect()
}

/// The path from the root of the crate; none for what is of other crates.
fn absolute(module: &[String], source: &Source, path: &[String]) -> Option<Vec<String>> {
    let (first, rest) = path.split_first()?;
    let from = match first.as_str() {
        "crate" | "$crate" => return Some(rest.to_vec()),
        "self" => module,
        "super" => {
            let above = &module[..module.len().checked_sub(1)?];
            return match rest.first().map(String::as_str) {
                Some("super") => absolute(above, &Source::default(), rest),
                _ => Some([above, rest].concat()),
            };
        }
        name if source.children.contains(name) => return Some([module, path].concat()),
        _ => return None,
    };
    Some([from, rest].concat())
}

/// Module whose file defines what the path from the root of the crate names.
fn definition(files: &BTreeMap<Module, Source>, path: &[String], depth: usize) -> Module {
    let longest = (0..=path.len())
        .rev()
        .find(|&length| files.contains_key(&path[..length]))
        .unwrap_or(0);
    let module = path[..longest].to_vec();
    let source = &files[&module];
    let Some(item) = path.get(longest) else {
        return module;
    };
    // Beyond some re-exports of re-exports something is wrong with the sources.
    if depth > 8 || source.inline.contains(item) {
        return module;
    }
    let reexported = source.imports.iter().filter(|(_, _, public)| *public);
    for (target, name, _) in reexported {
        let all = name == "*";
        if !(all || name == item) {
            continue;
        }
        let Some(mut target) = absolute(&module, source, target) else {
            continue;
        };
        if all {
            target.pop();
            target.push(item.clone());
        }
        return definition(files, &target, depth + 1);
    }
    module
}

/// Groups of more than one file each of which leads to all others.
fn strong_components(edges: &BTreeMap<String, BTreeSet<String>>) -> Vec<Vec<String>> {
    let reached = |from: &String| {
        let mut found = BTreeSet::new();
        let mut open = vec![from.clone()];
        while let Some(file) = open.pop() {
            for next in edges.get(&file).into_iter().flatten() {
                if found.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        found
    };
    let reach: BTreeMap<&String, BTreeSet<String>> =
        edges.keys().map(|file| (file, reached(file))).collect();
    let mut groups: BTreeSet<Vec<String>> = BTreeSet::new();
    for (file, found) in &reach {
        let back = found.iter().filter(|other| reach[other].contains(*file));
        let group: Vec<String> = back.cloned().collect();
        if group.len() > 1 {
            groups.insert(group);
        }
    }
    groups.into_iter().collect()
}

/// A crate of the given files in a folder of its own.
#[cfg(test)]
fn house(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    }
    folder
}

#[test]
fn a_circle_is_found_through_re_exports_and_paths() {
    let house = house(&[
        ("lib.rs", "mod a; mod b; pub use a::One; pub use b::Two;"),
        ("a.rs", "use crate::Two; pub struct One(Two);"),
        ("b.rs", "pub struct Two; fn f() { super::a::One::new(); }"),
    ]);
    assert_eq!(circles(house.path()), [["a.rs", "b.rs"]]);
}

#[test]
fn parents_that_list_their_children_and_tests_close_no_circle() {
    let house = house(&[
        ("lib.rs", "mod a; mod c; pub use a::{One, two::Two};"),
        ("a/mod.rs", "mod one; pub mod two; pub use one::*;"),
        ("a/one.rs", "use super::two::Two; pub struct One(Two);"),
        (
            "a/two.rs",
            "/// crate::One\npub struct Two; const S: &str = \"crate::One\";\n#[cfg(test)] mod tests { use crate::One; }",
        ),
        ("c.rs", "use crate::{One as Uno, a::two::{self, Two}};"),
    ]);
    assert!(circles(house.path()).is_empty());
}

#[test]
fn a_macro_is_of_the_file_that_defines_it() {
    let house = house(&[
        ("lib.rs", "mod a; mod b; pub use a::one;"),
        ("a.rs", "pub fn one() { crate::note!() }"),
        ("b.rs", "macro_rules! note { () => { $crate::one() } }"),
    ]);
    assert_eq!(circles(house.path()), [["a.rs", "b.rs"]]);
}

#[test]
fn a_child_that_uses_what_its_parent_defines_is_a_circle() {
    let house = house(&[
        ("main.rs", "mod a; use a::f; fn help() {}"),
        ("a.rs", "pub fn f() { crate::help() }"),
    ]);
    assert_eq!(circles(house.path()), [["a.rs", "main.rs"]]);
}
