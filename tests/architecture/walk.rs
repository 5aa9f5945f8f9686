//! The ways of an option to its result and of the heights of a trace to the loss, as `walks.txt` draws them.

use std::fs;
use std::path::Path;

use crate::ALLOWED;

/// Maximum number of functions of a way.
const MOST: usize = 12;

/// A function of the way.
struct Step<'a> {
    depth: usize,
    function: &'a str,
    file: &'a str,
}

/// The functions of the way that `title` announces, in their order.
fn steps<'a>(page: &'a str, title: &str) -> Vec<Step<'a>> {
    let (_, after) = page.split_once(title).unwrap();
    let drawn = after.split("```").nth(1).unwrap();
    drawn.lines().skip(1).filter_map(step).collect()
}

fn step(line: &str) -> Option<Step<'_>> {
    let mut words = line.split_whitespace();
    Some(Step {
        depth: line.len() - line.trim_start().len(),
        function: words.next()?,
        file: words.next()?,
    })
}

fn source(file: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    fs::read_to_string(root.join(file)).unwrap()
}

/// Body of a function: up to the brace in the column in which it begins.
fn body<'a>(text: &'a str, function: &str) -> Option<&'a str> {
    let name = format!("fn {function}(");
    let start = text.find(&name)?;
    let line = text[..start].rfind('\n').map_or(0, |end| end + 1);
    let indent = text[line..].len() - text[line..].trim_start().len();
    let end = format!("\n{}}}\n", " ".repeat(indent));
    let length = text[start..].find(&end)?;
    Some(&text[start..start + length])
}

/// The crate of a file.
fn folder(file: &str) -> &str {
    file.split_once("/src/").unwrap().0
}

#[test]
fn an_option_reaches_its_result_in_few_functions_and_none_calls_a_crate_above_it() {
    check("An option of `run` on its way", 1);
}

/// The first function makes the case that the second one takes.
#[test]
fn heights_reach_the_loss_in_few_functions_and_none_calls_a_crate_above_it() {
    check("The heights of a trace on their way", 2);
}

/// Checks a way of `parts`, each of which begins with a function that no other one of the way calls.
fn check(title: &str, parts: usize) {
    let page = source("tests/architecture/walks.txt");
    let steps = steps(&page, title);
    assert_eq!(steps.iter().filter(|step| step.depth == 0).count(), parts);
    assert!((2..=MOST).contains(&steps.len()), "{}", steps.len());
    for (k, step) in steps.iter().enumerate() {
        let Step {
            depth,
            function,
            file,
        } = *step;
        assert!(
            body(&source(file), function).is_some(),
            "{file}: {function}"
        );
        let Some(caller) = steps[..k].iter().rev().find(|above| above.depth < depth) else {
            assert_eq!(depth, 0, "{function} has no caller");
            continue;
        };
        let text = source(caller.file);
        let calls = format!("{function}(");
        let calling = body(&text, caller.function).unwrap();
        assert!(calling.contains(&calls), "{}: {calls}", caller.function);
        let (from, to) = (folder(caller.file), folder(file));
        let allowed = ALLOWED.iter().find(|(of, _)| *of == from).unwrap().1;
        let name = to.trim_start_matches("crates/");
        let package = match name {
            "asperity" => name.to_owned(),
            name => format!("asperity-{name}"),
        };
        let is_below = allowed.contains(&&*package);
        assert!(from == to || is_below, "{from} calls {to}");
    }
}
