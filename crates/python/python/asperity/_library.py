"""Gears, steels and oils of the library, worked cases, cases from gearbox files."""

from __future__ import annotations

import json
import os
from os import PathLike, fspath
from pathlib import Path
from typing import Any, NamedTuple, Optional, Union, overload

from . import _asperity
from ._case import Case
from ._errors import checked, checked_or_none
from ._html import page
from ._record import Record, Table


def _listed(rows: str, name: Optional[str]) -> Any:
    found = json.loads(rows)
    return Table(found) if name is None else Record(found[0])


@overload
def gears(name: None = None) -> Table: ...
@overload
def gears(name: str) -> Record: ...


def gears(name: Optional[str] = None) -> Union[Table, Record]:
    """The gears of the library, or the gears of this name, with centre distance, contact ratio, certainty and source of
    every number, as ``asperity list gears`` lists them.

    Parameters:
        name: name of the gears; default all.

    Returns:
        A `Table` with a row per gear pair, or the `Record` of the one that is named.

    Raises:
        AsperityError: no gears of the library have this name (E220).

    Example:
        >>> round(asperity.gears("fzg-c").centre_distance_mm, 1)
        91.5
    """
    found: Union[Table, Record] = _listed(_asperity.gears(name), name)
    return found


@overload
def steels(name: None = None) -> Table: ...
@overload
def steels(name: str) -> Record: ...


def steels(name: Optional[str] = None) -> Union[Table, Record]:
    """The steels of the library, or the one of this name, with flow pressure, elastic limit, certainty and source of
    every number, as ``asperity list steels`` lists them.

    Parameters:
        name: name of the steel; default all.

    Returns:
        A `Table` with a row per steel, or the `Record` of the one that is named.

    Raises:
        AsperityError: no steel of the library has this name (E220).

    Example:
        >>> len(asperity.steels()) > 3
        True
    """
    found: Union[Table, Record] = _listed(_asperity.steels(name), name)
    return found


@overload
def oils(name: None = None) -> Table: ...
@overload
def oils(name: str) -> Record: ...


def oils(name: Optional[str] = None) -> Union[Table, Record]:
    """The oils of the library, or the one of this name, with viscosities, certainty and source of the numbers, as
    ``asperity list oils`` lists them.

    Parameters:
        name: name of the oil; default all.

    Returns:
        A `Table` with a row per oil, or the `Record` of the one that is named.

    Raises:
        AsperityError: no oil of the library has this name (E220).

    Example:
        >>> asperity.oils("m100").name
        'm100'
    """
    found: Union[Table, Record] = _listed(_asperity.oils(name), name)
    return found


def demo(
    folder: Optional[Union[str, PathLike[str]]] = None, *, gears: Optional[str] = None, paper: bool = False
) -> Path:
    """Writes a worked case with synthetic profiles into a folder and returns the path of its ``case.toml``.

    A folder that has the case as it is written is left as it is: a cell of a notebook can be run again.

    Parameters:
        folder: the folder; default ``demo``, the name of the gears, or ``table2``.
        gears: gears of the library instead of the electric drive.
        paper: Table 2 of the 2022 paper on a damaged flank.

    Returns:
        The path of the case file.

    Raises:
        AsperityError: the folder exists with other content (E401), or no gears of the library have this name (E220).

    Example:
        >>> asperity.demo("drive").name
        'case.toml'
    """
    return Path(_asperity.demo(None if folder is None else fspath(folder), gears, checked("paper", paper, bool))) / "case.toml"


class RexsCase(NamedTuple):
    """A case made from a gearbox file."""

    case: Case
    """The case."""
    toml: str
    """Its text, with the attribute of every number as a comment."""
    notes: list[str]
    """Contradictions in the file, and values that it lacks."""
    not_read: list[str]
    """Attributes of the file that the case does not use, by component."""

    def __repr__(self) -> str:
        return f"<RexsCase {self.case.title!r}: {len(self.notes)} notes, {len(self.not_read)} attributes not read>"

    def _repr_html_(self) -> str:
        rows = [("note", note) for note in self.notes] + [("not read", name) for name in self.not_read]
        return self.case._repr_html_() + page("Gearbox file", rows, None)


def rexs_contents(file: Union[str, PathLike[str]]) -> Record:
    """The stages of a REXS gearbox file with kind, teeth and the operating points of the pinion or sun, and its
    ``version``, ``program`` and ``lubricants``, as ``asperity case from-rexs`` lists them.

    Parameters:
        file: the gearbox file.

    Returns:
        A `Record` with ``stages``, ``lubricants``, ``version`` and ``program``.

    Raises:
        AsperityError: the file cannot be read as REXS (E132).

    Example:
        >>> asperity.rexs_contents("chain.rexs").stages.kind.tolist()
        ['pair', 'pair', 'bevel_stage']
    """
    return Record(json.loads(_asperity.rexs_contents(fspath(file))))


def from_rexs(
    file: Union[str, PathLike[str]],
    *,
    stage: Optional[int] = 1,
    load_case: int = 1,
    pinion: Optional[Union[str, PathLike[str]]] = None,
    wheel: Optional[Union[str, PathLike[str]]] = None,
) -> RexsCase:
    """The case of a stage of a REXS gearbox file (``.rexs``, ``.rexsj`` or zip).

    Parameters:
        file: the gearbox file.
        stage: number of the stage, in the order of the file (`rexs_contents` lists them); None for one case of all stages.
        load_case: number of the load case, in the order of the file.
        pinion, wheel: files of the traces of pinion (sun) and wheel (planet). Without ``pinion`` the case lacks its flanks (E204).

    Returns:
        A `RexsCase`: the case, its text, and what was noted and not read.

    Raises:
        AsperityError: the file cannot be read as REXS (E132), or lacks what a case needs (E133).

    Example:
        >>> made = asperity.from_rexs("chain.rexs", pinion="ground_pinion.csv")
        >>> made.case.run("losses").loss_w > 0
        True
    """
    flanks = [None if trace is None else os.path.abspath(fspath(trace)) for trace in (pinion, wheel)]
    text, notes, not_read = _asperity.from_rexs(fspath(file), checked_or_none("stage", stage, int), checked("load_case", load_case, int), (flanks[0], flanks[1]))
    folder = os.path.dirname(os.path.abspath(fspath(file)))
    return RexsCase(Case._of(_asperity.Case.from_text("case.toml", text, folder, [], None)), text, notes, not_read)
