"""`.PROGRAM name(a, $b, c[])` to a name and formals."""

import re

from vrts.base.diagnostic import Rule
from vrts.lang.dialect import Dialect
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.splitter import DEFAULT_PROGRAM, INVALID_HEADER, Section
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import Formal

DUPLICATE_FORMAL = Rule("V217", "duplicate-formal")

_HEADER = re.compile(
    r"\.?PROGRAM(?:[ \t]+(?P<name>[A-Za-z][\w.]*))?[ \t]*(?:\((?P<formals>[^()]*)\))?(?P<rest>.*)$",
    re.IGNORECASE | re.ASCII,
)
_AS_TAIL = re.compile(r"[@#\d]")  # date, time and number that AS writes behind the header
_PIECE = re.compile(r"[^,\[]*(?:\[[^\]]*\]?[^,\[]*)*")  # up to a comma that is not inside `a[,]`
_FORMAL = re.compile(
    r"(?P<name>(?:\.?&?|&?\.?)[$#]?[A-Za-z][\w.]*)[ \t]*(?P<array>\[[ ,]*\])?$", re.ASCII
)


def read_header(section: Section, problems: Problems) -> tuple[str, tuple[Formal, ...]]:
    """Return name and formals of a program."""
    line = section.header
    if not line.text:
        return DEFAULT_PROGRAM, ()
    match = _HEADER.match(line.text)
    if match is None or not match["name"]:
        problems.error(
            INVALID_HEADER,
            "a program needs a name",
            line.start,
            line.end,
            notes=("VAL-II says *Invalid program or variable name*",),
            help=("write `.PROGRAM name` or `.PROGRAM name(a, b)`",),
        )
        return "", ()
    rest = match["rest"].strip()
    if _AS_TAIL.match(rest):
        rest = ""
    if rest.startswith(("(", "[", ",")) or (rest and match["formals"] is None):
        problems.error(
            INVALID_HEADER,
            f"`{rest[:40]}` does not belong to the name of a program",
            line.start + match.start("rest"),
            line.end,
            help=("write `.PROGRAM name` or `.PROGRAM name(a, b)`",),
        )
    formals: list[Formal] = []
    at = line.start + max(match.start("formals"), 0)
    taken: set[str] = set()
    for written in _pieces(match["formals"] or ""):
        start = at + len(written) - len(written.lstrip())
        at += len(written) + 1
        text = written.strip()
        formal = _FORMAL.match(text)
        if formal is None and (text or "," not in (match["formals"] or "")):
            if text:
                problems.error(
                    INVALID_HEADER,
                    f"`{text[:40]}` is not a formal argument",
                    start,
                    start + len(text),
                    help=("formals are names such as `n`, `$text`, `#point` or `row[]`",),
                )
            continue
        name = formal["name"].replace("&", "") if formal else ""
        if name[:1] == "." and name[1] in "$#":
            name = f"{name[1]}.{name[2:]}"  # `.$s` of AS, with its sigil first
        node = Name(name, start, start + len(name))
        if name and key(name) in taken:
            problems.error(
                DUPLICATE_FORMAL,
                f"`{name}` stands twice among the formals",
                node.start,
                node.end,
                help=("give each formal its own name",),
            )
            continue
        if name:
            taken.add(key(name))
        formals.append(Formal(node, bool(formal and formal["array"])))
    return key(match["name"]), tuple(formals)


def _pieces(formals: str) -> list[str]:
    """Return what stands between the commas of a list of formals."""
    pieces: list[str] = []
    at = 0
    while at <= len(formals):
        match = _PIECE.match(formals, at)
        assert match is not None
        pieces.append(match.group())
        at = match.end() + 1
    return pieces


def is_remarks(section: Section, dialect: Dialect) -> bool:
    """Return whether a section is the fake program in which the editor of AS keeps its remarks."""
    match = _HEADER.match(section.header.text) if section.kind == "program" else None
    name = match["name"] if match is not None else None
    return dialect.has("a") and name is not None and name.lower().startswith("comment___")
