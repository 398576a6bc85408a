"""Statistics in the words of their JSON. Points and marks as numbers; null where there is none."""

from msgspec import Struct

from vrts.desk.told import CauseTold


class Bar(Struct, frozen=True, rename={"from_": "from"}):
    """How many values lie from one number to another; the last bar holds its end, too."""

    from_: float
    to: float
    count: int


class CheckFigures(Struct, frozen=True):
    """One check over the class."""

    id: str
    title: str
    most: float
    count: int  # programs that it was made on
    mean: float
    full: int  # that lost nothing by it
    none: int  # that got nothing, or paid, by it
    discrimination: float | None
    histogram: tuple[Bar, ...]


class AttemptFigures(Struct, frozen=True):
    """Marks of those who handed in so many times, or of their attempts of this number."""

    number: int
    count: int
    mean: float | None
    median: float | None


class GraderFigures(Struct, frozen=True):
    """What a grader has done."""

    who: str
    rows: int  # assigned
    finished: int
    mean: float | None  # of the marks that the grader would give


class Double(Struct, frozen=True):
    """A row that several graders have finished."""

    student: str
    marks: dict[str, float | None]
    difference: float | None


class Statistics(Struct, frozen=True):
    """The class in numbers."""

    marks: tuple[Bar, ...]
    mean: float | None
    median: float | None
    checks: tuple[CheckFigures, ...]
    causes: tuple[CauseTold, ...]
    attempts: tuple[AttemptFigures, ...]  # final marks by how often somebody handed in
    progress: tuple[AttemptFigures, ...]  # computed marks of first, second … attempts; or nothing
    graders: tuple[GraderFigures, ...]
    double: tuple[Double, ...]
