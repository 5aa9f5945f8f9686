"""Laws of Hertz contact, film thickness and friction over arrays."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from . import _asperity
from ._choices import FilmLaw, FrictionLaw, ThermalLaw
from ._errors import Code, json_text, warn
from ._quantity import Floats, Values, pressed, si_array
from ._record import Record


def _over(columns: dict[str, Floats], law: Callable[[dict[str, Floats]], dict[str, Any]]) -> dict[str, Any]:
    """The arrays of a law in the common shape of its columns; numbers where all columns are numbers.

    Where a column of an array is NaN or masked, so is the result, and the law is not asked.
    """
    given, shape = pressed(columns)
    if not shape:
        return {name: array[0].item() for name, array in law(given).items()}
    missing = np.logical_or.reduce([np.isnan(array) for array in given.values()])
    if not missing.any():
        return {name: array.reshape(shape) for name, array in law(given).items()}
    found = {}
    for name, array in law({name: array[~missing] for name, array in given.items()}).items():
        whole = np.full(missing.shape, False if array.dtype == np.bool_ else np.nan, dtype=array.dtype)
        whole[~missing] = array
        found[name] = whole.reshape(shape)
    return found


def _noted(notes: list[str]) -> list[str]:
    """The notes, after a warning of each."""
    warn({"code": Code.W401, "text": f"{note} is outside the range that the law was fitted to"} for note in notes)
    return notes


def _fitted(given: dict[str, Any], known: dict[str, str]) -> dict[str, Any]:
    """Arrays in SI units, of one shape, flat."""
    return {
        name: si_array(value, known[name], name)
        for name, value in given.items()
        if value is not None
    }


def hertz(load: Values, radius: Values, modulus: Values) -> Record:
    """Hertz line contacts: ``half_width`` (m), ``max_pressure``, ``mean_pressure`` (Pa).

    b = √(4 w R/(π E*)), p₀ = √(w E*/(π R)); Johnson, Contact Mechanics (1985).

    Parameters:
        load: load per metre w, N/m.
        radius: relative radius R, m.
        modulus: reduced modulus E*, Pa.

    The arguments are broadcast; arrays have their common shape, with NaN where an array is NaN or masked. A single NaN is refused (E209).

    Returns:
        A `Record` with ``half_width`` (m), ``max_pressure`` and ``mean_pressure`` (Pa).

    Raises:
        AsperityError: a value that is not positive (E209), of another unit (E204), or arrays that do not fit each other (E209).

    Example:
        >>> found = asperity.hertz(load=[1e5, 4e5], radius="10 mm", modulus=115e9)
        >>> bool(np.isclose(found.max_pressure[1], 2 * found.max_pressure[0]))
        True
    """
    columns = {
        "load": si_array(load, "LineLoad", "load"),
        "radius": si_array(radius, "Length", "radius"),
        "modulus": si_array(modulus, "Pressure", "modulus"),
    }
    return Record(_over(columns, lambda given: _asperity.hertz(given["load"], given["radius"], given["modulus"])))


_FILM = {
    "entrainment": "Speed",
    "radius": "Length",
    "load": "LineLoad",
    "modulus": "Pressure",
    "viscosity": "DynamicViscosity",
    "pressure_viscosity": "PressureViscosity",
    "contact_length": "Length",
}


def film_thickness(
    law: FilmLaw = "steady",
    *,
    entrainment: Values,
    radius: Values,
    load: Values,
    modulus: Values,
    viscosity: Values,
    pressure_viscosity: Values,
    contact_length: Values | None = None,
) -> Record:
    """Smooth isothermal films: ``central``, ``minimum`` (m), ``outside`` (bool), ``notes`` (what left its range).

    Parameters:
        law: ``"steady"``, ``"dowson-toyoda"``, ``"moes"``, ``"ertel-grubin"``, ``"hamrock-dowson"`` or ``"hamrock-dowson-line"``;
            ``asperity equations`` lists their sources.
        entrainment: mean surface speed, m/s.
        radius: relative radius, m.
        load: load per metre, N/m.
        modulus: reduced modulus E*, Pa.
        viscosity: at ambient pressure, Pa s.
        pressure_viscosity: coefficient α, 1/Pa.
        contact_length: m, of ``"hamrock-dowson"`` alone.

    Returns:
        A `Record` with ``central``, ``minimum``, ``outside`` and ``notes``.

    Raises:
        AsperityError: a value that is not positive (E209), of another unit (E204), or arrays that do not fit each other (E209).

    Example:
        >>> film = asperity.film_thickness(entrainment=[5.0, 10.0], radius="10 mm", load="200 N/mm", modulus=115e9,
        ...                                viscosity=0.01, pressure_viscosity=2e-8)
        >>> bool(film.central[1] > film.central[0] > film.minimum[0])
        True
    """
    given = dict(
        entrainment=entrainment,
        radius=radius,
        load=load,
        modulus=modulus,
        viscosity=viscosity,
        pressure_viscosity=pressure_viscosity,
        contact_length=contact_length,
    )
    notes: list[str] = []

    def found(columns: dict[str, Floats]) -> dict[str, Any]:
        arrays, notes[:] = _asperity.film_thickness(law, columns)
        return arrays

    return Record({**_over(_fitted(given, _FILM), found), "notes": _noted(notes)})


def thermal_reduction(
    law: ThermalLaw = "gupta", *, max_pressure: Values, modulus: Values, loading: Values, slide_to_roll: Values
) -> Record:
    """Factor by which heat in the inlet thins a film: ``factor``, ``outside``, ``notes``.

    Parameters:
        law: ``"gupta"`` (1992) or ``"none"``.
        max_pressure: Hertz pressure, Pa.
        modulus: reduced modulus E*, Pa.
        loading: thermal loading L = η β V²/k.
        slide_to_roll: slide-to-roll ratio.

    Returns:
        A `Record` with ``factor``, ``outside`` and ``notes``.

    Raises:
        AsperityError: a value that is not positive (E209), of another unit (E204), or arrays that do not fit each other (E209).

    Example:
        >>> found = asperity.thermal_reduction(max_pressure=1e9, modulus=115e9, loading=[0.1, 1.0], slide_to_roll=0.2)
        >>> bool(found.factor[1] < found.factor[0] < 1)
        True
    """
    given = {"max_pressure": max_pressure, "modulus": modulus, "loading": loading, "slide_to_roll": slide_to_roll}
    known = {"max_pressure": "Pressure", "modulus": "Pressure", "loading": "", "slide_to_roll": ""}
    notes: list[str] = []

    def found(columns: dict[str, Floats]) -> dict[str, Any]:
        factor, outside, notes[:] = _asperity.thermal_reduction(law, columns)
        return {"factor": factor, "outside": outside}

    return Record({**_over(_fitted(given, known), found), "notes": _noted(notes)})


_FRICTION = {
    "load": "LineLoad",
    "radius": "Length",
    "entrainment": "Speed",
    "sliding": "Speed",
    "max_pressure": "Pressure",
    "viscosity": "DynamicViscosity",
    "contact_viscosity": "DynamicViscosity",
    "kinematic_viscosity": "KinematicViscosity",
    "pressure_viscosity": "PressureViscosity",
    "central_film": "Length",
    "minimum_film": "Length",
    "combined_roughness": "Length",
    "mean_ra": "Length",
    "sum_rz": "Length",
    "boundary_coefficient": "",
    "base_line_load": "LineLoad",
    "sum_speed": "Speed",
    "reduced_radius": "Length",
    "lubricant_factor": "",
    "load_intensity": "Pressure",
    "pitch_line_speed": "Speed",
}


def friction_coefficient(
    law: FrictionLaw = "xu",
    *,
    settings: dict[str, Any] | None = None,
    load: Values | None = None,
    radius: Values | None = None,
    entrainment: Values | None = None,
    sliding: Values | None = None,
    max_pressure: Values | None = None,
    viscosity: Values | None = None,
    contact_viscosity: Values | None = None,
    kinematic_viscosity: Values | None = None,
    pressure_viscosity: Values | None = None,
    central_film: Values | None = None,
    minimum_film: Values | None = None,
    combined_roughness: Values | None = None,
    mean_ra: Values | None = None,
    sum_rz: Values | None = None,
    boundary_coefficient: Values | None = None,
    base_line_load: Values | None = None,
    sum_speed: Values | None = None,
    reduced_radius: Values | None = None,
    lubricant_factor: Values | None = None,
    load_intensity: Values | None = None,
    pitch_line_speed: Values | None = None,
) -> Record:
    """Friction coefficients by a published law: ``coefficient``, ``outside``, ``notes``.

    Parameters:
        law: ``"xu"``, ``"benedict-kelley"``, ``"iso-14179-1"``, ``"iso-14179-2"``, ``"matsumoto"``, ``"doleschel"``,
            ``"eyring-arana"`` or ``"constant"``; ``asperity equations`` lists their sources.
        settings: ``constant``, ``fluid_coefficient``, ``limiting_stress`` and ``xu`` as in ``model.friction_settings``.
        load, ..., pitch_line_speed: the inputs of the law, in SI units; the last six are of the whole mesh. An input
            that the law requires and that is missing is refused.

    Returns:
        A `Record` with ``coefficient``, ``outside`` and ``notes``.

    Raises:
        AsperityError: an input that the law requires is missing (E205), or a value is out of its domain (E209).

    Example:
        >>> asperity.friction_coefficient("constant", settings={"constant": 0.05}).coefficient
        0.05
    """
    every = locals()
    given = {name: every[name] for name in _FRICTION if every[name] is not None} or {"boundary_coefficient": 0.0}
    notes: list[str] = []

    def found(columns: dict[str, Floats]) -> dict[str, Any]:
        coefficient, outside, notes[:] = _asperity.friction_coefficient(law, columns, json_text(settings or {}, "settings"))
        return {"coefficient": coefficient, "outside": outside}

    return Record({**_over(_fitted(given, _FRICTION), found), "notes": _noted(notes)})
