"""Keys of the terminal debugger: none ends it but `q`, and all is repeated from its record."""

import random
from pathlib import Path

import pytest

from tests.support_programs import ROOT, cans, compiled
from tests.unit.debug.scripted.test_commands import said, session
from vrts.debug.debugger import Debugger
from vrts.debug.passages import Instant
from vrts.debug.scripted.commander import carry_out
from vrts.debug.scripted.reading import commands_in
from vrts.debug.scripted.recording import Recorder
from vrts.debug.scripted.session import Session
from vrts.debug.terminal.key_table import KEYS
from vrts.debug.terminal.keys import Keyboard, Outside
from vrts.debug.terminal.panel import panel
from vrts.debug.terminal.view import View
from vrts.engine.controller import execute
from vrts.lang.dialect import DIALECTS
from vrts.report.plain import width

HITS = ROOT / "examples/01-cans-on-bases/submissions/hits-base.v2"
NAMED = [name for key in KEYS for name in key.names if name != "q"]
TYPING = [*"np3>=+[(\"';: ", "backspace", "delete", "c-a", "c-e", "c-k", "c-u", "c-w", "tab", "q"]
LINES = [
    "print n",
    "n = 3",
    "set m = 2",
    "step out",
    "break 5:n>2",
    "events",
    "calls",
    "mark here",
    "go here",
    "marks",
    "link",
    "WHERE",
    "at 2",
    "DO",
]
SIZES = [(80, 24), (100, 30), (160, 50), (72, 20), (1, 1), (30, 60), (200, 3)]


