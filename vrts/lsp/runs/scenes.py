"""A scene, task or other TOML file as somebody writes it: what is wrong, and how the scene looks.

`python -m vrts.lsp.runs.scenes` reads a line of JSON (path, text) from stdin and writes one to
stdout, so that the server itself reads no scene and knows no arm. It ends where stdin ends.
"""

import json
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from threading import Thread
from typing import Any

from vrts.base.diagnostic import Diagnostic
from vrts.base.safe_names import safe
from vrts.base.source import SourceFile
from vrts.base.toml.reading import read_toml
from vrts.check.judgement import Judgement
from vrts.check.task.feasible import task_findings
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.check.task.task_places import controller_name, lab_name
from vrts.check.task.task_places import scene_name as scene_of_task
from vrts.lsp.channel.findings import in_words
from vrts.lsp.runs.stdin import end_with_server
from vrts.marking.supervise.limits import Limits, impose
from vrts.pipeline.alone import robot_alone
from vrts.pipeline.compiling.reading import ProgramFile, Reading
from vrts.pipeline.controllers import with_controller
from vrts.pipeline.execution import executed
from vrts.pipeline.files import CannotRead, named_place
from vrts.pipeline.refused import Refused
from vrts.pipeline.request import Request
from vrts.pipeline.scenes import load_scene, with_scenario_text
from vrts.pipeline.setting import Setting, accepted
from vrts.pipeline.settings import setting_for
from vrts.prove.environment.reading import read_environment
from vrts.report.assessment import Assessment
from vrts.report.page.page import recording
from vrts.scene.checks import scene_findings, without_repeats
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene, read_scene_in_lab, scene_name
from vrts.schemas import kind_of
from vrts.validate.log.columns_file import ChosenColumns, read_columns

CPU_S = 60  # of this process
MOST = 200  # findings
_STILL = b".PROGRAM still\n.END\n"
_ANY_SCENE = '[robot]\nname = "puma761"\n'  # a lab is read as it is laid over a scene


def looked_at(path: str, text: str) -> dict[str, Any]:
    """Return what is wrong with a file, and the scene that it describes, if it does, to be shown.

    Args:
        path: Of the file, which may hold another text.
        text: Of the buffer.
    """
    source = SourceFile(path, text)
    scene: Scene | None = None
    task: Task | None = None
    elsewhere = ""
    try:
        scene, task, found = _read(source)
    except Refused as refused:
        found = refused.diagnostics
        others = [d for d in found if not _is_here(d, source)]
        if others:
            elsewhere = f"another file that this one needs has errors: {others[0].headline}"
    except CannotRead as problem:
        found, elsewhere = (), problem.message
    rows = [_row(d) for d in found if _is_here(d, source)][:MOST]
    if elsewhere:
        rows.append([0, 0, "error", "", elsewhere])
    shown = None if scene is None else _still(scene, task)
    bodies = [] if scene is None else [body.name for body in scene.bodies if body.kind != "floor"]
    return {"rows": rows, "recording": shown, "bodies": bodies}


def _read(source: SourceFile) -> tuple[Scene | None, Task | None, Sequence[Diagnostic]]:
    path = Path(source.name)
    folder = path.parent
    match kind_of(source.name):
        case "scene":
            scene, found = read_scene(source, folder, name=safe(scene_name(source.name)))
            told = found if scene is None else without_repeats(found, scene_findings(scene))
            return scene, None, tuple(told)
        case "task":
            named, found = scene_of_task(source)
            lab = lab_name(source)
            laid = None if lab is None else named_place(folder, lab)
            setting = load_scene(accepted(named, found), folder, None, laid)
            setting = with_controller(setting, controller_name(source))
            task, found = read_task(source, setting.scene, safe(folder.name or "task"))
            told = found if task is None else (*found, *task_findings(setting.scene, task))
            return (None if task is None else setting.scene), task, told
        case "lab":
            plain = SourceFile("scene", _ANY_SCENE)
            return None, None, read_scene_in_lab(plain, source, None, folder)[1]
        case "scenario":
            setting = setting_for(path) or robot_alone()
            return None, None, with_scenario_text(setting, source).diagnostics
        case "environment":
            return None, None, read_environment(source)[1]
        case "columns":
            columns = read_columns(source)
            return None, None, () if isinstance(columns, ChosenColumns) else columns
        case _:
            return None, None, read_toml(source)[1].in_order()


def _is_here(found: Diagnostic, source: SourceFile) -> bool:
    return found.primary is None or found.primary.span.source.name == source.name


def _row(found: Diagnostic) -> list[object]:
    start, end = (0, 0) if found.primary is None else found.primary.span[1:3]
    return [start, end, found.severity.value, found.rule.code, in_words(found)]


def _still(scene: Scene, task: Task | None) -> str | None:
    """Return a recording in which nothing moves, as JSON."""
    asked = Request(ProgramFile(_STILL, "still.v2"), Setting(scene, None, ()), Reading(None))
    run = executed(asked).run
    if run is None:
        return None
    a = Assessment(
        "scene", scene.title, None, (), scene=scene, run=run, judgement=Judgement((), None)
    )
    shown = recording(replace(a, task=task), None)
    return json.dumps(shown, separators=(",", ":"), allow_nan=False)


def main() -> None:
    """Answer one request."""
    path, text = json.loads(sys.stdin.buffer.readline())
    Thread(target=end_with_server, daemon=True).start()
    impose(Limits(cpu_s=CPU_S))
    outgoing, sys.stdout = sys.stdout.buffer, sys.stderr
    outgoing.write(json.dumps(looked_at(path, text)).encode() + b"\n")
    outgoing.flush()


if __name__ == "__main__":
    main()
