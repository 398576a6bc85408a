"""What a controller refuses of a number that is known, and what to write instead."""

import math
from collections.abc import Callable
from typing import NamedTuple, TypeAlias

from vrts.base.diagnostic import Rule
from vrts.base.numbers import round_half_away
from vrts.ir.ranges import (
    HIGHEST_PRIORITY,
    HIGHEST_SUBSCRIPT,
    HIGHEST_TIMER,
    INPUTS,
    INTERNAL,
    MOST_BITS,
    OUTPUTS,
)
from vrts.lang.findings.values.intervals import Interval

NO_SUCH_SIGNAL = Rule("V230", "no-such-signal")
OPERAND_RANGE = Rule("V231", "operand-range")
DIVISION_BY_ZERO = Rule("V232", "certain-division-by-zero")

JOINTS = 6
_WITH_MORE = range(1, 513)  # signals of each kind of the largest controllers of the family
_BEYOND = 1e9  # numbers from here on are not looked at

_SURE_INPUTS = range(1001, 1033)  # of V+ and AS; above them modules may be wired otherwise
_SIGNALS = "outputs are 1 to 32, inputs 1001 to 1032, internal signals 2001 to 2256"


class Complaint(NamedTuple):
    """Why a number cannot stand where it does."""

    rule: Rule
    headline: str
    note: str
    help: str
    certain: bool = False  # whether every controller refuses it, wherever it stands


Complain: TypeAlias = Callable[[Interval], Complaint | None]


def set_signal(value: Interval) -> Complaint | None:
    """SIGNAL and BITS set outputs and internal signals."""
    numbers = _numbers(value)
    if numbers is None or _any(numbers, OUTPUTS, INTERNAL) or numbers[0] == 0:
        return None
    low, high = numbers
    if low in INPUTS and high in INPUTS:
        return Complaint(
            NO_SUCH_SIGNAL,
            f"signal {_shown(low, high)} is an input; a program cannot set it",
            _SIGNALS,
            f"set an output, 1 to 32; to wait for the input write `WAIT SIG({low})`",
            certain=True,
        )
    return _no_signal(low, high, "set an output, 1 to 32, or an internal signal from 2001 on")


def set_input(value: Interval) -> Complaint | None:
    """SIGNAL and PULSE of V+ and AS; how many outputs there are differs."""
    numbers = _numbers(value)
    if numbers is None or numbers[0] not in _SURE_INPUTS or numbers[1] not in _SURE_INPUTS:
        return None
    return Complaint(
        NO_SUCH_SIGNAL,
        f"signal {_shown(*numbers)} is an input; a program cannot set it",
        "outputs are numbered from 1, inputs from 1001, internal signals from 2001",
        "set an output, a number from 1 on, or an internal signal from 2001 on",
    )


def read_signal(value: Interval) -> Complaint | None:
    """SIG and BITS read signals of every kind; 0 is none, and always on."""
    numbers = _numbers(value)
    if numbers is None or numbers[0] == 0 or _any(numbers, OUTPUTS, INPUTS, INTERNAL):
        return None
    return _no_signal(*numbers, "an input is a number from 1001 to 1032, as in `SIG(1001)`")


def watched_signal(value: Interval) -> Complaint | None:
    """REACT watches inputs and internal signals."""
    numbers = _numbers(value)
    if numbers is None or _any(numbers, INPUTS, INTERNAL):
        return None
    low, high = numbers
    help_ = "watch an input, 1001 to 1032, or an internal signal from 2001 on"
    if low in OUTPUTS and high in OUTPUTS:
        return Complaint(
            NO_SUCH_SIGNAL,
            f"signal {_shown(low, high)} is an output; it cannot be watched",
            _SIGNALS,
            help_,
            certain=True,
        )
    return _no_signal(low, high, help_)


