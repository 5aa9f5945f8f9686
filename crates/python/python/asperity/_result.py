"""Results of runs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from os import PathLike, fspath
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

from . import _asperity
from ._errors import AsperityError, Code, Row, checked_or_none, of_several, wrong_kind
from ._html import Chart, page, shown
from ._quantity import Floats, in_numbers
from ._record import Record, Table, Values, variable, with_ends
from ._values import PathRow, PathRowTable, ResultValues, SummaryValues, Uncertainty

if TYPE_CHECKING:
    import pandas
    import xarray


OF_OFFSETS = {name: kind for name, kind in SummaryValues.__annotations__.items() if kind.endswith(("float", "float]"))} | {"offset": "int"}
"""Types of the columns at the offsets."""


class Fields(Values):
    """Fields along the contact at one position, of its first offset: arrays of shape (n,), SI units.

    ``x``, ``height_pinion``, ``height_wheel``, ``displacement_*``, ``plastic_*``, ``gap`` (m), ``pressure_solid``,
    ``pressure_fluid``, ``shear`` (Pa); where stress was computed ``depths`` (m) and ``sigma_xx``, ``sigma_zz``,
    ``tau_xz``, ``von_mises``, ``plastic_stress`` (von Mises stress beyond the elastic limit) of shape (depths, n) in Pa.
    """

    height_pinion: Floats; height_wheel: Floats; displacement_pinion: Floats; displacement_wheel: Floats
    plastic_pinion: Floats; plastic_wheel: Floats; gap: Floats; pressure_solid: Floats; pressure_fluid: Floats; shear: Floats
    depths: Floats; sigma_xx: Floats; sigma_zz: Floats; tau_xz: Floats; von_mises: Floats; plastic_stress: Floats

    @property
    def x(self) -> Floats:
        """Positions across the contact, 0 at its middle, m."""
        x: Floats = self._values["x"]
        return x

    def to_pandas(self) -> pandas.DataFrame:
        """The fields along the surface as a `pandas.DataFrame`."""
        import pandas

        return pandas.DataFrame({name: value for name, value in self._values.items() if value.shape == self.x.shape})

    def to_xarray(self) -> xarray.Dataset:
        """All fields as an `xarray.Dataset` over x and depth."""
        import xarray

        arrays = {
            name: variable(("x",) if value.ndim == 1 else ("depth", "x"), name, value, _unit_of_field(name))
            for name, value in self._values.items()
            if name not in ("x", "depths")
        }
        coordinates = {"x": variable("x", "x", self.x, "m")}
        if "depths" in self._values:
            coordinates["depth"] = variable("depth", "depth", self._values["depths"], "m")
        return xarray.Dataset(arrays, coords=coordinates)

    def plot(self, ax: Any = None) -> Any:
        """Pressure of solids and film in MPa over x in µm, on axes of matplotlib or as a `Chart`."""
        series = [
            ("solids", (self._values["pressure_solid"] * 1e-6).tolist()),
            ("film", (self._values["pressure_fluid"] * 1e-6).tolist()),
        ]
        return shown(Chart("Pressure", (self.x * 1e6).tolist(), series, ("x in µm", "pressure in MPa")), ax)


def _unit_of_field(name: str) -> str:
    """Unit of a field along the contact: stresses in Pa, all else in m."""
    is_stress = name.startswith(("pressure", "sigma", "tau", "von_mises", "plastic_stress", "shear"))
    return "Pa" if is_stress else "m"


_DEPTHS = ("sigma_xx", "sigma_zz", "tau_xz", "von_mises", "plastic_stress")


class Summary(SummaryValues):
    """Efficiency and losses of a mesh, mean over the offsets; of a gear train its sums."""


class Path(PathRowTable):
    """One row per mesh position from A to E: columns as attributes and items, rows by their number."""


class RunResult(Values, ResultValues):
    """Result of a run, as ``result.json`` has it (docs/FILE_FORMATS.md): losses, path, warnings, equations.

    Units are in the names: ``summary.loss_w``, ``path.film_minimum_um``; also of quantities that the file has as text, as
    ``lubricant.temperature_c`` and ``gears.face_width_mm``. What the case states stays text: ``inputs``, ``defaults``. ``run("losses")`` has ``summary``, ``path``, ``offsets``,
    ``warnings`` and ``equations``; with contacts there are also ``formulation``, ``inputs``, ``defaults``, ``gears``, ``load``, ``flanks``,
    ``lubricant``, ``film_constants``, ``points``, ``running_in``, ``published_laws`` and ``references``, and where they were computed, else None,
    ``uncertainty``, ``bulk`` (temperatures of oil and flanks), ``gearbox``, ``micropitting``, ``run_in`` (the losses run in), ``records`` (of mixed lubrication),
    ``pairs`` (of several traces, or rows of a scan), and where patches of areal scans are in contact, with the interval of the loss, ``scans`` (patches beside their rows) or why not, ``no_scans``. Folders of the command have
    ``ridges`` or ``no_ridges``, which `ridges` computes here. A result of several meshes has ``shafts``, ``kinds`` and ``meshes``, each a result.
    """

    _absent = {name: None for name in (
        "uncertainty", "bulk", "gearbox", "micropitting", "run_in", "ridges", "no_ridges", "scans", "no_scans", "pairs", "case_file", "mesh",
    )} | {"records": []}

    _outcome: Optional[_asperity.Outcome]
    _json: str
    _offsets: list[dict[str, Any]]
    _meshes: list[RunResult]

    def __init__(self, values: Mapping[str, Any]) -> None:
        super().__init__(in_numbers(values))
        self._outcome = None
        self._json = ""
        self._offsets = []
        self._meshes = []

    @classmethod
    def _of(cls, outcome: _asperity.Outcome) -> RunResult:
        text, offsets = outcome.json()
        made = cls(json.loads(text))
        made._outcome, made._json, made._offsets = outcome, text, json.loads(offsets)
        return made

    def __getstate__(self) -> dict[str, Any]:
        # What the compiled part holds stays where it is: another process gets the result without the fields.
        return {**self.__dict__, "_meshes": self.meshes, "_outcome": None}

    @property
    def summary(self) -> Summary:
        """Efficiency and losses, mean over the offsets; of several meshes, their train."""
        return Summary(self._values.get("summary", self._values))

    @property
    def efficiency(self) -> float:
        """Efficiency of the mesh."""
        return float(self._summary()["efficiency"])

    @property
    def loss_w(self) -> float:
        """All losses, W: the median of the samples, without samples the loss of the run."""
        return float(self._summary()["loss_w"])

    @property
    def uncertainty(self) -> Optional[Uncertainty]:
        """Draws of the loss: ``loss`` with ``quantiles_w`` (5 and 95 %) and ``parts`` by component,
        ``structures``, ``other_models``; None where nothing was drawn, as by ``run("losses")`` or ``band=False``, and of a gear train, whose
        interval is ``summary.loss_distribution``."""
        found = self._values.get("uncertainty")
        return Uncertainty(found) if found else None

    def _summary(self) -> Mapping[str, Any]:
        summary: Mapping[str, Any] = self._values.get("summary", self._values)
        return summary

    @property
    def title(self) -> str:
        """Title of the case."""
        return str(self._values["title"])

    @property
    def path(self) -> Path:
        """One row per mesh position from A to E; of several meshes the rows of each, with its name in ``mesh``."""
        if not self._is_train:
            return Path(self._values.get("path", []))
        runs = zip(self._values["meshes"], self.meshes)
        return Path([{"mesh": row["mesh"], **position} for row, run in runs for position in run._values["path"]])

    @property
    def _is_train(self) -> bool:
        return "path" not in self._values and "meshes" in self._values

    def _of_pair(self, what: str) -> None:
        """Refuses what only a single mesh has."""
        if self._is_train:
            raise AsperityError(f"a result of several meshes has no {what}", Code.E402, f"Take the {what} of one of them: .meshes[0].")

    def _beyond_losses(self, what: str, detail: str) -> None:
        """Refuses what a run of losses alone does not have."""
        if "schema_version" not in self._values and not self._is_train:
            raise AsperityError(f"a result of losses alone has no {what}", Code.E402, f'Run the case with detail = "{detail}".')

    @property
    def warnings(self) -> Table:
        """Warnings: code and text; of several meshes those of each, with its name in ``mesh``."""
        if self._is_train:
            rows = [{"mesh": mesh._values["mesh"], **row} for mesh in self.meshes for row in mesh._values["warnings"]]
            return Table(rows, ["mesh", "code", "text"])
        return Table(self._values.get("warnings", []), ["code", "text"])

    def _doubts(self) -> list[Row]:
        """Its warnings, each once; of several meshes, each with the names of its meshes."""
        if not self._is_train:
            return list(self._values.get("warnings", []))
        return of_several(((f"{row.code} {row.text}", row.mesh) for row in self.warnings), len(self.meshes))

    @property
    def offsets(self) -> Table:
        """Efficiency and losses at each ``offset`` of the traces, columns as the names of `Summary`; empty for a result that was read back."""
        return Table(self._offsets, declared=OF_OFFSETS)

    @property
    def positions(self) -> list[int]:
        """Numbers of the positions whose fields are held, from 1 at A."""
        return [] if self._outcome is None or "schema_version" not in self._values else self._outcome.positions()

    def fields(self, position: Optional[int] = None) -> Fields:
        """Fields along the contact at a position, from 1 at A; by default where the pressure is highest.

        Only a run with ``detail="fields"`` has them; of another run, or one that was read back, they are refused (E402).
        """
        if self._outcome is None:
            raise AsperityError("a result that was pickled or read back holds no fields", Code.E402, "Run the case again, or take what the fields are needed for before it is pickled.")
        self._of_pair("fields")
        self._beyond_losses("fields", "fields")
        if not self._outcome.positions():
            raise AsperityError("this result holds no fields", Code.E402, 'Run the case with detail = "fields".')
        position = checked_or_none("position", position, int)
        if position is None:
            highest = self.path["p_max_mpa"]
            position = int(np.nanargmax(highest)) + 1 if np.isfinite(highest).any() else 1
        found = self._outcome.fields(position)
        count = len(found["x"])
        return Fields({name: array.reshape(-1, count) if name in _DEPTHS else array for name, array in found.items()})

    @property
    def meshes(self) -> list[RunResult]:
        """Results of the meshes of a gear train or planetary set."""
        if not self._meshes and self._outcome is not None:
            self._meshes = [RunResult._of(mesh) for mesh in self._outcome.meshes()]
        return list(self._meshes)

    def write(self, folder: Union[str, PathLike[str]], *, fields: bool = False) -> None:
        """Writes the result folder of ``asperity run`` with its page ``report.html``, whole or not at all.

        A run of losses alone, or one that was read back, has none (E402).
        """
        if self._outcome is None:
            raise AsperityError("a result that was read back is in its folder", Code.E402, "Run the case again.")
        self._beyond_losses("result folder", "contacts")
        self._outcome.write(fspath(folder), fields)

    def diff(self, other: RunResult) -> Record:
        """Differences from this result to another: ``inputs``, ``summary``, ``path``, ``warnings``, ``equations``.

        Both are whole results, of ``run("contacts")``, ``run()`` or `read_result`; one of losses alone, or of several meshes,
        is refused (E402).
        """
        if not isinstance(other, RunResult):
            raise wrong_kind("other", other, "a RunResult")
        for one in (self, other):
            one._of_pair("differences")
            one._beyond_losses("inputs and equations to compare", "contacts")
        return Record(json.loads(_asperity.diff(self._json, other._json)))

    def to_json(self) -> str:
        """The text of ``result.json`` without its line breaks."""
        return self._json

    def to_pandas(self) -> pandas.DataFrame:
        """The positions of the path as a `pandas.DataFrame`, the summary in its ``attrs``."""
        frame = self.path.to_pandas()
        frame.attrs = {"title": self.title, **Record(self._summary()).to_dict()}
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """The numbers along the path as an `xarray.Dataset` over ``path_fraction``, the summary in its ``attrs``."""
        import xarray

        self._of_pair("arrays along the path")
        path = self.path
        columns = {name: path._at(name) for name in path.columns}
        at = columns.pop("path_fraction", np.arange(len(path)))
        numbers = {name: variable("path_fraction", name, value) for name, value in columns.items() if value.dtype != object}
        plain = {name: value for name, value in self._summary().items() if isinstance(value, (int, float, str))}
        return xarray.Dataset(numbers, coords={"path_fraction": variable("path_fraction", "path_fraction", at)}, attrs={"title": self.title, **plain})

    def plot(self, ax: Any = None) -> Any:
        """Loss along the path in W per metre of contact line, on axes of matplotlib or as a `Chart`."""
        self._of_pair("chart along the path")
        path = self.path
        parts = [
            ("film", "film_w_per_m"),
            ("lubricated asperities", "lubricated_asperity_w_per_m"),
            ("boundary layer", "boundary_w_per_m"),
            ("rolling", "rolling_w_per_m"),
        ]
        series = [(name, path._at(key).tolist()) for name, key in parts if key in path.columns]
        at = path["path_fraction"].tolist()
        return shown(Chart("Loss along the path", at, series, ("A to E", "W/m")), ax)

    def __str__(self) -> str:
        if "summary" in self._values and "inputs" in self._values:
            return _asperity.summary(self._json)
        return repr(self)

    def __repr__(self) -> str:
        quantiles = self._quantiles()
        loss = f"{self.loss_w:.6g} W (one run, no interval drawn)" if quantiles is None else with_ends(self.loss_w, quantiles)
        return f"<RunResult {self.title!r}: loss {loss}, efficiency {100 * self.efficiency:.4f} %>"

    def _quantiles(self) -> Any:
        """5 and 95 % quantiles of the loss of a pair of gears or of a gear train, if they were drawn."""
        found = (self._values.get("uncertainty") or {}).get("loss") or self._summary().get("loss_distribution")
        return found and found["quantiles_w"]

    def _repr_html_(self) -> str:
        of = self._summary()
        names = (
            ("sliding_w", "sliding", "W"),
            ("film_w", "in the film", "W"),
            ("lubricated_asperity_w", "in lubricated asperities", "W"),
            ("boundary_w", "in the boundary layer", "W"),
            ("rolling_w", "rolling", "W"),
            ("mu_equivalent", "equivalent friction coefficient", ""),
            ("mixed_share", "share of the path in mixed or boundary lubrication", ""),
        )
        quantiles = self._quantiles()
        rows = [
            ("efficiency", f"{100 * self.efficiency:.4f} %"),
            ("loss" if quantiles is None else "loss, in brackets 5 to 95 %", with_ends(self.loss_w, quantiles)),
        ]
        rows += [(name, f"{of[key]:.4g} {unit}".strip()) for key, name, unit in names if key in of]
        rows += [("regime", str(of["regime"]))] if "regime" in of else []
        rows += [(str(warning.code), str(warning.text)) for warning in self.warnings]
        chart = None if self._is_train or "path_fraction" not in self.path.columns else str(self.plot())
        return page(self.title, rows, chart)


class Regime(Table):
    """Film and regime along the path of contact: columns ``path_fraction``, ``line_load_n_per_mm``, ``hertz_pressure_mpa``,
    ``sliding_m_per_s``, ``entrainment_m_per_s``, ``film_central_um``, ``film_minimum_um``, ``thermal_reduction``, ``lambda_star``,
    ``film_ratio``, ``film_share``, ``mixed_share``, as of `Path`."""

    def __init__(self, meshes: list[dict[str, Any]]) -> None:
        super().__init__(meshes[0]["rows"], declared=PathRow.__annotations__)
        self._meshes = meshes

    @property
    def title(self) -> str:
        """Title of the case, or of the mesh."""
        return str(self._meshes[0]["title"])

    @property
    def meshes(self) -> list[Regime]:
        """The regime of each mesh of a gear train or planetary set."""
        return [Regime([mesh]) for mesh in self._meshes]

    def plot(self, ax: Any = None) -> Any:
        """Λ* along the path, on axes of matplotlib or as a `Chart`."""
        at = self["path_fraction"].tolist()
        return shown(Chart("Film parameter Λ*", at, [("Λ*", self["lambda_star"].tolist())], ("A to E", "Λ*")), ax)

    def to_xarray(self, dimension: str = "path_fraction") -> xarray.Dataset:
        """The columns over ``path_fraction``."""
        import xarray

        columns = {name: variable(dimension, name, self[name]) for name in self.columns if name != "path_fraction"}
        return xarray.Dataset(columns, coords={dimension: variable(dimension, "path_fraction", self["path_fraction"])})

    def _repr_html_(self) -> str:
        mixed = self["mixed_share"]
        rows = [("mixed", f"{100 * float(mixed.mean()):.4g} % of the positions")]
        return page(f"Regime, {self.title}", rows, str(self.plot()))
