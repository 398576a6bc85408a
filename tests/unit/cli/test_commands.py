"""The command as a user runs it: real processes, real files, real exit statuses."""

import json
import os
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

from tests import support_commands
from tests.places import ROOT

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
SOLUTION = EXAMPLE / "solution.v2"
BROKEN = EXAMPLE / "submissions" / "syntax-error.v2"
HITS = EXAMPLE / "submissions" / "hits-base.v2"

HEAVY = ("numpy", "pinocchio", "coal", "fcl", "trimesh", "rerun")


def vrts(
    *words: str | Path, stdin: bytes = b"", cwd: Path = ROOT, **environment: str
) -> "subprocess.CompletedProcess[bytes]":
    plain = {k: v for k, v in os.environ.items() if k not in ("NO_COLOR", "FORCE_COLOR")}
    environment = {**plain, "PYTHONPATH": str(ROOT), **environment}
    return support_commands.vrts(*words, cwd=cwd, stdin=stdin, env=environment)


@pytest.mark.thorough
def test_alone_it_says_in_five_lines_what_to_type_where_nothing_is(tmp_path: Path) -> None:
    result = vrts(cwd=tmp_path)
    assert result.returncode == 0
    where, *lines = result.stdout.decode().splitlines()
    assert where == "No program, task or lesson yet. What works here:"
    assert len(lines) == 5
    for word, command in zip(lines, ("learn", "scene", "new", "grade", "explain"), strict=True):
        assert f"vrts {command}" in word


@pytest.mark.parametrize(
    "command", ["compile", "run", "verify", "grade", "view", "point", "explain", "scene"]
)
def test_every_help_ends_with_examples(command: str) -> None:
    result = vrts(command, "--help")
    assert result.returncode == 0
    examples = result.stdout.decode().rsplit("Examples:", 1)[1]
    assert f"vrts {command}" in examples


def test_a_program_that_compiles_gives_status_0_and_nothing_on_stdout() -> None:
    result = vrts("compile", SOLUTION)
    assert (result.returncode, result.stdout) == (0, b"")
    assert b"compiles" in result.stderr


def test_a_mistake_gives_status_1_and_its_place_on_stderr() -> None:
    result = vrts("compile", BROKEN)
    assert result.returncode == 1
    assert result.stdout == b""
    assert b"error[V131 missing-comma]" in result.stderr
    assert b"syntax-error.v2:7:" in result.stderr


def test_a_dash_reads_from_stdin() -> None:
    result = vrts("compile", "-", "--emit", "ir", stdin=SOLUTION.read_bytes())
    assert result.returncode == 0
    assert b"move" in result.stdout


def test_compiling_loads_no_heavy_library() -> None:
    program = (
        "import sys; sys.argv = ['vrts', 'compile', sys.argv[1]]\n"
        "from vrts.cli.main import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        f"print([m for m in {HEAVY!r} if m in sys.modules])"
    )
    for path in (SOLUTION, BROKEN):
        result = subprocess.run(
            [sys.executable, "-c", program, path], capture_output=True, cwd=ROOT, check=True
        )
        assert result.stdout.strip() == b"[]"


def test_what_a_program_types_goes_to_stdout_and_words_to_stderr() -> None:
    result = vrts("run", SOLUTION, "--scene", "cans-on-bases")
    assert result.returncode == 0
    assert result.stdout == b"Both cans are in place.\n"
    assert b"completed after" in result.stderr


def test_verify_takes_the_task_beside_the_program() -> None:
    result = vrts("verify", SOLUTION)
    assert result.returncode == 0
    assert result.stdout.startswith(b"10.0 / 10")


def test_verify_finds_the_contact_and_gives_status_1() -> None:
    result = vrts("verify", HITS, "--format", "json")
    assert result.returncode == 1
    found = json.loads(result.stdout)
    assert found["schema"] == "vrts.assessment/1"
    assert found["mark"] == 7.0
    assert "`can1` hits `base1`" in found["cause"]


