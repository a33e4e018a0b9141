# SPDX-License-Identifier: GPL-3.0-or-later
"""Measurements over numpy arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _axiscomp
from ._axiscomp import Table
from ._call import _Files, call, flat, give_warnings

if TYPE_CHECKING:
    import numpy


class Measurement:
    """Deviations at targets, to be given to judge, fit, compare and runs in place of a file.

    targets  shape (n,), ascending, in mm or deg
    up       shape (runs, n): reference - target, in the unit of the targets, of runs in the positive direction;
             NaN or masked where nothing was measured
    down     the same of the negative direction
    unit     "mm" or "deg", of targets and deviations
    statements: machine, axis, instrument, serial, operator, date, feed, dwell, drive,
             compensation ("on" or "off"), kind: "averages" where each value is a mean of runs, of which nothing says how
             they repeat ("runs")

    A measurement never changes: other values are another one, Measurement(m.targets, m.up - offset, m.down,
    kind=m.kind, ...).
    """

    def __init__(
        self, targets: Any, up: Any = None, down: Any = None, unit: str = "mm", **statements: str
    ) -> None:
        import numpy

        if unit not in ("mm", "deg"):
            raise ValueError(f"the unit is mm or deg, not {unit}")

        def floats(given: Any) -> numpy.ndarray:
            if numpy.asarray(given).dtype.kind in "cmM":
                raise TypeError("targets and deviations are real numbers")  # numpy would drop a part of them
            # What is masked was not measured.
            return numpy.ma.filled(numpy.ma.asarray(given, dtype=float), numpy.nan)

        for name, statement in statements.items():
            if not isinstance(statement, str):
                raise TypeError(f"{name} is a text, not {statement!r}")
        targets = floats(targets)
        none = numpy.empty((0, targets.size))
        self._take(
            _axiscomp.csv_of_runs(
                targets,
                none if up is None else numpy.atleast_2d(floats(up)),
                none if down is None else numpy.atleast_2d(floats(down)),
                unit == "deg",
                statements,
            )
        )

    def _take(self, file: bytes) -> None:
        parts = _axiscomp.runs_of_csv(file)
        self.file = file  #: the documented CSV of runs (docs/metrology.md)
        self.targets: numpy.ndarray = parts["targets"]
        self.up: numpy.ndarray = parts["up"]
        self.down: numpy.ndarray = parts["down"]
        self.unit: str = parts["unit"]
        self.kind: str = parts["kind"]  #: "runs", or "averages" of a file of means
        for array in (self.targets, self.up, self.down):
            array.setflags(write=False)  # the file would not change with it

    @classmethod
    def of_file(cls, file: bytes) -> "Measurement":
        """Of the documented CSV of runs."""
        measurement = cls.__new__(cls)
        measurement._take(file)
        return measurement

    def as_file(self, files: _Files) -> str:
        return files.put(self.file, "measurement.csv")

    def __reduce__(self):
        return (Measurement.of_file, (self.file,))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Measurement) and self.file == other.file

    def __repr__(self) -> str:
        return (
            f"<axiscomp.Measurement: {self.targets.size} targets from {self.targets[0]} to {self.targets[-1]} "
            f"{self.unit}, {len(self.up)} runs up, {len(self.down)} runs down>"
        )


def read_measurement(files: Any, **options: Any) -> Measurement:
    """One measurement of one file or several, of any format that `axiscomp runs` reads.

    options: those of `axiscomp runs`, such as from_="renishaw", unit="mm", exclude="down:1:1". Values that
    are left out are NaN. Raises Error, and warns (FileWarning) of what looks wrong.
    """
    document, output = call("runs", flat([files]), {**options, "output": "-"}, raw=True)
    give_warnings(document.notes)
    return Measurement.of_file(output)


class Prediction:
    """The runs of a measurement as they would be with a table active. It is no measurement, and is not taken for one.

    targets, up, down, unit  as of Measurement
    figures                  of ISO 230-2: {"B", "M", "E", "A", ...}, in `unit`; None: not defined
    """

    def __init__(self, parts: dict[str, Any]) -> None:
        self.targets: numpy.ndarray = parts["targets"]
        self.up: numpy.ndarray = parts["up"]
        self.down: numpy.ndarray = parts["down"]
        self.unit: str = parts["unit"]
        self.figures: dict[str, float | None] = parts["figures"]


def predict(
    measurement: Measurement,
    table: Table,
    *,
    lookup_at: str,
    measured_with: Table | str | None = None,
    turn: float | None = None,
) -> Prediction:
    """Foretells a measurement with a table active, as the drive applies it.

    table          of one dimension and of the axis that was measured; the units of its values and positions
                   must be stated (UnitMismatch)
    lookup_at      "encoder" or "set": at which position the drive looks the table up
    measured_with  the table that was active, or "off", where the measurement does not say it
                   (MeasurementState)
    turn           length of a turn of a modulo axis, which is that of the table
    """
    if isinstance(measured_with, str) and measured_with != "off":
        raise ValueError(f'measured_with is a table or "off", not {measured_with}')
    if turn is not None and not hasattr(turn, "__float__"):
        raise TypeError(f"turn is a number, not {turn!r}")
    active = None if isinstance(measured_with, str) else measured_with
    return Prediction(
        _axiscomp.predict(measurement.file, table, lookup_at, active, measured_with == "off", turn)
    )
