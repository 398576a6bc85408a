"""Functions of the language on values; lengths in mm and angles in degrees, as programs see them.

A component taken from a location and every real result is rounded once to single precision. Poses
and joints stay double.
"""

import math
import re
from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

from vrts.base.numbers import round_half_away
from vrts.base.oat import (
    known_components,
    plain_angles,
    pose_from_components,
    rotation_from_oat,
)
from vrts.base.pose import (
    IDENTITY,
    X_AXIS,
    Y_AXIS,
    Z_AXIS,
    Pose,
    Rotation,
    add,
    cross,
    distance,
    dot,
    rotation_about,
    scale,
    subtract,
)
from vrts.base.source import Span
from vrts.base.units import DEG, MM, deg, mm
from vrts.engine.code.values.arithmetic import checked_string, integer, logical, rounded
from vrts.engine.faults import RuntimeFault
from vrts.ir.expressions import Function
from vrts.ir.runtime_errors import RuntimeErrorKind
from vrts.ir.values import Value

Arguments = Sequence[Value | None]

MAX_BLANKS = 255  # of $SPACE [assumed]; longer strings are refused where they are kept
_ELEMENTS = 7  # of a location of AS: six, and an axis more
COLLINEAR = 1e-9  # [m] points of a FRAME nearer than this to one line are refused


def _real(arguments: Arguments, k: int, default: float = 0.0) -> float:
    value = arguments[k] if k < len(arguments) else None
    return default if value is None else value  # type: ignore[return-value]


def _pose(arguments: Arguments, k: int) -> Pose:
    value = arguments[k]
    assert isinstance(value, Pose)
    return value


def _text(arguments: Arguments, k: int) -> str:
    value = arguments[k]
    assert isinstance(value, str)
    return value


def bad(headline: str, span: Span | None) -> RuntimeFault:
    """Return the fault of an argument that a function cannot take."""
    return RuntimeFault(RuntimeErrorKind.INVALID_ARGUMENT, headline, span)


def _trans(a: Arguments, span: Span | None) -> Pose:
    """TRANS.

    With all three angles omitted the orientation is identity [assumed, manual
    language/locations#trans].
    """
    x, y, z = (_real(a, k) for k in range(3))
    if all(k >= len(a) or a[k] is None for k in (3, 4, 5)):
        return Pose(IDENTITY.rotation, (x * MM, y * MM, z * MM))
    return pose_from_components(x, y, z, _real(a, 3), _real(a, 4), _real(a, 5))


def _trans_zyz(a: Arguments, span: Span | None) -> Pose:
    """TRANS of V+ and AS: plain Z Y' Z'' angles [manual language/locations#yaw-pitch-roll]."""
    x, y, z, yaw, pitch, roll = (_real(a, k) for k in range(6))
    return pose_from_components(x, y, z, yaw + 90.0, pitch - 90.0, roll)


def _frame(a: Arguments, span: Span | None) -> Pose:
    """FRAME: x along the first two points, y towards the third, origin at the fourth."""
    p1, p2, p3, origin = (_pose(a, k).translation for k in range(4))
    along = subtract(p2, p1)
    normal = cross(along, subtract(p3, p1))
    length, height = math.sqrt(dot(along, along)), math.sqrt(dot(normal, normal))
    if length < COLLINEAR or height < COLLINEAR * length:
        raise RuntimeFault(
            RuntimeErrorKind.ILLEGAL_VALUE, "the points of FRAME lie on one line", span
        )
    x, z = scale(along, 1.0 / length), scale(normal, 1.0 / height)
    y = cross(z, x)
    turn: Rotation = (x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2])
    return Pose(turn, origin)


def _shift(a: Arguments, span: Span | None) -> Pose:
    pose = _pose(a, 0)
    offset = (_real(a, 1) * MM, _real(a, 2) * MM, _real(a, 3) * MM)
    return Pose(pose.rotation, add(pose.translation, offset))


def _sqrt(a: Arguments, span: Span | None) -> float:
    value = _real(a, 0)
    if value < 0.0:
        raise RuntimeFault(
            RuntimeErrorKind.NEGATIVE_SQUARE_ROOT, "square root of a negative number", span
        )
    return rounded(math.sqrt(value), span)


