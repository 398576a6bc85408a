"""No proposals at all: our own search for the nearest points starts from the shapes alone."""

import numpy as np

from vrts.geometry.proposing.proposer import Proposals, Questions

OWN = "own"


class Nobody:
    """Answers nothing."""

    name: str = OWN

    def propose(self, asked: Questions) -> Proposals:
        """Return NaN for each question."""
        return nothing(len(asked.first))


def nothing(count: int) -> Proposals:
    """Return the answers of somebody who knows none."""
    return Proposals(*(np.full((count, 3), np.nan) for _ in range(3)))
