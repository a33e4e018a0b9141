# SPDX-License-Identifier: GPL-3.0-or-later
"""Tables over numpy arrays: read, written, converted, resampled, looked up."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Sequence

from . import _axiscomp
from ._axiscomp import Table
from ._call import Document, call, give_warnings, is_list, one, with_filled, with_points
from .errors import RequestError


class Axis(NamedTuple):
    """One dimension of a table: position(i) = start + i * distance, i = 0 .. size - 1.

    Table takes it for another one over the same positions; a size of 0 is that of the values.
    """

    start: float
    distance: float
    unit: str = ""
    name: str = ""
    size: int = 0

    @property
    def last(self) -> float:
        return self.start + (self.size - 1) * self.distance


def read_all(file: Any, **options: Any) -> list[Table]:
    """All tables of a file of any format, in the sign of the drive, or those of table=[...], by names or numbers.

    options: those of `axiscomp convert`, such as dims=1, from_="softmc", fill="plane", within=0.01. A CSV
    file needs dims. Raises Error, and warns (FileWarning) of what a file leaves open.
    """
    return _read(file, options, takes_several=True)


def _read(file: Any, options: dict[str, Any], takes_several: bool) -> list[Table]:
    choice = options.get("table")
    if is_list(choice) and len(choice) > 0:
        tables, notes = _one_by_one(file, choice, options)
    else:
        try:
            tables, notes = _converted(file, options)
        except RequestError as error:
            count = error.context.get("tables")
            is_for_one = not takes_several or options.get("name") is not None or (isinstance(file, str) and file == "-")
            if count is None or is_for_one:  # standard input is read once, and a name is that of one table
                raise
            # Tables over different positions do not fit into one CSV.
            tables, notes = _one_by_one(file, range(1, count + 1), options)
    given = [file] if isinstance(file, Table) else file
    if isinstance(given, (list, tuple)) and all(isinstance(table, Table) for table in given):
        # What is said of the file that they became is of no file of the caller.
        give_warnings([note for note in notes if note.startswith("warning: ")])
        count = 0 if is_list(choice) else len(tables)  # those of a list are in its order, and known by their names
        return [_with_filled_of(table, n, given, count) for n, table in enumerate(tables)]
    give_warnings(notes)
    return tables


def _converted(file: Any, options: dict[str, Any]) -> tuple[list[Table], list[str]]:
    """The tables that have a place in one CSV, and what was said of them."""
    document, output = call("convert", [file, "-"], {**options, "to": "csv"}, raw=True)
    tables = _axiscomp.tables_of_csv(output, document["dimensions"])
    # Of a conversion the document has one entry for each group of columns, and the tables are the columns.
    said = [column for group in document["tables"] for column in group.get("columns", [group])]
    if len(said) == len(tables):
        tables = [with_filled(table, column.get("filled")) for table, column in zip(tables, said)]
    return tables, document.notes


def _one_by_one(file: Any, choices: Iterable[Any], options: dict[str, Any]) -> tuple[list[Table], list[str]]:
    tables: list[Table] = []
    notes: list[str] = []
    for choice in choices:
        try:
            made, said = _converted(file, {**options, "table": choice})
        except RequestError as error:
            if error.code != "TableAmbiguous" or not isinstance(choice, int):
                raise
            made, said = _converted(file, {**options, "table": f"#{choice}"})  # another one has this number for a name
        tables += made
        notes += [note for note in said if note not in notes]
    return tables, notes


def _with_filled_of(table: Table, number: int, given: Sequence[Table], count: int) -> Table:
    """A table that was made of one of those given has its filled points while the points stay."""
    same = [given[number]] if count == len(given) else [one for one in given if one.name == table.name]
    if len(same) != 1 or not same[0].filled or not _have_same_points(table.axes, same[0].axes):
        return table
    return with_points(table, same[0].filled)


def _have_same_points(axes: list[Axis], others: list[Axis]) -> bool:
    def are_close(one: Axis, other: Axis) -> bool:
        most = 1e-6 * other.distance  # a position may have been rounded on its way through a file
        return abs(one.start - other.start) <= most and abs(one.last - other.last) <= most

    return len(axes) == len(others) and all(
        one.size == other.size and are_close(one, other) for one, other in zip(axes, others)
    )


def read(file: Any, **options: Any) -> Table:
    """The only table of a file, or that with the name or number `table`. Otherwise as read_all."""
    return one(_read(file, options, takes_several=False), "tables")


def write(tables: Table | Sequence[Table], file: Any, **options: Any) -> Document:
    """Writes a file, whole or not at all, in the format of its name or of to="...".

    options: those of `axiscomp convert`. A large correction is refused in a .TAMtbl (LargeCorrection)
    unless accept_large=True.
    """
    return call("convert", [tables, file], options)


def resample(table: Table, **options: Any) -> Table:
    """The table on another even grid: points=..., distance=... or within=..., method="cubic", hold=True.

    Warns (FileWarning) of a distance with which the grid ends before the table.
    """
    return read(table, **options)


Table.__doc__ = """Compensation values on an even grid of 1 to 3 dimensions; it never changes.

Table(values, axes, name="Table", unit="", target="", filled=[], notes=[]) copies the values once, as float32:
    values  shape (n1,), (n1, n2) or (n1, n2, n3), reference - encoder, in `unit`
    axes    one (start, distance[, unit[, name]]) per dimension, distance > 0
    target  the axis that is corrected; empty: what the name says, as in a file: "Y" of "Y error" over X
    filled  indices, dimension 1 fastest, of values that were made up, each once; a mask is a TypeError
    notes   comments of the file: "lookup: encoder" or "lookup: set" says for which side a fit made the table, and
            a write to a source on the other side is refused; "drive: NAME, serial number N" says which drive was
            measured, and a write to another one is refused; tables of one file say the same
Raises Error (InvalidArgument) for a value that is not finite, ValueError for a text with a control character.
"""
Table.values.__doc__ = "float32, shape (n1[, n2[, n3]]): the table's own memory, which nobody can write to."
Table.axes.__doc__ = "One Axis(start, distance, unit, name, size) per dimension."
Table.crc.__doc__ = "CRC-32 of the elements, as a drive with the built-in profile shows it."
