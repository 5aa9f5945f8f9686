//! The gears of a case while they are typed: a picture, and what follows from them.

use asperity::case::{GearsInput, Source, gear_pair};
use asperity::quantity::Length;
use asperity_report::chart::Dress;
use asperity_report::html::pair_in_mesh;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;

/// The gears of a case; its other tables are not read.
#[derive(Deserialize)]
struct Gears {
    gears: GearsInput,
}

/// The pair in mesh.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Pair {
    /// Picture as SVG; empty for gears that cannot be drawn.
    pub svg: String,
    /// Names and values of what follows from the gears.
    pub facts: Vec<[String; 2]>,
}

/// The gears in the `text` of a case called `name`; nothing else of it needs to be complete.
///
/// # Errors
/// When the gears cannot be read or cannot mesh.
///
/// ```
/// let gears = "[gears]\nteeth = [16, 24]\nmodule = \"4.5 mm\"\nface_width = \"14 mm\"\n";
/// let pair = asperity_web::pair("case.toml", gears).unwrap();
/// assert!(pair.svg.starts_with("<svg"));
/// assert_eq!(pair.facts[0], ["centre distance", "90.000 mm"]);
/// ```
pub fn pair(name: &str, text: &str) -> Result<Pair, Failure> {
    let read = || {
        let source = Source::from_bytes(name, text.as_bytes())?;
        let Gears { gears } = source.read()?;
        Ok((gear_pair(gears.clone(), &source)?, gears))
    };
    let (pair, gears) = read()
        .map_err(|error: asperity::case::CaseError| Failure::from(&asperity::Error::from(error)))?;
    let mm = |length: Length| format!("{:.3} mm", 1e3 * length.si().abs());
    let tips = pair.tip_radius.map(|radius| mm(radius * 2.0));
    let mut facts = vec![
        ["centre distance".to_owned(), mm(pair.centre_distance)],
        [
            "transverse contact ratio".to_owned(),
            format!("{:.3}", pair.path.eps_alpha),
        ],
    ];
    if !pair.is_spur() {
        let overlap = format!("{:.3}", pair.path.eps_beta);
        facts.push(["overlap ratio".to_owned(), overlap]);
    }
    facts.push(["tip diameters".to_owned(), tips.join(" and ")]);
    Ok(Pair {
        svg: pair_in_mesh(&pair, &gears).map_or(String::new(), |picture| picture.svg(Dress::Page)),
        facts,
    })
}
