//! `equations`, `explain` and `schema`: reference information of the program.

use asperity::equations::{self, Equation};
use asperity::message::{self, Explanation};
use asperity_core::Code;
use asperity_report::{Described, StudySettings, columns, schema_of_settings};
use asperity_studies::every_study;
use serde_json::{Value, json};

use crate::args::{Common, EquationsArgs};
use crate::failure::Failure;
use crate::output::{print, print_json, print_text};
use crate::words;

/// `asperity equations`
pub fn equations(args: &EquationsArgs, common: &Common) -> Result<(), Failure> {
    if args.markdown {
        return print_text(common, &equations::markdown());
    }
    let chosen = match &args.tag {
        None => equations::all(),
        Some(tag) => std::slice::from_ref(equations::find(tag).ok_or_else(|| unknown_tag(tag))?),
    };
    let table = || columns! { equation in chosen; head tag "tag" ""; text title "title" ""; };
    print(
        common,
        || chosen,
        || match args.tag {
            None => table().text(""),
            Some(_) => chosen.iter().map(in_full).collect(),
        },
    )
}

fn in_full(equation: &Equation) -> String {
    let mut text = format!(
        "{}  {}\n  formula   {}\n  file      {}\n  test      {}\n",
        equation.tag, equation.title, equation.formula, equation.file, equation.test
    );
    for reference in &equation.references {
        text.push_str(&format!("  source    {}\n", reference.text));
    }
    if let Some(misprint) = equation.misprint {
        text.push_str(&format!("  misprint  {misprint}\n"));
    }
    text
}

fn unknown_tag(tag: &str) -> Failure {
    Failure::new(
        Code::E210,
        format!("no equation has the tag \"{tag}\"; asperity equations lists every tag"),
    )
}

/// `asperity explain`
pub fn explain(code: Option<&str>, common: &Common) -> Result<(), Failure> {
    let Some(code) = code else {
        let all = || message::EXPLANATIONS.iter();
        let json = || all().map(as_json).collect::<Vec<_>>();
        let line = |entry: &Explanation| format!("{}  {}\n", entry.code, entry.title);
        return print(common, json, || all().map(line).collect());
    };
    let entry = message::explain(code).ok_or_else(|| {
        Failure::new(
            Code::E210,
            format!("no message has the code \"{code}\"; asperity explain lists every code"),
        )
    })?;
    let advice = words::advice(entry.code);
    let text = || {
        format!(
            "{}  {}\n  why         {}\n  what to do  {advice}\n",
            entry.code, entry.title, entry.meaning
        )
    };
    print(common, || as_json(entry), text)
}

/// Headings of the page of messages, by the first two characters of a code.
const KINDS: [(&str, &str); 9] = [
    ("E1", "Errors: files"),
    ("E2", "Errors: cases and arguments"),
    ("E3", "Errors: solutions and results"),
    ("E4", "Errors: files to be written"),
    ("E5", "Errors: the program"),
    ("W1", "Warnings: traces"),
    ("W2", "Warnings: values of a case"),
    ("W3", "Warnings: readers"),
    ("W4", "Warnings: results"),
];

/// `asperity explain --markdown`
pub fn messages(common: &Common) -> Result<(), Failure> {
    let mut page = String::from(
        "# Messages\n\nEvery error and warning has a stable code. `asperity explain W401` prints one of these \
         entries,\n`asperity explain --markdown` this page.\n",
    );
    let escaped = |text: &str| text.replace('<', "\\<").replace('*', "\\*");
    for (start, heading) in KINDS {
        page += &format!("\n## {heading}\n");
        for entry in message::EXPLANATIONS
            .iter()
            .filter(|entry| entry.code.as_str().starts_with(start))
        {
            let (title, meaning) = (escaped(entry.title), escaped(entry.meaning));
            page += &format!("\n### {}: {title}\n\n{meaning}\n", entry.code);
            let advice = words::advice(entry.code);
            page += &format!("\n*Remedy:* {}\n", escaped(&advice));
        }
    }
    print_text(common, &page)
}

fn as_json(entry: &Explanation) -> Value {
    json!({
        "code": entry.code,
        "title": entry.title,
        "meaning": entry.meaning,
        "remedy": words::advice(entry.code),
        "settings": entry.settings,
    })
}

/// `asperity schema --markdown`
pub fn keys(common: &Common) -> Result<(), Failure> {
    let page = asperity::case::markdown().map_err(|error| Failure::from_error(&error))?;
    print_text(common, &page)
}

/// `asperity schema`, of a case or of the settings of the studies
pub fn schema(of_settings: bool) -> Result<(), Failure> {
    print_json(&if of_settings {
        schema_of_settings(&every_study!(described))
    } else {
        asperity::case::schema()
    })
}

fn described<S: StudySettings>() -> Described {
    Described::new::<S>()
}
