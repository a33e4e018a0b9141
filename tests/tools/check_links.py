#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that links lead somewhere.

Without arguments: every relative link of every Markdown file of the repository leads to a file of it, and
its anchor to a section, as the web pages of a repository name them. With --site FOLDER: the same for every
page of the documentation site, which besides takes no script, style, picture or font from elsewhere, so
that it works without a network. Prints one sentence for each fault and fails if there is one. --self-test
looks whether every kind of fault is found.
"""

import os
import re
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

LEFT_OUT = ("build", "tests/data", "tests/fuzz/corpus")
SCHEME = re.compile(r"^(?:[a-z][a-z0-9+.-]*:|//)", re.IGNORECASE)
FENCE = re.compile(r"^ {0,3}(```+|~~~+)")
HEADING = re.compile(r"^ {0,3}#{1,6}[ \t]+(.*?)(?:[ \t]+#+)?[ \t]*$")
INLINE_LINK = re.compile(r"\]\(\s*<?([^)\s>]*)>?(?:\s+\"[^\"]*\")?\s*\)")
DEFINITION = re.compile(r"^ {0,3}\[([^\]]+)\]:\s*(\S+)", re.MULTILINE)
HTML_LINK = re.compile(r"<[a-z]+\b[^>]*\b(?:href|src)=[\"']([^\"']*)[\"']", re.IGNORECASE)
HTML_ANCHOR = re.compile(r"<[a-z]+\b[^>]*\b(?:id|name)=[\"']([^\"']*)[\"']", re.IGNORECASE)


def is_left_out(path):
    return path.as_posix() in LEFT_OUT


def anchor_of(heading):
    """As the web pages of a repository make it."""
    words = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()) # a link is its text
    words = re.sub(r"[`*]", "", words).lower()
    return re.sub(r"[^\w\- ]", "", words).replace(" ", "-")


def without_code(text):
    """The same length and lines; code is blank: it has no links, and its signs # begin no section."""
    kept, fence, in_list, in_code, after_blank = [], None, False, False, True
    for line in text.split("\n"):
        opening = FENCE.match(line)
        is_indented = line.startswith("    ") and line.strip() and not in_list
        if fence:
            fence = None if opening and line.strip().startswith(fence) else fence
            kept.append(" " * len(line))
        elif opening:
            fence = opening.group(1)
            kept.append(" " * len(line))
        elif is_indented and (after_blank or in_code):
            in_code = True
            kept.append(" " * len(line))
        else:
            in_code = in_code and not line.strip()
            kept.append(line)
            if line.strip() and not line.startswith(" "):
                in_list = re.match(r"[-*+] |\d+[.)] ", line) is not None
        after_blank = not line.strip()
    spans = re.compile(r"(?<!`)(`+)(?!`)(.+?)(?<!`)\1(?!`)", re.DOTALL)
    return spans.sub(lambda m: re.sub(r"[^\n]", " ", m.group()), "\n".join(kept))


def anchors_of(text):
    """Those of a Markdown text; a title that comes again has a number behind it."""
    anchors, seen = set(HTML_ANCHOR.findall(text)), {}
    code = without_code(text).split("\n")
    for line, bare in zip(text.split("\n"), code):
        heading = HEADING.match(line)
        if heading and bare.lstrip().startswith("#"):
            anchor = anchor_of(heading.group(1))
            seen[anchor] = seen.get(anchor, -1) + 1
            anchors.add(f"{anchor}-{seen[anchor]}" if seen[anchor] else anchor)
    return anchors


class MarkdownLinks:
    def __init__(self, root):
        self.root = Path(root).resolve()
        self.faults = []
        self.anchors = {}

    def check(self):
        for folder, subfolders, names in os.walk(self.root):
            here = Path(folder).relative_to(self.root)
            subfolders[:] = sorted(s for s in subfolders
                                   if not s.startswith((".", "__")) and not is_left_out(here / s))
            for name in sorted(names):
                if name.endswith(".md"):
                    self.check_file(here / name)
        return self.faults

    def check_file(self, path):
        text = without_code((self.root / path).read_text(encoding="utf-8"))
        for pattern, group in ((INLINE_LINK, 1), (DEFINITION, 2), (HTML_LINK, 1)):
            for found in pattern.finditer(text):
                if not SCHEME.match(found.group(group)):
                    self.check_link(path, text, found, unquote(found.group(group)))

    def check_link(self, path, text, found, link):
        target, _, anchor = link.partition("#")
        if target.startswith("/"):
            self.fault(path, text, found, f"links to {target}: write it relative to the file.")
            return
        file = Path(os.path.normpath(path.parent / target)) if target else path
        if not target and not anchor:
            self.fault(path, text, found, "has a link to nothing.")
        elif file.parts[:1] == ("..",) or not (self.root / file).exists():
            self.fault(path, text, found, f"links to {target}, which is not there.")
        elif anchor and file.suffix == ".md" and anchor not in self.anchors_in(file):
            self.fault(path, text, found, f"links to #{anchor}, a section that {file.as_posix()} does not have.")

    def anchors_in(self, file):
        if file not in self.anchors:
            self.anchors[file] = anchors_of((self.root / file).read_text(encoding="utf-8"))
        return self.anchors[file]

    def fault(self, path, text, found, sentence):
        self.faults.append(f"{path.as_posix()}:{text.count(chr(10), 0, found.start()) + 1}: {sentence}")


