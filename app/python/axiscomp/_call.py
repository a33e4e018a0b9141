# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands of axiscomp as functions: arguments become words of the command line, and back."""

from __future__ import annotations

import functools
import math
import os
import sys
import warnings
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Callable, Sequence

from . import _axiscomp
from ._axiscomp import Table
from .errors import Error, FileWarning, RequestError

Echo = Callable[[str], None]


class Document(dict):
    """What a command says: the document of --json (docs/cli.md), and what a person reads.

    outcome  "Done", or a result that is no error: "ToleranceNotMet" (judge, fit, compare), "Differs" (plan),
             "ProblemsFound" (doctor)
    text     what the command prints for people
    notes    warnings and notes, one line each
    tables   of fit, where it writes no file; none with direction="both", whose pair is for a file of a controller
    """

    def __init__(self, content: Any, outcome: str, text: str, notes: list[str]) -> None:
        super().__init__(content if isinstance(content, dict) else {} if content is None else {"list": content})
        self.outcome = outcome
        self.text = text
        self.notes = notes
        self.tables: list[Table] = []

    @property
    def ok(self) -> bool:
        """Nothing is against it: no tolerance that is not met, no drive that differs, no problem."""
        return self.outcome == "Done"

    def __str__(self) -> str:
        return self.text

    def __reduce__(self):
        return (Document, (dict(self), self.outcome, self.text, self.notes), {"tables": self.tables})


class _Files:
    """Objects that are given in place of files, as files in a folder that goes away with them."""

    def __init__(self) -> None:
        self._stack = ExitStack()
        self._folder: Path | None = None
        self.names: dict[str, str] = {}

    def __enter__(self) -> "_Files":
        return self

    def __exit__(self, *_: Any) -> None:
        self._stack.close()

    def put(self, content: bytes, name: str) -> str:
        if self._folder is None:
            import tempfile  # not before, since it loads as many modules as all else here

            self._folder = Path(self._stack.enter_context(tempfile.TemporaryDirectory(prefix="axiscomp-")))
        place = self._folder / str(len(self.names) + 1)
        place.mkdir()
        file = place / name
        file.write_bytes(content)
        self.names[str(file)] = name
        return str(file)

    def named(self, said: Any) -> Any:
        """What was said of these files, without the folder that nobody knows."""
        if isinstance(said, str):
            for file, name in self.names.items():
                said = said.replace(file, name)
        elif isinstance(said, list):
            return [self.named(element) for element in said]
        elif isinstance(said, dict):
            return {key: self.named(value) for key, value in said.items()}
        return said


def option_name(parameter: str) -> str:
    """"accept_large" -> "--accept-large", "from_" -> "--from"."""
    return "--" + parameter.rstrip("_").replace("_", "-")


def _plain(value: Any) -> Any:
    """A number, a text or a truth value of numpy as that of Python."""
    if not hasattr(value, "dtype") or getattr(value, "ndim", 1) != 0:
        return value
    if getattr(value, "mask", False):
        raise TypeError("a masked value is no value")
    return value.item()


def _is_decimal(value: Any) -> bool:
    decimal = sys.modules.get("decimal")  # where nobody has loaded it there is none
    return decimal is not None and isinstance(value, decimal.Decimal)


def _text(value: Any) -> str:
    value = _plain(value)
    if isinstance(value, bool):
        raise TypeError("True and False are for options without a value")
    if not isinstance(value, (str, int, float, os.PathLike)) and not _is_decimal(value):
        # Its text would be a word of the command line, and decide something.
        raise TypeError(f"a {type(value).__name__} is no single value: give a text, a number or a path")
    if isinstance(value, float):
        # repr() of a float is the shortest text that reads back to the same number; nan and inf are refused in words.
        return str(int(value)) if math.isfinite(value) and value == int(value) else repr(value)
    text = os.fsdecode(value) if isinstance(value, os.PathLike) else str(value)
    if "\0" in text:
        raise ValueError("a text with a zero byte")  # a word of the command line would end there
    return text


