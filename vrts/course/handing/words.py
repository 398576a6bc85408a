"""A README as blocks and spans, so that no page ever takes what somebody wrote for markup.

It reads what READMEs of tasks use of Markdown: headings, paragraphs, lists, tables, blocks of code,
and within lines code, bold, slanted and links. All else is text.
"""

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Final

import msgspec

MOST_BLOCKS: Final = 600
MOST_SPANS: Final = 400  # of a block
DEPTHS: Final = 4


class Span(msgspec.Struct, frozen=True, omit_defaults=True):
    """A piece of a line."""

    text: str
    kind: str = ""  # code, strong, em, link
    to: str = ""  # address of a link


Spans = tuple[Span, ...]


class Item(msgspec.Struct, frozen=True, omit_defaults=True):
    """A line of a list."""

    spans: Spans
    depth: int = 0


class Block(msgspec.Struct, frozen=True, omit_defaults=True):
    """A paragraph, or what stands in its place."""

    kind: str  # heading, text, code, list, numbers, table
    level: int = 0  # of a heading, from 1
    spans: Spans = ()
    items: tuple[Item, ...] = ()
    rows: tuple[tuple[Spans, ...], ...] = ()  # the first is the head


_FENCE: Final = re.compile(r" {0,3}(`{3,}|~{3,})")
_HEADING: Final = re.compile(r"(#{1,6})\s+(.*?)\s*#*$")
_ITEM: Final = re.compile(r"(\s*)([-*+]|\d{1,9}[.)])\s+(.*)$")
_RULE: Final = re.compile(r"\s*([-*_])(\s*\1){2,}\s*$")
_TABLE: Final = re.compile(r"\s*\|.*\|\s*$")
_TABLE_LINE: Final = re.compile(r"[\s|:-]+$")
_COMMENT: Final = re.compile(r"<!--.*?(?:-->|\Z)", re.S)
_INLINE: Final = re.compile(
    r"(?P<ticks>`+)(?P<code>.+?)(?P=ticks)(?!`)"
    r"|!\[(?P<picture>[^\]\n]{0,200})\]\([^)\s]{0,400}\)"
    r"|\[(?P<link>[^\]\n]{1,200})\]\((?P<to>[^)\s]{1,400})\)"
    r"|\*\*(?P<strong>[^*\n]{1,400})\*\*"
    r"|(?<![\w*])\*(?P<em>[^*\s][^*\n]{0,400})\*(?![\w*])"
)


def blocks_of(text: str) -> tuple[Block, ...]:
    """Return a README as blocks, without its comments."""
    lines = _COMMENT.sub("", text.replace("\r\n", "\n")).split("\n")
    found: list[Block] = []
    for block in _blocks(lines):
        found.append(block)
        if len(found) == MOST_BLOCKS:
            break
    return tuple(found)


def _blocks(lines: Sequence[str]) -> Iterator[Block]:
    k = 0
    while k < len(lines):
        line = lines[k]
        fence, heading = _FENCE.match(line), _HEADING.match(line)
        if not line.strip() or _RULE.match(line):
            k += 1
        elif fence is not None:
            end = k + 1
            while end < len(lines) and not lines[end].strip().startswith(fence[1]):
                end += 1
            yield Block("code", spans=(Span("\n".join(lines[k + 1 : end])),))
            k = end + 1
        elif heading is not None:
            yield Block("heading", len(heading[1]), spans_of(heading[2]))
            k += 1
        elif _TABLE.match(line):
            end = _while(lines, k, lambda one: _TABLE.match(one) is not None)
            yield _table(lines[k:end])
            k = end
        elif _ITEM.match(line):
            end = _while(lines, k, lambda one: bool(one.strip()) and not _HEADING.match(one))
            yield _list(lines[k:end])
            k = end
        else:
            end = _while(lines, k, _goes_on)
            yield Block("text", spans=spans_of(" ".join(one.strip(" >") for one in lines[k:end])))
            k = end


def _while(lines: Sequence[str], k: int, fits: Callable[[str], bool]) -> int:
    end = k + 1
    while end < len(lines) and fits(lines[end]):
        end += 1
    return end


def _goes_on(line: str) -> bool:
    other = (_FENCE, _HEADING, _ITEM, _TABLE, _RULE)
    return bool(line.strip()) and not any(form.match(line) for form in other)


def _table(lines: Sequence[str]) -> Block:
    rows = [line for line in lines if not _TABLE_LINE.fullmatch(line)]
    cells = (tuple(spans_of(cell) for cell in row.strip().strip("|").split("|")) for row in rows)
    return Block("table", rows=tuple(cells))


def _list(lines: Sequence[str]) -> Block:
    items: list[tuple[int, str]] = []
    first = _ITEM.match(lines[0])
    for line in lines:
        item = _ITEM.match(line)
        if item is not None:
            items.append((min(DEPTHS, len(item[1].expandtabs(4)) // 2), item[3]))
        else:
            depth, words = items[-1]
            items[-1] = (depth, f"{words} {line.strip()}")
    kind = "numbers" if first is not None and first[2][0].isdigit() else "list"
    return Block(kind, items=tuple(Item(spans_of(words), depth) for depth, words in items))


def spans_of(text: str) -> Spans:
    """Return a line as pieces."""
    text = text.strip()
    found: list[Span] = []
    at = 0
    for match in _INLINE.finditer(text):
        if match.start() > at:
            found.append(Span(text[at : match.start()]))
        found.append(_span(match))
        at = match.end()
        if len(found) >= MOST_SPANS:
            break
    if text[at:]:
        found.append(Span(text[at:]))
    return tuple(found)


def _span(match: "re.Match[str]") -> Span:
    if match["code"] is not None:
        return Span(match["code"].strip(), "code")
    if match["picture"] is not None:
        return Span(match["picture"], "em")
    if match["link"] is not None:
        leads = match["to"].startswith(
            ("https://", "http://")
        )  # others lead into the task's folder
        return Span(match["link"], "link", match["to"]) if leads else Span(match["link"])
    if match["strong"] is not None:
        return Span(match["strong"], "strong")
    return Span(match["em"], "em")
