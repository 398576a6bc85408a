"""Bounds on the distances of many pairs of solids: proposals first, our own search where they fail.

A proposer names a direction and two points for each pair. What they prove is computed from the
shapes alone (`rows`); where that is not enough, `scalar` searches on, from the best direction
known. It needs no proposals, so a proposer that lies, fails or is not there costs time only.
"""

from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from vrts.base.pose import Pose
from vrts.base.remembered import is_remembering, remembered
from vrts.geometry.proposing.proposer import Proposer, Questions
from vrts.geometry.proving import scalar
from vrts.geometry.proving.placed import placed as support_of
from vrts.geometry.proving.rows import Placed, gaps, units, uppers
from vrts.geometry.shapes import Shape
from vrts.geometry.solids import Solids

Array: TypeAlias = npt.NDArray[np.float64]
Indices: TypeAlias = npt.NDArray[np.int64]

EXACT = 1e-7  # [m] bounds this near to each other are told as one distance


class Bounds(NamedTuple):
    """What is proven of m pairs."""

    lower: Array  # (m,) apart by at least so much; below zero: overlap at most so deep [m]
    upper: Array  # (m,) apart by at most so much; below zero: overlap at least so deep [m]
    normal: Array  # (m, 3) along which `lower` holds, from the first to the second
    first: Array  # (m, 3) points of the first solids in W [m]
    second: Array  # (m, 3) of the second [m]

    @property
    def distance(self) -> Array:
        """Signed distances, halfway between the bounds, shape (m,), in m."""
        return 0.5 * (self.lower + self.upper)

    def put(self, rows: Indices, found: "Bounds") -> None:
        """Take over what is better in other bounds of some rows."""
        better = found.lower > self.lower[rows]
        self.lower[rows[better]] = found.lower[better]
        self.normal[rows[better]] = found.normal[better]
        nearer = found.upper < self.upper[rows]
        for own, new in ((self.upper, found.upper), (self.first, found.first)):
            own[rows[nearer]] = new[nearer]
        self.second[rows[nearer]] = found.second[nearer]


class Proposed(NamedTuple):
    """What a proposer says of m pairs, and what that proves."""

    lower: Array  # (m,) gap along the direction: proven; -inf where there is none [m]
    normal: Array  # (m, 3) the direction; NaN where there is none
    claim: Array  # (m,) signed distance that the points amount to: proven by nobody, or inf [m]
    first: Array  # (m, 3) points near the first solids [m]
    second: Array  # (m, 3) and near the second [m]


