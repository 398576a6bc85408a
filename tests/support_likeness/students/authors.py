"""Who writes: habits of people who have never met, drawn from a seed."""

from dataclasses import dataclass, replace
from random import Random

from tests.support_likeness.students.tongues import ENGLISH, SHARES, TONGUES, Tongue

SHAPES = {  # how a program is cut up, and how many of a hundred do it so
    "straight": 27,  # one program from top to bottom
    "carry": 22,  # a subroutine with the two places as arguments
    "carry_high": 6,  # and with heights as arguments
    "two": 13,  # one that picks, one that places
    "globals": 6,  # a subroutine that reads variables of all
    "for": 9,  # arrays and a FOR
    "while": 5,
    "goto": 4,
    "each": 8,  # a subroutine for each thing
}
HEIGHTS = (30, 40, 50, 60, 70, 75, 80, 90, 100, 100, 100, 110, 120, 130, 150, 150, 180, 200)
FOLLOW = 0.12  # of students
USUAL = 120  # [mm] that the lesson approaches from


@dataclass(frozen=True)
class Layout:
    """How somebody's text looks."""

    indent: str
    deeper: str  # of a block, more
    upper: str  # case of VAL-II's words: upper, lower, title
    comma: str
    equals: str
    lead: str  # of a comment
    column: int  # of comments behind statements; 0: right behind them
    brackets: bool  # `.PROGRAM main()`
    blank: bool  # lines between programs
    digits: int  # of numbers in .LOCATIONS; -1: as short as they are
    columns: bool  # whether these stand below each other


@dataclass(frozen=True)
class Author:
    """The habits of one person. Lengths in mm, speeds in percent."""

    layout: Layout
    tongue: Tongue  # of comments
    naming: Tongue  # of names
    shape: str
    own_names: bool
    name_form: int
    name_case: str
    notes: float  # chance of a comment behind a statement
    part_notes: float  # chance of one above a goal
    types: str  # what it prints: none, end, each
    taught_mm: float  # spread of values taught by hand; 0: as in the text
    rounding_mm: int  # of own values
    lift_mm: float  # by how much it holds cans higher
    turn_deg: float  # of the hand at cans
    computed: str  # places: section, trans, shift
    own_safe: bool
    above_grip: int
    above_put: int
    away: int
    rise: float  # from the lowest to the highest that is sensible, 0..1
    speeds: str  # once, next, switch, none, units
    fast: int
    slow: int
    slower: int
    down: str  # MOVES or MOVE
    up: str  # DEPARTS or DEPART
    approach: str  # APPRO or APPROS
    points: bool  # has a place of its own above each, in their stead
    grips: str  # CLOSEI, CLOSE
    opens: str  # first, each, both
    pause_s: float
    breaks: bool
    safe: str  # ends, between, start, never
    inner: str  # a habit of subroutines: none, return, args
    order: float  # whether goals are done in another order than the text has them
    signal: int  # where the output is switched: 0 at first, 1 before the last, 2 at the end
    follows: bool = False  # the text, word by word, wherever it says something


