# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the code cells of a notebook in one namespace, without a kernel: none of ours has a magic command."""

import json


def run(file, stop_before=None, **names):
    """names: what the cells find beside what they define. stop_before: a text; its cell, and what follows, is left out."""
    with open(file, encoding="utf-8") as stream:
        notebook = json.load(stream)
    assert notebook["nbformat"] == 4
    namespace = {"__name__": "__main__", **names}
    for number, cell in enumerate(notebook["cells"]):
        if cell["cell_type"] != "code":
            continue
        source = "".join(cell["source"])
        if stop_before and stop_before in source:
            break
        exec(compile(source, f"{file}, cell {number}", "exec"), namespace)
    return namespace
