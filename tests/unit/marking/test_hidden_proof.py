"""A hidden environment costs points and reaches nothing that a student gets."""

import re
import zipfile
from pathlib import Path

import pytest

from tests.support_commands import vrts_text
from tests.unit.marking.proven_task import FITTED, GOOD, MARKERS, written
from vrts.lsp.channel.verification import Asked
from vrts.lsp.runs.verifying import verify

FORMATS = ("moodle-feedback", "folders", "prairielearn")
NAMES = {"anna": FITTED, "bert": GOOD}


# of recordings: drawn, or a time and a count, so any digits may stand in one by chance
IDENTIFIER = re.compile(
    rb"[0-9A-Fa-f]{32}|[0-9A-Fa-f]{8}-(?:[0-9A-Fa-f]{4}-){3}[0-9A-Fa-f]{12}",
)


def told(data: bytes) -> list[str]:
    """Return the markers in some bytes, also where these are UTF-16."""
    data = IDENTIFIER.sub(b"", data)
    return [m for m in MARKERS if m.encode() in data or m.encode("utf-16-le") in data]


def leaks(folder: Path) -> dict[str, list[str]]:
    """Return the markers in every file of a folder, and in what is in its zips."""
    found: dict[str, list[str]] = {}
    for path in sorted(p for p in folder.rglob("*") if p.is_file()):
        found[path.name] = told(path.read_bytes())
        if zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as archive:
                for name in archive.namelist():
                    found[f"{path.name}/{name}"] = told(archive.read(name))
    assert found, "there is something to look at"
    return {name: markers for name, markers in found.items() if markers}


class Marked:
    """A class that was marked by a task with a hidden environment."""

    def __init__(self, home: Path) -> None:
        self.home = home
        self.task = written(home / "parts")
        handed_in = home / "class"
        handed_in.mkdir()
        for name, program in NAMES.items():
            (handed_in / f"{name}.v2").write_text(program)
        self.says = self.run("grade", self.task, handed_in, "--recordings", "-o", "out")
        self.run("task", "pack", self.task, "-o", home / "packed")
        self.zip = home / "packed" / "parts-student.zip"

    def run(self, *words: object, status: int = 0) -> str:
        done = vrts_text(*words, cwd=self.home)
        assert done.returncode == status, done.stderr
        return done.stdout + done.stderr


@pytest.fixture(scope="module")
def marked(tmp_path_factory: pytest.TempPathFactory) -> Marked:
    return Marked(tmp_path_factory.mktemp("marked"))


@pytest.mark.thorough
def test_a_program_that_fits_one_answer_loses_points_and_staff_read_why(marked: Marked) -> None:
    first = marked.says.splitlines()[0]
    assert first.startswith(" 5.5  anna.v2")
    assert marked.says.splitlines()[1].startswith("10.0  bert.v2")
    staff = marked.home / "out" / "staff"
    for file in ("students/anna/report.html", "students/anna/result.json", "marks.csv"):
        assert set(told((staff / file).read_bytes())) == set(MARKERS[1:]), file
    assert set(told((staff / "index.html").read_bytes())) >= {MARKERS[1]}
    assert 'class="tag hidden"' in (staff / "students/anna/report.html").read_text()


@pytest.mark.thorough
def test_nothing_of_it_is_in_what_is_written_for_students(marked: Marked) -> None:
    students = marked.home / "out" / "students"
    assert leaks(students) == {}
    assert "1 more at marking" in (students / "anna" / "report.html").read_text()
    assert (students / "anna" / "run.rrd").is_file()
    for form in FORMATS:
        place = marked.home / f"export-{form}"
        marked.run("grade", "export", "out", "--to", form, "-o", place)
        if place.is_dir():
            assert leaks(place) == {}, form
        else:
            with zipfile.ZipFile(place) as archive:
                assert [told(archive.read(name)) for name in archive.namelist()] == [
                    [] for _ in archive.namelist()
                ], form


def test_nothing_of_it_is_in_the_task_that_students_get(marked: Marked) -> None:
    with zipfile.ZipFile(marked.zip) as archive:
        names = archive.namelist()
        assert [told(archive.read(name)) for name in names] == [[] for _ in names]
    assert not [name for name in names if "staff" in name]
    with zipfile.ZipFile(marked.home / "packed" / "parts-staff.zip") as archive:
        assert "parts/staff/secret-cell.toml" in archive.namelist()


@pytest.mark.thorough
@pytest.mark.parametrize("whose", ["zip", "folder"])
def test_no_command_about_it_tells_students_more(marked: Marked, whose: str) -> None:
    task = marked.zip if whose == "zip" else marked.task
    program = marked.home / "class" / "anna.v2"
    place = marked.home / f"tried-{whose}"
    place.mkdir()
    given = (program, "--task", task)
    said = [
        marked.run("verify", *given, "--html", place / "page.html", "--record", place / "a.rrd"),
        marked.run("verify", *given, "--format", "json"),
        marked.run("run", program, "--task", marked.task, "--save", place / "run.vrun"),
        marked.run("prove", *given, "--counterexample", place / "bad.toml"),
        marked.run("grade", task, program) if whose == "zip" else "",
    ]
    assert [told(text.encode()) for text in said] == [[] for _ in said]
    assert "all public checks passed; 1 more at marking" in said[0]
    assert leaks(place) == {}


def test_neither_task_check_nor_an_editor_tells_it_where_the_task_was_unpacked(
    marked: Marked,
) -> None:
    with zipfile.ZipFile(marked.zip) as archive:
        archive.extractall(marked.home / "unpacked")
    folder = marked.home / "unpacked" / "parts"
    said = marked.run("task", "check", folder, status=1)
    assert told(said.encode()) == []
    for place in (folder, marked.task):
        answer = verify(Asked(str(place / "anna.v2"), FITTED))
        assert answer.is_whole
        assert told(repr(answer).encode()) == []
        assert "every future" not in repr(answer)
