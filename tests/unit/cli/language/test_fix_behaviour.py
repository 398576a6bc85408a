"""`vrts fix --behaviour` as a user runs it, and what it may say at each level of hints."""

import shutil
from pathlib import Path

import pytest

from tests.golden.examples import EXAMPLES
from tests.laws import first
from tests.unit.cli.test_commands import vrts

WRONG = ("APPRO start, 120", "APPRO start, -120")
TOLD = {
    "nothing": "",
    "place": "look at line 13\n",
    "direction": "look at line 13: -120 is too small\n",
    "number": "look at line 13: -120 is too small, 120 would do; every whole number from ",
    "edit": "one change away: 10 with line 13: `120` for `-120`; every whole number from ",
}


@pytest.fixture
def program(tmp_path: Path) -> Path:
    """Return a program with a mistake, beside its task."""
    shutil.copy(EXAMPLES[0] / "task.toml", tmp_path)
    path = tmp_path / "prog.v2"
    path.write_text((EXAMPLES[0] / "solution.v2").read_text().replace(*WRONG))
    return path


@pytest.mark.thorough
@pytest.mark.parametrize("level", first(2, TOLD))  # `edit` is what is shown below
def test_no_more_is_told_than_the_task_allows(level: str, program: Path) -> None:
    task = program.parent / "task.toml"
    task.write_text(f'{task.read_text()}\n[hints]\nlevel = "{level}"\n')
    result = vrts("fix", "--behaviour", program)
    told = result.stdout.decode()
    assert TOLD[level] in told
    assert ("would do, certified" in told) == (level in ("number", "edit"))
    assert bool(told) == (level != "nothing")
    for option in ("--diff", "--write") if level != "edit" else ():  # there: see below
        before = program.read_text()
        result = vrts("fix", "--behaviour", option, program)
        assert program.read_text() == before
        assert "+        APPRO" not in result.stdout.decode()
        assert result.returncode == 1


@pytest.mark.thorough
def test_the_change_is_shown_and_written(program: Path) -> None:
    result = vrts("fix", "--behaviour", "--diff", program)
    assert b"+        APPRO start, 120 " in result.stdout
    result = vrts("fix", "--behaviour", "--write", program)
    assert result.returncode == 0
    assert program.read_text() == (EXAMPLES[0] / "solution.v2").read_text()
    result = vrts("fix", "--behaviour", program)
    assert b"nothing to mend: it earns 10" in result.stderr


@pytest.mark.thorough
def test_where_nothing_mends_a_program_it_is_told_where_points_go(tmp_path: Path) -> None:
    """The whole way round the walls is missing: no place to begin with."""
    shutil.copy(EXAMPLES[2] / "task.toml", tmp_path)
    program = tmp_path / "prog.v2"
    shutil.copy(EXAMPLES[2] / "submissions" / "over-the-walls.v2", program)
    result = vrts("fix", "--behaviour", program)
    assert (
        b"no change was found that earns the full mark; what is lost shows at lines 9 and 11"
        in (result.stdout + result.stderr)
    )
    assert result.returncode == 1


def test_an_unknown_level_is_an_error_of_the_task(program: Path) -> None:
    task = program.parent / "task.toml"
    task.write_text(f'{task.read_text()}\n[hints]\nlevel = "all"\n')
    result = vrts("fix", "--behaviour", program)
    assert result.returncode != 0
    assert b"all" in result.stderr + result.stdout


def test_a_task_is_for_behaviour_only(program: Path) -> None:
    result = vrts("fix", "--task", program.parent, program)
    assert b"only behaviour is mended for a task" in result.stderr
