"""Which functions the engine knows the value of; the rest stops a run where it is reached."""

from vrts.engine.code.values.functions import PURE
from vrts.ir.expressions import Function

_STATEFUL = frozenset(
    {
        Function.BASE,
        Function.TIME_TEXT,
        Function.TIME,
        Function.SWITCH,
        Function.STATUS,
        Function.STATE,
        Function.PRIORITY,
        Function.PENDANT,
        Function.PARAMETER,
        Function.FREE,
        Function.ERROR_TEXT,
        Function.ERROR,
        Function.DATE_TEXT,
        Function.ADC,
        Function.BITS,
        Function.DECODE,
        Function.DEFINED,
        Function.DEST,
        Function.DEST_JOINTS,
        Function.ENCODE,
        Function.HAND,
        Function.HERE,
        Function.HERE_JOINTS,
        Function.INRANGE,
        Function.LAST,
        Function.RANDOM,
        Function.SIG,
        Function.SPEED,
        Function.TAS,
        Function.CAS,
        Function.TIMER,
        Function.TOOL,
        Function.UNPACK,
    }
)


def evaluates(function: Function) -> bool:
    """Return whether the engine knows the value of a function."""
    return function in _STATEFUL or function in PURE
