"""Whether a task is ready to be handed out: its reference, the empty program, its times.

Answers with findings, with times proposed from the reference, and with what every goal, via point
and contact is worth.
"""

from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import NamedTuple

from vrts.base.diagnostic import Diagnostic, Rule, error
from vrts.base.units import mm
from vrts.check.rules.scheme import Contacts, MarkScheme
from vrts.check.task.feasible import task_findings
from vrts.check.task.goals import Goal, Relation
from vrts.check.task.manifest import NOT_COUNTING
from vrts.check.task.score import divided
from vrts.check.task.task import Task
from vrts.check.task.task_file import MAX_SHARE, PAR_SHARE
from vrts.check.verdicts.duration import duration
from vrts.pipeline.assess import assess
from vrts.pipeline.compiling.reading import ProgramFile
from vrts.pipeline.files import read_bytes
from vrts.pipeline.request import Request
from vrts.pipeline.setting import Setting
from vrts.report.assessment import Assessment
from vrts.report.quantities import full
from vrts.scene.checks import scene_findings

BELOW_FULL = Rule("V674", "reference-below-full")
EMPTY_SCORES = Rule("V675", "empty-program-scores")
NO_REFERENCE = Rule("V676", "no-reference")

EMPTY = b".PROGRAM main()\n        ; does nothing\n.END\n"
STEP_S = Fraction(1, 10)  # to which times are proposed, rounded up


class Times(NamedTuple):
    """Times proposed from a reference [s]."""

    reference_s: Fraction
    t_par_s: Fraction
    t_max_s: Fraction


class Worth(NamedTuple):
    """What not meeting something costs, with everything else met."""

    points: Fraction
    what: str  # "`can1` not on base2"


class TaskCheck(NamedTuple):
    """What was found out about a task."""

    reference: Assessment | None
    empty: Assessment
    times: Times | None  # None: there is no reference that comes to its end
    worths: tuple[Worth, ...]
    findings: tuple[Diagnostic, ...]

    @property
    def ready(self) -> bool:
        """Whether the task can be handed out."""
        return not any(d.is_error for d in self.findings)


def check_task(setting: Setting, reference: Path | None) -> TaskCheck:
    """Run the reference and the empty program, and look at every goal.

    Args:
        setting: The task with its hidden part.
        reference: The program that is to get full marks; None: there is none.
    """
    task = setting.task
    assert task is not None
    findings = [*setting.diagnostics, *scene_findings(setting.scene)]
    findings += task_findings(setting.scene, task)
    empty = assess(Request(ProgramFile(EMPTY, "the empty program"), setting, identifier="empty"))
    findings += _about_empty(empty, task)
    if reference is None:
        remedy = "write `staff/solution.v2` in the folder of the task"
        findings.append(error(NO_REFERENCE, "the task has no reference solution", help=(remedy,)))
        return TaskCheck(None, empty, None, worths(task), tuple(findings))
    longest = replace(task, t_max=max(task.t_max, setting_limit(task)), proof=None)
    data = read_bytes(reference)
    found = assess(Request(ProgramFile(data, reference.name), setting))
    free = assess(Request(ProgramFile(data, "reference"), replace(setting, task=longest)))
    findings += _about_reference(found)
    for variant in setting.variants:
        assert variant.task is not None
        findings += (*variant.diagnostics, *scene_findings(variant.scene))
        findings += task_findings(variant.scene, variant.task)
        name = f"{reference.name} in {variant.scene.name}"
        there = assess(Request(ProgramFile(data, name), variant))
        findings += _about_reference(there)
    return TaskCheck(found, empty, times_of(free), worths(task), tuple(findings))


def setting_limit(task: Task) -> float:
    """Return how long a reference may run while its time is taken [s]."""
    return 10.0 * task.t_max


def times_of(reference: Assessment) -> Times | None:
    """Return the times that follow from a reference that is free of faults, whatever it takes."""
    took = None if reference.run is None else duration(reference.run)
    if took is None or not took:
        return None
    length = _rounded_up(took)
    par = _rounded_up(PAR_SHARE * length)
    return Times(length, par, MAX_SHARE * par)


