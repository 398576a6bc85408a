"""Which table is about which download: several may lie in one folder."""

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.places import ROOT
from tests.unit.marking.intake.support import PICK, put, zipped
from vrts.cli.main import vrts
from vrts.marking.intake.tables.own_table import own_table, remark_on
from vrts.marking.intake.tree.opening import open_place

ONE = {"anna.v2": PICK, "ben.v2": PICK}
TWO = {"anna.v2": PICK, "cara.v2": PICK}
OLD = b"id,file,problem\nanna,anna.v2,\n"


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a folder with downloads of two labs, which is the working folder."""
    (tmp_path / "lab1.zip").write_bytes(zipped(ONE))
    (tmp_path / "lab2.zip").write_bytes(zipped(TWO))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def intake(*words: str) -> Result:
    return CliRunner().invoke(vrts, ["grade", "intake", *words])


def obeyed(place: Path) -> tuple[str | None, tuple[str, ...]]:
    with open_place(place) as tree:
        found = own_table(place, tree)
    return (None if found.path is None else found.path.name), found.remarks


def test_every_download_has_its_own_table(home: Path) -> None:
    told = intake("lab1.zip").stderr
    assert told == (
        "wrote intake.csv: change what is not right, and `vrts grade TASK lab1.zip` obeys it\n"
    )
    why = "`intake.csv` is of `lab1.zip`, and was not obeyed; with `--intake intake.csv` it is"
    assert obeyed(Path("lab1.zip")) == ("intake.csv", ())
    assert obeyed(Path("lab2.zip")) == (None, (why,))
    before = (home / "intake.csv").read_bytes()
    assert "wrote lab2-intake.csv" in intake("lab2.zip", "--delimiter", ";").stderr
    assert (home / "intake.csv").read_bytes() == before
    assert obeyed(Path("lab1.zip")) == ("intake.csv", ())
    assert obeyed(Path("lab2.zip")) == ("lab2-intake.csv", ())
    for place in ("lab1.zip", "lab2.zip"):
        again = intake(place)
        assert again.exit_code == 2
        assert "is there already" in again.stderr


def test_a_table_that_names_no_download_is_obeyed_where_it_fits_and_that_is_told(
    home: Path,
) -> None:
    (home / "intake.csv").write_bytes(OLD)
    for place in ("lab1.zip", "lab2.zip"):
        why = f"`intake.csv` does not say of which download it is: it was obeyed for `{place}`"
        assert obeyed(Path(place)) == ("intake.csv", (why,))
    (home / "intake.csv").write_bytes(OLD.replace(b"anna", b"dora"))
    why = "`intake.csv` names no file of `lab1.zip`, and was not obeyed"
    assert obeyed(Path("lab1.zip")) == (None, (why,))
    assert intake("lab1.zip").exit_code == 2  # nobody's table is lost


def test_a_table_in_a_folder_is_of_that_folder_whatever_it_is_called(home: Path) -> None:
    put(home / "class", ONE)
    assert "`vrts grade TASK class` obeys it" in intake("class", "--program", "pick").stderr
    (home / "class").rename(home / "renamed")
    assert obeyed(home / "renamed") == ("intake.csv", ())


def test_a_table_that_was_asked_for_is_obeyed_and_what_is_odd_is_told(home: Path) -> None:
    told = intake("lab1.zip", "-o", "mine.csv").stderr
    assert "`vrts grade TASK lab1.zip --intake mine.csv` obeys it" in told
    mine = home / "mine.csv"
    why = "`mine.csv` was written for `lab1.zip`, and was obeyed for `lab2.zip`"
    assert remark_on(mine, home / "lab1.zip") == ()
    assert remark_on(mine, home / "lab2.zip") == (why,)
    assert remark_on(mine, home) == ()


def test_marking_obeys_the_table_of_its_own_download_only(home: Path) -> None:
    task = ROOT / "examples" / "01-cans-on-bases"
    intake("lab1.zip")
    table = home / "intake.csv"
    table.write_text(table.read_text().replace("anna,", "somebody,"))
    words = ["grade", str(task), "lab2.zip", "-o", "out", "--no-pages", "--no-collisions"]
    marked = CliRunner().invoke(vrts, words)
    assert marked.exit_code == 0, marked.output
    assert "note: `intake.csv` is of `lab1.zip`, and was not obeyed" in marked.stderr
    assert {path.name for path in (home / "out" / "students").iterdir()} == {"anna", "cara"}
    marked = CliRunner().invoke(vrts, [*words[:2], "lab1.zip", *words[3:]])
    assert marked.exit_code == 0, marked.output
    assert (home / "out" / "students" / "somebody").is_dir()
    assert ",lab1.zip" in (home / "out" / "staff" / "intake.csv").read_text()
