"""Tables and small charts for notebooks, without any package."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from os import PathLike
from typing import Any

from ._fixed import Fixed

Series = Sequence[tuple[str, Sequence[float]]]

_COLOURS = ("#2a6f97", "#c8553d", "#588b4c", "#8a5a9e", "#b08900", "#5c6b73")
_WIDTH, _HEIGHT = 460.0, 200.0
_LEFT, _RIGHT, _BOTTOM = 62.0, 12.0, 40.0
_OF_A_LETTER = 5.8
"""Mean width of a letter, for names side by side."""


def escape(text: str) -> str:
    """The text as it stands in HTML; the package html is not worth its import."""
    for sign, name in (("&", "amp"), ("<", "lt"), (">", "gt"), ('"', "quot")):
        text = text.replace(sign, f"&{name};")
    return text


def table(names: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """An HTML table; after twenty rows the others are counted."""
    most = 20
    every = [list(row) for row in rows]
    head = "".join(f"<th>{escape(name)}</th>" for name in names)
    body = "".join("<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in every[:most])
    rest = f"<p>{len(every) - most} more rows</p>" if len(every) > most else ""
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{rest}"


def page(title: str, rows: Iterable[tuple[str, str]], chart: str | None) -> str:
    """Title, names with values, and a chart beside them."""
    cells = "".join(
        f'<tr><td style="text-align:left">{escape(name)}</td><td style="text-align:right">{escape(value)}</td></tr>'
        for name, value in rows
    )
    beside = f"<div>{chart}</div>" if chart else ""
    return (
        f"<div><strong>{escape(title)}</strong>"
        f'<div style="display:flex;flex-wrap:wrap;gap:1em;align-items:flex-start"><table>{cells}</table>{beside}</div></div>'
    )


def _ticks(low: float, high: float, most: int) -> list[float]:
    span = high - low
    step = 10.0 ** math.floor(math.log10(span / most))
    step *= next(factor for factor in (1.0, 2.0, 5.0, 10.0) if span / (step * factor) <= most)
    first = math.ceil(low / step - 1e-9)
    return [number * step for number in range(first, math.floor(high / step + 1e-9) + 1)]


def _range(values: Iterable[float]) -> tuple[float, float]:
    finite = [value for value in values if math.isfinite(value)]
    low, high = (min(finite), max(finite)) if finite else (0.0, 1.0)
    if low == high:
        half = abs(low) or 1.0
        return low - 0.5 * half, high + 0.5 * half
    return low, high


class Chart(Fixed):
    """A small line chart as SVG, in the colours of the page around it.

    Notebooks show it; `save` writes it to a file, `str` gives the text.
    """

    def __init__(self, title: str, x: Sequence[float], series: Series, labels: tuple[str, str]) -> None:
        self._title = title
        self._x, self._series, self._labels = x, series, labels
        self._svg = _drawn(title, x, series, labels)

    @property
    def title(self) -> str:
        """Title of the chart."""
        return self._title

    def on(self, ax: Any) -> Any:
        """Draws the chart on axes of matplotlib and returns them."""
        for name, values in self._series:
            ax.plot(self._x, values, linewidth=1.0, label=name)
        ax.set_title(self.title)
        ax.set_xlabel(self._labels[0])
        ax.set_ylabel(self._labels[1])
        if len(self._series) > 1:
            ax.legend()
        return ax

    def __str__(self) -> str:
        return self._svg

    def __repr__(self) -> str:
        return f"<Chart {self.title!r}>"

    def _repr_html_(self) -> str:
        return self._svg

    def save(self, path: str | PathLike[str]) -> None:
        """Writes the chart to an SVG file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self._svg)


def shown(chart: Chart, ax: Any) -> Any:
    """The chart, or the axes of matplotlib that it is drawn on."""
    return chart if ax is None else chart.on(ax)


def _thinned(values: Sequence[float]) -> Iterator[int]:
    """Numbers of the points that are drawn: of many the lowest and the highest in every part, so that no peak is lost."""
    parts = 500
    if len(values) <= 2 * parts:
        yield from range(len(values))
        return
    for part in range(parts):
        places = range(part * len(values) // parts, (part + 1) * len(values) // parts)
        yield from sorted({min(places, key=values.__getitem__), max(places, key=values.__getitem__)})


def _drawn(title: str, x: Sequence[float], series: Series, labels: tuple[str, str]) -> str:
    x_low, x_high = _range(x)
    y_low, y_high = _range(value for _, values in series for value in values)
    pad = 0.06 * (y_high - y_low)
    y_low, y_high = y_low - pad, y_high + pad
    right, bottom = _WIDTH - _RIGHT, _HEIGHT - _BOTTOM
    # Names of the lines have a row of their own below the title.
    top = 38.0 if len(series) > 1 else 22.0

    def across(value: float) -> float:
        return _LEFT + (value - x_low) / (x_high - x_low) * (right - _LEFT)

    def down(value: float) -> float:
        return bottom - (value - y_low) / (y_high - y_low) * (bottom - top)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH:g} {_HEIGHT:g}" width="{_WIDTH:g}" '
        f'role="img" aria-label="{escape(title)}" font-family="sans-serif" font-size="11" fill="currentColor">'
        f'<text x="{_LEFT:g}" y="14" font-weight="bold">{escape(title)}</text>'
    ]
    for tick in _ticks(x_low, x_high, 6):
        parts.append(f'<text x="{across(tick):.1f}" y="{bottom + 14:g}" text-anchor="middle">{tick:.6g}</text>')
    for tick in _ticks(y_low, y_high, 4):
        y = down(tick)
        parts.append(f'<path d="M{_LEFT:g} {y:.1f}H{right:g}" stroke="currentColor" stroke-opacity="0.15"/>')
        parts.append(f'<text x="{_LEFT - 5:g}" y="{y + 4:.1f}" text-anchor="end">{tick:.6g}</text>')
    middle = 0.5 * (_LEFT + right)
    parts.append(f'<text x="{middle:g}" y="{_HEIGHT - 8:g}" text-anchor="middle">{escape(labels[0])}</text>')
    parts.append(
        f'<text transform="translate(12 {0.5 * (top + bottom):g}) rotate(-90)" text-anchor="middle">{escape(labels[1])}</text>'
    )
    named = _LEFT
    for number, (name, values) in enumerate(series):
        colour = _COLOURS[number % len(_COLOURS)]
        points, pen = [], "M"
        for index in _thinned(values):
            if not math.isfinite(values[index]):
                pen = "M"
                continue
            points.append(f"{pen}{across(x[index]):.1f} {down(values[index]):.1f}")
            pen = "L"
        parts.append(f'<path d="{"".join(points)}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        if len(series) > 1:
            parts.append(f'<text x="{named:g}" y="30" fill="{colour}">{escape(name)}</text>')
            named += _OF_A_LETTER * (len(name) + 3)
    return "".join(parts) + "</svg>"
