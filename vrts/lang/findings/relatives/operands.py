"""Which steps of V+ and AS are looked at, and by what."""

from collections.abc import Callable
from typing import TypeAlias

from vrts.lang.findings.relatives.clamps import check_clamp, check_hand
from vrts.lang.findings.relatives.homes import check_home, check_home_place
from vrts.lang.findings.relatives.numbers import check_distance, check_draw
from vrts.lang.findings.relatives.seconds import check_event, check_seconds
from vrts.lang.findings.relatives.signal_numbers import (
    check_signal,
    check_stop_signal,
    check_timed_signal,
)
from vrts.lang.findings.relatives.timers import check_user_timer
from vrts.lang.meaning.resolve import Resolver
from vrts.lang.syntax.program import ProgramText
from vrts.lang.syntax.statements import Device, ReactStatement, Simple

Step: TypeAlias = Simple | Device | ReactStatement
_Check: TypeAlias = Callable[[Resolver, ProgramText, Step], bool]

_OF_VPLUS: dict[str, _Check] = {
    "DELAY": check_seconds,
    "WAIT.EVENT": check_event,
    "SIGNAL": check_signal,
    "IGNORE": check_signal,
    "REACT": check_signal,
    "REACTI": check_signal,
}
_OF_AS: dict[str, _Check] = {
    "DELAY": check_seconds,
    "TWAIT": check_seconds,
    "STABLE": check_seconds,
    "MON_TWAIT": check_seconds,
    "SIGNAL": check_signal,
    "SWAIT": check_signal,
    "IGNORE": check_signal,
    "ON": check_signal,
    "ONI": check_signal,
    "PULSE": check_timed_signal,
    "DLYSIG": check_timed_signal,
    "XMOVE": check_stop_signal,
    "MOVE": check_clamp,
    "MOVES": check_clamp,
    "C1MOVE": check_clamp,
    "C2MOVE": check_clamp,
    "HMOVE": check_clamp,
    "APPRO": check_distance,
    "APPROS": check_distance,
    "DEPART": check_distance,
    "DRAW": check_draw,
    "TDRAW": check_draw,
    "DEPARTS": check_distance,
    "OPEN": check_hand,
    "OPENI": check_hand,
    "CLOSE": check_hand,
    "CLOSEI": check_hand,
    "RELAX": check_hand,
    "RELAXI": check_hand,
    "READY": check_home,
    "SETHOME": check_home_place,
    "SET2HOME": check_home_place,
    "UTIMER": check_user_timer,
}


def check_operands(resolver: Resolver, programs: list[ProgramText]) -> None:
    """Report operands that surely are not meant, at most one of each step; V+ and AS only."""
    dialect = resolver.dialect
    if not (dialect.is_as or dialect.is_vplus):
        return
    wrong, source = resolver.wrong_lines, resolver.problems.source
    checks = _OF_AS if dialect.is_as else _OF_VPLUS
    for program in programs:
        for step in program.steps:
            node = step.statement
            if not isinstance(node, Simple | Device | ReactStatement):
                continue
            check = checks.get(node.word)
            if check is None or not node.operands:
                continue
            line = source.line_of(node.start)
            if line not in wrong and check(resolver, program, node):
                wrong.add(line)
