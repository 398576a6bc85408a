"""Every word of the language in one table: what it is, who knows it, how short it may be.

The tokeniser, the error messages, the did-you-mean of instructions and the tests read this table
and nothing else. Dialects: `1` VAL, `2` VAL-II, `+` V+, `a` AS [val2.md 12].
"""

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
    dialects: str
    terminal: str | None = None  # class of words in the grammar; None: known, not supported yet
    usage: str = ""  # as a reader would write it
    operands: tuple[str, ...] = ()  # what each stands for, for messages
    qualifiers: frozenset[str] = frozenset()  # words its step may hold
    full: bool = False  # never abbreviated
    shortest: str = ""  # fixed shortest form; empty: any prefix that is unique
    robot: bool = False  # [R]: moves or configures the robot, so not in process control programs
    breaks: bool = False  # waits until the arm stands still (breaks continuous path)

    @property
    def in_val2(self) -> bool:
        """Whether VAL-II has the word."""
        return "2" in self.dialects


def _instruction(
    text: str,
    dialects: str,
    terminal: str | None = None,
    usage: str = "",
    operands: str = "",
    qualifiers: str = "",
    *,
    full: bool = False,
    shortest: str = "",
    robot: bool = False,
    breaks: bool = False,
) -> Word:
    return Word(
        text,
        Place.INSTRUCTION,
        dialects,
        terminal,
        usage or text,
        tuple(operands.split(" | ")) if operands else (),
        frozenset(qualifiers.split()),
        full,
        shortest,
        robot,
        breaks,
    )


_I = _instruction
_LOCATION = "a location"
_RETREAT = "a location | a distance in mm"

