"""Every word of the language has its place in the manual, with an example that was executed."""

import re
from functools import cache

import pytest

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.report.support import RUNS, Entry, entries
from vrts.scene.default import robot_alone
from vrts.site.generated.cheat_sheet import GROUPS, PROGRAM, cheat_sheet, members
from vrts.site.generated.rules import about, rules_of
from vrts.site.generated.word_examples import Cases, all_cases, case_of, dialogue_of, sample_program
from vrts.site.generated.word_pages import form, has_section, label_of, page_of, word_pages

SPEC = ROOT / "tests" / "spec"
MANUAL = ROOT / "vrts" / "manual"


@cache
def cases() -> Cases:
    return all_cases(SPEC)


@cache
def everything() -> tuple[Entry, ...]:
    return entries()


@cache
def pages() -> dict[str, str]:
    return word_pages(MANUAL, SPEC)


def test_every_word_stands_in_the_list_and_on_its_page() -> None:
    index = pages()["index"]
    for entry in everything():
        word = re.sub(r"([$#_*])", r"\\\1", entry.word)
        assert f"| [{word}](" in index, entry.word
        page = pages()[page_of(entry)]
        assert (f"({label_of(entry)})=\n" in page) == has_section(entry), entry.word
        shown = f"`{form(entry)}`"
        in_table = shown.replace("|", "\\|")
        assert (shown if has_section(entry) else in_table) in page, entry.word


def test_no_two_words_have_one_label() -> None:
    labels = [label_of(entry) for entry in everything()]
    assert sorted(labels) == sorted(set(labels))


def test_most_words_of_val2_are_shown_by_a_case_with_what_it_does() -> None:
    kinds = ("instruction", "function", "operator", "constant")
    words = [e for e in everything() if e.state == RUNS and "2" in e.dialects and e.kind in kinds]
    shown = [e for e in words if case_of(e, cases()) is not None]
    assert len(shown) > 0.8 * len(words)
    commands = [e for e in everything() if e.state == RUNS and e.kind == "command"]
    assert sum(dialogue_of(e, cases()) is not None for e in commands) > 0.8 * len(commands)


def test_an_example_shows_its_word_in_its_language() -> None:
    for entry in everything():
        case = case_of(entry, cases()) if entry.kind != "command" else None
        if case is not None:
            assert entry.word in case.program, entry.word
            assert set(DIALECTS[case.dialect].letters) & set(entry.dialects), entry.word


def samples() -> list[Entry]:
    """Return the words whose example is a step that no case of the spec executes."""
    own = [e for e in everything() if has_section(e) and e.kind != "command"]
    return [e for e in own if case_of(e, cases()) is None]


GIVEN = """\
.PROGRAM program
        RETURN
.END
.LOCATIONS
a 600 0 0 90 90 0
b 700 0 0 90 90 0
c 600 100 0 90 90 0
d 600 0 0 90 90 0
p 600 0 0 90 90 0
.END
.REALS
channel 1
distance 50
dx 10
dy 0
dz 0
mask 1
n 1
percent 50
seconds 0.1
signal -1
state 1
value 1
.END
.STRINGS
$name "program"
$s "a"
.END
"""
STANDS = "        DRIVE 3, -30, 50\n        DRIVE 5, 40, 50\n        HERE location\n"
MOVES = ("location", "distance", "dx")  # words in steps that want an arm that is not stretched


def given(program: str) -> str:
    """Return the program of an example with values for its words, and a place to begin at."""
    head, steps = program.split("\n", 1)
    stands = STANDS if any(word in steps for word in MOVES) else ""
    return f"{head}\n{stands}{steps}{GIVEN}"


def test_what_no_case_executes_is_executed_here() -> None:
    found = samples()
    assert found
    scene = robot_alone("puma761")
    for entry in found:
        program, dialect = sample_program(entry)
        compiled = compile_source(
            SourceFile("sample.v2", given(program)), Options(DIALECTS[dialect])
        )
        assert compiled.module is not None, (entry.word, compiled.diagnostics)
        run = execute(compiled.module, scene)
        assert [d.headline for d in run.findings if d.is_error] == [], entry.word


def test_a_step_that_is_never_simulated_would_be_noticed() -> None:
    text = ".PROGRAM main\n        ABORT 1\n.END\n"
    module = compile_source(SourceFile("sample.v2", text), Options(DIALECTS["vplus"])).module
    assert module is not None
    found = execute(module, robot_alone("puma761")).findings
    assert "not-simulated" in {d.rule.slug for d in found}


@pytest.mark.parametrize("word", ["MOVES", "SIGNAL", "WAIT", "SPEED"])
def test_a_word_leads_to_its_rules_and_their_sources(word: str) -> None:
    rules = rules_of(MANUAL / "language")
    found = about(word, rules)
    assert found
    section = pages()["instructions"].partition(f"## {word}\n")[2].partition("\n## ")[0]
    for rule in found:
        assert f"](#{rule.label})" in section
    assert "Source\n: " in section


# --- two pages to print ---------------------------------------------------------------------------


def test_the_cheat_sheet_holds_every_instruction_of_val2_that_runs_once() -> None:
    listed = [word for group in GROUPS for kind, word in members(group) if kind == "instruction"]
    wanted = [e.word for e in everything() if e.kind == "instruction" and "2" in e.dialects]
    runs = {e.word for e in everything() if e.kind == "instruction" and e.state == RUNS}
    assert sorted(listed) == sorted(word for word in wanted if word in runs)


def test_the_cheat_sheet_says_what_the_vocabulary_says() -> None:
    page = cheat_sheet()
    moves = next(e for e in everything() if e.word == "MOVES")
    assert f"`{moves.usage}`\n: {moves.about}\n" in page


def test_the_program_of_the_cheat_sheet_carries_something_there() -> None:
    module = compile_source(SourceFile("sheet.v2", PROGRAM), Options(DIALECTS["val2"])).module
    assert module is not None
    run = execute(module, robot_alone("puma761"))
    assert [d for d in run.findings if d.is_error] == []
    assert run.horizon_s > 5
