# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the code cells of a notebook in one namespace, without a kernel: none of ours has a magic command."""

import json
import os
import signal
import threading


def run(file, stop_before=None, within=540):
    """stop_before: a text; its cell, and what follows, is left out. within: seconds, after which it is stopped as by
    Ctrl-C, so that what it has begun ends too: less than the time that ctest gives a test."""
    with open(file, encoding="utf-8") as stream:
        notebook = json.load(stream)
    assert notebook["nbformat"] == 4
    namespace = {"__name__": "__main__"}
    late = threading.Event()

    def stop():
        late.set()
        os.kill(os.getpid(), signal.SIGINT)

    watch = threading.Timer(within, stop)
    watch.daemon = True
    watch.start()
    try:
        for number, cell in enumerate(notebook["cells"]):
            if cell["cell_type"] != "code":
                continue
            source = "".join(cell["source"])
            if stop_before and stop_before in source:
                break
            exec(compile(source, f"{file}, cell {number}", "exec"), namespace)
    except KeyboardInterrupt as interrupt:
        if late.is_set():
            raise AssertionError(f"cell {number} was not done within {within} s") from interrupt
        raise
    finally:
        watch.cancel()
    return namespace
