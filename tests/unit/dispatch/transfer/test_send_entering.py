"""Sending to an emulated controller: what is typed, and what is done with what is there already."""

import io
from pathlib import Path

import pytest

from tests.support_emulator import (
    CARGO,
    NOON,
    PICK,
    PLACES,
    PUT,
    Watched,
    Wire,
    profile,
    sending,
    talk_over,
)
from vrts.dispatch.profile import Profile, profile_names
from vrts.dispatch.steps import Steps
from vrts.dispatch.transfer.cargo import Cargo
from vrts.dispatch.transfer.held.looking import Options
from vrts.dispatch.transfer.listed import Place
from vrts.dispatch.transfer.locations import same_place
from vrts.dispatch.transfer.rehearsal import rehearsed
from vrts.dispatch.transfer.talk import Talk
from vrts.dispatch.transfer.transcript import Transcript
from vrts.pipeline.refused import Refused

KNOWN = profile()
AS_PICK = Steps("pick", "(&at,n)", ("JMOVE at", "d = 5", "", "100 LMOVE part", "CLOSEI"))


def fill(machine: Watched, program: Steps, count: int) -> None:
    """Have the controller hold the first steps of a program."""
    machine.type(f"EDIT {program.name}{program.formals}", *program.rows[:count], "E")


def refused(machine: Watched, options: Options | None = None, cargo: Cargo = CARGO) -> Refused:
    """Send, and return why it was refused."""
    with pytest.raises(Refused) as told:
        sending(talk_over(Wire(machine), KNOWN), KNOWN, cargo, options).run()
    return told.value


def send(machine: Watched, options: Options | None = None, cargo: Cargo = CARGO) -> dict[str, str]:
    """Send, and return the states."""
    found = sending(talk_over(Wire(machine), KNOWN), KNOWN, cargo, options)
    found.run()
    return found.states


