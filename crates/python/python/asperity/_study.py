"""Studies: results with a summary and a folder of files."""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike, fspath
from typing import Any, Optional, Protocol, TypeVar, Union

from . import _asperity
from ._errors import AsperityError, Code, checked_or_none, json_text, not_finite, warn
from ._html import page
from ._progress import Progress, Steps
from ._quantity import in_numbers
from ._record import Values


class RawStudy(Protocol):
    """A study of the compiled part."""

    def json(self) -> str: ...
    def summary(self) -> str: ...
    def write(self, folder: Union[str, PathLike[str]]) -> None: ...


def files_of(raw: Any) -> dict[str, bytes]:
    """Names and contents of the files that a study writes."""
    import tempfile
    from pathlib import Path

    with tempfile.TemporaryDirectory() as place:
        folder = Path(place) / "study"
        raw.write(fspath(folder))
        files = (file for file in folder.rglob("*") if file.is_file())
        return {file.relative_to(folder).as_posix(): file.read_bytes() for file in files}


class Unpickled:
    """A study that another process made: its texts and files."""

    def __init__(self, text: Any, summary: str, files: dict[str, bytes]) -> None:
        self._text, self._summary, self._files = text, summary, files

    def json(self) -> Any:
        """The JSON text of the study."""
        return self._text

    def summary(self) -> str:
        """The summary as text."""
        return self._summary

    def write(self, folder: Union[str, PathLike[str]]) -> None:
        """Writes the files of the study into a new folder."""
        from pathlib import Path

        place = Path(folder)
        try:
            place.mkdir(parents=True)
            for name, content in self._files.items():
                (place / name).parent.mkdir(exist_ok=True)
                (place / name).write_bytes(content)
        except OSError as error:
            raise AsperityError(f"{place}: {error}", Code.E401, "Name a folder that does not exist.") from error


class Study(Values):
    """A study: values as attributes, a summary as text, a folder of files."""

    def __init__(self, raw: RawStudy) -> None:
        super().__init__(in_numbers(json.loads(raw.json())))
        self._raw = raw

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (Unpickled(self._raw.json(), self._raw.summary(), files_of(self._raw)),)

    def write(self, folder: Union[str, PathLike[str]]) -> None:
        """Writes the folder of the command."""
        self._raw.write(fspath(folder))

    def __str__(self) -> str:
        return self._raw.summary()

    def __repr__(self) -> str:
        found = ", ".join(f"{name} {value}" for name, value in self._rows()[:4])
        return f"<{type(self).__name__} {self._values['title']!r}: {found}>"

    def _repr_html_(self) -> str:
        return page(str(self._values["title"]), self._rows(), None)

    def _rows(self) -> list[tuple[str, str]]:
        """Names and values that a notebook shows, the first of which are those of `repr`."""
        return []

    def _doubts(self) -> Iterable[Any]:
        """Its warnings."""
        doubts: Iterable[Any] = self._values.get("warnings", ())
        return doubts


S = TypeVar("S", bound=Study)


def as_json(settings: Mapping[str, Any]) -> str:
    """Settings as JSON, whose numbers are finite."""
    for name, value in settings.items():
        if isinstance(value, float) and not math.isfinite(value):
            raise not_finite(name, value)
    return json_text(settings)


def _cases(given: Any) -> Iterator[_asperity.Case]:
    """The cases among what is given."""
    if isinstance(given, _asperity.Case):
        yield given
    elif isinstance(given, (list, tuple)):
        for one in given:
            yield from _cases(one)


def ran(
    kind: type[S],
    name: str,
    given: tuple[Any, ...],
    settings: Mapping[str, Any],
    threads: Optional[int],
    progress: Optional[Progress] = None,
) -> S:
    """The study ``name`` of what is given, by its settings, after a warning of each doubt that the cases do not have."""
    with Steps(progress, _asperity.steps(name)) as steps:
        found = kind(_asperity.study(name, given, as_json(settings), checked_or_none("threads", threads, int), steps))
    warn(found._doubts(), (warning for case in _cases(given) for warning in json.loads(case.warnings)))
    return found
