"""Programs and locations back from a controller: as a file, and beside a bundle."""

from pathlib import Path

import pytest

from tests.support_emulator import (
    CARGO,
    PICK,
    PLACES,
    PUT,
    Fault,
    Faulty,
    Watched,
    Wire,
    profile,
    sending,
    talk_over,
)
from vrts.base.source import SourceFile
from vrts.dispatch.steps import first_difference, steps_of
from vrts.dispatch.transfer.held.diff import differences
from vrts.dispatch.transfer.held.fetch import fetch, fetched_text
from vrts.lang.compiler import compile_source
from vrts.lang.writing.store import store_text
from vrts.pipeline.refused import Refused

KNOWN = profile()


@pytest.fixture(name="machine")
def loaded(tmp_path: Path) -> Watched:
    """Return a controller that holds what is sent in other tests."""
    machine = Watched(tmp_path, KNOWN)
    sending(talk_over(Wire(machine), KNOWN), KNOWN).run()
    machine.lines.clear()
    return machine


def test_what_is_fetched_is_a_file_that_vrts_reads(machine: Watched) -> None:
    found = fetch(talk_over(Wire(machine), KNOWN), KNOWN)
    text = fetched_text(found, KNOWN.language)
    compiled = compile_source(SourceFile("fetched", text))
    assert not [d for d in compiled.diagnostics if d.is_error]
    assert compiled.module is not None
    assert sorted(compiled.module.programs) == ["pick", "put"]
    stored = store_text(SourceFile("fetched", text), compiled.module, KNOWN.language)
    assert "tray[2]         300.0000 350.2500 -60.0000 90.0000 -30.0000 12.3450" in stored


def test_every_program_comes_back_step_by_step(machine: Watched) -> None:
    found = fetch(talk_over(Wire(machine), KNOWN), KNOWN)
    for sent, back in zip((PICK, PUT), found.programs, strict=True):
        assert first_difference(sent, back, KNOWN.language) is None
        assert first_difference(sent, steps_of(back.text), KNOWN.language) is None
    assert [place.name for place in found.places] == ["part", "tray[2]", "#safe"]


def test_only_listings_are_asked_for(machine: Watched) -> None:
    fetch(talk_over(Wire(machine), KNOWN), KNOWN, ["put"])
    differences(talk_over(Wire(machine), KNOWN), KNOWN, CARGO)
    assert {line.split(" ")[0] for _, line in machine.lines} == {"", "LISTP", "LISTL"}


def test_a_program_may_run_meanwhile(machine: Watched) -> None:
    machine.type("EDIT loop", "10 DELAY 1", "GOTO 10", "E", "EXECUTE loop")
    found = fetch(talk_over(Wire(machine), KNOWN), KNOWN, ["pick"])
    assert first_difference(PICK, found.programs[0], KNOWN.language) is None
    assert machine.dialogue.busy


def test_an_empty_controller_gives_an_empty_file(tmp_path: Path) -> None:
    found = fetch(talk_over(Wire(Watched(tmp_path, KNOWN)), KNOWN), KNOWN)
    assert fetched_text(found) == ""


def test_a_program_that_is_not_there_is_told(machine: Watched) -> None:
    with pytest.raises(Refused) as told:
        fetch(talk_over(Wire(machine), KNOWN), KNOWN, ["main"])
    assert told.value.diagnostics[0].headline == "the controller has no program `main`"


@pytest.mark.parametrize("kind", ["dropped", "doubled", "garbled"])
@pytest.mark.parametrize("at", range(150, 900, 75))
def test_no_changed_character_gets_into_a_file(machine: Watched, kind: str, at: int) -> None:
    good = fetch(talk_over(Wire(machine), KNOWN), KNOWN)
    line, told = Faulty([Fault("told", at, kind, 1)]), ""
    try:
        found = fetch(talk_over(Wire(machine, line), KNOWN), KNOWN)
    except Refused as refused:
        found, told = good, refused.diagnostics[0].rule.code
    assert found == good
    assert told in ("", "V834", "V835", "V836", "V840")
    assert line.happened


def test_a_controller_that_holds_the_bundle_differs_in_nothing(machine: Watched) -> None:
    assert differences(talk_over(Wire(machine), KNOWN), KNOWN, CARGO) == []


def test_differences_are_shown_line_by_line(machine: Watched) -> None:
    machine.type("EDIT pick,6", "MOVE part", "E", "DELETEP put", "Y")
    machine.type("POINT part", ",,-99", "", "DELETEL #safe", "DO count = 4")
    cargo = CARGO._replace(values=(("count", "5"), ("limit", "3")))
    rows = differences(talk_over(Wire(machine), KNOWN), KNOWN, cargo)
    assert [row for row in rows if row[0] in "+-"] == [
        "--- pick in the bundle",
        "+++ pick on the controller",
        "-        MOVES part",
        "+        MOVE part",
        "-.PROGRAM put(n,at)  (not on the controller)",
        "-part 500.00 200.00 -100.50 90.000 90.000 0.000",
        "+part 500.00 200.00 -99.00 90.000 90.000 0.000",
        "-#safe 0.000 -90.000 90.000 0.000 0.000 0.000",
        "-count 5",
        "+count 4",
        "-limit 3",
    ]
    assert PLACES[1].name not in "".join(rows)
