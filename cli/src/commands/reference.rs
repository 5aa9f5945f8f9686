//! `equations`, `explain` and `schema`: what the program knows about itself.

use asperity::{equations, message};
use asperity_core::Equation;

use crate::args::{Common, EquationsArgs};
use crate::failure::Failure;
use crate::output::print_json;

/// `asperity equations`
pub fn equations(args: &EquationsArgs, common: &Common) -> Result<(), Failure> {
    if args.markdown {
        print!("{}", equations::markdown());
        return Ok(());
    }
    let chosen = match &args.tag {
        None => equations::all(),
        Some(tag) => vec![equations::find(tag).ok_or_else(|| unknown_tag(tag))?],
    };
    if common.json {
        return print_json(&chosen);
    }
    for equation in &chosen {
        match args.tag {
            None => println!("{:16} {}", equation.tag, equation.title),
            Some(_) => print_equation(equation),
        }
    }
    Ok(())
}

fn print_equation(equation: &Equation) {
    println!("{}  {}", equation.tag, equation.title);
    println!("  formula   {}", equation.formula);
    println!("  file      {}", equation.file);
    println!("  test      {}", equation.test);
    for reference in equation.references {
        println!("  source    {}", reference.text);
    }
    if let Some(misprint) = equation.misprint {
        println!("  misprint  {misprint}");
    }
}

fn unknown_tag(tag: &str) -> Failure {
    Failure::new(
        "E205",
        format!("no equation has the tag \"{tag}\"; asperity equations lists every tag"),
    )
}

/// `asperity explain`
pub fn explain(code: Option<&str>, common: &Common) -> Result<(), Failure> {
    let Some(code) = code else {
        if common.json {
            return print_json(&message::EXPLANATIONS);
        }
        for entry in message::EXPLANATIONS {
            println!("{}  {}", entry.code, entry.title);
        }
        return Ok(());
    };
    let entry = message::explain(code).ok_or_else(|| {
        Failure::new(
            "E205",
            format!("no message has the code \"{code}\"; asperity explain lists every code"),
        )
    })?;
    if common.json {
        return print_json(entry);
    }
    println!("{}  {}", entry.code, entry.title);
    println!("  why      {}", entry.meaning);
    println!("  what to do  {}", entry.remedy);
    Ok(())
}

/// `asperity schema`
pub fn schema() -> Result<(), Failure> {
    print_json(&asperity::case::schema())
}
