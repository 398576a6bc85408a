"""What seems wrong is replayed in full, on the ordinary engine and by the ordinary checks."""

import math
from typing import NamedTuple

from vrts.check.collision.collision import check_collisions
from vrts.check.task.task import Task
from vrts.check.verdict import Answer, ContactEvent, sides
from vrts.check.verdicts.limits import check_limits
from vrts.engine.controller import advance, commands_of, start
from vrts.engine.faults import NO_ANSWER, WAIT_NEVER_ENDS
from vrts.engine.machine.forever.findings import ENDLESS
from vrts.engine.memory.events import Cause, Found
from vrts.engine.memory.records import INSTANT, Ending
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.prove.environment.environment import Environment
from vrts.prove.graph.suspects import Suspect
from vrts.prove.proof import Wrong
from vrts.prove.properties.of_run import first_broken
from vrts.prove.telling.goals import missed
from vrts.scene.model import Scenario, Scene

NEVER = (ENDLESS, WAIT_NEVER_ENDS, NO_ANSWER)
BEYOND_S = 1.0  # a replay goes on behind what it is to show


class Shown(NamedTuple):
    """What a replay shows of a suspect."""

    headline: str
    time_s: float
    cause: Cause | None


class Replays:
    """Replays scenarios of one program."""

    def __init__(
        self,
        module: Module,
        scene: Scene,
        environment: Environment,
        entry: str,
        task: Task | None,
    ) -> None:
        """Take what is executed, where, and what is asked of it."""
        self.module, self.scene, self.environment = module, scene, environment
        self.entry, self.task = entry, task
        self.count = 0

    def run(self, scenario: Scenario, until_s: float) -> Run:
        """Return the run of a scenario up to a time."""
        self.count += 1
        run = start(self.module, self.scene, scenario)
        commands = commands_of(scenario, self.entry)
        return advance(run, until_s, [c for c in commands if c.time_s <= until_s], closed=True)

    def shows(self, suspect: Suspect, scenario: Scenario) -> Shown | None:
        """Return what a replay shows of what seems wrong; None: it does not come about."""
        last = max([act.time_s for act in scenario.operator], default=0.0)
        limit = last + scenario.limits.time_s + BEYOND_S
        match suspect.wrong:
            case Wrong.ENDLESS | Wrong.DEADLOCK:
                return _never(self.run(scenario, limit), suspect)
            case Wrong.CONTACT:
                run = self.run(scenario, min(suspect.time_s + BEYOND_S, limit))
                return self._contact(run, suspect)
            case Wrong.LIMIT:
                run = self.run(scenario, min(suspect.time_s + 10.0 * BEYOND_S, limit))
                return _limit(run, suspect)
            case Wrong.ERROR:
                run = self.run(scenario, min(suspect.time_s + BEYOND_S, limit))
                return _error(run, suspect)
            case Wrong.PROPERTY:
                until_s = min(suspect.time_s + BEYOND_S, limit)
                return self._property(self.run(scenario, until_s), suspect, until_s)
            case Wrong.GOAL | Wrong.DEMAND:
                return self._missed(self.run(scenario, limit), suspect)
            case Wrong.UNBOUNDED:
                return None

    def _property(self, run: Run, suspect: Suspect, until_s: float) -> Shown | None:
        number, tick_s = int(suspect.what[0]), self.scene.robot.arm.tick
        until_s = math.floor(until_s / tick_s + INSTANT) * tick_s
        broken = first_broken(run, self.environment.properties[number : number + 1], until_s)
        if broken is None:
            return None
        under_way = _under_way(run, min(broken.time_s, run.horizon_s))
        return Shown(suspect.headline, broken.time_s, under_way)

    def _missed(self, run: Run, suspect: Suspect) -> Shown | None:
        for one in () if self.task is None else missed(run, self.task):
            if (one.verdict.check,) == suspect.what and one.verdict.answer is Answer.VIOLATED:
                words = f"{one.verdict.check}: {one.verdict.summary}"
                return Shown(words, one.time_s, None)
        return None

    def _contact(self, run: Run, suspect: Suspect) -> Shown | None:
        report = check_collisions(self.scene, run, clearance=False)  # only contacts are asked for
        for contact in report.contacts:
            if _same_bodies(contact, suspect.what[:2]):
                first, second = sides(contact)
                depth = f"{1e3 * contact.depth_m:.1f} mm deep"
                words = f"{first} touches {second}, {depth}"
                return Shown(words, contact.start_s, contact.cause)
        return None


def _under_way(run: Run, time_s: float) -> Cause | None:
    """Return the step under way at a time, or after the last one that of the motion."""
    robot = run.at(time_s).robot
    if robot is not None and robot.cause is not None:
        return robot.cause
    moving = (m.cause for m in run.motions if m.start_s <= time_s <= m.end_s)
    return next(moving, None)


def _same_bodies(contact: ContactEvent, bodies: tuple[str, ...]) -> bool:
    told = {contact.first, contact.second, *contact.parts, *sides(contact)}
    return set(bodies) <= told


def _never(run: Run, suspect: Suspect) -> Shown | None:
    for event in run.events:
        if not isinstance(event, Found) or event.diagnostic.rule not in NEVER:
            continue
        cause = event.cause
        if cause is not None and _at(cause) in suspect.steps:
            return Shown(_without_why(event), event.time_s, cause)
    if run.ending is Ending.LIMIT and suspect.wrong is Wrong.ENDLESS:  # it counts its rounds
        return Shown(suspect.headline, suspect.time_s, suspect.cause)
    return None


def _without_why(event: Found) -> str:
    found = event.diagnostic
    return f"{found.headline}; {found.notes[0]}" if len(found.notes) > 1 else found.headline


def _limit(run: Run, suspect: Suspect) -> Shown | None:
    code, *joint = suspect.what
    for finding in check_limits(run).findings:
        label, joints = finding.primary, [str(finding.data.get("joint"))]
        same = suspect.cause is None or (label and label.span == suspect.cause.span)
        if finding.rule.code == code and same and (not joint or joint == joints):
            causes = [motion.cause for motion in run.motions]
            cause = next((c for c in causes if label and c.span == label.span), suspect.cause)
            time_s = suspect.time_s if finding.moment is None else finding.moment.time_s
            return Shown(finding.headline, time_s, cause)
    return None


def _error(run: Run, suspect: Suspect) -> Shown | None:
    for event in run.events:
        if not isinstance(event, Found):
            continue
        same = (
            event.cause is None or suspect.cause is None or _at(event.cause) == _at(suspect.cause)
        )
        if (event.diagnostic.rule.code,) == suspect.what and same:
            return Shown(event.diagnostic.headline, event.time_s, event.cause)
    if run.ending is Ending.ERROR and not suspect.what:
        return Shown(suspect.headline, suspect.time_s, suspect.cause)
    return None


def _at(cause: Cause) -> tuple[str, int]:
    return cause.program, cause.step
