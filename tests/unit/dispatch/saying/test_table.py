"""The table of signals and pins: written, edited, read."""

import pytest

from vrts.base.source import SourceFile
from vrts.dispatch.saying.table import read_table, table_text, usual
from vrts.pipeline.refused import Refused


def test_what_is_written_is_read() -> None:
    table = usual([1003, 1001], [4, 1])
    assert table.inputs == {1001: 0, 1003: 1}
    assert table.outputs == {1: 2, 4: 3}  # behind those of the hand
    assert read_table(SourceFile("io.toml", table_text(table, "pin", "NN of {}"))) == table


@pytest.mark.parametrize(
    ("text", "code", "says"),
    [
        ("[hand]\nopen = 0\nclose = 0\n", "V871", "pin 0 stands for `open` and `close`"),
        ("[hand]\nopen = 0\nclose = 1\n[outputs]\n1 = 1\n", "V871", "`close` and `1`"),
        ("[hand]\nopen = 0\nclose = 1\n[inputs]\nleft = 3\n", "V871", "`left` is no number"),
        ("[hand]\nopen = 0\nclose = 1\n[inputs]\n1001 = 62\n", "V605", "1001"),
        ("[inputs]\n1001 = 0\n", "V603", "hand"),
    ],
)
def test_what_is_wrong_is_told_with_its_place(text: str, code: str, says: str) -> None:
    with pytest.raises(Refused) as refused:
        read_table(SourceFile("io.toml", text))
    found = refused.value.diagnostics[0]
    assert says in found.headline
    assert found.primary is not None
    assert found.rule.code == code
