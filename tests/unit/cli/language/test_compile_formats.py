"""`vrts compile --format`: streams, exit statuses, several files, names that try to steer."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.support_hostile import service_commands, steering
from tests.support_sarif import schema_errors
from tests.unit.cli.test_commands import BROKEN, HEAVY, ROOT, SOLUTION, vrts

ON_STDOUT = ("concise", "json", "sarif", "github")
PDF = b"%PDF-1.7\n"
NAMES = ["\x1b[31mred.v2", "\u202eright.v2", "::stop-commands::x", "##[error]x", "new\nline"]


@pytest.mark.parametrize("form", ON_STDOUT)
def test_formats_for_programs_go_to_stdout_alone(form: str) -> None:
    result = vrts("compile", BROKEN, "--format", form)
    assert result.returncode == 1
    assert result.stderr == b""
    assert b"V131" in result.stdout


@pytest.mark.parametrize("form", ON_STDOUT)
def test_what_compiles_gives_status_0_in_every_format(form: str) -> None:
    result = vrts("compile", SOLUTION, "--format", form)
    assert (result.returncode, result.stderr) == (0, b"")
    assert (result.stdout == b"") == (form in {"concise", "github"})


@pytest.mark.parametrize("form", ON_STDOUT)
def test_what_is_no_text_is_told_in_every_format(form: str) -> None:
    result = vrts("compile", "-", "--format", form, stdin=PDF)
    assert result.returncode == 1
    assert b"V102" in result.stdout
    assert b"stdin" in result.stdout


def test_several_files_are_told_in_order_and_the_worst_counts() -> None:
    result = vrts("compile", SOLUTION, BROKEN, "-", "--format", "sarif", stdin=PDF)
    assert result.returncode == 1
    log = json.loads(result.stdout)
    assert schema_errors(log) == []
    places = [
        row["locations"][0]["physicalLocation"]["artifactLocation"]["uri"]
        for row in log["runs"][0]["results"]
    ]
    assert set(places[:-1]) == {BROKEN.relative_to(ROOT).as_posix()}
    assert places[-1] == "stdin"


def test_for_people_every_file_has_its_summary() -> None:
    result = vrts("compile", SOLUTION, BROKEN, SOLUTION)
    assert result.returncode == 1
    assert result.stderr.count(b"compiles") == 2
    assert result.stderr.count(b"1 error") == 1
    assert vrts("compile", SOLUTION, SOLUTION).returncode == 0


def test_a_file_that_is_not_there_is_a_wrong_call_before_anything_is_written() -> None:
    result = vrts("compile", BROKEN, "nowhere.v2", "--format", "json")
    assert (result.returncode, result.stdout) == (2, b"")


def test_two_outputs_do_not_share_stdout() -> None:
    result = vrts("compile", SOLUTION, "--emit", "ir", "--format", "json")
    assert (result.returncode, result.stdout) == (2, b"")
    assert b"both write to stdout" in result.stderr


@pytest.mark.parametrize("form", ["full", *ON_STDOUT])
@pytest.mark.parametrize("name", NAMES)
def test_the_name_of_a_file_steers_nothing(form: str, name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_bytes(BROKEN.read_bytes())
    result = vrts("compile", name, "--format", form, cwd=tmp_path)
    assert result.returncode == 1
    text = (result.stdout + result.stderr).decode()
    assert steering(text) == []
    lines = text.splitlines() if form == "github" else service_commands(text)
    assert all(line.startswith(("::error file=", "::warning file=")) for line in lines)
    assert bool(lines) is (form == "github")


@pytest.mark.parametrize("name", NAMES)
def test_a_name_that_cannot_be_read_or_compiles_steers_nothing(name: str, tmp_path: Path) -> None:
    missing = vrts("compile", name, cwd=tmp_path)
    assert missing.returncode == 2
    (tmp_path / name).write_bytes(SOLUTION.read_bytes())
    fine = vrts("compile", name, cwd=tmp_path)
    assert fine.returncode == 0
    for result in (missing, fine):
        assert steering(result.stderr.decode()) == []
        assert service_commands(result.stderr.decode()) == []


@pytest.mark.parametrize("form", ["full", *ON_STDOUT])
def test_no_format_loads_what_it_does_not_need(form: str) -> None:
    program = (
        f"import sys; sys.argv = ['vrts', 'compile', sys.argv[1], '--format', {form!r}]\n"
        "from vrts.cli.main import main\n"
        "try: main()\n"
        "except SystemExit: pass\n"
        "print('', *sys.modules, file=sys.stderr)"
    )
    result = subprocess.run(
        [sys.executable, "-c", program, SOLUTION], capture_output=True, cwd=ROOT, check=True
    )
    loaded = set(result.stderr.decode().split())
    assert loaded & {*HEAVY, "vrts.engine", "vrts.check"} == set()
    assert ("vrts.report.formats.sarif" in loaded) is (form == "sarif")
    assert ("vrts.report.formats.diagnostic_json" in loaded) is (form in {"json", "sarif"})
    assert ("json" in loaded) is (form in {"json", "sarif"})
