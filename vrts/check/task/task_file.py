"""Reads `task.toml`: goals, via points, times and weights, in millimetres and degrees."""

import hashlib
import re
from fractions import Fraction

from vrts.base.diagnostic import Diagnostic, Rule
from vrts.base.oat import pose_from_components
from vrts.base.pose import Pose
from vrts.base.source import SourceFile
from vrts.base.toml.reading import Problems, Table, read_toml
from vrts.base.units import DEG, MM, mm
from vrts.check.task.demand_file import read_demands
from vrts.check.task.late_file import read_keep, read_late
from vrts.check.task.task import Goal, MarkScheme, Task
from vrts.check.task.via_file import read_via
from vrts.geometry.support import bounds
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.things.seat import seat

NOT_MOVABLE = Rule("V651", "not-movable")
GOAL_PLACE = Rule("V652", "goal-place")
GOAL_TWICE = Rule("V653", "goal-twice")
TIMES = Rule("V654", "times")
TOO_MANY_POINTS = Rule("V655", "too-many-points")

POSITION_MM, ORIENTATION_DEG = 10.0, 5.0  # tolerances of a goal when the file gives none
PAR_SHARE = Fraction(5, 4)  # t_par is this times the reference solution
FULL = 10  # points
MAX_SHARE = 2  # t_max is this times t_par
NEAR_MISS_MM = 1.0, 50.0  # least and most of `near_miss_mm`
FARTHEST = 10_000.0  # [mm] any position


def read_task(source: SourceFile, scene: Scene) -> tuple[Task | None, tuple[Diagnostic, ...]]:
    """Return the task a file describes, or None, with everything there is to say about it."""
    top, problems = read_toml(source)
    task = None if top is None else _task(top, problems, source, scene)
    if problems.any_error:
        task = None
    return task, problems.in_order()


def _task(top: Table, problems: Problems, source: SourceFile, scene: Scene) -> Task | None:
    section = top.table("task", required=True)
    if section is None:
        return None
    folder = [part for part in re.split(r"[/\\]", source.name) if part]
    name = folder[-2] if len(folder) > 1 else "task"
    title = section.string("title", name)
    scene_name = section.string("scene", required=True) or ""
    section.string("lab")  # for `task_places`
    program = section.string("program")
    ordered = section.boolean("ordered", default=False)
    section.finish()
    goals = _goals(top, problems, scene)
    vias = tuple(read_via(t, problems, number) for number, t in enumerate(top.tables("via"), 1))
    demands = read_demands(top, problems, scene)
    t_par, t_max = _times(top, problems)
    mark = _mark(top, problems)
    near_miss = _near_miss(top)
    late, keep = read_late(top, problems), read_keep(top)
    top.finish()
    return Task(
        name,
        title,
        scene_name,
        program.lower() if program else None,
        goals,
        vias,
        ordered,
        t_par,
        t_max,
        mark,
        hashlib.sha256(source.text.encode()).hexdigest(),
        demands,
        near_miss,
        late,
        keep,
    )


def _goals(top: Table, problems: Problems, scene: Scene) -> tuple[Goal, ...]:
    goals: list[Goal] = []
    for table in top.tables("goal", required=True):
        goal = _goal(table, problems, scene)
        if goal is None:
            continue
        if any(goal.body == other.body for other in goals):
            problems.error(
                GOAL_TWICE, f"`{goal.body}` has two goals", table.value_span("object"), "again here"
            )
        goals.append(goal)
    return tuple(goals)


def _goal(table: Table, problems: Problems, scene: Scene) -> Goal | None:
    movable = [b.name for b in scene.bodies if b.mobility is Mobility.MOVABLE]
    everything = [body.name for body in scene.bodies]
    name = table.string("object", choices=everything, required=True)
    on = table.string("on", choices=everything)
    at = table.numbers("at_mm", count=(2, 3), minimum=-FARTHEST, maximum=FARTHEST)
    turn = table.number("turn_deg", 0.0)
    position = table.number("position_mm", POSITION_MM, above=0.0, maximum=FARTHEST)
    orientation = table.number("orientation_deg", ORIENTATION_DEG, above=0.0, maximum=60.0)
    weight = table.fraction("weight", Fraction(1), minimum=0.001)
    title = table.string("title", f"{name} on {on}" if on else f"{name} in place")
    table.finish()
    if name is None:
        return None
    if name not in movable:
        problems.error(
            NOT_MOVABLE,
            f"`{name}` cannot be carried, so it can have no goal",
            table.value_span("object"),
            help=(f"objects that can be carried: {', '.join(movable)}",),
        )
        return None
    if on == name:
        problems.error(GOAL_PLACE, f"`{name}` cannot stand on itself", table.value_span("on"))
        return None
    if on is None and (at is None or len(at) < 3):
        problems.error(
            GOAL_PLACE,
            f"the goal of `{name}` says neither what it stands on nor where",
            table.span,
            help=('add `on = "base1"`, or `at_mm = [x, y, z]` of the middle of its underside',),
        )
        return None
    X_WG = _goal_pose(scene.body(name), scene.body(on) if on else None, at, turn)
    return Goal(name, X_WG, position * MM, orientation * DEG, weight, title, table.span)


