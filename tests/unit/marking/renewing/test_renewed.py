"""Lists, feedback and pages follow from decisions without marking; nothing foreign gets through."""

import json
from concurrent.futures import ThreadPoolExecutor
from datetime import UTC, datetime
from pathlib import Path

import pytest
from click.testing import CliRunner, Result
from msgspec.structs import replace

from tests.support_desk import write_desk_class
from vrts.cli.grade.decisions_command import command
from vrts.cli.shared.console import HOLDS, WRONG
from vrts.marking.by_hand.decisions.files import add_decisions
from vrts.marking.by_hand.decisions.records import (
    ChangeMark,
    Comment,
    Decision,
    Extend,
    Give,
    Item,
    Undo,
)
from vrts.marking.class_files import LOCK
from vrts.marking.exports.feedback import NAME as FEEDBACK
from vrts.marking.layout import Layout
from vrts.marking.renewing.renewed import renewed, write_sections
from vrts.marking.renewing.section import BEGIN, with_section
from vrts.marking.row import Decided, Given, Row, Told, class_from_bytes
from vrts.marking.submission.report_files import REPORT
from vrts.pipeline.refused import Refused

NOW = datetime(2026, 11, 26, 20, tzinfo=UTC)
PAGE = (
    b'<nav aria-label="On this page"><a href="#replay">Replay</a></nav>'
    b'<section id="replay"><ol><li id="L9">MOVE a</li></ol></section><footer>vrts</footer>'
)
ITEM = Item(0, "", "comments", "no comments", "-1/2")


def add(layout: Layout, who: str, *said: Decision) -> None:
    """Let a grader decide."""
    add_decisions(layout.decisions, who, said, NOW)


def everything(layout: Layout) -> dict[str, bytes]:
    """Return the bytes of all files that marking writes."""
    held = (path for path in sorted(layout.root.rglob("*")) if path.is_file())
    return {
        str(path): path.read_bytes()
        for path in held
        if layout.decisions not in path.parents and path.name != LOCK
    }


def graded(layout: Layout) -> list[Row]:
    """Return rows that have a mark and a page."""
    rows = class_from_bytes(layout.results.read_bytes()).rows
    return [row for row in rows if row.final is not None and row.result.program is not None]


def call(layout: Layout, *words: str) -> Result:
    """Call `vrts grade decisions`."""
    return CliRunner().invoke(command, [str(layout.root), *words])


def test_everything_follows_and_goes_back_again(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 12, decisions=False)
    renewed(layout, [row.id for row in graded(layout)])  # feedback, as marking writes it
    before = everything(layout)
    anna = graded(layout)[0]
    text = "Why <script>alert(1)</script>?"
    add(
        layout, "R. Huber", ITEM, Give(0, "", "comments", (anna.id,)), Comment(0, "", anna.id, text)
    )
    add(layout, "R. Huber", Comment(0, "", anna.id, "SECRET", private=True))
    found = renewed(layout)
    assert found.changed == (anna.id,)
    told = (layout.student(anna.id) / FEEDBACK).read_text("utf-8")
    assert "no comments: by R. Huber" in told
    assert text in told
    for home in (layout.student(anna.id), layout.grader(anna.id)):
        page = (home / REPORT).read_bytes()
        assert b"&lt;script&gt;alert(1)" in page
        assert b"<script>alert(1)" not in page
        assert b"<b>Final mark: " in page
    (row,) = (row for row in graded(layout) if row.id == anna.id)
    assert row.exact_final == max(0, (anna.exact_final or 0) * 2 - 1) / 2
    after = everything(layout)
    assert not any(b"SECRET" in data for data in after.values())
    assert renewed(layout).changed == ()
    assert everything(layout) == after
    names = tuple(f"r-huber:{number}" for number in range(1, 5))
    add(layout, "A. Lang", Undo(0, "", names))
    renewed(layout)
    end = everything(layout)
    lists = [class_from_bytes(held.pop(str(layout.results))) for held in (before, end)]
    assert end == before
    assert lists[1] == replace(lists[0], decisions=lists[1].decisions)
    assert [one.lines for one in lists[1].decisions] == [2, 5]  # none of them may get lost now
    (layout.decisions / "a-lang.jsonl").unlink()
    with pytest.raises(Refused) as problem:
        renewed(layout)
    assert "rest on 2 lines of `a-lang.jsonl`" in problem.value.diagnostics[0].headline


def test_a_page_that_was_marked_anew_gets_its_section_again(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 3, decisions=False)
    anna = graded(layout)[0].id
    add(layout, "R. Huber", Comment(0, "", anna, "look"))
    rows = renewed(layout).rows.rows
    whole = everything(layout)
    page = layout.student(anna) / REPORT
    page.write_bytes(with_section(page.read_bytes(), None, staff=False))
    write_sections(rows, layout, ())
    assert everything(layout) == whole


