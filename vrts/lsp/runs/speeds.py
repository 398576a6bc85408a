"""The speed that would do: edits of SPEED after which a run is no longer too fast, or too slow.

A speed is worked out from how far the run is off, written into the text, and the text is compiled
and executed again: only what has been seen to mend is offered.
"""

import math
import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TypeAlias

import numpy as np

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.base.units import deg
from vrts.check.collision.corner_hint import PROGRAM_ENDS
from vrts.check.collision.of_run import motion_of
from vrts.check.curves.certified import highest
from vrts.check.judgement import Judgement
from vrts.check.task.demands import DEMAND, Demand
from vrts.check.task.task import Task
from vrts.check.verdicts.demand_values import bound_of, close_of, quantity
from vrts.check.verdicts.demand_words import SPEED as TASK_SPEED
from vrts.check.verdicts.limits import JOINT_SPEED, check_limits
from vrts.check.verdicts.via_verdict import VIA_SPEED
from vrts.check.verdicts.vias import Lack, passed
from vrts.engine.memory.records import Motion
from vrts.engine.run import Run
from vrts.lsp.answers.formatting import Edit
from vrts.lsp.channel.findings import Found, Mending

TRIES = 4  # at what is still too fast
MOST_MENDED = 8  # faults for which a speed is worked out: each costs runs
ELSEWHERE = -1  # a motion of another file, which is not changed

_SPEED_LINE = re.compile(
    r"[ \t]*SPEED[ \t]+(?P<value>[^,;]*[^,;\s])[ \t]*(?:;.*)?", re.IGNORECASE | re.ASCII
)
_LASTING = re.compile(r"\bALWAYS\b", re.IGNORECASE)

Wanted: TypeAlias = dict[int, int]
"""By where the instruction of a motion begins: the speed that would do there [%]."""

Fault: TypeAlias = Callable[[Run], Wanted]
"""What is wrong with the speeds of a run; empty when nothing is."""

Again: TypeAlias = Callable[[str], Run | None]
"""Executes another text in the same setting; None when it does not compile."""


def with_speeds(
    source: SourceFile, run: Run, judgement: Judgement, task: Task | None, again: Again
) -> list[Found]:
    """Return the findings of the checks, with what to write where another speed would do.

    Args:
        source: The text whose motions may be changed.
        run: Its run.
        judgement: What was found in the run.
        task: What was asked for.
        again: Executes another text.
    """
    known: dict[tuple[str, int | None], Mending | None] = {}
    found: list[Found] = []
    for verdict in judgement.verdicts:
        for diagnostic in verdict.findings:
            fault = _fault(diagnostic, verdict.check, task, source.name)
            place = None
            if diagnostic.rule == JOINT_SPEED and diagnostic.primary is not None:
                place = diagnostic.primary.span.start
            same = verdict.check, place
            if fault is not None and same not in known and len(known) < MOST_MENDED:
                known[same] = mending(source, run, fault, again, place)
            found.append(Found(diagnostic, known.get(same) if fault is not None else None))
    return found


def mending(
    source: SourceFile, run: Run, fault: Fault, again: Again, place: int | None = None
) -> Mending | None:
    """Return how to write speeds so that a fault is gone; None when no speed does it.

    Args:
        source: The text.
        run: Its run.
        fault: What is wrong with speeds.
        again: Executes another text.
        place: Where the only motion that counts begins; None: all count.
    """
    wanted = _only(fault(run), place)
    for _ in range(TRIES):
        if not wanted or any(s == ELSEWHERE or not 1 <= p <= 100 for s, p in wanted.items()):
            return None
        edits = [_edit(source, start, percent) for start, percent in sorted(wanted.items())]
        mended = again(applied(source.text, edits))
        if mended is None or mended.ending not in (run.ending, *PROGRAM_ENDS):
            return None
        left = _only({_before(edits, s): percent for s, percent in fault(mended).items()}, place)
        if not left:
            return Mending(_title(wanted), tuple(edits))
        if left.items() <= wanted.items():
            return None
        wanted |= left
    return None


def applied(text: str, edits: Iterable[Edit]) -> str:
    """Return a text with edits that do not overlap."""
    for start, end, new in sorted(edits, reverse=True):
        text = text[:start] + new + text[end:]
    return text


def _only(wanted: Wanted, place: int | None) -> Wanted:
    return wanted if place is None else {s: p for s, p in wanted.items() if s == place}


