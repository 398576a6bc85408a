"""What a dialogue leaves alone, and what nothing typed can do."""

from pathlib import Path
from tempfile import TemporaryDirectory

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.laws import examples
from tests.unit.monitor.dialogues import LONGEST, dialogue, said
from vrts.lang.dialect import VAL2_PLUS
from vrts.lang.vocabulary.commands import COMMANDS
from vrts.monitor.completion import completions
from vrts.monitor.monitor import HANDLERS

PIECES = st.sampled_from(
    [
        *COMMANDS,
        *(word.usage for word in COMMANDS.values()),
        *("main", "main, 2", "= old", "a[1]", "#p", "$s", "a:b", "1/0", "(", '"', ",", "=", "^H"),
        *("Y", "R", "E", "I", "T p", "D 9", "S 2", "M /a/b", ",,1", "MOVE a", "READY", ";@ 1"),
    ]
)
LINES = st.lists(
    st.one_of(st.lists(PIECES, max_size=3).map(" ".join), st.text(max_size=20)), max_size=12
)


@settings(max_examples=examples(60), deadline=None)
@given(LINES)
def test_no_line_makes_the_monitor_fail(lines: list[str]) -> None:
    with TemporaryDirectory() as folder:
        found = dialogue(Path(folder), dialect=VAL2_PLUS)
        for line in lines:
            found.enter(line)
            assert isinstance(found.prompt, str)
            if found.monitor.at_commands:
                found.settle(5.0)
        for _ in range(4):
            found.interrupt()
        assert found.monitor.at_commands


def test_every_command_of_the_vocabulary_is_carried_out_or_known_as_opaque() -> None:
    carried_out = {word.text for word in COMMANDS.values() if not word.opaque}
    assert carried_out == HANDLERS.keys()


def test_expressions_are_worked_out_beside_the_run(tmp_path: Path) -> None:
    found = dialogue(tmp_path)
    said(found, "DO n = 1")
    events = found.controller.run.events
    assert said(found, "LISTR n+1, RANDOM*0") == "n+1       2\nRANDOM*0  0\n"
    assert found.controller.run.events == events
    assert "monitor.answer" not in found.state.variables
    assert found.state.robot is not None  # which the fork could have spoilt


def test_expressions_are_worked_out_at_once_while_a_program_executes(tmp_path: Path) -> None:
    found = dialogue(tmp_path)
    said(found, "EDIT main", "TIMER 1 = 0", "DELAY 5", "BREAK", "n = 7", "E")
    found.enter("EXECUTE main")
    found.advance(found.time_s + 2.0)
    seconds = float(found.enter("LISTR TIMER(1)").split()[-1])
    assert 1.9 < seconds < 2.2
    assert found.settle(LONGEST) == "Program completed\n"  # not disturbed
    assert found.state.variables["n"] == 7.0


def test_the_same_lines_do_the_same_twice(tmp_path: Path) -> None:
    lines = ("DO n = 2", "HERE p", "", "EDIT main", "MOVE p", "TYPE n", "E", "EXECUTE main", "IO")
    first, second = dialogue(tmp_path), dialogue(tmp_path)
    assert said(first, *lines) == said(second, *lines)
    assert first.state.variables == second.state.variables


def test_going_back_in_time_goes_on_from_there(tmp_path: Path) -> None:
    found = dialogue(tmp_path)
    said(found, "DO n = 1")
    then = found.time_s
    said(found, "DO n = 2", "DO m = 3")
    found.truncate(then)
    assert said(found, "LISTR") == "n         1\n"


def test_a_program_that_is_executed_is_not_deleted_or_edited(tmp_path: Path) -> None:
    found = dialogue(tmp_path, asks=False)
    said(found, "EDIT sub", "DELAY 5", "BREAK", "E", "EDIT main", "CALL sub", "E")
    found.enter("EXECUTE main")
    found.advance(1.0)
    for line in ("EDIT main", "EDIT sub", "DELETEP sub", "ZERO", "RENAME a = main"):
        assert found.enter(line).startswith("*Illegal when program executing*")
    found.advance(10.0)
    assert found.enter("DELETEP sub") == ""


def test_control_c_stops_what_executes_and_leaves_questions(tmp_path: Path) -> None:
    found = dialogue(tmp_path)
    said(found, "EDIT main", "DELAY 5", "BREAK", "E")
    found.enter("EXECUTE main")
    found.advance(1.0)
    shown = found.interrupt() + found.settle(9.0)
    assert shown == "(ABORTED)\nProgram stopped at main, step 2\n"
    found.enter("ZERO")
    assert found.prompt == "Are you sure (Y/N)? "
    assert found.interrupt() == ""
    assert found.prompt == "."
    assert "main" in said(found, "DIRECTORY")


def test_completion_knows_commands_programs_names_and_files(tmp_path: Path) -> None:
    (tmp_path / "cell.v2").write_text("")
    found = dialogue(tmp_path)
    said(found, "EDIT pick", "READY", "E", "DO count = 1", 'DO $msg = "x"')
    desk, state = found.monitor.desk, found.state

    def after(line: str) -> list[str]:
        return completions(line, desk, state)

    assert after("lis") == ["LISTF", "LISTL", "LISTP", "LISTR", "LISTS"]
    assert after("EXECUTE p") == ["pick"]
    assert after("LISTR co") == ["count"]
    assert after("LISTS $") == after("LISTS $m") == ["$msg"]
    assert after("LOAD c") == ["cell.v2"]
    assert after("DO MOVE") == ["MOVE", "MOVES", "MOVEST", "MOVET"]
    assert after("DO CALL p") == ["pick"]