def ignored_signal(value: Interval) -> Complaint | None:
    """IGNORE forgets what REACT watches; one that nothing watches changes nothing."""
    found = watched_signal(value)
    return found and found._replace(certain=False)


def joint(value: Interval) -> Complaint | None:
    """DRIVE turns joints 1 to 6."""
    return _outside(value, 1, JOINTS, "there is no joint {}", "joints are 1 to 6")


def timer_set(value: Interval) -> Complaint | None:
    """TIMER n = seconds."""
    return _outside(value, 1, HIGHEST_TIMER, "there is no timer {}", "timers are 1 to 15")


def timer_read(value: Interval) -> Complaint | None:
    """TIMER(n); 0 is the time since the controller was switched on."""
    return _outside(value, 0, HIGHEST_TIMER, "there is no timer {}", "timers are 1 to 15")


def bits_count(value: Interval) -> Complaint | None:
    """BITS takes so many signals at once."""
    headline = "BITS cannot take {} signals at once"
    return _outside(value, 1, MOST_BITS, headline, "write a number of signals from 1 to 16")


def priority(value: Interval) -> Complaint | None:
    """LOCK takes the priority of a reaction."""
    return _outside(
        value, 0, HIGHEST_PRIORITY, "there is no priority {}", "priorities are 0 to 127"
    )


def reaction(value: Interval) -> Complaint | None:
    """REACT gives a reaction its priority."""
    return _outside(
        value,
        1,
        HIGHEST_PRIORITY,
        "a reaction cannot have the priority {}",
        "priorities of reactions are 1 to 127",
    )


def subscript(value: Interval) -> Complaint | None:
    """Index of an array."""
    headline = "an index cannot be {}"
    return _outside(value, 0, HIGHEST_SUBSCRIPT, headline, "the first element has index 0")


def root(value: Interval) -> Complaint | None:
    """SQRT of a negative number."""
    if value[1] >= 0.0 or math.isinf(value[1]):
        return None
    return Complaint(
        OPERAND_RANGE,
        f"there is no root of a negative number, {value[1]:g}",
        "VAL-II says *Negative square root*",
        "make sure that it is positive, by ABS or by IF",
    )


def divisor(value: Interval) -> Complaint | None:
    """What something is divided by."""
    if value != (0.0, 0.0):
        return None
    return Complaint(
        DIVISION_BY_ZERO,
        "this divides by zero",
        "VAL-II says *Division by zero*",
        "divide by a number other than 0, or ask before: `IF n <> 0 THEN`",
    )


def _outside(value: Interval, low: int, high: int, headline: str, help_: str) -> Complaint | None:
    if not (abs(value[0]) < _BEYOND and abs(value[1]) < _BEYOND):
        return None
    first, last = round_half_away(value[0]), round_half_away(value[1])
    if first <= high and last >= low:
        return None
    return Complaint(
        OPERAND_RANGE,
        headline.format(_shown(first, last)),
        "the controller stops here",
        help_,
        certain=True,
    )


def _numbers(value: Interval) -> tuple[int, int] | None:
    """Return the lowest and highest number of a signal; its sign says on or off."""
    low, high = value
    if not (abs(low) < _BEYOND and abs(high) < _BEYOND) or low < 0.0 < high:
        return None
    ends = sorted((abs(round_half_away(low)), abs(round_half_away(high))))
    return ends[0], ends[1]


def _any(numbers: tuple[int, int], *allowed: range) -> bool:
    low, high = numbers
    return any(low < some.stop and high >= some.start for some in allowed)


def _no_signal(low: int, high: int, help_: str) -> Complaint:
    larger = any(low % 1000 in _WITH_MORE and low // 1000 == kind for kind in (0, 1, 2))
    return Complaint(
        NO_SUCH_SIGNAL,
        f"there is no signal {_shown(low, high)}",
        _SIGNALS,
        help_,
        certain=not larger,
    )


def _shown(low: int, high: int) -> str:
    return str(low) if low == high else f"{low} to {high}"
