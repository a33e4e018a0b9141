#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs every command of the documents as it is printed there.

An example is a block of code with a command in it: a line that begins with a program of this project, or
with ./ or $. The examples of one document run in one shell, in their order, in a folder of their own; each
command must end with 0, or as examples.toml says, and a line that a document prints behind `$ command` must
be said by that command. examples.toml also has what a reader has before, and what is not run, with the
reason. Only addresses and folders are replaced: 192.168.1.20 and 127.0.0.1:8080 by an address that no
other test uses, /tmp and /usr/share/axiscomp by folders of this run.

run_examples.py PROGRAMS [DOCUMENT ...] runs those of the documents that are named, else all of them.
--self-test looks whether every kind of fault is found.
"""

import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import tomllib
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
SETTINGS = Path(__file__).with_name("examples.toml")
DOCUMENTS = ("README.md", "docs/**/*.md", "packaging/man/**/*.1")
PROGRAMS = ("axiscomp", "axiscomp-virtualdrive", "axis-compensation-wizard")
COMMAND = re.compile(rf"\$ |\./|(?:{'|'.join(PROGRAMS)})(?:\s|$)")
SECONDS = 300 # for all examples of one document
# ROFF of the manual pages
ROFF = (("\\-", "-"), ("\\(aq", "'"), ("\\(dq", '"'), ("\\&", ""), ("\\e", "\\"))


@dataclass
class Command:
    document: str
    line: int
    text: str # without the prompt
    printed: list = field(default_factory=list) # what the document says it answers

    def __str__(self):
        return f"{self.document}:{self.line}: {self.text.splitlines()[0]}"

    @property
    def words(self):
        """In one line, without its comment."""
        return re.sub(r"\s+", " ", re.sub(r"\s#.*", "", self.text.replace("\\\n", " "))).strip()

    @property
    def starts_drive(self):
        return self.words.startswith("axiscomp-virtualdrive")


def code_blocks(text):
    """The code of a Markdown text: each block as its lines with their numbers."""
    blocks, block, fence, in_list, after_blank = [], [], None, False, True
    for number, line in enumerate(text.split("\n"), start=1):
        marks = re.match(r"\s{0,3}(```+|~~~+)", line)
        is_code = after_blank and line.startswith("      " if in_list else "    ")
        if fence and not (marks and line.strip() == fence):
            block.append((number, line))
        elif marks:
            fence = None if fence else marks.group(1)
            blocks.append(block)
            block = []
        elif not line.strip() and block or line.startswith("    ") and (block or is_code):
            block.append((number, line))
        else:
            blocks.append(block)
            block = []
            if line.strip() and not line.startswith(" "):
                in_list = re.match(r"[-*+] |\d+[.)] ", line) is not None
        after_blank = not line.strip()
    return [dedented(b) for b in [*blocks, block] if b]


def dedented(block):
    by = min((len(line) - len(line.lstrip()) for _, line in block if line.strip()), default=0)
    return [(number, line[by:]) for number, line in block]


def manual_blocks(text):
    """The examples of a manual page."""
    blocks, block, is_examples, is_code = [], [], False, False
    for number, line in enumerate(text.split("\n"), start=1):
        if line.startswith(".SH"):
            is_examples = line[3:].strip() in ("EXAMPLES", "BEISPIELE")
        elif line in (".nf", ".fi") and is_examples:
            is_code = line == ".nf"
            blocks.append(block)
            block = []
        elif is_code:
            for coded, plain in ROFF:
                line = line.replace(coded, plain)
            block.append((number, line))
    return [b for b in blocks if b]


def commands_of(document, text):
    blocks = manual_blocks(text) if document.endswith(".1") else code_blocks(text)
    commands = []
    for block in blocks:
        if any(COMMAND.match(line) for _, line in block):
            commands += commands_in(document, block)
    return commands


def commands_in(document, block):
    """With prompts, what has none is what the command before it says."""
    has_prompts = any(line.startswith("$ ") for _, line in block)
    commands, goes_on, in_quotes = [], False, False
    for number, line in block:
        if goes_on or in_quotes:
            commands[-1].text += "\n" + line
        elif has_prompts and not COMMAND.match(line):
            commands[-1].printed += [line.strip()] if line.strip() else []
            continue
        elif line.strip():
            commands.append(Command(document, number, line.removeprefix("$ ")))
        else:
            continue
        goes_on = line.endswith("\\")
        in_quotes = is_open(commands[-1].text)
    return commands


def is_open(text):
    """Whether a quotation mark waits for its end."""
    try:
        shlex.split(text.replace("\\\n", " "), comments=True)
    except ValueError:
        return True
    return False


class Settings:
    def __init__(self, text):
        content = tomllib.loads(text)
        self.before = content.get("before", {})
        self.not_run = content.get("not-run", [])
        self.ends_with = content.get("ends-with", [])
        self.used = set()

    def find(self, table, command):
        for number, entry in enumerate(getattr(self, table)):
            if entry.get("document", command.document) == command.document and command.words.startswith(entry["command"]):
                self.used.add((table, number))
                return entry
        return None

    @staticmethod
    def place(entry):
        return f"{entry.get('document', 'any document')}, {entry['command']!r}"

    def unused(self):
        for table in ("not_run", "ends_with"):
            for number, entry in enumerate(getattr(self, table)):
                if (table, number) not in self.used:
                    yield f"{SETTINGS.name}: {self.place(entry)}: there is no such command any more"

    def faults(self, root, documents):
        for document in self.before:
            if document not in documents:
                yield f"{SETTINGS.name}: {document} has no examples"
        for entry in self.not_run:
            if not entry.get("reason", "").strip():
                yield f"{SETTINGS.name}: {self.place(entry)}: give the reason why it is not run"
            test = entry.get("test")
            if test and not (root / test).is_file():
                yield f"{SETTINGS.name}: {self.place(entry)}: there is no test {test}"


class Session:
    """A shell in which the commands of one document run, one after the other."""

    # Each command runs in the shell itself, as if it were typed: what it exports holds for the next one.
    # A drive is there when it says so; it replaces the drive of before, as switching off and on does.
    SHELL = r"""
