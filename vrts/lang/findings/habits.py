"""Legal steps that beginners regret: each warning needs no run to be seen."""

from collections.abc import Callable

from vrts.base.diagnostic import Rule
from vrts.ir.ranges import INPUTS, INTERNAL
from vrts.lang.findings.endless import LoopCheck
from vrts.lang.findings.lost_speeds import check_speeds
from vrts.lang.findings.motion_habits import check_motion
from vrts.lang.findings.terminal_habits import check_terminal
from vrts.lang.findings.values.begun_anew import check_begun_anew
from vrts.lang.findings.values.sign_behind_equals import check_sign
from vrts.lang.findings.values.units.converted import check_converted
from vrts.lang.findings.ways.branches import check_branches
from vrts.lang.findings.ways.breaks import check_breaks
from vrts.lang.findings.ways.case_groups import check_groups
from vrts.lang.findings.ways.counting import CountingCheck
from vrts.lang.findings.ways.repeated_values import check_values
from vrts.lang.meaning.constants import constant, number_of
from vrts.lang.meaning.scope import Scope
from vrts.lang.meaning.structure import Block
from vrts.lang.names import key
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Name
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import (
    Assignment,
    CallStatement,
    Simple,
    SpeedStatement,
    Statement,
)

CONSTANT_WAIT = Rule("V152", "constant-wait")
NEGATIVE_APPROACH = Rule("V220", "negative-approach")
HAND_ON_THE_WAY = Rule("V221", "hand-on-the-way")

PRESSED = 5.0  # [mm] so far beyond a location a part may be pressed on purpose
NEAR = 50  # steps that are looked through for the motion before or after
_ARRIVING = frozenset({"MOVE", "MOVES"})
_LEAVING = frozenset({"DEPART", "DEPARTS"})
_BACK = ("DEPART", "DEPARTS")
_DISTANCE = {"APPRO": 1, "APPROS": 1, "DEPART": 0, "DEPARTS": 0}  # which operand it is
_MOTIONS = _ARRIVING | _LEAVING | {"APPRO", "APPROS", "DRIVE", "READY"}


def check_habits(
    problems: Problems,
    scope: Scope,
    programs: list[ProgramText],
    structures: dict[str, list[Block]],
    changed_by: Callable[[str], frozenset[str] | None],
    *,
    alone: bool,
) -> None:
    """Warn of what the language allows and the writer hardly means.

    `changed_by` tells which variables the CALL of a program may change; None: it is not known.
    `alone`: no other program may run between two steps.
    """
    loops = LoopCheck(problems, scope)
    counting = CountingCheck(problems, scope, changed_by)
    called = {
        key(node.program.text)
        for program in programs
        for step in program.steps
        if isinstance(node := step.statement, CallStatement)
    }
    converted = "atan2" in problems.source.text.lower()
    for program in programs:
        steps = [s.statement for s in program.steps]
        for at, node in enumerate(steps):
            if isinstance(node, Assignment):
                check_sign(problems, node)
            elif isinstance(node, Simple):
                if node.word == "WAIT":
                    _waiting(problems, node)
                elif node.word in _DISTANCE:
                    if not _comes_back(scope, program, node, steps[at + 1 : at + 2]):
                        _approach(problems, scope, program, node)
                elif node.word in ("OPEN", "CLOSE"):
                    _hand(problems, steps, at, node)
        check_motion(problems, scope, program)
        if converted and not problems.dialect.tolerant:
            check_converted(problems, program)
        found = structures[program.name]
        empty: set[int] = set()  # where structures open that do nothing
        if not problems.any_error:  # else the structures may be others
            check_speeds(problems, program, called=program.name in called)
            check_terminal(problems, program)
            empty = {block.opener for block in check_branches(problems, program, found)}
            check_groups(problems, program)
            counting.check(program, found)
            check_values(problems, program, found)
            check_breaks(problems, program, found)
            if alone:
                check_begun_anew(problems, scope, program, found, changed_by)
        if alone:
            loops.check(program, [block for block in found if block.opener not in empty])


