"""Everybody who may propose where shapes are nearest: honest, absent, lying."""

from collections.abc import Callable, Mapping

import numpy as np
import numpy.typing as npt

from vrts.geometry.proposing.by_coal import ByCoal
from vrts.geometry.proposing.nobody import Nobody
from vrts.geometry.proposing.proposer import Proposals, Proposer, Questions
from vrts.geometry.support import farthest


class Liar:
    """Names random directions, and points up to 40 mm off; says nothing at all now and then."""

    name = "liar"

    def __init__(self, seed: int = 0) -> None:
        self.chance = np.random.default_rng(seed)

    def propose(self, asked: Questions) -> Proposals:
        count = len(asked.first)
        normal = self._ways(count)
        normal[self.chance.random(count) < 0.1] = np.nan
        first = asked.origin_a + 0.04 * self._ways(count)
        second = asked.origin_b + 0.04 * self._ways(count)
        return Proposals(normal, first, second)

    def _ways(self, count: int) -> npt.NDArray[np.float64]:
        ways = self.chance.normal(size=(count, 3))
        return ways / np.linalg.norm(ways, axis=1, keepdims=True)


class Off(Liar):
    """Knows better, turns directions by half a radian or so, and moves points by 40 mm."""

    name = "off"

    def __init__(self, seed: int = 0) -> None:
        super().__init__(seed)
        self.honest = ByCoal()

    def propose(self, asked: Questions) -> Proposals:
        normal, first, second = self.honest.propose(asked)
        count = len(asked.first)
        normal = normal + 0.5 * self._ways(count)
        normal /= np.linalg.norm(normal, axis=1, keepdims=True)
        return Proposals(normal, first + 0.04 * self._ways(count), second + 0.04 * normal)


class Plausible(Liar):
    """Names random directions, and points whose distance is just what the direction shows."""

    name = "plausible"

    def propose(self, asked: Questions) -> Proposals:
        normal = self._ways(len(asked.first))
        found = Proposals(normal, np.empty_like(normal), np.empty_like(normal))
        places = zip(
            asked.rotation_a, asked.origin_a, asked.rotation_b, asked.origin_b, strict=True
        )
        for k, (R_a, o_a, R_b, o_b) in enumerate(places):
            n = normal[k]
            found.first[k] = o_a + R_a @ np.array(farthest(asked.first[k], tuple(R_a.T @ n)))
            found.second[k] = o_b + R_b @ np.array(farthest(asked.second[k], tuple(-R_b.T @ n)))
        return found


PROPOSERS: Mapping[str, Callable[[], Proposer]] = {
    "coal": ByCoal,
    "own": Nobody,
    "liar": Liar,
    "off": Off,
    "plausible": Plausible,
}
