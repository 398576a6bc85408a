"""`vrts grade --pseudonyms`: no name in any file but one, also when the class is marked again."""

import csv
import re
import shutil
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from vrts.cli.main import vrts
from vrts.marking.layout import Layout
from vrts.marking.privacy.pseudonyms import COLUMN, KEY, NAMES, key_for, pseudonym
from vrts.marking.row import class_from_bytes
from vrts.pipeline.files import CHECKOUT

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
PEOPLE = {
    "Annegret Bergmeister_1234_assignsubmission_file_": ("bergmeister.v2", "solution.v2"),
    "Zoltán Kisfaludy_1235_assignsubmission_file_": ("kisfaludy.v2", "submissions/hits-base.v2"),
}
SECRETS = ("annegret", "bergmeister", "zolt", "kisfaludy", "1234", "1235", "laszlo")
PACKED = re.compile("[A-Za-z0-9+/=]{200,}")  # data in letters, where four letters stand by chance


def names_in(text: str) -> list[str]:
    """Return the names that a text tells; numbers stand anywhere."""
    said = PACKED.sub("", text).casefold()
    return [secret for secret in SECRETS if secret in said and not secret.isdigit()]


def call(*words: object) -> Result:
    """Call `vrts`."""
    return CliRunner().invoke(vrts, [str(word) for word in words])