def encoded(word: str) -> bytes:
    """A word as the command line has it: in UTF-8, of a file's name each byte that os.fsdecode() could not read."""
    try:
        return word.encode("utf-8", "surrogateescape")
    except UnicodeEncodeError:
        raise ValueError("a text with half of a surrogate pair") from None


def is_list(value: Any) -> bool:
    return isinstance(value, (list, tuple)) or (hasattr(value, "shape") and getattr(value, "ndim", 0) > 0)


@functools.cache
def _options_with_value() -> frozenset[str]:
    options = [option for command in _axiscomp.commands() for option in command["options"]]
    return frozenset(name for option in options if option["takes_value"] for name in option["names"])


def _words(parameter: str, value: Any, files: _Files) -> list[str]:
    name = option_name(parameter)
    value = _plain(value)
    if value is None:
        return []
    if isinstance(value, bool):
        # Alone it would take the next word for its value. What the command does not know it refuses itself.
        if name in _options_with_value():
            raise TypeError(f"{parameter} takes a value: True and False are for options without one")
        return [name] if value else []
    if (isinstance(value, dict) or is_list(value)) and len(value) == 0:
        if parameter in MAY_BE_EMPTY:
            return []
        raise RequestError(
            "InvalidArgument",
            f"{parameter} is an empty {type(value).__name__}: give at least one value, or None for what the command "
            f"does without {name}",
        )
    if isinstance(value, dict):  # tolerance={"A": "10um"}, set_in={"axis": 1}
        if parameter in ("tolerance", "columns"):
            return [name + "=" + ",".join(f"{key}={_text(element)}" for key, element in value.items())]
        return [f"{name}={key}={_text(element)}" for key, element in value.items()]
    if hasattr(value, "as_file"):
        return [f"{name}={value.as_file(files)}"]
    if is_list(value):
        if parameter in LISTS:
            return [name + "=" + ",".join(_text(element) for element in value)]
        return [f"{name}={_text(element)}" for element in value]
    return [f"{name}={_text(value)}"]


def _positional(place: Any, files: _Files) -> str:
    return place.as_file(files) if hasattr(place, "as_file") else _text(place)


# Options whose values stand in one word, with commas between them.
LISTS = frozenset(("points", "distance", "period", "zero", "exclude"))
# Options without which there is none of what they name. Without any other one it is another thing: without only all axes,
# without drive that of the environment.
MAY_BE_EMPTY = frozenset(("exclude", "tolerance", "columns", "period", "set_in", "set_out"))


class _TableFile:
    """Tables over the same axes, given in place of a file."""

    def __init__(self, tables: list[Table]) -> None:
        self.tables = tables

    def as_file(self, files: _Files) -> str:
        return files.put(_axiscomp.csv_of_tables(self.tables), "table.csv")


def _file_of(given: Any) -> Any:
    """Tables become a file; all else stays."""
    tables = [given] if isinstance(given, Table) else given
    if isinstance(tables, (list, tuple)) and tables and all(isinstance(table, Table) for table in tables):
        return _TableFile(list(tables))
    return given


def _check_data(given: Any) -> None:
    """An empty list as data would be no data: the axis would keep its table, under new sources."""
    if not is_list(given) or (len(given) == 1 and isinstance(given[0], (str, os.PathLike))):
        return
    raise RequestError(
        "InvalidArgument",
        f"data is a {type(given).__name__} without a table: give a Table, a list of tables over the same axes, or a file",
    )


def _with_files(positionals: list[Any], options: dict[str, Any]) -> tuple[list[Any], dict[str, Any]]:
    positionals = [_file_of(given) for given in positionals]
    options = {parameter: _file_of(value) for parameter, value in options.items()}
    _check_data(options.get("data"))
    for given in (*positionals, options.get("data")):
        if isinstance(given, _TableFile):  # it says its dimensions itself
            for parameter, value in (("dims", given.tables[0].dimensions), ("from_", "csv")):
                if options.get(parameter) is None:
                    options[parameter] = value
    return positionals, options


