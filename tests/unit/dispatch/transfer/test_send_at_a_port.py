"""Sending over a real pseudo-terminal, by pyserial: what depends on time, and on the system."""

import io
import re
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.support_emulator import (
    CARGO,
    Unplugged,
    Watched,
    at_a_port,
    port_talk,
    profile,
    sending,
)
from vrts.dispatch.profile_parts import Profile
from vrts.dispatch.transfer.emulator import Emulator, GoodLine
from vrts.dispatch.transfer.held.looking import Options
from vrts.pipeline.refused import Refused

if sys.platform == "win32":
    pytest.skip("Windows has no pseudo-terminals", allow_module_level=True)

KNOWN = profile()
FAST = 115_200.0
XON, XOFF = b"\x11", b"\x13"
ROW = re.compile(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3} [<>-] .*")


def refused(machine: Watched, known: Profile = KNOWN, baud: float = FAST) -> tuple[str, str]:
    """Send, and return code and headline of the refusal."""
    with at_a_port(machine, baud) as emulator, port_talk(emulator.port, known) as talk:
        with pytest.raises(Refused) as told:
            sending(talk, known).run()
        found = told.value.diagnostics[0]
        return found.rule.code, found.headline


def test_everything_is_sent_verified_and_written_down(tmp_path: Path) -> None:
    machine, log = Watched(tmp_path, KNOWN), io.StringIO()
    with at_a_port(machine, FAST) as emulator, port_talk(emulator.port, KNOWN, log) as talk:
        found = sending(talk, KNOWN)
        found.run()
    assert set(found.states.values()) == {"verified"}
    assert machine.programs() == {program.name: program.rows for program in CARGO.programs}
    rows = log.getvalue().splitlines()
    assert all(ROW.fullmatch(row) for row in rows)
    assert [row[:23] for row in rows] == sorted(row[:23] for row in rows)
    sent = "".join(row[26:] for row in rows if row[24] == ">")
    assert sent.startswith(r"\x15\rSTATUS\rLISTP pick\r")
    for program in CARGO.programs:
        assert all(row in sent for row in program.rows)


class Holding(Watched):
    """A controller that stops its line with Ctrl-S in the middle of a program."""

    hold_s = 0.3
    _since: float | None = None
    held = False

    def receive(self, character: int) -> bytes:
        shown = super().receive(character)
        if not self.held and self.lines and self.lines[-1][1] == "MOVES part":
            self.held = True
            self._since = time.monotonic()
            return shown + XOFF
        return shown

    def pass_time(self, seconds: float) -> bytes:
        if self._since is not None and time.monotonic() - self._since > self.hold_s:
            self._since = None
            return XON
        return super().pass_time(seconds)


def test_a_line_that_is_held_for_a_while_is_waited_for(tmp_path: Path) -> None:
    machine = Holding(tmp_path, KNOWN)
    with at_a_port(machine, FAST) as emulator, port_talk(emulator.port, KNOWN) as talk:
        found = sending(talk, KNOWN)
        found.run()
    assert machine.held
    assert set(found.states.values()) == {"verified"}


def test_a_line_that_is_held_for_ever_is_told(tmp_path: Path) -> None:
    machine = Holding(tmp_path, KNOWN)
    machine.hold_s = 1e9
    code, headline = refused(machine)
    assert (code, headline[:27]) == ("V833", "nothing could be sent on `/")
    assert machine.programs()["pick"] == CARGO.programs[0].rows[:6]


def test_a_slow_echo_is_waited_for(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    small = CARGO._replace(programs=CARGO.programs[1:], places=())
    with at_a_port(machine, 2400.0) as emulator, port_talk(emulator.port, KNOWN) as talk:
        found = sending(talk, KNOWN, small)
        found.run()
    assert found.states == {"program put": "verified"}


def test_an_echo_that_is_slower_than_the_profile_says_is_told(tmp_path: Path) -> None:
    patience = KNOWN.patience._replace(echo_s=0.02)
    known = KNOWN._replace(patience=patience._replace(quiet_s=0.3))
    code, _ = refused(Watched(tmp_path, known), known, baud=150.0)
    assert code in ("V834", "V835")


def test_a_plug_that_is_pulled_is_told_and_sending_goes_on_later(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    line = Pulled(lambda: bool(machine.lines) and machine.lines[-1][1] == "CLOSEI")
    with at_a_port(machine, FAST, line) as emulator, port_talk(emulator.port, KNOWN) as talk:
        line.emulator = emulator
        found = sending(talk, KNOWN)
        with pytest.raises(Refused) as told:
            found.run()
    assert told.value.diagnostics[0].rule.code == "V833"
    assert found.states["program pick"] == "begun: how many steps it has is not known"
    with at_a_port(machine, FAST) as emulator, port_talk(emulator.port, KNOWN) as talk:
        found = sending(talk, KNOWN, CARGO, Options(resume=True))
        found.run()
    assert set(found.states.values()) == {"verified"}
    assert machine.programs() == {program.name: program.rows for program in CARGO.programs}
    assert sum(line == "MOVES part" for _, line in machine.lines) == 1


class Pulled(GoodLine):
    """A line whose plug is pulled once something holds."""

    emulator: Emulator | None = None

    def __init__(self, when: Callable[[], bool]) -> None:
        self._when = when

    def told(self, character: int) -> bytes:
        if self.emulator is not None and self._when():
            self.emulator.close()
            raise Unplugged
        return super().told(character)


def test_a_port_that_is_none_cannot_be_opened(tmp_path: Path) -> None:
    plain = tmp_path / "file"
    plain.write_text("no port")
    for name in (str(tmp_path / "ttyUSB9"), str(plain), str(tmp_path), ""):
        with pytest.raises(Refused) as told, port_talk(name, KNOWN):
            pass
        assert told.value.diagnostics[0].rule.code == "V832", name


def test_a_port_is_for_one_at_a_time(tmp_path: Path) -> None:
    with (
        at_a_port(Watched(tmp_path, KNOWN), FAST) as emulator,
        port_talk(emulator.port, KNOWN),
        pytest.raises(Refused) as told,
        port_talk(emulator.port, KNOWN),
    ):
        pass
    assert told.value.diagnostics[0].rule.code == "V832"


def test_a_running_program_and_what_it_prints_are_no_prompt(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    machine.type("EDIT loop", 'TYPE "."', "DELAY 0.1", "E", "EXECUTE loop, -1")
    code, _ = refused(machine)
    assert code in ("V837", "V834")
    assert machine.dialogue.busy  # it still runs
    assert {line for _, line in machine.lines} <= {"", "STATUS"}


def test_nobody_there_is_told(tmp_path: Path) -> None:
    machine = Deaf(tmp_path, KNOWN)
    code, headline = refused(machine)
    assert code == "V834"
    assert "it shows no prompt after RETURN" in headline


class Deaf(Watched):
    """A controller that is turned off."""

    def receive(self, character: int) -> bytes:
        return b""

    def greeting(self) -> bytes:
        return b""
