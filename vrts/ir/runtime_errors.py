"""VAL's run-time errors: their words and numbers.

Numbers are those of the family as far as they are remembered [assumed, manual
language/errors#numbers].
"""

from enum import Enum
from typing import NamedTuple


class ValError(NamedTuple):
    """What the controller prints between asterisks, and what ERROR returns."""

    words: str
    number: int


class RuntimeErrorKind(Enum):
    """Every run-time error an engine may raise; `.value` has VAL's words and number."""

    UNDEFINED_VALUE = ValError("Undefined value", -401)
    ILLEGAL_VALUE = ValError("Illegal value", -402)
    ILLEGAL_ARRAY_INDEX = ValError("Illegal array index", -404)
    ILLEGAL_SIGNAL = ValError("Illegal digital signal", -405)
    UNDEFINED_PROGRAM = ValError("Undefined program or variable name", -406)
    INVALID_ARGUMENT = ValError("Invalid argument", -407)
    ARGUMENT_MISMATCH = ValError("Program argument mismatch", -408)
    ARITHMETIC_OVERFLOW = ValError("Arithmetic overflow", -409)
    NEGATIVE_SQUARE_ROOT = ValError("Negative square root", -410)
    STACK_FULL = ValError("Not enough program stack space", -413)
    DIVISION_BY_ZERO = ValError("Division by zero", -415)
    STRING_OVERFLOW = ValError("String variable overflow", -416)
    CONTROL_STRUCTURE = ValError("Control structure error", -473)
    ILLEGAL_JOINT = ValError("Illegal joint number", -609)
    OUT_OF_RANGE = ValError("Location out of range", -610)
    CANNOT_ALTER_CONFIGURATION = ValError("Straight-line motion can't alter configuration", -612)
    ILLEGAL_MOTION_FROM_HERE = ValError("Illegal motion from here", -613)
    TOO_FAR = ValError("Location too far", -617)
    TOO_CLOSE = ValError("Location too close", -618)
    JOINT_OUT_OF_RANGE = ValError("Joint {joint} out of range", -1000)  # number is -1000 - joint
    ROBOT_POWER_OFF = ValError("Robot power off", -604)
    HAND_CLOSED_TOO_FAR = ValError("Hand closed too far", -620)
    INVALID_NUMBER = ValError("Invalid number format", -457)
    PROCESS_EXECUTING = ValError("Process control program executing", -305)
    ILLEGAL_IN_PROCESS = ValError("Illegal in process control program", -306)
    # text and number assumed [manual language/reactions#returne]
    ILLEGAL_RETURNE = ValError("Illegal RETURNE", -307)
    INVALID_SWITCH = ValError("Invalid switch", -424)  # number assumed
    NOT_INSTALLED = ValError("Option not installed", -802)
