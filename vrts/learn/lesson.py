"""Lessons as data: steps of a few minutes, and what the files of a learner have to do for each."""

from fractions import Fraction
from typing import NamedTuple, TypeAlias


class ProgramWish(NamedTuple):
    """What a program has to do. What is left out is not asked for."""

    file: str
    scene: str | None = None  # to run it in; None: the task beside it
    teaches: tuple[str, ...] = ()  # locations in its data
    own_places: int = 0  # locations that the scene does not name, and that the arm can reach
    holds: str | None = None  # an object that the hand takes hold of
    in_place: tuple[str, ...] = ()  # objects that end at their goals
    untouched: bool = False  # nothing is hit
    finds: str | None = None  # a code that has to be found: a step in which something goes wrong
    mark: Fraction | None = None  # at least


class AssignmentWish(NamedTuple):
    """What the folder of an assignment has to hold."""

    folder: str
    objects: tuple[str, ...] = ()  # in its scene
    task: bool = True  # whether it has to be ready to be handed out; False: the scene alone counts
    hidden: int = 0  # checks that students do not see, at least


class PackedWish(NamedTuple):
    """A packed assignment, and a program that is marked in it."""

    file: str
    program: str
    mark: Fraction


class MarkedWish(NamedTuple):
    """A folder of marks."""

    folder: str
    rows: int  # at least


class LogWish(NamedTuple):
    """The log of a robot that has to be of a program's run. Lengths in metres."""

    program: str
    log: str
    scene: str | None = None
    lab: str | None = None
    within_m: float | None = None  # the tool is never farther off
    beyond_m: float | None = None  # it is farther off than this somewhere


Wish: TypeAlias = ProgramWish | AssignmentWish | PackedWish | MarkedWish | LogWish


class Step(NamedTuple):
    """A few minutes of work."""

    title: str
    minutes: int
    does: str  # what to do, in a sentence or three
    tries: tuple[str, ...]  # commands to type
    part: str  # of the lesson's text to read; "" where there is none
    wish: Wish


class Lesson(NamedTuple):
    """A lesson: the folder of an example, divided into steps."""

    number: int
    title: str
    about: str  # one sentence
    steps: tuple[Step, ...]
    files: tuple[str, ...] = ()  # what a copy holds: names inside its folder, or patterns of them

    @property
    def minutes(self) -> int:
        """How long all steps take."""
        return sum(step.minutes for step in self.steps)


class Answer(NamedTuple):
    """Whether the files of a learner do what a step asks for."""

    done: bool
    why: str = ""  # not: one sentence, without full stop
    hint: str = ""  # where to look; not the solution


DONE = Answer(done=True)
