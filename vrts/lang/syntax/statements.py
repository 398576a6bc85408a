"""Nodes of statements, one for each form that a step can have.

Every node ends with `start` and `end`, a half-open range of offsets in the source text.
"""

from typing import NamedTuple, TypeAlias

from vrts.lang.syntax.expressions import Expression, Item, Name, Number, Variable


class Assignment(NamedTuple):
    """`v = e`."""

    target: Variable
    value: Expression
    start: int
    end: int


class SetLocation(NamedTuple):
    """`SET l = e`."""

    target: Variable
    value: Expression
    start: int
    end: int


class HereStatement(NamedTuple):
    """`HERE frame:part`."""

    target: Expression
    start: int
    end: int


class ShiftStatement(NamedTuple):
    """`SHIFT l BY dx, dy, dz`, VAL's form of the function."""

    target: Variable
    offsets: "tuple[Item | None, ...]"
    start: int
    end: int


class Simple(NamedTuple):
    """An instruction whose operands are a plain list: READY, APPRO, SIGNAL, TYPE, BASE ..."""

    word: str  # the whole keyword, upper case
    operands: "tuple[Item | None, ...]"
    start: int
    end: int


class Level(NamedTuple):
    """A value with its unit, as SPEED and its like take them."""

    value: Expression
    unit: str | None
    start: int
    end: int


class SpeedStatement(NamedTuple):
    """`SPEED value [unit] [, value [unit]] [ALWAYS]`, and ACCEL, DURATION, ACCURACY like it."""

    word: str
    levels: tuple[Level, ...]
    always: bool
    profile: "tuple[Item | None, ...] | None"  # `ACCEL (profile) up, down` of V+
    start: int
    end: int


class Setting(NamedTuple):
    """`COARSE [percent] [ALWAYS]`, NULL, SINGLE, RIGHTY ..."""

    word: str
    value: Expression | None
    always: bool
    start: int
    end: int


class Give(NamedTuple):
    """`word v = e`: PARAMETER, DECOMPOSE, SETI, INVERSE, FRAME."""

    word: str
    target: Variable
    values: tuple[Expression, ...]
    start: int
    end: int


class Put(NamedTuple):
    """`word e = e`: TIMER, DAC, IOPUT; BITS has a count between."""

    word: str
    target: Expression
    length: Expression | None
    value: Expression
    start: int
    end: int


class PackStatement(NamedTuple):
    """`PACK $v, first, count = $s`."""

    target: Variable
    first: Expression
    length: Expression
    value: Expression
    start: int
    end: int


class ReactStatement(NamedTuple):
    """`REACT signal, program, priority [ALWAYS]`, and IGNORE, ON, ONI."""

    word: str
    operands: "tuple[Item | None, ...]"
    always: bool
    start: int
    end: int


class Device(NamedTuple):
    """`WRITE (unit) items`; `unit` is None when no parentheses are written.

    `VGETCAL (camera) data[0] = x, y` gives or takes more behind `=`.
    """

    word: str
    unit: "tuple[Item | None, ...] | None"
    operands: "tuple[Item | None, ...]"
    given: "tuple[Item | None, ...] | None"  # behind `=`
    start: int
    end: int


class Declare(NamedTuple):
    """`AUTO REAL a, b[10]`, LOCAL, GLOBAL."""

    word: str
    kind: str | None  # REAL, DOUBLE or LOC
    names: tuple[Expression, ...]
    start: int
    end: int


class Rest(NamedTuple):
    """An instruction whose operands are not looked into: opaque ones, MC."""

    word: str
    names: tuple[str, ...]  # in the rest of the line: nothing is reported about them
    start: int
    end: int


class Goto(NamedTuple):
    """`GOTO label`, and with a condition `IF e GOTO label`."""

    label: Number | Name  # names are labels of AS
    condition: Expression | None
    start: int
    end: int


class If(NamedTuple):
    """`IF e THEN`."""

    condition: Expression
    start: int
    end: int


class While(NamedTuple):
    """`WHILE e DO`."""

    condition: Expression
    start: int
    end: int


class Until(NamedTuple):
    """`UNTIL e`."""

    condition: Expression
    start: int
    end: int


class For(NamedTuple):
    """`FOR v = first TO last [STEP increment]`."""

    target: Variable
    first: Expression
    last: Expression
    increment: Expression | None
    start: int
    end: int


class Case(NamedTuple):
    """`CASE e OF`."""

    selector: Expression
    start: int
    end: int


class ValueGroup(NamedTuple):
    """`VALUE e, e:`."""

    values: "tuple[Item | None, ...]"
    start: int
    end: int


class Structure(NamedTuple):
    """A word that stands alone: ELSE, END, DO, ANY."""

    word: str
    start: int
    end: int


class CallStatement(NamedTuple):
    """`CALL program(a, b)`."""

    program: Name
    arguments: "tuple[Item | None, ...]"
    start: int
    end: int


class CallNamed(NamedTuple):
    """`CALLS $name(a, b)`."""

    program: Expression
    arguments: "tuple[Item | None, ...]"
    start: int
    end: int


class Bad(NamedTuple):
    """A step that was reported. `word` keeps the structure of the program known."""

    word: str | None  # the whole keyword, if one was recognised
    names: tuple[str, ...]  # names in it: nothing is reported about them
    start: int
    end: int
    meant: str | None = None  # the steps meant, where it takes the blocks around to mend it


Statement: TypeAlias = (
    Assignment
    | SetLocation
    | HereStatement
    | ShiftStatement
    | Simple
    | SpeedStatement
    | Setting
    | Give
    | Put
    | PackStatement
    | ReactStatement
    | Device
    | Declare
    | Rest
    | Goto
    | If
    | While
    | Until
    | For
    | Case
    | ValueGroup
    | Structure
    | CallStatement
    | CallNamed
    | Bad
)
