"""Measured and synthetic profiles."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from numbers import Real
from os import PathLike, fspath
from typing import IO, TYPE_CHECKING, Any, NamedTuple, Optional, Union, cast

import numpy as np
from numpy.typing import ArrayLike

from . import _asperity
from ._choices import (
    Abscissa,
    Amplitudes,
    DecimalSign,
    Encoding,
    Ends,
    Form,
    Gaps,
    LengthUnit,
    LikeMethod,
    Separator,
    Standard,
    SurfaceKind,
    TraceLine,
    Uneven,
)
from ._errors import AsperityError, Code, brief, checked, checked_or_none, json_text, warn, wrong_kind
from ._files import on_disk
from ._fixed import Fixed, UnknownName, unknown
from ._html import Chart, page, shown
from ._quantity import Floats, Scalar, in_numbers, line, si, si_or_none
from ._record import Record, Table, described
from ._values import ParameterName, ParameterValues

if TYPE_CHECKING:
    import pandas
    import xarray


_USUAL_END: Ends = "cut"


_FIRST = ("ra_um", "rq_um", "rz_um", "rp_um", "rv_um", "rt_um", "rsk", "rku", "rk_um", "rpk_um", "rvk_um")


class Parameters(Fixed, dict[ParameterName, float], ParameterValues):
    """Roughness parameters by name, lengths in µm as the name tells (``ra_um``, ``rpk_um``); also as attributes.

    A parameter that the profile does not have is NaN. ``standard`` and ``warnings`` are attributes alone.
    """

    def __init__(self, values: Mapping[str, Optional[float]], standard: str, warnings: Table) -> None:
        numbers = {name: math.nan if value is None else value for name, value in values.items()}
        super().__init__(cast("dict[ParameterName, float]", numbers))
        self._standard = standard
        self._warnings = warnings

    def __reduce__(self) -> tuple[Any, ...]:
        return Parameters, (dict(self), self._standard, self._warnings)

    @property
    def standard(self) -> str:
        """The standard that they follow."""
        return self._standard

    @property
    def warnings(self) -> Table:
        """Warnings: code, text and help."""
        return self._warnings

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> float:
            try:
                return self[name]
            except KeyError as error:
                raise AttributeError(str(error)) from None

        def __missing__(self, name: object) -> float:
            raise UnknownName(unknown("Parameters", name, self))

    def to_dict(self) -> dict[str, float]:
        """The parameters in Python's own types."""
        return {str(name): value for name, value in self.items()}

    def to_pandas(self) -> pandas.Series[float]:
        """The parameters as a `pandas.Series`."""
        import pandas

        return pandas.Series(self.to_dict(), name=self.standard, dtype=float)

    def _repr_html_(self) -> str:
        rows = [(name, "-" if math.isnan(value) else f"{value:.6g}") for name, value in self.items()]
        return page(f"Parameters ({self.standard})", rows, None)


class Parts(NamedTuple):
    """A profile parted by its filters."""

    primary: Profile
    """Without form and short waves, over the whole trace."""
    waviness: Optional[Profile]
    """Mean line of the filter at the cut-off; none without it."""
    roughness: Profile
    """Primary profile minus waviness."""


_STEEPEST = 10.0
"""Root mean square slope from point to point, an angle of 84 degrees, that no profile has."""


def _refuse_implausible(heights: Floats, spacing: float) -> None:
    """Refuses heights or a spacing in another unit than m."""
    # Heights in µm or mm, where they are taken for m, are a million or a thousand times as steep.
    slope = math.sqrt(float(np.mean(np.diff(heights) ** 2))) / spacing
    if slope > _STEEPEST:
        text = f"heights: over a range of {np.ptp(heights):.3g} m they rise by {slope:.3g} times the spacing from point to point"
        help = "Heights and spacing are in metres: multiply heights in µm by 1e-6, or give a quantity of pint."
        raise AsperityError(text, Code.E209, help)


