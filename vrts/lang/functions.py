"""Functions and constants of the language: what they take and what they yield.

Signatures: `r` real, `s` string, `p` pose, `l` location (pose or precision point), `v` a variable
or whole array, `$` a string variable, `f` a format or any value. `?` may be left out or omitted,
`*` any number of these, at least none. Before BY stands what comes first.
"""

from typing import NamedTuple

from vrts.ir.expressions import Function
from vrts.ir.values import Type


class Signature(NamedTuple):
    """How a function is applied. `function` is None for one that is not supported yet."""

    name: str  # lower case, with its sigil
    function: Function | None
    parameters: tuple[str, ...]
    result: Type
    by: int | None = None  # how many arguments stand before BY
    bare: bool = False  # may be written without parentheses
    required: int = 0

    @property
    def most(self) -> int | None:
        """Largest number of arguments; None is any number."""
        repeated = bool(self.parameters) and self.parameters[-1].endswith("*")
        return None if repeated else len(self.parameters)


_R, _S, _P, _J = Type.REAL, Type.STRING, Type.POSE, Type.JOINTS


def _f(
    function: Function | None,
    parameters: str,
    result: Type,
    name: str = "",
    *,
    by: int | None = None,
    bare: bool = False,
) -> Signature:
    wanted = tuple(parameters.split())
    required = sum(1 for p in wanted if p[-1] not in "?*")
    written = name or (function.value if function else "")
    return Signature(written, function, wanted, result, by, bare, required)


_F = Function
_ALL = (
    _f(_F.ABS, "r", _R),
    _f(_F.ATAN2, "r r", _R),
    _f(_F.COS, "r", _R),
    _f(_F.SIN, "r", _R),
    _f(_F.TAN, "r", _R),
    _f(_F.FRACT, "r", _R),
    _f(_F.INT, "r", _R),
    _f(_F.MAX, "r r*", _R),
    _f(_F.MIN, "r r*", _R),
    _f(_F.OUTSIDE, "r r r", _R),
    _f(_F.RANDOM, "", _R, bare=True),
    _f(_F.SIGN, "r", _R),
    _f(_F.SQR, "r", _R),
    _f(_F.SQRT, "r", _R),
    _f(_F.BCD, "r", _R),
    _f(_F.DCB, "r", _R),
    _f(_F.DISTANCE, "l l", _R),
    _f(_F.DX, "l", _R),
    _f(_F.DY, "l", _R),
    _f(_F.DZ, "l", _R),
    _f(_F.TRANS, "r? r? r? r? r? r?", _P),
    _f(_F.NULL, "", _P, bare=True),
    _f(_F.INVERSE, "p", _P),
    _f(_F.FRAME, "p p p p", _P),
    _f(_F.SHIFT, "p r? r? r?", _P, by=1),
    _f(_F.SCALE, "p r", _P, by=1),
    _f(_F.RX, "r", _P),
    _f(_F.RY, "r", _P),
    _f(_F.RZ, "r", _P),
    _f(_F.IDENTICAL, "l l", _R),
    _f(_F.PPOINT, "r? r? r? r? r? r?", _J),
    _f(_F.HERE, "", _P, bare=True),
    _f(_F.DEST, "", _P, bare=True),
    _f(_F.HERE_JOINTS, "", _J, bare=True),
    _f(_F.HERE_JOINTS, "", _J, "#phere", bare=True),
    _f(_F.DEST_JOINTS, "", _J, bare=True),
    _f(_F.DEST_JOINTS, "", _J, "#pdest", bare=True),
    _f(_F.BASE, "", _P, bare=True),
    _f(_F.TOOL, "", _P, bare=True),
    _f(_F.INRANGE, "l", _R),
    _f(_F.HAND, "", _R, bare=True),
    _f(_F.SIG, "r r*", _R),
    _f(_F.BITS, "r r", _R),
    _f(_F.TIMER, "r", _R),
    _f(_F.SPEED, "r", _R),
    _f(_F.DEFINED, "v", _R),
    _f(_F.ASC, "s r?", _R),
    _f(_F.CHR, "r", _S),
    _f(_F.LEN, "s", _R),
    _f(_F.MID, "s r? r?", _S),
    _f(_F.POS, "s s r?", _R),
    _f(_F.VAL, "s", _R),
    # known, not supported yet
    _f(None, "f f*", _S, "$encode"),
    _f(None, "$ s r?", _S, "$decode"),
    _f(None, "r r?", _R, "adc"),
    _f(None, "r r?", _R, "error"),
    _f(None, "r", _R, "free"),
    _f(None, "v", _R, "last"),
    _f(None, "v", _R, "parameter"),
    _f(None, "r", _R, "pendant"),
    _f(None, "", _R, "priority", bare=True),
    _f(None, "r", _R, "state"),
    _f(None, "s", _R, "status"),
    _f(None, "v", _R, "switch"),
    _f(None, "v r", _R, "tas"),
    _f(None, "s? r?", _R, "time", bare=True),
    _f(None, "r r?", _S, "$error"),
    _f(None, "s", _S, "$truncate"),
    _f(None, "v r r", _S, "$unpack"),
    _f(None, "r?", _S, "$time", bare=True),
)

FUNCTIONS = {signature.name: signature for signature in _ALL}

# Functions of relatives, and what a VAL-II programmer writes instead.
FOREIGN_FUNCTIONS = {
    "maxval": "use MAX",
    "minval": "use MIN",
    "instr": "use POS($s, $part, start)",
    "point": "use TRANS(x, y, z, o, a, t)",
    "pow": "multiply, or use SQR(x)",
    "sqrtf": "use SQRT",
    "round": "use INT(x+0.5)",
    "$left": "use $MID($s, 1, count)",
    "$right": "use $MID($s, first)",
}

CONSTANTS = {"true": -1.0, "false": 0.0, "on": -1.0, "off": 0.0, "pi": 3.141593}
