"""Objects whose attributes are not assigned."""

from __future__ import annotations

from typing import TYPE_CHECKING


class Fixed:
    """What is not changed by the assignment of an attribute, which would change no result; it is refused."""

    if not TYPE_CHECKING:  # A type checker knows the attributes that there are.

        def __setattr__(self, name: str, value: object) -> None:
            if not name.startswith("_"):
                raise AttributeError(f"{type(self).__name__}.{name} cannot be assigned: a {type(self).__name__} does not change")
            object.__setattr__(self, name, value)
