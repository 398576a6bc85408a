"""`vrts support` as a user runs it."""

import json

from tests.unit.cli.test_commands import vrts


def test_table_names_every_kind_and_explains_its_marks() -> None:
    result = vrts("support")
    assert (result.returncode, result.stderr) == (0, b"")
    lines = result.stdout.decode().splitlines()
    headings = [line for line in lines if line.endswith("s") and " " not in line]
    assert headings == [
        *("instructions", "qualifiers", "operators", "functions"),
        *("constants", "switches", "parameters", "commands"),
    ]
    delay = next(line.split() for line in lines if line.startswith("  DELAY "))
    assert delay[:5] == ["DELAY", "DEL", "runs", "RB", "12+a"]
    assert any("opaque: a run stops there" in line for line in lines)


def test_one_word_in_full() -> None:
    text = vrts("support", "delay").stdout.decode()
    assert text.splitlines()[0] == "DELAY  (instruction of VAL, VAL-II, V+, AS)"
    assert "shortest   DEL\n" in text
    assert "breaks continuous path" in text
    both = vrts("support", "base").stdout.decode()  # an instruction, a function and a command
    assert [line.split("  ")[1] for line in both.splitlines() if line.startswith("BASE ")] == [
        *("(instruction of VAL, VAL-II, V+, AS)", "(function of VAL-II, V+, AS)"),
        "(command of VAL, VAL-II, V+)",
    ]


def test_unknown_words_are_a_wrong_call() -> None:
    result = vrts("support", "MOVEE")
    assert (result.returncode, result.stdout) == (2, b"")
    assert b"there is no word `MOVEE`" in result.stderr
    assert b"did you mean `MOVE`?" in result.stderr
    assert b"`vrts support` lists all words" in vrts("support", "xyzzy").stderr


def test_dialect_and_kind_choose() -> None:
    found = json.loads(vrts("support", "--dialect", "as", "--kind", "instruction", "--json").stdout)
    assert found["schema"] == "vrts.support/1"
    words = {word["word"]: word for word in found["words"]}
    assert "JMOVE" in words
    assert "MOVE" not in words
    assert words["JMOVE"]["languages"] == ["V+", "AS"]
    assert {word["kind"] for word in found["words"]} == {"instruction"}
    nothing = vrts("support", "--dialect", "val", "--kind", "switch")
    assert (nothing.returncode, nothing.stdout) == (2, b"")
