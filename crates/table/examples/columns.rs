//! Prints the columns of a table that is named on the command line, or of one that is made up.

use asperity_table::Table;

const MADE_UP: &str = "Torque [Nm];Speed [1/min];state\n120,5;3000;as ground\n60;1500;run in\n";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let text = match std::env::args().nth(1) {
        Some(file) => std::fs::read_to_string(file)?,
        None => MADE_UP.to_owned(),
    };
    let table = Table::read(&text)?;
    for row in table.rows() {
        for name in table.names() {
            println!(
                "line {}: {name} = {}",
                row.line,
                row.text(name).unwrap_or("-")
            );
        }
    }
    Ok(())
}
