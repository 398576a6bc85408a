"""Numbers, conditions and locations as expressions of URScript.

Lengths are in mm and angles in degrees, as in the program; what is given to UR is turned there.
Locations are poses of URScript in the frame that VAL-II counts in.
"""

import math

from vrts.base.pose import Pose, Rotation
from vrts.dispatch.saying.cannot import CannotSay
from vrts.dispatch.saying.names import decimal, plain, printed
from vrts.dispatch.saying.parts import constant
from vrts.dispatch.saying.signals import FIRST_INPUT, FIRST_INTERNAL, bits_of, signal_of
from vrts.dispatch.saying.table import Table
from vrts.dispatch.saying.timers import timer_of
from vrts.ir.expressions import (
    Apply,
    Argument,
    Binary,
    BinaryOperator,
    Compose,
    Constant,
    Function,
    Load,
    Place,
    Slot,
    Unary,
    UnaryOperator,
    Variable,
)
from vrts.ir.values import Type

COMPARISONS = {
    BinaryOperator.EQUAL: "==",
    BinaryOperator.NOT_EQUAL: "!=",
    BinaryOperator.LESS: "<",
    BinaryOperator.LESS_EQUAL: "<=",
    BinaryOperator.GREATER: ">",
    BinaryOperator.GREATER_EQUAL: ">=",
}
LOGIC = {BinaryOperator.AND: "and", BinaryOperator.OR: "or", BinaryOperator.XOR: "xor"}
ARITHMETIC = {
    BinaryOperator.ADD: "+",
    BinaryOperator.SUBTRACT: "-",
    BinaryOperator.MULTIPLY: "*",
    BinaryOperator.DIVIDE: "/",
}
ANGLES = {Function.SIN: "sin", Function.COS: "cos", Function.TAN: "tan"}
PART = {Function.DX: 0, Function.DY: 1, Function.DZ: 2}
HERE = "v_at"
JOINTS_HERE = "get_target_joint_positions()"
NOTHING = "p[0.0, 0.0, 0.0, 0.0, 0.0, 0.0]"
SIX = 6
_LETTER = {Type.REAL: "n", Type.POSE: "at", Type.JOINTS: "j", Type.STRING: "s"}


def number(value: float) -> str:
    """Return a number with a decimal point: URScript does not say how it divides whole ones."""
    text = decimal(value)
    return text if "." in text else f"{text}.0"


def rotation_vector(turn: Rotation) -> tuple[float, float, float]:
    """Return axis times angle [rad], by the quaternion, so that half turns are exact too."""
    a, b, c, d, e, f, g, h, i = turn
    squares = (1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i)
    k = max(range(4), key=lambda n: squares[n])
    rows = (
        (squares[0], h - f, c - g, d - b),
        (h - f, squares[1], b + d, c + g),
        (c - g, b + d, squares[2], f + h),
        (d - b, c + g, f + h, squares[3]),
    )
    w, *axis = rows[k]
    if w < 0.0:
        w, axis = -w, [-part for part in axis]
    length = math.hypot(*axis)
    if length == 0.0:
        return (0.0, 0.0, 0.0)
    angle = 2.0 * math.atan2(length, w)
    x, y, z = (angle * part / length for part in axis)
    return (x, y, z)


def pose_text(pose: Pose) -> str:
    """Return a pose that is known, in metres and radians."""
    parts = (*pose.translation, *rotation_vector(pose.rotation))
    return f"p[{', '.join(map(number, parts))}]"


def joints_text(joints: tuple[float, ...]) -> str:
    """Return six joints in radians."""
    return f"[{', '.join(map(number, joints))}]"


def name_of(variable: Variable) -> str:
    """Return the name of a variable."""
    if isinstance(variable, Slot):
        return f"own_{plain(variable.name)}"
    if variable.type not in _LETTER:
        raise CannotSay(f"`{variable.name}` may be of any kind", "give it one")
    return f"{_LETTER[variable.type]}_{plain(variable.name)}"


