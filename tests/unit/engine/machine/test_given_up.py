"""What a run tells of a single instruction whose motion is given up on the way."""

from vrts.base.source import SourceFile
from vrts.engine.controller import advance, start
from vrts.engine.memory.events import ProgramEnded, ProgramStarted
from vrts.engine.run import Run
from vrts.ir.commands import Do, Execute, Panic, TimedCommand
from vrts.ir.module import Module
from vrts.lang.compiler import compile_source
from vrts.pipeline.scenes import load_scene


def compiled(text: str) -> Module:
    module = compile_source(SourceFile("given", text)).module
    assert module is not None
    return module


def test_the_end_that_never_comes_is_not_told() -> None:
    wait = compiled(".PROGRAM wait()\n DELAY 20\n.END\n")
    far = compiled(".PROGRAM far()\n DRIVE 1,90,10\n.END\n")
    commands = [
        TimedCommand(0.0, Do(far)),
        TimedCommand(1.0, Panic()),
        TimedCommand(2.0, Execute("wait")),
    ]
    run = advance(start(wait, load_scene("cans-on-bases").scene), 15.0, commands)
    assert spells(run) == [("far", 0.0), ("wait", 2.0)]
    robot = run.at(14.0).robot
    assert robot is not None
    assert (robot.program, robot.status.value) == ("wait", "waiting")


def spells(run: Run) -> list[tuple[str, float]]:
    found: list[tuple[str, float]] = []
    for event in run.events:
        if isinstance(event, ProgramStarted):
            found.append((event.program, round(event.time_s, 1)))
        elif isinstance(event, ProgramEnded):
            found.append(("", event.time_s))
    return found
