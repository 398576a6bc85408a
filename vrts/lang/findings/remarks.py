"""Instructions behind `;`: a remark to the controller, a second step to who writes C."""

import re
from bisect import bisect_right
from collections.abc import Iterator
from typing import Any

from vrts.base.diagnostic import Rule
from vrts.ir.values import Type
from vrts.lang.dialect import Dialect
from vrts.lang.meaning.scope import Scope
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.reading.sections.lines import Line, comment_start
from vrts.lang.steps.step_parser import StepParser
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    Give,
    HereStatement,
    Put,
    ReactStatement,
    SetLocation,
    Setting,
    Simple,
    SpeedStatement,
    Statement,
)
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS
from vrts.lang.vocabulary.lookup import spellings

STEP_IN_REMARK = Rule("V238", "step-in-remark")

_REMARK = re.compile(r";[ \t]*([A-Za-z][\w.]*)")
_EQUALS = re.compile(r"[ \t]*=(?!=)")
_JOINED = re.compile(  # a blank nowhere round the `;`, and nothing behind the name
    r"^[ \t\d]*(?:SET[ \t]+[\w.]+[ \t]*=|(?P<motion>MOVES?)[ \t])[ \t]*"
    r"(?P<frame>[A-Za-z][\w.]*)(?P<sign>;)"
    r"(?P<part>[A-Za-z][\w.]*)[ \t]*$",
    re.IGNORECASE | re.MULTILINE,
)
_GLUED = re.compile(r";(?<=[\w.];)[A-Za-z]", re.IGNORECASE)  # as all of these; found quickly
_GLUED_PROSE = re.compile(r"[^\s;];[A-Za-z][\w.]*[ \t]+[A-Za-z]")
_STEPS = (
    Assignment,
    CallStatement,
    Give,
    HereStatement,
    Put,
    ReactStatement,
    SetLocation,
    Setting,
    Simple,
    SpeedStatement,
)
_HAND_AND_ARM = re.compile(
    r"(?:\d+[ \t]+)?(?:MOVE|APPRO|DEPART|DRAW|DRIVE|READY|OPEN|CLOSE|RELAX|BREAK|SPEED|DELAY|ALIGN"
    r"|JMOVE|LMOVE|JAPPRO|LAPPRO|JDEPART|LDEPART|HOME)",
    re.IGNORECASE,
)
_NO_WORDS = frozenset({"OPENI", "CLOSEI", "RELAXI", "DEPARTS", "MOVES", "APPROS"})  # of English


def check_remarks(problems: Problems, scope: Scope, programs: list[ProgramText]) -> None:
    """Warn of steps that stand behind the `;` of another: nobody carries them out."""
    text = problems.source.text
    words = spellings(problems.dialect)
    if not problems.dialect.is_as:
        _joined(problems, scope)
    bodies = sorted((p.start, p.finish[1], p.name) for p in programs)
    for match in _REMARK.finditer(text):
        if match[1].upper() not in words and not _EQUALS.match(text, match.end()):
            continue
        start = text.rfind("\n", 0, match.start()) + 1
        end = text.find("\n", start)
        line = text[start : end if end >= 0 else len(text)]
        before = line[: match.start() - start].strip()
        if not before or comment_start(line) != match.start() - start:
            continue
        number = bisect_right(bodies, (start, len(text), "")) - 1
        if number < 0 or start >= bodies[number][1]:
            continue
        _line(problems, scope, bodies[number][2], before, match.start(), start + len(line))


def _joined(problems: Problems, scope: Scope) -> None:
    """`SET goal = tray;cell`: a `;` for the `:` of two locations, unless remarks stand so here."""
    text = problems.source.text
    found = list(_JOINED.finditer(text)) if _GLUED.search(text) else []
    if not found or _GLUED_PROSE.search(text):
        return
    for match in found:
        motion = match["motion"]
        other = scope.entries.get(key(match["part"]))
        if motion and (other is None or Type.POSE not in (other.type, *other.types)):
            continue
        help_ = f"to join two locations write `{match['frame']}:{match['part']}`"
        if motion:
            help_ += f"; for two motions write `{motion} {match['part']}` on a line of its own"
        problems.warning(
            STEP_IN_REMARK,
            f"what stands behind `;` is a remark: `{match['part']}` is not part of this"
            f" {motion.upper() if motion else 'SET'}",
            *match.span("part"),
            "a remark to the controller",
            help=(help_,),
            fix=problems.replace(*match.span("sign"), ":", sure=False),
        )


