"""What the grammar takes in common and one dialect refuses: operands too many, labels by name."""

import re
from collections.abc import Sequence
from typing import Any

from vrts.base.diagnostic import Rule
from vrts.lang.dialect import Dialect
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Infix, Item, Name, Number
from vrts.lang.syntax.statements import (
    CallStatement,
    Device,
    Goto,
    Level,
    ReactStatement,
    Rest,
    Setting,
    Simple,
    SpeedStatement,
    Statement,
)
from vrts.lang.vocabulary.room import room_of
from vrts.lang.vocabulary.word import Word

UNEXPECTED_TEXT = Rule("V125", "unexpected-text")
LABEL_EXPECTED = Rule("V136", "label-expected")
TOO_MANY_OPERANDS = Rule("V156", "too-many-operands")
MISSING_KEYWORD = Rule("V130", "missing-keyword")
MISSING_OPERAND = Rule("V124", "missing-operand")

_DRAW = 3
_DRAW_OF_AS = 7  # three rotations and a speed more
_MOST = {
    "JMOVE": 6,
    "BASE": 4,
    "TDRAW": _DRAW_OF_AS,
    "PCEXECUTE": 3,
    "REACT": 3,
    "REACTI": 3,
    "IGNORE": 1,
    "ON": 3,
    "ONI": 3,
    "WAIT.EVENT": 2,
}
_TEXT_SAYS = "VAL-II says *Unexpected text at end of line*"


def fits(problems: Problems, node: Statement, word: Word | None) -> bool:
    """Return whether a dialect takes a step that the grammar took; report it if not."""
    dialect = problems.dialect
    match node:
        case Goto(label=Name() as label) if not dialect.has("a"):
            return _named_label(problems, label)
        case Rest(word="POINT") if not dialect.tolerant and _is_set(problems, node):
            return _one_location(problems, node)
        case Goto(label=Number(value=value) as label) if value != int(value):
            return _named_label(problems, label)
        case CallStatement(program=program) if dialect.is_as and program.text.startswith("."):
            return _local_program(problems, program)
        case SpeedStatement(word="SPEED", levels=levels) if dialect.is_as and any(
            map(_half_unit, levels)
        ):
            return _whole_unit(problems, next(filter(_half_unit, levels)))
        case Simple(word="GRASP", operands=(_, label)) if not isinstance(label, Number):
            assert label is not None
            return _named_label(problems, label)
        case Simple(operands=operands) | ReactStatement(operands=operands):
            return _few_enough(problems, word, operands, _most(node.word, dialect))
        case Device() if word is not None and word.terminal == "DEVICE":
            return _room_enough(problems, word, node)
        case SpeedStatement(profile=profile) if profile is not None and not (
            dialect.has("+") and node.word == "ACCEL"
        ):
            return _few_enough(problems, word, profile, 0)
        case SpeedStatement(levels=levels):
            most = 1 if node.word in ("DURATION", "ACCURACY", "DECEL") or not _pairs(dialect) else 2
            return _few_enough(problems, word, levels, most)
        case Setting(value=value) if value is not None and not dialect.has("+"):
            return _few_enough(problems, word, (value,), 0)
        case _:
            return True


def _is_set(problems: Problems, node: Rest) -> bool:
    return problems.source.text[node.start : node.start + 3].upper() == "SET"


def _one_location(problems: Problems, node: Rest) -> bool:
    """`SET p = a, 2`, which only V+ takes."""
    text = problems.source.text
    first, comma, _ = text[node.start : node.end].rpartition(",")
    shifted = first.replace("=", "= SHIFT(", 1).replace("( ", "(")
    problems.error(
        UNEXPECTED_TEXT,
        "SET gives a location one value",
        node.start + len(first),
        node.end,
        "unexpected here",
        notes=(_TEXT_SAYS,),
        help=(
            f"leave it out: write `{first.rstrip()}`",
            f"to shift it write `{shifted.rstrip()} BY dx, dy, dz)`",
        ),
    )
    assert comma
    return False


