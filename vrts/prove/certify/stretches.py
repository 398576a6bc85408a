"""Motion of arm and hand between two times of a machine, in pieces that come again elsewhere.

A stretch is a part of polynomials in `s`: the path time of a piece while nothing but the arm moves,
else run time. The same piece of a path is the same wherever it is in time, at whatever monitor
speed; with a hand that moves, where the hand does the same on it.
"""

from array import array
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from hashlib import blake2b
from typing import NamedTuple, TypeAlias

from vrts.engine.machine.machine import Machine
from vrts.engine.memory.records import ArmPiece
from vrts.engine.motion.polynomials import Row, composed, value
from vrts.engine.motion.time_scale import TimeScale

NOTHING = 1e-7  # [s] what is shorter is no stretch
DIGITS = 8  # [rad, m, s] ways that differ by less are one: 0.2 um at the hand, of a band of 10
MOST = 20_000  # polynomials that are known by the very object
OF_HAND = -1  # number of a way on which it does not matter what the arm does
REST_S = 0.01  # of a stretch in which nothing moves, whatever it lasts

Rows: TypeAlias = tuple[Row, ...]
Way: TypeAlias = tuple[float, ...]


class Stretch(NamedTuple):
    """Polynomials of arm and hand on an interval of `s`."""

    number: int  # of the polynomials of the arm
    rows: Rows  # six joints
    opening: Row
    from_s: float  # of s
    to_s: float
    begins_s: float  # run time at both ends
    ends_s: float
    zero_s: float  # run time at s = 0, where that is run time
    rate: float  # s runs faster than run time by this at most
    moves: bool  # the arm does

    @property
    def way(self) -> Way:
        """Return what stands for what moves, and how fast."""
        return (self.number, self.rate, *[round(c, DIGITS) for c in self.opening])

    @property
    def hand_moves(self) -> bool:
        """Whether the fingers do."""
        return len(self.opening) > 1

    @property
    def at_once(self) -> "Stretch":
        """Return its beginning as that of all in which the hand is the same and does not move."""
        rows = tuple([(value(row, self.from_s),) for row in self.rows])
        times = (0.0, REST_S, self.begins_s, self.begins_s)
        return Stretch(OF_HAND, rows, self.opening, *times, 0.0, 0.0, False)

    def part(self, from_s: float, to_s: float) -> "Stretch":
        """Return a part of it."""
        times = {"begins_s": self.time(from_s), "ends_s": self.time(to_s)}
        return self._replace(from_s=from_s, to_s=to_s, **times)

    def time(self, s: float) -> float:
        """Return the run time, as if it ran evenly."""
        lasts = self.to_s - self.from_s
        share = min(max((s - self.from_s) / lasts, 0.0), 1.0) if lasts > 0.0 else 0.0
        return self.begins_s + share * (self.ends_s - self.begins_s)


class Ways:
    """Gives numbers to polynomials: the same to those that are the same but for rounding."""

    def __init__(self) -> None:
        """Know none."""
        self._numbers: dict[bytes, int] = {}
        self._by_id: dict[int, tuple[Rows, int]] = {}  # what is kept keeps its id
        self._rests: dict[tuple[int, float], tuple[Rows, Rows, int]] = {}

    def number(self, rows: Rows, lasts_s: float) -> int:
        """Return the number of polynomials that last so long."""
        known = self._by_id.get(id(rows))
        if known is not None:
            return known[1]
        number = self.of_content(rows, lasts_s)
        if len(self._by_id) >= MOST:
            self._by_id.clear()
        self._by_id[id(rows)] = (rows, number)
        return number

    def at_rest(self, machine: Machine, time_s: float) -> tuple[Rows, int]:
        """Return constants for an arm that stands still at a run time, and their number."""
        given, path_s = machine.system.planner.given, machine.system.planner.scale.path(time_s)
        piece = given.pieces[-1] if given.pieces else None
        if piece is None or path_s < piece.end_s:
            rows = tuple([(joint,) for joint in configuration_at(machine, time_s)])
            return rows, self.of_content(rows, 0.0)
        key = (id(piece.rows), piece.end_s - piece.start_s)
        known = self._rests.get(key)
        if known is None:
            if len(self._rests) >= MOST:
                self._rests.clear()
            rows = tuple([(joint,) for joint in configuration_at(machine, time_s)])
            known = self._rests[key] = (piece.rows, rows, self.of_content(rows, 0.0))
        return known[1:]

    def of_content(self, rows: Rows, lasts_s: float) -> int:
        """Return the number of polynomials that nobody keeps."""
        content = array("d")
        for row in rows:
            content.append(float(len(row)))
            scale = 1.0
            for c in row:
                content.append(round(c * scale, DIGITS) + 0.0)
                scale *= lasts_s
        content.append(round(lasts_s, DIGITS))
        key = blake2b(content.tobytes(), digest_size=16).digest()
        return self._numbers.setdefault(key, len(self._numbers))


