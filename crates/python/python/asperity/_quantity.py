"""Numbers in SI units, text with a unit, quantities of pint: all become numbers in SI units."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _asperity
from ._errors import AsperityError


class PintLike(Protocol):
    """A quantity of pint, or of a package with the same two members."""

    @property
    def magnitude(self) -> Any: ...

    def to(self, other: Any, /) -> Any: ...


Scalar = Union[float, str, PintLike]
"""A number in SI units, text with a unit (``"1.8 mm"``), or a quantity of pint."""

Values = Union[Scalar, ArrayLike, Sequence[str]]
"""The same, or arrays and lists of them."""

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
    "W/(m K)": "W/(m*K)",
    "J/(kg K)": "J/(kg*K)",
}


def is_pint(value: object) -> bool:
    """Whether the value carries its unit."""
    return hasattr(value, "magnitude") and hasattr(value, "to")


def _magnitude(value: Any, quantity: str) -> Any:
    unit = SI_UNITS[quantity]
    try:
        return value.to(_PINT.get(unit, unit)).magnitude
    except Exception as error:
        text = f"{value}: is no {quantity}, whose unit is {unit}: {error}"
        raise AsperityError(text, "E204", f"Give a quantity that has the dimension of {unit}.") from error


def si(value: Scalar, quantity: str) -> float:
    """The value in SI units."""
    if isinstance(value, str):
        return _asperity.to_si(quantity, value)
    if is_pint(value):
        value = _magnitude(value, quantity)
    try:
        return float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError) as error:
        text = f"{value!r}: is no {quantity}; a number in {SI_UNITS[quantity]} or text with a unit is expected"
        raise AsperityError(text, "E204", 'Write text with a unit, e.g. "1.8 mm", or a number.') from error


def si_or_none(value: Scalar | None, quantity: str) -> float | None:
    """The same, where there is a value."""
    return None if value is None else si(value, quantity)


def si_array(value: Values, quantity: str) -> Floats:
    """The values in SI units, of any shape."""
    if is_pint(value):
        value = _magnitude(value, quantity)
    if isinstance(value, str):
        return np.asarray(si(value, quantity))
    if isinstance(value, (list, tuple)) and any(isinstance(item, str) or is_pint(item) for item in value):
        value = [si(item, quantity) for item in value]
    return numbers(value, quantity)


def numbers(value: object, name: str) -> Floats:
    """An array of numbers."""
    try:
        return np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError) as error:
        text = f"{name}: an array of numbers is expected: {error}"
        raise AsperityError(text, "E204", "Give an array of numbers in SI units.") from error


def flat(value: Floats, name: str) -> Floats:
    """An array of one dimension, as the compiled part takes it."""
    if value.ndim != 1:
        text = f"{name}: an array of one dimension is expected, this one has {value.ndim}"
        raise AsperityError(text, "E209", "Pass one profile or gap at a time.")
    return value


def pressed(values: dict[str, Floats]) -> tuple[dict[str, Floats], tuple[int, ...]]:
    """Arrays of one shape by the rules of numpy, flat, and that shape."""
    try:
        wide = np.broadcast_arrays(*values.values())
    except ValueError as error:
        text = f"the arrays do not fit each other: {error}"
        raise AsperityError(text, "E209", "Give arrays that numpy can broadcast to one shape.") from error
    shape = wide[0].shape
    return {name: array.ravel() for name, array in zip(values, wide)}, shape
