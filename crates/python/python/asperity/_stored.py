"""Results read back from their folders."""

from __future__ import annotations

import json
from os import PathLike, fspath
from pathlib import Path
from typing import Any, Union

from . import _asperity
from ._errors import AsperityError, Code
from ._map import Map, read_map
from ._quantity import in_numbers
from ._record import Record
from ._result import RunResult


_STUDIES = ("compare", "sensitivity", "ridges", "running_in", "callout", "sweep", "calibration", "design", "evidence", "cycle", "change", "oil_fit", "oil_plan", "traction", "stribeck")
"""Names of the JSON files of all studies except maps."""


def _study(file: Path) -> Record:
    """The values of a study as its file has them."""
    try:
        return Record(in_numbers(json.loads(file.read_text(encoding="utf-8"))))
    except ValueError as error:
        raise AsperityError(f"{file}: is damaged: {error}", Code.E402) from error


def _with_meshes(place: Path, file: Path) -> RunResult:
    """The result of several meshes, each read from its folder."""
    text = _asperity.read_whole(fspath(file))
    made = RunResult(json.loads(text))
    made._json = text
    found = [read_result(one) for one in place.iterdir() if (one / "result.json").is_file()]
    meshes = {one._values["mesh"]: one for one in found if isinstance(one, RunResult)}
    order = [row["mesh"] for row in made._values["meshes"]]
    if {*order} != {*meshes}:
        text = f"{place}: {file.name} has the meshes {', '.join(order)}, and the folder the results of {', '.join(sorted(meshes)) or 'none'}"
        raise AsperityError(text, Code.E402, "Run the case again.")
    made._meshes = [meshes[name] for name in order]
    return made


def read_result(folder: Union[str, PathLike[str]]) -> Union[RunResult, Map, Record]:
    """The result in a folder: of ``asperity run`` (or its ``result.json``), of a gear train with its meshes, of a map, or of another study.

    The fields of single positions are not read.

    Parameters:
        folder: the folder, or the file ``result.json`` in it.

    Returns:
        The `RunResult`, the `Map`, or the `Record` of another study.

    Raises:
        AsperityError: the folder holds no result, or a file of it is damaged (E402).

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> result = case.run()
        >>> result.write("result")
        >>> asperity.read_result("result").loss_w == result.loss_w
        True
    """
    place = Path(folder)
    if (place / "map.json").is_file():
        return read_map(place)
    if not (place / "result.json").is_file():
        for file in (place / "train.json", place / "planetary.json"):
            if file.is_file():
                return _with_meshes(place, file)
        for name in _STUDIES:
            if (place / f"{name}.json").is_file():
                return _study(place / f"{name}.json")
    text = _asperity.read_result(fspath(folder))
    result = RunResult(json.loads(text))
    result._json = text
    return result
