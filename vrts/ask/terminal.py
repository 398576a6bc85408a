"""A page as lines of a terminal: headings, wrapped text, lists, tables, code.

Only the Markdown that the manual uses is known. What is for the site alone is left out.
"""

import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from vrts.report.plain import visible

WIDEST = 88  # columns: longer lines are hard to read
KEPT = "\u00a0"  # a blank at which no line ends, until the text is wrapped
BOLD, DIM, CODE, OFF = "\x1b[1m", "\x1b[2m", "\x1b[36m", "\x1b[0m"

_LABEL = re.compile(r"^\(([^)\n]+)\)=\n", re.M)
_DIRECTIVE = re.compile(r"^(:{3,}|`{3,})\{.*?^\1\n?", re.M | re.S)
_COMMENT = re.compile(r"<!--.*?-->\n?", re.S)
_PICTURE = re.compile(r"!\[[^\]]*\]\([^)]*\)\n?")
_LINK = re.compile(r"\[((?:[^\[\]]|\[[^\]]*\])+)\]\(([^)]+)\)")
_SPAN = re.compile(r"(`+)(.+?)\1|\*\*(.+?)\*\*|(?<![\w*])\*([^*\n]+)\*(?!\w)", re.S)
_ITEM = re.compile(r"^(\s*)([-*]|\d+\.) (.*)$")
_CODE = re.compile(r"^- \*\*Code:\*\* .*\n?", re.M)  # files of vrts: for those who change it
_ROLE = re.compile(r"\{[a-z:]+\}(?=`)")

Link = Callable[[str, str], str]  # words and target of a link to what is shown


class Look(NamedTuple):
    """How text is shown."""

    width: int
    color: bool


def rendered(text: str, look: Look, link: Link) -> str:
    """Return Markdown as text for a terminal.

    Args:
        text: The page, without front matter.
        look: Width in columns and whether there are colours.
        link: What is shown for the words and the target of a link.
    """
    for gone in (_LABEL, _DIRECTIVE, _COMMENT, _PICTURE, _CODE, _ROLE):
        text = gone.sub("", text)
    shown: list[str] = []
    for kind, lines in _blocks(text.splitlines()):
        if shown:
            shown.append("")
        shown += _block(kind, lines, look, link)
    return visible_with_colors("\n".join(shown).strip("\n").replace(KEPT, " "))


def visible_with_colors(text: str) -> str:
    """Return text in which nothing steers a terminal but the colours made here."""
    pieces = re.split("(\x1b\\[(?:0|1|2|36)m)", text)
    return "".join(piece if number % 2 else visible(piece) for number, piece in enumerate(pieces))


def _blocks(lines: Sequence[str]) -> list[tuple[str, list[str]]]:
    """Return the blocks of a text: their kind, and their lines."""
    found: list[tuple[str, list[str]]] = []
    kind = ""
    for line in lines:
        fence = line.startswith("```")
        if kind == "code":
            kind = "" if fence else kind
            if not fence:
                found[-1][1].append(line)
            continue
        begun = _kind(line)
        if fence:
            found.append(("code", []))
            kind = "code"
        elif begun in ("blank", "heading"):
            if begun == "heading":
                found.append((begun, [line]))
            kind = ""
        elif kind == begun or (kind == "list" and begun == "paragraph"):
            found[-1][1].append(line)
        else:
            found.append((begun, [line]))
            kind = begun
    return found


def _kind(line: str) -> str:
    if not line.strip():
        return "blank"
    if line.startswith("#"):
        return "heading"
    if line.startswith("|"):
        return "table"
    return "list" if _ITEM.match(line) else "paragraph"


def _block(kind: str, lines: list[str], look: Look, link: Link) -> list[str]:
    match kind:
        case "heading":
            words = _inline(lines[0].lstrip("# "), look._replace(color=False), link, ticks=False)
            words = words.replace(KEPT, " ")
            line = "=" if lines[0].startswith("# ") else "-"
            return [f"{BOLD}{words}{OFF}"] if look.color else [words, line * len(words)]
        case "code":
            return [
                f"    {CODE}{line}{OFF}" if look.color and line else f"    {line}" for line in lines
            ]
        case "table":
            return _table([_inline_row(line, look, link) for line in lines], look.width)
        case "list":
            return _list(lines, look, link)
        case _:
            return _wrapped(_inline(" ".join(lines), look, link), look.width)


