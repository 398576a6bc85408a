"""What counts in a task, in plain words: the part of README.md that is written from task.toml."""

from collections.abc import Iterable, Iterator, Sequence
from datetime import timedelta
from fractions import Fraction
from typing import TypeAlias

from vrts.assignments.handed.demand_words import demand_words
from vrts.assignments.handed.exam_words import exam_words
from vrts.assignments.handed.words import box, number, place, points, title, turn
from vrts.base.units import deg, mm
from vrts.check.goals.placed import counted
from vrts.check.rules.hints import Hints
from vrts.check.rules.scheme import Contacts, MarkScheme
from vrts.check.rules.settings import FULL_ACCELERATION
from vrts.check.task.demands import Keeps
from vrts.check.task.goals import Choice, Goal, Looks, Relation, Stands
from vrts.check.task.late_rules import Keep, LateRules
from vrts.check.task.score import divided
from vrts.check.task.task import Task, ViaPoint
from vrts.robots.kinematics.branch import has_branches
from vrts.scene.model import Scene

_Part: TypeAlias = tuple[str, str, Sequence[str]]  # heading, words before the lines, lines

TOLD = {
    Hints.NOTHING: "hints: vrts tells what is wrong, but not how to mend it",
    Hints.PLACE: "hints: vrts may tell the line that has to be changed, and no more",
    Hints.DIRECTION: "hints: vrts may tell the line that has to be changed and in which direction",
    Hints.NUMBER: "hints: vrts may tell the number that has to be changed, and what would do",
    Hints.EDIT: "hints: vrts may tell the whole change that would mend a program",
}


def task_words(task: Task, scene: Scene, *, hidden: bool = False) -> str:
    """Return what counts in the public part of a task, as Markdown.

    Args:
        task: Without its hidden part.
        scene: That it is set in.
        hidden: Whether marking has more checks, which are not told.
    """
    scheme = task.mark
    for_goals, for_vias = divided(scheme, targets=bool(task.targets), vias=bool(task.vias))
    parts = [
        ("## What counts", "", _first(task, scene)),
        _targets(task, for_goals, scene),
        _vias(task, for_vias),
        ("### What a program must keep to", "", _bullets(demand_words(task))),
        ("### What costs points", "", _bullets(_costs(scheme))),
        ("### Speed", "", (_speed(task),)),
        ("### The exam", "", _bullets(exam_words(task))),
        ("### Other rules", "", _bullets(_rest(task, hidden=hidden))),
    ]
    return "\n".join(_section(*part) for part in parts if part[-1])


def _section(heading: str, intro: str, lines: Sequence[str]) -> str:
    first = f"{heading}\n\n{intro}\n\n" if intro else f"{heading}\n\n"
    return first + "".join(f"{line}\n" for line in lines)


def _bullets(lines: Iterable[str]) -> tuple[str, ...]:
    return tuple(f"- {line}" for line in lines)


def _first(task: Task, scene: Scene) -> tuple[str, ...]:
    said = [f"The mark is out of {points(task.mark.total)}."]
    if task.program is not None:
        said.append(f"The program `{task.program}` of your file is executed.")
    zones = any(demand.keeps in (Keeps.TOOL_OUT, Keeps.ROBOT_OUT) for demand in task.demands)
    if task.targets or task.vias or zones:
        origin = "shoulder" if has_branches(scene.robot.arm) else "foot"
        said.append(
            f"X, Y and Z are in mm from the robot's {origin}: X forward, Y to the left, Z up."
        )
    if task.goals:
        said.append("The place of an object is the middle of its underside.")
    if any(_shows_turns(goal, choice, scene) for goal in task.goals for choice in goal.choices):
        said.append(
            "Turns are counter-clockwise, seen from above; at 0 degrees an object is along X and Y."
        )
    return tuple(said)


def _targets(task: Task, every: Fraction, scene: Scene) -> _Part:
    heading = f"### What has to be done: {points(every)}"
    if not task.targets:
        ends = () if task.vias else ("- the program comes to its end",)
        return heading, "", ends
    times = number(float(task.mark.zero_at))
    intro = (
        "In the end each object is at rest, and the hand has let go. An object within the limits "
        f"below earns\nall its points. Farther off it earns less, and nothing from {times} times "
        "these limits on."
    )
    total = sum((goal.weight for goal in task.targets), Fraction(0))
    said = [_goal(goal, scene) for goal in task.goals] + [_relation(one) for one in task.relations]
    worth = [points(every * target.weight / total) for target in task.targets]
    lines = (f"{words}: {share}" for words, share in zip(said, worth, strict=True))
    return heading, intro, _bullets(lines)


def _goal(goal: Goal, scene: Scene) -> str:
    off, turned = mm(goal.position_tolerance), deg(goal.orientation_tolerance)
    where = " or ".join(dict.fromkeys(_where(goal, choice, scene) for choice in goal.choices))
    words = [f"{title(goal.title)} ({where}), within {number(off)} mm and {number(turned)} degrees"]
    if goal.looks is Looks.UPRIGHT:
        words.append("upside down is wrong, also where it looks the same")
    if goal.looks is Looks.NONE:
        words.append("every turn counts, also where it looks the same")
    phases = goal.phases
    if phases.gripped:
        words.append(f"{_percent(phases.gripped)} of its points are for being gripped")
    if phases.lifted:
        lifted = f"lifted by {number(mm(phases.height))} mm"
        words.append(f"{_percent(phases.lifted)} of its points are for being {lifted}")
    return "; ".join(words)


