# SPDX-License-Identifier: GPL-3.0-or-later
"""Compensation of measured axis errors in a servo drive.

Tables over numpy arrays (Table, read, write, resample), measurements (Measurement, judge, fit, predict, compare) and
drives (Drive). Every command of the command line `axiscomp` is a function with its options as keywords:
`axiscomp judge x.rtl --tolerance A=10um` is axiscomp.judge("x.rtl", tolerance={"A": "10um"}). See docs/python.md.
"""

from ._axiscomp import Table, __version__
from ._call import Document
from .drives import Drive, Monitor
from .errors import *  # noqa: F401,F403
from .measurements import Measurement, Prediction, predict, read_measurement
from .tables import Axis, read, read_all, resample, write
from .commands import (
    compare,
    convert,
    example,
    fit,
    formats,
    inspect,
    judge,
    lookup,
    report,
    runs,
    targets,
)
