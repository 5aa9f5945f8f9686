//! `asperity oil`: the subjects of the studies of oils.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use asperity::LoadedCase;
use asperity::case::open_source;
use asperity_calibration::oil::{ConstantsOf, Curves, MeasuredOil, OfOil, OilBase, OilOfCase};
use asperity_core::{Code, Fault};
use asperity_report::library::oil_named;

use super::{load_case, result_name};
use crate::args::{Given, GivenCurves, GivenOil, GivenOilOfCase, NoLimits, SetArgs, Subject};
use crate::failure::Failure;

/// An oil with the name of its results, and its case if it is the oil of one.
struct NamedOil {
    oil: OilBase,
    name: OsString,
    case: Option<LoadedCase>,
}

/// The oil of a case file, of an oil file, of a data sheet or of the library.
fn base(oil: &str, set: &SetArgs, constants: ConstantsOf) -> Result<NamedOil, Failure> {
    let path = Path::new(oil);
    let is_file = path.extension().is_some() || path.exists();
    if is_file {
        let name = result_name(path);
        let source = open_source(path).map_err(|error| Failure::from_error(&error))?;
        if let Some(oil) = OilBase::of_source(&name.to_string_lossy(), &source, constants)? {
            return Ok(NamedOil {
                oil,
                name,
                case: None,
            });
        }
        let loaded = load_case(path, set, None)?;
        return Ok(NamedOil {
            oil: OilBase::of_case(&loaded, constants)?,
            name,
            case: Some(loaded),
        });
    }
    let name = oil_named(oil)?.name;
    Ok(NamedOil {
        oil: OilBase::of_library(&name)?,
        name: OsString::from(name),
        case: None,
    })
}

/// Rejects keys of a case and the name of a mesh where no case is given.
fn refuse_keys(set: &SetArgs, case: Option<&LoadedCase>) -> Result<(), Failure> {
    if case.is_none() && (!set.keys.is_empty() || set.mesh.is_some()) {
        Err(Failure::new(
            Code::E205,
            "--set and --mesh change a case, and the oil is not of one",
        ))
    } else {
        Ok(())
    }
}

impl Given for OfOil {
    type Args = GivenOil;
    type Limits = NoLimits;
    const NAMED_BY: &'static str = "<name of the oil or case>";

    fn read(args: &GivenOil, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        let NamedOil { oil, name, case } = base(&args.oil, set, ConstantsOf::File)?;
        refuse_keys(set, case.as_ref())?;
        Ok(Subject {
            input: Self(oil),
            name,
            file: None,
        })
    }
}

impl Given for OilOfCase {
    type Args = GivenOilOfCase;
    type Limits = NoLimits;
    const NAMED_BY: &'static str = OfOil::NAMED_BY;

    fn read(args: &GivenOilOfCase, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        let NamedOil {
            oil,
            name,
            case: of,
        } = base(&args.oil, set, ConstantsOf::Family)?;
        let case = args.case.as_ref();
        let case = case.map(|path| load_case(path, set, None)).transpose()?;
        let input = Self::new(oil, of, case);
        refuse_keys(set, input.case.as_ref())?;
        Ok(Subject {
            input,
            name,
            file: None,
        })
    }
}

impl Given for MeasuredOil {
    type Args = GivenCurves;
    type Limits = NoLimits;
    const NAMED_BY: &'static str = "<name of the first file>";

    fn read(args: &GivenCurves, set: &SetArgs) -> Result<Subject<Self>, Failure> {
        let NamedOil { oil, case, .. } = base(&args.oil, set, ConstantsOf::Family)?;
        refuse_keys(set, case.as_ref())?;
        let curves = args.curves.iter().map(|file| Curves::open(file));
        let curves = curves.collect::<Result<Vec<Curves>, Fault>>()?;
        let first: Option<&PathBuf> = args.curves.first();
        Ok(Subject {
            input: Self { curves, oil },
            name: first.map(|file| result_name(file)).unwrap_or_default(),
            file: None,
        })
    }
}
