"""Proposers that are wrong on purpose: no answer of the check may depend on them."""

from collections.abc import Callable
from contextlib import AbstractContextManager, nullcontext
from typing import TypeAlias

import numpy as np

from vrts.geometry.coal_engine import Pair, Transform
from vrts.geometry.nearest import Nearest
from vrts.geometry.proposing.by_coal import ByCoal
from vrts.geometry.proposing.nobody import Nobody
from vrts.geometry.proposing.proposer import Proposals, Proposer, Questions
from vrts.geometry.shapes import Shape
from vrts.marking.proposer.by_fcl import ByFcl

OFF = 0.04  # [m]


class Anywhere:
    """Points anywhere: random directions, now and then of no length, and points metres away."""

    name = "random"

    def __init__(self, seed: int) -> None:
        self._random = np.random.default_rng(seed)

    def propose(self, asked: Questions) -> Proposals:
        count = len(asked.first)
        normal = self._random.normal(size=(count, 3))
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        normal[self._random.random(count) < 0.1] = 0.0
        normal[self._random.random(count) < 0.1] = np.inf
        points = self._random.normal(size=(2, count, 3)) * self._random.choice([1e-3, 1.0, 1e9])
        points[:, self._random.random(count) < 0.1] = np.nan
        return Proposals(normal, points[0], points[1])


class Off(ByCoal):
    """Measures 40 mm too much or too little, in directions that are somewhat wrong."""

    name = "off by 40 mm"

    def __init__(self, seed: int) -> None:
        super().__init__()
        self._random = np.random.default_rng(seed)

    def propose(self, asked: Questions) -> Proposals:
        found = super().propose(asked)
        count = len(asked.first)
        normal = found.normal + self._random.normal(size=(count, 3)) * 0.3
        normal /= np.linalg.norm(normal, axis=1)[:, None]
        shift = self._random.choice([-OFF, OFF], (count, 1)) * found.normal
        return Proposals(normal, found.first, found.second + shift)


class Backward(ByCoal):
    """Names the direction from the second to the first, and swaps their points."""

    name = "backward"

    def propose(self, asked: Questions) -> Proposals:
        normal, first, second = super().propose(asked)
        return Proposals(-normal, second, first)


class _Raising(Pair):
    """Raises what coal raises, every third time."""

    count = 0

    def nearest(self, first: Transform, second: Transform) -> Nearest:
        _Raising.count += 1
        if _Raising.count % 3 == 0:
            raise RuntimeError("no")
        return super().nearest(first, second)


class Raising(ByCoal):
    """Coal that raises within."""

    name = "exceptions"

    def made(self, a: Shape, b: Shape) -> Pair | None:
        return None if super().made(a, b) is None else _Raising(a, b)


class Dying(ByFcl):
    """A child that is killed before every fifth batch, for good in the end."""

    name = "aborts"

    def __init__(self) -> None:
        super().__init__()
        self._batches = 0

    def propose(self, asked: Questions) -> Proposals:
        self._batches += 1
        if self._batches % 5 == 0:
            self.kill()
        return super().propose(asked)


Made: TypeAlias = Callable[[int], AbstractContextManager[Proposer]]

HONEST: dict[str, Made] = {
    "coal": lambda _: nullcontext(ByCoal()),
    "own": lambda _: nullcontext(Nobody()),
    "fcl": lambda _: ByFcl(),
}
LYING: dict[str, Made] = {
    "random": lambda seed: nullcontext(Anywhere(seed)),
    "off": lambda seed: nullcontext(Off(seed)),
    "backward": lambda _: nullcontext(Backward()),
    "exceptions": lambda _: nullcontext(Raising()),
    "aborts": lambda _: Dying(),
}
