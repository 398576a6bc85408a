"""Highlighting: nothing is lost, words count only where they are words, files are up to date."""

import json
import re
import subprocess
import sys
from importlib.metadata import entry_points
from importlib.resources import files

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pygments.token import Comment, Error, Keyword, Name, Number, Operator, String, Text

from tests.places import ROOT
from vrts.editors.patterns import patterns
from vrts.editors.pygments_lexer import Val2Lexer
from vrts.editors.textmate import grammar, grammar_text
from vrts.lang.vocabulary.functions import FUNCTIONS
from vrts.lang.vocabulary.instructions import INSTRUCTIONS

PROGRAMS = [
    path.read_text("utf-8")
    for folder in ("tests/golden/lang", "examples/01-cans-on-bases")
    for path in sorted((ROOT / folder).glob("*.*"))
    if path.suffix in (".v2", ".val", ".vplus", ".as")
]


def tokens(text: str) -> list[tuple[object, str]]:
    return [(kind, value) for _, kind, value in Val2Lexer().get_tokens_unprocessed(text)]


def kinds(line: str) -> dict[str, object]:
    return {value: kind for kind, value in tokens(line)}


@given(st.text())
def test_nothing_is_lost(text: str) -> None:
    assert "".join(value for _, value in tokens(text)) == text


@pytest.mark.parametrize("text", PROGRAMS)
def test_programs_are_understood(text: str) -> None:
    found = tokens(text)
    assert "".join(value for _, value in found) == text
    assert [value for kind, value in found if kind in (Error, Text)] == []


def test_words_count_where_they_are_words() -> None:
    found = kinds('10 MOVES part:SHIFT(stop BY dx,DX(p)) ; MOVE "a"')
    assert found["10"] is Name.Label
    assert found["MOVES"] is Keyword.Reserved
    assert found["stop"] is Name  # no instruction can stand there
    assert found["dx"] is Name
    assert found["DX"] is Name.Builtin
    assert found["BY"] is Keyword.Pseudo
    assert found['; MOVE "a"'] is Comment.Single
    assert kinds("stop = 3")["stop"] is Name
    assert kinds("value[n] = 3")["value"] is Name
    assert kinds("VALUE 3:")["VALUE"] is Keyword
    assert kinds("delay.fdb = 1")["delay.fdb"] is Name
    assert kinds('TYPE /F8.2, "IF", a AND b')["/F8.2"] is String.Interpol
    assert kinds('TYPE /F8.2, "IF", a AND b')['"IF"'] is String.Double
    assert kinds("x = a AND b/c")["AND"] is Operator.Word
    assert kinds("x = a AND b/c")["/"] is Operator
    assert kinds("IF a GOTO 10")["GOTO"] is Keyword
    assert kinds("value[a[1]] = 3")["value"] is Name
    assert kinds("here = hand")["here"] is Name
    assert kinds("here = hand")["hand"] is Name.Builtin
    assert kinds("step = 3")["step"] is Name
    assert kinds("FOR i = 1 TO 9 STEP 2")["STEP"] is Keyword
    assert kinds("WINDOW %belt")["%belt"] is Name
    assert kinds(".PROGRAM main")[".PROGRAM"] is Keyword.Namespace


def test_words_may_be_short() -> None:
    assert kinds("DEL 2")["DEL"] is Keyword.Reserved
    assert kinds("DEL = 2")["DEL"] is Name
    assert kinds("WH n DO")["WH"] is Keyword
    assert kinds("MOV p")["MOV"] is Name  # MOVE, MOVES, MOVET: the controller does not take it


def test_numbers_and_what_looks_like_them() -> None:
    found = kinds("x = ^HFF+^B101-'A*1.5E-3+p2--4")
    for number in ("^HFF", "^B101", "1.5E-3", "4"):
        assert found[number] is Number, number
    assert found["'A"] is String.Char
    assert found["p2"] is Name
    assert found["+"] is Operator


@pytest.mark.parametrize("word", sorted(INSTRUCTIONS))
def test_every_instruction_counts_at_the_start_of_a_step_only(word: str) -> None:
    assert kinds(f"  10 {word.lower()} x")[word.lower()] in (Keyword, Keyword.Reserved)
    inside = tokens(f'TYPE "{word}" ;{word}')
    assert [value for _, value in inside if value.strip()] == ["TYPE", f'"{word}"', f";{word}"]


@pytest.mark.parametrize("name", sorted(FUNCTIONS))
def test_every_function_counts_before_its_parentheses(name: str) -> None:
    assert kinds(f"x = {name}(1)")[name] is Name.Builtin
    if not FUNCTIONS[name].bare:
        assert kinds(f"x = {name}+1").get(name) is not Name.Builtin


def test_lexer_is_registered() -> None:
    (found,) = [e for e in entry_points(group="pygments.lexers") if e.name == "val2"]
    assert found.load() is Val2Lexer


def test_grammar_file_is_up_to_date() -> None:
    kept = files("vrts.editors").joinpath("val2.tmLanguage.json").read_text("utf-8")
    assert kept == grammar_text()
    printed = subprocess.run(
        [sys.executable, "-m", "vrts.editors.textmate"], capture_output=True, check=True
    )
    assert printed.stdout.decode() == kept
    assert json.loads(kept)["scopeName"] == "source.val2"


def test_expressions_are_read_alike_by_python_and_oniguruma() -> None:
    """Only groups, sets, repetition, and look-around of fixed width: the same in both."""
    for text in (pattern.expression for pattern in patterns()):
        re.compile(text)
        bare = re.sub(r"\[\^?[^]]*\]", "x", re.sub(r"\\[^a-z]", "x", text))  # without sets
        assert set(re.findall(r"\(\?(<?[^\w<])", bare)) <= {":", "=", "!", "<=", "<!"}
        assert set(re.findall(r"\\([a-zA-Z])", text)) <= {"b", "d", "n", "t", "w"}
        assert re.search(r"[*+?}][+]", bare) is None  # possessive


def scopes(line: str) -> dict[str, str]:
    """Return the scope of each piece of a line, as an editor finds them."""
    rules = json.loads(json.dumps(grammar()))["patterns"]
    found: dict[str, str] = {}
    at = 0
    while at < len(line):
        best = None
        for rule in rules:
            match = re.compile(rule["match"], re.MULTILINE).search(line, at)
            if match and match.group() and (best is None or match.start() < best[0].start()):
                best = match, rule
        if best is None:
            break
        match, rule = best
        if "name" in rule:
            found[match.group()] = rule["name"]
        for group, scope in rule.get("captures", {}).items():
            if match.group(int(group)):
                found[match.group(int(group)).strip()] = scope["name"]
        at = match.end()
    return found


def test_scopes() -> None:
    found = scopes('10 MOVES part:SHIFT(stop BY dx,DX(p)) ; MOVE "a"')
    assert found["10"] == "entity.name.tag.label.val2"
    assert found["MOVES"] == "keyword.other.instruction.val2"
    assert found["stop"] == "variable.other.val2"
    assert found["DX"] == "support.function.val2"
    assert found['; MOVE "a"'] == "comment.line.semicolon.val2"
    assert scopes('IF $s == "IF" THEN')["IF"] == "keyword.control.val2"
    assert scopes('IF $s == "IF" THEN')['"IF"'] == "string.quoted.double.val2"
