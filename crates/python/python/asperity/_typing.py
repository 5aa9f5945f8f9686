"""Names of typing that Python 3.10 does not have."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from typing_extensions import Unpack as Unpack
elif sys.version_info >= (3, 11):
    from typing import Unpack
else:

    class Unpack:
        """Keywords of a `TypedDict`, which type checkers read."""

        def __class_getitem__(cls, of: object) -> object:
            return of