@pytest.fixture(scope="module")
def download(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a download as Moodle packs it, with a third who handed in two files."""
    home = tmp_path_factory.mktemp("download")
    for folder, (name, program) in PEOPLE.items():
        (home / folder).mkdir()
        (home / folder / name).write_bytes((EXAMPLE / program).read_bytes())
    both = home / "Laszlo Laszlo_1236_assignsubmission_file_"
    both.mkdir()
    for name in ("laszlo1.v2", "laszlo2.v2"):
        (both / name).write_bytes((EXAMPLE / "solution.v2").read_bytes() + name.encode())
    return home


@pytest.fixture(scope="module")
def out(download: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the output of a marking with pseudonyms."""
    folder = tmp_path_factory.mktemp("results") / "out"
    done = call("grade", EXAMPLE, download, "-o", folder, "--pseudonyms")
    assert done.exit_code == 0, done.output
    assert not [secret for secret in SECRETS if secret in done.stdout.casefold()]
    return folder


@pytest.mark.thorough
def test_no_name_is_anywhere_but_in_one_table(out: Path) -> None:
    files = [path for path in out.rglob("*") if path.is_file()]
    assert len(files) > 10
    for path in files:
        if path.name in (NAMES, KEY):
            continue
        text = path.read_text("utf-8", errors="replace")
        assert not names_in(f"{path.relative_to(out)} {text}"), path
    table = (out / "staff" / NAMES).read_text("utf-8-sig")
    assert table.startswith(f"{COLUMN},id,name,")
    assert "Bergmeister" in table
    assert not (out / "staff" / "intake.csv").exists()


def test_marks_are_those_of_the_same_programs(out: Path) -> None:
    layout = Layout(out)
    rows = {row.id: row for row in class_from_bytes(layout.results.read_bytes()).rows}
    with (out / "staff" / NAMES).open(encoding="utf-8-sig", newline="") as file:
        people = list(csv.DictReader(file))
    ids = {line["name"]: line[COLUMN] for line in people}
    assert rows[ids["Annegret Bergmeister"]].final == 10.0
    assert rows[ids["Zoltán Kisfaludy"]].final not in (None, 10.0)
    identifier = next(line["id"] for line in people if "Bergmeister" in line["name"])
    assert pseudonym(identifier, key_for(layout)) == ids["Annegret Bergmeister"]


def test_a_second_marking_has_the_same_ids_and_marks_nothing_anew(
    out: Path, download: Path
) -> None:
    before = {p: p.stat().st_mtime_ns for p in (out / "students").rglob("report.html")}
    done = call("grade", EXAMPLE, download, "-o", out, "--pseudonyms")
    assert done.exit_code == 0
    assert {p: p.stat().st_mtime_ns for p in (out / "students").rglob("report.html")} == before


@pytest.mark.thorough
def test_names_do_not_come_in_later(out: Path, download: Path, tmp_path: Path) -> None:
    done = call("grade", EXAMPLE, download, "-o", out)
    assert done.exit_code == 1
    assert "error[V773 names-and-pseudonyms]" in done.stderr
    assert call("grade", EXAMPLE, download, "-o", tmp_path, "--no-pages").exit_code == 0
    done = call("grade", EXAMPLE, download, "-o", tmp_path, "--pseudonyms")
    assert "error[V773 names-and-pseudonyms]" in done.stderr
    assert call("grade", EXAMPLE, download, "--pseudonyms").exit_code == 2


@pytest.mark.thorough
def test_evidence_is_found_by_name_and_has_none(out: Path, tmp_path: Path) -> None:
    import zipfile

    place = tmp_path / "evidence.zip"
    done = call("grade", "evidence", "Annegret Bergmeister", "--from", out, "-o", place)
    assert done.exit_code == 0, done.output
    with zipfile.ZipFile(place) as archive:
        program = next(name for name in archive.namelist() if name.startswith("submission/"))
        assert archive.read(program) == (EXAMPLE / "solution.v2").read_bytes()
        for name in archive.namelist():
            assert not names_in(f"{name} {archive.read(name).decode('utf-8', 'replace')}"), name
    assert call("grade", "reproduce", place).exit_code == 0


def test_exports_have_the_names_again(out: Path, tmp_path: Path) -> None:
    words = ("grade", "export", out, "--to", "csv", "-o", tmp_path / "marks.csv")
    done = call(*words)
    assert done.exit_code == 1, done.output
    assert "(ambiguous)" in done.output
    assert not (tmp_path / "marks.csv").exists()
    done = call(*words, "--despite", "ambiguous")
    assert done.exit_code == 0, done.output
    lines = (tmp_path / "marks.csv").read_text("utf-8-sig").splitlines()
    (anna,) = [line for line in lines if "Annegret Bergmeister" in line]
    assert ",10" in anna


def test_who_is_not_in_the_worksheet_is_told_by_name(out: Path, tmp_path: Path) -> None:
    sheet = tmp_path / "worksheet.csv"
    sheet.write_text(
        "Identifier,Full name,Email address,Status,Grade,Maximum Grade\n"
        "Participant 1234,Annegret Bergmeister,a@example.org,Submitted,,10.00\n"
    )
    words = ("--to", "moodle", "--fill", sheet, "-o", tmp_path / "filled.csv")
    words = (*words, "--despite", "ambiguous")
    done = call("grade", "export", out, *words)
    assert done.exit_code == 0, done.output
    lacking = re.findall(r"`([^`]+)` \(`[a-z]{4}-[a-z]{4}-[a-z]{4}`\)", done.stderr)
    assert sorted(lacking) == ["Laszlo Laszlo", "Zoltán Kisfaludy"]


def test_files_named_one_by_one_are_not_told(tmp_path: Path) -> None:
    (tmp_path / "kisfaludy.v2").write_bytes((EXAMPLE / "solution.v2").read_bytes())
    words = (EXAMPLE, tmp_path / "kisfaludy.v2", "-o", tmp_path / "out", "--no-pages")
    done = call("grade", *words, "--pseudonyms")
    assert done.exit_code == 0
    assert "kisfaludy" not in (tmp_path / "out" / "staff" / "marking.json").read_text()


def test_the_table_of_names_is_obeyed_when_it_was_edited(
    out: Path, download: Path, tmp_path: Path
) -> None:
    shutil.copytree(out, tmp_path / "out")
    table = tmp_path / "out" / "staff" / NAMES
    text = table.read_text("utf-8-sig")
    (line,) = [line for line in text.splitlines() if "Bergmeister" in line]
    cells = line.split(",")
    at = text.splitlines()[0].split(",").index("problem")
    edited = ",".join([*cells[:at], "excused", *cells[at + 1 :]])
    table.write_text(text.replace(line, edited), "utf-8")
    for _ in range(2):  # also when it is read the second time
        done = call("grade", EXAMPLE, download, "-o", tmp_path / "out", "--pseudonyms")
        assert done.exit_code == 0, done.output
        rows = class_from_bytes(Layout(tmp_path / "out").results.read_bytes()).rows
        assert {row.id: row.result.kind.value for row in rows}[cells[0]] == "excused"
        assert len(rows) == 3
