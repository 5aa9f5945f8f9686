"""The error of every function of the package."""

from __future__ import annotations

import json
from typing import Any, NamedTuple, Optional


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


class AsperityError(ValueError):
    """What cannot be read, computed or written.

    Attributes:
        code: stable code such as ``"E301"``; `asperity.explain` says more about it.
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
        code: str = "E209",
        help: str = "",
        place: Optional[tuple[Any, ...]] = None,
        actions: str = "[]",
    ) -> None:
        super().__init__(message, code, help, place, actions)
        self.code = code
        self.message = message
        self.help = help
        self.place = None if place is None else Place(*place)
        self.actions = json.loads(actions)

    def __str__(self) -> str:
        text = f"{self.code} {self.message}"
        return f"{text}\nhelp: {self.help}" if self.help else text
