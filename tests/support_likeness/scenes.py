"""What the tasks ask for: places, goals, and what any student finds in the text."""

from pathlib import Path
from typing import NamedTuple

from tests.places import ROOT
from tests.support_likeness.students.program import Values

DOWN = (90.0, 90.0, 0.0)  # the hand points down, and its fingers close along Y


class Place(NamedTuple):
    """Where the hand has to be for something."""

    key: str  # thing and use: `can1.grip`
    given: str  # name in the task's text; empty: everybody has to find it
    values: Values
    slack_mm: float  # by how much it may be off without harm
    turns: bool = False  # whether the hand may be turned about the vertical
    lifts: bool = False  # whether the hand may hold higher or lower
    made: str = ""  # how it may be computed from places of the text, with their names


class Goal(NamedTuple):
    """A thing that goes somewhere."""

    part: str
    grip: str
    put: str
    rise_mm: tuple[int, int]  # how far up it has to be, and can be
    above_mm: tuple[int, int] = (60, 150)  # heights from which one goes down
    ways: tuple[tuple[str, bool], ...] = ()  # places on the way; true: to stop there
    lands: bool = False  # the last way lies above the place: there is nothing to approach
    is_straight: bool = False  # ways on straight lines only, and low


class Job(NamedTuple):
    """A task as its students see it."""

    name: str
    task: str  # folder below the repository
    places: tuple[Place, ...]
    goals: tuple[Goal, ...]
    safe: Values
    wants_safe: bool = False  # between the two sides one goes over `safe`
    signal: bool = False  # an output is asked for
    frames: tuple[tuple[str, Values], ...] = ()  # of the text, to compute with

    def place(self, key: str) -> Place:
        """Return the place of a key."""
        return next(one for one in self.places if one.key == key)


def _at(x: float, y: float, z: float, turn: tuple[float, float, float] = DOWN) -> Values:
    return (x, y, z, *turn)


def _can(n: int, x: float, y: float, z: float = -225) -> Place:
    return Place(f"can{n}.grip", f"can{n}_grip", _at(x, y, z), 0.9, turns=True, lifts=True)


def _base(n: int, x: float, y: float, z: float) -> Place:
    return Place(f"base{n}.put", f"base{n}_put", _at(x, y, z), 2.5, turns=True, lifts=True)


def _dish(grip: Values, mid: Values, put: Values) -> tuple[tuple[Place, ...], Goal]:
    places = (
        Place("dish.grip", "dish_grip", grip, 0.6),
        Place("stand.put", "", put, 0.6, made="stand_mid:rim"),
    )
    return places, Goal("dish", "dish.grip", "stand.put", (180, 280), (100, 160))


CANS = Job(
    "cans",
    "examples/01-cans-on-bases",
    (
        _can(1, 800, -450),
        _can(2, 750, 450),
        _base(1, 950, -130, -75),
        _base(2, 1100, 230, -125),
    ),
    (
        Goal("can1", "can1.grip", "base2.put", (180, 320)),
        Goal("can2", "can2.grip", "base1.put", (180, 320)),
    ),
    _at(900, 30, 100),
)
LEANING = (90.0, 70.0, 0.0)
RIM = ("rim", (0.0, 103.0, 18.0, 90.0, -90.0, 0.0))
_SMALL = _dish(
    _at(850, -227, -268), _at(962.9, 330, -133.02, LEANING), _at(969.06, 433, -149.93, LEANING)
)
DISH = Job(
    "dish",
    "examples/02-dish-on-stand",
    _SMALL[0],
    (_SMALL[1],),
    _at(920, 0, 140),
    frames=(("stand_mid", _at(962.9, 330, -133.02, LEANING)), RIM),
)
WALLS = Job(
    "walls",
    "examples/03-around-obstacles",
    (
        Place("can1.grip", "can1_grip", _at(850, -430, -225), 0.9, lifts=True),
        Place("base1.put", "base1_put", _at(950, 430, -165), 2.5, lifts=True),
        Place("corner1.way", "", _at(1150, -430, -180), 12.0),
        Place("gap1.way", "", _at(1150, -220, -180), 3.0),
        Place("corner2.way", "", _at(1150, 105, -180), 8.0),
        Place("corner3.way", "", _at(800, 105, -180), 8.0),
        Place("gap2.way", "", _at(800, 230, -180), 3.0),
    ),
    (
        Goal(
            "can1",
            "can1.grip",
            "base1.put",
            (50, 75),
            (35, 60),
            (
                ("corner1.way", False),
                ("gap1.way", True),
                ("corner2.way", False),
                ("corner3.way", False),
                ("gap2.way", True),
            ),
            is_straight=True,
        ),
    ),
    _at(950, 0, 320),
)
_LARGE = _dish(
    _at(730, 163, -268), _at(1042.9, 480, -133.02, LEANING), _at(1049.06, 583, -149.93, LEANING)
)
HELD = (90.0, 60.0, 0.0)
PROJECT = Job(
    "project",
    "examples/04-final-project",
    (
        _can(1, 720, -610),
        _can(2, 880, -610),
        _can(3, 1040, -610),
        _base(1, 690, 300, -185),
        _base(2, 690, 450, -145),
        _base(3, 690, 600, -105),
        *_LARGE[0],
        Place("pizza.grip", "pizza_grip", _at(906.16, -286.73, -268, (70, 60, 0)), 0.8),
        Place(
            "oven.put", "", _at(1125, 30, -188, HELD), 1.5, made="stone:INVERSE(pizza):{pizza.grip}"
        ),
        Place("in.way", "", _at(1125, 30, -168, HELD), 2.0, made="SHIFT({oven.put} BY 0,0,20)"),
        Place("door.way", "", _at(820, 30, -168, HELD), 4.0, made="SHIFT({in.way} BY -305,0,0)"),
    ),
    (
        *(Goal(f"can{n}", f"can{n}.grip", f"base{n}.put", (60, 200), (70, 130)) for n in (1, 2, 3)),
        _LARGE[1],
        Goal(
            "pizza",
            "pizza.grip",
            "oven.put",
            (120, 160),
            (70, 100),
            (("door.way", True), ("in.way", False)),
            lands=True,
        ),
    ),
    _at(860, -20, 160),
    wants_safe=True,
    signal=True,
    frames=(
        ("stand_mid", _at(1042.9, 480, -133.02, LEANING)),
        RIM,
        ("pizza", _at(1080, -350, -300, (70, -90, 0))),
        ("stone", _at(1310, 30, -220, (90, -90, 0))),
    ),
)
PALLET = Job(
    "pallet",
    "tests/data/likeness/pallet",
    (
        *(_can(n, 700 + 130 * n, -480) for n in (1, 2)),
        *(_can(n, 700 + 130 * (n - 2), -310) for n in (3, 4)),
        *(_base(n, 780 + 160 * (n - 1), 260, -165) for n in (1, 2)),
        *(_base(n, 780 + 160 * (n - 3), 460, -125) for n in (3, 4)),
    ),
    tuple(
        Goal(f"can{n}", f"can{n}.grip", f"base{n}.put", (150, 260), (70, 150)) for n in (1, 2, 3, 4)
    ),
    _at(880, -40, 140),
)
JOBS = {job.name: job for job in (CANS, DISH, WALLS, PROJECT, PALLET)}


def folder(job: Job) -> Path:
    """Return the folder of a job's task."""
    return ROOT / job.task
