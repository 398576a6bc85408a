"""Reads `[[goal]]` of a task: which object is to end where, in millimetres and degrees."""

from collections.abc import Sequence
from fractions import Fraction
from typing import NamedTuple

from vrts.base.diagnostic import Rule
from vrts.base.oat import pose_from_components
from vrts.base.pose import Pose
from vrts.base.toml.reading import Problems, Table
from vrts.base.units import DEG, MM
from vrts.check.task.goals import Choice, Goal, Looks, Phases
from vrts.geometry.support import bounds
from vrts.scene.model import Body, Mobility, Scene
from vrts.scene.things.seat import seat

NOT_MOVABLE = Rule("V651", "not-movable")
GOAL_PLACE = Rule("V652", "goal-place")
GOAL_TWICE = Rule("V653", "goal-twice")
PHASES = Rule("V658", "goal-phases")

POSITION_MM, ORIENTATION_DEG = 10.0, 5.0  # tolerances of a goal when the file gives none
LIFTED_MM = 50.0  # how high is lifted when the file does not say
FARTHEST = 10_000.0  # [mm] any position
MOST_CHOICES = 24  # objects, or places, of one `[[goal]]`
WIDEST_DEG = 60.0  # an orientation tolerance


class _Spot(NamedTuple):
    """A place as the file has it."""

    on: str | None
    at: tuple[float, ...] | None  # [mm]
    turn: float  # [degrees]

    @property
    def where(self) -> str:
        """In words: "on base1", "at X 850 Y 0"."""
        support = f"on {self.on}" if self.on else ""
        if self.at is None:
            return support
        x, y = self.at[:2]
        return f"{support} at X {x:g} Y {y:g}".strip()


class _Terms(NamedTuple):
    """What all goals of one `[[goal]]` have in common."""

    position: float  # [mm]
    orientation: float  # [degrees]
    weight: Fraction
    looks: Looks
    phases: Phases


def read_goals(top: Table, problems: Problems, scene: Scene) -> tuple[Goal, ...]:
    """Return every goal of a task; what is wrong goes to `problems`."""
    goals: list[Goal] = []
    for group, table in enumerate(top.tables("goal")):
        found = _goals(table, problems, scene, group)
        taken = {name for goal in goals for name in goal.bodies}
        again = [name for goal in found for name in goal.bodies if name in taken]
        if again:
            problems.error(
                GOAL_TWICE, f"`{again[0]}` has two goals", table.value_span("object"), "again here"
            )
        goals += found
    return tuple(goals)


def carried(table: Table, problems: Problems, scene: Scene, names: Sequence[str]) -> bool:
    """Return whether all objects of a goal can be carried."""
    movable = [b.name for b in scene.bodies if b.mobility is Mobility.MOVABLE]
    for name in names:
        if name not in movable:
            problems.error(
                NOT_MOVABLE,
                f"`{name}` cannot be carried, so it can have no goal",
                table.value_span("object"),
                help=(f"objects that can be carried: {', '.join(movable)}",),
            )
            return False
    return True


def _goals(table: Table, problems: Problems, scene: Scene, group: int) -> tuple[Goal, ...]:
    everything = [body.name for body in scene.bodies]
    names = table.names("object", choices=everything, required=True)
    spots = _spots(table, problems, names, everything)
    terms = _Terms(
        table.number("position_mm", POSITION_MM, above=0.0, maximum=FARTHEST),
        table.number("orientation_deg", ORIENTATION_DEG, above=0.0, maximum=WIDEST_DEG),
        table.fraction("weight", Fraction(1), minimum=0.001),
        Looks(table.string("symmetry", Looks.SHAPE.value, choices=[look.value for look in Looks])),
        _phases(table, problems),
    )
    title = table.string("title")
    table.finish()
    if not names or not carried(table, problems, scene, names) or spots is None:
        return ()
    if max(len(names), len(spots)) > MOST_CHOICES:
        headline = f"one goal can have {MOST_CHOICES} objects and places at most"
        problems.error(GOAL_PLACE, headline, table.span, help=("write several goals",))
        return ()
    choices = [
        [Choice(name, n, _pose(scene, name, spot), spot.where) for n, spot in enumerate(spots)]
        for name in names
    ]
    if len(names) > len(spots):  # a goal for every place, else one for every object
        choices = [[row[n] for row in choices] for n in range(len(spots))]
    shared = group if min(len(names), len(spots)) > 1 else None
    return tuple(_goal(row, title, terms, table, shared, len(choices)) for row in choices)


