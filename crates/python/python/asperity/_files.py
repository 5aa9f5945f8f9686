"""Objects that are read like files."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from os import PathLike, fspath
from typing import IO, Any, Union

from ._errors import AsperityError, Code, wrong_kind

Paths = Union[str, PathLike[str], Sequence[Union[str, PathLike[str]]]]
"""A path, or a list of paths."""


def is_read(file: Any) -> bool:
    """Whether an object is read like a file."""
    return hasattr(file, "read")


def text_of(file: Any) -> str:
    """The text in an object that is read like a file."""
    content = file.read()
    try:
        return content.decode("utf-8") if isinstance(content, bytes) else str(content)
    except UnicodeDecodeError as error:
        raise AsperityError(f"the text cannot be read: {error}", Code.E202, "Encode the text in UTF-8.") from error


def paths(given: Paths, name: str) -> list[str]:
    """One path or several as text; ``name`` is that of the argument."""
    found: list[str] = []
    for path in given if isinstance(given, (list, tuple)) else [given]:
        if not isinstance(path, (str, PathLike)):
            raise wrong_kind(name, path, "a path, or a list of paths")
        found.append(fspath(path))
    return found


@contextmanager
def on_disk(file: Union[str, PathLike[str], IO[bytes]]) -> Iterator[str]:
    """The name of a file with the bytes of an object that is read like one."""
    if isinstance(file, (str, PathLike)):
        yield fspath(file)
        return
    if not is_read(file):
        raise wrong_kind("path", file, "a path, or an object that is read like a file")
    import tempfile
    from pathlib import Path

    content: Any = file.read()
    name = str(getattr(file, "name", "profile")).replace("\\", "/").rsplit("/", 1)[-1]
    with tempfile.TemporaryDirectory() as place:
        copy = Path(place) / (name or "profile")
        copy.write_bytes(content.encode() if isinstance(content, str) else content)
        yield str(copy)
