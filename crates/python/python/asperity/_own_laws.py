"""Laws written in Python: conditions as arrays over the offsets, results checked."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple, Optional

import numpy as np

from ._errors import AsperityError, Code
from ._quantity import Floats, numbers
from ._record import Record

Law = Callable[[Record], Any]
"""A function, or an object with ``__call__``, of the conditions."""

_RESULTS: dict[str, tuple[tuple[str, Optional[float], float, float], ...]] = {
    "film-friction": (("coefficient", None, 0.0, 2.0),),
    "film-thickness": (("central", None, 0.0, 1.0), ("minimum", None, 0.0, 1.0)),
    "load-share": (("film_share", None, 0.0, 1.0), ("boundary_part", 1.0, 0.0, 1.0), ("lubricated_coefficient", 0.0, 0.0, 2.0)),
    "load-distribution": (("line_load", None, 0.0, np.inf),),
}
"""Values that a law returns: name, default, least and largest."""


def name_of(law: Any) -> str:
    """Name of a law: its ``name``, or the name of the function or class."""
    return str(getattr(law, "name", None) or getattr(law, "__name__", None) or type(law).__name__)


class Called(NamedTuple):
    """A law of one kind as the compiled part calls it."""

    kind: str
    law: Law

    def __call__(self, conditions: Mapping[str, Floats], count: int) -> dict[str, Floats]:
        """The checked results of the law for these conditions."""
        given = Record({})
        # They are made for this call alone, and a law may change them in place.
        given._values.update(conditions)
        found = self.law(given)
        results = _RESULTS[self.kind]
        if not isinstance(found, Mapping):
            found = dict.fromkeys((name for name, default, *_ in results if default is None), found)
        if unknown := set(found) - {name for name, *_ in results}:
            known = ", ".join(name for name, *_ in results)
            raise self._refused(f"returns {', '.join(sorted(unknown))}; known are {known}")
        return {
            name: self._array(found.get(name, default), count, name, least, largest)
            for name, default, least, largest in results
        }

    def _array(self, values: Any, count: int, name: str, least: float, largest: float) -> Floats:
        if values is None:
            raise self._refused(f"returns no {name}")
        array = numbers(values, name)
        if array.size != count and array.size != 1:
            raise self._refused(f"returns {array.size} values of {name} for {count} conditions")
        array = np.array(np.broadcast_to(array.reshape(-1), (count,)))
        wrong = ~(np.isfinite(array) & (array >= least) & (array <= largest))
        if wrong.any():
            place = int(np.argmax(wrong))
            raise self._refused(f"returns {name} = {array[place]:g} at place {place}; it must be {least:g} to {largest:g}")
        return array

    def _refused(self, what: str) -> AsperityError:
        return AsperityError(f"the law {name_of(self.law)} {what}", Code.E209, "Correct the law.")


def exponent_of(kind: str, law: Any) -> float:
    """Exponent of speed in the central film by a law of film thickness."""
    if not callable(law):
        raise AsperityError(f"{law!r}: a law must be callable", Code.E205, "Give a function or an object with __call__.")
    if kind != "film-thickness":
        return 0.0
    exponent = getattr(law, "speed_exponent", None)
    if exponent is None:
        text = f"the film thickness law {name_of(law)} has no speed_exponent, which the film parameter requires"
        raise AsperityError(text, Code.E205, "Set law.speed_exponent, the exponent of speed in its central film.")
    found = float(numbers(exponent, "speed_exponent"))
    if not 0.0 < found < 2.0:
        text = f"the speed_exponent {found:g} of the law {name_of(law)} must be between 0 and 2"
        raise AsperityError(text, Code.E209, "Correct the law.")
    return found