_HELP = {
    Code.E106: "Give at least 100 points.",
    Code.E209: "Correct the value named; lengths are in metres: numbers as 0.4e-6, or text with a unit as \"0.4 um\".",
    Code.E116: "Heights and spacing are in metres: give numbers as 0.5e-6, text with a unit as \"0.5 um\", or a quantity of pint.",
}
"""What can be done about points in memory, which have no file."""


def _in_memory(make: Callable[..., _asperity.Trace], *points: Any) -> _asperity.Trace:
    """A trace of points in memory, whose errors name no file."""
    try:
        return make(*points)
    except AsperityError as error:
        text = error.message.split(" (named by ")[0]
        raise AsperityError(text, error.code, _HELP.get(error.code, error.help)) from None


class Profile(Fixed):
    """Heights of a surface along a line, evenly spaced.

    ``len(profile)`` is the number of its points, ``profile[100:500]`` the profile of some of them, and ``numpy.asarray(profile)``
    the array of its heights.

    Parameters:
        heights: heights, shape (n,), m, out of the material; at least 100. Heights steeper than 84 degrees in the mean, as of
            a profile in µm, are refused (E209).
        spacing: distance of the points, m.
        name: name for charts and messages.
    """

    def __init__(self, heights: ArrayLike, spacing: Scalar, *, name: Optional[str] = None) -> None:
        values, distance = line(heights, "Length", "heights"), si(spacing, "Length", "spacing")
        made = _in_memory(_asperity.Trace.of, values, distance)
        _refuse_implausible(values, distance)
        self._set(made, name)

    def _set(self, raw: _asperity.Trace, name: Optional[str]) -> None:
        self._raw = raw
        self._name = name
        self._about: dict[str, Any] = json.loads(raw.about)

    @classmethod
    def _of(cls, raw: _asperity.Trace, name: Optional[str]) -> Profile:
        made = cls.__new__(cls)
        made._set(raw, name)
        return made

    @property
    def name(self) -> Optional[str]:
        """Name for charts and messages."""
        return self._name

    @property
    def heights(self) -> Floats:
        """Heights, shape (n,), m, out of the material; a copy."""
        return self._raw.heights

    @property
    def spacing(self) -> float:
        """Distance of the points, m."""
        return self._raw.spacing

    @property
    def x(self) -> Floats:
        """Positions from the first point, shape (n,), m."""
        x: Floats = np.arange(len(self), dtype=np.float64)
        x *= self.spacing
        return x

    def __len__(self) -> int:
        return len(self._raw.heights)

    def __getitem__(self, points: slice) -> Profile:
        if not isinstance(points, slice) or points.step not in (None, 1):
            text = f"points: a slice of points one after another is expected, not {brief(points)}"
            raise AsperityError(text, Code.E204, "profile[100:500] is a profile of these points; profile.heights is the array of the heights.")
        first, end, _ = points.indices(len(self))
        return Profile._of(_in_memory(self._raw.cut, first, max(first, end)), self.name)

    def crop(self, start: Scalar = 0.0, end: Optional[Scalar] = None) -> Profile:
        """The part of the profile between two distances from its first point, as a slice of its points is.

        Parameters:
            start: beginning, m.
            end: end, m; default the last point.

        Returns:
            The part as a `Profile`.

        Raises:
            AsperityError: distances beyond the profile (E209), or too few points between them (E106).

        Example:
            >>> flank = asperity.read_profile("ground_pinion.csv").crop("0.5 mm", "2 mm")
            >>> len(flank)
            3001
        """
        places = [round(si(place, "Length", name) / self.spacing) for name, place in (("start", start), ("end", end)) if place is not None]
        if places[0] < 0 or places[-1] >= len(self) or places[0] > places[-1]:
            length = f"{(len(self) - 1) * self.spacing * 1e3:.6g} mm"
            text = f"{start!r} to {'the end' if end is None else repr(end)}: the profile is {length} long"
            raise AsperityError(text, Code.E209, "Give two distances within the profile, the lower first.")
        return self[places[0] : places[1] + 1 if end is not None else None]

    def psd(self) -> Table:
        """One-sided power spectral density: ``frequency_per_m``, ``density_m3``.

        The density at frequency 0, and the last of an even number of points, has no second side and is not doubled. The Hann window is
        symmetric, ``numpy.hanning``. The sum of the densities times the step of the frequency is a mean square of the heights about their mean, whose weights
        are the squares of a Hann window (``asperity equations PSD-1``): near the square of ``rq_um``, but not equal to it. The
        spectrum has the form and the waviness of the profile, which `prepare` removes.
        """
        return Table._of_columns(self._raw.psd())

    def autocorrelation(self) -> Table:
        """Autocorrelation of the heights about their mean by shifts: ``shift_m``, ``autocorrelation``, 1 at no shift.

        A shift averages the products of the overlap, and is noisy where that is short (``asperity equations ACF-1``).
        """
        return Table._of_columns(self._raw.autocorrelation())

    def material_ratio(self) -> Table:
        """The material ratio curve: ``material_ratio_percent``, ``height_m`` from the highest point (``asperity equations Rk-2``)."""
        return Table._of_columns(self._raw.material_ratio())

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Profile):
            return NotImplemented
        return self.spacing == other.spacing and bool(np.array_equal(self.heights, other.heights))

    def __hash__(self) -> int:
        return hash((self.spacing, self.heights.tobytes()))

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> Any:
        return np.asarray(self.heights, dtype=dtype)

    @property
    def unit(self) -> Optional[str]:
        """Unit of the heights in the file; they are in m here."""
        unit: Optional[str] = self._about.get("z_unit")
        return unit

    @property
    def about(self) -> Record:
        """All that reading, generating or preparing found: format, metadata, recipe, what was achieved."""
        return Record(in_numbers(self._about))

    @property
    def warnings(self) -> Table:
        """Warnings: code, text and help."""
        return Table(self._about["warnings"], ["code", "text", "help"])

    def prepare(
        self,
        *,
        form: Form = "level",
        cutoff: Optional[Scalar] = None,
        noise_cutoff: Optional[Scalar] = None,
        ends: Ends = _USUAL_END,
        robust: bool = False,
        base_radius: Optional[Scalar] = None,
        roll_length: Optional[Scalar] = None,
        towards_root: bool = False,
    ) -> Profile:
        """The roughness profile: form removed, filtered (ISO 21920-2, ISO 16610-21).

        Parameters:
            form: ``"level"`` (default), ``"none"``, ``"mean"``, ``"poly2"``, ``"circle"`` or ``"involute"``.
            cutoff: cut-off λc, m; default what the file states, else 0.25 mm; 0 turns the filter off.
            noise_cutoff: cut-off λs, m; default what the file states, else 2.5 µm; 0 turns the filter off.
            ends: ``"cut"`` (default: half a cut-off is dropped at each end), ``"reg0"``, ``"reg1"`` or ``"reflect"``.
            robust: the robust Gaussian regression filter (ISO 16610-31).
            base_radius, roll_length, towards_root: place on the flank of ``form="involute"``, m.

        Returns:
            The roughness as a `Profile`, with what was done in ``about.preparation``.

        Raises:
            AsperityError: a trace that is too short for the filter (E120), or settings that do not go together (E205).

        Example:
            >>> rough = asperity.read_profile("ground_pinion.csv").prepare(cutoff="0.25 mm", robust=True)
            >>> rough.about.preparation.filter
            'robust-gaussian'
        """
        parts = self.filter(
            form=form,
            cutoff=cutoff,
            noise_cutoff=noise_cutoff,
            ends=ends,
            robust=robust,
            base_radius=base_radius,
            roll_length=roll_length,
            towards_root=towards_root,
        )
        return parts.roughness

    def filter(
        self,
        *,
        form: Form = "level",
        cutoff: Optional[Scalar] = None,
        noise_cutoff: Optional[Scalar] = None,
        ends: Ends = _USUAL_END,
        robust: bool = False,
        base_radius: Optional[Scalar] = None,
        roll_length: Optional[Scalar] = None,
        towards_root: bool = False,
    ) -> Parts:
        """Primary, waviness and roughness profile; arguments as of `prepare`."""
        plan = {
            "form": form,
            "cutoff": si_or_none(cutoff, "Length", "cutoff"),
            "noise_cutoff": si_or_none(noise_cutoff, "Length", "noise_cutoff"),
            "ends": ends,
            "robust": robust,
            "base_radius": si_or_none(base_radius, "Length", "base_radius"),
            "roll_length": si_or_none(roll_length, "Length", "roll_length"),
            "towards_root": towards_root,
        }
        primary, waviness, roughness = self._raw.prepare(json_text(plan))
        return Parts(
            Profile._of(primary, self.name),
            None if waviness is None else Profile._of(waviness, self.name),
            Profile._of(roughness, self.name)._warned(),
        )

    def _warned(self) -> Profile:
        warn(self._about["warnings"])
        return self

    def mean_line(self, cutoff: Scalar, *, robust: bool = False, ends: Ends = "reg1") -> Profile:
        """Mean line of the Gaussian filter, or of the robust one; cut-off in m."""
        return Profile._of(self._raw.mean_line(si(cutoff, "Length", "cutoff"), robust, ends), self.name)

    def parameters(
        self,
        *,
        standard: Standard = "iso4287",
        sections: Optional[int] = None,
        cutoff: Optional[Scalar] = None,
        prepare: Optional[bool] = None,
    ) -> Parameters:
        """Roughness parameters, lengths in µm, as ``asperity profile info`` gives them.

        Parameters:
            standard: ``"iso4287"`` (means over sections) or ``"iso21920"``.
            sections: number of sections; default as many cut-offs as fit.
            cutoff: length of a section, m; default the cut-off of the filter.
            prepare: whether form and waviness are removed first by the defaults of `prepare`; by default so
                unless the profile was prepared.

        Returns:
            The `Parameters`.

        Raises:
            AsperityError: a trace that is too short for the filter or the sections (E120).

        Example:
            >>> found = asperity.read_profile("ground_pinion.csv").parameters()
            >>> found["ra_um"] == found.ra_um < found.rz_um
            True
        """
        is_prepared = "preparation" in self._about
        trace = self
        prepare = checked_or_none("prepare", prepare, bool)
        if prepare or (prepare is None and not is_prepared):
            trace = self.prepare() if cutoff is None else self.prepare(cutoff=cutoff)
        found = json.loads(trace._raw.parameters(standard, checked_or_none("sections", sections, int), si_or_none(cutoff, "Length", "cutoff")))
        every = {**found["heights"], **found["material_ratio"], **found["spectral"], "section_um": found["section_um"]}
        values = {name: every[name] for name in (*_FIRST, *(name for name in every if name not in _FIRST))}
        rows = [*trace._about["warnings"], *found["warnings"]]
        return Parameters(values, standard, Table(rows, ["code", "text", "help"]))

    def mirrored(self) -> Profile:
        """The same profile run from its other end."""
        return Profile._of(self._raw.mirrored(), self.name)

    def write(self, path: Union[str, PathLike[str]]) -> None:
        """Writes the profile as ``.csv`` (or ``.txt``, the same text), ``.x3p`` or ``.smd``; reading it back gives the same to the last bit. In ``.csv`` some heights
        differ in their last bit. Only ``.csv`` states that a profile was filtered, of which reading it warns (W118)."""
        self._raw.write(fspath(path))

    def plot(self, ax: Any = None) -> Any:
        """A chart of the heights in µm over mm: on axes of matplotlib, else an SVG `Chart`."""
        x, heights = self.x * 1e3, self.heights * 1e6
        labels = ("x in mm", "height in µm")
        return shown(Chart(self.name or "Profile", x.tolist(), [("height", heights.tolist())], labels), ax)

    def to_dict(self) -> dict[str, Any]:
        """Name, spacing, heights and what is known of them, in Python's own types."""
        about = in_numbers({key: value for key, value in self._about.items() if key != "spacing"})
        return {"name": self.name, "spacing": self.spacing, "heights": self.heights.tolist(), **about}

    def to_pandas(self) -> pandas.Series[float]:
        """Heights in m over x in m as a `pandas.Series`."""
        import pandas

        return pandas.Series(self.heights, index=pandas.Index(self.x, name="x_m"), name=self.name or "height_m")

    def to_xarray(self) -> xarray.DataArray:
        """Heights in m over x in m as an `xarray.DataArray`."""
        import xarray

        units = described("height", "m")
        x = xarray.Variable("x", self.x, described("x", "m"))
        return xarray.DataArray(self.heights, coords={"x": x}, dims="x", name=self.name or "height", attrs=units)

    def __repr__(self) -> str:
        length = (len(self) - 1) * self.spacing
        return f"<Profile{f' {self.name}' if self.name else ''}: {len(self)} points, {self.spacing * 1e6:.6g} µm apart, {length * 1e3:.6g} mm>"

    def _repr_html_(self) -> str:
        rows = [("points", str(len(self))), ("spacing", f"{self.spacing * 1e6:.6g} µm")]
        rows += [(warning.code, warning.text) for warning in self.warnings]
        return page(self.name or "Profile", rows, str(self.plot()))