def test_without_task_or_scene_verify_lists_the_scenes(tmp_path: Path) -> None:
    program = tmp_path / "p.v2"
    program.write_bytes(SOLUTION.read_bytes())
    result = vrts("verify", program)
    assert result.returncode == 2
    assert b"cans-on-bases" in result.stderr


def test_verify_writes_page_and_recording(tmp_path: Path) -> None:
    page, recording = tmp_path / "p.html", tmp_path / "r.rrd"
    result = vrts("verify", SOLUTION, "--html", page, "--record", recording)
    assert result.returncode == 0
    assert page.read_text().startswith("<!doctype html>") or "<html" in page.read_text()[:200]
    tool = Path(sys.executable).parent / "rerun"
    checked = subprocess.run(
        [tool, "rrd", "verify", recording], capture_output=True, text=True, check=False
    )
    assert checked.returncode == 0, checked.stderr
    assert "verified without error" in checked.stdout + checked.stderr


@pytest.mark.thorough
def test_grading_gives_a_row_for_everything_and_status_0(tmp_path: Path) -> None:
    folder = tmp_path / "in"
    folder.mkdir()
    (folder / "good.v2").write_bytes(SOLUTION.read_bytes())
    (folder / "empty.v2").write_bytes(b"")
    (folder / "binary.v2").write_bytes(bytes(range(256)) * 40)
    (folder / "huge-line.v2").write_bytes(b"MOVE " + b"a" * 10_000_000)
    (folder / "circular.v2").write_text(".PROGRAM a\n CALL b\n.END\n.PROGRAM b\n CALL a\n.END\n")
    (folder / "overflow.v2").write_text(".PROGRAM a\n x = 1E30\n x = x*x\n.END\n")
    (folder / "endless.v2").write_text(".PROGRAM a\n10 x = 1\n GOTO 10\n.END\n")
    result = vrts(
        "grade", EXAMPLE / "task.toml", folder, "-o", tmp_path / "out", "--format", "json"
    )
    assert result.returncode == 0, result.stderr.decode()
    found = json.loads(result.stdout)
    rows = {row["id"]: (row["result"]["kind"], row["final"]) for row in found["rows"]}
    assert found["schema"] == "vrts.class/1"
    assert rows == {
        "good": ("graded", 10.0),
        "empty": ("unreadable", 0.0),
        "binary": ("unreadable", 0.0),
        "huge-line": ("unreadable", 0.0),
        "circular": ("stopped by an error", 0.0),
        "overflow": ("stopped by an error", 0.0),
        "endless": ("stopped by a limit", 0.0),
    }
    for identifier in rows:
        assert (tmp_path / "out" / "students" / identifier / "report.html").is_file()
    assert (tmp_path / "out" / "staff" / "results.json").is_file()


def test_a_typo_in_a_task_points_into_the_file(tmp_path: Path) -> None:
    task = tmp_path / "task.toml"
    task.write_text((EXAMPLE / "task.toml").read_text().replace("\nposition_mm", "\npostion_mm", 1))
    result = vrts("grade", task, SOLUTION)
    assert result.returncode == 1
    assert b"task.toml:" in result.stderr
    assert b"did you mean" in result.stderr


def test_objects_inside_each_other_are_refused(tmp_path: Path) -> None:
    scene = (ROOT / "scenes" / "cans-on-bases" / "scene.toml").read_text()
    (tmp_path / "scene.toml").write_text(scene.replace("[800, -450]", "[940, -130]"))
    result = vrts("verify", SOLUTION, "--scene", tmp_path / "scene.toml")
    assert result.returncode == 1
    assert b"V613" in result.stderr


def test_a_missing_file_is_a_wrong_call() -> None:
    result = vrts("verify", "nowhere.v2")
    assert result.returncode == 2
    assert b"cannot read" in result.stderr


def test_colour_only_where_it_is_wanted() -> None:
    assert b"\x1b[" not in vrts("verify", HITS).stdout
    assert b"\x1b[" in vrts("verify", HITS, FORCE_COLOR="1").stdout
    assert b"\x1b[" not in vrts("verify", HITS, FORCE_COLOR="1", NO_COLOR="1").stdout


