"""URScript as an interpreter from excerpts of UR's manual carries it out, beside the run."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.oracle.urscript.drawn import AUTO, drawn
from tests.oracle.urscript.interpreter import Motion, Robot
from tests.oracle.urscript.poses import Matrix, Pose, nearest
from tests.oracle.urscript.values import NotTaken
from tests.support_commands import vrts_text
from tests.support_programs import ROOT
from vrts.base.source import SourceFile
from vrts.base.units import MM
from vrts.dispatch.saying.table import read_table
from vrts.dispatch.urscript.export import Folder, exported_script
from vrts.dispatch.verified import Verified, verified
from vrts.engine.memory.events import Printed, SignalChanged
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scenario
from vrts.scene.planned import ScenarioFile

CLOSE_MM = 1e-3
PLACES = """.LOCATIONS
can1_grip         450.00  -150.00   -40.00    90.00    90.00     0.00
base1_put         480.00   250.00    20.00    90.00    90.00     0.00
safe              460.00    50.00   200.00    90.00    90.00     0.00
turn1              30.00    20.00    10.00    90.00   -80.00     5.00
.END
"""
CARRY = """.PROGRAM main
SPEED 60 ALWAYS
OPENI
MOVE safe
CALL carry(can1_grip, base1_put, 120)
MOVE safe
TYPE "done"
.END
.PROGRAM carry(start, goal, up)
APPRO start, up
SPEED 200 MMPS
MOVES start
CLOSEI
DEPARTS up
APPRO goal, up
SPEED 30
MOVES goal
OPENI
DEPARTS up
.END
"""
DECIDES = """.PROGRAM main
SIGNAL -1, 2
x = 0
FOR i = 1 TO 3
IF SIG(1001) AND (i <> 2) THEN
SET p = SHIFT(safe BY 10*i, -5, 0)
MOVE p
BREAK
SIGNAL 1
ELSE
MOVE safe:turn1
MOVES safe
BREAK
SIGNAL -1, 2001
END
x = x + i
END
CASE x OF
VALUE 6, 7:
DRAW 0, 20, -15
ANY
READY
END
WHILE x > 4 DO
DEPART 5
x = x - 1
END
DO
MOVES safe:TRANS(x, 0, 0, 90, -90, 10)
x = x - 2
UNTIL x < 0
BREAK
SET p = HERE
IF (DX(p) > 400) AND SIG(2001, -1001) THEN
MOVES p:INVERSE(turn1)
END
MOVE #j
BREAK
WAIT SIG(-1002)
SET p = HERE
MOVE p:turn1
TOOL TRANS(0, 0, 100, 90, -90, 0)
MOVES safe
MOVE NULL:safe
BREAK
SIGNAL -2
.END
"""
JOINTS = "#j 10 -80 95 -100 -85 5\n"


def _found(
    text: str,
    on: bool = False,
    table: str | None = None,
    inputs: Mapping[int, bool] | None = None,
    dialect: str = "val2",
) -> tuple[Folder, Run]:
    place = Path("prog.v2")
    setting = setting_for(place, Where("one-can-ur5"))
    assert setting is not None
    given = {1001: on} if inputs is None else inputs
    scenario = Scenario(inputs=tuple((0.0, signal, state) for signal, state in given.items()))
    setting = replace(setting, scenario=ScenarioFile("inputs", scenario, ""))
    reading = Reading(dialect)
    request = Request(ProgramFile(text.encode(), place.name), setting, reading)
    found = verified(request)
    assert isinstance(found, Verified), found
    source = None if table is None else SourceFile("io.toml", table)
    return exported_script(request, source), found.run


def _flange(run: Run) -> Callable[[Pose], Matrix]:
    """Return where the flange is in UR's base frame, which is opposed to the scene's."""
    arm = run.scene.robot.arm
    opposed = np.diag([-1.0, -1.0, 1.0, 1.0])

    def flange(joints: Pose) -> Matrix:
        pose = forward(arm, tuple(joints))  # type: ignore[arg-type]
        made = np.eye(4)
        made[:3, :3] = np.reshape(pose.rotation, (3, 3))
        made[:3, 3] = pose.translation
        return opposed @ made

    return flange


def _done(text: str, run: Run, on: Callable[[int], bool] | bool) -> list[Any]:
    """Return what the interpreter does."""

    def looked_at(pin: int) -> bool:
        return on(pin) if callable(on) else on and pin == 0

    return Robot(_flange(run), run.scene.robot.arm.ready, looked_at).run(text)


def _same(text: str, run: Run, on: bool, *, rounded: bool = True) -> None:
    _same_motions(_done(text, run, on), run, rounded=rounded)


def _same_motions(
    done: list[Any], run: Run, *, rounded: bool = True, turned_by: float = 1e-6
) -> None:
    moved = [item for item in done if isinstance(item, Motion)]
    assert len(moved) == len(run.motions) > 0
    arm = run.scene.robot.arm
    for motion, wanted in zip(moved, run.motions, strict=True):
        linear = wanted.interpolation is Interpolation.LINEAR
        assert motion.word == ("movel" if linear else "movej")
        went = wanted.X_WT @ wanted.X_FT.inverse()
        x, y, z = went.translation
        assert np.abs(motion.flange[:3, 3] - np.array([-x, -y, z])).max() < CLOSE_MM * MM
        turned = np.diag([-1.0, -1.0, 1.0]) @ np.reshape(went.rotation, (3, 3))
        assert np.abs(motion.flange[:3, :3] - turned).max() < turned_by
        full = arm.linear_speed if linear else min(arm.speed)
        assert motion.v == pytest.approx(wanted.speed_fraction * full)
        assert motion.a == pytest.approx(motion.v / arm.acceleration_time)
        assert not rounded or (motion.r > 0.0) <= wanted.blended


LINES_TURN = 1e-5  # lines of a serial arm are solved step by step, and end within this [rad]


def _joints_alike(done: list[Any], run: Run) -> None:
    """UR takes the joints nearest to where the arm stands: those that the run took."""
    flange = _flange(run)
    moved = [item for item in done if isinstance(item, Motion)]
    stands = np.array(run.scene.robot.arm.ready)
    for motion, wanted in zip(moved, run.motions, strict=True):
        found = nearest(flange, motion.flange, stands)
        assert np.abs(found - np.array(wanted.goal)).max() < 1e-4, wanted.cause.span.text
        stands = np.array(wanted.goal)


TICK = 0.028  # [s] VAL-II looks at its steps at ticks, so each wait may take one more
AT_REST = 3 * TICK  # that VAL-II waits at a stop; an output of a motion under way comes at once


def _told_alike(done: list[Any], run: Run, pins: dict[int, int]) -> None:
    """Outputs come in the same order and at the same times, reckoned from the motion before."""
    outside = [e for e in run.events if isinstance(e, SignalChanged) and e.signal in pins]
    now, moved, waits, seen = 0.0, 0, 0, dict.fromkeys(pins.values(), False)
    found: list[tuple[float, int, int, bool]] = []
    for item in done:
        if isinstance(item, Motion):
            now, moved, waits = run.motions[moved].end_s, moved + 1, 0
        elif item[0] == "sleep":
            now, waits = now + item[1], waits + 1
        elif item[0] == "out" and item[1] in seen and seen[item[1]] != item[2]:
            seen[item[1]] = item[2]
            found.append((now, waits, item[1], item[2]))
    assert [(pin, on) for *_, pin, on in found] == [(pins[e.signal], e.on) for e in outside]
    for (at, waits, *_), event in zip(found, outside, strict=True):
        assert -1e-6 <= event.time_s - at <= AT_REST + TICK * waits + 1e-6, event


def _outputs(text: str, run: Run, on: bool) -> list[tuple[int, bool]]:
    return [(item[1], item[2]) for item in _done(text, run, on) if item[0] == "out"]


def test_a_can_is_carried_where_the_run_carried_it() -> None:
    folder, run = _found(CARRY + PLACES)
    assert folder.files is not None, folder.diagnostics
    text = folder.files["program.script"].decode()
    _same(text, run, on=False)
    _joints_alike(_done(text, run, on=False), run)
    hand = [(1, False), (0, True), (0, False), (1, True), (1, False), (0, True)]
    assert sorted(_outputs(text, run, on=False)) == sorted(hand)
    assert "def prog_carry(own_start, own_goal, own_up):" in text
    assert text.count("prog_carry(") == 2
    assert ("text", "done") in _done(text, run, on=False)
    assert any(isinstance(m, Motion) and m.r > 0.0 for m in _done(text, run, on=False))


@pytest.mark.parametrize(
    "on", [False, pytest.param(True, marks=pytest.mark.thorough)], ids=["off", "on"]
)
def test_both_ways_of_decisions_lead_where_the_run_went(on: bool) -> None:
    text = DECIDES + PLACES.replace(".END", JOINTS + ".END")
    folder, run = _found(text, on)
    assert folder.files is not None, folder.diagnostics
    script = folder.files["program.script"].decode()
    _same(script, run, on)
    first = [(0, False), (1, True)]  # the table begins with outputs 2 and 3
    loop = [(0, True), (0, False), (0, True)] if on else [(0, False)] * 3
    wanted = [(pin + 2, state) for pin, state in (*first, *loop, (1, False))]
    assert _outputs(script, run, on) == wanted
    other, _ = _found(text, not on)
    assert other.files is not None
    _same(other.files["program.script"].decode(), run, on, rounded=False)


@pytest.mark.parametrize(
    ("steps", "headline"),
    [
        ("IF x THEN\nMOVE safe\nEND\nSIGNAL 1", "the arm may still move when this looks"),
        ("MOVE safe\nIF SIG(1001) THEN\nMOVES safe\nEND", "the arm may still move when"),
        ("BASE 0,0,0,0\nMOVE safe", "URScript has nothing that means BASE"),
        ("SET #q[1] = #PPOINT(0,-90,90,0,0,0)\nMOVE #q[1]", "URScript reads a list of joints"),
        ("CALL two(x)", "`x` is passed to `two`, which changes it too"),
        ("REACTI 1001, halt1\nMOVE safe", "URScript has nothing that means REACT"),
        ("TIMER(1) = 0\nMOVE safe", "URScript has nothing that means"),
    ],
)
def test_what_ur_cannot_do_is_refused_with_the_line(steps: str, headline: str) -> None:
    steps = steps.replace("TIMER(1) = 0", "DRIVE 1, 5, 50")
    more = ".PROGRAM halt1\nHALT\n.END\n.PROGRAM two(n)\nn = 1\nx = 2\n.END\n"
    text = f".PROGRAM main\nx = 1\n{steps}\n.END\n{more}{PLACES}"
    folder, _ = _found(text)
    assert folder.files is None
    found = [d for d in folder.diagnostics if d.is_error]
    assert found[0].rule.code == "V877"
    assert found[0].headline.startswith(headline)
    assert found[0].primary is not None
    assert found[0].primary.span.text in steps


def test_the_table_says_which_pin_is_which_signal() -> None:
    table = "[hand]\nopen = 6\nclose = 7\n[inputs]\n1001 = 4\n[outputs]\n1 = 5\n"
    steps = ".PROGRAM main\nSIGNAL 1\nIF SIG(1001) THEN\nMOVE safe\nEND\nMOVE safe\n.END\n"
    folder, _ = _found(steps + PLACES, table=table)
    assert folder.files is not None
    text = folder.files["program.script"].decode()
    assert "set_standard_digital_out(5, True)" in text
    assert "if (get_standard_digital_in(4)):" in text
    assert read_table(SourceFile("io.toml", folder.files["io.toml"].decode())).hand_open == 6
    folder, _ = _found(steps + PLACES, table=table.replace("= 4", "= 9"))
    assert [d.rule.code for d in folder.diagnostics if d.is_error] == ["V878"]


def test_the_interpreter_refuses_what_the_manual_does_not_have() -> None:
    robot = Robot(lambda _: np.eye(4), (0.0,) * 6, lambda _: False)
    for text, why in (
        ("def p():\n  movej(p[0,0,0,0,0])\nend\n", "six numbers"),
        ("def p():\n  x = y\nend\n", "has no value"),
        ("def p():\n  if 1:\n    sync()\n  end\nend\n", "True or False"),
        ("def p():\n  while True:\n    sync()\nend\n", "`end` is missing"),
        ("def p():\n  MOVE(3)\nend\n", "no function"),
        ("def p():\n  x = 1 + True\nend\n", "no numbers"),
        ("def p():\n  movel(p[0,0,0,0,0,0], z=3)\nend\n", "a, v, t, r"),
        ("def p():\n  if x == 1\nend\n", "`:` is missing"),
    ):
        with pytest.raises(NotTaken, match=why):
            robot.run(text)
    for place in (ROOT / "tests" / "oracle" / "urscript").glob("*.py"):
        assert "from vrts" not in place.read_text(encoding="utf-8")


def test_the_command_writes_a_folder_and_refuses_other_arms(tmp_path: Path) -> None:
    place = tmp_path / "prog.v2"
    place.write_text(CARRY + PLACES)
    call = ("dispatch", "export", place, "--to", "urscript", "-o", tmp_path / "out", "--scene")
    done = vrts_text(*call, "one-can-ur5")
    assert done.returncode == 0, done.stderr
    assert "not tried on a controller" in done.stderr
    assert "**Not tried on a controller.**" in (tmp_path / "out" / "sheet.md").read_text()
    place.write_text(".PROGRAM main\nREADY\n.END\n")
    done = vrts_text(*call, "one-can-puma560")
    assert done.returncode == 1
    assert "V878" in done.stderr


def test_a_program_has_variables_of_its_own_wherever_it_is_called() -> None:
    folder, run = _found(AUTO, dialect="vplus")
    assert folder.files is not None, folder.diagnostics
    script = folder.files["program.script"].decode()
    _same(script, run, on=False)
    shown = [e.text.split() for e in run.events if isinstance(e, Printed)]
    told = [item[1] for item in _done(script, run, on=False) if item[0] == "text"]
    assert told == [float(word) for row in shown for word in row] == [61.0, 3.0]
    folder, _ = _found(
        AUTO.replace("x = 1\n", "x = 1\nIF n > 9 THEN\nCALL main\nEND\n"), dialect="vplus"
    )
    assert [d.rule.code for d in folder.diagnostics if d.is_error] == ["V877"]


PARTS = [
    pytest.param(k, marks=(pytest.mark.thorough,) if k > 0 else (), id=f"{10 * k}")
    for k in range(8)
]


@pytest.mark.parametrize("part", PARTS)
def test_programs_drawn_by_chance_do_the_same(part: int) -> None:
    """Motions, outputs with their times, what is typed, and both ways of decisions."""
    written = 0
    for number in range(10 * part, 10 * part + (10 if part else 2)):
        for ways in (0, 3):
            inputs = {1001: bool(ways & 1), 1002: bool(ways & 2), 1003: True}
            folder, run = _found(drawn(number), inputs=inputs)
            assert folder.files is not None, (number, folder.diagnostics)
            table = read_table(SourceFile("io.toml", folder.files["io.toml"].decode()))
            on = {pin for signal, pin in table.inputs.items() if inputs[signal]}
            text = folder.files["program.script"].decode()
            done = _done(text, run, lambda pin, on=on: pin in on)
            _same_motions(done, run, turned_by=LINES_TURN)
            _told_alike(done, run, table.outputs)
            _joints_alike(done, run)
            printed = [e.text.split() for e in run.events if isinstance(e, Printed)]
            told = [item[1] for item in done if item[0] == "text"]
            assert len(told) == sum(map(len, printed))
            for word, shown in zip(told, (w for row in printed for w in row), strict=True):
                assert word == shown or word == pytest.approx(float(shown), rel=1e-4, abs=6e-3)
            written += 1
    assert written >= 4
