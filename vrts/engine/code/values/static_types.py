"""Which type an expression is known to have before it is evaluated."""

from vrts.ir.expressions import (
    Apply,
    Binary,
    BinaryOperator,
    Compose,
    Constant,
    Expression,
    Function,
    Load,
    Unary,
)
from vrts.ir.values import Type, type_of_value

LOCATIONS = frozenset(
    {
        Function.TRANS,
        Function.TRANS_ZYZ,
        Function.NULL,
        Function.INVERSE,
        Function.NORMAL,
        Function.FRAME,
        Function.SHIFT,
        Function.SCALE,
        Function.RX,
        Function.RY,
        Function.RZ,
        Function.HERE,
        Function.DEST,
        Function.BASE,
        Function.TOOL,
    }
)
NOT_KNOWN = frozenset({Function.OPAQUE, Function.TAS, Function.CAS})


def static_type(expression: Expression) -> Type | None:
    """Return the type that an expression has whenever it has a value; None when that is open."""
    match expression:
        case Constant(value=value):
            return type_of_value(value)
        case Load(place=place):
            known = place.variable.type
            return None if known is Type.DYNAMIC else known
        case Unary():
            return Type.REAL
        case Binary(operator=BinaryOperator.ADD, left=left, right=right):
            found = {static_type(left), static_type(right)} - {None}
            return found.pop() if len(found) == 1 else None
        case Binary():
            return Type.REAL
        case Compose():
            return Type.POSE
        case Apply(function=function):
            if function in NOT_KNOWN:
                return None
            if function in LOCATIONS:
                return Type.POSE
            if function.value.startswith("#"):
                return Type.JOINTS
            return Type.STRING if function.value.startswith("$") else Type.REAL


def of_reals(expression: Binary) -> bool:
    """Return whether both operands are known to be reals."""
    return static_type(expression.left) is Type.REAL and static_type(expression.right) is Type.REAL
