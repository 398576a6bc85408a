"""`vrts replay` of a saved run: what happened, and the page that plays it both ways."""

from pathlib import Path

import pytest

from tests.support_commands import Said, vrts_text

PROGRAM = ".PROGRAM main()\nDRIVE 1,20,100\nOPENI\n.END\n"


@pytest.fixture(scope="module")
def saved(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("saved")
    (folder / "turn.v2").write_text(PROGRAM)
    done = vrts(folder, "run", "turn.v2", "--scene", "cans-on-bases", "--save", "turn.vrun")
    assert done.returncode == 0, done.stderr
    return folder / "turn.vrun"


def vrts(folder: Path, *words: str) -> Said:
    return vrts_text(*words, cwd=folder)


def test_a_saved_run_is_told_and_shown(saved: Path) -> None:
    done = vrts(saved.parent, "replay", "turn.vrun", "--page", "--no-open")
    assert done.returncode == 0, done.stderr
    assert "DRIVE 1,20,100" in done.stdout
    assert "wrote turn.html" in done.stderr
    page = (saved.parent / "turn.html").read_text(encoding="utf-8")
    assert '"horizon":' in page
    assert "OPENI" in page


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--scene", "cans-on-bases"), "its scene is in it"),
        (("--session", "1"), "one run"),
        (("-o", "x.html"), "give `--page` too"),
    ],
)
def test_options_that_do_not_fit_are_refused(
    saved: Path, words: tuple[str, ...], said: str
) -> None:
    done = vrts(saved.parent, "replay", "turn.vrun", *words)
    assert done.returncode == 2
    assert said in done.stderr
    assert not (saved.parent / "x.html").exists()
