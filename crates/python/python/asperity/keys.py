"""Keys of a case and choices of arguments, for type checkers and completion.

Written by crates/python/typed.py from the lists of the compiled part.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Literal, Optional, TypedDict, Union

from ._choices import *
from ._profile import Profile
from ._quantity import PintLike, Quantity


class CalibrationInput(TypedDict, total=False):
    """Parameters calibrated on a rig, each with the 95 % interval from which the interval of the loss is sampled."""

    boundary_friction: Optional[Estimate]
    boundary_layer: Optional[Estimate2]
    correlations: Optional[Sequence[CorrelationInput]]
    eyring_stress: Optional[Estimate3]
    limiting_shear: Optional[Estimate]
    simulated: Optional[bool]
    source: Optional[str]


class Estimate(TypedDict, total=False):
    """A value with the ends of its interval."""

    high: Optional[float]
    low: Optional[float]
    value: Optional[float]


class Estimate2(TypedDict, total=False):
    """A value with the ends of its interval."""

    high: Optional[Quantity]
    low: Optional[Quantity]
    value: Optional[Quantity]


class CorrelationInput(TypedDict, total=False):
    """Correlation of two parameters, of their logarithms where these are normal."""

    between: Optional[Sequence[Literal["boundary_friction", "boundary_layer", "limiting_shear", "eyring_stress"]]]
    value: Optional[float]


class Estimate3(TypedDict, total=False):
    """A value with the ends of its interval."""

    high: Optional[Quantity]
    low: Optional[Quantity]
    value: Optional[Quantity]


class GearboxInput(TypedDict, total=False):
    """Losses of the gearbox other than the loss of the mesh; only the losses stated here are added."""

    bearings: Optional[Sequence[BearingInput]]
    jet: Optional[JetInput]
    loss_table: Optional[str]
    seals: Optional[Sequence[SealInput]]
    temperature: Optional[Quantity]


class BearingInput(TypedDict, total=False):
    """A rolling bearing with its load."""

    at: Optional[Quantity]
    at_torque: Optional[Quantity]
    axial: Optional[Quantity]
    axial_factor: Optional[float]
    bore: Optional[Quantity]
    k_rs: Optional[float]
    k_z: Optional[float]
    kind: Optional[Literal["deep-groove-ball", "cylindrical-roller", "tapered-roller"]]
    locating: Optional[bool]
    mu_bl: Optional[float]
    mu_ehl: Optional[float]
    name: Optional[str]
    outside_diameter: Optional[Quantity]
    per_planet: Optional[int]
    planet_mass: Optional[Quantity]
    r1: Optional[float]
    r2: Optional[float]
    radial: Optional[Quantity]
    s1: Optional[float]
    s2: Optional[float]
    shaft: Optional[Literal["pinion", "wheel"]]
    static_rating: Optional[Quantity]


class JetInput(TypedDict, total=False):
    """An oil jet."""

    flow: Optional[Quantity]
    speed: Optional[Quantity]


class SealInput(TypedDict, total=False):
    """A radial shaft seal."""

    diameter: Optional[Quantity]
    name: Optional[str]
    shaft: Optional[Literal["pinion", "wheel"]]


class GearsInput(TypedDict, total=False):
    """The gear pair; names as in ISO 21771."""

    addendum: Optional[float]
    amounts: Optional[Literal["transverse", "normal"]]
    centre_distance: Optional[Quantity]
    end_relief: Optional[EndReliefInput]
    face_width: Optional[Union[Sequence[Quantity], Quantity]]
    helix: Optional[Quantity]
    module: Optional[Quantity]
    module_plane: Optional[Literal["normal", "transverse"]]
    pinion: Optional[GearFlankInput]
    pitch_deviations: Optional[Sequence[Quantity]]
    pressure_angle: Optional[Quantity]
    profile_shift: Optional[Sequence[float]]
    relief_tolerance: Optional[Quantity]
    teeth: Optional[Sequence[int]]
    tip_diameter: Optional[Sequence[Quantity]]
    wheel: Optional[GearFlankInput]


class EndReliefInput(TypedDict, total=False):
    """Relief of both ends of the face: `{ amount = '10 um', length = '3 mm' }`."""

    amount: Optional[Quantity]
    length: Optional[Quantity]
    power: Optional[int]


class GearFlankInput(TypedDict, total=False):
    """Modifications of the flanks of one gear, its tip and its root."""

    crowning: Optional[Quantity]
    dedendum: Optional[float]
    fillet_radius: Optional[float]
    lead_slope: Optional[Quantity]
    profile_crowning: Optional[Quantity]
    profile_slope: Optional[Quantity]
    relief: Optional[Literal["drawn", "from-trace"]]
    root_relief: Optional[ReliefInput]
    tip_chamfer: Optional[Quantity]
    tip_relief: Optional[Union[Literal["none"], ReliefInput]]


class ReliefInput(TypedDict, total=False):
    """Relief of tips or roots: `{ amount = '10 um', length = '2.9 mm' }`."""

    amount: Optional[Quantity]
    length: Optional[Quantity]
    power: Optional[int]
    start_diameter: Optional[Quantity]


class LubricantInput(TypedDict, total=False):
    """The lubricant as the case file states it; every key is optional, some are needed together."""

    assume_base_oil: Optional[Literal["mineral", "naphthenic", "group-iii", "pao", "ester", "polyglycol"]]
    base_oil: Optional[Literal["mineral", "naphthenic", "group-iii", "pao", "ester", "polyglycol"]]
    density: Optional[Quantity]
    density_temperature: Optional[Quantity]
    heat_capacity: Optional[Quantity]
    limiting_shear_temperature: Optional[Quantity]
    oil: Optional[str]
    oil_file: Optional[str]
    pressure_viscosity: Optional[Quantity]
    pressure_viscosity_factor: Optional[float]
    temperature_coefficient: Optional[Quantity]
    thermal_conductivity: Optional[Quantity]
    thermal_expansion: Optional[Quantity]
    viscosity: Optional[Union[ViscosityAstmD341, ViscosityIsoVg, ViscosityVogel, ViscosityGiven]]


class ViscosityAstmD341(TypedDict, total=False):
    """ASTM D341 through the two kinematic viscosities of a data sheet."""

    at_100: Optional[Quantity]
    at_40: Optional[Quantity]
    law: Optional[Literal["astm-d341"]]


class ViscosityIsoVg(TypedDict, total=False):
    """ASTM D341 through the viscosities of an ISO VG grade and a viscosity index."""

    grade: Optional[float]
    law: Optional[Literal["iso-vg"]]
    viscosity_index: Optional[float]


class ViscosityVogel(TypedDict, total=False):
    """Vogel's law η = K·exp(b/(T − θ))."""

    law: Optional[Literal["vogel"]]
    limit_viscosity: Optional[Quantity]
    pole_kelvin: Optional[float]
    slope_kelvin: Optional[float]


class ViscosityGiven(TypedDict, total=False):
    """One dynamic viscosity; the lubricant then needs a `temperature_coefficient`."""

    dynamic_viscosity: Optional[Quantity]
    law: Optional[Literal["given"]]
    temperature: Optional[Quantity]


class MapInput(TypedDict, total=False):
    """Ranges of the default axes of a map."""

    speed_max: Optional[Quantity]
    torque_max: Optional[Quantity]


class MaterialInput(TypedDict, total=False):
    """Steel of both gears."""

    pinion: Optional[BodyInput]
    wheel: Optional[BodyInput]


