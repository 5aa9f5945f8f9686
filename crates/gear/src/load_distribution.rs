//! Extension point for load distributions: the laws of this crate and user-defined laws.
//!
//! A law computes the load over the flanks, a [`LoadMap`], from which loss factors, cells and mean line loads follow.
//! Every [`LoadLaw`] of a case file is a load distribution.

use std::fmt::Debug;
use std::sync::Arc;

use crate::error::GearError;
use crate::load_map::{LoadConditions, LoadLaw, LoadMap};

/// Law of the load distribution over the flanks.
///
/// ```
/// use asperity_gear::{GearError, LoadConditions, LoadDistribution, LoadMap, LoadSharing};
///
/// /// Equal sharing on a spur pair, reduced by 10 % at both ends by tip relief.
/// #[derive(Debug)]
/// struct Relieved;
///
/// impl LoadDistribution for Relieved {
///     fn name(&self) -> &str {
///         "relieved"
///     }
///
///     fn load_map(&self, mesh: &LoadConditions<'_>) -> Result<LoadMap, GearError> {
///         LoadMap::of_line_load(mesh, |s| {
///             let path = mesh.pair.path();
///             let place = (s - path.a) / (path.e - path.a);
///             let share = if (0.1..=0.9).contains(&place) { 1.0 } else { 0.9 };
///             Ok(mesh.pair.line_load(s, mesh.torque, &LoadSharing::Uniform)? * share)
///         })
///     }
/// }
/// # use asperity_gear::{GearPair, GearPairInput, LoadLaw, LoadMapSettings, MicroGeometry};
/// # let steel = asperity_core::material::Material {
/// #     young: "206 GPa".parse()?, poisson: 0.3, elastic_limit: "1 GPa".parse()?,
/// #     density: "7850 kg/m3".parse()?, conductivity: "45 W/(m K)".parse()?,
/// #     heat_capacity: "460 J/(kg K)".parse()?,
/// # };
/// # let pair = GearPair::new(&GearPairInput::standard(
/// #     [50, 120], "1.3 mm".parse()?, "0 deg".parse()?, "50 mm".parse()?,
/// # ))?;
/// # let (micro, settings) = (MicroGeometry::default(), LoadMapSettings::default());
/// let mesh = LoadConditions {
///     pair: &pair, torque: "285 N m".parse()?, micro: &micro, materials: &[steel; 2],
///     settings: &settings,
/// };
/// let relieved = Relieved.load_map(&mesh)?.loss_factor();
/// assert!(relieved < LoadLaw::Uniform.load_map(&mesh)?.loss_factor());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub trait LoadDistribution: Debug + Send + Sync {
    /// Name in results.
    fn name(&self) -> &str;

    /// The load over the flanks during a mesh cycle.
    ///
    /// # Errors
    /// When the law does not hold for this mesh.
    fn load_map(&self, mesh: &LoadConditions<'_>) -> Result<LoadMap, GearError>;
}

impl LoadDistribution for LoadLaw {
    fn name(&self) -> &str {
        LoadLaw::name(self)
    }

    fn load_map(&self, mesh: &LoadConditions<'_>) -> Result<LoadMap, GearError> {
        LoadMap::new(
            mesh.pair,
            mesh.torque,
            self,
            mesh.micro,
            mesh.materials,
            mesh.settings,
        )
    }
}

impl From<LoadLaw> for Arc<dyn LoadDistribution> {
    fn from(law: LoadLaw) -> Self {
        Arc::new(law)
    }
}
