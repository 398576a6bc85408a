"""A keyword, and all that is known of it."""

from enum import Enum
from typing import NamedTuple


class Place(Enum):
    """Where a word counts as a keyword."""

    INSTRUCTION = "instruction"  # first word of a step
    QUALIFIER = "qualifier"  # inside a step, where its instruction wants it
    OPERATOR = "operator"
    COMMAND = "command"  # of the monitor, not of programs


class Word(NamedTuple):
    """A keyword."""

    text: str  # upper case
    place: Place
    dialects: str  # columns: `1` VAL, `2` VAL-II, `+` V+, `a` AS [manual language/names#columns]
    terminal: str  # class of words with the same operands, in the grammar
    usage: str = ""  # as a reader would write it
    about: str = ""  # what it does, in one line
    operands: tuple[str, ...] = ()  # what each stands for, for messages
    qualifiers: frozenset[str] = frozenset()  # words its step may hold
    means: str = ""  # the word it is another spelling of; empty: itself
    full: bool = False  # never abbreviated
    shortest: str = ""  # fixed shortest form; empty: any prefix that is unique
    robot: bool = False  # [R]: moves or configures the robot, so not in process control programs
    breaks: bool = False  # waits until the arm stands still (breaks continuous path)
    unit: bool = False  # a device number in parentheses may follow: `WRITE (lun) ...`
    opaque: bool = False  # known, and never carried out by the simulator

    @property
    def canonical(self) -> str:
        """The word that statements and messages of later stages name."""
        return self.means or self.text

    @property
    def in_val2(self) -> bool:
        """Whether VAL-II has the word."""
        return "2" in self.dialects


class Match(NamedTuple):
    """What a first word stands for: one word, or several that it could abbreviate, or none."""

    word: Word | None
    candidates: tuple[Word, ...] = ()
