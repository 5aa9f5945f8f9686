"""Progress: a function of steps done and their number, or a bar of tqdm."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Optional, Union

from ._errors import wrong_kind

Progress = Union[Callable[[int, int], object], Any]
"""``f(done, total)``, the class ``tqdm`` or a bar of it."""


class Steps:
    """Progress in the form that the compiled part calls; closed by ``with``."""

    def __init__(self, progress: Optional[Progress], what: str) -> None:
        self._bar: Any = None
        self._own = False
        self.call: Optional[Callable[[int, int], object]] = None
        if progress is None:
            return
        if isinstance(progress, type) and hasattr(progress, "update"):
            self._bar, self._own = progress(desc=what, total=0), True
        elif hasattr(progress, "update") and hasattr(progress, "total"):
            self._bar = progress
        if self._bar is None and not callable(progress):
            raise wrong_kind("progress", progress, "a function of steps done and their number, tqdm or a bar of it")
        self.call = progress if self._bar is None else self._move

    def _move(self, done: int, total: int) -> None:
        self._bar.total = total
        self._bar.update(done - self._bar.n)

    def __enter__(self) -> Optional[Callable[[int, int], object]]:
        return self.call

    def __exit__(self, *_: object) -> None:
        if self._own:
            self._bar.close()
