"""Points as they are shown: hundredths that add up to the mark, without a row for the rounding.

The mark is rounded once, to a tenth. Rows that are shown beside it are rounded with it: first those
that are no tenths themselves, always the one that is farthest from what it is.
"""

from collections.abc import Sequence
from fractions import Fraction

HUNDREDTH = Fraction(1, 100)
TENTH = Fraction(1, 10)


def apportioned(
    exact: Sequence[Fraction],
    total: Fraction,
    *,
    most: Sequence[Fraction | None] | None = None,
    fixed: Sequence[bool] | None = None,
) -> tuple[Fraction, ...]:
    """Return amounts in hundredths that add up to a total; what is 0 stays 0.

    Args:
        exact: The amounts; those that cost are negative.
        total: A multiple of a hundredth, near their sum.
        most: Beside them, what each may be shown as at most; None: there is no bound.
        fixed: Beside them, whether it is shown as it is.

    Raises:
        ValueError: There is no way.
    """
    left = int(total / HUNDREDTH)
    if Fraction(left) != total / HUNDREDTH:
        raise ValueError(f"{total} is no number of hundredths")
    bounds = most or [None] * len(exact)
    highest = [_highest(a, bound) for a, bound in zip(exact, bounds, strict=True)]
    shown = [
        count if bound is None else min(count, bound)
        for count, bound in zip([round(a / HUNDREDTH) for a in exact], highest, strict=True)
    ]
    kept = fixed or [False] * len(exact)
    left -= sum(shown)
    step = 1 if left > 0 else -1
    while left:
        rows = [
            k
            for k, amount in enumerate(exact)
            if amount and not kept[k] and _may_be(shown[k] + step, amount, highest[k])
        ]
        odd = [k for k in rows if exact[k] % TENTH] or rows
        if not odd:
            raise ValueError(f"nothing adds up to {total}")
        k = max(odd, key=lambda row: (step * (exact[row] / HUNDREDTH - shown[row]), -row))
        shown[k] += step
        left -= step
    return tuple(count * HUNDREDTH for count in shown)


def _highest(amount: Fraction, bound: Fraction | None) -> int | None:
    if amount < 0:
        return 0
    return None if bound is None else int(bound / HUNDREDTH)


def _may_be(count: int, amount: Fraction, highest: int | None) -> bool:
    """Return whether an amount may be shown as a number of hundredths: it keeps its sign."""
    if amount > 0 > count:
        return False
    return highest is None or count <= highest
