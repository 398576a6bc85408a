"""Pieces of Markdown, as MyST reads it."""

import re
from collections.abc import Iterable, Sequence

_SIGNS = re.compile(r"([\\`*_{}\[\]<>#|$~])")


def text(words: str) -> str:
    """Return plain words so that no sign in them means anything; `code` stays code."""
    pieces = re.split(r"(`[^`]+`)", " ".join(words.split()))
    return "".join(
        code(piece[1:-1]) if index % 2 else _SIGNS.sub(r"\\\1", piece)
        for index, piece in enumerate(pieces)
    )


def code(words: str) -> str:
    """Return words as code within a line."""
    ticks = "``" if "`" in words else "`"
    pad = " " if "`" in words else ""
    return f"{ticks}{pad}{words}{pad}{ticks}" if words else ""


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table whose cells are Markdown already; a bar in a cell ends no cell."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join(
        "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n" for cells in lines
    )


def block(language: str, body: str) -> str:
    """Return a block of code."""
    longest = max((len(found) for found in re.findall(r"`{3,}", body)), default=2)
    fence = "`" * (longest + 1)
    return f"{fence}{language}\n{body.rstrip()}\n{fence}\n"


def container(kind: str, body: str) -> str:
    """Return a part of a page with a class for the style sheet."""
    return f"::::{{container}} {kind}\n{body.rstrip()}\n::::\n"


def contents(pages: Iterable[str], *, hidden: bool = False) -> str:
    """Return a table of contents of pages."""
    options = ":hidden:\n" if hidden else ":maxdepth: 1\n"
    return f":::{{toctree}}\n{options}\n" + "".join(f"{page}\n" for page in pages) + ":::\n"


def anchor(*parts: str) -> str:
    """Return a label that is one of the whole manual."""
    named = "-".join(parts).lower().replace("$", "text-").replace("#", "joints-")
    return re.sub(r"[^a-z0-9-]+", "-", named).strip("-")
