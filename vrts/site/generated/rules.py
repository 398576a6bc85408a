"""Rules of the pages in `manual/language`: which rule speaks of a word, and what it stands on."""

import re
from pathlib import Path
from typing import NamedTuple

_SECTION = re.compile(r"^\(([^)\n]*)\)=\n^## (.+)\n((?:(?!^\(|^## ).*\n?)*)", re.M)
_FIELD = re.compile(r"^- \*\*(Status|Source|Code):\*\* (.*\S)$", re.M)
_BLOCK = re.compile(r"^```\S+\n(.*?)^```$", re.M | re.S)


class Rule(NamedTuple):
    """One rule of the language."""

    label: str
    title: str
    status: str
    source: str
    blocks: str
    prose: str


def rules_of(folder: Path) -> tuple[Rule, ...]:
    """Return the rules of all pages in a folder of the manual."""
    found: list[Rule] = []
    for page in sorted(folder.glob("*.md")):
        for label, title, body in _SECTION.findall(page.read_text("utf-8")):
            fields = dict(_FIELD.findall(body))
            if "Status" in fields:
                status, source = fields["Status"], fields.get("Source", "")
                blocks = "\n".join(_BLOCK.findall(body))
                prose = _FIELD.sub("", _BLOCK.sub("", body))
                found.append(Rule(label, title, status, source, blocks, prose))
    return tuple(found)


def about(word: str, rules: tuple[Rule, ...], most: int = 3) -> list[Rule]:
    """Return the rules that speak of a word, those that have it in their titles first."""
    whole = re.compile(rf"(?<![\w.$#]){re.escape(word)}(?![\w]|\.\w)")

    def weight(rule: Rule) -> int:
        return (
            4 * bool(whole.search(rule.title))
            + 2 * bool(whole.search(rule.prose))
            + bool(whole.search(rule.blocks))
        )

    speaking = sorted((rule for rule in rules if weight(rule)), key=weight, reverse=True)
    return speaking[:most]