def test_an_empty_controller_holds_everything_afterwards(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    states = send(machine)
    assert set(states.values()) == {"verified"}
    assert machine.programs() == {"pick": PICK.rows, "put": PUT.rows}
    assert machine.places() == {p.name: [float(v) for v in p.values] for p in PLACES}
    assert machine.dialogue.monitor.desk.programs["put"].header == ".PROGRAM put(n,at)"


@pytest.mark.parametrize("name", profile_names())
def test_every_profile_talks_to_the_monitor_in_its_dialect(name: str, tmp_path: Path) -> None:
    known = profile(name)
    cargo = Cargo((AS_PICK,), PLACES, ()) if known.dialect == "as" else CARGO
    machine = Watched(tmp_path, known)
    found = sending(talk_over(Wire(machine), known), known, cargo)
    found.run()
    assert set(found.states.values()) == {"verified"}
    assert machine.programs()["pick"] == cargo.programs[0].rows


def test_a_dry_run_shows_exactly_the_lines_that_are_typed(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    send(machine)
    lines = [line.text for line in rehearsed(CARGO, KNOWN)]
    assert [text for _, text in machine.lines] == ["", *lines]  # RETURN shows the first prompt


def test_what_is_there_already_is_not_touched(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    send(machine)
    machine.lines.clear()
    states = send(machine)
    assert set(states.values()) == {"verified"}
    assert not any(line.startswith(("EDIT", "POINT", "DELETE")) for _, line in machine.lines)


def test_another_program_of_the_name_is_left_alone_and_shown(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    fill(machine, Steps("pick", "", ("READY", "OPENI")), 2)
    told = refused(machine)
    assert told.diagnostics[0].rule.code == "V838"
    assert told.diagnostics[0].notes == (
        "program `pick` is another one: step 1 is 'READY', not '; fetch one part'",
    )
    assert machine.programs() == {"pick": ("READY", "OPENI")}
    assert machine.places() == {}


def test_replacing_keeps_a_copy_first(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    fill(machine, Steps("pick", "", ("READY", "OPENI")), 2)
    machine.type("POINT part", "1,2,3,90,-90,0", "")
    copies: list[tuple[str, dict[str, tuple[str, ...]]]] = []

    def kept(text: str) -> None:
        copies.append((text, dict(machine.programs())))

    found = sending(talk_over(Wire(machine), KNOWN), KNOWN, CARGO, Options(replace=True), kept)
    found.run()
    text = (
        ".PROGRAM pick\n        READY\n        OPENI\n.END\n"
        ".LOCATIONS\npart            1.00 2.00 3.00 90.000 -90.000 0.000\n.END\n"
    )
    assert copies == [(text, {"pick": ("READY", "OPENI")})]  # while it was still there
    assert machine.programs()["pick"] == PICK.rows


def test_old_programs_are_gone_before_new_locations_come(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    fill(machine, Steps("pick", "", ("READY",)), 1)
    send(machine, Options(replace=True))
    words = [line.split()[0] for _, line in machine.lines if line[:4] in ("DELE", "POIN", "EDIT")]
    assert words == ["DELETEP", "POINT", "POINT", "POINT", "EDIT", "EDIT"]


@pytest.mark.parametrize("steps", [1, 3, 4, 12])
def test_resuming_goes_on_behind_what_is_there(steps: int, tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    rows = [*PICK.rows[:3], "I", " ", "", *PICK.rows[4:]]
    machine.type("EDIT pick", *rows[: steps if steps < 4 else steps + 2], "E")
    machine.lines.clear()
    told = refused(machine)
    assert f"first {steps} of 13 steps: `--resume` goes on" in told.diagnostics[0].notes[0]
    assert send(machine, Options(resume=True))["program pick"] == "verified"
    assert machine.programs()["pick"] == PICK.rows
    typed = [line for prompt, line in machine.lines if prompt.endswith("?")]
    assert PICK.rows[0] not in typed


def test_resuming_leaves_an_editor_that_was_left_open(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    machine.type("EDIT pick", *PICK.rows[:2])
    told = refused(machine)
    assert told.diagnostics[0].rule.code == "V841"
    assert "(step 3)" in told.diagnostics[0].notes[0]
    send(machine, Options(resume=True))
    assert machine.programs()["pick"] == PICK.rows


def test_resuming_takes_up_a_location_that_was_begun(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    machine.type("POINT part")  # and then the line broke
    send(machine, Options(resume=True))
    assert machine.places()["part"] == [500.0, 200.0, -100.5, 90.0, 90.0, 0.0]


def test_resuming_does_not_take_another_program_for_a_beginning(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    fill(machine, Steps("pick", "", (PICK.rows[0], "READY")), 2)
    told = refused(machine, Options(resume=True))
    assert told.diagnostics[0].rule.code == "V838"
    assert machine.programs()["pick"] == (PICK.rows[0], "READY")


def test_nothing_is_sent_while_a_program_runs(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    machine.type("EDIT loop", "10 DELAY 1", "GOTO 10", "E", "EXECUTE loop")
    told = refused(machine)
    assert told.diagnostics[0].rule.code == "V837"
    assert [line for _, line in machine.lines] == [""]


def test_a_program_that_only_status_tells_of_is_noticed(tmp_path: Path) -> None:
    known = profile("kawasaki-as")
    machine = Watched(tmp_path, known)
    machine.type("EDIT loop", "10 DELAY 1", "GOTO 10", "E", "EXECUTE loop")
    with pytest.raises(Refused) as told:
        sending(talk_over(Wire(machine), known), known, Cargo((AS_PICK,), (), ())).run()
    assert told.value.diagnostics[0].rule.code == "V837"
    assert [line for _, line in machine.lines] == ["", "STATUS"]


def test_a_full_memory_is_told_in_the_words_of_the_controller(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    machine.dialogue.monitor.desk.room = 120
    found = sending(talk_over(Wire(machine), KNOWN), KNOWN)
    with pytest.raises(Refused) as told:
        found.run()
    assert told.value.diagnostics[0].rule.code == "V836"
    assert "*Not enough storage area*" in told.value.diagnostics[0].headline
    assert machine.dialogue.prompt == "."  # the editor has been left
    steps = machine.programs()["pick"]
    assert steps == PICK.rows[: len(steps)]
    assert found.states["program pick"] == f"steps 1 to {len(steps)} of 13, as sent"
    assert found.states["program put"] == "not there"


def test_a_step_that_the_controller_refuses_stops_everything(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    bad = Steps("pick", "", ("READY", "MOVEE part", "OPENI"))
    found = sending(talk_over(Wire(machine), KNOWN), KNOWN, Cargo((bad, PUT), (), ()))
    with pytest.raises(Refused) as told:
        found.run()
    assert "*Unknown instruction*" in told.value.diagnostics[0].headline
    assert machine.programs() == {"pick": ("READY",)}
    assert found.states["program pick"] == "steps 1 to 1 of 3, as sent"


@pytest.mark.parametrize("after", range(4))
def test_a_step_is_not_typed_when_the_editor_has_ended_without_a_word(
    after: int, tmp_path: Path
) -> None:
    machine = Leaving(tmp_path, KNOWN, after)
    outputs = Steps("lamps", "", ("SIGNAL 1", "SIGNAL 2", "SIGNAL 3", "SIGNAL 4"))
    found = sending(talk_over(Wire(machine), KNOWN), KNOWN, Cargo((outputs,), (), ()))
    with pytest.raises(Refused) as told:
        found.run()
    assert told.value.diagnostics[0].rule.code == "V834"
    typed = [line for prompt, line in machine.lines if prompt == "." and line.startswith("SIGNAL")]
    assert not typed, "at the prompt for commands it would switch an output"
    assert found.states["program lamps"] in ("not there", f"steps 1 to {after} of 4, as sent")


class Leaving(Watched):
    """A controller whose editor ends by itself, after so many steps, and shows nothing."""

    def __init__(self, folder: Path, known: Profile, after: int) -> None:
        super().__init__(folder, known)
        self.after = after
        self.ended = False

    def receive(self, character: int) -> bytes:
        shown = super().receive(character)
        steps = [line for _, line in self.lines if line.startswith("SIGNAL")]
        editing = "?" in self.dialogue.prompt
        if character == 0x0D and editing and len(steps) == self.after and not self.ended:
            self.ended = True
            self.dialogue.enter("E")
        return shown


@pytest.mark.parametrize("shown", ["12.34", "12.35"])
def test_a_half_of_what_is_printed_may_be_rounded_either_way(shown: str) -> None:
    coarse = KNOWN._replace(angle_decimals=2, length_decimals=2)
    joints = Place("#a", ("12.345", *("0.00",) * 5))
    assert same_place(joints, Place("#a", (shown, *("0.00",) * 5)), coarse)
    pose = Place("a", ("12.345", "0.00", "0.00", "0.00", "90.00", "0.00"))
    assert same_place(pose, Place("a", (shown, *pose.values[1:])), coarse)
    assert not same_place(joints, Place("#a", ("12.36", *("0.00",) * 5)), coarse)


def test_an_answer_that_is_neither_silence_nor_an_error_stops_everything(tmp_path: Path) -> None:
    machine = Chatty(tmp_path, KNOWN)
    found = sending(talk_over(Wire(machine), KNOWN), KNOWN)
    with pytest.raises(Refused) as told:
        found.run()
    assert told.value.diagnostics[0].rule.code == "V834"
    assert "came: 'line changed to: MOVES part\\n'" in told.value.diagnostics[0].notes
    assert machine.dialogue.prompt == "."
    assert found.states["program pick"] == "steps 1 to 6 of 13, as sent"


class Chatty(Watched):
    """A controller that comments on a step."""

    def receive(self, character: int) -> bytes:
        shown = super().receive(character)
        if character == 0x0D and self.lines[-1][1] == "MOVES part":
            return shown.replace(b"\r\n", b"\r\nline changed to: MOVES part\r\n", 1)
        return shown


def test_numbers_and_strings_are_compared_and_left_to_the_operator(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    machine.type("DO count = 5", "DO pitch = 25.4", 'DO $msg = "PART  READY"')
    values = (("count", "5"), ("pitch", "25.5"), ("$msg", '"PART  READY"'), ("limit", "3"))
    found = sending(talk_over(Wire(machine), KNOWN), KNOWN, Cargo((PUT,), (), values))
    found.run()
    assert found.missing == [("pitch", "25.5"), ("limit", "3")]


def test_a_controller_that_needs_time_gets_it(tmp_path: Path) -> None:
    typing = KNOWN.typing._replace(character_delay_s=0.01, line_delay_s=0.5)
    slow, waits = KNOWN._replace(typing=typing), list[float]()
    wire = Wire(Watched(tmp_path, slow))
    talk = Talk(wire, slow, Transcript(io.StringIO(), lambda: NOON), waits.append)
    sending(talk, slow, Cargo((PUT,), (), ())).run()
    lines = [line.text for line in rehearsed(Cargo((PUT,), (), ()), slow)]
    assert waits.count(0.5) == len(lines)
    assert waits.count(0.01) == sum(map(len, lines))


def test_a_vertical_tool_may_be_listed_with_other_angles(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    place = Place("up", ("0.00", "0.00", "900.00", "30.000", "90.000", "10.000"))
    send(machine, cargo=Cargo((), (place,), ()))
    assert machine.places()["up"][3:] == [20.0, 90.0, 0.0]


def test_what_is_no_line_to_send_is_not_sent(tmp_path: Path) -> None:
    machine = Watched(tmp_path, KNOWN)
    place = Place("x\rEXECUTE pick", PLACES[0].values)
    told = refused(machine, cargo=Cargo((), (place,), ()))
    assert told.diagnostics[0].rule.code == "V842"
    assert not any("EXECUTE" in line for _, line in machine.lines)
