"""The list of all that may leave for a controller."""

import ast
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import vrts.dispatch
from tests.support_emulator import CARGO, Watched, Wire, profile, sending, talk_over
from vrts.base.source import SourceFile
from vrts.dispatch.allowed import VERBS, Prompt, permits
from vrts.dispatch.transfer.held.looking import Options
from vrts.lang.dialect import VAL2
from vrts.lang.typed.commands import read_command
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.lang.vocabulary.lookup import spellings
from vrts.pipeline.refused import Refused

PACKAGE = Path(vrts.dispatch.__file__).parent
AT_COMMANDS = (Prompt.READY, Prompt.RUNNING)
HARMLESS = {"STATUS", "DIRECTORY", "EDIT", "POINT", "LISTP", "LISTL", "LISTR", "LISTS", "DELETEP"}


def test_of_all_commands_of_the_monitor_only_these_are_sent() -> None:
    sent = {word for word in COMMANDS if permits(f"{word} a", Prompt.READY)}
    assert sent == HARMLESS
    assert {verb.replace("/", "") for verb in VERBS} == HARMLESS


@pytest.mark.parametrize("prompt", AT_COMMANDS)
@pytest.mark.parametrize(
    "line",
    [
        *("EXECUTE pick", "EX pick", "DO READY", "CALIBRATE", "ENABLE POWER", "PROCEED", "RETRY"),
        *(
            "SPEED 100",
            "LOAD pick",
            "STORE pick",
            "ZERO",
            "BASE 1",
            "HERE a",
            "SIGNAL 1",
            "PCEXECUTE p",
        ),
        *(
            "POINT a = HERE",
            "POINT a = b",
            "LISTR a+1",
            "EDIT a;EXECUTE b",
            "status",
            " STATUS",
            "Y",
        ),
        *(
            "STATUS\r",
            "STATUS\rEXECUTE a",
            "EDIT a\nb",
            "\x03",
            "LISTP é",
            "LISTP(a)",
            "E",
            "I",
            "RESET",
        ),
    ],
)
def test_nothing_else_is_a_command_that_is_sent(line: str, prompt: Prompt) -> None:
    assert not permits(line, prompt)


def test_while_a_program_runs_only_listings_are_asked_for() -> None:
    sent = {word for word in COMMANDS if permits(f"{word} a", Prompt.RUNNING)}
    assert sent == {"STATUS", "LISTP", "LISTL", "LISTR", "LISTS"}


WORDS = st.sampled_from(sorted({*COMMANDS, *spellings(VAL2)}))
PIECES = st.lists(
    st.sampled_from([" ", ",", "a", "b.c[1]", "2", "(n)", "#p", "$s", "=", "HERE", ";", "/P", ":"]),
    max_size=5,
)


@given(st.sampled_from(AT_COMMANDS), WORDS, PIECES)
def test_what_is_permitted_is_read_as_a_harmless_command(
    prompt: Prompt, word: str, pieces: list[str]
) -> None:
    line = " ".join([word, *pieces])
    if permits(line, prompt):
        command, _ = read_command(SourceFile("line", line), VAL2)
        assert command is None or command.word.text in HARMLESS


@pytest.mark.parametrize(
    ("line", "permitted"), [("Y", True), ("", True), ("N", False), ("YES", False)]
)
def test_questions_are_answered_with_yes_or_return(line: str, permitted: bool) -> None:
    assert permits(line, Prompt.CONFIRM) is permitted


@pytest.mark.parametrize(
    "line", ["1,2,3", "1,2,3,4,5,6,7", "READY", "1,2,3,4,5,1E9", "1 2 3 4 5 6"]
)
def test_a_location_gets_six_numbers(line: str) -> None:
    assert permits("-1.50,2,3,90.000,-90,0", Prompt.CHANGE)
    assert not permits(line, Prompt.CHANGE)


def test_one_place_sends_and_one_place_decides() -> None:
    """Bytes go to the wire in `Talk._write` alone; lines reach it behind `permits`."""
    writes = [
        (path.name, node.lineno)
        for path in PACKAGE.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text()))
        if isinstance(node, ast.Attribute) and node.attr == "write" and "wire" in ast.unparse(node)
    ]
    assert [name for name, _ in writes] == ["talk.py"]


def test_whatever_is_done_only_listed_lines_arrive(tmp_path: Path) -> None:
    known = profile()
    machine = Watched(tmp_path, known)
    for options in (Options(), Options(resume=True), Options(replace=True)):
        machine.type("EDIT pick, 3", "OPENI", "E")
        try:
            sending(talk_over(Wire(machine), known), known, CARGO, options).run()
        except Refused:
            assert not options.replace
    commands = [line for prompt, line in machine.lines if prompt == "."]
    assert {line.split(" ")[0] for line in commands} == {*HARMLESS, ""} - {
        "DIRECTORY",
        "LISTR",
        "LISTS",
    }
    assert not machine.dialogue.state.robot
