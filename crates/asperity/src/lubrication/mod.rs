//! Film, load share and friction of every window of a mesh at one operating point, without rows of a result.

mod chosen_laws;
mod decision;
mod film_of_case;
mod friction;
mod full_film;
mod full_film_solution;
mod plausibility;
mod position;
mod records;
mod rolling;
mod rough_film;
mod share_comparison;
mod smooth_position;
mod solve;

pub use asperity_case::formula_film::FormulaFilm;
pub use asperity_case::load_share_law::{LoadShare, ShareConditions, SharedLoad};
pub use asperity_case::physical_limits::HIGHEST_PRESSURE;
pub use asperity_case::{laws, load_share_law};
pub use film_of_case::formula_film;
pub use plausibility::{check_mesh_position, plausible_film};

pub(crate) use chosen_laws::ChosenLaws;
pub(crate) use decision::Decision;
pub(crate) use friction::film_contact;
pub(crate) use full_film::NOTED_DEVIATION;
pub(crate) use position::{ContactNumbers, LubricatedPosition, LubricatedWindow};
pub(crate) use records::records_of;
pub(crate) use rolling::rolling;
pub(crate) use rough_film::RoughFilm;
pub use share_comparison::{
    ComparedWindow, LawShare, ShareComparison, WINDOWS, compared_windows, points_of_window,
    share_settings, shares, windows_at,
};
pub(crate) use smooth_position::SmoothPosition;
pub(crate) use solve::{LubricatedMesh, PositionGradient, doubts};
