"""Reads `[[zone]]`, `[[upright]]`, `[[limit]]` and `[[rule]]` of a task."""

from fractions import Fraction

from vrts.base.diagnostic import Rule
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import DEG, MM
from vrts.check.rules.scheme import TOTAL
from vrts.check.task.demands import Demand, Keeps, distances_of
from vrts.lang.vocabulary.lookup import look_up
from vrts.robots.model import SphericalWristArm
from vrts.scene.model import Mobility, Scene

DEMAND = Rule("V431", "demand")

FARTHEST = 10_000.0  # [mm]
LIMITS = (
    *("joint_percent", "tool_mm_s", "wrist_deg", "elbow_deg"),
    *("shoulder_mm", "singular_value"),
)
RULES = ("must_use", "must_not_use", "most_steps")


def read_demands(
    top: Table, problems: Problems, scene: Scene, total: Fraction = TOTAL
) -> tuple[Demand, ...]:
    """Return every demand of a task; what is wrong goes to `problems`.

    Args:
        top: The task.
        problems: Told what is wrong.
        scene: In which it is set.
        total: A mark is out of so many points; a demand costs a tenth of them if it does not say.
    """
    found = [_zone(table, problems, n, total) for n, table in enumerate(top.tables("zone"), 1)]
    found += [_upright(table, scene, total) for table in top.tables("upright")]
    found += [_limit(table, problems, scene, total) for table in top.tables("limit")]
    found += [_rule(table, problems, total) for table in top.tables("rule")]
    return tuple(demand for demand in found if demand is not None)


def _points(table: Table, total: Fraction) -> Fraction:
    return table.fraction("points", total / 10, minimum=0, maximum=float(total))


def _zone(table: Table, problems: Problems, number: int, total: Fraction) -> Demand | None:
    name = table.string("name", f"zone {number}")
    wanted = {"count": 3, "minimum": -FARTHEST, "maximum": FARTHEST, "required": True}
    low = table.numbers("from_mm", **wanted)  # type: ignore[arg-type]
    high = table.numbers("to_mm", **wanted)  # type: ignore[arg-type]
    keeps = table.string("keeps_out", "tool", choices=("tool", "robot"))
    points = _points(table, total)
    table.finish()
    if low is None or high is None:
        return None
    if any(a >= b for a, b in zip(low, high, strict=True)):
        problems.error(
            DEMAND,
            f"the zone `{name}` is empty",
            table.value_span("to_mm"),
            help=("every number of `to_mm` must be more than that of `from_mm`",),
        )
        return None
    what = Keeps.ROBOT_OUT if keeps == "robot" else Keeps.TOOL_OUT
    a, b, c = (value * MM for value in low)
    d, e, f = (value * MM for value in high)
    return Demand(what, name, points, table.span, lower=(a, b, c), upper=(d, e, f))


def _upright(table: Table, scene: Scene, total: Fraction) -> Demand | None:
    movable = [b.name for b in scene.bodies if b.mobility is Mobility.MOVABLE]
    body = table.string("object", choices=movable, required=True)
    angle = table.number("within_deg", 5.0, above=0.0, maximum=180.0)
    points = _points(table, total)
    table.finish()
    if body is None:
        return None
    name = f"{body} upright"
    return Demand(Keeps.UPRIGHT, name, points, table.span, angle * DEG, body=body)


def _limit(table: Table, problems: Problems, scene: Scene, total: Fraction) -> Demand | None:
    percent = table.number("joint_percent", above=0.0, maximum=100.0)
    speed = table.number("tool_mm_s", above=0.0, maximum=FARTHEST)
    wrist = table.number("wrist_deg", above=0.0, maximum=90.0)
    elbow = table.number("elbow_deg", above=0.0, maximum=90.0)
    shoulder = table.number("shoulder_mm", above=0.0, maximum=FARTHEST)
    singular = table.number("singular_value", above=0.0, maximum=1.0)
    points = _points(table, total)
    table.finish()
    if not _one_of(table, problems, LIMITS):
        return None
    given = (
        (Keeps.JOINT_SPEED, percent, 0.01),
        (Keeps.TOOL_SPEED, speed, MM),
        (Keeps.WRIST, wrist, DEG),
        (Keeps.ELBOW, elbow, DEG),
        (Keeps.SHOULDER, shoulder, MM),
        (Keeps.SINGULAR, singular, 1.0),
    )
    for keeps, value, unit in given:
        if value is None:
            continue
        if not _of_arm(keeps, scene, table, problems):
            return None
        return Demand(keeps, keeps.value, points, table.span, value * unit)
    return None


def _of_arm(keeps: Keeps, scene: Scene, table: Table, problems: Problems) -> bool:
    """Return whether an arm has the singularity that a limit is about."""
    if keeps in (Keeps.JOINT_SPEED, Keeps.TOOL_SPEED):
        return True
    if keeps in distances_of(scene.robot.arm):
        return True
    if isinstance(scene.robot.arm, SphericalWristArm):
        headline = "arms of the PUMA family have singularities of wrist, elbow and shoulder"
        remedy = "write `wrist_deg`, `elbow_deg` or `shoulder_mm`"
    else:
        headline = "only arms of the PUMA family have singularities of wrist, elbow and shoulder"
        remedy = "write `singular_value`, the smallest of the Jacobian"
    problems.error(DEMAND, headline, table.span, help=(remedy,))
    return False


def _rule(table: Table, problems: Problems, total: Fraction) -> Demand | None:
    use, avoid = table.string("must_use"), table.string("must_not_use")
    steps = table.integer("most_steps", minimum=1, maximum=65_000)
    points = _points(table, total)
    table.finish()
    if not _one_of(table, problems, RULES):
        return None
    if steps is not None:
        return Demand(Keeps.STEPS, "number of steps", points, table.span, float(steps))
    given = use or avoid
    if given is None:
        return None
    word = look_up(given).word
    if word is None:
        problems.error(
            DEMAND,
            f"there is no instruction `{given}`",
            table.value_span("must_use" if use else "must_not_use"),
        )
        return None
    keeps = Keeps.USES if use else Keeps.AVOIDS
    return Demand(keeps, f"{keeps.value} {word.text}", points, table.span, word=word.text)


def _one_of(table: Table, problems: Problems, keys: tuple[str, ...]) -> bool:
    if sum(key in table for key in keys) == 1:
        return True
    problems.error(DEMAND, f"{table.title} needs exactly one of {', '.join(keys)}", table.span)
    return False
