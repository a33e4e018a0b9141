#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes axiscomp/commands.py: each command of axiscomp as a function with its options as keywords.

What the command line has is asked of the module itself, so nothing of it is written down twice. A test compares the file
with what this prints.
    PYTHONPATH=build/run/python python3 -P app/python/make_commands.py > app/python/axiscomp/commands.py
"""

import keyword
import sys
import textwrap

from axiscomp import _axiscomp

WIDTH = 110
HEAD = '''# SPDX-License-Identifier: GPL-3.0-or-later
# Written by make_commands.py of the options of axiscomp.
"""Every command of axiscomp but monitor (Drive.monitor) as a function: the same words, options as keywords.

A hyphen is an underline; from and as are from_ and as_. Where a file is read, a Table (or a list of tables over the
same axes) or a Measurement may stand in its place. Options with several values take a list, KEY=VALUE a dictionary.
echo: is called with what the command says while it works, such as print. Each function raises Error, and releases the
interpreter's lock while it works.
"""

from __future__ import annotations

import os
from typing import Any, Mapping, Sequence, Union

from ._axiscomp import Table
from ._call import Document, Echo, call, call_fit, flat
from .measurements import Measurement

Value = Union[str, int, float, "os.PathLike[str]", None]
Values = Union[Value, Sequence[Any], Mapping[str, Any]]
Source = Union[str, "os.PathLike[str]", Table, Sequence[Table], Measurement]
'''
# Options whose values may be objects in place of a file.
OBJECTS = ("data", "onto", "measured_with")
MAPPINGS = ("tolerance", "columns")
LEFT_OUT = ("--help", "--json")
WITHOUT_END = ("monitor",)  # Drive.monitor hands out its readings one by one


def parameter(name):
    word = name.lstrip("-").lower().replace("-", "_")
    if word == "in":
        return "input"
    return word + "_" if keyword.iskeyword(word) else word


def positional_type(option):
    source = option["name"] in ("FILE", "IN")
    if option["several"]:
        return "Source | Sequence[Source]" if source else "Value | Sequence[Value]"
    return "Source" if source else "Value"


def option_type(option):
    name = parameter(option["name"])
    if not option["takes_value"]:
        return "bool"
    if name in OBJECTS:
        return "Source | None"
    return "Values" if option["several"] or option["delimiter"] or name in MAPPINGS else "Value"


def described(name, option):
    text = option["description"]
    if option["text"]:
        text = f"{option['text']}. {text}"
    return textwrap.fill(f"{name}: {text}", WIDTH, initial_indent="    ", subsequent_indent=" " * 8)


def function(command):
    options = [o for o in command["options"] if not o["positional"] and o["names"] and o["names"][0] not in LEFT_OUT]
    positionals = [o for o in command["options"] if o["positional"]]
    lines = [f"def {parameter(command['name'])}("]
    for option in positionals:
        if option["several"]:
            lines.append(f"    *{parameter(option['name'])}: {positional_type(option)},")
            continue
        end = "" if option["required"] else " | None = None" if "None" not in positional_type(option) else " = None"
        lines.append(f"    {parameter(option['name'])}: {positional_type(option)}{end},")
    if not any(option["several"] for option in positionals):
        lines.append("    *,")
    for option in options:
        default = "None" if option["takes_value"] else "False"
        lines.append(f"    {parameter(option['names'][0])}: {option_type(option)} = {default},")
    lines += ["    echo: Echo | None = None,", ") -> Document:"]
    lines.append(textwrap.fill(f'"""{command["description"]}.', WIDTH, initial_indent="    ", subsequent_indent="    "))
    lines.append("")
    lines += [described(parameter(o["name"]), o) for o in positionals]
    lines += [described(parameter(o["names"][0]), o) for o in options]
    lines.append('    """')
    places = ", ".join(
        f"*flat({parameter(o['name'])})" if o["several"] else parameter(o["name"]) for o in positionals
    )
    names = [parameter(o["names"][0]) for o in options]
    run = "call_fit" if command["name"] == "fit" else "call"
    lines.append(f'    return {run}(')
    lines += [f'        "{command["name"]}",', f"        [{places}],", "        {"]
    lines += [f'            "{name}": {name},' for name in names]
    lines += ["        },", "        echo,", "    )"]
    return "\n".join(lines)


def page():
    commands = [c for c in _axiscomp.commands() if c["name"] not in WITHOUT_END]
    names = ", ".join(f'"{parameter(c["name"])}"' for c in commands)
    every = textwrap.fill(f"__all__ = [{names}]", WIDTH, subsequent_indent="    ")
    return "\n\n\n".join([HEAD + "\n" + every, *map(function, commands)]) + "\n"


if __name__ == "__main__":
    sys.stdout.write(page().replace("\\", "\\\\"))
