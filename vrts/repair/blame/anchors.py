"""Where each loss of a run shows: the executed steps, and how far from right things are there."""

import math
from collections.abc import Iterator
from typing import NamedTuple

from vrts.base.pose import Pose, Vector
from vrts.base.units import MM
from vrts.check.goals.reached import Reached, judged_at, reached
from vrts.check.judgement import Judgement
from vrts.check.mark.grade import Grade
from vrts.check.task.goals import Goal
from vrts.check.task.task import Task
from vrts.check.verdicts.vias import passed
from vrts.engine.hand.told import DROP_HEIGHT
from vrts.engine.memory.events import Found, Grasped, HandCommanded, Released
from vrts.engine.memory.records import Ending
from vrts.engine.run import Run, pose_of
from vrts.ir.motion import SetSpeed
from vrts.repair.blame.trail import Trail

ENDS = (Ending.COMPLETED, Ending.HALTED)
SOON = 1.0  # [s] in which the hand has closed on what it closes on
UNGRIPPED = 0.9  # of the motion that came nearest to a thing that was never gripped
HELD = 0.6  # of how a thing was gripped that touches something later
SLOWEST = 12  # motions looked at where time is lost


class Anchor(NamedTuple):
    """An executed step where a loss shows."""

    weight: float
    step: int


class Shown(NamedTuple):
    """Where the losses of a run show."""

    anchors: tuple[Anchor, ...]
    residuals: tuple[Vector, ...]  # from where something is to where it should be, in W [mm]
    poses: tuple[Pose, ...]  # where the tool should have been, X_WT
    first_s: float | None  # when the first loss surely has happened; None: at the end
    lost: bool  # anchors are steps of losses, and not only of where time goes