def _goal_pose(body: Body, support: Body | None, at: tuple[float, ...] | None, turn: float) -> Pose:
    """Return X_WG: its underside on the support's seat or upper side, or at the given height."""
    upright = pose_from_components(0.0, 0.0, 0.0, 90.0 + turn, -90.0, 0.0)
    underside = bounds(body.pieces, upright).lower[2]
    X_WS = None if support is None or at is not None else seat(support)
    if X_WS is not None:
        return X_WS @ Pose(upright.rotation, (0.0, 0.0, -underside))
    if support is None:
        assert at is not None
        x, y, z = at[0] * MM, at[1] * MM, at[2] * MM
    else:
        box = bounds(support.pieces, support.X_WO)
        x, y, z = support.X_WO.translation[0], support.X_WO.translation[1], box.upper[2]
        if at is not None:
            x, y = at[0] * MM, at[1] * MM
    return Pose(upright.rotation, (x, y, z - underside))


def _times(top: Table, problems: Problems) -> tuple[float, float]:
    section = top.table("time", required=True)
    if section is None:
        return 0.0, 0.0
    reference = section.fraction("reference_s", minimum=0.001, maximum=3600)
    par = section.fraction("t_par_s", minimum=0.001, maximum=3600)
    longest = section.fraction("t_max_s", minimum=0.001, maximum=7200)
    given = (("reference_s", reference), ("t_par_s", par), ("t_max_s", longest))
    section.finish()
    if any(key in section and found is None for key, found in given):
        return 0.0, 0.0  # said already
    if par is None and reference is not None:
        par = PAR_SHARE * reference
    if par is None:
        problems.error(
            TIMES,
            "the task does not say how long a good solution takes",
            section.span,
            help=("add `reference_s`, the duration of the reference solution in seconds",),
        )
        return 0.0, 0.0
    longest = MAX_SHARE * par if longest is None else longest
    if longest <= par:
        problems.error(
            TIMES,
            f"`t_max_s` must be more than {float(par):g} s, the time of a good solution",
            section.value_span("t_max_s"),
        )
    return float(par), float(longest)


def _near_miss(top: Table) -> float | None:
    section = top.table("collision")
    if section is None:
        return None
    least, most = NEAR_MISS_MM
    distance = section.number("near_miss_mm", minimum=least, maximum=most)
    section.finish()
    return None if distance is None else distance * MM


def _mark(top: Table, problems: Problems) -> MarkScheme:
    section = top.table("mark")
    usual = MarkScheme()
    if section is None:
        return usual
    found = MarkScheme(
        section.fraction("targets", usual.targets, minimum=0, maximum=10),
        section.fraction("vias", usual.vias, minimum=0, maximum=10),
        section.fraction("first_contact", usual.first_contact, minimum=0, maximum=10),
        section.fraction("further_contact", usual.further_contact, minimum=0, maximum=10),
        section.fraction("contact_cap", usual.contact_cap, minimum=0, maximum=10),
        section.fraction("time_bonus", usual.time_bonus, minimum=0, maximum=10),
        section.fraction("zero_at", usual.zero_at, minimum=1.01, maximum=100),
    )
    section.finish()
    most = found.targets + found.vias + found.time_bonus
    if most > FULL:
        problems.error(
            TOO_MANY_POINTS,
            f"the parts of the mark add up to {float(most):g}, more than 10",
            section.span,
            help=("targets + vias + time_bonus may be 10 at most",),
        )
    return found


def describe_goal(goal: Goal) -> str:
    """Return where a goal is, in words."""
    x, y, z = goal.X_WG.translation
    return f"{goal.title} at X {mm(x):.0f} Y {mm(y):.0f} Z {mm(z):.0f} mm"
