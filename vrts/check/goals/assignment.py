"""Which of several ways is taken by which of several goals: the best sum, exactly.

The method of Kuhn and Munkres with whole numbers of any size, so that no sum is rounded and no tie
is left: of equal sums the one counts in which the first goal has its earliest way, then the second.
"""

from collections.abc import Sequence


def assigned(values: Sequence[Sequence[int]]) -> tuple[int, ...]:
    """Return for every row the column that it takes, no column twice, with the largest sum.

    Args:
        values: Of every row for every column: rows are as long as one another, and no shorter than
            there are rows.
    """
    rows = len(values)
    columns = len(values[0]) if rows else 0
    if rows > columns:
        raise ValueError("more rows than columns")
    base = columns + 1
    size = base**rows  # of the numbers that decide between equal sums
    costs = [
        [-value * size + n * base ** (rows - 1 - k) for n, value in enumerate(row)]
        for k, row in enumerate(values)
    ]
    return _cheapest(costs, columns)


def _cheapest(costs: Sequence[Sequence[int]], columns: int) -> tuple[int, ...]:
    """Return the columns of the smallest sum: shortest ways to a free column, row by row."""
    rows = len(costs)
    of_row, of_column = [0] * (rows + 1), [0] * (columns + 1)  # potentials; 0 is a helper
    owner = [0] * (columns + 1)  # row of a column, from 1; 0: nobody
    for row in range(1, rows + 1):
        owner[0] = row
        column = 0
        least: list[int | None] = [None] * (columns + 1)
        before = [0] * (columns + 1)
        used = [False] * (columns + 1)
        while owner[column]:
            used[column] = True
            k, step, following = owner[column], None, 0
            for n in range(1, columns + 1):
                if used[n]:
                    continue
                reduced = costs[k - 1][n - 1] - of_row[k] - of_column[n]
                known = least[n]
                if known is None or reduced < known:
                    least[n], before[n] = reduced, column
                    known = reduced
                if step is None or known < step:
                    step, following = known, n
            assert step is not None, "there are as many columns as rows"
            for n in range(columns + 1):
                rest = least[n]
                if used[n]:
                    of_row[owner[n]] += step
                    of_column[n] -= step
                elif rest is not None:
                    least[n] = rest - step
            column = following
        while column:
            owner[column] = owner[before[column]]
            column = before[column]
    found = [0] * rows
    for n, row in enumerate(owner[1:]):
        if row:
            found[row - 1] = n
    return tuple(found)
