#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks the plan of the parts core, drivecomm, ui and app against every #include.

Each part has a README.md with a table of its folders, from top to ground. A folder includes only what
stands below it there; what one part may include of another is in PARTS and in the lists of HEADERS in
CMakeLists.txt. Nothing but the profile spells a register either. Prints one sentence for each fault,
FILE:LINE first as compilers do, and fails if there is one. --self-test builds small trees with one fault
each and looks whether every fault is found.
"""

import os
import re
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

# Each part and the parts it may include.
PARTS = {
    "core": (),
    "drivecomm": ("core",),
    "ui": ("core",),
    "app": ("core", "drivecomm", "ui"),
}
WITHOUT_QT = ("core",)
MOST_FILES = 40

SOURCES = (".cpp", ".h", ".cpp.in", ".h.in")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
QT_HEADER = re.compile(r"(Q[A-Z]\w*|Qt\w*/.*|q[a-z]+\.h)$")
GENERATED = re.compile(r"(.*\.moc|moc_.*\.cpp|ui_.*\.h)$")
# What a register's path looks like in a string. The profile spells registers; so does what is a drive
# itself, and the help of a program, by way of example.
REGISTER = re.compile(r'"[^"]*(Axes\[|\b(Signals|Parameters|Commands)/)[^"]*"')
MAY_SPELL_REGISTERS = ("drivecomm/virtualdrive", "app")
# The table of folders in a README.md begins with this line. The first cell of a row has one name in
# backticks, or several that stand beside each other.
HEADING = re.compile(r"\|\s*folder\s*\|")
NAME = re.compile(r"`([^`]+)`")
# What names source files in a CMakeLists.txt.
COMMANDS = ("axiscomp_add_sources", "target_sources", "add_executable", "add_library")


class Tree:
    """What stands on disk below one root, and the faults found in it."""

    def __init__(self, root):
        self.root = Path(root)
        self.faults = []
        self.files = {}  # folder -> names of all its files
        for part in PARTS:
            for folder, subfolders, names in os.walk(self.root / part):
                subfolders[:] = sorted(s for s in subfolders if not s.startswith((".", "__")))
                relative = Path(folder).relative_to(self.root).as_posix()
                self.files[relative] = sorted(n for n in names if not n.startswith("."))

    def fault(self, path, line, sentence):
        self.faults.append(f"{path}:{line}: {sentence}")

    def text(self, path):
        return (self.root / path).read_text(encoding="utf-8", errors="replace")

    def check(self):
        self.levels = {}  # folder -> place in the list of its part, 0 is the top
        for part in PARTS:
            self.read_list(part)
        self.public = set()
        self.read_cmake_lists()
        self.read_includes()
        for file, line, included in self.includes:
            self.check_include(file, line, included)
        self.check_circles()
        self.check_folders()
        return self.faults

    def read_list(self, part):
        readme = f"{part}/README.md"
        if not (self.root / readme).is_file():
            self.fault(readme, 1, f"is missing. It lists the folders of {part} from top to ground, "
                       "in a table whose first column is the folder in backticks.")
            return
        rows = []
        in_table = False
        for number, line in enumerate(self.text(readme).splitlines(), 1):
            in_table = line.startswith("|") and (in_table or bool(HEADING.match(line)))
            if in_table:
                rows.append((number, NAME.findall(line.split("|")[1])))
        for level, (number, names) in enumerate(rows):
            for name in names:
                folder = part if name == "." else f"{part}/{name.rstrip('/')}"
                if folder in self.levels:
                    self.fault(readme, number, f"lists {folder} a second time. Leave one of the two.")
                elif not self.has_sources(folder):
                    self.fault(readme, number, f"lists {folder}, but no source file stands there. "
                               "Take it out of the list, or correct the name.")
                self.levels.setdefault(folder, level)
        for folder in self.folders_of(part):
            if self.has_sources(folder) and folder not in self.levels:
                self.fault(readme, 1, f"does not list {folder}. Add a row at the place that its "
                           "includes allow: below all that include it, above all that it includes.")

    def folders_of(self, part):
        return [f for f in self.files if f == part or f.startswith(part + "/")]

    def has_sources(self, folder):
        return any(name.endswith(SOURCES) for name in self.files.get(folder, ()))

    def read_cmake_lists(self):
        self.listed = defaultdict(set)
        for folder in self.files:
            path = f"{folder}/CMakeLists.txt"
            if "CMakeLists.txt" not in self.files[folder]:
                continue
            last = command = ""
            in_headers = False
            for number, line in enumerate(self.text(path).splitlines(), 1):
                for word in re.findall(r"[^\s()\"]+|[()]", line.partition("#")[0]):
                    if word == "(":
                        command, in_headers = last, False
                    elif word in ("HEADERS", "SOURCES", "POSIX", "WINDOWS", "DRIVES"):
                        in_headers = word == "HEADERS"
                    elif command in COMMANDS and re.fullmatch(r"[\w.-]+\.(cpp|h)", word):
                        self.listed[folder].add(word)
                        if in_headers:
                            self.public.add(f"{folder}/{word}")
                        if word not in self.files[folder]:
                            self.fault(path, number, f"names {word}, which is not in {folder}. Take "
                                       "the line out, or correct the name.")
                    last = word

    def read_includes(self):
        self.includes = []
        self.included = set()
        for folder, names in self.files.items():
            for name in names:
                if not name.endswith(SOURCES):
                    continue
                path = f"{folder}/{name}"
                for number, line in enumerate(self.text(path).splitlines(), 1):
                    if not path.startswith(MAY_SPELL_REGISTERS) and REGISTER.search(line.partition("//")[0]):
                        self.fault(path, number, "spells a register. Take its path from the profile "
                                   "(core/drive/drive_profile.h).")
                    found = INCLUDE.match(line)
                    if found:
                        self.includes.append((path, number, found.group(2)))
                        self.included.add(found.group(2))

    def check_include(self, file, line, included):
        folder = os.path.dirname(file)
        part = folder.split("/")[0]
        if part in WITHOUT_QT and QT_HEADER.match(included):
            self.fault(file, line, f"includes {included}, but {part} knows no Qt. Use the standard "
                       "library, or do it in ui or drivecomm.")
            return
        target_part = included.split("/")[0]
        if target_part == "tests" and "/" in included:
            self.fault(file, line, f"includes {included}, but the product knows no tests. Pass in "
                       "what the test wants to replace.")
            return
        if target_part not in PARTS or "/" not in included:
            if (self.root / folder / included).is_file() and not GENERATED.match(included):
                self.fault(file, line, f"includes {included} without its folder. Write it as "
                           f"\"{os.path.normpath(folder + '/' + included)}\".")
            return
        target = os.path.dirname(included)
        if not (self.root / included).is_file():
            self.fault(file, line, f"includes {included}, but there is no such file. Write the path "
                       "from the root of the repository.")
        elif target_part != part:
            if target_part not in PARTS[part]:
                may = " and ".join(PARTS[part]) if PARTS[part] else "no other part"
                self.fault(file, line, f"includes {included}, but {part} includes {may}. Put what "
                           "both need into core, or let app pass it in.")
            elif included not in self.public:
                self.fault(file, line, f"includes {included}, which is private to {target_part}. "
                           f"List it under HEADERS in {target}/CMakeLists.txt if it belongs to what "
                           f"{target_part} offers, or use a header that is listed.")
        elif file in self.public and included not in self.public:
            self.fault(file, line, f"includes {included}, which is private to {part}, but is offered to "
                       f"others itself, who cannot compile it when it is installed. List {name_of(included)} "
                       f"under HEADERS in {target}/CMakeLists.txt, or do without it in a header.")
        elif target != folder and target in self.levels and folder in self.levels:
            place = "above" if self.levels[target] < self.levels[folder] else "beside"
            if self.levels[target] <= self.levels[folder]:
                self.fault(file, line, f"includes {included}, but {target} stands {place} {folder} in "
                           f"{part}/README.md. Move what {name_of(file)} needs to a folder below both, "
                           f"or {name_of(file)} to one above {target}.")

    def check_circles(self):
        """Folders that include each other, also by way of others: the shortest circle of each."""
        arrows = defaultdict(dict)
        for file, line, included in self.includes:
            here, there = os.path.dirname(file), os.path.dirname(included)
            if here != there and there in self.files and (self.root / included).is_file():
                arrows[here].setdefault(there, (file, line, included))
        told = set()
        for start in sorted(arrows):
            circle = shortest_way(arrows, start)
            if not circle or told & set(circle):
                continue
            told.update(circle)
            while not self.goes_up(circle[0], circle[1]):  # the arrow to blame first
                circle.append(circle.pop(0))
            steps = [arrows[a][b] for a, b in zip(circle, circle[1:] + circle[:1])]
            ways = "; ".join(f"{file}:{line} includes {included}" for file, line, included in steps)
            file, line, _ = steps[0]
            self.fault(file, line, f"closes a circle of folders, {' -> '.join(circle + [circle[0]])} "
                       f"({ways}). Move one of these files, or what it needs, until one arrow is gone.")

    def goes_up(self, here, there):
        """Parts stand above those that they may include; of two unknown folders any may be to blame."""
        part, target_part = here.split("/")[0], there.split("/")[0]
        if part != target_part:
            return target_part not in PARTS[part]
        return self.levels.get(here, sys.maxsize) >= self.levels.get(there, 0)

    def check_folders(self):
        for folder, names in self.files.items():
            if len(names) > MOST_FILES:
                self.fault(folder, 1, f"has {len(names)} files of its own, more than {MOST_FILES}. "
                           "Find the two ideas in it and give each a folder.")
            for name in names:
                path = f"{folder}/{name}"
                if name.endswith(".cpp") and name not in self.listed[folder]:
                    self.fault(path, 1, f"is not in {folder}/CMakeLists.txt, so nothing compiles it. "
                               "Add it under SOURCES, or delete it.")
                elif name.endswith(".h") and path not in self.public and path not in self.included:
                    self.fault(path, 1, f"is not in {folder}/CMakeLists.txt and no file includes it. "
                               "Add it under HEADERS if other parts need it, or delete it.")


def name_of(path):
    return os.path.basename(path)


def shortest_way(arrows, start):
    """The folders of the shortest circle through start, beginning with it; empty if there is none."""
    ways = [[start]]
    seen = {start}
    for way in ways:
        for there in sorted(arrows.get(way[-1], ())):
            if there == start:
                return way
            if there not in seen:
                seen.add(there)
                ways.append(way + [there])
    return []


# A tree in which everything is right.
CLEAN = {
    "core/README.md": "# core\n\n| folder | about |\n|---|---|\n| `top` | the service |\n"
                      "| `side/a`, `side/b` | two formats |\n| `ground` | values |\n\n"
                      "| question | look into |\n|---|---|\n| `what`? | `nowhere` |\n",
    "core/CMakeLists.txt": "add_subdirectory(top) # not_a_file.cpp\n",
    "core/top/CMakeLists.txt": "axiscomp_add_sources(core\n  HEADERS\n    service.h\n  SOURCES\n    service.cpp)\n",
    "core/top/service.h": "#include \"core/ground/value.h\"\n#include <vector>\n",
    "core/top/service.cpp": "#include \"core/top/service.h\"\n#include \"core/top/hidden.h\"\n",
    "core/top/hidden.h": "#include \"core/side/a/a.h\"\n",
    "core/side/a/CMakeLists.txt": "axiscomp_add_sources(core SOURCES a.cpp)\n",
    "core/side/a/a.h": "#include \"core/ground/value.h\"\n",
    "core/side/a/a.cpp": "#include \"core/side/a/a.h\"\n",
    "core/side/b/CMakeLists.txt": "axiscomp_add_sources(core SOURCES b.cpp)\n",
    "core/side/b/b.cpp": "const char* text = \"#include <QString>\";\n",
    "core/ground/CMakeLists.txt": "axiscomp_add_sources(core\n  HEADERS value.h\n  SOURCES value.cpp)\n",
    "core/ground/value.h": "#include <qualified>\n",
    "core/ground/value.cpp": "#include \"core/ground/value.h\"\n",
    "drivecomm/README.md": "# drivecomm\n\n| folder | about |\n|---|---|\n| `.` | links |\n",
    "drivecomm/CMakeLists.txt": "axiscomp_add_sources(drivecomm\n  HEADERS link.h\n  SOURCES link.cpp)\n",
    "drivecomm/link.h": "#include \"core/top/service.h\"\n",
    "drivecomm/link.cpp": "#include \"drivecomm/link.h\"\n#include <QString>\n",
    "ui/README.md": "# ui\n\n| folder | about |\n|---|---|\n| `.` | the window |\n",
    "ui/CMakeLists.txt": "axiscomp_add_sources(ui HEADERS page.h SOURCES page.cpp)\n",
    "ui/page.h": "#include <QWidget>\n",
    "ui/page.cpp": "#include \"ui/page.h\"\n#include \"core/ground/value.h\"\n#include \"page.moc\"\n",
    "app/README.md": "# app\n\n| folder | about |\n|---|---|\n| `wizard` | the program |\n",
    "app/wizard/CMakeLists.txt": "add_executable(wizard main.cpp)\n",
    "app/wizard/main.cpp": "#include \"ui/page.h\"\n#include \"drivecomm/link.h\"\n",
}

# What is changed in it (a file and its new text, None: deleted), and the fault that must be found.
FAULTS = {
    "a folder includes one above it": (
        {"core/ground/value.cpp": "\n#include \"core/top/service.h\"\n"},
        "core/ground/value.cpp:2: includes core/top/service.h, but core/top stands above core/ground"),
    "a folder includes one beside it": (
        {"core/side/b/b.cpp": "#include \"core/side/a/a.h\"\n"},
        "core/side/b/b.cpp:1: includes core/side/a/a.h, but core/side/a stands beside core/side/b"),
    "a circle": (
        {"core/ground/value.cpp": "#include \"core/side/a/a.h\"\n"},
        "circle of folders, core/ground -> core/side/a -> core/ground"),
    "a folder that the list lacks": (
        {"core/new/CMakeLists.txt": "axiscomp_add_sources(core SOURCES n.cpp)\n", "core/new/n.cpp": ""},
        "core/README.md:1: does not list core/new"),
    "a folder of the list that is gone": (
        {"core/README.md": CLEAN["core/README.md"].replace("| `ground`", "| `gone` | nothing |\n| `ground`")},
        "core/README.md:7: lists core/gone, but no source file stands there"),
    "a folder listed twice": (
        {"core/README.md": CLEAN["core/README.md"].replace("| `ground`", "| `top` | again |\n| `ground`")},
        "core/README.md:7: lists core/top a second time"),
    "no list": ({"ui/README.md": None}, "ui/README.md:1: is missing"),
    "a private header of another part": (
        {"ui/page.cpp": "#include \"core/top/hidden.h\"\n"},
        "ui/page.cpp:1: includes core/top/hidden.h, which is private to core"),
    "a public header includes a private one": (
        {"core/top/service.h": "#include \"core/top/hidden.h\"\n"},
        "core/top/service.h:1: includes core/top/hidden.h, which is private to core, but is offered"),
    "a register is spelled outside the profile": (
        {"core/ground/value.cpp": "// \"Axes[0]/\"\nauto path = \"Axes[0]/Signals/State\";\n"},
        "core/ground/value.cpp:2: spells a register"),
    "core includes Qt": (
        {"core/ground/value.cpp": "#include <QtCore/QString>\n"},
        "core/ground/value.cpp:1: includes QtCore/QString, but core knows no Qt"),
    "core includes another part": (
        {"core/ground/value.cpp": "#include \"drivecomm/link.h\"\n"},
        "core/ground/value.cpp:1: includes drivecomm/link.h, but core includes no other part"),
    "ui includes drivecomm": (
        {"ui/page.cpp": "#include \"drivecomm/link.h\"\n"},
        "ui/page.cpp:1: includes drivecomm/link.h, but ui includes core"),
    "drivecomm includes ui": (
        {"drivecomm/link.cpp": "#include \"ui/page.h\"\n"},
        "drivecomm/link.cpp:1: includes ui/page.h, but drivecomm includes core"),
    "the product includes a test": (
        {"ui/page.cpp": "#include \"tests/support/verify.h\"\n"},
        "ui/page.cpp:1: includes tests/support/verify.h, but the product knows no tests"),
    "a header without its folder": (
        {"core/top/hidden.h": "#include \"service.h\"\n"},
        "core/top/hidden.h:1: includes service.h without its folder"),
    "a header that is not there": (
        {"core/top/hidden.h": "#include \"core/top/servise.h\"\n"},
        "core/top/hidden.h:1: includes core/top/servise.h, but there is no such file"),
    "too many files in a folder": (
        {f"app/wizard/file{number}.txt": "" for number in range(MOST_FILES)},
        f"app/wizard:1: has {MOST_FILES + 2} files of its own"),
    "a source that nothing compiles": (
        {"core/top/lost.cpp": ""}, "core/top/lost.cpp:1: is not in core/top/CMakeLists.txt"),
    "a header that nothing lists or includes": (
        {"core/top/lost.h": ""}, "core/top/lost.h:1: is not in core/top/CMakeLists.txt"),
    "a listed file that is not there": (
        {"core/side/a/CMakeLists.txt": "axiscomp_add_sources(core SOURCES a.cpp\n b.cpp)\n"},
        "core/side/a/CMakeLists.txt:2: names b.cpp, which is not in core/side/a"),
}


def faults_of(files):
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            if text is not None:
                file = Path(folder, path)
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
        return Tree(folder).check()


def self_test():
    failures = []
    found = faults_of(CLEAN)
    if found:
        failures.append("a tree in which everything is right:\n  " + "\n  ".join(found))
    for name, (changes, expected) in FAULTS.items():
        found = faults_of({**CLEAN, **changes})
        if not any(expected in sentence for sentence in found):
            failures.append(f"{name}: not found\n  " + "\n  ".join(found))
    for failure in failures:
        print(failure, file=sys.stderr)
    print(f"{len(FAULTS)} kinds of fault, {len(failures)} failures")
    return 1 if failures else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if len(sys.argv) > 1:
        print("usage: check_includes.py [--self-test]", file=sys.stderr)
        return 2
    tree = Tree(Path(__file__).resolve().parents[2])
    faults = tree.check()
    for sentence in faults:
        print(sentence, file=sys.stderr)
    if faults:
        print(f"{len(faults)} faults in the structure; docs/architecture.md, \"The rule\", says why",
              file=sys.stderr)
        return 1
    print(f"{sum(map(len, tree.files.values()))} files in {len(tree.levels)} folders, "
          f"{len(tree.includes)} includes: all in order")
    return 0


if __name__ == "__main__":
    sys.exit(main())
