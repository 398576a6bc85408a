"""Functions and constants of the language: what they take and what they yield.

Signatures: `r` real, `s` string, `p` pose, `l` location (pose or precision point), `v` a variable
or whole array, `$` a string variable, `f` a format or any value, `n` the name of a switch or
parameter, `x` anything (of functions that are never carried out). `?` may be left out or omitted,
`*` any number of these, at least none. Before BY stands what comes first.
"""

from functools import cache
from typing import NamedTuple

from vrts.ir.expressions import Function
from vrts.ir.values import Type
from vrts.lang.dialect import Dialect
from vrts.lang.vocabulary.kawasaki_functions import OF_KAWASAKI
from vrts.lang.vocabulary.opaque_vplus_functions import OPAQUE_VPLUS_FUNCTIONS


class Signature(NamedTuple):
    """How a function is applied."""

    name: str  # lower case, with its sigil
    function: Function
    parameters: tuple[str, ...]
    result: Type
    about: str  # what it yields, in one line
    dialects: str  # columns, as of words
    by: int | None = None  # how many arguments stand before BY
    bare: str = ""  # columns of the dialects in which it may be written without parentheses
    required: int = 0

    @property
    def most(self) -> int | None:
        """Largest number of arguments; None is any number."""
        repeated = bool(self.parameters) and self.parameters[-1].endswith("*")
        return None if repeated else len(self.parameters)

    @property
    def opaque(self) -> bool:
        """Whether the simulator never carries it out."""
        return self.function is Function.OPAQUE


AXES = 6  # of the arms that are simulated
MOST_AXES = 18  # that controllers of AS move, as programs of their maker have it

_EVERYWHERE = "12+a"
_R, _S, _P, _J = Type.REAL, Type.STRING, Type.POSE, Type.JOINTS


def _f(
    function: Function,
    parameters: str,
    result: Type,
    about: str,
    dialects: str = "2+a",
    *,
    name: str = "",
    by: int | None = None,
    bare: str = "",
) -> Signature:
    wanted = tuple(parameters.split())
    required = sum(1 for p in wanted if p[-1] not in "?*")
    return Signature(
        name or function.value, function, wanted, result, about, dialects, by, bare, required
    )