def _bcd(a: Arguments, span: Span | None) -> float:
    return float(int(str(integer(_real(a, 0), span, 0, 9999, "number")), 16))


def _dcb(a: Arguments, span: Span | None) -> float:
    digits = f"{integer(_real(a, 0), span, 0, 0xFFFF, 'number'):x}"
    if not digits.isdecimal():
        raise RuntimeFault(RuntimeErrorKind.ILLEGAL_VALUE, "a group of four bits is above 9", span)
    return float(digits)


def _atan2(a: Arguments, span: Span | None) -> float:
    return rounded(deg(math.atan2(_real(a, 0), _real(a, 1))), span)


def _sine(a: Arguments, span: Span | None) -> float:
    return rounded(rotation_from_oat(_real(a, 0), 0.0, 0.0)[2], span)  # exact at right angles


def _cosine(a: Arguments, span: Span | None) -> float:
    return rounded(-rotation_from_oat(_real(a, 0), 0.0, 0.0)[5], span)


def _tangent(a: Arguments, span: Span | None) -> float:
    cosine = _cosine(a, span)
    if cosine == 0.0:
        raise RuntimeFault(RuntimeErrorKind.DIVISION_BY_ZERO, "tangent of a right angle", span)
    return rounded(math.tan(_real(a, 0) * DEG), span)


def _asc(a: Arguments, span: Span | None) -> float:
    text, place = _text(a, 0), max(round_half_away(_real(a, 1, 1.0)), 1)
    return float(ord(text[place - 1]) & 0xFF) if place <= len(text) else -1.0


def _mid(a: Arguments, span: Span | None) -> str:
    text, first = _text(a, 0), round_half_away(_real(a, 1, 1.0))
    if first < 1:
        return ""
    if len(a) < 3 or a[2] is None:
        return text[first - 1 :]
    return text[first - 1 : first - 1 + max(round_half_away(_real(a, 2)), 0)]


def _pos(a: Arguments, span: Span | None) -> float:
    start = max(round_half_away(_real(a, 2, 1.0)), 1)
    return float(_text(a, 0).find(_text(a, 1), start - 1) + 1)


def _instr(a: Arguments, span: Span | None) -> float:
    """INSTR of AS [AS2015] 9-14."""
    start = max(round_half_away(_real(a, 2, 1.0)), 1)
    return float(_text(a, 0).lower().find(_text(a, 1).lower(), start - 1) + 1)


def _right(a: Arguments, span: Span | None) -> str:
    text, count = _text(a, 0), max(round_half_away(_real(a, 1)), 0)
    return text[max(len(text) - count, 0) :]


def _space(a: Arguments, span: Span | None) -> str:
    return " " * integer(_real(a, 0), span, 0, MAX_BLANKS, "number of blanks")


def _dext(a: Arguments, span: Span | None) -> float:
    """DEXT of AS: the seventh element is an axis that the arm does not have."""
    location, element = a[0], integer(_real(a, 1), span, 1, _ELEMENTS, "element")
    if isinstance(location, Pose):
        x, y, z, *turns = known_components(location)
        values = (x, y, z, *plain_angles(*turns), 0.0)
    else:
        values = (*map(deg, location), 0.0)  # type: ignore[arg-type]
    return rounded(values[element - 1], span)


def number_at_start(text: str) -> tuple[float, int] | None:
    """Return the number that a text begins with and how long it is; None when there is none."""
    based = re.match(r"([-+]?)\^(?:[hH]([0-9a-fA-F]+)|[bB]([01]+)|([0-7]+))", text)
    if based:
        sign, hexadecimal, binary, octal = based.groups()
        value = float(
            int(hexadecimal, 16) if hexadecimal else int(binary, 2) if binary else int(octal, 8)
        )
        return (-value if sign == "-" else value), based.end()
    plain = re.match(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text)
    return (float(plain.group()), plain.end()) if plain else None


