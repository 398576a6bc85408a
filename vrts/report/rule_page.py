"""The explanation page of a rule, taken apart for tools that show it in pieces."""

import re
from importlib.resources import files
from typing import NamedTuple

_HEADING = re.compile(r"^#+ ", re.MULTILINE)
_FENCE = re.compile(r"^```.*\n?", re.MULTILINE)


class RulePage(NamedTuple):
    """A page of `vrts/pages`."""

    summary: str  # the first paragraph, plain text
    meaning: str  # summary and why it matters, plain text
    text: str  # everything below the title, plain text
    markdown: str  # the same, as written


def rule_page(code: str) -> RulePage | None:
    """Return the page of a code; None for a code that has none."""
    file = files("vrts") / "pages" / f"{code}.md"
    if not file.is_file():
        return None
    markdown = file.read_text(encoding="utf-8").partition("\n")[2].strip()
    summary, _, rest = markdown.partition("\n\n## ")
    why = rest.partition("\n\n")[2].partition("\n\n## ")[0] if rest.startswith("Why") else ""
    meaning = "\n\n".join(part for part in (summary, why) if part)
    return RulePage(_plain(summary), _plain(meaning), _plain(markdown), markdown)


def _plain(markdown: str) -> str:
    return _HEADING.sub("", _FENCE.sub("", markdown)).replace("`", "").strip()
