"""Which expressions may change although no program, signal or command changes anything."""

from vrts.ir.expressions import Apply, Binary, Compose, Function, Load, Place, Unary

CLOCKS = frozenset(
    {
        Function.TIMER,
        Function.TIME,
        Function.TIME_TEXT,
        Function.DATE_TEXT,
        Function.RANDOM,
    }
)  # a loop that reads one of them may end by itself

MOVING = frozenset(
    {
        Function.HERE,
        Function.HERE_JOINTS,
        Function.HAND,
        Function.STATE,
        Function.STATUS,
    }
)  # these change while the arm or the hand moves

SWAPS = frozenset(
    {Function.TAS, Function.CAS, Function.DECODE}
)  # these change a variable when they are asked


def changes_by_itself(expression: object) -> bool:
    """Return whether an expression reads a clock, or the arm or the hand while they move."""
    match expression:
        case Apply(function=function, arguments=arguments):
            return (
                function in CLOCKS
                or function in MOVING
                or function in SWAPS
                or any(changes_by_itself(a) for a in arguments)
            )
        case Unary(operand=operand):
            return changes_by_itself(operand)
        case Binary(left=left, right=right):
            return changes_by_itself(left) or changes_by_itself(right)
        case Compose(parts=parts):
            return any(changes_by_itself(part) for part in parts)
        case Load(place=Place(subscripts=subscripts)) | Place(subscripts=subscripts):
            return any(changes_by_itself(subscript) for subscript in subscripts)
        case _:
            return False
