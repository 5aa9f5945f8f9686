"""Rough line contacts."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _asperity
from ._choices import Boundary
from ._errors import AsperityError, Code, checked, json_text, wrong_kind
from ._html import Chart, page, shown
from ._profile import Profile
from ._quantity import Floats, Scalar, Values, line, si, si_array, si_or_none
from ._record import Table, Values as Named, variable, warned
from ._values import ContactNumbers

if TYPE_CHECKING:
    import pandas
    import xarray

class Contact(ContactNumbers):
    """A solved contact: numbers with units in their names, arrays of shape (n,), of a patch (rows, n), in SI units.

    Numbers: ``load_n_per_m``, ``approach_m`` (over ``approach_datum_m``), ``contact_fraction``, ``p_max_pa``,
    ``p_end_pa``, ``plastic_energy_j_per_m``, ``elastic_energy_j_per_m``, ``iterations``; ``certificate`` has the
    bounds of the error.
    """

    def __init__(self, numbers: str, arrays: dict[str, Floats]) -> None:
        of = json.loads(numbers)
        if rows := of.get("rows"):
            arrays = {name: array if name == "x" else array.reshape(rows, -1) for name, array in arrays.items()}
        super().__init__({**of, **arrays})

    @property
    def x(self) -> Floats:
        """Positions along rolling from the middle, m."""
        return self._array("x")

    @property
    def y(self) -> Floats:
        """Positions of the rows along the lead from the middle, m; of a line one."""
        rows, spacing = self._values.get("rows") or 1, self._values.get("lead_spacing_m") or 0.0
        return (np.arange(rows) - (rows - 1) / 2) * float(spacing)

    @property
    def undeformed(self) -> Floats:
        """Gap before contact, m."""
        return self._array("undeformed")

    @property
    def pressure(self) -> Floats:
        """Pressure between the solids, Pa."""
        return self._array("pressure")

    @property
    def gap(self) -> Floats:
        """Gap in contact, m."""
        return self._array("gap")

    @property
    def displacement(self) -> Floats:
        """Elastic displacement of both bodies together, m."""
        return self._array("displacement")

    @property
    def plastic_displacement(self) -> Floats:
        """Plastic displacement of both bodies together, m."""
        return self._array("plastic_displacement")

    def _array(self, name: str) -> Floats:
        array: Floats = self._values[name]
        return array

    @property
    def approach(self) -> float:
        """Approach of the bodies, m."""
        return float(self._values["approach_m"])

    @property
    def warnings(self) -> Table:  # type: ignore[override]
        """Doubts about the problem: code and text."""
        return Table(self._values["warnings"], ["code", "text"])

    def stress(
        self, depths: Values, *, traction: Optional[ArrayLike] = None, poisson: float = 0.3
    ) -> Stress:
        """Stress below the surface at ``depths`` in m; see `subsurface_stress`."""
        spacing = float(self._values["spacing_m"])
        return subsurface_stress(self.pressure, spacing, depths, traction=traction, poisson=poisson)

    def plot(self, ax: Any = None) -> Any:
        """Pressure in MPa, of a patch its mean along the lead, over x in µm, on axes of matplotlib or as a `Chart`."""
        x, pressure = self.x * 1e6, self.pressure.reshape(-1, len(self.x)).mean(axis=0) * 1e-6
        return shown(Chart("Contact pressure", x.tolist(), [("pressure", pressure.tolist())], ("x in µm", "pressure in MPa")), ax)

    def to_pandas(self) -> pandas.DataFrame:
        """The arrays as a `pandas.DataFrame`; of a patch row after row, with x and y."""
        import pandas

        if self._values.get("rows") is None:
            return pandas.DataFrame({name: self._values[name] for name in _POINTS})
        y, x = np.meshgrid(self.y, self.x, indexing="ij")
        arrays = {name: self._values[name] for name in _POINTS if name != "x"}
        return pandas.DataFrame({name: array.reshape(-1) for name, array in {"x": x, "y": y, **arrays}.items()})

    def to_xarray(self) -> xarray.Dataset:
        """The arrays over x, of a patch over y and x, as an `xarray.Dataset`, the numbers as its attributes."""
        import xarray

        is_patch = self._values.get("rows") is not None
        over = ("y", "x") if is_patch else "x"
        arrays = {name: variable(over, name, self._values[name], unit) for name, unit in _POINTS.items() if name != "x"}
        plain = (int, float, str)
        attributes = {name: value for name, value in self._values.items() if isinstance(value, plain)}
        places = {"x": self.x, "y": self.y} if is_patch else {"x": self.x}
        coordinates = {name: variable(name, name, place, "m") for name, place in places.items()}
        return xarray.Dataset(arrays, coords=coordinates, attrs=attributes)

    def __repr__(self) -> str:
        of = self._values
        return (
            f"<Contact: {of['points']} points, p_max {of['p_max_pa'] * 1e-6:.6g} MPa, "
            f"contact {100 * of['contact_fraction']:.4g} %, duality gap {of['certificate']['duality_gap']:.1e}>"
        )

    def _repr_html_(self) -> str:
        of = self._values
        rows = [
            ("load", f"{of['load_n_per_m'] * 1e-3:.6g} N/mm"),
            ("largest pressure", f"{of['p_max_pa'] * 1e-6:.6g} MPa"),
            ("contact", f"{100 * of['contact_fraction']:.4g} %"),
            ("approach", f"{of['approach_m'] * 1e6:.6g} µm"),
            ("iterations", str(of["iterations"])),
        ]
        rows += [(warning.code, warning.text) for warning in self.warnings]
        return page("Contact", rows, str(self.plot()))


_POINTS = {
    "x": "m",
    "undeformed": "m",
    "pressure": "Pa",
    "gap": "m",
    "displacement": "m",
    "plastic_displacement": "m",
}


class Stress(Named):
    """Stress below a surface, tension positive: arrays of shape (depths, points), Pa.

    ``depths`` (m), ``sigma_xx``, ``sigma_zz``, ``tau_xz``, ``von_mises``, ``von_mises_max_pa``,
    ``von_mises_depth_m``, ``von_mises_position_m`` from the first point.
    """

    depths: Floats; sigma_xx: Floats; sigma_zz: Floats; tau_xz: Floats; von_mises: Floats
    von_mises_max_pa: float; von_mises_depth_m: float; von_mises_position_m: float


def _asked(boundary: str, tolerance: float, iterations: int, cascade: bool, window: bool, **numbers: Any) -> str:
    settings = {"tolerance": tolerance, "max-iterations": iterations, "cascade": cascade, "window": window}
    return json_text({"boundary": boundary, "settings": settings, **numbers})


def solve_contact(
    gap: Union[ArrayLike, Profile],
    spacing: Optional[Scalar] = None,
    modulus: Optional[Scalar] = None,
    load: Optional[Scalar] = None,
    *,
    lead_spacing: Optional[Scalar] = None,
    approach: Optional[Scalar] = None,
    datum: Optional[Scalar] = None,
    boundary: Boundary = "free",
    pressure_limit: Optional[Scalar] = None,
    prescribed_pressure: Optional[ArrayLike] = None,
    start: Optional[ArrayLike] = None,
    tolerance: float = 1e-8,
    max_iterations: int = 5000,
    cascade: bool = True,
    window: bool = True,
) -> Contact:
    """Presses two elastic bodies with a gap between them together: along a line (plane strain), or over a patch that is periodic
    along the lead.

    Parameters:
        gap: undeformed gap, shape (n,), m, from any datum; of a patch (rows, n), each row along rolling.
        spacing: distance of the points along rolling, m.
        modulus: reduced modulus E* = 1/Σ((1 − ν²)/E), Pa.
        load: load per metre of face width, of a patch its mean, N/m; of a period where the ends are periodic.
        lead_spacing: distance of the rows of a patch, m.
        approach: approach of the bodies instead of a load, m.
        datum: distance at which the displacement by a cell is zero, m; default twice the window.
        boundary: ``"free"``, ``"periodic"`` or ``"periodic-spectral"``.
        pressure_limit: pressure at which the softer body flows, Pa.
        prescribed_pressure: further pressure on both bodies, of the shape of the gap, Pa.
        start: pressure to start from, of the shape of the gap, Pa.
        tolerance: largest duality gap, penetration and load error; at most 1e-4.
        max_iterations: most iterations on the finest grid.
        cascade: whether coarser grids are solved first.
        window: whether the part that touches is solved first.

    Solved by an active set with conjugate gradients over fast Fourier transforms, every solution with its
    certificate (``asperity equations Duality-1``).

    Returns:
        The `Contact`.

    Raises:
        AsperityError: spacing, modulus, or load and approach are missing (E205), a value is out of its domain (E209), or the
            contact cannot be solved to the tolerance (E301) or below the pressure limit (E302).

    Example:
        >>> x = (np.arange(2001) - 1000) * 0.5e-6
        >>> contact = asperity.solve_contact(x**2 / 0.02, 0.5e-6, 115e9, load=2e5)
        >>> hertz = asperity.hertz(load=2e5, radius=0.01, modulus=115e9)
        >>> bool(np.isclose(contact.p_max_pa, hertz.max_pressure, rtol=1e-3))
        True
        >>> y = np.arange(8)[:, None] / 8
        >>> patch = asperity.solve_contact(x**2 / 0.02 + 2e-8 * np.sin(2 * np.pi * y), 0.5e-6, 115e9, load=2e5, lead_spacing=5e-6)
        >>> patch.pressure.shape
        (8, 2001)
    """
    if isinstance(gap, Profile):
        spacing = gap.spacing if spacing is None else spacing
        gap = -gap.heights
    if spacing is None or modulus is None:
        raise AsperityError("a contact needs spacing and modulus", Code.E205, "Give the spacing of the points and E*.")

    rows: Optional[int] = None

    def whole(values: Any, quantity: str, name: str) -> Floats:
        """The values of a line, or of the rows of a patch one after the other."""
        if lead_spacing is None:
            return line(values, quantity, name)
        array = si_array(values, quantity, name)
        if array.ndim != 2 or rows not in (None, len(array)):
            text = f"{name}: rows of points are expected where a lead_spacing is given, this array has the shape {array.shape}"
            raise AsperityError(text, Code.E209, "Pass an array of the shape (rows, n), or no lead_spacing.")
        return line(array.reshape(-1), quantity, name)

    def optional(values: Optional[ArrayLike], name: str) -> Optional[Floats]:
        return None if values is None else whole(values, "Pressure", name)

    points = whole(gap, "Length", "gap")
    if lead_spacing is not None:
        rows = np.shape(gap)[0]

    asked = _asked(
        boundary,
        tolerance,
        max_iterations,
        cascade,
        window,
        spacing=si(spacing, "Length", "spacing"),
        rows=rows,
        lead_spacing=si_or_none(lead_spacing, "Length", "lead_spacing"),
        modulus=si(modulus, "Pressure", "modulus"),
        load=si_or_none(load, "LineLoad", "load"),
        approach=si_or_none(approach, "Length", "approach"),
        datum=si_or_none(datum, "Length", "datum"),
        pressure_limit=si_or_none(pressure_limit, "Pressure", "pressure_limit"),
    )
    prescribed = optional(prescribed_pressure, "prescribed_pressure")
    found = _asperity.solve_contact(points, asked, prescribed, optional(start, "start"))
    return warned(Contact(*found))


def press_flanks(
    first: Profile,
    second: Profile,
    *,
    radius: Scalar,
    load: Scalar,
    modulus: Scalar,
    pressure_limit: Optional[Scalar] = None,
    run_in: Optional[int] = None,
    first_share: float = 0.5,
    tolerance: float = 1e-8,
) -> Contact:
    """Presses two profiles of one length and spacing together, point i of one facing point i of the other.

    Parameters:
        first, second: the profiles.
        radius: relative radius of curvature, m.
        load: load per metre of face width, N/m.
        modulus: reduced modulus E*, Pa.
        pressure_limit: pressure at which the softer flank flows, Pa.
        run_in: passes per cycle of a running-in before; ``running_in`` of the result lists the cycles.
        first_share: share of the plastic displacement that the first flank takes.
        tolerance: as of `solve_contact`.

    Returns:
        The `Contact`, with the cycles in ``running_in``.

    Raises:
        AsperityError: the profiles differ in length or spacing, or a value is out of its domain (E209), or the contact cannot
            be solved (E301, E302).

    Example:
        >>> case = asperity.demo()
        >>> first = asperity.read_profile("demo/ground_pinion.csv").prepare().crop(end="1 mm")
        >>> contact = asperity.press_flanks(first, first.mirrored(), radius="10 mm", load="200 N/mm", modulus="115 GPa")
        >>> 0 < contact.contact_fraction < 1
        True
    """
    for name, flank in (("first", first), ("second", second)):
        if not isinstance(flank, Profile):
            raise wrong_kind(name, flank, "a Profile")
    asked = _asked(
        "free",
        tolerance,
        5000,
        True,
        True,
        spacing=first.spacing,
        modulus=si(modulus, "Pressure", "modulus"),
        load=si(load, "LineLoad", "load"),
        pressure_limit=si_or_none(pressure_limit, "Pressure", "pressure_limit"),
    )
    plan = None if run_in is None else json_text({"passes": checked("run_in", run_in, int), "first_share": first_share})
    found = _asperity.press_flanks(first._raw, second._raw, si(radius, "Length", "radius"), asked, plan)
    return warned(Contact(*found))


def subsurface_stress(
    pressure: ArrayLike,
    spacing: Scalar,
    depths: Values,
    *,
    traction: Optional[ArrayLike] = None,
    poisson: float = 0.3,
) -> Stress:
    """Stress in a half-plane under a pressure and a traction (Johnson 1985, uniform strips).

    Parameters:
        pressure: shape (n,), Pa.
        spacing: distance of the points, m.
        depths: shape (m,), m; 0 is allowed.
        traction: shear on the surface, shape (n,), Pa.
        poisson: Poisson's ratio.

    Returns:
        The `Stress`.

    Raises:
        AsperityError: a value is out of its domain (E209).

    Example:
        >>> x = (np.arange(801) - 400) * 1e-6
        >>> pressure = 1e9 * np.sqrt(np.maximum(0, 1 - (x / 200e-6) ** 2))
        >>> stress = asperity.subsurface_stress(pressure, 1e-6, np.linspace(0, 400e-6, 41))
        >>> round(stress.von_mises_depth_m / 200e-6, 1)
        0.7
    """
    p = line(pressure, "Pressure", "pressure")
    q = None if traction is None else line(traction, "Pressure", "traction")
    below = si_array(depths, "Length", "depths").reshape(-1)
    text, arrays = _asperity.subsurface_stress(p, q, si(spacing, "Length", "spacing"), below, checked("poisson", poisson, float))
    shaped = {name: array if name == "depths" else array.reshape(len(below), len(p)) for name, array in arrays.items()}
    return Stress({**json.loads(text), **shaped})
