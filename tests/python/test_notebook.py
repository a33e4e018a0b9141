# SPDX-License-Identifier: GPL-3.0-or-later
"""docs/python.ipynb does what it says."""

import os
import tempfile
import unittest
from pathlib import Path

import notebook

SOURCE = Path(os.environ["AXISCOMP_SOURCE"])


class Notebook(unittest.TestCase):
    def test_it_measures_fits_writes_and_plots(self):
        os.environ["MPLBACKEND"] = "Agg"
        folder = tempfile.TemporaryDirectory()  # also for what a cell that fails leaves behind
        self.addCleanup(folder.cleanup)
        self.addCleanup(setattr, tempfile, "tempdir", tempfile.tempdir)
        tempfile.tempdir = folder.name
        state = os.environ.pop("XDG_STATE_HOME", None)
        try:
            ends = notebook.run(SOURCE / "docs/python.ipynb")
        finally:
            os.environ.pop("XDG_STATE_HOME", None)
            if state is not None:
                os.environ["XDG_STATE_HOME"] = state
        before, after = ends["compared"]["before"], ends["compared"]["after"]
        self.assertLess(after["E"], before["E"] / 2)
        # Where the axis stands then the table may be 0, which proves nothing: the measurement does.
        self.assertEqual(ends["activated"]["status"]["state"], "Active")
        self.assertLess(abs(after["E"] - ends["fit"]["predicted"]["E"]), 0.0005)


if __name__ == "__main__":
    unittest.main()
