"""The error and the warning of every function of the package."""

from __future__ import annotations

import json
import sys
import warnings
from collections.abc import Iterable, Mapping
from operator import index
from typing import Any, NamedTuple, Optional, TypeVar, Union

from . import _asperity

N = TypeVar("N", bound=float)

Code = _asperity.Code
"""The stable codes by name, as the table of messages has them."""


class Place(NamedTuple):
    """Place in a case that an error is about."""

    file: str
    """Name of the case file, `case` or `case.json` for one in memory."""
    key: Optional[str]
    """Path of the key, as `gears.module`."""
    line: Optional[int]
    """Line from 1, where the case has a text."""
    column: Optional[int]
    """Column from 1, where the case has a text."""
    mesh: Optional[str]
    """Mesh of a gear train."""


def general_help(code: str) -> str:
    """The general advice of a code."""
    explained = _asperity.explain(code)
    return explained[2] if explained else ""


class AsperityError(ValueError):
    """What cannot be read, computed or written.

    Attributes:
        code: stable code such as ``E301``; `asperity.explain` says more about it.
        message: what is wrong, where, what was seen and what was expected.
        help: what to do about it.
        place: place in the case, where the error is about one.
        actions: the remedies as data, the best first.
    """

    code: str
    message: str
    help: str
    place: Optional[Place]
    actions: list[dict[str, Any]]

    def __init__(
        self,
        message: str,
        code: str = Code.E209,
        help: str = "",
        place: Optional[tuple[Any, ...]] = None,
        actions: str = "[]",
    ) -> None:
        super().__init__(message, code, help, place, actions)
        self.code = code
        self.message = message
        self.help = help or general_help(code)
        self.place = None if place is None else Place(*place)
        self.actions = json.loads(actions)

    def __str__(self) -> str:
        text = f"{self.code} {self.message}"
        return f"{text}\nhelp: {self.help}" if self.help else text

    def __repr__(self) -> str:
        return f"AsperityError({self.code} {self.message})"


class AsperityWarning(UserWarning):
    """A doubt about an input or a result, which also holds it among its ``warnings``.

    Attributes:
        code: stable code such as ``W401``; `asperity.explain` says more about it.
        text: what is doubtful.
        help: what to do about it.
    """

    code: str
    text: str
    help: str

    def __init__(self, code: str, text: str, help: str = "") -> None:
        super().__init__(code, text, help)
        self.code, self.text, self.help = code, text, help

    def __str__(self) -> str:
        return f"{self.code} {self.text}"


def brief(value: object) -> str:
    """A value in a message, shortened; a quantity of pint as text."""
    text = " ".join((str(value) if hasattr(value, "magnitude") else repr(value)).split())
    return text if len(text) <= 80 else f"{text[:60]} ... {text[-15:]}"


def wrong_kind(name: str, value: object, takes: str) -> AsperityError:
    """The error of an argument of a kind that a function does not take."""
    shape = getattr(value, "shape", None)
    seen = f"an array of shape {shape}" if isinstance(shape, tuple) else f"{brief(value)} of type {type(value).__name__}"
    has_heights = bool(shape) or isinstance(value, (list, tuple)) and value and isinstance(value[0], float)
    flank = name.removesuffix(".file")
    help = f"Give {flank} as asperity.Profile(heights, spacing), the profile of an array." if has_heights and "profile" in takes else f"Give {name} as {takes}."
    return AsperityError(f"{name}: {takes} is expected, not {seen}", Code.E204, help)


def json_text(value: Any, name: str = "", indent: Optional[int] = None) -> str:
    """The arguments of a function by name as JSON, or the error of one of another kind."""

    def plain(of: Any) -> Any:
        if getattr(of, "shape", None) == () and hasattr(of, "item") and isinstance(of.item(), (bool, int, float, str)):
            return of.item()
        holders = value.items() if isinstance(value, Mapping) else ()
        names = [str(key) for key, one in holders if one is of]
        raise wrong_kind(names[0] if names else name or "a value", of, "a number, a text, a list or a table")

    return json.dumps(value, ensure_ascii=False, indent=indent, default=plain)


def not_finite(name: str, value: float) -> AsperityError:
    """The error of a number that is NaN or infinite."""
    return AsperityError(f"{name}: {value}: must be a finite number", Code.E209, "Give a finite number, or leave it out.")


_KINDS = {float: "a number", int: "a number without decimals", bool: "True or False"}


def checked(name: str, value: Any, kind: type[N]) -> N:
    """The value of an argument, of the kind int, float or bool."""
    try:
        if kind is bool and value not in (True, False):
            raise TypeError
        return kind(index(value)) if kind is int else kind(value)
    except (TypeError, ValueError):
        raise wrong_kind(name, value, _KINDS[kind]) from None


def checked_or_none(name: str, value: Any, kind: type[N]) -> Optional[N]:
    """The same of an argument that can be missing."""
    return None if value is None else checked(name, value, kind)


Row = Union[str, Mapping[str, Any]]
"""A warning: code, text and help; or a text that begins with its code."""


def _parts(row: Row) -> tuple[str, str, str]:
    """Code, text and help of a warning."""
    if isinstance(row, str) or "code" not in row:
        code, _, text = (row if isinstance(row, str) else str(row["text"])).partition(" ")
        return code, text, general_help(code)
    return row["code"], row["text"], row.get("help") or general_help(row["code"])


def _of(row: Row) -> str:
    """The finishes that a warning is about, in brackets; nothing if it is about all."""
    names = [] if isinstance(row, str) else row.get("of") or []
    return f" ({', '.join(names)})" if names else ""


def of_several(warnings: Iterable[tuple[str, str]], count: int) -> list[Row]:
    """Distinct warnings, as code and text with the name of the part that has it, of `count` parts."""
    of: dict[str, list[str]] = {}
    for warning, name in warnings:
        of.setdefault(warning, []).append(name)
    return [{"text": text, "of": [] if len(names) == count else names} for text, names in of.items()]


def warn(rows: Iterable[Row], known: Iterable[Row] = ()) -> None:
    """Warns of every row with a code that is not known yet, at the line outside of the package.

    A map lists other notes on its points among its warnings, as points that are extrapolated, which have no code.
    """
    told = {_parts(row)[1] for row in known}
    read = [(*_parts(row), _of(row)) for row in rows]
    new = [(code, text + of, help) for code, text, help, of in read if text and text not in told]
    if not new:
        return
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for code, text, help in new:
        warnings.warn(AsperityWarning(code, text, help), stacklevel=level)
