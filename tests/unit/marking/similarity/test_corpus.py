"""What a marking keeps to compare with, other folders as a corpus, and the page of two programs."""

import hashlib
import json
import shutil
import zipfile
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.unit.marking.similarity.support import ORIGINAL, disguised
from tests.unit.marking.similarity.test_page import CORPUS as HOSTILE_STRINGS
from tests.unit.report.page.test_html import Reader
from vrts.base.zips import Unpacker
from vrts.cli.main import vrts
from vrts.marking.layout import Layout
from vrts.marking.privacy.pseudonyms import key_for
from vrts.marking.similarity.corpus import Corpora, read_corpora
from vrts.marking.similarity.evidence import Evidence
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.files import write_similarity
from vrts.marking.similarity.groups import Group, Link
from vrts.marking.similarity.kept import Kept, keep, place_of, read_kept
from vrts.marking.similarity.pair_page import Side, pair_page
from vrts.marking.submission.sketch import Sketch, Stop, from_bytes
from vrts.pipeline.files import CHECKOUT, CannotRead
from vrts.pipeline.refused import Refused

EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"
STOP = Stop(3, True, 50, (1, 2, 3), (0, 0, -100), "can1", (4, 5, 6), "", "open", False)
KEPT = Kept(
    "Lab 1",
    {"anna": Program(b".PROGRAM a()\n.END\n", Sketch("vrts.motion/1", (STOP,))), "b": Program(b"")},
    {"anna": "g1", "b": ""},
    (b"; given\n",),
)


def codes(refused: pytest.ExceptionInfo[Refused]) -> list[str]:
    return [found.rule.code for found in refused.value.diagnostics]


def test_what_is_kept_comes_back(tmp_path: Path) -> None:
    layout = Layout(tmp_path)
    keep(KEPT, layout)
    assert read_kept(place_of(layout)) == KEPT


@pytest.mark.parametrize(
    "contents",
    [
        {},
        {"schema": "vrts.programs/1", "title": "", "given": 1, "programs": []},
        {
            "schema": "vrts.programs/1",
            "title": "",
            "given": 0,
            "programs": [{"id": "a", "together": "", "ran": True}],
        },
    ],
)
def test_a_damaged_zip_is_refused(tmp_path: Path, contents: dict[str, object]) -> None:
    path = tmp_path / "programs.zip"
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("programs.json", json.dumps(contents))
    with pytest.raises(Refused) as refused:
        read_kept(path)
    assert codes(refused) == ["V775"]


def test_a_bomb_and_two_programs_of_one_id_are_refused_before_they_are_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read: list[str] = []
    unpack = Unpacker.read

    def counted(archive: Unpacker, name: str) -> bytes:
        read.append(name)
        return unpack(archive, name)

    monkeypatch.setattr(Unpacker, "read", counted)
    monkeypatch.setattr("vrts.marking.similarity.kept.RATIO_FROM", 4_000_000)
    one = {"id": "a", "together": "", "ran": False}
    head = {"schema": "vrts.programs/1", "title": "", "given": 0}
    for number, (count, size) in enumerate(((2, 5), (2, 3_900_000))):
        path = tmp_path / f"{number}.zip"
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
            archive.writestr("programs.json", json.dumps({**head, "programs": [one] * count}))
            for k in range(count):
                archive.writestr(f"programs/{k}.v2", b" " * size)
        with pytest.raises(Refused) as refused:
            read_kept(path)
        why = ("two programs of one id", "unpacks to 8 MB")[number]
        assert why in refused.value.diagnostics[0].headline
    assert read == ["programs.json"]


def test_too_many_programs_are_told_before_more_are_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    keep(KEPT, Layout(tmp_path))
    monkeypatch.setattr("vrts.marking.similarity.corpus.MOST", 1)
    with pytest.raises(CannotRead, match="more than 1 programs"):
        read_corpora([place_of(Layout(tmp_path)), tmp_path / "nowhere"])


def test_programs_in_a_folder_or_a_kept_zip_are_a_corpus(tmp_path: Path) -> None:
    folder = tmp_path / "old"
    folder.mkdir()
    (folder / "max.v2").write_text(ORIGINAL)
    keep(KEPT, Layout(tmp_path / "out"))
    found = read_corpora([folder, place_of(Layout(tmp_path / "out"))])
    assert {name: sorted(programs) for name, programs in found.programs.items()} == {
        "old": ["max"],
        "programs": ["anna", "b"],
    }
    assert sorted(read_corpora([folder, folder]).programs) == ["old", "old-2"]


def test_what_is_no_corpus_is_told(tmp_path: Path) -> None:
    with pytest.raises(CannotRead):
        read_corpora([tmp_path / "nowhere"])
    with pytest.raises(Refused) as refused:
        read_corpora([tmp_path], tmp_path)
    assert codes(refused) == ["V777"]
    (tmp_path / "staff").mkdir()
    (tmp_path / "staff" / "marking.json").write_text("{}")
    with pytest.raises(Refused) as refused:
        read_corpora([tmp_path])
    assert codes(refused) == ["V776"]
    empty = tmp_path / "empty"
    empty.mkdir()
    found = read_corpora([empty])
    assert [one.rule.code for one in found.findings] == ["V778"]
    assert found.programs == {}