def _rounded_up(time_s: Fraction) -> Fraction:
    return -((-time_s) // STEP_S) * STEP_S


def worths(task: Task) -> tuple[Worth, ...]:
    """Return what every goal, via point, demand and contact costs, each alone."""
    scheme = task.mark
    targets, vias = divided(scheme, targets=bool(task.targets), vias=bool(task.vias))
    total = sum((goal.weight for goal in task.targets), Fraction(0)) or Fraction(1)
    found = [
        Worth(targets * goal.weight / total, _missed(goal, scheme.zero_at)) for goal in task.targets
    ]
    if not task.targets and not task.vias:
        found.append(Worth(targets, "a program that does not come to its end"))
    found += [
        Worth(vias / len(task.vias), f"`{via.name}` not passed within {mm(via.radius):.0f} mm")
        for via in task.vias
    ]
    found += [Worth(cost.points, f"`{cost.name}` not kept") for cost in task.costs]
    return (
        *found,
        Worth(scheme.broken_limit, "a limit of the robot that is broken or moved"),
        *_contacts(scheme),
        Worth(scheme.contact_cap, "contacts and drops, at most"),
        Worth(scheme.time_bonus, "any of these: there are no points for speed then"),
    )


def _contacts(scheme: MarkScheme) -> tuple[Worth, ...]:
    first = Worth(scheme.first_contact, "the first contact, or object dropped")
    match scheme.contacts_by:
        case Contacts.EVENTS:
            return (first, Worth(scheme.further_contact, "each further one"))
        case Contacts.TIME:
            more = Worth(scheme.per_second, "each second of contact, as well")
        case Contacts.DEPTH:
            more = Worth(scheme.per_mm, "each millimetre of depth, as well")
    return (first, more, Worth(scheme.further_contact, "each further object dropped"))


def _missed(goal: Goal | Relation, zero_at: Fraction) -> str:
    """Return what it is not to meet a goal, in words."""
    if isinstance(goal, Relation):
        return f"`{goal.body}` not as it should be: {goal.title}"
    bodies = " or ".join(f"`{name}`" for name in goal.bodies)
    off = mm(goal.position_tolerance) * float(zero_at)
    words = f"{bodies} not at its goal: {goal.title}; nothing is earned from {off:.0f} mm off"
    phases = goal.phases
    shares = (("gripped", phases.gripped), ("lifted", phases.lifted))
    given = [f"{float(100 * share):g} % is for being {word}" for word, share in shares if share]
    return "; ".join((words, *given))


def _about_empty(empty: Assessment, task: Task) -> tuple[Diagnostic, ...]:
    assert empty.grade is not None
    if not empty.grade.mark:
        return ()
    mark, total = float(empty.grade.mark), full(empty.grade.total)
    headline = f"a program that does nothing gets {mark:g} of {total}"
    earned = {row.check for row in empty.grade.earned if row.kind == "target" and row.points}
    notes = tuple(_from_the_start(goal) for goal in task.targets if goal.check in earned)
    remedy = "move what starts at its goal, or make tolerances smaller"
    if not task.targets and not task.vias:
        notes = ("it comes to its end, and what it breaks costs less than that gives",)
        remedy = "give more `points` to what a program that does nothing does not keep to"
    return (error(EMPTY_SCORES, headline, notes=notes, help=(remedy,)),)


def _from_the_start(goal: Goal | Relation) -> str:
    if isinstance(goal, Goal) and len(goal.bodies) == 1:
        return f"`{goal.body}` is at its goal from the start"
    return f"{goal.title}: so it is from the start"


def _about_reference(found: Assessment) -> tuple[Diagnostic, ...]:
    assert found.grade is not None
    if found.grade.mark == found.grade.total and found.grade.ready:
        return ()
    losses = [loss for loss in found.grade.losses if loss.points]
    notes = tuple(f"{float(loss.points):.1f} lost by: {loss.sentence}" for loss in losses[:5])
    mark, total = float(found.grade.mark), full(found.grade.total)
    headline = f"the reference `{found.title}` gets {mark:g} of {total}"
    errors = tuple(d for d in found.diagnostics if d.is_error and NOT_COUNTING not in d.headline)
    remedy = "mend the solution, or the times and tolerances of the task"
    return (*errors, error(BELOW_FULL, headline, notes=notes, help=(remedy,)))
