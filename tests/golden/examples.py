"""What vrts says about the programs of the examples, short enough to be read by a person."""

import json
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import TypeAlias

from tests.places import ROOT
from vrts.pipeline.assess import assess
from vrts.pipeline.requesting import request_for
from vrts.pipeline.where import Where
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen, status

EXAMPLES = sorted(task.parent for task in (ROOT / "examples").glob("*/task.toml"))

Row: TypeAlias = dict[str, object]


def programs(example: Path) -> list[Path]:
    """Return the solution and every submission, in the order of the file of expected results."""
    return [example / "solution.v2", *sorted((example / "submissions").glob("*.v2"))]


def example_of(path: Path) -> Path:
    """Return the folder of the example that a program belongs to."""
    return next(example for example in EXAMPLES if example in path.parents)


def expected(example: Path) -> dict[str, Row]:
    """Return the rows of the file of expected results."""
    return json.loads((example / "expected.json").read_text(encoding="utf-8"))


def row(a: Assessment) -> Row:
    """Return the mark, the status and what the first screen says."""
    screen = first_screen(a)
    assert a.grade is not None
    return {
        "mark": float(a.grade.mark),
        "status": status(a),
        "ready": screen.ready,
        "message": screen.cause,
        "hint": screen.hint,
        "losses": [f"{float(loss.points):g} {loss.sentence}" for loss in a.grade.losses],
    }


@cache
def assessed(path: Path) -> Assessment:
    """Return what is found of one program of an example, in its task."""
    return assess(request_for(path, Where(task=example_of(path) / "task.toml")))


def mark(path: Path) -> Row:
    """Return the row of one program of an example."""
    return row(assessed(path))


def name(path: Path) -> str:
    """Return how a program is called in the file of expected results."""
    return path.relative_to(example_of(path)).as_posix()


def long_name(path: Path) -> str:
    """Return how a program is called among those of all examples."""
    return path.relative_to(ROOT / "examples").as_posix()


def text(rows: Iterable[tuple[str, Row]]) -> str:
    """Return the file of expected results."""
    return json.dumps(dict(rows), indent=2, ensure_ascii=False) + "\n"
