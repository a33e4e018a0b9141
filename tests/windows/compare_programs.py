#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs commands with axiscomp and with axiscomp.exe under Wine, and compares what they do, byte by byte.

    compare_programs.py NATIVE WINDOWS             every story of commands.toml, every pair of formats, and the
                                                   checks of system_check.exe beside axiscomp.exe
    compare_programs.py NATIVE WINDOWS NAME ...    these stories only
    compare_programs.py --self-test NATIVE         does this script notice what it has to?

A story is a folder with files and a list of commands, which both programs run in a folder of their own.
Exit code, standard output and standard error of every command must be the same, and at the end the names and
bytes of all files. What may differ stands in commands.toml, with its reason.
"""

import argparse
import base64
import contextlib
import copy
import json
import os
import re
import shlex
import shutil
import stat
import subprocess
import sys
import tempfile
import time
import tomllib
from dataclasses import dataclass
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
LONG = "n" * 120
PATIENCE = 600  # seconds for one command: a busy machine is no fault
WINE = ("/usr/lib/wine/wine64", "/usr/bin/wine64", "/usr/bin/wine")
SERVER = ("/usr/lib/wine/wineserver64", "/usr/lib/wine/wineserver", "/usr/bin/wineserver")


class Problem(Exception):
    """What a person has to be told."""


def first_of(programs):
    for program in programs:
        if os.access(program, os.X_OK):
            return program
    raise Problem(f"none of {', '.join(programs)} is there: packaging/packages-develop.txt has wine64")


@dataclass
class Outcome:
    code: int
    out: bytes
    err: bytes


class Program:
    """axiscomp, or axiscomp.exe under Wine."""

    def __init__(self, path, prefix):
        self.path = Path(path).resolve()
        if not self.path.is_file():
            raise Problem(f"{path} is not there: it has to be built first")
        self.is_windows = self.path.suffix == ".exe"
        self.environment = {"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "TZ": "UTC", "HOME": str(prefix.parent)}
        if self.is_windows:
            self.wine = first_of(WINE)
            self.environment |= {
                "WINEPREFIX": str(prefix), "WINEDEBUG": "-all",
                "WINEDLLOVERRIDES": "mscoree,mshtml,winemenubuilder.exe=",  # no downloads, no menus
            }
            # Makes the prefix, and lets the server and the services of Wine stay between two commands: to start
            # and to end them takes ten times as long as most of the commands. They keep what the program that
            # starts them has as standard output, and nobody may wait for its end.
            prefix.mkdir(exist_ok=True)
            nothing = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
            for command in ([first_of(SERVER), f"-p{PATIENCE}"], self.command(["--version"])):
                subprocess.run(command, env=self.environment, timeout=PATIENCE, check=False, **nothing)

    def other(self, path):
        """Another program for the same system."""
        program = copy.copy(self)
        program.path = path
        return program

    def command(self, arguments):
        return ([self.wine] if self.is_windows else []) + [str(self.path), *arguments]

    def run(self, arguments, folder, given=b""):
        done = subprocess.run(self.command(arguments), cwd=folder, input=given, env=self.environment,
                              capture_output=True, timeout=PATIENCE, check=False)
        return Outcome(done.returncode, done.stdout, done.stderr)

    def end(self):
        if self.is_windows:
            subprocess.run([first_of(SERVER), "-k"], env=self.environment, check=False)


class Differences:
    """What is known to differ; each is a pattern that is replaced in what one of the programs says."""

    def __init__(self, entries):
        self.entries = entries
        self.unused = {entry["name"] for entry in entries}

    def apply(self, text, is_windows, folder, names):
        for entry in self.entries:
            if entry["name"] not in names:
                continue
            pattern = entry["windows" if is_windows else "native"]
            pattern = pattern.replace("FOLDER", re.escape(folder))
            text, count = re.subn(pattern.encode(), entry["both"].encode(), text)
            if count and is_windows:
                self.unused.discard(entry["name"])
        return text


def windows_name(folder):
    """As Windows names a folder of Linux below the drive that Wine makes of /."""
    return "Z:" + str(folder).replace("/", "\\")


def content_of(entry):
    if "from" in entry:
        data = (ROOT / entry["from"]).read_bytes()
        if entry.get("head"):
            data = data.partition(b"\n")[2]
    elif "base64" in entry:
        data = base64.b64decode(entry["base64"])
    else:
        data = entry["text"].encode(entry.get("encoding", "utf-8"))
    if entry.get("lines") == "crlf":
        data = data.replace(b"\r\n", b"\n").replace(b"\n", b"\r\n")
    return data


def place(folder, entry):
    file = folder / entry["name"].replace("LONG", LONG)
    file.parent.mkdir(parents=True, exist_ok=True)
    if entry.get("kind") == "folder":
        file.mkdir()
        return
    file.write_bytes(content_of(entry))
    if entry.get("readonly"):
        file.chmod(stat.S_IREAD | stat.S_IRGRP | stat.S_IROTH)


def tree(folder):
    return {str(file.relative_to(folder)): file.read_bytes() if file.is_file() else None
            for file in sorted(folder.rglob("*"))}


def excerpt(name, native, windows):
    """Where two texts begin to differ."""
    at = next((i for i, (a, b) in enumerate(zip(native, windows)) if a != b), min(len(native), len(windows)))
    begin = max(0, at - 40)
    return (f"{name} differs from byte {at} on:\n    native  {native[begin:at + 80]!r}\n"
            f"    windows {windows[begin:at + 80]!r}")


class Comparison:
    def __init__(self, native, windows, data, folder):
        self.native = native
        self.windows = windows
        self.differences = Differences(data.get("difference", []))
        self.folder = folder
        self.commands = 0
        self.faults = []

    def fault(self, story, command, text):
        self.faults.append(f"{story}: {command}\n  {text}")

    def run(self, story):
        name = story["name"]
        folders = [self.folder / "native", self.folder / "windows"]
        for folder in folders:
            folder.mkdir()
            for entry in story.get("file", []):
                place(folder, entry)
        files_differ = set()
        for command in story["command"]:
            command = {"run": command} if isinstance(command, str) else command
            files_differ |= set(command.get("differs", []))
            self.compare(name, command, folders)
        trees = [self.known(tree(folder), folder, files_differ) for folder in folders]
        for file in sorted(trees[0].keys() | trees[1].keys()):
            if file not in trees[0] or file not in trees[1]:
                self.fault(name, file, f"is there only {'natively' if file in trees[0] else 'on Windows'}")
            elif trees[0][file] != trees[1][file]:
                self.fault(name, file, excerpt("the file", trees[0][file], trees[1][file]))
        for folder in folders:
            remove(folder)

    def known(self, files, folder, names):
        return {file: None if data is None else
                self.differences.apply(data, folder.name == "windows" and self.windows.is_windows,
                                       str(folder), names) for file, data in files.items()}

    def compare(self, story, command, folders):
        self.commands += 1
        arguments = [word.replace("LONG", LONG) for word in shlex.split(command["run"])]
        given = b""
        if "input" in command:
            given = (folders[0] / command["input"]).read_bytes()
        outcomes = []
        for program, folder in zip((self.native, self.windows), folders):
            outcome = program.run(arguments, folder, given)
            names = command.get("differs", [])
            shown = windows_name(folder) if program.is_windows else str(folder)
            outcomes.append(Outcome(outcome.code, *(
                self.differences.apply(text, program.is_windows, shown, names)
                for text in (outcome.out, outcome.err))))
        native, windows = outcomes
        if "code" in command and native.code != command["code"]:
            self.fault(story, command["run"], f"exit code {native.code}, not {command['code']}: "
                       f"{native.err.decode(errors='replace')[:400]}")
        if native.code != windows.code:
            self.fault(story, command["run"], f"exit code {native.code} natively, {windows.code} on Windows: "
                       f"{windows.err.decode(errors='replace')[:400]}")
        for what in ("out", "err"):
            texts = getattr(native, what), getattr(windows, what)
            if texts[0] != texts[1]:
                self.fault(story, command["run"], excerpt({"out": "standard output", "err": "standard error"}[what],
                                                          *texts))


def remove(folder):
    for file in folder.rglob("*"):
        if file.is_symlink():  # Wine has one to /
            continue
        with contextlib.suppress(OSError):
            file.chmod(0o700 if file.is_dir() else 0o600)
    shutil.rmtree(folder)


# --- every pair of formats


def settings_of(form, rules, side):
    """What a format leaves open: --set-out or --set-in KEY=VALUE, from the rules of commands.toml."""
    options = []
    for setting in form["settings"]:
        if not setting["writing" if side == "out" else "reading"]:
            continue
        for rule in rules:
            if re.fullmatch(rule["format"], form["name"]) and re.fullmatch(rule["key"], setting["key"]):
                options += [f"--set-{side}", f"{setting['key']}={rule['value']}"]
                break
    return options


def pairs_of_formats(formats, data):
    """A story for every format that is written: a table is converted to it, and from it to all others."""
    pairs = data["pairs"]
    stories = []
    for first in formats:
        if not first["writes"]:
            continue
        size = next(s for s in pairs["table"] if s["dimensions"] >= min(first["dimensions"]))
        dimensions = size["dimensions"]
        target = next((t["target"] for t in pairs["target"]
                       if re.fullmatch(t["format"], first["name"]) and dimensions == t.get("dimensions", dimensions)))
        commands = [shlex.join(["convert", "table.csv", "first", "--dims", str(dimensions), "--to", first["name"],
                                "--target", target, *sign(first, "to"), *settings_of(first, pairs["setting"], "out")])]
        reading = ["--from", first["name"], *settings_of(first, pairs["setting"], "in"), *sign(first, "from")]
        if first["name"] == "csv":
            reading += ["--dims", str(dimensions)]
        commands.append(shlex.join(["inspect", "first", *without_sign(reading)]))
        for other in formats:
            if first["reads"] and other["name"] != first["name"]:
                commands.append(shlex.join(
                    ["convert", "first", f"second-{other['name']}", *reading, "--to", other["name"], "--target", target,
                     *sign(other, "to"), *settings_of(other, pairs["setting"], "out")]))
        stories.append({"name": f"pairs of {first['name']}", "file": [{"name": "table.csv", "text": size["text"]}],
                        "command": commands})
    return stories


def sign(form, side):
    if form["signEvidence"] != "assumed":
        return []
    return ["--to-sign" if side == "to" else "--sign", form["sign"]]


def without_sign(options):
    return [o for i, o in enumerate(options) if o != "--sign" and (i == 0 or options[i - 1] != "--sign")]


def corpora(data):
    """Every file that fuzzers have found, read by a command: bad input is normal input."""
    stories = []
    for corpus in data["corpus"]:
        files = sorted((ROOT / corpus["folder"]).iterdir())
        head = corpus.get("head", False)
        entries = [{"name": f"input-{number}{corpus.get('ending', '')}", "from": str(file.relative_to(ROOT)),
                    "head": head} for number, file in enumerate(files)]
        heads = [file.read_bytes().partition(b"\n")[0].decode() if head else "" for file in files]
        commands = [corpus["run"].replace("FILE", entry["name"]).replace("HEAD", shlex.quote(first))
                    for entry, first in zip(entries, heads)]
        stories.append({"name": corpus["folder"], "file": entries, "command": commands})
    return stories


def stories_of(native, data):
    formats = json.loads(native.run(["formats", "--json"], Path("/")).out)["formats"]
    return data["story"] + pairs_of_formats(formats, data) + corpora(data)


# --- what is no comparison


def commands_of(help_page):
    """The names of the commands on the page of --help."""
    names = []
    in_list = False
    for line in help_page.splitlines():
        if line and not line.startswith(" "):
            in_list = line.endswith(":") and not line.startswith(("Options", "usage"))
        elif in_list and (found := re.match(r"  (\w[\w-]*)(  |$)", line)):
            names.append(found.group(1))
    return names


def check_alone(comparison, data):
    """What only the program for Windows has: a list of commands of its own, and its system."""
    windows = comparison.windows
    page = windows.run(["--help"], Path("/")).out.decode()
    if commands_of(page) != data["program"]["commands"]:
        comparison.fault("program", "--help", f"lists {commands_of(page)}")
    for command in data["program"]["refused"]:
        outcome = windows.run(shlex.split(command["run"]), Path("/"))
        if outcome.code != 2 or command["says"].encode() not in outcome.err:
            comparison.fault("program", command["run"], f"exit code {outcome.code}: {outcome.err.decode()[:400]}")
    checks = windows.path.with_name("system_check.exe")
    if not checks.is_file():
        raise Problem(f"{checks} is not there: it has to be built first")
    system = windows.other(checks)
    outcome = system.run([], Path("/"))
    print("system_check:", outcome.out.decode().strip())
    if outcome.code != 0:
        comparison.fault("system_check", "every check", outcome.out.decode() + outcome.err.decode()[:400])
    check_lock(comparison, system)


def check_lock(comparison, system):
    """Of two programs; the lock of one that dies is free."""
    lock = [windows_name(comparison.folder / "lock")]
    with subprocess.Popen(system.command(["hold", *lock]), env=system.environment, stdin=subprocess.PIPE,
                          stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as holder:
        said = holder.stdout.readline().strip()
        held = system.run(["try", *lock], Path("/")).out.strip()
        holder.kill()
        holder.wait()
    # The server of Wine notices the death of a program a moment later.
    ends = time.monotonic() + PATIENCE
    free = b""
    while free != b"free" and time.monotonic() < ends:
        free = system.run(["try", *lock], Path("/")).out.strip()
    if (said, held, free) != (b"held", b"taken", b"free"):
        comparison.fault("system_check", "a lock of two programs", f"{said!r}, {held!r}, {free!r}")


def compare(native_path, windows_path, names, data):
    # Names with blanks and umlauts are what people have.
    base = Path(tempfile.mkdtemp(prefix="axiscomp Prüfung "))
    programs = []
    try:
        for path in (native_path, windows_path):
            programs.append(Program(path, base / "prefix"))
        comparison = Comparison(*programs, data, base)
        stories = stories_of(programs[0], data)
        unknown = set(names) - {story["name"] for story in stories}
        if unknown:
            raise Problem(f"there is no story {', '.join(sorted(unknown))}")
        for story in stories:
            if not names or story["name"] in names:
                comparison.run(story)
        if not names and programs[1].is_windows:
            check_alone(comparison, data)
        if not names:
            for name in sorted(comparison.differences.unused):
                comparison.fault("commands.toml", name, "this difference is not there any more: take it out")
        return comparison
    finally:
        for program in programs:
            program.end()
        remove(base)


def report(comparison):
    for fault in comparison.faults:
        print(fault)
    print(f"{comparison.commands} commands, {len(comparison.faults)} differences that nobody expects")
    return 1 if comparison.faults else 0


# --- self-test


def self_test(native):
    """A program that does one thing otherwise, for each kind of fault."""
    data = {"story": [{"name": "one", "file": [{"name": "a", "text": "1"}],
                       "command": [{"run": "example --dims 1 -o b.csv", "code": 0}]}],
            "pairs": {"table": [], "target": [], "setting": []}, "corpus": []}
    tampering = {
        "nothing": ("", 0),
        "exit code": ("code=9", 2),
        "standard output": ("echo more", 1),
        "standard error": ("echo more >&2", 1),
        "a file more": ("echo x >c", 1),
        "a file less": ("rm -f b.csv", 1),
        "another byte": ("printf x >>b.csv", 1),
    }
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        for name, (line, _) in tampering.items():
            other = Path(folder) / "other"
            other.write_text(f'#!/bin/sh\n"{native}" "$@"\ncode=$?\n'
                             f'case "$1" in example) {line or ":"} ;; esac\nexit $code\n')
            other.chmod(0o700)
            stories = data | {"pairs": {"table": [], "target": [], "setting": []}}
            found = compare_without_pairs(native, other, stories).faults
            if bool(found) != bool(line):
                print(f"self-test: {name}: {len(found)} faults")
                failures += 1
    print(f"{len(tampering)} kinds of fault, {failures} failures")
    return 1 if failures else 0


def compare_without_pairs(native, other, data):
    with tempfile.TemporaryDirectory() as folder:
        programs = [Program(path, Path(folder) / "prefix") for path in (native, other)]
        comparison = Comparison(*programs, data, Path(folder))
        for story in data["story"]:
            comparison.run(story)
        return comparison


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--self-test", action="store_true")
    parser.add_argument("native")
    parser.add_argument("windows", nargs="?")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    try:
        if options.self_test:
            return self_test(options.native)
        if options.windows is None:
            parser.error("the program for Windows is missing")
        data = tomllib.loads((HERE / "commands.toml").read_text(encoding="utf-8"))
        return report(compare(options.native, options.windows, options.names, data))
    except Problem as problem:
        print(problem, file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