_F = Function
_RESULTS = {"r": _R, "s": _S, "p": _P, "j": _J}
_ALL = (
    # numbers
    _f(_F.ABS, "r", _R, "magnitude"),
    _f(_F.ATAN2, "r r", _R, "angle whose tangent is y/x, in degrees"),
    _f(_F.COS, "r", _R, "cosine of an angle in degrees"),
    _f(_F.SIN, "r", _R, "sine of an angle in degrees"),
    _f(_F.TAN, "r", _R, "tangent of an angle in degrees", "2+"),
    _f(_F.FRACT, "r", _R, "part behind the point, with its sign", "2+"),
    _f(_F.INT, "r", _R, "part before the point"),
    _f(_F.MAX, "r r*", _R, "largest", "2+"),
    _f(_F.MIN, "r r*", _R, "smallest", "2+"),
    _f(_F.OUTSIDE, "r r r", _R, "whether the second is not between the others", "2+"),
    _f(_F.RANDOM, "", _R, "a number from 0 to 1", bare=_EVERYWHERE),
    _f(_F.SIGN, "r", _R, "1 or -1", "2+"),
    _f(_F.SQR, "r", _R, "square", "2+"),
    _f(_F.SQRT, "r", _R, "square root"),
    _f(_F.BCD, "r", _R, "number to binary coded decimal", "2+"),
    _f(_F.DCB, "r", _R, "binary coded decimal to number", "2+"),
    # locations
    _f(_F.DISTANCE, "p p", _R, "distance of two locations in mm"),
    _f(_F.DX, "p", _R, "X of a location in mm"),
    _f(_F.DY, "p", _R, "Y of a location in mm"),
    _f(_F.DZ, "p", _R, "Z of a location in mm"),
    _f(_F.TRANS, "r? r? r? r? r? r?", _P, "location of three lengths and three angles"),
    _f(_F.NULL, "", _P, "the location that changes nothing", bare=_EVERYWHERE),
    _f(_F.INVERSE, "p", _P, "inverse of a location", "2+"),
    _f(_F.NORMAL, "p", _P, "location without errors of rounding", "+"),
    _f(_F.FRAME, "p p p p", _P, "frame by two points on X, one towards Y, and its origin"),
    _f(_F.SHIFT, "p r? r? r?", _P, "location shifted in world axes", by=1),
    _f(_F.SCALE, "p r", _P, "location with its lengths scaled", "+", by=1),
    _f(_F.RX, "r", _P, "rotation about X"),
    _f(_F.RY, "r", _P, "rotation about Y"),
    _f(_F.RZ, "r", _P, "rotation about Z"),
    _f(_F.IDENTICAL, "l l", _R, "whether two locations are exactly equal", "2+"),
    _f(_F.PPOINT, "r? r? r? r? r? r?", _J, "precision point of six joints in degrees"),
    # the robot and the controller
    _f(_F.HERE, "", _P, "present pose of the tool", bare=_EVERYWHERE),
    _f(_F.DEST, "", _P, "where the last motion goes", bare=_EVERYWHERE),
    _f(_F.HERE_JOINTS, "", _J, "present joints", bare=_EVERYWHERE),
    _f(_F.HERE_JOINTS, "", _J, "present joints", name="#phere", bare=_EVERYWHERE),
    _f(_F.DEST_JOINTS, "", _J, "joints where the last motion ends", bare=_EVERYWHERE),
    _f(
        _F.DEST_JOINTS, "", _J, "joints where the last motion ends", name="#pdest", bare=_EVERYWHERE
    ),
    _f(_F.BASE, "", _P, "how the robot was displaced", bare=_EVERYWHERE),
    _f(_F.TOOL, "", _P, "where the tool tip is on the flange", bare=_EVERYWHERE),
    _f(_F.INRANGE, "l", _R, "0 when the arm can reach a location"),
    _f(_F.HAND, "", _R, "opening of the hand", "2+", bare="12+"),
    _f(_F.SIG, "r r*", _R, "whether all signals are as given"),
    _f(_F.BITS, "r r", _R, "number on consecutive signals"),
    _f(_F.TIMER, "r", _R, "seconds of a timer"),
    _f(_F.SPEED, "r", _R, "speed in percent"),
    _f(_F.DEFINED, "v", _R, "whether a variable has a value", "2+"),
    _f(_F.SWITCH, "n", _R, "whether a system switch is on"),
    _f(_F.PARAMETER, "n r?", _R, "value of a parameter of the controller", "2+"),
    _f(_F.ADC, "r r?", _R, "counts on an analog input", "2"),
    _f(_F.PENDANT, "r", _R, "a key of the manual control", "2+"),
    _f(_F.PRIORITY, "", _R, "present priority of the program", "+a", bare="+a"),
    _f(_F.STATE, "r", _R, "state of the robot", "2+"),
    _f(_F.STATUS, "s", _R, "state of a program", "2+"),
    _f(_F.ERROR, "r? r?", _R, "number of the last error", bare="a"),
    _f(_F.FREE, "r? r?", _R, "memory left", "+"),
    _f(_F.LAST, "v", _R, "highest index that has a value", "+"),
    _f(_F.TAS, "v r", _R, "old value of a variable, which then takes the new one", "+"),
    _f(
        _F.CAS,
        "v r r",
        _R,
        "old value of a variable, which takes the last if it was the second",
        "+",
    ),
    _f(_F.TIME, "s? r?", _R, "date and time as a number", "+"),
    # strings
    _f(_F.ASC, "s r?", _R, "code of a character"),
    _f(_F.CHR, "r", _S, "character of a code"),
    _f(_F.LEN, "s", _R, "number of characters"),
    _f(_F.MID, "s r? r?", _S, "part of a string"),
    _f(_F.POS, "s s r?", _R, "where a string stands in another", "2+"),
    _f(_F.VAL, "s r?", _R, "number at the start of a string"),
    _f(_F.STRDIF, "s s", _R, "-1, 0 or 1: how two strings are sorted", "+"),
    _f(_F.ENCODE, "f f*", _S, "text as TYPE would write it"),
    _f(_F.DECODE, "$ s r?", _S, "next piece of a string, taken from it"),
    _f(_F.TRUNCATE, "s", _S, "string up to the first NUL", "+"),
    _f(_F.UNPACK, "v r r", _S, "part of a string array", "2+"),
    _f(_F.ERROR_TEXT, "r r?", _S, "words of an error"),
    _f(_F.TIME_TEXT, "r?", _S, "time as text", "+a"),
    _f(_F.DATE_TEXT, "r?", _S, "date as text", "a"),
    # spellings of AS
    _f(_F.MAX, "r r*", _R, "largest", "a", name="maxval"),
    _f(_F.MIN, "r r*", _R, "smallest", "a", name="minval"),
    _f(_F.INSTR, "r? s s", _R, "where a string stands in another", "a"),
    _f(_F.ROUND, "r", _R, "nearest whole number", "a"),
    _f(_F.DEXT, "l r", _R, "one element of a location", "a"),
    _f(_F.MID, "s r", _S, "first characters of a string", "a", name="$left"),
    _f(_F.RIGHT, "s r", _S, "last characters of a string", "a"),
    _f(_F.SPACE, "r", _S, "blanks", "a"),
    # never carried out
    _f(_F.OPAQUE, "r", _R, "word on the bus", "2", name="ioget"),
    *(
        _f(_F.OPAQUE, parameters, _RESULTS[kind], about, "a", name=name, bare=bare)
        for name, parameters, kind, about, bare in OF_KAWASAKI
    ),
    _f(_F.PPOINT, "r? r? r? r? r? r?", _J, "precision point without its sign", "+", name="ppoint"),
)