class BodyInput(TypedDict, total=False):
    """Elastic and thermal constants; all have the values of case-hardened steel by default."""

    conductivity: Optional[Quantity]
    density: Optional[Quantity]
    elastic_limit: Optional[Quantity]
    flow_pressure: Optional[Quantity]
    hardness: Optional[str]
    heat_capacity: Optional[Quantity]
    poisson: Optional[float]
    steel: Optional[str]
    young: Optional[Quantity]


class MicropittingInput(TypedDict, total=False):
    """Local specific film thickness of the micropitting rating of ISO/TS 6336-22, compared with the measured flanks at the same places; computed if this table is stated."""

    load_factor: Optional[float]
    permissible: Optional[float]
    ra: Optional[Sequence[Quantity]]


class ModelInput(TypedDict, total=False):
    """Choices of the model."""

    boundary_friction: Optional[float]
    boundary_layer: Optional[Quantity]
    depths: Optional[int]
    edge_contact: Optional[bool]
    ehl: Optional[EhlInput]
    face_coupling: Optional[float]
    film: Optional[Literal["steady", "dowson-toyoda", "moes", "ertel-grubin", "hamrock-dowson", "hamrock-dowson-line"]]
    film_friction: Optional[Union[Literal["eyring", "carreau", "newton", "xu", "iso-14179-2", "iso-14179-1", "benedict-kelley", "matsumoto", "doleschel", "eyring-arana", "constant"], FilmFriction, GearsFilmFriction]]
    film_pressure_law: Optional[Literal["barus", "roelands"]]
    flash_feedback: Optional[bool]
    friction_scale: Optional[float]
    full_film: Optional[Literal["formulas", "ehl", "ehl-transient"]]
    hysteresis: Optional[Union[float, str]]
    inlet_layer: Optional[Quantity]
    inner_boundary: Optional[float]
    lay: Optional[Union[Literal["across", "isotropic"], Sequence[Union[Literal["across", "isotropic"], float]], float]]
    load_distribution: Optional[Union[Literal["elastic", "iso-stiffness", "uniform", "mean-length", "min-potential", "trapezoid"], LoadDistribution]]
    load_share: Optional[Literal["solved", "lambda-star", "zhu-hu", "masjedi-khonsari", "jgp", "ehl"]]
    offsets: Optional[int]
    positions: Optional[int]
    stiffness_factor: Optional[float]
    thermal: Optional[Literal["gupta", "none"]]
    tolerance: Optional[float]
    window: Optional[float]


class EhlInput(TypedDict, total=False):
    """Grid and length of the elastohydrodynamic solutions, and where reference solutions are stored."""

    cache: Optional[str]
    cells: Optional[int]
    records: Optional[int]
    travel: Optional[float]


class FilmFriction(TypedDict, total=False):
    """One friction coefficient everywhere."""

    constant: Optional[float]


GearsFilmFriction = TypedDict(
    "GearsFilmFriction",
    {
        "iso-14179-2": "Optional[float]",
    },
    total=False,
)
"""Lubricant factor X_L of ISO/TR 14179-2; 1 for mineral oil."""


class LoadDistribution(TypedDict, total=False):
    """Rows (position from 0 at A to 1 at E, weight), as [`LoadSharing::Table`]."""

    table: Optional[Sequence[Sequence[float]]]


class OperationInput(TypedDict, total=False):
    """Torque, speed, temperature."""

    bulk: Optional[BulkInput]
    bulk_temperature: Optional[Union[Sequence[Quantity], Quantity]]
    oil_temperature: Optional[Quantity]
    running_in: Optional[Union[bool, RunningInInput]]
    speed: Optional[Quantity]
    temperature_deviation: Optional[Quantity]
    torque: Optional[Quantity]


class BulkInput(TypedDict, total=False):
    """Bulk temperature from the loss: by conductances, or `{ law = 'iso', lubrication = 'jet' }`."""

    between: Optional[Quantity]
    law: Optional[Literal["iso", "network"]]
    lubrication: Optional[Literal["jet", "dip", "jet-and-dip", "submerged"]]
    pinion_to_oil: Optional[Quantity]
    wheel_to_oil: Optional[Quantity]


class RunningInInput(TypedDict, total=False):
    """Running-in of the flanks: `{ torque = '302 N m', engagements = 1e3 }`."""

    engagements: Optional[float]
    torque: Optional[Quantity]


class PaperInput(TypedDict, total=False):
    """Choices of the formulation `paper`."""

    delta_step: Optional[Quantity]
    fluid_pressure: Optional[Literal["reynolds-cross", "paper"]]
    numerical_error: Optional[Union[float, str]]
    position: Optional[Union[Literal["A", "B", "C", "D", "E"], float]]


class SurfaceInput(TypedDict, total=False):
    """The two flanks and how their traces are prepared."""

    coast: Optional[CoastInput]
    contact: Optional[Literal["lines", "patch"]]
    cutoff: Optional[Quantity]
    ends: Optional[Literal["cut", "reg0", "reg1", "reflect"]]
    finish: Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]
    form: Optional[Literal["none", "mean", "level", "poly2", "circle"]]
    noise_cutoff: Optional[Quantity]
    outliers: Optional[float]
    pinion: Optional[Union[FlankInput, str, PathLike[str], Profile]]
    wheel: Optional[Union[FlankInput, str, PathLike[str], Profile]]


class CoastInput(TypedDict, total=False):
    """The flanks that carry the load at a negative torque."""

    pinion: Optional[Union[FlankInput, str, PathLike[str], Profile]]
    wheel: Optional[Union[FlankInput, str, PathLike[str], Profile]]


FlankInput = TypedDict(
    "FlankInput",
    {
        "abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "asperity_radius": "Optional[Quantity]",
        "at": "Optional[FlankPlaceInput]",
        "base_radius": "Optional[Quantity]",
        "columns": "Optional[Columns]",
        "decimal": 'Optional[Literal["point", "comma"]]',
        "dx": "Optional[Quantity]",
        "dy": "Optional[Quantity]",
        "encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "engagements": "Optional[float]",
        "file": "Optional[Union[str, PathLike[str], Profile]]",
        "finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "from": 'Optional[Literal["root", "tip"]]',
        "gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "invert": "Optional[bool]",
        "like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "mirrored": "Optional[bool]",
        "ra": "Optional[Quantity]",
        "range": "Optional[str]",
        "row": "Optional[int]",
        "rows": "Optional[int]",
        "rpk": "Optional[Quantity]",
        "rq": "Optional[Quantity]",
        "rz": "Optional[Quantity]",
        "seed": "Optional[int]",
        "separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "state": "Optional[float]",
        "traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "uneven": 'Optional[Literal["refuse", "resample"]]',
        "x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
    },
    total=False,
)
"""One flank: a file with its trace, or only roughness values."""


TraceInput = TypedDict(
    "TraceInput",
    {
        "at": "Optional[FlankPlaceInput]",
        "engagements": "Optional[float]",
        "file": "Optional[Union[str, PathLike[str], Profile]]",
        "from": 'Optional[Literal["root", "tip"]]',
        "range": "Optional[str]",
        "row": "Optional[int]",
        "tooth": "Optional[int]",
        "y": "Optional[Quantity]",
    },
    total=False,
)
"""One of several traces of a flank; all other keys are those of the flank."""