_INSTRUCTIONS = (
    _I("ABOVE", "12+a", "WORD0", robot=True, breaks=True),
    _I("ALIGN", "12+a", robot=True),
    _I("ALTER", "2+", robot=True),
    _I("ALTOFF", "2+", robot=True, breaks=True),
    _I("ALTON", "2+", robot=True),
    _I("ANY", "2+a", "ANY", "ANY", full=True),
    _I("APPRO", "12+", "WORD2", "APPRO location, distance", _RETREAT, robot=True),
    _I("APPROS", "12+", "WORD2", "APPROS location, distance", _RETREAT, robot=True),
    _I("BASE", "12+a", "WORDLIST", "BASE dx, dy, dz, rotation", robot=True, breaks=True),
    _I("BELOW", "12+a", "WORD0", robot=True, breaks=True),
    _I("BITS", "2+a"),
    _I("BRAKE", "2+a"),
    _I("BREAK", "2+a", "WORD0", breaks=True),
    _I("CALL", "2+a", "CALL", "CALL program(a, b)", "the name of a program"),
    _I("CASE", "2+a", "CASE", "CASE expression OF", "an expression", "OF", full=True),
    _I("CLOSE", "12+a", "WORD01", "CLOSE", robot=True),
    _I("CLOSEI", "12+a", "WORD01", "CLOSEI", robot=True, breaks=True),
    _I("COARSE", "12+", robot=True),
    _I("DAC", "2"),
    _I("DELAY", "12+a", "WORD1", "DELAY seconds", "a time in seconds", robot=True),
    _I("DEPART", "12+", "WORD1", "DEPART distance", "a distance in mm", robot=True),
    _I("DEPARTS", "12+", "WORD1", "DEPARTS distance", "a distance in mm", robot=True),
    _I("DISABLE", "2+"),
    _I("DO", "2+a", "STRUCTURE", "DO", full=True),
    _I("DRAW", "12a", robot=True),
    _I(
        "DRIVE",
        "12+a",
        "DRIVE",
        "DRIVE joint, change, speed",
        "a joint number | a change in degrees | a speed in percent",
        robot=True,
    ),
    _I("ELSE", "2+a", "STRUCTURE", full=True),
    _I("ENABLE", "2+"),
    _I("END", "2+a", "STRUCTURE", full=True),
    _I("FINE", "12+", robot=True),
    _I("FLIP", "12+", "WORD0", robot=True, breaks=True),
    _I(
        "FOR",
        "2+a",
        "FOR",
        "FOR variable = first TO last STEP increment",
        "a variable",
        "TO STEP",
        full=True,
    ),
    _I("GOTO", "12+a", "GOTO", "GOTO label", "the number of a label"),
    _I("GRASP", "12", robot=True, breaks=True),
    _I("HALT", "2+a", "WORD01", "HALT", breaks=True),
    _I("HERE", "12+a", "HERE", "HERE location", _LOCATION, robot=True),
    _I(
        "IF",
        "12+a",
        "IF",
        "IF condition THEN",
        "a condition",
        "THEN GOTO",
        full=True,
    ),
    _I("IGNORE", "12+a"),
    _I("INTOFF", "12", robot=True),
    _I("INTON", "12", robot=True),
    _I("IOPUT", "2"),
    _I("LEFTY", "12+a", "WORD0", robot=True, breaks=True),
    _I("LOCK", "2+a"),
    _I("MC", "2+a"),
    _I("MOVE", "12+", "WORD1", "MOVE location", _LOCATION, robot=True),
    _I("MOVES", "12+", "WORD1", "MOVES location", _LOCATION, robot=True),
    _I("MOVEST", "12+", robot=True),
    _I("MOVET", "12+", robot=True),
    _I("MULTIPLE", "2+", robot=True),
    _I("NOFLIP", "12+", "WORD0", robot=True, breaks=True),
    _I("NONULL", "12+", robot=True),
    _I("NULL", "12+", robot=True),
    _I("OPEN", "12+a", "WORD01", "OPEN", robot=True),
    _I("OPENI", "12+a", "WORD01", "OPENI", robot=True, breaks=True),
    _I("PACK", "2+"),
    _I("PARAMETER", "2+"),
    _I("PAUSE", "12+a", "WORD01", "PAUSE", breaks=True),
    _I("PCABORT", "2a"),
    _I("PCEND", "2a"),
    _I("PCEXECUTE", "2a"),
    _I("PROMPT", "2+a"),
    _I("REACT", "12+"),
    _I("REACTE", "2+"),
    _I("REACTI", "12+"),
    _I("READY", "12+", "WORD0", robot=True),
    _I("RELAX", "12+a", "WORD01", "RELAX", robot=True),
    _I("RELAXI", "12+a", "WORD01", "RELAXI", robot=True, breaks=True),
    _I("RESET", "2+a"),
    _I("RETURN", "12+a", "WORD0", shortest="RET"),
    _I("RETURNE", "2+a"),
    _I("RIGHTY", "12+a", "WORD0", robot=True, breaks=True),
    _I("SET", "12+", "SET", "SET location = value", "the location to set"),
    _I("SHIFT", "12", "SHIFT", "SHIFT location BY dx, dy, dz", _LOCATION, "BY"),
    _I("SIGNAL", "12+a", "WORDITEMS", "SIGNAL number", "a signal number"),
    _I("SINGLE", "2+", robot=True),
    _I(
        "SPEED",
        "12+a",
        "SPEED",
        "SPEED value MMPS ALWAYS",
        "a speed",
        "MMPS IPS ALWAYS",
        robot=True,
    ),
    _I("STOP", "12+a", "WORD01", "STOP"),
    _I("TIMER", "2+a"),
    _I("TOOL", "12+a", "WORD01", "TOOL location", robot=True, breaks=True),
    _I("TYPE", "12+a", "TYPE", 'TYPE "text", value'),
    _I("UNTIL", "2+a", "UNTIL", "UNTIL condition", "a condition", full=True),
    _I("VALUE", "2+a", "VALUE", "VALUE n:", "a value", full=True),
    _I("WAIT", "12+a", "WORD01", "WAIT condition"),
    _I("WHILE", "2+a", "WHILE", "WHILE condition DO", "a condition", "DO", shortest="WH"),
    # words of the relatives, so that they can be named
    _I("ACCEL", "+a"),
    _I("AUTO", "+"),
    _I("CALLS", "+"),
    _I("DECOMPOSE", "+a"),
    _I("DURATION", "+"),
    _I("EXIT", "+"),
    _I("FRAME", "1"),
    _I("GLOBAL", "+"),
    _I("GOSUB", "1"),
    _I("IFSIG", "1"),
    _I("INVERSE", "1"),
    _I("LOCAL", "+"),
    _I("NEST", "1"),
    _I("NEXT", "+"),
    _I("REMARK", "1"),
    _I("REST", "1"),
    _I("SETI", "1"),
    _I("TYPEI", "1"),
)