def _goal(
    row: Sequence[Choice],
    title: str | None,
    terms: _Terms,
    table: Table,
    group: int | None,
    count: int,
) -> Goal:
    first = row[0]
    if title is None:
        words = _words(row)
    elif count == 1:
        words = title
    else:
        words = f"{title}: {first.body if first.body == row[-1].body else first.where}"
    return Goal(
        first.body,
        first.X_WG,
        terms.position * MM,
        terms.orientation * DEG,
        terms.weight,
        words,
        table.span,
        terms.looks,
        terms.phases,
        tuple(row) if len(row) > 1 else (),
        group,
    )


def _words(row: Sequence[Choice]) -> str:
    """Return what a goal is called: "can1 on base1 or base2"."""
    bodies = tuple(dict.fromkeys(choice.body for choice in row))
    places = tuple(dict.fromkeys(choice.where for choice in row))
    if len(places) == 1:
        at, _, coordinates = places[0].rpartition("at X ")
        places = (at.strip() or "in place",) if coordinates and at else places
        places = ("in place",) if places[0].startswith("at ") else places
    elif all(place.startswith("on ") for place in places):
        places = (places[0], *(place.removeprefix("on ") for place in places[1:]))
    return f"{' or '.join(bodies)} {' or '.join(places)}"


def _phases(table: Table, problems: Problems) -> Phases:
    gripped = table.fraction("gripped", Fraction(0), minimum=0, maximum=1)
    lifted = table.fraction("lifted", Fraction(0), minimum=0, maximum=1)
    height = table.number("lifted_mm", LIFTED_MM, above=0.0, maximum=FARTHEST)
    if gripped + lifted >= 1:
        problems.error(
            PHASES,
            "nothing is left for being in place",
            table.span_of("lifted" if lifted else "gripped"),
            help=("`gripped` and `lifted` are shares of the goal's points: less than 1 together",),
        )
    if "lifted_mm" in table and not lifted:
        problems.error(
            PHASES,
            "the goal says how high, but gives nothing for being lifted",
            table.span_of("lifted_mm"),
            help=("add `lifted = 0.2`, the share of its points for that",),
        )
    return Phases(gripped, lifted, height * MM)


def _spots(
    table: Table, problems: Problems, names: Sequence[str], everything: Sequence[str]
) -> tuple[_Spot, ...] | None:
    """Return the places of a goal; None after saying what is wrong with them."""
    before = len(problems.found)
    alternatives = table.tables("place")
    if alternatives:
        if any(key in table for key in ("on", "at_mm", "turn_deg")):
            problems.error(
                GOAL_PLACE,
                "the goal has a place and `[[goal.place]]`",
                table.span,
                help=("write every place as `[[goal.place]]`",),
            )
        table.names("on", choices=everything)
        table.numbers("at_mm")
        table.number("turn_deg")
    found = [
        spot for one in alternatives or (table,) for spot in _of(one, problems, names, everything)
    ]
    for one in alternatives:
        one.finish()
    return tuple(found) if len(problems.found) == before else None


def _of(
    table: Table, problems: Problems, names: Sequence[str], everything: Sequence[str]
) -> tuple[_Spot, ...]:
    on = table.names("on", choices=everything)
    at = table.numbers("at_mm", count=(2, 3), minimum=-FARTHEST, maximum=FARTHEST)
    turn = table.number("turn_deg", 0.0)
    itself = next((name for name in on if name in names), None)
    who = f"`{names[0]}`" if len(names) == 1 else "the objects"
    if itself is not None:
        problems.error(GOAL_PLACE, f"`{itself}` cannot stand on itself", table.value_span("on"))
    elif len(on) > 1 and at is not None:
        problems.error(
            GOAL_PLACE,
            "several supports have one `at_mm`",
            table.value_span("at_mm"),
            help=("leave out `at_mm`, or write every place as `[[goal.place]]`",),
        )
    elif not on and "on" not in table and (at is None or len(at) < 3):
        problems.error(
            GOAL_PLACE,
            f"the goal of {who} says neither what it stands on nor where",
            table.span,
            help=('add `on = "base1"`, or `at_mm = [x, y, z]` of the middle of its underside',),
        )
    return tuple(_Spot(name, at, turn) for name in on) or (_Spot(None, at, turn),)


def _pose(scene: Scene, name: str, spot: _Spot) -> Pose:
    """Return X_WG: its underside on the support's seat or upper side, or at the given height."""
    body = scene.body(name)
    return _goal_pose(body, scene.body(spot.on) if spot.on else None, spot.at, spot.turn)


def _goal_pose(body: Body, support: Body | None, at: tuple[float, ...] | None, turn: float) -> Pose:
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
