# SPDX-License-Identifier: GPL-3.0-or-later
"""Pages of the C++ API: what doxygen has read in the public headers, as reStructuredText.

A page for each folder, on it a section for each header, in the order of the header. Doxygen's own HTML has
a thousand pages in a look of its own and no way to darken them; of these the site's search, colours and
navigation are the same as everywhere.
"""

import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

WIDTH = 88
SHOWN_KINDS = ("function", "signal", "slot", "variable", "typedef", "enum", "define")
# Marks of the private use area stand for references until a signature has its blanks.
FIRST_MARK = 0xE000


def escaped(text):
    return re.sub(r"([*`|_\\])", r"\\\1", text)


def plain(element):
    return "" if element is None else "".join(element.itertext()).strip()


def indented(text, by="   "):
    return "\n".join(by + line if line else "" for line in text.split("\n"))


class Signature:
    """A declaration with references in it, first as words, then with blanks where a person puts them."""

    def __init__(self, known):
        self.known = known
        self.references = []
        self.text = ""

    def add(self, part):
        if isinstance(part, str):
            self.text += part
        elif part is not None:
            self.text += part.text or ""
            for child in part:
                if child.tag == "ref" and child.get("refid") in self.known:
                    self.text += chr(FIRST_MARK + len(self.references))
                    self.references.append((child.text, child.get("refid")))
                else:
                    self.text += plain(child)
                self.text += child.tail or ""
        return self

    def __str__(self):
        tidy = re.sub(r"\s+", " ", self.text)
        tidy = re.sub(r"< (?!<)", "<", re.sub(r" >", ">", tidy))
        return re.sub(r" ([&*]+)(?=\s|\)|,|$|>|\w)", r"\1 ", tidy).replace("& )", "&)").replace("  ", " ").strip()

    def length(self):
        return sum(len(self.references[ord(c) - FIRST_MARK][0]) if ord(c) >= FIRST_MARK else 1 for c in str(self))

    def rst(self):
        return "".join(self.reference(c) if ord(c) >= FIRST_MARK else escaped(c) for c in str(self))

    def reference(self, mark):
        name, target = self.references[ord(mark) - FIRST_MARK]
        return rf"\ :ref:`{escaped(name)} <{target}>`\ "