def read_profile(
    path: Union[str, PathLike[str], IO[bytes]],
    *,
    x_unit: Optional[LengthUnit] = None,
    z_unit: Optional[LengthUnit] = None,
    dx: Optional[Scalar] = None,
    dy: Optional[Scalar] = None,
    columns: Union[None, int, tuple[int, int]] = None,
    decimal: Optional[DecimalSign] = None,
    separator: Optional[Separator] = None,
    encoding: Optional[Encoding] = None,
    gaps: Optional[Gaps] = None,
    row: Optional[int] = None,
    line: Optional[TraceLine] = None,
    abscissa: Optional[Abscissa] = None,
    base_radius: Optional[Scalar] = None,
    uneven: Optional[Uneven] = None,
    range: Optional[str] = None,
    invert: Optional[bool] = None,
) -> Profile:
    """Reads a profilometer file: text, CSV, X3P, SDF, SMD, PRF, Excel and others (docs/FILE_FORMATS.md).

    Parameters:
        path: the file, or an object with ``read`` that has its bytes, whose ``name`` helps to recognise the format.
        x_unit, z_unit: ``"mm"``, ``"um"``, ``"nm"`` ..., where the file does not tell.
        dx, dy: spacing of the points, and of the rows of a surface, m.
        columns: numbers of the columns from 1: ``(x, z)``, or that of the heights alone.
        decimal, separator, encoding: dialect of a text, where it is misread.
        gaps: ``"interpolate"`` fills missing points, which are refused by default.
        row: number of the profile, from 1, in a file that holds several.
        line: ``"row"``, ``"column"``, ``"mean"`` or ``"mean-column"`` of a surface.
        abscissa, base_radius: for positions that are roll lengths or angles.
        uneven: ``"resample"`` for uneven positions.
        range: part of the trace that is read, by distances from its first point: ``"1.2 mm .. 6.4 mm"``.
        invert: whether the values grow into the material (depths, a replica) and are turned into heights; by default only
            those that the file names depths.

    Returns:
        The `Profile`, with what was found and assumed in ``about``.

    Raises:
        AsperityError: the file cannot be read (E103), its format or units are not known (E102, E104, E110, E114), or its values are
            not a profile (E105, E106, E107), among others.

    Example:
        >>> case = asperity.demo()
        >>> flank = asperity.read_profile("demo/ground_pinion.csv")
        >>> flank.unit, 0.1 < flank.parameters().ra_um < 1
        ('um', True)
    """
    given = columns if isinstance(columns, (tuple, list)) else [] if columns is None else [columns]
    if len(given) > 2:
        raise wrong_kind("columns", columns, "the number of a column, or two of them")
    chosen = dict(zip(("z", "x"), [checked("columns", one, int) for one in reversed(given)])) or None
    options = {
        "x-unit": x_unit,
        "z-unit": z_unit,
        "dx": _length(dx),
        "dy": _length(dy),
        "columns": chosen,
        "decimal": decimal,
        "separator": separator,
        "encoding": encoding,
        "gaps": gaps,
        "row": row,
        "line": line,
        "abscissa": abscissa,
        "base-radius": _length(base_radius),
        "uneven": uneven,
        "range": range,
        "invert": invert,
    }
    keys = {key: value for key, value in options.items() if value is not None}
    with on_disk(path) as file:
        raw = _asperity.read_profile(file, json_text(keys))
        return Profile._of(raw, file.replace("\\", "/").rsplit("/", 1)[-1])._warned()


