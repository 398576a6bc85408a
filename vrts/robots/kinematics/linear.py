"""Six linear equations, in plain Python: one system is too small for numpy to pay."""

import math
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
    columns: Sequence[tuple[float, ...]], wanted: Sequence[float], damping: float
) -> list[float]:
    """Return x with (J^T J + damping I) x = J^T wanted, by Cholesky's factors.

    Written out for six rows: this is most of what numeric inverse kinematics costs.

    Args:
        columns: Of J, each of six numbers.
        wanted: The right-hand side before J^T.
        damping: Above zero, so that there is a solution.
    """
    w0, w1, w2, w3, w4, w5 = wanted
    lower: list[list[float]] = []
    y: list[float] = []
    for i, (a0, a1, a2, a3, a4, a5) in enumerate(columns):
        row: list[float] = []
        for j in range(i):
            b0, b1, b2, b3, b4, b5 = columns[j]
            value = a0 * b0 + a1 * b1 + a2 * b2 + a3 * b3 + a4 * b4 + a5 * b5
            other = lower[j]
            for k in range(j):
                value -= row[k] * other[k]
            row.append(value / other[j])
        square = a0 * a0 + a1 * a1 + a2 * a2 + a3 * a3 + a4 * a4 + a5 * a5 + damping
        right = a0 * w0 + a1 * w1 + a2 * w2 + a3 * w3 + a4 * w4 + a5 * w5
        for entry, known in zip(row, y, strict=True):
            square -= entry * entry
            right -= entry * known
        root = math.sqrt(max(square, 0.5 * damping))
        row.append(root)
        lower.append(row)
        y.append(right / root)
    x = y
    for i in range(len(x) - 1, -1, -1):
        x[i] /= lower[i][i]
        for k in range(i):
            x[k] -= lower[i][k] * x[i]
    return x
