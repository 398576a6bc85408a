"""Values as states are compared: what rounding leaves of the same value is the same."""

from collections.abc import Sequence

from vrts.engine.memory.records import ArmPiece

DIGITS = 7  # of times [s]
VALUE_DIGITS = 9  # of joints, poses, polynomials: lines come back to themselves no nearer


class Nearly:
    """What stands for values of many numbers: alike for what is nearly the same."""

    def __call__(self, value: object) -> object:
        """Return what stands for a value: all its numbers rounded."""
        return nearly(value)

    def chain(self, pieces: Sequence[ArmPiece], first: int) -> object:
        """Return what stands for the pieces of a path, one behind the other, from one on."""
        return tuple([_shape(piece) for piece in pieces[first:]])


NEARLY = Nearly()


def nearly(value: object) -> object:
    """Return a value with all its numbers rounded."""
    if isinstance(value, float):
        return round(value, VALUE_DIGITS) + 0.0
    if isinstance(value, tuple):
        return tuple([nearly(item) for item in value])  # pyright: ignore[reportUnknownVariableType, reportUnknownArgumentType]
    return value


def from_now(time_s: float, now: float) -> float:
    """Return how long it is until a time [s]; 0 when it is over."""
    return round(time_s - now, DIGITS) if time_s > now else 0.0


def _shape(piece: ArmPiece) -> object:
    return nearly(piece.rows), lasts(piece)


def lasts(piece: ArmPiece) -> float:
    """Return how long a piece of a path is [s], in path time."""
    return round(piece.end_s - piece.start_s, DIGITS)
