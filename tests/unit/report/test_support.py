"""`vrts support` tells the truth: what it calls simulated is, and what it does not is not."""

import json
from pathlib import Path

import pytest

from vrts.cli.support_command import KINDS as OFFERED
from vrts.engine.controller import execute
from vrts.ir.verify import verify
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.report.support import (
    COMPILES,
    KINDS,
    KNOWN,
    OPAQUE,
    RUNS,
    compiled,
    entries,
    function_sample,
    native,
    sample,
)
from vrts.scene.default import robot_alone

NOT_SIMULATED = "V261"
STATES = {entry.word: entry.state for entry in entries(kind="instruction")}
FUNCTION_STATES = {entry.word: entry.state for entry in entries(kind="function")}
LISTED = json.loads((Path(__file__).parents[2] / "data" / "keywords.json").read_text("utf-8"))


def stopped_at(steps: str, dialects: str) -> bool:
    """Whether a run of some steps stops because one of them is not simulated."""
    module = compiled(steps, native(dialects))
    assert module is not None, steps
    assert verify(module) == []
    run = execute(module, robot_alone())
    return any(finding.rule.code == NOT_SIMULATED for finding in run.findings)


@pytest.mark.parametrize("text", sorted(INSTRUCTIONS))
def test_instruction(text: str) -> None:
    word = INSTRUCTIONS[text]
    assert STATES[text] in (RUNS, COMPILES, OPAQUE)
    assert stopped_at(sample(word), word.dialects) is (STATES[text] != RUNS)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_function(name: str) -> None:
    signature = FUNCTIONS[name]
    before = '$s = "a"\n'
    if {"p", "l"} & {code[0] for code in signature.parameters}:
        before += "SET p = NULL\n"
    stops = stopped_at(before + function_sample(signature), signature.dialects)
    assert stops is (FUNCTION_STATES[name.upper()] != RUNS)


def test_words_that_are_never_simulated_say_so_in_the_table() -> None:
    for text, word in INSTRUCTIONS.items():
        if word.opaque:
            assert STATES[text] == OPAQUE


@pytest.mark.parametrize("kind", sorted(LISTED["words"]))
def test_nothing_of_the_reference_is_missing(kind: str) -> None:
    known = {entry.word for entry in entries(kind=kind)}
    assert set(LISTED["words"][kind]) - known == set()


def test_every_word_says_what_it_does() -> None:
    found = entries()
    assert [entry.word for entry in found if not entry.about or not entry.usage] == []
    assert KINDS == OFFERED
    assert {entry.state for entry in found} == {RUNS, COMPILES, OPAQUE, KNOWN}
