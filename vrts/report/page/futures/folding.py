"""The tree of decisions as it is drawn: what is alike is folded, what is too much is counted.

Futures of one parent in which the same is decided, and that go on in the same way, are one node
that says how many they are. So a wait of a thousand ticks is two nodes.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from vrts.prove.environment.environment import Environment
from vrts.prove.proof import Branch, Decided, Proof
from vrts.prove.telling.scenarios import scenario_of
from vrts.scene.model import Scenario

MOST = 300  # nodes that are drawn
ALIKE = 3  # so many alike are folded
SAME_S = 1e-6  # [s] times that differ by less are the same


class Mark(NamedTuple):
    """Something that goes wrong on a node."""

    number: int  # of what is told, from 1
    time_s: float


class Node(NamedTuple):
    """A future, or many that are alike, from a decision to the next end."""

    parent: int | None
    decided: Decided | None  # None: nothing has come from outside yet
    start_s: float
    end_s: float
    ends: str  # as a branch does
    into: int | None  # the node that it goes on like
    many: int  # futures that are alike; 1: this one alone
    last_s: float  # when the last of them begins
    left: int  # futures below that are not drawn
    marks: tuple[Mark, ...]

    @property
    def is_merged(self) -> bool:
        """Whether it meets a future that is drawn elsewhere."""
        return self.ends == "merged"


def stories(drawn: Sequence[Node]) -> list[tuple[Decided, ...]]:
    """Return what outside decided on the way to each node, and at it."""
    found: list[tuple[Decided, ...]] = []
    for node in drawn:
        before = () if node.parent is None else found[node.parent]
        found.append(before if node.decided is None else (*before, node.decided))
    return found


def scenarios_of(
    drawn: Sequence[Node], environment: Environment, tick_s: float
) -> dict[int, tuple[Scenario, float]]:
    """Return scenarios of the leaves in which nothing goes wrong, and until when each goes [s].

    Args:
        drawn: What is drawn of a tree.
        environment: What is the same in every future.
        tick_s: How often the controller looks [s].
    """
    return {
        k: (scenario_of(environment, story, tick_s), node.end_s)
        for k, (node, story) in enumerate(zip(drawn, stories(drawn), strict=True))
        if node.ends and not node.marks
    }


class _Knot:
    """A branch while the tree is folded."""

    def __init__(self, branch: Branch) -> None:
        self.parent, self.decided = branch.parent, branch.decided
        self.ends, self.into = branch.ends, branch.into
        self.start_s = 0.0 if branch.decided is None else branch.decided.time_s
        self.end_s = self.start_s if branch.ended_s is None else max(branch.ended_s, self.start_s)
        self.children: list[int] = []
        self.marks: list[Mark] = []
        self.size = 1  # futures in it and below
        self.many, self.last_s, self.left = 1, self.start_s, 0


def nodes(proof: Proof, most: int = MOST) -> tuple[Node, ...]:
    """Return what is drawn of the tree of a proof, parents before their children."""
    knots = [_Knot(branch) for branch in proof.tree]
    if not knots:
        return ()
    roots = [number for number, knot in enumerate(knots) if knot.parent is None]
    for number, knot in enumerate(knots):
        if knot.parent is not None:
            knots[knot.parent].children.append(number)
    for number, one in enumerate(proof.found, 1):
        at = _path(knots, roots, one.decisions)
        knots[at].marks.append(Mark(number, one.time_s))
        knots[at].end_s = max(knots[at].end_s, one.time_s)
    for knot in reversed(knots):
        knot.size += sum(knots[child].size for child in knot.children)
        knot.end_s = max([knot.end_s, *(knots[child].start_s for child in knot.children)])
        if not (knot.ends or knot.children or knot.marks):
            knot.ends = "open"  # the search ended before
    stood_for = _fold(knots)
    return _drawn(knots, roots, stood_for, most)


def _path(knots: list[_Knot], roots: Sequence[int], story: Sequence[Decided]) -> int:
    """Return the knot that a story leads to; what was left out of it makes knots of their own."""
    at = roots[0]
    others = roots if knots[at].decided is not None else knots[at].children
    for decided in story:
        found = next((k for k in others if _same(knots[k].decided, decided)), None)
        if found is None:
            found = len(knots)
            knots.append(_Knot(Branch(at, decided, "")))
            knots[at].children.append(found)
        at, others = found, knots[found].children
    return at


def _same(one: Decided | None, other: Decided) -> bool:
    return (
        one is not None
        and (one.what, one.number, one.value) == (other.what, other.number, other.value)
        and abs(one.time_s - other.time_s) < SAME_S
    )


def _fold(knots: list[_Knot]) -> dict[int, int]:
    """Fold children that are alike into the first of them; return which stands for which."""
    kinds: dict[object, int] = {}
    kind, marked = [0] * len(knots), [False] * len(knots)
    stood_for: dict[int, int] = {}
    for number in range(len(knots) - 1, -1, -1):
        knot = knots[number]
        marked[number] = bool(knot.marks) or any(marked[child] for child in knot.children)
        groups: dict[int, list[int]] = {}
        for child in knot.children:
            groups.setdefault(kind[child], []).append(child)
        kept: list[int] = []
        for alike in groups.values():
            first, *others = alike
            if len(alike) < ALIKE or marked[first]:
                kept += alike
                continue
            knots[first].many = len(alike)
            knots[first].last_s = max(knots[k].start_s for k in alike)
            stood_for.update((other, first) for other in others)
            kept.append(first)
        knot.children = sorted(kept)
        below = tuple(sorted(kind[child] for child in knot.children))
        cause = None if knot.decided is None else knot.decided.cause
        place = None if cause is None else (cause.program, cause.step)
        what = None if knot.decided is None else knot.decided[1:4]
        alone = number if marked[number] else None  # what leads to something wrong is like nothing
        shape = (what, place, knot.ends, below, alone)
        kind[number] = kinds.setdefault(shape, len(kinds))
    return stood_for


def _drawn(
    knots: list[_Knot], roots: Sequence[int], stood_for: dict[int, int], most: int
) -> tuple[Node, ...]:
    """Return the nodes that are drawn: those that lead to what goes wrong, then the nearest."""
    chosen: dict[int, None] = {}
    for number, knot in enumerate(knots):
        at: int | None = number if knot.marks else None
        while at is not None and at not in chosen:
            chosen[at] = None
            at = knots[at].parent
    for number in _breadth_first(knots, roots):
        if len(chosen) >= most:
            break
        chosen[number] = None
    order = [number for number in _breadth_first(knots, roots) if number in chosen]
    place = {number: k for k, number in enumerate(order)}
    found: list[Node] = []
    for number in order:
        knot = knots[number]
        into = knot.into
        while into is not None and into not in place:
            into = stood_for.get(into)
        left = sum(knots[child].size for child in knot.children if child not in place)
        found.append(
            Node(
                None if knot.parent is None else place[knot.parent],
                knot.decided,
                knot.start_s,
                knot.end_s,
                knot.ends,
                None if into is None else place[into],
                knot.many,
                knot.last_s,
                left,
                tuple(knot.marks),
            )
        )
    return tuple(found)


def _breadth_first(knots: list[_Knot], roots: Sequence[int]) -> Iterator[int]:
    level = list(roots)
    while level:
        yield from level
        level = [child for number in level for child in knots[number].children]