def _val(a: Arguments, span: Span | None) -> float:
    """VAL: the number at the start of a string, 0 when there is none."""
    found = number_at_start(_text(a, 0).lstrip())
    return rounded(found[0], span) if found else 0.0


def _chr(a: Arguments, span: Span | None) -> str:
    return chr(integer(_real(a, 0), span, 0, 255, "character code"))


def _ppoint(a: Arguments, span: Span | None) -> Value:
    j1, j2, j3, j4, j5, j6 = (_real(a, k) * DEG for k in range(6))
    return (j1, j2, j3, j4, j5, j6)


def _identical(a: Arguments, span: Span | None) -> float:
    return logical(a[0] == a[1])


def _outside(a: Arguments, span: Span | None) -> float:
    return logical(not _real(a, 0) <= _real(a, 1) <= _real(a, 2))


def _component(k: int) -> "Pure":
    return lambda a, span: rounded(known_components(_pose(a, 0))[k], span)


def _turn(axis: tuple[float, float, float]) -> "Pure":
    return lambda a, span: Pose(rotation_about(axis, _real(a, 0) * DEG), IDENTITY.translation)


Pure = Callable[[Arguments, "Span | None"], Value]

PURE: Mapping[Function, Pure] = MappingProxyType(
    {
        Function.ABS: lambda a, s: abs(_real(a, 0)),
        Function.ATAN2: _atan2,
        Function.COS: _cosine,
        Function.SIN: _sine,
        Function.TAN: _tangent,
        Function.FRACT: lambda a, s: rounded(math.fmod(_real(a, 0), 1.0), s),
        Function.INT: lambda a, s: float(math.trunc(_real(a, 0))),
        Function.ROUND: lambda a, s: float(round_half_away(_real(a, 0))),
        Function.MAX: lambda a, s: max(_real(a, k) for k in range(len(a))),
        Function.MIN: lambda a, s: min(_real(a, k) for k in range(len(a))),
        Function.OUTSIDE: _outside,
        Function.SIGN: lambda a, s: 1.0 if _real(a, 0) >= 0.0 else -1.0,
        Function.SQR: lambda a, s: rounded(_real(a, 0) * _real(a, 0), s),
        Function.SQRT: _sqrt,
        Function.BCD: _bcd,
        Function.DCB: _dcb,
        Function.DISTANCE: lambda a, s: rounded(
            mm(distance(_pose(a, 0).translation, _pose(a, 1).translation)), s
        ),
        Function.DX: _component(0),
        Function.DY: _component(1),
        Function.DZ: _component(2),
        Function.DEXT: _dext,
        Function.TRANS: _trans,
        Function.TRANS_ZYZ: _trans_zyz,
        Function.TRUNCATE: lambda a, s: _text(a, 0).partition("\0")[0],
        Function.NULL: lambda a, s: IDENTITY,
        Function.INVERSE: lambda a, s: _pose(a, 0).inverse(),
        Function.NORMAL: lambda a, s: _pose(a, 0),  # no errors of rounding add up here
        Function.FRAME: _frame,
        Function.SHIFT: _shift,
        Function.SCALE: lambda a, s: Pose(
            _pose(a, 0).rotation, scale(_pose(a, 0).translation, _real(a, 1))
        ),
        Function.RX: _turn(X_AXIS),
        Function.RY: _turn(Y_AXIS),
        Function.RZ: _turn(Z_AXIS),
        Function.IDENTICAL: _identical,
        Function.PPOINT: _ppoint,
        Function.ASC: _asc,
        Function.CHR: _chr,
        Function.LEN: lambda a, s: float(len(_text(a, 0))),
        Function.MID: lambda a, s: checked_string(_mid(a, s), s),
        Function.POS: _pos,
        Function.INSTR: _instr,
        Function.RIGHT: _right,
        Function.SPACE: lambda a, s: checked_string(_space(a, s), s),
        Function.VAL: _val,
        Function.STRDIF: lambda a, s: float(
            (_text(a, 0) > _text(a, 1)) - (_text(a, 0) < _text(a, 1))
        ),
    }
)
"""Functions whose result depends on their arguments only."""
