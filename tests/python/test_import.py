# SPDX-License-Identifier: GPL-3.0-or-later
"""What an import loads, which is what it costs; tests/bench/compare.sh measures the time."""

import json
import subprocess
import sys
import unittest

PROBE = """
import sys
before = set(sys.modules)
import axiscomp
loaded = sorted(set(sys.modules) - before)
import json, re
with open("/proc/self/maps") as maps:
    qt = sorted(set(re.findall(r"libQt6([A-Za-z]+)", maps.read())))
print(json.dumps([loaded, qt]))
"""


class Import(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        # Without site (-S), which loads modules of its own that ours would then not be seen to need.
        probe = [sys.executable, "-P", "-S", "-c", PROBE]
        cls.loaded, cls.qt = json.loads(subprocess.run(probe, capture_output=True, text=True, check=True).stdout)

    def test_an_import_loads_nothing_but_the_standard_library(self):
        foreign = {name.split(".")[0] for name in self.loaded} - sys.stdlib_module_names
        self.assertEqual(foreign, {"axiscomp"}, "numpy is loaded when the first array is made")

    def test_an_import_loads_few_modules(self):
        self.assertLessEqual(len(self.loaded), 60, self.loaded)

    def test_an_import_loads_no_window(self):
        self.assertEqual(self.qt, ["Core", "Network", "SerialPort"])


if __name__ == "__main__":
    unittest.main()
