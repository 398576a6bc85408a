"""Pairs of convex pieces as arrays: collected union by union, each with its time and its rule."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[np.float64]
Flags: TypeAlias = npt.NDArray[np.bool_]
Indices: TypeAlias = npt.NDArray[np.int64]


class Rule(NamedTuple):
    """How a pair is judged."""

    tolerance: float  # a contact is deeper than this [m]; inf: no contact is looked for
    grazes: bool  # shallower touches are listed
    counts: bool  # enters minimum clearance


class Pairs(NamedTuple):
    """Rows of (solid, solid, interval, rule); arrays of shape (p,)."""

    first: Indices  # of the solids
    second: Indices
    start_s: Array
    end_s: Array
    tolerance: Array  # [m]
    grazes: Flags
    counts: Flags
    group: Indices  # of `Plan.groups`


class _Block(NamedTuple):
    """Every pair of two unions of solids, under one rule for one time."""

    first: tuple[int, ...]
    second: Sequence[int]
    interval: tuple[float, float]
    rule: Rule
    group: int


@dataclass(slots=True)
class Table:
    """Collects pairs. What touches is one event where it has one group: names, and what else."""

    groups: dict[tuple[str, ...], int] = field(default_factory=dict[tuple[str, ...], int])
    blocks: list[_Block] = field(default_factory=list[_Block])
    rigid_blocks: list[_Block] = field(default_factory=list[_Block])

    def add(
        self,
        group: tuple[str, ...],
        first: Iterable[int],
        second: Sequence[int],
        interval: tuple[float, float],
        rule: Rule,
        *,
        rigid: bool = False,
    ) -> None:
        """Add every pair of two unions of solids."""
        start_s, end_s = interval
        if end_s <= start_s:
            return
        number = self.groups.setdefault(group, len(self.groups))
        blocks = self.rigid_blocks if rigid else self.blocks
        blocks.append(_Block(tuple(first), second, interval, rule, number))

    def pairs(self, *, rigid: bool) -> Pairs:
        """Return the pairs as arrays."""
        blocks = self.rigid_blocks if rigid else self.blocks
        sizes = [len(block.first) * len(block.second) for block in blocks]
        first, second = _products(blocks)

        def column(values: Sequence[object], kind: type[np.generic]) -> npt.NDArray[Any]:
            return np.repeat(np.array(values, dtype=kind), sizes)

        return Pairs(
            first,
            second,
            column([block.interval[0] for block in blocks], np.float64),
            column([block.interval[1] for block in blocks], np.float64),
            column([block.rule[0] for block in blocks], np.float64),
            column([block.rule[1] for block in blocks], np.bool_),
            column([block.rule[2] for block in blocks], np.bool_),
            column([block.group for block in blocks], np.int64),
        )


def _products(blocks: Sequence[_Block]) -> tuple[Indices, Indices]:
    """Return the first and the second solid of every pair, block after block."""
    firsts = np.array([i for block in blocks for i in block.first], dtype=np.int64)
    seconds = np.array([j for block in blocks for j in block.second], dtype=np.int64)
    wide = np.array([len(block.second) for block in blocks], dtype=np.int64)
    high = np.array([len(block.first) for block in blocks], dtype=np.int64)
    begins = np.repeat(np.cumsum(wide) - wide, high)  # of the second solids, for every first one
    counts = np.repeat(wide, high)
    along = np.arange(int(counts.sum())) - np.repeat(np.cumsum(counts) - counts, counts)
    return np.repeat(firsts, counts), seconds[np.repeat(begins, counts) + along]
