"""Every diagnostic: the pages that `vrts explain` prints, a hundred codes a page."""

import re
from pathlib import Path

from vrts.site.generated.markdown import contents, text

FAMILIES = {
    "V1": ("Text and structure", "how a program is written"),
    "V2": ("Names and values", "what its names and numbers mean"),
    "V3": ("Motion", "where the arm goes, and how fast"),
    "V4": ("Contacts and marks", "what touches what, and what a task asks for"),
    "V5": ("Signals, time and futures", "what comes from outside, and when"),
    "V6": ("Scenes, tasks and their files", "what authors write"),
    "V7": ("Classes and shared sessions", "hand-ins, marks, rooms"),
    "V8": ("Real robots", "dispatch, logs, other controllers"),
    "V9": ("Everything else", "what has no other place"),
}
HEAD = """\
# Messages

Every message has a code and a name. `vrts explain V301` prints its text in the terminal, and so
does `vrts explain out-of-reach`.
"""
_TITLE = re.compile(r"# (V\d{3}) ([a-z0-9-]+)\n")


def message_pages(pages: Path) -> dict[str, str]:
    """Return the pages of the codes, by their names in `look-up/messages`."""
    found: dict[str, list[tuple[str, str, str]]] = {}
    for path in sorted(pages.glob("V*.md")):
        words = path.read_text("utf-8")
        title = _TITLE.match(words)
        if title is None:
            raise ValueError(f"{path.name} does not begin with a code and its name")
        body = words[title.end() :].strip()
        found.setdefault(title[1][:2], []).append((title[1], title[2], body))
    made = {family.lower(): _family(family, rows) for family, rows in found.items()}
    return {**made, "index": _index(found)}


def _family(family: str, rows: list[tuple[str, str, str]]) -> str:
    title, says = FAMILIES[family]
    sections = "\n".join(_section(*row) for row in rows)
    return f"# {family}xx: {title}\n\nMessages about {says}.\n\n{sections}"


def _section(key: str, slug: str, body: str) -> str:
    lower = re.sub(r"^## ", "### ", body, flags=re.M)
    return f"(message-{key.lower()})=\n## {key} {slug}\n\n{lower}\n"


def _index(found: dict[str, list[tuple[str, str, str]]]) -> str:
    lines = [
        HEAD,
        contents((family.lower() for family in found), hidden=True),
    ]
    for family, rows in found.items():
        title, says = FAMILIES[family]
        lines.append(f"## [{family}xx: {title}]({family.lower()}.md)\n\n{says.capitalize()}.\n")
        for key, slug, body in rows:
            first = body.split("\n\n", 1)[0]
            lines.append(f"- [{key} {text(slug)}](#message-{key.lower()}): {first}")
        lines.append("")
    return "\n".join(lines)
