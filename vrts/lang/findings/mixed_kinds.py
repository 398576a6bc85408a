"""What helps where a location stands for a number, and a number for a location.

In: what the name stands for in its step. Out: what belongs there, and what to write instead.
"""

from collections.abc import Callable
from typing import NamedTuple

from vrts.base.diagnostic import Fix
from vrts.ir.values import Type
from vrts.lang.meaning.roles import COMPARISONS, Role
from vrts.lang.problems import Problems
from vrts.lang.syntax.expressions import Application, Expression, Infix, Item
from vrts.lang.syntax.statements import (
    Assignment,
    For,
    HereStatement,
    If,
    SetLocation,
    Simple,
    SpeedStatement,
    Until,
    While,
)
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

TypeOf = Callable[[Item], Type]

_APPROACHES = frozenset({"APPRO", "APPROS"})
_DEPARTURES = frozenset({"DEPART", "DEPARTS"})
_HAND = frozenset({"OPEN", "OPENI", "CLOSE", "CLOSEI", "RELAX", "RELAXI"})
_GOING = {"MOVE": "DRAW", "MOVES": "DRAW"}


class Remedy(NamedTuple):
    """What to say of a name that is of another kind than its place wants."""

    label: str  # what belongs at its place
    help: tuple[str, ...]
    fix: Fix | None = None


def kind_of_number(role: Role) -> str:
    """Return what a number is that stands in a place."""
    around = role.around
    if isinstance(around, Simple) and around.word in _APPROACHES | _DEPARTURES:
        return "a distance in mm"
    if isinstance(around, SpeedStatement):
        return "a speed"
    if isinstance(around, Simple) and around.word == "DELAY":
        return "a time in seconds"
    return "a number"


def a_number_is_wanted(problems: Problems, role: Role, type_of: TypeOf) -> Remedy:
    """Say what to write where a location stands for a number."""
    text = problems.source.text
    name = text[role.node.start : role.node.end]
    around = role.around
    if isinstance(around, Simple) and around.word in _APPROACHES:
        return _approach(problems, around, "a distance belongs here", type_of)
    if isinstance(around, Simple) and around.word in _DEPARTURES:
        return Remedy(
            "a distance belongs here",
            (f"write how many mm to move away: `{around.word} 50`",),
        )
    if isinstance(around, Simple) and around.word == "TYPE":
        written = f"DX({name}), DY({name}), DZ({name})"
        fix = problems.replace(role.node.start, role.node.end, written, sure=False)
        return Remedy("TYPE writes numbers", (f"write its coordinates: `{written}`",), fix)
    if isinstance(around, Simple) and around.word == "DRAW":
        return Remedy(
            "DRAW takes how far to go along X, Y and Z, in mm",
            (f"to go to the location in a straight line write `MOVES {name}`",),
        )
    if isinstance(around, Simple) and around.word == "BASE":
        return Remedy(
            "BASE takes three lengths and an angle",
            (f"write its coordinates: `BASE DX({name}), DY({name}), DZ({name})`",),
        )
    if isinstance(around, Simple) and around.word in _HAND:
        return Remedy(
            f"{around.word} takes how far to open the hand, in mm",
            (f"write `MOVES {name}` on a line of its own, and {around.word} alone below it",),
        )
    if isinstance(around, Simple) and around.word in ("SIGNAL", "IGNORE"):
        return Remedy(
            f"{around.word} takes the number of a signal",
            (f"write the number, as in `{INSTRUCTIONS[around.word].usage}`",),
        )
    if isinstance(around, SpeedStatement):
        return Remedy(
            "SPEED takes a number: percent, or millimetres a second with MMPS",
            (f"write `SPEED 50`; to go to the location write `MOVE {name}` on a line of its own",),
        )
    if isinstance(around, Simple) and around.word == "DELAY":
        return Remedy(
            "DELAY takes a time in seconds",
            (f"write `DELAY 0.5`; to wait until the arm is at `{name}` write `BREAK`",),
        )
    if isinstance(around, Simple) and around.word == "PROMPT":
        return Remedy(
            "PROMPT reads numbers and strings",
            (
                'read into a variable with a name of its own, as in `PROMPT "Height: ", height`',
                f"and make the location of it: `SET {name} = TRANS(x, y, height, 90, 90, 0)`",
                f"`HERE {name}` keeps where the arm stands",
            ),
        )
    if isinstance(around, For) and around.target.start == role.node.start:
        rest = text[role.node.end : around.end]
        return Remedy("FOR counts with a number", (f"count with another variable: `FOR i{rest}`",))
    if isinstance(around, Infix):
        return _operand(problems, role, name, type_of)
    if isinstance(around, If | While | Until) or (
        isinstance(around, Simple) and around.word == "WAIT"
    ):
        help_ = f"compare one of its coordinates, as in `DZ({name}) > 100`"
        if isinstance(around, Simple):
            help_ = "to wait until the arm is there write `BREAK`; " + help_
        return Remedy("a condition belongs here", (help_,))
    if isinstance(around, Assignment) and around.target.start == role.node.start:
        value = text[around.value.start : around.value.end]
        return Remedy(
            "a number is given to it here",
            (
                f"give the number a name of its own: `{name}.n = {value}`",
                "a location gets its value by SET",
            ),
        )
    what = "a number belongs here"
    if isinstance(around, Application):
        what = f"{around.name.text.upper()} takes a number"
    elif isinstance(around, Simple | SpeedStatement):
        what = f"{around.word} takes a number"
    return Remedy(what, (f"write a number, or one coordinate of the location: `DZ({name})`",))


