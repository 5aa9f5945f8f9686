"""Losses over torque, speed and temperature."""

from __future__ import annotations

import json
from collections.abc import Mapping
from os import PathLike, fspath
from pathlib import Path
from typing import TYPE_CHECKING, Any, Optional, Union, cast

import numpy as np

from . import _asperity
from ._choices import ExportFormat
from ._errors import AsperityError, Code, warn, wrong_kind
from ._html import Chart, page, shown
from ._quantity import Floats, Numbers, Quantities, Quantity, operating, together
from ._record import held, variable, with_ends
from ._study import RawStudy, Study, Unpickled, files_of
from ._values import CycleFinishTable, CycleValues, MapArrays, MapRowTable, MapValues, MapWarningTable

if TYPE_CHECKING:
    import pandas
    import xarray

_DIMENSIONS = ("finish", "temperature_c", "torque_nm", "speed_rpm")


class Map(Study, MapArrays, MapValues):
    """A map of losses: arrays over finish, temperature, torque and speed.

    ``loss_w``, ``loss_torque_nm``, ``efficiency`` and the other numbers have the shape (finishes, temperatures,
    torques, speeds), NaN where a point has no such number; ``regime`` names the lubrication regime; ``extended`` marks
    points below the smallest torque whose contacts the traces resolve. ``scope`` is ``"mesh"``: no bearings, seals, churning.
    """

    def __init__(self, raw: RawStudy) -> None:
        super().__init__(raw)
        self._map = _asperity.Map.of(cast("_asperity.Study", raw))
        shape = (len(self.temperature_c), len(self.torque_nm), len(self.speed_rpm))
        points = [self._map.points(number) for number in range(len(self.finishes))]
        self._points: dict[str, Any] = {
            name: held(np.stack([np.asarray(of[name]).reshape(shape) for of in points])) for name in points[0]
        }

    if not TYPE_CHECKING:

        def __getattr__(self, name: str) -> Any:
            points = self.__dict__.get("_points", {})
            return points[name] if name in points else super().__getattr__(name)

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self._points})

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (files_of(self._raw),)

    def _axis(self, name: str) -> Floats:
        return np.array(self._values["axes"][name], dtype=np.float64)

    @property
    def torque_nm(self) -> Floats:
        """Torques at the pinion, N m."""
        return self._axis("torque_nm")

    @property
    def speed_rpm(self) -> Floats:
        """Speeds of the pinion, 1/min."""
        return self._axis("speed_rpm")

    @property
    def temperature_c(self) -> Floats:
        """Temperatures of the flanks, °C."""
        return self._axis("temperature_c")

    @property
    def finishes(self) -> list[str]:
        """Names of the finishes."""
        return [str(finish["name"]) for finish in self._values["finishes"]]

    @property
    def rows(self) -> MapRowTable:
        """All points in one table, a row for each: finish, temperature, torque, speed, then its numbers.

        pandas, polars and pyarrow take it as it is: ``pyarrow.parquet.write_table(pyarrow.table(losses.rows), "map.parquet")``.
        """
        axes = [np.array(self.finishes), self.temperature_c, self.torque_nm, self.speed_rpm]
        places = [place.ravel() for place in np.meshgrid(*axes, indexing="ij")]
        points = {name: array.ravel() for name, array in self._points.items()}
        return MapRowTable._of_columns({**dict(zip(_DIMENSIONS, places)), **points})

    @property
    def warnings(self) -> MapWarningTable:
        """What left its range, with the points that it is about."""
        return MapWarningTable(self._values["warnings"])

    def loss_torque(
        self,
        *,
        torque_nm: Optional[Numbers] = None,
        speed_rpm: Optional[Numbers] = None,
        temperature_c: Optional[float] = None,
        torque: Optional[Quantities] = None,
        speed: Optional[Quantities] = None,
        temperature: Optional[Quantity] = None,
        finish: Union[int, str] = 0,
    ) -> Floats:
        """Loss torque in N m between the nodes of torque and speed, bilinear.

        Parameters:
            torque_nm, speed_rpm: numbers, broadcast; or ``torque``, ``speed``: text with a unit, quantities of pint.
            temperature_c, temperature: a node of the map; default next to that of the case.
            finish: name of the finish, or its number.

        A negative speed is reverse, where a negative torque drives: it has the loss of the same power forwards.
        Outside the map loss over torque is constant, with a warning: the loss at the edge times the torque over the
        torque of the edge. A place that is not a number has no loss.

        Returns:
            An array of the common shape of torques and speeds.

        Raises:
            AsperityError: neither number nor text of torque or speed (E205), or no node or finish of the map (E209).

        Example:
            >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
            >>> losses = asperity.map(case, torque_nm=[50, 145], speed_rpm=[1000, 9000], band="none")
            >>> losses.loss_torque(torque_nm=[60, 120], speed="4000 1/min").shape
            (2,)
        """
        names = self.finishes
        if finish not in (names if isinstance(finish, str) else range(len(names))):
            raise AsperityError(f"finish {finish!r}: the map has {', '.join(names)}", Code.E209, "Give one of these names.")
        number = names.index(finish) if isinstance(finish, str) else finish
        given = [_places("torque_nm", torque_nm, torque), _places("speed_rpm", speed_rpm, speed)]
        at = operating("temperature_c", temperature_c, temperature)
        torques, speeds = together(given)
        places = torques.ravel().tolist(), speeds.ravel().tolist()
        found, outside = self._map.loss_torque(number, self._node(at), *places)
        if outside.any():
            text = f"{outside.sum()} of {outside.size} places are outside the map; loss over torque is constant there"
            warn([{"code": Code.W401, "text": text}])
        return found.reshape(torques.shape)

    def _node(self, at: Optional[Floats]) -> int:
        """Number of a temperature among the nodes."""
        if at is None:
            return int(np.argmin(np.abs(self.temperature_c - self._values["operating_temperature_c"])))
        nodes = self.temperature_c
        is_node = np.isclose(nodes, at, rtol=0.0, atol=1e-9) if at.shape == (1,) else np.zeros(1)
        if not is_node.any():
            known, given = (", ".join(f"{node:g}" for node in of) for of in (nodes, at.ravel()))
            raise AsperityError(f"temperature {given} °C: the map has {known} °C", Code.E209, "Give the temperature of a node.")
        return int(np.argmax(is_node))

    def export(
        self,
        format: ExportFormat,
        folder: Union[str, PathLike[str]],
        *,
        added: Optional[Union[str, PathLike[str]]] = None,
        cycle: Optional[Union[str, PathLike[str]]] = None,
    ) -> list[Path]:
        """Writes the map for another program.

        Parameters:
            format: one of ``asperity.keys.ExportFormat``.
            folder: existing folder of the files, whose names follow from the finishes.
            added: table of losses beside those of the mesh.
            cycle: drive cycle, which ``"fastsim"`` is weighted by.

        Returns:
            The files that were written.

        Raises:
            AsperityError: a map that the format cannot hold (E205, E209), a missing cycle (E205), or an unwritable file (E401).

        Example:
            >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
            >>> losses = asperity.map(case, torque_nm=[-145, -50, 50, 145], speed_rpm=[1000, 9000], band="none")
            >>> [file.suffix for file in losses.export("matlab", ".")]
            ['.mat']
        """
        tables = [None if file is None else fspath(file) for file in (added, cycle)]
        written = []
        files, found = self._map.export(format, *tables)
        warn(json.loads(found))
        for name, content in files:
            file = Path(folder) / name
            try:
                file.write_bytes(content)
            except OSError as error:
                raise AsperityError(f"{file}: {error}", Code.E401, "Choose another place.") from error
            written.append(file)
        return written

    def to_dict(self) -> dict[str, Any]:
        """All but the raw handles in Python's own types, points as nested lists."""
        return {**super().to_dict(), "points": {name: array.tolist() for name, array in self._points.items()}}

    def to_xarray(self) -> xarray.Dataset:
        """The map as an `xarray.Dataset` over finish, temperature_c, torque_nm and speed_rpm. Between nodes interpolate ``loss_torque_nm``, as
        `loss_torque` does: ``loss_w`` is curved there."""
        import xarray

        coordinates = {
            "finish": self.finishes,
            **{name: variable(name, name, self._axis(name)) for name in ("temperature_c", "torque_nm", "speed_rpm")},
        }
        data = {name: variable(_DIMENSIONS, name, array) for name, array in self._points.items() if name != "code"}
        attributes = {"title": self._values["title"], "scope": self._values["scope"], "ratio": self._values["ratio"]}
        return xarray.Dataset(data, coords=coordinates, attrs=attributes)

    def to_pandas(self) -> pandas.DataFrame:
        """The map as a `pandas.DataFrame` with a row per point."""
        import pandas

        levels = [self.finishes, self.temperature_c, self.torque_nm, self.speed_rpm]
        index = pandas.MultiIndex.from_product(levels, names=_DIMENSIONS)
        return self.rows.to_pandas().drop(columns=list(_DIMENSIONS)).set_index(index)

    def plot(self, ax: Any = None) -> Any:
        """Loss over speed at the largest torque, of every finish at the first temperature, on axes of matplotlib or as a `Chart`."""
        losses = self._points["loss_w"][:, 0, -1, :]
        series = [(name, losses[number].tolist()) for number, name in enumerate(self.finishes)]
        title = f"Loss at {self.torque_nm[-1]:g} N m"
        return shown(Chart(title, self.speed_rpm.tolist(), series, ("speed in 1/min", "loss in W")), ax)

    def __repr__(self) -> str:
        points = self._points["loss_w"]
        shape = " x ".join(str(count) for count in points.shape)
        return f"<Map {self._values['title']!r}: {shape} points, loss {np.nanmin(points):.4g} to {np.nanmax(points):.4g} W>"

    def _repr_html_(self) -> str:
        rows = [
            ("torque", f"{self.torque_nm[0]:g} to {self.torque_nm[-1]:g} N m"),
            ("speed", f"{self.speed_rpm[0]:g} to {self.speed_rpm[-1]:g} 1/min"),
            ("temperature", ", ".join(f"{value:g}" for value in self.temperature_c) + " °C"),
            ("points", str(self._points["loss_w"].size)),
        ]
        return page(str(self._values["title"]), rows, str(self.plot()))


