"""A wheel holds what vrts consists of, and nothing that lies beside it."""

import subprocess
from importlib.metadata import Distribution, PathDistribution
from pathlib import Path

import pytest

from vrts.marking.exports.autograders import own_wheel as own_wheel_module
from vrts.marking.exports.autograders.autograder_zip import read_wheels
from vrts.marking.exports.autograders.own_files import (
    NoFiles,
    checkout_files,
    installed_files,
    is_checkout,
)
from vrts.pipeline.files import CannotRead
from vrts.pipeline.refused import Refused

OWN = ("vrts/__init__.py", "scenes/one/scene.toml", "examples/x/task.toml", "README.md")
OF_STUDENTS = (
    "examples/x/out/staff/names.csv",
    "examples/x/submissions/anna.v2",
    "scenes/marks.csv",
    "vrts/site/built/marks.html",
    "vrts/notes-about-ben.txt",
)


def written(root: Path, names: tuple[str, ...]) -> None:
    for name in names:
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(name)


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """Return a checkout in which a class was marked."""
    root = tmp_path / "checkout"
    written(root, OWN)
    (root / ".gitignore").write_text("out/\nvrts/site/built/\n")
    for words in (("init", "-q"), ("add", ".")):
        subprocess.run(["git", "-C", root, *words], check=True)
    written(root, OF_STUDENTS)
    return root


def test_what_is_about_students_stays_here(checkout: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_DIR", "/nowhere")  # as in a hook of another repository
    assert {name: data.decode() for name, data in checkout_files(checkout).items()} == {
        "vrts/__init__.py": "vrts/__init__.py",
        "vrts/library/scenes/one/scene.toml": "scenes/one/scene.toml",
        "vrts/library/examples/x/task.toml": "examples/x/task.toml",
    }
    (checkout / "examples/x/task.toml").unlink()
    assert len(checkout_files(checkout)) == 2


@pytest.mark.parametrize("name", ["examples/x/task.toml", "examples/x"])
def test_a_link_is_refused(name: str, checkout: Path, tmp_path: Path) -> None:
    (checkout / name).rename(tmp_path / "elsewhere")
    (checkout / name).symlink_to(tmp_path / "elsewhere")
    with pytest.raises(NoFiles, match=r"^`examples/x/task\.toml` is a link$"):
        checkout_files(checkout)


def test_a_folder_that_git_does_not_know_is_refused(tmp_path: Path) -> None:
    written(tmp_path, OWN)
    with pytest.raises(NoFiles, match=r"which is no checkout of Git$"):
        checkout_files(tmp_path)


def installed(site: Path, listed: tuple[str, ...]) -> Distribution:
    info = site / "vrts-0.1.0.dist-info"
    info.mkdir(parents=True)
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: vrts\nVersion: 0.1.0\n")
    (info / "RECORD").write_text("".join(f"{name},,\n" for name in listed))
    return PathDistribution(info)


def test_what_was_installed_is_what_its_list_says(tmp_path: Path) -> None:
    made = (
        "vrts/__init__.py",
        "vrts/__pycache__/x.pyc",
        "../../bin/vrts",
        "vrts-0.1.0.dist-info/RECORD",
    )
    found = installed(tmp_path / "site", made)
    written(tmp_path / "site", ("vrts/__init__.py", *OF_STUDENTS))
    assert list(installed_files(found)) == ["vrts/__init__.py"]
    with pytest.raises(NoFiles, match="cannot be read"):
        installed_files(installed(tmp_path / "other", made))


def test_another_vrts_than_the_one_that_runs_is_refused(
    checkout: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    found = installed(tmp_path / "site", ("vrts/__init__.py",))
    written(tmp_path / "site", ("vrts/__init__.py",))
    assert not is_checkout(found, checkout)
    (tmp_path / "site" / "vrts-0.1.0.dist-info" / "direct_url.json").write_text(
        f'{{"url": "{checkout.as_uri()}", "dir_info": {{"editable": true}}}}'
    )
    assert is_checkout(found, checkout)
    assert not is_checkout(found, tmp_path)

    def other(_: str) -> Distribution:
        return found

    monkeypatch.setattr(own_wheel_module, "distribution", other)
    monkeypatch.setattr(own_wheel_module, "__version__", "0.1.0")
    with pytest.raises(Refused) as refused:
        own_wheel_module.own_wheel()
    assert "and another one is installed" in refused.value.diagnostics[0].headline


def test_two_wheels_of_vrts_are_refused(tmp_path: Path) -> None:
    version = own_wheel_module.__version__
    names = (f"vrts-{version}-py3-none-any.whl", f"vrts-{version}-9-py3-none-any.whl")
    written(tmp_path, names)
    with pytest.raises(CannotRead, match=r"^there are 2 wheels of vrts: "):
        read_wheels((tmp_path,))
    assert list(read_wheels((tmp_path / names[0],))) == [names[0]]
    (tmp_path / "none").mkdir()
    with pytest.raises(CannotRead) as asked:
        read_wheels((tmp_path / "none",))
    assert asked.value.hints == ("build that of vrts with `python -m build --wheel`",)
