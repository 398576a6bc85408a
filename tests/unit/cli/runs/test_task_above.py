"""Commands take the task of the folder above, from wherever one stands, and say which it is."""

import shutil
from pathlib import Path

import pytest

from tests.places import ROOT
from tests.support_commands import vrts_text

EXAMPLE = ROOT / "examples" / "01-cans-on-bases"
HITS = EXAMPLE / "submissions" / "hits-base.v2"


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    folder = tmp_path / "lab1"
    (folder / "submissions" / "anna").mkdir(parents=True)
    shutil.copy(EXAMPLE / "task.toml", folder)
    shutil.copy(HITS, folder / "submissions")
    shutil.copy(HITS, folder / "submissions" / "anna" / "p.v2")
    return folder


def test_from_within_the_folder_of_hand_ins(lab: Path) -> None:
    inside = vrts_text("verify", "hits-base.v2", cwd=lab / "submissions")
    outside = vrts_text("verify", "submissions/hits-base.v2", cwd=lab)
    assert inside.stderr == "by the task `../task.toml`\n"
    assert outside.stderr == "by the task `task.toml`\n"
    assert inside.stdout.replace("hits-base.v2", "") == outside.stdout.replace(
        "submissions/hits-base.v2", ""
    ).replace("hits-base.v2", "")
    assert (inside.returncode, outside.returncode) == (1, 1)
    assert vrts_text("verify", "hits-base.v2", "-q", cwd=lab / "submissions").stderr == ""


def test_a_hand_in_brings_no_task_of_its_own(lab: Path) -> None:
    own = (lab / "task.toml").read_text().replace('title = "', 'title = "Easy ')
    (lab / "submissions" / "anna" / "task.toml").write_text(own)
    said = vrts_text("verify", "p.v2", cwd=lab / "submissions" / "anna")
    assert "by the task `../../task.toml`" in said.stderr
    assert "Easy" not in said.stdout
    (lab / "submissions").rename(lab / "download")
    asked = vrts_text("verify", "p.v2", cwd=lab / "download" / "anna")
    assert asked.returncode == 2
    assert "two tasks may be meant: `task.toml` and `../../task.toml`" in asked.stderr
    (lab / "download").rename(lab / "submissions")
    (lab / "task.toml").unlink()
    refused = vrts_text("verify", "submissions/anna/p.v2", cwd=lab)
    assert refused.returncode == 2
    assert "`submissions/anna/task.toml` may have been handed in with it" in refused.stderr
    assert "help: if it is yours: `--task submissions/anna/task.toml`" in refused.stderr


def test_a_folder_stands_for_the_program_in_it(lab: Path) -> None:
    shutil.copy(EXAMPLE / "solution.v2", lab)
    assert (
        vrts_text("verify", ".", cwd=lab).stdout
        == vrts_text("verify", "solution.v2", cwd=lab).stdout
    )
    assert vrts_text("compile", str(lab), cwd=lab.parent).returncode == 0
    shutil.copy(EXAMPLE / "solution.v2", lab / "other.v2")
    several = vrts_text("verify", ".", cwd=lab)
    assert several.returncode == 2
    assert "error: there are several programs in `.`" in several.stderr
    assert "`other.v2`, `solution.v2`" in several.stderr
    assert "`vrts grade .`" in several.stderr
    none = vrts_text("run", "pictures", cwd=EXAMPLE)
    assert none.returncode == 2
    assert "there is no program in `pictures`" in none.stderr
