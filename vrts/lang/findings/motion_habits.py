"""Motions and speeds that a controller refuses or changes, seen without a run."""

from vrts.base.diagnostic import Rule
from vrts.lang.findings.values.complaints import OPERAND_RANGE
from vrts.lang.meaning.constants import constant
from vrts.lang.meaning.scope import Scope
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Setting, Simple, SpeedStatement, Statement

SPEED_RANGE = Rule("V226", "speed-range")
STRAIGHT_FROM_READY = Rule("V228", "straight-from-ready")
STRAIGHT_TURNS_ARM = Rule("V267", "straight-turns-arm")
ARM_WORD_LOST = Rule("V272", "arm-word-lost")

FULL_SPEED = 100.0  # [%] what is above acts as this [assumed, manual language/settings#speed-limit]
_MOST = {1: 320.0, 2: 450.0, 3: 270.0, 4: 532.0, 5: 200.0, 6: 600.0}
# [deg] from one end of a joint to the other, of the arm of the family where that is most
_ARMS = {  # settings of the arm branch, and what they choose
    "LEFTY": "shoulder",
    "RIGHTY": "shoulder",
    "ABOVE": "elbow",
    "BELOW": "elbow",
    "FLIP": "wrist",
    "NOFLIP": "wrist",
}
_STRAIGHT = frozenset({"MOVES", "MOVEST", "APPROS", "DEPARTS", "DRAW"})
_JOINT = frozenset({"MOVE", "MOVET", "APPRO", "DEPART", "DRIVE", "ALIGN"})


def check_motion(problems: Problems, scope: Scope, program: ProgramText) -> None:
    """Warn of speeds out of range, of straight lines out of READY, and of turns too far."""
    if not problems.dialect.tolerant:
        _check_branches(problems, program)
    ready: Simple | None = None  # the READY that the arm stands in for sure
    for step in program.steps:
        node = step.statement
        if isinstance(node, SpeedStatement):
            _speed(problems, scope, program, node)
            continue
        if step.label is not None or not isinstance(node, Simple):
            ready = ready if _keeps_still(node) and step.label is None else None
        if isinstance(node, Simple):
            if node.word == "DRIVE" and not problems.dialect.tolerant:
                _drive(problems, scope, program, node)
            if node.word == "READY" and not problems.dialect.is_as:  # HOME of AS is taught
                ready = node
            elif node.word in _STRAIGHT and ready is not None:
                _straight(problems, node, ready)
                ready = None
            elif node.word in _JOINT:
                ready = None


def _check_branches(problems: Problems, program: ProgramText) -> None:
    """Warn of `RIGHTY`, `MOVES part` below `LEFTY`, `MOVE a`: a straight line keeps the branch."""
    settled: dict[str, Setting] = {}  # the branch that the arm is in for sure
    wanted: dict[str, Setting] = {}
    pending: set[str] = set()  # what was asked for under way, and no joint motion has turned yet
    moved = False
    above: Setting | None = None  # the arm word of the step before
    if not any(isinstance(step.statement, Setting) for step in program.steps):
        return
    for step in program.steps:
        node = step.statement
        simple = isinstance(node, Simple)
        if step.label is not None or not (
            simple or isinstance(node, Setting) or _keeps_still(node)
        ):
            settled, wanted = {}, {}
            pending.clear()
        if isinstance(node, Setting) and node.word in _ARMS:
            part = _ARMS[node.word]
            if above is not None and _ARMS[above.word] == part and above.always == node.always:
                _lost(problems, part, above, node)
            wanted[part] = above = node
            if moved:
                pending.add(part)
            continue
        above = None
        moved = moved or not (node is None or _keeps_still(node))
        if isinstance(node, Simple) and (node.word in ("READY", "DRIVE") or _to_joints(node)):
            settled = {}  # the joints of a precision point may be on any branch
        elif isinstance(node, Simple) and node.word in _JOINT:
            settled.update(wanted)
            pending.clear()
        elif isinstance(node, Simple) and node.word in _STRAIGHT:
            for part, setting in wanted.items():
                before = settled.get(part)
                if before is None and (setting.always or part not in pending):
                    continue
                if before is None or before.word != setting.word:
                    _turned(problems, node, part, before, setting)
                    settled, wanted = {}, {}
                    pending.clear()
                    break


def _lost(problems: Problems, part: str, first: Setting, second: Setting) -> None:
    problems.warning(
        ARM_WORD_LOST,
        f"{first.word} has no effect: {second.word} follows before the next motion",
        first.start,
        first.end,
        f"no motion turns the {part} this way",
        secondary=(problems.label(second.start, second.end, "replaces it"),),
        help=("remove one of the two, or put a motion by MOVE between them",),
    )


def _turned(
    problems: Problems, node: Simple, part: str, before: Setting | None, setting: Setting
) -> None:
    joint = {"MOVES": "MOVE", "MOVEST": "MOVET", "APPROS": "APPRO", "DEPARTS": "DEPART"}
    word = joint.get(node.word)
    headline = f"{setting.word} does not turn the {part} for {node.word}"
    at: Simple | Setting = setting
    motion = node.word
    note = f"where the arm is not {setting.word} already, the run stops at the straight line"
    other = problems.label(node.start, node.end, "keeps the branch that the arm is on")
    if before is not None:
        headline = f"{node.word} cannot turn the {part} from {before.word} to {setting.word}"
        at, motion = node, "this motion"
        note = "the arm passes from one side to the other in joint motion only"
        other = problems.label(setting.start, setting.end, "asks for the other side")
    problems.warning(
        STRAIGHT_TURNS_ARM,
        headline,
        at.start,
        at.end,
        "a straight line" if before is not None else "a straight line follows",
        secondary=(other,),
        notes=(note,),
        help=(f"write {word} for {motion}" if word else "go to a location by MOVE first",),
        fix=problems.replace(node.start, node.start + len(node.word), word)
        if word and problems.source.text[node.start : node.end].upper().startswith(node.word)
        else None,
    )


def _to_joints(node: Simple) -> bool:
    (to, *_) = (*node.operands, None)
    return node.word in _JOINT and isinstance(to, Name) and to.text.startswith("#")


def _drive(problems: Problems, scope: Scope, program: ProgramText, node: Simple) -> None:
    """`DRIVE 5, 250, 40`: farther than the joint turns at all."""
    joint, change = (*node.operands, None, None)[:2]
    number, by = constant(scope, program.name, joint), constant(scope, program.name, change)
    most = _MOST.get(round(number)) if number is not None else None
    if change is None or most is None or by is None or abs(by) <= most:
        return
    assert number is not None
    problems.warning(
        OPERAND_RANGE,
        f"joint {number:g} cannot turn by {by:g} degrees",
        change.start,
        change.end,
        f"from end to end it turns {most:g} degrees at most",
        notes=("DRIVE takes the joint, the change in degrees, and the speed in percent",),
        help=(f"write a smaller change, as in `DRIVE {number:g}, {most / 8:g}, 50`",),
    )


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