class FlankPlaceInput(TypedDict, total=False):
    """A point of a trace whose place on the flank is known, by one of five coordinates."""

    diameter: Optional[Quantity]
    position: Optional[Quantity]
    radius: Optional[Quantity]
    roll_angle: Optional[Quantity]
    roll_length: Optional[Quantity]
    x: Optional[Quantity]


class Columns(TypedDict, total=False):
    """The columns of a table, counted from 1."""

    x: Optional[int]
    z: Optional[int]


class VehicleInput(TypedDict, total=False):
    """A vehicle whose speed over time makes torque and speed of the pinion or input shaft."""

    drag_area: Optional[Quantity]
    grade: Optional[Union[float, str]]
    inertia_factor: Optional[float]
    mass: Optional[Quantity]
    ratio: Optional[float]
    rolling_resistance: Optional[float]
    wheel_radius: Optional[Quantity]


class MeshGearboxInput(TypedDict, total=False):
    """Losses of the gearbox other than the loss of the mesh; only the losses stated here are added."""

    bearings: Optional[Sequence[MeshBearingInput]]
    jets: Optional[Sequence[MeshJetInput]]
    seals: Optional[Sequence[MeshSealInput]]
    tables: Optional[Sequence[TableInput]]
    temperature: Optional[Quantity]


class MeshBearingInput(TypedDict, total=False):
    """A rolling bearing with its load."""

    at: Optional[Quantity]
    at_torque: Optional[Quantity]
    axial: Optional[Quantity]
    axial_factor: Optional[float]
    bore: Optional[Quantity]
    k_rs: Optional[float]
    k_z: Optional[float]
    kind: Optional[Literal["deep-groove-ball", "cylindrical-roller", "tapered-roller"]]
    locating: Optional[bool]
    mu_bl: Optional[float]
    mu_ehl: Optional[float]
    name: Optional[str]
    outside_diameter: Optional[Quantity]
    per_planet: Optional[int]
    planet_mass: Optional[Quantity]
    r1: Optional[float]
    r2: Optional[float]
    radial: Optional[Quantity]
    s1: Optional[float]
    s2: Optional[float]
    shaft: Optional[str]
    static_rating: Optional[Quantity]


class MeshJetInput(TypedDict, total=False):
    """An oil jet onto a pair of gears of a gear train."""

    flow: Optional[Quantity]
    mesh: Optional[str]
    name: Optional[str]
    speed: Optional[Quantity]


class MeshSealInput(TypedDict, total=False):
    """A radial shaft seal."""

    diameter: Optional[Quantity]
    name: Optional[str]
    shaft: Optional[str]


class TableInput(TypedDict, total=False):
    """A table of losses on a shaft of a gear train: of gears that run idle, a clutch, a pump."""

    against: Optional[str]
    file: Optional[Union[str, PathLike[str], Profile]]
    name: Optional[str]
    shaft: Optional[str]


class HeatInput(TypedDict, total=False):
    """Heat from the oil through the housing to the ambient air."""

    ambient: Optional[Quantity]
    housing_to_ambient: Optional[Quantity]
    oil_to_housing: Optional[Quantity]
    other_losses: Optional[Quantity]


class MeshMaterialInput(TypedDict, total=False):
    """Steel of both gears."""

    pinion: Optional[BodyInput]
    planet: Optional[BodyInput]
    ring: Optional[BodyInput]
    sun: Optional[BodyInput]
    wheel: Optional[BodyInput]


class MeshInput(TypedDict, total=False):
    """A mesh of a gear train: a pair of gears, or a planetary set."""

    angle: Optional[Quantity]
    at: Optional[Quantity]
    bulk: Optional[BulkInput]
    gears: Optional[GearsInput]
    hand: Optional[Literal["left", "right"]]
    material: Optional[MeshMaterialInput]
    planetary: Optional[PlanetaryInput]
    shafts: Optional[Sequence[str]]
    surface: Optional[MeshSurfaceInput]


class PlanetaryInput(TypedDict, total=False):
    """Sun, planets and ring."""

    addendum: Optional[float]
    centre_distance: Optional[Quantity]
    face_width: Optional[Sequence[Quantity]]
    helix: Optional[Quantity]
    load_share_factor: Optional[float]
    module: Optional[Quantity]
    planet: Optional[GearFlankInput]
    planets: Optional[int]
    pressure_angle: Optional[Quantity]
    profile_shift: Optional[Sequence[float]]
    ring: Optional[GearFlankInput]
    ring_speed: Optional[Quantity]
    sun: Optional[GearFlankInput]
    teeth: Optional[Sequence[int]]
    tip_diameter: Optional[Sequence[Quantity]]


class MeshSurfaceInput(TypedDict, total=False):
    """The two flanks and how their traces are prepared."""

    coast: Optional[CoastInput]
    contact: Optional[Literal["lines", "patch"]]
    cutoff: Optional[Quantity]
    ends: Optional[Literal["cut", "reg0", "reg1", "reflect"]]
    finish: Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]
    form: Optional[Literal["none", "mean", "level", "poly2", "circle"]]
    noise_cutoff: Optional[Quantity]
    outliers: Optional[float]
    pinion: Optional[Union[FlankInput, str, PathLike[str], Profile]]
    planet: Optional[Union[FlankInput, str, PathLike[str], Profile]]
    ring: Optional[Union[FlankInput, str, PathLike[str], Profile]]
    sun: Optional[Union[FlankInput, str, PathLike[str], Profile]]
    wheel: Optional[Union[FlankInput, str, PathLike[str], Profile]]


class ShaftsInput(TypedDict, total=False):
    """Shafts at which the power enters and leaves a gear train."""

    held: Optional[Sequence[str]]
    input: Optional[str]
    losses: Optional[Literal["not-passed-on", "passed-on"]]
    output: Optional[str]


class CaseTables(TypedDict, total=False):
    """Tables of a case, and its operating point as numbers or text."""

    calibration: Optional[CalibrationInput]
    gearbox: Optional[Union[GearboxInput, MeshGearboxInput]]
    gears: Optional[GearsInput]
    lubricant: Optional[LubricantInput]
    map: Optional[MapInput]
    material: Optional[Union[MaterialInput, MeshMaterialInput]]
    micropitting: Optional[MicropittingInput]
    model: Optional[ModelInput]
    operation: Optional[OperationInput]
    paper: Optional[PaperInput]
    surface: Optional[Union[SurfaceInput, MeshSurfaceInput]]
    title: Optional[str]
    vehicle: Optional[VehicleInput]
    heat: Optional[HeatInput]
    mesh: Optional[Mapping[str, MeshInput]]
    planetary: Optional[PlanetaryInput]
    train: Optional[ShaftsInput]
    torque_nm: Optional[float]
    speed_rpm: Optional[float]
    temperature_c: Optional[float]
    torque: Optional[Quantity]
    speed: Optional[Quantity]
    temperature: Optional[Quantity]


