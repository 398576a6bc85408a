"""The page: no verdict, side by side, and nothing foreign gets through."""

import json
from pathlib import Path

import msgspec
import pytest
from click.testing import CliRunner

from tests.unit.marking.similarity.support import ORIGINAL, disguised, independent
from tests.unit.report.page.test_html import Reader
from vrts.assignments.pack import student_zip
from vrts.assignments.task_folder import read_folder
from vrts.cli.main import vrts
from vrts.marking.layout import Layout
from vrts.marking.similarity.evidence import MOST
from vrts.marking.similarity.features.extract import Program
from vrts.marking.similarity.files import given, write_similarity
from vrts.marking.similarity.groups import Evidence, Group, Link
from vrts.marking.similarity.groups_section import why
from vrts.marking.similarity.kept import Kept
from vrts.marking.similarity.page import similarity_page
from vrts.marking.similarity.ranking import similarity
from vrts.marking.submission.marker import Marker
from vrts.marking.submission.one import Wanted
from vrts.marking.submission.setting import Place
from vrts.pipeline.files import CHECKOUT

CORPUS: list[str] = json.loads(
    (CHECKOUT / "tests" / "data" / "hostile_strings.json").read_text(encoding="utf-8")
)
HOSTILE = "</td><script>alert(1)</script>\u202e\x1b[2J"
EXAMPLE = CHECKOUT / "examples" / "01-cans-on-bases"


def test_a_pair_is_shown_side_by_side_with_links_and_without_a_verdict() -> None:
    programs = {**independent(), "anna": ORIGINAL.encode(), "ben": disguised().encode()}
    page = similarity_page(similarity(programs), programs, "Group 3", {"anna": "Anna Ady"})
    read = Reader(page)
    links = [a["href"] for tag, a in read.elements if tag == "a"]
    for link in ("#pair-1", "students/anna/report.html", "students/ben/report.html", "index.html"):
        assert link in links
    assert "Not a verdict." in read.text
    assert "Anna Ady anna" in read.text
    assert "SET above = TRANS(x,y,200,90,90,0)" in read.text
    assert "SET drueber = TRANS(x,y,200,90,90,0)" in read.text
    for word in ("plagiar", "cheat", "copied", "suspect"):
        assert word not in page.lower(), word


def hostile_page(foreign: str) -> str:
    """Return the page of two programs with a foreign text wherever one may stand."""
    line = " ".join(foreign.split())
    text = ORIGINAL.replace("safe   905", f"{line} 1 2 3\nsafe   905")
    text = text.replace('"missed it"', f'"{line}"').replace("50   RETURN", f"; {line}")
    data = text.encode("utf-8", "replace")
    programs = {"anna": data, "ben": data}
    return similarity_page(
        similarity(programs), programs, foreign, {"anna": foreign, "ben": foreign}
    )


@pytest.mark.parametrize("foreign", [*CORPUS, HOSTILE])
def test_nothing_foreign_gets_through(foreign: str) -> None:
    page = hostile_page(foreign)
    read, harmless = Reader(page), Reader(hostile_page("harmless"))
    known = {(tag, tuple(a)) for tag, a in harmless.elements}
    assert {(tag, tuple(a)) for tag, a in read.elements} <= known
    assert all(c.isprintable() or c == "\n" for c in read.text)
    page.encode("utf-8")


def test_a_class_in_which_nobody_is_like_another_is_a_page_too() -> None:
    page = similarity_page(similarity({}), {}, "Nobody")
    assert "No two programs share more than what is usual" in Reader(page).text


def test_the_locations_of_the_scene_are_given_and_programs_beside_the_task(tmp_path: Path) -> None:
    marker = Marker(Place(str(EXAMPLE / "task.toml")), Wanted(pages=False))
    (locations,) = given(EXAMPLE / "task.toml", marker.whole)
    assert b"can1_grip" in locations
    (tmp_path / "start.v2").write_text(ORIGINAL)
    (tmp_path / "handout").mkdir()
    (tmp_path / "handout" / "help.v2").write_text("; help\n")
    assert given(tmp_path / "task.toml", marker.whole)[:2] == (b"; help\n", ORIGINAL.encode())