_ALSO_OF_AS = frozenset({"task"})  # [AS manual, functions]
_OPAQUE_OF_VPLUS = tuple(
    _f(
        _F.OPAQUE,
        row.parameters,
        _RESULTS[row.result],
        row.about,
        "+a" if row.name in _ALSO_OF_AS else "+",
        name=row.name,
        bare="+" if row.bare else "",
    )
    for row in OPAQUE_VPLUS_FUNCTIONS
)

FUNCTIONS = {signature.name: signature for signature in (*_ALL, *_OPAQUE_OF_VPLUS)}


@cache
def applied_functions(dialect: Dialect) -> dict[str, Signature]:
    """Return the functions that a dialect has, before parentheses, by name in lower case."""
    if dialect.takes_all or dialect.is_val:
        return FUNCTIONS
    if dialect.is_as or dialect.is_vplus:
        return {name: s for name, s in FUNCTIONS.items() if dialect.has(s.dialects)}
    return {
        name: signature
        for name, signature in FUNCTIONS.items()
        if dialect.has(signature.dialects)
        or not (signature.opaque or signature.dialects == "a")  # V+ speaks for VAL-II
    }


@cache
def bare_functions(dialect: Dialect) -> dict[str, Signature]:
    """Return the functions that a dialect takes without parentheses."""
    return {name: s for name, s in FUNCTIONS.items() if s.bare and dialect.has(s.bare)}


def has_more_axes(name: str, given: int) -> bool:
    """Return whether TRANS or #PPOINT of AS is for a robot with more than six axes."""
    return name in ("trans", "#ppoint") and AXES < given <= MOST_AXES


