"""Keys of the pendant: what they move, what they record, what is written."""

from pathlib import Path

import pytest

from tests.unit.monitor.dialogues import LONGEST, dialogue
from vrts.base.oat import components
from vrts.base.source import SourceFile
from vrts.base.units import DEG, deg
from vrts.lang.compiler import compile_source
from vrts.monitor.dialogue import Dialogue
from vrts.monitor.pendant import Pendant, points_text, press, screen
from vrts.robots.arms.puma import PUMA_761

BENT = "DO MOVE #PPOINT(0,-60,120,0,30,0)"  # straight lines may begin here


class Session:
    """A pendant whose motions are carried out at once."""

    def __init__(self, folder: Path) -> None:
        self.dialogue: Dialogue = dialogue(folder)
        self.pendant = Pendant()
        self.said = ""

    def type(self, *keys: str) -> None:
        for key in keys:
            found = press(self.pendant, key, self.dialogue.state)
            self.pendant = found.pendant
            if found.value is not None:
                self.dialogue.issue(found.value)
            if found.instruction:
                self.said = self.dialogue.enter(f"DO {found.instruction}")
                self.said += self.dialogue.settle(LONGEST)

    @property
    def joints(self) -> tuple[float, ...]:
        return tuple(deg(q) for q in self.dialogue.state.configuration)

    @property
    def pose(self) -> tuple[float, ...]:
        state = self.dialogue.state
        return components(state.base @ state.X_WT)


@pytest.fixture
def session(tmp_path: Path) -> Session:
    return Session(tmp_path)


@pytest.mark.parametrize(
    ("plus", "minus", "axis"), list(zip("qwerty", "asdfgh", range(6), strict=True))
)
def test_each_joint_has_two_keys(session: Session, plus: str, minus: str, axis: int) -> None:
    before = session.joints
    session.type("-", plus)
    moved = [b - a for a, b in zip(before, session.joints, strict=True)]
    assert moved == pytest.approx([2.0 if n == axis else 0.0 for n in range(6)], abs=1e-6)
    session.type(minus)
    assert session.joints == pytest.approx(before, abs=1e-6)


@pytest.mark.parametrize(("key", "axis"), [("q", 0), ("w", 1), ("e", 2)])
def test_axes_of_the_world(session: Session, key: str, axis: int) -> None:
    session.dialogue.enter(BENT)
    session.dialogue.settle(LONGEST)
    before = session.pose
    session.type("2", key)
    assert session.said == ""
    moved = [b - a for a, b in zip(before, session.pose, strict=True)]
    assert moved == pytest.approx([10.0 if n == axis else 0.0 for n in range(6)], abs=1e-4)


def test_turning_about_the_world_keeps_the_place(session: Session) -> None:
    session.dialogue.enter(BENT)
    session.dialogue.settle(LONGEST)
    before = session.pose
    session.type("2", "y")  # about the vertical: only O changes
    assert session.said == ""
    moved = [b - a for a, b in zip(before, session.pose, strict=True)]
    assert moved == pytest.approx([0, 0, 0, 5, 0, 0], abs=1e-4)


def test_axes_of_the_tool(session: Session) -> None:
    session.dialogue.enter(BENT)
    session.dialogue.settle(LONGEST)
    X = session.dialogue.state.X_WT
    session.type("3", "e")  # along the approach
    assert session.said == ""
    moved = session.dialogue.state.X_WT.translation
    wanted = [p + 0.010 * a for p, a in zip(X.translation, X.approach, strict=True)]
    assert moved == pytest.approx(wanted, abs=1e-7)


def test_limits_are_those_of_the_controller(session: Session) -> None:
    session.type("+", "+", *"s" * 8)  # joint 2 by 45 degrees
    assert "*Joint 2 out of range*" in session.said
    assert "at its limit" not in screen(Pendant(), session.dialogue.state, PUMA_761)


def test_steps_have_a_smallest_and_a_largest(session: Session) -> None:
    session.type(*"-" * 9)
    assert "step 0.1 degrees" in screen(session.pendant, session.dialogue.state, PUMA_761)
    session.type("2", *"+" * 9)
    assert "step 100 mm" in screen(session.pendant, session.dialogue.state, PUMA_761)


def test_the_hand(session: Session) -> None:
    session.type("o")
    assert session.dialogue.state.hand_opening == pytest.approx(0.080)
    session.type("c")
    assert session.dialogue.state.hand_opening == pytest.approx(0.0)


def test_recording_counts_names_and_writes_what_store_writes(session: Session) -> None:
    session.type("space", "enter", "q", "space", "enter", "space", *"#safe", "enter")
    session.type("space", *"row[3]", "enter", "space")
    assert session.pendant.following == "row[4]"
    session.type("escape", "x")
    assert session.pendant.done == "write"
    text = points_text(session.pendant)
    found = compile_source(SourceFile("points.lc", text))
    assert found.module is not None
    assert [d.name for d in found.module.data] == ["p1", "p2", "row", "#safe"]
    joints = found.module.data[3].value
    assert joints == pytest.approx((5 * DEG, -90 * DEG, 90 * DEG, 0, 0, 0))


def test_names_that_cannot_be_are_refused(session: Session) -> None:
    for name in ("9p", "a b", "$s", "a[", "much.too.long.name"):
        session.type("space", *name, "enter")
        assert session.pendant.recorded == ()
        assert "no name of a location" in session.pendant.message
    session.type("space", *"Pick", "backspace", *"k2", "enter", "space", *"pick2", "enter")
    assert [r.title for r in session.pendant.recorded] == ["pick2"]
    assert "recorded already" in session.pendant.message


def test_undo_and_going_back(session: Session) -> None:
    session.type("enter")
    assert session.pendant.message == "nothing is recorded"
    session.type("space", "enter", "q", "space", "enter", "q")
    session.type("k", "enter")  # the first one
    assert session.said == ""
    assert session.joints[0] == pytest.approx(0.0, abs=1e-6)
    session.type("u")
    assert [r.title for r in session.pendant.recorded] == ["p1"]
    assert session.pendant.following == "p2"
    session.type("u", "u")
    assert session.pendant.message == "nothing is recorded"


def test_a_key_that_means_nothing_says_so(session: Session) -> None:
    session.type("?")
    assert session.pendant.message == "there is no key '?'"
    session.type("escape")
    assert session.pendant.done == "quit"