_RECIPE_LENGTHS = ("spacing", "rq", "roll_off", "short_cut", "grit_spacing", "grit_radius", "grit_protrusion", "depth", "width", "diameter")


def _length(value: Optional[Scalar]) -> Optional[str]:
    """A length as a file of settings has it."""
    return value if value is None or isinstance(value, str) else f"{si(value, 'Length')!r} m"


def _with_units(recipe: Mapping[str, Any]) -> dict[str, Any]:
    units: dict[str, Any] = {}
    for key, value in recipe.items():
        if isinstance(value, Mapping):
            units[key] = _with_units(value)
        else:
            units[key] = _length(value) if key in _RECIPE_LENGTHS else value
    return {key.replace("_", "-"): value for key, value in units.items()}


def generate(
    surface: SurfaceKind = "self-affine",
    *,
    amplitudes: Amplitudes = "fixed",
    pits: Optional[Mapping[str, Any]] = None,
    pores: Optional[Mapping[str, Any]] = None,
    scratches: Optional[Mapping[str, Any]] = None,
    mirrored: bool = False,
    name: Optional[str] = None,
    **recipe: Any,
) -> Profile:
    """A synthetic profile; the same recipe and seed give the same heights.

    Self-affine spectra after Jacobs, Junge and Pastewka (2017).

    Parameters:
        surface: ``"self-affine"`` (points, at least 100, spacing, rq, hurst, roll_off, short_cut, seed), ``"non-gaussian"``
            (``spectrum``, the keys of a self-affine surface, and ``heights``: ``"gaussian"``, ``"uniform"``,
            ``{"weibull-peaks": {"shape": 2}}`` or ``{"weibull-dales": {"shape": 2}}``), ``"plateau-honed"`` (``coarse`` and ``fine``, the keys
            of self-affine surfaces, and depth) or ``"ground"`` (points, spacing, rq, grit_spacing, grit_radius, grit_protrusion, seed);
            lengths in m. ``"fitted"`` takes the recipe of a profile of `generate_like`.
        amplitudes: ``"fixed"`` or ``"random"``, of self-affine surfaces.
        pits, scratches: count, width, depth, seed of damage added.
        pores: porosity, diameter, depth_ratio, seed of open pores of a sintered steel added.
        mirrored: whether the result is reversed.
        name: name for charts and messages.

    Returns:
        The `Profile`, with its recipe and what was achieved in ``about``.

    Raises:
        AsperityError: a key that the surface does not have or that is missing (E204), a value out of its domain (E209), or fewer
            than 100 points (E106).

    Example:
        >>> flank = asperity.generate(points=4000, spacing=0.5e-6, rq="0.4 um", hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1)
        >>> round(flank.about.achieved.rq_um, 3)
        0.4
    """
    whole = {
        "surface": {surface: _with_units(recipe)},
        "amplitudes": amplitudes,
        "pits": None if pits is None else _with_units(pits),
        "pores": None if pores is None else _with_units(pores),
        "scratches": None if scratches is None else _with_units(scratches),
        "mirrored": mirrored,
    }
    return Profile._of(_in_memory(_asperity.generate, json_text(whole)), name or f"{surface}, synthetic")


