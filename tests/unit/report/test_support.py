"""`vrts support` tells the truth: what it calls simulated is, and what it does not is not."""

import json
import re

import pytest

from tests.places import TESTS
from vrts.cli.language.support_command import KINDS as OFFERED
from vrts.engine.controller import execute
from vrts.ir.system import PARAMETERS, SWITCHES
from vrts.ir.taken import TAKEN_PARAMETERS, TAKEN_SWITCHES
from vrts.ir.verify import verify
from vrts.lang.vocabulary.functions import CONSTANTS, FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS
from vrts.lang.vocabulary.word import Word
from vrts.lang.vocabulary.words import OPERATORS, QUALIFIERS
from vrts.report.support import COMPILES, OPAQUE, RUNS, entries
from vrts.report.word_samples import (
    COMPANY,
    NATIVE,
    compiled,
    function_sample,
    home,
    instruction_sample,
    operator_sample,
    parameter_sample,
    qualifier_sample,
    switch_sample,
)
from vrts.scene.default import robot_alone

NOT_SIMULATED = "V261"
STATES = {entry.word: entry.state for entry in entries(kind="instruction")}
FUNCTION_STATES = {entry.word: entry.state for entry in entries(kind="function")}
LISTED = json.loads((TESTS / "data" / "keywords.json").read_text("utf-8"))


def stopped_at(steps: str, dialects: str) -> bool:
    """Whether a run of some steps stops because one of them is not simulated."""
    module = compiled(steps, home(steps, dialects))
    assert module is not None, steps
    assert verify(module) == []
    run = execute(module, robot_alone())
    return any(finding.rule.code == NOT_SIMULATED for finding in run.findings)


@pytest.mark.parametrize("text", sorted(INSTRUCTIONS))
def test_instruction(text: str) -> None:
    word = INSTRUCTIONS[text]
    assert STATES[text] in (RUNS, COMPILES, OPAQUE)
    assert stopped_at(instruction_sample(word), word.dialects) is (STATES[text] != RUNS)


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_function(name: str) -> None:
    signature = FUNCTIONS[name]
    before = '$s = "a"\n'
    if {"p", "l"} & {code[0] for code in signature.parameters}:
        before += f"{'POINT' if signature.dialects == 'a' else 'SET'} p = NULL\n"
    stops = stopped_at(before + function_sample(signature), signature.dialects)
    assert stops is (FUNCTION_STATES[name.upper()] != RUNS)


PARTS = [
    *(
        ("qualifier", word.text, qualifier_sample(word), word.dialects)
        for word in QUALIFIERS.values()
    ),
    *(("operator", word.text, operator_sample(word), word.dialects) for word in OPERATORS.values()),
    *(("constant", name.upper(), f"x = {name}", "2") for name in CONSTANTS),
    *(("switch", name, switch_sample(name), "2") for name in SWITCHES),
    *(("parameter", name, parameter_sample(name), "2") for name in PARAMETERS),
    *(
        ("switch", name, switch_sample(name, dialects), dialects)
        for name, dialects in TAKEN_SWITCHES.items()
    ),
    *(
        ("parameter", name, parameter_sample(name), dialects)
        for name, dialects in TAKEN_PARAMETERS.items()
    ),
]


@pytest.mark.parametrize(("kind", "text", "steps", "dialects"), PARTS)
def test_parts_of_steps(kind: str, text: str, steps: str, dialects: str) -> None:
    (entry,) = [entry for entry in entries(kind=kind) if entry.word == text]
    assert re.search(rf"(?i)(?<![\w.]){re.escape(text)}(?![\w.])", steps)
    assert stopped_at(f"n = 1\n{steps}", dialects) is (entry.state != RUNS)


@pytest.mark.parametrize("word", INSTRUCTIONS.values(), ids=lambda word: word.text)
def test_usage_compiles_where_the_word_exists(word: Word) -> None:
    """As it is printed, or with the steps around it without which it is no program.

    `...` says that there may be more of the last operand.
    """
    homes = [dialect for letter, dialect in NATIVE.items() if letter in word.dialects]
    steps = COMPANY.get(word.text, word.usage.replace(", ...", ""))
    assert any(compiled(steps, dialect) is not None for dialect in homes)


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
    assert [entry.word for entry in found if "an instruction of" in entry.about] == []
    assert tuple(dict.fromkeys(entry.kind for entry in found)) == OFFERED
    assert {entry.state for entry in found} == {RUNS, OPAQUE}


def test_everything_that_compiles_is_carried_out_or_never_will_be() -> None:
    waiting = [(e.kind, e.word) for e in entries() if e.state == COMPILES]
    assert waiting == []
