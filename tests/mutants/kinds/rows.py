"""Mistakes in rows of .LOCATIONS: numbers measured, copied or typed wrongly."""

from collections.abc import Callable
from random import Random

from tests.mutants.kinds.sites import Kind, locations, of, put
from tests.mutants.reading import Written
from vrts.lang.syntax.expressions import Name, Number
from vrts.lang.syntax.program import DataLine

X, Y, Z, O, A, T = range(6)  # noqa: E741 - VAL's own letters
INCH = 25.4


def sign(written: Written, chance: Random) -> str | None:
    """A number of the wrong sign."""
    return _one(written, chance, range(6), lambda v: -v)


def digit(written: Written, chance: Random) -> str | None:
    """One digit typed wrongly, or two beside each other exchanged."""

    def mistyped(value: float) -> float:
        letters = list(f"{abs(value):.2f}")
        whole = letters.index(".")
        at = chance.randrange(min(whole, 2))
        if chance.random() < 0.4 and at + 1 < whole:
            letters[at], letters[at + 1] = letters[at + 1], letters[at]
        else:
            letters[at] = str((int(letters[at]) + chance.choice((1, 2, 3, 7, 8, 9))) % 10)
        return float("".join(letters)) * (-1 if value < 0 else 1)

    return _one(written, chance, range(6), mistyped)


def tenfold(written: Written, chance: Random) -> str | None:
    """A number ten times too large or too small: the point slipped, or centimetres were read."""
    factor = chance.choice((10.0, 0.1, 0.1))
    return _one(written, chance, (X, Y, Z), lambda v: v * factor)


def inch(written: Written, chance: Random) -> str | None:
    """One number in inches."""
    return _one(written, chance, (X, Y, Z), lambda v: v / INCH)


def inch_row(written: Written, chance: Random) -> str | None:
    """A row measured in inches."""
    row = of(chance, locations(written))
    return row and put(written.text, *(_number(row, k, _at(row, k) / INCH) for k in (X, Y, Z)))


def x_and_y(written: Written, chance: Random) -> str | None:
    """X and Y exchanged."""
    return _exchanged(written, chance, [(X, Y)])


def y_and_z(written: Written, chance: Random) -> str | None:
    """Two lengths exchanged, one of them the height."""
    return _exchanged(written, chance, [(Y, Z), (X, Z)])


def angles(written: Written, chance: Random) -> str | None:
    """Two of the angles O, A and T exchanged."""
    return _exchanged(written, chance, [(O, T), (A, T), (O, A)])


def angle(written: Written, chance: Random) -> str | None:
    """One angle wrong: of another quarter, or some degrees off."""

    def turned(value: float) -> float:
        off = chance.choice((-30, -20, -15, -10, 10, 15, 20, 30))
        return chance.choice((0.0, -90.0, 180.0, 45.0, value + off, value + off))

    return _one(written, chance, (O, A, T), turned, zero=True)


def height(written: Written, chance: Random) -> str | None:
    """A location too high or too low."""
    off = chance.choice((10, 15, 20, 25, 30, 40, 50, 60, 80, 100, 115)) * chance.choice((-1, 1))
    return _one(written, chance, (Z,), lambda v: v + off, zero=True)


def aside(written: Written, chance: Random) -> str | None:
    """A location beside where it should be: a wrong edge or another point was measured."""
    off = chance.choice((12, 15, 20, 25, 30, 35, 40, 50, 60, 80, 100)) * chance.choice((-1, 1))
    return _one(written, chance, (X, Y), lambda v: v + off, zero=True)


def copied_row(written: Written, chance: Random) -> str | None:
    """A row copied from another, of which one or more lengths were not changed."""
    rows = locations(written)
    row = of(chance, rows)
    other = of(chance, rows)
    if row is None or other is None:
        return None
    kept = chance.choice(((X,), (Y,), (Z,), (X, Y), (X, Y, Z)))
    return put(written.text, *(_number(row, k, _at(other, k)) for k in kept))


def exchanged_rows(written: Written, chance: Random) -> str | None:
    """The names of two rows exchanged."""
    rows = [row for row in locations(written) if isinstance(row.target, Name)]
    if len(rows) < 2:
        return None
    one, two = chance.sample(rows, 2)
    return put(written.text, _named(written, one, two), _named(written, two, one))


def missing_row(written: Written, chance: Random) -> str | None:
    """A row that was never written."""
    rows = [row for row in written.rows if row.kind == "locations"]
    row = of(chance, rows)
    if row is None:
        return None
    lines = written.lines
    del lines[row.line - 1]
    return "".join(f"{line}\n" for line in lines)


def _named(written: Written, row: DataLine, other: DataLine) -> tuple[int, int, str]:
    """Return the change that gives a row the name of another, its numbers kept in their columns."""
    start = row.values[0].start
    name = written.text[other.target.start : other.target.end]
    return row.target.start, start, name.ljust(max(start - row.target.start, len(name) + 1))


def _at(row: DataLine, k: int) -> float:
    """Return a number of a row as it is written: in mm or degrees."""
    value = row.values[k]
    return value.value if isinstance(value, Number) else 0.0


def _number(row: DataLine, k: int, value: float) -> tuple[int, int, str]:
    """Return the change that writes another number, its last digit in the same column."""
    start, end = row.values[k].start, row.values[k].end
    return start, end, f"{round(value, 2) + 0.0:.2f}".rjust(end - start)


def _one(
    written: Written,
    chance: Random,
    places: range | tuple[int, ...],
    wrong: Callable[[float], float],
    *,
    zero: bool = False,
) -> str | None:
    """Return the text with one number wrong; numbers that are 0 are taken only where asked."""
    sites = [(row, k) for row in locations(written) for k in places if zero or _at(row, k) != 0]
    site = of(chance, sites)
    if site is None:
        return None
    row, k = site
    return put(written.text, _number(row, k, wrong(_at(row, k))))


def _exchanged(written: Written, chance: Random, pairs: list[tuple[int, int]]) -> str | None:
    sites = [
        (row, j, k) for row in locations(written) for j, k in pairs if _at(row, j) != _at(row, k)
    ]
    site = of(chance, sites)
    if site is None:
        return None
    row, j, k = site
    return put(written.text, _number(row, j, _at(row, k)), _number(row, k, _at(row, j)))


ROWS: dict[str, Kind] = {
    "sign": sign,
    "digit": digit,
    "tenfold": tenfold,
    "inch": inch,
    "inch-row": inch_row,
    "x-and-y": x_and_y,
    "y-and-z": y_and_z,
    "angles-exchanged": angles,
    "angle": angle,
    "height": height,
    "aside": aside,
    "copied-row": copied_row,
    "exchanged-rows": exchanged_rows,
    "missing-row": missing_row,
}
