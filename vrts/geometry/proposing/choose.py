"""The proposer of this process: coal where it can be imported, else nobody."""

from importlib.util import find_spec

from vrts.geometry.proposing.nobody import Nobody
from vrts.geometry.proposing.proposer import Proposer


def here() -> Proposer:
    """Return the best proposer that can do no harm to this process."""
    return Nobody() if find_spec("coal") is None else coal_itself()


def coal_itself() -> Proposer:
    """Return coal.

    Raises:
        ImportError: It is not installed.
    """
    from vrts.geometry.proposing.by_coal import ByCoal  # optional: there is no wheel for Windows

    return ByCoal()
