"""Motions and speeds that a controller refuses or changes, seen without a run."""

from vrts.base.diagnostic import Rule
from vrts.lang.meaning.constants import constant
from vrts.lang.meaning.scope import Scope
from vrts.lang.problems import Problems
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Simple, SpeedStatement, Statement

SPEED_RANGE = Rule("V226", "speed-range")
STRAIGHT_FROM_READY = Rule("V228", "straight-from-ready")

FULL_SPEED = 100.0  # [%] what is above acts as this [assumed, manual language/settings#speed-limit]
_STRAIGHT = frozenset({"MOVES", "MOVEST", "APPROS", "DEPARTS", "DRAW"})
_JOINT = frozenset({"MOVE", "MOVET", "APPRO", "DEPART", "DRIVE", "ALIGN"})


def check_motion(problems: Problems, scope: Scope, program: ProgramText) -> None:
    """Warn of speeds out of range, and of straight lines out of READY."""
    ready: Simple | None = None  # the READY that the arm stands in for sure
    for step in program.steps:
        node = step.statement
        if isinstance(node, SpeedStatement):
            _speed(problems, scope, program, node)
            continue
        if step.label is not None or not isinstance(node, Simple):
            ready = ready if _keeps_still(node) and step.label is None else None
        if isinstance(node, Simple):
            if node.word == "READY":
                ready = node
            elif node.word in _STRAIGHT and ready is not None:
                _straight(problems, node, ready)
                ready = None
            elif node.word in _JOINT:
                ready = None


def _keeps_still(node: Statement | None) -> bool:
    """Whether a step neither moves the arm nor calls or jumps elsewhere."""
    return node is None or type(node).__name__ in ("Assignment", "SetLocation", "Setting", "Put")


def _straight(problems: Problems, node: Simple, ready: Simple) -> None:
    joint = {"MOVES": "MOVE", "MOVEST": "MOVET", "APPROS": "APPRO"}.get(node.word)
    problems.warning(
        STRAIGHT_FROM_READY,
        f"{node.word} cannot leave the ready position",
        node.start,
        node.end,
        "a straight line",
        secondary=(problems.label(ready.start, ready.end, "the arm is stretched up here"),),
        notes=(
            "in READY the wrist and the elbow are stretched: the arm cannot go on a straight line",
        ),
        help=(f"begin with {joint}" if joint else "move to a location by MOVE first",),
        fix=problems.replace(node.start, node.start + len(node.word), joint)
        if joint and problems.source.text[node.start : node.end].upper().startswith(node.word)
        else None,
    )


def _speed(problems: Problems, scope: Scope, program: ProgramText, node: SpeedStatement) -> None:
    if node.word != "SPEED":
        return
    level = node.levels[0]
    value = constant(scope, program.name, level.value)
    if value is None:
        return
    if value <= 0:
        headline, text = f"SPEED {value:g} stops the run", "a speed is above 0"
        note, help_ = "VAL-II says *Illegal value*", f"write a speed from 1 to {FULL_SPEED:g}"
    elif value > FULL_SPEED and all(other.unit is None for other in node.levels):
        headline, text = f"SPEED {value:g} acts as SPEED {FULL_SPEED:g}", "in percent"
        note = f"{FULL_SPEED:g} is the full speed of the arm"
        help_ = f"write `SPEED {value:g} MMPS` if millimetres a second are meant"
    else:
        return
    problems.warning(
        SPEED_RANGE,
        headline,
        level.value.start,
        level.value.end,
        text,
        notes=(note,),
        help=(help_,),
        data={"speed": value},
    )