def _list(lines: list[str], look: Look, link: Link) -> list[str]:
    items: list[list[str]] = []
    for line in lines:
        item = _ITEM.match(line)
        if item:
            items.append([item[1], item[2], item[3]])
        else:
            items[-1][2] += " " + line.strip()
    shown: list[str] = []
    for indent, mark, words in items:
        mark = "•" if mark in "-*" else mark
        first = f"  {indent}{mark} "
        shown += _wrapped(_inline(words, look, link), look.width, first, " " * len(first))
    return shown


def _inline_row(line: str, look: Look, link: Link) -> list[str]:
    cells = re.split(r"(?<!\\)\|", line.strip().strip("|"))
    return [_inline(cell.strip(), look, link) for cell in cells]


def _table(rows: list[list[str]], width: int) -> list[str]:
    """Return a table; one that is too wide as a list of its rows."""
    rows = [row for row in rows if not all(re.fullmatch(r":?-+:?", cell) for cell in row)]
    rows = [row for row in rows if any(row)]
    columns = max(map(len, rows), default=0)
    rows = [row + [""] * (columns - len(row)) for row in rows]
    widths = [max(_seen(cell) for cell in column) for column in zip(*rows, strict=True)]
    if sum(widths) + 2 * columns <= width:
        return [
            "  ".join(_padded(c, w) for c, w in zip(r, widths, strict=True)).rstrip() for r in rows
        ]
    shown: list[str] = []
    for row in rows:
        shown += _wrapped(row[0], width, "  ", "    ")
        for cell in row[1:]:
            shown += _wrapped(cell, width, "      ", "      ") if cell else []
    return shown


def _inline(text: str, look: Look, link: Link, *, ticks: bool = True) -> str:
    text = _LINK.sub(lambda found: link(found[1], found[2]), text)

    def shown(found: re.Match[str]) -> str:
        if found[2] is not None:
            code = found[2].replace("\\|", "|").strip().replace(" ", KEPT)
            mark = "`" if ticks else ""
            return f"{CODE}{code}{OFF}" if look.color else f"{mark}{code}{mark}"
        words = found[3] or found[4]
        return f"{BOLD}{words}{OFF}" if look.color else words

    return _SPAN.sub(shown, text)


class _Wrapper(textwrap.TextWrapper):
    """Wraps words without counting colours."""

    def _wrap_chunks(self, chunks: list[str]) -> list[str]:
        lines: list[str] = []
        line, length = "", 0
        indent = self.initial_indent
        for chunk in chunks:
            size = _seen(chunk)
            if length and len(indent) + length + size > self.width and not chunk.isspace():
                lines.append(indent + line.rstrip())
                indent, line, length = self.subsequent_indent, "", 0
            if length or not chunk.isspace():
                line, length = line + chunk, length + size
        return [*lines, indent + line.rstrip()] if line.strip() else lines


def _wrapped(text: str, width: int, first: str = "", others: str = "") -> list[str]:
    wrapper = _Wrapper(width, initial_indent=first, subsequent_indent=others)
    wrapper.break_long_words = wrapper.break_on_hyphens = False
    return wrapper.wrap(text)


_COLORS = re.compile("\x1b\\[[0-9;]*m")


def _seen(text: str) -> int:
    return len(_COLORS.sub("", text))


def _padded(text: str, width: int) -> str:
    return text + " " * (width - _seen(text))


def to_type(target: str, at: str, labels: Mapping[str, str]) -> str:
    """Return what to type for the target of a link; empty: it leads out of the manual.

    Args:
        target: As the page has it: a file, a label behind `#`, an address.
        at: Name of the page on which it stands.
        labels: Names of sections, by their labels.
    """
    path, _, anchor = target.partition("#")
    if re.match(r"[a-z]+:", target) or (path and not path.endswith(".md")):
        return ""
    if not path:
        return labels.get(anchor, "")
    parts = at.split("/")[:-1]
    for piece in path.removesuffix(".md").split("/"):
        if piece == "..":
            parts = parts[:-1]
        elif piece != ".":
            parts.append(piece)
    return labels.get(anchor, "/".join(parts))
