"""`vrts dispatch export`: verified, written, read again, and compared."""

from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from tests.support_programs import ROOT, ran
from vrts.dispatch.posts.export import Exported, exported
from vrts.dispatch.posts.other_arm import SAME
from vrts.dispatch.posts.same_motion import TOLERANCE_MM, difference
from vrts.pipeline.compiling.reading import STRICT, ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where

EXAMPLES = sorted((ROOT / "examples").glob("*/solution.v2"))
FIRST_AND_OTHERS = [
    pytest.param(path, id=path.parent.name, marks=(pytest.mark.thorough,) if i > 0 else ())
    for i, path in enumerate(EXAMPLES)
]


def export(place: Path, target: str, reading: Reading = STRICT) -> Exported:
    setting = setting_for(place)
    assert setting is not None
    return exported(Request(ProgramFile(place.read_bytes(), place.name), setting, reading), target)


@pytest.mark.parametrize("target", ["val2", "vplus", "as"])
@pytest.mark.parametrize("place", FIRST_AND_OTHERS)
def test_every_example_moves_the_same_in_every_language(place: Path, target: str) -> None:
    found = export(place, target)
    assert not found.diagnostics
    assert found.difference is not None
    assert found.difference.most_mm <= TOLERANCE_MM
    assert found.difference.duration_s == 0.0
    assert found.text


def test_a_program_that_is_not_verified_is_refused() -> None:
    found = export(EXAMPLES[0].parent / "submissions" / "hits-base.v2", "vplus")
    assert found.text is None
    assert [d.rule.code for d in found.diagnostics][-1] == "V862"
    assert "V400" in [d.rule.code for d in found.diagnostics]


def test_a_program_that_would_move_otherwise_is_refused(tmp_path: Path) -> None:
    body = "NONULL ALWAYS\nMOVE a\nBREAK\nMOVE b"
    places = ".LOCATIONS\na 900 200 100 90 90 0\nb 900 -200 100 90 90 0\n.END\n"
    place = tmp_path / "prog.v2"
    place.write_text(f".PROGRAM main\n{body}\n.END\n{places}")
    setting = setting_for(place, Where("cans-on-bases"))
    assert setting is not None
    found = exported(Request(ProgramFile(place.read_bytes(), place.name), setting), "as")
    assert found.text is None
    assert found.diagnostics[-1].rule.code == "V863"
    assert found.difference is not None
    assert found.difference.most_mm > TOLERANCE_MM


def test_programs_in_as_are_not_exported() -> None:
    setting = setting_for(EXAMPLES[0])
    assert setting is not None
    data = b".PROGRAM main()\nJMOVE #[0,-90,90,0,0,0]\n.END\n"
    found = exported(Request(ProgramFile(data, "main.as"), setting, Reading("as")), "vplus")
    assert [d.rule.code for d in found.diagnostics][-1] == "V864"


def test_runs_apart_by_more_than_allowed_are_told_with_the_time() -> None:
    place = ".LOCATIONS\na 900 {y} 100 90 90 0\n.END\n"
    text = ".PROGRAM main\nDELAY 1\nMOVE a\n.END\n"
    one = ran(text + place.format(y=200))
    near = difference(one, ran(text + place.format(y=200.005)))
    far = difference(one, ran(text + place.format(y=200.5)))
    assert near.most_mm == pytest.approx(0.005, abs=0.003)
    assert far.most_mm == pytest.approx(0.5, abs=0.2)
    assert 1.0 < far.first_s < 2.5
    assert not far.is_none


def test_the_command_writes_beside_the_program_and_says_so(tmp_path: Path) -> None:
    for name in ("solution.v2", "task.toml"):
        (tmp_path / name).write_bytes((EXAMPLES[0].parent / name).read_bytes())
    done = vrts_text("dispatch", "export", tmp_path / "solution.v2", "--to", "as")
    assert done.returncode == 0, done.stderr
    text = (tmp_path / "solution-as.as").read_text()
    assert "JMOVE" in text
    here = "MOVES start in carry: 800.00 -450.00 -225.00 0.00 180.00 0.00"
    assert "; not tried on a controller; the arm stops where HERE shows (mm, degrees):\n" in text
    assert f";   motion 3, {here}\n" in text
    sheet = (tmp_path / "solution-as-sheet.md").read_text()
    assert "**Not tried on a controller.**" in sheet
    assert "0.00, 0.00, 150.00 mm from the flange" in sheet
    assert "| 800.00 -450.00 -225.00 0.00 180.00 0.00 | not known |" in sheet
    assert "the same motion" in done.stderr
    itself = str(tmp_path / "solution.v2")
    done = vrts_text("dispatch", "export", itself, "--to", "val2", "-o", itself)
    assert done.returncode == 2
    assert "is the program itself" in done.stderr


def test_another_arm_is_described_by_a_file(tmp_path: Path) -> None:
    place = tmp_path / "prog.v2"
    place.write_text(".PROGRAM main\nREADY\n.END\n")
    arm = tmp_path / "arm.toml"
    arm.write_text('title = "other"\n[joints]\nsign = [1,1,-1,1,1,1]\nzero_deg = [0,0,0,0,0,5]\n')
    call = ("dispatch", "export", place, "--scene", "cans-on-bases", "--to", "as")
    done = vrts_text(*call)
    assert done.returncode == 1
    assert "how the other arm counts its joints is not known" in done.stderr
    done = vrts_text(*call, "--arm", arm)
    assert done.returncode == 0, done.stderr
    assert "JMOVE #PPOINT(0,-90,-90,0,0,5)" in (tmp_path / "prog-as.as").read_text()
    arm.write_text('title = "other"\n[joints]\nsign = [1,2,1,1,1,1]\nzero_deg = [0,0,0,0,0,5]\n')
    done = vrts_text(*call, "--arm", arm)
    assert done.returncode == 1
    assert "V865" in done.stderr


def test_a_signal_stands_for_the_look_of_grasp(tmp_path: Path) -> None:
    place = tmp_path / "prog.v2"
    steps = "OPENI\nMOVE a\nGRASP 0, 10\nMOVE b\nHALT\n10 MOVE a\nMOVE b"
    places = ".LOCATIONS\na 900 200 100 90 90 0\nb 900 -200 100 90 90 0\n.END\n"
    place.write_text(f".PROGRAM main\n{steps}\n.END\n{places}")
    setting = setting_for(place, Where("cans-on-bases"))
    assert setting is not None
    request = Request(ProgramFile(place.read_bytes(), place.name), setting)
    found = exported(request, "as", SAME._replace(holds=1004))
    assert found.text is not None, found.diagnostics
    assert "IF SIG(-1004) GOTO 10" in found.text
    assert found.sheet is not None
    assert "Signal 1004 is on while the hand holds something" in found.sheet
    assert exported(request, "as").text is None