@pytest.mark.thorough
def test_a_marking_is_the_corpus_of_the_next_and_is_purged(tmp_path: Path) -> None:
    for year, text in (("2025", ORIGINAL), ("2026", disguised())):
        folder = tmp_path / f"in-{year}"
        folder.mkdir()
        (folder / f"z{year}.v2").write_text(text)
        (folder / "solution.v2").write_bytes((EXAMPLE / "solution.v2").read_bytes())
    run, task = CliRunner(), str(EXAMPLE / "task.toml")
    old, new = str(tmp_path / "2025"), str(tmp_path / "2026")
    words = ["grade", task, str(tmp_path / "in-2025"), "-o", old, "--no-pages"]
    assert run.invoke(vrts, words).exit_code == 0
    words = ["grade", task, str(tmp_path / "in-2026"), "-o", new, "--no-pages", "--corpus", old]
    assert run.invoke(vrts, words).exit_code == 0
    data = json.loads((tmp_path / "2026/staff/similarity.json").read_bytes())
    assert data["schema"] == "vrts.similarity/2"
    kept = place_of(Layout(tmp_path / "2025")).read_bytes()
    sha256 = hashlib.sha256(kept).hexdigest()
    assert data["corpus"] == [{"name": "2025", "programs": 2, "ran": 2, "sha256": sha256}]
    members = [group["members"] for group in data["groups"]]
    assert ["z2026", "2025/z2025"] in members
    assert from_bytes((tmp_path / "2026/staff/students/solution/motion.json").read_bytes()).stops
    both = run.invoke(vrts, ["purge", old, new, "--older-than", "0d"], input="n\n")
    assert "V780" not in both.output
    shutil.copytree(old, tmp_path / "moved")
    for asked, other in ((old, "2026"), (str(tmp_path / "moved"), "2026")):
        told = run.invoke(vrts, ["purge", asked, "--older-than", "0d"], input="n\n").output
        assert "warning[V780 copies-elsewhere]" in told
        assert f"{other}` show programs of" in " ".join(told.split())
        assert "vrts grade similarity" in told
    shutil.rmtree(tmp_path / "moved")
    marks = (tmp_path / "2026/staff/marks.csv").read_bytes()
    assert run.invoke(vrts, ["grade", "similarity", new]).exit_code == 0
    data = json.loads((tmp_path / "2026/staff/similarity.json").read_bytes())
    assert data["corpus"] == []
    assert not any("2025/z2025" in group["members"] for group in data["groups"])
    assert (tmp_path / "2026/staff/marks.csv").read_bytes() == marks
    done = run.invoke(vrts, ["grade", "similarity", str(tmp_path / "in-2026")])
    assert done.exit_code != 0
    again = run.invoke(vrts, ["purge", old, "--older-than", "0d"], input="n\n")
    assert "V780" not in again.output  # compared again, without it
    done = run.invoke(vrts, ["purge", new, "--older-than", "0d", "--yes"])
    assert not (tmp_path / "2026/staff/similarity").exists(), done.output


def side(name: str, text: str, report: str | None) -> Side:
    return Side(name, name, text.encode("utf-8", "replace"), report)


def page(foreign: str, report: str | None = None) -> str:
    """Return the page of two programs with a foreign text wherever one may stand."""
    link = Link("anna", f"2025/{foreign[:9]}", 0.9, "strong")
    evidence = (Evidence("motion", f"a word “{foreign}”", 3.2, 0, 2, 3),)
    group = Group((link.first, link.second, "cara"), 0.9, "strong", 0.01, (link,), evidence)
    text = f".PROGRAM a()\n ; {' '.join(foreign.split())}\n READY\n.END\n"
    sides = side("anna", text, report), side(link.second, text, None)
    return pair_page(link, group, evidence, sides, foreign)


def test_the_page_of_two_programs_shows_both_the_evidence_and_no_verdict() -> None:
    read = Reader(page("harmless", "../students/anna/report.html"))
    frames = [a["src"] for tag, a in read.elements if tag == "iframe"]
    assert frames == ["../students/anna/report.html#framed=1&t=0"]
    links = [a["href"] for tag, a in read.elements if tag == "a"]
    assert {"#e1", "#a2", "#b3", "../similarity.html"} <= {*links}
    assert "Not a verdict." in read.text
    assert "by chance among all that were compared, other folders too" in read.text
    assert "Others in this group: cara" in read.text
    for word in ("plagiar", "cheat", "copied", "suspect"):
        assert word not in read.text.lower(), word


@pytest.mark.parametrize("foreign", [*HOSTILE_STRINGS, "</td><script>alert(1)</script>"])
def test_nothing_foreign_gets_through(foreign: str) -> None:
    read, harmless = Reader(page(foreign)), Reader(page("harmless"))
    assert {tag for tag, _ in read.elements} <= {tag for tag, _ in harmless.elements}
    assert all(c.isprintable() or c == "\n" for c in read.text)


def test_in_a_class_without_names_nobody_of_another_folder_is_named(tmp_path: Path) -> None:
    layout = Layout(tmp_path / "out")
    key_for(layout)
    text = ORIGINAL.encode()
    kept = Kept("Lab 1", {"bcdf-ghjk-lmnp": Program(text), "x": Program(text)}, {}, ())
    old = {"zoe-zilk": Program(text), "qrst-vwxz-bcdf": Program(text)}
    corpora = Corpora({"before": old}, {"before": tmp_path / "before"})
    write_similarity(kept, layout, names={}, corpora=corpora)
    written = b"".join(path.read_bytes() for path in layout.staff.rglob("*.[hj]*"))
    assert b"qrst-vwxz-bcdf" in written, "a pseudonym stays as it is"
    assert b"zoe-zilk" not in written
    place = layout.staff / "similarity" / "names.csv"
    lines = place.read_text(encoding="utf-8-sig").splitlines()
    (line,) = (line for line in lines if line.endswith(",before,zoe-zilk"))
    assert line.split(",")[0].encode() in written

    write_similarity(kept, Layout(tmp_path / "named"), names={}, corpora=corpora)
    assert "before/zoe-zilk" in (tmp_path / "named" / "staff" / "similarity.json").read_text()
    assert not (tmp_path / "named" / "staff" / "similarity" / "names.csv").exists()