def _named(error: Error, files: _Files) -> Error:
    return type(error)(*map(files.named, error.args))


def call(
    command: str,
    positionals: list[Any],
    options: dict[str, Any],
    echo: Echo | None = None,
    raw: bool = False,
) -> Any:
    """Runs a command. raw: also the bytes that it wrote to standard output."""
    positionals, options = _with_files(positionals, options)
    with _Files() as files:
        words = [command]
        for parameter, value in options.items():
            words += _words(parameter, value, files)
        places = [_positional(place, files) for place in positionals if place is not None]
        if places:
            words += ["--", *places]  # behind it neither -5 nor a file called --json is an option
        names = {encoded(file): encoded(name) for file, name in files.names.items()}
        try:
            outcome, document, output, notes, told = _axiscomp.run(list(map(encoded, words)), echo, names)
        except Error as error:
            raise _named(error, files).with_traceback(error.__traceback__) from None
        document, notes = files.named(document), files.named(notes)
        if not raw:
            output = files.named(output.decode("utf-8", "replace"))
    result = Document(document, outcome, "" if raw else output, notes)
    if told is not None:
        error = _named(told, files)
        error.document = result
        raise error
    return (result, output) if raw else result


def give_warnings(notes: Sequence[str]) -> None:
    """Warnings among notes as those of Python, where the caller of this package stands."""
    here = os.path.dirname(__file__)
    frame, level = sys._getframe(), 1
    while frame.f_back is not None and os.path.dirname(frame.f_code.co_filename) == here:
        frame, level = frame.f_back, level + 1
    for note in notes:
        if note.startswith("warning: ") or ": warning: " in note:
            warnings.warn(note, FileWarning, stacklevel=level)


def with_points(table: Table, filled: Sequence[int]) -> Table:
    """The table whose values at these points were made up."""
    axes = [axis[:4] for axis in table.axes]
    return Table(table.values, axes, table.name, table.unit, table.target, filled, table.notes)


def with_filled(table: Table, said: list[list[int]] | None) -> Table:
    """A CSV file does not say which values were made up; a document does, by indices in each dimension."""
    if not said:
        return table
    strides = [1]
    for axis in table.axes[:-1]:
        strides.append(strides[-1] * axis.size)
    return with_points(table, [sum(i * stride for i, stride in zip(index, strides)) for index in said])


def call_fit(command: str, positionals: list[Any], options: dict[str, Any], echo: Echo | None = None) -> Document:
    """fit; the tables are in the document where the options name no file, and are of one direction or both."""
    if any(options.get(name) is not None for name in ("output", "to")) or options.get("direction") == "both":
        return call(command, positionals, options, echo)
    with _Files() as files:
        file = files.put(b"", "table.csv")
        document = call(command, positionals, {**options, "output": file, "to": "csv"}, echo)
        with open(file, "rb") as stream:
            tables = _axiscomp.tables_of_csv(stream.read(), len(document["table"]["axes"]))
    filled = {column["name"]: column.get("filled") for column in document["columns"]}
    document.tables = [with_filled(table, filled.get(table.name)) for table in tables]
    document["output"] = None
    document.notes = files.named(document.notes)
    document.text = "".join(line for line in document.text.splitlines(True) if file not in line).rstrip("\n") + "\n"
    return document


def flat(values: Any) -> list[Any]:
    """Things, and lists of them, one after the other. An empty list would shift those behind it to another place."""
    if any(isinstance(value, (list, tuple)) and not value for value in values):
        raise RequestError("InvalidArgument", "an empty list is no file and no position")
    things = [element for value in values for element in (value if isinstance(value, (list, tuple)) else [value])]
    if any(thing is None for thing in things):
        raise TypeError("None is no file and no position")
    return things


def one(values: list[Any], what: str) -> Any:
    if len(values) == 1:
        return values[0]
    raise RequestError("InvalidArgument", f"there are {len(values)} {what}, and one is needed: choose one with table=")
