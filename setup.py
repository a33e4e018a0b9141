# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the Python package with CMake. AXISCOMP_BUILD: a build folder to go on with, in place of a new one."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, extension):
        folder = Path(os.environ.get("AXISCOMP_BUILD") or self.build_temp).resolve()
        subprocess.run(
            [
                "cmake", "-S", ROOT, "-B", folder, "-DAXISCOMP_PYTHON=ON", f"-DPython3_EXECUTABLE={sys.executable}",
                *([] if "AXISCOMP_BUILD" in os.environ else [
                    "-DCMAKE_BUILD_TYPE=Release", "-DAXISCOMP_WINDOW=OFF", "-DBUILD_TESTING=OFF",
                    "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=10",
                    *(["-GNinja"] if shutil.which("ninja") else []),
                ]),
            ],
            check=True,
        )
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL") or str(os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", folder, "--target", "axiscomp_python", "--parallel", jobs], check=True)
        place = Path(self.get_ext_fullpath(extension.name))
        place.parent.mkdir(parents=True, exist_ok=True)
        (built,) = (folder / "python/axiscomp").glob("_axiscomp.*.so")
        shutil.copy(built, place)


setup(
    version=re.search(r"project\(AxisCompensationWizard VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text()).group(1),
    packages=["axiscomp"],
    package_dir={"axiscomp": "app/python/axiscomp"},
    package_data={"axiscomp": ["py.typed", "*.pyi"]},
    ext_modules=[Extension("axiscomp._axiscomp", [])],
    cmdclass={"build_ext": CMakeBuild},
)
