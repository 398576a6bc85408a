"""Numbers as the controller keeps them: IEEE single precision, rounded once per operation."""

import math
import struct

_SINGLE = struct.Struct("<f")  # standard layout: packing what is too large raises

LARGEST_SINGLE = 3.4028234663852886e38
LARGEST_EXACT_INTEGER = 16_777_215  # 24-bit mantissa


def single(value: float) -> float:
    """Return the nearest single-precision number, as a Python float.

    Raises:
        OverflowError: The value is beyond single precision, infinite, or not a number.
    """
    if value - value != 0.0:  # infinity or NaN
        raise OverflowError
    return _SINGLE.unpack(_SINGLE.pack(value))[0]


def round_half_away(value: float) -> int:
    """Return the nearest integer.

    Halves go away from zero [assumed, manual language/numbers#rounding].
    """
    return math.floor(value + 0.5) if value >= 0 else math.ceil(value - 0.5)
