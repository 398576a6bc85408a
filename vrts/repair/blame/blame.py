"""How much each line of a program is to blame for what a run lost: a dynamic slice with weights."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from vrts.base.pose import Pose, Vector
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.check.task.task import Task
from vrts.engine.run import Run
from vrts.ir.control import BeginFor, JumpIf, NextFor, TestFor
from vrts.repair.blame.anchors import ENDS, Anchor, shown
from vrts.repair.blame.trail import Trail

DEEPEST = 8  # steps that a chain is followed back
FAINT = 0.05  # of weights: a chain is not followed further
WRITERS, DATA, CALLERS, BEFORE = 0.9, 0.95, 0.8, 0.75  # how blame is handed on
BEGINS = 0.7  # of the data of the motion before one: where and how the arm sets out
NEAR = 7  # steps before one that are to blame too: settings, the hand, BREAK
FOLLOWING = 0.5
DECISIONS = 0.55  # of every branch and loop: what they leave out shows nowhere
UNREAD = 0.6  # of steps that write other elements of an array of which one has no value
DECIDING = (BeginFor, TestFor, NextFor, JumpIf)


class Blame(NamedTuple):
    """What a run says about where its program is wrong."""

    weights: Mapping[int, float]  # of lines, 0 to 1
    residuals: tuple[Vector, ...]  # from where something is to where it should be, in W [mm]
    poses: tuple[Pose, ...]  # where the tool should have been, X_WT
    executed: frozenset[int]  # lines of steps that were executed, and of data that were read
    last_step: int | None  # line of the step that was executed last
    before: frozenset[int]  # of `executed`, those executed before the first loss that has a time
    shown: tuple[int, ...]  # lines where what is lost shows, in the order of the run; () unknown
    slow: bool  # nothing is lost but time

    def weight(self, line: int) -> float:
        """Return how much a line is to blame."""
        return self.weights.get(line, 0.0)


def blame(run: Run, task: Task, judgement: Judgement, grade: Grade) -> Blame:
    """Return how much each line is to blame for what a run lost."""
    trail = Trail(run)
    found = shown(run, task, judgement, grade, trail)
    weights: dict[int, float] = {}
    reached: dict[int, float] = {}
    stopped = run.ending not in ENDS
    decided: set[int] = set()

    def follow(k: int, weight: float, depth: int) -> None:
        if weight < FAINT or weight <= reached.get(k, 0.0):
            return
        reached[k] = weight
        line = trail.steps[k].line
        weights[line] = max(weights.get(line, 0.0), weight)
        if depth > DEEPEST:
            return
        for written in trail.reads(k):
            if written.line is not None:
                handed = DATA * weight
                weights[written.line] = max(weights.get(written.line, 0.0), handed)
            elif written.step is not None:
                follow(written.step, WRITERS * weight, depth + 1)
        begun = trail.motion_before(k)
        for written in () if begun is None else trail.reads(begun):
            handed = BEGINS * weight
            if written.line is not None:
                weights[written.line] = max(weights.get(written.line, 0.0), handed)
            elif written.step is not None:
                follow(written.step, WRITERS * handed, depth + 1)
        caller = trail.caller(k)
        if caller is not None:
            follow(caller, CALLERS * weight, depth + 1)
        near = weight * (0.4 if stopped else 1.0)
        for back in range(1, NEAR + 1):
            if k - back >= 0:
                near *= BEFORE
                line = trail.steps[k - back].line
                weights[line] = max(weights.get(line, 0.0), near)
        if k + 1 < len(trail.steps):
            line = trail.steps[k + 1].line
            weights[line] = max(weights.get(line, 0.0), FOLLOWING * weight)

    for anchor in found.anchors:
        follow(anchor.step, anchor.weight, 0)
    for k, step in enumerate(trail.steps):
        if isinstance(step.instruction, DECIDING) and step.line not in decided:
            decided.add(step.line)
            follow(k, DECISIONS, DEEPEST - 2)
    for anchor in found.anchors:
        for name in trail.unknown(anchor.step):
            for k, step in enumerate(trail.steps):
                if trail.writes(k) == name:
                    weights[step.line] = max(weights.get(step.line, 0.0), UNREAD)
    read = trail.data_read()
    before = trail.lines
    if found.first_s is not None:
        before = frozenset(
            step.line for k, step in enumerate(trail.steps) if trail.time_of(k) <= found.first_s
        )
    return Blame(
        weights,
        found.residuals,
        found.poses,
        trail.lines | read,
        trail.steps[-1].line if trail.steps else None,
        before | read,
        tuple(dict.fromkeys(trail.steps[k].line for k in _most(found.anchors) if found.lost)),
        all(loss.kind == "time" for loss in grade.losses) and not stopped,
    )


def _most(anchors: Sequence[Anchor]) -> list[int]:
    """Return the executed steps where most shows, in the order of the run."""
    most = max((anchor.weight for anchor in anchors), default=0.0)
    return sorted({anchor.step for anchor in anchors if anchor.weight == most})
