# SPDX-License-Identifier: GPL-3.0-or-later
"""Settings of Sphinx for the documentation site (docs/site/build.py)."""

import os
import shutil
from pathlib import Path

project = "Axis Compensation Wizard"
version = release = os.environ["AXISCOMP_VERSION"]
copyright = "the authors of the Axis Compensation Wizard, GPL-3.0-or-later" # the name is Sphinx's
extensions = ["myst_parser"]
myst_heading_anchors = 6 # as the web pages of a repository make them
# Files of docs/embedding that a page links to are downloads; code is shown as it stands, unless its
# language is said.
highlight_language = "none"
root_doc = "index"

html_theme = "furo"
html_title = f"{project} {release}"
html_logo = "axis-compensation-wizard.svg"
html_favicon = "axis-compensation-wizard-32.png"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_search_summary = False # would be fetched, which a page of a file may not
html_use_index = False
html_last_updated_fmt = None # the same sources are the same bytes

NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")


def finish(app, failure):
    """Debian's furo names a stylesheet by the address that a web server of Debian would have it at, and has
    its script in two modules, which a browser does not load from files. Here both are as upstream has them:
    part of the site, the script in one piece."""
    if failure:
        return
    static = Path(app.outdir, "_static")
    style = static / "styles/furo.css"
    shutil.copyfile(NORMALIZE, static / "styles/normalize.css")
    style.write_text(style.read_text().replace("url(/javascript/normalize.css/normalize.css)", "url(normalize.css)"))
    module = static / "scripts/gumshoe-patched.js"
    script = static / "scripts/furo.js"
    text = script.read_text()
    line = 'import Gumshoe from "./gumshoe-patched.js";\n'
    if line in text:
        script.write_text(module.read_text() + text.replace(line, ""))
        module.unlink()


def setup(app):
    app.connect("build-finished", finish)
