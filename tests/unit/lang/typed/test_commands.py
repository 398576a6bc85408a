"""Lines of the monitor: words, short forms, operands, and what is said of a bad one."""

import pytest

from vrts.base.diagnostic import Diagnostic
from vrts.base.source import SourceFile
from vrts.lang.dialect import VAL2, VAL2_PLUS, Dialect
from vrts.lang.syntax.expressions import Name, Number
from vrts.lang.typed.commands import CommandLine, FileName, read_command
from vrts.lang.vocabulary.commands import COMMANDS, look_up_command


def read(text: str, dialect: Dialect = VAL2) -> CommandLine:
    line, found = read_command(SourceFile("monitor", text), dialect)
    assert line is not None, found
    return line


def refused(text: str) -> Diagnostic:
    line, found = read_command(SourceFile("monitor", text))
    assert line is None
    (diagnostic,) = [d for d in found if d.is_error]
    return diagnostic


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("EX", "EXECUTE"),  # fixed, whatever else begins so
        ("DIR", "DIRECTORY"),
        ("AB", "ABORT"),
        ("store", "STORE"),  # exact, though longer words begin with it
        ("ST", None),  # STATUS or STORE
        ("WH", "WHERE"),
        ("MOVE", None),
    ],
)
def test_short_forms(text: str, word: str | None) -> None:
    found = look_up_command(text).word
    assert (found.text if found else None) == word


@pytest.mark.parametrize("word", sorted(COMMANDS))
def test_every_command_is_read_from_its_usage(word: str) -> None:
    if word != "DO":  # `instruction` stands for one
        assert read(COMMANDS[word].usage).word.text == word


def test_operands_are_nodes_with_their_places() -> None:
    line = read("EXECUTE Pick.one,,5 ; from the fifth step")
    program, cycles, step = line.operands
    assert program == Name("Pick.one", 8, 16)
    assert cycles is None
    assert step == Number(5.0, 18, 19)
    assert line.rest == "Pick.one,,5"


def test_values_stand_behind_the_equals_sign() -> None:
    line = read("COPY new = old")
    assert [n.text for n in (*line.operands, *(line.values or ())) if isinstance(n, Name)] == [
        "new",
        "old",
    ]


@pytest.mark.parametrize(
    ("text", "files", "values"),
    [
        ("LOAD pick.v2", ["pick.v2"], None),
        ('LOAD "two words.v2"', ["two words.v2"], None),
        ("STORE cell = main, pick", ["cell"], 2),
        ("FCOPY 2new.v2 = old-1.v2", ["2new.v2"], 1),
        ("FDIRECTORY", [], None),
    ],
)
def test_files(text: str, files: list[str], values: int | None) -> None:
    line = read(text)
    assert [o.text for o in line.operands if isinstance(o, FileName)] == files
    assert (None if line.values is None else len(line.values)) == values


@pytest.mark.parametrize(
    ("text", "code", "words", "help_"),
    [
        ("EXECUET main", "V520", "Illegal monitor command", "did you mean `EXECUTE`?"),
        ("MOVE part", "V520", "Illegal monitor command", "`DO MOVE part` carries it out"),
        ("n = 5", "V520", "Illegal monitor command", "write `DO n = 5`"),
        ("LIST", "V521", "Ambiguous keyword", "write more of the word"),
        ("ABORT now", "V153", "Unexpected text at end of line", "write `ABORT` alone"),
        ("LOAD a b", "V153", "Unexpected text at end of line", "in quotes"),
        ("LISTR (1", "V128", "Missing parenthesis", "add `)`"),
        ("17", "V520", "Illegal monitor command", "EXECUTE main"),
    ],
)
def test_what_is_no_command(text: str, code: str, words: str, help_: str) -> None:
    found = refused(text)
    assert found.rule.code == code
    assert f"VAL-II says *{words}*" in found.notes
    assert help_ in " ".join(found.help)


def test_relatives_assign_without_do() -> None:
    line = read("n = 5", VAL2_PLUS)
    assert (line.word.text, line.rest) == ("DO", "n = 5")


@pytest.mark.parametrize("text", ["", "   ", "; only a comment"])
def test_an_empty_line_is_nothing(text: str) -> None:
    assert read_command(SourceFile("monitor", text)) == (None, ())


@pytest.mark.parametrize(
    "text", ["(" * 300, "LISTR " + "(" * 200, "é", "\x00", "LISTR -" + "-" * 240]
)
def test_hostile_lines_are_refused(text: str) -> None:
    line, found = read_command(SourceFile("monitor", text))
    assert line is not None or any(d.is_error for d in found)
