"""Six linear equations, in plain Python: one system is too small for numpy to pay."""

from collections.abc import Sequence

SMALLEST_PIVOT = 1e-12  # below, equations count as dependent; coefficients are of the order of 1


def solve_linear(
    columns: Sequence[Sequence[float]], wanted: Sequence[Sequence[float]]
) -> list[list[float]] | None:
    """Return x with A x = b for each right-hand side, by elimination with row exchange.

    Args:
        columns: Of the square matrix A.
        wanted: Right-hand sides.

    Returns:
        One x for each right-hand side; None where the equations are dependent.
    """
    size = len(columns)
    rows = [[column[k] for column in columns] + [b[k] for b in wanted] for k in range(size)]
    for k in range(size):
        best = max(range(k, size), key=lambda i: abs(rows[i][k]))
        pivot_row = rows[best]
        pivot = pivot_row[k]
        if abs(pivot) < SMALLEST_PIVOT:
            return None
        rows[best], rows[k] = rows[k], pivot_row
        for i in range(k + 1, size):
            row = rows[i]
            factor = row[k] / pivot
            if factor:
                rows[i] = [a - factor * b for a, b in zip(row, pivot_row, strict=True)]
    found: list[list[float]] = []
    for number in range(size, size + len(wanted)):
        x = [0.0] * size
        for k in range(size - 1, -1, -1):
            row = rows[k]
            x[k] = (row[number] - sum(row[j] * x[j] for j in range(k + 1, size))) / row[k]
        found.append(x)
    return found


def solve_symmetric(
    columns: Sequence[Sequence[float]], wanted: Sequence[float], damping: float
) -> list[float]:
    """Return x with (J^T J + damping I) x = J^T wanted, by Cholesky's factors.

    Args:
        columns: Of J.
        wanted: The right-hand side before J^T.
        damping: Above zero, so that there is a solution.
    """
    size = len(columns)
    lower: list[list[float]] = []
    y: list[float] = []
    for i in range(size):
        a = columns[i]
        row: list[float] = []
        for j in range(i):
            other = lower[j]
            value = sum([p * q for p, q in zip(a, columns[j], strict=True)])
            value -= sum([row[k] * other[k] for k in range(j)])
            row.append(value / other[j])
        square = sum([p * p for p in a]) + damping - sum([p * p for p in row])
        right = sum([p * q for p, q in zip(a, wanted, strict=True)])
        right -= sum([row[k] * y[k] for k in range(i)])
        root = max(square, 0.5 * damping) ** 0.5
        row.append(root)
        lower.append(row)
        y.append(right / root)
    x = [0.0] * size
    for i in range(size - 1, -1, -1):
        x[i] = (y[i] - sum([lower[k][i] * x[k] for k in range(i + 1, size)])) / lower[i][i]
    return x
