"""A class each of whom has an own variant: handed out, marked here and elsewhere, appealed."""

import csv
import re
import shutil
import zipfile
from pathlib import Path
from typing import NamedTuple

import pytest
from click.testing import CliRunner, Result

from tests.places import ROOT
from vrts.assignments.variants.key import NAME, key_of
from vrts.assignments.variants.of_task import load_varied
from vrts.check.variants.drawn import drawn
from vrts.cli.main import vrts
from vrts.marking.layout import RESULT, Layout
from vrts.marking.privacy.purge import FOLDERS
from vrts.marking.row import Row, class_from_bytes
from vrts.marking.similarity.kept import place_of, read_kept
from vrts.marking.similarity.ranking import similarity
from vrts.scene.block import location_block

LAB = ROOT / "examples" / "08-own-numbers" / "lab1"
CLASS = {"4711": "Ada Byron", "4712": "Kurt Weill", "4713": "Lena Meyer", "4714": "Nobody Yet"}
HEADER = "Identifier,Full name,Email address,Status"


class Home(NamedTuple):
    lab: Path
    roster: Path
    download: Path
    zips: Path

    def grade(self, out: Path, *more: object) -> Result:
        words = (self.lab, self.download, "--roster", self.roster, "-o", out, "--no-pages")
        return call("grade", *words, "--jobs", 1, *more)


def call(*words: object) -> Result:
    return CliRunner().invoke(vrts, [str(word) for word in words])


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Home:
    """Return a class whose zips are handed out: Kurt hands in what is Ada's, a stranger too."""
    folder = tmp_path_factory.mktemp("class")
    found = Home(folder / "lab1", folder / "grades.csv", folder / "download", folder / "zips")
    shutil.copytree(LAB, found.lab)
    lines = [f"Participant {n},{name},{n}@b.c,No submission" for n, name in CLASS.items()]
    found.roster.write_text("\n".join((HEADER, *lines)) + "\n")
    words = ("--roster", found.roster, "-o", found.zips, "--untried")
    told = call("task", "variants", found.lab, *words)
    assert told.exit_code == 0, told.output
    varied, key = load_varied(found.lab), key_of(found.lab / NAME)
    for name, number, whose in (
        *(("Ada Byron", "4711", "4711"), ("Kurt Weill", "4712", "4711")),
        *(("Lena Meyer", "4713", "4713"), ("Strange R", "9999", "4711")),
    ):
        variant = drawn(varied.variants, key, f"{whose}@b.c")
        place = found.download / f"{name}_{number}_assignsubmission_file_"
        place.mkdir(parents=True)
        (place / "mine.v2").write_bytes(varied.reference(variant.combination) or b"")
    return found


@pytest.fixture(scope="module")
def marked(home: Home) -> Layout:
    out = home.zips.parent / "out"
    told = home.grade(out)
    assert told.exit_code == 0, told.output
    return Layout(out)


def rows_of(layout: Layout) -> dict[str, Row]:
    rows = class_from_bytes(layout.results.read_bytes()).rows
    return {re.sub(r"\D", "", row.id): row for row in rows}


def doubts(row: Row) -> list[str]:
    return [f"{doubt.reason.value}: {doubt.sentence}" for doubt in row.unsafe]


def test_everybody_has_a_zip_and_staff_a_table(home: Home) -> None:
    with (home.zips / "variants.csv").open(encoding="utf-8-sig", newline="") as file:
        table = list(csv.DictReader(file))
    assert [line["name"] for line in table] == list(CLASS.values())
    names = {line["zip"] for line in table}
    assert names == {path.name for path in (home.zips / "students").iterdir()}
    private = [path for path in home.zips.rglob("*") if path.is_file()]
    assert {path.stat().st_mode & 0o777 for path in private} == {0o600}
    with zipfile.ZipFile(home.zips / "moodle-feedback.zip") as archive:
        folders = sorted(name.split("/")[0] for name in archive.namelist())
    wanted = [f"{v.replace(' ', '-')}_{n}_assignsubmission_file_" for n, v in CLASS.items()]
    assert folders == sorted(wanted)


@pytest.mark.thorough
def test_each_is_marked_by_the_own_variant_and_a_copy_is_told(home: Home, marked: Layout) -> None:
    rows = rows_of(marked)
    tags = {number: row.result.variant and row.result.variant.tag for number, row in rows.items()}
    assert len(set(tags.values())) == 5  # with the stranger's, who has none
    assert [rows[number].final for number in ("4711", "4713")] == [10.0, 10.0]
    assert doubts(rows["4711"]) == doubts(rows["4713"]) == []
    copy = rows["4712"]
    assert copy.final is not None
    assert copy.final <= 5
    its_own = f"marked by the student's own, `{tags['4712']}`"
    of_ada = f"its places are those of the variant `{tags['4711']}`, of `Ada Byron`"
    (doubt,) = doubts(copy)  # how many of them differ from the own variant depends on the key
    said = re.fullmatch(rf"variant: (\d+ of )?{of_ada}, where it would earn 10; {its_own}", doubt)
    assert said, doubt
    assert doubts(rows["9999"]) == [
        "variant: it is by nobody in the list of the class: marked by the task as it is written"
    ]
    assert doubts(rows["4714"]) == []  # nothing was handed in
    for row in rows.values():  # students learn their variant, and nothing of anybody else
        assert "Ada Byron" not in (marked.student(row.id) / RESULT).read_text()
    assert "staff/variants" in FOLDERS


