"""Answers as lists whose lines lead somewhere, and what is told of files that change meanwhile."""

from pathlib import Path

import pytest

from tests.unit.debug.scripted.test_commands import session
from tests.unit.debug.terminal.test_keys import Sitting
from vrts.debug.files import Files
from vrts.debug.scripted.places import current
from vrts.debug.terminal.keys import Keyboard, Outside
from vrts.debug.terminal.view import View


@pytest.mark.parametrize(
    ("question", "line"),
    [("who n", 5), ("next n", 6), ("why n", 5), ("marks", 2), ("who SIG(5)", 9), ("why", 7)],
)
def test_enter_on_a_line_of_an_answer_goes_there(tmp_path: Path, question: str, line: int) -> None:
    s = Sitting(session(tmp_path))
    for typed in ("mark first", "to 10", question):
        s.press(":")
        s.type(typed)
    page = s.view.page
    assert page is not None
    assert page.goes[page.chosen] == 1
    assert page.lines[page.chosen][:70] in s.screen()
    s.press("enter")
    assert s.view.page is None
    assert s.record[-1] == "go 1"
    now = current(s.session.debugger, process=False)
    assert now is not None
    assert now.span.line == line


def test_up_and_down_choose_only_lines_that_lead_somewhere(tmp_path: Path) -> None:
    s = Sitting(session(tmp_path))
    s.press(":")
    s.type("to 10")
    s.press("y")
    page = s.view.page
    assert page is not None
    assert page.goes[0] is None  # the effect
    seen = {page.chosen}
    for key in ["down"] * 20 + ["up"] * 20 + ["page down"]:
        s.press(key)
        seen.add(page.chosen)
        assert all(piece.strip() in s.screen(100) for piece in page.lines[page.chosen].split("  "))
    assert seen == {k for k, go in enumerate(page.goes) if go is not None}
    text = "\n".join(s.view.said)
    s.press("escape")
    assert s.view.page is None
    assert "\n".join(s.view.said) == text  # it is still to be read


def sitting(tmp_path: Path) -> tuple[Keyboard, View, Path, Path]:
    program, scene = tmp_path / "prog.v2", tmp_path / "scene.toml"
    program.write_text("old")
    scene.write_text("old")
    files, view = Files((program, scene), (program,)), View()
    keyboard = Keyboard(session(tmp_path), view, Outside(str, str, files.news))
    return keyboard, view, program, scene


def test_a_text_that_changed_is_offered_once_and_not_taken_up(tmp_path: Path) -> None:
    keyboard, view, program, _ = sitting(tmp_path)
    assert not keyboard.look()
    program.write_text("another")
    assert keyboard.look()
    assert "`prog.v2` has changed on disk: type `reload` to go on with it" in view.said[0]
    assert not keyboard.look()
    program.write_text("a third text")
    keyboard.press("up")  # any key looks
    assert view.said[-1].startswith("`prog.v2` has changed")


def test_it_waits_while_a_line_is_typed(tmp_path: Path) -> None:
    keyboard, view, program, _ = sitting(tmp_path)
    keyboard.press(":")
    program.write_text("another")
    assert not keyboard.look()
    assert view.said == []
    keyboard.press("escape")
    assert keyboard.look()


def test_another_scene_is_no_text_to_reload(tmp_path: Path) -> None:
    keyboard, view, _, scene = sitting(tmp_path)
    scene.write_text("another")
    assert keyboard.look()
    assert view.said == ["`scene.toml` has changed on disk: `restart` begins again with it"]
