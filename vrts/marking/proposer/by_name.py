"""Who proposes, and who gives the second opinion, by the name that `--engine` takes."""

from collections.abc import Generator
from contextlib import contextmanager
from typing import Final, NamedTuple

from vrts.geometry.proposing.choose import coal_itself, here
from vrts.geometry.proposing.nobody import OWN, Nobody
from vrts.geometry.proposing.proposer import Proposer
from vrts.marking.proposer.by_fcl import FCL, ByFcl

COAL: Final = "coal"
ENGINES: Final = (COAL, FCL, OWN)


class By(NamedTuple):
    """Whom a check asks; nothing that they say decides anything."""

    proposer: Proposer | None = None  # None: the best of this process
    second: Proposer | None = None  # gives a second opinion; None: nobody


ALONE: Final = By()


@contextmanager
def by_name(engine: str | None, *, asked: bool = True, kept: str | None = None) -> Generator[By]:
    """Give whom to ask; a child starts at once, loads beside us, and ends with the block.

    Args:
        engine: "coal", "fcl", "own", or None for the best of this process. fcl gives the second
            opinion about what others propose.
        asked: Whether anything will be asked at all.
        kept: Address of a child that gives second opinions to many processes; None: there is none.

    Raises:
        ImportError: coal is asked for and not installed.
    """
    if not asked:
        yield ALONE
        return
    made = {None: here, COAL: coal_itself, OWN: Nobody}
    ours = None if engine == FCL else made[engine]()
    with ByFcl(kept=None if ours is None else kept) as fcl:
        yield By(fcl, None) if ours is None else By(ours, fcl)