def _line(
    problems: Problems, scope: Scope, program: str, before: str, semicolon: int, end: int
) -> None:
    text = problems.source.text
    pieces: list[tuple[str, int]] = []
    at = semicolon + 1
    for piece in text[at:end].split(";"):
        pieces.append((piece.strip(), at + len(piece) - len(piece.lstrip())))
        at += len(piece) + 1
    steps = list(_steps(problems, scope, program, pieces))
    glued = text[semicolon - 1] not in " \t"
    if not steps:
        return
    if isinstance(steps[0][1], Assignment):
        if not glued or not _assigned(steps[0][1], joined=pieces[0][1] == semicolon + 1):
            return
    elif not _meant(before, steps):
        return
    first = steps[0][1]  # an assignment may be an old one, kept as a remark
    sure = not isinstance(first, Assignment) or _assigned(first, joined=False)
    start = pieces[0][1]
    line = text.rfind("\n", 0, semicolon) + 1
    indent = re.match(r"[ \t\d]*", text[line:semicolon])
    margin = re.sub(r"\d", " ", indent.group()) if indent else ""
    rest = [piece for piece, _ in pieces[len(steps) :] if piece]
    lines = [piece for piece, _ in pieces[: len(steps)]]
    if rest:
        lines[-1] += f" ; {'; '.join(rest)}"
    stop = line + len(text[line:semicolon].rstrip())
    shown = ", then ".join(f"`{piece}`" for piece, _ in pieces[: len(steps)])
    last, last_start = pieces[len(steps) - 1]
    problems.warning(
        STEP_IN_REMARK,
        f"what stands behind `;` is a remark: {shown} {'is' if len(steps) == 1 else 'are'}"
        " never carried out",
        start,
        last_start + len(last),
        "a remark to the controller",
        help=("write each step on a line of its own",),
        fix=problems.replace(
            stop, end, "".join(f"\n{margin}{piece}" for piece in lines), sure=sure
        ),
    )


def _steps(
    problems: Problems, scope: Scope, program: str, pieces: list[tuple[str, int]]
) -> Iterator[tuple[str, Statement]]:
    """Return the pieces from the first on that are steps about things that there are."""
    strict: Dialect = problems.dialect._replace(tolerant=False)
    for piece, at in pieces:
        own = Problems(problems.source, strict)
        parser = StepParser(own)
        parser.program_names = frozenset(scope.programs)
        if not piece:
            return
        node = parser.step(Line(1, piece, at, at + len(piece))).statement
        if own.found or not isinstance(node, _STEPS):
            return
        if not all(_exists(scope, program, name) for name in _names(node)):
            return
        yield piece, node


def _meant(before: str, steps: list[tuple[str, Statement]]) -> bool:
    """Return whether this is no prose: letters as large as before, and more than a word."""
    first = re.sub(r"^\d+[ \t]+", "", before)
    word = steps[0][0].split()[0]
    if first[:2].isupper() is not word.isupper() or first[:2].islower() is not word.islower():
        return False
    if len(steps) > 1 or any(sign.isspace() for sign in steps[0][0]):
        return True
    known = word.isupper() or word.upper() in _NO_WORDS
    return known and _HAND_AND_ARM.match(before) is not None


def _assigned(node: Statement, *, joined: bool) -> bool:
    """Return whether this is `n = n+1`, or any assignment without a blank round the `;`."""
    if not isinstance(node, Assignment) or not isinstance(node.target, Name):
        return False
    counts = key(node.target.text) in {key(name) for name in _names(node.value)}
    return counts or joined


def _exists(scope: Scope, program: str, name: str) -> bool:
    lower = name.lower()
    if lower in CONSTANTS or key(name) in scope.programs:
        return True
    if lower in FUNCTIONS and FUNCTIONS[lower].bare:
        return True
    entry = scope.formals[program].get(key(name)) or scope.entries.get(key(name))
    return entry is not None


def _names(node: Any) -> Iterator[str]:
    waiting: list[Any] = [node]
    while waiting:
        part = waiting.pop()
        if isinstance(part, Name):
            yield part.text
        else:
            waiting += [inner for inner in part if isinstance(inner, tuple)]