class Page(HTMLParser):
    """What a page of HTML refers to, and the anchors in it."""

    LINKS = {"href": ("a", "area", "link", "use", "image"), "xlink:href": ("use", "image"),
             "src": ("script", "img", "iframe", "source", "audio", "video", "embed", "input", "track"),
             "data": ("object",), "action": ("form",), "poster": ("video",)}

    def __init__(self, text):
        super().__init__()
        self.links = [] # line, tag, target
        self.anchors = set()
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        for name, value in attrs:
            if name in ("id", "name"):
                self.anchors.add(value)
            elif tag in self.LINKS.get(name, ()):
                self.links.append((self.getpos()[0], tag, value or ""))
            elif name == "srcset":
                self.links += [(self.getpos()[0], tag, c.split()[0]) for c in value.split(",") if c.strip()]
            elif name == "style":
                self.links += [(self.getpos()[0], tag, target) for target in style_links(value)]

    def handle_data(self, data):
        if self.cdata_elem == "style":
            self.links += [(self.getpos()[0], "style", target) for target in style_links(data)]


def style_links(text):
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    found = re.findall(r"url\(\s*[\"']?([^\"')]*)|@import\s+[\"']([^\"']*)", text)
    return [first or second for first, second in found]


class SiteLinks:
    def __init__(self, root):
        self.root = Path(root).resolve()
        self.faults = []
        self.pages = {}

    def check(self):
        files = sorted(self.root.rglob("*"))
        for file in files:
            if file.suffix == ".html":
                self.pages[file] = Page(file.read_text(encoding="utf-8"))
        if self.root / "index.html" not in self.pages:
            self.faults.append(f"{self.root}: has no index.html.")
        for file, page in self.pages.items():
            for line, tag, target in page.links:
                self.check_link(file, line, tag, target)
        for file in files:
            if file.suffix == ".css":
                for target in style_links(file.read_text(encoding="utf-8")):
                    self.check_link(file, 0, "style", target)
            elif file.suffix == ".js" and re.search(r"^\s*(?:import|export)\b", file.read_text(encoding="utf-8"), re.MULTILINE):
                self.fault(file, 0, "is a module, which a browser does not load from a file.")
        return self.faults

    def check_link(self, file, line, tag, link):
        if link.startswith("data:"):
            return
        if SCHEME.match(link):
            # What a person may click on; everything else would be fetched.
            if tag not in ("a", "area"):
                self.fault(file, line, f"takes {link} from elsewhere.")
            return
        target, _, anchor = unquote(link).partition("#")
        target = target.partition("?")[0]
        aim = Path(os.path.normpath(file.parent / target)) if target else file
        if target.startswith("/") or self.root not in (aim, *aim.parents):
            self.fault(file, line, f"links to {target}, outside of the site.")
        elif not aim.is_file():
            self.fault(file, line, f"links to {target}, which is not there.")
        elif anchor and aim in self.pages and anchor not in self.pages[aim].anchors:
            self.fault(file, line, f"links to #{anchor}, which {aim.relative_to(self.root)} does not have.")

    def fault(self, file, line, sentence):
        place = f"{file.relative_to(self.root).as_posix()}" + (f":{line}" if line else "")
        self.faults.append(f"{place}: {sentence}")


