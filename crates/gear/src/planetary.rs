//! Planetary sets of sun, planets and ring: kinematics, the two kinds of mesh, and the loss.
//!
//! Source: Willis equation; ISO 21771:2007 for the pairs.
//!
//! | symbol | meaning | unit |
//! |---|---|---|
//! | ω_s, ω_r, ω_c | speeds of sun, ring and carrier | rad/s |
//! | z_s, z_p, z_r | tooth numbers, all positive here | - |
//! | n_p | number of planets | - |
//! | T_s | torque at the sun | N m |
//! | F_t,s, F_r,s, F_t,r, F_r,r | tangential and radial forces of sun and ring on a planet | N |
//! | m, a | mass of a planet, distance of its axis from that of the sun | kg, m |
//! | K_γ | mesh load factor: load of the most loaded planet over the mean | - |
//!
//! Every mesh is a gear pair with speeds relative to the carrier. In the planet-ring mesh the planet is gear 1. The two
//! meshes use opposite flanks of a planet. The mean loss does not depend on the phases of the planets.

use asperity_core::quantity::{Angle, AngularSpeed, Force, Length, Mass, Power, Torque};
use asperity_core::{DomainError, cite};
use serde::{Deserialize, Serialize};

use crate::error::GearError;
use crate::input::GearPairInput;
use crate::pair::GearPair;

/// Drawing data of a planetary set. Arrays hold the values of sun, planet and ring.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PlanetarySetInput {
    /// Tooth numbers, all positive.
    pub teeth: [u32; 3],
    /// Number of planets.
    pub planets: u32,
    /// Normal module.
    pub module: Length,
    /// Helix angle.
    pub helix: Angle,
    /// Normal pressure angle.
    pub pressure_angle: Angle,
    /// Face widths.
    pub face_width: [Length; 3],
    /// Profile shift coefficients; a positive one brings the teeth of the ring towards its axis.
    pub profile_shift: [f64; 3],
    /// Distance between the axes of sun and planet; default: without backlash between them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub centre_distance: Option<Length>,
    /// Tip radii.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tip_radius: Option<[Length; 3]>,
    /// Addendum of the basic rack in normal modules.
    pub addendum: f64,
}

impl PlanetarySetInput {
    /// A set of the basic rack of ISO 53 without profile shift.
    pub fn standard(
        teeth: [u32; 3],
        planets: u32,
        module: Length,
        helix: Angle,
        face_width: Length,
    ) -> Self {
        let pair = GearPairInput::standard([teeth[0], teeth[1]], module, helix, face_width);
        Self {
            teeth,
            planets,
            module,
            helix,
            pressure_angle: pair.pressure_angle,
            face_width: [face_width; 3],
            profile_shift: [0.0; 3],
            centre_distance: None,
            tip_radius: None,
            addendum: pair.addendum,
        }
    }

    /// Input of the pair of two gears, given by their indices in the arrays.
    fn pair(&self, gears: [usize; 2], centre_distance: Option<Length>) -> GearPairInput {
        let [first, second] = gears;
        GearPairInput {
            pressure_angle: self.pressure_angle,
            face_width: [self.face_width[first], self.face_width[second]],
            profile_shift: Some([self.profile_shift[first], self.profile_shift[second]]),
            centre_distance,
            tip_radius: self.tip_radius.map(|radii| [radii[first], radii[second]]),
            addendum: self.addendum,
            ..GearPairInput::standard(
                [self.teeth[first], self.teeth[second]],
                self.module,
                self.helix,
                self.face_width[first],
            )
        }
    }
}

/// Speeds of a planetary set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PlanetarySpeeds {
    /// Sun.
    pub sun: AngularSpeed,
    /// Ring.
    pub ring: AngularSpeed,
    /// Carrier.
    pub carrier: AngularSpeed,
    /// Sun relative to the carrier.
    pub sun_relative: AngularSpeed,
    /// Planets relative to the carrier.
    pub planet_relative: AngularSpeed,
}

/// Load and speed of a mesh at its gear 1.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PlanetaryMesh {
    /// Mean torque at gear 1 of one mesh, for losses.
    pub torque: Torque,
    /// Torque at gear 1 of the most loaded mesh, K_γ times the mean, for pressures.
    pub pressure_torque: Torque,
    /// Magnitude of the speed of gear 1 relative to the carrier.
    pub speed: AngularSpeed,
}

