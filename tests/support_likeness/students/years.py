"""What is handed out in each of three years: text that any student may use."""

from typing import NamedTuple

from tests.support_likeness.students.program import Line, Unit


class Year(NamedTuple):
    """What a class is given beside the task."""

    number: int
    lecture: str  # which example of the lecture
    lecture_share: float  # of students who build on it
    start_share: float  # of students who begin with the start program
    text: str  # all of it, as handed out

    @property
    def has_start(self) -> bool:
        """Whether a start program is given."""
        return self.start_share > 0


START = """; ROBOTICS LAB - start program
; fill in your name and the part in the middle
.PROGRAM main()
        SPEED 100 ALWAYS                ; speed of all motions
        OPENI                           ; a run starts with a closed hand
        MOVE safe                       ; away from everything
        ; your program here
        MOVE safe
        TYPE "End of the program."
.END
"""
CARRY = """.PROGRAM carry(start, goal)
        ; fetch the thing at "start" and stand it at "goal"
        APPRO start, 120                ; above it, quickly
        SPEED 30
        MOVES start                     ; straight down, gently
        CLOSEI                          ; stop, close, wait for the fingers
        DEPARTS 200                     ; straight up
        APPRO goal, 120
        SPEED 20
        MOVES goal
        OPENI                           ; let go only now
        DEPARTS 120
.END
"""
FETCH = """.PROGRAM fetch(where)
        APPRO where, 100                ; from above
        MOVES where
        CLOSEI
        DEPARTS 180
.END
.PROGRAM deliver(where)
        APPRO where, 100
        SPEED 25
        MOVES where
        OPENI
        DEPARTS 100
.END
"""
YEARS = (
    Year(1, "carry", 0.33, 0.0, CARRY),
    Year(2, "carry", 0.2, 0.55, START + CARRY),
    Year(3, "fetch", 0.33, 0.3, START + FETCH),
)


def start_head() -> list[str]:
    """Return the comments at the top of the start program."""
    return ["ROBOTICS LAB - start program", "fill in your name and the part in the middle"]


def start_lines(safe: str) -> tuple[list[Line], list[Line]]:
    """Return how the start program begins and ends."""
    first = [
        Line("SPEED", ["100", "ALWAYS"], "speed of all motions"),
        Line("OPENI", [], "a run starts with a closed hand"),
        Line("MOVE", [safe], "away from everything"),
    ]
    return first, [Line("MOVE", [safe]), Line("TYPE", ['"End of the program."'])]


def lecture_units(year: Year) -> list[Unit]:
    """Return the lecture's subroutines."""
    if year.lecture == "carry":
        body = [
            Line("NOTE", ['fetch the thing at "start" and stand it at "goal"']),
            Line("APPRO", ["start", "120"], "above it, quickly"),
            Line("SPEED", ["30"]),
            Line("MOVES", ["start"], "straight down, gently"),
            Line("CLOSEI", [], "stop, close, wait for the fingers"),
            Line("DEPARTS", ["200"], "straight up"),
            Line("APPRO", ["goal", "120"]),
            Line("SPEED", ["20"]),
            Line("MOVES", ["goal"]),
            Line("OPENI", [], "let go only now"),
            Line("DEPARTS", ["120"]),
        ]
        return [Unit("carry", ["start", "goal"], body)]
    fetch = [
        Line("APPRO", ["where", "100"], "from above"),
        Line("MOVES", ["where"]),
        Line("CLOSEI"),
        Line("DEPARTS", ["180"]),
    ]
    deliver = [
        Line("APPRO", ["where", "100"]),
        Line("SPEED", ["25"]),
        Line("MOVES", ["where"]),
        Line("OPENI"),
        Line("DEPARTS", ["100"]),
    ]
    return [Unit("fetch", ["where"], fetch), Unit("deliver", ["where"], deliver)]
