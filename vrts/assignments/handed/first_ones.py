"""The first findings of a kind, and how many more there are: a page may hold ten thousands."""

from collections.abc import Iterable, Iterator
from itertools import islice

from vrts.base.diagnostic import Diagnostic, warning

MOST = 20  # that are told
COUNTED = 1000  # more that are counted


def first_ones(found: Iterable[Diagnostic], what: str) -> Iterator[Diagnostic]:
    """Yield the first findings, and one that says how many more there are.

    Args:
        found: Findings of one rule; those behind the counted ones are not looked for.
        what: One of them in words, as in "sentence".
    """
    each = iter(found)
    last = None
    for last in islice(each, MOST):
        yield last
    more = sum(1 for _ in islice(each, COUNTED))
    if last is not None and more:
        count = f"{more:,} or more" if more == COUNTED else f"{more:,} more"
        yield warning(
            last.rule,
            f"there are {count} {what}{'' if more == 1 else 's'} like these",
            help=("look at the first ones; the others may have the same cause",),
        )
