"""Runs whose motions and times are written down, to be had again under the same controller model.

`tests/data/controller` holds what vrts made of these programs before controllers had models.
"""

import random
from collections.abc import Iterator
from typing import NamedTuple

import msgspec

from tests.places import ROOT
from tests.support_programs import compiled
from vrts.base.units import deg
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.scene.model import Limits, Scenario, Scene

FOLDER = ROOT / "tests" / "data" / "controller"
PROGRAMS = 120  # random ones
SAMPLES = 12  # instants at which the joints are written down
REFUSED = ("random 69",)  # a line whose end is out of reach: it is refused before it starts now
SHORT = Limits(statements=3000, time_s=120.0)
SCENARIO = Scenario(
    inputs=((1.0, 1001, True), (2.0, 1001, False), (3.5, 1001, True)),
    answers=("1", "2"),
    limits=SHORT,
)
PLACES = (
    ".LOCATIONS\na 900 200 100 90 90 0\nb 900 -200 100 90 90 0\nc 900 0 300 90 90 0\n"
    "d 700 300 250 60 75 20\n.END\n.LOCATIONS\n.END\n"
)
STEPS = """
MOVE a | MOVES b | MOVE c | MOVES d | MOVES a | MOVE #up | APPRO a, 50 | APPROS b, -20 | DEPART 30
DEPARTS 10 | DRIVE 1, 10 | DRIVE 3, -20, 40 | DRAW 10, 20 | ALIGN | READY | DELAY 0.1 | DELAY 0.5
BREAK | BRAKE | SPEED 30 | SPEED 70 ALWAYS | SPEED 300 MMPS | SPEED 250 | COARSE | COARSE ALWAYS
NONULL | NONULL ALWAYS | FINE ALWAYS | RIGHTY | LEFTY | FLIP | NOFLIP | ABOVE | BELOW | OPENI
CLOSE | OPEN | CLOSEI | RELAX | RELAXI | MOVET b, 10 | MOVEST c, 0 | TOOL TRANS(0,0,50,90,-90,0)
TOOL NULL | SIGNAL 1, -2 | WAIT | WAIT SIG(1001) | ENABLE CP | DISABLE CP | DURATION 1
ACCEL 50, 25 | PULSE 3 | SPEED 100, 20 | SPEED 40 MONITOR | MOVE p | MOVES p:RY(-30)
MOVES p:RX(40):RZ(50) | SET p = HERE | SET p = DEST | n = n+1 | TYPE n | WAIT TIMER(1) > 0.3
TIMER 1 = 0 | SPEED 60 ALWAYS | MOVE a | MOVES b | MOVES c | MOVE d | BREAK | SIGNAL 4
"""


class Case(NamedTuple):
    """A program by a name, and the robot that executes it."""

    name: str
    robot: str
    text: str


def cases() -> Iterator[Case]:
    """Yield the random programs; the same ones every time."""
    draw = random.Random(16)
    steps = [step.strip() for line in STEPS.strip().splitlines() for step in line.split("|")]
    for number in range(PROGRAMS):
        body = ["SET p = c", "SET #up = #PPOINT(10, -80, 100, 5, 20, 0)", "TIMER 1 = 0", "n = 0"]
        body += ["MOVE a"] if number % 3 else []
        body += [draw.choice(steps) for _ in range(draw.randint(6, 22))]
        robot = "puma560" if number % 10 == 9 else "puma761"
        text = ".PROGRAM main\n" + "\n".join(body) + "\n.END\n" + PLACES
        if f"random {number}" not in REFUSED:
            yield Case(f"random {number}", robot, text)


def run_of(case: Case, scene: Scene) -> Run:
    """Run a case in a scene of its robot alone."""
    return execute(compiled(case.text, "val2+"), scene, SCENARIO)


class Written(msgspec.Struct):
    """What is written down of a run: times in 0.1 ms, angles in 0.0001 degrees."""

    horizon: int
    statements: int
    ending: str
    motions: list[tuple[int, int]]
    events: list[tuple[int, str]]
    joints: list[list[int]]  # at equal distances of time

    @property
    def numbers(self) -> list[int]:
        """Every number of it that rounding may move by one."""
        times = [self.horizon, *(time for pair in self.motions for time in pair)]
        return [
            *times,
            *(time for time, _ in self.events),
            *(q for row in self.joints for q in row),
        ]


def written(run: Run) -> Written:
    """Return what is written down of a run."""
    horizon = run.horizon_s
    return Written(
        round(1e4 * horizon),
        run.statements,
        run.ending.value,
        [(round(1e4 * m.start_s), round(1e4 * m.end_s)) for m in run.motions],
        [(round(1e4 * e.time_s), type(e).__name__) for e in run.events],
        [
            [round(1e4 * deg(q)) for q in run.at(horizon * k / SAMPLES).configuration]
            for k in range(SAMPLES)
        ],
    )


def kept() -> dict[str, Written]:
    """Return what was written down, by the name of a case or the path of an example."""
    return msgspec.json.decode((FOLDER / "runs.json").read_bytes(), type=dict[str, Written])


def same(found: Written, before: Written) -> bool:
    """Return whether two are the same but for rounding, findings, and order in one instant."""
    for one in (found, before):
        one.events = sorted(event for event in one.events if event[1] != "Found")
    words = (
        [name for _, name in w.events] + [w.ending, str(w.statements)] for w in (found, before)
    )
    pairs = zip(found.numbers, before.numbers, strict=False)
    return (
        len({tuple(said) for said in words}) == 1
        and len(found.numbers) == len(before.numbers)
        and all(abs(a - b) <= 1 for a, b in pairs)
    )
