"""SPEED that another SPEED replaces before the arm has moved."""

from vrts.base.diagnostic import Rule
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    HereStatement,
    Put,
    SetLocation,
    Setting,
    Simple,
    SpeedStatement,
    Statement,
)

SPEED_LOST = Rule("V249", "speed-lost")

_STILL = frozenset(
    {"SIGNAL", "TYPE", "PROMPT", "WAIT", "TOOL", "BASE", "RESET", "OPENI", "CLOSEI", "RELAXI"}
    | {"BREAK", "DELAY"}
)
_MOVING = frozenset({"MOVE", "MOVES", "APPRO", "APPROS", "DEPART", "DEPARTS", "DRIVE", "READY"})
_QUIET = (Assignment, SetLocation, Setting, Put, HereStatement)


def check_speeds(problems: Problems, program: ProgramText, *, called: bool) -> None:
    """Warn of speeds that no motion gets to use.

    `called`: whether another program of the file calls this one, and may move behind it.
    """
    if problems.dialect.tolerant:
        return  # relatives have speeds of several kinds beside each other
    moved = False
    since: dict[bool, SpeedStatement] = {}  # set since the last motion, with ALWAYS and without
    for step in program.steps:
        node = step.statement
        if step.label is not None:
            since = {}
        if node is None:
            continue
        if isinstance(node, SpeedStatement) and _plain(node):
            if node.always in since:
                _lost(problems, since[node.always], node)
            since[node.always] = node
        elif not _keeps_still(node):
            since = {}
            moved = moved or (isinstance(node, Simple) and node.word in _MOVING)
    if moved and not called and list(since) == [False]:
        _behind(problems, since[False])


def _plain(node: SpeedStatement) -> bool:
    return node.word == "SPEED" and len(node.levels) == 1 and node.levels[0].unit != "MONITOR"


def _keeps_still(node: Statement) -> bool:
    return isinstance(node, _QUIET) or (isinstance(node, Simple) and node.word in _STILL)


def _behind(problems: Problems, last: SpeedStatement) -> None:
    """`MOVES part / SPEED 20 / .END`."""
    problems.warning(
        SPEED_LOST,
        "this speed has no effect: no motion follows it in this program",
        last.start,
        last.end,
        "for the next motion only",
        help=("write SPEED before the motion that it is for",),
    )


def _lost(problems: Problems, first: SpeedStatement, second: SpeedStatement) -> None:
    problems.warning(
        SPEED_LOST,
        "this speed has no effect: another SPEED follows before the next motion",
        first.start,
        first.end,
        "no motion uses it",
        secondary=(problems.label(second.start, second.end, "replaces it"),),
        notes=()
        if first.always
        else ("SPEED counts for the next motion only, with ALWAYS for all that follow",),
        help=("remove one of the two, or put a motion between them",)
        if first.always
        else (
            "remove one of the two, or put a motion between them",
            f"for all motions that follow write `{_written(problems, first)} ALWAYS`",
        ),
    )


def _written(problems: Problems, node: SpeedStatement) -> str:
    return " ".join(problems.source.text[node.start : node.end].split())
