#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Completion: the files are what make_completion.py makes of the programs, and each shell proposes by them.

A shell that is not installed is left out.
    tests/packaging/check_completion.py build/run/bin
"""

import filecmp
import os
import pty
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILES = ROOT / "packaging/completion"
BASH_COMPLETION = Path("/usr/share/bash-completion/bash_completion")
programs = None

# A line that is typed, and what is proposed for its last word: all of it, or at least these.
EXACT = {
    "axiscomp unper": {"unpersist"},
    "axiscomp doc": {"doctor"},
    "axiscomp doctor --ti": {"--timeout"},
    "axiscomp write --persist": {"--persistent"},
    "axiscomp example --dims ": {"1", "2", "3"},
    "axiscomp fit --method ha": {"harmonic"},
    "axiscomp judge --from ren": {"renishaw"},
    "axiscomp convert --to lin": {"linuxcnc"},
    "axiscomp config ex": {"export"},
    "axiscomp config --json show two": {"two.TAMcfg"},
    "axiscomp config show two": {"two.TAMcfg"},
    "axiscomp report j": {"job.axcal"},
    "axiscomp axes --drive dem": {"demo:"},
    "axiscomp plan m": {"machine.toml"},
    "axiscomp download tables/large": {"tables/large1.TAMtbl", "tables/large2.TAMtbl"},
    "axiscomp-virtualdrive --unh": {"--unhomed"},
    "axiscomp-virtualdrive --config t": {"two.TAMcfg"},
    "axis-compensation-wizard --ti": {"--timeout"},
}
UNIQUE = [line for line, proposals in EXACT.items() if len(proposals) == 1]


def proposals_of_bash(line):
    words = line.split(" ")
    script = f"""
        source {BASH_COMPLETION}; source {FILES}/axiscomp.bash
        COMP_LINE='{line}'; COMP_POINT={len(line)}; COMP_CWORD={len(words) - 1}
        COMP_WORDS=({' '.join(f"'{word}'" for word in words)})
        _{words[0].replace('-', '_')}; printf '%s\\n' "${{COMPREPLY[@]}}" """
    run = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=False)
    return {word.strip() for word in run.stdout.split()}, run.stderr


def proposals_of_fish(line):
    script = f"source {FILES}/{line.split(' ')[0]}.fish; complete -C '{line}'"
    run = subprocess.run(["fish", "--no-config", "-c", script], capture_output=True, text=True, check=False)
    return {word.split("\t")[0] for word in run.stdout.splitlines()}, run.stderr


class Zsh:
    """A shell at a terminal, since nothing else completes: what Tab makes of a line."""

    def __init__(self):
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.execvpe("zsh", ["zsh", "-f", "-i"], {**os.environ, "TERM": "dumb", "PS1": ""})
        self.run(f"fpath=({FILES} $fpath); autoload -Uz compinit; compinit -u -D; setopt nobeep; unsetopt zle_bracketed_paste")
        self.run("show() { print -r \"<<$BUFFER>>\"; BUFFER=; }; zle -N show; bindkey '^X' show; bindkey '^I' complete-word")

    def until(self, mark):
        text = ""
        while mark not in text:
            text += os.read(self.terminal, 4096).decode(errors="replace")
        return text

    def run(self, command):
        os.write(self.terminal, f"{command}; print do''ne\n".encode())
        self.until("done")

    def completed(self, line):
        os.write(self.terminal, f"{line}\t\x18".encode())
        return self.until(">>").rsplit("<<", 1)[1].split(">>")[0].strip()

    def close(self):
        os.write(self.terminal, b"exit\n")
        os.waitpid(self.process, 0)


class Completion(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        for name in ("job.axcal", "two.TAMcfg", "machine.toml"):
            Path(name).touch()

    def test_the_files_are_what_the_programs_say(self):
        with tempfile.TemporaryDirectory() as made:
            subprocess.run([sys.executable, FILES / "make_completion.py", programs, made], check=True)
            for file in sorted(Path(made).iterdir()):
                self.assertTrue(
                    filecmp.cmp(file, FILES / file.name, shallow=False),
                    f"{file.name} is not up to date: packaging/completion/make_completion.py {programs} {FILES}")

    @unittest.skipUnless(BASH_COMPLETION.exists(), "no bash-completion")
    def test_bash_proposes(self):
        for line, expected in EXACT.items():
            with self.subTest(line):
                self.assertEqual(proposals_of_bash(line), (expected, ""))

    @unittest.skipUnless(shutil.which("fish"), "no fish")
    def test_fish_proposes(self):
        for line, expected in EXACT.items():
            with self.subTest(line):
                found, errors = proposals_of_fish(line)
                self.assertEqual((found, errors), (expected, ""))

    @unittest.skipUnless(shutil.which("zsh"), "no zsh")
    def test_zsh_completes(self):
        shell = Zsh()
        self.addCleanup(shell.close)
        for line in UNIQUE:
            with self.subTest(line):
                (word,) = EXACT[line]
                self.assertEqual(shell.completed(line), line.rsplit(" ", 1)[0] + " " + word)


if __name__ == "__main__":
    programs = Path(sys.argv.pop(1)).resolve()
    unittest.main()