def test_programs_in_a_packed_task_are_given_too(tmp_path: Path) -> None:
    files = read_folder(EXAMPLE)
    files.public["start.v2"] = ORIGINAL.encode()
    packed = tmp_path / "lab1.zip"
    packed.write_bytes(student_zip(files, 0))
    marker = Marker(Place(str(packed)), Wanted(pages=False))
    assert given(packed, marker.whole)[:-1] == (ORIGINAL.encode(),)


def test_both_files_are_for_the_staff(tmp_path: Path) -> None:
    programs = {"anna": ORIGINAL.encode(), "ben": ORIGINAL.encode()}
    layout = Layout(tmp_path)
    kept = Kept("Group 3", {name: Program(data) for name, data in programs.items()}, {}, ())
    ranking = write_similarity(kept, layout, names={})
    assert len(ranking.pairs) == 1
    assert sorted(p.relative_to(tmp_path).as_posix() for p in tmp_path.rglob("*.*")) == [
        "staff/similarity.html",
        "staff/similarity.json",
        "staff/similarity/pair-001.html",
    ]


@pytest.mark.thorough
def test_grade_writes_overview_and_similarity_for_the_staff(tmp_path: Path) -> None:
    handed_in = tmp_path / "in"
    handed_in.mkdir()
    text = (EXAMPLE / "solution.v2").read_bytes()
    for name in ("anna", "ben"):
        (handed_in / f"{name}.v2").write_bytes(text)
    out = tmp_path / "out"
    words = ["grade", str(EXAMPLE / "task.toml"), str(handed_in), "-o", str(out), "--no-pages"]
    assert CliRunner().invoke(vrts, words).exit_code == 0
    overview = (out / "staff" / "index.html").read_text()
    assert 'href="similarity.html"' in overview
    assert "report.html" not in overview
    assert "report.html" not in (out / "staff" / "similarity.html").read_text()
    (pair,) = json.loads((out / "staff" / "similarity.json").read_bytes())["pairs"]
    assert (pair["first"], pair["second"]) == ("anna", "ben")
    assert pair["values"] == []  # as the scene gives them to everybody
    (handed_in / "ben.v2").unlink()
    assert CliRunner().invoke(vrts, words).exit_code == 0
    assert not (out / "staff" / "similarity.html").exists()
    assert "similarity.html" not in (out / "staff" / "index.html").read_text()


def test_pairs_of_a_large_group_are_named_where_names_are_known() -> None:
    links = tuple(Link("anna", who, 0.9, "strong", f"similarity/{who}.html") for who in ("b", "c"))
    group = Group(("anna", "b", "c"), 0.9, "strong", 0.01, links, ())
    ranking = msgspec.structs.replace(similarity({}), groups=(group,))
    text = Reader(similarity_page(ranking, {}, "Group", {"anna": "Anna Ady", "b": "", "c": "Cem"}))
    assert "Anna Ady and b" in text.text
    assert "Anna Ady and Cem" in text.text
    assert "anna and b" in Reader(similarity_page(ranking, {}, "Group")).text


def test_a_group_says_why_in_a_sentence_and_claims_no_difference_it_does_not_know() -> None:
    def evidence(*kinds: str) -> tuple[Evidence, ...]:
        return tuple(Evidence(kind, "x", 2.0, 0, 1, 1) for kind in kinds)

    def said(*kinds: str) -> str:
        return why(Group(("a", "b"), 0.9, "strong", 0.01, (), evidence(*kinds)))

    assert said("motion", "motion", "steps", "offsets") == (
        "Alike and rare: 2 places and motions, 1 step or row of steps and 1 exact distance of"
        " taught values, but other names and comments and another wording or order of steps."
    )
    assert said("words", "text").endswith("habit of layout and 1 row of words.")
    assert "but" not in said(*["motion"] * MOST)  # more may be alike that is not told
    assert said() == "They share many small things, none of which is rare."
