"""The command ``asperity``, also as ``python -m asperity``."""

from __future__ import annotations

import sys

from ._asperity import command


def main() -> int:
    """Runs the command line of this process and returns its exit status."""
    return command(["asperity", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