class _Finder:
    def __init__(self, run: Run, task: Task, judgement: Judgement, trail: Trail) -> None:
        self.run, self.task, self.judgement, self.trail = run, task, judgement, trail
        self.anchors: list[Anchor] = []
        self.residuals: list[Vector] = []
        self.poses: list[Pose] = []
        self.times: list[float] = []

    def step(self, weight: float, k: int | None) -> None:
        if k is not None:
            self.anchors.append(Anchor(weight, k))

    def motion(self, time_s: float, weight: float) -> None:
        at = self.trail.motion_at(time_s)
        for beside, share in ((0, 1.0), (-1, 0.7), (1, 0.4)):
            self.step(weight * share, self.trail.motion_steps.get(at + beside))

    def stop(self) -> bool:
        """Find the error that stopped the program: all that came after is lost to it."""
        if self.run.ending in (*ENDS, Ending.LIMIT):
            return False
        errors = [
            e for e in self.run.events if isinstance(e, Found) and e.diagnostic.is_error and e.cause
        ]
        if not errors:
            return False
        self.step(1.0, self.trail.step_of(errors[-1].cause, errors[-1].time_s))
        self.times.append(errors[-1].time_s)
        return bool(self.anchors)

    def contacts(self) -> None:
        report = self.judgement.collisions
        for contact in report.contacts if report is not None else ():
            self.motion(contact.start_s, 1.0)
            self.times.append(contact.start_s)
            if contact.held is not None and contact.parts[0] == contact.held:
                self.gripped(contact.held, contact.start_s)

    def gripped(self, body: str, time_s: float) -> None:
        """Find where a thing was gripped that touches something: it may be held wrongly."""
        found = [
            e
            for e in self.run.events
            if isinstance(e, Grasped) and e.body == body and e.time_s <= time_s
        ]
        for e in found[-1:]:
            self.motion(e.time_s, HELD)

    def goals(self) -> None:
        time_s = min(judged_at(self.run, self.task), self.run.horizon_s)
        state = self.run.at(time_s)
        for result in reached(self.run, self.task):
            goal = result.goal
            if result.share == 1 or not isinstance(goal, Goal):
                continue
            grasps = [
                e for e in self.run.events if isinstance(e, Grasped) and e.body == result.body
            ]
            if grasps:
                X_WO = pose_of(state.placements[result.body], time_s, state.X_WF)
                self.carried(result, goal, grasps[-1], X_WO)
            else:
                self.never(result.body)

    def carried(self, result: Reached, goal: Goal, grasp: Grasped, X_WO: Pose) -> None:
        for e in self.run.events:
            if isinstance(e, Released | Grasped) and e.body == result.body and e.cause:
                weight = 1.0 if isinstance(e, Released) else 0.7
                self.step(weight, self.trail.step_of(e.cause, e.time_s))
                self.motion(e.time_s, weight)
        self.residuals.append(_apart(goal.X_WG.translation, X_WO.translation))
        if not self.run.motions:
            return
        X_WT = goal.X_WG @ grasp.X_FO.inverse() @ self.run.motions[-1].X_FT
        self.poses.append(X_WT)
        nearest = min(
            range(len(self.run.motions)),
            key=lambda m: math.dist(self.run.motions[m].X_WT.translation, X_WT.translation),
        )
        self.step(0.9, self.trail.motion_steps.get(nearest))

    def never(self, body: str) -> None:
        """Find the closing of the hand that should have gripped a thing."""
        at = self.run.scene.body(body).X_WO.translation
        closings = [
            e for e in self.run.events if isinstance(e, HandCommanded) and e.action == "close"
        ]
        gripped = [(e.cause, e.time_s) for e in self.run.events if isinstance(e, Grasped)]
        empty = [
            e
            for e in closings
            if not any(c == e.cause and 0.0 <= t - e.time_s < SOON for c, t in gripped)
        ]
        place = self.run.scene.locations.get(f"{body}_grip")
        if place is not None:
            self.poses.append(place)

        def distance(e: HandCommanded) -> float:
            tool = self.run.at(min(e.time_s, self.run.horizon_s)).X_WT.translation
            return math.dist(tool[:2], at[:2])

        if self.run.motions:  # or it should have closed where the tool came nearest
            near = place.translation if place is not None else at
            nearest = min(
                range(len(self.run.motions)),
                key=lambda m: math.dist(self.run.motions[m].X_WT.translation, near),
            )
            self.step(UNGRIPPED, self.trail.motion_steps.get(nearest))
        for e in sorted(empty or closings, key=distance)[:1]:
            self.step(1.0, self.trail.step_of(e.cause, e.time_s))
            self.motion(e.time_s, 1.0)
            if place is not None:
                tool = self.run.at(min(e.time_s, self.run.horizon_s)).X_WT.translation
                self.residuals.append(_apart(place.translation, tool))

    def vias(self) -> None:
        found = passed(self.run, self.task)
        for visits, lack in zip(found.visits, found.lacks, strict=True):
            if lack is None:
                continue
            self.motion(visits.best_s, 1.0)
            time_s = min(visits.best_s, self.run.horizon_s)
            tool = self.run.at(time_s).X_WT.translation
            self.residuals.append(_apart(visits.via.point, tool))
            for motion in self.run.motions:
                if motion.start_s <= time_s <= motion.end_s + SOON:
                    self.residuals.append(_apart(visits.via.point, motion.X_WT.translation))

    def events(self) -> None:
        for e in self.run.events:
            if isinstance(e, Released) and e.height_m > DROP_HEIGHT:
                self.step(1.0, self.trail.step_of(e.cause, e.time_s))
                self.motion(e.time_s, 1.0)
                self.residuals.append((0.0, 0.0, -e.height_m / MM))
                self.times.append(e.time_s)
            elif isinstance(e, Found):
                weight = 1.0 if e.diagnostic.is_error else 0.6
                self.step(weight, self.trail.step_of(e.cause, e.time_s))

    def demands(self, grade: Grade) -> None:
        """Find the steps at which the demands of a task are not kept, as far as they are known."""
        lines = {loss.span.line for loss in grade.losses if loss.kind == "demand" and loss.span}
        for k, step in enumerate(self.trail.steps):
            if step.line in lines:
                self.step(1.0, k)

    def slow(self) -> None:
        """Find where the time goes: slow motions, the speeds in force, and waiting."""
        run, trail = self.run, self.trail
        total = run.ended_s or run.horizon_s or 1.0
        longest = sorted(
            range(len(run.motions)), key=lambda m: run.motions[m].start_s - run.motions[m].end_s
        )
        for m in longest[:SLOWEST]:
            k = trail.motion_steps.get(m)
            if k is None:
                continue
            share = (run.motions[m].end_s - run.motions[m].start_s) / total
            weight = min(1.0, 0.5 + 2 * share)
            self.step(0.6 * weight, k)
            for j in range(k - 1, -1, -1):
                step = trail.steps[j].instruction
                if isinstance(step, SetSpeed):
                    self.step(weight, j)
                    if step.scope.value == "always":
                        break
        for k in range(len(trail.steps)):
            last = k + 1 == len(trail.steps)
            end = total if last else trail.time_of(k + 1)
            if end - trail.time_of(k) > 0.15 * total:
                self.step(0.9, k)
                self.step(0.6, k if last else k + 1)


def _apart(to: Vector, start: Vector) -> Vector:
    x, y, z = ((a - b) / MM for a, b in zip(to, start, strict=True))
    return (x, y, z)


def shown(run: Run, task: Task, judgement: Judgement, grade: Grade, trail: Trail) -> Shown:
    """Return where the losses of a run show."""
    found = _Finder(run, task, judgement, trail)
    lost = True
    if not found.stop():
        found.contacts()
        found.goals()
        found.vias()
        found.events()
        found.demands(grade)
        late = run.ending is Ending.LIMIT or any(
            loss.kind == "time" and "takes" in loss.sentence for loss in grade.losses
        )
        lost = bool(found.anchors) or late
        if late or not found.anchors:
            found.slow()
    if trail.steps and (run.ending is not Ending.COMPLETED or not found.anchors):
        found.step(1.0 if run.ending is not Ending.COMPLETED else 0.5, len(trail.steps) - 1)
    return Shown(
        tuple(found.anchors),
        tuple(_once(found.residuals)),
        tuple(found.poses),
        min(found.times, default=None),
        lost,
    )


def _once(residuals: list[Vector]) -> Iterator[Vector]:
    kept = {tuple(round(x, 2) for x in each): each for each in residuals}
    yield from kept.values()
