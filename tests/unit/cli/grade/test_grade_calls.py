"""Calls of `vrts grade` that cannot be meant: what is wrong is named, and nothing is marked."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from vrts.cli.main import vrts
from vrts.pipeline.files import CHECKOUT

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
SOLUTION = EXAMPLE / "solution.v2"


def call(*words: object) -> Result:
    return CliRunner().invoke(vrts, ["grade", *map(str, words)])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("nope", "x"), "there is no task `nope`"),
        (("nope",), "there is no task `nope`"),
        (("init", "gradescope", "nope"), "there is no task `nope`"),
        (("cans-on-bases",), "there is no task `cans-on-bases`"),
        ((EXAMPLE, "x"), "there is no `x`"),
        ((EXAMPLE, "/dev/zero"), "`/dev/zero` is neither a file nor a folder"),
        ((EXAMPLE, SOLUTION, "-o", "file"), "`file` is a file, and results want a folder"),
        (("plan", EXAMPLE, SOLUTION, "-o", "file"), "`file` is a file, and results want a folder"),
        (("merge", "plan", "-o", "file"), "`file` is a file, and results want a folder"),
        (("empty", SOLUTION), "there is no `task.toml` in `empty`"),
        (("task",), "no submissions given"),
        (
            ("export", "out", "--to", "json", "--decimal", "comma"),
            "`--decimal` is for the formats csv, moodle and canvas: the others have their own way",
        ),
    ],
    ids=str,
)
def test_what_is_wrong_is_named(
    words: tuple[object, ...], said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "file").write_text("mine")
    (tmp_path / "empty").mkdir()
    (tmp_path / "task").mkdir()
    (tmp_path / "task" / "task.toml").write_bytes((EXAMPLE / "task.toml").read_bytes())
    found = call(*words)
    assert found.exit_code == 2, found.output
    assert found.stderr.splitlines()[0] == f"error: {said}"
    assert found.stdout == ""
    assert (tmp_path / "file").read_text() == "mine"


def test_an_example_is_named_where_its_scene_was_meant() -> None:
    assert "did you mean the example `01-cans-on-bases`?" in call("cans-on-bases").stderr
    assert "did you mean the example `02-dish-on-stand`?" in call("02-dish-on-stnad").stderr
    assert "did you mean" not in call("something else").stderr
