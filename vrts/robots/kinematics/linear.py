"""Six linear equations, in plain Python: one system is too small for numpy to pay."""

import math
from collections.abc import Sequence

MOST_SWEEPS = 20  # of Jacobi's rotations; six equations need five or six
ROUNDING = 1e-30  # relative, of squares
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


def largest_singular_value(columns: Sequence[Sequence[float]]) -> float:
    """Return the largest singular value of a matrix: the root of the largest eigenvalue of A^T A.

    Jacobi's rotations make A^T A diagonal; they always converge.
    """
    squares, _ = _eigen(columns)
    return math.sqrt(max(squares))


def least_right_vector(columns: Sequence[Sequence[float]]) -> list[float]:
    """Return the unit vector x for which A x is shortest."""
    squares, vectors = _eigen(columns)
    least = min(range(len(squares)), key=squares.__getitem__)
    return [row[least] for row in vectors]


def _eigen(columns: Sequence[Sequence[float]]) -> tuple[list[float], list[list[float]]]:
    """Return eigenvalues of A^T A, and its eigenvectors as the columns of a matrix, by rows."""
    size = len(columns)
    a = [[math.fsum(x * y for x, y in zip(b, c, strict=True)) for c in columns] for b in columns]
    turned = [[float(i == j) for j in range(size)] for i in range(size)]
    for _ in range(MOST_SWEEPS):
        off = math.fsum(a[i][j] * a[i][j] for i in range(size) for j in range(i))
        if off <= ROUNDING * math.fsum(a[i][i] * a[i][i] for i in range(size)):
            break
        for i in range(size - 1):
            for j in range(i + 1, size):
                _rotate(a, turned, i, j)
    return [a[i][i] for i in range(size)], turned


def _rotate(a: list[list[float]], turned: list[list[float]], i: int, j: int) -> None:
    """Turn a symmetric matrix so that one element off its diagonal becomes zero."""
    if a[i][j] == 0.0:
        return
    tau = (a[j][j] - a[i][i]) / (2.0 * a[i][j])
    t = math.copysign(1.0, tau) / (abs(tau) + math.hypot(1.0, tau))
    c = 1.0 / math.hypot(1.0, t)
    s = t * c
    for k in range(len(a)):
        a[k][i], a[k][j] = c * a[k][i] - s * a[k][j], s * a[k][i] + c * a[k][j]
        turned[k][i], turned[k][j] = (
            c * turned[k][i] - s * turned[k][j],
            s * turned[k][i] + c * turned[k][j],
        )
    for k in range(len(a)):
        a[i][k], a[j][k] = c * a[i][k] - s * a[j][k], s * a[i][k] + c * a[j][k]