def test_nothing_is_written_while_a_decision_cannot_be_read(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 3, decisions=False)
    anna = graded(layout)[0].id
    add(layout, "R. Huber", Comment(0, "", anna, "look"))
    path = layout.decisions / "r-huber.jsonl"
    path.write_bytes(path.read_bytes().replace(b'"number":1', b'"number":2'))
    before = everything(layout)
    with pytest.raises(Refused):
        renewed(layout)
    assert everything(layout) == before


def test_lines_and_moments_are_links_where_the_page_has_them() -> None:
    told = Told("look", "RH", 9, 3.2)
    page = with_section(PAGE, Decided((told,)), staff=False)
    assert b'<a href="#L9">line 9</a>' in page
    assert b'class="seek" data-t="3.2"' in page
    assert page.index(b"</nav>") < page.index(BEGIN) < page.index(b'id="replay"')
    bare = with_section(b"<main><footer></footer></main>", Decided((told,)), staff=False)
    assert b"<span>line 9</span> <span>3.2 s</span>" in bare
    assert with_section(page, Decided((told,)), staff=False) == page
    assert with_section(page, None, staff=False) == PAGE


def test_hostile_words_stay_words() -> None:
    evil = "<!--/from-graders--></section><img src=x onerror=alert(1)>"
    decided = Decided((Told(evil, evil, 9),), (Given("x", evil, "1", evil),), excused=evil)
    page = with_section(PAGE, decided, staff=False)
    assert b"<img" not in page
    assert page.count(b'dir="auto"') == 4, "words and names turn nothing around that is beside them"
    assert b"Excused: <bdi>" in page
    assert with_section(page, None, staff=False) == PAGE
    staff = Decided(conflicts=("differ",), lapsed=("old",))
    assert with_section(PAGE, staff, staff=False) == PAGE
    assert with_section(PAGE, staff, staff=True).count(b"Not settled") == 2


def test_the_command_lists_settles_and_takes_back(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 6, decisions=False)
    anna = graded(layout)[0].id
    add(layout, "R. Huber", ChangeMark(0, "", (anna,), "shown in the lab", "1"))
    add(layout, "A. Lang", ChangeMark(0, "", (anna,), "shown in the lab", "-1"))
    add(layout, "A. Lang", Extend(0, "", (anna,), "2026-12-01T00:00:00+01:00", "ill"))
    said = call(layout)
    assert said.exit_code == WRONG
    assert f"  {anna}: graders differ: A. Lang (a-lang:1): −1 points: shown in" in said.stdout
    why = ("--who", "Dean", "--reason", "agreed")
    assert call(layout, "--keep", "r-huber:1", "--student", "nobody", *why).exit_code != HOLDS
    said = call(layout, "--keep", "r-huber:1", *why)
    assert said.exit_code == HOLDS
    assert f"r-huber:1 counts for {anna}" in said.stderr
    found = json.loads(call(layout, "--format", "json").stdout)
    assert (found["conflicts"], len(found["decisions"])) == ([], 4)
    said = call(layout, "--undo", "dean:1", "--who", "R. Huber")
    assert said.exit_code == WRONG
    assert "undone by r-huber:2" in said.stdout


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("--undo", "r-huber:9", "--who", "RH"), "there is no decision `r-huber:9`"),
        (("--undo", "r-huber:1"), "say who decides that"),
        (("--keep", "r-huber:1", "--who", "RH"), "`--keep` needs `--reason`"),
        (("--keep", "r-huber:1", "--who", "RH", "--reason", "x"), "is in no conflict"),
        (("--undo", "r-huber:1", "--who", " "), "no name of a grader"),
        (("--who", "RH"), "are for `--undo` and `--keep`"),
    ],
)
def test_wrong_calls_are_told_and_write_nothing(
    tmp_path: Path, words: tuple[str, ...], told: str
) -> None:
    layout = write_desk_class(tmp_path, 3, decisions=False)
    add(layout, "R. Huber", Comment(0, "", graded(layout)[0].id, "look"))
    before = sorted(path.read_bytes() for path in layout.decisions.iterdir())
    said = call(layout, *words)
    assert said.exit_code not in (HOLDS,)
    assert told in said.stderr
    assert sorted(path.read_bytes() for path in layout.decisions.iterdir()) == before


def test_several_desks_may_bring_a_folder_up_to_date_at_once(tmp_path: Path) -> None:
    layout = write_desk_class(tmp_path, 8, decisions=False)
    for number, row in enumerate(graded(layout)):
        add(layout, f"Grader {number}", Comment(0, "", row.id, "look"))
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(renewed, [Layout(layout.root)] * 8))
    assert sum(bool(one.changed) for one in found) == 1
    assert renewed(layout).changed == ()
