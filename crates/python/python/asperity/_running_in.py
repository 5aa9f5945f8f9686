"""Running-in of the flanks of a case over engagements."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._record import Table
from ._study import Study
from ._values import RunningInCourseTable, RunningInValues

if TYPE_CHECKING:
    import pandas


class RunningIn(Study, RunningInValues):
    """Running-in of the flanks: ``courses`` at each torque, whose ``rows`` are the flanks over engagements; ``loss_w`` of the flanks as
    measured; ``test``, with traces of one, has the wear coefficient.

    Intervals are from 5 to 95 %.
    """

    @property
    def courses(self) -> RunningInCourseTable:
        """One row per torque: how long running-in takes, what it is worth, what it removes, and its ``rows``."""
        return RunningInCourseTable(self._values["courses"])

    def to_pandas(self) -> pandas.DataFrame:
        """One row per torque and number of engagements."""
        courses = self._values["courses"]
        return Table([{"torque_nm": course["torque_nm"], **row} for course in courses for row in course["rows"]]).to_pandas()

    def _rows(self) -> list[tuple[str, str]]:
        courses = self._values["courses"]
        return [(f"loss run in at {course['torque_nm']:.4g} N m", f"{100 * course['factor']:.1f} % of {self._values['loss_w']:.4g} W") for course in courses]
