"""What a number is called, and its unit: for sentences, tables and documents."""

from typing import NamedTuple

from vrts.base.units import DEG, MM
from vrts.robots.built import AXES
from vrts.validate.identify.causes import BY_TICKS, Cause, Kind
from vrts.validate.identify.identified import Number

SHARES = (Kind.SPEEDS, Kind.SPEED, Kind.LINE_SPEED)
TIMES = (Kind.LAG, Kind.ACCELERATION, Kind.CORNERS)
ANGLES = (Kind.ZERO, Kind.HIDDEN_ZERO, Kind.TURN)
LEAST_HALF = {"deg": 1e-4, "mm": 1e-3, "ms": 1e-2, "%": 1e-4}  # no interval is told shorter


class Unit(NamedTuple):
    """A unit in which a number is told."""

    name: str
    size: float


def unit_of(kind: Kind) -> Unit:
    """Return the unit in which a number of a kind is told."""
    if kind in ANGLES:
        return Unit("deg", DEG)
    if kind in TIMES:
        return Unit("ms", 1e-3)
    if kind in SHARES or kind is Kind.RATE:
        return Unit("%", 1e-2)
    return Unit("mm", MM)


def name_of(cause: Cause) -> str:
    """Return what a number is called, for tables."""
    match cause.kind:
        case Kind.ZERO:
            return f"joint {cause.place + 1}"
        case Kind.HIDDEN_ZERO:
            return f"zero of joint {cause.place + 1}"
        case Kind.LINK:
            return f"link {cause.link} of the arm"
        case Kind.COUNTED_LINK:
            return f"link {cause.link} of the controller"
        case Kind.TOOL:
            return f"{AXES[cause.place]} of the tool"
        case Kind.BASE:
            return f"{AXES[cause.place]} of the base"
        case Kind.TURN:
            return f"turn of the base about {AXES[cause.place]}"
        case Kind.RATE:
            return "rate of the clock"
        case Kind.LAG:
            return "lag of the servos"
        case Kind.SPEEDS:
            return "all speeds"
        case Kind.SPEED:
            return f"speed of joint {cause.place + 1}"
        case Kind.LINE_SPEED:
            return "speed of lines"
        case Kind.ACCELERATION:
            return "acceleration time"
        case Kind.CORNERS:
            return "time of rounded corners"


def clause_of(number: Number) -> str:
    """Return what is wrong, as a part of a sentence."""
    cause, much, sign = number.cause, measured(number), number.value
    name = name_of(cause)
    match cause.kind:
        case Kind.ZERO:
            return f"{name} stands {much} off"
        case Kind.HIDDEN_ZERO:
            return f"joint {cause.place + 1} stands {much} off, which its encoder does not show"
        case Kind.LINK:
            return f"{name} is {much} {'longer' if sign > 0.0 else 'shorter'}"
        case Kind.COUNTED_LINK:
            way = "longer" if sign > 0.0 else "shorter"
            return f"the controller counts with a link {cause.link} that is {much} {way}"
        case Kind.TOOL:
            return f"the tool is {much} off along its {AXES[cause.place]}"
        case Kind.BASE:
            return f"the base stands {much} off along {AXES[cause.place]}"
        case Kind.TURN:
            return f"the base is turned by {much} about {AXES[cause.place]}"
        case Kind.RATE:
            return f"the clock of the log is {much} {'slow' if sign > 0.0 else 'fast'}"
        case Kind.LAG:
            return f"the servos are {much} behind"
        case Kind.SPEEDS:
            return f"all speeds are {much} {'higher' if sign > 0.0 else 'lower'}"
        case Kind.SPEED:
            return f"joint {cause.place + 1} is {much} {'faster' if sign > 0.0 else 'slower'}"
        case Kind.LINE_SPEED:
            return f"straight lines are {much} {'faster' if sign > 0.0 else 'slower'}"
        case Kind.ACCELERATION | Kind.CORNERS:
            what = "acceleration takes" if cause.kind is Kind.ACCELERATION else "corners take"
            return f"{what} {much} {'longer' if sign > 0.0 else 'less'}"


def measured(number: Number) -> str:
    """Return a number with half its interval: its size where a word tells the direction."""
    unit = unit_of(number.cause.kind)
    value = number.value if number.cause.kind in SIGNED else abs(number.value)
    half = max(number.half / unit.size, LEAST_HALF[unit.name])
    digits = decimals(half)
    if number.cause.kind in BY_TICKS and number.half == 0.0:
        digits = 2
    name = {"deg": "degrees"}.get(unit.name, unit.name)
    return f"{value / unit.size + 0.0:.{digits}f} ± {half:.{digits}f} {name}"


SIGNED = frozenset(ANGLES) | {Kind.TOOL, Kind.BASE}


def decimals(half: float) -> int:
    """Return how many decimals a number has whose interval is so long: two figures of it."""
    digits = 0
    while digits < 4 and half * 10.0**digits < 1.95:
        digits += 1
    return digits
