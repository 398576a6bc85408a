"""Runs the execution chapters of this folder: `run-*.md`.

A ```val2 block, or one named after another dialect, is compiled and run with the robot alone, or
with another one (```val2 on puma560). A program without `.PROGRAM` is wrapped in one. What follows
it belongs to it:

- ```scenario is what happens to it from outside, as in a scenario file;
- ```command starts it in another way;
- ```output is what it types (a last line that is not ended counts as ended);
- ```error is the code and VAL's words of the errors found;
- ```events is all that happens, in order, with the time in seconds.

The locations a, b, c and d are known where a program uses them. The prose says why.
"""

import re
from pathlib import Path
from typing import NamedTuple

import pytest

from vrts.base.source import SourceFile
from vrts.engine.controller import advance, execute, start
from vrts.engine.memory.events import (
    Event,
    HandCommanded,
    MotionEnded,
    MotionStarted,
    Printed,
    ProgramEnded,
    ProgramStarted,
    Prompted,
    Reacted,
    SignalChanged,
    SwitchChanged,
)
from vrts.engine.run import Run
from vrts.ir.commands import TimedCommand
from vrts.ir.module import Module
from vrts.ir.system import PARAMETERS
from vrts.lang.compiler import Compilation, Options, compile_source
from vrts.lang.dialect import DIALECTS, Dialect
from vrts.lang.typed.execute_line import parse_command
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario
from vrts.scene.reading.scenario_file import read_scenario

FOLDER = Path(__file__).parent
BLOCK = re.compile(r"^```([\w+]+)(?: on (\w+))?\n(.*?)^```$", re.M | re.S)
PARTS = ("scenario", "command", "output", "error", "events")
PLACES = """.LOCATIONS
a 900 200 100 90 90 0
b 900 -200 100 90 90 0
c 900 0 300 90 90 0
d 900 0 100 90 90 0
.END
"""
ROBOT = "puma761"
USES_PLACE = re.compile(r"\b(?:MOVES?T?|APPROS?|SET \w+ =|DISTANCE\(HERE,) ?[abcd]\b")
LONG_ENOUGH = 60.0  # [s] for what a command starts


class Case(NamedTuple):
    """One program and what it is expected to do."""

    name: str
    dialect: Dialect
    robot: str
    program: str
    expected: dict[str, str]


def cases() -> list[Case]:
    found: list[Case] = []
    for page in sorted(FOLDER.glob("run-*.md")):
        text = page.read_text(encoding="utf-8")
        for block in BLOCK.finditer(text):
            line = text[: block.start()].count("\n") + 1
            if block[1] in DIALECTS:
                found.append(
                    Case(f"{page.stem}:{line}", DIALECTS[block[1]], block[2] or ROBOT, block[3], {})
                )
            else:
                assert block[1] in PARTS, block[1]
                found[-1].expected[block[1]] = block[3]
    return found


def compiled_case(case: Case) -> Compilation:
    text = case.program
    if ".PROGRAM" not in text:
        text = f".PROGRAM main()\n{text}.END\n"
    if USES_PLACE.search(text) and ".LOCATIONS" not in text:
        text += PLACES
    compilation = compile_source(SourceFile("case.v2", text), Options(case.dialect))
    assert compilation.module is not None, compilation.diagnostics
    return compilation


def ran(case: Case) -> Run:
    module = compiled_case(case).module
    assert module is not None
    return ran_module(case, module)


def ran_module(case: Case, module: Module) -> Run:
    scene = robot_alone(case.robot)
    scenario = Scenario()
    if "scenario" in case.expected:
        source = SourceFile("scenario.toml", case.expected["scenario"])
        found, problems = read_scenario(source, scene, PARAMETERS)
        assert found is not None, problems
        scenario = found.scenario
    if "command" not in case.expected:
        return execute(module, scene, scenario)
    command, _ = parse_command(SourceFile("monitor", case.expected["command"].strip()))
    assert command is not None
    return advance(start(module, scene, scenario), LONG_ENOUGH, [TimedCommand(0.0, command)])


def stopped_by(run: Run) -> str:
    """Return VAL's words for errors, which are the last note; of waits, who waits for whom."""
    errors = [d for d in run.findings if d.is_error]
    told = [(d.rule.code, d.notes[0 if d.rule.code == "V502" else -1]) for d in errors]
    return "".join(f"{code} {note.removeprefix('VAL-II says ')}\n" for code, note in told)


def typed(run: Run) -> str:
    text = run.output.replace("\r\n", "\n")
    return text + "\n" if text and not text.endswith("\n") else text


def happened(run: Run) -> str:
    lines = ((event.time_s, in_words(event)) for event in run.events)
    return "".join(f"{time:.3f} {words}\n" for time, words in lines if words)


def in_words(event: Event) -> str:
    """Return an event as the pages name it; nothing for what they show otherwise."""
    match event:
        case MotionStarted(motion=number):
            return f"motion {number + 1} starts"
        case MotionEnded(motion=number):
            return f"motion {number + 1} ends"
        case SignalChanged(signal=signal, on=on):
            return f"signal {signal} {'on' if on else 'off'}"
        case HandCommanded(action=action):
            return f"hand {action}"
        case Printed(text=text):
            return f"types {text.strip()}"
        case Prompted():
            return "asks"
        case Reacted(signal=signal, program=program):
            return f"reacts to {signal or 'an error'}: {program or 'no program'}"
        case SwitchChanged(switch=switch, on=on):
            return f"{switch} {'on' if on else 'off'}"
        case ProgramStarted(process=True, program=program):
            return f"{program} starts beside it"
        case ProgramEnded(ending=ending, process=process):
            return f"{'the other' if process else 'the program'} ends: {ending}"
        case _:
            return ""


@pytest.mark.parametrize("case", cases(), ids=lambda case: case.name)
def test_the_program_does_what_the_page_says(case: Case) -> None:
    run = ran(case)
    assert stopped_by(run) == case.expected.get("error", "")
    if "events" in case.expected:
        assert happened(run) == case.expected["events"]
    if "events" not in case.expected or "output" in case.expected:
        assert typed(run) == case.expected.get("output", "")