def test_a_terminal_gets_colour() -> None:
    import pty

    parent, child = pty.openpty()
    result = subprocess.run(
        [sys.executable, "-m", "vrts.cli.main", "compile", BROKEN],
        stderr=child,
        stdout=child,
        cwd=ROOT,
        env={**os.environ, "TERM": "xterm", "NO_COLOR": ""},
        check=False,
    )
    os.close(child)
    written = os.read(parent, 65536)
    os.close(parent)
    assert result.returncode == 1
    assert b"\x1b[" in written


def test_a_closed_pipe_is_no_error() -> None:
    command = f"{sys.executable} -m vrts.cli.main explain | head -n 1"
    result = subprocess.run(
        ["bash", "-o", "pipefail", "-c", command], capture_output=True, cwd=ROOT, check=False
    )
    assert b"Traceback" not in result.stderr


def test_explain_prints_a_page_and_helps_with_typing_errors() -> None:
    assert b"# V301 out-of-reach" in vrts("explain", "V301").stdout
    wrong = vrts("explain", "V3O1")
    assert wrong.returncode == 2
    assert b"did you mean" in wrong.stderr


def test_point_tells_and_saves(tmp_path: Path) -> None:
    program = tmp_path / "p.v2"
    program.write_text(".PROGRAM a\n MOVE above\n.END\n")
    result = vrts(
        "point", "cans-on-bases", "800", "-450", "-100", "--down", "--save", "above", program
    )
    assert result.returncode == 0, result.stderr
    assert b"reachable" in result.stdout
    assert "MOVE above" in program.read_text()
    assert vrts("compile", program).returncode == 0
    assert vrts("point", "cans-on-bases", "2500", "0", "0", "--down").returncode == 1
    assert vrts("point", "cans-on-bases", "1", "2").returncode == 2


def test_scene_show_prints_a_block_that_compiles(tmp_path: Path) -> None:
    shown = vrts("scene", "show", "cans-on-bases", "--svg", tmp_path / "map.svg")
    block = shown.stdout.decode().split(".LOCATIONS")[1]
    program = f".PROGRAM a\n MOVE can1_grip\n.END\n.LOCATIONS{block}"
    assert vrts("compile", "-", stdin=program.encode()).returncode == 0
    assert (tmp_path / "map.svg").read_text().startswith("<svg")


def test_hostile_program_text_reaches_no_terminal() -> None:
    program = b'.PROGRAM a\n TYPE "\x1b]0;x\x07"\n MOVEE \x1b[31m\n.END\n'
    result = vrts("compile", "-", stdin=program)
    assert result.returncode == 1
    assert b"\x1b" not in result.stderr


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("library", "words", "said"),
    [
        ("coal", ["verify", SOLUTION, "--engine", "coal"], b"no wheel for this machine (Windows)"),
        ("rerun", ["verify", SOLUTION, "--record", "never.rrd"], b"rerun-sdk"),
    ],
)
def test_a_missing_library_is_told_in_one_sentence(
    library: str, words: list[str | Path], said: bytes
) -> None:
    program = (
        f"import sys; sys.modules[{library!r}] = None\n"
        f"sys.argv = ['vrts', *{[str(word) for word in words]!r}]\n"
        "from vrts.cli.main import main\nmain()"
    )
    result = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, cwd=ROOT, check=False
    )
    assert result.returncode == 1
    assert said in result.stderr
    assert b"Traceback" not in result.stderr


def test_a_fault_of_vrts_has_its_own_status() -> None:
    program = (
        "import vrts.pipeline.compiling.programs\n"
        "def broken(*_): raise ValueError('sabotaged')\n"
        "vrts.pipeline.compiling.programs.compile_bytes = broken\n"
        f"import sys; sys.argv = ['vrts', 'compile', {str(SOLUTION)!r}]\n"
        "from vrts.cli.main import main\nmain()"
    )
    result = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, cwd=ROOT, check=False
    )
    assert result.returncode == 70
    assert b"please report" in result.stderr


@pytest.mark.parametrize("name", support_commands.LOADED)
def test_what_is_loaded_for_tests_is_there(name: str) -> None:
    assert find_spec(name) is not None
