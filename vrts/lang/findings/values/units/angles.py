"""Angles that look like radians: the language has degrees."""

import math
import re

from vrts.base.diagnostic import Edit, Fix, Rule
from vrts.base.pose import Pose
from vrts.ir.module import Datum
from vrts.lang.findings.values.evaluate import evaluate, nothing_known
from vrts.lang.findings.values.units.lengths import offset_of
from vrts.lang.findings.values.units.parts_of_pi import (
    first_in_data,
    first_in_radians,
    is_part_of_pi,
    number_written,
)
from vrts.lang.meaning.name_uses import Asked, NameUses
from vrts.lang.names import key
from vrts.lang.syntax.expressions import (
    Application,
    Infix,
    Item,
    Name,
    Parenthesised,
    Prefix,
)
from vrts.lang.syntax.statements import Simple

RADIANS = Rule("V234", "angle-in-radians")

_ANGLES = {"sin": 0, "cos": 0, "tan": 0, "rx": 0, "ry": 0, "rz": 0, "trans": 3, "#ppoint": 0}
_TURNS = frozenset({"SIN", "COS", "TAN"})  # alone among functions they may take any number,
_FEW_DIGITS = 3  # and with fewer behind its point it may be an angle in degrees by chance
_VALUE = re.compile(r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)")
_FROM_DEGREES = re.compile(
    r"(?P<before>[\w.]+|\([^()]*\))[ \t]*\*[ \t]*\(?PI[ \t]*/[ \t]*180(?:\.0*)?\)?"
    r"|\(?PI[ \t]*/[ \t]*180(?:\.0*)?\)?[ \t]*\*[ \t]*(?P<behind>[\w.]+|\([^()]*\))",
    re.IGNORECASE,
)
_ROUND = 0.1  # [deg] 1.57 are 89.95 degrees, and 90 are meant
_VALUES = 6  # of a location, and of a precision point


def check_angles(types: NameUses, asked: Asked) -> bool:
    """Warn of angles in radians; return whether there is one."""
    node = asked.node
    if isinstance(node, Application) and node.name.text.lower() in _ANGLES:
        angles = node.arguments[_ANGLES[node.name.text.lower()] :]
        where = node.name.text.upper()
    elif isinstance(node, Simple) and node.word == "DRIVE":
        angles, where = node.operands[1:2], "DRIVE"
    else:
        return False
    at = first_in_radians(types, asked.program, angles)
    if where in _TURNS and at >= 0:
        written = number_written(types, asked.program, angles[at]) or ""
        if len(written.partition(".")[2]) < _FEW_DIGITS:
            at = -1
    for i, angle in enumerate(angles):
        if angle is not None and (i == at or has_pi(types, asked.program, angle, follow=True)):
            _warn(types, asked.program, [a for a in angles[i:] if a is not None], where)
            return True
    return False


def check_taught(types: NameUses, data: list[Datum]) -> None:
    """Warn of angles in radians in data sections."""
    problems = types.problems
    if problems.dialect.tolerant:
        return
    for datum in data:
        pose = isinstance(datum.value, Pose)
        at = first_in_data(datum, joints=not pose)
        if at < 0 or not (pose or datum.name[0] == "#"):
            continue
        values = list(_VALUE.finditer(datum.span.text))[-_VALUES:]
        start = offset_of(types, datum.span) + values[at].start()
        degrees = _degrees(float(values[at].group()))
        problems.warning(
            RADIANS,
            "angles are in degrees, and this looks like radians",
            start,
            start + len(values[at].group()),
            f"{values[at].group()} degrees",
            notes=("a right angle is 90 degrees, a full turn 360",),
            help=(f"write `{degrees}`",),
            fix=problems.replace(start, start + len(values[at].group()), degrees),
            data={"name": datum.name},
        )


def _warn(types: NameUses, program: str | None, angles: list[Item], where: str) -> None:
    """Warn of the first of some angles, and mend all that are in radians."""
    node = angles[0]
    problems = types.problems
    value = evaluate(node, nothing_known)
    known = value[0] == value[1]
    degrees = _degrees(value[0]) if known else ""
    written = number_written(types, program, node)
    if not known and written is not None:
        help_ = f"give it the angle in degrees: `{_degrees(float(written))}`"
    elif known:
        help_ = f"write `{degrees}`"
    else:
        help_ = "leave PI out: a full turn is 360 degrees, not 2*PI"
    given = _given_with_pi(types, program, node)
    place = node if given is None else given
    found = _FROM_DEGREES.fullmatch(problems.source.text[place.start : place.end])
    fix = Fix.from_edits(_in_degrees(types, angles)) if known else None
    if found is not None and not known:
        degrees_of = (found["before"] or found["behind"]).strip()
        help_ = f"angles are in degrees already: write `{degrees_of}`"
        fix = problems.replace(place.start, place.end, degrees_of)
    problems.warning(
        RADIANS,
        f"{where} takes degrees, and this looks like radians",
        node.start,
        node.end,
        f"{value[0]:.4g} degrees" if known else "",
        notes=("a right angle is 90 degrees, a full turn 360",),
        help=(help_,),
        secondary=(problems.label(place.start, place.end, "given here"),)
        if given is not None
        else (),
        fix=fix,
    )


def _given_with_pi(types: NameUses, program: str | None, node: Item) -> Item | None:
    """Return what a variable is given, where that holds PI, and the variable stands alone."""
    while isinstance(node, Parenthesised):
        node = node.inner
    if not isinstance(node, Name) or not has_pi(types, program, node, follow=True):
        return None
    values = types.scope.entry(program, key(node.text)).values
    return values[0] if len(values) == 1 else None


def _in_degrees(types: NameUses, angles: list[Item]) -> list[Edit]:
    """Return the edits of all angles that are written as parts of pi."""
    problems = types.problems
    edits: list[Edit] = []
    for node in angles:
        low, high = evaluate(node, nothing_known)
        written = problems.source.text[node.start : node.end].lstrip("+-")
        if low == high and (is_part_of_pi(written) or has_pi(types, None, node, follow=False)):
            edits.append(Edit(problems.span(node.start, node.end), _degrees(low)))
    return edits


def _degrees(radians: float) -> str:
    """Return an angle in degrees, whole where the digits that were left out make it so."""
    degrees = math.degrees(radians)
    whole = round(degrees)
    return f"{whole if abs(degrees - whole) < _ROUND else round(degrees, 2):g}"


def has_pi(types: NameUses, program: str | None, node: Item | None, *, follow: bool) -> bool:
    """Return whether PI is a factor, not a divisor, also in a variable only ever given so."""
    match node:
        case Name(text):
            if text.lower() == "pi":
                return True
            if not follow or text[0] in "$#" or text.lower() in types.predefined:
                return False
            values = types.scope.entry(program, key(text)).values
            return len(values) == 1 and has_pi(types, program, values[0], follow=False)
        case Parenthesised(inner) | Prefix(_, inner):
            return has_pi(types, program, inner, follow=follow)
        case Infix("/", left, _):
            return has_pi(types, program, left, follow=follow)
        case Infix("*" | "+" | "-", left, right):
            return has_pi(types, program, left, follow=follow) or has_pi(
                types, program, right, follow=follow
            )
        case _:
            return False
