"""Frames and columns as text of a table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import IO, Any, Optional, Protocol, Union

import numpy as np
from numpy.typing import NDArray

from ._errors import AsperityError, Code, brief, wrong_kind
from ._files import is_read, text_of
from ._quantity import OPERATING, in_unit, is_pint
from ._record import Rows, described


class FrameLike(Protocol):
    """A frame of pandas, polars or another package: names of columns, and columns by name."""

    @property
    def columns(self) -> Any: ...

    def __getitem__(self, name: Any, /) -> Any: ...


Columns = Union[str, PathLike[str], IO[str], IO[bytes], FrameLike, Mapping[str, Union[Sequence[Any], NDArray[Any]]], Rows]
"""A file, an object that is read like one, a table, a frame or columns by their names."""


def in_unit_of(name: str, column: Any) -> Any:
    """The numbers of a quantity of pint in the unit that the name of its column states."""
    of = OPERATING.get(name)
    return in_unit(column, of.quantity, of.pint) if of else in_unit(column, "", described(name)["units"])


def table_text(columns_by_name: Any, what: str, code: str) -> str:
    """The table as text, or the error ``code`` about ``what``."""
    if is_read(columns_by_name):
        return text_of(columns_by_name)
    # pyarrow has the arrays themselves as columns.
    of_arrow = getattr(columns_by_name, "column_names", None)
    if isinstance(of_arrow, list) and hasattr(columns_by_name, "to_pydict"):
        columns_by_name = columns_by_name.to_pydict()
    if not isinstance(columns_by_name, Mapping) and not hasattr(columns_by_name, "columns"):
        raise wrong_kind(what, columns_by_name, "a file, a table, a frame or columns by name")
    # At their first need: they take time to import.
    import csv
    import io

    names = columns_by_name if isinstance(columns_by_name, Mapping) else columns_by_name.columns
    for name in names:
        column = columns_by_name[name]
        if isinstance(column, (str, bytes, Mapping)) or not hasattr(column, "__iter__"):
            text = f"{what}: its column {name!r} is not a list of values but {brief(column)}"
            raise AsperityError(text, Code.E204, "Give a table, such as .points or .rows of a result, or numbers in the units of the columns.")
    columns = {str(name): _values(columns_by_name[name], str(name)) for name in names}
    if len({len(column) for column in columns.values()}) > 1:
        text = f"{what}: its columns differ in length"
        raise AsperityError(text, code, "Give every column one value per measurement.")
    simulated = columns.pop("simulated", [])
    written = io.StringIO()
    writer = csv.writer(written, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(value) for value in row] for row in zip(*columns.values()))
    # At the end, so that messages count the heading as line 1.
    written.write("# SIMULATED\n" if any(simulated) else "")
    return written.getvalue()


def table_of(table: Columns, name: str, code: str) -> tuple[str, Optional[str]]:
    """A table by its name with its text, which a file does not have, or the error ``code``."""
    if isinstance(table, (str, PathLike)):
        return fspath(table), None
    return name, table_text(table, name, code)


def _values(column: Any, name: str) -> list[Any]:
    """The values of a column in Python's own types, also of a variable of xarray; a quantity of pint in the unit of the name."""
    if is_pint(column):
        column = in_unit_of(name, column)
    return np.asarray(column).tolist() if hasattr(column, "dims") else list(column)


def _cell(value: Any) -> str:
    """A cell; empty where there is nothing."""
    missing = value is None or value != value
    return "" if missing else str(value)
