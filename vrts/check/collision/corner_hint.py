"""Would a contact have been avoided if the arm had stopped where it rounds a corner?

Answered by trying: where a contact begins in a rounded corner, the same run is executed again with
continuous path switched off, so that every motion stops at its location, and checked again.
"""

from collections.abc import Mapping
from itertools import pairwise

from vrts.base.source import SourceFile
from vrts.check.collision.collision import touching
from vrts.check.verdict import CollisionReport, ContactEvent
from vrts.engine.controller import AFTERWARDS, advance, start
from vrts.engine.memory.events import Grasped
from vrts.engine.memory.records import Ending, Motion
from vrts.engine.run import Run
from vrts.geometry.proposing.proposer import Proposer
from vrts.ir.commands import Do, TimedCommand
from vrts.lang.compiler import compile_source

PROGRAM_ENDS = (Ending.COMPLETED, Ending.HALTED)
STOP_ALWAYS = ".PROGRAM stop\n DISABLE CP\n.END\n"


def corner_hints(run: Run, report: CollisionReport, proposer: Proposer | None) -> Mapping[int, str]:
    """Return hints for contacts, by their place in a report, that stopping would have avoided."""
    corners = {
        number: motion
        for number, event in enumerate(report.contacts)
        if (motion := _rounded(run, event)) is not None
    }
    if not corners or run.ending not in PROGRAM_ENDS or not run.history.closed:
        return {}  # of a session nobody can say what its operator would have done then
    stopping = _stopping(run)
    if stopping.ending not in PROGRAM_ENDS:
        return {}  # it did not get there
    asked = {report.contacts[number][:2] for number in corners}
    left = touching(stopping, asked, proposer=proposer)  # on whatever step
    return {
        number: _hint(run, motion, report.contacts[number])
        for number, motion in corners.items()
        if report.contacts[number][:2] not in left
    }


def _rounded(run: Run, event: ContactEvent) -> Motion | None:
    """Return the motion whose rounded end a contact begins in: it should have stopped there."""
    motions = run.motions
    arm = run.scene.robot.arm
    width = (arm.blend_time or 2.0 * arm.acceleration_time) * 100.0 / run.scenario.monitor_speed
    for before, after in pairwise(motions):
        if before.blended and after.start_s <= event.start_s <= after.start_s + width:
            return before
    return None


def _stopping(run: Run) -> Run:
    """Return the same execution with every motion stopped at its location."""
    module = compile_source(SourceFile("stop", STOP_ALWAYS)).module
    assert module is not None
    begun = start(run.module, run.scene, run.scenario)
    wait = run.history.tick_s
    begun = advance(begun, wait, (TimedCommand(0.0, Do(module)),))
    later = [timed._replace(time_s=timed.time_s + wait) for timed in run.history.issued]
    until = run.scenario.limits.time_s + AFTERWARDS
    return advance(begun, until, later, closed=run.history.closed)


def _hint(run: Run, motion: Motion, event: ContactEvent) -> str:
    """Return where to look: at the hand, where it took what it holds in the same corner."""
    span = motion.cause.span
    place = f"the arm does not stop at the end of line {span.line} `{' '.join(span.text.split())}`"
    on_the_way = any(
        isinstance(grasp, Grasped)
        and grasp.body == event.held
        and motion.end_s <= grasp.time_s <= event.start_s
        for grasp in run.events
    )
    if on_the_way:
        return f"{place}, and the hand closes on the way: compare CLOSE with CLOSEI"
    return f"{place}, but rounds the corner: look at what BREAK does"
