"""The site and the man pages, built from the texts of a checkout."""

import io
import re
import shutil
import tempfile
from collections.abc import Callable
from pathlib import Path

from sphinx.application import Sphinx
from sphinx.util.docutils import docutils_namespace, patch_docutils

from vrts.site.accessible import accessible, finding_beginnings
from vrts.site.configuration import configuration
from vrts.site.generated.assumptions_page import assumptions_page
from vrts.site.generated.cheat_sheet import cheat_sheet
from vrts.site.generated.command_pages import command_pages
from vrts.site.generated.debugger_page import debugger_page
from vrts.site.generated.lessons import write_lessons
from vrts.site.generated.message_pages import message_pages
from vrts.site.generated.python_page import python_page
from vrts.site.generated.schema_pages import schema_pages
from vrts.site.generated.word_pages import word_pages

PICTURE = re.compile(r"\]\((?:\.\./)+examples/([\w-]+/pictures/[\w.-]+)\)")
COLOUR = re.compile(r"\x1b\[[0-9;]*m")
SEARCH = "_static/searchtools.js"
NOT_NEEDED = (".buildinfo", "objects.inv", ".doctrees")


class NotBuilt(Exception):  # noqa: N818 -- names the situation
    """Sphinx gave up."""


def build(root: Path, html: Path, man: Path) -> str:
    """Build the site and the man pages; return what Sphinx finds wrong with them, a line each.

    A fault - a link that leads nowhere, a table that is none, a search that cannot be mended -
    spoils its place and nothing else. So it stops no installation; a test fails.

    Args:
        root: Folder with `pyproject.toml`.
        html: Folder for the site.
        man: Folder for the man pages.

    Raises:
        NotBuilt: Sphinx gave up.
    """
    faults: dict[str, None] = {}
    with tempfile.TemporaryDirectory() as work:
        source, trees = Path(work) / "source", Path(work) / "trees"
        write_sources(root, source)
        for builder, name in (("html", html), ("man", man)):
            out = Path(work) / builder
            said = _sphinx(source, out, trees, builder).replace(f"{source}/", "")
            faults |= dict.fromkeys(said.splitlines())
            for page in out.rglob("*.html"):
                page.write_text(accessible(page.read_text("utf-8")), "utf-8")
            if builder == "html":
                faults |= dict.fromkeys(mend_search(out / SEARCH))
            for left in NOT_NEEDED:
                (out / left).unlink(missing_ok=True)
            shutil.copytree(out, name, dirs_exist_ok=True)
    return "\n".join(faults)


def mend_search(script: Path) -> list[str]:
    """Let Sphinx's search find beginnings of titles, too; return why it cannot be done."""
    try:
        script.write_text(finding_beginnings(script.read_text("utf-8")), "utf-8")
    except (OSError, ValueError) as problem:
        return [f"{SEARCH}: {problem}"]
    return []


def write_sources(root: Path, source: Path) -> None:
    """Write all pages of the manual into a folder: those written by hand, and those made."""
    package = root / "vrts"
    shutil.copytree(package / "manual", source)
    write_lessons(root / "examples", source / "learn")
    for page in source.rglob("*.md"):
        words = page.read_text("utf-8")
        page.write_text(PICTURE.sub(_picture_of(root, source), words), "utf-8")
    pages = generated_pages(root)
    for name, words in pages.items():
        path = source / f"{name}.md"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(words, "utf-8")


def _picture_of(root: Path, source: Path) -> Callable[[re.Match[str]], str]:
    """Return what puts a picture of an example beside the pages, and says where it is then."""

    def moved(match: re.Match[str]) -> str:
        place = source / "learn" / match[1]
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(root / "examples" / match[1], place)
        return f"](/learn/{match[1]})"

    return moved


def generated_pages(root: Path) -> dict[str, str]:
    """Return the pages that are made of what vrts knows, by their names."""
    package = root / "vrts"
    folders = {
        "words": word_pages(package / "manual", root / "tests" / "spec"),
        "messages": message_pages(package / "pages"),
        "files": schema_pages(),
        "commands": command_pages(),
    }
    return {
        **{f"look-up/{f}/{n}": words for f, pages in folders.items() for n, words in pages.items()},
        "look-up/cheat-sheet": cheat_sheet(),
        "look-up/debugger": debugger_page(),
        "look-up/python": python_page(package),
        "understand/assumptions": assumptions_page(package),
    }


def _sphinx(source: Path, out: Path, trees: Path, builder: str) -> str:
    warnings = io.StringIO()
    with patch_docutils(), docutils_namespace():
        app = Sphinx(
            srcdir=source,
            confdir=None,
            outdir=out,
            doctreedir=trees,
            buildername=builder,
            confoverrides=configuration(),
            status=None,
            warning=warnings,
        )
        app.build()
    if app.statuscode:
        raise NotBuilt(warnings.getvalue() or f"Sphinx ended with {app.statuscode}")
    return COLOUR.sub("", warnings.getvalue())
