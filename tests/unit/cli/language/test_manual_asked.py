"""`vrts manual` with something asked."""

import json
import subprocess
import sys

import pytest

from tests.support_commands import vrts_text


def test_a_word_its_rule_and_what_to_type_next() -> None:
    done = vrts_text("manual", "MOVES")
    assert (done.returncode, done.stderr) == (0, "")
    lines = done.stdout.splitlines()
    assert lines[0] == "MOVES  (instruction of VAL, VAL-II, V+)"
    assert "MOVE and MOVES" in lines
    listed = lines[lines.index("see also") + 1 :]
    assert listed[0].split() == ["vrts", "manual", "do/go-straight", "Go", "straight"]


def test_a_question_shows_the_page_that_answers_it() -> None:
    done = vrts_text("manual", "wait", "2", "seconds")
    assert done.returncode == 0
    assert done.stdout.startswith("Wait 2 seconds\n==============\n")
    assert "        DELAY 2\n" in done.stdout
    assert done.stdout == vrts_text("manual", "wait 2 seconds").stdout


@pytest.mark.parametrize(
    ("asked", "title"),
    [
        ("v301", "V301 out-of-reach"),
        ("out-of-reach", "V301 out-of-reach"),
        ("wait-a-time", "Wait 2 seconds"),
        ("do/wait-a-time", "Wait 2 seconds"),
        ("language/motion#move", "MOVE and MOVES"),
        ("language/motion", "Motion"),
        ("verify", "Usage: vrts verify [OPTIONS] PROGRAM"),
        ("movel", "Go straight"),
        ("MvoeL", "(`mvoel` was read as `movel`)"),
        ("decode", "$DECODE  (function of VAL-II, V+, AS)"),
    ],
)
def test_names(asked: str, title: str) -> None:
    done = vrts_text("manual", asked)
    assert (done.returncode, done.stdout.splitlines()[0]) == (0, title)


def test_a_section_names_its_page() -> None:
    text = vrts_text("manual", "language/motion#align").stdout
    assert "the whole page: vrts manual language/motion\n" in text


def test_a_word_that_is_none_is_a_wrong_call() -> None:
    done = vrts_text("manual", "SIGNLA")
    assert (done.returncode, done.stdout) == (2, "")
    assert "did you mean `vrts manual SIGNAL`?" in done.stderr
    done = vrts_text("manual", "xqzzt")
    assert done.returncode == 2
    assert "the manual has no page about `xqzzt`" in done.stderr
    assert "`vrts manual --list`" in done.stderr
    assert vrts_text("manual", "").returncode == 2


def test_hostile_questions_are_harmless() -> None:
    done = vrts_text("manual", "\x1b[2J" + "x" * 10_000)
    assert done.returncode == 2
    assert "\x1b" not in done.stderr
    assert len(done.stderr) < 500


def test_pages_are_listed() -> None:
    text = vrts_text("manual", "--list").stdout
    assert [line for line in text.splitlines() if line in ("Do", "Look up", "Understand")] == [
        *("Do", "Look up", "Understand")
    ]
    assert "  do/wait-a-time " in text


def test_as_json() -> None:
    found = json.loads(vrts_text("manual", "wait 2 seconds", "--json").stdout)
    assert found["schema"] == "vrts.manual/1"
    assert found["pages"][0] == {"name": "do/wait-a-time", "kind": "do", "title": "Wait 2 seconds"}


def test_nothing_heavy_is_loaded() -> None:
    """So that it answers at once: how fast is in tests/bench."""
    heavy = ("numpy", "lark", "vrts.lang.compiler", "vrts.engine", "vrts.report.support")
    ask = "import sys\nsys.argv = ['vrts', 'manual', 'MOVES']\nfrom vrts.cli.main import main\n"
    ask += f"try:\n    main()\nfinally:\n    print([m for m in {heavy} if m in sys.modules])\n"
    done = subprocess.run([sys.executable, "-c", ask], capture_output=True, text=True, check=False)
    assert done.stdout.splitlines()[-1] == "[]"


@pytest.mark.parametrize("word", ["straight", "move straight", "MoveL", "LIN", "movl"])
def test_support_finds_moves(word: str) -> None:
    done = vrts_text("support", word)
    assert done.returncode == 0
    assert done.stdout.startswith("MOVES  (instruction of VAL, VAL-II, V+)\n")
    assert "no word of the language; what may be meant" in done.stderr


def test_support_begins_with_groups_and_an_example_each() -> None:
    lines = vrts_text("support").stdout.splitlines()
    assert lines[0].startswith("Words of the language.")
    assert "  motion      MOVES part" in lines
    assert lines.index("  motion      MOVES part") < lines.index("instructions")
    legend = next(i for i, line in enumerate(lines) if line.startswith("How to read the table"))
    assert legend < lines.index("instructions")
