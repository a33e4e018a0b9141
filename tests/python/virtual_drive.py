# SPDX-License-Identifier: GPL-3.0-or-later
"""A virtual drive as a process of its own."""

import os
import re
import subprocess


class VirtualDrive:
    """with VirtualDrive("--machine", file) as endpoint: ..."""

    def __init__(self, *arguments):
        self._arguments = list(map(str, arguments))

    def __enter__(self):
        environment = {key: value for key, value in os.environ.items() if key != "LD_PRELOAD"}
        self._process = subprocess.Popen(
            [os.environ["AXISCOMP_VIRTUALDRIVE"], *self._arguments],
            stdout=subprocess.PIPE,
            text=True,
            env=environment,
        )
        ready = self._process.stdout.readline()
        return re.search(r"http=(\S+)", ready).group(1)

    def __exit__(self, *_):
        self._process.terminate()
        self._process.wait(60)
        self._process.stdout.close()
