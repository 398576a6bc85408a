"""The public part of a task as the page of a room shows it: words, places, and what is drawn.

Lengths are in m, but for names that say otherwise (`positionMm`); poses are as the viewer's.
Hidden checks are not read by a session, so they cannot be in it.
"""

from collections.abc import Iterable, Sequence
from typing import Final

from vrts.base.units import deg, mm
from vrts.check.goals.placed import counted
from vrts.check.rules.scheme import Contacts, MarkScheme
from vrts.check.task.demands import Demand, Keeps
from vrts.check.task.goals import Goal, Relation, Stands
from vrts.check.task.task import Task, ViaPoint
from vrts.check.verdicts.demand_words import wanted
from vrts.live.session.channel.messages import Json
from vrts.report.page.viewer_data import pose_numbers
from vrts.report.plain import capital, one_line, visible
from vrts.report.quantities import MINUS, points
from vrts.scene.model import Scene

MOST: Final = 200  # goals, relations, zones ... of a kind that are shown
LONGEST: Final = 4000  # characters of the description
MOST_TURNS: Final = 48  # of a thing that looks the same after them
KEPT_OUT_OF: Final = (Keeps.TOOL_OUT, Keeps.ROBOT_OUT)
OF_PROGRAMS: Final = (Keeps.USES, Keeps.AVOIDS, Keeps.STEPS)
BESIDE: Final = {
    Stands.LEFT: "left of",
    Stands.RIGHT: "right of",
    Stands.FARTHER: "farther away than",
    Stands.NEARER: "nearer to the robot than",
}


def task_view(scene: Scene, task: Task) -> Json:
    """Return everything about a task that people in a room may see."""
    return {
        "title": one_line(task.title),
        "text": visible(shortened(task.description)),
        "total": float(task.mark.total),
        "zeroAt": float(task.mark.zero_at),
        "ordered": task.ordered and len(task.vias) > 1,
        "goals": [
            *(_goal(scene, goal) for goal in task.goals[:MOST]),
            *(_relation(relation) for relation in task.relations[:MOST]),
        ],
        "vias": [_via(via) for via in task.vias[:MOST]],
        "zones": [_zone(d) for d in task.demands[:MOST] if d.keeps in KEPT_OUT_OF],
        "rules": list(_rules(task)),
    }


def shortened(text: str) -> str:
    """Return a text of a length that a panel can show."""
    return text if len(text) <= LONGEST else f"{text[: LONGEST - 1]}…"


def _goal(scene: Scene, goal: Goal) -> Json:
    near = f"within {mm(goal.position_tolerance):g} mm"
    turned = f"{deg(goal.orientation_tolerance):g} degrees"
    shapes: dict[str, Json] = {}
    for name in goal.bodies:
        same = counted(scene.body(name), goal.looks)
        shapes[name] = {
            "turns": [pose_numbers(turn) for turn in same.turns[:MOST_TURNS]],
            "axis": None if same.axis is None else list(same.axis),
            "foot": list(same.foot),
        }
    return {
        "kind": "goal",
        "check": goal.check,
        "title": one_line(goal.title),
        "words": f"{_choices(goal)}{near} and {turned}{_phases(goal)}",
        "bodies": list(goal.bodies),
        "places": [
            {"body": c.body, "X": pose_numbers(c.X_WG), "where": one_line(c.where)}
            for c in goal.choices[:MOST]
        ],
        "shapes": shapes,
        "positionMm": mm(goal.position_tolerance),
        "orientationDeg": deg(goal.orientation_tolerance),
    }


def _choices(goal: Goal) -> str:
    if not goal.others:
        return ""
    once = ", each for one goal only" if goal.group is not None else ""
    return f"any of {len(goal.others)} places{once}, "


def _phases(goal: Goal) -> str:
    shares = (
        ("gripped", goal.phases.gripped, ""),
        ("lifted", goal.phases.lifted, f" by {mm(goal.phases.height):g} mm"),
    )
    told = [f"{100 * float(s):g} % for being {word}{by}" for word, s, by in shares if s]
    return f"; {' and '.join(told)}" if told else ""


def _relation(relation: Relation) -> Json:
    return {
        "kind": "relation",
        "check": relation.check,
        "title": one_line(relation.title),
        "words": _relation_words(relation),
        "bodies": [relation.body],
        "places": [],
        "other": relation.other,
        "stands": relation.stands.value,
        "box": _box(relation.lower, relation.upper) if relation.stands is Stands.INSIDE else None,
    }


def _relation_words(relation: Relation) -> str:
    slack = "" if relation.tolerance is None else f", within {mm(relation.tolerance):g} mm"
    match relation.stands:
        case Stands.INSIDE:
            where = "all of it inside the box that is drawn"
        case Stands.ON:
            where = f"standing on {relation.other}, wherever that is"
        case Stands.ALIGNED:
            turned = f"{deg(relation.turn_tolerance):g} degrees"
            where = f"in a row with {relation.other} along {relation.along}, turned by {turned}"
            where += " at most"
        case beside:
            where = f"{BESIDE[beside]} {relation.other}, by {mm(relation.distance):g} mm at least"
    return where + slack


def _via(via: ViaPoint) -> Json:
    x, y, z = (mm(n) for n in via.point)
    at = f"{x:g}, {y:g}, {z:g}".replace("-", MINUS)
    words = [f"the tool comes within {mm(via.radius):g} mm of {at} mm"]
    if via.approach is not None:
        words.append(f"points along the arrow, within {deg(via.cone):g} degrees")
    if via.slowest > 0.0:
        words.append(f"no slower than {mm(via.slowest):g} mm/s")
    if via.fastest < float("inf"):
        words.append(f"no faster than {mm(via.fastest):g} mm/s")
    return {
        "check": f"via {via.name}",
        "name": one_line(via.name),
        "point": list(via.point),
        "radius": via.radius,
        "approach": None if via.approach is None else list(via.approach),
        "words": ", ".join(words),
    }


def _zone(demand: Demand) -> Json:
    return {"name": one_line(demand.name), **_box(demand.lower, demand.upper)}


def _box(lower: Sequence[float], upper: Sequence[float]) -> Json:
    return {"lower": list(lower), "upper": list(upper)}


def _rules(task: Task) -> Iterable[Json]:
    """Yield what is to be kept to, in words, and what it costs not to."""
    for demand in task.demands[:MOST]:
        text = f"the program {demand.name}" if demand.keeps in OF_PROGRAMS else wanted(demand)
        if demand.keeps is Keeps.STEPS:
            text = f"the program has at most {demand.limit:g} steps"
        yield _rule(text, demand.name, f"costs {points(demand.points)}")
    if task.proof is not None:
        yield _rule("the program is right in every future", "", "not looked at while live")
    best, longest = f"{task.t_par:g} s", f"{task.t_max:g} s"
    bonus = points(task.mark.time_bonus)
    yield _rule(f"full time bonus up to {best}, over at {longest}", "", f"up to {bonus}")
    yield _rule("nothing is touched or dropped", "", _contacts(task.mark))


def _contacts(mark: MarkScheme) -> str:
    match mark.contacts_by:
        case Contacts.EVENTS:
            first, further = points(mark.first_contact), points(mark.further_contact)
            return f"costs {first}, then {further} each"
        case Contacts.TIME:
            return f"costs {points(mark.per_second)} a second"
        case Contacts.DEPTH:
            return f"costs {points(mark.per_mm)} a millimetre"


def _rule(text: str, name: str, worth: str) -> Json:
    return {"text": capital(one_line(text)), "name": one_line(name), "worth": worth}