def _edit(source: SourceFile, start: int, percent: int) -> Edit:
    """Return how to give one motion another speed, and no other: SPEED without ALWAYS."""
    line = source.line_of(start)
    lead = source.text[source.line_starts[line - 1] : start]
    if not lead.strip():  # programs may jump to a label, past the line above
        above = line - 1
        while above > 0 and _is_remark(source.line_text(above)):
            above -= 1
        match = _SPEED_LINE.fullmatch(source.line_text(above)) if above > 0 else None
        if match is not None and not _LASTING.search(match["value"]):
            at = source.line_starts[above - 1]
            return Edit(at + match.start("value"), at + match.end("value"), str(percent))
    return Edit(start, start, f"SPEED {percent}\n{' ' * len(lead.expandtabs(8))}")


def _is_remark(line: str) -> bool:
    return not line.strip() or line.lstrip().startswith(";")


def _before(edits: Iterable[Edit], offset: int) -> int:
    """Return where an offset of an edited text was before; it lies in none of the edits."""
    for start, end, new in sorted(edits):
        if offset < start + len(new):
            break
        offset -= len(new) - (end - start)
    return offset


def _title(wanted: Wanted) -> str:
    speeds = sorted(set(wanted.values()))
    shown = f"{speeds[0]} to {speeds[-1]}" if len(speeds) > 1 else f"{speeds[0]}"
    where = f" for {len(wanted)} motions" if len(wanted) > 1 else ""
    return f"Set SPEED {shown}{where}: that would do"


# --- what is wrong with speeds ------------------------------------------------------------------


def _fault(diagnostic: Diagnostic, check: str, task: Task | None, path: str) -> Fault | None:
    """Return what a finding complains of, if a speed may mend it."""
    if diagnostic.rule == JOINT_SPEED:
        return lambda run: _least(_fast_joints(run), path)
    if diagnostic.rule == TASK_SPEED and task is not None:
        demand = next(demand for demand in task.demands if check == DEMAND + demand.name)
        return lambda run: _least(_fast_for(run, demand), path)
    if diagnostic.rule == VIA_SPEED and task is not None:
        return lambda run: _least(_wrong_at(run, check, task), path)
    return None


def _least(found: Iterable[tuple[Motion, float]], path: str) -> Wanted:
    """Return the speed for every instruction, from motions and how many times theirs would do."""
    wanted: Wanted = {}
    for motion, factor in found:
        span = motion.cause.span
        place = span.start if span.source.name == path else ELSEWHERE
        speed = 100.0 * motion.speed_fraction * factor
        percent = math.floor(speed + 1e-6) if factor < 1.0 else math.ceil(speed - 1e-6)
        wanted[place] = min(percent, wanted.get(place, percent))
    return wanted


def _fast_joints(run: Run) -> Iterator[tuple[Motion, float]]:
    limits: Mapping[int, float] = {n: deg(v) for n, v in enumerate(run.scene.robot.arm.speed, 1)}
    for finding in check_limits(run).findings:
        if finding.rule == JOINT_SPEED and finding.moment is not None:
            joint, speed = finding.data["joint"], finding.data["speed_deg_s"]
            assert isinstance(joint, int)
            assert isinstance(speed, float)
            yield _motion_at(run, finding.moment.time_s), limits[joint] / speed


def _fast_for(run: Run, demand: Demand) -> Iterator[tuple[Motion, float]]:
    motion = motion_of(run)
    value, most = quantity(demand, run.scene, motion), bound_of(demand)
    for number in sorted(set(motion.motions.tolist()) - {-1}):
        own = np.nonzero(motion.motions == number)[0]
        top = highest(value, motion.starts[own], motion.ends[own], close_of(demand.keeps)).value
        if top > most:
            yield run.motions[number], most / top


def _wrong_at(run: Run, check: str, task: Task) -> Iterator[tuple[Motion, float]]:
    found = passed(run, task)
    for visits, lack in zip(found.visits, found.lacks, strict=True):
        if check == f"via {visits.via.name}" and lack in (Lack.TOO_FAST, Lack.TOO_SLOW):
            allowed = visits.via.fastest if lack is Lack.TOO_FAST else visits.via.slowest
            yield _motion_at(run, visits.best_s), allowed / max(visits.best, 1e-6)


def _motion_at(run: Run, time_s: float) -> Motion:
    """Return the motion under way at a time."""
    known = motion_of(run)
    number = int(known.motions[known.piece_at(np.array([time_s]))[0]])
    return run.motions[number]
