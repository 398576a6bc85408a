"""What nothing can reach any more is let go: motions, commands, code, knots of the speed."""

from collections.abc import Iterator

import pytest

from tests.unit.live.session.growing.test_growing_run import SCENE
from vrts.base.source import SourceFile
from vrts.engine.machine.forget import forget
from vrts.engine.memory.numbered import Numbered
from vrts.engine.run import Run
from vrts.ir.commands import Command, Do, Load, MonitorSpeed, Panic
from vrts.ir.module import Module
from vrts.lang.compiler import compile_source
from vrts.live.session.growing.growing_run import GrowingRun
from vrts.scene.model import Scenario

TWICE = ".PROGRAM main()\n CALL sub(1)\n.END\n.PROGRAM sub(x)\n TYPE x\n DRIVE 1,5,100\n.END\n"


def module(text: str) -> Module:
    found = compile_source(SourceFile("text", text)).module
    assert found is not None
    return found


def commands() -> Iterator[Command]:
    """Yield what somebody types at a monitor, programs of several lengths."""
    yield Load(module(TWICE))
    for k in range(200):
        way = 5 if k % 2 else -5
        lines = [f"DRIVE 1,{way},100", f"SIGNAL {1 - 2 * (k % 2)}", "a = 1", "b = a"][: 1 + k % 4]
        program = ".PROGRAM alone()\n" + "".join(f" {line}\n" for line in lines) + ".END\n"
        yield Do(Module({"alone": module(program).programs["alone"]}, ()))
        if k % 10 == 4:
            yield Panic()
        if k % 10 == 9:
            yield MonitorSpeed(50.0 + k % 50)


def grown(forgetting_s: float | None) -> GrowingRun:
    growing = GrowingRun(SCENE, Scenario(), forgets=False)
    for k, command in enumerate(commands()):
        growing.issue(command)
        growing.advance(growing.time_s + 0.37)
        if forgetting_s is not None and k % 20 == 19:
            before = max(growing.time_s - forgetting_s, 0.0)
            forget([growing.machine], before)
            growing.drop_run()
    return growing


def told(run: Run, time_s: float) -> list[object]:
    state = run.at(time_s)
    motion = run.motion_begun(time_s)
    return [
        state.configuration,
        state.velocity,
        state.signals,
        state.monitor_speed,
        state.program_speed,
        state.X_WT,
        state.robot and (state.robot.program, state.robot.status),
        [(cause.program, cause.step, cause.span.text) for cause in state.call_stack],
        motion and (motion.start_s, motion.end_s, motion.goal, motion.cut, motion.cause.span.text),
    ]


def test_what_is_left_answers_as_if_nothing_was_forgotten() -> None:
    whole, short = grown(None), grown(5.0)
    now_s = whole.time_s
    for k in range(150):
        time_s = now_s - 4.9 * k / 149
        assert told(short.run, time_s) == told(whole.run, time_s)
    after = [motion for motion in whole.run.motions if motion.start_s > now_s - 4.9]
    assert [m.goal for m in short.run.motions][-len(after) :] == [m.goal for m in after]
    segments = [s for s in short.run.timeline.segments if s.motion is not None]
    assert all(short.run.motions[s.motion].end_s >= s.end_s - 1e-6 for s in segments)  # type: ignore[index]


def test_what_is_kept_has_an_end() -> None:
    whole, short = grown(None).machine, grown(5.0).machine
    assert len(whole.issued) > 200
    assert len(short.issued) < 40
    assert len(whole.system.programs.loaded) > 150
    assert len(short.system.programs.loaded) < 50
    assert len(short.system.programs.causes) < 150
    motions = short.system.planner.given.motions
    assert len(list(motions)) < 40 < len(motions)
    assert len(short.system.planner.scale.knots) < len(whole.system.planner.scale.knots) / 3


def test_code_that_something_can_reach_stays() -> None:
    growing = GrowingRun(SCENE, Scenario())
    growing.issue(Load(module(TWICE)))
    growing.advance(1.0)
    executable = growing.machine.executable
    assert executable.only(()) is executable, "what is in memory can be executed"
    without = executable.without(("main",))
    numbers = without.programs.numbers["sub"], executable.programs.numbers["main"]
    left = without.only(())
    assert left.programs.loaded[numbers[0]].program.name == "sub"
    assert not left.steps[numbers[1]]
    assert without.only(numbers).programs.loaded[numbers[1]].program.name == "main"


def test_a_list_keeps_the_numbers_of_what_is_left() -> None:
    numbered = Numbered("abcde")
    copy = numbered.copy()
    numbered.forget(2)
    assert len(numbered) == 5
    assert list(numbered) == ["c", "d", "e"]
    assert (numbered[2], numbered[-1], numbered[3:]) == ("c", "e", ["d", "e"])
    assert list(reversed(numbered)) == ["e", "d", "c"]
    with pytest.raises(IndexError):
        numbered[1]
    numbered.append("f")
    numbered[5] = "g"
    assert numbered.pop() == "g"
    assert list(copy) == list("abcde")
