"""What vrts says about the programs of the first example, short enough to be read by a person."""

import json
from collections.abc import Iterable
from pathlib import Path
from typing import TypeAlias

from vrts.pipeline import assess
from vrts.report.assessment import Assessment
from vrts.report.first_screen import first_screen, status

ROOT = Path(__file__).parent.parent.parent
EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
EXPECTED = EXAMPLE / "expected.json"

Row: TypeAlias = dict[str, object]


def programs() -> list[Path]:
    """Return the solution and every submission, in the order of the file of expected results."""
    return [EXAMPLE / "solution.v2", *sorted((EXAMPLE / "submissions").glob("*.v2"))]


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


def mark(path: Path) -> Row:
    """Return the row of one program of the example."""
    return row(assess(path, task=EXAMPLE / "task.toml"))


def name(path: Path) -> str:
    """Return how a program is called in the file of expected results."""
    return path.relative_to(EXAMPLE).as_posix()


def text(rows: Iterable[tuple[str, Row]]) -> str:
    """Return the file of expected results."""
    return json.dumps(dict(rows), indent=2, ensure_ascii=False) + "\n"