CLEAN_TEXTS = {
    "README.md": "[a](docs/a.md#the-generic-layout) [b](#read-me) [c](https://example.org/x#y) [d](docs)\n\n"
                 "[e][there] ![p](<p.png> \"title\") <a href=\"docs/a.md#here\">f</a> [g](docs/a.md#again-1)\n\n"
                 "[there]: docs/a.md\n\n# Read me\n\n    [code](nowhere.md)\n\n`[code](nowhere.md)`\n",
    "docs/a.md": "# A\n\n## The `generic` layout\n\n## Again\n\n## Again\n\n<a id=\"here\"></a> [back](../README.md)\n\n"
                 "- item\n\n      # no section\n\n```\n# no section\n[code](nowhere.md)\n```\n",
    "p.png": "",
}
FAULTY_TEXTS = {
    "a dead link": ({"docs/b.md": "\n[x](c.md)\n"}, "docs/b.md:2: links to c.md"),
    "a dead picture": ({"docs/b.md": "![x](c.png)\n"}, "docs/b.md:1: links to c.png"),
    "a dead link in HTML": ({"docs/b.md": "<img src=\"c.png\">\n"}, "docs/b.md:1: links to c.png"),
    "a dead definition": ({"docs/b.md": "[x][y]\n\n[y]: c.md\n"}, "docs/b.md:3: links to c.md"),
    "a dead anchor": ({"docs/b.md": "[x](a.md#b)\n"}, "docs/b.md:1: links to #b"),
    "an anchor that is in code": ({"docs/b.md": "[x](a.md#no-section)\n"}, "docs/b.md:1: links to #no-section"),
    "a third section of two": ({"docs/b.md": "[x](a.md#again-2)\n"}, "docs/b.md:1: links to #again-2"),
    "a link out of the repository": ({"docs/b.md": "[x](../../a.md)\n"}, "docs/b.md:1: links to ../../a.md"),
    "an absolute link": ({"docs/b.md": "[x](/docs/a.md)\n"}, "docs/b.md:1: links to /docs/a.md"),
    "an empty link": ({"docs/b.md": "[x]()\n"}, "docs/b.md:1: has a link to nothing"),
    "a link in the item of a list": ({"docs/b.md": "- a\n\n    [x](c.md)\n"}, "docs/b.md:3: links to c.md"),
}
CLEAN_PAGES = {
    "index.html": "<link rel=\"stylesheet\" href=\"s/a.css?digest=1\"><script src=\"a.js\"></script>"
                  "<a href=\"b.html#x\">b</a> <a href=\"https://example.org/\">c</a> <img src=\"data:image/png;base64,\">"
                  "<p id=\"top\"><a href=\"#top\">top</a> <a href=\"#\">all</a>",
    "b.html": "<p id=\"x\"><a href=\"index.html\">a</a>",
    "a.js": "var a = 'https://example.org/';\n",
    "s/a.css": "@import url(b.css); p { background: url('data:,') } /* url(nowhere) */\n",
    "s/b.css": "",
}
FAULTY_PAGES = {
    "a dead link": ({"b.html": "<p id=\"x\">\n<a href=\"c.html\">"}, "b.html:2: links to c.html"),
    "a dead anchor": ({"b.html": ""}, "index.html:1: links to #x"),
    "a script of elsewhere": ({"c.html": "<script src=\"https://example.org/a.js\">"}, "c.html:1: takes https://example.org/a.js"),
    "a picture of elsewhere": ({"c.html": "<img src=\"//example.org/a.png\">"}, "c.html:1: takes //example.org/a.png"),
    "a style of elsewhere": ({"c.html": "<link href=\"http://example.org/a.css\">"}, "c.html:1: takes http://example.org/a.css"),
    "a font of elsewhere": ({"s/b.css": "@font-face { src: url(https://example.org/a.woff) }"}, "s/b.css: takes https://example.org/a.woff"),
    "a style in the page": ({"c.html": "<style>@import \"https://example.org/a.css\";</style>"}, "c.html:1: takes https://example.org/a.css"),
    "a style that is not there": ({"s/b.css": "@import \"c.css\";"}, "s/b.css: links to c.css"),
    "an address of a web server": ({"s/b.css": "@import url(/javascript/n.css);"}, "s/b.css: links to /javascript/n.css, outside"),
    "a link out of the site": ({"c.html": "<a href=\"../c.html\">"}, "c.html:1: links to ../c.html, outside"),
    "a folder": ({"c.html": "<a href=\"s/\">"}, "c.html:1: links to s/"),
    "a module": ({"a.js": "import a from './b.js';\n"}, "a.js: is a module"),
}


def faults_of(kind, files):
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            file = Path(folder, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return kind(folder).check()


def self_test():
    failures = []
    for kind, clean, faulty in ((MarkdownLinks, CLEAN_TEXTS, FAULTY_TEXTS), (SiteLinks, CLEAN_PAGES, FAULTY_PAGES)):
        if found := faults_of(kind, clean):
            failures.append("where every link is right:\n  " + "\n  ".join(found))
        for name, (changes, expected) in faulty.items():
            found = faults_of(kind, {**clean, **changes})
            if len(found) != 1 or not found[0].startswith(expected):
                failures.append(f"{name}: not found\n  " + "\n  ".join(found))
    for failure in failures:
        print(failure, file=sys.stderr)
    print(f"{len(FAULTY_TEXTS) + len(FAULTY_PAGES)} kinds of fault, {len(failures)} failures")
    return 1 if failures else 0


def main():
    arguments = sys.argv[1:]
    if arguments == ["--self-test"]:
        return self_test()
    if len(arguments) == 2 and arguments[0] == "--site":
        faults = SiteLinks(arguments[1]).check()
    elif not arguments:
        faults = MarkdownLinks(Path(__file__).resolve().parents[2]).check()
    else:
        sys.exit("usage: check_links.py [--site FOLDER | --self-test]")
    for sentence in faults:
        print(sentence, file=sys.stderr)
    print(f"{len(faults)} links that lead nowhere or elsewhere")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
