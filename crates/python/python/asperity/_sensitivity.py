"""What the loss of a case does when one thing changes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from ._study import Study
from ._values import SensitivityRowTable, SensitivityValues

if TYPE_CHECKING:
    import pandas

COLUMNS = [
    "group", "what", "to", "difference_w", "change", "sampling_p05_w", "sampling_p95_w", "film_w", "lubricated_asperity_w",
    "boundary_w", "rolling_w", "code",
]


class Sensitivity(Study, SensitivityValues):
    """Changes of a loss, one thing changed at a time: ``title``, ``loss_w``, ``loss_at_medians_w``, ``efficiency``, ``rows``.

    They are answers of the model at the same windows of the traces, not measurements.
    """

    @property
    def rows(self) -> SensitivityRowTable:
        """One row per change; a change that cannot be run has a ``code`` and no numbers."""
        rows: list[dict[str, Any]] = []
        for row in self._values["rows"]:
            flat = {name: None for name in COLUMNS}
            flat.update({name: row[name] for name in ("group", "what", "to")})
            flat.update(row["effect"] or {})
            flat["code"] = (row.get("refused") or {}).get("code")
            rows.append(flat)
        return SensitivityRowTable(rows, COLUMNS)

    def to_pandas(self) -> pandas.DataFrame:
        """One row per change."""
        return self.rows.to_pandas()

    def __repr__(self) -> str:
        return f"<Sensitivity {self._values['title']!r}: {len(self._values['rows'])} changes of {self._values['loss_w']:.4g} W>"

    def _rows(self) -> list[tuple[str, str]]:
        effects = [(row, row["effect"]) for row in self._values["rows"] if row["effect"]]
        return [(f"{row['what']} → {row['to']}", f"{100 * effect['change']:+.1f} %") for row, effect in effects]
