#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the tests find faults.

Each entry of faults/*.toml is a fault: a piece of a source file and what a mistake would have made of it.
All of them are built into one set of test programs, each behind a switch (AXISCOMP_FAULT=NUMBER), so that
one build serves all. A fault that none of its tests finds is an error, and so is one whose piece is not in
the source any more.

    mutation.py                  builds, runs the tests of every fault
    mutation.py NAME ...         of these faults only
    mutation.py --check          builds nothing: are the pieces and the tests still there?
    mutation.py --self-test      does this script notice what it has to?

An entry has
    name      for the table and the command line
    file      below core or drivecomm
    rule      what the fault breaks, as a sentence
    original  the piece: whole statements, or an expression. How blanks and lines are set does not matter.
    within    a longer piece around it, where the piece alone stands several times
    faulty    what is there instead; may be empty for statements
    tests     the tests of ctest that are to find it, in the order in which they are tried
"""

import argparse
import concurrent.futures
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
MUTATED = ("core", "drivecomm")
SWITCH = "AXISCOMP_FAULT"
HEADER = "fault_switch.h"
HEADER_TEXT = f"""#pragma once
#include <cstdlib>
namespace axiscomp::mutation {{
inline bool on(int fault)
{{
    static const int chosen = [] {{
        const char* const text = std::getenv("{SWITCH}");
        return text == nullptr ? 0 : std::atoi(text);
    }}();
    return fault == chosen;
}}
}}
"""
STATEMENT = re.compile(r"\s*(if|for|while|switch|return)\b")
OPERATOR_FIRST = re.compile(r"\s*(\|\||&&|\*\s|[?:,=<>%/.)}{]|->)")
OPERATOR_LAST = re.compile(r"(\|\||&&|[?:,=<>%/.(+*!-])\s*$")
FAILURE = b"\nFAIL!"  # of Qt Test
PATIENCE = 60  # seconds for one test, and so many times of what it takes without a fault:
PATIENCE_FACTOR = 30  # a fault that makes it hang is found, a busy machine finds none


class Wrong(Exception):
    """The list, or the sources that it is about, must be corrected first."""


@dataclass
class Fault:
    name: str
    file: str
    rule: str
    original: str
    faulty: str
    tests: list
    within: str = ""
    number: int = 0
    begin: int = 0  # in the text of the file
    end: int = 0


def load(root):
    faults = []
    for path in sorted((root / "tests/mutation/faults").glob("*.toml")):
        with path.open("rb") as stream:
            entries = tomllib.load(stream).get("fault", [])
        for entry in entries:
            try:
                faults.append(Fault(**entry))
            except TypeError as error:
                raise Wrong(f"{path.name}: {entry.get('name', 'an entry')}: {error}") from error
    for number, fault in enumerate(faults, 1):
        fault.number = number
    return faults


def places(piece, text):
    pattern = r"\s+".join(re.escape(word) for word in piece.split())
    return [match.span() for match in re.finditer(pattern, text)]


def locate(fault, text):
    """Sets where the piece stands; a sentence when it does not, or more than once."""
    begin, end = 0, len(text)
    for piece in filter(None, (fault.within, fault.original)):
        found = places(piece, text[begin:end])
        if len(found) != 1:
            often = "is not there" if not found else f"stands {len(found)} times"
            return f"{fault.name}: in {fault.file} this {often}: {' '.join(piece.split())}"
        begin, end = begin + found[0][0], begin + found[0][1]
    fault.begin, fault.end = begin, end
    return None


def is_block(fault):
    return bool(STATEMENT.match(fault.original)) or fault.original.rstrip().endswith(";")


def is_statement(fault, text):
    """Whether what stands there can be put in a block: it ends a statement and begins one."""
    before = re.sub(r"//[^\n]*", "", text[:fault.begin]).rstrip()
    return fault.original.rstrip().endswith(";") and before.endswith((";", "{", "}", ")", ":", "else"))


def is_expression(fault, text):
    """Whether what stands there can be put in brackets: no part of a name, a call or an operation."""
    piece = text[fault.begin:fault.end]
    return not (re.match(r"\w\w|\w\(", text[fault.end - 1:fault.end + 1])
                or re.match(r"\w\w", text[max(fault.begin - 1, 0):fault.begin + 1])
                or OPERATOR_FIRST.match(piece) or OPERATOR_LAST.search(piece)
                or any(piece.count(one) != piece.count(other) for one, other in ("()", "[]", "{}")))


def problems_of(root, faults):
    problems = []
    for name in {fault.name for fault in faults}:
        if sum(fault.name == name for fault in faults) > 1:
            problems.append(f"{name}: there are several faults of this name")
    known = {path.stem for path in (root / "tests").rglob("tst_*.cpp")}
    for fault in faults:
        path = root / fault.file
        if not path.is_file() or path.relative_to(root).parts[0] not in MUTATED:
            problems.append(f"{fault.name}: there is no file {fault.file}")
        elif problem := locate(fault, text := path.read_text(encoding="utf-8")):
            problems.append(problem)
        elif not (is_statement(fault, text) if is_block(fault) else is_expression(fault, text)):
            problems.append(f"{fault.name}: a piece is whole statements or an expression: {fault.original}")
        if not fault.tests:
            problems.append(f"{fault.name}: it has no tests")
        problems += [f"{fault.name}: there is no test {test}" for test in fault.tests if test not in known]
    return problems


def switched(fault, original):
    chosen = f"::axiscomp::mutation::on({fault.number})"
    if is_block(fault):
        return f"{{ if ({chosen}) {{ {fault.faulty} }} else {{ {original} }} }}"
    return f"({chosen} ? ({fault.faulty}) : ({original}))"


def mutated(text, faults):
    """The text with every fault behind its switch; one piece may hold another."""
    ordered = sorted(faults, key=lambda fault: (fault.begin, -fault.end))

    def render(begin, end, inner):
        result, at = "", begin
        while inner:
            outer = inner[0]
            nested = [fault for fault in inner[1:] if fault.begin < outer.end]
            if crossing := [fault for fault in nested if fault.end > outer.end]:
                raise Wrong(f"{outer.name} and {crossing[0].name} overlap")
            result += text[at:outer.begin] + switched(outer, render(outer.begin, outer.end, nested))
            at, inner = outer.end, inner[1 + len(nested):]
        return result + text[at:end]

    return f'#include "{HEADER}"\n#line 1\n' + render(0, len(text), ordered)


def write_if_other(path, text):
    """A file that stays as it is need not be compiled again."""
    if not path.is_file() or path.read_text(encoding="utf-8") != text:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def prepare(root, copy, faults):
    """A checkout in which core and drivecomm have the faults; everything else is that of root."""
    copy.mkdir(parents=True, exist_ok=True)
    for entry in root.iterdir():
        link = copy / entry.name
        if entry.name not in (*MUTATED, "build", ".git") and not link.exists():
            link.symlink_to(entry)
    write_if_other(copy / HEADER, HEADER_TEXT)
    of_file = {}
    for fault in faults:
        of_file.setdefault(fault.file, []).append(fault)
    wanted = set()
    for part in MUTATED:
        for source in (root / part).rglob("*"):
            if source.is_file():
                path = str(source.relative_to(root))
                text = source.read_text(encoding="utf-8")
                write_if_other(copy / path, mutated(text, of_file[path]) if path in of_file else text)
                wanted.add(copy / path)
        for made in (copy / part).rglob("*"):
            if made.is_file() and made not in wanted:
                made.unlink()


def build(copy, folder):
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    linker = ["-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=mold"] if shutil.which("mold") else []
    for command in (["cmake", "--preset", "mutation", "-B", folder, *launcher, *linker],
                    ["cmake", "--build", folder, "--", "-k", "0"]):
        subprocess.run(command, cwd=copy, check=True)


@dataclass
class Test:
    command: list
    folder: str
    environment: dict = field(default_factory=dict)
    patience: float = 3600.0


def tests_in(folder):
    listed = subprocess.run(["ctest", "--show-only=json-v1"], cwd=folder, check=True, capture_output=True)
    tests = {}
    for test in json.loads(listed.stdout)["tests"]:
        if "command" not in test:  # its program is not built
            continue
        of = {each["name"]: each["value"] for each in test.get("properties", [])}
        environment = dict(line.split("=", 1) for line in of.get("ENVIRONMENT", []))
        tests[test["name"]] = Test(test["command"], of.get("WORKING_DIRECTORY", str(folder)), environment)
    return tests


def ends_well(process, patience, said):
    """Whether a test ends within its time and well. It has not when it says so: Qt Test goes on with the
    next function then, and a fault can make each of them wait."""
    end = time.monotonic() + patience
    last = b"\n"
    while time.monotonic() < end:
        try:
            return process.wait(0.2) == 0
        except subprocess.TimeoutExpired:
            last = last[-len(FAILURE):] + said.read()
            if FAILURE in last:
                return False
    return False


def passes(test, number, log):
    """Whether a test passes with a fault switched on; number 0: none."""
    environment = {**os.environ, **test.environment, SWITCH: str(number)}
    with log.open("wb") as stream, log.open("rb") as said:
        process = subprocess.Popen(test.command, cwd=test.folder, env=environment, stdin=subprocess.DEVNULL,
                                   stdout=stream, stderr=subprocess.STDOUT, start_new_session=True)
        try:
            return ends_well(process, test.patience, said)
        finally:
            # also what the test has started
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            process.wait()


def passes_clean(test, log):
    begin = time.monotonic()
    good = passes(test, 0, log)
    test.patience = PATIENCE + PATIENCE_FACTOR * (time.monotonic() - begin)
    return good


def finder(fault, tests, logs):
    """The name of the first test that finds the fault, and the seconds that it took."""
    begin = time.monotonic()
    for name in fault.tests:
        if not passes(tests[name], fault.number, logs / f"{fault.name}.{name}.log"):
            return name, time.monotonic() - begin
    return None, time.monotonic() - begin


def run(root, folder, chosen):
    faults = load(root)
    if problems := problems_of(root, faults):
        raise Wrong("\n".join(problems))
    prepare(root, folder / "source", faults)
    build(folder / "source", folder / "build")
    tests = tests_in(folder / "build")
    selected = [fault for fault in faults if not chosen or fault.name in chosen]
    if unknown := set(chosen) - {fault.name for fault in faults}:
        raise Wrong(f"there is no fault {', '.join(sorted(unknown))}")
    needed = sorted({test for fault in selected for test in fault.tests})
    if missing := [name for name in needed if name not in tests]:
        raise Wrong(f"there is no test {', '.join(missing)} in this build")
    logs = folder / "log"
    shutil.rmtree(logs, ignore_errors=True)
    logs.mkdir(parents=True)

    survivors = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        clean = pool.map(lambda name: passes_clean(tests[name], logs / f"none.{name}.log"), needed)
        if failed := [name for name, good in zip(needed, clean) if not good]:
            raise Wrong(f"without any fault these fail, see {logs}/none.*: {', '.join(failed)}")
        for fault, (name, seconds) in zip(selected, pool.map(lambda f: finder(f, tests, logs), selected)):
            print(f"{fault.number:4}  {fault.name:44} {name or 'NOT FOUND':24} {seconds:6.1f} s", flush=True)
            if not name:
                survivors.append(fault)
    for fault in survivors:
        print(f"\nNo test finds {fault.name} ({fault.file}): {fault.rule}", file=sys.stderr)
    print(f"{len(selected)} faults, {len(selected) - len(survivors)} found, {len(survivors)} not")
    return 1 if survivors else 0


SAMPLE = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.25)
project(sample LANGUAGES CXX)
enable_testing()
add_executable(sample tests/tst_sample.cpp core/sample.cpp)
target_include_directories(sample PRIVATE ${PROJECT_SOURCE_DIR})
add_test(NAME tst_sample COMMAND sample)
""",
    "CMakePresets.json": '{"version": 6, "configurePresets": [{"name": "mutation", "generator": "Ninja"}]}\n',
    "core/sample.h": "int half(int number);\nbool isEven(int number);\n",
    "core/sample.cpp": """#include "core/sample.h"
int half(int number)
{
    return number /
        2;
}
bool isEven(int number)
{
    if (number < 0)
        return isEven(-number);
    return half(number) * 2 == number;
}
""",
    "tests/tst_sample.cpp": '#include "core/sample.h"\nint main() { return half(8) == 4 && isEven(2) && !isEven(3) ? 0 : 1; }\n',
}
FOUND = {"name": "third", "file": "core/sample.cpp", "rule": "Half is half.", "original": "number / 2",
         "faulty": "number / 3", "tests": ["tst_sample"]}
SAMPLES = {
    "faults that are found": ([FOUND, {**FOUND, "name": "never", "original": "return half(number) * 2 == number;",
                                       "faulty": "return false;"},
                               {**FOUND, "name": "inner", "within": "return half(number) * 2 == number",
                                "original": "half(number)", "faulty": "number"}], 0, "3 faults, 3 found, 0 not"),
    "a test that goes on after it has failed": ([{**FOUND, "tests": ["tst_slow"]}], 0, "1 faults, 1 found, 0 not"),
    "a fault that nothing finds": ([FOUND, {**FOUND, "name": "negative", "original": "isEven(-number)",
                                            "faulty": "true"}], 1, "No test finds negative"),
    "a line that is gone": ([{**FOUND, "original": "number / 4"}], 2, "this is not there: number / 4"),
    "a line that stands twice": ([{**FOUND, "original": "half"}], 2, "this stands 2 times: half"),
    "a file that is gone": ([{**FOUND, "file": "core/other.cpp"}], 2, "there is no file core/other.cpp"),
    "a test that does not exist": ([{**FOUND, "tests": ["tst_other"]}], 2, "there is no test tst_other"),
    "a condition with its keyword": ([{**FOUND, "original": "if (number < 0)", "faulty": "if (number > 0)"}], 2,
                                     "whole statements or an expression: if (number < 0)"),
    "a part of an operation": ([{**FOUND, "original": "* 2 == number", "faulty": "* 3 == number"}], 2,
                               "whole statements or an expression: * 2 == number"),
    "the name of a call": ([{**FOUND, "original": "half(number) * 2", "within": "half(number) * 2",
                             "name": "call"}, {**FOUND, "within": "isEven(-number)", "original": "isEven",
                                               "faulty": "half"}], 2, "whole statements or an expression: isEven"),
    "braces": ([{**FOUND, "original": "{ return number / 2; }", "faulty": "{ return 1; }"}], 2,
               "whole statements or an expression: { return"),
    "the end of a statement": ([{**FOUND, "original": "2 == number;", "faulty": "3 == number;"}], 2,
                               "whole statements or an expression: 2 == number;"),
    "no test at all": ([{**FOUND, "tests": []}], 2, "it has no tests"),
    "one name twice": ([FOUND, FOUND], 2, "several faults of this name"),
    "a word that no entry has": ([{**FOUND, "why": "so"}], 2, "why"),
    "a test that fails anyway": ([{**FOUND, "tests": ["tst_broken"]}], 2, "without any fault these fail"),
    "faults that overlap": ([{**FOUND, "original": "half(number) * 2", "faulty": "0"},
                             {**FOUND, "name": "over", "original": "2 == number", "faulty": "true"}], 2, "overlap"),
}
ADDED = {
    "broken": "int main() { return 1; }\n",
    "slow": """#include "core/sample.h"
#include <cstdio>
#include <unistd.h>
int main()
{
    if (half(8) == 4)
        return 0;
    std::puts("begin\\nFAIL!  : half");
    std::fflush(stdout);
    sleep(5);
    return 0;
}
""",
}


def with_added(name):
    """The sample with one more test."""
    return {
        f"tests/tst_{name}.cpp": ADDED[name],
        "CMakeLists.txt": SAMPLE["CMakeLists.txt"]
        + f"""add_executable({name} tests/tst_{name}.cpp core/sample.cpp)
target_include_directories({name} PRIVATE ${{PROJECT_SOURCE_DIR}})
add_test(NAME tst_{name} COMMAND {name})
""",
    }


def toml(entries):
    return "\n".join("[[fault]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in entry.items())
                     for entry in entries)


def self_test():
    failures = 0
    for name, (entries, status, sentence) in SAMPLES.items():
        with tempfile.TemporaryDirectory() as folder:
            files = {**SAMPLE, "tests/mutation/faults/sample.toml": toml(entries)}
            for added in ADDED:
                if f"tst_{added}" in str(entries):
                    files.update(with_added(added))
            for path, text in files.items():
                write_if_other(Path(folder, path), text)
            outcome = subprocess.run([sys.executable, __file__, "--root", folder], capture_output=True, text=True)
        said = outcome.stdout + outcome.stderr
        if outcome.returncode != status or sentence not in said:
            failures += 1
            print(f"{name}: status {outcome.returncode} instead of {status}, \"{sentence}\"\n{said}", file=sys.stderr)
    print(f"{len(SAMPLES)} lists, {failures} failures")
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description="Whether the tests find faults.")
    parser.add_argument("names", nargs="*", metavar="NAME", help="of the faults; all without")
    parser.add_argument("--check", action="store_true", help="only whether the list fits the sources")
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("--root", type=Path, default=ROOT, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.self_test:
        return self_test()
    try:
        if not given.check:
            return run(given.root, given.root / "build/mutation", given.names)
        faults = load(given.root)
        if problems := problems_of(given.root, faults):
            raise Wrong("\n".join(problems))
        print(f"{len(faults)} faults, all of them fit the sources")
        return 0
    except Wrong as problem:
        print(problem, file=sys.stderr)
        return 2
    except subprocess.CalledProcessError as problem:
        print(f"{' '.join(map(str, problem.cmd))} failed", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
