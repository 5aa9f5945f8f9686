"""Objects whose attributes are not assigned."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from . import _asperity


def unknown(kind: str, name: object, known: Iterable[str], more: Iterable[str] = ()) -> str:
    """The text about a name that is not known: the most similar one, and those that there are; some more can be meant."""
    names = [*known]
    like = _asperity.nearest(str(name), [*names, *(one for one in more if not one.startswith("_"))])
    meant = f" Did you mean {like!r}?" if like else ""
    return f"{kind} has no {name!r}.{meant} It has {', '.join(names)}."


class UnknownName(KeyError):
    """The error of an item that there is not, whose text is shown as it is."""

    def __str__(self) -> str:
        return str(self.args[0])


class Fixed:
    """What is not changed by the assignment of an attribute, which would change no result; it is refused."""

    if not TYPE_CHECKING:  # A type checker knows the attributes that there are.

        def __setattr__(self, name: str, value: object) -> None:
            if not name.startswith("_"):
                raise AttributeError(f"{type(self).__name__}.{name} cannot be assigned: a {type(self).__name__} does not change")
            object.__setattr__(self, name, value)
