"""Rules of the manual: sections that say what holds, how sure that is, and who says so."""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

_SECTION = re.compile(r"^\(([^)\n]+)\)=\n## (.+)\n((?:(?!^\(|^## ).*\n?)*)", re.M)
_FIELD = re.compile(r"^- \*\*(Status|Source|Code|On the robot):\*\* (.*\S)$", re.M)
_BLOCK = re.compile(r"^```\S+\n(.*?)^```$", re.M | re.S)


class Rule(NamedTuple):
    """One rule. Its text is Markdown."""

    page: str  # as `language/motion`
    label: str  # by which pages link to it, as `language-motion-align`
    title: str
    body: str
    fields: Mapping[str, str]  # Status, Source, Code, On the robot

    @property
    def name(self) -> str:
        """What code cites and `vrts manual` takes: `language/motion#align`."""
        return f"{self.page}#{self.label.removeprefix(self.page.replace('/', '-') + '-')}"

    @property
    def status(self) -> str:
        """How sure it is: documented, inferred or assumed."""
        return self.fields.get("Status", "")

    @property
    def source(self) -> str:
        """Who says so."""
        return self.fields.get("Source", "")

    @property
    def text(self) -> str:
        """What it says, without its fields."""
        return self.body.partition("- **Status")[0]

    @property
    def blocks(self) -> str:
        """The programs in it."""
        return "\n".join(_BLOCK.findall(self.body))

    @property
    def prose(self) -> str:
        """What it says, without programs and fields."""
        return _FIELD.sub("", _BLOCK.sub("", self.body))


def rules_in(page: str, text: str) -> Iterator[Rule]:
    """Yield the rules of a page of the manual, by its name and its text."""
    prefix = page.replace("/", "-") + "-"
    for label, title, body in _SECTION.findall(text):
        fields = dict(_FIELD.findall(body))
        if label.startswith(prefix) and "Status" in fields:
            yield Rule(page, label, title, body, fields)
