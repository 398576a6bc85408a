"""Laws of sending over a line that loses, doubles and changes characters, or breaks.

After any fault either everything is verified, or it is said what is wrong and what the controller
holds; RETURN is pressed only behind lines that are on the list; and what was broken off can be
resumed, without doubling a line.
"""

import re
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.support_emulator import (
    CARGO,
    PLACES,
    Fault,
    Faulty,
    Watched,
    Wire,
    profile,
    sending,
    talk_over,
)
from vrts.dispatch import allowed
from vrts.dispatch.allowed import Prompt
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.held.looking import Options
from vrts.dispatch.transfer.rehearsal import rehearsed
from vrts.dispatch.transfer.send import BEGUN, Sending
from vrts.pipeline.refused import Refused

KNOWN = profile()
KINDS = ("dropped", "doubled", "garbled", "unplugged")
_PREFIX = re.compile(r"steps 1 to (\d+) of \d+, as sent")


def transfer(machine: Watched, faults: tuple[Fault, ...]) -> tuple[Sending, Refused | None, int]:
    """Send over a faulty line; return the transfer, what was told, and how many faults happened."""
    line = Faulty(faults)
    found = sending(talk_over(Wire(machine, line), KNOWN), KNOWN)
    try:
        found.run()
    except Refused as refused:
        return found, refused, line.happened
    return found, None, line.happened


def characters(direction: str) -> int:
    """Return how many characters an undisturbed transfer has in one direction."""
    if direction not in _COUNTED:
        with TemporaryDirectory() as folder:
            line = Counting()
            sending(talk_over(Wire(Watched(Path(folder), KNOWN), line), KNOWN), KNOWN).run()
            _COUNTED.update(heard=line.heard_ones, told=line.told_ones)
    return _COUNTED[direction]


_COUNTED: dict[str, int] = {}


class Counting:
    """A good line that counts."""

    heard_ones = told_ones = 0

    def heard(self, character: int) -> bytes:
        self.heard_ones += 1
        return bytes((character,))

    def told(self, character: int) -> bytes:
        self.told_ones += 1
        return bytes((character,))


@st.composite
def fault(draw: st.DrawFn) -> Fault:
    direction = draw(st.sampled_from(("heard", "told")))
    at = draw(st.integers(0, characters(direction) - 1))
    return Fault(direction, at, draw(st.sampled_from(KINDS)), draw(st.integers(1, 255)))


def check_what_is_known(found: Sending, machine: Watched) -> None:
    """Compare what is said of the controller with what it holds."""
    held, there = machine.programs(), machine.places()
    for program in CARGO.programs:
        state, rows = found.states[f"program {program.name}"], held.get(program.name)
        prefix = _PREFIX.fullmatch(state)
        if state in ("verified", "there already, the same") or state.startswith("all steps"):
            assert rows == program.rows, state
        elif prefix is not None:
            assert rows == program.rows[: int(prefix[1])], state
        elif state == "not there":
            assert not rows, state
        else:
            known = ("not looked at", "entered, not yet read back", BEGUN)
            assert state in known or " is '" in state, state
    for place in PLACES:
        state = found.states[f"location {place.name}"]
        if state == "not there":
            assert place.name not in there
        elif state.endswith(" there"):
            assert there[place.name] == [float(value) for value in state.split()[:6]]
        elif state == "verified":
            assert there[place.name] == [float(value) for value in place.values]


def check_lines(machine: Watched) -> None:
    """See that RETURN was pressed only behind lines that may be sent."""
    for prompt, line in machine.lines:
        if prompt in (".", "*"):
            kind = Prompt.READY if prompt == "." else Prompt.RUNNING
        elif prompt.startswith("Change"):
            kind = Prompt.CHANGE
        elif prompt.startswith("Are you"):
            kind = Prompt.CONFIRM
        else:
            kind = Prompt.STEP
        begun = any(row.startswith(line) for row in _LINES)  # a character has become RETURN
        assert allowed.permits(line, kind) or begun, (prompt, line)


_LINES = [line.text for line in rehearsed(CARGO, KNOWN)]