_QUALIFIERS = (
    Word("ALWAYS", Place.QUALIFIER, "12+a", "ALWAYS"),
    Word("BY", Place.QUALIFIER, "12+a", "BY"),
    Word("IPS", Place.QUALIFIER, "2+", "UNIT"),
    Word("MMPS", Place.QUALIFIER, "2+", "UNIT"),
    Word("OF", Place.QUALIFIER, "2+a", "OF"),
    Word("STEP", Place.QUALIFIER, "2+a", "STEP"),
    Word("THEN", Place.QUALIFIER, "12+a", "THEN"),
    Word("TO", Place.QUALIFIER, "2+a", "TO"),
)

_OPERATORS = (
    Word("AND", Place.OPERATOR, "2+a", "INFIX"),
    Word("BAND", Place.OPERATOR, "2+a", "INFIX"),
    Word("BOR", Place.OPERATOR, "2+a", "INFIX"),
    Word("BXOR", Place.OPERATOR, "2+a", "INFIX"),
    Word("COM", Place.OPERATOR, "2+a", "PREFIX"),
    Word("MOD", Place.OPERATOR, "2+a", "INFIX"),
    Word("NOT", Place.OPERATOR, "2+a", "PREFIX"),
    Word("OR", Place.OPERATOR, "2+a", "INFIX"),
    Word("XOR", Place.OPERATOR, "2+a", "INFIX"),
)

_COMMANDS = tuple(
    Word(text, Place.COMMAND, "12+")
    for text in (
        *("ABORT", "CALIBRATE", "COPY", "DELETE", "DIRECTORY", "EDIT", "ERASE", "EXECUTE", "FREE"),
        *("LISTL", "LISTP", "LISTR", "LISTS", "LOAD", "POINT", "PROCEED", "RENAME", "RETRY"),
        *("STATUS", "STORE", "STOREL", "STOREP", "STORER", "STORES", "SWITCH", "TEACH", "WHERE"),
        "ZERO",
    )
)

INSTRUCTIONS = {word.text: word for word in _INSTRUCTIONS}
QUALIFIERS = {word.text: word for word in _QUALIFIERS}
OPERATORS = {word.text: word for word in _OPERATORS}
COMMANDS = {word.text: word for word in _COMMANDS}

NAMES_OF_DIALECTS = {"1": "VAL", "2": "VAL-II", "+": "V+", "a": "AS"}