Trace = Union[Profile, str, PathLike[str]]
"""A profile, or the path of one."""

Traces = Union[Trace, Sequence[Trace]]
"""A profile, the path of one, or a list of them."""


def listed_profiles(name: str, traces: Traces) -> list[tuple[Trace, Profile]]:
    """What an argument lists, each with its profile, which is read where a file is named."""
    found: list[tuple[Trace, Profile]] = []
    listed: Sequence[Trace] = traces if isinstance(traces, (list, tuple)) else [cast("Trace", traces)]
    for trace in listed:
        profile = read_profile(trace) if isinstance(trace, (str, PathLike)) else trace
        if not isinstance(profile, Profile):
            raise wrong_kind(name, trace, "a profile, the path of one, or a list of them")
        found.append((trace, profile))
    return found


def generate_like(
    traces: Traces,
    *,
    after: Union[None, Traces, Mapping[float, Traces]] = None,
    state: Optional[float] = None,
    engagements: Optional[float] = None,
    method: Optional[LikeMethod] = None,
    seed: int = 1,
    name: Optional[str] = None,
) -> Profile:
    """A profile like measured ones of one finish, or like them in a state of a test; it has as many points as the first of them.

    It is made of pieces of the traces where heights, slopes or curvatures are not Gaussian, elsewhere of their spectrum and heights.

    Parameters:
        traces: profiles of one finish and spacing, or their paths.
        after: traces of the same places after a test, in the same order; of several stages ``{engagements: traces}``.
        state: part of the way from before the test, 0, to after it, 1, the default.
        engagements: engagements of a tooth of the flank wanted, instead of ``state``; default those of the last stage.
        method: ``"pieces"`` or ``"spectrum"``, for traces without ``after``.
        seed: equal seeds give equal heights.
        name: name for charts and messages.

    Returns:
        The `Profile`; ``about`` has its ``method``, its ``pieces`` (number of the trace, first point, points) or its recipe, and what
        was achieved.

    Raises:
        AsperityError: traces that are too short or of different spacing (E120), a state out of its domain (E209), or a trace that is not
            of the place of the one before it (E143), or arguments that exclude each other (E205).

    Example:
        >>> flank = asperity.generate(points=8000, spacing=0.5e-6, rq="0.4 um", hurst=0.8, roll_off=50e-6, short_cut=2e-6, seed=1)
        >>> worn = asperity.Profile(np.minimum(flank.heights, 0.2e-6), flank.spacing, name="worn")
        >>> between = asperity.generate_like(flank, after={1e4: worn}, engagements=5e3)
        >>> between.about.method
        'pieces'
    """
    stages: Mapping[float, Traces] = after if isinstance(after, Mapping) else {}
    is_by_stage = isinstance(after, Mapping)
    is_of_place = state is not None or engagements is not None
    for excluded, text, help in (
        (after is None and is_of_place, "state and engagements are of a test", "Give after, the traces after it."),
        (after is not None and method is not None, "flanks in a state of a test are made of pieces", "Leave method out."),
        (is_by_stage and state is not None, "after has engagements", "Give engagements instead of state."),
        (not is_by_stage and engagements is not None, "after has no engagements", "Give after as {engagements: traces}."),
    ):
        if excluded:
            raise AsperityError(f"generate_like: {text}", Code.E205, help)
    if not all(isinstance(stage, Real) for stage in stages):
        raise wrong_kind("after", after, "traces by engagements that are numbers")
    rising = sorted(stages)
    of_stages: list[Traces] = [stages[stage] for stage in rising] if stages else [] if after is None else [cast("Traces", after)]
    worn = [profile._raw for traces_of in of_stages for _, profile in listed_profiles("after", traces_of)]
    wanted = {"method": method, "state": state, "engagements": engagements, "stages": rising, "seed": seed}
    before = [profile._raw for _, profile in listed_profiles("traces", traces)]
    if not before:
        raise AsperityError("traces: no profile is named", Code.E205, "Give at least one.")
    raw = _in_memory(_asperity.generate_like, before, worn, json_text(wanted))
    return Profile._of(raw, name or f"like {len(before)} measured")._warned()
