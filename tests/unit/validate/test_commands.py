"""`vrts validate` from the command line, as the lesson shows it."""

import json
import re
import shlex
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.unit.validate.support import EXAMPLE, path_run
from vrts.cli.main import vrts
from vrts.validate.sampling import sampled
from vrts.validate.synthetic import Imperfect, logged

FENCE = re.compile(r"```sh\n(.*?)```", re.DOTALL)


def called(*words: str) -> Result:
    result = CliRunner().invoke(vrts, words, prog_name="vrts")
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        raise result.exception
    return result


@pytest.fixture
def lesson(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a copy of the lesson, which is the working folder."""
    folder = tmp_path / "lesson"
    shutil.copytree(EXAMPLE, folder, ignore=shutil.ignore_patterns("speeds.csv", "*.rrd"))
    monkeypatch.chdir(folder)
    return folder


@pytest.mark.thorough
def test_every_command_of_the_lesson_does_what_it_says(lesson: Path) -> None:
    text = (EXAMPLE / "README.md").read_text()
    lines = [line for block in FENCE.findall(text) for line in block.splitlines()]
    commands = [line for line in lines if "--camera" not in line]
    assert len(commands) == 7
    said: list[str] = []
    for line in commands:
        words = shlex.split(line)
        assert words[0] == "vrts"
        result = called(*words[1:])
        assert result.exit_code == 0, (line, result.output)
        said.append(result.stdout)
    assert (lesson / "robot.csv").read_bytes() == (EXAMPLE / "robot.csv").read_bytes()
    assert (lesson / "report.html").stat().st_size > 50_000
    assert (lesson / "both.rrd").stat().st_size > 50_000
    for row in re.findall(r"^  [XYZ] .*$|^  base .*$|^ +turn about.*$", text, re.M):
        assert any(row in one for one in said), row
    fit = said[5]
    for row in re.findall(r"^  (?:JT1 speed|acceleration|rounded).*$", text, re.M):
        assert row in fit
    far = [float(m[1]) for m in re.finditer(r"length.* (\S+)$", said[4] + "\n" + said[6], re.M)]
    assert far[0] > 500.0
    assert far[1] < 4.0


def test_the_first_line_of_the_log_in_the_lesson_is_in_the_log() -> None:
    text = (EXAMPLE / "README.md").read_text()
    row = re.search(r"^-0\.504,.*$", text, re.M)
    assert row is not None
    assert row[0] in (EXAMPLE / "robot.csv").read_text()


@pytest.mark.usefixtures("lesson")
def test_a_limit_decides_the_exit_status() -> None:
    near = called("validate", "path.v2", "--log", "robot.csv", "--within", "2")
    far = called("validate", "path.v2", "--log", "robot.csv", "--within", "2.5")
    assert (near.exit_code, far.exit_code) == (1, 0)
    assert "the tool is up to 2.33 mm off, more than 2 mm" in near.stderr


@pytest.mark.usefixtures("lesson")
def test_json_goes_to_stdout_alone() -> None:
    result = called("validate", "path.v2", "--log", "robot.csv", "--json")
    assert json.loads(result.stdout)["log"]["name"] == "robot.csv"


@pytest.mark.usefixtures("lesson")
def test_a_saved_run_is_compared_as_its_program_is() -> None:
    assert called("run", "path.v2", "--save", "path.vrun").exit_code == 0
    one = called("validate", "path.vrun", "--log", "robot.csv")
    other = called("validate", "path.v2", "--log", "robot.csv")
    assert one.stdout == other.stdout


@pytest.mark.parametrize(
    ("words", "status", "said"),
    [
        (("path.v2",), 2, "--log"),
        (("path.v2", "--log", "none.csv"), 2, "cannot read `none.csv`"),
        (("path.v2", "--log", "robot.csv", "--align", "arm"), 2, "--align takes time, base, tool"),
        (("path.v2", *2 * ("--log", "robot.csv"), "--html", "x.html"), 2, "show one log"),
        (("path.v2", "--log", "robot.csv", "-o", "x.toml"), 2, "-o belongs to --fit"),
        (("path.v2", "--log", "robot.csv", "--fit", "--html", "x.html"), 2, "not to --fit"),
        (("path.v2", "--log", "robot.csv", "--html", "README.md"), 2, "is there already"),
        (("path.v2", "--log", "path.v2"), 1, "V881"),
        (("path.v2", "--log", "robot.csv", "--lab", "other-robot.toml"), 2, "laid over a scene"),
        (("README.md", "--log", "robot.csv"), 1, "there is no run"),
    ],
)
@pytest.mark.usefixtures("lesson")
def test_wrong_calls_and_wrong_files(words: tuple[str, ...], status: int, said: str) -> None:
    result = called("validate", *words)
    assert (result.exit_code, said in result.stderr) == (status, True), result.stderr


def test_the_synthetic_robot_is_what_it_says(lesson: Path) -> None:
    result = called("validate", "simulate", "path.v2", "--noise-deg", "0", "--seed", "9")
    assert result.exit_code == 0
    first, second, names, *_ = result.stdout.splitlines()
    assert first.startswith("# SYNTHETIC: ")
    assert "noise 0 deg" in second
    assert "seed 9" in second
    assert names.startswith("time_s,jt1_deg")
    assert str(lesson) not in result.stdout


def test_a_robot_without_faults_is_the_run() -> None:
    perfect = Imperfect(0.0, 0.0, 0.0, (0.0, 0.0, 0.0))
    times, joints, points = logged(path_run(), perfect)
    expected = sampled(path_run(), times)
    assert joints == pytest.approx(expected.joints, abs=1e-12)
    assert points == pytest.approx(expected.positions, abs=1e-12)


COLUMNS = 'time = "time_s"\njoints = [' + ", ".join(f'"jt{k}_deg [deg]"' for k in range(1, 7)) + "]"


def test_a_run_written_for_ros_is_read_as_a_log_of_itself(lesson: Path) -> None:
    written = called("run", "path.v2", "--mcap", "bag/run.mcap")
    assert written.exit_code == 2  # no folder is made unasked
    (lesson / "bag").mkdir()
    assert called("run", "path.v2", "--mcap", "bag/run.mcap").exit_code == 0
    Path("columns.toml").write_text(COLUMNS)
    for log in ("bag", "bag/run.mcap"):
        result = called("validate", "path.v2", "--log", log, "--within", "0.01", "--json")
        assert result.exit_code == 0, result.output
    several = called(
        *("validate", "path.v2", "--log", "robot.csv", "--log", "robot.csv"),
        *("--columns", "columns.toml", "--json"),
    )
    assert several.exit_code == 0, several.output
    first, second = json.loads(several.stdout)["comparisons"]
    assert first == second
    page = called(
        *("validate", "path.v2", "--log", "bag", "--log", "bag", "--html", "page.html"),
    )
    assert page.exit_code == 2
    Path("columns.toml").write_text("time = 3")
    assert called("validate", "path.v2", "--log", "bag", "--columns", "columns.toml").exit_code == 1
    (lesson / "empty").mkdir()
    assert "holds no bag" in called("validate", "path.v2", "--log", "empty").output
