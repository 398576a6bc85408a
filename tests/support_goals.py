"""A workspace of bricks and cans, and what becomes of programs that carry them, for tests."""

import math

from vrts.base.pose import Pose, rotation_about, translation
from vrts.base.source import SourceFile
from vrts.base.units import DEG, MM
from vrts.check.goals.reached import Reached, reached
from vrts.check.judge import judge
from vrts.check.mark.grade import Grade
from vrts.check.mark.mark import grade
from vrts.check.task.task import Task
from vrts.check.task.task_file import read_task
from vrts.engine.controller import execute
from vrts.engine.run import Run
from vrts.lang.compiler import Options, compile_source
from vrts.lang.dialect import DIALECTS
from vrts.scene.block import location_line
from vrts.scene.handling.places import down_pose
from vrts.scene.model import Scene
from vrts.scene.reading.scene_file import read_scene

SCENE_TEXT = """
title = "Bricks and cans"
[robot]
name = "puma761"
[objects.table]
kind = "table"
at_mm = [1000, 0]
size_mm = [800, 1400]
top_z_mm = -300
[objects.base1]
kind = "base"
at_mm = [900, -130]
on = "table"
size_mm = [120, 120, 100]
[objects.base2]
kind = "base"
at_mm = [900, 130]
on = "table"
size_mm = [120, 120, 100]
[objects.brick]
kind = "box"
fixed = false
at_mm = [750, -400]
on = "table"
size_mm = [70, 40, 80]
[objects.can1]
kind = "can"
at_mm = [750, 300]
on = "table"
radius_mm = 30
height_mm = 100
[objects.can2]
kind = "can"
at_mm = [750, 450]
on = "table"
radius_mm = 30
height_mm = 100
"""
TIMES = "\n[time]\nreference_s = 20\n"


def scene_of(text: str = SCENE_TEXT) -> Scene:
    """Return a scene."""
    scene, problems = read_scene(SourceFile("bricks/scene.toml", text))
    assert scene is not None, problems
    return scene


SCENE = scene_of()


def task_of(text: str, scene: Scene = SCENE) -> Task:
    """Return a task that asks for something; times are added."""
    whole = f'[task]\nscene = "bricks"\n{text}{TIMES}'
    task, problems = read_task(SourceFile("bricks/task.toml", whole), scene)
    assert task is not None, [d.headline for d in problems]
    return task


def faults_of(text: str, scene: Scene = SCENE) -> list[tuple[str, str]]:
    """Return what is wrong with a task: every code, and the text that it points at."""
    whole = f'[task]\nscene = "bricks"\n{text}{TIMES}'
    task, problems = read_task(SourceFile("bricks/task.toml", whole), scene)
    assert (task is None) is any(d.is_error for d in problems)
    places = [(d.rule.code, d.primary) for d in problems]
    return [
        (code, "" if place is None else whole[place.span.start : place.span.end])
        for code, place in places
    ]


class Move:
    """An object carried: gripped from above where it stands, and set down elsewhere."""

    def __init__(
        self,
        body: str,
        x: float,
        y: float,
        z: float,
        turn: float = 0.0,
        *,
        release: bool = True,
        lift: float = 120.0,
    ) -> None:
        """Say where its underside ends [mm] and how it is turned on the way [degrees]."""
        self.body, self.release, self.lift = body, release, lift
        self.end = translation(x * MM, y * MM, z * MM)
        self.turn = turn


def program_of(*moves: Move, scene: Scene = SCENE, ends: str = "") -> str:
    """Return a program that carries objects; `ends` is its last line."""
    lines, places = ["SPEED 100 ALWAYS"], ["safe 850 0 200 90 90 0"]
    where = {body.name: body.X_WO for body in scene.bodies}
    for n, move in enumerate(moves):
        X_WO = where[move.body]
        height = 60 * MM
        own = math.atan2(X_WO.rotation[3], X_WO.rotation[0]) / DEG
        X_OP = down_pose(0, 0, height / MM, 90)
        X_WG = move.end @ Pose(rotation_about((0, 0, 1), (own + move.turn) * DEG), (0, 0, 0))
        places += [location_line(f"g{n}", X_WO @ X_OP), location_line(f"p{n}", X_WG @ X_OP)]
        lines += ["OPENI", "MOVE safe", f"APPRO g{n}, 100", f"MOVES g{n}", "CLOSEI"]
        lines += [f"DEPARTS {move.lift}", "MOVE safe", f"APPRO p{n}, 100", "SPEED 20"]
        lines += [f"MOVES p{n}", *(["OPENI", "DEPARTS 120"] if move.release else [])]
        where[move.body] = X_WG
    body = "\n".join((*lines, ends))
    return f".PROGRAM main\n{body}\n.END\n.LOCATIONS\n" + "\n".join(places) + "\n.END\n"


def run_of(*moves: Move, scene: Scene = SCENE, ends: str = "") -> Run:
    """Return the run of `program_of`."""
    text = program_of(*moves, scene=scene, ends=ends)
    found = compile_source(SourceFile("main.v2", text), Options(DIALECTS["val2"]))
    assert found.module is not None, [d.headline for d in found.diagnostics]
    return execute(found.module, scene)


def results(run: Run, text: str) -> list[Reached]:
    """Return how the goals of a task were met."""
    return list(reached(run, task_of(text, run.scene)))


def graded(run: Run, text: str) -> Grade:
    """Return the mark of a run."""
    task = task_of(text, run.scene)
    return grade(task, run, judge(run.scene, run, task, collisions=False))