@pytest.mark.thorough
def test_what_is_marked_is_not_marked_again_and_evidence_holds(home: Home, marked: Layout) -> None:
    before = {row.id: (marked.grader(row.id) / RESULT).stat() for row in rows_of(marked).values()}
    assert home.grade(marked.root).exit_code == 0
    after = {name: (marked.grader(name) / RESULT).stat() for name in before}
    programs = [name for name in before if not name.endswith("4714")]
    assert all(before[name].st_ino == after[name].st_ino for name in programs)
    evidence = marked.root.parent / "evidence.zip"
    name = rows_of(marked)["4712"].id
    assert call("grade", "evidence", name, "--from", marked.root, "-o", evidence).exit_code == 0
    told = call("grade", "reproduce", evidence)
    assert told.exit_code == 0, told.output
    assert "the same result" in told.output


@pytest.mark.thorough
def test_other_machines_mark_each_by_the_own_variant(home: Home, marked: Layout) -> None:
    folder = marked.root.parent
    words = (home.lab, home.download, "--roster", home.roster, "--no-pages", "--shards", 2)
    assert call("grade", "plan", *words, "-o", folder / "plan").exit_code == 0
    alone = shutil.copy(home.lab / NAME, folder / "copied.key")  # without the record beside it
    told = call("grade", "plan", *words, "--key", alone, "-o", folder / "unknown")
    assert "V779" in told.output
    assert "`copied.key.handed.json`" in told.output
    for shard in sorted((folder / "plan" / "shards").iterdir()):
        assert call("grade", "run", shard, "-o", folder / "results").exit_code == 0
    told = call("grade", "merge", folder / "plan", folder / "results", "-o", folder / "merged")
    assert told.exit_code == 0, told.output
    merged = Layout(folder / "merged")
    for row in rows_of(marked).values():
        for here, there in (
            (marked.grader(row.id), merged.grader(row.id)),
            (marked.student(row.id), merged.student(row.id)),
        ):
            assert (here / RESULT).read_bytes() == (there / RESULT).read_bytes(), row.id


def test_what_marking_needs_is_asked_for(home: Home, tmp_path: Path) -> None:
    words = ("grade", home.lab, home.download, "-o", tmp_path / "out")
    assert "nothing says who is who" in call(*words).output
    other = call(*words, "--roster", home.roster, "--key", tmp_path / "none")
    assert "there is no key of variants" in other.output
    plain = ROOT / "examples" / "01-cans-on-bases"
    told = call("grade", plain, home.download, "--key", home.lab / NAME)
    assert "`--key` is for variants" in told.output
    assert not (tmp_path / "out").exists()


@pytest.mark.thorough
def test_what_a_variant_gives_is_no_evidence_of_likeness(home: Home, marked: Layout) -> None:
    given = read_kept(place_of(marked)).given
    varied, key = load_varied(home.lab), key_of(home.lab / NAME)
    written = location_block(varied.base.scene.locations)
    for number in ("4711", "4713"):
        variant = drawn(varied.variants, key, f"{number}@b.c")
        block = location_block(varied.setting(variant.combination).scene.locations)
        assert block != written
        programs = {
            name: f".PROGRAM main()\n  {step}\n.END\n{block}".encode()
            for name, step in (("a", "READY"), ("b", "OPENI"))
        }
        assert similarity(programs, [written.encode()]).pairs  # the task as written is not enough
        assert not similarity(programs, given).pairs


@pytest.mark.thorough
def test_who_is_forgotten_leaves_no_variant_and_who_asks_learns_of_nobody(
    marked: Layout, tmp_path: Path
) -> None:
    out = tmp_path / "out"
    shutil.copytree(marked.root, out)
    rows = rows_of(marked)
    ada, kurt = rows["4711"], rows["4712"]
    told = call("grade", "person", out, "--student", kurt.id, "-o", tmp_path / "kurt.zip")
    assert told.exit_code == 0, told.output
    with zipfile.ZipFile(tmp_path / "kurt.zip") as archive:
        for name in archive.namelist():
            assert b"Ada" not in archive.read(name), name
    assert ada.result.variant is not None
    task = out / "staff" / "variants" / f"{ada.result.variant.tag}.zip"
    assert task.is_file()
    told = call("purge", out, "--student", ada.id, "--yes")
    assert told.exit_code == 0, told.output
    assert not task.exists()
    assert "warning[V924 still-named]" in told.stderr  # Kurt's row says whose places he has
    left = {path for path in out.rglob("*") if path.is_file() and b"Ada" in path.read_bytes()}
    named = {path for path in left if path.relative_to(out).as_posix() in told.stderr}
    assert left == named
    assert rows_of(Layout(out)) == {number: row for number, row in rows.items() if row != ada}
