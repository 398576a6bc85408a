"""Instructions of the IR: a flat list per program, jumps by index.

Operands are expressions in the language's units (mm, degrees, seconds, percent). Motion settings
carry their scope. Where an instruction waits for the arm to stand still first, it says so in its
docstring as "breaks continuous path".
"""

from enum import Enum
from typing import NamedTuple, TypeAlias

from vrts.base.source import Span
from vrts.ir.expressions import Expression, Place, WholeArray


class Interpolation(Enum):
    """How a motion goes from where the arm is to its target."""

    JOINT = "joint"
    LINEAR = "linear"


class Scope(Enum):
    """How long a motion setting holds."""

    NEXT_MOTION = "next"
    ALWAYS = "always"


class SpeedUnit(Enum):
    """Unit of a program speed."""

    PERCENT = "percent"
    MM_PER_S = "mm/s"
    INCH_PER_S = "inch/s"


class HandAction(Enum):
    """What the hand is told to do."""

    OPEN = "open"
    CLOSE = "close"
    RELAX = "relax"


class BranchRequest(Enum):
    """An arm branch asked for the next joint-interpolated motion to a pose."""

    RIGHTY = "righty"
    LEFTY = "lefty"
    ABOVE = "above"
    BELOW = "below"
    FLIP = "flip"
    NOFLIP = "noflip"


# --- assignment ---------------------------------------------------------------------------------


class Assign(NamedTuple):
    """`v = e`, `$v = e`, `SET l = e`. SET converts between pose and joints where they differ."""

    place: Place
    value: Expression


class AssignHere(NamedTuple):
    """`HERE frame:part`: give the last element the value INVERSE(frame):HERE. No break."""

    place: Place
    frame: Expression | None = None


# --- motion -------------------------------------------------------------------------------------


class Move(NamedTuple):
    """MOVE, MOVES, APPRO, APPROS: to a location, or `retreat` [mm] short of it along tool -Z."""

    interpolation: Interpolation
    target: Expression
    retreat: Expression | None = None


class Depart(NamedTuple):
    """DEPART, DEPARTS: back along tool -Z [mm] from the destination of the last motion."""

    interpolation: Interpolation
    distance: Expression


class Drive(NamedTuple):
    """DRIVE: one joint (1..6) by a change [deg], at its own speed [%]; None is 100."""

    joint: Expression
    change: Expression
    speed: Expression | None = None


class Ready(NamedTuple):
    """READY: joint-interpolated to the robot's ready configuration."""


class Delay(NamedTuple):
    """DELAY: a motion to nowhere that lasts a time [s]; ends continuous path."""

    time: Expression


class Break(NamedTuple):
    """BREAK: wait until the arm stands still. Breaks continuous path."""


class SetSpeed(NamedTuple):
    """SPEED value [MMPS|IPS] [ALWAYS]."""

    value: Expression
    unit: SpeedUnit
    scope: Scope


class RequestBranch(NamedTuple):
    """RIGHTY .. NOFLIP: kept until a joint-interpolated motion does it. Breaks continuous path."""

    branch: BranchRequest


class MoveHand(NamedTuple):
    """OPEN, CLOSE, RELAX with the next motion; the I forms break, act now and wait HAND.TIME."""

    action: HandAction
    immediate: bool
    opening: Expression | None = None  # [mm], servo hands only


class SetTool(NamedTuple):
    """TOOL: pose of the tool tip in the flange frame; None is NULL. Breaks continuous path."""

    pose: Expression | None


class SetBase(NamedTuple):
    """BASE dx, dy, dz [mm], rotation [deg]: the robot was displaced. Breaks continuous path."""

    dx: Expression | None
    dy: Expression | None
    dz: Expression | None
    rotation: Expression | None


# --- control ------------------------------------------------------------------------------------


class Jump(NamedTuple):
    """Go on at an instruction index."""

    target: int


class JumpIf(NamedTuple):
    """Go on at an index when the condition, taken as true or false, equals `when`."""

    condition: Expression
    when: bool
    target: int


class BeginFor(NamedTuple):
    """Assign the first value, then evaluate and keep limit and increment of the loop."""

    place: Place
    first: Expression
    last: Expression
    increment: Expression | None
    loop: int  # index of the loop in its program


class TestFor(NamedTuple):
    """Leave the loop when the variable is past its limit.

    A loop never begun is VAL's *Control structure error*.
    """

    place: Place
    loop: int
    leave: int


class NextFor(NamedTuple):
    """Add the increment to the variable, then go on at the test."""

    place: Place
    loop: int
    test: int


class BeginCase(NamedTuple):
    """Evaluate the selector of a CASE once and keep it in the frame."""

    selector: Expression
    case: int  # index of the CASE in its program


class TestCase(NamedTuple):
    """Go on at an index when none of the values equals the selector kept."""

    case: int
    values: tuple[Expression, ...]
    otherwise: int


class Call(NamedTuple):
    """CALL: a Place or WholeArray is passed by reference, an expression by value, None is omitted.

    A Place whose type is DYNAMIC passes whatever it holds.
    """

    program: str
    arguments: tuple[Expression | Place | WholeArray | None, ...]
    program_span: Span | None = None


class Return(NamedTuple):
    """RETURN, and the end of every program."""


class Stop(NamedTuple):
    """STOP: end this execution cycle, from any depth of calls."""

    message: Expression | None = None


class Halt(NamedTuple):
    """HALT: end the execution. Breaks continuous path."""

    message: Expression | None = None


class Pause(NamedTuple):
    """PAUSE: stop, resumable at the next step. Breaks continuous path."""

    message: Expression | None = None


# --- signals and terminal -----------------------------------------------------------------------


class Signal(NamedTuple):
    """SIGNAL: turn outputs or internal signals on (positive number) or off (negative)."""

    signals: tuple[Expression, ...]


class Wait(NamedTuple):
    """WAIT: until the condition is true at a tick; None gives up the rest of this tick."""

    condition: Expression | None


class FormatKind(Enum):
    """Format controls of TYPE and $ENCODE; the value is the letter."""

    FREE = "D"
    FIXED = "F"
    INTEGER = "I"
    GENERAL = "G"
    EXPONENT = "E"
    HEX = "H"
    OCTAL = "O"
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


class Type(NamedTuple):
    """TYPE: write items; a number format holds for all later numbers of the instruction."""

    items: tuple[Expression | Format, ...]


class Unsupported(NamedTuple):
    """An instruction that the simulator knows and does not do: stops the run when reached."""

    words: str


Instruction: TypeAlias = (
    Assign
    | AssignHere
    | Move
    | Depart
    | Drive
    | Ready
    | Delay
    | Break
    | SetSpeed
    | RequestBranch
    | MoveHand
    | SetTool
    | SetBase
    | Jump
    | JumpIf
    | BeginFor
    | TestFor
    | NextFor
    | BeginCase
    | TestCase
    | Call
    | Return
    | Stop
    | Halt
    | Pause
    | Signal
    | Wait
    | Type
    | Unsupported
)
