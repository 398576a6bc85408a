"""`vrts new environment`: what it writes fits the program, and reads back without a word."""

import re
from pathlib import Path

import pytest

from tests.unit.cli.test_commands import SOLUTION, vrts
from vrts.base.source import SourceFile
from vrts.prove.environment.environment import Answers, Counts, Environment
from vrts.prove.environment.reading import read_environment

PROGRAM = """\
.PROGRAM main()
  SIGNAL 7
  REACTI 1003, stop
  PROMPT "how many? ", n
  FOR i = 1 TO n
    WAIT SIG(1001)
    IF SIG(1001, -1002) OR RANDOM > 0.5 THEN
      CLOSEI
    END
  END
.END
.PROGRAM stop()
  SIGNAL -7
.END
"""


def read(text: str) -> Environment:
    found, said = read_environment(SourceFile("environment.toml", text))
    assert found is not None, said
    assert said == ()
    return found


@pytest.fixture
def written(tmp_path: Path) -> str:
    program = tmp_path / "main.v2"
    program.write_text(PROGRAM)
    result = vrts("new", "environment", program)
    assert result.returncode == 0, result.stderr
    assert b"vrts prove" in result.stderr
    return (tmp_path / "environment.toml").read_text()


def test_it_names_what_the_program_reads_and_where(written: str) -> None:
    assert re.findall(r"^signal = (\d+)", written, re.MULTILINE) == ["1001", "1002", "1003"]
    assert "# read at main 5, main 6\n" in written
    assert "# output = 7\n" in written
    assert "The program asks at main 3." in written
    assert "draws" in written
    assert "misses" in written


def test_as_it_is_written_everything_is_free(written: str) -> None:
    found = read(written)
    assert found == Environment(
        title="The cell of main.v2", answers=Answers(("0", "1", "2")), digest=found.digest
    )


@pytest.mark.parametrize("kind", ["held", "pulsed", "answers"])
def test_each_choice_that_is_shown_can_be_taken(written: str, kind: str) -> None:
    """The lines of a kind, uncommented, in place of `free`."""
    lines = written.replace('is = "free"\n', "").splitlines()
    taken: list[str] = []
    inside = ""
    for line in lines:
        shown = re.match(r'# (is = "(\w+)".*)', line)
        inside = shown[2] if shown else inside if line.startswith("# ") else ""
        taken.append(line[2:] if inside == kind and line.startswith("# ") else line)
    assert set(read("\n".join(taken)).inputs) == {1001, 1002, 1003}


def test_analog_inputs_read_all_that_a_controller_can_until_it_is_said(tmp_path: Path) -> None:
    program = tmp_path / "main.v2"
    program.write_text(".PROGRAM main()\nv = ADC(2)\nIF ADC(2) > ADC(5) THEN\nTYPE v\nEND\n.END\n")
    assert vrts("new", "environment", program).returncode == 0
    text = (tmp_path / "environment.toml").read_text()
    assert "# read at main 1, main 2\n[[analog]]\nchannel = 2\n" in text
    assert "# read at main 2\n[[analog]]\nchannel = 5\n" in text
    assert read(text).analog == {2: Counts(-2048, 2047), 5: Counts(-2048, 2047)}
    taken = text.replace("range = [", "# range = [").replace("# counts", "counts")
    assert read(taken).analog == {2: Counts(0, 350, (0, 350)), 5: Counts(0, 350, (0, 350))}


def test_stops_repetition_and_properties_can_be_taken(written: str) -> None:
    begins = written.index("[operator]")
    tail = re.sub(r"^# (?=\[\[|[a-z]+ = )", "", written[begins:], flags=re.MULTILINE)
    found = read(written[:begins] + tail.replace("again = false", "again = true"))
    assert len(found.stops) == 3
    assert found.again.most == 5
    assert [one.signals for one in found.properties] == [(3,)]


def test_a_program_that_reads_nothing_gets_little(tmp_path: Path) -> None:
    target = tmp_path / "cell.toml"
    assert vrts("new", "environment", SOLUTION, "-o", target).returncode == 0
    assert "[[inputs]]" not in target.read_text()
    assert vrts("prove", SOLUTION, "--environment", target).returncode == 0


def test_nothing_is_overwritten(tmp_path: Path) -> None:
    target = tmp_path / "cell.toml"
    target.write_text("mine")
    result = vrts("new", "environment", SOLUTION, "-o", target)
    assert result.returncode == 2
    assert target.read_text() == "mine"