class Prover:
    """Proves distances of solids."""

    def __init__(self, solids: Solids, proposer: Proposer) -> None:
        """Take what is asked about, and who proposes."""
        self.solids = solids
        self.proposer = proposer
        self.asked = 0  # questions to the proposer
        self.searched = 0  # and to ourselves

    def questions(self, a: Placed, b: Placed) -> Questions:
        """Return what a proposer is asked about pairs."""
        shapes = self.solids.shapes
        first, second = _shapes(shapes, a), _shapes(shapes, b)
        return Questions(first, second, a.rotation, a.origin, b.rotation, b.origin)

    def proposed(self, a: Placed, b: Placed) -> Proposed:
        """Ask the proposer, and return what its directions prove."""
        self.asked += len(a.solid)
        normal, first, second = self.proposer.propose(self.questions(a, b))
        normal = units(normal)
        lower = gaps(self.solids, a, b, normal)
        claim = np.einsum("ri,ri->r", second - first, normal)
        return Proposed(lower, normal, np.where(np.isnan(claim), np.inf, claim), first, second)

    def searched_for(
        self,
        a: Placed,
        b: Placed,
        start: Array,
        *,
        tight: float = EXACT,
        apart: Array | None = None,
        deep: Array | None = None,
    ) -> Bounds:
        """Return what our own search proves, pair by pair.

        Args:
            a: First solids.
            b: Second solids.
            start: Directions to begin with, shape (m, 3); NaN: from centre to centre.
            tight: Bounds this near to each other are near enough [m].
            apart: Lower bounds that are enough, however far the upper ones are, shape (m,), in m.
            deep: So are upper bounds of so little.
        """
        count = len(a.solid)
        self.searched += count
        shapes = self.solids.shapes
        ways = np.where(np.isfinite(start), start, units(self.middles(b) - self.middles(a)))
        ways = np.where(np.isfinite(ways), ways, (0.0, 0.0, 1.0))
        enough = [np.inf] * count if apart is None else apart.tolist()
        deeper = [-np.inf] * count if deep is None else deep.tolist()
        columns = zip(
            _shapes(shapes, a), _poses(a), _shapes(shapes, b), _poses(b), ways.tolist(),
            enough, deeper, strict=True,
        )  # fmt: skip
        found = [
            _searched(_Question(one, X_WA, other, X_WB, (x, y, z), tight, far, low))
            for one, X_WA, other, X_WB, (x, y, z), far, low in columns
        ]
        return _bounds(found)

    def middles(self, of: Placed) -> Array:
        """Return the middles of placed solids in W, shape (m, 3), in m."""
        return of.origin + (of.rotation @ self.solids.middle[of.solid][:, :, None])[:, :, 0]

    def at_once(self, a: Placed, b: Placed) -> Bounds:
        """Return what the proposals alone prove of the signed distances of pairs."""
        lower, normal, _, first, second = self.proposed(a, b)
        upper = uppers(self.solids, a, b, first, second)
        return Bounds(lower, upper, normal, first, second)

    def exact(self, a: Placed, b: Placed, apart: float = np.inf) -> Bounds:
        """Return the signed distances of pairs to `EXACT`; of those so far apart, that they are."""
        found = self.at_once(a, b)
        lower, upper = found.lower, found.upper
        loose = np.flatnonzero(~(upper - lower <= EXACT) & ~(lower >= apart))
        if len(loose):
            start = found.normal[loose]
            far = np.full(len(loose), apart)
            found.put(loose, self.searched_for(a.at(loose), b.at(loose), start, apart=far))
        return found

    def told(self, a: Placed, b: Placed) -> Bounds:
        """Return the same, the same bits whoever proposes."""
        return self.searched_for(a, b, np.full((len(a.solid), 3), np.nan), tight=scalar.TIGHT)


class _Question(NamedTuple):
    """What one search is about."""

    one: Shape
    X_WA: Pose
    other: Shape
    X_WB: Pose
    way: tuple[float, float, float]
    tight: float
    apart: float
    deep: float


def _searched(asked: _Question) -> scalar.Proven:
    if not is_remembering():
        return _search(asked)
    one, other = asked.one, asked.other
    key = (_searched, id(one), asked.X_WA, id(other), *asked[3:])
    return remembered(key, lambda: _search(asked), alive=(one, other))


def _search(asked: _Question) -> scalar.Proven:
    return scalar.of_supports(
        support_of(asked.one, asked.X_WA),
        support_of(asked.other, asked.X_WB),
        asked.way,
        asked.tight,
        apart=asked.apart,
        deep=asked.deep,
    )


def _shapes(shapes: Sequence[Shape], of: Placed) -> list[Shape]:
    return [shapes[number] for number in of.solid.tolist()]


def _poses(of: Placed) -> list[Pose]:
    rotations: list[list[float]] = of.rotation.reshape(-1, 9).tolist()
    origins: list[list[float]] = of.origin.tolist()
    return [
        Pose((r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]), (o[0], o[1], o[2]))
        for r, o in zip(rotations, origins, strict=True)
    ]


def _bounds(found: Sequence[scalar.Proven]) -> Bounds:
    """Return answers to single questions as columns."""
    table = np.array(
        [(one.lower, one.upper, *one.normal, *one.first, *one.second) for one in found]
    ).reshape(-1, 11)
    return Bounds(table[:, 0], table[:, 1], table[:, 2:5], table[:, 5:8], table[:, 8:11])