def _waiting(problems: Problems, node: Simple) -> None:
    if problems.dialect.is_val:
        return  # there a number is a signal
    operand = node.operands[0] if node.operands else None
    value = number_of(operand)
    if operand is None or value is None:
        return
    signal, asked = abs(value), problems.source.text[operand.start : operand.end].strip("()")
    by_signal = f"to wait for a signal write `WAIT SIG({asked})`"
    by_time = f"to wait {value:g} s write `DELAY {value:g}`"
    is_signal = signal in INPUTS or signal in INTERNAL
    both = value > 0.0 and value == round(value)
    problems.warning(
        CONSTANT_WAIT,
        f"this WAIT goes on {'at once' if value else 'never'}",
        operand.start,
        operand.end,
        "a constant condition",
        notes=("WAIT takes a condition, not a time; any number but 0 is true",),
        help=(by_signal,) if is_signal else (by_time, by_signal) if both else (by_time,),
        fix=problems.replace(operand.start, operand.end, f"SIG({asked})", sure=False)
        if is_signal
        else None,
    )


def _comes_back(
    scope: Scope, program: ProgramText, node: Simple, following: list[Statement | None]
) -> bool:
    """`DEPARTS -30`, `DEPARTS 30`: forward and back again, as into a hole."""
    back = following[0] if following else None
    if not isinstance(back, Simple) or back.word not in _BACK or node.word not in _BACK:
        return False
    gone = constant(scope, program.name, node.operands[0])
    returned = constant(scope, program.name, back.operands[0])
    return gone is not None and returned is not None and returned >= -gone > 0.0


def _approach(problems: Problems, scope: Scope, program: ProgramText, node: Simple) -> None:
    operand = node.operands[_DISTANCE[node.word]]
    distance = constant(scope, program.name, operand)
    if operand is None or distance is None or distance > -PRESSED:
        return
    approach = node.word.startswith("APPRO")
    problems.warning(
        NEGATIVE_APPROACH,
        f"{node.word} by {distance:g} mm goes {'beyond the location' if approach else 'forward'}",
        operand.start,
        operand.end,
        f"{-distance:g} mm along the tool, towards what lies in front of it",
        notes=(
            "the distance counts backwards from the "
            + ("location" if approach else "tool")
            + ": positive is away from the part",
        ),
        help=(f"write `{-distance:g}` to keep away from the part",),
        fix=problems.replace(operand.start, operand.end, f"{-distance:g}", sure=False),
        data={"distance_mm": distance},
    )


def _hand(problems: Problems, steps: list[Statement | None], at: int, node: Simple) -> None:
    """`MOVES part / CLOSE / DEPARTS 50`: the hand closes while it leaves."""
    if _is_i(node):
        return
    following = next((s for s in steps[at + 1 : at + 1 + NEAR] if _counts(s)), None)
    before = next((s for s in reversed(steps[max(at - NEAR, 0) : at]) if _counts(s)), None)
    if not isinstance(following, Simple) or not isinstance(before, Simple):
        return
    leaves = following.word in _LEAVING
    grips = node.word == "CLOSE" and following.word in _MOTIONS
    if before.word not in _ARRIVING or not (leaves or grips):
        return
    does = "close" if node.word == "CLOSE" else "open"
    problems.warning(
        HAND_ON_THE_WAY,
        f"the hand only begins to {does} when {following.word} begins",
        node.start,
        node.end,
        f"acts together with the {following.word} below",
        secondary=(
            problems.label(following.start, following.end, f"the hand {does}s during this motion"),
        ),
        notes=(f"{node.word} belongs to the next motion, whether BREAK stands before it or not",),
        help=(f"write `{node.word}I`: it waits for the arm, {does}s, and waits for the hand",),
        fix=problems.replace(node.start, node.start + len(node.word), f"{node.word}I", sure=leaves)
        if problems.source.text[node.start : node.end].upper() == node.word
        else None,
    )


def _is_i(node: Simple) -> bool:
    """Whether this is `CLOSE I`, of which the variable that has no value is told."""
    operand = node.operands[0] if node.operands else None
    return isinstance(operand, Name) and operand.text.upper() == "I"


def _counts(node: Statement | None) -> bool:
    """Whether a step matters for when the hand acts."""
    if node is None or isinstance(node, SpeedStatement):
        return False
    return not (isinstance(node, Simple) and node.word in ("BREAK", "TYPE", "SIGNAL"))