def _where(goal: Goal, choice: Choice, scene: Scene) -> str:
    at = place(choice.X_WG.translation)
    return f"{at}, {turn(choice.X_WG)}" if _shows_turns(goal, choice, scene) else at


def _shows_turns(goal: Goal, choice: Choice, scene: Scene) -> bool:
    """Return whether it can be seen how an object is turned about its own vertical."""
    return counted(scene.body(choice.body), goal.looks).upright().axis is None


def _percent(share: Fraction) -> str:
    return f"{number(float(100 * share))} %"


def _relation(relation: Relation) -> str:
    words = [title(relation.title)]
    match relation.stands:
        case Stands.INSIDE:
            words.append(f"the whole object is in the box {box(relation.lower, relation.upper)}")
        case Stands.ON:
            words.append(f"`{relation.body}` is stacked on `{relation.other}`")
        case Stands.ALIGNED:
            turned = number(deg(relation.turn_tolerance))
            row = f"`{relation.body}` is in one row with `{relation.other}`, along {relation.along}"
            words.append(f"{row}, turned alike within {turned} degrees")
        case Stands.LEFT | Stands.RIGHT | Stands.FARTHER | Stands.NEARER:
            by = number(mm(relation.distance))
            way = relation.stands.value.replace("_", " ")
            words.append(f"`{relation.body}` is {way} `{relation.other}` by {by} mm or more")
    if relation.tolerance is None:
        words.append("all or nothing")
    else:
        words.append(f"within {number(mm(relation.tolerance))} mm")
    return ", ".join(words)


def _vias(task: Task, every: Fraction) -> _Part:
    order = ", in this order" if task.ordered and len(task.vias) > 1 else ""
    heading = f"### What the tool has to pass{order}: {points(every)}"
    one = every / max(1, len(task.vias))
    return heading, "", _bullets(f"{_via(via)}: {points(one)}" for via in task.vias)


def _via(via: ViaPoint) -> str:
    near = f"within {number(mm(via.radius))} mm of {place(via.point)}"
    words = [f"{title(via.name)}, passed by the point between the pads {near}"]
    if via.approach is not None:
        along = ", ".join(number(value) for value in via.approach)
        words.append(f"the tool points along ({along}) within {number(deg(via.cone))} degrees")
    if via.slowest > 0:
        words.append(f"the tool has {number(mm(via.slowest))} mm/s or more there")
    if via.fastest < float("inf"):
        words.append(f"the tool has {number(mm(via.fastest))} mm/s or less there")
    return "; ".join(words)


def _costs(scheme: MarkScheme) -> Iterator[str]:
    yield f"the first contact, or object dropped: {points(scheme.first_contact)}"
    match scheme.contacts_by:
        case Contacts.EVENTS:
            yield f"each further contact, or object dropped: {points(scheme.further_contact)}"
        case Contacts.TIME:
            yield f"each second of contact, as well: {points(scheme.per_second)}"
        case Contacts.DEPTH:
            yield f"each millimetre of depth of a contact, as well: {points(scheme.per_mm)}"
    if scheme.contacts_by is not Contacts.EVENTS:
        yield f"each further object dropped: {points(scheme.further_contact)}"
    yield f"all contacts and drops together: {points(scheme.contact_cap)} at most"
    limit = "a limit of the robot that is broken, or a setting that is not for programs"
    yield f"{limit}: {points(scheme.broken_limit)}, once"


def _speed(task: Task) -> str:
    par, longest = number(task.t_par), number(task.t_max)
    return (
        f"A program without any mistake earns {points(task.mark.time_bonus)} more if it takes no "
        f"longer than {par} s.\nThen it earns less, and nothing from {longest} s on, when it is "
        "stopped."
    )


def _rest(task: Task, *, hidden: bool) -> Iterator[str]:
    locks = task.locks
    if locks.names:
        yield f"a program may not set {', '.join(f'`{name}`' for name in locks.names)}"
    if locks.acceleration < FULL_ACCELERATION:
        yield f"`ACCEL` may ask for {number(locks.acceleration)} % at most"
    exam = task.late is not None and task.late.is_exam  # which says so itself
    if task.late is not None and not exam:
        yield from _late(task.late)
    if task.keep is Keep.BEST and not exam:
        yield "of several hand-ins, the one with the best mark counts"
    elif task.late is not None and not exam:
        yield "of several hand-ins, the latest counts"
    yield TOLD[task.hints]
    if hidden:
        yield "marking has more checks, which share these points; `vrts grade` says how many"


def _late(late: LateRules) -> Iterator[str]:
    grace = ""
    if late.grace:
        grace = f"; up to {number(late.grace / timedelta(minutes=1))} min later costs nothing"
    yield f"due: {late.due.isoformat(' ')}{grace}"
    if late.per_day:
        yield f"each day late that has begun: {points(late.per_day)}, {points(late.most)} at most"
    for step in late.steps:
        hours = number(step.after / timedelta(hours=1))
        yield f"more than {hours} h late: {points(min(step.points, late.most))}"
    if late.closed is not None:
        yield f"what comes after {late.closed.isoformat(' ')} gets 0"
