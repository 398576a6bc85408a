"""A program as a numbered list of lines, with marks where something was found."""

import re
from collections.abc import Sequence
from functools import lru_cache

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.report.page.html import Markup, element, joined
from vrts.report.plain import shown

KEPT = 4096  # lines: a program is shown to two readers, and a class has many lines in common

_TOKEN = re.compile(
    r"""(?P<comment>;.*)|(?P<string>"[^"]*"?)|(?P<number>(?<![\w.$])\d+(?:\.\d*)?)"""
    r"""|(?P<word>^\s*(?:\d+\s+)?\.?[A-Za-z][\w.]*)""",
    re.VERBOSE,
)


def listing(source: SourceFile, findings: Sequence[Diagnostic]) -> Markup:
    """Return the program; line 17 has the id `L17` and jumps to the first finding on it."""
    first: dict[int, tuple[int, Diagnostic]] = {}
    for number, d in enumerate(findings, start=1):
        if d.primary and d.primary.span.source is source:
            first.setdefault(d.primary.span.line, (number, d))
    rows = [_line(number, text, first.get(number)) for number, text in enumerate(source.lines(), 1)]
    if rows and not source.line_text(len(rows)):
        rows.pop()  # after the last line end
    return element("ol", *rows, class_="source", id="source", tabindex="0", aria_label="Program")


def _line(number: int, text: str, found: tuple[int, Diagnostic] | None) -> Markup:
    code = _code(text)
    if found is None:
        return element("li", code, id=f"L{number}")
    index, d = found
    link = element(
        "a", "●", href=f"#finding-{index}", class_="dot", title=d.headline, aria_label=d.headline
    )
    return element("li", code, link, id=f"L{number}", class_=f"has-{d.severity.value}")


@lru_cache(maxsize=KEPT)
def _code(text: str) -> Markup:
    return element("code", _coloured(shown(text).text))


def _coloured(text: str) -> Markup:
    parts: list[str | Markup] = []
    at = 0
    for match in _TOKEN.finditer(text):
        kind = match.lastgroup or ""
        parts += [text[at : match.start()], element("span", match[0], class_=f"t-{kind}")]
        at = match.end()
    return joined([*parts, text[at:]])
