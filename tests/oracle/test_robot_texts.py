"""Second readers of AS and V+: every text is taken, and leads where the run went."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.oracle.robot_texts.carrying_out import LINEAR, targets
from tests.oracle.robot_texts.expressions import NotTaken
from tests.oracle.robot_texts.frames import Frame
from tests.oracle.robot_texts.reading import read
from tests.oracle.urscript.drawn import AUTO
from tests.oracle.urscript.drawn import drawn as calling
from tests.support_programs import ROOT
from tests.unit.dispatch.posts.test_posts import HOLDS
from tests.whole_programs.drawing import drawn
from vrts.base.source import SourceFile
from vrts.base.units import MM
from vrts.dispatch.posts.export import exported
from vrts.dispatch.posts.written import written
from vrts.dispatch.verified import Verified, verified
from vrts.engine.run import Run
from vrts.ir.instructions import Interpolation
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.request import Request
from vrts.pipeline.settings import setting_for
from vrts.pipeline.where import Where
from vrts.robots.arms.primitives import degrees
from vrts.robots.kinematics.kinematics import forward
from vrts.scene.model import Scenario
from vrts.scene.planned import ScenarioFile

LANGUAGES = ("as", "vplus")
PROGRAMS = [
    *sorted((ROOT / "examples").glob("*/solution.v2")),
    *sorted((ROOT / "tests" / "data" / "linuxcnc").glob("*/*.v2")),
]
SOLUTIONS = [
    pytest.param(place, id=place.parent.name, marks=(pytest.mark.thorough,) if k > 0 else ())
    for k, place in enumerate(PROGRAMS)
]
CLOSE_MM = 1e-3
TURNED = 2e-6  # of the rotation's elements: angles have four decimals in the text


@pytest.mark.parametrize("place", SOLUTIONS)
def test_every_text_leads_where_the_run_went(place: Path) -> None:
    setting = setting_for(place)
    assert setting is not None
    request = Request(ProgramFile(place.read_bytes(), place.name), setting)
    found = verified(request)
    assert isinstance(found, Verified)
    for language in LANGUAGES:
        told = exported(request, language)
        assert told.text is not None, told.diagnostics
        if "IF TIMER(" in told.text:  # the second reader has no clock
            read(told.text, language)
        else:
            _same_targets(told.text, language, found.entry, found.run)


def _same_targets(
    text: str, language: str, entry: str, run: Run, turned_by: float = TURNED
) -> None:
    arm = run.scene.robot.arm
    first = {number: on for time, number, on in run.scenario.inputs if time == 0.0}

    def flange(joints: tuple[float, ...]) -> Frame:
        pose = forward(arm, degrees(*joints))
        made = np.eye(4)
        made[:3, :3] = np.reshape(pose.rotation, (3, 3))
        made[:3, 3] = np.array(pose.translation) / MM
        return made

    moved = targets(text, language, entry, flange, lambda number: first.get(number, False))
    wanted = [m for m in run.motions if m.end_s > m.start_s]
    assert len(moved) == len(run.motions)
    assert wanted
    for (word, pose), motion in zip(moved, run.motions, strict=True):
        assert (word in LINEAR) == (motion.interpolation is Interpolation.LINEAR)
        went = motion.X_WT @ motion.X_FT.inverse()
        assert np.abs(pose[:3, 3] - np.array(went.translation) / MM).max() < CLOSE_MM, word
        turned = np.reshape(went.rotation, (3, 3))
        assert np.abs(pose[:3, :3] - turned).max() < turned_by, word


FEW = [
    pytest.param(k, marks=(pytest.mark.thorough,) if k > 0 else (), id=f"{25 * k}")
    for k in range(28)
]


@pytest.mark.parametrize("part", FEW)
def test_texts_of_programs_drawn_by_chance_are_taken(part: int) -> None:
    """Whatever a post writes of them; steps that it refuses are taken out first."""
    taken = 0
    for number in range(25 * part, 25 * part + (25 if part else 5)):
        given = drawn(number)
        if given.dialect not in ("val2", "vplus"):
            continue
        for language in LANGUAGES:
            text = _written(given.text, given.dialect, language)
            if text is not None:
                read(text, language)
                taken += 1
    assert taken > 0


def _written(text: str, dialect: str, language: str) -> str | None:
    for _ in range(8):
        compilation = compile_source(SourceFile("main.v2", text), Options(DIALECTS[dialect]))
        if compilation.module is None:
            wrong = [d for d in compilation.diagnostics if d.is_error]
        else:
            found = written(compilation, language, HOLDS)
            wrong = [d for d in found.diagnostics if d.is_error]
            if not wrong:
                return found.text
        lines = {d.primary.span.line for d in wrong if d.primary is not None}
        text = "\n".join(
            row
            for k, row in enumerate(text.split("\n"), 1)
            if k not in lines or row.startswith(".")
        )
    return None


FOLLOWED = [
    pytest.param(k, marks=(pytest.mark.thorough,) if k > 0 else (), id=f"{4 * k}") for k in range(4)
]
LINES_TURN = 1e-5  # lines of a serial arm are solved step by step, and end within this [rad]


@pytest.mark.thorough
@pytest.mark.parametrize("part", FOLLOWED)
def test_programs_drawn_by_chance_lead_where_the_run_went(part: int) -> None:
    """Whole programs with calls, loops, jumps and inputs, in both ways of their decisions."""
    base = setting_for(Path("prog.v2"), Where("one-can-ur5"))
    assert base is not None
    for number in range(4 * part, 4 * part + (4 if part else 1)):
        text = calling(number).replace("SIGN(", "ABS(")  # AS has none
        for on in (False, True):
            scenario = Scenario(inputs=((0.0, 1001, on), (0.0, 1002, on), (0.0, 1003, True)))
            setting = replace(base, scenario=ScenarioFile("inputs", scenario, ""))
            request = Request(ProgramFile(text.encode(), "prog.v2"), setting)
            found = verified(request)
            assert isinstance(found, Verified)
            for language in LANGUAGES:
                told = exported(request, language)
                assert told.text is not None, told.diagnostics
                _same_targets(told.text, language, found.entry, found.run, LINES_TURN)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_program_called_from_two_places_has_variables_of_its_own_each_time(language: str) -> None:
    setting = setting_for(Path("prog.v2"), Where("one-can-ur5"))
    assert setting is not None
    request = Request(ProgramFile(AUTO.encode(), "prog.v2"), setting, Reading("vplus"))
    found, told = verified(request), exported(request, language)
    assert isinstance(found, Verified)
    assert told.text is not None, told.diagnostics
    assert len(found.run.motions) == 9
    _same_targets(told.text, language, found.entry, found.run)


WRONG = [
    ("as", "MOVE a", "no instruction MOVE"),
    ("as", "LMOVE 5", "a location is wanted"),
    ("as", "JAPPRO a", "an operand is missing"),
    ("as", "TOOL TRANS(0,0,150,0,0,0)", "the name of a location is wanted"),
    ("as", "BASE -TRANS(1,0,0,0,0,0)", "the name of a location is wanted"),
    ("as", "y = x**2", "nothing may follow"),
    ("as", "ENABLE CP", "no instruction ENABLE"),
    ("as", "POINT c = a:b", "nothing may follow"),
    ("as", "CALL sub(#p)", "passed without &"),
    ("as", "c = TRANS(1,2,3)", "without POINT"),
    ("as", "READY", "no instruction READY"),
    ("as", "SPEED 20 MMPS", "nothing may follow"),
    ("as", "RETURN 1", "nothing may follow"),
    ("as", "CASE x OF\nANY", "is missing"),
    ("as", "WAIT", "an operand is missing"),
    ("as", 'HALT "over"', "nothing may follow"),
    ("as", "IFSIG 1001 THEN 10", "no instruction IFSIG"),
    ("vplus", 'STOP "over"', "nothing may follow"),
    ("vplus", "LMOVE a", "no instruction LMOVE"),
    ("vplus", "PCEXECUTE two", "EXECUTE"),
    ("vplus", "EXECUTE two()", "the number of a task"),
    ("vplus", "EXECUTE 1 two(), 2, 1, 1, 1", "cycles, a step and a priority"),
    ("as", "EXECUTE 1 two()", "PCEXECUTE"),
    ("vplus", "GRASP 20, 10", "no instruction GRASP"),
    ("vplus", "DRAW 1,2,3", "no instruction DRAW"),
    ("vplus", "WHILE x > 2", "DO is missing"),
    ("vplus", "MOVES SHIFT(a, 1, 2)", "BY is missing"),
    ("vplus", 'x = "a"', "a string is given"),
]


@pytest.mark.parametrize(("language", "step", "why"), WRONG)
def test_what_the_manuals_do_not_list_is_refused(language: str, step: str, why: str) -> None:
    with pytest.raises(NotTaken, match=f"line [23]: .*{why}"):
        read(f".PROGRAM main()\n{step}\n.END\n", language)


BESIDE = """.PROGRAM main
PCEXECUTE blink, 3
MOVE a
DELAY 2
MOVES a:TRANS(0,0,-20)
.END
.PROGRAM blink
SIGNAL 1
TIMER 1 = 0
WAIT TIMER(1) > 0.5
SIGNAL -1
.END
.LOCATIONS
a 460 -30 0 90 90 0
.END
"""


def test_a_second_program_is_a_task_in_vplus() -> None:
    setting = setting_for(Path("beside.v2"), Where("one-can-puma560"))
    assert setting is not None
    request = Request(ProgramFile(BESIDE.encode(), "beside.v2"), setting)
    found = verified(request)
    assert isinstance(found, Verified)
    for language, step in (("vplus", "EXECUTE 1 blink(), 3"), ("as", "PCEXECUTE blink, 3")):
        told = exported(request, language)
        assert told.text is not None, told.diagnostics
        assert f" {step}\n" in told.text
        _same_targets(told.text, language, found.entry, found.run)
    back = exported(request._replace(program=_as_vplus(request), reading=Reading("vplus")), "val2")
    assert back.text is not None, back.diagnostics
    assert " PCEXECUTE blink, 3\n" in back.text
    text = BESIDE.replace("DELAY 2", "PCEND")
    other = request._replace(program=ProgramFile(text.encode(), "beside.v2"))
    refused = exported(other, "vplus")
    assert [d.headline for d in refused.diagnostics if d.is_error] == [
        "V+ has nothing that means PCEND"
    ]


def _as_vplus(request: Request) -> ProgramFile:
    told = exported(request, "vplus")
    assert told.text is not None
    return ProgramFile(told.text.encode(), "beside-vplus.v2")


def test_the_second_reader_knows_nothing_of_vrts() -> None:
    for place in (ROOT / "tests" / "oracle" / "robot_texts").glob("*.py"):
        for row in place.read_text(encoding="utf-8").split("\n"):
            assert not row.lstrip().startswith(("import vrts", "from vrts")), place.name


def test_data_and_formals_of_as_are_read_strictly() -> None:
    for text, why in (
        (".REALS\nx 3\n.END\n", "= is missing"),
        (".TRANS\na 1 2 3\n.END\n", "6 values"),
        (".LOCATIONS\na 1 2 3 4 5 6\n.END\n", "no section"),
        (".PROGRAM main(n)\n.END\n", "begins with a dot"),
    ):
        with pytest.raises(NotTaken, match=why):
            read(text, "as")


def test_a_text_without_tool_leads_elsewhere() -> None:
    place = PROGRAMS[0]
    setting = setting_for(place)
    assert setting is not None
    request = Request(ProgramFile(place.read_bytes(), place.name), setting)
    found, told = verified(request), exported(request, "as")
    assert isinstance(found, Verified)
    assert told.text is not None
    cut = "\n".join(row for row in told.text.split("\n") if row.split()[:1] != ["TOOL"])
    with pytest.raises(AssertionError):
        _same_targets(cut, "as", found.entry, found.run)
