"""Lessons: the READMEs of the examples, with their pictures; they are written only there."""

import re
import shutil
import tomllib
from pathlib import Path
from typing import Any

from vrts.site.generated.markdown import container, text

LIST = "<!-- lessons -->"  # in the page `learn/index`: where the list of lessons goes
_LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)#\s]+)(#[^)\s]*)?\)")
_FILE_NOTE = re.compile(r"^<!-- .*? -->\n", re.M)
_LESSON = re.compile(r"(?:^|/)(\d\d-[\w-]+)(?:/README\.md)?/?$")
_MANUAL = re.compile(r"vrts/manual/(.+\.md)$")


def write_lessons(examples: Path, learn: Path) -> None:
    """Write a page for each example into a folder of the site's sources, and the list of them."""
    rows: list[str] = []
    for readme in sorted(examples.glob("*/README.md")):
        name = readme.parent.name
        told = _told(readme.parent / "lesson.toml")
        page = lesson(readme.read_text("utf-8"), name, told)
        (learn / f"{name}.md").write_text(page, "utf-8")
        rows.append(_row(name, page, told))
        pictures = readme.parent / "pictures"
        for picture in sorted(pictures.glob("*")) if pictures.is_dir() else ():
            if f"{name}/pictures/{picture.name}" in page:
                (learn / name / "pictures").mkdir(parents=True, exist_ok=True)
                shutil.copy(picture, learn / name / "pictures" / picture.name)
    index = learn / "index.md"
    if index.is_file():
        index.write_text(index.read_text("utf-8").replace(LIST, "\n".join(rows)), "utf-8")


def lesson(words: str, name: str, told: dict[str, Any] | None = None) -> str:
    """Return the page of a lesson: links lead to pages of the manual, other files are named."""
    page = _LINK.sub(lambda match: _link(match, name), _FILE_NOTE.sub("", words))
    if not told:
        return page
    title, _, rest = page.partition("\n")
    number = told["lesson"]["number"]
    copies = f"`vrts learn {number}` copies this lesson, `vrts learn next` leads you on."
    note = f"{_length(told)}. {copies}"
    return f"{title}\n\n{container('lesson-note', note)}{rest}"


def _told(path: Path) -> dict[str, Any]:
    """Return what a lesson says of itself; an example need not be a lesson."""
    return tomllib.loads(path.read_text("utf-8")) if path.is_file() else {}


def _length(told: dict[str, Any]) -> str:
    steps = told["step"]
    return f"{sum(step['minutes'] for step in steps)} minutes, {len(steps)} steps"


def _row(name: str, page: str, told: dict[str, Any]) -> str:
    title = page.partition("\n")[0].lstrip("# ")
    about = f"{text(told['lesson']['about'])} *{_length(told)}*" if told else ""
    return f"1. [{title}]({name}.md): {about}".rstrip(": ")


def _link(match: re.Match[str], name: str) -> str:
    sign, shown, target, place = match.groups()
    if ":" in target:
        return match[0]
    if sign:
        return f"![{shown}]({name}/{target})"
    page = _page(target)
    if page:
        return f"[{shown}]({page}{place or ''})"
    return f"{shown} (`examples/{name}/{target}`)"


def _page(target: str) -> str:
    """Return the page of the manual that holds what a link leads to; empty: none does."""
    if match := _LESSON.search(target):
        return f"{match[1]}.md"
    if match := _MANUAL.search(target):
        return f"../{match[1]}"
    return "../index.md" if target == "../../README.md" else ""
