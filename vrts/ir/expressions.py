"""Expressions of the IR. Lengths in mm, angles in degrees, as the language has them.

Evaluated left to right; both operands of a logical operator are always evaluated.
"""

from enum import Enum
from typing import NamedTuple, TypeAlias

from vrts.base.source import Span
from vrts.ir.values import Type, Value


class Global(NamedTuple):
    """A variable of the controller's memory, alive between programs."""

    name: str  # lower case, at most 15 characters, with its sigil: "pick", "$msg", "#safe"
    type: Type


class Slot(NamedTuple):
    """A formal argument: a slot of the frame that holds a value or a reference to a cell."""

    number: int
    name: str  # as Global.name
    type: Type


Variable: TypeAlias = Global | Slot


class Place(NamedTuple):
    """Something that can be read and assigned: a scalar, or an element of an array."""

    variable: Variable
    subscripts: "tuple[Expression, ...]" = ()  # rounded to integers when used
    span: Span | None = None


class Constant(NamedTuple):
    """A value known at compile time."""

    value: Value
    span: Span | None = None


class Load(NamedTuple):
    """The value of a variable. Reading one without a value is VAL's *Undefined value*."""

    place: Place


class Unary(NamedTuple):
    """An operator with one operand."""

    operator: "UnaryOperator"
    operand: "Expression"
    span: Span | None = None


class Binary(NamedTuple):
    """An operator with two operands."""

    operator: "BinaryOperator"
    left: "Expression"
    right: "Expression"
    span: Span | None = None


class Apply(NamedTuple):
    """A function of the language. An omitted operand is None; DEFINED and its like take a Place.

    $ENCODE also takes formats; SWITCH and PARAMETER take a name as a string constant.
    """

    function: "Function"
    arguments: "tuple[Argument, ...]" = ()
    span: Span | None = None


class Compose(NamedTuple):
    """A compound location `a:b:c`, composed left to right."""

    parts: "tuple[Expression, ...]"
    span: Span | None = None


class FormatKind(Enum):
    """Format controls of TYPE and $ENCODE; the value is the letter."""

    FREE = "D"
    FIXED = "F"
    INTEGER = "I"
    GENERAL = "G"
    EXPONENT = "E"
    HEX = "H"
    OCTAL = "O"
    HEX_FILLED = "J"  # AS: hexadecimal with leading zeros
    DECIMAL_FILLED = "K"  # AS: decimal with leading zeros
    TIGHT = "L"  # AS: as D, without the blank before it
    NEWLINE = "C"
    BLANK = "X"
    UP = "U"
    BELL = "B"
    STAY = "S"


class Format(NamedTuple):
    """`/F8.2`, `/C2`, `/S`."""

    kind: FormatKind
    width: int | None = None
    decimals: int | None = None


class WholeArray(NamedTuple):
    """An array passed whole, `a[]`."""

    variable: Variable
    span: Span | None = None


Expression: TypeAlias = Constant | Load | Unary | Binary | Apply | Compose
Argument: TypeAlias = Expression | Place | WholeArray | Format | None


class UnaryOperator(Enum):
    """Operators with one operand."""

    MINUS = "-"
    NOT = "not"
    COM = "com"


class BinaryOperator(Enum):
    """Operators with two operands. `+` and the comparisons also take two strings."""

    ADD = "+"
    SUBTRACT = "-"
    MULTIPLY = "*"
    DIVIDE = "/"
    MOD = "mod"
    POWER = "**"  # AS, and V+ as far as programs use it
    EQUAL = "=="
    NOT_EQUAL = "<>"
    LESS = "<"
    LESS_EQUAL = "<="
    GREATER = ">"
    GREATER_EQUAL = ">="
    AND = "and"
    OR = "or"
    XOR = "xor"
    BAND = "band"
    BOR = "bor"
    BXOR = "bxor"


class Function(Enum):
    """Functions of the language; the value is the name in a text dump."""

    # reals
    ABS = "abs"
    ATAN2 = "atan2"
    COS = "cos"
    SIN = "sin"
    TAN = "tan"
    FRACT = "fract"
    INT = "int"
    ROUND = "round"  # AS: halves away from zero
    MAX = "max"
    MIN = "min"
    OUTSIDE = "outside"
    RANDOM = "random"
    SIGN = "sign"
    SQR = "sqr"
    SQRT = "sqrt"
    BCD = "bcd"
    DCB = "dcb"
    # locations
    DISTANCE = "distance"
    DX = "dx"
    DY = "dy"
    DZ = "dz"
    DEXT = "dext"  # AS: element 1 to 7 of a location, plain Z Y' Z'' angles or joints [deg]
    TRANS = "trans"  # x, y, z [mm], o, a, t [deg]
    TRANS_ZYZ = "trans.zyz"  # x, y, z [mm], plain Z Y' Z'' angles [deg]: V+ and AS
    NULL = "null"
    INVERSE = "inverse"
    NORMAL = "normal"
    FRAME = "frame"
    SHIFT = "shift"  # pose, dx, dy, dz [mm] in world axes
    SCALE = "scale"
    RX = "rx"
    RY = "ry"
    RZ = "rz"
    IDENTICAL = "identical"
    PPOINT = "#ppoint"  # six joints [deg]
    # state of the robot and the controller
    HERE = "here"
    DEST = "dest"
    HERE_JOINTS = "#here"
    DEST_JOINTS = "#dest"
    BASE = "base"
    TOOL = "tool"
    INRANGE = "inrange"
    HAND = "hand"
    SIG = "sig"
    BITS = "bits"
    TIMER = "timer"
    SPEED = "speed"
    DEFINED = "defined"
    LAST = "last"
    TAS = "tas"  # old value of a variable, which then takes another
    CAS = "cas"  # old value of a variable, which takes another if it was a third
    SWITCH = "switch"
    PARAMETER = "parameter"
    ADC = "adc"
    PENDANT = "pendant"
    PRIORITY = "priority"
    STATE = "state"
    STATUS = "status"
    ERROR = "error"
    FREE = "free"
    TIME = "time"
    # strings
    ASC = "asc"
    CHR = "$chr"
    LEN = "len"
    MID = "$mid"
    POS = "pos"
    INSTR = "instr"  # AS: as POS, whatever the case of letters
    RIGHT = "$right"  # AS
    SPACE = "$space"  # AS
    VAL = "val"
    STRDIF = "strdif"  # -1, 0 or 1: how two strings are sorted
    ENCODE = "$encode"
    DECODE = "$decode"
    TRUNCATE = "$truncate"
    UNPACK = "$unpack"
    ERROR_TEXT = "$error"
    TIME_TEXT = "$time"
    DATE_TEXT = "$date"
    # known, never carried out
    OPAQUE = "opaque"  # its first argument is the name of the function
