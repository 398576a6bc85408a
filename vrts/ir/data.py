"""Instructions that change memory, signals, the terminal and the controller."""

from typing import NamedTuple

from vrts.ir.expressions import Expression, Format, Place


class Assign(NamedTuple):
    """`v = e`, `$v = e`, `SET l = e`. SET converts between pose and joints where they differ."""

    place: Place
    value: Expression


class AssignHere(NamedTuple):
    """`HERE frame:part`: give the last element the value INVERSE(frame):HERE. No break."""

    place: Place
    frame: Expression | None = None


class Decompose(NamedTuple):
    """DECOMPOSE: the six components of a location into elements of an array.

    A pose gives x, y, z [mm] and three angles [deg], O A T or plain Z Y' Z''; joints give six.
    """

    place: Place  # the first element; with no subscript the whole array, from index 0
    location: Expression
    plain_angles: bool = False


class Pack(NamedTuple):
    """PACK: replace a part of a string, or of a string array of elements of 128 characters."""

    place: Place
    first: Expression
    length: Expression
    text: Expression


class Signal(NamedTuple):
    """SIGNAL: turn outputs or internal signals on (positive number) or off (negative)."""

    signals: tuple[Expression, ...]


class Reset(NamedTuple):
    """RESET: turn off all external outputs."""


class SetBits(NamedTuple):
    """BITS first, length = value: binary to consecutive signals, the first least significant."""

    first: Expression
    length: Expression
    value: Expression


class Pulse(NamedTuple):
    """PULSE of AS: a signal on for a time [s] (None is 0.2 s), then off again."""

    signal: Expression
    time: Expression | None = None


class DelayedSignal(NamedTuple):
    """DLYSIG of AS: turn a signal on or off after a time [s]."""

    signal: Expression
    time: Expression


class SetAnalog(NamedTuple):
    """DAC channel = value: raw counts to an analog output."""

    channel: Expression
    value: Expression


class Type(NamedTuple):
    """TYPE: write items; a number format holds for all later numbers of the instruction."""

    items: tuple[Expression | Format, ...]


class Prompt(NamedTuple):
    """PROMPT: write a text, read a line into one string or several reals."""

    text: Expression | None
    places: tuple[Place, ...]


class Switch(NamedTuple):
    """ENABLE, DISABLE: set system switches, named in upper case."""

    names: tuple[str, ...]
    on: bool


class SetParameter(NamedTuple):
    """PARAMETER name[index] = value; the name in upper case."""

    name: str
    subscript: Expression | None
    value: Expression


class SetTimer(NamedTuple):
    """TIMER n = value [s]: it counts up from there."""

    number: Expression
    value: Expression


class Opaque(NamedTuple):
    """An instruction that the language has and the simulator never does.

    It stops the run when it is reached, with VAL's *Option not installed*.
    """

    words: str  # the instruction as written, for the message
