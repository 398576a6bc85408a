"""Commands of the monitor go through the grammar of programs."""

import pytest

from vrts.base.source import SourceFile
from vrts.ir.commands import Command, Execute
from vrts.lang.typed.execute_line import parse_command


@pytest.mark.parametrize(
    ("text", "command"),
    [
        ("EXECUTE main", Execute("main")),
        ("ex Main, 3", Execute("main", 3)),
        ("EXECUTE main,,5", Execute("main", 1, 5)),
        ("EXECUTE main, -1", Execute("main", -1)),
    ],
)
def test_command(text: str, command: Command) -> None:
    assert parse_command(SourceFile("monitor", text)) == (command, ())


@pytest.mark.parametrize("text", ["MOVE part", "EXECUTE", "EXECUTE 5", "EXECUTE a, b", "x"])
def test_what_is_no_command_is_one_diagnostic(text: str) -> None:
    command, diagnostics = parse_command(SourceFile("monitor", text))
    assert command is None
    assert len([d for d in diagnostics if d.is_error]) == 1
