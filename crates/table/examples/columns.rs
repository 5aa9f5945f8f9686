//! Prints the cells of a table, each with its line and column.

use asperity_table::Table;

const MADE_UP: &str = "Torque [Nm];Speed [1/min];state\n120,5;3000;as ground\n60;1500;run in\n";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let table = Table::read(MADE_UP)?;
    for row in table.rows() {
        for name in table.names() {
            let text = row.text(name).unwrap_or("-");
            println!("line {}: {name} = {text}", row.line);
        }
    }
    Ok(())
}
