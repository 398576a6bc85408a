"""A memory that has an end."""

from pathlib import Path

from tests.unit.monitor.dialogues import dialogue, said


def test_a_step_that_does_not_fit_into_memory_is_refused_and_the_others_stay(
    tmp_path: Path,
) -> None:
    found = dialogue(tmp_path)
    found.monitor.desk.room = 40  # of which .PROGRAM, the name and .END take 20
    shown = said(
        found, "EDIT p", "READY", "OPENI", "CLOSEI", "BREAK", "I", "BREAK", "", "E", "LISTP p"
    )
    assert shown.count("*Not enough storage area*\nmemory is full\n") == 2
    steps = found.monitor.desk.programs["p"].lines
    assert steps == ("READY", "OPENI", "CLOSEI")


def test_other_programs_take_room_as_well(tmp_path: Path) -> None:
    found = dialogue(tmp_path)
    said(found, "EDIT p", "READY", "E")
    found.monitor.desk.room = 49
    assert "memory is full" in said(found, "EDIT q", "READY", "READY", "E")
    assert "memory is full" not in said(found, "DELETEP q", "Y", "EDIT p", "OPENI", "E")
