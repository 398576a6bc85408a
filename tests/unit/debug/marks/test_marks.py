"""Marks lead to where they were given, or say why not; links open exactly the place they name."""

import json
import shlex
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from tests.support_commands import vrts
from tests.unit.debug.scripted.test_commands import refused, said, session
from tests.unit.debug.test_debugger import TEXT, debugger
from vrts.debug.marks.marks import Marks
from vrts.debug.opening import Asked, opened
from vrts.debug.passages import Instant, Passages, at_time
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.session import Session


def test_a_mark_is_gone_to_exactly(tmp_path: Path) -> None:
    s = session(tmp_path)
    passages = Passages(s.debugger.run, process=False)
    places = [passages.instant(number) for number in range(1, passages.count, 5)]
    for k, instant in enumerate(places):
        s.debugger.go(instant)
        said(s, f"mark m{k}")
    said(s, "at end")
    for k, instant in enumerate(places):
        done = carry_out(s, f"go M{k}")
        assert (s.debugger.at, done.ok) == (instant, True)
        assert done.place is not None
        assert done.place.text == f"mark m{k}"
    listed = said(s, "marks").splitlines()
    assert len(listed) == len(places)
    assert carry_out(s, "go 3").ok
    assert s.debugger.at == sorted(places)[2]
    assert "; it was at" in said(s, "mark m3")
    said(s, "unmark m3")
    assert "there is no mark `m3`" in refused(s, "go m3")
    assert said(s, "unmark all") == "no marks"


def test_a_mark_of_another_future_is_told_and_never_taken_for_another(tmp_path: Path) -> None:
    s = session(tmp_path)
    said(s, "to 5")
    said(s, "mark before")
    said(s, "at 4")
    said(s, "mark after")
    said(s, "go before")
    said(s, "step")
    said(s, "set n = 3")
    assert carry_out(s, "go before").ok, "what comes before the change is still the same"
    assert "another one at `after`" in refused(s, "go after")
    before, after = said(s, "marks").splitlines()
    assert before.lstrip().startswith("1 before")
    assert after.startswith("   - after  4.000 s")
    assert after.endswith("of another future")
    said(s, "restart")
    assert carry_out(s, "go after").ok


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("mark", "`mark` takes a name"),
        ("mark 5", "the name of a mark is"),
        ("mark a b", "the name of a mark is"),
        ("mark " + "x" * 41, "the name of a mark is"),
        ("unmark", "takes the name"),
        ("unmark nosuch", "there is no mark `nosuch`"),
        ("go nosuch", "there is no mark `nosuch`"),
        ("marks x", "takes nothing behind it, or `keep`"),
        ("marks keep", "a script changes no file"),
        ("link x", "takes nothing behind it"),
        ("at 0 step x", "no number of statements"),
        ("at 0 step 99999", "statements are finished, not 99,999"),
        ("at 99 step 1", "the run goes from 0"),
    ],
)
def test_what_cannot_be_is_refused(tmp_path: Path, line: str, words: str) -> None:
    assert words in refused(session(tmp_path), line)


def test_a_record_with_marks_replays(tmp_path: Path) -> None:
    lines = ["to 5", "mark loop", "events where signal = 5", "go 1", "step", "go loop", "step"]
    ends: set[Instant] = set()
    for _ in range(2):
        s = session(tmp_path)
        for line in lines:
            assert carry_out(s, line).ok, line
        ends.add(s.debugger.at)
    assert len(ends) == 1


def kept(program: Path) -> Session:
    found = opened(Asked(program, dialect="val2+"))
    assert found.debugger is not None
    assert found.console is not None
    return Session(found.debugger, found.console, writes=True)