# Functions of relatives, and what a VAL-II programmer writes instead.
_RANDOM = "use RANDOM, from 0 to 1: `INT(6*RANDOM)+1` is a number from 1 to 6"
FOREIGN_FUNCTIONS = {
    "maxval": "use MAX",
    "minval": "use MIN",
    "instr": "use POS($s, $part, start)",
    "$left": "use $MID($s, 1, count)",
    "$right": "use $MID($s, first)",
    "point": "use TRANS(x, y, z, o, a, t)",
    "pow": "multiply, or use SQR(x)",
    "sqrtf": "use SQRT",
    "floor": "use INT(x)",
    "ceil": "use INT(x)+1",
    "round": "use INT(x+0.5)",
    "trunc": "use INT(x)",
    "fix": "use INT(x)",
    "toint": "use INT(x)",
    "fabs": "use ABS(x)",
    "sgn": "use SIGN(x)",
    "mod": "MOD stands between: write `a MOD b`",
    "hypot": "use SQRT(SQR(x)+SQR(y))",
    "radians": "angles are in degrees everywhere: leave it out",
    "deg2rad": "angles are in degrees everywhere: leave it out",
    "degrees": "angles are in degrees everywhere: leave it out",
    "rad2deg": "angles are in degrees everywhere: leave it out",
    "rad": "angles are in degrees everywhere: leave it out",
    "deg": "angles are in degrees everywhere: leave it out",
    "torad": "angles are in degrees everywhere: leave it out",
    "todeg": "angles are in degrees everywhere: leave it out",
    "format": "a format stands before its number: `TYPE /F8.2, x`",
    "strlen": "use LEN($s)",
    "length": "use LEN($s)",
    "size": "use LEN($s)",
    "ord": "use ASC($s)",
    "chr": "use $CHR(code)",
    "substr": "use $MID($s, first, count)",
    "$substr": "use $MID($s, first, count)",
    "curpos": "use HERE",
    "crobt": "use HERE",
    "cpos": "use HERE",
    "getpose": "use HERE",
    "get_actual_tcp_pose": "use HERE",
    "clock": "use TIMER(1)",
    "input": 'write `PROMPT "text", n`',
    "prompt": 'PROMPT is an instruction: write `PROMPT "text", n`',
    "str": "use $ENCODE(x)",
    "tostring": "use $ENCODE(x)",
    "num2str": "use $ENCODE(x)",
    "inttostr": "use $ENCODE(x)",
    "float": "use VAL($s)",
    "atan": "use ATAN2(y, x)",
    "arctan": "use ATAN2(y, x)",
    "arctan2": "use ATAN2(y, x)",
    "arcsin": "use ATAN2(x, SQRT(1-SQR(x)))",
    "arccos": "use ATAN2(SQRT(1-SQR(x)), x)",
    "cot": "use COS(x)/SIN(x)",
    "pi": "PI is a number: leave the parentheses out, and write `PI`",
    "dist": "use DISTANCE(one, other)",
    "inc": "to count write `n = n+1`",
    "dec": "to count down write `n = n-1`",
    "succ": "to count write `n = n+1`",
    "$upper": 'VAL-II has no such function: compare both, as in `($s == "y") OR ($s == "Y")`',
    "upper": 'VAL-II has no such function: compare both, as in `($s == "y") OR ($s == "Y")`',
    "asin": "use ATAN2(x, SQRT(1-SQR(x)))",
    "acos": "use ATAN2(SQRT(1-SQR(x)), x)",
    "rand": _RANDOM,
    "rnd": _RANDOM,
    "randint": _RANDOM,
    "random.randint": _RANDOM,
    "randi": _RANDOM,
    "p": "use TRANS(x, y, z, o, a, t)",
    "pose": "use TRANS(x, y, z, o, a, t)",
    "offs": "use SHIFT(location BY x, y, z)",
    "reltool": "join locations by `:`, as in `part:TRANS(0, 0, 50)`",
    "digitalread": "a signal is asked for by SIG: write `SIG(1001)`",
    "signal": "SIGNAL switches, SIG asks: write `SIG(1001)`",
    "input.signal": "a signal is asked for by SIG: write `SIG(1001)`",
    "din": "a signal is asked for by SIG: write `SIG(1001)`",
    "di": "a signal is asked for by SIG: write `SIG(1001)`",
}

CONSTANTS = {"true": -1.0, "false": 0.0, "on": -1.0, "off": 0.0, "pi": 3.141593}