def stretches(
    machine: Machine, ways: Ways, from_s: float, to_s: float, *, falling_from_s: float | None
) -> Iterator[Stretch]:
    """Yield what arm and hand do between two run times, between which no stroke begins or ends.

    Args:
        machine: The machine.
        ways: Gives numbers.
        from_s: From when on [s].
        to_s: Until when.
        falling_from_s: Since when something falls; None: nothing does.
    """
    planner, hand = machine.system.planner, machine.system.hand
    scale = planner.scale
    openings = hand.opening(from_s), hand.opening(to_s)
    pieces = _between(planner.given.pieces, scale.path(from_s), scale.path(to_s))
    if openings[0] == openings[1] and falling_from_s is None:
        found = _along(pieces, scale, ways, (from_s, to_s), openings[0])
        if found:
            yield from found
            return
        yield _resting(machine, ways, (from_s, to_s), (openings[0],), None)
        return
    at = from_s
    rate = (openings[1] - openings[0]) / (to_s - from_s)
    for piece in _in_run_time(pieces, scale, (from_s, to_s)):
        begin, end = max(piece.start_s, from_s), min(piece.end_s, to_s)
        if end - begin < NOTHING:
            continue
        if begin - at > NOTHING:
            row = _row(openings[0] + rate * (at - from_s), rate)
            yield _resting(machine, ways, (at, begin), row, falling_from_s)
        lasts_s = piece.end_s - piece.start_s
        number = (ways.number if scale.plain else ways.of_content)(piece.rows, lasts_s)
        s = begin - piece.start_s, end - piece.start_s
        row = _row(openings[0] + rate * (piece.start_s - from_s), rate)
        yield Stretch(number, piece.rows, row, *s, begin, end, piece.start_s, 1.0, True)
        at = end
    if to_s - at > NOTHING:
        row = _row(openings[0] + rate * (at - from_s), rate)
        yield _resting(machine, ways, (at, to_s), row, falling_from_s)


def configuration_at(machine: Machine, time_s: float) -> tuple[float, ...]:
    """Return the joints at a run time as the timeline of a run has them [rad]."""
    planner = machine.system.planner
    pieces, path_s = planner.given.pieces, planner.scale.path(time_s)
    found = bisect_right(pieces, path_s, key=_start)
    if not found:
        return planner.given.at(path_s)
    piece = pieces[found - 1]
    t = min(path_s, piece.end_s) - piece.start_s
    return tuple([value(row, t) for row in piece.rows])


def _row(at_zero: float, rate: float) -> Row:
    return (at_zero, rate) if rate else (at_zero,)


def _between(pieces: Sequence[ArmPiece], from_s: float, to_s: float) -> list[ArmPiece]:
    """Return the pieces that last for some of an interval of path time."""
    k = max(bisect_right(pieces, from_s, key=_start) - 1, 0)
    found: list[ArmPiece] = []
    while k < len(pieces) and pieces[k].start_s < to_s:
        if pieces[k].end_s > from_s:
            found.append(pieces[k])
        k += 1
    return found


def _along(
    pieces: Sequence[ArmPiece],
    scale: TimeScale,
    ways: Ways,
    times: tuple[float, float],
    opening: float,
) -> list[Stretch]:
    """Return stretches in path time."""
    from_s, to_s = scale.path(times[0]), scale.path(times[1])
    rate = 1.0
    if not scale.plain:  # as fast as it would be if it did not slow down
        knots = [knot.time_s for knot in scale.knots if times[0] < knot.time_s < times[1]]
        rate = max(scale.rate, *[scale.rate_at(t) for t in (*times, *knots)])
    found: list[Stretch] = []
    for piece in pieces:
        begin, end = max(piece.start_s, from_s), min(piece.end_s, to_s)
        if end - begin < NOTHING:
            continue
        number = ways.number(piece.rows, piece.end_s - piece.start_s)
        s = begin - piece.start_s, end - piece.start_s
        if scale.plain:
            begins_s, ends_s = begin, end
        else:
            begins_s = max(scale.time(begin), times[0])
            ends_s = min(scale.time(end), times[1])
        hand = (opening,)
        found.append(Stretch(number, piece.rows, hand, *s, begins_s, ends_s, 0.0, rate, True))
    return found


def _in_run_time(
    pieces: Sequence[ArmPiece], scale: TimeScale, times: tuple[float, float]
) -> Iterator[ArmPiece]:
    """Yield pieces as polynomials of the run time."""
    if scale.plain:
        yield from pieces
        return
    for begin, stop, path in scale.pieces(*times):
        until_s = scale.path(stop)
        for piece in pieces:
            low, high = max(piece.start_s, path[0]), min(piece.end_s, until_s)
            if high - low < NOTHING:
                continue
            inner = (path[0] - piece.start_s, *path[1:])
            rows = tuple([composed(row, inner) for row in piece.rows])
            first = begin if low == path[0] else max(scale.time(low), begin)
            last = stop if high == until_s else min(scale.time(high), stop)
            yield _moved(ArmPiece(begin, last, rows, piece.motion), first)


def _moved(piece: ArmPiece, start_s: float) -> ArmPiece:
    """Return the part of a piece from a time on."""
    if start_s == piece.start_s:
        return piece
    by: Row = (start_s - piece.start_s, 1.0)
    rows = tuple([composed(row, by) for row in piece.rows])
    return piece._replace(start_s=start_s, rows=rows)


def _resting(
    machine: Machine,
    ways: Ways,
    times: tuple[float, float],
    opening: Row,
    falling_from_s: float | None,
) -> Stretch:
    """Return a stretch in which the arm stands still.

    Args:
        machine: The machine.
        ways: Gives numbers.
        times: From when to when [s].
        opening: Of the hand at the first of them, and its rate.
        falling_from_s: Since when something falls.
    """
    rows, number = ways.at_rest(machine, times[0])
    lasts_s = times[1] - times[0]
    if falling_from_s is not None:
        begin = times[0] - falling_from_s
        row = _row(opening[0] - sum(opening[1:]) * begin, sum(opening[1:]))
        zero_s = falling_from_s
    elif len(opening) > 1:  # s counts from where the hand would be closed
        begin = opening[0] / opening[1]
        row, zero_s = (0.0, opening[1]), times[0] - begin
    else:
        return Stretch(number, rows, opening, 0.0, REST_S, times[0], times[0], 0.0, 0.0, False)
    return Stretch(number, rows, row, begin, begin + lasts_s, *times, zero_s, 0.0, False)


def _start(piece: ArmPiece) -> float:
    return piece.start_s
