"""Text with a unit and quantities of pint as numbers; numbers in the unit that their name states, or in SI units."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Optional, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _asperity
from ._errors import AsperityError, Code, brief, not_finite
from ._fixed import similar


class PintLike(Protocol):
    """A quantity of pint, or of a package with the same two members."""

    @property
    def magnitude(self) -> Any: ...

    def to(self, other: Any, /) -> Any: ...


Scalar = Union[float, str, PintLike]
"""A number in SI units, text with a unit (``"1.8 mm"``), or a quantity of pint."""

Values = Union[Scalar, ArrayLike, Sequence[str]]
"""Numbers in SI units, text with a unit, or quantities of pint; single, or in arrays and lists."""

Quantity = Union[str, PintLike]
"""Text with a unit (``"1.8 mm"``) or a quantity of pint."""

Quantities = Union[Quantity, Sequence[Quantity]]
"""Text with a unit or a quantity of pint, or lists of them."""

Numbers = Union[float, Sequence[float], NDArray[Any]]
"""A number, or an array or list of numbers."""

Floats = NDArray[np.float64]
"""Array of 64-bit floating-point numbers."""

SI_UNITS: dict[str, str] = dict(_asperity.si_units())
"""SI unit by the name of a quantity."""

# What pint calls the units that it does not read as they are written.
_PINT = {
    "N m": "N*m",
    "m2": "m**2",
    "Pa s": "Pa*s",
    "m2/s": "m**2/s",
    "kg/m3": "kg/m**3",
    "m3/s": "m**3/s",
    "W/(m K)": "W/(m*K)",
    "J/(kg K)": "J/(kg*K)",
}


_ANGLES = ("rad", "deg", "°", "rev", "turn", "cycle", "rpm", "rps", "gon", "arc")
"""Parts of the names of units with an angle."""


def _angle(value: Any, quantity: str) -> float:
    """The angle of a turn for a rotational speed whose unit has none: 1/min and Hz count turns, as in text."""
    unit = str(getattr(value, "units", _ANGLES[0])).lower()
    is_count = quantity == "AngularSpeed" and not any(angle in unit for angle in _ANGLES)
    return 2.0 * np.pi if is_count else 1.0


def is_pint(value: object) -> bool:
    """Whether the value carries its unit."""
    return hasattr(value, "magnitude") and hasattr(value, "to")


def in_unit(value: Any, quantity: str, unit: Optional[str] = None) -> Any:
    """The numbers of a quantity of pint in a unit, by default the SI unit."""
    unit = unit or SI_UNITS.get(quantity, "")
    try:
        if quantity == "Temperature" and "delta_" in str(getattr(value, "units", "")):
            raise ValueError("a temperature difference is not a temperature")
        magnitude, angle = value.to(_PINT.get(unit, unit)).magnitude, _angle(value, quantity)
        return magnitude if angle == 1.0 else angle * magnitude
    except Exception as error:
        text = f"{brief(value)}: is not a {quantity or 'number'}, whose unit is {unit or '1'}: {error}"
        raise AsperityError(text, Code.E204, f"Give a quantity that has the dimension of {unit or '1'}.") from error


def si(value: Scalar, quantity: str, name: str = "") -> float:
    """The value in SI units; ``name`` is that of the argument."""
    if isinstance(value, str):
        return _asperity.to_si(quantity, value, name)
    if is_pint(value):
        value = in_unit(value, quantity)
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError) as error:
        seen = f"{name}: {brief(value)}" if name else f"{brief(value)}:"
        text = f"{seen} is not a {quantity}; a number in {SI_UNITS[quantity]} or text with a unit is expected"
        raise AsperityError(text, Code.E204, 'Write text with a unit, e.g. "1.8 mm", or a number.') from error


def si_or_none(value: Scalar | None, quantity: str, name: str = "") -> float | None:
    """The same, where there is a value."""
    return None if value is None else si(value, quantity, name)


_NAMED: dict[str, tuple[str, float]] = {
    "m": ("um", 1e-6), "mm": ("um", 1e-3), "um": ("um", 1.0), "nm": ("um", 1e3), "deg": ("deg", 1.0), "s": ("s", 1.0), "ms": ("s", 1e3),
    "m/s": ("m_per_s", 1.0), "1/min": ("rpm", 1.0), "kg": ("kg", 1.0), "m2": ("m2", 1.0), "kN": ("n", 1e-3), "N": ("n", 1.0),
    "N/mm": ("n_per_mm", 1.0), "N/m": ("n_per_mm", 1e3), "N m": ("nm", 1.0), "kW": ("w", 1e-3), "W": ("w", 1.0), "J": ("j", 1.0),
    "mJ": ("j", 1e3), "J/m": ("j_per_m", 1.0), "mJ/m": ("j_per_m", 1e3), "GPa": ("mpa", 1e-3), "MPa": ("mpa", 1.0), "kPa": ("mpa", 1e3),
    "Pa": ("mpa", 1e6), "mPa s": ("mpa_s", 1.0), "mm2/s": ("mm2_per_s", 1.0), "kg/m3": ("kg_per_m3", 1.0), "1/GPa": ("per_gpa", 1.0),
    "1/Pa": ("per_gpa", 1e-9), "°C": ("c", 1.0), "K": ("k", 1.0), "W/(m K)": ("w_per_m_k", 1.0), "W/K": ("w_per_k", 1.0), "l/min": ("l_per_min", 1.0),
    "J/(kg K)": ("j_per_kg_k", 1.0), "1/K": ("per_k", 1.0), "%": ("percent", 1.0),
}
"""Ends of names and divisors of the units in which the compiled part writes quantities as text: one unit for each quantity."""

_STATED = ("input", "inputs", "defaults", "changes", "recipe", "from", "to")
"""Values that are as a case or a recipe states them, and stay text."""

_WORDS = frozenset((
    "title", "name", "names", "key", "keys", "label", "kind", "id", "tag", "file", "files", "folder", "case_file", "oil_file", "source", "text", "mesh",
    "finish", "finishes", "fitted_to", "oil", "base_oil", "what", "value", "values", "of", "code", "parameter", "assembly", "assemblies", "shaft", "shafts",
    "sets", "columns", "command", "program", "notes", "note", "message", "warnings", "measurement", "group", "part", "other", "taken", "stage", "stages",
    "flank", "flanks", "contact", "contacts",
))
"""Names and words, which stay text also where they read like a quantity."""


def _number(value: object, mm: bool) -> Optional[tuple[float, str]]:
    """Number and end of the name of text with a unit; lengths in mm or µm."""
    if not isinstance(value, str):
        return None
    number, _, unit = value.partition(" ")
    if unit not in _NAMED:
        return None
    try:
        found = float(number)
    except ValueError:
        return None
    end, divisor = _NAMED[unit]
    return (found / (divisor * 1e3), "mm") if mm and end == "um" else (found / divisor, end)


def in_numbers(value: Any, mm: bool = False) -> Any:
    """Values of a JSON text whose quantities are numbers in the unit that ends their names: ``"90 °C"`` as ``temperature_c`` 90.

    Lengths of gears are in mm, all others in µm. Names and words stay text, and so do lists of several units and keys that a user has named.
    """
    if isinstance(value, list):
        return [in_numbers(item, mm) for item in value]
    if not isinstance(value, dict):
        return value
    found: dict[str, Any] = {}
    for name, item in value.items():
        if name in _STATED:
            found[name] = item
            continue
        is_mm = mm or name == "gears"
        every = [_number(one, is_mm) for one in (item if isinstance(item, list) else [item])]
        numbers = [one for one in every if one is not None]
        is_quantity = name not in _WORDS and name.isidentifier() and len({end for _, end in numbers}) == 1
        if not is_quantity or len(numbers) < len(every):
            found[name] = in_numbers(item, is_mm)
            continue
        plain = [number for number, _ in numbers]
        found[f"{name}_{numbers[0][1]}"] = plain if isinstance(item, list) else plain[0]
    return found


class Operating(NamedTuple):
    """A quantity of the operating point: its unit in names of keywords, columns and results."""

    quantity: str
    unit: str
    key: str
    pint: str
    spellings: tuple[str, ...]
    scale: float = 1.0
    offset: float = 0.0

    def number(self, value: object, name: str) -> float:
        """The quantity in its unit; text in this unit to the last digit."""
        if isinstance(value, str):
            text = value.strip()
            unit = next((unit for unit in self.spellings if text.endswith(unit)), None)
            if unit is not None:
                try:
                    return float(text.removesuffix(unit))
                except ValueError:
                    pass  # Read, or refused, below.
            return _asperity.to_si(self.quantity, value, "") * self.scale + self.offset
        if is_pint(value):
            return float(in_unit(value, self.quantity, self.pint))
        raise _without_unit(name, value, self.quantity)


OPERATING: dict[str, Operating] = {
    "torque_nm": Operating("Torque", "N m", "operation.torque", "N*m", ("N m", "Nm")),
    "speed_rpm": Operating("AngularSpeed", "1/min", "operation.speed", "rpm", ("1/min", "rpm", "min-1"), 30.0 / np.pi),
    "temperature_c": Operating(
        "Temperature", "°C", "operation.bulk_temperature", "degC", ("°C", "C"), 1.0, -273.15
    ),
}
"""Quantities of the operating point by the names under which they are numbers."""


def _without_unit(name: str, value: object, quantity: str) -> AsperityError:
    own = next((own for own, of in OPERATING.items() if of.quantity == quantity and own.startswith(name)), None)
    number = f", or a number by {own}" if own else ""
    text = f"{name}: {brief(value)} has no unit; text with a unit or a quantity of pint is expected"
    return AsperityError(text, Code.E204, f'Write text with a unit, e.g. "1 {SI_UNITS[quantity]}"{number}.')


def stated(value: Quantity, quantity: str, name: str) -> float:
    """The value in SI units of text with a unit or of a quantity of pint, never of a bare number."""
    if isinstance(value, str) or is_pint(value):
        return si(value, quantity)
    raise _without_unit(name, value, quantity)


def written(value: Quantity, quantity: str, name: str) -> str:
    """The same as text in SI units."""
    return f"{stated(value, quantity, name)!r} {SI_UNITS[quantity]}"


def stated_or_none(value: Optional[Quantity], quantity: str, name: str) -> Optional[float]:
    """The same of a value that can be missing."""
    return None if value is None else stated(value, quantity, name)


def operating(own: str, given: Optional[Numbers], text: Optional[Quantities]) -> Optional[Floats]:
    """Numbers of an operating quantity in its unit: given as such, or by text, a range or pint."""
    of, name = OPERATING[own], own.rsplit("_", 1)[0]
    if given is not None and text is not None:
        raise AsperityError(f"{name} and {own}: both are given", Code.E205, "Give one of both.")
    if given is not None:
        if isinstance(given, (str, bool)) or is_pint(given):
            raise AsperityError(f"{own}: {brief(given)}: must be a number in {of.unit}", Code.E204, f"Give it by {name}.")
        return np.atleast_1d(numbers(given, own))
    if isinstance(text, str) and ".." in text:
        unit = next((unit for unit in of.spellings if text.strip().endswith(f" {unit}")), None)
        if unit is None:
            message = f"{name}: {brief(text)}: a range must end with its unit {of.unit}"
            raise AsperityError(message, Code.E204, f'Write e.g. "10..100:5 {of.unit}".')
        return np.array(_asperity.axis(text.strip().removesuffix(unit).strip()))
    if text is None:
        return None
    if is_pint(text):
        return np.atleast_1d(np.asarray(in_unit(text, of.quantity, of.pint), dtype=np.float64))
    every: Any = text if isinstance(text, (list, tuple)) else [text]
    return np.array([of.number(one, name) for one in every])


def axis_of(found: Floats, name: str) -> list[float]:
    """Nodes of an axis as a list."""
    if found.ndim != 1:
        text = f"{name}: an array of one dimension is expected, this one has {found.ndim}"
        raise AsperityError(text, Code.E209, "Give the nodes of the axis.")
    nodes: list[float] = found.tolist()
    return nodes


def nodes(own: str, given: Optional[Numbers], text: Optional[Quantities], default: Optional[str]) -> Union[list[float], str, None]:
    """Nodes of an axis of an operating quantity in its unit, or the text of the default."""
    found = operating(own, given, text)
    return default if found is None else axis_of(flat(found, own), own)


def _single(name: str, found: Optional[Floats]) -> float:
    """The only number of an operating quantity."""
    if found is None or found.shape != (1,):
        text = f"{name}: {brief(found)}: one number is expected"
        raise AsperityError(text, Code.E204, f"Give a number in {OPERATING[name].unit}.")
    return float(found[0])


def number(own: str, given: Optional[float], text: Optional[Quantity]) -> Optional[float]:
    """A number of an operating quantity in its unit, if one is given."""
    found = operating(own, given, text)
    return None if found is None else _single(own, found)


BY_TEXT: dict[str, str] = {own.rsplit("_", 1)[0]: own for own in OPERATING}
"""The same by the names under which they are text with a unit."""


def is_table(name: str) -> bool:
    """Whether a case has a table or a key of this name, or of its part before the first point."""
    # At its first need: the schema is not part of a run.
    from ._keys import Schema

    return any(Schema(kind).has(name.split(".")[0]) for kind in ("gears", "mesh"))


def refuse_misspelt(name: str) -> None:
    """Refuses a name that is similar to one of the operating point, and is none of a case."""
    like = similar(name, [*OPERATING, *BY_TEXT])
    if like and not is_table(name):
        raise AsperityError(f'case: unknown key "{name}". Did you mean "{like}"?', Code.E203, f"Write {like}.")


def as_keys(given: Mapping[str, Any]) -> dict[str, Any]:
    """Keys of a case, the numbers of its operating point as text with their units."""
    keys: dict[str, Any] = {}
    for name, value in given.items():
        own = BY_TEXT.get(name, name)
        of = OPERATING.get(own)
        if of is None:
            refuse_misspelt(name)
            keys[name] = value
            continue
        if of.key in keys:
            raise AsperityError(f"{name}: {of.key} is given twice", Code.E205, "Give one of both.")
        if value is None:
            keys[of.key] = None
        elif name != own:
            if not isinstance(value, str) and not is_pint(value):
                raise _without_unit(name, value, of.quantity)
            keys[of.key] = value
        else:
            found = _single(name, operating(name, value, None))
            if not np.isfinite(found):
                raise not_finite(name, found)
            keys[of.key] = f"{found!r} {of.unit}".replace(".0 ", " ")
    return keys


def _in_si(value: Any, quantity: str, name: str) -> Any:
    """The value without a unit: in SI units where it, or what it consists of, carries one."""
    # Frames of pint-pandas and arrays of pint-xarray hold a quantity.
    for holder, member in (("array", "quantity"), ("variable", "data")):
        held = getattr(getattr(value, holder, None), member, None)
        value = held if is_pint(held) else value
    if is_pint(value):
        return in_unit(value, quantity)
    if hasattr(value, "to") and (hasattr(value, "unit") or hasattr(value, "units")):
        text = f"{name}: {brief(value)} has a unit of another package than pint"
        raise AsperityError(text, Code.E204, "Give a quantity of pint, or numbers in SI units.")
    if isinstance(value, np.ndarray) and value.dtype == object and not isinstance(value, np.ma.MaskedArray):
        value = value.tolist()
    if isinstance(value, (list, tuple)) and any(is_pint(item) for item in value):
        return [in_unit(item, quantity) if is_pint(item) else item for item in value]
    return value


def si_array(value: Values, quantity: str, name: str = "") -> Floats:
    """The values in SI units, of any shape."""
    if isinstance(value, str) and quantity:
        return np.asarray(si(value, quantity))
    value = _in_si(value, quantity, name or quantity)
    if quantity and isinstance(value, (list, tuple)) and any(isinstance(item, str) for item in value):
        value = [si(item, quantity) if isinstance(item, str) else item for item in value]
    return numbers(value, name or quantity)


def line(value: object, quantity: str, name: str) -> Floats:
    """The values in SI units along one line, of numbers or a quantity of pint, as the compiled part takes them."""
    return flat(numbers(_in_si(value, quantity, name), name), name)


def numbers(value: object, name: str) -> Floats:
    """An array of numbers, which have no unit."""
    value = _in_si(value, "", name)
    if isinstance(value, np.ma.MaskedArray):
        value = np.ma.filled(value.astype(np.float64), np.nan)
    try:
        array = np.asarray(value)
        if array.dtype.kind not in "biufO" or array.dtype == object and any(isinstance(item, str) for item in array.flat):
            raise TypeError(f"{brief(value)} holds {array.dtype}")
        return np.asarray(array, dtype=np.float64)
    except (TypeError, ValueError) as error:
        text = f"{name}: an array of numbers is expected: {error}"
        raise AsperityError(text, Code.E204, "Give an array of numbers in SI units.") from error


def flat(value: Floats, name: str) -> Floats:
    """An array of one dimension, as the compiled part takes it."""
    if value.ndim != 1:
        text = f"{name}: an array of one dimension is expected, this one has {value.ndim}"
        raise AsperityError(text, Code.E209, "Pass one profile or gap at a time.")
    if not np.isfinite(value).all():
        wrong = np.flatnonzero(~np.isfinite(value))
        text = f"{name}: {value[wrong[0]]} at index {wrong[0]}; {len(wrong)} of {len(value)} values are not finite"
        raise AsperityError(text, Code.E209, "Interpolate these values, or cut the array before them.")
    return value


def together(values: Sequence[Floats]) -> list[Floats]:
    """The arrays broadcast to one shape."""
    try:
        return list(np.broadcast_arrays(*values))
    except ValueError as error:
        text = f"the arrays do not fit each other: {error}"
        raise AsperityError(text, Code.E209, "Give arrays that numpy can broadcast to one shape.") from error


def pressed(values: dict[str, Floats]) -> tuple[dict[str, Floats], tuple[int, ...]]:
    """Arrays of one shape by the rules of numpy, flat, and that shape."""
    wide = together(list(values.values()))
    shape = wide[0].shape
    return {name: array.ravel() for name, array in zip(values, wide)}, shape
