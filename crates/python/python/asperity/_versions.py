"""Versions, for reports of faults."""

from __future__ import annotations

from ._asperity import __version__

_PACKAGES = ("numpy", "pandas", "xarray", "pyarrow", "pint", "tqdm", "matplotlib", "dask")
"""Packages that the module uses, or that take its results."""


def show_versions() -> None:
    """Prints the versions of the program, of Python, and of the packages that it uses, for a report of a fault.

    Returns:
        None.

    Raises:
        OSError: the text cannot be printed.

    Example:
        >>> asperity.show_versions()  # doctest: +ELLIPSIS
        asperity    ...
    """
    # At its first need: they take time to import.
    import platform
    from importlib import metadata

    found = {"asperity": __version__, "python": platform.python_version(), "platform": platform.platform()}
    for package in _PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "not installed"
    for name, version in found.items():
        print(f"{name:<12}{version}")
