#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which documents are pages of the site, in the order of what a reader needs, and their links.

Run as a program it looks whether every document is a page; the site itself is made by build.py.
"""

import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

INDEX = "docs/index.md"
# The caption of a group, and its documents.
NAVIGATION = (
    ("Begin", (
        "docs/first-five-minutes.md",
        "docs/user-guide.md",
        "docs/laser-to-drive.md",
    )),
    ("Measure and compensate", (
        "docs/metrology.md",
        "docs/report.md",
        "docs/machine-file.md",
        "docs/virtual-machine.md",
    )),
    ("Command line and Python", (
        "docs/cli.md",
        "docs/python.md",
    )),
    ("Files", (
        "docs/calibration-csv.md",
        "docs/formats.md",
        "docs/measurement-formats.md",
        "docs/axcal.md",
        "docs/tamtbl.md",
    )),
    ("Drives", (
        "docs/drive.md",
        "docs/profiles.md",
        "docs/protocol.md",
    )),
    ("How it is proved", (
        "docs/reliability.md",
        "docs/performance.md",
    )),
    ("Reference", (
        "docs/terms.md",
        "CHANGELOG.md",
    )),
    ("For developers", (
        "docs/architecture.md",
        "docs/cpp.md",
        "docs/embedding/README.md",
        "docs/windows.md",
        "CONTRIBUTING.md",
        "core/README.md",
        "drivecomm/README.md",
        "ui/README.md",
        "app/README.md",
        "DECISIONS.md",
    )),
)
# The page of the repository itself says the same as the front page.
ALIASES = {"README.md": "index"}
# The list of sections at the head of a page: the site has it beside every page.
CONTENTS = re.compile(r"\n(?:- \[[^\]\n]*\]\(#[^)\s]*\)\n)+")
LINK = re.compile(r"(\]\()([^)\s:#]+)((?:#[^)\s]*)?\))")


def page_names():
    """The page of each document, by its path in the repository."""
    names = {INDEX: "index"}
    for _, documents in NAVIGATION:
        for document in documents:
            path = Path(document)
            names[document] = (path.parent.name if path.name == "README.md" else path.stem).lower()
    if len(set(names.values())) != len(names):
        raise ValueError("two documents would have the same page")
    return names


class Assembly:
    """Lays the documents into one folder, with links from page to page."""

    def __init__(self, root, target):
        self.root = Path(root)
        self.target = Path(target)
        self.names = page_names()

    def run(self):
        missing = sorted({p.relative_to(self.root).as_posix() for p in (self.root / "docs").rglob("*.md")}
                         - set(self.names))
        if missing:
            raise ValueError(f"{', '.join(missing)}: in no group of docs/site/pages.py, NAVIGATION")
        shutil.rmtree(self.target, ignore_errors=True)
        self.target.mkdir(parents=True)
        for document, name in self.names.items():
            text = (self.root / document).read_text(encoding="utf-8")
            text = LINK.sub(lambda found: found.group(1) + self.link(document, found.group(2)) + found.group(3), text)
            text = CONTENTS.sub("\n", text, count=1)
            if document == INDEX:
                text += self.navigation()
            (self.target / f"{name}.md").write_text(text, encoding="utf-8")

    def link(self, document, target):
        """A document is its page, any other file a copy beside the pages; what is not there stays, and is
        a warning of the builder."""
        path = os.path.normpath(os.path.join(os.path.dirname(document), target))
        name = self.names.get(path, ALIASES.get(path))
        if name:
            return f"{name}.md"
        file = self.root / path
        if not file.is_file():
            return target
        copy = self.target / "files" / path
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)
        return f"files/{path}"

    def navigation(self):
        trees = []
        for caption, documents in NAVIGATION:
            pages = "\n".join(self.names[d] for d in documents)
            trees.append(f"```{{toctree}}\n:hidden:\n:caption: {caption}\n:maxdepth: 1\n\n{pages}\n```")
        return "\n" + "\n\n".join(trees) + "\n"

    def add_cpp(self, pages):
        """A page for each folder with public headers, below that of the C++ API."""
        folder = self.target / "cpp-api"
        folder.mkdir()
        names = []
        for path, text in pages:
            names.append("cpp-api/" + path.replace("/", "-"))
            (self.target / f"{names[-1]}.rst").write_text(text, encoding="utf-8")
        with open(self.target / "cpp.md", "a", encoding="utf-8") as page:
            page.write("\n## Headers by folder\n\n```{toctree}\n:maxdepth: 1\n\n" + "\n".join(names) + "\n```\n")


def main():
    with tempfile.TemporaryDirectory() as folder:
        try:
            Assembly(Path(__file__).resolve().parents[2], folder).run()
        except (OSError, ValueError) as error:
            sys.exit(f"documentation site: {error}")


if __name__ == "__main__":
    main()