def author(seed: object) -> Author:
    """Return the author of a seed."""
    draw = Random(f"author {seed}")
    tongue = draw.choices(TONGUES, SHARES)[0]
    usual = draw.random() < 0.22  # takes the lesson's numbers
    above = USUAL if usual else draw.choice(HEIGHTS)
    talks = draw.choice((0.0, 0.0, 0.05, 0.15, 0.3, 0.5, 0.9))
    fast = draw.choice((100, 100, 100, 100, 90, 80, 80, 75, 70, 60, 50))
    found = Author(
        layout=layout(draw),
        tongue=tongue,
        naming=tongue if draw.random() < 0.7 else ENGLISH,
        shape=draw.choices(tuple(SHAPES), tuple(SHAPES.values()))[0],
        own_names=draw.random() < 0.52,
        name_form=draw.randrange(8),
        name_case=draw.choice(("lower", "lower", "lower", "upper", "title", "camel")),
        notes=talks,
        part_notes=draw.choice((0.0, 0.3, 0.8, 1.0)) if talks else draw.choice((0.0, 0.0, 1.0)),
        types=draw.choice(("none", "none", "end", "end", "each")),
        taught_mm=draw.choice((0.0, 0.0, 0.0, 0.4, 0.8, 1.0)),
        rounding_mm=draw.choice((0, 0, 1, 1, 5)),
        lift_mm=draw.choice((0, 0, 0, 0, 5, 10, 15, -5, -10, 8, 12.5)),
        turn_deg=draw.choice((90, 90, 90, 90, 90, 0, 180, 45)),
        computed=draw.choices(("section", "trans", "shift"), (70, 15, 15))[0],
        own_safe=draw.random() < 0.6,
        above_grip=above,
        above_put=above if draw.random() < 0.6 else draw.choice(HEIGHTS),
        away=above if usual or draw.random() < 0.3 else draw.choice(HEIGHTS[4:]),
        rise=draw.random(),
        speeds=draw.choices(("once", "next", "switch", "none", "units"), (28, 34, 22, 8, 8))[0],
        fast=fast,
        slow=draw.choice((20, 25, 30, 30, 35, 40, 40, 50, 60)),
        slower=draw.choice((10, 15, 20, 20, 25, 30, 40)),
        down=draw.choices(("MOVES", "MOVE"), (85, 15))[0],
        up=draw.choices(("DEPARTS", "DEPART"), (75, 25))[0],
        approach=draw.choices(("APPRO", "APPROS"), (80, 20))[0],
        points=draw.random() < 0.14,
        grips=draw.choices(("CLOSEI", "CLOSE"), (85, 15))[0],
        opens=draw.choice(("first", "first", "each", "both")),
        pause_s=draw.choice((0, 0, 0, 0, 0.1, 0.2, 0.25, 0.3, 0.5)),
        breaks=draw.random() < 0.15,
        safe=draw.choice(("ends", "ends", "start", "between", "between", "never")),
        inner=draw.choice(("none", "none", "return", "args")),
        order=draw.random(),
        signal=draw.randrange(3),
    )
    return follower(found, draw) if draw.random() < FOLLOW else found


def follower(one: Author, draw: Random) -> Author:
    """Return one who does it as the lesson does, with the text's names, values and numbers."""
    return replace(
        one,
        follows=True,
        shape=draw.choice(("carry", "carry", "for", "straight")),
        own_names=False,
        naming=ENGLISH,
        taught_mm=0.0,
        rounding_mm=0,
        lift_mm=0,
        turn_deg=90,
        computed="section",
        own_safe=False,
        above_grip=USUAL,
        above_put=USUAL,
        away=USUAL,
        rise=0.1,
        speeds=draw.choice(("next", "next", "once")),
        fast=100,
        slow=30,
        slower=20,
        down="MOVES",
        up="DEPARTS",
        approach="APPRO",
        points=False,
        grips="CLOSEI",
        opens="first",
        pause_s=0,
        breaks=False,
        safe="ends",
        order=draw.choice((0.0, 0.0, 0.7)),
    )


def layout(draw: Random) -> Layout:
    """Return how a text looks."""
    indent = draw.choice(("", "  ", "  ", "    ", "    ", "\t", "        ", " "))
    return Layout(
        indent=indent,
        deeper=draw.choice(("  ", "  ", "    ", "\t" if indent == "\t" else "   ")),
        upper=draw.choices(("upper", "lower", "title"), (72, 23, 5))[0],
        comma=draw.choice((", ", ", ", ", ", ",", " , ")),
        equals=draw.choice((" = ", " = ", "=")),
        lead=draw.choice(("; ", "; ", ";", ";; ", ";- ", ";   ")),
        column=draw.choice((0, 0, 28, 32, 40)),
        brackets=draw.random() < 0.6,
        blank=draw.random() < 0.5,
        digits=draw.choice((2, 2, -1, -1, 1, 3)),
        columns=draw.random() < 0.6,
    )
