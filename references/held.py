"""Numbers that the tests of the project hold, looked up in the test files themselves.

A script recomputes a number from its formula and calls `held`: among all numbers written in the test file there must
be one that agrees with it. So a script needs no copy of the expected values, and fails when either side changes.
"""

import math
import re
import sys
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
NUMBER = re.compile(r"-?\b\d[\d_]*(?:\.[\d_]+)?(?:[eE][+-]?\d+)?")

checked = 0
failed = 0
largest = {}


@lru_cache(maxsize=None)
def numbers(file):
    """Every number in a file, rising."""
    text = (ROOT / file).read_text(encoding="utf-8")
    return sorted(float(word.replace("_", "")) for word in NUMBER.findall(text))


def held(file, what, value, tolerance=1e-12):
    """Whether `file` holds `value` within the relative `tolerance`."""
    global checked, failed
    value = float(value)
    nearest = min(numbers(file), key=lambda number: abs(number - value))
    off = abs(nearest - value) / abs(value) if value else abs(nearest)
    checked += 1
    if not off <= tolerance or math.isnan(value):
        failed += 1
        print(f"DIFFERS {file}: {what} is {value!r} here, the nearest number there is {nearest!r} ({off:.1e} off)")


def agree(what, value, expected, tolerance):
    """Whether two numbers of a script agree, such as a closed form and a quadrature."""
    global checked, failed
    checked += 1
    if not abs(value - expected) <= tolerance * abs(expected):
        failed += 1
        print(f"DIFFERS {what}: {value!r} is not {expected!r}")


def compare(kind, what, value, expected, tolerance, floor=0.0):
    """Whether two numbers agree to the relative `tolerance` or the absolute `floor`; `report` tells the largest
    deviation of each kind."""
    off = abs(value - expected)
    relative = off / abs(expected) if expected else (0.0 if off <= floor else math.inf)
    if not relative <= largest.get(kind, (-1.0, ""))[0]:
        largest[kind] = (relative, what)
    agree(f"{kind} of {what}", value, expected, max(tolerance, floor / abs(expected)) if expected else tolerance)


def report():
    """Prints the count; the exit status tells whether all agree."""
    for kind, (off, what) in largest.items():
        print(f"  {kind}: largest deviation {off:.1e} ({what})")
    print(f"{Path(sys.argv[0]).name}: {checked - failed} of {checked} numbers agree")
    sys.exit(1 if failed else 0)
