"""Variants without a task, for what asks only which choices there are."""

from collections.abc import Mapping, Sequence

from vrts.base.source import SourceFile, Span
from vrts.check.variants.model import Variants, Vary, Without

NOWHERE = Span(SourceFile("task.toml", "x"), 0, 1)


def variants(
    counts: Sequence[int], without: Sequence[Mapping[int, frozenset[int]]] = ()
) -> Variants:
    """Return variants with so many choices of each."""
    varies = tuple(
        Vary(f"v{k}", (f"scene.v{k}",), tuple((str(c),) for c in range(n)), NOWHERE, (NOWHERE,))
        for k, n in enumerate(counts)
    )
    return Variants("test", varies, tuple(map(Without, without)), (), NOWHERE)
