"""How large an edit is said to be, beside the measure that the mutants are made with."""

from pathlib import Path

import pytest

from tests.golden.examples import EXAMPLES
from tests.mutants.measure import size
from vrts.base.source import SourceFile
from vrts.repair.nodes import nodes_of_row, nodes_of_step
from vrts.repair.written import read, without_comments


@pytest.mark.parametrize("example", EXAMPLES[:4], ids=lambda path: path.name)
def test_a_step_or_row_has_as_many_nodes_as_the_measure_says(example: Path) -> None:
    text = (example / "solution.v2").read_text()
    written = read(SourceFile("p.v2", text))
    lines = text.splitlines(keepends=True)
    for step in written.steps:
        left = "".join(lines[: step.line - 1] + lines[step.line :])
        assert size(text, left) == nodes_of_step(step.statement), step.text
    for row in written.rows:
        left = "".join(lines[: row.line - 1] + lines[row.line :])
        assert size(text, left) == nodes_of_row(row.node)


def test_lines_stay_where_they_are_without_comments() -> None:
    text = '; a\nTYPE "a;b" ; c\n\nREADY\n'
    assert without_comments(text) == '\nTYPE "a;b"\n\nREADY\n'