@settings(max_examples=examples(40), deadline=None)
@given(fault(), st.booleans())
def test_one_fault_is_harmless_or_told_and_can_be_resumed(one: Fault, resumes: bool) -> None:
    with TemporaryDirectory() as folder:
        machine = Watched(Path(folder), KNOWN)
        found, told, _ = transfer(machine, (one,))
        check_lines(machine)
        if told is None:
            assert set(found.states.values()) == {"verified"}
        else:
            assert told.diagnostics[0].headline
            assert set(found.states.values()) != {"verified"}
        sent = {row for program in CARGO.programs for row in program.rows}
        typed = [line for prompt, line in machine.lines if prompt.endswith((".?", ".I"))]
        cut = {line for line in typed if one.kind == "garbled" and _begins(line, sent)}
        assert set(typed) - cut <= sent | {"I", "E", "", " "}  # no step that was not meant
        assert one.kind == "unplugged" or machine.dialogue.prompt == "."  # nothing is left open
        if not resumes:
            check_what_is_known(found, machine)
            held = machine.programs()
            for program in CARGO.programs:
                rows = held.get(program.name, ())
                assert rows == program.rows[: len(rows)] or _begins(rows[-1], sent)
            return
        resumed = sending(talk_over(Wire(machine), KNOWN), KNOWN, CARGO, Options(resume=True))
        if cut - sent:
            return  # `--resume` refuses what is no beginning of the program
        resumed.run()
        assert set(resumed.states.values()) == {"verified"}
        assert machine.programs() == {p.name: p.rows for p in CARGO.programs}
        assert machine.places() == {p.name: [float(v) for v in p.values] for p in PLACES}


def _begins(line: str, sent: set[str]) -> bool:
    """Return whether a line is the beginning of one that was sent."""
    return any(row.startswith(line) for row in sent)


@settings(max_examples=examples(40), deadline=None)
@given(st.lists(fault(), min_size=2, max_size=6))
def test_many_faults_are_never_taken_for_success(many: list[Fault]) -> None:
    with TemporaryDirectory() as folder:
        machine = Watched(Path(folder), KNOWN)
        found, told, _ = transfer(machine, tuple(many))
        if told is None:
            assert set(found.states.values()) == {"verified"}
            assert machine.programs() == {p.name: p.rows for p in CARGO.programs}
        check_what_is_known(found, machine)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("direction", ["heard", "told"])
def test_a_fault_in_a_step_stops_before_return(kind: str, direction: str, tmp_path: Path) -> None:
    count = _characters_until(tmp_path, direction, b"MOVES part") + 3
    machine = Watched(tmp_path, KNOWN)
    found, told, happened = transfer(machine, (Fault(direction, count, kind, 1),))
    assert happened == 1
    assert told is not None
    assert told.diagnostics[0].rule.code == ("V833" if kind == "unplugged" else "V835")
    assert machine.programs().get("pick", ()) == CARGO.programs[0].rows[:5]
    if kind != "unplugged":
        assert found.states["program pick"] == "steps 1 to 5 of 13, as sent"
        assert machine.lines[-2:] == [("    6.?", "E"), (".", "LISTP pick")]


def test_a_listing_that_comes_back_changed_is_not_believed(tmp_path: Path) -> None:
    count = characters("told") - 200  # in the listing of locations at the end
    machine = Watched(tmp_path, KNOWN)
    _, told, _ = transfer(machine, (Fault("told", count, "garbled", 1),))
    assert told is not None
    assert told.diagnostics[0].rule.code in ("V839", "V840", "V834")
    assert machine.programs() == {p.name: p.rows for p in CARGO.programs}


def test_a_program_that_lost_a_step_on_the_controller_is_noticed(tmp_path: Path) -> None:
    machine = Forgetful(tmp_path, KNOWN)
    _, told, _ = transfer(machine, ())
    assert told is not None
    assert told.diagnostics[0].rule.code == "V839"
    assert told.diagnostics[0].notes == ("step 7 is 'TYPE \"a  b;c\", /I2, d', not 'CLOSEI'",)


