"""Objects whose attributes are not assigned."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Optional

from . import _asperity


def similar(name: str, known: Iterable[str]) -> Optional[str]:
    """The name that is meant: the most similar one, or the only one of the same unit of which the name is a short form."""
    names = [*known]
    stem, _, unit = name.rpartition("_")
    longer = [one for one in names if stem and one.startswith(stem) and one.endswith(f"_{unit}")]
    return longer[0] if len(longer) == 1 else _asperity.nearest(name, names)


def unknown(kind: str, name: object, known: Iterable[str], more: Iterable[str] = ()) -> str:
    """The text about a name that is not known: the most similar one, and those that there are; some more can be meant."""
    names = [*known]
    like = similar(str(name), [*names, *(one for one in more if not one.startswith("_"))])
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
