"""What the README shows is what its command says."""

import re

from tests.places import ROOT
from tests.unit.cli.test_commands import vrts

SHOWN = re.compile(r"`vrts (verify \S+)` says so.*?```text\n(.*?)```", re.DOTALL)


def test_the_first_report_is_what_the_command_prints() -> None:
    found = SHOWN.search((ROOT / "README.md").read_text("utf-8"))
    assert found is not None
    command, text = found.groups()
    verb, program = command.split()
    printed = vrts(verb, ROOT / program).stdout.decode().replace(f"{ROOT}/", "")
    rows = iter(line.rstrip() for line in printed.splitlines())
    for line in text.splitlines():
        assert any(row == line for row in rows), line  # in this order; the drawing is left out