class CppPages:
    def __init__(self, xml, root, documents):
        """xml: doxygen's folder; documents: the pages of the site by the paths of their sources."""
        self.root = root
        self.documents = documents
        self.files = {}
        self.compounds = {}
        self.namespace_members = {}
        for file in sorted(Path(xml).glob("*.xml")):
            for compound in ElementTree.parse(file).getroot().iter("compounddef"):
                self.compounds[compound.get("id")] = compound
                if compound.get("kind") == "file":
                    self.files[compound.find("location").get("file")] = compound
                if compound.get("kind") in ("file", "namespace"):
                    self.gather(compound)
        self.known = set()
        for compound in self.files.values():
            for entry in self.entries(compound):
                self.known.add(entry.get("id"))
                if entry.tag == "compounddef":
                    self.known.update(m.get("id") for m in self.members(entry))

    def gather(self, compound):
        """Functions, enumerations and so on by their header; an anonymous namespace is nobody else's."""
        if "@" in plain(compound.find("compoundname")):
            return
        for member in compound.iter("memberdef"):
            if member.get("kind") in SHOWN_KINDS:
                members = self.namespace_members.setdefault(member.find("location").get("file"), {})
                members[member.get("id")] = member

    def pages(self):
        """The path of each folder, and its page."""
        folders = {}
        for path in sorted(self.files):
            folders.setdefault(Path(path).parent.as_posix(), []).append(path)
        for folder, paths in folders.items():
            parts = [self.heading(folder, "=")]
            parts += [self.header(path) for path in paths]
            yield folder, "\n\n".join(parts) + "\n"

    def entries(self, file):
        """Classes and members of namespaces in one header, as they stand there."""
        found = []
        for inner in file.findall("innerclass"):
            compound = self.compounds.get(inner.get("refid"))
            if compound is not None and compound.get("prot") == "public" and "@" not in inner.text:
                found.append(compound)
        found += self.namespace_members.get(file.find("location").get("file"), {}).values()
        return sorted(found, key=lambda e: int(e.find("location").get("line")))

    def members(self, compound):
        found = [m for m in compound.iter("memberdef")
                 if m.get("prot") == "public" and m.get("kind") in SHOWN_KINDS]
        return sorted(found, key=lambda m: int(m.find("location").get("line")))

    @staticmethod
    def heading(title, mark):
        return f"{escaped(title)}\n{mark * max(3, len(escaped(title)))}"

    def header(self, path):
        parts = [self.heading(Path(path).name, "-"), f".. code-block:: cpp\n\n   #include \"{path}\""]
        parts.append(self.descriptions(self.files[path]))
        for entry in self.entries(self.files[path]):
            parts.append(self.compound(entry) if entry.tag == "compounddef" else self.member(entry))
        return "\n\n".join(p for p in parts if p)

    def compound(self, compound):
        name = plain(compound.find("compoundname")).removeprefix("axiscomp::")
        declaration = Signature(self.known)
        self.add_template(declaration, compound)
        declaration.add(f"{compound.get('kind')} {plain(compound.find('compoundname'))}")
        bases = [plain(b) for b in compound.findall("basecompoundref")]
        if bases:
            declaration.add(" : " + ", ".join(bases))
        parts = [f".. _{compound.get('id')}:", self.heading(name, "^"), self.literal([declaration.rst()]),
                 self.descriptions(compound)]
        parts += [self.member(m) for m in self.members(compound)]
        return "\n\n".join(p for p in parts if p)

    def member(self, member):
        parts = [self.literal(self.declaration(member)), self.descriptions(member)]
        if member.get("kind") == "enum":
            parts.append(self.enumerators(member))
        body = "\n\n".join(p for p in parts if p)
        return f".. _{member.get('id')}:\n\n.. container:: member\n\n{indented(body)}"

    @staticmethod
    def literal(lines):
        # With the empty mark in front Sphinx does not take it for plain code, which it would colour.
        return ".. parsed-literal::\n   :class: signature\n\n" + indented("\\ " + "\n".join(lines))

    @staticmethod
    def add_template(declaration, element):
        parameters = element.find("templateparamlist")
        if parameters is None:
            return
        declaration.add("template <")
        for number, parameter in enumerate(parameters.findall("param")):
            declaration.add(", " if number else "").add(parameter.find("type"))
            for name in ("declname", "defval"):
                if plain(parameter.find(name)):
                    declaration.add((" = " if name == "defval" else " ") + plain(parameter.find(name)))
        declaration.add("> ")

    def declaration(self, member):
        """The lines of a declaration: one where it is short enough, else one for each parameter."""
        kind, name = member.get("kind"), plain(member.find("name"))
        declaration = Signature(self.known)
        if kind == "define":
            parameters = ", ".join(plain(p.find("defname")) for p in member.findall("param"))
            return [escaped(f"#define {name}" + (f"({parameters})" if parameters else ""))]
        if kind == "enum":
            return [escaped(f"enum {'class ' if member.get('strong') == 'yes' else ''}{name}")]
        self.add_template(declaration, member)
        if kind == "typedef":
            return [declaration.add(f"using {name} = ").add(member.find("type")).rst()]
        if member.get("static") == "yes":
            declaration.add("static ")
        declaration.add(member.find("type"))
        if plain(member.find("type")):
            declaration.add(" ")
        declaration.add(name)
        if kind == "variable":
            return [declaration.add(" " + plain(member.find("initializer"))).rst()]
        return self.call(declaration, member)

    def call(self, declaration, member):
        parameters = []
        for parameter in member.findall("param"):
            one = Signature(self.known).add(parameter.find("type"))
            if plain(parameter.find("declname")):
                one.add(" " + plain(parameter.find("declname")) + plain(parameter.find("array")))
            if plain(parameter.find("defval")):
                one.add(" = " + re.sub(r"\s+", " ", plain(parameter.find("defval"))))
            parameters.append(one)
        suffix = re.sub(r"^.*\)", ")", re.sub(r"\s+", " ", plain(member.find("argsstring"))))
        length = declaration.length() + 2 + sum(p.length() + 2 for p in parameters) + len(suffix)
        if length <= WIDTH:
            return [declaration.rst() + "(" + ", ".join(p.rst() for p in parameters) + escaped(suffix)]
        lines = [declaration.rst() + "("]
        lines += ["    " + p.rst() + "," for p in parameters]
        lines[-1] = lines[-1].removesuffix(",") + escaped(suffix)
        return lines

    def enumerators(self, member):
        items = []
        for value in member.findall("enumvalue"):
            text = self.descriptions(value)
            item = f"``{plain(value.find('name'))}``" + (": " + text if text else "")
            items.append("- " + indented(item, "  ").lstrip())
        return "\n".join(items)

    def descriptions(self, element):
        parts = [self.description(element.find(tag)) for tag in ("briefdescription", "detaileddescription")]
        return "\n\n".join(p for p in parts if p)

    def description(self, element):
        if element is None:
            return ""
        return "\n\n".join(b for b in (block for child in element for block in self.blocks(child)) if b)

    def blocks(self, para):
        """A paragraph of doxygen may hold lists and code: each is a block of its own."""
        if para.tag != "para":
            raise ValueError(f"doxygen's <{para.tag}> has no form yet; write the comment without it")
        line = self.cited(escaped(para.text or ""))
        for child in para:
            if child.tag in ("itemizedlist", "verbatim", "blockquote"):
                yield line.strip()
                yield self.block(child)
                line = self.cited(escaped((child.tail or "").lstrip()))
            else:
                line += self.inline(child) + self.cited(escaped(child.tail or ""))
        yield line.strip()

    def block(self, element):
        if element.tag == "verbatim":
            return "::\n\n" + indented(element.text.strip("\n"))
        if element.tag == "blockquote": # a comment that begins with the sign >
            return "> " + self.description(element).strip()
        items = [self.description(item) for item in element.findall("listitem")]
        return "\n".join("- " + indented(item, "  ").lstrip() for item in items)

    def inline(self, element):
        if element.tag == "computeroutput":
            return rf"\ ``{plain(element)}``\ "
        if element.tag == "ref":
            text = plain(element)
            known = element.get("refid") in self.known
            return rf"\ :ref:`{escaped(text)} <{element.get('refid')}>`\ " if known else escaped(text)
        if element.tag == "ulink":
            return rf"\ `{escaped(plain(element))} <{element.get('url')}>`__\ "
        if element.tag == "ndash":
            return "--"
        if element.tag == "zwj":
            return ""
        raise ValueError(f"doxygen's <{element.tag}> in \"{plain(element)}\" has no form yet; "
                         "write the comment without it, or with `...` around it")

    def cited(self, text):
        """Documents that a comment names become links."""

        def link(found):
            path = found.group().replace("\\", "")
            page = self.documents.get(path)
            return rf"\ :doc:`{path} </{page}>`\ " if page else found.group()

        return re.sub(r"docs/[\w\\/-]+\.md|DECISIONS\.md", link, text)