drive=
stop_drive() { if [ -n "$drive" ]; then kill "$drive" 2>/dev/null; wait "$drive" 2>/dev/null; drive=; fi; }
await_drive() {
    drive=$!
    until grep -q '^ready' "$1" 2>/dev/null; do
        kill -0 "$drive" 2>/dev/null || { cat "$1"; return 1; }
        sleep 0.02
    done
}
trap stop_drive EXIT
"""

    def __init__(self, programs, work, place, root):
        self.programs = programs
        self.work = Path(work)
        self.address = f"127.{place >> 14 & 127 | 64}.{place >> 7 & 127}.{place & 127}:8080"
        self.root = root

    def replaced(self, text):
        for printed, here in (("http://192.168.1.20", f"http://{self.address}"), ("127.0.0.1:8080", self.address),
                              ("/tmp/", f"{self.work}/tmp/"),
                              ("/usr/share/axiscomp/machines", f"{self.root}/resources/machines")):
            text = text.replace(printed, here)
        return text

    def script(self, before, commands):
        lines = [self.SHELL]
        for number, command in enumerate([Command("", 0, before), *commands]):
            (self.work / f"{number}.sh").write_text(self.replaced(command.text) + "\n", encoding="utf-8")
            source = f'. "{self.work}/{number}.sh"'
            said = f'"{self.work}/{number}.out"'
            lines.append(f"echo {number}")
            if number and command.starts_drive:
                self.make_background(number)
                lines.append(f"stop_drive; ({source}) >{said} 2>&1 & await_drive {said} 2>&1")
            else:
                lines.append(f"{source} >{said} 2>&1")
            lines.append('echo "$?"')
        return "\n".join(lines) + "\n"

    def make_background(self, number):
        """The drive is a process of this shell, whose number is known; `&` may stand there already."""
        file = self.work / f"{number}.sh"
        text = re.sub(r"\s*&\s*(?:#[^\n]*)?$", "", file.read_text(encoding="utf-8").rstrip())
        file.write_text("exec " + text + "\n", encoding="utf-8")

    def run(self, before, commands):
        """The exit code of each command and what it said; fewer where the shell has ended."""
        home = self.work / "home"
        for folder in (home, self.work / "tmp", self.work / "here"):
            folder.mkdir()
        environment = {**os.environ, "PATH": f"{self.programs}:{os.environ['PATH']}", "HOME": str(home),
                       "SOURCES": str(self.root), "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "offscreen"}
        for name in ("AXISCOMP_DRIVE", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"):
            environment.pop(name, None)
        shell = subprocess.Popen(["bash", "-c", self.script(before, commands)], cwd=self.work / "here", env=environment,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, start_new_session=True)
        try:
            progress, _ = shell.communicate(timeout=SECONDS)
        except subprocess.TimeoutExpired:
            self.end(shell)
            progress, _ = shell.communicate()
        finally:
            self.end(shell)
        codes = progress.split()
        return [(int(codes[2 * n + 1]) if 2 * n + 1 < len(codes) else None, self.said(n)) for n in range(len(commands) + 1)]

    @staticmethod
    def end(shell):
        """Nothing that it has started outlives it."""
        try:
            os.killpg(shell.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass

    def said(self, number):
        file = self.work / f"{number}.out"
        return file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""


def is_said(printed, output):
    """`...` stands for anything."""
    pattern = ".*".join(re.escape(part) for part in printed.split("..."))
    return re.search(pattern, output) is not None


class Examples:
    def __init__(self, root, programs, settings):
        self.root = Path(root)
        self.programs = Path(programs).resolve()
        self.settings = Settings(settings)
        self.commands = {}
        for pattern in DOCUMENTS:
            for path in sorted(self.root.glob(pattern)):
                document = path.relative_to(self.root).as_posix()
                if commands := commands_of(document, path.read_text(encoding="utf-8")):
                    self.commands[document] = commands

    def run(self, chosen=()):
        """The faults, as sentences."""
        faults = list(self.settings.faults(self.root, self.commands))
        documents = [d for d in self.commands if not chosen or d in chosen]
        faults += [f"{d}: has no examples" for d in chosen if d not in self.commands]
        with ThreadPoolExecutor(max_workers=len(documents) or 1) as pool:
            for found in pool.map(self.run_document, documents, range(len(documents))):
                faults += found
        return faults if chosen else faults + list(self.settings.unused())

    def run_document(self, document, number):
        commands = [c for c in self.commands[document] if not self.settings.find("not_run", c)]
        ends = [(self.settings.find("ends_with", c) or {}).get("code", 0) for c in commands]
        if not any(COMMAND.match(c.text) for c in commands):
            return []
        with tempfile.TemporaryDirectory() as work:
            place = os.getpid() * 31 + number
            results = Session(self.programs, work, place, self.root).run(self.settings.before.get(document, ""), commands)
        before, *results = results
        if before[0] != 0:
            return [f"{SETTINGS.name}: what {document} has before its examples failed ({before[0]})\n{before[1]}"]
        for command, code, (ended, said) in zip(commands, ends, results):
            if ended is None:
                return [f"{command}\n    did not end in {SECONDS} s, nor did anything after it\n{said}"]
            if ended not in (code if isinstance(code, list) else [code]):
                return [f"{command}\n    ended with {ended}, not {code}\n{said}"]
            if missing := [line for line in command.printed if not is_said(line, said)]:
                return [f"{command}\n    does not say {missing[0]!r}\n{said}"]
        return []


SELF_TEST_DOCUMENT = """# A

    axiscomp one \\
        two      # a comment
    export WORD=kept