CaseKeys = TypedDict(
    "CaseKeys",
    {
        "calibration": "Optional[CalibrationInput]",
        "formulation": 'Optional[Literal["corrected", "paper"]]',
        "gearbox": "Optional[Union[GearboxInput, MeshGearboxInput]]",
        "gears": "Optional[GearsInput]",
        "lubricant": "Optional[LubricantInput]",
        "map": "Optional[MapInput]",
        "material": "Optional[Union[MaterialInput, MeshMaterialInput]]",
        "micropitting": "Optional[MicropittingInput]",
        "model": "Optional[ModelInput]",
        "operation": "Optional[OperationInput]",
        "paper": "Optional[PaperInput]",
        "surface": "Optional[Union[SurfaceInput, MeshSurfaceInput]]",
        "title": "Optional[str]",
        "vehicle": "Optional[VehicleInput]",
        "heat": "Optional[HeatInput]",
        "mesh": "Optional[Mapping[str, MeshInput]]",
        "planetary": "Optional[PlanetaryInput]",
        "train": "Optional[ShaftsInput]",
        "torque_nm": "Optional[float]",
        "speed_rpm": "Optional[float]",
        "temperature_c": "Optional[float]",
        "torque": "Optional[Quantity]",
        "speed": "Optional[Quantity]",
        "temperature": "Optional[Quantity]",
        "calibration.boundary_friction": "Optional[Estimate]",
        "calibration.boundary_friction.high": "Optional[float]",
        "calibration.boundary_friction.low": "Optional[float]",
        "calibration.boundary_friction.value": "Optional[float]",
        "calibration.boundary_layer": "Optional[Estimate2]",
        "calibration.boundary_layer.high": "Optional[Quantity]",
        "calibration.boundary_layer.low": "Optional[Quantity]",
        "calibration.boundary_layer.value": "Optional[Quantity]",
        "calibration.correlations": "Optional[Sequence[CorrelationInput]]",
        "calibration.eyring_stress": "Optional[Estimate3]",
        "calibration.eyring_stress.high": "Optional[Quantity]",
        "calibration.eyring_stress.low": "Optional[Quantity]",
        "calibration.eyring_stress.value": "Optional[Quantity]",
        "calibration.limiting_shear": "Optional[Estimate]",
        "calibration.limiting_shear.high": "Optional[float]",
        "calibration.limiting_shear.low": "Optional[float]",
        "calibration.limiting_shear.value": "Optional[float]",
        "calibration.simulated": "Optional[bool]",
        "calibration.source": "Optional[str]",
        "gearbox.bearings": "Optional[Union[Sequence[BearingInput], Sequence[MeshBearingInput]]]",
        "gearbox.jet": "Optional[JetInput]",
        "gearbox.jet.flow": "Optional[Quantity]",
        "gearbox.jet.speed": "Optional[Quantity]",
        "gearbox.loss_table": "Optional[str]",
        "gearbox.seals": "Optional[Union[Sequence[SealInput], Sequence[MeshSealInput]]]",
        "gearbox.temperature": "Optional[Quantity]",
        "gears.addendum": "Optional[float]",
        "gears.amounts": 'Optional[Literal["transverse", "normal"]]',
        "gears.centre_distance": "Optional[Quantity]",
        "gears.end_relief": "Optional[EndReliefInput]",
        "gears.end_relief.amount": "Optional[Quantity]",
        "gears.end_relief.length": "Optional[Quantity]",
        "gears.end_relief.power": "Optional[int]",
        "gears.face_width": "Optional[Union[Sequence[Quantity], Quantity]]",
        "gears.face_width.0": "Optional[Quantity]",
        "gears.face_width.1": "Optional[Quantity]",
        "gears.helix": "Optional[Quantity]",
        "gears.module": "Optional[Quantity]",
        "gears.module_plane": 'Optional[Literal["normal", "transverse"]]',
        "gears.pinion": "Optional[GearFlankInput]",
        "gears.pinion.crowning": "Optional[Quantity]",
        "gears.pinion.dedendum": "Optional[float]",
        "gears.pinion.fillet_radius": "Optional[float]",
        "gears.pinion.lead_slope": "Optional[Quantity]",
        "gears.pinion.profile_crowning": "Optional[Quantity]",
        "gears.pinion.profile_slope": "Optional[Quantity]",
        "gears.pinion.relief": 'Optional[Literal["drawn", "from-trace"]]',
        "gears.pinion.root_relief": "Optional[ReliefInput]",
        "gears.pinion.root_relief.amount": "Optional[Quantity]",
        "gears.pinion.root_relief.length": "Optional[Quantity]",
        "gears.pinion.root_relief.power": "Optional[int]",
        "gears.pinion.root_relief.start_diameter": "Optional[Quantity]",
        "gears.pinion.tip_chamfer": "Optional[Quantity]",
        "gears.pinion.tip_relief": 'Optional[Union[Literal["none"], ReliefInput]]',
        "gears.pinion.tip_relief.amount": "Optional[Quantity]",
        "gears.pinion.tip_relief.length": "Optional[Quantity]",
        "gears.pinion.tip_relief.power": "Optional[int]",
        "gears.pinion.tip_relief.start_diameter": "Optional[Quantity]",
        "gears.pitch_deviations": "Optional[Sequence[Quantity]]",
        "gears.pressure_angle": "Optional[Quantity]",
        "gears.profile_shift": "Optional[Sequence[float]]",
        "gears.profile_shift.0": "Optional[float]",
        "gears.profile_shift.1": "Optional[float]",
        "gears.relief_tolerance": "Optional[Quantity]",
        "gears.teeth": "Optional[Sequence[int]]",
        "gears.teeth.0": "Optional[int]",
        "gears.teeth.1": "Optional[int]",
        "gears.tip_diameter": "Optional[Sequence[Quantity]]",
        "gears.tip_diameter.0": "Optional[Quantity]",
        "gears.tip_diameter.1": "Optional[Quantity]",
        "gears.wheel": "Optional[GearFlankInput]",
        "gears.wheel.crowning": "Optional[Quantity]",
        "gears.wheel.dedendum": "Optional[float]",
        "gears.wheel.fillet_radius": "Optional[float]",
        "gears.wheel.lead_slope": "Optional[Quantity]",
        "gears.wheel.profile_crowning": "Optional[Quantity]",
        "gears.wheel.profile_slope": "Optional[Quantity]",
        "gears.wheel.relief": 'Optional[Literal["drawn", "from-trace"]]',
        "gears.wheel.root_relief": "Optional[ReliefInput]",
        "gears.wheel.root_relief.amount": "Optional[Quantity]",
        "gears.wheel.root_relief.length": "Optional[Quantity]",
        "gears.wheel.root_relief.power": "Optional[int]",
        "gears.wheel.root_relief.start_diameter": "Optional[Quantity]",
        "gears.wheel.tip_chamfer": "Optional[Quantity]",
        "gears.wheel.tip_relief": 'Optional[Union[Literal["none"], ReliefInput]]',
        "gears.wheel.tip_relief.amount": "Optional[Quantity]",
        "gears.wheel.tip_relief.length": "Optional[Quantity]",
        "gears.wheel.tip_relief.power": "Optional[int]",
        "gears.wheel.tip_relief.start_diameter": "Optional[Quantity]",
        "lubricant.assume_base_oil": 'Optional[Literal["mineral", "naphthenic", "group-iii", "pao", "ester", "polyglycol"]]',
        "lubricant.base_oil": 'Optional[Literal["mineral", "naphthenic", "group-iii", "pao", "ester", "polyglycol"]]',
        "lubricant.density": "Optional[Quantity]",
        "lubricant.density_temperature": "Optional[Quantity]",
        "lubricant.heat_capacity": "Optional[Quantity]",
        "lubricant.limiting_shear_temperature": "Optional[Quantity]",
        "lubricant.oil": "Optional[str]",
        "lubricant.oil_file": "Optional[str]",
        "lubricant.pressure_viscosity": "Optional[Quantity]",
        "lubricant.pressure_viscosity_factor": "Optional[float]",
        "lubricant.temperature_coefficient": "Optional[Quantity]",
        "lubricant.thermal_conductivity": "Optional[Quantity]",
        "lubricant.thermal_expansion": "Optional[Quantity]",
        "lubricant.viscosity": "Optional[Union[ViscosityAstmD341, ViscosityIsoVg, ViscosityVogel, ViscosityGiven]]",
        "lubricant.viscosity.at_100": "Optional[Quantity]",
        "lubricant.viscosity.at_40": "Optional[Quantity]",
        "lubricant.viscosity.law": 'Optional[Literal["astm-d341", "iso-vg", "vogel", "given"]]',
        "lubricant.viscosity.grade": "Optional[float]",
        "lubricant.viscosity.viscosity_index": "Optional[float]",
        "lubricant.viscosity.limit_viscosity": "Optional[Quantity]",
        "lubricant.viscosity.pole_kelvin": "Optional[float]",
        "lubricant.viscosity.slope_kelvin": "Optional[float]",
        "lubricant.viscosity.dynamic_viscosity": "Optional[Quantity]",
        "lubricant.viscosity.temperature": "Optional[Quantity]",
        "map.speed_max": "Optional[Quantity]",
        "map.torque_max": "Optional[Quantity]",
        "material.pinion": "Optional[BodyInput]",
        "material.pinion.conductivity": "Optional[Quantity]",
        "material.pinion.density": "Optional[Quantity]",
        "material.pinion.elastic_limit": "Optional[Quantity]",
        "material.pinion.flow_pressure": "Optional[Quantity]",
        "material.pinion.hardness": "Optional[str]",
        "material.pinion.heat_capacity": "Optional[Quantity]",
        "material.pinion.poisson": "Optional[float]",
        "material.pinion.steel": "Optional[str]",
        "material.pinion.young": "Optional[Quantity]",
        "material.wheel": "Optional[BodyInput]",
        "material.wheel.conductivity": "Optional[Quantity]",
        "material.wheel.density": "Optional[Quantity]",
        "material.wheel.elastic_limit": "Optional[Quantity]",
        "material.wheel.flow_pressure": "Optional[Quantity]",
        "material.wheel.hardness": "Optional[str]",
        "material.wheel.heat_capacity": "Optional[Quantity]",
        "material.wheel.poisson": "Optional[float]",
        "material.wheel.steel": "Optional[str]",
        "material.wheel.young": "Optional[Quantity]",
        "micropitting.load_factor": "Optional[float]",
        "micropitting.permissible": "Optional[float]",
        "micropitting.ra": "Optional[Sequence[Quantity]]",
        "micropitting.ra.0": "Optional[Quantity]",
        "micropitting.ra.1": "Optional[Quantity]",
        "model.boundary_friction": "Optional[float]",
        "model.boundary_layer": "Optional[Quantity]",
        "model.depths": "Optional[int]",
        "model.edge_contact": "Optional[bool]",
        "model.ehl": "Optional[EhlInput]",
        "model.ehl.cache": "Optional[str]",
        "model.ehl.cells": "Optional[int]",
        "model.ehl.records": "Optional[int]",
        "model.ehl.travel": "Optional[float]",
        "model.face_coupling": "Optional[float]",
        "model.film": 'Optional[Literal["steady", "dowson-toyoda", "moes", "ertel-grubin", "hamrock-dowson", "hamrock-dowson-line"]]',
        "model.film_friction": 'Optional[Union[Literal["eyring", "carreau", "newton", "xu", "iso-14179-2", "iso-14179-1", "benedict-kelley", "matsumoto", "doleschel", "eyring-arana", "constant"], FilmFriction, GearsFilmFriction]]',
        "model.film_friction.constant": "Optional[float]",
        "model.film_friction.iso-14179-2": "Optional[float]",
        "model.film_friction.xu": "Optional[str]",
        "model.film_pressure_law": 'Optional[Literal["barus", "roelands"]]',
        "model.flash_feedback": "Optional[bool]",
        "model.friction_scale": "Optional[float]",
        "model.full_film": 'Optional[Literal["formulas", "ehl", "ehl-transient"]]',
        "model.hysteresis": "Optional[Union[float, str]]",
        "model.inlet_layer": "Optional[Quantity]",
        "model.inner_boundary": "Optional[float]",
        "model.lay": 'Optional[Union[Literal["across", "isotropic"], Sequence[Union[Literal["across", "isotropic"], float]], float]]',
        "model.lay.0": 'Optional[Union[Literal["across", "isotropic"], float]]',
        "model.lay.1": 'Optional[Union[Literal["across", "isotropic"], float]]',
        "model.load_distribution": 'Optional[Union[Literal["elastic", "iso-stiffness", "uniform", "mean-length", "min-potential", "trapezoid"], LoadDistribution]]',
        "model.load_distribution.table": "Optional[Sequence[Sequence[float]]]",
        "model.load_share": 'Optional[Literal["solved", "lambda-star", "zhu-hu", "masjedi-khonsari", "jgp", "ehl"]]',
        "model.offsets": "Optional[int]",
        "model.positions": "Optional[int]",
        "model.stiffness_factor": "Optional[float]",
        "model.thermal": 'Optional[Literal["gupta", "none"]]',
        "model.tolerance": "Optional[float]",
        "model.window": "Optional[float]",
        "operation.bulk": "Optional[BulkInput]",
        "operation.bulk.between": "Optional[Quantity]",
        "operation.bulk.law": 'Optional[Literal["iso", "network"]]',
        "operation.bulk.lubrication": 'Optional[Literal["jet", "dip", "jet-and-dip", "submerged"]]',
        "operation.bulk.pinion_to_oil": "Optional[Quantity]",
        "operation.bulk.wheel_to_oil": "Optional[Quantity]",
        "operation.bulk_temperature": "Optional[Union[Sequence[Quantity], Quantity]]",
        "operation.bulk_temperature.0": "Optional[Quantity]",
        "operation.bulk_temperature.1": "Optional[Quantity]",
        "operation.oil_temperature": "Optional[Quantity]",
        "operation.running_in": "Optional[Union[bool, RunningInInput]]",
        "operation.running_in.engagements": "Optional[float]",
        "operation.running_in.torque": "Optional[Quantity]",
        "operation.speed": "Optional[Quantity]",
        "operation.temperature_deviation": "Optional[Quantity]",
        "operation.torque": "Optional[Quantity]",
        "paper.delta_step": "Optional[Quantity]",
        "paper.fluid_pressure": 'Optional[Literal["reynolds-cross", "paper"]]',
        "paper.numerical_error": "Optional[Union[float, str]]",
        "paper.position": 'Optional[Union[Literal["A", "B", "C", "D", "E"], float]]',
        "surface.coast": "Optional[CoastInput]",
        "surface.coast.pinion": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.coast.pinion.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.coast.pinion.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.coast.pinion.asperity_radius": "Optional[Quantity]",
        "surface.coast.pinion.at": "Optional[FlankPlaceInput]",
        "surface.coast.pinion.at.diameter": "Optional[Quantity]",
        "surface.coast.pinion.at.position": "Optional[Quantity]",
        "surface.coast.pinion.at.radius": "Optional[Quantity]",
        "surface.coast.pinion.at.roll_angle": "Optional[Quantity]",
        "surface.coast.pinion.at.roll_length": "Optional[Quantity]",
        "surface.coast.pinion.at.x": "Optional[Quantity]",
        "surface.coast.pinion.base_radius": "Optional[Quantity]",
        "surface.coast.pinion.columns": "Optional[Columns]",
        "surface.coast.pinion.columns.x": "Optional[int]",
        "surface.coast.pinion.columns.z": "Optional[int]",
        "surface.coast.pinion.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.coast.pinion.dx": "Optional[Quantity]",
        "surface.coast.pinion.dy": "Optional[Quantity]",
        "surface.coast.pinion.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.coast.pinion.engagements": "Optional[float]",
        "surface.coast.pinion.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.coast.pinion.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.coast.pinion.from": 'Optional[Literal["root", "tip"]]',
        "surface.coast.pinion.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.coast.pinion.invert": "Optional[bool]",
        "surface.coast.pinion.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.coast.pinion.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.coast.pinion.mirrored": "Optional[bool]",
        "surface.coast.pinion.ra": "Optional[Quantity]",
        "surface.coast.pinion.range": "Optional[str]",
        "surface.coast.pinion.row": "Optional[int]",
        "surface.coast.pinion.rows": "Optional[int]",
        "surface.coast.pinion.rpk": "Optional[Quantity]",
        "surface.coast.pinion.rq": "Optional[Quantity]",
        "surface.coast.pinion.rz": "Optional[Quantity]",
        "surface.coast.pinion.seed": "Optional[int]",
        "surface.coast.pinion.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.coast.pinion.state": "Optional[float]",
        "surface.coast.pinion.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.coast.pinion.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.coast.pinion.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.coast.pinion.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.coast.wheel": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.coast.wheel.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.coast.wheel.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.coast.wheel.asperity_radius": "Optional[Quantity]",
        "surface.coast.wheel.at": "Optional[FlankPlaceInput]",
        "surface.coast.wheel.at.diameter": "Optional[Quantity]",
        "surface.coast.wheel.at.position": "Optional[Quantity]",
        "surface.coast.wheel.at.radius": "Optional[Quantity]",
        "surface.coast.wheel.at.roll_angle": "Optional[Quantity]",
        "surface.coast.wheel.at.roll_length": "Optional[Quantity]",
        "surface.coast.wheel.at.x": "Optional[Quantity]",
        "surface.coast.wheel.base_radius": "Optional[Quantity]",
        "surface.coast.wheel.columns": "Optional[Columns]",
        "surface.coast.wheel.columns.x": "Optional[int]",
        "surface.coast.wheel.columns.z": "Optional[int]",
        "surface.coast.wheel.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.coast.wheel.dx": "Optional[Quantity]",
        "surface.coast.wheel.dy": "Optional[Quantity]",
        "surface.coast.wheel.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.coast.wheel.engagements": "Optional[float]",
        "surface.coast.wheel.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.coast.wheel.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.coast.wheel.from": 'Optional[Literal["root", "tip"]]',
        "surface.coast.wheel.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.coast.wheel.invert": "Optional[bool]",
        "surface.coast.wheel.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.coast.wheel.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.coast.wheel.mirrored": "Optional[bool]",
        "surface.coast.wheel.ra": "Optional[Quantity]",
        "surface.coast.wheel.range": "Optional[str]",
        "surface.coast.wheel.row": "Optional[int]",
        "surface.coast.wheel.rows": "Optional[int]",
        "surface.coast.wheel.rpk": "Optional[Quantity]",
        "surface.coast.wheel.rq": "Optional[Quantity]",
        "surface.coast.wheel.rz": "Optional[Quantity]",
        "surface.coast.wheel.seed": "Optional[int]",
        "surface.coast.wheel.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.coast.wheel.state": "Optional[float]",
        "surface.coast.wheel.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.coast.wheel.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.coast.wheel.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.coast.wheel.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.contact": 'Optional[Literal["lines", "patch"]]',
        "surface.cutoff": "Optional[Quantity]",
        "surface.ends": 'Optional[Literal["cut", "reg0", "reg1", "reflect"]]',
        "surface.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.form": 'Optional[Literal["none", "mean", "level", "poly2", "circle"]]',
        "surface.noise_cutoff": "Optional[Quantity]",
        "surface.outliers": "Optional[float]",
        "surface.pinion": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.pinion.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.pinion.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.pinion.asperity_radius": "Optional[Quantity]",
        "surface.pinion.at": "Optional[FlankPlaceInput]",
        "surface.pinion.at.diameter": "Optional[Quantity]",
        "surface.pinion.at.position": "Optional[Quantity]",
        "surface.pinion.at.radius": "Optional[Quantity]",
        "surface.pinion.at.roll_angle": "Optional[Quantity]",
        "surface.pinion.at.roll_length": "Optional[Quantity]",
        "surface.pinion.at.x": "Optional[Quantity]",
        "surface.pinion.base_radius": "Optional[Quantity]",
        "surface.pinion.columns": "Optional[Columns]",
        "surface.pinion.columns.x": "Optional[int]",
        "surface.pinion.columns.z": "Optional[int]",
        "surface.pinion.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.pinion.dx": "Optional[Quantity]",
        "surface.pinion.dy": "Optional[Quantity]",
        "surface.pinion.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.pinion.engagements": "Optional[float]",
        "surface.pinion.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.pinion.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.pinion.from": 'Optional[Literal["root", "tip"]]',
        "surface.pinion.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.pinion.invert": "Optional[bool]",
        "surface.pinion.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.pinion.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.pinion.mirrored": "Optional[bool]",
        "surface.pinion.ra": "Optional[Quantity]",
        "surface.pinion.range": "Optional[str]",
        "surface.pinion.row": "Optional[int]",
        "surface.pinion.rows": "Optional[int]",
        "surface.pinion.rpk": "Optional[Quantity]",
        "surface.pinion.rq": "Optional[Quantity]",
        "surface.pinion.rz": "Optional[Quantity]",
        "surface.pinion.seed": "Optional[int]",
        "surface.pinion.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.pinion.state": "Optional[float]",
        "surface.pinion.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.pinion.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.pinion.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.pinion.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.wheel": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.wheel.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.wheel.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.wheel.asperity_radius": "Optional[Quantity]",
        "surface.wheel.at": "Optional[FlankPlaceInput]",
        "surface.wheel.at.diameter": "Optional[Quantity]",
        "surface.wheel.at.position": "Optional[Quantity]",
        "surface.wheel.at.radius": "Optional[Quantity]",
        "surface.wheel.at.roll_angle": "Optional[Quantity]",
        "surface.wheel.at.roll_length": "Optional[Quantity]",
        "surface.wheel.at.x": "Optional[Quantity]",
        "surface.wheel.base_radius": "Optional[Quantity]",
        "surface.wheel.columns": "Optional[Columns]",
        "surface.wheel.columns.x": "Optional[int]",
        "surface.wheel.columns.z": "Optional[int]",
        "surface.wheel.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.wheel.dx": "Optional[Quantity]",
        "surface.wheel.dy": "Optional[Quantity]",
        "surface.wheel.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.wheel.engagements": "Optional[float]",
        "surface.wheel.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.wheel.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.wheel.from": 'Optional[Literal["root", "tip"]]',
        "surface.wheel.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.wheel.invert": "Optional[bool]",
        "surface.wheel.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.wheel.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.wheel.mirrored": "Optional[bool]",
        "surface.wheel.ra": "Optional[Quantity]",
        "surface.wheel.range": "Optional[str]",
        "surface.wheel.row": "Optional[int]",
        "surface.wheel.rows": "Optional[int]",
        "surface.wheel.rpk": "Optional[Quantity]",
        "surface.wheel.rq": "Optional[Quantity]",
        "surface.wheel.rz": "Optional[Quantity]",
        "surface.wheel.seed": "Optional[int]",
        "surface.wheel.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.wheel.state": "Optional[float]",
        "surface.wheel.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.wheel.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.wheel.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.wheel.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "vehicle.drag_area": "Optional[Quantity]",
        "vehicle.grade": "Optional[Union[float, str]]",
        "vehicle.inertia_factor": "Optional[float]",
        "vehicle.mass": "Optional[Quantity]",
        "vehicle.ratio": "Optional[float]",
        "vehicle.rolling_resistance": "Optional[float]",
        "vehicle.wheel_radius": "Optional[Quantity]",
        "gearbox.jets": "Optional[Sequence[MeshJetInput]]",
        "gearbox.tables": "Optional[Sequence[TableInput]]",
        "heat.ambient": "Optional[Quantity]",
        "heat.housing_to_ambient": "Optional[Quantity]",
        "heat.oil_to_housing": "Optional[Quantity]",
        "heat.other_losses": "Optional[Quantity]",
        "material.planet": "Optional[BodyInput]",
        "material.planet.conductivity": "Optional[Quantity]",
        "material.planet.density": "Optional[Quantity]",
        "material.planet.elastic_limit": "Optional[Quantity]",
        "material.planet.flow_pressure": "Optional[Quantity]",
        "material.planet.hardness": "Optional[str]",
        "material.planet.heat_capacity": "Optional[Quantity]",
        "material.planet.poisson": "Optional[float]",
        "material.planet.steel": "Optional[str]",
        "material.planet.young": "Optional[Quantity]",
        "material.ring": "Optional[BodyInput]",
        "material.ring.conductivity": "Optional[Quantity]",
        "material.ring.density": "Optional[Quantity]",
        "material.ring.elastic_limit": "Optional[Quantity]",
        "material.ring.flow_pressure": "Optional[Quantity]",
        "material.ring.hardness": "Optional[str]",
        "material.ring.heat_capacity": "Optional[Quantity]",
        "material.ring.poisson": "Optional[float]",
        "material.ring.steel": "Optional[str]",
        "material.ring.young": "Optional[Quantity]",
        "material.sun": "Optional[BodyInput]",
        "material.sun.conductivity": "Optional[Quantity]",
        "material.sun.density": "Optional[Quantity]",
        "material.sun.elastic_limit": "Optional[Quantity]",
        "material.sun.flow_pressure": "Optional[Quantity]",
        "material.sun.hardness": "Optional[str]",
        "material.sun.heat_capacity": "Optional[Quantity]",
        "material.sun.poisson": "Optional[float]",
        "material.sun.steel": "Optional[str]",
        "material.sun.young": "Optional[Quantity]",
        "planetary.addendum": "Optional[float]",
        "planetary.centre_distance": "Optional[Quantity]",
        "planetary.face_width": "Optional[Sequence[Quantity]]",
        "planetary.face_width.0": "Optional[Quantity]",
        "planetary.face_width.1": "Optional[Quantity]",
        "planetary.face_width.2": "Optional[Quantity]",
        "planetary.helix": "Optional[Quantity]",
        "planetary.load_share_factor": "Optional[float]",
        "planetary.module": "Optional[Quantity]",
        "planetary.planet": "Optional[GearFlankInput]",
        "planetary.planet.crowning": "Optional[Quantity]",
        "planetary.planet.dedendum": "Optional[float]",
        "planetary.planet.fillet_radius": "Optional[float]",
        "planetary.planet.lead_slope": "Optional[Quantity]",
        "planetary.planet.profile_crowning": "Optional[Quantity]",
        "planetary.planet.profile_slope": "Optional[Quantity]",
        "planetary.planet.relief": 'Optional[Literal["drawn", "from-trace"]]',
        "planetary.planet.root_relief": "Optional[ReliefInput]",
        "planetary.planet.root_relief.amount": "Optional[Quantity]",
        "planetary.planet.root_relief.length": "Optional[Quantity]",
        "planetary.planet.root_relief.power": "Optional[int]",
        "planetary.planet.root_relief.start_diameter": "Optional[Quantity]",
        "planetary.planet.tip_chamfer": "Optional[Quantity]",
        "planetary.planet.tip_relief": 'Optional[Union[Literal["none"], ReliefInput]]',
        "planetary.planet.tip_relief.amount": "Optional[Quantity]",
        "planetary.planet.tip_relief.length": "Optional[Quantity]",
        "planetary.planet.tip_relief.power": "Optional[int]",
        "planetary.planet.tip_relief.start_diameter": "Optional[Quantity]",
        "planetary.planets": "Optional[int]",
        "planetary.pressure_angle": "Optional[Quantity]",
        "planetary.profile_shift": "Optional[Sequence[float]]",
        "planetary.profile_shift.0": "Optional[float]",
        "planetary.profile_shift.1": "Optional[float]",
        "planetary.profile_shift.2": "Optional[float]",
        "planetary.ring": "Optional[GearFlankInput]",
        "planetary.ring.crowning": "Optional[Quantity]",
        "planetary.ring.dedendum": "Optional[float]",
        "planetary.ring.fillet_radius": "Optional[float]",
        "planetary.ring.lead_slope": "Optional[Quantity]",
        "planetary.ring.profile_crowning": "Optional[Quantity]",
        "planetary.ring.profile_slope": "Optional[Quantity]",
        "planetary.ring.relief": 'Optional[Literal["drawn", "from-trace"]]',
        "planetary.ring.root_relief": "Optional[ReliefInput]",
        "planetary.ring.root_relief.amount": "Optional[Quantity]",
        "planetary.ring.root_relief.length": "Optional[Quantity]",
        "planetary.ring.root_relief.power": "Optional[int]",
        "planetary.ring.root_relief.start_diameter": "Optional[Quantity]",
        "planetary.ring.tip_chamfer": "Optional[Quantity]",
        "planetary.ring.tip_relief": 'Optional[Union[Literal["none"], ReliefInput]]',
        "planetary.ring.tip_relief.amount": "Optional[Quantity]",
        "planetary.ring.tip_relief.length": "Optional[Quantity]",
        "planetary.ring.tip_relief.power": "Optional[int]",
        "planetary.ring.tip_relief.start_diameter": "Optional[Quantity]",
        "planetary.ring_speed": "Optional[Quantity]",
        "planetary.sun": "Optional[GearFlankInput]",
        "planetary.sun.crowning": "Optional[Quantity]",
        "planetary.sun.dedendum": "Optional[float]",
        "planetary.sun.fillet_radius": "Optional[float]",
        "planetary.sun.lead_slope": "Optional[Quantity]",
        "planetary.sun.profile_crowning": "Optional[Quantity]",
        "planetary.sun.profile_slope": "Optional[Quantity]",
        "planetary.sun.relief": 'Optional[Literal["drawn", "from-trace"]]',
        "planetary.sun.root_relief": "Optional[ReliefInput]",
        "planetary.sun.root_relief.amount": "Optional[Quantity]",
        "planetary.sun.root_relief.length": "Optional[Quantity]",
        "planetary.sun.root_relief.power": "Optional[int]",
        "planetary.sun.root_relief.start_diameter": "Optional[Quantity]",
        "planetary.sun.tip_chamfer": "Optional[Quantity]",
        "planetary.sun.tip_relief": 'Optional[Union[Literal["none"], ReliefInput]]',
        "planetary.sun.tip_relief.amount": "Optional[Quantity]",
        "planetary.sun.tip_relief.length": "Optional[Quantity]",
        "planetary.sun.tip_relief.power": "Optional[int]",
        "planetary.sun.tip_relief.start_diameter": "Optional[Quantity]",
        "planetary.teeth": "Optional[Sequence[int]]",
        "planetary.teeth.0": "Optional[int]",
        "planetary.teeth.1": "Optional[int]",
        "planetary.teeth.2": "Optional[int]",
        "planetary.tip_diameter": "Optional[Sequence[Quantity]]",
        "planetary.tip_diameter.0": "Optional[Quantity]",
        "planetary.tip_diameter.1": "Optional[Quantity]",
        "planetary.tip_diameter.2": "Optional[Quantity]",
        "surface.planet": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.planet.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.planet.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.planet.asperity_radius": "Optional[Quantity]",
        "surface.planet.at": "Optional[FlankPlaceInput]",
        "surface.planet.at.diameter": "Optional[Quantity]",
        "surface.planet.at.position": "Optional[Quantity]",
        "surface.planet.at.radius": "Optional[Quantity]",
        "surface.planet.at.roll_angle": "Optional[Quantity]",
        "surface.planet.at.roll_length": "Optional[Quantity]",
        "surface.planet.at.x": "Optional[Quantity]",
        "surface.planet.base_radius": "Optional[Quantity]",
        "surface.planet.columns": "Optional[Columns]",
        "surface.planet.columns.x": "Optional[int]",
        "surface.planet.columns.z": "Optional[int]",
        "surface.planet.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.planet.dx": "Optional[Quantity]",
        "surface.planet.dy": "Optional[Quantity]",
        "surface.planet.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.planet.engagements": "Optional[float]",
        "surface.planet.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.planet.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.planet.from": 'Optional[Literal["root", "tip"]]',
        "surface.planet.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.planet.invert": "Optional[bool]",
        "surface.planet.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.planet.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.planet.mirrored": "Optional[bool]",
        "surface.planet.ra": "Optional[Quantity]",
        "surface.planet.range": "Optional[str]",
        "surface.planet.row": "Optional[int]",
        "surface.planet.rows": "Optional[int]",
        "surface.planet.rpk": "Optional[Quantity]",
        "surface.planet.rq": "Optional[Quantity]",
        "surface.planet.rz": "Optional[Quantity]",
        "surface.planet.seed": "Optional[int]",
        "surface.planet.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.planet.state": "Optional[float]",
        "surface.planet.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.planet.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.planet.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.planet.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.ring": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.ring.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.ring.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.ring.asperity_radius": "Optional[Quantity]",
        "surface.ring.at": "Optional[FlankPlaceInput]",
        "surface.ring.at.diameter": "Optional[Quantity]",
        "surface.ring.at.position": "Optional[Quantity]",
        "surface.ring.at.radius": "Optional[Quantity]",
        "surface.ring.at.roll_angle": "Optional[Quantity]",
        "surface.ring.at.roll_length": "Optional[Quantity]",
        "surface.ring.at.x": "Optional[Quantity]",
        "surface.ring.base_radius": "Optional[Quantity]",
        "surface.ring.columns": "Optional[Columns]",
        "surface.ring.columns.x": "Optional[int]",
        "surface.ring.columns.z": "Optional[int]",
        "surface.ring.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.ring.dx": "Optional[Quantity]",
        "surface.ring.dy": "Optional[Quantity]",
        "surface.ring.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.ring.engagements": "Optional[float]",
        "surface.ring.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.ring.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.ring.from": 'Optional[Literal["root", "tip"]]',
        "surface.ring.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.ring.invert": "Optional[bool]",
        "surface.ring.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.ring.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.ring.mirrored": "Optional[bool]",
        "surface.ring.ra": "Optional[Quantity]",
        "surface.ring.range": "Optional[str]",
        "surface.ring.row": "Optional[int]",
        "surface.ring.rows": "Optional[int]",
        "surface.ring.rpk": "Optional[Quantity]",
        "surface.ring.rq": "Optional[Quantity]",
        "surface.ring.rz": "Optional[Quantity]",
        "surface.ring.seed": "Optional[int]",
        "surface.ring.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.ring.state": "Optional[float]",
        "surface.ring.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.ring.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.ring.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.ring.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.sun": "Optional[Union[FlankInput, str, PathLike[str], Profile]]",
        "surface.sun.abscissa": 'Optional[Literal["distance", "roll-length", "roll-degrees", "roll-radians"]]',
        "surface.sun.after": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.sun.asperity_radius": "Optional[Quantity]",
        "surface.sun.at": "Optional[FlankPlaceInput]",
        "surface.sun.at.diameter": "Optional[Quantity]",
        "surface.sun.at.position": "Optional[Quantity]",
        "surface.sun.at.radius": "Optional[Quantity]",
        "surface.sun.at.roll_angle": "Optional[Quantity]",
        "surface.sun.at.roll_length": "Optional[Quantity]",
        "surface.sun.at.x": "Optional[Quantity]",
        "surface.sun.base_radius": "Optional[Quantity]",
        "surface.sun.columns": "Optional[Columns]",
        "surface.sun.columns.x": "Optional[int]",
        "surface.sun.columns.z": "Optional[int]",
        "surface.sun.decimal": 'Optional[Literal["point", "comma"]]',
        "surface.sun.dx": "Optional[Quantity]",
        "surface.sun.dy": "Optional[Quantity]",
        "surface.sun.encoding": 'Optional[Literal["utf-8", "utf-16le", "utf-16be", "windows-1252"]]',
        "surface.sun.engagements": "Optional[float]",
        "surface.sun.file": "Optional[Union[str, PathLike[str], Profile]]",
        "surface.sun.finish": 'Optional[Literal["ground", "superfinished", "honed", "hobbed", "shaved", "skived", "lapped", "shot-peened"]]',
        "surface.sun.from": 'Optional[Literal["root", "tip"]]',
        "surface.sun.gaps": 'Optional[Literal["refuse", "interpolate"]]',
        "surface.sun.invert": "Optional[bool]",
        "surface.sun.like": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.sun.line": 'Optional[Literal["row", "column", "mean", "mean-column"]]',
        "surface.sun.mirrored": "Optional[bool]",
        "surface.sun.ra": "Optional[Quantity]",
        "surface.sun.range": "Optional[str]",
        "surface.sun.row": "Optional[int]",
        "surface.sun.rows": "Optional[int]",
        "surface.sun.rpk": "Optional[Quantity]",
        "surface.sun.rq": "Optional[Quantity]",
        "surface.sun.rz": "Optional[Quantity]",
        "surface.sun.seed": "Optional[int]",
        "surface.sun.separator": 'Optional[Literal["semicolon", "tab", "comma", "blank", "none"]]',
        "surface.sun.state": "Optional[float]",
        "surface.sun.traces": "Optional[Union[str, Sequence[Union[str, TraceInput, PathLike[str], Profile]]]]",
        "surface.sun.uneven": 'Optional[Literal["refuse", "resample"]]',
        "surface.sun.x_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "surface.sun.z_unit": 'Optional[Literal["m", "mm", "um", "nm", "angstrom", "inch", "mil", "uin"]]',
        "train.held": "Optional[Sequence[str]]",
        "train.input": "Optional[str]",
        "train.losses": 'Optional[Literal["not-passed-on", "passed-on"]]',
        "train.output": "Optional[str]",
    },
    total=False,
)
"""Tables of a case and single keys by their paths."""
