#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that documents and comments cite only what the repository has.

In every text file: docs/NAME.md exists, and so does the section in docs/NAME.md, "Section"; DECISIONS.md, N
exists. In documents also: files named as `core/...`; their links are those of check_links.py. Prints one
sentence for each fault and fails if there is one. --self-test looks whether every kind of fault is found.
"""

import os
import re
import sys
import tempfile
from pathlib import Path

from check_links import anchor_of, anchors_of

FOLDERS = ("app", "cmake", "core", "docs", "drivecomm", "packaging", "resources", "tests", "translations", "ui")
LEFT_OUT = ("build", "tests/data", "tests/fuzz/corpus", "tests/tools/check_citations.py", "tests/tools/check_links.py")
TEXTS = (".md", ".h", ".cpp", ".in", ".txt", ".cmake", ".sh", ".py", ".json", ".yml")

# A comment may break a line anywhere; the marks of comments are taken out before these are looked for.
DOCUMENT = re.compile(r'\b(docs/[\w./-]+?\.md)\b(?:,? \(?"([^"]+)")?')
DECISION = re.compile(r"\bDECISIONS\.md, ((?:\d+(?:, | and )?)+)")
NAMED_FILE = re.compile(r"`((?:%s)/[\w./*{},-]+)`" % "|".join(FOLDERS))
SOURCE_FILE = re.compile(r"`(\w+\.(?:cpp|h))`")
ELSEWHERE = re.compile(r"\bspec/[\w-]+\.md|\b(?:DESIGN|HOUSE|STYLE)\.md|\bDESIGN, \"")


class Repository:
    def __init__(self, root):
        self.root = Path(root)
        self.faults = []
        self.headings = {}

    def check(self):
        texts = []
        for folder, subfolders, names in os.walk(self.root):
            here = Path(folder).relative_to(self.root)
            subfolders[:] = sorted(s for s in subfolders
                                   if not s.startswith((".", "__")) and (here / s).as_posix() not in LEFT_OUT)
            for name in sorted(names):
                path = (here / name).as_posix()
                if name.endswith(TEXTS) and path not in LEFT_OUT:
                    texts.append(path)
        self.names = {os.path.basename(path) for path in texts}
        for path in texts:
            self.check_file(path)
        return self.faults

    def fault(self, path, text, offset, sentence):
        self.faults.append(f"{path}:{text.count(chr(10), 0, offset) + 1}: {sentence}")

    def check_file(self, path):
        text = (self.root / path).read_text(encoding="utf-8", errors="replace")
        # Same length, so that places stay: a line break and the marks of the next line become blanks.
        joined = re.sub(r"\n[ \t]*(?:///?<?|#)?[ \t]*", lambda m: "\n" + " " * (len(m.group()) - 1), text)
        flat = re.sub(r"\s+", lambda m: " " + "\0" * (len(m.group()) - 1), joined)
        squeezed, places = squeeze(flat)
        for found in DOCUMENT.finditer(squeezed):
            self.check_document(path, text, places[found.start()], found.group(1), found.group(2))
        for found in DECISION.finditer(squeezed):
            for number in re.findall(r"\d+", found.group(1)):
                if f"{number}-" not in {f"{h.split('-')[0]}-" for h in self.anchors("DECISIONS.md")}:
                    self.fault(path, text, places[found.start()], f"cites DECISIONS.md, {number}, which is not there.")
        for found in ELSEWHERE.finditer(squeezed):
            self.fault(path, text, places[found.start()], f"cites {found.group()}, which the repository does not have. "
                       "Cite a document of docs/, and write there what is missing.")
        if path.endswith(".md"):
            self.check_names(path, text)

    def check_document(self, path, text, offset, document, section):
        if not (self.root / document).is_file():
            self.fault(path, text, offset, f"cites {document}, which is not there.")
        elif section and anchor_of(section) not in self.anchors(document):
            self.fault(path, text, offset, f"cites \"{section}\" of {document}, which has no such section.")

    def check_names(self, path, text):
        for found in SOURCE_FILE.finditer(text):
            if found.group(1) not in self.names:
                self.fault(path, text, found.start(), f"names {found.group(1)}, which is not there.")
        for found in NAMED_FILE.finditer(text):
            for name in expand(found.group(1)):
                if not (list(self.root.glob(name)) if "*" in name else (self.root / name).exists()):
                    self.fault(path, text, found.start(), f"names {name}, which is not there.")

    def anchors(self, document):
        if document not in self.headings:
            file = self.root / document
            self.headings[document] = anchors_of(file.read_text(encoding="utf-8")) if file.is_file() else set()
        return self.headings[document]


def squeeze(flat):
    """Without the zero characters, and the place of each character that is left."""
    places = [i for i, c in enumerate(flat) if c != "\0"]
    return "".join(flat[i] for i in places), places


def expand(name):
    """a/{b,c} is a/b and a/c."""
    braces = re.search(r"\{([^}]*)\}", name)
    if not braces:
        return [name]
    return [e for part in braces.group(1).split(",")
            for e in expand(name[:braces.start()] + part + name[braces.end():])]


CLEAN = {
    "DECISIONS.md": "# Decisions\n\n## 1. One\n- drivecomm\n\n## 12. Two\n",
    "README.md": "`core/{a.h,b.h}` `core/*.h`\n",
    "docs/a.md": "# A\n\n## The `generic` layout\n",
    "core/a.h": "/// As docs/a.md, \"The\n/// generic layout\", has it (DECISIONS.md, 1 and\n// 12).\n",
    "core/b.h": "",
}
FAULTS = {
    "a document that is not there": ({"core/b.h": "\n// docs/b.md\n"}, "core/b.h:2: cites docs/b.md"),
    "a section that is not there": (
        {"core/b.h": "// docs/a.md,\n// \"The other\n// layout\"\n"}, "core/b.h:1: cites \"The other layout\""),
    "a decision that is not there": ({"core/b.h": "// DECISIONS.md, 2\n"}, "core/b.h:1: cites DECISIONS.md, 2"),
    "a document of elsewhere": ({"core/b.h": "// spec/a.md\n"}, "core/b.h:1: cites spec/a.md"),
    "a file that is not there": ({"docs/b.md": "`core/{a,c}.h`\n"}, "docs/b.md:1: names core/c.h"),
    "a source file that is not there": ({"docs/b.md": "`c.h`\n"}, "docs/b.md:1: names c.h"),
    "files that are not there": ({"docs/b.md": "`core/x_*.h`\n"}, "docs/b.md:1: names core/x_*.h"),
}


def faults_of(files):
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            file = Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return Repository(folder).check()


def self_test():
    failures = []
    if found := faults_of(CLEAN):
        failures.append("a repository in which everything is right:\n  " + "\n  ".join(found))
    for name, (changes, expected) in FAULTS.items():
        found = faults_of({**CLEAN, **changes})
        if len(found) != 1 or not found[0].startswith(expected):
            failures.append(f"{name}: not found\n  " + "\n  ".join(found))
    for failure in failures:
        print(failure, file=sys.stderr)
    print(f"{len(FAULTS)} kinds of fault, {len(failures)} failures")
    return 1 if failures else 0


def main():
    if sys.argv[1:] == ["--self-test"]:
        return self_test()
    faults = Repository(Path(__file__).resolve().parents[2]).check()
    for sentence in faults:
        print(sentence, file=sys.stderr)
    print(f"{len(faults)} citations of what is not there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
