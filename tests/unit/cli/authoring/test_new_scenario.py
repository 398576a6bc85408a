"""`vrts new scenario`: a file that fits a program, and is taken with all that it offers."""

import re
from pathlib import Path

from tests.schemas.documents import refusals
from tests.support_commands import vrts_text

READS = """\
.PROGRAM main()
WAIT SIG(1003)
WAIT SIG(1001)
PROMPT "how many? ", n
CLOSEI
DELAY 4
TYPE n, ADC(2)+RANDOM
.END
"""


def _written(folder: Path, program: str = READS) -> tuple[Path, str, str]:
    source = folder / "prog.v2"
    source.write_text(program)
    done = vrts_text("new", "scenario", "prog.v2", cwd=folder)
    assert done.returncode == 0, done.stderr
    file = folder / "prog-scenario.toml"
    return file, file.read_text(), done.stderr


def test_it_names_what_the_program_reads(tmp_path: Path) -> None:
    _, text, said = _written(tmp_path)
    assert re.findall(r"^# (read at .*)\n\[\[inputs\]\]\nsignal = (\d+)", text, re.M) == [
        ("read at main 2", "1001"),
        ("read at main 1", "1003"),
    ]
    assert "\n[[analog]]\nchannel = 2\n" in text
    assert "# The program asks at main 3:" in text
    assert "\n[random]\n" in text
    assert 'kind = "gripper slips"' in text
    assert "vrts run prog.v2 --scenario prog-scenario.toml" in said


def test_it_is_taken_as_it_is(tmp_path: Path) -> None:
    file, text, _ = _written(tmp_path)
    assert refusals("scenario", text) == []
    done = vrts_text("run", "prog.v2", "--scenario", file.name, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.split()[-2:] == ["1", "0.5"]  # the arm still waits when it is read


def test_all_that_it_offers_is_taken(tmp_path: Path) -> None:
    file, text, _ = _written(tmp_path)
    offered = re.sub(r"^# ((?:\[|[a-z_]+ = ).*)$", r"\1", text, flags=re.M)
    assert offered.count("[[faults]]") == 3
    assert refusals("scenario", offered) == []
    file.write_text(offered)
    done = vrts_text("run", "prog.v2", "--scenario", file.name, cwd=tmp_path)
    assert "V60" not in done.stderr
    assert "emergency stop" in done.stderr


def test_of_a_program_that_reads_nothing_it_says_what_can_happen_all_the_same(
    tmp_path: Path,
) -> None:
    _, text, _ = _written(tmp_path, ".PROGRAM a()\nDRIVE 1, 30, 100\n.END\n")
    assert "[[inputs]]" not in text
    assert "input stuck" not in text
    assert refusals("scenario", text) == []


def test_nothing_is_replaced_and_mistakes_are_told(tmp_path: Path) -> None:
    _written(tmp_path)
    again = vrts_text("new", "scenario", "prog.v2", cwd=tmp_path)
    assert again.returncode == 2
    assert "is there already" in again.stderr
    (tmp_path / "wrong.v2").write_text(".PROGRAM a()\nSPED 3\n.END\n")
    wrong = vrts_text("new", "scenario", "wrong.v2", cwd=tmp_path)
    assert wrong.returncode == 1
    assert "V120" in wrong.stderr