/// Operating point of a planetary set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PlanetaryOperation {
    /// Torque at the sun, positive in the direction of its speed.
    pub sun_torque: Torque,
    /// Speed of the sun.
    pub sun_speed: AngularSpeed,
    /// Speed of the ring, zero if it is fixed.
    pub ring_speed: AngularSpeed,
    /// Load of the most loaded planet over the mean, K_γ.
    pub load_share_factor: f64,
}

/// The working geometry of a planetary set.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlanetarySet {
    /// Sun (gear 1) and planet.
    pub sun_planet: GearPair,
    /// Planet (gear 1) and ring.
    pub planet_ring: GearPair,
    /// Number of planets.
    pub planets: u32,
}

impl PlanetarySet {
    /// Derives both pairs at a common centre distance.
    ///
    /// # Errors
    /// When a pair has invalid geometry, the ring does not fit at the centre distance of sun and planet, or the planets
    /// collide.
    ///
    /// ```
    /// use asperity_core::quantity::{AngularSpeed, Torque};
    /// use asperity_gear::planetary::{PlanetaryOperation, PlanetarySet, PlanetarySetInput};
    /// let set = PlanetarySet::new(&PlanetarySetInput::standard(
    ///     [27, 24, 75], 3, "1.5 mm".parse()?, "0 deg".parse()?, "20 mm".parse()?,
    /// ))?;
    /// let [sun_planet, planet_ring] = set.meshes(&PlanetaryOperation {
    ///     sun_torque: "120 N m".parse()?, sun_speed: "3000 1/min".parse()?,
    ///     ring_speed: AngularSpeed::from_si(0.0), load_share_factor: 1.0,
    /// })?;
    /// assert_eq!(sun_planet.torque, Torque::from_si(40.0));
    /// assert!((planet_ring.torque.si() - 35.556).abs() < 1e-3);
    /// assert!((planet_ring.speed.si() - 259.874).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(input: &PlanetarySetInput) -> Result<Self, GearError> {
        let planets = input.planets;
        let rule = "must be at least 1";
        DomainError::require(planets >= 1, "planets", planets.into(), "-", rule)?;
        let sun_planet = GearPair::new(&input.pair([0, 1], input.centre_distance))?;
        let distance = sun_planet.centre_distance;
        let planet_ring = GearPair::internal(&input.pair([1, 2], Some(distance)))?;
        let axis_distance = distance * (2.0 * (std::f64::consts::PI / f64::from(planets)).sin());
        let tip_diameter = sun_planet.tip_radius[1] * 2.0;
        if planets > 1 && axis_distance <= tip_diameter {
            return Err(GearError::planets_collide(
                planets,
                axis_distance,
                tip_diameter,
            ));
        }
        Ok(Self {
            sun_planet,
            planet_ring,
            planets,
        })
    }

    /// z_s, z_p, z_r.
    fn teeth(&self) -> [f64; 3] {
        let [sun, planet] = self.sun_planet.teeth;
        [sun, planet, self.planet_ring.teeth[1]].map(f64::from)
    }

    /// Whether equally spaced planets can be assembled: (z_s + z_r)/n_p is a whole number.
    pub fn can_be_equally_spaced(&self) -> bool {
        let teeth = self.sun_planet.teeth[0] + self.planet_ring.teeth[1];
        teeth.is_multiple_of(self.planets)
    }

    /// ω_c = (ω_s z_s + ω_r z_r)/(z_s + z_r), ω_p − ω_c = −(ω_s − ω_c) z_s/z_p      [Planet-1]
    ///
    /// # Errors
    /// When a speed is not finite.
    pub fn speeds(
        &self,
        sun: AngularSpeed,
        ring: AngularSpeed,
    ) -> Result<PlanetarySpeeds, GearError> {
        cite!("Planet-1");
        let omega_s = DomainError::finite("speed of the sun", sun)?;
        let omega_r = DomainError::finite("speed of the ring", ring)?;
        let [z_s, z_p, z_r] = self.teeth();
        let omega_c = (omega_s * z_s + omega_r * z_r) / (z_s + z_r);
        // ω_s − ω_c would leave a rounding error when the set rotates as a block.
        let relative = (omega_s - omega_r) * z_r / (z_s + z_r);
        Ok(PlanetarySpeeds {
            sun,
            ring,
            carrier: AngularSpeed::from_si(omega_c),
            sun_relative: AngularSpeed::from_si(relative),
            planet_relative: AngularSpeed::from_si(-relative * z_s / z_p),
        })
    }

    /// T = T_s/n_p at the sun and T_s z_p/(n_p z_s) at the planet, with the speeds relative to the
    /// carrier                                                                  [Planet-2]
    ///
    /// The first mesh is the sun-planet mesh, the second the planet-ring mesh.
    ///
    /// # Errors
    /// When a number is not finite, K_γ is below 1, or the set rotates as a block, without relative motion.
    pub fn meshes(&self, operation: &PlanetaryOperation) -> Result<[PlanetaryMesh; 2], GearError> {
        cite!("Planet-2");
        let torque = DomainError::finite("torque at the sun", operation.sun_torque)?;
        let share = operation.load_share_factor;
        let rule = "must be finite and at least 1";
        let fits = share.is_finite() && share >= 1.0;
        DomainError::require(fits, "load share factor", share, "-", rule)?;
        let speeds = self.speeds(operation.sun_speed, operation.ring_speed)?;
        let relative = speeds.sun_relative.si();
        let rule = "must differ from the speed of the ring: a set that rotates as a block has no relative motion";
        let sun = operation.sun_speed.si();
        DomainError::require(relative != 0.0, "speed of the sun", sun, "rad/s", rule)?;
        let [z_s, z_p, _] = self.teeth();
        let at_sun = torque / f64::from(self.planets);
        let mesh = |torque: f64, speed: AngularSpeed| PlanetaryMesh {
            torque: Torque::from_si(torque),
            pressure_torque: Torque::from_si(torque * share),
            speed: AngularSpeed::from_si(speed.si().abs()),
        };
        Ok([
            mesh(at_sun, speeds.sun_relative),
            mesh(at_sun * z_p / z_s, speeds.planet_relative),
        ])
    }

    /// P = n_p·(P_sun-planet + P_planet-ring)                                    [Planet-3]
    pub fn loss(&self, sun_planet: Power, planet_ring: Power) -> Power {
        cite!("Planet-3");
        (sun_planet + planet_ring) * f64::from(self.planets)
    }

    /// Radial load of the bearings of a planet, from the teeth of sun and ring and the mass of the planet, without friction of
    /// the teeth:
    ///
    /// F = √((F_t,s + F_t,r)² + (F_r,s − F_r,r + m a ω_c²)²)                        [Planet-4]
    ///
    /// Both tangential forces turn the carrier; the sun pushes the planet outwards, the ring inwards. The axial forces of sun and
    /// ring cancel, and the moment by which they tilt the planet is not in F.
    ///
    /// # Errors
    /// As [`meshes`](Self::meshes), and when the mass is negative.
    pub fn planet_load(
        &self,
        operation: &PlanetaryOperation,
        mass: Mass,
    ) -> Result<Force, GearError> {
        cite!("Planet-4");
        let mass = DomainError::non_negative("mass of a planet", mass)?;
        let [sun, ring] = self.meshes(operation)?;
        let carrier = self
            .speeds(operation.sun_speed, operation.ring_speed)?
            .carrier;
        let of_sun = self.sun_planet.forces(sun.torque)?;
        let of_ring = self.planet_ring.forces(ring.torque)?;
        let outwards = mass * self.sun_planet.centre_distance.si() * carrier.si().powi(2);
        let tangential = of_sun.tangential.si() + of_ring.tangential.si();
        let radial = of_sun.radial.si() - of_ring.radial.si() + outwards;
        Ok(Force::from_si(tangential.hypot(radial)))
    }

    /// Rolling power transmitted by the meshes, |T_s·(ω_s − ω_c)|.
    ///
    /// # Errors
    /// When a number is not finite.
    pub fn rolling_power(&self, operation: &PlanetaryOperation) -> Result<Power, GearError> {
        let torque = DomainError::finite("torque at the sun", operation.sun_torque)?;
        let speeds = self.speeds(operation.sun_speed, operation.ring_speed)?;
        Ok(Power::from_si((torque * speeds.sun_relative.si()).abs()))
    }
}