def test_marks_are_kept_in_a_file_beside_the_program(tmp_path: Path) -> None:
    program, file = tmp_path / "loop.v2", tmp_path / "loop.v2.marks"
    program.write_text(TEXT)
    s = kept(program)
    said(s, "at 4")
    said(s, "mark four")
    assert not file.exists(), "nothing is written before somebody asks for it"
    assert str(file) in said(s, "marks keep")
    again = kept(program)
    said(again, "go four")
    assert again.debugger.at == s.debugger.at
    said(again, "mark more")
    assert {row["name"] for row in json.loads(file.read_text())["marks"]} == {"four", "more"}
    program.write_text(TEXT.replace("b = a*2", "b = a*3"))  # the same steps, other values
    assert "another one at `four`" in refused(kept(program), "go four")
    file.write_text("{}")
    broken = kept(program)
    assert "holds no marks" in said(broken, "marks")
    assert "left as it is" in refused(broken, "marks keep")
    assert file.read_text() == "{}"


@pytest.mark.parametrize(
    "text",
    [
        "",
        "[]",
        '{"schema": "vrts.marks/1"}',
        '{"schema": "vrts.marks/1", "marks": [{"name": "a"}]}',
        '{"schema": "vrts.marks/1", "marks": [3]}',
        "[" * 100_000,
        "x" * 1_000_001,
    ],
)
def test_any_file_of_marks_is_read_or_named(tmp_path: Path, text: str) -> None:
    (tmp_path / "a.marks").write_text(text)
    marks = Marks(tmp_path / "a.marks")
    assert marks.all() == []
    assert marks.problem


def test_what_links_name_opens_there(tmp_path: Path) -> None:
    program = tmp_path / "a loop.v2"
    program.write_text(TEXT)
    s = kept(program)
    passages = Passages(s.debugger.run, process=False)
    instants = [passages.instant(number) for number in range(passages.count)]
    within = next(i for i in instants if at_time(s.debugger.run, i.time_s) != i and i.time_s > 1)
    s.debugger.go(within)
    command, editor = said(s, "link").splitlines()
    assert shlex.split(command)[-2] == "--step"
    found = vrts(*shlex.split(command)[1:], "--command", "where", "--json", cwd=Path("/"))
    place = json.loads(found.stdout)
    assert (place["time_s"], place["statements"]) == tuple(within)
    address = urlsplit(editor)
    assert (address.scheme, address.netloc) == ("vscode", "file")
    path, line, column = unquote(address.path).rsplit(":", 2)
    text = Path(path).read_text().splitlines()[int(line) - 1]
    assert text[int(column) - 1 :].startswith(place["source"].strip())
    assert int(line) == place["line"]


def test_a_link_to_the_page_opens_a_page_at_that_time(tmp_path: Path) -> None:
    program = tmp_path / "loop.v2"
    program.write_text(TEXT)
    found = opened(Asked(program))
    assert found.debugger is not None
    assert found.console is not None
    s = Session(found.debugger, found.console)
    said(s, "at 2.5")
    _, view, anchor, _ = said(s, "link").splitlines()
    words = [*shlex.split(view)[1:], "--no-open", "-o", tmp_path / "page.html"]
    assert words[-5:-3] == ["--at", "2.500"]
    shown = vrts(*words, cwd=Path("/"))
    assert shown.returncode == 0, shown.stderr
    assert anchor.split()[0] in shown.stderr.decode()
    assert (tmp_path / "page.html").is_file()


def test_a_future_that_comes_of_changes_has_no_link(tmp_path: Path) -> None:
    program = tmp_path / "loop.v2"
    program.write_text(TEXT)
    s = kept(program)
    said(s, "to 5")
    said(s, "set n = 3")
    said(s, "at end")
    assert "this future comes of changes" in said(s, "link")
    said(s, "restart")
    assert "vrts debug" in said(s, "link")


def test_places_that_share_a_time_are_told_apart(tmp_path: Path) -> None:
    s = session(tmp_path, debugger())
    passages = Passages(s.debugger.run, process=False)
    for number in range(passages.count):
        instant = passages.instant(number)
        said(s, f"at {instant.time_s!r} step {instant.finished}")
        assert s.debugger.at == instant