class Sitting:
    """A session with its keyboard, as a terminal has it."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.session.writes = True
        self.record: list[str] = []
        self.view = View()
        outside = Outside(str, str, str)
        self.keyboard = Keyboard(session, self.view, outside, Recorder(self.record.append))

    def press(self, *keys: str) -> None:
        for key in keys:
            assert not self.keyboard.press(key), key

    def type(self, text: str) -> None:
        self.press(*text, "enter")

    def screen(self, columns: int = 80, rows: int = 24) -> str:
        found = panel(self.session, self.view, columns, rows)
        assert len(found) <= max(rows, 1)
        assert all(sum(width(text) for _, text in row) <= max(columns, 1) for row in found)
        return "\n".join("".join(text for _, text in row) for row in found)


@pytest.fixture
def sitting(tmp_path: Path) -> Sitting:
    return Sitting(session(tmp_path))


def played(sitting: Sitting, seed: int, number: int) -> list[Instant]:
    """Press random keys, look at each screen; return where it stood after each key."""
    chosen = random.Random(seed)
    stood: list[Instant] = []
    for _ in range(number):
        if sitting.view.question is None:
            sitting.press(chosen.choice(NAMED))
        elif chosen.random() < 0.3:
            sitting.press("c-u")
            sitting.type(chosen.choice(LINES))
        else:
            sitting.press(chosen.choice([*TYPING, "enter", "escape"]))
        if chosen.random() < 0.02:
            sitting.keyboard.interrupted()
        sitting.screen(*chosen.choice(SIZES))
        stood.append(sitting.session.debugger.at)
    return stood


def test_no_key_ends_it_and_the_record_comes_to_the_same_places(tmp_path: Path) -> None:
    _check(tmp_path, [1], 150)


@pytest.mark.thorough
def test_no_key_ends_it_in_long_sessions(tmp_path: Path) -> None:
    _check(tmp_path, [2, 3], 400)


def _check(tmp_path: Path, seeds: list[int], number: int) -> None:
    for seed in seeds:
        first = Sitting(session(tmp_path))
        stood = played(first, seed, number)
        again = session(tmp_path)
        places = [again.debugger.at]
        for line in commands_in("\n".join(first.record).encode()):
            done = carry_out(again, line.text)
            assert done.ok, done
            places.append(again.debugger.at)
        assert places[-1] == stood[-1]
        assert [at for k, at in enumerate(places) if k == 0 or at != places[k - 1]] == [
            at
            for k, at in enumerate([places[0], *stood])
            if k == 0 or at != [places[0], *stood][k - 1]
        ]
        assert again.debugger.wishes.lines == first.session.debugger.wishes.lines
        assert again.debugger.state.variables == first.session.debugger.state.variables


def test_q_ends_it_and_only_closes_help_and_lines(sitting: Sitting) -> None:
    sitting.press("?", "q", ":", "q", "escape")
    assert sitting.keyboard.press("q")


def test_the_form_of_a_breakpoint_asks_for_each_and_refuses_what_cannot_be(
    sitting: Sitting,
) -> None:
    sitting.press("down", "down", "down", "B")
    sitting.type("sen > 1")
    assert "there is no `sen` here: `seen`" in sitting.screen()
    sitting.press("c-u")
    sitting.type("n > 2")
    sitting.type(">= x")
    assert "says not which hits count" in sitting.screen()
    sitting.press("c-u")
    sitting.type("")
    sitting.type("")
    assert "line 5: stops, where n > 2" in sitting.screen()
    assert "◆   5" in sitting.screen()
    sitting.press("c")
    assert said(sitting.session, "print n") == "3"
    sitting.press("B")
    assert "condition: n > 2" in sitting.screen()
    sitting.press("escape", "b")
    assert "◆" not in sitting.screen()


def test_what_is_long_is_a_page_that_scrolls(sitting: Sitting) -> None:
    sitting.screen()
    sitting.press("?")
    first = sitting.screen()
    assert "Forward" in first
    sitting.press(*["page down"] * 20)
    last = sitting.screen()
    assert "Any other line is an expression" in last
    assert "Forward" not in last
    sitting.press("escape", ":")
    sitting.type("state")
    assert "Arm" in sitting.screen() or "Variables" in sitting.screen()
    sitting.press("n")
    assert "main 2" in sitting.screen()


def test_at_80_columns_every_screen_is_readable_at_a_contact(tmp_path: Path) -> None:
    run = execute(compiled(HITS.read_text()), cans())
    there = Sitting(session(tmp_path, Debugger(run, DIALECTS["val2"])))
    there.press("a")
    assert "which alarms stop? contact, near-miss" in there.screen()
    there.press("c-u")
    there.type("contact")
    there.press("c")
    shown = there.screen()
    assert "ALARM: can1 touches base1, holding can1; 59.0 mm deep at" in shown
    assert "caused by line 11" in shown
    assert "11 ! APPROS base2_put, 60" in shown
    assert "base2_put    1100 230 -125 90 90 0" in shown
    there.press("y")
    assert "this speed is in force: 60 %" in there.screen()
    there.press("escape")
    for columns in (100, 160):
        assert "hand      60.0 mm holds can1" in there.screen(columns, 30)


def test_futures_are_gone_through_by_keys(sitting: Sitting) -> None:
    sitting.press(":")
    sitting.type("set n = 3")
    sitting.press("u")
    assert "future 1: the program as it was opened" in sitting.screen()
    sitting.press("U")
    assert "n = 3" in sitting.screen()
    sitting.press("R")
    assert "a saved run goes on with no other text" in sitting.screen()


def test_lines_typed_before_come_back(sitting: Sitting) -> None:
    sitting.press(":")
    sitting.type("print far")
    sitting.press(":", "up")
    assert ":print far" in sitting.screen()
    sitting.press("escape", ":", *"seen", "tab")
    assert ":seen" in sitting.screen()


def test_a_record_that_cannot_be_written_ends_and_the_session_goes_on(tmp_path: Path) -> None:
    there = Sitting(session(tmp_path))

    def full(line: str) -> None:
        raise OSError(28, "No space left on device")

    there.keyboard = Keyboard(
        there.session,
        there.view,
        Outside(str, str, str),
        Recorder(full, "kept.txt"),
    )
    there.press("n")
    assert "the record kept.txt ends here: no space left on device" in there.screen()
    there.press("n")
    assert "main 3" in there.screen()


def test_enter_on_an_event_of_the_list_goes_there(tmp_path: Path) -> None:
    s = Sitting(session(tmp_path))
    s.press(":")
    s.type("at 3")
    s.press("e")
    screen = s.screen()
    assert "MOVE far, line 7" in screen
    page = s.view.page
    assert page is not None
    s.press("up", "up")
    row = page.chosen
    rows = s.session.debugger.tables.asked("events", "", s.session.debugger.at).rows
    assert rows[row + 2].go.instant <= s.session.debugger.at < rows[row + 3].go.instant
    for _ in range(3):
        s.press("page down")
    assert page.chosen == len(page.choices) - 1
    assert page.lines[page.chosen] in s.screen()
    s.press("home", "e") if s.view.page is None else s.press("escape", "e")
    page = s.view.page
    assert page is not None
    while page.chosen > 6:
        s.press("up")
    s.press("enter")
    assert s.view.page is None
    assert s.session.debugger.stop.text == "signal 5 on"
    assert "gone to: signal 5 on" in s.screen()
    assert s.record[-2:] == ["events", "go 7"]
