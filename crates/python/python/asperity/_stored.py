"""Results read back from their folders."""

from __future__ import annotations

import json
from os import PathLike, fspath
from typing import Union

from . import _asperity
from ._map import Map, read_map
from ._record import Record
from ._result import RunResult


def read_result(folder: Union[str, PathLike[str]]) -> Union[RunResult, Map, Record]:
    """The result in a folder: of ``asperity run`` (or its ``result.json``), ``map``, ``compare``, ``sensitivity``, ``sweep``
    or ``calibrate``.

    The fields of single positions are not read. Of a gear train the folders of its meshes are read.

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
    from pathlib import Path

    place = Path(folder)
    if (place / "map.json").is_file():
        return read_map(place)
    for name in ("compare.json", "sensitivity.json", "ridges.json", "callout.json", "sweep.json", "calibration.json", "design.json"):
        if (place / name).is_file():
            return Record(json.loads((place / name).read_text(encoding="utf-8")))
    text = _asperity.read_result(fspath(folder))
    result = RunResult(json.loads(text))
    result._json = text
    return result
