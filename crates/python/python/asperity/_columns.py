"""Frames and columns as text of a table."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from os import PathLike, fspath
from typing import IO, TYPE_CHECKING, Any, Optional, Union

from ._errors import AsperityError
from ._files import is_read, text_of

if TYPE_CHECKING:
    import pandas

Columns = Union[str, "PathLike[str]", IO[str], IO[bytes], "pandas.DataFrame", Mapping[str, Sequence[Any]]]
"""A file, an object that is read like one, a frame or columns by their names."""


def table_text(columns_by_name: Any, what: str, code: str) -> str:
    """The table as text, or the error ``code`` about ``what``."""
    if is_read(columns_by_name):
        return text_of(columns_by_name)
    # At their first need: they take time to import.
    import csv
    import io

    columns = {str(name): list(columns_by_name[name]) for name in columns_by_name}
    if len({len(column) for column in columns.values()}) > 1:
        text = f"{what}: its columns differ in length"
        raise AsperityError(text, code, "Give every column one value per measurement.")
    simulated = columns.pop("simulated", [])
    written = io.StringIO()
    if any(simulated):
        written.write("# SIMULATED\n")
    writer = csv.writer(written, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(value) for value in row] for row in zip(*columns.values()))
    return written.getvalue()


def table_of(table: Columns, name: str, code: str) -> tuple[str, Optional[str]]:
    """A table by its name with its text, which a file does not have, or the error ``code``."""
    if isinstance(table, (str, PathLike)):
        return fspath(table), None
    return name, table_text(table, name, code)


def _cell(value: Any) -> str:
    """A cell; empty where there is nothing."""
    missing = value is None or value != value
    return "" if missing else str(value)
