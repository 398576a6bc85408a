"""All pages there are, from the files of the package and from its tables of words."""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable

from vrts.ask.asked import asked_for
from vrts.ask.other_languages import names_elsewhere
from vrts.ask.page import Kind, Page
from vrts.ask.words import facts

FRONT = re.compile(r"\A---\n(.*?)^---\n+", re.M | re.S)
KEYWORDS = re.compile(r"^\s*keywords:\s*(.*(?:\n {4,}.*)*)", re.M)
LABEL = re.compile(r"^\(([^)\n]+)\)=\n", re.M)
SECTION = re.compile(r"(?:^\(([^)\n]+)\)=\n)?^## (.+)\n", re.M)
RULES = ("language/", "robots/")  # folders of rules, one a section
RECIPES = "do/"


@cache
def manual_files() -> Mapping[str, str]:
    """Return the Markdown files of the manual by name, without `.md`."""
    return dict(_walked(files("vrts").joinpath("manual"), ""))


def _walked(folder: Traversable, prefix: str) -> Iterator[tuple[str, str]]:
    for item in sorted(folder.iterdir(), key=lambda item: item.name):
        if item.is_dir():
            if not item.name.startswith(("_", ".")):
                yield from _walked(item, f"{prefix}{item.name}/")
        elif item.name.endswith(".md"):
            yield f"{prefix}{item.name.removesuffix('.md')}", item.read_text("utf-8")


def all_pages(commands: Mapping[str, str]) -> Iterator[Page]:
    """Yield every page.

    Args:
        commands: What each command of the command line does, by its name.
    """
    asked = asked_for()
    for page in _all(commands):
        yield page._replace(asked=asked.get(page.name, ()))


def _all(commands: Mapping[str, str]) -> Iterator[Page]:
    for name, text in manual_files().items():
        yield from _of_file(name, text)
    yield from _messages()
    yield from _words()
    for command, says in commands.items():
        yield Page(f"vrts {command}", Kind.COMMAND, f"vrts {command}", says)


def without_front(text: str) -> tuple[str, str]:
    """Return a Markdown file without what stands before its title, and its keywords."""
    front = FRONT.match(text)
    if front is None:
        return text, ""
    keywords = KEYWORDS.search(front[1])
    return text[front.end() :], " ".join(keywords[1].split()) if keywords else ""


def title_of(text: str) -> str:
    """Return the first heading of a Markdown text."""
    found = re.search(r"^# (.+)$", text, re.M)
    return found[1].replace("`", "") if found else ""


def _of_file(name: str, text: str) -> Iterator[Page]:
    body, keywords = without_front(text)
    title = title_of(body)
    if name.startswith(RECIPES):
        if not name.endswith("/index"):
            yield Page(name, Kind.RECIPE, title, body, keywords)
        return
    if name == "index" or name.endswith("/index") or not title:
        return
    kind = Kind.RULE if name.startswith(RULES) else Kind.BACKGROUND
    pieces = SECTION.split(body)  # before, then label, heading and text of each section
    yield Page(name, kind, title, pieces[0], keywords)
    for label, heading, content in zip(pieces[1::3], pieces[2::3], pieces[3::3], strict=True):
        text = f"# {heading}\n{content}"
        anchor = _anchor(name, label) if label else _slug(heading)
        yield Page(f"{name}#{anchor}", kind, heading.replace("`", ""), text, keywords, section=True)


@cache
def section_names() -> Mapping[str, str]:
    """Return the names of sections by their labels, by which pages link to them."""
    return {
        label: f"{name}#{_anchor(name, label)}"
        for name, text in manual_files().items()
        for label in LABEL.findall(text)
    }


def _anchor(name: str, label: str) -> str:
    """Return a label without the name of its page: `motion-move` of `language/motion`: `move`."""
    last = name.rpartition("/")[2]
    return label.removeprefix(name.replace("/", "-") + "-").removeprefix(f"{last}-")


def _slug(heading: str) -> str:
    return re.sub(r"[^a-z0-9]+", "-", heading.lower()).strip("-")


def _messages() -> Iterator[Page]:
    for item in sorted(files("vrts").joinpath("pages").iterdir(), key=lambda item: item.name):
        if item.name.endswith(".md"):
            code = item.name.removesuffix(".md")
            text = item.read_text("utf-8")
            yield Page(code, Kind.MESSAGE, title_of(text), text)


def _words() -> Iterator[Page]:
    elsewhere = names_elsewhere()
    for name, known in facts().items():
        said = "\n".join(f"{fact.form}: {fact.about}" for fact in known)
        yield Page(name, Kind.WORD, name, said, " ".join(elsewhere.get(name, ())))
