"""Compiles and runs programs given as text."""

from collections.abc import Mapping

from tests.places import ROOT
from vrts.base.source import SourceFile
from vrts.engine.controller import execute
from vrts.engine.memory.events import Event, MotionEnded, MotionStarted, SignalChanged
from vrts.engine.run import Run
from vrts.ir.module import Module
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.scene.default import robot_alone
from vrts.scene.model import Scenario, Scene
from vrts.scene.reading.scene_file import read_scene

ALONE = robot_alone()
PLACES = {
    "a": "900 200 100 90 90 0",
    "b": "900 -200 100 90 90 0",
    "c": "900 0 300 90 90 0",
}


def compiled(text: str, dialect: str = "val2") -> Module:
    """Return the module of a whole file."""
    found = compile_source(SourceFile("main.v2", text), Options(DIALECTS[dialect]))
    assert found.module is not None, [d.headline for d in found.diagnostics]
    return found.module


def program(body: str, places: Mapping[str, str] = PLACES) -> str:
    """Return a file with one program and the places it uses."""
    lines = "\n".join(f"{name} {values}" for name, values in places.items())
    return f".PROGRAM main\n{body}\n.END\n.LOCATIONS\n{lines}\n.END\n"


def ran(text: str, scene: Scene = ALONE, scenario: Scenario | None = None) -> Run:
    """Run the first program of a file to its end."""
    return execute(compiled(text), scene, scenario)


def run_body(body: str, scene: Scene = ALONE, scenario: Scenario | None = None) -> Run:
    """Run the lines of one program to their end."""
    return ran(program(body), scene, scenario)


def codes(run: Run) -> list[str]:
    """Return the codes of what the engine found."""
    return [found.rule.code for found in run.findings]


def typed(run: Run) -> list[str]:
    """Return what was written, line by line, without blanks at the ends."""
    return [line.strip() for line in run.output.split("\r\n")[:-1]]


def started(run: Run) -> list[float]:
    """Return when every motion began [s]."""
    return [event.time_s for event in run.events if isinstance(event, MotionStarted)]


def ended(run: Run) -> list[float]:
    """Return when every motion came to the end of its path [s]."""
    return [event.time_s for event in run.events if isinstance(event, MotionEnded)]


def switched(run: Run) -> dict[int, float]:
    """Return when every signal changed last [s]."""
    return {e.signal: e.time_s for e in run.events if isinstance(e, SignalChanged)}


def happened(run: Run, kind: type[Event]) -> list[Event]:
    """Return the events of a kind."""
    return [event for event in run.events if isinstance(event, kind)]


def cans() -> Scene:
    """Return the scene of two cans and two bases."""
    path = ROOT / "scenes" / "cans-on-bases" / "scene.toml"
    scene, problems = read_scene(SourceFile(str(path), path.read_text("utf-8")))
    assert scene is not None, problems
    return scene