def _local_program(problems: Problems, program: Name) -> bool:
    """`CALL .x`."""
    problems.error(
        MISSING_OPERAND,
        f"`{program.text}` is a local variable, not a program",
        program.start,
        program.end,
        "the name of a program belongs here",
        help=("names of programs begin with a letter; SCALL takes a name from a string",),
    )
    return False


def _half_unit(level: Level) -> bool:
    """Whether the unit of a speed in AS lacks its length, as in `SPEED 100 /S`."""
    value = level.value
    right = value.right if isinstance(value, Infix) and value.operator == "/" else None
    return level.unit is None and isinstance(right, Name) and right.text.upper() in ("S", "MIN")


def _whole_unit(problems: Problems, level: Level) -> bool:
    assert isinstance(level.value, Infix)
    unit, start = level.value.right, level.value.operator_start
    problems.error(
        MISSING_KEYWORD,
        f"`/{problems.source.text[unit.start : unit.end]}` is only a part of a unit",
        start,
        unit.end,
        help=("write `MM/S` for millimetres a second, or `DEG/S` for degrees",),
    )
    return False


def _room_enough(problems: Problems, word: Word, node: Device) -> bool:
    """Whether the operands of an instruction with a device are not more than its usage shows."""
    room = room_of(word)
    given = node.given
    optional = room.equal is None or (room.equal and problems.dialect.is_as)
    if room.equal is not (given is not None) and not optional:
        at = node.start + len(word.text) if given is None else _equal_sign(problems, node)
        problems.error(
            UNEXPECTED_TEXT if given is not None else MISSING_KEYWORD,
            f"{word.text} takes no `=`" if given is not None else f"{word.text} wants `=`",
            at,
            at + 1 if given is not None else node.end,
            help=(f"write `{word.usage}`",),
        )
        return False
    return (
        _few_enough(problems, word, node.unit or (), room.unit)
        and _few_enough(problems, word, node.operands, room.operands)
        and _few_enough(problems, word, given or (), room.given)
    )


def _equal_sign(problems: Problems, node: Device) -> int:
    """Return where the `=` of a step stands."""
    before = [operand for operand in (*(node.unit or ()), *node.operands) if operand is not None]
    start = max((operand.end for operand in before), default=node.start)
    return problems.source.text.index("=", start)


def _pairs(dialect: Dialect) -> bool:
    """Whether SPEED takes a second value, for the speed of turning."""
    return dialect.has("+a")


def _most(word: str, dialect: Dialect) -> int | None:
    if word == "DRAW":
        return _DRAW_OF_AS if dialect.has("a") else _DRAW
    if word == "BASE" and dialect.is_as:
        return 1
    if word == "RETURN":
        return 1 if dialect.has("1") else 0
    return _MOST.get(word)


def _few_enough(
    problems: Problems, word: Word | None, operands: Sequence[Any], most: int | None
) -> bool:
    if most is None or len(operands) <= most or word is None:
        return True
    extra = [operand for operand in operands[most:] if operand is not None]
    if not extra:
        return True
    takes = f"at most {most} operand{'' if most == 1 else 's'}" if most else "no operand"
    problems.error(
        TOO_MANY_OPERANDS,
        f"{word.text} takes {takes}, {len(operands)} given",
        extra[0].start,
        extra[-1].end,
        "unexpected here",
        notes=(_TEXT_SAYS,),
        help=(f"write `{word.usage}`",),
    )
    return False


def _named_label(problems: Problems, label: Item) -> bool:
    text = problems.source.text[label.start : label.end]
    line = rf"^[ \t]*{re.escape(text)}[ \t]"
    if isinstance(label, Number) and re.search(line, problems.source.text, re.MULTILINE):
        return False  # said there
    problems.error(
        LABEL_EXPECTED,
        f"`{text[:40]}` is not a label",
        label.start,
        label.end,
        "the number of a label belongs here",
        notes=("VAL-II says *Invalid statement label*",),
        help=("labels are whole numbers at the start of a line: `10 MOVE a`, then `GOTO 10`",),
    )
    return False
