#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the documentation site: HTML that a browser opens from the disk, without a network.

build.py --version V --work FOLDER --output FOLDER --headers FILE. HEADERS has the public headers, one a line.
Any warning of doxygen or Sphinx fails it. Needs the packages of packaging/packages-develop.txt.
"""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

from cpp_pages import CppPages
from pages import Assembly

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ICONS = ROOT / "resources/icons"


def read_headers(headers, work):
    """What doxygen says of the headers; the folder of its XML."""
    xml = work / "xml"
    shutil.rmtree(xml, ignore_errors=True)
    settings = work / "Doxyfile"
    settings.write_text((HERE / "Doxyfile").read_text(encoding="utf-8")
                        + f"OUTPUT_DIRECTORY = \"{work}\"\nSTRIP_FROM_PATH = \"{ROOT}\"\nINPUT = "
                        + " ".join(f'"{h}"' for h in headers) + "\n", encoding="utf-8")
    subprocess.run(["doxygen", settings], check=True, cwd=ROOT)
    return xml


def build(arguments):
    work, output = Path(arguments.work).resolve(), Path(arguments.output).resolve()
    work.mkdir(parents=True, exist_ok=True)
    pages = work / "pages"
    assembly = Assembly(ROOT, pages)
    assembly.run()
    headers = Path(arguments.headers).read_text(encoding="utf-8").split("\n")
    xml = read_headers([h for h in headers if h], work)
    assembly.add_cpp(CppPages(xml, ROOT, assembly.names).pages())
    shutil.copytree(HERE / "static", pages / "static")
    for icon in ("axis-compensation-wizard.svg", "axis-compensation-wizard-32.png"):
        shutil.copyfile(ICONS / icon, pages / icon)
    shutil.copyfile(HERE / "conf.py", pages / "conf.py")
    shutil.rmtree(output, ignore_errors=True)
    # In one process, and from the beginning: the search index has the pages in the order in which
    # they were read.
    subprocess.run(["sphinx-build", "-q", "-W", "--keep-going", "-E", "-b", "html",
                    "-d", work / "doctrees", pages, output],
                   check=True, env={**os.environ, "AXISCOMP_VERSION": arguments.version})
    # What Sphinx keeps for its next run, and for other projects.
    for file in (".buildinfo", "objects.inv"):
        (output / file).unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser()
    for option in ("version", "work", "output", "headers"):
        parser.add_argument("--" + option, required=True)
    missing = [program for program in ("doxygen", "sphinx-build") if not shutil.which(program)]
    if missing:
        sys.exit(f"{' and '.join(missing)} not found: packaging/install-packages.sh packaging/packages-develop.txt")
    try:
        build(parser.parse_args())
    except (ValueError, subprocess.CalledProcessError) as error:
        sys.exit(f"documentation site: {error}")


if __name__ == "__main__":
    main()
