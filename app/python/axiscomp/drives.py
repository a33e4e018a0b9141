# SPDX-License-Identifier: GPL-3.0-or-later
"""A drive: read, written to, switched, watched."""

from __future__ import annotations

import os
import weakref
from typing import Any, Iterator

from . import _axiscomp
from ._axiscomp import Table
from ._call import Document, Echo, _Files, _words, call, encoded, one
from .errors import RequestError


class Monitor:
    """Readings of an axis, one dictionary each: time in s, state, output, index1 ..., source1 ...

    A context manager and an iterator. Readings are taken on a thread of their own at the rate that was asked
    for, whatever the program does in between; at its end, and at the end of the program, it is stopped.
    """

    def __init__(self, words: list[str]) -> None:
        self._readings = _axiscomp.Readings(list(map(encoded, words)))
        self._stop = weakref.finalize(self, self._readings.stop)

    def __enter__(self) -> "Monitor":
        return self

    def __exit__(self, *_: Any) -> None:
        self.stop()

    def __iter__(self) -> Iterator[dict[str, Any]]:
        return self

    def __next__(self) -> dict[str, Any]:
        reading = self._readings.next()
        if reading is None:
            raise StopIteration
        return reading

    def stop(self) -> None:
        """Takes no more readings; those that were taken can still be fetched."""
        self._stop()

    @property
    def missed(self) -> int:
        """Readings that were dropped because nobody fetched them, of more than 100 000."""
        return self._readings.missed


class Drive:
    """A drive by its address: "http://host[:port]" or "https://...".

    Nothing is sent before a method is called; each makes its connection, and releases the interpreter's lock
    while it waits. axis: index or name; not needed if the drive has only one. Every method raises Error.
    """

    def __init__(
        self,
        endpoint: str,
        *,
        profile: Any = None,
        timeout: float | None = None,
        trust_certificate: str | None = None,
        echo: Echo | None = None,
    ) -> None:
        """profile: file in place of the built-in one. timeout: of one exchange, in s (5). echo: is called with
        what a command says while it works, such as print."""
        if not isinstance(endpoint, (str, os.PathLike)) or not os.fspath(endpoint):
            # Without an address it would be the drive of AXISCOMP_DRIVE. In a list there may be a password.
            given = "an empty one" if isinstance(endpoint, str) else f"a {type(endpoint).__name__}"
            raise TypeError(f"a drive needs its address as a text, not {given}")
        self.endpoint = endpoint
        self.echo = echo
        self._connection = {
            "drive": endpoint,
            "profile": profile,
            "timeout": timeout,
            "trust_certificate": trust_certificate,
        }

    def __repr__(self) -> str:
        # Notebooks and logs keep it: without user and password, which end at the last @, whatever stands in them.
        before, _, host = os.fspath(self.endpoint).rpartition("@")
        scheme, mark, _ = before.partition("://")
        return f"<axiscomp.Drive {scheme + mark if mark else ''}{host}>"

    def _call(self, command: str, options: dict[str, Any], *positionals: Any) -> Document:
        # In the order of the options, the way to the drive behind them. None takes nothing of it away.
        said = {name: value for name, value in options.items() if value is not None or name not in self._connection}
        return call(command, list(positionals), said | self._connection | said, self.echo)

    def axes(self) -> Document:
        """The axes of the drive: what `axiscomp axes` says."""
        return self._call("axes", {})

    def status(self, axis: int | str | None = None, **options: Any) -> Document:
        """The compensation of an axis, and the outcome of an interrupted write."""
        return self._call("status", {"axis": axis, **options})

    def _write(self, data: Any, axis: int | str | None, options: dict[str, Any]) -> Document:
        return self._call("write", {**options, "axis": axis, "data": data})

    def plan(self, data: Any = None, axis: int | str | None = None, **options: Any) -> Document:
        """What write with the same arguments would change and cost; changes nothing."""
        dry_run = {"dry_run": True}
        return self._write(data, axis, dry_run | options | dry_run)  # first, so that no word before can take it

    def write(self, data: Any = None, axis: int | str | None = None, **options: Any) -> Document:
        """Writes a table in the safe order, verified; the compensation stays off.

        data     a Table, tables of one file (with map={"column": axis}) or a file; without it the axis keeps
                 its table
        options  those of `axiscomp write`: source1="Axes[0]/...", own_position=True, persistent=True,
                 value_unit="um", target=..., slot=..., record="x.axcal", accept_large=True, ...
        What the values correct and in which units they are is stated by the table, the options or the sources;
        else the write is refused (TargetNotKnown, UnitMismatch), as is a large correction without
        accept_large=True (LargeCorrection). After any error but OutcomeUnknown and RollbackFailed the drive
        holds the old state. The plan is in the document and in its text.
        """
        return self._write(data, axis, options)

    def persist(self, axis: int | str | None = None) -> Document:
        """Stores the axis's table in the drive's flash."""
        return self._call("persist", {"axis": axis})

    def unpersist(self, axis: int | str | None = None) -> Document:
        """Makes the axis's table volatile."""
        return self._call("unpersist", {"axis": axis})

    def activate(self, axis: int | str | None = None, **options: Any) -> Document:
        """Switches the compensation on, and compares the drive's output with the table (ProofFailed)."""
        return self._call("activate", {"axis": axis, **options})

    def evaluate(self, axis: int | str | None = None) -> Document:
        """Lets the drive look the table up without adding its values."""
        return self._call("evaluate", {"axis": axis})

    def deactivate(self, axis: int | str | None = None) -> Document:
        """Switches the compensation off."""
        return self._call("deactivate", {"axis": axis})

    def read(self, axis: int | str | None = None) -> Table:
        """The table that an axis uses."""
        with _Files() as files:
            file = files.put(b"", "table.csv")
            document = self._call("read", {"axis": axis, "output": file})
            with open(file, "rb") as stream:
                return one(_axiscomp.tables_of_csv(stream.read(), len(document["axes"])), "tables")

    def monitor(
        self, axis: int | str | None = None, rate: float | None = None, count: int | None = None
    ) -> Monitor:
        """Readings of the running compensation, `rate` a second (1 to 100; 10), without end or `count` of them.

        with drive.monitor("X", rate=50) as readings:
            for reading in readings: ...
        """
        options = {**self._connection, "axis": axis, "rate": rate, "count": count}
        words = ["monitor"]
        with _Files() as files:
            for parameter, value in options.items():
                words += _words(parameter, value, files)
        return Monitor(words)

    def run(self, command: str, *positionals: Any, **options: Any) -> Document:
        """Any other command of axiscomp that talks to a drive: drive.run("backup", output="x.json")."""
        if command == "monitor":  # its readings are no document
            raise RequestError("InvalidArgument", "monitor has no document: drive.monitor() gives its readings")
        return self._call(command, options, *positionals)
