"""What goes wrong in programs of people who learn."""

import re
from random import Random

from tests.support_likeness.scenes import Job
from tests.support_likeness.students.program import Program, Values

BREAKS = (  # what is written, and what should have been something else
    (r"(\w)\s*,\s*(\d+)", r"\1 \2"),  # no comma
    (r"(?mi)^\.END$", ""),
    (r"(?i)OPENI", "OPENGRIPPER"),
    (r"(?i)\bMOVES\b", "MOVEL"),
    (r"(?i)\bMOVE\b", "// now\n MOVE"),
)
SKILLS = {"good": 56, "slips": 27, "weak": 13, "breaks": 4}  # of a hundred


def skill(draw: Random) -> str:
    """Return how well somebody does."""
    return draw.choices(tuple(SKILLS), tuple(SKILLS.values()))[0]


def slip(program: Program, job: Job, level: str, draw: Random) -> None:
    """Make the mistakes of a level in a program."""
    kinds = (value_off, no_open, too_low, half_height, swapped, unfinished, hurried, doubled)
    count = {"good": 0, "breaks": 0, "slips": 1, "weak": 3}[level]
    for kind in draw.sample(kinds, count):
        kind(program, job, draw)


def value_off(program: Program, job: Job, draw: Random) -> None:
    """Teach one place wrong."""
    del job
    _off(program, draw, (8, 12, 15, 18, 25, 40))


def half_height(program: Program, job: Job, draw: Random) -> None:
    """Take a height wrong."""
    del job
    name = draw.choice(list(program.places) or [""])
    if name:
        x, y, z, o, a, t = program.places[name]
        program.places[name] = (x, y, z + draw.choice((-30, -20, 20, 35, 60)), o, a, t)


def _off(program: Program, draw: Random, by: tuple[int, ...]) -> None:
    if not program.places:
        return
    name = draw.choice(list(program.places))
    values = list(program.places[name])
    values[draw.randrange(2)] += draw.choice(by) * draw.choice((-1, 1))
    x, y, z, o, a, t = values
    program.places[name] = (x, y, z, o, a, t)


def no_open(program: Program, job: Job, draw: Random) -> None:
    """Forget to open the hand once."""
    del job
    _without(program, draw, ("OPENI", "OPEN"))


def too_low(program: Program, job: Job, draw: Random) -> None:
    """Lift a thing not high enough."""
    del job
    ups = [line for line in program.lines() if line.word in ("DEPARTS", "DEPART")]
    if ups:
        draw.choice(ups).args = [draw.choice(("20", "30", "40", "50"))]


def swapped(program: Program, job: Job, draw: Random) -> None:
    """Change X and Y of a place, or two goals."""
    del job
    if program.places:
        name = draw.choice(list(program.places))
        x, y, *rest = program.places[name]
        values: Values = (y, x, rest[0], rest[1], rest[2], rest[3])
        program.places[name] = values


def unfinished(program: Program, job: Job, draw: Random) -> None:
    """Leave the last goal out."""
    parts = [goal.part for goal in job.goals]
    part = draw.choice(parts)
    main = program.main
    if len({line.part for line in main.body} - {""}) > 1:
        main.body = [line for line in main.body if line.part != part]


def hurried(program: Program, job: Job, draw: Random) -> None:
    """Leave a way over the safe place out."""
    del job
    _without(program, draw, ("MOVE",))


def doubled(program: Program, job: Job, draw: Random) -> None:
    """Go so slowly that it costs points."""
    del job
    for line in program.lines():
        if line.word == "SPEED" and "ALWAYS" in line.args:
            line.args = [draw.choice(("10", "15", "20", "25")), "ALWAYS"]
            return


def _without(program: Program, draw: Random, words: tuple[str, ...]) -> None:
    """Take one line out."""
    places = [
        (block, line)
        for block in program.blocks()
        for line in block
        if line.word in words and not line.label
    ]
    if places:
        block, line = draw.choice(places)
        block.remove(line)


def broken(text: str, draw: Random) -> str:
    """Return a text that does not compile."""
    pattern, instead = draw.choice(BREAKS)
    return re.sub(pattern, instead, text, count=1)