def a_location_is_wanted(problems: Problems, role: Role, type_of: TypeOf) -> Remedy:
    """Say what to write where a number stands for a location."""
    name = problems.source.text[role.node.start : role.node.end]
    around = role.around
    if isinstance(around, Simple) and around.word in _GOING:
        return Remedy(
            f"{around.word} goes to a location",
            (
                "name a location, or write `TRANS(x, y, z, o, a, t)`",
                f"to go {name} mm up from here write `DRAW 0, 0, {name}`",
            ),
        )
    if isinstance(around, Simple) and around.word in _APPROACHES:
        return _approach(problems, around, f"{around.word} takes the location first", type_of)
    if isinstance(around, SetLocation) and around.value.start == role.node.start:
        target = _shown(problems, around.target)
        return Remedy(
            "SET takes a location",
            (
                f"make a location of numbers: `SET {target} = TRANS(x, y, z, o, a, t)`",
                f"a number is given by `{target} = {name}`, without SET",
            ),
        )
    if isinstance(around, SetLocation | HereStatement):
        return Remedy("a location is kept here", ("give the location a name of its own",))
    if isinstance(around, Infix):
        return Remedy(
            "`:` joins locations",
            (f"shift by numbers: `SHIFT({_other(problems, role)} BY 0, 0, {name})`",),
        )
    if isinstance(around, Application):
        word = around.name.text.upper()
        return Remedy(
            f"{word} takes a location",
            (f"name a location: `{word}` of a number has no meaning",),
        )
    return Remedy(
        "a location belongs here", ("name a location, or write `TRANS(x, y, z, o, a, t)`",)
    )


def _operand(problems: Problems, role: Role, name: str, type_of: TypeOf) -> Remedy:
    """A location on one side of an operator of numbers."""
    around = role.around
    other = role.other
    assert other is not None
    sides = (problems.source.text[around.start : role.node.start], f"DZ({name})")
    changed = "".join((*sides, problems.source.text[role.node.end : around.end]))
    both = type_of(other) is Type.POSE
    if around.operator in COMPARISONS:
        if both:
            left, right = _shown(problems, around.left), _shown(problems, around.right)
            sign = ">" if around.operator == "<>" else "<"
            return Remedy(
                f"`{around.operator}` compares numbers",
                (f"two places are the same where `DISTANCE({left}, {right}) {sign} 1`, in mm",),
            )
        return Remedy(
            f"`{around.operator}` compares numbers",
            (f"compare one of its coordinates: `{changed}`; DX and DY are the others",),
        )
    if both and around.operator == "-":
        left, right = _shown(problems, around.left), _shown(problems, around.right)
        return Remedy(
            "`-` subtracts numbers",
            (
                f"`DISTANCE({left}, {right})` is how far one is from the other",
                f"`DZ({left})-DZ({right})` how much higher",
            ),
        )
    if both and around.operator == "+":
        return Remedy("`+` adds numbers", ("join a frame and a location in it by `:`",))
    helps = [f"for a number write `{changed}`; DX and DY are the other coordinates"]
    step = role.step
    if around.operator in "+-" and isinstance(step, Assignment) and role.place == 0:
        target, by = _shown(problems, step.target), _shown(problems, other)
        by = by if around.operator == "+" else f"-{by}"
        helps.append(
            f"for a location that is shifted write `SET {target} = SHIFT({name} BY 0, 0, {by})`"
        )
    return Remedy(f"`{around.operator}` takes numbers", tuple(helps))


def _approach(problems: Problems, around: Simple, label: str, type_of: TypeOf) -> Remedy:
    """`APPRO height, part`, and an operand of another kind than its place wants."""
    first, last = (*around.operands, None, None)[:2]
    if first is None or last is None:
        return Remedy(label, (f"write `{INSTRUCTIONS[around.word].usage}`",))
    kinds = type_of(first), type_of(last)
    number, location = _shown(problems, first), _shown(problems, last)
    if kinds == (Type.REAL, Type.POSE):
        swapped = f"{location}, {number}"
        fix = problems.replace(first.start, last.end, swapped)
        return Remedy(
            f"{around.word} takes the location first", (f"write `{around.word} {swapped}`",), fix
        )
    if kinds[0] is Type.POSE:
        return Remedy(label, (f"write how many mm before it: `{around.word} {number}, 50`",))
    return Remedy(label, (f"write `{INSTRUCTIONS[around.word].usage}`",))


def _shown(problems: Problems, node: Item | None) -> str:
    return problems.source.text[node.start : node.end] if node is not None else ""


def _other(problems: Problems, role: Role) -> str:
    other: Expression | None = role.other
    return _shown(problems, other)
