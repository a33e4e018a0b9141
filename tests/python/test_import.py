# SPDX-License-Identifier: GPL-3.0-or-later
"""What an import costs, in processor time: others may be at work beside it."""

import os
import subprocess
import sys
import unittest

PROBE = """
import sys, time
begin = time.process_time()
import axiscomp
print(time.process_time() - begin)
assert "numpy" not in sys.modules
"""


class Import(unittest.TestCase):
    def test_an_import_is_quick_and_leaves_numpy_for_later(self):
        times = [
            float(subprocess.run([sys.executable, "-c", PROBE], capture_output=True, text=True, check=True).stdout)
            for _ in range(5)
        ]
        print("import takes", min(times), "s")
        if not os.environ.get("AXISCOMP_IS_SANITIZED"):
            self.assertLess(min(times), 0.060)


if __name__ == "__main__":
    unittest.main()