Text.

    $ axiscomp says "$WORD"
    says kept
    ...

- a list

    axiscomp nothing

      axiscomp in a list

Text.

    axiscomp fails
    axiscomp-virtualdrive --http 127.0.0.1:8080 &      # a drive
    axiscomp-virtualdrive
    ./run        installs

Text.

    { "no": "command" }
"""
SELF_TEST_SETTINGS = """
[before]
"docs/cli.md" = "touch there"
[[ends-with]]
document = "docs/cli.md"
command = "axiscomp fails"
code = 3
[[not-run]]
document = "docs/cli.md"
command = "./run"
reason = "installs"
"""
SELF_TEST_MANUAL = ".SH OPTIONS\n.nf\naxiscomp fails\n.fi\n.SH EXAMPLES\n.nf\naxiscomp \\-\\-one \\e\n    two\n.fi\n"
SELF_TEST_FAULTS = {
    "a command that fails": ("fails\n", "fails\n    axiscomp fails twice\n", "", "docs/cli.md:22: axiscomp fails twice"),
    "a command that says something else": ("says kept", "says lost", "", "docs/cli.md:9: axiscomp says"),
    "a command that is as printed no more": ("code = 3", "", "code = 4", "docs/cli.md:21: axiscomp fails"),
    "a drive that does not start": ("axiscomp-virtualdrive\n", "axiscomp-virtualdrive fails\n", "", "docs/cli.md:23: axiscomp-virtualdrive fails"),
    "a command that is not run without a reason": ('reason = "installs"', "", 'reason = ""', "examples.toml: docs/cli.md, './run': give the reason"),
    "a command that is not there": ('command = "./run"', "", 'command = "./walk"', "docs/cli.md:24: ./run"),
    "what comes before fails": ("touch there", "", "false", "examples.toml: what docs/cli.md has before"),
}
SELF_TEST_PROGRAM = """#!/bin/bash
[ -e there ] || [ "$1" = --one ] || exit 9
case $1 in
says) echo "$@" ;;
fails) [ -n "${2:-}" ] && exit 4 || exit 3 ;;
nothing) exit 5 ;;
esac
"""
SELF_TEST_DRIVE = "#!/bin/bash\n[ \"$1\" = fails ] && exit 1\necho ready\nexec sleep 100\n"


def self_test():
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for name, text in (("docs/cli.md", SELF_TEST_DOCUMENT), ("packaging/man/a.1", SELF_TEST_MANUAL),
                           ("axiscomp", SELF_TEST_PROGRAM), ("axiscomp-virtualdrive", SELF_TEST_DRIVE)):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            (root / name).write_text(text, encoding="utf-8")
            (root / name).chmod(0o755)
        if found := Examples(root, root, SELF_TEST_SETTINGS).run():
            failures.append("where every example is right:\n  " + "\n  ".join(found))
        for name, (text, in_document, in_settings, expected) in SELF_TEST_FAULTS.items():
            is_document = text in SELF_TEST_DOCUMENT
            document = SELF_TEST_DOCUMENT.replace(text, in_document) if is_document else SELF_TEST_DOCUMENT
            (root / "docs/cli.md").write_text(document, encoding="utf-8")
            settings = SELF_TEST_SETTINGS if is_document else SELF_TEST_SETTINGS.replace(text, in_settings)
            found = Examples(root, root, settings).run()
            if not found or not found[0].startswith(expected):
                failures.append(f"{name}: not found\n  " + "\n  ".join(found))
    for failure in failures:
        print(failure, file=sys.stderr)
    print(f"{len(SELF_TEST_FAULTS)} kinds of fault, {len(failures)} failures")
    return 1 if failures else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    if len(sys.argv) < 2:
        sys.exit("usage: run_examples.py PROGRAMS [DOCUMENT ...] | --self-test")
    examples = Examples(ROOT, sys.argv[1], SETTINGS.read_text(encoding="utf-8"))
    faults = examples.run(sys.argv[2:])
    for fault in faults:
        print(fault, file=sys.stderr)
    print(f"{sum(len(c) for c in examples.commands.values())} commands in {len(examples.commands)} documents, "
          f"{len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
