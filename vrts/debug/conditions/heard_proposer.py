"""A proposer of distances that lets somebody be heard: so a check of collisions can be ended."""

from vrts.debug.conditions.hearing import Hear
from vrts.geometry.proposing.choose import here
from vrts.geometry.proposing.proposer import Proposals, Questions


class HeardProposer:
    """The best proposer there is here; before each answer it looks whether anybody still waits.

    A check asks again and again. Whoever wants no answer any more raises `Interrupted` through it.
    """

    def __init__(self, hear: Hear) -> None:
        """Take who is heard."""
        self._hear, self._best = hear, here()

    @property
    def name(self) -> str:
        """How reports call it: as the one that answers."""
        return self._best.name

    def propose(self, asked: Questions) -> Proposals:
        """Return what the other proposes.

        Raises:
            Interrupted: Somebody wants no answer any more.
        """
        self._hear()
        return self._best.propose(asked)