class Forgetful(Watched):
    """A controller that loses a step when its editor is left."""

    def receive(self, character: int) -> bytes:
        shown = super().receive(character)
        programs = self.dialogue.monitor.desk.programs
        pick = programs.get("pick")
        if pick is not None and len(pick.lines) == 13:
            programs["pick"] = pick._replace(lines=(*pick.lines[:6], *pick.lines[7:]))
        return shown


def test_a_location_that_changes_on_the_controller_is_noticed(tmp_path: Path) -> None:
    machine = Moving(tmp_path, KNOWN)
    _, told, _ = transfer(machine, ())
    assert told is not None
    assert told.diagnostics[0].rule.code == "V839"
    (note,) = told.diagnostics[0].notes
    assert note == (
        "`part`: sent 500.00 200.00 -100.50 90.000 90.000 0.000, "
        "listed 500.00 200.00 -99.00 90.000 90.000 0.000"
    )


class Moving(Watched):
    """A controller at which somebody changes a location once all programs are there."""

    def receive(self, character: int) -> bytes:
        shown = super().receive(character)
        desk = self.dialogue.monitor.desk
        if "put" in desk.programs and self.places()["part"][2] == -100.5:
            self.type("POINT part", ",,-99", "")
        return shown


def _characters_until(folder: Path, direction: str, text: bytes) -> int:
    """Return how many characters come before a text is typed, or echoed."""
    line = Until(text)
    sending(talk_over(Wire(Watched(folder, KNOWN), line), KNOWN), KNOWN).run()
    return line.counts[direction]


class Until:
    """A good line that counts until a text has begun to be sent."""

    def __init__(self, text: bytes) -> None:
        self.counts = {"heard": 0, "told": 0}
        self._text = text
        self._seen = {"heard": b"", "told": b""}

    def heard(self, character: int) -> bytes:
        return self._passed("heard", character)

    def told(self, character: int) -> bytes:
        return self._passed("told", character)

    def _passed(self, direction: str, character: int) -> bytes:
        if self._text not in self._seen[direction]:
            self._seen[direction] += bytes((character,))
            self.counts[direction] = len(self._seen[direction]) - len(self._text)
        return bytes((character,))


def test_a_controller_unlike_the_profile_is_told_with_what_came(tmp_path: Path) -> None:
    machine, other = Watched(tmp_path, KNOWN), profile("kawasaki-as")
    with pytest.raises(Refused) as told:
        sending(talk_over(Wire(machine), other), other).run()
    assert told.value.diagnostics[0].rule.code == "V834"
    assert "came: '\\n.\\n.\\n.'" in told.value.diagnostics[0].notes
    assert {line for _, line in machine.lines} == {""}


def test_a_controller_that_shows_a_prompt_of_its_own_in_the_editor(tmp_path: Path) -> None:
    machine = Watched(tmp_path, profile("kawasaki-as"))  # no period behind the number, and `>`
    known = KNOWN._replace(prompts=KNOWN.prompts._replace(ready=re.compile(">")))
    found = sending(talk_over(Wire(machine), known), known, Cargo(CARGO.programs, (), ()))
    with pytest.raises(Refused) as told:
        found.run()
    assert told.value.diagnostics[0].rule.code == "V834"
    assert "came: '\\n.PROGRAM pick\\n    1?'" in told.value.diagnostics[0].notes
    assert machine.programs() == {}


def test_an_echo_in_upper_case_is_taken_where_the_profile_says_so(tmp_path: Path) -> None:
    known = KNOWN._replace(typing=KNOWN.typing._replace(echo="upper"))
    machine = Shouting(tmp_path, known)
    sending(talk_over(Wire(machine), known), known).run()
    with pytest.raises(Refused) as told:
        sending(talk_over(Wire(machine), KNOWN), KNOWN, _renamed()).run()
    assert told.value.diagnostics[0].rule.code == "V835"


class Shouting(Watched):
    """A controller that echoes in upper case."""

    def receive(self, character: int) -> bytes:
        shown = super().receive(character)
        return shown.upper() if len(shown) == 1 else shown


def _renamed() -> Cargo:
    rows = CARGO.programs[0].rows
    return CARGO._replace(programs=(Steps("third", "", rows),), places=())
