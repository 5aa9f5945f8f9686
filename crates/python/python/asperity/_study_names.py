"""Names of the studies.

Written by crates/python/typed.py from the settings of the compiled part.
"""

__all__ = [
    "calibrate",
    "callout",
    "compare",
    "cycle",
    "design",
    "evidence",
    "oil_fit",
    "oil_plan",
    "oil_traction",
    "profile_change",
    "ridges",
    "running_in",
    "sensitivity",
    "stribeck",
]
