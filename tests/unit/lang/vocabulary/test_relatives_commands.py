"""Commands of the monitors of V+ and AS: what they are is known, and said."""

import pytest

from tests.support_words import listed
from vrts.base.source import SourceFile
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import AS, DIALECTS, VAL2, VPLUS, Dialect
from vrts.lang.typed.commands import read_command
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.lang.vocabulary.relatives_commands import COMMANDS_OF, commands_of


@pytest.mark.parametrize("dialect", ["vplus", "as"])
def test_every_command_of_a_published_list_is_known(dialect: str) -> None:
    words = {word.word for word in listed(dialect) if word.kind == "command"}
    assert words - COMMANDS.keys() - commands_of(DIALECTS[dialect]).keys() == set()


def test_none_is_a_command_of_val2() -> None:
    assert [word for words in COMMANDS_OF.values() for word in words if word in COMMANDS] == []


@pytest.mark.parametrize(
    ("dialect", "step"),
    [
        (AS, "SAVE/P main = pick"),
        (AS, "ERESET"),
        (AS, "USB_SAVE/ALLLOG"),
        (AS, "STPNEXT"),
        (VPLUS, "STOREM disk = pick"),
        (VPLUS, "SRV.NET"),
        (VPLUS, "STORE disk = pick"),
    ],
)
def test_a_command_in_a_program_is_told_to_be_one(dialect: Dialect, step: str) -> None:
    source = SourceFile("main", f".PROGRAM main()\n{step}\n.END\n")
    found = [d for d in compile_source(source, Options(dialect)).diagnostics if d.is_error]
    assert [d.rule.code for d in found] == ["V149"]
    assert "command for the monitor, not a step" in found[0].headline


@pytest.mark.parametrize(
    ("line", "whose"), [("ERESET", "AS"), ("SAVE/P x", "AS"), ("STOREM a", "V+"), ("BITS 1", "V+")]
)
def test_who_types_one_is_told_whose_it_is(line: str, whose: str) -> None:
    _, found = read_command(SourceFile("<terminal>", line), VAL2)
    assert [d.rule.code for d in found] == ["V520"]
    assert f"a command of {whose}" in found[0].headline