class Values:
    """Writes what the steps of a program work out."""

    def __init__(self, table: Table, here: str = HERE) -> None:
        """Know which input is which signal, and what tells where the arm rests."""
        self.table, self.here = table, here

    def place(self, place: Place) -> str:
        """Return a variable, or an element of a list."""
        if not place.subscripts:
            return name_of(place.variable)
        kind = place.variable.type
        if isinstance(place.variable, Slot):
            raise CannotSay("URScript passes copies of arrays", "use an array of all programs")
        if kind is Type.JOINTS:
            raise CannotSay("URScript reads a list of joints as a matrix", "use variables")
        subscript, *others = place.subscripts
        if others:
            raise CannotSay(f"`{place.variable.name}` has two subscripts", "use one")
        at = constant(subscript)
        index = f"v_index({self.real(subscript)})" if at is None else str(round(at))
        return f"{name_of(place.variable)}[{index}]"

    def string(self, e: Argument) -> str:
        """Return a string: one that stands in the text, or that a variable holds."""
        match e:
            case Constant(str(text)):
                words = printed(text).replace('"', "'").replace("\n", " ")
                return f'"{words}"'
            case Load(place) if not place.subscripts and place.variable.type is Type.STRING:
                return self.place(place)
            case _:
                raise CannotSay("URScript's strings are only kept and told", "do without")

    def is_string(self, e: Argument) -> bool:
        """Return whether an expression is a string."""
        match e:
            case Constant(value):
                return isinstance(value, str)
            case Load(place):
                return place.variable.type is Type.STRING
            case Apply(function):
                return function.value.startswith("$")
            case _:
                return False

    def real(self, e: Argument) -> str:
        """Return a number."""
        match e:
            case Constant(float(value)):
                return number(value)
            case Load(place):
                return self.place(place)
            case Unary(UnaryOperator.MINUS, operand):
                return f"(-{self.real(operand)})"
            case Binary(operator, left, right) if operator in ARITHMETIC:
                return f"({self.real(left)} {ARITHMETIC[operator]} {self.real(right)})"
            case Binary(BinaryOperator.MOD, left, right):
                one, other = self.real(left), self.real(right)
                return f"({one} - {other} * v_int({one} / {other}))"
            case Unary(UnaryOperator.NOT) | Binary() | Apply(Function.SIG):
                return f"v_real({self.condition(e)})"
            case Apply(function, arguments):
                return self._apply(function, arguments)
            case _:
                raise CannotSay("URScript has nothing that means this")

    def condition(self, e: Argument) -> str:
        """Return True or False."""
        match e:
            case Binary(operator, left, right) if operator in COMPARISONS:
                return f"({self.real(left)} {COMPARISONS[operator]} {self.real(right)})"
            case Binary(operator, left, right) if operator in LOGIC:
                return f"({self.condition(left)} {LOGIC[operator]} {self.condition(right)})"
            case Unary(UnaryOperator.NOT, operand):
                return f"(not {self.condition(operand)})"
            case Apply(Function.SIG, arguments):
                return f"({' and '.join(self._signal(a) for a in arguments)})"
            case Binary(operator) if operator not in (*ARITHMETIC, BinaryOperator.MOD):
                raise CannotSay(f"URScript has nothing that means {operator.value.upper()}")
            case _:
                return f"({self.real(e)} != 0.0)"

    def _signal(self, e: Argument) -> str:
        signal, on = signal_of(e)
        if signal >= FIRST_INTERNAL:
            read = f"signal_{signal}"
        elif signal >= FIRST_INPUT:
            read = f"get_standard_digital_in({self.table.input(signal)})"
        else:
            read = f"out_{signal}"  # what the program has set
        return read if on else f"(not {read})"

    def _apply(self, function: Function, arguments: tuple[Argument, ...]) -> str:
        if function in PART:
            return f"(1000.0 * v_part({self.location(arguments[0])}, {PART[function]}))"
        if function is Function.DISTANCE:
            one, other = (self.location(argument) for argument in arguments)
            return f"v_distance({one}, {other})"
        if function is Function.BITS:
            each = (
                f"{2.0**k} * v_real({self._signal(Constant(float(signal)))})"
                for k, signal in enumerate(bits_of(*(*arguments, None)[:2]))
            )
            return f"(-({' + '.join(each)}))"
        if function is Function.TIMER:
            timer = timer_of(arguments[0])
            return "v_clock()" if timer == 0 else f"(v_clock() - timer_{timer})"
        values = [self.real(argument) for argument in arguments]
        if function in ANGLES:
            return f"{ANGLES[function]}(v_rad * {values[0]})"
        match function:
            case Function.ABS:
                return f"norm({values[0]})"
            case Function.SQRT:
                return f"sqrt({values[0]})"
            case Function.SQR:
                return f"({values[0]} * {values[0]})"
            case Function.INT:
                return f"v_int({values[0]})"
            case Function.SIGN:
                return f"v_sign({values[0]})"
            case Function.FRACT:
                return f"({values[0]} - v_int({values[0]}))"
            case Function.MAX | Function.MIN if values:
                return _largest(values, least=function is Function.MIN)
            case Function.ATAN2:
                return f"(atan2({values[0]}, {values[1]}) / v_rad)"
            case _:
                raise CannotSay(f"URScript has nothing that means {function.value.upper()}")

    def is_joints(self, e: Argument) -> bool:
        """Return whether a location is six joints."""
        match e:
            case Load(place):
                return place.variable.type is Type.JOINTS
            case Constant(value):
                return isinstance(value, tuple) and not isinstance(value, Pose)
            case Apply(function):
                return function in (Function.PPOINT, Function.HERE_JOINTS, Function.DEST_JOINTS)
            case _:
                return False

    def location(self, e: Argument) -> str:
        """Return a location: a pose, or six joints."""
        match e:
            case Load(place):
                return self.place(place)
            case Constant(Pose() as pose):
                return pose_text(pose)
            case Constant(tuple(joints)):
                return joints_text(joints)
            case Compose((first, *others)):
                text = self.location(first)
                for other in others:
                    text = f"pose_trans({text}, {self.location(other)})"
                return text
            case Apply(function, arguments):
                return self._located(function, arguments)
            case _:
                raise CannotSay("URScript has nothing that means this location")

    def _located(self, function: Function, arguments: tuple[Argument, ...]) -> str:
        given = [*arguments, *(None for _ in range(SIX))]
        match function:
            case Function.HERE:
                return self.here
            case Function.HERE_JOINTS:
                return JOINTS_HERE
            case Function.DEST:
                return HERE
            case Function.NULL:
                return NOTHING
            case Function.INVERSE:
                return f"pose_inv({self.location(arguments[0])})"
            case Function.SHIFT:
                by = ", ".join(map(self._or_zero, given[1:4]))
                return f"pose_trans(v_shift({by}), {self.location(arguments[0])})"
            case Function.TRANS:
                x, y, z, o, a, t = map(self._or_zero, given[:SIX])
                return f"v_trans({x}, {y}, {z}, ({o} - 90.0), ({a} + 90.0), {t})"
            case Function.TRANS_ZYZ:
                return f"v_trans({', '.join(map(self._or_zero, given[:SIX]))})"
            case Function.FRAME:
                places = ", ".join(map(self.location, arguments))
                return f"v_frame({places})"
            case Function.PPOINT:
                angles = (f"v_rad * {self._or_zero(item)}" for item in given[:SIX])
                return f"[{', '.join(angles)}]"
            case _:
                raise CannotSay(f"URScript has nothing that means {function.value.upper()}")

    def _or_zero(self, e: Argument) -> str:
        return "0.0" if e is None else self.real(e)


def _largest(values: list[str], *, least: bool) -> str:
    first, *others = [f"(-{value})" for value in values] if least else values
    for other in others:
        first = f"v_max({first}, {other})"
    return f"(-{first})" if least else first
