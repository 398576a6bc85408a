"""Which task a program is verified by where nobody says; and that hand-ins never choose theirs."""

from pathlib import Path

import pytest

from vrts.pipeline.files import CannotRead
from vrts.pipeline.finding.task_of import MOST_LEVELS, is_beside, task_of


@pytest.fixture(autouse=True)
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with a task; one stands in it."""
    folder = tmp_path / "lab1"
    folder.mkdir()
    (folder / "task.toml").write_text("# the teacher's\n")
    monkeypatch.chdir(folder)
    return folder


def program(*parts: str, task: str | None = None) -> Path:
    """Return the path of a program below the lab; beside it is a task, if one is given."""
    path = Path(*parts, "p.v2")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("")
    if task is not None:
        (path.parent / "task.toml").write_text(task)
    return path


def test_beside_it_and_above_it(lab: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert task_of(program()) == Path("task.toml")
    assert task_of(program("work", "anna")) == Path("task.toml")
    assert task_of(program("work").absolute()) == lab / "task.toml"
    assert is_beside(Path("task.toml"), Path("p.v2"))
    assert not is_beside(Path("task.toml"), Path("work", "p.v2"))
    monkeypatch.chdir(lab / "work")
    assert task_of(Path("p.v2")) == Path("../task.toml")
    assert task_of(Path("../work/p.v2")) == Path("../task.toml")


def test_it_is_looked_for_no_further_than_is_sensible() -> None:
    near, far = ["a"] * MOST_LEVELS, ["b"] * (MOST_LEVELS + 1)
    assert task_of(program(*near)) == Path("task.toml")
    assert task_of(program(*far)) is None


def test_the_hidden_part_of_a_task_is_no_task() -> None:
    assert task_of(program("staff", task="[[goal]]\n")) == Path("task.toml")


@pytest.mark.parametrize("name", ["submissions", "Submissions", "hand-ins"])
def test_what_is_in_a_folder_of_hand_ins_chooses_no_task(lab: Path, name: str) -> None:
    for parts in ((name,), (name, "anna"), (name, "anna", "submissions"), (name, "x", "y", "z")):
        assert task_of(program(*parts, task="# anna's own\n")) == Path("task.toml")
    (lab / "task.toml").unlink()
    assert task_of(Path(name, "anna", "p.v2")) is None


@pytest.mark.parametrize("depth", [1, MOST_LEVELS, 3 * MOST_LEVELS])
def test_elsewhere_another_task_on_the_way_is_a_question(depth: int) -> None:
    path = program(*["downloads"] * depth, task="# anna's own\n")
    (path.parent / ".git").mkdir()  # where others would stop to look
    path.parent.chmod(0o777)
    with pytest.raises(CannotRead, match="two tasks may be meant") as refused:
        task_of(path)
    assert "--task" in refused.value.hints[0]


def test_a_copy_of_the_task_is_no_other_task() -> None:
    assert task_of(program("anna", task="# the teacher's\n")) == Path("task.toml")


def test_where_everybody_may_write_no_task_is_looked_for(lab: Path) -> None:
    lab.chmod(0o777)
    assert task_of(program("anna")) is None
    assert task_of(program()) == Path("task.toml"), "but beside the program it is its user's choice"


@pytest.mark.parametrize("own", ["# anna's own\n", "# the teacher's\n"])
@pytest.mark.parametrize("below", [("anna",), ("anna", "1")])
def test_what_is_not_taken_where_everybody_may_write_is_asked_about(
    lab: Path, own: str, below: tuple[str, ...]
) -> None:
    """A copy of the teacher's, too: the scene that it names stands beside it, and may be anna's."""
    path = program(*below, task=own)
    lab.chmod(0o777)  # as all folders are on a disk of Windows, seen from WSL
    with pytest.raises(CannotRead, match=r"two tasks may be meant: `anna.*` and `task.toml`"):
        task_of(path)


def test_what_somebody_puts_below_the_task_of_a_folder_is_not_taken_or_asked_about() -> None:
    path = program("drop", "anna")
    Path("drop", "task.toml").write_text("# anybody's\n")
    Path("drop").chmod(0o777)
    assert task_of(path) == Path("task.toml")


def test_at_home_and_far_above_it_is_the_same(lab: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    far = program(*["a"] * (MOST_LEVELS + 1), task="# the teacher's\n")
    with pytest.raises(CannotRead, match="two tasks may be meant"):
        task_of(far)
    monkeypatch.setenv("HOME", str(lab))
    with pytest.raises(CannotRead, match="two tasks may be meant"):
        task_of(program("anna", task="# anna's own\n"))


@pytest.mark.skipif(not Path("/proc/self/mem").exists(), reason="needs a file that fails")
def test_a_task_that_cannot_be_read_is_told(lab: Path) -> None:
    path = program("anna", task="")
    (lab / "task.toml").unlink()
    (lab / "task.toml").symlink_to("/proc/self/mem")  # has no bytes, and says so only when read
    with pytest.raises(CannotRead, match=r"cannot tell the task of `anna/p.v2`: input/output"):
        task_of(path)


def test_the_search_ends_at_home(lab: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(lab))
    assert task_of(program("anna")) is None
    assert task_of(program()) == Path("task.toml")