def _places(own: str, given: Optional[Numbers], text: Optional[Quantities]) -> Floats:
    """Torques or speeds in the unit of the map; a single one is a number."""
    found = operating(own, given, text)
    if found is None:
        name = own.rsplit("_", 1)[0]
        raise AsperityError(f"{own} or {name} is required", Code.E205, f"Give {own} or {name}.")
    is_single = given is not None and np.ndim(given) == 0 or isinstance(text, str) or np.ndim(getattr(text, "magnitude", [0.0])) == 0
    return found.reshape(np.shape(given)) if given is not None else found[0] if is_single else found


class Cycle(Study, CycleValues):
    """Energy lost over a cycle: ``finishes`` (name, energies in Wh, quantiles ...), ``drive_wh``, ``coast_wh`` ..."""

    @property
    def finishes(self) -> CycleFinishTable:
        """One row per finish."""
        return CycleFinishTable(self._values["finishes"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per finish."""
        return self.finishes.to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        def lost(of: Mapping[str, Any]) -> str:
            return with_ends(of["lost_wh"], of.get("lost_quantiles_wh"), "W h")

        return [(f"lost with {finish['name']}", lost(finish)) for finish in self._values["finishes"]]


def read_map(folder: Union[str, PathLike[str]]) -> Map:
    """The map in a folder that ``asperity map`` or `Map.write` has written.

    Parameters:
        folder: the folder.

    Returns:
        The `Map`.

    Raises:
        AsperityError: the folder holds no map, or a file of it is damaged (E402).

    Example:
        >>> case = asperity.Case(asperity.demo(), model={"positions": 4, "offsets": 2})
        >>> asperity.map(case, torque_nm=[50, 145], speed_rpm=[1000, 9000], band="none").write("losses")
        >>> asperity.read_map("losses").torque_nm.tolist()
        [50.0, 145.0]
    """
    return Map(_asperity.read_map(fspath(folder)))


def map_of(map: Map) -> _asperity.Study:
    """The map of the compiled part."""
    if not isinstance(map, Map):
        raise wrong_kind("map", map, "a Map, of map or read_map")
    return cast("_asperity.Study", map._raw)


def _restored(files: dict[str, bytes]) -> Map:
    """The map in the files that another process wrote."""
    import tempfile
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place) / "map"
        Unpickled("", "", files).write(folder)
        return read_map(folder)