# Words that are no keyword of VAL-II, and what a VAL-II programmer writes instead.
FOREIGN = {
    "ACCEL": ("V+", "VAL-II has no such setting: use SPEED"),
    "ACCURACY": ("AS", "use COARSE or FINE"),
    "ATTACH": ("V+", "leave it out: the robot is attached"),
    "AUTO": ("V+", "leave it out: variables of VAL-II are global and need no declaration"),
    "CALLS": ("V+", "write CALL with the name of the program"),
    "DECOMPOSE": ("V+", "use DX(l), DY(l) and DZ(l)"),
    "DETACH": ("V+", "leave it out: the robot is attached"),
    "DURATION": ("V+", "VAL-II has no such setting: use SPEED"),
    "DWRIST": ("AS", "use FLIP"),
    "ELIF": ("other languages", "write ELSE on a line of its own and a new IF in the line below"),
    "ELSEIF": ("other languages", "write ELSE on a line of its own and a new IF in the line below"),
    "ENDCASE": ("other languages", "write END"),
    "ENDDO": ("other languages", "write END, or UNTIL with a condition after DO"),
    "ENDFOR": ("other languages", "write END"),
    "ENDIF": ("other languages", "write END"),
    "ENDWHILE": ("other languages", "write END"),
    "EXIT": ("V+", "leave the loop by `IF condition GOTO label`"),
    "FRAME": ("VAL", "write `SET frame = FRAME(a, b, c, d)`"),
    "GLOBAL": ("V+", "leave it out: variables of VAL-II are global"),
    "GOSUB": ("VAL", "use CALL"),
    "HOME": ("AS", "use READY"),
    "IFSIG": ("VAL", "write `IF SIG(number) THEN`"),
    "INPUT": ("other languages", "use PROMPT"),
    "INVERSE": ("VAL", "write `SET a = INVERSE(b)`"),
    "JAPPRO": ("AS", "use APPRO"),
    "JDEPART": ("AS", "use DEPART"),
    "JMOVE": ("AS", "use MOVE"),
    "LAPPRO": ("AS", "use APPROS"),
    "LDEPART": ("AS", "use DEPARTS"),
    "LET": ("other languages", "leave LET out: `x = 5`"),
    "LMOVE": ("AS", "use MOVES"),
    "LOCAL": ("V+", "leave it out: variables of VAL-II are global and need no declaration"),
    "LOOP": ("other languages", "a loop ends with END, or with UNTIL after DO"),
    "MOVEJ": ("other languages", "use MOVE"),
    "MOVEL": ("other languages", "use MOVES"),
    "NEST": ("VAL", "use READY"),
    "NEXT": ("V+", "a FOR loop ends with END"),
    "PRINT": ("AS", "use TYPE"),
    "PULSE": ("AS", "use SIGNAL, DELAY and SIGNAL again"),
    "REMARK": ("VAL", "begin comments with `;`"),
    "REPEAT": ("other languages", "use DO and UNTIL"),
    "REST": ("VAL", "use READY"),
    "SETI": ("VAL", "leave SETI out: `n = 5`"),
    "SLEEP": ("other languages", "use DELAY"),
    "SWAIT": ("AS", "write `WAIT SIG(number)`"),
    "THEN": ("other languages", "THEN ends the line of its IF"),
    "TWAIT": ("AS", "use DELAY"),
    "TYPEI": ("VAL", "use TYPE"),
    "UWRIST": ("AS", "use NOFLIP"),
    "WEND": ("other languages", "write END"),
    "WRITE": ("V+", "use TYPE"),
}


class Match(NamedTuple):
    """What a first word stands for: one word, or several that it could abbreviate, or none."""

    word: Word | None
    candidates: tuple[Word, ...] = ()


def look_up(text: str) -> Match:
    """Return the instruction a first word stands for in VAL-II [val2.md 1.13].

    An exact word wins, then a unique prefix; structure words are written in full.
    """
    text = text.upper()
    exact = INSTRUCTIONS.get(text)
    if exact is not None:
        return Match(exact)
    found = [
        word
        for word in INSTRUCTIONS.values()
        if word.in_val2 and not word.full and word.text.startswith(text)
    ]
    fixed = [word for word in found if word.shortest and text.startswith(word.shortest)]
    if fixed:
        return Match(fixed[0])
    found = [word for word in found if not (word.shortest == "WH" and len(text) < 2)]
    if len(found) == 1:
        return Match(found[0])
    return Match(None, tuple(found))
